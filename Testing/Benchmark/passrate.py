#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Errors of graphs of all meshes in a folder, relative to the accuracy; anisotropy of the triangles;
refused files with reasons.

Usage: passrate.py OUT.json OUT.md FOLDER [--accuracies=0.1,0.01,0.001] [--sources=3]
           [--most_points=1000000]

Errors are those of distances in the graph without correction, relative to exact distances.
"""

import os
import time
import warnings

import modes
import numpy as np
import vtkdgg
from exhibits.surfaces import anisotropy, arrays_of
from tables import column, count_text, digits, listing, tenths
from vtkdgg.commands.measured import ROUNDING, Errors
from vtkdgg.commands.sizes import floor_of
from vtkdgg.vtk_data import triangulated

SOURCES = 3
EXTENSIONS = (".obj", ".off", ".ply", ".stl", ".vtk", ".vtp")


def meshes_of(folder):
    """Returns the paths of mesh files, sorted by name."""
    names = sorted(os.listdir(folder))
    return [os.path.join(folder, name) for name in names if name.lower().endswith(EXTENSIONS)]


def measure_mesh(path, accuracies, number_of_sources, most_points):
    """Returns one row per accuracy. Raises errors of reading and of exact distances."""
    mesh = triangulated(vtkdgg.read(path).as_polydata(), path)
    points, triangles = arrays_of(mesh)
    if len(points) > most_points:
        raise ValueError(f"{len(points)} points exceed the limit of {most_points}")
    used = np.unique(triangles)
    sources = [
        int(used[len(used) * (2 * k + 1) // (2 * number_of_sources)])
        for k in range(number_of_sources)
    ]
    exact = [vtkdgg.distance(mesh, source) for source in sources]
    floor = floor_of(mesh)
    rows = []
    for accuracy in accuracies:
        row = {
            "mesh": os.path.basename(path),
            "vertices": len(points),
            "tau": anisotropy(points, triangles),
            "accuracy": accuracy,
        }
        start = time.process_time()
        try:
            graph = vtkdgg.Graph(mesh, accuracy=accuracy)
        except vtkdgg.Error as problem:
            row["refused"] = reason(problem)
        else:
            row["seconds"] = time.process_time() - start
            row["degree"] = graph.degree
            found = [
                Errors(graph.distance(source, correction=False), e, floor)
                for source, e in zip(sources, exact)
            ]
            row["mean"] = float(np.mean([errors.mean for errors in found]))
            row["max"] = max(errors.largest for errors in found)
        rows.append(row)
    return rows


def reason(problem):
    """Returns the start of a message on one line, without its source."""
    return " ".join(str(problem).split()).split(": ", 1)[-1][:160]


def measure(folder, accuracies, number_of_sources=SOURCES, most_points=1000000, say=print):
    """Returns rows of all meshes, warnings, and refused files."""
    rows, refused, noted = [], [], []
    for path in meshes_of(folder):
        name = os.path.basename(path)
        say(name)
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            try:
                rows += measure_mesh(path, accuracies, number_of_sources, most_points)
            except (ValueError, vtkdgg.Error) as problem:
                refused.append({"mesh": name, "reason": reason(problem)})
        # All filters give the same warnings.
        said = dict.fromkeys(reason(warning.message) for warning in caught)
        noted += [{"mesh": name, "note": note} for note in said]
    refused += [
        {"mesh": f"{row['mesh']}, ε = {row['accuracy']:g}", "reason": row["refused"]}
        for row in rows
        if "refused" in row
    ]
    rows = [row for row in rows if "mean" in row]
    return {"rows": rows, "refused": refused, "noted": noted}


def passes(row):
    """Returns true if no error exceeds the bound."""
    return row["max"] <= row["accuracy"] + ROUNDING


def tables(results):
    """Returns the tables of all graphs, of refused files and of warnings."""
    rows = results["rows"]
    columns = (
        column("mesh", str, "mesh"),
        column("vertices", count_text, "vertices"),
        column("anisotropy", "{:.3g}", "tau"),
        column("ε", "{:g}", "accuracy"),
        column("degree", tenths, "degree"),
        ("mean / ε", lambda row: digits(row["mean"] / row["accuracy"])),
        ("largest / ε", lambda row: digits(row["max"] / row["accuracy"])),
        ("kept", lambda row: "yes" if passes(row) else "NO"),
    )
    refused = (column("refused", str, "mesh"), column("why", str, "reason"))
    noted = (column("mesh", str, "mesh"), column("warning", str, "note"))
    parts = (
        f"{sum(map(passes, rows))} of {len(rows)} graphs are within the bound.\n",
        listing(columns, rows),
        listing(refused, results["refused"]),
        listing(noted, results.get("noted", ())),
    )
    return "\n".join(filter(None, parts))


def parse(arguments=None):
    """Returns the options of a command line."""
    options = modes.parse(
        __doc__, arguments, accuracies=(0.1, 0.01, 0.001), sources=SOURCES, most_points=1000000
    )
    for folder in options.meshes:
        if not os.path.isdir(folder):
            raise SystemExit(f"error: {folder} is not a folder.")
        if not meshes_of(folder):
            raise SystemExit(f"error: {folder} contains no mesh ({' '.join(EXTENSIONS)}).")
    return options


def measure_folders(options):
    """Returns the results of the folder of a command line."""
    (folder,) = options.meshes
    return measure(folder, options.accuracies, options.sources, options.most_points)


if __name__ == "__main__":
    modes.run(measure_folders, tables, parse())
