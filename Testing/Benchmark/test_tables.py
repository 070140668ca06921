# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""What becomes of results of the benchmarks: tables, a plot, a section of a Markdown file."""

import importlib.util
import os
import re
import unittest

import insert_table
import summarize_cloud
import summarize_graph
import summarize_isolines
import summarize_path
from table_support import PNG, cells_of, draw, entry, errors, write_results


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
        cls.path = write_results("tables.json", results)
        cls.lines = summarize_graph.summarize(cls.path).splitlines()

    def cells(self, start, header):
        return cells_of(self.lines, start, header)

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
        self.assertEqual(draw("plot_graph.py", self.path, "tables.png"), PNG)

    def test_curves(self):
        import plot_graph

        graphs = summarize_graph.Run(self.path).graphs["ball"]
        points = plot_graph.curve(graphs, "Guaranteed", "Certified", 0)
        self.assertEqual([round(x) for x, _ in points], [15, 50])
        self.assertAlmostEqual(points[1][1], 0.08)


class PathTables(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cells = {"vertices": 10000, "samples": 100}
        voronoi = {"query_seconds": 0.004, "nearest_per_query": 1.125, "labels_per_query": 2.25}
        voronoi.update({"labels_per_corrected": 1.5, "diagram_per_query": 3.5})
        voronoi["refined_per_query"] = 4.25
        loops = {"runs": 5, "invalid": 0}
        results = [
            entry("Path/ball/Graph/manual_time", 1500.0, threads=2, graph_bytes=1.25e7),
            entry("Path/ball/Exact/manual_time", 30.0),
            path("Raw", 4e-4),
            path("Default", 1e-8),
            path("MarkedDefault", 1e-8),
            path("VertexVTK", 0.05),
            entry("Path/ball/VertexDefault", 0.1, ms_mean=0.125, excess_mean=-1e-16, excess_max=0),
            entry("Cells/ball/FarthestPoints/x", 30.0, per_ten_queries=0.75, **cells),
            entry("Cells/ball/Voronoi/manual_time", 14.0, **voronoi, **cells),
            entry(
                "Matrix/ball/Update", 2500, size=50, threads=2, error_mean=4e-4, error_max=2e-3
            ),
            entry("Loop/ball/AroundHandles/manual_time", 70.0, loops=20, empty=5, **loops),
            entry("Loop/ball/ThroughPoint/manual_time", 8.0, loops=4, **loops),
        ]
        cls.lines = cls.summarize("paths.json", results)
        cls.few = cls.summarize("matrix.json", results[9:10])

    @staticmethod
    def summarize(name, results):
        path = write_results(name, results)
        return summarize_path.summarize(path).splitlines()

    def cells(self, header, start="ball"):
        return cells_of(self.lines, start, header)

    def test_paths(self):
        cells = self.cells("with landmarks", "ball | 10K | default")
        self.assertEqual(cells["ms: median / 90 % / 99 %"], "0.5 / 0.75 / 2")
        self.assertEqual(cells["with landmarks"], "0.5 / 0.75 / 2")
        self.assertEqual(cells["% within 1e-6 / 1e-5 / 1e-4"], "97.5 / 99.99 / 100")
        excess = cells["excess: median / mean / 99 % / max"]
        self.assertEqual(excess, "0 / 1.0e-08 / 3.0e-08 / 5.0e-08")
        self.assertEqual(cells["beyond 1e-6: median / max"], "25: 2.0e-08 / 5.0e-08")
        raw = self.cells("with landmarks", "ball | 10K | as in the graph")
        self.assertEqual(raw["with landmarks"], "–")

    def test_before(self):
        cells = self.cells("its size")
        self.assertEqual((cells["graph (wall)"], cells["its size"]), ("1.5 s", "12.5MB"))
        self.assertEqual(cells["exact propagation"], "30 ms")
        self.assertEqual(cells["landmarks (wall)"], "–")

    def test_edges(self):
        cells = self.cells("pairs of vertices")
        self.assertEqual(cells["time"], "5x")
        self.assertEqual(cells["excess of VTK's: mean / max"], "5 / 25 %")
        self.assertEqual(cells["of the default: mean / max"], "0 / 0")

    def test_checks(self):
        cells = self.cells("not straightened", "ball | default")
        figures = [cells[name] for name in ("pairs", "not straightened", "edges found anew")]
        self.assertEqual(figures, ["1000", "2", "3"])
        self.assertEqual(cells["longer than before straightening"], "1")
        self.assertEqual(cells["not on the surface"], "0")
        raw = self.cells("not straightened", "ball | as in the graph")
        self.assertEqual(raw["not straightened"], "–")

    def test_cells(self):
        cells = self.cells("farthest points")
        self.assertEqual((cells["farthest points"], cells["in 10 queries"]), ("30 ms", "0.75x"))
        self.assertEqual(cells["one query"], "4 ms")
        self.assertEqual(cells["search from all samples, in queries"], "1.12x")
        self.assertEqual(cells["labels of Voronoi cells, in queries"], "2.25x")
        self.assertEqual(cells["in corrected queries"], "1.50x")
        self.assertEqual(cells["whole diagram, in queries"], "3.50x")
        self.assertEqual(cells["with refined borders"], "4.25x")

    def test_matrix_and_loops(self):
        cells = self.cells("update (wall)")
        self.assertEqual((cells["matrix"], cells["update (wall)"]), ("50 x 50", "2.5 s"))
        self.assertEqual(cells["error of a row: mean / max"], "0.04 / 0.2 %")
        cells = self.cells("around handles")
        self.assertEqual((cells["around handles"], cells["loops"]), ("70 ms", "4 and 1 fixed"))
        self.assertEqual(cells["through a point (found / asked)"], "8 ms (4 / 5)")
        self.assertEqual(cells["let go there"], "–")

    def test_nothing_but_what_was_measured(self):
        self.assertEqual([line for line in self.few if line.startswith("**")], ["**Matrices**"])


class IsolineTables(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        def lines(mesh, vertices, case, milliseconds, mean, **more):
            figures = {"vertices": vertices, "faces": 2 * vertices, "heap_bytes_per_vertex": 500.0}
            figures.update({"segments": 4000, "levels": 20, "error_by_length": 2.0 * mean})
            name = f"Isolines/{mesh}/{case}/manual_time"
            return entry(name, milliseconds, **figures, **errors(mean), **more)

        def ball(mesh, vertices, error):
            return [
                lines(mesh, vertices, "Exact/Contour", 2.0, error),
                lines(mesh, vertices, "Exact/Windows", 8.0, error / 500, chord=1e-5, fallbacks=2),
                lines(mesh, vertices, "Exact/WindowsHalved", 9.0, error / 1000, chord=5e-6),
                lines(mesh, vertices, "Exact/WindowsDrawn", 5.0, error / 50, chord=1e-3),
                lines(mesh, vertices, "Exact/Sources", 20.0, error / 8, chord=1e-5, fallbacks=3),
            ]

        results = (
            ball("large-10K", 10000, 0.001)
            + ball("small-1K", 1000, 0.004)
            + [
                lines("small-1K", 1000, f"Exact/Apollonius{count}", 10.0 * count, 0.001)
                for count in (10, 2, 0)
            ]
            + [
                lines("small-1K", 1000, "Heat/Contour", 2.0, 0.03),
                lines("small-1K", 1000, "Heat/Sources", 2.0, 0.02),
                entry("Isolines/small-1K/Heat/Input/manual_time", 2.0, **errors(0.04)),
                entry("Approximate/ball/Heat/Factors/x", 200, heap_bytes_per_vertex=1000.0),
                entry("Approximate/ball/Heat/Query/0/x", 8.0, vertices=500, **errors(0.01)),
                entry("Approximate/ball/Heat/Query/1/x", 10.0, vertices=500, **errors(0.03)),
                entry("Peer/ball/Heat/Query/0/x", 20.0, vertices=500, **errors(0.02)),
            ]
        )
        path = write_results("isolines.json", results)
        cls.lines = summarize_isolines.summarize(path).splitlines()

    def cells(self, start, header):
        return cells_of(self.lines, start, header)

    def test_errors(self):
        cells = self.cells("small-1K", "vtkContourFilter, %")
        self.assertEqual(cells["vtkContourFilter, %"], "0.4")
        self.assertEqual(cells["Apollonius, k = 2, %"], "0.1 (4x)")
        self.assertEqual(cells["virtual sources, %"], "0.05 (8x)")
        self.assertEqual(cells["windows, %"], "0.0008 (500x)")
        self.assertEqual(self.cells("large-10K", "windows, %")["Apollonius, k = 2, %"], "–")
        self.assertEqual(self.cells("geometric mean", "windows, %")["windows, %"], "500x")
        first = next(i for i, line in enumerate(self.lines) if "weighted by the length" in line)
        cells = cells_of(self.lines[first:], "small-1K", "windows, %")
        self.assertEqual(cells["windows, %"], "0.0016 (500x)")
        rows = [line.split(" |")[0] for line in self.lines if line.startswith(("| s", "| l"))]
        self.assertEqual(rows[:2], ["| small-1K", "| large-10K"])

    def test_largest(self):
        cells = self.cells("small-1K", "fallbacks: virtual / windows")
        self.assertEqual(cells["vtkContourFilter, %"], "1.2 / 2")
        self.assertEqual(cells["fallbacks: virtual / windows"], "3 / 2")

    def test_chords(self):
        cells = self.cells("small-1K", "windows, 1e-05 h, %")
        self.assertEqual(cells["windows, 1e-05 h, %"], "0.0008")
        self.assertEqual(cells["windows, 5e-06 h, %"], "0.0004")
        self.assertEqual(cells["windows, 0.001 h, %"], "0.008")
        self.assertEqual(cells["virtual, 0.001 h, %"], "–")

    def test_inputs(self):
        cells = self.cells("small-1K | heat", "gain")
        figures = [cells[name] for name in ("at vertices: mean, %", "max, %", "gain")]
        self.assertEqual(figures, ["4", "20", "1.5x"])

    def test_steiner_points(self):
        first = next(i for i, line in enumerate(self.lines) if "peak memory, MB" in line)
        rows = [line.split(" | ")[1:] for line in self.lines[first + 2 : first + 6]]
        self.assertEqual([row[0] for row in rows], ["k = 0", "k = 2", "k = 10", "windows"])
        self.assertEqual(rows[2], ["k = 10", "0.1", "4x", "100 ms", "0.5 |"])
        self.assertFalse(any("large-10K | k =" in line for line in self.lines))

    def test_times(self):
        cells = self.cells("large-10K", "windows, µs per face")
        self.assertEqual((cells["faces"], cells["windows"]), ("20K", "5 ms"))
        self.assertEqual(cells["windows, µs per face"], "0.25")
        self.assertEqual(cells["segments: linear / windows"], "4K / 4K")

    def test_fields(self):
        cells = self.cells("ball | 500 | heat", "before queries")
        self.assertEqual((cells["before queries"], cells["query"]), ("200 ms", "9 ms"))
        self.assertEqual((cells["error: mean, %"], cells["max, %"]), ("2", "10"))
        cells = self.cells("ball | 500 | heat (CGAL)", "before queries")
        self.assertEqual((cells["before queries"], cells["query"]), ("–", "20 ms"))


class CloudTables(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        def graph(prefix, points, error, milliseconds=500.0, **more):
            size = {"points": points, "degree": 80.4, "spacing": 0.02, "reach": 0.21}
            size.update({"graph_bytes": 6.4e6, "false_edges": 0, "components": 1, "noise": 0.0})
            size.update({"cpu_seconds": 0.9, "threads": 2, "resident_bytes": 9e6, **more})
            return [
                entry(prefix + "Build/manual_time", milliseconds, **size),
                entry(prefix + "Query/0/manual_time", 4.0, unreached=0, **errors(error)),
                entry(prefix + "Query/1/manual_time", 6.0, unreached=3, **errors(3.0 * error)),
            ]

        results = (
            graph("Cloud/torus-57K/C/chord/", 57000, 4e-4)
            + graph("Cloud/torus-57K/C/arc/", 57000, 1e-4)
            + graph("Cloud/torus-57K/C/fine/", 57000, 1e-5, accuracy=1e-4)
            + [entry("Cloud/torus-57K/Band/march/Query/0/x", 50.0, **errors(0.02))]
            + graph("Cloud/square-40K/A/arc/", 40000, 1e-4)
            + graph("Cloud/torus-57K_few/C/arc/", 9000, 1e-4)
            + graph("Cloud/igea/C/arc/", 134000, 1e-4)
            + graph("Cloud/half/C/arc/", 100, 1e-4)
            + graph("Cloud/none/C/arc/", 100, 1e-4)[:1]
            + [entry("Cloud/none/C/arc/Query/0/x", 1.0, error_occurred=True, **errors(0.0))]
            + graph("Guard/sheets/B/arc/", 2000, 1e-3, components=2, false_edges=7)
            + graph("Guard/noise_0.5/C/arc/", 2000, 2e-3, noise=0.0101)
            + [entry("Guard/noise_0.5/C/arc/Query/2/x", 5.0, reached_beyond=4)]
            + graph("Speed/ball/C/arc/", 200000, 1e-4, milliseconds=25000.0)
            + [
                entry("Speed/ball/C/arc/Estimate/x", 80.0, estimated_peak_bytes=1.2e7),
                entry("Speed/ball/Mesh/Build/manual_time", 2000.0, vertices=200000),
                entry("Speed/ball/Mesh/Query/0/manual_time", 60.0, **errors(1e-3)),
            ]
            + graph("Speed/sphere/C/arc/", 200000, 1e-4)
        )
        for alpha, error in (("2.5", 2e-3), ("10.5", 1e-4)):
            results += graph(f"Curve/sphere-10K/C/arc/Alpha/{alpha}/", 10000, error)
        results += graph("Curve/sphere-10K/A/chord/Offset/3/", 10000, 5e-4)
        results += graph("Curve/sphere-10K/A/chord/Offset/1/", 10000, 0.5)
        results[-1]["unreached"] = 5000
        cls.path = write_results("clouds.json", results)
        cls.lines = summarize_cloud.summarize(cls.path).splitlines()

    def cells(self, start, header):
        return cells_of(self.lines, start, header)

    def test_means(self):
        cells = self.cells("torus-57K", "C: arcs (default)")
        self.assertEqual((cells["points"], cells["published"]), ("57K", "0.12 to 0.17"))
        self.assertEqual(cells["C: arcs (default)"], "0.02 (6x)")
        self.assertEqual(cells["C: arcs, finer"], "0.002 (60x)")
        self.assertEqual((cells["C: chords"], cells["fast marching"]), ("0.08", "2"))
        self.assertEqual(cells["A: chords / arcs"], "– / –")
        cells = self.cells("square-40K", "C: arcs (default)")
        self.assertEqual((cells["A: chords / arcs"], cells["published"]), ("– / 0.02", "–"))

    def test_means_of_other_sizes(self):
        for cloud in ("torus-57K_few", "igea"):
            cells = self.cells(cloud, "C: arcs (default)")
            self.assertEqual((cells["published"], cells["C: arcs (default)"]), ("–", "0.02"))

    def test_means_of_what_is_not_reached(self):
        # 3 of 100 points, and all of them.
        for cloud in ("half", "none"):
            self.assertEqual(self.cells(cloud, "C: arcs (default)")["C: arcs (default)"], "–")
        self.assertEqual(self.cells("half | 100", "published mean")["unreached"], "3")

    def test_wrongly_reached(self):
        cells = self.cells("noise, 0.5 % of the box | C, arcs (default)", "unreached")
        self.assertEqual(cells["unreached"], "3, 4 wrongly reached")

    def test_errors(self):
        cells = self.cells("torus-57K | 57K | C, arcs (default)", "published mean")
        self.assertEqual(cells["error: mean / 99.9 % / max"], "0.02 / 0.06 / 0.15 %")
        self.assertEqual((cells["degree"], cells["reach, spacings"]), ("80", "10"))
        self.assertEqual((cells["unreached"], cells["query"]), ("3", "5 ms"))
        # The better of the published ones counts.
        self.assertEqual(cells["published mean"], "0.12 to 0.17 %")
        self.assertEqual(cells["published / ours"], "6x")
        cells = self.cells("torus-57K | 57K | C, chords", "published mean")
        self.assertEqual(cells["published / ours"], "1.5x")
        cells = self.cells("torus-57K | 57K | C, arcs, accuracy 0.0001", "published mean")
        self.assertEqual(cells["published / ours"], "60x")
        cells = self.cells("torus-57K | 57K | fast marching", "published mean")
        self.assertEqual(cells["published mean"], "1.8 to 3.7 %")
        self.assertEqual((cells["published / ours"], cells["degree"]), ("0.9x", "–"))
        cells = self.cells("square-40K | 40K | A, arcs", "published mean")
        self.assertEqual((cells["published mean"], cells["published / ours"]), ("–", "–"))

    def test_guards(self):
        header = "edges between sheets"
        cells = self.cells("two sheets, 3 h apart | B, arcs", header)
        self.assertEqual((cells[header], cells["components"]), ("7", "2"))
        self.assertEqual(cells["error: mean / 99.9 % / max"], "–")
        cells = self.cells("noise, 0.5 % of the box | C, arcs (default)", header)
        self.assertEqual(cells["noise found"], "0.01")
        self.assertEqual(cells["error: mean / 99.9 % / max"], "0.4 / 1.2 / 3 %")

    def test_speed(self):
        cells = self.cells("ball", "query there")
        self.assertEqual((cells["graph (wall)"], cells["CPU"]), ("25 s", "900 ms"))
        self.assertEqual(cells["peak: predicted / measured"], "12MB / 9MB")
        self.assertEqual((cells["query"], cells["query there"]), ("5 ms", "60 ms"))
        self.assertEqual(cells["graph of the mesh (CPU)"], "2 s")
        cells = self.cells("sphere", "query there")
        self.assertEqual((cells["query there"], cells["error there"]), ("–", "–"))
        self.assertEqual(cells["peak: predicted / measured"], "– / 9MB")

    def test_curves(self):
        import plot_cloud

        graphs = summarize_cloud.Run(self.path).curves["sphere-10K"]
        self.assertEqual(plot_cloud.name_of("sphere-10K", graphs), "sphere, 10K points")
        points = plot_cloud.curve(graphs, "C/arc", "Alpha")
        self.assertEqual([value for value, _ in points], [2.5, 10.5])
        self.assertAlmostEqual(points[1][1], 0.02)
        self.assertEqual(plot_cloud.curve(graphs, "C/arc", "Offset"), [])
        # Where half of the points is not reached, the others show nothing.
        self.assertEqual([x for x, _ in plot_cloud.curve(graphs, "A/chord", "Offset")], [3.0])

    @unittest.skipUnless(importlib.util.find_spec("matplotlib"), "needs matplotlib")
    def test_plot(self):
        self.assertEqual(draw("plot_cloud.py", self.path, "clouds.png"), PNG)


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
        here = os.path.dirname(os.path.abspath(__file__))
        with open(os.path.join(here, "README.md"), encoding="utf-8") as file:
            page = file.read()
        written = re.findall(r"written by Testing/Benchmark/run.sh (\w+) --readme", page)
        self.assertEqual(sorted(written), ["cloud", "first", "graph", "local", "spectral"])
        for name in written:
            self.assertIn("\nnew\n<!-- end", insert_table.insert(page, name, "new"))


if __name__ == "__main__":
    unittest.main()
