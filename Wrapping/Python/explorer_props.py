# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""The parts of the explorer's window: the surface or cloud, lines, colors, text."""

from __future__ import annotations

from colorsys import hsv_to_rgb

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersGeneral import vtkVertexGlyphFilter
from vtkmodules.vtkRenderingCore import vtkCellPicker, vtkPointPicker

from . import _kernel, pictures
from .commands.cloud_pictures import make_bands
from .vtk_data import add_array, configured, coordinates_of, structure_of

# Lightness of the cells of sources, alternating.
LIGHTNESS = (0.95, 0.80)


class Skin:
    """A surface, colored by values of its points or of cells that replace it."""

    def __init__(self, surface, locator):
        numbered = structure_of(surface)
        add_array(numbered.GetPointData(), "Id", np.arange(surface.GetNumberOfPoints()))
        self._points = pictures.shaded(numbered)
        self._ids = np.array(vtk_to_numpy(self._points.GetPointData().GetArray("Id")))
        self.actor = pictures.actor_of(self._points, pictures.UNREACHED_DISTANCE)
        configured(self.actor.GetProperty(), **pictures.GLOSSY).SetInterpolationToPhong()
        self._mapper = self.actor.GetMapper()
        # Lines are drawn in front of the surface.
        self._mapper.SetResolveCoincidentTopologyToPolygonOffset()
        self._mapper.SetRelativeCoincidentTopologyPolygonOffsetParameters(2.0, 60.0)
        self._cells = None
        self._picker = _only(vtkCellPicker(), surface)
        self._picker.AddLocator(locator)

    def show(self, values, cells, table, is_smooth):
        """Colors the surface by values (None: in gray) or shows cells in its place."""
        mapper = self._mapper
        mapper.SetScalarVisibility(values is not None)
        if cells is None:
            mapper.SetInputData(self._points)
            if values is not None:
                self._points.GetPointData().SetScalars(numpy_to_vtk(values[self._ids], deep=True))
            mapper.SetScalarModeToUsePointData()
        else:
            if cells is not self._cells:
                self._cells, self._shaded_cells = cells, pictures.shaded(cells)
            mapper.SetInputData(self._shaded_cells)
            mapper.SetScalarModeToUseCellData()
        if table:
            configured(mapper, LookupTable=table, UseLookupTableScalarRange=True)
        mapper.SetInterpolateScalarsBeforeMapping(is_smooth and cells is None)

    def pick(self, x, y, renderer):
        """Returns the coordinates on the surface at a pixel, None beside the surface."""
        if not self._picker.Pick(x, y, 0.0, renderer):
            return None
        return np.array(self._picker.GetPickPosition())


class CloudSkin:
    """A cloud, drawn as discs."""

    def __init__(self, cloud):
        self._count = cloud.GetNumberOfPoints()
        self.spacing, _ = _kernel.cloud_size(coordinates_of(cloud))
        plain = pictures.lookup_table(
            (pictures.UNREACHED_DISTANCE,) * 2, 0.0, 1.0, pictures.UNREACHED_DISTANCE
        )
        radii = np.full(self._count, pictures.DISC_RADIUS * self.spacing)
        self.actor = pictures.discs(cloud, radii, np.zeros(self._count), plain)
        self._plain = plain
        # Points without cells have no bounds for pickers.
        dots = configured(vtkVertexGlyphFilter(), InputData=cloud)
        dots.Update()
        self._picker = _only(vtkPointPicker(), dots.GetOutput())
        self._picker.SetTolerance(0.01)

    def show(self, values, cells, table, is_smooth):
        """Colors the cloud by values; None: in gray."""
        mapper = self.actor.GetMapper()
        array = mapper.GetInput().GetPointData().GetArray("Value")
        vtk_to_numpy(array)[:] = 0.0 if values is None else values
        array.Modified()
        table = table or self._plain
        configured(mapper, LookupTable=table, ScalarRange=[*table.GetRange()])
        mapper.GetInput().Modified()

    def pick(self, x, y, renderer):
        """Returns the id of the nearest point at a pixel, None without one."""
        found = self._picker.Pick(x, y, 0.0, renderer) and self._picker.GetPointId() >= 0
        return self._picker.GetPointId() if found else None


def _only(picker, data):
    """Returns the picker, which picks only these data, whatever is drawn."""
    picker.PickFromListOn()
    picker.AddPickList(pictures.actor_of(data))
    return picker


def lines_actor():
    """Returns an actor of lines on a surface, drawn in front of it."""
    actor = pictures.actor_of(vtkPolyData(), pictures.INK)
    mapper = actor.GetMapper()
    mapper.SetResolveCoincidentTopologyToPolygonOffset()
    mapper.SetRelativeCoincidentTopologyLineOffsetParameters(-2.0, -60.0)
    configured(actor.GetProperty(), LineWidth=1.5, Lighting=False)
    return actor


def table_of(scene):
    """Returns the colors of a scene."""
    low, high = scene.limits
    if scene.shown == "voronoi":
        table = configured(vtkLookupTable(), NumberOfTableValues=int(high) + 1)
        table.SetTableRange(low, high)
        for i in range(int(high) + 1):
            lightness = LIGHTNESS[i % len(LIGHTNESS)]
            table.SetTableValue(i, *hsv_to_rgb(0.618034 * i % 1.0, 0.45, lightness), 1.0)
        table.SetNanColor(*pictures.UNREACHED_DISTANCE, 1.0)
        return table
    if scene.shown == "error":
        table = pictures.lookup_table(pictures.ERROR_COLORS, low, high, pictures.UNREACHED_ERROR)
        table.SetScaleToLog10()
        return table
    colors = (
        pictures.DISTANCE_COLORS if scene.shown == "distance" else pictures.DISTANCE_COLORS[::-1]
    )
    table = pictures.lookup_table(colors, low, high, pictures.UNREACHED_DISTANCE)
    make_bands(table, scene.step / (high - low))
    return table


def bar_of(scene, table):
    """Returns the actors of the legend; none for cells."""
    low, high = scene.limits
    if scene.shown == "voronoi":
        return []
    if scene.shown == "error":
        title, values = "Relative\nerror (%)", [high * 10.0**power for power in range(-3, 1)]
    else:
        title = "Green's\nfunction" if scene.shown == "greens" else "Geodesic\ndistance"
        values = pictures.labels(low, high)
    bar = pictures.scalar_bar(table, title, values, "%-.4g", bottom=0.25)
    bar.SetMaximumNumberOfColors(table.GetNumberOfTableValues())  # bands as wide as they are
    return [bar, *pictures.unreached(bar, scene.values)]
