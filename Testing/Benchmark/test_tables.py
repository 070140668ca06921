# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""What becomes of the results of BenchmarkGraph: tables, a plot, a section of a Markdown file."""

import importlib.util
import json
import os
import subprocess
import sys
import unittest

import insert_table
import summarize_graph

HERE = os.path.dirname(os.path.abspath(__file__))
OUTPUT = os.environ["DGG_TEST_OUTPUT"]


def entry(name, milliseconds, **figures):
    """One result, as Google Benchmark writes it."""
    return {"name": name, "real_time": milliseconds, "time_unit": "ms", **figures}


def errors(mean):
    return {"error_mean": mean, "error_p999": 3.0 * mean, "error_max": 5.0 * mean}


def graph(rule, parameter, degree, error):
    prefix = f"Graph/ball/{rule}/{parameter}/"
    size = {"vertices": 10000, "degree_mean": degree, "degree_deviation": 4.0}
    corrected = {"pops_per_vertex": 1.25, **errors(error / 10.0)}
    return [
        entry(prefix + "Build/manual_time", 500.0, **size),
        entry(prefix + "Certified/0/manual_time", 4.0, **errors(error)),
        entry(prefix + "Certified/1/manual_time", 6.0, **errors(error)),
        entry(prefix + "Corrected/0/manual_time", 7.0, **corrected),
    ]


def thorough(rule, parameter):
    prefix = f"Graph/ball/{rule}/{parameter}/"
    many = {"sources": 500, "threads": 1, "wall_seconds": 1.0}
    parallel = {"sources": 500, "threads": 2, "wall_seconds": 0.5}
    return [
        entry(prefix + "Estimate/manual_time", 20.0, edges_ratio=1.02),
        entry(prefix + "Dijkstra/0/manual_time", 20.0),
        entry(prefix + "Many/manual_time", 1000.0, **many),
        entry(prefix + "ParallelMany/manual_time", 500.0, **parallel),
    ]


class Tables(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        results = (
            graph("Guaranteed", "0.1", 15.0, 0.008)
            + graph("Guaranteed", "0.01", 50.0, 0.0008)
            + thorough("Guaranteed", "0.01")
            + graph("SVG", "30", 30.0, 0.01)
            + [entry("Peer/ball/VTK/Query/0", 28.0, vertices=10000, **errors(0.08))]
        )
        cls.path = os.path.join(OUTPUT, "tables.json")
        with open(cls.path, "w", encoding="utf-8") as file:
            json.dump({"context": {"vtk_version": "9"}, "benchmarks": results}, file)
        cls.lines = summarize_graph.summarize(cls.path).splitlines()

    def cells(self, start, header):
        """The first row that starts so, by the columns of the first table with this header."""
        first = next(i for i, line in enumerate(self.lines) if f"| {header} |" in line)
        names = [name.strip() for name in self.lines[first].split("|")[1:-1]]
        row = next(line for line in self.lines[first:] if line.startswith(f"| {start} |"))
        return dict(zip(names, (cell.strip() for cell in row.split("|")[1:-1])))

    def test_size(self):
        cells = self.cells("Guaranteed, ε = 0.01", "degree")
        self.assertEqual(cells["degree"], "50.0 ± 4.0")
        self.assertEqual(cells["build"], "500 ms")
        self.assertEqual(cells["per vertex"], "50.0 µs")
        self.assertEqual(cells["error: mean / 99.9 % / max"], "0.08 / 0.24 / 0.4 %")
        self.assertEqual(cells["corrected"], "0.008 / 0.024 / 0.04 %")
        self.assertEqual(cells["query"], "7 ms")
        self.assertEqual(cells["queue entries per vertex"], "1.25")
        self.assertEqual(self.cells("SVG, K = 30", "degree")["degree"], "30.0 ± 4.0")

    def test_queries(self):
        cells = self.cells("Guaranteed, ε = 0.01", "Dijkstra / certified")
        self.assertEqual(cells["certified"], "5 ms")
        self.assertEqual(cells["Dijkstra / certified"], "4x")
        self.assertEqual(cells["in blocks, per source"], "2 ms")
        self.assertEqual(cells["certified / blocks"], "2.5x")
        self.assertEqual(cells["blocks on threads"], "2x on 2")
        # What was not measured in full has no row here.
        first = next(i for i, line in enumerate(self.lines) if "Dijkstra / certified" in line)
        self.assertFalse(any("SVG, K = 30" in line for line in self.lines[first:]))

    def test_peers(self):
        cells = self.cells("ball", "mean error")
        self.assertEqual((cells["time"], cells["mean error"]), ("4x", "1000x"))

    @unittest.skipUnless(importlib.util.find_spec("matplotlib"), "needs matplotlib")
    def test_plot(self):
        picture = os.path.join(OUTPUT, "tables.png")
        command = [sys.executable, "-B", os.path.join(HERE, "plot_graph.py"), self.path, picture]
        subprocess.run(command, check=True)
        with open(picture, "rb") as file:
            self.assertEqual(file.read(8), b"\x89PNG\r\n\x1a\n")

    def test_curves(self):
        import plot_graph

        graphs = summarize_graph.Run(self.path).graphs["ball"]
        points = plot_graph.curve(graphs, "Guaranteed", "Certified", 0)
        self.assertEqual([round(x) for x, _ in points], [15, 50])
        self.assertAlmostEqual(points[1][1], 0.08)


class Insert(unittest.TestCase):
    TEXT = "a\n<!-- begin t (made) -->\nold\n\nolder\n<!-- end t -->\nz\n"

    def test_replaces(self):
        expected = "a\n<!-- begin t (made) -->\nnew \\1\n<!-- end t -->\nz\n"
        self.assertEqual(insert_table.insert(self.TEXT, "t", "\nnew \\1\n\n"), expected)
        self.assertEqual(insert_table.insert(expected, "t", "new \\1"), expected)

    def test_other_markers(self):
        for text in ("nothing", self.TEXT + self.TEXT, self.TEXT.replace("end t", "end s")):
            with self.subTest(text=text), self.assertRaises(insert_table.MarkerError):
                insert_table.insert(text, "t", "new")


if __name__ == "__main__":
    unittest.main()
