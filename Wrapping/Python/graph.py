# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""A discrete geodesic graph as a Python object: built once, asked often."""

from __future__ import annotations

import threading
from typing import TYPE_CHECKING, Any, Literal, Optional, Tuple, Union, overload

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData

from . import arguments
from .errors import VTKError, run
from .graph_info import ARRAYS, CONSTRUCTIONS, GraphInfo, damaged
from .paths import Path, find
from .surface import copy_surface, from_arrays, to_arrays
from .vtkDGGFiltersGeodesic import (
    vtkDGGDistance,
    vtkDGGPath,
    vtkDiscreteGeodesicGraph,
    vtkGeodesicDistanceMatrix,
)

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

__all__ = ["Graph"]


class Graph:
    """Geodesic distances and paths on one triangle mesh, asked many times.

    A sparse graph is built once, in which shortest paths are geodesics up to a known error; then a
    distance field takes milliseconds. The mesh is copied and does not change any more.

    A graph can be copied and pickled, for other processes for example; it is not built again.

    Parameters
    ----------
    points : array_like, shape (n, 3)
        Coordinates; at least one point.
    triangles : array_like of int, shape (m, 3)
        Point ids of the corners.
    accuracy : float, optional
        Largest relative error of a distance, in [1e-6, 0.5]. The mean error is far smaller.
    construction : str, optional
        The rule that chooses the edges: "Guaranteed", or for comparison "OneRelay", "Indirect",
        "SaddleVertexGraph" (which has no use for `accuracy`).
    number_of_neighbors : int, optional
        Of a SaddleVertexGraph: how many of the nearest points each point looks at. Where it is more
        than there are points, all of them: minutes for some thousand points.
    memory_limit : int, optional
        Most bytes that building the graph, or the table of `matrix`, may take. Default: 70 % of the
        memory that is free at that time.
    merge_coincident_points : bool, optional
        Whether points with the very same coordinates are one, as along the seams of a textured
        mesh or in a soup of triangles. (MergeCoincidentPoints, in the messages of the filters.)
    merge_tolerance : float, optional
        How far from each other merged points may be, as a fraction of the diagonal of the bounding
        box of all points. Default: 0, the very same coordinates. Only used with
        `merge_coincident_points`. (MergeTolerance, in the messages of the filters.)

    Raises
    ------
    ValueError
        When an array has the wrong shape or type, a number is not finite, or an id does not exist;
        when another argument is not of the type above (`number_of_neighbors` is an integer of 32
        bits).
    VTKError
        When the filter refuses the input: an accuracy out of range, a mesh without triangles, a
        graph that would take more memory than `memory_limit`.

    See Also
    --------
    vtkDiscreteGeodesicGraph, vtkDGGDistance, vtkGeodesicDistanceMatrix, vtkDGGPath : the filters
        that do the work, with further options.

    Examples
    --------
    >>> graph = vtkdgg.Graph([[0, 0, 0], [3, 0, 0], [0, 4, 0]], [[0, 1, 2]])
    >>> graph.distance(1)
    array([3., 0., 5.])
    >>> graph.matrix([0, 1], [1, 2])
    array([[3., 4.],
           [0., 5.]])
    >>> graph.path(1, 2).length
    5.0
    """

    def __init__(
        self,
        points: ArrayLike,
        triangles: ArrayLike,
        accuracy: float = 0.01,
        construction: str = "Guaranteed",
        number_of_neighbors: int = 30,
        memory_limit: Optional[int] = None,
        merge_coincident_points: bool = False,
        merge_tolerance: float = 0.0,
    ) -> None:
        points = arguments.coordinates(points, "points")
        if len(points) == 0:
            raise ValueError("points: at least one is wanted")
        triangles = arguments.corners(triangles, len(points))
        if construction not in CONSTRUCTIONS:
            known = ", ".join(CONSTRUCTIONS)
            raise ValueError(f"construction: one of {known} is wanted, not {construction!r}")
        builder = vtkDiscreteGeodesicGraph()
        builder.SetAccuracy(arguments.number(accuracy, "accuracy"))
        builder.SetConstruction(CONSTRUCTIONS.index(construction))
        builder.SetNumberOfNeighbors(arguments.integer(number_of_neighbors, "number_of_neighbors"))
        builder.SetMemoryLimit(arguments.number_of_bytes(memory_limit, "memory_limit"))
        builder.SetMergeCoincidentPoints(bool(merge_coincident_points))
        builder.SetMergeTolerance(arguments.limit(merge_tolerance, "merge_tolerance"))
        self._build(builder, arguments.polydata(points, triangles))

    @classmethod
    def from_polydata(cls, polydata: vtkPolyData, memory_limit: Optional[int] = None) -> Graph:
        """The graph that vtkDiscreteGeodesicGraph has put on a surface.

        It is used as it is, without a copy. Points and cells are copied; the arrays of point, cell
        and field data are kept in `polydata` and shared. When it is not that of the points and
        polygons any more, a warning says so and it is built anew with the same parameters. When it
        is damaged, its parameters may be as well: that is an error.

        Parameters
        ----------
        polydata : vtkPolyData
            Output of vtkDiscreteGeodesicGraph, of a filter after it, or of a reader.
        memory_limit : int, optional
            As for the class.

        Raises
        ------
        ValueError
            When there are no points, no graph, or a damaged one.
        """
        if not isinstance(polydata, vtkPolyData):
            raise TypeError(f"polydata: a vtkPolyData is wanted, not {type(polydata).__name__}")
        if polydata.GetNumberOfPoints() == 0:
            raise ValueError("polydata: at least one point is wanted")
        info = GraphInfo(polydata)
        builder = vtkDiscreteGeodesicGraph()
        builder.SetConstruction(info.construction)
        if info.accuracy is not None:
            builder.SetAccuracy(info.accuracy)
        else:
            builder.SetNumberOfNeighbors(info.number_of_neighbors)
        builder.SetMergeCoincidentPoints(info.is_merged)
        builder.SetMergeTolerance(info.merge_tolerance)
        builder.SetMemoryLimit(arguments.number_of_bytes(memory_limit, "memory_limit"))
        graph = cls.__new__(cls)
        try:
            graph._build(builder, copy_surface(polydata), builder.GetInputGraphDamage)
        except VTKError:
            if not builder.GetInputGraphDamage():
                raise
            raise damaged(builder.GetInputGraphDamage()) from None
        return graph

    @overload
    def distance(
        self,
        sources: ArrayLike,
        correction: bool = ...,
        maximum_distance: Optional[float] = ...,
        initial_distances: Optional[ArrayLike] = ...,
        return_source: Literal[False] = ...,
        unreached: float = ...,
        projection_tolerance: Optional[float] = ...,
    ) -> NDArray[np.float64]: ...

    @overload
    def distance(
        self,
        sources: ArrayLike,
        correction: bool = ...,
        maximum_distance: Optional[float] = ...,
        initial_distances: Optional[ArrayLike] = ...,
        *,
        return_source: Literal[True],
        unreached: float = ...,
        projection_tolerance: Optional[float] = ...,
    ) -> Tuple[NDArray[np.float64], NDArray[np.int64]]: ...

    def distance(
        self,
        sources: ArrayLike,
        correction: bool = True,
        maximum_distance: Optional[float] = None,
        initial_distances: Optional[ArrayLike] = None,
        return_source: bool = False,
        unreached: float = np.nan,
        projection_tolerance: Optional[float] = None,
    ) -> Union[NDArray[np.float64], Tuple[NDArray[np.float64], NDArray[np.int64]]]:
        """Distance of every point from the nearest source.

        Parameters
        ----------
        sources : int, sequence of int, or array_like of float, shape (k, 3)
            Point ids, or coordinates of points anywhere on the surface; they are moved to the
            closest point of the surface.
        correction : bool, optional
            True: the best estimate within the promised error. False: the length of a path in the
            graph, which is never shorter than the exact distance; these are a metric.
        maximum_distance : float, optional
            Points farther than this are left unreached. Default: no limit.
        initial_distances : float or sequence of float, optional
            The distances that the sources start with. Default: 0.
        return_source : bool, optional
            Whether to return the nearest source as well.
        unreached : float, optional
            Distance given to points that no source reaches. Default: NaN.
        projection_tolerance : float, optional
            How far coordinates may be from the surface, as a fraction of the diagonal of its
            bounding box. Default: 0.01.

        Returns
        -------
        distances : numpy.ndarray of float64, shape (n,)
            In the unit of the points.
        nearest : numpy.ndarray of int, shape (n,)
            Index into `sources` of the nearest one, -1 where none reaches. Only with
            `return_source`.

        Raises
        ------
        ValueError
            When an argument has the wrong shape or type, or an id does not exist.
        VTKError
            When the filter refuses the input, as for coordinates far off the surface.
        """
        ids, places = arguments.places(sources, "sources", self.number_of_points)
        limit = arguments.limit(maximum_distance, "maximum_distance")
        unreached = arguments.number(unreached, "unreached")
        offsets = None
        if initial_distances is not None:
            count = len(places) if ids is None else len(ids)
            offsets = arguments.finite_numbers(initial_distances, "initial_distances", count)

        search = self._filter(vtkDGGDistance, projection_tolerance)
        distances, nearest = self._search(search, ids, places, offsets, limit, correction)
        distances[np.isinf(distances)] = unreached
        return (distances, nearest) if return_source else distances

    def matrix(
        self,
        rows: ArrayLike,
        columns: Optional[ArrayLike] = None,
        unreached: float = np.nan,
        projection_tolerance: Optional[float] = None,
    ) -> NDArray[np.float64]:
        """Distances between two sets of points, or between all pairs of one.

        They are lengths of paths in the graph (there is no correction): at least the exact
        distance, and at most (1 + accuracy) times that. Between points of the mesh they are a
        metric.

        Parameters
        ----------
        rows, columns : int, sequence of int, or array_like of float, shape (k, 3)
            Point ids or coordinates, as for `distance`. Without columns they are the rows; then the
            matrix is symmetric.
        unreached : float, optional
            Distance given to pairs that are not connected. Default: NaN.
        projection_tolerance : float, optional
            How far coordinates may be from the surface, as a fraction of the diagonal of its
            bounding box. Default: 0.01.

        Returns
        -------
        numpy.ndarray of float64, shape (number of rows, number of columns)
            In the unit of the points.

        Raises
        ------
        ValueError, VTKError
            As for `distance`; a VTKError also when the matrix would take more memory than
            `memory_limit`.
        """
        row_ids, row_places = arguments.places(rows, "rows", self.number_of_points)
        column_ids, column_places = None, None
        if columns is not None:
            column_ids, column_places = arguments.places(columns, "columns", self.number_of_points)

        tabulate = self._filter(vtkGeodesicDistanceMatrix, projection_tolerance)
        tabulate.SetRowIds([] if row_ids is None else row_ids)
        tabulate.SetRowData(None if row_places is None else arguments.polydata(row_places))
        tabulate.SetColumnIds([] if column_ids is None else column_ids)
        tabulate.SetColumnData(None if column_places is None else arguments.polydata(column_places))
        tabulate.SetUnreachedValue(arguments.number(unreached, "unreached"))
        tabulate.GenerateTableOff()
        run(tabulate, self._heard)
        matrix = tabulate.GetMatrix()
        shape = matrix.GetNumberOfTuples(), matrix.GetNumberOfComponents()
        tabulate.ReleaseMatrix()  # it is ours alone now, and is not given out twice
        return vtk_to_numpy(matrix).reshape(shape)

    def path(
        self,
        start: ArrayLike,
        end: ArrayLike,
        straighten: bool = True,
        detour: Optional[float] = None,
        projection_tolerance: Optional[float] = None,
    ) -> Path:
        """A path on the surface from one point to another.

        It is a geodesic: no path next to it is shorter. Its length is at least the exact distance,
        and at most (1 + accuracy) times that.

        Parameters
        ----------
        start, end : int, or array_like, shape (3,)
            A point id, or coordinates of a point anywhere on the surface; it is moved to the
            closest point of the surface. Three integers are coordinates.
        straighten : bool, optional
            False: the path in the graph as it is, with small bends at some points.
        detour : float, optional
            Behind every bump there are several geodesics. The shortest one is taken of those with
            detours from the first one found of up to this fraction of its length, in [0, 0.1].
            Default: 1e-4.
        projection_tolerance : float, optional
            How far coordinates may be from the surface, as a fraction of the diagonal of its
            bounding box. Default: 0.01.

        Returns
        -------
        Path

        Raises
        ------
        ValueError
            When an argument has the wrong shape or type, an id does not exist, or start and end are
            not connected by the surface.
        VTKError
            When the filter refuses the input, as for coordinates far off the surface.
        """
        ends = tuple(
            arguments.place(value, name, self.number_of_points)
            for value, name in ((start, "start"), (end, "end"))
        )
        detour = 1e-4 if detour is None else arguments.number(detour, "detour")
        if not 0.0 <= detour <= 0.1:
            raise ValueError(f"detour: must be in [0, 0.1], is {detour}")
        finder = self._filter(vtkDGGPath, projection_tolerance)
        finder.SetStraighten(bool(straighten))
        finder.SetDetour(detour)
        points = vtk_to_numpy(self._surface.GetPoints().GetData())
        return find(finder, ends, points, self._heard)

    @property
    def csr(self) -> Any:
        """The graph as a new scipy.sparse.csr_matrix of lengths, shape (n, n).

        It has arrays of its own, because SciPy sorts them in place now and then.

        Raises
        ------
        ImportError
            When SciPy is not installed.
        """
        try:
            from scipy.sparse import csr_matrix
        except ImportError as error:
            raise ImportError(
                "Graph.csr needs SciPy, which is not installed (Debian: python3-scipy, else: "
                "pip install scipy); Graph.offsets, .targets and .lengths do without"
            ) from error
        n = self.number_of_points
        return csr_matrix((self.lengths, self.targets, self.offsets), shape=(n, n), copy=True)

    @property
    def offsets(self) -> NDArray[np.int64]:
        """int64, shape (n + 1,): edges that leave point i are offsets[i] to offsets[i + 1] - 1.

        A view that cannot be written to, as are `targets` and `lengths`.
        """
        return self._array("Offsets")

    @property
    def targets(self) -> NDArray[np.int32]:
        """int32, one for each directed edge: the point at its end. Not sorted in a row."""
        return self._array("Targets")

    @property
    def lengths(self) -> NDArray[Any]:
        """float32 (float64 below an accuracy of 1e-5), one for each directed edge: rounded up."""
        return self._array("Lengths")

    @property
    def number_of_points(self) -> int:
        """Number of points, n."""
        return self._surface.GetNumberOfPoints()

    @property
    def accuracy(self) -> Optional[float]:
        """What the graph was built for; None for a SaddleVertexGraph."""
        return self._info.accuracy

    @property
    def construction(self) -> str:
        """The rule that chose the edges. Only "Guaranteed" is sure to keep to `accuracy`."""
        return CONSTRUCTIONS[self._info.construction]

    @property
    def degree(self) -> float:
        """Mean number of edges that leave a point."""
        return len(self.targets) / self.number_of_points

    @property
    def nbytes(self) -> int:
        """Bytes of the arrays of the graph."""
        return sum(self._array(name).nbytes for name in ARRAYS)

    @property
    def polydata(self) -> vtkPolyData:
        """The surface with its graph as a new vtkPolyData, for filters and writers.

        It has all that was given to `from_polydata`. It shares its arrays with this object: do not
        change them in place.
        """
        result = vtkPolyData()
        result.ShallowCopy(self._surface)
        return result

    def __repr__(self) -> str:
        quality = "" if self.accuracy is None else f", accuracy {self.accuracy:g}"
        return (
            f"<vtkdgg.Graph: {self.number_of_points} points, {len(self.targets)} edges, "
            f"{self.construction}{quality}, {self.nbytes / 2**20:.1f} MiB>"
        )

    def __getstate__(self):
        # Filters prepare themselves again.
        return {
            "surface": to_arrays(self._surface),
            "memory_limit": self._memory_limit,
            "heard": self._heard,
        }

    def __setstate__(self, state):
        self._heard = set(state["heard"])
        self._memory_limit = state["memory_limit"]
        self._local = threading.local()
        self._surface = from_arrays(state["surface"])
        self._info = GraphInfo(self._surface)

    def _build(self, builder, surface, refused=None):
        """Take the graph of the surface, or have the builder make one; `refused` as for run()."""
        self._heard = set()  # what is wrong with the mesh is said once, not by each filter
        self._memory_limit = builder.GetMemoryLimit()
        self._local = threading.local()
        builder.SetInputData(surface)
        self._surface = vtkPolyData()  # without the builder, which keeps much more
        self._surface.ShallowCopy(run(builder, self._heard, refused))
        self._info = GraphInfo(self._surface)

    @property
    def _filters(self):
        """Those of this thread: another one would change sources before results are read."""
        return self._local.__dict__

    def _filter(self, kind, tolerance):
        """The filter of the class, which keeps what it has prepared for the next query."""
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

    def _search(self, search, ids, places, offsets, limit, correction):
        """Distances, infinite where unreached, and nearest sources."""
        search.SetUnreachedValue(np.inf)
        search.SetCorrection(bool(correction))
        search.SetMaximumDistance(limit)
        search.GenerateNearestSourceOn()
        ids = [] if ids is None else ids
        search.SetSourceIds(ids, np.zeros(len(ids)) if offsets is None else offsets[: len(ids)])
        search.SetSourceData(None if places is None else arguments.polydata(places))
        if places is not None and offsets is not None:
            array = numpy_to_vtk(offsets, deep=True)
            array.SetName(search.GetInitialDistanceArrayName())
            search.GetInputDataObject(1, 0).GetPointData().AddArray(array)
        data = run(search, self._heard).GetPointData()
        # Copies: the output is kept, and given out again when the same is asked for.
        distances = np.array(vtk_to_numpy(data.GetArray(search.GetDistanceArrayName())))
        nearest = vtk_to_numpy(data.GetArray(search.GetSourceArrayName())).astype(np.intp)
        return distances, nearest

    def _array(self, name):
        view = vtk_to_numpy(self._surface.GetFieldData().GetArray(f"DGG.{name}"))
        view.flags.writeable = False
        return view
