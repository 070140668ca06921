# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Progress of several processes, and an error or an abort on one of them. Each process runs this
script, in pvbatch --symmetric."""

import os

import support
import test_processes
from support import simple, unittest
from test_updates import Watch
from vtkmodules.vtkParallelCore import vtkMultiProcessController

CONTROLLER = vtkMultiProcessController.GetGlobalController()
IS_LAST = CONTROLLER.GetLocalProcessId() == CONTROLLER.GetNumberOfProcesses() - 1


class Ranks(unittest.TestCase):
    def setUp(self):
        simple.ResetSession()
        surface = test_processes.divided(support.bumpy())
        self.graph = simple.GeodesicGraph(Input=surface)

    def check_empty(self):
        """Expects an empty output of an update that has ended on all processes."""
        self.assertEqual(support.fetch(self.graph).GetNumberOfPoints(), 0)
        CONTROLLER.Barrier()

    def check_graph(self):
        """Expects a graph after a change of a property on all processes."""
        self.graph.Accuracy = 0.05
        arrays = support.fetch(self.graph).GetFieldData()
        self.assertTrue(arrays.HasArray("DGG.Offsets"))

    def test_progress(self):
        watch = Watch(self.graph)
        self.check_graph()
        self.assertGreater(len(set(watch.seen)), 5)
        self.assertEqual(watch.seen, sorted(watch.seen))
        watch.close()

    def test_error(self):
        listener = support.Listener(self.graph)
        self.graph.Accuracy = 2.0 if IS_LAST else 0.01
        self.check_empty()
        self.assertIn("Accuracy is 2", " ".join(listener.errors))
        self.check_graph()

    def test_abort(self):
        self.graph.SMProxy.UpdateVTKObjects()
        listener = support.Listener(self.graph)
        watch = Watch(self.graph, stops=IS_LAST)
        self.check_empty()
        self.assertEqual(listener.errors, [])
        watch.close()
        self.check_graph()


if __name__ == "__main__":
    if not unittest.main(verbosity=2, exit=False).result.wasSuccessful():
        os._exit(1)  # mpiexec then ends the other processes, which may wait for this one
