# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Measurement of one method of peers.py on one task, in a process of its own.

Usage: measure_alone.py METHOD TASK CASE.npz RESULT.json
"""

import importlib
import json
import os
import resource
import signal
import statistics
import subprocess
import sys
import tempfile
import time
import traceback

import modes
import numpy as np
from peers import METHODS

ENOUGH_SECONDS = 10.0  # CPU time of calls after which no further one follows
FEWEST_SECONDS = 0.2  # CPU time of repetitions of a short call
UNREACHED = 1e30  # larger values mean unreached vertices


def run_alone(command, limit):
    """Returns why a process failed; None if it succeeded. The limit is in CPU seconds. The limit
    of wall-clock time, against deadlocks, leaves room for other load."""
    longest = 5 * limit + 60

    def set_limits():
        # Exhausted memory is an error of this process alone.
        memory = os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE")
        resource.setrlimit(resource.RLIMIT_DATA, (memory, memory))
        resource.setrlimit(resource.RLIMIT_CPU, (limit, limit + 1))

    with tempfile.TemporaryFile() as errors:
        try:
            status = subprocess.run(
                command,
                timeout=longest,
                stdout=subprocess.DEVNULL,
                stderr=errors,
                preexec_fn=set_limits,
                check=False,
            ).returncode
        except subprocess.TimeoutExpired:
            return f"> {longest} s of wall-clock time"
        errors.seek(0)
        lines = errors.read().decode(errors="replace").split("\n")
    if status == -signal.SIGXCPU:
        return f"> {limit} s"
    if status < 0:
        return f"crashed ({signal.Signals(-status).name})"
    last = next((line for line in reversed(lines) if line.strip()), "no message")
    return f"exit status {status}: {last}" if status else None


def measure_alone(name, task, case, limit):
    """Returns the figures of a method, or {"failed": reason}, measured in a process of its own."""
    with tempfile.TemporaryDirectory() as folder:
        result = os.path.join(folder, "result.json")
        command = [sys.executable, os.path.abspath(__file__), name, task, case, result]
        failed = run_alone(command, limit)
        if failed:
            return {"failed": failed}
        with open(result, encoding="utf-8") as file:
            return json.load(file)


def length(points):
    """Returns the length of a polyline as an array of one number."""
    return np.linalg.norm(np.diff(points, axis=0), axis=1).sum(keepdims=True)


def calls_of(method, task, case):
    """Returns pairs of a call and the exact result, and a function of the results to compare."""
    sources, rows = case["sources"].tolist(), case["rows"]
    if task == "one":
        pairs = [((lambda s=s: method.distance([s])), row) for s, row in zip(sources, rows)]
        return pairs, np.asarray
    if task == "many":
        return [(lambda: method.distance(sources), case["nearest"])] * len(rows), np.asarray
    if task == "matrix":
        exact = rows[:, sources]
        return [(lambda: method.matrix(sources), exact)] * len(rows), lambda m: m[: len(rows)]
    ends = [(k, end) for end in sources[len(rows) :] for k in range(len(rows))]
    reached = [(k, end) for k, end in ends if np.isfinite(rows[k, end])]
    pairs = [((lambda k=k, e=e: method.path(sources[k], e)), rows[k, [e]]) for k, e in reached]
    return pairs, length


def errors_of(found, exact):
    """Returns relative errors, and the number of missing values."""
    counted = np.isfinite(exact) & (exact > 0.0)
    found, exact = found[counted], exact[counted]
    reached = np.isfinite(found) & (np.abs(found) < UNREACHED)
    errors = np.abs(found[reached] / exact[reached] - 1.0)
    return errors, int(np.count_nonzero(~reached))


def timed(function):
    """Returns the CPU time of a call, and its result. Short calls are repeated, because with a
    limit the system counts CPU time in steps of some milliseconds."""
    seconds, count = 0.0, 0
    while seconds < FEWEST_SECONDS:
        one, result = modes.timed(function)
        seconds, count = seconds + one, count + 1
    return seconds / count, result


def measure(name, task, case):
    """Returns times in CPU seconds, memory above that of the mesh in bytes, and relative errors."""
    library = importlib.import_module(METHODS[name].module)
    memory = modes.ResidentPeak()
    mesh = case["points"], case["triangles"]
    prepare, method = timed(lambda: METHODS[name](library, *mesh))
    pairs, compared = calls_of(method, task, case)
    times, errors, missed = [], [], 0
    start = time.process_time()
    for call, exact in pairs:
        seconds, result = timed(call)
        times.append(seconds)
        wrong, missing = errors_of(compared(result), exact)
        errors.append(wrong)
        missed += missing
        if time.process_time() - start > ENOUGH_SECONDS:
            break
    found = {"prepare": prepare, "query": statistics.median(times), "calls": len(times)}
    found["memory"] = memory.growth()
    errors = np.concatenate(errors)
    if len(errors) > 0:
        mean, most = float(errors.mean()), float(errors.max())
        found["error"] = {"mean": mean, "max": most, "missed": missed}
    return found


def main(name, task, path, result):
    with np.load(path) as file:
        case = dict(file)
    try:
        found = measure(name, task, case)
    except Exception as error:
        traceback.print_exc()
        found = {"failed": f"{type(error).__name__}: {error}".splitlines()[0]}
    with open(result, "w", encoding="utf-8") as file:
        json.dump(found, file)


if __name__ == "__main__":
    main(*sys.argv[1:])
