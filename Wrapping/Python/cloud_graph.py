# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""The graph of a point cloud as a Python object."""

from __future__ import annotations

import threading
from typing import TYPE_CHECKING, Any, Optional

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData

from . import arguments, meshes
from .build_info import HAS_POINT_CLOUDS
from .graph_info import GraphInfo
from .queries import Queries
from .surface import copy_surface

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

__all__ = ["CloudGraph"]


class CloudGraph(Queries):
    """Geodesic distances and paths on what a point cloud samples, asked many times.

    Nothing is promised: errors depend on the sampling. The points are copied and do not change any
    more. A graph can be copied and pickled; it is not built again.

    Parameters
    ----------
    points : array_like, shape (n, 3), or a mesh, of which only the points are used
        Coordinates; at least one point.
    normals : array_like, shape (n, 3), optional
        Normals. Default: those that a vtkPolyData has, else they are found from the points.
    scheme : {"C", "B", "A"}, optional
        How far edges reach, see vtkPointCloudDGG.
    offset_in_voxels, resolution, alpha : float, int, float, optional
        The band around the cloud, see vtkPointCloudDGG. Default: 0, automatic.
    accuracy : float, optional
        How much longer a path may become by edges that are left out, as a fraction; 0 for none.
    memory_limit : int, optional
        As for `Graph`.

    Raises
    ------
    ImportError
        When vtkDGG was built without PCL.
    ValueError, VTKError
        As for `Graph`.

    See Also
    --------
    vtkPointCloudDGG : the filter that builds it, with further options.

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
        scheme: str = "C",
        offset_in_voxels: float = 0.0,
        resolution: int = 0,
        alpha: float = 0.0,
        accuracy: float = 0.001,
        memory_limit: Optional[int] = None,
    ) -> None:
        if not HAS_POINT_CLOUDS:
            raise ImportError("CloudGraph needs vtkDGG built with PCL (CMake: -DDGG_WITH_PCL=ON)")
        from .vtkDGGFiltersPointCloud import vtkPointCloudDGG

        if isinstance(points, vtkPolyData):
            cloud = copy_surface(points)
        else:
            cloud = arguments.polydata(meshes.points_of(points))
        count = cloud.GetNumberOfPoints()
        if count == 0:
            raise ValueError("points: at least one is wanted")
        if normals is not None:
            normals = arguments.coordinates(normals, "normals")
            if len(normals) != count:
                raise ValueError(f"normals: {count} are wanted, not {len(normals)}")
            cloud.GetPointData().SetNormals(numpy_to_vtk(normals, deep=True))
        builder = vtkPointCloudDGG()
        if scheme not in ("A", "B", "C"):
            raise ValueError(f"scheme: one of A, B, C is wanted, not {scheme!r}")
        builder.SetScheme(getattr(builder, scheme))
        builder.SetOffsetInVoxels(arguments.number(offset_in_voxels, "offset_in_voxels"))
        builder.SetResolution(arguments.integer(resolution, "resolution"))
        builder.SetAlpha(arguments.number(alpha, "alpha"))
        builder.SetAccuracy(arguments.number(accuracy, "accuracy"))
        builder.SetMemoryLimit(arguments.number_of_bytes(memory_limit, "memory_limit"))
        self._build(builder, cloud)

    @classmethod
    def from_polydata(
        cls, polydata: vtkPolyData, *, memory_limit: Optional[int] = None
    ) -> CloudGraph:
        """The graph that vtkPointCloudDGG has put on a cloud.

        It is used as it is, without a copy. When it is not that of the points any more, the first
        query fails.

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
        if not isinstance(polydata, vtkPolyData):
            raise TypeError(f"polydata: a vtkPolyData is wanted, not {type(polydata).__name__}")
        info = GraphInfo(polydata)
        if not info.is_cloud:
            raise ValueError("polydata: its graph is that of a mesh: see vtkdgg.Graph")
        graph = cls.__new__(cls)
        graph._heard = set()
        graph._memory_limit = arguments.number_of_bytes(memory_limit, "memory_limit")
        graph._local = threading.local()
        graph._surface = copy_surface(polydata)
        graph._info = info
        return graph

    @property
    def components(self) -> NDArray[np.int32]:
        """The connected part of each point, from the largest on; -1 where it is not finite."""
        return np.array(vtk_to_numpy(self._surface.GetPointData().GetArray("Component")))
