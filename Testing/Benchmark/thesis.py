#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Measures the tables and figures of the thesis again, and writes them and the published values to one
page.

`Testing/Benchmark/run.sh thesis` runs this script. The source is Z. Fang, "Discrete geodesic graphs",
PhD thesis, Nanyang Technological University, 2019.
"""

import argparse
import functools
import inspect
import os
import sys
import time
import warnings

from exhibits.every import ALL, place
from exhibits.exhibit import FAILED, NOT_REGENERATED, SLACK, Verdict
from exhibits.run import ProgramFailed, Run, TooLong, limited_time
from plots import PlotError
from tables import table

MOST_SECONDS = 3600  # limit of an exhibit
KINDS = {"T": "Table", "F": "Figure", "D": "Difference", "R": "Rival", "L": "Law"}

HEAD = f"""# The thesis, measured again

The tables and figures of Z. Fang, *Discrete geodesic graphs* (PhD thesis, Nanyang Technological
University, 2019): published values, ours, and conclusions. One command generates this page or parts
of it:

```sh
Testing/Benchmark/run.sh thesis --readme [--data FOLDER] [--full] [--exhibits T3.4,F3.9]
```

Models of the thesis that are not public are replaced by public models of the data folder, such as
`bunny.ply`, or by generated surfaces, such as `bumpy-5` (see [surfaces.py](exhibits/surfaces.py)).
Therefore only errors and degrees are compared; times are ratios within one run. Errors are relative to
exact distances on the same mesh. Sources are evenly spaced in the list of vertices. Columns of errors
contain the mean, the 99.9th percentile and the maximum over all vertices and sources. ε is the accuracy of
a graph. "Guaranteed" is our rule; "OneRelay" and "Indirect" are the published constructions, see
[differences](Differences.md).

Verdicts compare quantities of which less is better. "Reproduced" means within a factor of {SLACK:g} of the
published value or range, "better" and "worse" mean outside of it. "Not comparable" marks pictures, and
values for other models or machines.
"""


def anchor(title):
    """Returns the anchor of a heading on GitHub."""
    kept = [c for c in title.lower() if c.isalnum() or c in " -_"]
    return "".join(kept).replace(" ", "-")


def heading(exhibit):
    return f"{KINDS[exhibit.name[0]]} {exhibit.name[1:]}: {exhibit.title}"


def measured(exhibit, run, say, is_wanted=True):
    """Returns the results, or None, and the verdict. Results of exhibits that are not wanted come from
    an earlier run."""
    if not is_wanted and run.find(exhibit.name) is None:
        return None, Verdict(NOT_REGENERATED)
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


def pictures_of(exhibit, figures, folder):
    """Draws the pictures of an exhibit; returns {name: file name}."""
    found = {}
    for name, draw in exhibit.pictures(figures).items():
        file = f"thesis_{name.lower().replace('.', '_')}.png"
        try:
            if draw(os.path.join(folder, file)):
                found[name] = file
        except PlotError:
            pass
    return found


def section(exhibit, found, verdict, pictures, images):
    """Returns the section of an exhibit."""
    parts = [f"## {heading(exhibit)}\n"]
    if found is not None:
        parts.append(" ".join(inspect.getdoc(type(exhibit)).split()) + "\n")
    parts.append(f"*Published:* {exhibit.published}\n")
    if found is not None:
        parts.append(exhibit.table(found.figures))
    for name, file in pictures.items():
        parts.append(f"![{exhibit.titles[name]}]({images}/{file})\n")
    if verdict.reason:
        parts.append(f"{verdict.reason}\n")
    return "\n".join(parts)


def overview(results):
    """Returns the table of all exhibits with their models and verdicts, and the words."""
    rows = {}
    for exhibit, found, verdict, _ in results:
        words = exhibit.words(found.figures) if found else {}
        code = type(exhibit).__module__.split(".")[-1] + ".py"
        for name, title in exhibit.titles.items():
            link = f"[{name}](#{anchor(heading(exhibit))})"
            models = ", ".join(found.models) if found else ""
            word = words.get(name, verdict.word)
            rows[name] = [link, title, f"[{code}](exhibits/{code})", models, word]
    rows = [rows[name] for name in sorted(rows, key=place)]
    header = ["exhibit", "content", "code", "models", "verdict"]
    return table(header, rows), [row[-1] for row in rows]


def page(results, note, images):
    """Returns the page; `results` are (exhibit, results, verdict, pictures)."""
    made, words = overview(results)
    summary = ", ".join(f"{words.count(word)} {word}" for word in dict.fromkeys(words))
    parts = [HEAD, f"{note} {len(words)} exhibits: {summary}.\n", made]
    parts += [section(*result, images) for result in results]
    return "\n".join(parts)


def note_of(run):
    """Returns the command that made the page."""
    options = " --data FOLDER" * (run.data is not None) + " --full" * run.full
    kept = ", exhibit by exhibit (`--keep`)" * (run.reuse and not run.full)
    return f"This page was generated by `run.sh thesis --readme{options}`{kept}."


def chosen(names):
    """Returns the exhibits of these names, in the order of the thesis."""
    known = {name for exhibit in ALL for name in exhibit.titles}
    unknown = [name for name in names if name not in known]
    if unknown:
        raise SystemExit(
            f"error: unknown exhibit {', '.join(unknown)}. Choose from {', '.join(sorted(known))}."
        )
    return [exhibit for exhibit in ALL if not names or set(names) & set(exhibit.titles)]


def parse(arguments):
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--out", required=True, help="folder of results and pictures")
    parser.add_argument("--programs", required=True, help="folder of the benchmark programs")
    parser.add_argument("--data", help="folder of scans (.ply)")
    parser.add_argument("--full", action="store_true", help="larger models and more measurements")
    parser.add_argument(
        "--keep", action="store_true", help="reuse results of earlier runs"
    )
    parser.add_argument("--exhibits", default="", help="T3.1,F3.9,... (default: all)")
    parser.add_argument("--images", default=".", help="path from the page to its pictures")
    parser.add_argument("--pictures", help="folder for pictures (default: that of results)")
    parser.add_argument("--page", help="file of the page (default: thesis.md in the folder)")
    return parser.parse_args(arguments)


def main(arguments=None):
    """Measures, and writes the page; returns 1 if an exhibit failed."""
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
        drawn = pictures_of(exhibit, found.figures, pictures) if found else {}
        results.append((exhibit, found, verdict, drawn))
    path = options.page or os.path.join(options.out, "thesis.md")
    with open(path, "w", encoding="utf-8") as file:
        file.write(page(results, note_of(run), options.images))
    words = [verdict.word for exhibit, _, verdict, _ in results if exhibit in wanted]
    print(f"Written: {path} ({len(words) - words.count(NOT_REGENERATED)} exhibits regenerated)")
    return 1 if FAILED in words else 0


if __name__ == "__main__":
    sys.exit(main())
