# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Queries of the graph of a mesh or cloud."""

from __future__ import annotations

from typing import TYPE_CHECKING, List, Optional, Tuple, Union

import numpy as np

from . import _kernel, arguments
from .distances import field_of, field_options
from .matrices import Matrices
from .paths import find, paths_of
from .results import Path, Samples, Voronoi, surface_points_of, voronoi_of

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray
    from vtkmodules.vtkCommonDataModel import vtkPolyData

    from .arguments import SurfacePointLike, SurfacePointsLike


class Queries(Matrices):
    """Queries of a graph for distances, paths, samples and Voronoi cells."""

    @arguments.with_flags
    def distance(
        self,
        sources: SurfacePointsLike,
        *,
        correction: bool = True,
        maximum_distance: Optional[float] = None,
        initial_distances: Optional[ArrayLike] = None,
        return_source: bool = False,
        unreached: float = np.nan,
        projection_tolerance: Optional[float] = None,
        as_polydata: bool = False,
    ) -> Union[NDArray[np.float64], Tuple[NDArray[np.float64], NDArray[np.intp]], vtkPolyData]:
        """Distance of every point from the nearest source.

        Parameters
        ----------
        sources : surface points
            As for the function `vtkdgg.distance`: point ids, coordinates, or tuples (face,
            (b0, b1, b2)).
        correction : bool, optional
            True: the best estimate within the error bound. False: the length of a path in the
            graph, which is never shorter than the exact distance; these lengths form a metric.
        maximum_distance : float, optional
            Points farther than this are not reached. Default: no limit.
        initial_distances : float or sequence of float, optional
            Distances at the sources, in the unit of the points. Default: 0.
        return_source : bool, optional
            Return the nearest source of each point as well.
        unreached : float, optional
            Distance given to points that no source reaches. Default: NaN.
        projection_tolerance : float, optional
            Largest distance of coordinates from the surface, as a fraction of the diagonal of its
            bounding box. Default: 0.01.
        as_polydata : bool, optional
            Return the surface with the point arrays "GeodesicDistance" and "GeodesicSource".

        Returns
        -------
        distances : numpy.ndarray of float64, shape (n,), or vtkPolyData
            In the unit of the points.
        nearest : numpy.ndarray of int, shape (n,)
            Index into `sources` of the nearest one, -1 for unreached points. Only with
            `return_source` and without `as_polydata`.

        Raises
        ------
        ValueError
            When an argument has the wrong shape or type, or an id does not exist.
        Error
            When a point is far off the surface.
        """
        result = self._distance(
            sources,
            maximum_distance,
            initial_distances,
            projection_tolerance,
            unreached_value=unreached,
            correction=correction,
            generate_nearest_source=True,
        )
        return self._polydata(result) if as_polydata else field_of(result, return_source)

    @arguments.with_flags
    def path(
        self,
        start: SurfacePointLike,
        end: SurfacePointLike,
        *,
        straighten: bool = True,
        detour: Optional[float] = None,
        projection_tolerance: Optional[float] = None,
        as_polydata: bool = False,
    ) -> Union[Path, vtkPolyData]:
        """A path on the surface from one point to another.

        It is a geodesic: no path next to it is shorter. Its length is at least the exact distance,
        and at most (1 + accuracy) times that.

        Parameters
        ----------
        start, end : surface point
            As one of the sources of `distance`.
        straighten : bool, optional
            False: the path in the graph as it is, with small bends at some points.
        detour : float, optional
            Several geodesics may connect two points. The result is the shortest of those that
            exceed the first one found by at most this fraction of its length, in [0, 0.1]; 0 takes
            the first one. Default: 1e-4.
        projection_tolerance : float, optional
            As for `distance`.
        as_polydata : bool, optional
            Return a vtkPolyData with one polyline and the arrays of vtkDGGPath.

        Returns
        -------
        Path or vtkPolyData

        Raises
        ------
        ValueError
            When an argument has the wrong shape or type, or an id does not exist.
        NotConnectedError
            A ValueError: when start and end are not connected by the surface.
        Error
            When a point is far off the surface.
        """
        result = self._path(start, end, straighten, detour, projection_tolerance)
        return self._polydata(result) if as_polydata else paths_of(result, 1)[0]

    @arguments.with_flags
    def paths(
        self,
        starts: SurfacePointsLike,
        ends: SurfacePointsLike,
        *,
        straighten: bool = True,
        detour: Optional[float] = None,
        projection_tolerance: Optional[float] = None,
        as_polydata: bool = False,
    ) -> Union[List[Optional[Path]], vtkPolyData]:
        """Paths between many pairs of points, on all threads.

        Parameters
        ----------
        starts, ends : surface points
            As for `distance`; equal numbers of starts and ends, or one of either.
        straighten, detour, projection_tolerance
            As for `path`.
        as_polydata : bool, optional
            Return one vtkPolyData with a polyline for each path; the cell array "PairId" contains
            the index of the pair.

        Returns
        -------
        list of Path, or vtkPolyData
            The item is None, with a warning, for a pair that the surface does not connect.

        Raises
        ------
        ValueError, Error
            As for `path`.
        """
        sets = [self._points(starts, "starts"), self._points(ends, "ends")]
        count = max(map(len, sets))
        if any(len(points) not in (1, count) for points in sets):
            raise ValueError(
                "starts and ends: expected equal numbers, or one of either, got "
                f"{len(sets[0])} and {len(sets[1])}"
            )
        sets = [points[np.arange(count) % len(points)] for points in sets]
        result = self._find_paths(*sets, straighten, detour, projection_tolerance)
        return self._polydata(result) if as_polydata else paths_of(result, count)

    @arguments.with_flags
    def sample(
        self,
        number_of_samples: int,
        *,
        first: int = 0,
        start: Optional[SurfacePointsLike] = None,
        covering_radius: float = 0.0,
        in_faces: bool = False,
        projection_tolerance: Optional[float] = None,
        as_polydata: bool = False,
    ) -> Union[Samples, vtkPolyData]:
        """Evenly spread points: each is as far as possible from all earlier ones.

        Parameters
        ----------
        number_of_samples : int
            Largest number of samples, including those of `start`.
        first : int, optional
            Point id of the first sample. Default: 0.
        start : surface points, optional
            First samples, which replace `first`.
        covering_radius : float, optional
            Stop when every point of the mesh is at most this far from a sample, in the unit of the
            points. Default: 0, no such limit.
        in_faces : bool, optional
            Samples may lie in faces and on edges, and not only at points of the mesh.
        projection_tolerance : float, optional
            As for `distance`.
        as_polydata : bool, optional
            Return the points as vtkPolyData, with the arrays of vtkGeodesicSampler.

        Returns
        -------
        Samples or vtkPolyData

        Raises
        ------
        ValueError, Error
            As for `distance`.
        """
        result = self._samples(
            number_of_samples, first, start, covering_radius, in_faces, projection_tolerance
        )
        if as_polydata:
            return self._polydata(result)
        return Samples(
            points=result.points,
            **surface_points_of(result.point_data),
            covering_radii=result.point_data["CoveringRadius"],
        )

    @arguments.with_flags
    def voronoi(
        self,
        sites: SurfacePointsLike,
        *,
        iterations: int = 0,
        projection_tolerance: Optional[float] = None,
        as_polydata: bool = False,
    ) -> Union[Voronoi, vtkPolyData]:
        """Voronoi cells: the nearest of some sites for each point, and the areas of the cells. On
        triangles that are large for the accuracy, cells and areas are exact.

        Parameters
        ----------
        sites : surface points
            As for `distance`.
        iterations : int, optional
            Largest number of times that sites move to the centers of their cells. Default: 0.
        projection_tolerance : float, optional
            As for `distance`.
        as_polydata : bool, optional
            Return a vtkPolyData: the surface, cut along the borders of cells, with the cell array
            "SiteId"; for a cloud the cloud with the point array "GeodesicSource".

        Returns
        -------
        Voronoi or vtkPolyData

        Raises
        ------
        ValueError, Error
            As for `distance`.
        """
        surface, _, cells, moved = self._divide(sites, iterations, projection_tolerance)
        if as_polydata:
            return self._polydata(surface if self.is_cloud else cells)
        return voronoi_of(surface, moved)

    def _samples(
        self, count, first, start=None, radius=0.0, in_faces=False, projection_tolerance=None
    ):
        """Returns samples as a result of the kernel."""
        return self._call(
            _kernel.samples,
            self._graph,
            None if start is None else self._points(start, "start").in_kernel(),
            number_of_samples=arguments.integer(count, "number_of_samples"),
            first_sample=arguments.point_id(first, "first", self.number_of_points),
            covering_radius=arguments.number(radius, "covering_radius"),
            in_faces=in_faces,
            projection_tolerance=projection_tolerance,
        )

    def _divide(self, sites, iterations, projection_tolerance):
        """Returns the four results of the kernel: surface, borders, cells and moved sites."""
        iterations = arguments.integer(iterations, "iterations")
        return self._call(
            _kernel.voronoi,
            self._graph,
            self._points(sites, "sites").in_kernel(),
            centroidal=iterations != 0,
            number_of_iterations=iterations,
            projection_tolerance=projection_tolerance,
        )

    def _distance(
        self, sources, maximum_distance, initial_distances, projection_tolerance, **options
    ):
        """Returns the distances as a result of the kernel."""
        sources = self._points(sources, "sources")
        options.update(
            field_options(sources, maximum_distance, initial_distances, projection_tolerance)
        )
        return self._call(self._graph.distance, sources.in_kernel(), **options)

    def _path(self, start, end, straighten=True, detour=None, projection_tolerance=None):
        """Returns the path between two points as a result of the kernel."""
        ends = (
            arguments.surface_point(value, name, self._surface, self.is_cloud)
            for value, name in ((start, "start"), (end, "end"))
        )
        return self._find_paths(*ends, straighten, detour, projection_tolerance)

    def _find_paths(self, starts, ends, straighten, detour, tolerance):
        """Returns the paths between `SurfacePoints` as a result of the kernel."""
        detour = 1e-4 if detour is None else arguments.number(detour, "detour")
        if not 0.0 <= detour <= 0.1:
            raise ValueError(f"detour: expected a number in [0, 0.1], got {detour}")
        return find(
            self._graph,
            starts,
            ends,
            self._issued,
            straighten=straighten,
            detour=detour,
            memory_limit=self._memory_limit,
            projection_tolerance=tolerance,
        )
