# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""The class and the function of pygeodesic.geodesic: exact distances and paths."""

from __future__ import annotations

from typing import TYPE_CHECKING, Optional, Tuple

import numpy as np

from ... import _kernel, arguments, meshes
from ...paths import find, paths_of
from ..common import find_distances, vertices

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

__all__ = ["PyGeodesicAlgorithmExact", "read_mesh_from_file"]


class PyGeodesicAlgorithmExact:
    """Exact distances and paths on one mesh."""

    def __init__(self, _points: ArrayLike, _faces: ArrayLike) -> None:
        self._surface = meshes.from_arrays(_points, _faces)
        self._prepared = self._surface.prepared()

    def geodesicDistance(
        self, sourceIndex: int, targetIndex: int
    ) -> Tuple[float, NDArray[np.float64]]:
        """Returns the distance between two vertices, and the points of the path from the target
        back to the source, shape (k, 3)."""
        surface = self._surface
        count = surface.number_of_points
        ends = (
            arguments.surface_points([arguments.point_id(index, name, count)], name, surface)
            for index, name in ((sourceIndex, "sourceIndex"), (targetIndex, "targetIndex"))
        )
        found = paths_of(find(self._prepared, *ends, method="Exact"), 1)[0]
        return found.length, found.points[::-1].copy()

    def geodesicDistances(
        self,
        source_indices: Optional[ArrayLike] = None,
        target_indices: Optional[ArrayLike] = None,
        max_distance: float = np.inf,
    ) -> Tuple[NDArray[np.float64], NDArray[np.int32]]:
        """Returns distances of the targets (default: all vertices) from the nearest source (default:
        vertex 0), infinite where unreached, and the index of that source."""
        count = self._surface.number_of_points
        sources = vertices([0] if source_indices is None else source_indices, "sources", count)
        distances, nearest = find_distances(
            _kernel.exact_distance, self._surface, self._prepared, sources, max_distance
        )
        if target_indices is not None:
            targets = vertices(target_indices, "target_indices", count)
            distances, nearest = distances[targets], nearest[targets]
        return distances, nearest.astype(np.int32)


def read_mesh_from_file(filename: str) -> Tuple[NDArray[np.float64], NDArray[np.int64]]:
    """Returns points and faces of a text file that begins with their counts."""
    with open(filename, encoding="utf-8") as file:
        points, faces = map(int, file.readline().split())
        rows = [line.split() for line in file if line.strip()]
    if len(rows) < points + faces:
        raise ValueError(f"{filename}: expected {points + faces} lines, got {len(rows)}")
    return (
        np.array(rows[:points], dtype=np.float64),
        np.array(rows[points : points + faces], dtype=np.int64),
    )
