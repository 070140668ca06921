# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Model of graphs on several processes: ghosts, exchanges, messages and bytes.

Usage: measure_processes.py OUT.md LINES.json ...

The lines are those of BenchmarkProcesses. The option --replay adds the number of ghosts, layers and
rounds of a division, found on one process; each measured division needs them. The tables compare
predictions with counts on several processes, predict 10^9 points on 10^3 processes, and compare
labels with shortest paths of the Parallel Boost Graph Library, if it was found.
"""

import json
import math
import statistics
import sys

from tables import column, listing

LAYERS = (64, 256, 1024)  # of cells around a piece after each round of a build
# Constants of the kernel, bytes.
POINT, CELL = 32, 8  # registration of a point or cell
SHARED = 32  # the processes of a point that two of them have
GROWTH = 64  # per cell of a layer: the cell, its part of the points, and their requests
EDGE, LABEL, TAIL, ARRIVAL = 32, 16, 16, 52
LAYER_HEADERS, BUILD_HEADERS, PREPARE_HEADERS = 86, 300, 400  # per pair of processes
ROUND_HEADERS = 20
# Constants of the model, fitted to the runs of Filters/Parallel/Scale.md.
CROSSING_EDGES = 0.12  # per ghost and edge per vertex
DEPTH = 0.2  # added to the reach
TAILS = 0.25  # tails sent to their owners, per ghost
RESENT = 0.24  # times that a label is sent, per border that a wave crosses
LARGE = 1e5  # vertices of surfaces that are extrapolated


def hops(division, processes):
    """Returns the number of borders between opposite ends of a surface."""
    if division == "strips":
        return processes - 1
    first = 2 ** math.ceil(math.log2(processes) / 2)
    return first + processes / first - 2


class Prediction:
    """Counts of a surface on several processes, predicted.

    `run` has the division: lists of the points, faces and points shared with other pieces of each
    process, and of the cells of a layer around its piece. `surface` has the number of vertices and
    edges. `replay` has the number of ghosts, the rounds of labels and of the tree, the largest
    number of layers around a piece, and per process the number of layers that its edges reach."""

    def __init__(self, run, surface, replay):
        count, vertices = run["processes"], surface["vertices"]
        self.pairs, self.faces = count * (count - 1), sum(run["faces"])
        self.away = (count - 1) / count
        border, shared = sum(run["layer_cells"]) / 2, sum(run["shared"]) / 2
        self.ghosts = replay["ghosts"]
        known = self.ghosts + shared  # vertices of each process that others have
        self.start = self.away * (POINT * sum(run["points"]) + CELL * self.faces + SHARED * shared)
        self.predict_build(run, replay["layers"], replay["depth"] + 1)
        self.build_bytes += EDGE * CROSSING_EDGES * known * surface["edges"] / vertices
        self.prepare_bytes = (
            self.start + GROWTH * 2 * border + 16 * known + self.pairs * PREPARE_HEADERS
        )
        rounds = replay["label_rounds"] + replay["tree_rounds"]
        self.query_exchanges = 2 * (rounds + 2)
        labels = LABEL * known * max(1, 0.8 + RESENT * hops(run["division"], count))
        arrivals = ARRIVAL * shared + TAIL * TAILS * known
        self.query_bytes = labels + arrivals + self.pairs * ROUND_HEADERS * (rounds + 2)
        # Sizes of messages are sent to all processes. Cells and labels are sent to few.
        self.build_messages = self.pairs * self.build_exchanges * (0.75 + 0.5 / count)
        self.query_messages = self.pairs * self.query_exchanges * (0.5 + 0.5 / count)

    def predict_build(self, run, layers, depth):
        """Predicts the rounds and the cells of a build. A process grows its region until no window
        meets the rim, and at most by `depth` layers, which are the entire surface."""
        enough = min(depth, max(layers))
        rounds = next(k for k, number in enumerate(LAYERS, 1) if number >= enough)
        cells, before = 0.0, 0
        for number in LAYERS[:rounds]:
            for faces, width, least in zip(run["faces"], run["layer_cells"], layers):
                others = self.faces - faces
                if before == 0 or least > before:
                    cells += min(others, width * number) - min(others, width * before)
            before = number
        grown = min(before, depth)
        self.build_exchanges = 10 + 2 * rounds + 4 * grown + (2 if depth < before else 0)
        headers = self.pairs * (LAYER_HEADERS * grown + BUILD_HEADERS)
        self.build_bytes = self.start + GROWTH * cells + headers


COUNTS = {
    "ghosts": lambda run: sum(run["ghosts"]),
    "build_exchanges": lambda run: run["build_exchanges"],
    "build_messages": lambda run: run["build_messages"],
    "build_bytes": lambda run: run["build_bytes"],
    "prepare_bytes": lambda run: run["prepare_bytes"],
    "query_exchanges": lambda run: run["query_exchanges"],
    "query_messages": lambda run: run["query_messages"],
    "query_bytes": lambda run: run["query_bytes"],
}


def replays(line):
    """Returns the replays of a line by number of processes."""
    found, begin = {}, 0
    for k, count in enumerate(line.get("replay_processes", ())):
        names = ("ghosts", "label_rounds", "tree_rounds", "depth")
        found[count] = {name: line[f"replay_{name}"][k] for name in names}
        found[count]["layers"] = line["replay_layers"][begin : begin + count]
        begin += count
    return found


def read(paths):
    """Returns the runs on several processes, the properties of graphs, and the replays of
    divisions."""
    runs, surfaces, divisions = [], {}, {}
    for path in paths:
        with open(path, encoding="utf-8") as file:
            for line in map(json.loads, file):
                surface = line["mesh"], line["accuracy"]
                if "reach" in line:
                    surfaces[surface] = line
                divisions.setdefault((*surface, line["division"]), {}).update(replays(line))
                if line["processes"] > 1:
                    runs.append(line)
    return runs, surfaces, divisions


def compare(runs, surfaces, divisions):
    """Returns rows of predicted and measured counts."""
    rows = []
    for run in runs:
        surface = run["mesh"], run["accuracy"]
        replay = divisions[(*surface, run["division"])][run["processes"]]
        predicted = Prediction(run, surfaces[surface], replay)
        row = {name: run[name] for name in ("mesh", "accuracy", "division", "processes")}
        for name, measure in COUNTS.items():
            row[name] = getattr(predicted, name), measure(run)
        rows.append(row)
    return rows


def summary(rows):
    """Returns a table with the errors of each count."""
    lines = []
    for name in COUNTS:
        errors = [abs(row[name][0] / row[name][1] - 1.0) for row in rows]
        lines.append(
            {
                "count": name.replace("_", ", "),
                "median": statistics.median(errors),
                "largest": max(errors),
                "within": sum(error <= 0.25 for error in errors) / len(errors),
            }
        )
    columns = (
        column("count", "{}", "count"),
        column("median error", "{:.0%}", "median"),
        column("largest error", "{:.0%}", "largest"),
        column("runs within 25 %", "{:.0%}", "within"),
    )
    return listing(columns, lines)


def pair(scale, form):
    """Returns the format of a predicted and a measured count."""
    return lambda values: " / ".join(form.format(value / scale) for value in values)


def table(rows):
    """Returns a table with a row per run."""
    columns = (
        column("mesh", "{}", "mesh"),
        column("ε", "{:g}", "accuracy"),
        column("division", "{}", "division"),
        column("processes", "{}", "processes"),
        column("ghosts", pair(1, "{:.0f}"), "ghosts"),
        column("exchanges, build", pair(1, "{:.0f}"), "build_exchanges"),
        column("MB, build", pair(1e6, "{:.2f}"), "build_bytes"),
        column("exchanges, query", pair(1, "{:.0f}"), "query_exchanges"),
        column("KB, query", pair(1e3, "{:.0f}"), "query_bytes"),
    )
    return listing(columns, rows)


def peer_table(runs):
    """Returns a table with a row per run that compares with Boost."""
    lines = []
    for run in runs:
        if "boost_seconds" in run:
            line = {name: run[name] for name in ("mesh", "vertices", "accuracy", "processes")}
            line["times"] = run["labels_seconds"], min(run["boost_seconds"])
            line["ratio"] = line["times"][1] / line["times"][0]
            line["difference"] = max(run["boost_difference"])
            lines.append(line)
    columns = (
        column("mesh", "{}", "mesh"),
        column("points", lambda value: f"{value / 1e3:.0f}K", "vertices"),
        column("ε", "{:g}", "accuracy"),
        column("processes", "{}", "processes"),
        column("labels / Boost, ms", pair(1e-3, "{:.1f}"), "times"),
        column("ratio", "{:.1f}", "ratio"),
        column("largest difference", "{:g}", "difference"),
    )
    return listing(columns, lines)


def square_pieces(surface):
    """Returns the prediction for 1000 square pieces of 1000 x 1000 points. Paths cross all
    pieces."""
    count, side = 1000, 1000
    run = {
        "processes": count,
        "division": "bisection",
        "points": [side * (side + 4.0)] * count,
        "faces": [2.0 * side * side] * count,
        "shared": [4.0 * side] * count,
        "layer_cells": [8.0 * side] * count,
    }
    across = 2.0 * math.sqrt(count)
    shared = sum(run["shared"]) / 2
    replay = {
        "ghosts": sum(run["layer_cells"]) / 2 * (surface["reach"] + DEPTH) - shared,
        "label_rounds": 1.2 * across,
        "tree_rounds": 1.2 * across,
        "depth": across * side,
        "layers": [LAYERS[1]] * count,
    }
    return Prediction(run, surface, replay)


def large_table(surfaces):
    """Returns a table of predictions per process for 10^9 points on 1000 processes, with graphs as
    on large measured surfaces."""
    lines = []
    for (mesh, accuracy), surface in sorted(surfaces.items(), reverse=True):
        if surface["vertices"] < LARGE:
            continue
        made = square_pieces(surface)
        names = ("ghosts", "build_exchanges", "build_bytes", "query_exchanges", "query_bytes")
        line = {name: getattr(made, name) for name in names}
        line.update(mesh=mesh, accuracy=accuracy)
        line["graph"] = 16e6 * surface["edges"] / surface["vertices"]
        lines.append(line)
    columns = (
        column("graph like", "{}", "mesh"),
        column("ε", "{:g}", "accuracy"),
        column("MB of edges", lambda value: f"{value / 1e6:.0f}", "graph"),
        column("ghosts", lambda value: f"{value / 1e3:.0f}", "ghosts"),
        column("exchanges, build", "{:.0f}", "build_exchanges"),
        column("MB sent, build", lambda value: f"{value / 1e9:.0f}", "build_bytes"),
        column("exchanges, query", "{:.0f}", "query_exchanges"),
        column("MB sent, query", lambda value: f"{value / 1e9:.0f}", "query_bytes"),
    )
    return listing(columns, lines)


def main(page, *paths):
    runs, surfaces, divisions = read(paths)
    rows = compare(runs, surfaces, divisions)
    text = "\n".join((summary(rows), table(rows), large_table(surfaces), peer_table(runs)))
    with open(page, "w", encoding="utf-8") as file:
        file.write(text)
    print(text)


if __name__ == "__main__":
    main(*sys.argv[1:])
