# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""A graph in arrays, and the filters that search it."""

from __future__ import annotations

import threading
from typing import TYPE_CHECKING, Any, Optional

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData

from . import arguments
from .checks import counted
from .errors import run
from .graph_info import ARRAYS, CONSTRUCTIONS, GraphInfo
from .surface import from_arrays, shallow_copy, to_arrays

if TYPE_CHECKING:
    from numpy.typing import NDArray


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
        return _read_only(self._surface.GetPoints().GetData())

    @property
    def offsets(self) -> NDArray[np.int64]:
        """int64, shape (n + 1,): edges that leave point i are offsets[i] to offsets[i + 1] - 1.

        A read-only view, as are `targets` and `lengths`.
        """
        return self._array("Offsets")

    @property
    def targets(self) -> NDArray[np.int32]:
        """int32, shape (m,): point id of the end of each directed edge. Rows are not sorted."""
        return self._array("Targets")

    @property
    def lengths(self) -> NDArray[Any]:
        """float32 (float64 below an accuracy of 1e-5), shape (m,): lengths of edges, rounded up."""
        return self._array("Lengths")

    @property
    def number_of_points(self) -> int:
        """Number of points, n."""
        return self._surface.GetNumberOfPoints()

    @property
    def accuracy(self) -> Optional[float]:
        """Accuracy of the graph; None for a SaddleVertexGraph. On clouds it is no bound."""
        return self._info.accuracy

    @property
    def construction(self) -> str:
        """The rule that chose the edges. `accuracy` bounds errors for "Guaranteed" only."""
        return CONSTRUCTIONS[self._info.construction]

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
        names = (name for name in ARRAYS if self._surface.GetFieldData().HasArray(f"DGG.{name}"))
        return sum(self._array(name).nbytes for name in names)

    @property
    def polydata(self) -> vtkPolyData:
        """The surface with its graph as a new vtkPolyData, for filters and writers.

        It has all other data of the input mesh. Arrays are shared with this object and must not be
        changed in place.
        """
        return shallow_copy(self._surface)

    def __repr__(self) -> str:
        kind = self.construction
        if self.is_cloud:  # the accuracy is no bound
            kind = f"scheme {kind}"
        elif self.accuracy is not None:
            kind += f", accuracy {self.accuracy:g}"
        size = f"{counted(self.number_of_points, 'point')}, {counted(len(self.targets), 'edge')}"
        return f"<vtkdgg.{type(self).__name__}: {size}, {kind}, {self.nbytes / 2**20:.1f} MiB>"

    def __getstate__(self):
        # Without filters, which repeat their preparation.
        return {
            "surface": to_arrays(self._surface),
            "memory_limit": self._memory_limit,
            "heard": self._issued,  # the key in older pickles
            "used_input_graph": self._used_input_graph,
        }

    def __setstate__(self, state):
        # Version 1.0.0 did not store the origin of the graph.
        used_input_graph = state.get("used_input_graph", False)
        surface = from_arrays(state["surface"])
        self._take(surface, state["memory_limit"], used_input_graph, state["heard"])

    def _build(self, builder, surface, refused=None):
        """Runs a builder, which may find the graph on the surface; `refused` as for run()."""
        issued = set()  # warnings already issued, which filters repeat
        builder.SetInputData(surface)
        output = shallow_copy(run(builder, issued, refused))  # the builder keeps much more
        self._take(output, builder.GetMemoryLimit(), builder.GetGraphBuildTime() == 0, issued)

    def _take(self, surface, memory_limit, used_input_graph, issued=()):
        """Uses the graph in the field data of a surface."""
        self._issued = set(issued)
        self._memory_limit = memory_limit
        self._used_input_graph = used_input_graph
        self._local = threading.local()
        self._surface = surface
        self._info = GraphInfo(surface)

    @property
    def _filters(self):
        """Filters of this thread. Other threads have their own, with other sources."""
        return self._local.__dict__

    def _filter(self, kind, tolerance):
        """Returns the filter of a class, which keeps its preparation for the next query."""
        filters = self._filters
        if kind not in filters:
            consumer = kind()
            consumer.SetMergeCoincidentPoints(self._info.is_merged)
            consumer.SetMergeTolerance(self._info.merge_tolerance)
            consumer.SetMemoryLimit(self._memory_limit)
            consumer.SetInputData(self._surface)
            filters[kind] = consumer
        consumer = filters[kind]
        consumer.SetProjectionTolerance(arguments.projection_tolerance(tolerance))
        return consumer

    def _points(self, values, name):
        """Returns the points as `SurfacePoints`."""
        return arguments.surface_points(values, name, self._surface, self.is_cloud)

    @staticmethod
    def _detached(algorithm, port=0):
        """Returns a copy of the output, which the next query replaces."""
        result = shallow_copy(algorithm.GetOutputDataObject(port))
        algorithm.Modified()
        return result

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

    def _array(self, name):
        return _read_only(self._surface.GetFieldData().GetArray(f"DGG.{name}"))


def _read_only(array):
    view = vtk_to_numpy(array)
    view.flags.writeable = False
    return view
