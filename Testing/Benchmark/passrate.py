#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Whether graphs keep their promise on all meshes of a folder: mean and largest error over the
accuracy, the anisotropy of the triangles, and what was refused and why.

Usage: passrate.py OUT FOLDER [--accuracies 0.1,0.01,0.001] [--sources 3] [--most_points 1000000]

To be run by `Testing/Benchmark/run.sh passrate`. Writes passrate.json, passrate.md and passrate.png.
Errors are those of distances in the graph, before they are corrected, against exact ones.
"""

import argparse
import json
import os
import sys
import time
import warnings

import numpy as np
import vtkdgg
from benchmark_results import count_text, digits, table
from exhibits.surfaces import anisotropy, arrays_of
from plot_tools import STYLES, PlotError, add_legend, load_matplotlib, style_axes
from vtkdgg.commands import files
from vtkdgg.commands.measured import ROUNDING, Errors
from vtkdgg.commands.methods import field
from vtkdgg.commands.sizes import floor_of

SOURCES = 3
EXTENSIONS = (".obj", ".off", ".ply", ".stl", ".vtk", ".vtp")


def meshes_of(folder):
    """Paths of the files that may hold a surface, by name."""
    names = sorted(os.listdir(folder))
    return [os.path.join(folder, name) for name in names if name.lower().endswith(EXTENSIONS)]


def measure_mesh(path, accuracies, number_of_sources, most_points):
    """One row for each accuracy. Raises what reading, exact distances or graphs refuse."""
    mesh = files.triangles_of(vtkdgg.read(path).as_polydata(), path)
    points, triangles = arrays_of(mesh)
    if len(points) > most_points:
        raise ValueError(f"{len(points)} points, and {most_points} are wanted at most")
    used = np.unique(triangles)
    sources = [
        int(used[len(used) * (2 * k + 1) // (2 * number_of_sources)])
        for k in range(number_of_sources)
    ]
    exact = [field(vtkdgg.vtkExactGeodesicDistance, mesh, source) for source in sources]
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
        except vtkdgg.VTKError as problem:
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
    """The first sentence or line of what was said, on one line."""
    return " ".join(str(problem).split()).split(": ", 1)[-1][:160]


def measure(folder, accuracies, number_of_sources=SOURCES, most_points=1000000, say=print):
    """Rows of all meshes, what was said of them, and what was refused."""
    rows, refused, noted = [], [], []
    for path in meshes_of(folder):
        name = os.path.basename(path)
        say(name)
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            try:
                rows += measure_mesh(path, accuracies, number_of_sources, most_points)
            except (ValueError, vtkdgg.VTKError) as problem:
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
    """Whether no error is larger than promised."""
    return row["max"] <= row["accuracy"] + ROUNDING


def tables(results):
    """As Markdown."""
    rows = results["rows"]
    count = sum(map(passes, rows))
    parts = [f"{count} of {len(rows)} graphs keep their promise.\n"]
    header = ["mesh", "vertices", "anisotropy", "ε", "degree", "mean / ε", "largest / ε", "kept"]
    lines = [
        [
            row["mesh"],
            count_text(row["vertices"]),
            f"{row['tau']:.3g}",
            f"{row['accuracy']:g}",
            f"{row['degree']:.1f}",
            digits(row["mean"] / row["accuracy"]),
            digits(row["max"] / row["accuracy"]),
            "yes" if passes(row) else "NO",
        ]
        for row in rows
    ]
    parts.append(table(header, lines))
    refused = [[entry["mesh"], entry["reason"]] for entry in results["refused"]]
    parts.append(table(["refused", "why"], refused))
    noted = [[entry["mesh"], entry["note"]] for entry in results.get("noted", ())]
    parts.append(table(["mesh", "what the filters say of it"], noted))
    return "\n".join(part for part in parts if part)


def plot(results, picture):
    """Mean and largest error over ε, against anisotropy; says whether there was anything."""
    subplots, handle = load_matplotlib()
    rows = [row for row in results["rows"] if row["mean"] > 0.0 and np.isfinite(row["max"])]
    if not rows:
        return False
    figure, axes = subplots(1, 1, figsize=(7.0, 5.2))
    accuracies = sorted({row["accuracy"] for row in rows}, reverse=True)
    curves = []
    for accuracy, (colour, marker) in zip(accuracies, STYLES):
        chosen = [row for row in rows if row["accuracy"] == accuracy]
        for key, face in (("mean", colour), ("max", "white")):
            xs = [row["tau"] for row in chosen]
            ys = [row[key] / accuracy for row in chosen]
            axes.plot(xs, ys, marker, color=colour, markerfacecolor=face, markersize=6.5)
        curves.append((f"ε = {accuracy:g}", (colour, marker)))
    axes.axhline(1.0, color="#444444", linewidth=1.2, linestyle="--")
    style_axes(
        axes,
        "error over ε: mean (full), largest (empty)",
        "anisotropy of the triangles",
        minor=lambda value, _: f"{value:g}",
    )
    add_legend(figure, handle, curves, columns=5)
    figure.tight_layout(rect=(0.0, 0.08, 1.0, 1.0))
    figure.savefig(picture, dpi=80)
    return True


def main(arguments=None):
    """Measure and write; 1 when a promise was broken."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("out")
    parser.add_argument("folder")
    parser.add_argument("--accuracies", default="0.1,0.01,0.001")
    parser.add_argument("--sources", type=int, default=SOURCES)
    parser.add_argument("--most_points", type=int, default=1000000)
    options = parser.parse_args(arguments)
    if not os.path.isdir(options.folder):
        sys.exit(f"error: {options.folder}: no such folder")
    if not meshes_of(options.folder):
        sys.exit(f"error: {options.folder}: holds no mesh ({' '.join(EXTENSIONS)})")
    accuracies = [float(word) for word in options.accuracies.split(",")]
    os.makedirs(options.out, exist_ok=True)
    results = measure(options.folder, accuracies, options.sources, options.most_points)
    path = os.path.join(options.out, "passrate")
    with open(path + ".json", "w", encoding="utf-8") as file:
        json.dump(results, file, indent=1)
    text = tables(results)
    with open(path + ".md", "w", encoding="utf-8") as file:
        file.write(text)
    print(text)
    try:
        if plot(results, path + ".png"):
            print(f"Written: {path}.png")
    except PlotError as problem:
        print(f"no plot: {problem}")
    return 0 if all(map(passes, results["rows"])) else 1


if __name__ == "__main__":
    sys.exit(main())
