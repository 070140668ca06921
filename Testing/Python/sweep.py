#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Run every filter over any meshes, and check what must hold of each result and how long it took.

Each filter runs in a process of its own, which ends when the filter has used 20 times the time
that it takes on a clean mesh of that size, at least 2 s. A filter may refuse a mesh only with a
message that its documentation announces. Times are those of the processors, in all threads, so
that a busy machine makes no difference.

    sweep.py FOLDER...                   all meshes in folders
    sweep.py --generate 2000             meshes made at random, those of sweep_seeds.txt first
    sweep.py --generate 1 --seed 1234    one of them again
"""

import argparse
import functools
import json
import os
import pickle
import re
import resource
import signal
import sys
import tempfile
import time
import warnings

os.environ.setdefault("DGG_TEST_OUTPUT", tempfile.gettempdir())

# pylint: disable=wrong-import-position
import numpy as np
import support
import sweep_meshes
import vtkdgg
from sweep_checks import CHECKS, LARGE, NEEDS
from sweep_trial import Surface, Trial
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkTriangleFilter

RATIO, LEAST = 20.0, 2.0  # time limit: multiple of a clean mesh, at least seconds
SHORTEST = 0.01  # seconds; shorter times are not distinguished
PATIENCE = 60.0  # seconds that a process may take beyond 20 time limits
LARGEST = 70_000  # points, for filters that are not meant for more
LADDER = [50, 200, 800, 3200, 12800]  # points of the clean meshes that are measured
SEEDS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "sweep_seeds.txt")

EXTENSIONS = (".ply", ".stl", ".obj", ".vtp", ".off")

GOOD = ("ok", "refused", "known")
# Messages of refusals that the documentation announces.
REFUSALS = [
    r"multipl(y|ies) among non-manifold edges or (triangles without|long triangles of little) area",
    r"reach too far over long triangles",
    r"The triangles are too thin: about",
    r"has more than two triangles\. Make the surface a manifold: loops around handles",
    r"curves have no sides where they meet",
    r"Points \d+ and \d+ of .*curve are not connected",
    r"The layout edge between landmarks .* cannot be drawn on",
    r"the faces that it crosses are too narrow",
    r"has more than two faces\. .* patches need a surface with two sides",
    r"the surface cannot be oriented\. .* patches need a surface with two sides",
]


class Timer:
    """Context that ends this process if the code inside exceeds a total processor time."""

    def __init__(self, limit):
        self.limit = limit
        self.used = 0.0

    @staticmethod
    def now():
        usage = resource.getrusage(resource.RUSAGE_SELF)
        return usage.ru_utime + usage.ru_stime

    def __enter__(self):
        self.start = self.now()
        signal.setitimer(signal.ITIMER_PROF, max(self.limit - self.used, 1e-3))

    def __exit__(self, *_):
        signal.setitimer(signal.ITIMER_PROF, 0.0)
        self.used += self.now() - self.start


def attempt(name, surface, results, folder, limit):
    """Returns the outcome of one filter on a surface, a dictionary."""
    timer = Timer(limit)
    outcome = {"status": "ok", "messages": [], "result": None}
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        trial = Trial(surface, results, folder, timer)
        try:
            outcome["result"] = CHECKS[name](trial)
        except vtkdgg.Error as error:
            known = all(any(re.search(p, m, re.I) for p in REFUSALS) for m in error.messages)
            outcome["status"] = "refused" if known else "error"
            outcome["messages"] = [re.sub(r"\s+", " ", text) for text in error.messages]
    if trial.failures:
        outcome["status"] = "wrong"
        outcome["messages"] = trial.failures + outcome["messages"]
    outcome["seconds"] = timer.used
    return outcome


def in_process(work, limit):
    """Returns the result of a function that runs in a process of its own, which may crash or be
    ended."""
    sys.stdout.flush()
    sys.stderr.flush()
    receiver, sender = os.pipe()
    child = os.fork()
    if child == 0:
        try:
            os.close(receiver)
            signal.setitimer(signal.ITIMER_REAL, PATIENCE + 20 * limit)
            with os.fdopen(sender, "wb") as pipe:
                pickle.dump(work(), pipe)
        except BaseException as error:  # pylint: disable=broad-except
            sys.excepthook(type(error), error, error.__traceback__)
            os._exit(1)
        os._exit(0)
    os.close(sender)
    with os.fdopen(receiver, "rb") as pipe:
        data = pipe.read()
    _, status = os.waitpid(child, 0)
    if os.WIFEXITED(status) and os.WEXITSTATUS(status) == 0:
        return pickle.loads(data)
    number = os.WTERMSIG(status) if os.WIFSIGNALED(status) else 0
    kind, message = {
        0: ("crash", "the check failed"),
        signal.SIGPROF: ("too slow", f"ended after {limit:.3g} s"),
        signal.SIGALRM: ("hangs", "ended while it waited"),
    }.get(number, ("crash", f"signal {number}"))
    return {"status": kind, "messages": [message], "seconds": limit, "result": None}


class CleanTimes:
    """Seconds that filters take on clean meshes, measured on demand."""

    def __init__(self, names, patience):
        self.names = names
        self.patience = patience
        self.times = {}

    def measure(self, number):
        surface = Surface(sweep_meshes.Mesh("clean", *sweep_meshes.clean(number)))
        best = {}
        for _ in range(3 if number < 1000 else 1):
            for name, outcome in run(surface, self.names, lambda name: 600.0):
                if outcome["status"] != "ok":
                    raise RuntimeError(f"{name} on a clean mesh: {outcome['messages']}")
                best[name] = min(best.get(name, np.inf), outcome["seconds"])
        return best

    def limit(self, number, name):
        """Returns the time limit of a filter, seconds."""
        return self.patience * max(LEAST, RATIO * self(number, name))

    def __call__(self, number, name):
        """Returns the time of a filter, linear in the logarithms between the sizes of the ladder.
        """
        i = int(np.clip(np.searchsorted(LADDER, number), 1, len(LADDER) - 1))
        low, high = LADDER[i - 1 : i + 1]
        for rung in (low, high):
            if rung not in self.times:
                self.times[rung] = self.measure(rung)
        part = max(np.log(number / low) / np.log(high / low), 0.0)
        a, b = (max(self.times[rung][name], 1e-6) for rung in (low, high))
        return max(float(a * (b / a) ** part), SHORTEST)


def run(surface, names, limit_of):
    """Yields the outcomes of filters on a surface."""
    results = {}
    with tempfile.TemporaryDirectory() as folder:
        for name in names:
            if "graph" in NEEDS.get(name, []) and "graph" not in results:
                continue
            limit = limit_of(name)
            work = functools.partial(attempt, name, surface, results, folder, limit)
            outcome = in_process(work, limit)
            result = outcome.pop("result")
            if result is not None:
                results[name] = result
            yield name, outcome


def read(path):
    """Returns the mesh of a file, or None if it has no triangles. Readers use no threads, which a
    process that forks must not have."""
    triangles = vtkTriangleFilter()
    triangles.SetInputData(vtkdgg.read(path).as_polydata())
    triangles.PassVertsOff()
    triangles.PassLinesOff()
    mesh = vtkdgg.check(triangles)
    if mesh.GetNumberOfPolys() == 0:
        return None
    points = np.array(vtk_to_numpy(mesh.GetPoints().GetData()), dtype=float)
    return sweep_meshes.Mesh(os.path.basename(path), points, support.triangles_of(mesh))


def files_in(folders):
    """Returns the paths of the meshes in folders, the smallest first."""
    found = []
    for folder in folders:
        for place, _, names in os.walk(folder):
            found += [
                os.path.join(place, name)
                for name in names
                if os.path.splitext(name)[1].lower() in EXTENSIONS
            ]
    return sorted(found, key=lambda path: (os.path.getsize(path), path))


def kept():
    """Returns the filters that still fail, by seed or name of a file."""
    with open(SEEDS, encoding="utf-8") as file:
        lines = [line.split("#")[0].split() for line in file]
    return {words[0]: words[1:] for words in lines if words}


def kept_seeds():
    return [int(name) for name in kept() if name.isdigit()]


def meshes(options):
    """Yields for each mesh of a run the command that repeats it, and a function that returns it."""
    script = os.path.relpath(os.path.abspath(__file__))
    if options.generate:
        seeds = [] if options.generate == 1 else kept_seeds()
        seeds += range(options.seed, options.seed + options.generate)
        for seed in dict.fromkeys(seeds):
            again = f"{script} --generate 1 --seed {seed}"
            yield again, functools.partial(sweep_meshes.generate, seed)
    for path in files_in(options.folders):
        again = f"{script} {os.path.dirname(path)} --only-mesh {os.path.basename(path)}"
        if options.only_mesh in path:
            yield again, functools.partial(read, path)


def sweep(options):
    """Returns the records of all runs, and the meshes that exceed the time budget."""
    asked = options.filters.split(",") if options.filters else list(CHECKS)
    names = [name for name in CHECKS if any(name in [a, *NEEDS.get(a, [])] for a in asked)]
    clean = CleanTimes(names, options.patience)
    start, records, left = time.time(), [], []
    for again, make in meshes(options):
        if time.time() - start > options.time_budget:
            left.append(again)
            continue
        mesh = make()
        if mesh is None:
            continue
        number = len(mesh.points)
        known = [] if options.strict else kept().get(str(mesh.seed), kept().get(mesh.name, []))
        wanted = names if number <= LARGEST else [name for name in names if name in LARGE]
        surface = Surface(mesh)
        for name, outcome in run(surface, wanted, functools.partial(clean.limit, number)):
            record = {"mesh": mesh.name, "seed": mesh.seed, "points": number, "filter": name}
            record.update(outcome, ratio=outcome["seconds"] / clean(number, name))
            records.append(record)
            if name in known:
                print(f"{mesh.name}, {name}: {record['status']}, known to fail")
                record["status"] = "known"
            if record["status"] not in GOOD:
                print(f"{mesh.name}, {surface}, {name}: {record['status']}")
                print("\n".join(f"    {message}" for message in record["messages"]))
                print(f"  again: {again} --filters {name}", flush=True)
        if options.verbose:
            print(f"{mesh.name}: {number} points, {time.time() - start:.0f} s", flush=True)
    return records, left


def summarize(records, left):
    """Prints a summary."""
    print("\nfilter            runs    ok refused known failed  slowest, times a clean mesh")
    for name in dict.fromkeys(r["filter"] for r in records):
        own = [r for r in records if r["filter"] == name]
        good, refused, known = (sum(r["status"] == status for r in own) for status in GOOD)
        slowest = max(own, key=lambda r: r["ratio"])
        print(
            f"{name:<16}{len(own):>6}{good:>6}{refused:>8}{known:>6}"
            f"{len(own) - good - refused - known:>7}"
            f"  {slowest['ratio']:.1f} x, {slowest['mesh']}"
        )
    refusals = {}
    for record in records:
        if record["status"] == "refused":
            text = re.sub(r"[\d.]+|vtk\w+: ", "#", record["messages"][0])
            refusals.setdefault(text, []).append(record["mesh"])
    for text, names in refusals.items():
        print(f"refused, {len(names)} times, as {names[0]}: {text}")
    if left:
        print(f"time is up: {len(left)} meshes left out, the first by: {left[0]}")
    number = len({r["mesh"] for r in records})
    failed = sum(r["status"] not in GOOD for r in records)
    print(f"{number} meshes, {len(records)} runs, {failed} failures")


def keep(records):
    """Adds the seeds that failed to the file of seeds."""
    failed = {}
    for record in records:
        if record["status"] not in GOOD and record["seed"] is not None:
            failed.setdefault(record["seed"], []).append(f"{record['filter']} {record['status']}")
    with open(SEEDS, "a", encoding="utf-8") as file:
        for seed in sorted(set(failed) - set(kept_seeds())):
            file.write(f"{seed}  # {', '.join(failed[seed])}\n")


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("folders", nargs="*", help="folders of meshes")
    parser.add_argument("--generate", type=int, default=0, metavar="N", help="N generated meshes")
    parser.add_argument("--seed", type=int, default=0, help="of the first of them")
    parser.add_argument("--filters", default="", help=f"of {', '.join(CHECKS)}; default all")
    parser.add_argument("--only-mesh", default="", help="files with this in their path only")
    parser.add_argument("--json", help="file for all outcomes")
    parser.add_argument("--time-budget", type=float, default=np.inf, help="begin no mesh after, s")
    parser.add_argument("--keep", action="store_true", help="add failing seeds to sweep_seeds.txt")
    parser.add_argument(
        "--patience", type=float, default=1.0, help="as a factor of time limits, on busy machines"
    )
    parser.add_argument("--strict", action="store_true", help="known failures are failures, too")
    parser.add_argument("-v", "--verbose", action="store_true", help="a line for each mesh")
    options = parser.parse_args()
    records, left = sweep(options)
    summarize(records, left)
    if options.keep:
        keep(records)
    if options.json:
        with open(options.json, "w", encoding="utf-8") as file:
            json.dump(records, file, indent=1)
    return any(record["status"] not in GOOD for record in records)


if __name__ == "__main__":
    sys.exit(main())
