# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Names and arguments of other packages, with answers of this one, for code that people have::

    import vtkdgg.compat as pp3d  # in place of potpourri3d
    import vtkdgg.compat as geodesic  # in place of pygeodesic.geodesic
    import vtkdgg.compat as gdist

Answers of the heat method are as good as that method is, all others are exact, but for paths of
EdgeFlipGeodesicSolver: they are geodesics and at most 1 % longer than the shortest. Wrong input is
a ValueError or a VTKError, whatever the original prints or does.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Optional, Tuple

import numpy as np

from . import arguments, meshes
from .errors import run
from .graph import Graph
from .graph_data import GraphData
from .paths import find
from .results import array_of
from .vtkDGGFiltersGeodesic import vtkDGGPath, vtkExactGeodesicDistance, vtkHeatGeodesicDistance

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

__all__ = [
    "EdgeFlipGeodesicSolver",
    "MeshHeatMethodDistanceSolver",
    "PyGeodesicAlgorithmExact",
    "compute_distance",
    "compute_distance_multisource",
    "compute_gdist",
    "distance_matrix_of_selected_points",
    "local_gdist_matrix",
    "read_mesh_from_file",
]


class MeshHeatMethodDistanceSolver:
    """That of potpourri3d: distances by the heat method, prepared once."""

    def __init__(
        self, V: ArrayLike, F: ArrayLike, t_coef: float = 1.0, use_robust: bool = True
    ) -> None:
        self._solve = vtkHeatGeodesicDistance()
        self._solve.SetInputData(meshes.from_arrays(V, F))
        self._solve.SetTimeStepFactor(arguments.number(t_coef, "t_coef"))
        self._solve.SetIntrinsicDelaunay(bool(use_robust))

    def compute_distance(self, v_ind: int) -> NDArray[np.float64]:
        """Distances from a vertex."""
        return self.compute_distance_multisource([v_ind])

    def compute_distance_multisource(self, v_inds: ArrayLike) -> NDArray[np.float64]:
        """Distances from the nearest of some vertices."""
        return _distances(self._solve, v_inds)[0]


def compute_distance(V: ArrayLike, F: ArrayLike, v_ind: int) -> NDArray[np.float64]:
    """That of potpourri3d: distances from a vertex by the heat method."""
    return MeshHeatMethodDistanceSolver(V, F).compute_distance(v_ind)


def compute_distance_multisource(
    V: ArrayLike, F: ArrayLike, v_inds: ArrayLike
) -> NDArray[np.float64]:
    """That of potpourri3d: distances from the nearest of some vertices by the heat method."""
    return MeshHeatMethodDistanceSolver(V, F).compute_distance_multisource(v_inds)


class EdgeFlipGeodesicSolver:
    """That of potpourri3d: geodesic paths and loops, prepared once.

    There is no limit of iterations, and none is needed; a path through more than two vertices that
    is pulled tight between the first and the last one is not there.
    """

    def __init__(self, V: ArrayLike, F: ArrayLike, t_coef: float = 1.0) -> None:
        self._graph = Graph(V, F, accuracy=0.01)

    def find_geodesic_path(
        self,
        v_start: int,
        v_end: int,
        max_iterations: Optional[int] = None,
        max_relative_length_decrease: Optional[float] = None,
    ) -> NDArray[np.float64]:
        """Points of a path from one vertex to another, shape (k, 3)."""
        _refuse_limits(max_iterations, max_relative_length_decrease)
        return self._graph.path(v_start, v_end, detour=0.01).points

    def find_geodesic_path_poly(
        self,
        v_list: ArrayLike,
        max_iterations: Optional[int] = None,
        max_relative_length_decrease: Optional[float] = None,
    ) -> NDArray[np.float64]:
        """The same between the two vertices of a list."""
        if len(v_list) != 2:
            raise NotImplementedError("find_geodesic_path_poly: for two vertices only")
        return self.find_geodesic_path(*v_list, max_iterations, max_relative_length_decrease)

    def find_geodesic_loop(
        self,
        v_list: ArrayLike,
        max_iterations: Optional[int] = None,
        max_relative_length_decrease: Optional[float] = None,
    ) -> NDArray[np.float64]:
        """Points of a closed geodesic to which the loop through the vertices is pulled tight."""
        _refuse_limits(max_iterations, max_relative_length_decrease)
        loops = self._graph.loop(v_list, rope=len(v_list) > 2, taut=True)
        return loops[0].points if loops else np.empty((0, 3))


