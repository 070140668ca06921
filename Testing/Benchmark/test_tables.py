# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tables and plots of benchmark results, and sections of Markdown files.

test_tables.py --write replaces the expected tables of ExpectedTables.md. Read the difference before
you keep it.
"""

import importlib.util
import os
import re
import sys
import unittest

import insert_table
import summarize
import summarize_graph
import summarize_path
import summarize_spectral
from table_support import HERE, PNG, draw, entry, errors, write_results

EXPECTED = os.path.join(HERE, "ExpectedTables.md")
FACTOR = {"analysis_seconds": 0.25, "factor_entries": 4e5, "predicted_bytes": 3e7}
POINT = {"first_seconds": 0.03, "radius_in_edges": 30.4, "other_method": 0}
PAIRS = {"pairs": 100, "complete": 1}
MOVERS = {"iterations": 500, "gap": 0.02, "per_geodesic": 0.99984}


def spectral_mesh(case, milliseconds, **figures):
    return entry(f"Spectral/ball/{case}/min_time:0.1", milliseconds, vertices=10000, **figures)


def spectral_peer(case, milliseconds, **figures):
    return entry(f"Peer/ball/{case}/min_time:0.1", milliseconds, vertices=10000, **figures)


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


def path(case, excess, **more):
    """A result with many paths, of which 25 are beyond 1e-6."""
    figures = {"ms_median": 0.5, "ms_p90": 0.75, "ms_p99": 2.0, "ms_mean": 0.625}
    figures.update({"within_1e6": 0.975, "within_1e5": 0.99999, "within_1e4": 1.0})
    figures.update({"excess_median": 2e-16, "excess_p99": 3.0 * excess, "excess_max": 5.0 * excess})
    figures.update({"outside": 25, "outside_median": 2.0 * excess, "outside_max": 5.0 * excess})
    figures.update(dict.fromkeys(("unconnected", "mismatches", "too_short", "invalid"), 0))
    figures.update({"pairs": 1000, "longer": 1, "unstraightened": 2, "fallbacks": 3})
    return entry(
        f"Path/ball/{case}/manual_time", 0.5, vertices=10000, excess_mean=excess, **figures, **more
    )


def exact_results():
    """Two meshes of a comparison, and two sizes of growth; engine R was not run on the second mesh."""
    results = []
    for name, vertices in (
        ("Exact/ball", 10000),
        ("Exact/cube", 500),
        ("Growth/ball-5K", 5000),
        ("Growth/ball", 10000),
    ):
        size = {"vertices": vertices, "windows": 40.0 * vertices, "heap_bytes_per_vertex": 150.0}
        results += [entry(f"{name}/T/{k}", 1e-3 * vertices * (k + 1), **size) for k in range(3)]
        if name == "Exact/ball":
            results += [
                entry(f"{name}/SetUp", 3.0, mesh_bytes_per_vertex=280.0),
                entry(f"{name}/R/0", 50.0, heap_bytes_per_vertex=300.0, **errors(1e-15)),
                entry(f"{name}/VTK/0", 5.0, **errors(0.05)),
            ]
    return results


def graph_results():
    """Two accuracies of the default rule, of which one was measured in full, another rule, and a peer."""
    return (
        graph("Guaranteed", "0.1", 15.0, 0.008)
        + graph("Guaranteed", "0.01", 50.0, 0.0008)
        + thorough("Guaranteed", "0.01")
        + graph("SVG", "30", 30.0, 0.01)
        + [entry("Peer/ball/VTK/Query/0", 28.0, vertices=10000, **errors(0.08))]
    )


def path_results():
    """Paths, cells and a matrix on one mesh."""
    cells = {"vertices": 10000, "samples": 100}
    voronoi = {"query_seconds": 0.004, "nearest_per_query": 1.125, "labels_per_query": 2.25}
    voronoi.update({"labels_per_corrected": 1.5, "diagram_per_query": 3.5})
    voronoi["refined_per_query"] = 4.25
    return [
        entry("Path/ball/Graph/manual_time", 1500.0, threads=2, graph_bytes=1.25e7),
        entry("Path/ball/Exact/manual_time", 30.0),
        path("Raw", 4e-4),
        path("Default", 1e-8),
        path("MarkedDefault", 1e-8),
        path("VertexVTK", 0.05),
        entry("Path/ball/VertexDefault", 0.1, ms_mean=0.125, excess_mean=-1e-16, excess_max=0),
        entry("Cells/ball/FarthestPoints/x", 30.0, per_ten_queries=0.75, **cells),
        entry("Cells/ball/Voronoi/manual_time", 14.0, **voronoi, **cells),
        entry("Matrix/ball/Update", 2500, size=50, threads=2, error_mean=4e-4, error_max=2e-3),
    ]


def matrix_results():
    """A matrix alone: what was not measured has no table."""
    return [result for result in path_results() if result["name"].startswith("Matrix/")]


def spectral_results():
    """One mesh with two peers; a failed result."""
    results = [
        spectral_mesh("Factor", 1000.0, peak_bytes=2.5e7, **FACTOR),
        spectral_mesh("Column/0", 4.0),
        spectral_mesh("Column/1", 5.0),
        spectral_mesh("Column/2", 9.0),
        spectral_mesh("Block", 16.0, columns=8),
        spectral_mesh("Greens/SingularitySubtraction/0", 20.0, **POINT),
        spectral_mesh("Greens/SingularitySubtraction/1", 40.0, **{**POINT, "other_method": 1}),
        spectral_mesh(
            "Greens/Vertex/0", 4.0, first_seconds=0.004, radius_in_edges=0, other_method=0
        ),
        spectral_mesh("Biharmonic/0", 10.0),
        spectral_mesh("Eigenpairs", 2000.0, **PAIRS),
        spectral_mesh("EarthMovers", 3000.0, **MOVERS),
        entry("Spectral/failed/Factor/min_time:0.1", 1.0, error_occurred=True),
        spectral_peer("Cholmod/Factor", 500.0, peak_bytes=5e7),
        spectral_peer("Cholmod/Column/0", 10.0, difference=1e-13),
        spectral_peer("Cholmod/Column/1", 10.0, difference=4e-13),
        spectral_peer("LibiglBiharmonic/Factor", 6000.0, peak_bytes=1e8),
        spectral_peer("LibiglBiharmonic/Column/0", 20.0, difference=2e-7),
    ]
    return results


CASES = {
    "exact": (summarize, exact_results),
    "graph": (summarize_graph, graph_results),
    "path": (summarize_path, path_results),
    "matrix": (summarize_path, matrix_results),
    "spectral": (summarize_spectral, spectral_results),
}


def results_of(case):
    """Returns the path of a file of results."""
    return write_results(f"{case}.json", CASES[case][1]())


def tables_of(case):
    """Returns the tables of these results, without titles and lines that separate headers."""
    text = CASES[case][0].summarize(results_of(case))
    skipped = ("**", "<", "|---")
    return "\n".join(line for line in text.splitlines() if line and not line.startswith(skipped))


class Tables(unittest.TestCase):
    def test_all(self):
        with open(EXPECTED, encoding="utf-8") as file:
            page = file.read()
        for case in CASES:
            with self.subTest(case):
                self.assertEqual(insert_table.insert(page, case, tables_of(case)), page)


class Plots(unittest.TestCase):
    @unittest.skipUnless(importlib.util.find_spec("matplotlib"), "needs matplotlib")
    def test_graph(self):
        self.assertEqual(draw("plot_graph.py", results_of("graph"), "graph.png"), PNG)

    def test_curves_of_graphs(self):
        import plot_graph

        graphs = summarize_graph.Run(results_of("graph")).graphs["ball"]
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

    def test_page(self):
        with open(os.path.join(HERE, "README.md"), encoding="utf-8") as file:
            page = file.read()
        written = re.findall(r"written by Testing/Benchmark/run.sh (\w+) --readme", page)
        self.assertEqual(sorted(written), ["cloud", "first", "graph", "local", "spectral", "spheres"])
        for name in written:
            self.assertIn("\nnew\n<!-- end", insert_table.insert(page, name, "new"))


def write():
    """Replaces the expected tables."""
    lines = ["# Tables that test_tables.py expects", ""]
    for case in CASES:
        lines += [f"<!-- begin {case} -->", tables_of(case), f"<!-- end {case} -->"]
    with open(EXPECTED, "w", encoding="utf-8") as file:
        file.write("\n".join(lines) + "\n")


if __name__ == "__main__":
    if sys.argv[1:] == ["--write"]:
        write()
    else:
        unittest.main()
