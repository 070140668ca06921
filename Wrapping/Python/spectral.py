# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Functions based on the Laplacian of a surface: Green's functions, smooth distances, transport,
interpolation."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Optional, Union

import numpy as np

from . import _kernel, arguments, meshes
from .errors import call
from .graph_info import merging
from .results import EarthMovers

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray
    from vtkmodules.vtkCommonDataModel import vtkPolyData

    from .arguments import SurfacePointsLike

__all__ = ["biharmonic", "earth_movers", "greens_function", "interpolate"]


@arguments.with_flags
def greens_function(
    points: Any,
    triangles: Optional[ArrayLike] = None,
    sources: Optional[SurfacePointsLike] = None,
    *,
    order: int = 1,
    method: str = "SingularitySubtraction",
    boundary: str = "Neumann",
    at: Optional[SurfacePointsLike] = None,
    merge_coincident_points: bool = False,
    merge_tolerance: float = 0.0,
    projection_tolerance: Optional[float] = None,
    as_polydata: bool = False,
) -> Union[NDArray[np.float64], vtkPolyData]:
    """Green's functions of the Laplacian: ``greens_function(points, triangles, sources)`` or
    ``greens_function(mesh, sources)``.

    Parameters
    ----------
    points, triangles : array_like, shapes (n, 3) and (m, 3), or one mesh
        As for `distance`.
    sources : surface points
        As for `distance`.
    order : {1, 2}, optional
        1 for the Laplacian, 2 for the bi-Laplacian. Default: 1.
    method : {"SingularitySubtraction", "Localized", "Interpolated", "Vertex"}, optional
        See vtkDiscreteGreensFunction.
    boundary : {"Neumann", "Dirichlet"}, optional
        Condition at the boundary: no flow through it, or the value 0. Default: "Neumann".
    at : surface points, optional
        Points on the surface where the function is evaluated. Default: the points of the mesh.
    merge_coincident_points, merge_tolerance, projection_tolerance
        As for `distance`.
    as_polydata : bool, optional
        Return the surface, or the points of `at`, with the point array "GreensFunction".

    Returns
    -------
    numpy.ndarray of float64, shape (n, k) or (p, k), or vtkPolyData
        Numbers without a unit for order 1, areas for order 2, positive at the sources; one column
        for each source. The shape is (n,) or (p,) for one source.

    Raises
    ------
    ValueError, Error
        As for `distance`.

    See Also
    --------
    vtkDiscreteGreensFunction : a filter with further options.

    References
    ----------
    Y. Lipman, R. M. Rustamov, T. A. Funkhouser, "Biharmonic distance", ACM Trans. Graph. 29(3),
    2010, section 3 ("Vertex"); Z. Fang, "Discrete geodesic graphs", PhD thesis, Nanyang
    Technological University, 2019, chapter 4 ("Localized").

    Examples
    --------
    >>> g = vtkdgg.greens_function(mesh, [0, 10])
    >>> g.shape
    (642, 2)
    """
    options = {"order": _ORDERS[_order(order)], "method": method, "boundary": boundary}
    surface, (sources,) = meshes.take(points, triangles, sources=sources)
    sources = arguments.surface_points(sources, "sources", surface)
    how = merge_coincident_points, merge_tolerance, projection_tolerance
    found = _solve(_kernel.greens_function, surface, sources, at, how, **options)
    return found.answer("GreensFunction", as_polydata)


