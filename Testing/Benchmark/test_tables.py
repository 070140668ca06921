# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tests of tables and plots of benchmark results, and of generated sections of pages. The tests
Benchmark.NAME.Run and .Table run the programs."""

import importlib.util
import json
import os
import re
import subprocess
import sys
import unittest

import plots
from summarize import PATTERNS, summarize
from tables import MarkerError, insert, load, rows_of

HERE = os.path.dirname(os.path.abspath(__file__))
OUTPUT = os.environ["DGG_TEST_OUTPUT"]
PNG = b"\x89PNG\r\n\x1a\n"


def cells_of(lines, start, header):
    """Returns a row by column: the first row that starts with `start`, in the first table that has
    the column `header`."""
    first = next(i for i, line in enumerate(lines) if f"| {header} |" in line)
    names = [name.strip() for name in lines[first].split("|")[1:-1]]
    row = next(line for line in lines[first:] if line.startswith(f"| {start} |"))
    return dict(zip(names, (cell.strip() for cell in row.split("|")[1:-1])))


def graph(rule, parameter, degree, error):
    """Returns the results of one graph, as Google Benchmark writes them."""
    size = {"vertices": 10000, "degree_mean": degree, "degree_deviation": 4.0}
    errors = {"error_mean": error, "error_p999": 3.0 * error, "error_max": 5.0 * error}
    cases = {"Build": size, "Certified/0": errors, "Certified/1": errors}
    return [
        {"name": f"Graph/ball/{rule}/{parameter}/{case}", "real_time": 4.0 + 2.0 * k, **figures}
        for k, (case, figures) in enumerate(cases.items())
    ]


class Tables(unittest.TestCase):
    def setUp(self):
        results = graph("Guaranteed", "0.1", 15.0, 0.008) + graph("Guaranteed", "0.01", 50.0, 0.0008)
        results += [{"name": "Graph/ball/failed/1/Build", "real_time": 1.0, "error_occurred": True}]
        self.path = os.path.join(OUTPUT, "graph.json")
        entries = [{"time_unit": "ms", **result} for result in results]
        with open(self.path, "w", encoding="utf-8") as file:
            json.dump({"context": {"vtk_version": "9"}, "benchmarks": entries}, file)

    def test_table(self):
        text = summarize(self.path)
        self.assertIn("(vtk 9).", text)
        self.assertNotIn("failed", text)
        row = cells_of(text.splitlines(), "Guaranteed, ε = 0.01", "graph")
        self.assertEqual(row["degree"], "50.0 ± 4.0")
        self.assertEqual(row["build"], "4 ms")
        self.assertEqual(row["error: mean / 99.9 % / max"], "0.08 / 0.24 / 0.4 %")
        self.assertEqual(row["query"], "–")

    def test_statistics(self):
        row = rows_of(load(self.path)[1], PATTERNS["graph"])[0]
        self.assertEqual((row["mesh"], row["rule"], row["parameter"]), ("ball", "Guaranteed", "0.1"))
        self.assertEqual(row["Certified"]["error"]["mean"], 0.008)
        self.assertAlmostEqual(row["Certified"]["seconds"], 0.007)  # median of 6 and 8 ms

    def test_curve(self):
        rows = rows_of(load(self.path)[1], PATTERNS["graph"])
        points = plots.degree_curve(rows, "Guaranteed", "Certified", "mean")
        self.assertEqual([round(x) for x, _ in points], [15, 50])
        self.assertAlmostEqual(points[1][1], 0.08)

    @unittest.skipUnless(importlib.util.find_spec("matplotlib"), "needs matplotlib")
    def test_plot(self):
        picture = os.path.join(OUTPUT, "graph.png")
        command = [sys.executable, "-B", os.path.join(HERE, "plots.py"), "graph", self.path, picture]
        subprocess.run(command, check=True)
        with open(picture, "rb") as file:
            self.assertEqual(file.read(8), PNG)


class Insert(unittest.TestCase):
    TEXT = "a\n<!-- begin t (made) -->\nold\n\nolder\n<!-- end t -->\nz\n"

    def test_replaces(self):
        expected = "a\n<!-- begin t (made) -->\nnew \\1\n<!-- end t -->\nz\n"
        self.assertEqual(insert(self.TEXT, "t", "\nnew \\1\n\n"), expected)
        folded = "<details><summary>more</summary>\n\nhidden\n</details>\n"
        self.assertEqual(insert(expected, "t", folded + "new \\1\n\n" + folded), expected)

    def test_other_markers(self):
        for text in ("nothing", self.TEXT + self.TEXT, self.TEXT.replace("end t", "end s")):
            with self.subTest(text=text), self.assertRaises(MarkerError):
                insert(text, "t", "new")

    def test_page(self):
        with open(os.path.join(HERE, "README.md"), encoding="utf-8") as file:
            page = file.read()
        written = re.findall(r"written by Testing/Benchmark/run.sh (\w+) --readme", page)
        expected = ["cloud", "first", "graph", "local", "peers", "spectral", "spheres"]
        self.assertEqual(sorted(written), expected)
        for name in written:
            self.assertIn("\nnew\n<!-- end", insert(page, name, "new"))


if __name__ == "__main__":
    unittest.main()
