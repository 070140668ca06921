# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Smooth colors on a surface from curves and regions."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Optional, Union

import numpy as np

from . import _kernel, arguments, meshes
from .checks import counted
from .errors import call
from .graph_info import merging
from .mesh import Mesh

if TYPE_CHECKING:
    from numpy.typing import ArrayLike
    from vtkmodules.vtkCommonDataModel import vtkPolyData

__all__ = ["vector_graphics"]

# Largest refinement level.
MAXIMUM_LEVEL = 8
# Names of cell arrays.
_REGION, _STRENGTH, _REFINE = "Region", "RegionStrength", "Refine"


@arguments.with_flags
def vector_graphics(
    points: Any,
    triangles: Optional[ArrayLike] = None,
    curves: Any = None,
    *,
    regions: Optional[ArrayLike] = None,
    region_strengths: Optional[ArrayLike] = None,
    width: Optional[float] = None,
    background_color: ArrayLike = 0.0,
    refinement_level: int = 1,
    refinement_region: Union[str, ArrayLike] = "Everywhere",
    merge_coincident_points: bool = False,
    merge_tolerance: float = 0.0,
    projection_tolerance: Optional[float] = None,
    as_polydata: bool = False,
) -> Union[Mesh, vtkPolyData]:
    """Smooth colors on a surface from few curves and regions (Poisson vector graphics):
    ``vector_graphics(points, triangles, curves)`` or ``vector_graphics(mesh, curves)``.

    Parameters
    ----------
    points, triangles : array_like, shapes (n, 3) and (m, 3), or one mesh
        As for `distance`.
    curves : Mesh, file name or vtkPolyData, optional
        Each line is a curve. Its points are moved to the surface and joined by exact geodesics; it
        is closed if its last id is its first. Arrays per line, or except "CurveType" per point,
        with one column for each channel, define the colors. Left is as seen from the side from
        which triangles are counter-clockwise.

        "CurveType"
            0 for diffusion curves (default), 1 for Poisson curves, 2 for the rims of regions, 3 for
            sources. See vtkPoissonVectorGraphics.
        "LeftColor", "RightColor"
            Of diffusion curves, from 0 to 1, or 0 to 255 as numpy.uint8.
        "Strength", "RightStrength"
            Of the other types, in the unit of colors; one column applies to all channels.
        "Width"
            Distance from a Poisson curve at which its effect ends, in the unit of the points.
    regions : array_like of int, shape (number of cells,), optional
        Cells with the same number other than 0 are a region, which becomes brighter.
    region_strengths : array_like of float, one row for each cell, optional
        Strength of a region at its first cell. Required with `regions`.
    width : float, optional
        Width of Poisson curves without the array "Width". Default: 5 % of the diagonal of the
        bounding box of the surface.
    background_color : array_like of float, shape (3,), or float, optional
        Mean color of components without a diffusion curve. Default: 0.
    refinement_level : int, optional
        Number of times that triangles are split into four, in [0, 8]. Default: 1.
    refinement_region : {"Everywhere", "NearCurves"} or array_like, optional
        Triangles that are refined: all, those that touch a curve and one ring for each further
        level, or those of the cells whose entry in the array is not 0. Default: "Everywhere".
    merge_coincident_points, merge_tolerance, projection_tolerance
        As for `distance`.
    as_polydata : bool, optional
        Return a vtkPolyData, with the arrays of the surface as well.

    Returns
    -------
    Mesh or vtkPolyData
        The surface as triangles, refined and cut along diffusion and Poisson curves. Point data:
        "Colors" (float64, one column for each channel); with three or more channels "RGB" (uint8);
        "Component" (int64). Field data: "NetSource", the sum of sources in each component that no
        diffusion curve absorbs.

    Raises
    ------
    ValueError, Error
        As for `distance`; also for neither a line nor a region, a line of fewer than two different
        points, and arrays that are missing, not finite or of a wrong size.

    See Also
    --------
    vtkPoissonVectorGraphics : a filter with further options.

    References
    ----------
    F. Hou et al., "Poisson vector graphics (PVG)", IEEE Trans. Vis. Comput. Graph. 26(2), 2020;
    A. Orzan et al., "Diffusion curves", ACM Trans. Graph. 27(3), 2008.

    Examples
    --------
    >>> curves = vtkdgg.Mesh(
    ...     mesh.points[[0, 10]],
    ...     lines=([0, 2], [0, 1]),
    ...     cell_data={"LeftColor": [[1.0, 0.0, 0.0]], "RightColor": [[0.0, 0.0, 1.0]]},
    ... )
    >>> colored = vtkdgg.vector_graphics(mesh, curves, refinement_level=0)
    >>> colored.point_data["RGB"].shape
    (670, 3)
    """
    surface, (curves,) = meshes.take(points, triangles, optional=("curves",), curves=curves)
    cell_data = dict(surface.data.cell_data)
    level = arguments.integer(refinement_level, "refinement_level")
    if not 0 <= level <= MAXIMUM_LEVEL:
        raise ValueError(f"refinement_level: expected 0 to {MAXIMUM_LEVEL}, got {level}")
    options = {
        "refinement_level": level,
        "background_color": arguments.finite_numbers(background_color, "background_color", 3),
        "projection_tolerance": projection_tolerance,
    }
    if width is not None:
        options["width"] = width
    if regions is None and region_strengths is not None:
        raise ValueError("regions: missing; `region_strengths` need regions")
    if regions is not None:
        options["region_array_name"] = _REGION
        cell_data[_REGION] = _per_cell(surface, regions, "regions", "integer")
        if region_strengths is None:
            raise ValueError("region_strengths: missing; `regions` need a strength each")
        cell_data[_STRENGTH] = _per_cell(surface, region_strengths, "region_strengths")
    options["refinement_region"] = refinement_region
    if isinstance(refinement_region, str) and refinement_region == "Cells":
        raise ValueError("refinement_region: pass one number for each cell instead of 'Cells'")
    if not isinstance(refinement_region, str):
        options["refinement_region"] = "Cells"
        cell_data[_REFINE] = _per_cell(surface, refinement_region, "refinement_region")
    prepared = surface.prepared(*merging(merge_coincident_points, merge_tolerance))
    drawing = None if curves is None else _drawing(curves)
    result, _ = call(_kernel.vector_graphics, prepared, drawing, cell_data, **options)
    return surface.polydata(result) if as_polydata else surface.mesh(result)


