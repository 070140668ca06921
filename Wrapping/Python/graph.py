# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""A discrete geodesic graph as a Python object, for many queries."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, List, Optional, Union

import numpy as np

from . import _kernel, arguments, meshes
from .errors import call
from .graph_data import require_graph
from .graph_info import arrays_of, find_info, merging, options_like
from .queries import Queries
from .results import Isoline, Loop, lines_of

if TYPE_CHECKING:
    from numpy.typing import ArrayLike
    from vtkmodules.vtkCommonDataModel import vtkPolyData

    from .arguments import SurfacePointsLike

__all__ = ["Graph"]

# Maximum number of isovalues.
MAXIMUM_VALUES = 10_000


class Graph(Queries):
    """Geodesic distances and paths on one triangle mesh, for many queries.

    A sparse graph is built once, in which shortest paths are geodesics up to a known error; then a
    distance field takes milliseconds. The mesh is copied.

    A graph can be copied and pickled, for other processes for example, without building it again.

    Parameters
    ----------
    points, triangles : array_like, shapes (n, 3) and (m, 3), or one mesh
        As for `distance`; at least one point. A graph on the mesh is used, without a copy, unless
        the next three arguments ask for another graph. If it belongs to other points or cells, or
        is damaged, a graph with the same parameters is built, with a warning.
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
        (`number_of_neighbors` is an integer of 32 bits).
    Error
        When the mesh has no triangles, or the graph would take more memory than `memory_limit`.

    See Also
    --------
    vtkDiscreteGeodesicGraph, vtkDGGDistance, vtkGeodesicDistanceMatrix, vtkDGGPath : filters with
        further options.

    References
    ----------
    X. Wang et al., "Discrete geodesic graph (DGG) for computing geodesic distances on polyhedral
    surfaces", CAGD 52-53, 2017; Z. Fang, "Discrete geodesic graphs", PhD thesis, Nanyang
    Technological University, 2019.

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

    @arguments.with_flags
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
        if surface.number_of_points == 0:
            raise ValueError("points: expected at least one, got none")
        options = {
            "accuracy": accuracy,
            "construction": construction,
            "number_of_neighbors": number_of_neighbors,
        }
        options = {name: value for name, value in options.items() if value is not None}
        limit = arguments.number_of_bytes(memory_limit, "memory_limit")
        how = merge_coincident_points, merge_tolerance
        self._find_or_build(surface, how, limit, options, must_match=bool(options))

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
            When there are no points, no graph, or one whose parameters cannot be read.
        """
        require_graph(polydata, False)
        return cls(polydata, memory_limit=memory_limit)

    @classmethod
    def _of(cls, mesh, accuracy, is_merged):
        """Returns the graph on a mesh, with a warning if it is coarser, or else builds one."""
        graph = cls.__new__(cls)
        options = {} if accuracy is None else {"accuracy": accuracy}
        graph._find_or_build(meshes.take(mesh)[0], (is_merged, 0.0), 0, options, False)
        return graph

    @classmethod
    def from_points(cls, points: Any, **options: Any) -> Any:
        """Returns the graph of a point cloud, with the parameters of `CloudGraph`."""
        from .cloud_graph import CloudGraph

        return CloudGraph(points, **options)

    @arguments.with_flags
    def isolines(
        self,
        sources: SurfacePointsLike,
        values: ArrayLike,
        *,
        initial_distances: Optional[ArrayLike] = None,
        projection_tolerance: Optional[float] = None,
        as_polydata: bool = False,
    ) -> Union[List[Isoline], vtkPolyData]:
        """Curves along which the distance from the nearest source has a given value. They are exact
        on triangles that are large for the accuracy.

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
        ValueError, Error
            As for `distance`.
        """
        array = arguments.numbers(values, "values")
        is_number = array.ndim == 0 and array.dtype.kind in "iu"
        if is_number and array < 0:
            raise ValueError(f"values: expected a non-negative number of isolines, got {array}")
        if array.size == 0:
            raise ValueError("values: expected at least one, got none")
        count = int(array) if is_number else array.size
        if count > MAXIMUM_VALUES:
            raise ValueError(f"values: expected at most {MAXIMUM_VALUES}, got {count}")
        if not is_number:
            array = arguments.finite_numbers(values, "values", array.size)
        field = self._field(sources, initial_distances, projection_tolerance)
        if is_number:
            array = even_values(field.point_data["GeodesicDistance"], count)
        lines, _, _ = find_isolines(self._prepared, field, array, self._issued)
        if as_polydata:
            return self._polydata(lines)
        return lines_of(lines, Isoline, value="IsoValue")

    @arguments.with_flags
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
        ValueError, Error
            As for `distance`; an Error also for a rope of fewer than three different points, or
            handles of a surface with edges of more than two triangles.
        """
        loops = self._loops(points, rope, taut, projection_tolerance)
        if as_polydata:
            return self._polydata(loops)
        return lines_of(loops, Loop, length="Length", angle="Angle")

    def _find_or_build(self, surface, how, limit, options, must_match):
        """Takes the graph on a surface, or else builds one. `options` are those of the kernel."""
        info = find_info(surface.field_data)
        options = options or options_like(info)
        issued = set()
        prepared = surface.prepared(*merging(*how, None if must_match else info), issued=issued)
        graph = call(
            _kernel.Graph,
            prepared,
            stored=arrays_of(surface.field_data),
            must_match=must_match,
            memory_limit=limit,
            issued=issued,
            **options,
        )
        self._take(surface.copy(), graph, limit, graph.is_stored, issued)

    def _loops(self, points, rope, taut, projection_tolerance):
        """Returns closed geodesics as a result of the kernel."""
        if points is None and rope:
            raise ValueError("points: expected points for a rope, got none")
        mode = "AroundHandles" if points is None else "Rope" if rope else "ThroughPoint"
        loops, _ = self._call(
            _kernel.loops,
            self._graph,
            None if points is None else self._points(points, "points").in_kernel(),
            mode=mode,
            taut=taut,
            projection_tolerance=projection_tolerance,
        )
        return loops

    def _field(self, sources, initial_distances, projection_tolerance):
        """Returns distances with virtual sources, as find_isolines() needs, as a result of the
        kernel."""
        return self._distance(
            sources, None, initial_distances, projection_tolerance, generate_virtual_source=True
        )


def even_values(distances, count):
    """Returns values with even spacing between 0 and the largest distance, both excluded."""
    largest = np.nanmax(np.append(distances, 0.0))
    return largest * np.arange(1, count + 1) / (count + 1)


def find_isolines(prepared, field, values, issued=None, **options):
    """Returns isolines, ridges and bands of the active array of a result of the kernel, whose
    virtual sources or windows determine the array inside triangles."""
    return call(
        _kernel.isolines,
        prepared,
        field.point_data[field.active["points"]],
        virtual_sources=field.point_data.get("GeodesicVirtualSource"),
        field_data=field.field_data,
        values=values,
        issued=issued,
        **options,
    )