@arguments.with_flags
def biharmonic(
    points: Any,
    triangles: Optional[ArrayLike] = None,
    sources: Optional[SurfacePointsLike] = None,
    *,
    kind: str = "Biharmonic",
    method: str = "Spectrum",
    number_of_eigenvalues: Optional[int] = None,
    diffusion_time: Optional[float] = None,
    boundary: str = "Neumann",
    at: Optional[SurfacePointsLike] = None,
    unreached: float = np.nan,
    merge_coincident_points: bool = False,
    merge_tolerance: float = 0.0,
    projection_tolerance: Optional[float] = None,
    as_polydata: bool = False,
) -> Union[NDArray[np.float64], vtkPolyData]:
    """Smooth distances by the Laplacian: ``biharmonic(points, triangles, sources)`` or
    ``biharmonic(mesh, sources)``.

    Parameters
    ----------
    points, triangles : array_like, shapes (n, 3) and (m, 3), or one mesh
        As for `distance`.
    sources : surface points
        As for `distance`.
    kind : {"Biharmonic", "CommuteTime", "Diffusion"}, optional
        The kind of distance. Default: "Biharmonic".
    method : {"Spectrum", "Exact"}, optional
        Use the smallest eigenvalues of the Laplacian, or all. Default: "Spectrum".
    number_of_eigenvalues : int, optional
        Number of eigenvalues of each component for "Spectrum". Default: 150.
    diffusion_time : float, optional
        Time of diffusion, a length squared. Default: a tenth of the inverse of the first eigenvalue
        of the component.
    boundary : {"Neumann", "Dirichlet"}, optional
        As for `greens_function`.
    at : surface points, optional
        As for `greens_function`.
    unreached : float, optional
        Value at points of components without a source. Default: NaN.
    merge_coincident_points, merge_tolerance, projection_tolerance
        As for `distance`.
    as_polydata : bool, optional
        Return the surface, or the points of `at`, with the point array "BiharmonicDistance".

    Returns
    -------
    numpy.ndarray of float64, shape (n, k) or (p, k), or vtkPolyData
        Biharmonic distances in the unit of the points, commute-time distances without a unit,
        diffusion distances in the inverse unit; one column for each source. The shape is (n,) or
        (p,) for one source.

    Raises
    ------
    ValueError, Error
        As for `distance`.

    See Also
    --------
    vtkBiharmonicDistance : a filter with further options.

    References
    ----------
    Y. Lipman, R. M. Rustamov, T. A. Funkhouser, "Biharmonic distance", ACM Trans. Graph. 29(3),
    2010, sections 3 and 4; R. R. Coifman, S. Lafon, "Diffusion maps", Appl. Comput. Harmon.
    Anal. 21, 2006.

    Examples
    --------
    >>> d = vtkdgg.biharmonic(mesh, 0)
    >>> d.shape
    (642,)
    """
    options = {
        "kind": kind,
        "method": method,
        "boundary": boundary,
        "unreached_value": unreached,
        "number_of_eigenvalues": number_of_eigenvalues,
        "diffusion_time": diffusion_time,
    }
    surface, (sources,) = meshes.take(points, triangles, sources=sources)
    sources = arguments.surface_points(sources, "sources", surface)
    how = merge_coincident_points, merge_tolerance, projection_tolerance
    found = _solve(_kernel.biharmonic_distance, surface, sources, at, how, **options)
    return found.answer("BiharmonicDistance", as_polydata)


@arguments.with_flags
def earth_movers(
    points: Any,
    triangles: Optional[ArrayLike] = None,
    start: Optional[SurfacePointsLike] = None,
    end: Optional[SurfacePointsLike] = None,
    *,
    density: bool = True,
    normalize: bool = True,
    tolerance: Optional[float] = None,
    merge_coincident_points: bool = False,
    merge_tolerance: float = 0.0,
    projection_tolerance: Optional[float] = None,
    as_polydata: bool = False,
) -> Union[EarthMovers, vtkPolyData]:
    """The least cost of moving mass within a surface:
    ``earth_movers(points, triangles, start, end)`` or ``earth_movers(mesh, start, end)``.

    Parameters
    ----------
    points, triangles : array_like, shapes (n, 3) and (m, 3), or one mesh
        As for `distance`.
    start, end : array_like of float, shape (n,), or surface points
        Initial and final distribution: a number for each point, or surface points with the mass 1
        each.
    density : bool, optional
        True if numbers of points are mass per area, false if they are masses. Default: True.
    normalize : bool, optional
        Scale both distributions to the mass 1; otherwise their masses have to be equal. Default:
        True.
    tolerance : float, optional
        Largest difference of cost and lower bound, relative to the cost. Default: 0.01.
    merge_coincident_points, merge_tolerance, projection_tolerance
        As for `distance`.
    as_polydata : bool, optional
        Return the surface with the arrays of vtkSurfaceEarthMoversDistance.

    Returns
    -------
    EarthMovers or vtkPolyData

    Raises
    ------
    ValueError, Error
        As for `distance`; a ValueError for three numbers on a mesh of three points, which may be
        masses or coordinates.

    See Also
    --------
    vtkSurfaceEarthMoversDistance : a filter with further options.

    References
    ----------
    J. Solomon, R. Rustamov, L. Guibas, A. Butscher, "Earth mover's distances on discrete surfaces",
    ACM Trans. Graph. 33(4), 2014, section 4.

    Examples
    --------
    >>> vtkdgg.earth_movers(mesh, 0, 20).lower_bound <= vtkdgg.path(mesh, 0, 20).length
    True
    """
    surface, (start, end) = meshes.take(points, triangles, start=start, end=end)
    options = {
        **_distribution(surface, start, "start", "from"),
        **_distribution(surface, end, "end", "to"),
        "array_meaning": "Density" if density else "Mass",
        "normalize": normalize,
        "projection_tolerance": projection_tolerance,
        "tolerance": tolerance,
    }
    prepared = surface.prepared(*merging(merge_coincident_points, merge_tolerance))
    result = call(_kernel.earth_movers_distance, prepared, **options)
    if as_polydata:
        return surface.polydata(result)
    return EarthMovers(
        distance=result.distance,
        lower_bound=result.lower_bound,
        potential=result.point_data["EarthMoversPotential"],
        flow=result.cell_data["EarthMoversFlow"],
    )


