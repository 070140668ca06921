# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Isolines: errors at the middles of their segments, by method and input."""

import measure_isolines
import numpy as np
import vtkdgg
from benchmark_results import count_text, digits, gain_text, nested, percent, slope, table
from measure_isolines import METHODS, exact_with, levels_of, line_errors, linear, solved, traced
from plot_tools import STYLES
from vtkdgg.commands.methods import graph as graph_of

from .drawing import plot_curves
from .exhibit import NOT_COMPARABLE, Exhibit, Verdict, judged
from .fields import sources_of
from .run import shared
from .tables import column, hundredths, joined, listing, named

# Published model, vertices, mean error in percent with two Steiner points, and linear.
PUBLISHED = (
    ("Beetle", 600, 0.12, 0.52),
    ("Bottle", 1000, 0.096, 0.43),
    ("Fertility", 1200, 0.074, 0.23),
    ("Kitten", 3000, 0.045, 0.36),
    ("Beetle", 5000, 0.019, 0.22),
    ("Buddha", 5000, 0.028, 0.10),
    ("Gargoyle", 5000, 0.030, 0.20),
    ("Bottle", 10000, 0.009, 0.096),
    ("Gargoyle", 50000, 0.004, 0.019),
)
SHOWN = ("Contour", "Apollonius0", "Apollonius2", "Sources", "Windows")


@shared
def isolines(run):
    """{mesh: {"vertices": number, method: errors}} of isolines of exact distances."""
    torus = f"torus-{run.pick(100, 320)}"
    run.uses(torus)
    meshes = [run.file(name) for name in ["bumpy-4", *run.scans(run.pick(2, None))]]
    sizes = run.pick("600,1000,5000", "600,1000,5000,10000,50000")
    options = ("-", "-", f"--sizes={sizes}", "--accuracy=0", *meshes, torus)
    found = measure_isolines.measure(measure_isolines.parse(options))
    return {mesh: {"vertices": row["vertices"], **row["exact"]} for mesh, row in found.items()}


class Errors(Exhibit):
    """Mean error of isolines of exact distances: |d - c| / c, with the exact distance d at the middle
    of a segment and its level c, for 20 levels."""

    name = "T5.4"
    title = "errors of isolines"
    published = "with two Steiner points, and linear: " + "; ".join(
        f"{model} {count_text(size)} {apollonius} and {linear} %"
        for model, size, apollonius, linear in PUBLISHED
    )

    def measure(self, run):
        return isolines(run)

    def table(self, figures):
        columns = (
            column("mesh", str, "name"),
            column("vertices", count_text, "vertices"),
            *(column(f"{METHODS[m]}, %", percent, m, "mean") for m in SHOWN),
        )
        return listing(columns, named(figures))

    def near(self, vertices):
        """The published means for meshes of about this size; k = 2, and linear."""
        sizes = {size for _, size, _, _ in PUBLISHED}
        best = min(sizes, key=lambda size: abs(np.log(size / vertices)))
        found = [(a, c) for _, size, a, c in PUBLISHED if size == best]
        return [(min(x) / 100.0, max(x) / 100.0) for x in zip(*found)]

    def verdict(self, figures):
        words, gains = [], []
        for cases in figures.values():
            (low, high), _ = self.near(cases["vertices"])
            words.append(judged(cases["Apollonius2"]["mean"], low, high, slack=2.0))
            gains.append(cases["Apollonius2"]["mean"] / cases["Sources"]["mean"])
        return Verdict(
            max(words, key=words.count),
            "The Apollonius method is beside published errors of models of about the same size. Virtual "
            f"sources, our default, are {digits(min(gains))} to {digits(max(gains))} times as accurate.",
        )


