# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""The graph of a point cloud as a Python object."""

from __future__ import annotations

import warnings
from typing import TYPE_CHECKING, Any, Optional

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData

from . import arguments, meshes
from .build_info import HAS_POINT_CLOUDS
from .errors import VTKError, depth_of_package, run
from .graph_info import CONSTRUCTIONS, SCHEMES, GraphInfo
from .queries import Queries
from .vtkDGGFiltersGeodesic import vtkDGGDistance

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

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
        scheme: Optional[str] = None,
        offset_in_voxels: float = 0.0,
        resolution: int = 0,
        alpha: float = 0.0,
        accuracy: Optional[float] = None,
        memory_limit: Optional[int] = None,
    ) -> None:
        if not HAS_POINT_CLOUDS:
            raise ImportError("CloudGraph needs vtkDGG built with PCL (CMake: -DDGG_WITH_PCL=ON)")
        from .vtkDGGFiltersPointCloud import vtkPointCloudDGG

        cloud = meshes.cloud_of(points)
        count = cloud.GetNumberOfPoints()
        if count == 0:
            raise ValueError("points: expected at least one, got none")
        limit = arguments.number_of_bytes(memory_limit, "memory_limit")
        is_given = offset_in_voxels or resolution or alpha
        if not is_given and normals is None and scheme is None and accuracy is None:
            info = GraphInfo.find(cloud)
        else:
            info = None
        if info is not None and info.is_cloud:
            self._take(cloud, limit, True)
            if self._is_current():
                return
            scheme, accuracy = CONSTRUCTIONS[info.construction], info.accuracy
        if normals is not None:
            normals = arguments.coordinates(normals, "normals")
            if len(normals) != count:
                raise ValueError(f"normals: expected {count}, got {len(normals)}")
            cloud.GetPointData().SetNormals(numpy_to_vtk(normals, deep=True))
        builder = vtkPointCloudDGG()
        if scheme not in (None, *SCHEMES):
            raise ValueError(f"scheme: expected one of {', '.join(SCHEMES)}, got {scheme!r}")
        builder.SetScheme(getattr(builder, scheme or "C"))
        builder.SetOffsetInVoxels(arguments.number(offset_in_voxels, "offset_in_voxels"))
        builder.SetResolution(arguments.integer(resolution, "resolution"))
        builder.SetAlpha(arguments.number(alpha, "alpha"))
        if accuracy is not None:
            builder.SetAccuracy(arguments.number(accuracy, "accuracy"))
        builder.SetMemoryLimit(limit)
        self._build(builder, cloud)

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
        if not isinstance(polydata, vtkPolyData):
            raise TypeError(f"polydata: expected a vtkPolyData, got {type(polydata).__name__}")
        if not GraphInfo(polydata).is_cloud:
            raise ValueError("polydata: its graph is that of a mesh: see vtkdgg.Graph")
        return cls(polydata, memory_limit=memory_limit)

    def _is_current(self):
        """Returns true if the graph belongs to the points, otherwise warns."""
        search = self._filter(vtkDGGDistance, None)
        finite = np.isfinite(self.points).all(axis=1)
        search.SetSourceIds([int(np.argmax(finite))])
        search.SetMaximumDistance(0.0)
        try:
            run(search, self._issued)
        except VTKError:
            warnings.warn(
                "points: the graph on the cloud belongs to other points or is damaged; another "
                "one is built",
                RuntimeWarning,
                stacklevel=depth_of_package(),
            )
            return False
        return True

    @property
    def components(self) -> NDArray[np.int32]:
        """Components by decreasing size, shape (n,); -1 for points that are not finite."""
        return np.array(vtk_to_numpy(self._surface.GetPointData().GetArray("Component")))
