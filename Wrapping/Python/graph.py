# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""A discrete geodesic graph as a Python object, for many queries."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, List, Optional, Union

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkPolyData

from . import arguments, meshes
from .errors import VTKError, run
from .graph_info import CONSTRUCTIONS, MESH_CONSTRUCTIONS, GraphInfo, damaged, set_merging
from .queries import Queries
from .results import Isoline, Loop, array_of, lines_of
from .surface import shallow_copy
from .vtkDGGFiltersGeodesic import vtkApolloniusIsolines, vtkDGGLoop, vtkDiscreteGeodesicGraph

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from .arguments import SurfacePointsLike

__all__ = ["Graph"]

# Largest number of values of isolines.
MOST_VALUES = 10_000


class Graph(Queries):
    """Geodesic distances and paths on one triangle mesh, for many queries.

    A sparse graph is built once, in which shortest paths are geodesics up to a known error; then a
    distance field takes milliseconds. The mesh is copied.

    A graph can be copied and pickled, for other processes for example, without building it again.

    Parameters
    ----------
    points, triangles : array_like, shapes (n, 3) and (m, 3), or one mesh
        As for `distance`; at least one point. A graph on the mesh is used, without a copy, unless
        the next three arguments ask for another graph. If it belongs to other points or cells, a
        graph with the same parameters is built, with a warning.
    accuracy : float, optional
        Largest relative error of a distance, in [1e-6, 0.5]. The mean error is far smaller.
        Default: that of the graph on the mesh, otherwise 0.01.
    construction : str, optional
        The rule that chooses the edges: "Guaranteed" (default), or for comparison "OneRelay",
        "Indirect", "SaddleVertexGraph" (which ignores `accuracy`).
    number_of_neighbors : int, optional
        Number of nearest points that each point of a SaddleVertexGraph may connect to. Examining
        all points takes minutes for some thousand points. Default: 30.
    memory_limit : int, optional
        Largest size of the graph while it is built, and of the array of `matrix`, in bytes.
        Default: 70 % of the memory that is free at that time.
    merge_coincident_points : bool, optional
        Treat points with equal coordinates as one, as along the seams of a textured mesh or in a
        triangle soup.
    merge_tolerance : float, optional
        Largest distance of merged points, as a fraction of the diagonal of the bounding box of all
        points. Default: 0, equal coordinates. Only used with `merge_coincident_points`.

    Raises
    ------
    ValueError
        When an array has the wrong shape or type, a number is not finite, or an id does not exist;
        when an accuracy is out of range; when another argument is not of the type above
        (`number_of_neighbors` is an integer of 32 bits); when the graph on the mesh is damaged
        and none of its parameters is given.
    VTKError
        When the filter refuses the input: a mesh without triangles, a graph that would take more
        memory than `memory_limit`.

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
        points: Any,
        triangles: Optional[ArrayLike] = None,
        *,
        accuracy: Optional[float] = None,
        construction: Optional[str] = None,
        number_of_neighbors: Optional[int] = None,
        memory_limit: Optional[int] = None,
        merge_coincident_points: bool = False,
        merge_tolerance: float = 0.0,
    ) -> None:
        if isinstance(triangles, float):
            raise ValueError(
                f"triangles: expected cells, got {triangles}; accuracy is a keyword argument: "
                f"accuracy={triangles}"
            )
        surface, _ = meshes.take(points, triangles)
        if surface.GetNumberOfPoints() == 0:
            raise ValueError("points: expected at least one, got none")
        info = None
        if accuracy is None and construction is None and number_of_neighbors is None:
            info = GraphInfo.find(surface)
            if info is not None and not info.is_cloud:
                accuracy, construction = info.accuracy, CONSTRUCTIONS[info.construction]
                number_of_neighbors = info.number_of_neighbors or None
        if construction not in (None, *MESH_CONSTRUCTIONS):
            known = ", ".join(MESH_CONSTRUCTIONS)
            raise ValueError(f"construction: expected one of {known}, got {construction!r}")
        builder = vtkDiscreteGeodesicGraph()
        if accuracy is not None:
            builder.SetAccuracy(arguments.accuracy(accuracy))
        if construction is not None:
            builder.SetConstruction(CONSTRUCTIONS.index(construction))
        if number_of_neighbors is not None:
            count = arguments.integer(number_of_neighbors, "number_of_neighbors")
            builder.SetNumberOfNeighbors(count)
        builder.SetMemoryLimit(arguments.number_of_bytes(memory_limit, "memory_limit"))
        set_merging(builder, merge_coincident_points, merge_tolerance, info)
        try:
            self._build(builder, surface, builder.GetInputGraphDamage if info else None)
        except VTKError:
            if not (info and builder.GetInputGraphDamage()):
                raise
            raise damaged(builder.GetInputGraphDamage()) from None

    @classmethod
    def from_polydata(cls, polydata: vtkPolyData, *, memory_limit: Optional[int] = None) -> Graph:
        """Returns the graph in the field data of a vtkPolyData.

        Unlike ``Graph(polydata)``, a missing graph is an error. Points and cells are copied; the
        arrays of point, cell and field data are shared with `polydata`.

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
            raise TypeError(f"polydata: expected a vtkPolyData, got {type(polydata).__name__}")
        if GraphInfo(polydata).is_cloud:
            raise ValueError("polydata: its graph is that of a point cloud: see vtkdgg.CloudGraph")
        return cls(polydata, memory_limit=memory_limit)

    @classmethod
    def from_points(cls, points: Any, **options: Any) -> Any:
        """Returns the graph of a point cloud, with the parameters of `CloudGraph`."""
        from .cloud_graph import CloudGraph

        return CloudGraph(points, **options)

    def isolines(
        self,
        sources: SurfacePointsLike,
        values: ArrayLike,
        *,
        initial_distances: Optional[ArrayLike] = None,
        projection_tolerance: Optional[float] = None,
        as_polydata: bool = False,
    ) -> Union[List[Isoline], vtkPolyData]:
        """Curves along which the distance from the nearest source has a given value.

        Parameters
        ----------
        sources, initial_distances, projection_tolerance
            As for `distance`.
        values : float, or sequence of float, or int
            The distances, at most 10,000. An integer is a number of distances with even spacing
            between 0 and the largest distance, both excluded.
        as_polydata : bool, optional
            Return a vtkPolyData with polylines and the arrays of vtkApolloniusIsolines.

        Returns
        -------
        list of Isoline, or vtkPolyData
            By increasing value; none for a value outside the range of the distances.

        Raises
        ------
        ValueError, VTKError
            As for `distance`.
        """
        array = arguments.numbers(values, "values")
        is_number = array.ndim == 0 and array.dtype.kind in "iu"
        if is_number and array < 0:
            raise ValueError(f"values: expected a non-negative number of isolines, got {array}")
        if array.size == 0:
            raise ValueError("values: expected at least one, got none")
        count = int(array) if is_number else array.size
        if count > MOST_VALUES:
            raise ValueError(f"values: expected at most {MOST_VALUES}, got {count}")
        if not is_number:
            array = arguments.finite_numbers(values, "values", array.size)
        field = self._field(sources, initial_distances, projection_tolerance)
        if is_number:
            array = even_values(array_of(field.GetPointData(), "GeodesicDistance"), count)
        output = find_isolines(field, array, False, self._info, self._issued)
        return output if as_polydata else lines_of(output, Isoline, value="IsoValue")

    def loop(
        self,
        points: Optional[SurfacePointsLike] = None,
        *,
        rope: bool = False,
        taut: bool = False,
        projection_tolerance: Optional[float] = None,
        as_polydata: bool = False,
    ) -> Union[List[Loop], vtkPolyData]:
        """Closed geodesics: closed curves that are locally shortest.

        Parameters
        ----------
        points : surface points, optional
            As for `distance`: the shortest loop found through each of them. Default: None,
            loops around the handles and holes of the surface.
        rope : bool, optional
            One loop through all points, in their order.
        taut : bool, optional
            Release the points and pull the loops tight.
        projection_tolerance : float, optional
            As for `distance`.
        as_polydata : bool, optional
            Return a vtkPolyData with polylines and the arrays of vtkDGGLoop.

        Returns
        -------
        list of Loop, or vtkPolyData
            Loops that contract to a point are skipped, with a warning.

        Raises
        ------
        ValueError, VTKError
            As for `distance`; a VTKError also for a rope of fewer than three different points, or
            handles of a surface with edges of more than two triangles.
        """
        tie = self._filter(vtkDGGLoop, projection_tolerance)
        if points is not None:
            arguments.set_points(tie, "Point", self._points(points, "points"))
            tie.SetMode(tie.Rope if rope else tie.ThroughPoint)
        elif rope:
            raise ValueError("points: expected points for a rope, got none")
        else:
            tie.SetModeToAroundHandles()
        tie.SetTaut(bool(taut))
        output = run(tie, self._issued)
        if as_polydata:
            return self._detached(tie)
        return lines_of(output, Loop, length="Length", angle="Angle")

    def _field(self, sources, initial_distances, projection_tolerance):
        """Returns the surface with distances and what find_isolines() needs."""
        search = self._search(sources, True, None, initial_distances, projection_tolerance)
        search.SetUnreachedValue(np.nan)
        search.GenerateVirtualSourceOn()
        # The next query replaces the output of the filter.
        return shallow_copy(run(search, self._issued))


def even_values(distances, count):
    """Returns values with even spacing between 0 and the largest distance, both excluded."""
    largest = np.nanmax(np.append(distances, 0.0))
    return largest * np.arange(1, count + 1) / (count + 1)


def find_isolines(field, values, merge_coincident_points, info=None, issued=None):
    """Returns the isolines of a surface with distances and virtual sources or windows. `info` is
    that of the graph of the distances."""
    contour = vtkApolloniusIsolines()
    set_merging(contour, merge_coincident_points, 0.0, info)
    contour.SetInputData(field)
    for i, value in enumerate(values):
        contour.SetValue(i, value)
    return run(contour, issued)
