# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Vector graphics as they were published (Algorithm 4): colors are sums of Green's functions, to
compare with the solution on a mesh that is cut along the curves.

With all vertices as sites the splines of the thesis are sums of Green's functions of those vertices
that have sources: here the ends of edges which cross a curve. Each has the color of its side.
"""

import numpy as np
import vtkdgg


def beside(triangles, is_left):
    """Vertices next to a curve, the border between two sets of vertices."""
    edges = np.concatenate([triangles[:, [i, (i + 1) % 3]] for i in range(3)])
    return np.unique(edges[is_left[edges[:, 0]] != is_left[edges[:, 1]]])


def sources(mesh, vertices, colors):
    """The strengths of sources at these vertices with which a sum of Green's functions and a constant
    has these colors there; and the constant. Strengths sum to 0."""
    count = len(vertices)
    matrix = np.ones((count + 1, count + 1))
    matrix[:count, :count] = vtkdgg.greens_function(mesh, vertices, method="Interpolated")[vertices]
    matrix[count, count] = 0.0
    *strengths, constant = np.linalg.solve(matrix, [*colors, 0.0])
    return np.array(strengths), constant


def colors_of(mesh, vertices, strengths, constant, places, method):
    """Colors of fragments, each by the Green's function of its place."""
    functions = vtkdgg.greens_function(mesh, places, method=method)
    return functions[vertices].T @ strengths + constant
