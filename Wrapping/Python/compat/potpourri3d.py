# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""The functions and classes of potpourri3d.

Mesh solvers named after the heat method use it and have its error. Paths are geodesics, at most
1 % longer than the shortest. Distances on point clouds come from a graph (`vtkdgg.CloudGraph`).
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, List, Optional, Sequence, Tuple

import numpy as np

from .. import _kernel, arguments, meshes
from ..cloud_graph import CloudGraph
from ..graph import Graph
from ..mesh import Mesh
from ..reading import read
from ..writing import write
from .common import find_distances, missing, vertices

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

__all__ = [
    "EdgeFlipGeodesicSolver",
    "GeodesicTracer",
    "MeshFastMarchingDistanceSolver",
    "MeshHeatMethodDistanceSolver",
    "MeshMarchingTrianglesSolver",
    "MeshSignedHeatSolver",
    "MeshVectorHeatSolver",
    "PointCloudHeatSolver",
    "PointCloudLocalTriangulation",
    "PolygonMeshHeatSolver",
    "compute_distance",
    "compute_distance_multisource",
    "cotan_laplacian",
    "edges",
    "face_areas",
    "marching_triangles",
    "read_mesh",
    "read_point_cloud",
    "read_polygon_mesh",
    "validate_mesh",
    "validate_points",
    "vertex_areas",
    "write_mesh",
    "write_point_cloud",
]

_NO_VECTORS = "vtkDGG has no vector heat method."
_EXTEND = (
    "vtkdgg.interpolate makes a smooth function of values at some points; "
    "vtkdgg.distance(..., return_source=True) names the nearest source of each point."
)
_UNSIGNED = "Distances are unsigned: vtkdgg.distance takes points as sources."
_ISOLINES = "vtkdgg.Graph.isolines finds isolines of distances, vtkContourFilter those of arrays."

GeodesicTracer = missing("GeodesicTracer", "vtkdgg.path finds a geodesic between two points.")
MeshMarchingTrianglesSolver = missing("MeshMarchingTrianglesSolver", _ISOLINES)
MeshSignedHeatSolver = missing("MeshSignedHeatSolver", _UNSIGNED)
MeshVectorHeatSolver = missing("MeshVectorHeatSolver", f"{_NO_VECTORS} {_EXTEND}")
PointCloudLocalTriangulation = missing(
    "PointCloudLocalTriangulation", "vtkdgg.CloudGraph needs no triangles."
)
marching_triangles = missing("marching_triangles", _ISOLINES)


class _HeatSolver:
    """The heat method on a surface, prepared once."""

    def __init__(self, V: ArrayLike, F: ArrayLike, t_coef: float = 1.0) -> None:
        self._surface = meshes.from_arrays(V, F)
        self._prepared = self._surface.prepared()
        self._options = {"time_step_factor": arguments.number(t_coef, "t_coef")}

    def _find(self, indices):
        sources = vertices(indices, "sources", self._surface.number_of_points)
        return find_distances(
            _kernel.heat_distance, self._surface, self._prepared, sources, **self._options
        )[0]


class MeshHeatMethodDistanceSolver(_HeatSolver):
    """Distances on a triangle mesh by the heat method."""

    def __init__(
        self, V: ArrayLike, F: ArrayLike, t_coef: float = 1.0, use_robust: bool = True
    ) -> None:
        super().__init__(V, F, t_coef)
        self._options["intrinsic_delaunay"] = bool(use_robust)

    def compute_distance(self, v_ind: int) -> NDArray[np.float64]:
        """Returns distances from a vertex."""
        return self._find([v_ind])

    def compute_distance_multisource(self, v_inds: ArrayLike) -> NDArray[np.float64]:
        """Returns distances from the nearest of some vertices."""
        return self._find(v_inds)


def compute_distance(V: ArrayLike, F: ArrayLike, v_ind: int) -> NDArray[np.float64]:
    """Returns distances from a vertex by the heat method."""
    return MeshHeatMethodDistanceSolver(V, F).compute_distance(v_ind)


def compute_distance_multisource(
    V: ArrayLike, F: ArrayLike, v_inds: ArrayLike
) -> NDArray[np.float64]:
    """Returns distances from the nearest of some vertices by the heat method."""
    return MeshHeatMethodDistanceSolver(V, F).compute_distance_multisource(v_inds)


class PolygonMeshHeatSolver(_HeatSolver):
    """Distances on a mesh of polygons by the heat method on their triangles."""

    def compute_distance(self, v_inds: ArrayLike) -> NDArray[np.float64]:
        """Returns distances from the nearest of some vertices."""
        return self._find(v_inds)

    compute_signed_distance = missing("compute_signed_distance", _UNSIGNED)
    extend_scalar = missing("extend_scalar", _EXTEND)
    get_tangent_frames = missing("get_tangent_frames", _NO_VECTORS)
    transport_tangent_vectors = missing("transport_tangent_vectors", _NO_VECTORS)


