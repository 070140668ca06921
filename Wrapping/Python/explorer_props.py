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
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkCellPicker,
    vtkPointPicker,
    vtkPolyDataMapper,
)

from .commands.cloud_pictures import make_bands
from .commands.sizes import spacing_of
from .pictures import (
    DISC_RADIUS,
    DISTANCE_COLORS,
    ERROR_COLORS,
    INK,
    UNREACHED_DISTANCE,
    UNREACHED_ERROR,
    discs,
    labels,
    lookup_table,
    scalar_bar,
    shaded,
    unreached,
)
from .surface import add_array

# Lightness of the cells of sources, in turns.
LIGHTNESS = (0.95, 0.80)


class Skin:
    """A surface, colored by values of its points or of cells that replace it."""

    def __init__(self, surface, locator):
        numbered = vtkPolyData()
        numbered.CopyStructure(surface)
        add_array(numbered.GetPointData(), "Id", np.arange(surface.GetNumberOfPoints()))
        self._points = shaded(numbered)
        self._ids = np.array(vtk_to_numpy(self._points.GetPointData().GetArray("Id")))
        self._mapper = vtkPolyDataMapper()
        self._mapper.SetInputData(self._points)
        self._mapper.ScalarVisibilityOff()
        # Lines are drawn in front of the surface.
        self._mapper.SetResolveCoincidentTopologyToPolygonOffset()
        self._mapper.SetRelativeCoincidentTopologyPolygonOffsetParameters(2.0, 60.0)
        self._cells = None
        self.actor = vtkActor()
        self.actor.SetMapper(self._mapper)
        look = self.actor.GetProperty()
        look.SetColor(*UNREACHED_DISTANCE)
        look.SetInterpolationToPhong()
        look.SetAmbient(0.10)
        look.SetDiffuse(0.90)
        look.SetSpecular(0.12)
        look.SetSpecularPower(25.0)

        self._body = vtkActor()  # what is picked, whatever is drawn
        self._body.SetMapper(vtkPolyDataMapper())
        self._body.GetMapper().SetInputData(surface)
        self._picker = vtkCellPicker()
        self._picker.PickFromListOn()
        self._picker.AddPickList(self._body)
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
                self._cells, self._shaded_cells = cells, shaded(cells)
            mapper.SetInputData(self._shaded_cells)
            mapper.SetScalarModeToUseCellData()
        if table:
            mapper.SetLookupTable(table)
            mapper.UseLookupTableScalarRangeOn()
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
        self.spacing = spacing_of(cloud)
        plain = lookup_table((UNREACHED_DISTANCE,) * 2, 0.0, 1.0, UNREACHED_DISTANCE)
        radii = np.full(self._count, DISC_RADIUS * self.spacing)
        self.actor = discs(cloud, radii, np.zeros(self._count), plain)
        self._plain = plain
        dots = vtkVertexGlyphFilter()  # points without cells have no bounds for pickers
        dots.SetInputData(cloud)
        self._body = vtkActor()
        self._body.SetMapper(vtkPolyDataMapper())
        self._body.GetMapper().SetInputConnection(dots.GetOutputPort())
        self._picker = vtkPointPicker()
        self._picker.SetTolerance(0.01)
        self._picker.PickFromListOn()
        self._picker.AddPickList(self._body)

    def show(self, values, cells, table, is_smooth):
        """Colors the cloud by values; None: in gray."""
        mapper = self.actor.GetMapper()
        array = mapper.GetInput().GetPointData().GetArray("Value")
        vtk_to_numpy(array)[:] = 0.0 if values is None else values
        array.Modified()
        table = table or self._plain
        mapper.SetLookupTable(table)
        mapper.SetScalarRange(*table.GetRange())
        mapper.GetInput().Modified()

    def pick(self, x, y, renderer):
        """Returns the id of the nearest point at a pixel, None without one."""
        found = self._picker.Pick(x, y, 0.0, renderer) and self._picker.GetPointId() >= 0
        return self._picker.GetPointId() if found else None


def lines_actor():
    """Returns an actor of lines on a surface, drawn in front of it."""
    mapper = vtkPolyDataMapper()
    mapper.ScalarVisibilityOff()
    mapper.SetResolveCoincidentTopologyToPolygonOffset()
    mapper.SetRelativeCoincidentTopologyLineOffsetParameters(-2.0, -60.0)
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(*INK)
    actor.GetProperty().SetLineWidth(1.5)
    actor.GetProperty().LightingOff()
    return actor


def table_of(scene):
    """Returns the colors of a scene."""
    low, high = scene.limits
    if scene.shown == "voronoi":
        table = vtkLookupTable()
        table.SetNumberOfTableValues(int(high) + 1)
        table.SetTableRange(low, high)
        for i in range(int(high) + 1):
            lightness = LIGHTNESS[i % len(LIGHTNESS)]
            table.SetTableValue(i, *hsv_to_rgb(0.618034 * i % 1.0, 0.45, lightness), 1.0)
        table.SetNanColor(*UNREACHED_DISTANCE, 1.0)
        return table
    if scene.shown == "error":
        table = lookup_table(ERROR_COLORS, low, high, UNREACHED_ERROR)
        table.SetScaleToLog10()
        return table
    colors = DISTANCE_COLORS if scene.shown == "distance" else DISTANCE_COLORS[::-1]
    table = lookup_table(colors, low, high, UNREACHED_DISTANCE)
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
        values = labels(low, high)
    bar = scalar_bar(table, title, values, "%-.4g", bottom=0.25)
    bar.SetMaximumNumberOfColors(table.GetNumberOfTableValues())  # bands as wide as they are
    return [bar, *unreached(bar, scene.values)]