def _per_cell(surface, values, name, kind="number"):
    """Returns an array of numbers with a row for each cell."""
    array = np.asarray(values)
    array = arguments.numbers(array.astype(int) if array.dtype == bool else array, name, kind)
    has_one = array.ndim < 2 or array.shape[1] == 1 or kind == "number"
    if not has_one or len(np.atleast_1d(array)) != surface.number_of_cells:
        cells = counted(surface.number_of_cells, "row")
        raise ValueError(f"{name}: expected {cells}, one for each cell, got shape {array.shape}")
    return array


def _drawing(curves):
    """Returns the lines of a mesh and their arrays, as functions of the kernel take them."""
    found = meshes.opened(curves)
    if not (isinstance(found, Mesh) or meshes.is_vtk(found, "vtkPolyData")):
        kind = type(curves).__name__
        raise ValueError(
            f"curves: expected a Mesh, a file name or a vtkPolyData with lines, got a {kind}"
        )
    data = meshes.take(found)[0].data
    for name, values in {**data.point_data, **data.cell_data}.items():
        if np.asarray(values).dtype == bool and name.endswith("Color"):
            raise ValueError(f"curves: the array {name!r} has the type bool; expected numbers")
    first = len(data.cells["verts"][0]) - 1  # arrays of cells begin with verts
    lines = slice(first, first + len(data.cells["lines"][0]) - 1)
    return {
        "points": data.points,
        "lines": data.cells["lines"],
        "point_data": data.point_data,
        "cell_data": {name: values[lines] for name, values in data.cell_data.items()},
    }
