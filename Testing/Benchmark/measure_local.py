# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Cost of queries about a few points on meshes of growing size, compared with SciPy and gdist.

Usage: measure_local.py OUT.json OUT.md [NUMBER-OF-POINTS ...]

Meshes are rippled squares of 10,000, 100,000 and 1,000,000 points by default, the radius is three
mean edge lengths. CPU time on one thread. SciPy's dijkstra(limit=...) searches the same graph, from
a sample of the points; gdist (`pip install tvb-gdist`) is measured if it is installed, on meshes of
up to 10,000 points.
"""

import modes
import numpy as np
import vtkdgg
from scipy.sparse.csgraph import dijkstra
from tables import column, listing, tenths

try:
    import gdist
except ImportError:
    gdist = None

SIZES = (10_000, 100_000, 1_000_000)
REPETITIONS = 20
LARGEST_OF_GDIST = 10_000
DENSE_ENTRIES = 2e7  # entries of dense rows of SciPy


def rippled_square(number_of_points):
    """Returns points and triangles of a jittered, rippled grid with unit spacing."""
    side = round(number_of_points**0.5)
    x, y = (a.ravel() for a in np.meshgrid(np.arange(side), np.arange(side), indexing="ij"))
    jitter = np.random.default_rng(7).uniform(-0.25, 0.25, (2, x.size))
    height = np.sin(0.2 * x) * np.sin(0.15 * y)
    corner = (np.arange(side - 1)[:, None] * side + np.arange(side - 1)).ravel()
    lower = np.stack([corner, corner + side, corner + side + 1], axis=1)
    upper = np.stack([corner, corner + side + 1, corner + 1], axis=1)
    points = np.stack([x + jitter[0], y + jitter[1], height], axis=1)
    return points, np.concatenate([lower, upper])


def median(function, sources):
    """Returns the median CPU time of one call per source. A further call precedes them."""
    function(sources[-1])
    return float(np.median([modes.timed(lambda s=s: function(s))[0] for s in sources]))


def measure_mesh(number_of_points):
    """Returns all figures of one mesh."""
    points, triangles = rippled_square(number_of_points)
    edges = points[triangles[:, 0]] - points[triangles[:, 1]]
    radius = 3.0 * float(np.linalg.norm(edges, axis=1).mean())
    graph = vtkdgg.Graph(points, triangles)
    n = graph.number_of_points
    sources = np.linspace(0.1 * n, 0.9 * n, REPETITIONS).astype(int).tolist()
    took, matrix = modes.timed(lambda: graph.sparse_matrix(radius))
    found = {
        "points": n,
        "entries per row": matrix.nnz / n,
        "sparse_matrix": took / matrix.nnz,
        "neighborhood": median(lambda s: graph.neighborhood(s, radius), sources),
        "bounded distance": median(lambda s: graph.distance(s, maximum_distance=radius), sources),
        "matrix of two": median(lambda s: graph.matrix([s], [s + 3]), sources),
    }
    rows = np.linspace(0, n - 1, max(1, int(DENSE_ENTRIES / n))).astype(int)[:1000]
    csr = graph.csr
    took, dense = modes.timed(lambda: dijkstra(csr, indices=rows, limit=radius))
    found["dijkstra"] = took / (np.count_nonzero(np.isfinite(dense)) - len(rows))
    if gdist and n <= LARGEST_OF_GDIST:
        local = triangles.astype(np.int32)
        took, matrix = modes.timed(lambda: gdist.local_gdist_matrix(points, local, radius))
        found["gdist"] = took / matrix.nnz
    return found


def measure(options):
    """Returns the figures of all meshes."""
    return [measure_mesh(size) for size in map(int, options.meshes or SIZES)]


def table(results):
    """Returns a table with a row per mesh."""

    def scaled(form, factor):
        return lambda value: form.format(factor * value)

    microseconds, milliseconds = scaled("{:.2f} µs", 1e6), scaled("{:.2f} ms", 1e3)
    columns = (
        column("points", "{:,}", "points"),
        column("entries per row", tenths, "entries per row"),
        column("sparse_matrix, per entry", microseconds, "sparse_matrix"),
        column("dijkstra(limit), per entry", microseconds, "dijkstra"),
        column("gdist, per entry", microseconds, "gdist"),
        column("neighborhood", milliseconds, "neighborhood"),
        column("distance(maximum_distance)", milliseconds, "bounded distance"),
        column("matrix of two points", milliseconds, "matrix of two"),
    )
    return listing(columns, results)


if __name__ == "__main__":
    modes.run(measure, table, modes.parse(__doc__))