@arguments.with_flags
def interpolate(
    points: Any,
    triangles: Optional[ArrayLike] = None,
    sites: Optional[SurfacePointsLike] = None,
    values: Optional[ArrayLike] = None,
    *,
    order: int = 2,
    boundary: str = "Neumann",
    at: Optional[SurfacePointsLike] = None,
    merge_coincident_points: bool = False,
    merge_tolerance: float = 0.0,
    projection_tolerance: Optional[float] = None,
    as_polydata: bool = False,
) -> Union[NDArray[np.float64], vtkPolyData]:
    """A smooth function with given values at some surface points:
    ``interpolate(points, triangles, sites, values)`` or ``interpolate(mesh, sites, values)``.

    Parameters
    ----------
    points, triangles : array_like, shapes (n, 3) and (m, 3), or one mesh
        As for `distance`.
    sites : surface points
        Positions of the values, as the sources of `distance`. With order 1 they move to the nearest
        corner of their triangle.
    values : array_like of float, shape (k,) or (k, c)
        One number for each site, or several.
    order : {1, 2}, optional
        Order of the splines: 2 for biharmonic splines, which are smooth, 1 for harmonic splines,
        which have bumps at the sites. Default: 2.
    boundary : {"Neumann", "Dirichlet"}, optional
        Condition at the boundary: no flow through it, or the value 0. Default: "Neumann".
    at : surface points, optional
        As for `greens_function`.
    merge_coincident_points, merge_tolerance, projection_tolerance
        As for `distance`.
    as_polydata : bool, optional
        Return the surface, or the points of `at`, with the point array "Interpolation".

    Returns
    -------
    numpy.ndarray of float64, shape (n,), (n, c), (p,) or (p, c), or vtkPolyData
        In the unit of the values. One column of values gives shape (n,) or (p,).

    Raises
    ------
    ValueError, Error
        As for `distance`; also if there is not one value for each site, for two sites at the same
        position, and for components without a site.

    See Also
    --------
    vtkHarmonicBSpline : a filter with further options.

    References
    ----------
    P. Feng, J. Warren, "Discrete bi-Laplacians and biharmonic b-splines", ACM Trans. Graph. 31(4),
    2012; G. Wahba, "Spline interpolation and smoothing on the sphere", SIAM J. Sci. Stat. Comput.
    2(1), 1981.

    Examples
    --------
    >>> t = vtkdgg.interpolate(mesh, [0, 10, 20], [15.0, 20.0, 18.0])
    >>> t.shape
    (642,)
    """
    options = {
        "order": ("Harmonic", "Biharmonic")[_order(order) - 1],
        "boundary": boundary,
    }
    surface, (sites, values) = meshes.take(points, triangles, sites=sites, values=values)
    sites = arguments.surface_points(sites, "sites", surface)
    numbers = np.asarray(arguments.numbers(values, "values"), dtype=np.float64)
    numbers = numbers.reshape(1) if numbers.ndim == 0 else numbers
    if numbers.ndim > 2 or len(numbers) != len(sites) or numbers.size == 0:
        raise ValueError(
            f"values: expected one row for each of {len(sites)} sites, got shape {numbers.shape}"
        )
    how = merge_coincident_points, merge_tolerance, projection_tolerance
    options.update(point_values=numbers, generate_basis=False)
    found = _solve(_kernel.harmonic_spline, surface, sites.by_position(), at, how, **options)
    return found.answer("Interpolation", as_polydata)


_ORDERS = {1: "Laplace", 2: "BiLaplace"}


def _order(value):
    if isinstance(value, bool) or value not in (1, 2):
        raise ValueError(f"order: expected 1 or 2, got {value!r}")
    return int(value)


class _Solution:
    """Results of the kernel on a surface, and at further points if there are any."""

    def __init__(self, surface, results, at):
        self._surface = surface
        self._on_surface, self._at_points = results
        self._at = at

    def answer(self, name, as_polydata):
        """Returns the array with this name, or the surface or points that have it."""
        result = self._on_surface if self._at is None else self._at_points
        if not as_polydata:
            return result.point_data[name]
        if self._at is None:
            return self._surface.polydata(result)
        return self._at.polydata(result)


def _solve(function, surface, sources, at, how, **options):
    """Applies a function of the kernel to `SurfacePoints`. `how` has the arguments that all
    functions have in common."""
    is_merged, merge_tolerance, projection_tolerance = how
    if at is not None:
        at = arguments.surface_points(at, "at", surface)
        options["evaluation"] = at.in_kernel()
    prepared = surface.prepared(*merging(is_merged, merge_tolerance))
    options["projection_tolerance"] = projection_tolerance
    sources = sources if isinstance(sources, dict) else sources.in_kernel()
    return _Solution(surface, call(function, prepared, sources, **options), at)


def _distribution(surface, values, name, role):
    """Returns the options of a distribution: numbers of all points, or surface points."""
    count = surface.number_of_points
    array = None if arguments.is_mixed(values) else arguments.numbers(values, name)
    if array is not None and array.dtype.kind == "f" and array.shape == (count,):
        if count == 3:
            raise ValueError(f"{name}: three numbers may be masses of the points or coordinates")
        if not np.isfinite(array).all():
            raise ValueError(f"{name}: entry {int(np.argmin(np.isfinite(array)))} is not finite")
        return {f"{role}_values": array}
    return {f"{role}_points": arguments.surface_points(values, name, surface).in_kernel()}
