# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Isolines: errors at the midpoints of their segments, by method and input."""

import measure_isolines
import numpy as np
import vtkdgg
from measure_isolines import (
    INPUTS,
    METHODS,
    exact_with,
    gain,
    levels_of,
    line_errors,
    linear,
    solved,
    traced,
)
from plots import STYLES, Panel, plot
from tables import column, count_text, gain_text, joined, listing, named, percent, range_text, slope

from .exhibit import NOT_COMPARABLE, Exhibit, Verdict, judged, most_frequent
from .fields import sources_of

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
SHOWN = ("Apollonius0", "Apollonius2", "Sources", "Windows")


class Errors(Exhibit):
    """Mean errors, in percent, of isolines of exact distances at 20 levels, and gains over
    `vtkContourFilter`. The error of a segment is |d - c| / c, where d is the exact distance at its midpoint
    and c its level. The second table varies the number k of Steiner points per edge."""

    name = "T5.4"
    title = "errors of isolines"
    also = {
        "F5.14": "isolines against resolution",
        "F5.15": "Steiner points",
        "F5.16": "isolines of several models",
    }
    published = "errors with two Steiner points and by linear interpolation: " + "; ".join(
        f"{model} {count_text(size)}: {apollonius} and {linear} %"
        for model, size, apollonius, linear in PUBLISHED
    ) + "."

    def measure(self, run):
        torus = f"torus-{run.pick(100, 320)}"
        run.uses(torus)
        meshes = [run.file(name) for name in ["bumpy-4", *run.scans(run.pick(2, None))]]
        sizes = run.pick("600,1000,5000", "600,1000,5000,10000,50000")
        options = ("-", "-", f"--sizes={sizes}", "--accuracy=0", *meshes, torus)
        found = measure_isolines.measure(measure_isolines.parse(options))
        return {mesh: {"vertices": row["vertices"], **row["exact"]} for mesh, row in found.items()}

    def table(self, figures):
        def cell(row, method):
            return f"{percent(row[method]['mean'])} ({gain_text(gain(row, method))})"

        columns = [
            column("mesh", str, "name"),
            column("vertices", count_text, "vertices"),
            column(METHODS["Contour"], percent, "Contour", "mean"),
            *((METHODS[m], lambda row, m=m: cell(row, m)) for m in SHOWN),
        ]
        made = listing(columns, named(figures))
        rows = self.varied(figures)
        counts = measure_isolines.steiner_counts(next(iter(rows.values()), {}))
        columns = [column("mesh", str, "name")]
        columns += [column(f"k = {k}", percent, f"Apollonius{k}", "mean") for k in counts]
        columns += [column(METHODS["Sources"], percent, "Sources", "mean")]
        return "\n".join(filter(None, (made, listing(columns, named(rows)))))

    def varied(self, figures):
        """Returns the meshes for which more than two numbers of Steiner points were measured."""
        counts = measure_isolines.steiner_counts
        return {mesh: cases for mesh, cases in figures.items() if len(counts(cases)) > 2}

    def by_surface(self, figures, method):
        """Returns a curve (vertices, error in percent) per surface."""
        found = {}
        for mesh, cases in figures.items():
            point = cases["vertices"], 100.0 * cases[method]["mean"]
            found.setdefault(mesh.rsplit("-", 1)[0], []).append(point)
        return [sorted(points) for points in found.values()]

    def pictures(self, figures):
        methods = dict(zip(("Contour", "Apollonius2", "Sources"), STYLES))
        curves = [
            (points, style, "-")
            for method, style in methods.items()
            for points in self.by_surface(figures, method)
        ]
        resolution = Panel("mean error of isolines (%)", "vertices", "", curves)
        rows = self.varied(figures)
        meshes = dict(zip(rows, STYLES))
        curves = [
            (
                [
                    (k + 1, 100.0 * cases[f"Apollonius{k}"]["mean"])
                    for k in measure_isolines.steiner_counts(cases)
                ],
                meshes[mesh],
                "-",
            )
            for mesh, cases in rows.items()
        ]
        steiner = Panel("mean error of isolines (%)", "k + 1, parts of an edge", "", curves)
        legend = [(METHODS[method], style) for method, style in methods.items()]
        return {
            "F5.14": lambda path: plot(path, [[resolution]], legend),
            "F5.15": lambda path: plot(path, [[steiner]], meshes.items()),
        }

    def near(self, vertices):
        """Returns the published means with k = 2 for meshes of about this size."""
        best = min(PUBLISHED, key=lambda row: abs(np.log(row[1] / vertices)))[1]
        found = [mean / 100.0 for _, size, mean, _ in PUBLISHED if size == best]
        return min(found), max(found)

    def verdict(self, figures):
        words = [
            judged(cases["Apollonius2"]["mean"], *self.near(cases["vertices"]), slack=2.0)
            for cases in figures.values()
        ]
        better = [c["Apollonius2"]["mean"] / c["Sources"]["mean"] for c in figures.values()]
        powers = map(slope, self.by_surface(figures, "Apollonius2"))
        return Verdict(
            most_frequent(words),
            "Errors are compared with the published errors of models of about the same size. Virtual "
            f"sources, our default, are {range_text(better)} times as accurate as the Apollonius method. The "
            "error of that method is a power of the number of vertices, with exponents of "
            f"{range_text(list(powers), '{:.2f}'.format)}.",
        )

    def words(self, figures):
        published = [linear / apollonius for _, _, apollonius, linear in PUBLISHED]
        ours = np.median([gain(cases, "Apollonius2") for cases in figures.values()])
        by_model = judged(1.0 / ours, 1.0 / max(published), 1.0 / min(published))
        word = self.verdict(figures).word
        return {**dict.fromkeys(self.titles, NOT_COMPARABLE), "T5.4": word, "F5.16": by_model}


