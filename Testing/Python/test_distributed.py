# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Matrices on a Dask cluster, on which workers die."""

import contextlib
import os
import signal
import tempfile
import unittest
from unittest import mock

import numpy as np
import support
import vtkdgg
import vtkdgg.distributed
import zarr
from distributed import Client, LocalCluster
from vtkdgg.matrices import MatrixRequest


class Matrix(support.Test):
    @classmethod
    def setUpClass(cls):
        cls.points, triangles = support.bumpy()
        cls.graph = vtkdgg.Graph(cls.points, triangles, accuracy=0.02)
        cls.rows = np.arange(0, 600, 5)

    @contextlib.contextmanager
    def cluster(self, workers, threads=1):
        """Yields a cluster and a client, for which matrices have many strips."""
        options = {"n_workers": workers, "threads_per_worker": threads, "dashboard_address": None}
        with mock.patch("vtkdgg.distributed._ROWS", 3), LocalCluster(**options) as cluster:
            with Client(cluster) as client:
                yield cluster, client

    def test_results(self):
        near = self.points[self.rows[:20]] + 1e-3
        cloud = vtkdgg.CloudGraph(self.points)
        cases = [
            (self.graph, self.rows, None),
            (self.graph, self.rows, [3, 500, 77]),
            (self.graph, near, self.rows),
            (self.graph, near, None),
            (cloud, self.rows, None),
        ]
        with self.cluster(2) as (_, client), tempfile.TemporaryDirectory() as folder:
            for number, (graph, rows, columns) in enumerate(cases):
                expected = graph.matrix(rows, columns)
                found = vtkdgg.distributed.matrix(graph, rows, client, columns)
                np.testing.assert_allclose(found, expected, rtol=1e-12)
                out = np.memmap(f"{folder}/{number}", np.float32, "w+", shape=found.shape)
                self.assertIs(
                    vtkdgg.distributed.matrix(graph, rows, client, columns, out=out), out
                )
                np.testing.assert_array_equal(out, found.astype(np.float32))
                del out
            array = zarr.create_array(
                f"{folder}/zarr", shape=expected.shape, chunks=(50, 50), dtype="f8"
            )
            vtkdgg.distributed.matrix(graph, rows, client, out=array)
            np.testing.assert_array_equal(array[:], found)

    def test_workers_that_die(self):
        expected = None
        for workers, threads in ((2, 1), (1, 2)):  # the others have the graph, or no worker has it
            with self.cluster(workers, threads) as (cluster, client):
                if expected is None:
                    expected = vtkdgg.distributed.matrix(self.graph, self.rows, client)
                victims = [worker.pid for worker in cluster.workers.values()][:1]
                store = MatrixRequest.store

                def kill_and_store(request, *arguments, victims=victims, store=store):
                    while victims:
                        os.kill(victims.pop(), signal.SIGKILL)
                    store(request, *arguments)

                with mock.patch.object(MatrixRequest, "store", kill_and_store):
                    found = vtkdgg.distributed.matrix(self.graph, self.rows, client)
                self.assertEqual(victims, [])
                np.testing.assert_array_equal(found, expected)

    def test_errors(self):
        far = [[0.0, 0.0, 5.0]]
        with self.cluster(1) as (_, client):

            def find(rows, columns, **given):
                return vtkdgg.distributed.matrix(self.graph, rows, client, columns, **given)

            self.refuse(
                find,
                ((642, None), "rows: point id 642"),
                ((0, []), "columns: expected at least one"),
            )
            wrong = np.concatenate([self.points[self.rows], far])
            self.refuse(
                find,
                ((0, far), "Column 0"),
                ((wrong, None), "Row 120"),
                ((wrong, 0), "Row 120"),
                error=vtkdgg.Error,
            )
            self.assertEqual(find(0, 1).shape, (1, 1))
        refuse = vtkdgg.distributed.matrix
        self.refuse(
            refuse, ((self.graph, 0, "client"), "client: expected a distr"), error=TypeError
        )
        self.refuse(refuse, ((self.graph, 0, mock.Mock(asynchronous=True)), "not asynchronous"))


if __name__ == "__main__":
    unittest.main()
