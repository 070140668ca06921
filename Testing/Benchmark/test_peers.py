# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tests of failed measurements of peers. The test Benchmark.peers measures our own methods."""

import sys
import types
import unittest
from unittest import mock

import measure_peers
import numpy as np
from measure_alone import errors_of, run_alone


def run_python(code):
    return run_alone([sys.executable, "-c", code], limit=1)


class Failures(unittest.TestCase):
    def test_reasons(self):
        self.assertIsNone(run_python("print('noise')"))
        self.assertEqual(run_python("import os; os.abort()"), "crashed (SIGABRT)")
        self.assertEqual(run_python("import sys; sys.exit('no mesh')"), "exit status 1: no mesh")
        self.assertEqual(run_python("while True: pass"), "> 1 s")

    def test_larger_meshes(self):
        """Meshes on which a method is expected to exceed the limit are not measured."""
        methods = {"slow": types.SimpleNamespace(tasks=("one",))}
        for figures in ({"failed": "> 60 s"}, {"prepare": 10.0, "query": 11.0}):
            paces = {}
            with mock.patch.object(measure_peers, "measure_alone", return_value=figures) as alone:
                smaller, larger = [
                    measure_peers.measure_mesh("", vertices, methods, 60, paces)["slow"]["one"]
                    for vertices in (100, 300)
                ]
            alone.assert_called_once()
            self.assertEqual(smaller, figures)
            self.assertEqual(larger["failed"], "not measured, since a smaller mesh predicts > 60 s")

    def test_notes(self):
        figures = {"prepare": 1.0, "query": 0.25, "memory": 1000}
        error = {"mean": 0.01, "max": 0.03, "missed": 2}
        methods = {
            "good": {"one": {**figures, "error": error}},
            "slow": {"one": {"failed": "> 200 s"}},
            "broken": {
                "one": {"failed": "crashed (SIGSEGV)"},
                "path": {"failed": "ValueError: no"},
            },
        }
        meshes = {"ball": {"vertices": 642, "methods": methods}}
        text = measure_peers.tables({"versions": {"good": "1"}, "cores": 1, "meshes": meshes})
        for part in (
            "| good | 1 s / 250 ms |",
            "| good | 1 / 3, 2 unreached |",
            "| slow | > 200 s |",
            "| broken | crashed (1) |",
            "| broken | refused (2) |",
            "(1) crashed (SIGSEGV).",
            "(2) ValueError: no.",
        ):
            self.assertIn(part, text)

    def test_missing_values(self):
        exact = np.array([0.0, 1.0, 2.0, 4.0, 5.0, np.inf])
        errors, missing = errors_of(np.array([9.0, np.nan, 3.4e38, 5.0, 5.0, 1.0]), exact)
        self.assertEqual((errors.tolist(), missing), ([0.25, 0.0], 2))


if __name__ == "__main__":
    unittest.main()
