# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Green's functions on spheres, where there is a closed form."""

from measure_spheres import measure_ways, order
from plots import draw_sphere_curves
from summarize import WAYS
from tables import column, count_text, hundredths, listing, named, percent

from .exhibit import NOT_COMPARABLE, REPRODUCED, WORSE, Exhibit, Verdict, judged

LOCALIZED = 1e-4
NEAR, FAR = "error_local", "error_global"


class Anywhere(Exhibit):
    """Relative L2 errors of Green's functions of poles inside faces: within 0.2 of the pole on all
    spheres, and everywhere on the finest sphere. The order is the slope of the logarithm of the error
    against that of the mean edge. The method `vertex` uses the nearest vertex as the pole; its error
    after subdivision is that of the next sphere."""

    name = "F4.5"
    title = "Green's functions of points anywhere"
    also = {"F4.6": "vertex poles and subdivision as baselines", "F4.7": "convergence"}
    published = (
        "22 to 25 % by interpolation and 0.01 % localized (Eq. 4.21), on a sphere of 48.6K vertices; curves "
        "of the baselines, with errors of 22 to 25 %; errors within 0.2 of 50 random points, which converge "
        "between first and second order."
    )

    def measure(self, run):
        levels = run.pick((3, 4, 5), (3, 4, 5, 6))
        run.uses(*(f"sphere-{level}" for level in levels))
        return measure_ways(levels, run.pick(10, 50))[0]

    def table(self, figures):
        columns = [column("method", WAYS.get, "name")]
        for i, (vertices, *_) in enumerate(figures["Vertex"][NEAR]):
            columns.append(column(f"{count_text(vertices)} vertices, %", percent, NEAR, i, 2))
        columns.append(("order", lambda row: hundredths(order(row[NEAR]))))
        columns.append(column("everywhere, %", percent, FAR, -1, 2))
        return listing(columns, named(figures))

    def pictures(self, figures):
        return {"F4.7": lambda path: draw_sphere_curves(figures, path)}

    def verdict(self, figures):
        return Verdict(
            judged(figures["Localized"][FAR][-1][2], LOCALIZED),
            "The verdict refers to the localized scheme. As printed, this scheme is no better than "
            "interpolation: its constraint preserves distances to barycentric averages, but does not "
            "determine the strength of the pole. The published normalization is unknown. It seems to include "
            "the pole, which our measure excludes. Our default is singularity subtraction.",
        )

    def words(self, figures):
        ours = order(figures["SingularitySubtraction"][NEAR])
        return {
            **super().words(figures),
            "F4.6": NOT_COMPARABLE,
            "F4.7": REPRODUCED if ours > 1.5 else WORSE,
        }


EXHIBITS = (Anywhere(),)
