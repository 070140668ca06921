# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Isolines: errors at the middles of their segments, by method and input."""

import numpy as np
import vtkdgg
from benchmark_results import (
    count_text,
    digits,
    median,
    nested,
    percent,
    ratio_text,
    slope,
    table,
)
from plot_tools import STYLES
from summarize_isolines import METHODS, STEINER
from summarize_isolines import Run as IsolineRun
from vtkdgg.commands.methods import graph as graph_of
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkContourFilter

from .drawing import plot_curves
from .exhibit import NOT_COMPARABLE, Exhibit, Verdict, judged
from .fields import sources_of
from .run import shared
from .tables import column, hundredths, listing, named

# Published: model, vertices, mean error with two Steiner points, and linear, in percent.
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
    """{mesh: {method: {figure: value}}} of isolines of exact distances, by BenchmarkIsolines."""
    rings = run.pick(100, 320)
    run.uses(f"a torus of {rings} rings")
    path = run.program(
        "BenchmarkIsolines",
        f"--sizes={run.pick('600,1000,5000', '600,1000,5000,10000,50000')}",
        f"--torus={rings}",
        "--sources=0",
        "--subdivided=none",
        "--benchmark_filter=^Isolines/[^/]*/Exact/",
        *(run.file(name) for name in ["bumpy-4", *run.scans(run.pick(2, None))]),
    )
    keys = ("error_mean", "error_max", "seconds", "vertices", "segments")
    return {
        mesh: {
            method: {key: median(figures, key) for key in keys} for method, figures in cases.items()
        }
        for mesh, cases in IsolineRun(path).exact()
    }


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
            column("vertices", count_text, "Contour", "vertices"),
            *(column(f"{METHODS[m]}, %", percent, m, "error_mean") for m in SHOWN),
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
            (low, high), _ = self.near(cases["Contour"]["vertices"])
            words.append(judged(cases["Apollonius2"]["error_mean"], low, high, slack=2.0))
            gains.append(cases["Apollonius2"]["error_mean"] / cases["Sources"]["error_mean"])
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
            mesh: {m: cases["Contour"]["error_mean"] / cases[m]["error_mean"] for m in SHOWN[1:]}
            for mesh, cases in figures.items()
        }
        columns = [column(METHODS[m], times_text, m) for m in SHOWN[1:]]
        return listing([column("mesh", str, "name"), *columns], named(gains))

    def verdict(self, figures):
        published = [linear / apollonius for _, _, apollonius, linear in PUBLISHED]
        ours = [
            c["Contour"]["error_mean"] / c["Apollonius2"]["error_mean"] for c in figures.values()
        ]
        return Verdict(
            judged(1.0 / np.median(ours), 1.0 / max(published), 1.0 / min(published)),
            f"By the Apollonius method isolines are {digits(min(ours))} to {digits(max(ours))} times as "
            f"accurate as linear ones; published are {digits(min(published))} to "
            f"{digits(max(published))}.",
        )


