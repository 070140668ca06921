# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""A session on any number of processes, in pvbatch: one process reads the surface and distributes
it. Alone, the session writes its results; under mpiexec, the results are compared with those."""

import numpy as np
import support
from paraview import servermanager
from support import simple, unittest
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkParallelCore import vtkMultiProcessController

PROCESSES = vtkMultiProcessController.GetGlobalController().GetNumberOfProcesses()
RESULTS = support.OUTPUT / "processes.npz"
SOURCE = [0.9, -0.4, 0.3]
# Ids differ in pieces, so that lengths of graphs, which are floats, are rounded differently.
TOLERANCE = {"distance": 1e-7, "cells": 1e-7}


def on_points(proxy, name):
    """Returns an array in the order of the file."""
    data = servermanager.Fetch(proxy)
    ids = vtk_to_numpy(data.GetPointData().GetArray("PointIds"))
    values = vtk_to_numpy(data.GetPointData().GetArray(name))
    ordered = np.full((ids.max() + 1,) + values.shape[1:], np.nan)
    ordered[ids] = values
    return ordered


def curves(proxy):
    """Returns the points of curves, sorted."""
    points = vtk_to_numpy(servermanager.Fetch(proxy).GetPoints().GetData())
    return points[np.lexsort(np.round(points, 6).T)]


def run(step):
    mesh = simple.GenerateIds(Input=support.bumpy(), PointIdsArrayName="PointIds")
    surface = step(mesh)
    graph = simple.GeodesicGraph(Input=surface)
    arrays = support.fetch(graph).GetFieldData()
    results = {"is_distributed": bool(arrays.HasArray("DGG.GhostIds"))}
    for name, method in [("distance", "GeodesicDistance"), ("exact", "ExactGeodesicDistance")]:
        distance = getattr(simple, method)(Input=graph)
        distance.Source.Center = SOURCE
        distance.UpdatePipeline()
        results[name] = on_points(distance, "GeodesicDistance")
    distance.GenerateWindows = 1
    lines = simple.GeodesicIsolines(Input=distance, Distances=[0.5, 1.0, 1.5])
    results["lines"] = curves(lines)
    path = simple.GeodesicPath(Input=graph, Method="Exact")
    path.Ends.StartPoint, path.Ends.EndPoint = SOURCE, [-0.9, 0.2, 0.5]
    results["path"] = curves(path)
    green = simple.GreensFunction(Input=surface)
    green.Source.Center = SOURCE
    results["green"] = on_points(green, "GreensFunction")
    sites = simple.Line(Point1=[-0.9, 0.2, 0.5], Point2=SOURCE, Resolution=4)
    cells = simple.GeodesicVoronoiCells(Input=graph, Sites=sites)
    results["cells"] = on_points(cells, "GeodesicDistance")
    return results


# A filter without an entry in ParaView's menus.
BALANCE = """
from paraview.modules.vtkPVVTKExtensionsFiltersRendering import vtkBalancedRedistributePolyData
from vtkmodules.vtkParallelCore import vtkMultiProcessController
balance = vtkBalancedRedistributePolyData()
controller = vtkMultiProcessController.GetGlobalController()
balance.SetController(controller)
balance.SetInputDataObject(self.GetInputDataObject(0, 0))
balance.UpdatePiece(controller.GetLocalProcessId(), controller.GetNumberOfProcesses(), 0)
self.GetOutputDataObject(0).ShallowCopy(balance.GetOutputDataObject(0))
"""


# Divides a surface, with the ids of the file as global ids. Unlike ParaView's own filter, the script
# does not transfer pieces as XML.
DIVIDE = """
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkParallelCore import vtkMultiProcessController
controller = vtkMultiProcessController.GetGlobalController()
here, count = controller.GetLocalProcessId(), controller.GetNumberOfProcesses()
surface = vtkPolyData()
surface.DeepCopy(self.GetInputDataObject(0, 0))
controller.Broadcast(surface, 0)
corners = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
cells = np.array_split(np.arange(len(corners)), count)[here]
ids, corners = np.unique(corners[cells], return_inverse=True)
piece = self.GetOutputDataObject(0)
points = vtkPoints()
points.SetData(numpy_to_vtk(vtk_to_numpy(surface.GetPoints().GetData())[ids], deep=True))
piece.SetPoints(points)
triangles = vtkCellArray()
triangles.SetData(3, numpy_to_vtkIdTypeArray(corners.ravel(), deep=True))
piece.SetPolys(triangles)
for data, name, values in (
    (piece.GetPointData(), "PointIds", ids),
    (piece.GetCellData(), "CellIds", cells),
):
    array = numpy_to_vtkIdTypeArray(values, deep=True)
    array.SetName(name)
    data.SetGlobalIds(array)
"""


def whole(mesh):
    return mesh


def regions(mesh):
    return simple.ExtractSurface(Input=simple.RedistributeDataSet(Input=mesh))


def divided(mesh):
    return simple.ProgrammableFilter(Input=mesh, Script=DIVIDE)


def identified(mesh):
    return regions(simple.GenerateGlobalIds(Input=mesh))


def read(mesh):
    """Returns a reader of one file for each process."""
    file = str(support.OUTPUT / f"pieces_{PROCESSES}.pvtp")
    simple.SaveData(file, proxy=divided(mesh), DataMode="Ascii")
    return simple.XMLPartitionedPolydataReader(FileName=[file])


def balanced(mesh):
    return simple.ProgrammableFilter(Input=mesh, Script=BALANCE)


def loses_cells(pieces):
    """Returns true if ParaView's own filter loses cells: with an expat of 2024 or later, its reader
    of binary XML, which transfers pieces, fails."""
    mesh = support.bumpy()
    surface = pieces(mesh)
    surface.UpdatePipeline()
    found, expected = (data.GetDataInformation().GetNumberOfCells() for data in (surface, mesh))
    return found < expected


class Processes(unittest.TestCase):
    def test_results_are_the_same(self):
        if PROCESSES == 1:
            np.savez(RESULTS, **run(whole))
        expected = dict(np.load(RESULTS))
        for pieces in (whole, regions, balanced, identified, read):
            has_ids = pieces in (identified, read)
            expected["is_distributed"] = has_ids and PROCESSES > 1
            if loses_cells(pieces):
                with self.subTest(pieces=pieces.__name__):
                    self.skipTest("ParaView's own redistribution loses cells")
                continue
            for name, values in run(pieces).items():
                with self.subTest(pieces=pieces.__name__, name=name, processes=PROCESSES):
                    exact = pieces is whole or has_ids
                    most = 0 if exact else TOLERANCE.get(name, 1e-12)
                    np.testing.assert_allclose(values, expected[name], rtol=0, atol=most)


if __name__ == "__main__":
    support.main()
