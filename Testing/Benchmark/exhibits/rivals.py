# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Methods that the thesis names as rivals, beside ours; by BenchmarkPublished."""

from benchmark_results import digits, mean, median, percent
from plot_tools import STYLES

from .drawing import plot_curves
from .exhibit import NOT_COMPARABLE, WORSE, Exhibit, Verdict
from .searches import errors_of, published
from .tables import ERRORS, column, hundredths, listing, vertices_text

ROUNDING = 1e-7  # smaller errors are drawn at this value


class Unfolding(Exhibit):
    """Random pairs of vertices. GTU has the exact distances between m samples, and lays the geodesic
    triangles of two vertices out in the plane. Ours are asked by A*; paths of the graph can be
    straightened as well. Times are in units of an exact propagation on the same mesh."""

    name = "R1.1"
    title = "pairs of vertices: geodesic triangle unfolding"
    published = (
        "GTU answers in constant time, after as many exact propagations as there are samples, and takes "
        "memory with the square of that; its errors are not at hand."
    )
    accuracies = ("0.1", "0.01", "0.001")
    samples = (50, 100, 200, 400)

    def measure(self, run):
        name = run.pick("bumpy-4", "bumpy-5")
        options = (f"--samples={','.join(map(str, self.samples))}",)
        found = published(run, name, "Unfolding", self.accuracies, options=options)
        return [
            {
                "method": key.split("/")[0].split("=")[0],
                "parameter": key.split("/")[-1].split("=")[-1],
                "vertices": median(figures, "vertices"),
                "build": median(figures, "seconds") / median(figures, "exact_seconds"),
                "query": median(figures, "query_seconds") / median(figures, "exact_seconds"),
                "bytes": median(figures, "bytes"),
                "error": errors_of(figures),
            }
            for key, figures in found.items()
        ]

    def rows(self, figures, method):
        return [row for row in figures if row["method"] == method]

    def table(self, figures):
        titles = {
            "samples": "GTU, m = {}",
            "Graph": "graph, ε = {}",
            "Paths": "graph, ε = {}, straightened",
        }
        columns = (
            ("method", lambda row: titles[row["method"]].format(row["parameter"])),
            column("prepared in", digits, "build"),
            ("query, millionths", lambda row: digits(1e6 * row["query"])),
            ("bytes per vertex", lambda row: digits(row["bytes"] / row["vertices"])),
            ERRORS,
        )
        return listing(columns, figures, f"{vertices_text(figures[0]['vertices'])}, 2000 pairs.")

    def draw(self, figures, path):
        titles = {"samples": "GTU", "Graph": "graph", "Paths": "graph, straightened"}
        styles = dict(zip(titles, STYLES))
        lines = {"mean": "-", "max": "--"}
        curves = [
            (
                [
                    (row["bytes"] / row["vertices"], 100.0 * max(row["error"][key], ROUNDING))
                    for row in rows
                ],
                style,
                line,
            )
            for method, style in styles.items()
            for rows in [self.rows(figures, method)]
            for key, line in lines.items()
        ]
        legend = [(titles[method], style) for method, style in styles.items()]
        return plot_curves(
            path,
            "error in % (at least 1e-5)",
            "bytes per vertex",
            curves,
            legend,
            [("mean", "-"), ("largest", "--")],
        )

    def verdict(self, figures):
        theirs = self.rows(figures, "samples")[-1]
        ours = next(r for r in self.rows(figures, "Graph") if r["parameter"] == "0.01")
        paths = next(r for r in self.rows(figures, "Paths") if r["parameter"] == "0.01")
        return Verdict(
            NOT_COMPARABLE,
            f"With m = {theirs['parameter']} GTU is off by {percent(theirs['error']['mean'])} % on average "
            f"and {percent(theirs['error']['max'])} % at most, which nothing bounds beforehand; the graph with "
            f"ε = 0.01 by {percent(ours['error']['mean'])} and {percent(ours['error']['max'])} %, its "
            f"straightened paths by {percent(paths['error']['mean'])} and {percent(paths['error']['max'])} %. "
            f"GTU takes {digits(theirs['build'] / ours['build'])} times as long to prepare, and answers "
            f"{digits(ours['query'] / theirs['query'])} times as fast: a table for many queries, where "
            "errors of that size will do.",
        )


class Merging(Exhibit):
    """Windows side by side are merged where that changes no distance by more than a part of it, the
    tolerance, all mergers of a way together; times and windows are those of the exact propagation
    without mergers, which is 1."""

    name = "R1.2"
    title = "approximate propagation with an error parameter"
    published = (
        "windows are merged within a tolerance, each merger by itself; its figures are not at hand."
    )
    tolerances = ("0", "0.0001", "0.001", "0.01", "0.1")

    def measure(self, run):
        rows = []
        for name in run.pick(("bumpy-5", "bumpy-5-stretched-8"), ("bumpy-6", "bumpy-6-stretched-8")):
            options = (f"--tolerances={','.join(self.tolerances)}",)
            found = published(run, name, "Merging", options=options)
            unit = found[f"tolerance={self.tolerances[0]}"]
            for tolerance in self.tolerances[1:]:
                figures = found[f"tolerance={tolerance}"]
                rows.append(
                    {
                        "model": name,
                        "vertices": median(figures, "vertices"),
                        "tolerance": tolerance,
                        "windows": mean(figures, "windows_per_vertex")
                        / mean(unit, "windows_per_vertex"),
                        "time": mean(figures, "seconds") / mean(unit, "seconds"),
                        "error": errors_of(figures),
                    }
                )
        return rows

    def table(self, figures):
        columns = (
            column("mesh", str, "model"),
            column("tolerance", str, "tolerance"),
            column("windows", hundredths, "windows"),
            column("time", hundredths, "time"),
            ERRORS,
            (
                "largest / tolerance",
                lambda row: digits(row["error"]["max"] / float(row["tolerance"])),
            ),
        )
        note = f"{vertices_text(figures[0]['vertices'])}, three sources."
        return listing(columns, figures, note)

    def verdict(self, figures):
        worst = max(row["error"]["max"] / float(row["tolerance"]) for row in figures)
        least = min(figures, key=lambda row: row["time"])
        return Verdict(
            NOT_COMPARABLE if worst <= 1.0 else WORSE,
            f"The largest error is {digits(worst)} times the tolerance. At a tolerance of "
            f"{least['tolerance']} the propagation takes {least['time']:.2f} times as long as the exact one.",
        )


EXHIBITS = (Unfolding(), Merging())