class MeshFastMarchingDistanceSolver:
    """Distances on a triangle mesh by fast marching."""

    def __init__(self, V: ArrayLike, F: ArrayLike) -> None:
        self._surface = meshes.from_arrays(V, F)
        self._prepared = self._surface.prepared()

    def compute_distance(
        self,
        curves: Sequence[Sequence[Tuple[int, Sequence[float]]]],
        distances: Sequence[Sequence[float]] = (),
        sign: bool = False,
    ) -> NDArray[np.float64]:
        """Returns distances from the nearest source.

        Each curve is one point: ``(vertex, [])``, or ``(face, barycentric coordinates)``, of which
        the third may be omitted. `distances` gives each its initial distance.
        """
        if sign or any(len(curve) != 1 or len(curve[0][1]) == 1 for curve in curves):
            raise NotImplementedError(
                "compute_distance is not available for signs, edges and curves of several points. "
                f"{_UNSIGNED}"
            )
        count = self._surface.number_of_points
        sources: List[Any] = []
        for ((element, weights),) in curves:
            weights = [*weights, 1.0 - sum(weights)] if len(weights) == 2 else list(weights)
            if weights:
                sources.append((element, weights))
            else:
                sources += vertices([element], "curves", count)
        initial = [distance for curve in distances for distance in curve] or None
        return find_distances(
            _kernel.fast_marching_distance,
            self._surface,
            self._prepared,
            sources,
            initial_distances=initial,
        )[0]


