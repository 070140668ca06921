# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Green's functions on spheres, where there is a closed form."""

from benchmark_results import count_text, percent, table
from measure_spheres import WAYS, measure_ways, order
from plot_spheres import plot_curves

from .exhibit import NOT_COMPARABLE, REPRODUCED, WORSE, Exhibit, Verdict, judged
from .run import shared
from .tables import column, hundredths, listing, named, vertices_text

LOCALIZED = 1e-4
NEAR, FAR = "error_local", "error_global"


@shared
def spheres(run):
    """{way: {error: [(vertices, mean edge, error)]}}."""
    levels = run.pick((3, 4, 5), (3, 4, 5, 6))
    run.uses(*(f"sphere-{level}" for level in levels))
    return measure_ways(levels, run.pick(10, 50))[0]


class Anywhere(Exhibit):
    """Poles inside faces: relative L2 errors by all ways, on the finest sphere."""

    name = "F4.5"
    title = "Green's functions of points anywhere"
    published = (
        "22 to 25 % by interpolation, 0.01 % localized (Eq. 4.21), on a sphere of 48.6K vertices."
    )

    def measure(self, run):
        return spheres(run)

    def last(self, figures, way):
        """The error on the finest sphere."""
        return figures[way][FAR][-1][2]

    def vertices(self, figures):
        """Of that sphere."""
        return figures["Vertex"][FAR][-1][0]

    def table(self, figures):
        columns = (
            column("way", WAYS.get, "name"),
            column("within 0.2 of the pole, %", percent, NEAR, -1, 2),
            column("on the whole sphere, %", percent, FAR, -1, 2),
        )
        note = f"{vertices_text(self.vertices(figures))}; relative L2 errors."
        return listing(columns, named(figures), note)

    def verdict(self, figures):
        ours = self.last(figures, "SingularitySubtraction")
        localized = self.last(figures, "Localized")
        return Verdict(
            judged(localized, LOCALIZED),
            f"The localized scheme as written has {percent(localized)} %, no less than interpolation with "
            f"{percent(self.last(figures, 'Interpolated'))} %: its constraint holds distances to "
            "barycentric averages, which says nothing of the strength of the pole. The published "
            "normalisation is not known; it seems to include the pole. Singularity subtraction, our "
            f"default, has {percent(ours)} % with {vertices_text(self.vertices(figures))}.",
        )


class Baselines(Anywhere):
    """The nearest vertex as the pole, and the same on a sphere with four times the vertices, which is
    what subdivision gives, beside poles inside faces."""

    name = "F4.6"
    title = "vertex poles and subdivision as baselines"
    published = "curves of the baselines, whose errors are 22 to 25 %."

    def rows(self, figures):
        vertex = figures["Vertex"][NEAR]
        return [
            (
                vertex[i][0],
                vertex[i][2],
                vertex[i + 1][2],
                figures["SingularitySubtraction"][NEAR][i][2],
            )
            for i in range(len(vertex) - 1)
        ]

    def table(self, figures):
        rows = [[count_text(n), *map(percent, errors)] for n, *errors in self.rows(figures)]
        header = ["vertices", "nearest vertex, %", "the same, subdivided, %"]
        return "Within 0.2 of the pole.\n\n" + table([*header, "singularity subtraction, %"], rows)

    def verdict(self, figures):
        vertex = [row[1] for row in self.rows(figures)]
        return Verdict(
            NOT_COMPARABLE,
            f"The nearest vertex has {percent(min(vertex))} to {percent(max(vertex))} %, less than was "
            "published for it; with a measure that leaves out the pole, as ours does, the baselines are "
            "not as bad.",
        )


class Convergence(Anywhere):
    """Errors over the mean edge, within 0.2 of random poles inside faces, and orders: slopes of the
    logarithms."""

    name = "F4.7"
    title = "convergence"
    published = (
        "errors of 50 random points within a radius of 0.2, over the mean edge: between first and "
        "second order."
    )

    def orders(self, figures):
        return {way: order(points[NEAR]) for way, points in figures.items()}

    def table(self, figures):
        columns = [column("way", WAYS.get, "name")]
        for i, (vertices, *_) in enumerate(figures["Vertex"][NEAR]):
            columns.append(column(f"{count_text(vertices)} vertices, %", percent, NEAR, i, 2))
        columns.append(("order", lambda row: hundredths(order(row[NEAR]))))
        return listing(columns, named(figures))

    def draw(self, figures, path):
        plot_curves(figures, path)
        return True

    def verdict(self, figures):
        orders = self.orders(figures)
        ours = orders["SingularitySubtraction"]
        return Verdict(
            REPRODUCED if ours > 1.5 else WORSE,
            f"Order {ours:.2f} by singularity subtraction, {orders['Localized']:.2f} localized, "
            f"{orders['Interpolated']:.2f} interpolated.",
        )


EXHIBITS = (Anywhere(), Baselines(), Convergence())
