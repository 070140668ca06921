# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Rivals that the thesis names, compared with our methods, by BenchmarkPublished."""

from plots import STYLES, Panel, plot
from tables import (
    ERRORS,
    column,
    digits,
    hundredths,
    listing,
    ratio,
    vertices_text,
)

from .exhibit import NOT_COMPARABLE, WORSE, Exhibit, Verdict
from .searches import published

ROUNDING = 1e-7  # smaller errors are drawn at this value


class Unfolding(Exhibit):
    """Distances between random pairs of vertices. GTU stores the exact distances between m samples, and
    unfolds the geodesic triangles of two vertices into the plane. Our graphs are searched by A*, optionally
    with straightened paths. Times are in units of an exact propagation on the same mesh."""

    name = "R1.1"
    title = "pairs of vertices: geodesic triangle unfolding"
    published = (
        "GTU answers in constant time, after one exact propagation per sample, with memory proportional to "
        "the square of the number of samples; its errors are not available."
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
                "vertices": figures["vertices"],
                "build": figures["seconds"] / figures["exact_seconds"],
                "query": figures["query_seconds"] / figures["exact_seconds"],
                "bytes": figures["bytes"],
                "error": figures["error"],
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
            column("preparation", digits, "build"),
            column("query, millionths", lambda x: digits(1e6 * x), "query"),
            ratio("bytes per vertex", ("bytes",), ("vertices",), digits),
            ERRORS,
        )
        return listing(columns, figures, f"{vertices_text(figures[0]['vertices'])}, 2000 pairs.")

    def pictures(self, figures):
        styles = dict(zip(("samples", "Graph", "Paths"), STYLES))
        titles = ("GTU", "graph", "graph, straightened")
        lines = {"mean": ("mean", "-"), "max": ("largest", "--")}
        curves = [
            (
                [
                    (row["bytes"] / row["vertices"], 100.0 * max(row["error"][key], ROUNDING))
                    for row in self.rows(figures, method)
                ],
                style,
                line,
            )
            for method, style in styles.items()
            for key, (_, line) in lines.items()
        ]
        panel = Panel("error in % (at least 1e-5)", "bytes per vertex", "", curves)
        legend = list(zip(titles, styles.values()))
        return {self.name: lambda path: plot(path, [[panel]], legend, lines.values())}

    def verdict(self, figures):
        theirs = self.rows(figures, "samples")[-1]
        ours = next(r for r in self.rows(figures, "Graph") if r["parameter"] == "0.01")
        return Verdict(
            NOT_COMPARABLE,
            f"With m = {theirs['parameter']} GTU takes {digits(theirs['build'] / ours['build'])} times as long "
            f"to prepare as the graph with ε = 0.01, and answers {digits(ours['query'] / theirs['query'])} times "
            "as fast. GTU suits many queries that tolerate errors without a bound.",
        )


class Merging(Exhibit):
    """Adjacent windows are merged if the relative change of each distance, accumulated along the path,
    stays within the tolerance. Times and windows are relative to exact propagation."""

    name = "R1.2"
    title = "approximate propagation with an error parameter"
    published = (
        "windows are merged within a tolerance that holds for each merge; figures are not available."
    )
    tolerances = ("0", "0.0001", "0.001", "0.01", "0.1")
    columns = (
        column("mesh", str, "model"),
        column("tolerance", str, "tolerance"),
        column("windows", hundredths, "windows"),
        column("time", hundredths, "time"),
        ERRORS,
        ("largest / tolerance", lambda row: digits(row["error"]["max"] / float(row["tolerance"]))),
    )

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
                        "vertices": figures["vertices"],
                        "tolerance": tolerance,
                        "windows": figures["windows_per_vertex"] / unit["windows_per_vertex"],
                        "time": figures["seconds"] / unit["seconds"],
                        "error": figures["error"],
                    }
                )
        return rows

    def note(self, figures):
        return f"{vertices_text(figures[0]['vertices'])}, three sources."

    def verdict(self, figures):
        worst = max(row["error"]["max"] / float(row["tolerance"]) for row in figures)
        return Verdict(
            NOT_COMPARABLE if worst <= 1.0 else WORSE,
            f"The largest error is {digits(worst)} times the tolerance.",
        )


EXHIBITS = (Unfolding(), Merging())