class ByModel(Errors):
    """The gain over linear isolines, which is what the figure shows."""

    name = "F5.16"
    title = "isolines of several models"
    published = (
        "isolines of the models of Table 5.4, as pictures; the gains below are from that table."
    )

    def table(self, figures):
        gains = {
            mesh: {m: cases["Contour"]["mean"] / cases[m]["mean"] for m in SHOWN[1:]}
            for mesh, cases in figures.items()
        }
        columns = [column(METHODS[m], gain_text, m) for m in SHOWN[1:]]
        return listing([column("mesh", str, "name"), *columns], named(gains))

    def verdict(self, figures):
        published = [linear / apollonius for _, _, apollonius, linear in PUBLISHED]
        ours = [
            c["Contour"]["mean"] / c["Apollonius2"]["mean"] for c in figures.values()
        ]
        return Verdict(
            judged(1.0 / np.median(ours), 1.0 / max(published), 1.0 / min(published)),
            f"By the Apollonius method isolines are {digits(min(ours))} to {digits(max(ours))} times as "
            f"accurate as linear ones; published are {digits(min(published))} to "
            f"{digits(max(published))}.",
        )


class Resolution(Errors):
    """Powers of the number of vertices that the mean errors of Table 5.4 follow on each surface."""

    name = "F5.14"
    title = "isolines against resolution"
    published = "isolines of a model with 3K and 5K vertices, as pictures."

    methods = ("Contour", "Apollonius2", "Sources")

    def curves(self, figures):
        """{surface: {method: [(vertices, error in percent)]}}."""
        found = {}
        for mesh, cases in figures.items():
            for method in self.methods:
                point = cases["vertices"], 100.0 * cases[method]["mean"]
                nested(found, mesh.rsplit("-", 1)[0]).setdefault(method, []).append(point)
        return found

    def table(self, figures):
        columns = [
            column(METHODS[m], lambda points: hundredths(slope(points)), m) for m in self.methods
        ]
        return listing([column("surface", str, "name"), *columns], named(self.curves(figures)))

    def draw(self, figures, path):
        styles = dict(zip(self.methods, STYLES))
        curves = [
            (sorted(methods[method]), style, "-")
            for methods in self.curves(figures).values()
            for method, style in styles.items()
        ]
        legend = [(METHODS[method], style) for method, style in styles.items()]
        return plot_curves(path, "mean error of isolines (%)", "vertices", curves, legend)

    def verdict(self, figures):
        powers = [slope(methods["Apollonius2"]) for methods in self.curves(figures).values()]
        return Verdict(
            NOT_COMPARABLE,
            "Pictures were published. The error of the Apollonius method falls with the power "
            f"{max(powers):.2f} to {min(powers):.2f} of the number of vertices: with the square of the length "
            "of edges, or nearly so.",
        )


class SteinerPoints(Errors):
    """Mean error over the number of Steiner points per edge, beside local sources, which need
    none."""

    name = "F5.15"
    title = "Steiner points"
    published = "errors for k = 0, 2, 10, 20 and 50; Table 5.4 has those of k = 2."

    def curves(self, figures):
        """{mesh: [(k, error)]} where more than two were measured."""
        found = {}
        for mesh, cases in figures.items():
            counts = measure_isolines.steiner_counts(cases)
            if len(counts) > 2:
                found[mesh] = [(k, cases[f"Apollonius{k}"]["mean"]) for k in counts]
        return found

    def table(self, figures):
        curves = self.curves(figures)
        counts = [k for k, _ in next(iter(curves.values()))]
        rows = [
            [
                mesh,
                *(percent(e) for _, e in points),
                percent(figures[mesh]["Sources"]["mean"]),
            ]
            for mesh, points in curves.items()
        ]
        return "Mean errors, %.\n\n" + table(
            ["mesh", *(f"k = {k}" for k in counts), METHODS["Sources"]], rows
        )

    def draw(self, figures, path):
        styles = dict(zip(self.curves(figures), STYLES))
        curves = [
            ([(k + 1, 100.0 * e) for k, e in points], styles[mesh], "-")
            for mesh, points in self.curves(figures).items()
        ]
        title = "mean error of isolines (%)"
        return plot_curves(path, title, "k + 1, parts of an edge", curves, list(styles.items()))

    def verdict(self, figures):
        texts = [
            f"{percent(points[0][1])} % at k = {points[0][0]} and {percent(points[-1][1])} % at "
            f"k = {points[-1][0]}"
            for points in self.curves(figures).values()
        ]
        falls = all(points[-1][1] < points[0][1] for points in self.curves(figures).values())
        return Verdict(
            NOT_COMPARABLE,
            f"The error {'falls' if falls else 'does not fall'} with k: {'; '.join(texts)}.",
        )


