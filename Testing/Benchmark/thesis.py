#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""The tables and figures of the thesis, measured anew, as one page: ours beside what was published.

To be run by `Testing/Benchmark/run.sh thesis`. The source is Z. Fang, "Discrete geodesic graphs",
PhD thesis, Nanyang Technological University, 2019.
"""

import argparse
import functools
import inspect
import os
import sys
import time
import warnings

from benchmark_results import table
from exhibits.every import ALL
from exhibits.exhibit import FAILED, NOT_REGENERATED, SLACK, Verdict
from exhibits.run import ProgramFailed, Run, TooLong, limited_time
from plot_tools import PlotError

MOST_SECONDS = 3600  # limit of an exhibit

HEAD = f"""# The thesis, measured anew

The tables and figures of Z. Fang, *Discrete geodesic graphs* (PhD thesis, Nanyang Technological
University, 2019), each with what was published beside ours, and what follows from that. One command
makes this page, or a part of it:

```sh
Testing/Benchmark/run.sh thesis --readme [--data FOLDER] [--full] [--exhibits T3.4,F3.9]
```

Models of the thesis that are not public are replaced by public ones (`bunny.ply` of the folder) or by
generated surfaces (`bumpy-5`: see [surfaces.py](exhibits/surfaces.py)). So errors and degrees are
compared, and times only as ratios within one run. "Ours" names what makes an exhibit alone, its code, and
its models. Errors are relative to exact distances along the same mesh, from vertices evenly spread over
the list of vertices: means over all vertices and sources, and the largest. ε is the accuracy that a graph
is built for. "Guaranteed" is our rule; "OneRelay" and "Indirect" are the published constructions, see
[what we changed and why](Differences.md).

