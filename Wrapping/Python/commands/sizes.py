# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Lengths and areas of a mesh; spacing and components of a point cloud."""

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIdList
from vtkmodules.vtkCommonDataModel import vtkStaticPointLocator
from vtkmodules.vtkFiltersPoints import vtkConnectedPointsFilter

from ..surface import area_vectors, configured, coordinates_of, triangles_of

# Fraction of the mean edge length. Shorter distances consist of rounding errors and of the length
# that is added to triangles without area.
FLOOR = 1e-6
# Width of gaps that separate the components of a cloud, in spacings.
GAP = 5.0
# Largest median edge, as a fraction of the diagonal, without a remark: pictures interpolate
# distances linearly in triangles, which is inaccurate in large triangles.
LARGE = 0.05


def edge_lengths(mesh):
    """Returns the edge lengths of all triangles; shared edges are repeated."""
    corners = coordinates_of(mesh)[triangles_of(mesh)]
    return np.linalg.norm(np.roll(corners, -1, axis=1) - corners, axis=2).ravel()


def area(mesh):
    """Returns the area of all triangles."""
    return float(np.linalg.norm(area_vectors(mesh), axis=1).sum())


def floor_of(mesh):
    """Returns the distance below which relative errors are meaningless."""
    return FLOOR * float(edge_lengths(mesh).mean())


def notes(mesh):
    """Returns remarks on pictures of the mesh."""
    share = float(np.median(edge_lengths(mesh))) / mesh.GetLength() if mesh.GetLength() > 0 else 0.0
    if share <= LARGE:
        return []
    return [
        f"triangles are large (half of the edges are longer than {100 * share:.0f} % of the "
        "diagonal): isolines and colors are accurate at points, and approximate between them"
    ]


def spacing_of(cloud):
    """Returns the median distance of some points from their fourth neighbors."""
    locator = configured(vtkStaticPointLocator(), DataSet=cloud)
    locator.BuildLocator()
    count = cloud.GetNumberOfPoints()
    points = vtk_to_numpy(cloud.GetPoints().GetData())
    lengths = []
    for i in range(0, count, max(1, count // 500)):
        if np.isfinite(points[i]).all():
            near = vtkIdList()
            locator.FindClosestNPoints(5, points[i].astype(float), near)
            other = points[near.GetId(near.GetNumberOfIds() - 1)]
            lengths.append(np.linalg.norm(other - points[i]))
    return float(np.median(lengths)) if lengths else 0.0


def components_of(cloud, spacing):
    """Returns the number of components of a cloud, which wide gaps separate."""
    connect = configured(vtkConnectedPointsFilter(), InputData=cloud, Radius=GAP * spacing)
    connect.SetExtractionModeToAllRegions()
    connect.Update()
    return connect.GetNumberOfExtractedRegions()
