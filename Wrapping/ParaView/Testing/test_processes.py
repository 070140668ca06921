# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""A session in pvbatch on any number of processes: the surface is read by one, and given out to
all. Alone, its results are written; under mpiexec, they are compared with those."""

import numpy as np
from paraview import servermanager
from support import OUTPUT, bumpy, simple, unittest
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkParallelCore import vtkMultiProcessController

PROCESSES = vtkMultiProcessController.GetGlobalController().GetNumberOfProcesses()
RESULTS = OUTPUT / "processes.npz"
SOURCE = [0.9, -0.4, 0.3]
OTHER = [-0.9, 0.2, 0.5]
# Where cells come in another order, angles of graphs are rounded to other floats.
TOLERANCE = {"distance": 1e-7, "cells": 1e-7}
# A filter that the menus do not have.
BALANCE = """
from paraview.modules.vtkPVVTKExtensionsFiltersRendering import vtkBalancedRedistributePolyData
from vtkmodules.vtkParallelCore import vtkMultiProcessController

controller = vtkMultiProcessController.GetGlobalController()
balance = vtkBalancedRedistributePolyData()
balance.SetController(controller)
balance.SetInputDataObject(self.GetInputDataObject(0, 0))
balance.UpdatePiece(controller.GetLocalProcessId(), controller.GetNumberOfProcesses(), 0)
self.GetOutputDataObject(0).ShallowCopy(balance.GetOutputDataObject(0))
"""


def whole(mesh):
    """All of it on the first process."""
    return mesh


def regions(mesh):
    """Pieces that are compact."""
    return simple.ExtractSurface(Input=simple.RedistributeDataSet(Input=mesh))


def balanced(mesh):
    """Pieces of the same number of cells, by vtkRedistributePolyData."""
    return simple.ProgrammableFilter(Input=mesh, Script=BALANCE)


def on_points(proxy, name):
    """A point array, in the order of the file."""
    data = servermanager.Fetch(proxy).GetPointData()
    ids = vtk_to_numpy(data.GetArray("PointIds"))
    values = vtk_to_numpy(data.GetArray(name))
    ordered = np.full((ids.max() + 1,) + values.shape[1:], np.nan)
    ordered[ids] = values
    return ordered


def on_curves(proxy):
    """The points of curves, as a set."""
    points = vtk_to_numpy(servermanager.Fetch(proxy).GetPoints().GetData())
    return points[np.lexsort(np.round(points, 6).T)]


def results(pieces):
    """All that is compared, by name."""
    surface = pieces(simple.GenerateIds(Input=bumpy(), PointIdsArrayName="PointIds"))
    graph = simple.GeodesicGraph(Input=surface)
    distance = simple.GeodesicDistance(Input=graph)
    distance.Source.Center = SOURCE
    exact = simple.ExactGeodesicDistance(Input=surface, GenerateWindows=1)
    exact.Source.Center = SOURCE
    lines = simple.GeodesicIsolines(Input=exact, Distances=[0.5, 1.0, 1.5])
    path = simple.GeodesicPath(Input=graph, Method="Exact")
    path.Ends.StartPoint, path.Ends.EndPoint = SOURCE, OTHER
    green = simple.GreensFunction(Input=surface)
    green.Source.Center = SOURCE
    sites = simple.Line(Point1=SOURCE, Point2=OTHER, Resolution=4)
    cells = simple.GeodesicVoronoiCells(Input=graph, Sites=sites)
    return {
        "distance": on_points(distance, "GeodesicDistance"),
        "exact": on_points(exact, "GeodesicDistance"),
        "lines": on_curves(lines),
        "path": on_curves(path),
        "green": on_points(green, "GreensFunction"),
        "cells": on_points(cells, "GeodesicDistance"),
    }


class Processes(unittest.TestCase):
    def test_results_are_the_same(self):
        if PROCESSES == 1:
            np.savez(RESULTS, **results(whole))
        expected = np.load(RESULTS)
        for pieces in (whole, regions, balanced):
            for name, values in results(pieces).items():
                with self.subTest(pieces=pieces.__name__, name=name):
                    most = 0 if pieces is whole else TOLERANCE.get(name, 1e-12)
                    np.testing.assert_allclose(values, expected[name], rtol=0, atol=most)


if __name__ == "__main__":
    unittest.main()