Of a figure of which less is better, and one that was printed, "reproduced" is within a factor of
{SLACK:g} of it, "better" and "worse" lie beyond; of a range, beyond its ends. "Not comparable" are
pictures, and what was measured for another model or machine only. Which figure is meant is said with
each verdict.
"""


def anchor(title):
    """Of a heading, as GitHub makes it."""
    kept = [c for c in title.lower() if c.isalnum() or c in " -_"]
    return "".join(kept).replace(" ", "-")


def heading(exhibit):
    kind = {"T": "Table", "F": "Figure", "D": "Difference", "R": "Rival", "L": "Law"}[exhibit.name[0]]
    return f"{kind} {exhibit.name[1:]}: {exhibit.title}"


def measured(exhibit, run, say, is_wanted=True):
    """What was measured, None where nothing was, and the verdict. What is not wanted is taken from an
    earlier run."""
    if not is_wanted and run.find(exhibit.name) is None:
        return None, Verdict(NOT_REGENERATED, "Not asked for, in this run or before.")
    start = time.perf_counter()
    try:
        with limited_time(MOST_SECONDS):
            found = (
                run.kept(exhibit.name, lambda: exhibit.measure(run))
                if is_wanted
                else run.find(exhibit.name)
            )
        exhibit.table(found.figures)  # kept results may have an older form
        verdict = exhibit.verdict(found.figures)
    except (ProgramFailed, TooLong, OSError, ValueError, KeyError, RuntimeError) as problem:
        found, verdict = None, Verdict(FAILED, f"{type(problem).__name__}: {problem}")
    if is_wanted:
        say(f"{exhibit.name}: {verdict.word} ({time.perf_counter() - start:.0f} s)")
    return found, verdict


def picture_of(exhibit, figures, folder):
    """The name of the file of its picture; None without one."""
    name = f"thesis_{exhibit.name.lower().replace('.', '_')}.png"
    try:
        return name if exhibit.draw(figures, os.path.join(folder, name)) else None
    except PlotError:
        return None


def origin(exhibit, models):
    """The code of an exhibit, what makes it alone, and what it is measured on."""
    code = type(exhibit).__module__.split(".")[-1] + ".py"
    return f"*Ours:* `--exhibits {exhibit.name}` ([{code}](exhibits/{code})), on {', '.join(models)}.\n"


def section(exhibit, found, verdict, picture, images):
    """What the page says of one exhibit."""
    parts = [f"## {heading(exhibit)}\n"]
    if found is not None:
        parts.append(" ".join(inspect.getdoc(type(exhibit)).split()) + "\n")
    if exhibit.published:
        parts.append(f"*Published:* {exhibit.published}\n")
    if found is not None:
        parts.append(origin(exhibit, found.models))
        parts.append(exhibit.table(found.figures))
    if picture:
        parts.append(f"![{exhibit.title}]({images}/{picture})\n")
    parts.append(f"**{verdict.word.capitalize()}.** {verdict.reason}\n")
    return "\n".join(parts)


def overview(rows):
    """All exhibits with their verdicts."""
    lines = [
        [f"[{exhibit.name}](#{anchor(heading(exhibit))})", exhibit.title, verdict.word]
        for exhibit, verdict in rows
    ]
    return table(["exhibit", "what it shows", "verdict"], lines)


def page(results, note, images):
    """The whole page; results are of (exhibit, what was measured, verdict, picture)."""
    rows = [(exhibit, verdict) for exhibit, _, verdict, _ in results]
    counts = {}
    for _, verdict in rows:
        counts[verdict.word] = counts.get(verdict.word, 0) + 1
    summary = ", ".join(f"{count} {word}" for word, count in counts.items())
    parts = [HEAD, note + "\n", f"{len(rows)} exhibits: {summary}.\n", overview(rows)]
    parts += [section(*result, images) for result in results]
    return "\n".join(parts)


def note_of(run):
    """How this page was made."""
    options = " --data FOLDER" * (run.data is not None) + " --full" * run.full
    kept = ", exhibit by exhibit (`--keep`)" * (run.reuse and not run.full)
    return f"This page was made with `run.sh thesis --readme{options}`{kept}."


def chosen(names):
    """The exhibits of these names, in the order of the thesis."""
    if not names:
        return ALL
    known = {exhibit.name for exhibit in ALL}
    unknown = [name for name in names if name not in known]
    if unknown:
        raise SystemExit(
            f"error: no exhibit {', '.join(unknown)}; there are {', '.join(sorted(known))}"
        )
    return [exhibit for exhibit in ALL if exhibit.name in names]


def parse(arguments):
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--out", required=True, help="folder of results and pictures")
    parser.add_argument("--programs", required=True, help="folder of the benchmark programs")
    parser.add_argument("--data", help="folder of scans (.ply)")
    parser.add_argument("--full", action="store_true", help="larger models, more of everything")
    parser.add_argument(
        "--keep", action="store_true", help="do not measure again what was measured"
    )
    parser.add_argument("--exhibits", default="", help="T3.1,F3.9,... (default: all)")
    parser.add_argument("--images", default=".", help="where the page finds its pictures")
    parser.add_argument("--pictures", help="folder that pictures go to (default: that of results)")
    parser.add_argument("--page", help="file of the page (default: thesis.md in the folder)")
    return parser.parse_args(arguments)


def main(arguments=None):
    """Measure, judge, and write the page; 1 when something failed."""
    options = parse(arguments)
    wanted = chosen([name for name in options.exhibits.split(",") if name])
    # Runs that take hours can be resumed; runs that take minutes are measured completely.
    reuse = options.keep or options.full
    run = Run(options.out, options.programs, options.data, options.full, reuse)
    pictures = options.pictures or options.out
    os.makedirs(pictures, exist_ok=True)
    # Warnings about stretched triangles, which are intended here.
    warnings.simplefilter("ignore", RuntimeWarning)
    results = []
    for exhibit in ALL:
        say = functools.partial(print, flush=True)
        found, verdict = measured(exhibit, run, say, exhibit in wanted)
        picture = picture_of(exhibit, found.figures, pictures) if found else None
        results.append((exhibit, found, verdict, picture))
    path = options.page or os.path.join(options.out, "thesis.md")
    with open(path, "w", encoding="utf-8") as file:
        file.write(page(results, note_of(run), options.images))
    words = [verdict.word for exhibit, _, verdict, _ in results if exhibit in wanted]
    print(f"Written: {path} ({len(words) - words.count(NOT_REGENERATED)} exhibits regenerated)")
    return 1 if FAILED in words else 0


if __name__ == "__main__":
    sys.exit(main())
