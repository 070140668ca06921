# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Functions based on the Laplacian of a surface: Green's functions, smooth distances, transport,
interpolation."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Optional, Union

import numpy as np

from . import arguments, meshes
from .errors import run
from .graph_info import set_up
from .results import EarthMovers, array_of
from .surface import add_array
from .vtkDGGFiltersSpectral import (
    vtkBiharmonicDistance,
    vtkDiscreteGreensFunction,
    vtkHarmonicBSpline,
    vtkSurfaceEarthMoversDistance,
)

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray
    from vtkmodules.vtkCommonDataModel import vtkPolyData

    from .arguments import SurfacePointsLike

__all__ = ["biharmonic", "earth_movers", "greens_function", "interpolate"]


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
    ValueError, VTKError
        As for `distance`.

    See Also
    --------
    vtkDiscreteGreensFunction : the filter that does the work, with further options.

    Examples
    --------
    >>> g = vtkdgg.greens_function(mesh, [0, 10])
    >>> g.shape
    (642, 2)
    """
    surface, (sources,) = meshes.take(points, triangles, sources=sources)
    solve = vtkDiscreteGreensFunction()
    solve.SetOrder(_order(order))
    solve.SetMethod(_choice(solve, method, "method"))
    solve.SetBoundary(_choice(solve, boundary, "boundary"))
    set_up(solve, surface, merge_coincident_points, merge_tolerance, projection_tolerance)
    return _solve(solve, surface, sources, at, as_polydata)


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
    ValueError, VTKError
        As for `distance`.

    See Also
    --------
    vtkBiharmonicDistance : the filter that does the work.

    Examples
    --------
    >>> d = vtkdgg.biharmonic(mesh, 0)
    >>> d.shape
    (642,)
    """
    surface, (sources,) = meshes.take(points, triangles, sources=sources)
    solve = vtkBiharmonicDistance()
    solve.SetKind(_choice(solve, kind, "kind"))
    solve.SetMethod(_choice(solve, method, "method"))
    if number_of_eigenvalues is not None:
        solve.SetNumberOfEigenvalues(
            arguments.integer(number_of_eigenvalues, "number_of_eigenvalues")
        )
    if diffusion_time is not None:
        solve.SetDiffusionTime(arguments.number(diffusion_time, "diffusion_time"))
    solve.SetBoundary(_choice(solve, boundary, "boundary"))
    solve.SetUnreachedValue(arguments.number(unreached, "unreached"))
    set_up(solve, surface, merge_coincident_points, merge_tolerance, projection_tolerance)
    return _solve(solve, surface, sources, at, as_polydata)


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
    ValueError, VTKError
        As for `distance`; a ValueError for three numbers on a mesh of three points, which may be
        masses or coordinates.

    See Also
    --------
    vtkSurfaceEarthMoversDistance : the filter that does the work, with further options.

    Examples
    --------
    >>> vtkdgg.earth_movers(mesh, 0, 20).lower_bound <= vtkdgg.path(mesh, 0, 20).length
    True
    """
    surface, (start, end) = meshes.take(points, triangles, start=start, end=end)
    move = vtkSurfaceEarthMoversDistance()
    _set_distribution(surface, start, "start", move.SetFromArrayName, move.SetFromData)
    _set_distribution(surface, end, "end", move.SetToArrayName, move.SetToData)
    move.SetArrayMeaning(move.Density if density else move.Mass)
    move.SetNormalize(bool(normalize))
    if tolerance is not None:
        move.SetTolerance(arguments.limit(tolerance, "tolerance"))
    set_up(move, surface, merge_coincident_points, merge_tolerance, projection_tolerance)
    output = run(move)
    if as_polydata:
        return output
    return EarthMovers(
        distance=move.GetDistance(),
        lower_bound=move.GetLowerBound(),
        potential=array_of(output.GetPointData(), "EarthMoversPotential"),
        flow=array_of(output.GetCellData(), "EarthMoversFlow"),
    )


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
    ValueError, VTKError
        As for `distance`; also if there is not one value for each site, for two sites at the same
        position, and for components without a site.

    See Also
    --------
    vtkHarmonicBSpline : the filter that does the work, with further options.

    Examples
    --------
    >>> t = vtkdgg.interpolate(mesh, [0, 10, 20], [15.0, 20.0, 18.0])
    >>> t.shape
    (642,)
    """
    surface, (sites, values) = meshes.take(points, triangles, sites=sites, values=values)
    spline = vtkHarmonicBSpline()
    spline.SetOrder(_order(order))
    spline.SetBoundary(_choice(spline, boundary, "boundary"))
    spline.SetSiteValuesArrayName(_SITE_VALUES)
    spline.GenerateBasisOff()
    set_up(spline, surface, merge_coincident_points, merge_tolerance, projection_tolerance)
    sites = arguments.surface_points(sites, "sites", surface)
    numbers = np.asarray(arguments.numbers(values, "values"), dtype=np.float64)
    numbers = numbers.reshape(1) if numbers.ndim == 0 else numbers
    if numbers.ndim > 2 or len(numbers) != len(sites) or numbers.size == 0:
        raise ValueError(
            f"values: expected one row for each of {len(sites)} sites, got shape {numbers.shape}"
        )
    data = sites.polydata()
    add_array(data.GetPointData(), _SITE_VALUES, numbers)
    spline.SetSourceData(data)
    output = _evaluate(spline, at)
    output.GetPointData().RemoveArray(_SITE_VALUES)
    if as_polydata:
        return output
    return array_of(output.GetPointData(), "Interpolation")


#: Name of the point array with the values of sites.
_SITE_VALUES = "vtkdgg site values"


def _order(value):
    if isinstance(value, bool) or value not in (1, 2):
        raise ValueError(f"order: expected 1 or 2, got {value!r}")
    return int(value)


def _choice(algorithm, value, name):
    """Returns the number of a choice by its name in an enumeration of the class."""
    kind = getattr(type(algorithm), f"{name.capitalize()}Type")
    known = {
        key: number
        for base in type(algorithm).__mro__
        for key, number in vars(base).items()
        if isinstance(number, kind)
    }
    if value not in known:
        raise ValueError(f"{name}: expected one of {', '.join(known)}, got {value!r}")
    return known[value]


def _solve(solve, surface, sources, at, as_polydata):
    sources = arguments.surface_points(sources, "sources", surface)
    arguments.set_points(solve, "Source", sources)
    output = _evaluate(solve, at)
    if as_polydata:
        return output
    return array_of(output.GetPointData(), solve.GetResultArrayName())


def _evaluate(solve, at):
    """Returns the surface, or the points of `at`, with the results."""
    if at is not None:
        at = arguments.surface_points(at, "at", solve.GetInput())
        solve.SetEvaluationData(at.polydata())
    run(solve)
    return solve.GetOutput() if at is None else solve.GetEvaluation()


def _set_distribution(surface, values, name, set_array, set_points):
    """Sets a distribution: numbers of all points as an array, surface points as points."""
    count = surface.GetNumberOfPoints()
    array = None if arguments.is_mixed(values) else arguments.numbers(values, name)
    if array is not None and array.dtype.kind == "f" and array.shape == (count,):
        if count == 3:
            raise ValueError(f"{name}: three numbers may be masses of the points or coordinates")
        if not np.isfinite(array).all():
            raise ValueError(f"{name}: entry {int(np.argmin(np.isfinite(array)))} is not finite")
        add_array(surface.GetPointData(), name, array.astype(np.float64))
        set_array(name)
        return
    set_points(arguments.surface_points(values, name, surface).polydata())
