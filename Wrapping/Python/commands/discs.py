# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""A point cloud as discs: one at each point, along the surface, as large as the gaps around it."""

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersPoints import vtkPCANormalEstimation
from vtkmodules.vtkFiltersSources import vtkRegularPolygonSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkGlyph3DMapper

# Radius of discs, of the spacing there: neighbours overlap, so that there are no gaps between them.
RADIUS = 0.85
# How many times larger or smaller than the median a disc may be.
LARGER = 2.5


def spacings_of(graph):
    """How far points are from each other around each: the radii of the balls follow that."""
    radii = vtk_to_numpy(graph.GetOutput().GetFieldData().GetArray("DGG.Radii")).astype(float)
    median = float(np.median(radii[radii > 0.0])) if (radii > 0.0).any() else 1.0
    return radii * (graph.GetSpacing() / median)


def disc_radii(spacings):
    """Radii of discs that overlap."""
    spacing = float(np.median(spacings))
    return RADIUS * np.clip(spacings, spacing / LARGER, spacing * LARGER)


def discs(cloud, radii, values, table):
    """An actor of a disc at each point with this radius, coloured by its value."""
    # Which side the normals point to does not matter: discs are lit on both.
    estimate = vtkPCANormalEstimation()
    estimate.SetInputData(cloud)
    estimate.SetSampleSize(min(16, cloud.GetNumberOfPoints()))
    estimate.SetNormalOrientationToPoint()
    estimate.Update()
    oriented = vtkPolyData()
    oriented.ShallowCopy(estimate.GetOutput())
    for name, numbers in (("Value", values), ("Radius", radii)):
        array = numpy_to_vtk(numbers, deep=True)
        array.SetName(name)
        oriented.GetPointData().AddArray(array)

    disc = vtkRegularPolygonSource()
    disc.SetNumberOfSides(10)
    disc.SetRadius(1.0)
    disc.SetNormal(1.0, 0.0, 0.0)  # what glyphs turn into the direction of the normal
    disc.GeneratePolylineOff()
    mapper = vtkGlyph3DMapper()
    mapper.SetInputData(oriented)
    mapper.SetSourceConnection(disc.GetOutputPort())
    mapper.OrientOn()
    mapper.SetOrientationArray(oriented.GetPointData().GetNormals().GetName())
    mapper.SetOrientationModeToDirection()
    mapper.ScalingOn()
    mapper.SetScaleModeToScaleByMagnitude()
    mapper.SetScaleArray("Radius")
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectColorArray("Value")
    mapper.SetLookupTable(table)
    mapper.SetScalarRange(*table.GetRange())
    actor = vtkActor()
    actor.SetMapper(mapper)
    look = actor.GetProperty()
    look.SetInterpolationToFlat()
    look.SetAmbient(0.18)
    look.SetDiffuse(0.85)
    look.SetSpecular(0.1)
    look.SetSpecularPower(25.0)
    return actor