class PyGeodesicAlgorithmExact:
    """That of pygeodesic: exact distances and paths, prepared once."""

    def __init__(self, _points: ArrayLike, _faces: ArrayLike) -> None:
        surface = meshes.from_arrays(_points, _faces)
        self._solve = vtkExactGeodesicDistance()
        self._finder = vtkDGGPath()
        self._finder.SetMethodToExact()
        for algorithm in (self._solve, self._finder):
            algorithm.SetInputData(surface)

    def geodesicDistance(
        self, sourceIndex: int, targetIndex: int
    ) -> Tuple[float, NDArray[np.float64]]:
        """The distance between two vertices, and the points of the path from the target back to the
        source, shape (k, 3)."""
        surface = self._finder.GetInput()
        count = surface.GetNumberOfPoints()
        ends = (
            arguments.surface_points([arguments.point_id(index, name, count)], name, surface)
            for index, name in ((sourceIndex, "sourceIndex"), (targetIndex, "targetIndex"))
        )
        found = find(self._finder, *ends)[0]
        return found.length, found.points[::-1].copy()

    def geodesicDistances(
        self,
        source_indices: Optional[ArrayLike] = None,
        target_indices: Optional[ArrayLike] = None,
        max_distance: float = np.inf,
    ) -> Tuple[NDArray[np.float64], NDArray[np.int32]]:
        """Distances of the targets (of all vertices) from the nearest source (vertex 0), infinite
        where none reaches, and which one that is."""
        sources = [0] if source_indices is None else source_indices
        distances, nearest = _distances(self._solve, sources, max_distance)
        if target_indices is not None:
            targets = np.asarray(target_indices)
            arguments.check_ids(targets, len(distances), "target_indices")
            distances, nearest = distances[targets], nearest[targets]
        return distances, nearest.astype(np.int32)


def read_mesh_from_file(filename: str) -> Tuple[NDArray[np.float64], NDArray[np.int64]]:
    """That of pygeodesic: points and faces of a text file that begins with their numbers."""
    with open(filename, encoding="utf-8") as file:
        points, faces = map(int, file.readline().split())
        rows = [line.split() for line in file if line.strip()]
    if len(rows) < points + faces:
        raise ValueError(f"{filename}: {points + faces} lines are wanted, not {len(rows)}")
    return (
        np.array(rows[:points], dtype=np.float64),
        np.array(rows[points : points + faces], dtype=np.int64),
    )


def compute_gdist(
    vertices: ArrayLike,
    triangles: ArrayLike,
    source_indices: Optional[ArrayLike] = None,
    target_indices: Optional[ArrayLike] = None,
    max_distance: float = np.inf,
    is_one_indexed: bool = False,
) -> NDArray[np.float64]:
    """That of gdist: exact distances of the targets (of all vertices) from the nearest source
    (vertex 0), infinite beyond the largest distance."""
    solve = PyGeodesicAlgorithmExact(vertices, np.asarray(triangles) - int(is_one_indexed))
    return solve.geodesicDistances(source_indices, target_indices, max_distance)[0]


def local_gdist_matrix(
    vertices: ArrayLike,
    triangles: ArrayLike,
    max_distance: float = np.inf,
    is_one_indexed: bool = False,
) -> Any:
    """That of gdist: exact distances between all vertices within a distance, a
    scipy.sparse.csc_matrix. `vtkdgg.Graph.sparse_matrix` is faster."""
    count = len(np.asarray(vertices))
    solve = PyGeodesicAlgorithmExact(vertices, np.asarray(triangles) - int(is_one_indexed))
    rows = [solve.geodesicDistances([i], None, max_distance)[0] for i in range(count)]
    return _sparse(np.arange(count), np.arange(count), rows, count)


def distance_matrix_of_selected_points(
    vertices: ArrayLike,
    triangles: ArrayLike,
    points: ArrayLike,
    max_distance: float = np.inf,
    is_one_indexed: bool = False,
) -> Any:
    """That of gdist: exact distances between some vertices, a scipy.sparse.csc_matrix."""
    points = np.asarray(points)
    solve = PyGeodesicAlgorithmExact(vertices, np.asarray(triangles) - int(is_one_indexed))
    rows = [solve.geodesicDistances([i], points, max_distance)[0] for i in points]
    return _sparse(points, points, rows, len(np.asarray(vertices)))


def _refuse_limits(max_iterations, max_relative_length_decrease):
    if max_iterations is not None or max_relative_length_decrease is not None:
        raise NotImplementedError("a limit of iterations or of the decrease in length")


def _distances(solve, sources, max_distance=np.inf):
    """Distances, infinite where unreached, and indices of the nearest source."""
    ids = arguments.surface_points(np.asarray(sources), "sources", solve.GetInput()).ids
    if not ids:
        raise ValueError("sources: vertex indices are wanted")
    solve.SetSourceIds(ids)
    solve.SetMaximumDistance(arguments.limit(max_distance, "max_distance"))
    solve.SetUnreachedValue(np.inf)
    solve.GenerateNearestSourceOn()
    data = run(solve).GetPointData()
    return array_of(data, solve.GetDistanceArrayName()), array_of(data, solve.GetSourceArrayName())


def _sparse(row_ids, column_ids, rows, count):
    """What is positive and finite in a dense matrix, as a larger sparse one."""
    csr_matrix = GraphData._csr_matrix("a distance matrix")
    dense = np.array(rows)
    row, column = np.nonzero((dense > 0.0) & (dense < np.inf))
    places = row_ids[row], column_ids[column]
    return csr_matrix((dense[row, column], places), shape=(count, count)).tocsc()
