# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Laws of errors, fitted to measurements."""

from dataclasses import dataclass

import measure_clouds
import numpy as np
from plots import STYLES, Panel, plot
from tables import column, count_text, digits, hundredths, listing, percent, range_text, table

from .clouds import errors_of
from .exhibit import NOT_COMPARABLE, Exhibit, Verdict


class CloudDensity(Exhibit):
    """Mean errors on random points of a sphere and of a torus (radii 1 and 0.4), with several draws of
    each number of points. Methods are graphs of scheme C with the default tolerance and, for one draw,
    with a tenth of it ("finer"), and fast marching in the band. C (s/r)^p + F is fitted to the mean errors
    of all draws; s is the spacing (the square root of the area per point) and r the smallest radius of
    curvature. Points of the torus are vertices of a mesh of 205K vertices, on which distances are exact."""

    name = "L1.1"
    title = "error of cloud distances against spacing"
    published = (
        "none; the thesis has mean errors of single clouds, and lists the law as future work (6.2)."
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
        """Returns (x, mean error in percent)."""
        return [(row["x"], 100.0 * row[method]["mean"]) for row in rows if method in row]

    def fits(self, figures):
        """Returns {shape: {method: fit of points_of()}}."""
        return {
            shape: {method: fit(self.points_of(rows, method)) for method in self.tolerances}
            for shape, rows in figures.items()
        }

    def table(self, figures):
        rows = []
        for shape, draws in figures.items():
            for count in sorted({row["points"] for row in draws}):
                same = [row for row in draws if row["points"] == count]
                row = {"cloud": shape, "points": count, "x": same[0]["x"]}
                row.update({m: [mean for _, mean in self.points_of(same, m)] for m in self.methods})
                row["largest"] = max(row["graph"]["max"] for row in same)
                rows.append(row)
        columns = (
            column("cloud", str, "cloud"),
            column("points", count_text, "points"),
            column("s/r", digits, "x"),
            *(column(f"{method}, %", range_text, method) for method in self.methods),
            column("graph, largest error, %", percent, "largest"),
        )
        fits = [
            [shape, method, digits(f.c), f"{f.p:.1f}", digits(f.floor), hundredths(f.off)]
            for shape, methods in self.fits(figures).items()
            for method, f in methods.items()
        ]
        header = ["cloud", "method", "C, %", "p", "F, %", "mean deviation, factor"]
        return listing(columns, rows) + "\n" + table(header, fits)

    def pictures(self, figures):
        curves, legend = [], []
        styles = iter(STYLES)
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
        panel = Panel(title, "spacing by radius of curvature, s/r", "", curves)
        return {self.name: lambda path: plot(path, [[panel]], legend)}

    def verdict(self, figures):
        gains = [2.0 ** methods["graph"].p for methods in self.fits(figures).values()]
        return Verdict(
            NOT_COMPARABLE,
            f"With four times the points, errors are smaller by a factor of {range_text(gains)}, down to a "
            "floor F that is due to pruned edges (0 if the measured errors do not reach it). Fast marching "
            "follows no such law: shortcuts at bends, which decrease with the width of the band, and first-order "
            "differences, which lengthen paths, cancel at intermediate spacings.",
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
    """Fits by least squares of logarithms. For each of several floors, a power is fitted to the values
    above the floor."""
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