def times_text(gain):
    """As ratio_text() has it."""
    return ratio_text(gain, 1.0)


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
                point = cases[method]["vertices"], 100.0 * cases[method]["error_mean"]
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
            counts = sorted(
                int(STEINER.match(name)["count"]) for name in cases if STEINER.match(name)
            )
            if len(counts) > 2:
                found[mesh] = [(k, cases[f"Apollonius{k}"]["error_mean"]) for k in counts]
        return found

    def table(self, figures):
        curves = self.curves(figures)
        counts = [k for k, _ in next(iter(curves.values()))]
        rows = [
            [
                mesh,
                *(percent(e) for _, e in points),
                percent(figures[mesh]["Sources"]["error_mean"]),
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


# Several sources and approximate distances, by the filters.


def exact_with_windows(mesh, sources):
    """The filter of exact distances, which can be asked at any point of the surface."""
    exact = vtkdgg.vtkExactGeodesicDistance()
    exact.SetInputData(mesh)
    exact.SetSourceIds(sources)
    exact.GenerateWindowsOn()
    exact.GenerateVirtualSourceOn()
    vtkdgg.check(exact)
    return exact


def middles(lines):
    """Of all segments of polylines, and their levels."""
    points = vtk_to_numpy(lines.GetPoints().GetData()).astype(float)
    offsets = vtk_to_numpy(lines.GetLines().GetOffsetsArray())
    ids = vtk_to_numpy(lines.GetLines().GetConnectivityArray())
    inside = np.ones(max(0, len(ids) - 1), bool)
    inside[offsets[1:-1] - 1] = False
    levels = lines.GetPointData().GetArray("IsoValue") or lines.GetCellData().GetArray("IsoValue")
    if lines.GetPointData().GetArray("IsoValue"):
        values = vtk_to_numpy(levels)[ids[:-1]]
    elif levels:
        values = np.repeat(vtk_to_numpy(levels), np.diff(offsets))[:-1]
    else:
        values = vtk_to_numpy(lines.GetPointData().GetScalars())[ids[:-1]]
    return 0.5 * (points[ids[:-1]] + points[ids[1:]])[inside], values[inside]


def line_errors(exact, lines):
    """Mean and largest |d - c| / c over the segments."""
    places, levels = middles(lines)
    probe = vtkdgg.vtkGeodesicProbe()
    probe.SetInputConnection(exact.GetOutputPort())
    probe.SetProbeData(vtkdgg.Mesh(places).as_polydata())
    found = vtkdgg.check(probe).GetPointData().GetArray(exact.GetDistanceArrayName())
    sizes = np.abs(vtk_to_numpy(found) / levels - 1.0)
    sizes = sizes[np.isfinite(sizes)]
    return {"mean": float(sizes.mean()), "max": float(sizes.max()), "segments": len(sizes)}


def levels_of(exact, count=20):
    """Evenly spread over the distances."""
    array = exact.GetOutput().GetPointData().GetArray(exact.GetDistanceArrayName())
    largest = np.nanmax(vtk_to_numpy(array))
    return largest * np.arange(1, count + 1) / (count + 1)


def traced(distance, levels, method, steiner=2):
    """Isolines by one of our methods."""
    lines = vtkdgg.vtkApolloniusIsolines()
    lines.SetInputConnection(distance.GetOutputPort())
    lines.SetMethod(getattr(lines, method))
    lines.SetSteinerPoints(steiner)
    for i, level in enumerate(levels):
        lines.SetValue(i, level)
    return vtkdgg.check(lines)


def linear(distance, levels):
    """Those of vtkContourFilter."""
    lines = vtkContourFilter()
    lines.SetInputConnection(distance.GetOutputPort())
    lines.SetInputArrayToProcess(0, 0, 0, 0, distance.GetDistanceArrayName())
    for i, level in enumerate(levels):
        lines.SetValue(i, level)
    return vtkdgg.check(lines)


def errors_by_method(exact, distance, levels):
    return {
        "linear": line_errors(exact, linear(distance, levels)),
        "Apollonius, k = 2": line_errors(exact, traced(distance, levels, "Apollonius")),
        "virtual sources": line_errors(exact, traced(distance, levels, "LocalSources")),
    }


def by_method(title, figures, note, keys):
    """The table of the errors of methods, in percent."""
    columns = [
        column(method, lambda errors: " / ".join(percent(errors[key]) for key in keys), method)
        for method in next(iter(figures.values()))
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
            exact = exact_with_windows(mesh, sources_of(mesh, count))
            found[str(count)] = errors_by_method(exact, exact, levels_of(exact))
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
        exact = exact_with_windows(mesh, sources)
        levels = levels_of(exact)
        inputs = {
            "exact": exact,
            "DGG, ε = 0.01": graph_of(0.01)(),
            "heat": vtkdgg.vtkHeatGeodesicDistance(),
            "fast marching": vtkdgg.vtkDGGFastMarchingDistance(),
        }
        found = {}
        for title, distance in inputs.items():
            if distance is not exact:
                distance.SetInputData(mesh)
                distance.SetSourceIds(sources)
                distance.GenerateVirtualSourceOn()
                vtkdgg.check(distance)
            found[title] = errors_by_method(exact, distance, levels)
        return found

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