def errors_by_method(exact, field):
    """Returns the errors of the isolines of a field, given exact distances with windows."""
    levels = levels_of(exact)
    lines = {
        "linear": linear(field, levels),
        "Apollonius, k = 2": traced(field, levels, 2),
        "virtual sources": traced(field, levels),
    }
    return {title: line_errors(exact, vtkdgg.check(made)) for title, made in lines.items()}


class SeveralSources(Exhibit):
    """Mean and largest errors, in percent, of isolines of the distance from the nearest of several
    vertices."""

    name = "F5.17"
    title = "several sources"
    published = "isolines of several sources, as pictures."
    counts = (1, 3, 10)
    columns = (
        column("sources", str, "name"),
        column("linear", joined(percent, "mean", "max"), "linear"),
        column("Apollonius, k = 2", joined(percent, "mean", "max"), "Apollonius, k = 2"),
        column("virtual sources", joined(percent, "mean", "max"), "virtual sources"),
    )

    def measure(self, run):
        mesh = run.mesh(run.pick("bumpy-4", "bumpy-5"))
        found = {}
        for count in self.counts:
            exact, field = (exact_with(mesh, sources_of(mesh, count), w) for w in (True, False))
            found[str(count)] = errors_by_method(exact, field)
        return found


class ApproximateInput(Exhibit):
    """Mean errors, in percent, of isolines of approximate distances, including the errors of the
    distances."""

    name = "F5.18"
    title = "isolines of approximate distances"
    published = "Apollonius isolines of approximate distances, as pictures."
    columns = (
        column("distances", str, "name"),
        column("linear", percent, "linear", "mean"),
        column("Apollonius, k = 2", percent, "Apollonius, k = 2", "mean"),
        column("virtual sources", percent, "virtual sources", "mean"),
    )

    def measure(self, run):
        mesh = run.mesh(run.pick("bumpy-4", "bumpy-5"))
        sources = sources_of(mesh, 1)
        exact = exact_with(mesh, sources, True)
        inputs = {
            "exact": vtkdgg.vtkExactGeodesicDistance,
            "DGG, ε = 0.01": INPUTS["DGG"](0.01),
            "heat": vtkdgg.vtkHeatGeodesicDistance,
            "fast marching": vtkdgg.vtkDGGFastMarchingDistance,
        }
        return {
            title: errors_by_method(exact, solved(make, mesh, sources))
            for title, make in inputs.items()
        }


EXHIBITS = (Errors(), SeveralSources(), ApproximateInput())
