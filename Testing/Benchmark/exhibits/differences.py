# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Differences from the thesis that none of its exhibits shows."""

import statistics
import time

import numpy as np
import vtkdgg
from benchmark_results import count_text, digits, percent, table
from Published import bidirectional
from vtkdgg.commands.methods import field
from vtkdgg.commands.sizes import floor_of

from . import surfaces
from .exhibit import BETTER, NOT_COMPARABLE, WORSE, Exhibit, Verdict
from .fields import errors_text, summary

ACCURACY = 0.01


class BothEnds(Exhibit):
    """Random pairs of vertices in a graph: vertices settled until the shortest path is known, and how
    often the path that the published search ends with is longer."""

    name = "D1.1"
    title = "paths: A* instead of a search from both ends"
    published = "a search from both ends that stops where they meet first."
    pairs = 60

    def measure(self, run):
        mesh = run.mesh(run.pick("bumpy-4", "bumpy-5"))
        graph = vtkdgg.Graph(mesh, accuracy=ACCURACY)
        read = bidirectional.arrays(graph)
        points, _ = surfaces.arrays_of(mesh)
        random = np.random.default_rng(surfaces.SEED)
        found = {"one end": [], "both ends": [], "both ends, as published": [], "A*": []}
        for _ in range(self.pairs):
            start, end = random.choice(len(points), 2, replace=False).tolist()
            straight = np.linalg.norm(points - points[end], axis=1) * (1.0 - 1e-6)
            found["one end"].append(bidirectional.one_sided(read, start, end))
            found["both ends"].append(bidirectional.two_sided(read, start, end, False))
            found["both ends, as published"].append(bidirectional.two_sided(read, start, end, True))
            found["A*"].append(bidirectional.one_sided(read, start, end, straight))
        shortest = np.array([length for length, _ in found["one end"]])
        return {
            "vertices": len(points),
            "searches": {
                title: {
                    "settled": statistics.fmean(count for _, count in pairs) / len(points),
                    "wrong": float((longer(pairs, shortest) > 1e-9).mean()),
                    "excess": float(longer(pairs, shortest).max()),
                }
                for title, pairs in found.items()
            },
        }

    def table(self, figures):
        rows = [
            [
                title,
                f"{100.0 * row['settled']:.1f}",
                f"{100.0 * row['wrong']:.0f}",
                percent(row["excess"]) if row["wrong"] else "–",
            ]
            for title, row in figures["searches"].items()
        ]
        header = [
            "search",
            "vertices settled, %",
            "not the shortest path, %",
            "longer by at most, %",
        ]
        return (
            f"{count_text(figures['vertices'])} vertices, {self.pairs} pairs, ε = {ACCURACY}.\n\n"
            + table(header, rows)
        )

    def verdict(self, figures):
        found = figures["searches"]
        star, both = found["A*"], found["both ends"]
        published = found["both ends, as published"]
        return Verdict(
            BETTER if star["settled"] < both["settled"] and not star["wrong"] else WORSE,
            f"As published {100.0 * published['wrong']:.0f} % of the paths are not the shortest ones. A* "
            f"settles {digits(both['settled'] / star['settled'])} times fewer vertices than a search from "
            "both ends that is right.",
        )


def longer(pairs, shortest):
    """By which part lengths are longer."""
    return np.array([length for length, _ in pairs]) / shortest - 1.0


class Links(Exhibit):
    """Sources in the middle of random faces: the graph is linked to them and does not change. Times
    are those of a query from a vertex."""

    name = "D1.2"
    title = "points anywhere: links instead of insertion"
    published = "the point is inserted into the triangulation, and the graph is changed around it."
    sources = 10

    def measure(self, run):
        mesh = run.mesh(run.pick("bumpy-4", "bumpy-5"))
        points, triangles = surfaces.arrays_of(mesh)
        start = time.process_time()
        graph = vtkdgg.Graph(mesh, accuracy=ACCURACY)
        built = time.process_time() - start
        faces = np.random.default_rng(surfaces.SEED).choice(len(triangles), self.sources)
        places = points[triangles[faces]].mean(axis=1)
        exact = [field(vtkdgg.vtkExactGeodesicDistance, mesh, place) for place in places.tolist()]
        graph.distance(0)
        graph.distance(places[:1])  # what is prepared once
        times = {"vertex": [], "face": []}
        found = []
        for k, place in enumerate(places):
            for kind, source in (("vertex", k), ("face", place[None])):
                start = time.process_time()
                distances = graph.distance(source, correction=False)
                times[kind].append(time.process_time() - start)
            found.append(distances)
        unit = statistics.median(times["vertex"])
        return {
            "vertices": len(points),
            "query": statistics.median(times["face"]) / unit,
            "build": built / unit,
            "error": summary(found, exact, floor_of(mesh)),
        }

    def table(self, figures):
        rows = [
            ["query from a point in a face", f"{figures['query']:.2f}"],
            ["building the graph anew", f"{figures['build']:.0f}"],
            ["error: mean / 99.9 % / max", errors_text(figures["error"])],
        ]
        return (
            f"{count_text(figures['vertices'])} vertices, {self.sources} sources, ε = {ACCURACY}.\n\n"
            + table(["what", "queries from a vertex"], rows)
        )

    def verdict(self, figures):
        kept = figures["error"]["max"] <= ACCURACY
        return Verdict(
            NOT_COMPARABLE if kept else WORSE,
            f"No figures were published. A query from a point in a face takes {figures['query']:.2f} times one from a vertex, and "
            f"the largest error, {percent(figures['error']['max'])} %, is below ε. Nothing is changed, so "
            "that several threads can ask at once.",
        )


EXHIBITS = (BothEnds(), Links())