def errors_by_method(exact, field):
    """Returns the errors of the isolines of a field, exact distances with windows given."""
    levels = levels_of(exact)
    lines = {
        "linear": linear(field, levels),
        "Apollonius, k = 2": traced(field, levels, 2),
        "virtual sources": traced(field, levels),
    }
    return {title: line_errors(exact, vtkdgg.check(made)) for title, made in lines.items()}


def by_method(title, figures, note, keys):
    """The table of the errors of methods, in percent."""
    columns = [
        column(method, joined(percent, *keys), method) for method in next(iter(figures.values()))
    ]
    return listing([column(title, str, "name"), *columns], named(figures), note)


class SeveralSources(Exhibit):
    """Isolines of the distance from the nearest of several vertices."""

    name = "F5.17"
    title = "several sources"
    published = "isolines of several sources, as pictures."
    counts = (1, 3, 10)

    def measure(self, run):
        mesh = run.mesh(run.pick("bumpy-4", "bumpy-5"))
        found = {}
        for count in self.counts:
            exact, field = (exact_with(mesh, sources_of(mesh, count), w) for w in (True, False))
            found[str(count)] = errors_by_method(exact, field)
        return found

    def table(self, figures):
        return by_method("sources", figures, "Mean and largest errors, %.", ("mean", "max"))

    def verdict(self, figures):
        gains = [f["linear"]["mean"] / f["Apollonius, k = 2"]["mean"] for f in figures.values()]
        return Verdict(
            NOT_COMPARABLE,
            "Pictures were published. The Apollonius method gains "
            f"{digits(min(gains))} to {digits(max(gains))} times over linear isolines with 1 to 10 "
            "sources; most of what is left lies at ridges.",
        )


class ApproximateInput(Exhibit):
    """Isolines of approximate distances: the error of the distances is part of theirs."""

    name = "F5.18"
    title = "isolines of approximate distances"
    published = "Apollonius isolines of approximate distances, as pictures."

    def measure(self, run):
        mesh = run.mesh(run.pick("bumpy-4", "bumpy-5"))
        sources = sources_of(mesh, 1)
        exact = exact_with(mesh, sources, True)
        inputs = {
            "exact": vtkdgg.vtkExactGeodesicDistance,
            "DGG, ε = 0.01": graph_of(0.01),
            "heat": vtkdgg.vtkHeatGeodesicDistance,
            "fast marching": vtkdgg.vtkDGGFastMarchingDistance,
        }
        return {
            title: errors_by_method(exact, solved(make, mesh, sources))
            for title, make in inputs.items()
        }

    def table(self, figures):
        return by_method("distances", figures, "Mean errors, %.", ("mean",))

    def verdict(self, figures):
        graph, heat = figures["DGG, ε = 0.01"], figures["heat"]
        key = "Apollonius, k = 2"
        return Verdict(
            NOT_COMPARABLE,
            f"Pictures were published. With heat the error is that of the distances "
            f"({percent(heat[key]['mean'])} %, {percent(heat['linear']['mean'])} % linear); with a graph "
            f"the method matters ({percent(graph[key]['mean'])} %, {percent(graph['linear']['mean'])} %).",
        )


EXHIBITS = (
    Errors(),
    ByModel(),
    Resolution(),
    SteinerPoints(),
    SeveralSources(),
    ApproximateInput(),
)
