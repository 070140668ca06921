# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Matrices on a Dask cluster, on which workers die."""

import contextlib
import os
import signal
import tempfile
import time
import unittest
from unittest import mock

import numpy as np
import support
import vtkdgg
import zarr
from distributed import Client, LocalCluster
from vtkdgg.matrices import MatrixRequest

# Ends workers when they compute a strip.
DEADLY = """
import os
from vtkdgg.matrices import MatrixRequest
MatrixRequest.compute = lambda *arguments, **options: os._exit(1)
"""


class Matrix(support.Test):
    @classmethod
    def setUpClass(cls):
        cls.points, triangles = support.bumpy()
        cls.graph = vtkdgg.Graph(cls.points, triangles, accuracy=0.02)
        cls.rows = np.arange(0, 600, 5)

    @contextlib.contextmanager
    def cluster(self, workers, threads=1, **options):
        """Yields a cluster and a client, for which matrices have many strips. Expects that no data
        remain on the workers."""
        options.update(n_workers=workers, threads_per_worker=threads, dashboard_address=None)
        with mock.patch("vtkdgg.distributed._ROWS", 3), LocalCluster(**options) as cluster:
            with Client(cluster) as client:
                yield cluster, client
                end = time.monotonic() + 10.0
                while any(client.has_what().values()) and time.monotonic() < end:
                    time.sleep(0.05)
                self.assertEqual([key for keys in client.has_what().values() for key in keys], [])

    def test_results(self):
        near = self.points[self.rows[:20]] + 1e-3
        mixed = [5, (7, (0.2, 0.3, 0.5)), *near[:3], 5]
        cloud = vtkdgg.CloudGraph(self.points)
        cases = [
            (self.graph, self.rows, None),
            (self.graph, self.rows, [3, 500, 77]),
            (self.graph, mixed, self.rows),
            (self.graph, near, None),
            (cloud, self.rows, None),
        ]
        with self.cluster(2) as (_, client), tempfile.TemporaryDirectory() as folder:
            for number, (graph, rows, columns) in enumerate(cases):
                expected = graph.matrix(rows, columns)
                found = vtkdgg.distributed.matrix(graph, rows, client, columns)
                np.testing.assert_allclose(found, expected, rtol=1e-12)
                out = np.memmap(f"{folder}/{number}", np.float32, "w+", shape=found.shape)
                result = vtkdgg.distributed.matrix(graph, rows, client, columns, out=out)
                self.assertIs(result, out)
                np.testing.assert_array_equal(out, found.astype(np.float32))
                del out, result
            options = {"shape": expected.shape, "chunks": (50, 37), "dtype": "f8"}
            array = zarr.create_array(f"{folder}/zarr", **options)
            vtkdgg.distributed.matrix(graph, rows, client, out=array)
            np.testing.assert_array_equal(array[:], found)

    def test_workers_that_die(self):
        expected = None
        for workers, threads in ((2, 1), (1, 2)):  # others have the graph, or no worker has it
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

    def test_strips_that_kill(self):
        with tempfile.NamedTemporaryFile("w", suffix=".py") as file:
            file.write(DEADLY)
            file.flush()
            with self.cluster(2, preload=[file.name]) as (_, client):
                matrix = vtkdgg.distributed.matrix
                with self.assertRaisesRegex(vtkdgg.Error, "died again and again"):
                    matrix(self.graph, self.rows, client)

    def test_errors(self):
        far = [[0.0, 0.0, 5.0]]
        wrong = np.concatenate([self.points[self.rows], far])
        matrix = vtkdgg.distributed.matrix
        with self.cluster(1) as (cluster, client):

            def find(rows, columns=None):
                return matrix(self.graph, rows, client, columns)

            self.refuse(
                find,
                ((642,), "rows: point id 642"),
                ((0, []), "columns: expected at least one"),
            )
            self.refuse(
                find,
                ((0, far), "Column 0"),
                ((wrong,), "Row 120"),
                ((wrong, 0), "Row 120"),
                error=vtkdgg.Error,
            )
            with mock.patch.object(MatrixRequest, "store", side_effect=KeyboardInterrupt):
                with self.assertRaises(KeyboardInterrupt):
                    find(self.rows)
            self.assertEqual(find(0, 1).shape, (1, 1))
            self.refuse(matrix, ((self.graph, 0, [1]), "client: .* list"), error=TypeError)
            with Client(cluster) as closed:
                pass
            self.refuse(matrix, ((self.graph, 0, closed), "client: .* closed"))
        options = {"n_workers": 0, "dashboard_address": None}
        with LocalCluster(**options) as cluster, Client(cluster) as client:
            self.refuse(matrix, ((self.graph, 0, client), "client: .* no workers"))


if __name__ == "__main__":
    unittest.main()
