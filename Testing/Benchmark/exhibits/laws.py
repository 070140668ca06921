# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Laws that errors follow, fitted to what is measured."""

from dataclasses import dataclass

import measure_clouds
import numpy as np
from benchmark_results import count_text, digits, percent, table
from plot_tools import STYLES

from .clouds import errors_of
from .drawing import plot_curves
from .exhibit import NOT_COMPARABLE, Exhibit, Verdict


class CloudDensity(Exhibit):
    """Random points of a sphere and of a torus (radii 1 and 0.4), several draws of each number: graphs
    of scheme C as it is by default, of one draw with a tenth of the tolerance for edges that are left
    out as well, and fast marching in the band. Mean errors of graphs are fitted by C (s/r)^p + F, all
    draws together: s is the spacing, the root of the area per point, r the smallest radius of curvature.
    Distances on the sphere are arcs, those on the torus exact ones along a mesh of 205K vertices, from
    which the points are drawn.
    """

    name = "L1.1"
    title = "error of cloud distances against spacing"
    published = (
        "none; the thesis has mean errors of single clouds, and names the law as future work (6.2)."
    )
    tolerances = {"graph": 0.001, "finer graph": 0.0001}
    methods = (*tolerances, "fast marching")

    def measure(self, run):
        counts = run.pick((1000, 2000, 5000, 10000, 20000), (1000, 2000, 5000, 10000, 20000, 50000))
        found = {}
        run.uses("random points of a sphere", measure_clouds.TORUS)
        for shape, radius, area, draw in (
            ("sphere", 1.0, 4.0 * np.pi, measure_clouds.sphere),
            ("torus", 0.4, 4.0 * np.pi**2 * 0.4, measure_clouds.torus),
        ):
            found[shape] = []
            for count in counts:
                for seed in range(run.pick(3, 5)):
                    cloud = draw(count, seed=seed)
                    row = {"points": count, "seed": seed, "x": (area / count) ** 0.5 / radius}
                    methods = [m for m in self.methods if seed == 0 or m != "finer graph"]
                    row.update({method: self.errors(method, cloud) for method in methods})
                    found[shape].append(row)
        return found

    def errors(self, method, cloud):
        """Returns the errors of a method on a cloud."""
        if method in self.tolerances:
            asked, _ = measure_clouds.built(cloud.data, Accuracy=self.tolerances[method])
        else:
            asked = measure_clouds.marching(cloud.data)
        return errors_of(cloud, asked)

    def points_of(self, rows, method):
        """(x, mean error in percent)."""
        return [(row["x"], 100.0 * row[method]["mean"]) for row in rows if method in row]

    def fits(self, figures):
        """{shape: {method: fit of points_of()}}."""
        return {
            shape: {method: fit(self.points_of(rows, method)) for method in self.tolerances}
            for shape, rows in figures.items()
        }

    def table(self, figures):
        rows = []
        for shape, draws in figures.items():
            for count in sorted({row["points"] for row in draws}):
                same = [row for row in draws if row["points"] == count]
                rows.append([shape, count_text(count), digits(same[0]["x"])])
                for method in self.methods:
                    means = [mean for _, mean in self.points_of(same, method)]
                    least, most = digits(min(means)), digits(max(means))
                    rows[-1].append(least if least == most else f"{least} to {most}")
                rows[-1].append(percent(max(row["graph"]["max"] for row in same)))
        header = ["cloud", "points", "s/r", *(f"{method}, %" for method in self.methods)]
        fits = [
            [
                shape,
                method,
                digits(found.c),
                f"{found.p:.1f}",
                digits(found.floor),
                f"{found.off:.2f}",
            ]
            for shape, methods in self.fits(figures).items()
            for method, found in methods.items()
        ]
        return (
            "Mean errors of the draws, from the least to the largest.\n\n"
            + table([*header, "graph, largest error, %"], rows)
            + "\n"
            + table(["cloud", "method", "C, %", "p", "F, %", "off the fit by a factor of"], fits)
        )

    def draw(self, figures, path):
        curves, legend = [], []
        styles = iter((*STYLES, ("#c0392b", "P")))
        for shape, rows in figures.items():
            for method in self.methods:
                style = next(styles)
                marks = self.points_of(rows, method)
                curves.append((marks, style, "none"))
                if method in self.tolerances:
                    x = np.geomspace(min(marks)[0], max(marks)[0], 40)
                    curves.append((list(zip(x, fit(marks).at(x))), (style[0], ""), "-"))
                legend.append((f"{shape}, {method}", style))
        title = "mean error in percent, of graphs with fits of C (s/r)^p + F"
        return plot_curves(path, title, "spacing by radius of curvature, s/r", curves, legend)

    def verdict(self, figures):
        fits = self.fits(figures)

        def texts(method, value):
            return " and ".join(value(methods[method]) for methods in fits.values())

        def floors(method):
            return texts(method, lambda found: digits(found.floor))

        gains = [2.0 ** methods["graph"].p for methods in fits.values()]
        rough = [mean for r in figures.values() for _, mean in self.points_of(r, "fast marching")]
        return Verdict(
            NOT_COMPARABLE,
            f"On sphere and torus p is {texts('graph', lambda found: f'{found.p:.1f}')} by default and "
            f"{texts('finer graph', lambda found: f'{found.p:.1f}')} for finer graphs: with four times "
            f"the points errors are {digits(min(gains))} to {digits(max(gains))} times as small. That ends "
            "at a floor, which is what leaving out edges costs: F is "
            f"{floors('graph')} % by default, {floors('finer graph')} % for finer graphs (0 where what is "
            f"measured does not reach it). Fast marching follows no such law: {digits(min(rough))} to "
            f"{digits(max(rough))} %. Short cuts over bends, which fall with the width of the band, and "
            "differences of first order, which make ways longer, cancel in between.",
        )


@dataclass(frozen=True)
class Fit:
    """y = c x^p + floor."""

    c: float
    p: float
    floor: float
    off: float  # root mean square, as a factor

    def at(self, x):
        return self.c * x**self.p + self.floor


def fit(points):
    """By least squares of logarithms: floors are tried one by one, for each of which the rest is
    fitted to what is left above it."""
    x, y = np.array(points).T
    best = None
    for floor in (0.0, *(y.min() * np.linspace(0.02, 0.98, 97))):
        p, c = np.polyfit(np.log(x), np.log(y - floor), 1, w=1.0 - floor / y)
        found = np.exp(c) * x**p + floor
        off = float(np.exp(np.sqrt(np.mean(np.log(y / found) ** 2))))
        if best is None or off < best.off:
            best = Fit(float(np.exp(c)), float(p), float(floor), off)
    return best


EXHIBITS = (CloudDensity(),)
