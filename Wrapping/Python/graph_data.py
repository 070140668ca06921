# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""A graph in arrays."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Optional

from . import _kernel, arguments, meshes
from .checks import counted
from .errors import call, in_arguments
from .graph_info import PREFIX, arrays_of
from .surface import Surface

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray
    from vtkmodules.vtkCommonDataModel import vtkPolyData


class GraphData:
    """The arrays of a graph. Copies and pickled graphs are not built again."""

    @property
    def csr(self) -> Any:
        """The graph as a new scipy.sparse.csr_matrix of lengths, shape (n, n).

        Arrays are copied, because SciPy may sort them in place.

        Raises
        ------
        ImportError
            When SciPy is not installed.
        """
        csr_matrix = self._csr_matrix(
            "Graph.csr", "; Graph.offsets, .targets and .lengths do without"
        )
        n = self.number_of_points
        return csr_matrix((self.lengths, self.targets, self.offsets), shape=(n, n), copy=True)

    @property
    def points(self) -> NDArray[Any]:
        """Coordinates, shape (n, 3). A read-only view."""
        return self._prepared.points

    @property
    def offsets(self) -> NDArray[np.int64]:
        """int64, shape (n + 1,): edges that leave point i are offsets[i] to offsets[i + 1] - 1.

        A read-only view, as are `targets` and `lengths`.
        """
        return self._arrays[PREFIX + "Offsets"]

    @property
    def targets(self) -> NDArray[np.int32]:
        """int32, shape (m,): point id of the end of each directed edge. Rows are not sorted."""
        return self._arrays[PREFIX + "Targets"]

    @property
    def lengths(self) -> NDArray[Any]:
        """float32 (float64 below an accuracy of 1e-5), shape (m,): lengths of edges, rounded up."""
        return self._arrays[PREFIX + "Lengths"]

    @property
    def number_of_points(self) -> int:
        """Number of points, n."""
        return self._surface.number_of_points

    @property
    def accuracy(self) -> Optional[float]:
        """Accuracy of the graph; None for a SaddleVertexGraph. On clouds it is no bound."""
        return self._info.accuracy

    @property
    def construction(self) -> str:
        """The rule that chose the edges. `accuracy` bounds errors for "Guaranteed" only."""
        return self._info.construction

    @property
    def used_input_graph(self) -> bool:
        """True if the graph was found on the mesh or cloud, False if it was built."""
        return self._used_input_graph

    @property
    def is_cloud(self) -> bool:
        """True for the graph of a point cloud."""
        return self._info.is_cloud

    @property
    def degree(self) -> float:
        """Mean number of edges that leave a point."""
        return len(self.targets) / self.number_of_points

    @property
    def nbytes(self) -> int:
        """Bytes of the arrays of the graph."""
        return sum(array.nbytes for array in self._arrays.values())

    @property
    def polydata(self) -> vtkPolyData:
        """The surface with its graph as a new vtkPolyData, for filters and writers.

        It has all other data of the input mesh. Arrays are shared with this object and must not be
        changed in place.
        """
        return self._polydata()

    def __repr__(self) -> str:
        kind = self.construction
        if self.is_cloud:  # the accuracy is no bound
            kind = f"scheme {kind}"
        elif self.accuracy is not None:
            kind += f", accuracy {self.accuracy:g}"
        size = f"{counted(self.number_of_points, 'point')}, {counted(len(self.targets), 'edge')}"
        return f"<vtkdgg.{type(self).__name__}: {size}, {kind}, {self.nbytes / 2**20:.1f} MiB>"

    def __getstate__(self):
        return {
            "surface": self._surface.state(self._arrays),
            "memory_limit": self._memory_limit,
            "heard": self._issued,  # the key in older pickles
            "used_input_graph": self._used_input_graph,
        }

    def __setstate__(self, state):
        # Version 1.0.0 did not store the origin of the graph.
        used_input_graph = state.get("used_input_graph", False)
        surface = Surface.from_state(state["surface"])
        arrays = arrays_of(surface.field_data)
        info = _kernel.graph_info(arrays)
        issued = set(state["heard"])
        how = info.merge_coincident_points, info.merge_tolerance, info.is_cloud
        graph = call(_kernel.Graph.from_arrays, surface.prepared(*how, issued), arrays)
        self._take(surface, graph, state["memory_limit"], used_input_graph, issued)

    def _take(self, surface, graph, memory_limit, used_input_graph, issued):
        """Uses a graph of the kernel, which belongs to a surface."""
        self._surface = surface
        self._prepared, self._graph = graph.surface, graph
        self._arrays = graph.arrays
        self._info = _kernel.graph_info(self._arrays)
        self._memory_limit = memory_limit
        self._used_input_graph = used_input_graph
        self._issued = issued  # warnings already issued, which are not repeated

    def _call(self, function, *arguments, **options):
        """Calls a function of the kernel within the memory limit of the graph."""
        return call(
            function, *arguments, issued=self._issued, memory_limit=self._memory_limit, **options
        )

    def _polydata(self, result=None):
        """Returns the surface with its graph, or the output of a function of the kernel."""
        return self._surface.polydata(result, self._arrays)

    def _points(self, values, name):
        """Returns the points as `SurfacePoints`."""
        return arguments.surface_points(values, name, self._surface, self.is_cloud)

    @staticmethod
    def _csr_matrix(who, remedy=""):
        try:
            from scipy.sparse import csr_matrix
        except ImportError as error:
            raise ImportError(
                f"{who} needs SciPy, which is not installed (Debian: python3-scipy, else: pip "
                f"install scipy){remedy}"
            ) from error
        return csr_matrix


def require_graph(polydata, is_cloud):
    """Raises an error unless a vtkPolyData has the graph of a cloud, or of a mesh."""
    if not meshes.is_vtk(polydata, "vtkPolyData"):
        raise TypeError(f"polydata: expected a vtkPolyData, got {type(polydata).__name__}")
    arrays = arrays_of(meshes.cloud_of(polydata).field_data)
    builder = "vtkPointCloudDGG" if is_cloud else "vtkDiscreteGeodesicGraph"
    if not arrays:
        raise ValueError(
            f"polydata: there is no graph in its field data; take the output of {builder}"
        )
    try:
        info = _kernel.graph_info(arrays)
    except _kernel.Error as error:
        raise ValueError(f"polydata: {in_arguments(error.message)}") from None
    if info.is_cloud != is_cloud:
        kind, name = ("point cloud", "CloudGraph") if info.is_cloud else ("mesh", "Graph")
        raise ValueError(f"polydata: its graph is that of a {kind}: see vtkdgg.{name}")
