# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""The graph of a point cloud as a Python object."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Optional

from . import _kernel, arguments, meshes
from .errors import Error, call, warn
from .graph_data import require_graph
from .graph_info import arrays_of, find_info
from .queries import Queries

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray
    from vtkmodules.vtkCommonDataModel import vtkPolyData

__all__ = ["CloudGraph"]


class CloudGraph(Queries):
    """Geodesic distances and paths on the surface that a point cloud samples, for many queries.

    Errors depend on the sampling and have no bound. The points are copied. A graph can be copied
    and pickled without building it again. There are no methods `isolines` and `loop`, which need
    the triangles of a `Graph`.

    Parameters
    ----------
    points : array_like, shape (n, 3), or a mesh, of which only the points are used
        Coordinates; at least one point. The graph on a vtkPolyData or `Mesh` is used, without a
        copy, unless one of the next six arguments is given. If it belongs to other points or is
        damaged, a graph with the same scheme and accuracy is built, with a warning.
    normals : array_like, shape (n, 3), optional
        Normals. Default: those of a vtkPolyData or `Mesh`, otherwise estimated from the points.
    scheme : {"C", "B", "A"}, optional
        Rule for the length of edges, see vtkPointCloudDGG. Default: "C".
    offset_in_voxels, resolution, alpha : float, int, float, optional
        The band around the cloud, see vtkPointCloudDGG. Default: 0, automatic.
    accuracy : float, optional
        Largest relative increase of path lengths by the removal of edges; 0 keeps all edges.
        Default: 0.001.
    memory_limit : int, optional
        As for `Graph`.

    Raises
    ------
    ValueError, Error
        As for `Graph`.

    See Also
    --------
    vtkPointCloudDGG : a filter with further options.

    References
    ----------
    Z. Fang, "Discrete geodesic graphs", PhD thesis, Nanyang Technological University, 2019, chapter
    5, for the band and the schemes A and B.

    Examples
    --------
    >>> cloud = vtkdgg.CloudGraph(np.random.default_rng(0).random((2000, 3)) * [1, 1, 0])
    >>> cloud.distance(0).shape
    (2000,)
    """

    def __init__(
        self,
        points: Any,
        *,
        normals: Optional[ArrayLike] = None,
        scheme: Optional[str] = None,
        offset_in_voxels: float = 0.0,
        resolution: int = 0,
        alpha: float = 0.0,
        accuracy: Optional[float] = None,
        memory_limit: Optional[int] = None,
    ) -> None:
        cloud = meshes.cloud_of(points)
        if cloud.number_of_points == 0:
            raise ValueError("points: expected at least one, got none")
        limit = arguments.number_of_bytes(memory_limit, "memory_limit")
        options = {
            "offset_in_voxels": offset_in_voxels,
            "resolution": resolution,
            "alpha": alpha,
        }
        is_given = any(options.values()) or any(x is not None for x in (normals, scheme, accuracy))
        info = None if is_given else find_info(cloud.field_data)
        issued = set()
        prepared = cloud.prepared(is_cloud=True, issued=issued)
        if info is not None and info.is_cloud:
            try:
                graph = call(_kernel.Graph.from_arrays, prepared, arrays_of(cloud.field_data))
                self._take(cloud.copy(), graph, limit, True, issued)
                return
            except Error as error:
                if error.reason == "OutOfMemory":
                    raise
                warn([f"{error} Another one is built."], issued)
            scheme, accuracy = info.construction, info.accuracy
        if normals is not None:
            normals = arguments.coordinates(normals, "normals")
        require_clouds()
        built = call(
            _kernel.cloud_graph,
            prepared,
            scheme=scheme,
            accuracy=accuracy,
            normals=cloud.normals if normals is None else normals,
            memory_limit=limit,
            issued=issued,
            **options,
        )
        surface = cloud.copy()
        surface.add_point_array("Component", built.components)
        self._take(surface, built.graph, limit, False, issued)
        self._statistics = built.statistics

    @classmethod
    def from_polydata(
        cls, polydata: vtkPolyData, *, memory_limit: Optional[int] = None
    ) -> CloudGraph:
        """Returns the graph in the field data of a vtkPolyData.

        Unlike ``CloudGraph(polydata)``, a missing graph is an error.

        Parameters
        ----------
        polydata : vtkPolyData
            Output of vtkPointCloudDGG, of a filter after it, or of a reader.
        memory_limit : int, optional
            As for `Graph`.

        Raises
        ------
        ValueError
            When there are no points, no graph, or that of a mesh.
        """
        require_graph(polydata, True)
        return cls(polydata, memory_limit=memory_limit)

    @property
    def components(self) -> NDArray[np.int32]:
        """Components by decreasing size, shape (n,); -1 for points that are not finite."""
        found = self._surface.data.point_data.get("Component")
        if found is None:
            raise ValueError(
                "The cloud has its graph without the point array Component. Build another graph, "
                "for example by an `accuracy`."
            )
        return found.copy()


def require_clouds():
    """Raises an error if vtkDGG was built without graphs of point clouds."""
    if not hasattr(_kernel, "cloud_graph"):
        raise ValueError("this vtkDGG has no graphs of point clouds: build it with DGG_WITH_PCL")
