# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""The graph in the field data of a surface, as vtkDiscreteGeodesicGraph documents it."""

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

ARRAYS = ("Offsets", "Targets", "Lengths", "Angles", "ArrivalAngles", "Info")
# By the numbers of vtkDiscreteGeodesicGraph.ConstructionType.
CONSTRUCTIONS = ("Guaranteed", "OneRelay", "Indirect", "SaddleVertexGraph")
_VERSION = 1
_SIZE = 12


class GraphInfo:
    """Parameters that a graph was built with.

    Attributes
    ----------
    construction : int
        Index into CONSTRUCTIONS.
    accuracy : float or None
        None for a SaddleVertexGraph.
    number_of_neighbors : int
        Of a SaddleVertexGraph.
    is_merged : bool
        Whether coincident points were one.
    """

    def __init__(self, polydata):
        array = polydata.GetFieldData().GetArray("DGG.Info")
        if array is None:
            raise ValueError(
                "polydata: there is no graph in its field data; take the output of "
                "vtkDiscreteGeodesicGraph"
            )
        values = vtk_to_numpy(array)
        if values.dtype != np.int64 or values.shape != (_SIZE,) or values[0] != _VERSION:
            raise ValueError(
                "polydata: its graph has a DGG.Info of another version, or is damaged; build it "
                "anew by vtkDiscreteGeodesicGraph"
            )
        if not 0 <= values[2] < len(CONSTRUCTIONS):
            raise ValueError(f"polydata: its graph has an unknown construction, {values[2]}")
        self.construction = int(values[2])
        has_accuracy = CONSTRUCTIONS[self.construction] != "SaddleVertexGraph"
        self.accuracy = float(values[3:4].view(np.float64)[0]) if has_accuracy else None
        self.number_of_neighbors = int(values[4])
        self.is_merged = bool(values[5])


def copy_surface(polydata):
    """The surface with points and polygons of its own. The arrays of the graph are shared."""
    result = vtkPolyData()
    points = vtkPoints()
    points.DeepCopy(polydata.GetPoints())
    result.SetPoints(points)
    for take, give in (
        (polydata.GetPolys, result.SetPolys),
        (polydata.GetStrips, result.SetStrips),
    ):
        cells = vtkCellArray()
        cells.DeepCopy(take())
        give(cells)
    for name in ARRAYS:
        array = polydata.GetFieldData().GetAbstractArray(f"DGG.{name}")
        if array is not None:
            result.GetFieldData().AddArray(array)
    return result
