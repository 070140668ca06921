# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Graphs that processes with pieces of a surface build together. Run under mpiexec; a single process
is valid, too."""

import unittest

import numpy as np
import support
from mpi4py import MPI
from vtkdgg import vtkDGGDistance, vtkDiscreteGeodesicGraph
from vtkmodules.util.numpy_support import numpy_to_vtkIdTypeArray
from vtkmodules.vtkParallelCore import vtkMultiProcessController
from vtkmodules.vtkParallelMPI import vtkMPIController

SOURCES = [5, 600]


def piece_of(points, triangles, process, processes):
    """Returns the piece of a process: a slab with global ids of points and cells."""
    order = np.argsort(points[triangles].mean(axis=1)[:, 0])
    cells = np.sort(np.array_split(order, processes)[process])
    ids, corners = np.unique(triangles[cells], return_inverse=True)
    piece = support.polydata(points[ids], corners.reshape(-1, 3))
    for data, values in ((piece.GetPointData(), ids), (piece.GetCellData(), cells)):
        array = numpy_to_vtkIdTypeArray(values.astype(np.int64), deep=True)
        array.SetName("GlobalIds")
        data.SetGlobalIds(array)
    return piece, ids


class Pieces(unittest.TestCase):
    def test_graph_and_distances(self):
        """The graph is distributed, and distances are bitwise identical to those of one process."""
        controller = vtkMultiProcessController.GetGlobalController()
        here, count = controller.GetLocalProcessId(), controller.GetNumberOfProcesses()
        points, triangles = support.bumpy()
        alone = support.make(
            vtkDGGDistance, support.polydata(points, triangles), Controller=None, SourceIds=SOURCES
        )
        expected = support.distances_of(alone)
        piece, ids = piece_of(points, triangles, here, count)
        graph = support.make(vtkDiscreteGeodesicGraph, piece)
        distance = support.make(vtkDGGDistance, graph, SourceIds=SOURCES)
        distance.UpdatePiece(here, count, 0)
        arrays = graph.GetOutput().GetFieldData()
        self.assertEqual(arrays.HasArray("DGG.GhostIds"), count > 1)
        found = support.point_array(distance.GetOutput(), "GeodesicDistance")
        np.testing.assert_array_equal(found, expected[ids])


if __name__ == "__main__":
    controller = vtkMPIController()
    controller.Initialize()
    vtkMultiProcessController.SetGlobalController(controller)
    if not unittest.main(verbosity=2, exit=False).result.wasSuccessful():
        MPI.COMM_WORLD.Abort(1)  # or the other processes wait for this one
