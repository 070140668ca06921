# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Fixtures of the tests of tables and plots: files of results, pictures."""

import json
import os
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
OUTPUT = os.environ["DGG_TEST_OUTPUT"]


def entry(name, milliseconds, **figures):
    """One result, as Google Benchmark writes it."""
    return {"name": name, "real_time": milliseconds, "time_unit": "ms", **figures}


def errors(mean):
    return {"error_mean": mean, "error_p999": 3.0 * mean, "error_max": 5.0 * mean}


def write_results(name, results):
    """A file of these results; its path."""
    path = os.path.join(OUTPUT, name)
    with open(path, "w", encoding="utf-8") as file:
        json.dump({"context": {"vtk_version": "9"}, "benchmarks": results}, file)
    return path


def cells_of(lines, start, header):
    """Returns a row by column: the first row that starts with `start`, in the first table that has
    the column `header`."""
    first = next(i for i, line in enumerate(lines) if f"| {header} |" in line)
    names = [name.strip() for name in lines[first].split("|")[1:-1]]
    row = next(line for line in lines[first:] if line.startswith(f"| {start} |"))
    return dict(zip(names, (cell.strip() for cell in row.split("|")[1:-1])))


def draw(script, path, name):
    """The first bytes of the picture that a script makes of results."""
    picture = os.path.join(OUTPUT, name)
    command = [sys.executable, "-B", os.path.join(HERE, script), path, picture]
    subprocess.run(command, check=True)
    with open(picture, "rb") as file:
        return file.read(8)


PNG = b"\x89PNG\r\n\x1a\n"
