# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""The functions of gdist (tvb-gdist): exact distances.

See Also
--------
vtkdgg.Graph.sparse_matrix : faster than `local_gdist_matrix`, within an error bound.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Optional

import numpy as np

from ..graph_data import GraphData
from .common import vertices as check_vertices
from .pygeodesic.geodesic import PyGeodesicAlgorithmExact

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

__all__ = ["compute_gdist", "distance_matrix_of_selected_points", "local_gdist_matrix"]


def compute_gdist(
    vertices: ArrayLike,
    triangles: ArrayLike,
    source_indices: Optional[ArrayLike] = None,
    target_indices: Optional[ArrayLike] = None,
    max_distance: float = np.inf,
    is_one_indexed: bool = False,
) -> NDArray[np.float64]:
    """Returns distances of the targets (default: all vertices) from the nearest source (default:
    vertex 0), infinite beyond the largest distance."""
    solver = PyGeodesicAlgorithmExact(vertices, np.asarray(triangles) - int(is_one_indexed))
    return solver.geodesicDistances(source_indices, target_indices, max_distance)[0]


def local_gdist_matrix(
    vertices: ArrayLike,
    triangles: ArrayLike,
    max_distance: float = np.inf,
    is_one_indexed: bool = False,
) -> Any:
    """Returns distances between all vertices within a distance, a scipy.sparse.csc_matrix."""
    return _matrix(vertices, triangles, None, max_distance, is_one_indexed)


def distance_matrix_of_selected_points(
    vertices: ArrayLike,
    triangles: ArrayLike,
    points: ArrayLike,
    max_distance: float = np.inf,
    is_one_indexed: bool = False,
) -> Any:
    """Returns distances between some vertices, a scipy.sparse.csc_matrix of shape (n, n)."""
    return _matrix(vertices, triangles, points, max_distance, is_one_indexed)


def _matrix(vertices, triangles, points, max_distance, is_one_indexed):
    """Returns the positive distances between `points` (None: all vertices). Only one dense row is
    stored at a time."""
    csr_matrix = GraphData._csr_matrix("a distance matrix")
    solver = PyGeodesicAlgorithmExact(vertices, np.asarray(triangles) - int(is_one_indexed))
    count = len(np.asarray(vertices))
    is_target = np.full(count, points is None)
    if points is not None:
        is_target[check_vertices(points, "points", count)] = True
    sizes, targets, values = np.zeros(count, dtype=np.int64), [np.empty(0, np.int64)], [np.empty(0)]
    for point in np.flatnonzero(is_target):
        distances, _ = solver.geodesicDistances([point], None, max_distance)
        near = np.flatnonzero(is_target & (distances > 0.0) & (distances < np.inf))
        sizes[point] = len(near)
        targets.append(near)
        values.append(distances[near])
    offsets = np.concatenate([[0], np.cumsum(sizes)])
    parts = np.concatenate(values), np.concatenate(targets), offsets
    return csr_matrix(parts, shape=(count, count)).T  # the matrix is symmetric: stored by columns