class EdgeFlipGeodesicSolver:
    """Geodesic paths and loops on a triangle mesh, from a graph that is built once.

    The number of iterations is not limited. A path through more than two vertices that is pulled
    tight between the first and the last one is not available.
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
        """Returns the points of a path from one vertex to another, shape (k, 3)."""
        _refuse_limits(max_iterations, max_relative_length_decrease)
        return self._graph.path(v_start, v_end, detour=0.01).points

    def find_geodesic_path_poly(
        self,
        v_list: ArrayLike,
        max_iterations: Optional[int] = None,
        max_relative_length_decrease: Optional[float] = None,
    ) -> NDArray[np.float64]:
        """Returns the points of a path between the two vertices of a list."""
        if len(v_list) != 2:
            raise NotImplementedError(
                "find_geodesic_path_poly is not available for more than two vertices. "
                "vtkdgg.Graph.paths finds the path between each and the next."
            )
        return self.find_geodesic_path(*v_list, max_iterations, max_relative_length_decrease)

    def find_geodesic_loop(
        self,
        v_list: ArrayLike,
        max_iterations: Optional[int] = None,
        max_relative_length_decrease: Optional[float] = None,
    ) -> NDArray[np.float64]:
        """Returns the points of a closed geodesic, to which the loop through the vertices is pulled
        tight."""
        _refuse_limits(max_iterations, max_relative_length_decrease)
        loops = self._graph.loop(v_list, rope=len(v_list) > 2, taut=True)
        return loops[0].points if loops else np.empty((0, 3))


class PointCloudHeatSolver:
    """Distances on a point cloud, from a graph that is built once; `t_coef` has no effect."""

    def __init__(self, P: ArrayLike, t_coef: float = 1.0) -> None:
        self._graph = CloudGraph(P)

    def compute_distance(self, p_ind: int) -> NDArray[np.float64]:
        """Returns distances from a point."""
        return self.compute_distance_multisource([p_ind])

    def compute_distance_multisource(self, p_inds: ArrayLike) -> NDArray[np.float64]:
        """Returns distances from the nearest of some points."""
        sources = vertices(p_inds, "sources", self._graph.number_of_points)
        return self._graph.distance(sources, unreached=np.inf)

    compute_log_map = missing("compute_log_map", _NO_VECTORS)
    compute_signed_distance = missing("compute_signed_distance", _UNSIGNED)
    extend_scalar = missing("extend_scalar", _EXTEND)
    get_tangent_frames = missing("get_tangent_frames", _NO_VECTORS)
    transport_tangent_vector = missing("transport_tangent_vector", _NO_VECTORS)
    transport_tangent_vectors = missing("transport_tangent_vectors", _NO_VECTORS)


def read_mesh(filename: str) -> Tuple[NDArray[np.float64], NDArray[np.int64]]:
    """Returns the points and triangles of a file."""
    points, polygons = read_polygon_mesh(filename)
    for i, polygon in enumerate(polygons):
        if len(polygon) != 3:
            raise ValueError(
                f"{filename}: polygon {i} has {len(polygon)} corners, expected 3. "
                "Use read_polygon_mesh."
            )
    return points, np.array(polygons, dtype=np.int64).reshape(-1, 3)


def read_polygon_mesh(filename: str) -> Tuple[NDArray[np.float64], List[List[int]]]:
    """Returns the points and polygons of a file."""
    mesh = read(filename)
    offsets, corners = mesh.polygons
    return mesh.points, [ids.tolist() for ids in np.split(corners, offsets[1:-1])]


def read_point_cloud(filename: str) -> NDArray[np.float64]:
    """Returns the points of a file."""
    return read(filename).points


def write_mesh(
    V: ArrayLike,
    F: ArrayLike,
    filename: str,
    UV_coords: Optional[ArrayLike] = None,
    UV_type: Optional[str] = None,
) -> None:
    """Writes points and polygons to a file, without texture coordinates."""
    if UV_coords is not None or UV_type is not None:
        raise NotImplementedError("write_mesh is not available with texture coordinates.")
    write(filename, (V, F))


def write_point_cloud(V: ArrayLike, filename: str) -> None:
    """Writes points to a file."""
    write(filename, Mesh(V))


def validate_points(V: ArrayLike) -> None:
    """Raises a ValueError if points have the wrong shape or type."""
    arguments.coordinates(V, "points")


def validate_mesh(
    V: ArrayLike, F: ArrayLike, force_triangular: bool = False, test_indices: bool = False
) -> None:
    """Raises a ValueError if points or polygons have the wrong shape or type, or an index does not
    exist."""
    surface = meshes.from_arrays(V, F)
    if force_triangular and (np.diff(surface.polygons[0]) > 3).any():
        raise ValueError("triangles: some polygons have more than three corners")


def face_areas(V: ArrayLike, F: ArrayLike) -> NDArray[np.float64]:
    """Returns the areas of triangles."""
    _, normals = _corners(*_triangle_mesh(V, F))
    return np.linalg.norm(normals[:, 0], axis=1) / 2.0


def vertex_areas(V: ArrayLike, F: ArrayLike) -> NDArray[np.float64]:
    """Returns a third of the area of the triangles around each vertex."""
    points, triangles = _triangle_mesh(V, F)
    thirds = np.repeat(face_areas(points, triangles) / 3.0, 3)
    return np.bincount(triangles.ravel(), thirds, minlength=len(points))


def cotan_laplacian(V: ArrayLike, F: ArrayLike, denom_eps: float = 0.0) -> Any:
    """Returns the positive semidefinite cotangent Laplacian, a scipy.sparse.csr_matrix."""
    from scipy.sparse import csr_matrix, diags

    points, triangles = _triangle_mesh(V, F)
    cosines, normals = _corners(points, triangles)
    weights = cosines / (np.linalg.norm(normals, axis=2) + denom_eps) / 2.0
    opposite = np.roll(triangles, -1, axis=1).ravel(), np.roll(triangles, -2, axis=1).ravel()
    sides = csr_matrix((weights.ravel(), opposite), shape=(len(points),) * 2)
    sides = sides + sides.T
    return csr_matrix(diags(np.asarray(sides.sum(axis=1)).ravel()) - sides)


def edges(V: ArrayLike, F: ArrayLike) -> NDArray[np.int64]:
    """Returns the two vertices of each edge, shape (k, 2), in the order in which faces name it."""
    validate_mesh(V, F, test_indices=True)
    offsets, corners = Mesh(V, F).polygons
    after = np.arange(1, len(corners) + 1)
    after[offsets[1:] - 1] = offsets[:-1]
    sides = np.stack([corners, corners[after]], axis=1)
    _, first = np.unique(np.sort(sides, axis=1), axis=0, return_index=True)
    return sides[np.sort(first)]


def _triangle_mesh(V, F):
    """Returns valid points and triangles."""
    validate_mesh(V, F, force_triangular=True, test_indices=True)
    mesh = Mesh(V, F)
    return mesh.points, mesh.triangles


def _corners(points, triangles):
    """Returns the scalar and vector products of the two sides at each corner of triangles."""
    corners = points[triangles]
    after = np.roll(corners, -1, axis=1) - corners
    before = np.roll(corners, -2, axis=1) - corners
    return (after * before).sum(axis=2), np.cross(after, before)


def _refuse_limits(max_iterations, max_relative_length_decrease):
    if max_iterations is not None or max_relative_length_decrease is not None:
        raise NotImplementedError(
            "max_iterations and max_relative_length_decrease are not available. Paths and loops "
            "are shortened until they are geodesics."
        )
