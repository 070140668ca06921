# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""What becomes of results of BenchmarkSpectral: tables and a plot."""

import importlib.util
import unittest

import summarize_spectral
from table_support import PNG, cells_of, draw, entry, write_results

FACTOR = {"analysis_seconds": 0.25, "factor_entries": 4e5, "predicted_bytes": 3e7}
POINT = {"first_seconds": 0.03, "radius_in_edges": 30.4, "other_method": 0}
PAIRS = {"pairs": 100, "complete": 1}
MOVERS = {"iterations": 500, "gap": 0.02, "per_geodesic": 0.99984}


def mesh(case, milliseconds, **figures):
    return entry(f"Spectral/ball/{case}/min_time:0.1", milliseconds, vertices=10000, **figures)


def peer(case, milliseconds, **figures):
    return entry(f"Peer/ball/{case}/min_time:0.1", milliseconds, vertices=10000, **figures)


def sphere(level, way, error):
    """Errors of orders 2, 1 and 0, by the mean edge, from `error` on level 3."""
    step = 0.5 ** (level - 3)
    figures = {"vertices": 10 * 4**level + 2, "mean_edge": 0.15 * step, "other_method": 1}
    figures.update({"error_local": error * step**2, "error_global": error * step})
    return entry(f"Convergence/{level}/{way}/manual_time", 5.0, error_largest=error, **figures)


class SpectralTables(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        results = [
            mesh("Factor", 1000.0, peak_bytes=2.5e7, **FACTOR),
            mesh("Column/0", 4.0),
            mesh("Column/1", 5.0),
            mesh("Column/2", 9.0),
            mesh("Block", 16.0, columns=8),
            mesh("Greens/SingularitySubtraction/0", 20.0, **POINT),
            mesh("Greens/SingularitySubtraction/1", 40.0, **{**POINT, "other_method": 1}),
            mesh("Greens/Vertex/0", 4.0, first_seconds=0.004, radius_in_edges=0, other_method=0),
            mesh("Biharmonic/0", 10.0),
            mesh("Eigenpairs", 2000.0, **PAIRS),
            mesh("EarthMovers", 3000.0, **MOVERS),
            entry("Spectral/failed/Factor/min_time:0.1", 1.0, error_occurred=True),
            peer("Cholmod/Factor", 500.0, peak_bytes=5e7),
            peer("Cholmod/Column/0", 10.0, difference=1e-13),
            peer("Cholmod/Column/1", 10.0, difference=4e-13),
            peer("LibiglBiharmonic/Factor", 6000.0, peak_bytes=1e8),
            peer("LibiglBiharmonic/Column/0", 20.0, difference=2e-7),
        ]
        for level in (3, 4, 5):
            results.append(sphere(level, "SingularitySubtraction", 8e-4))
            results.append(sphere(level, "Vertex", 0.5))
        for sites, error in ((320, 0.02), (80, 0.08)):
            figures = {"vertices": 10242, "sites": sites, "error": error}
            results.append(entry(f"Splines/{sites}/min_time:0.000", 50.0, **figures))
        cls.path = write_results("spectral.json", results)
        cls.lines = summarize_spectral.summarize(cls.path).splitlines()

    def cells(self, header, start="ball"):
        return cells_of(self.lines, start, header)

    def test_factors(self):
        cells = self.cells("one more column")
        self.assertEqual((cells["vertices"], cells["factorization"]), ("10K", "1 s"))
        self.assertEqual(cells["of that, analysis"], "250 ms")
        self.assertEqual(cells["entries per vertex"], "40")
        self.assertEqual(cells["peak: predicted / measured"], "30MB / 25MB")
        self.assertEqual(cells["one more column"], "5 ms")
        self.assertEqual(cells["in blocks of eight, each"], "2 ms")
        self.assertEqual(cells["biharmonic column"], "10 ms")
        self.assertFalse(any("failed" in line for line in self.lines))

    def test_points(self):
        cells = self.cells("a point anywhere", "ball | singularity subtraction")
        self.assertEqual(cells["a point anywhere"], "30 ms")
        self.assertEqual(cells["with the columns it needs"], "30 ms")
        self.assertEqual((cells["radius, mean edges"], cells["by another method"]), ("30", "1"))
        cells = self.cells("a point anywhere", "ball | vertex")
        self.assertEqual((cells["radius, mean edges"], cells["by another method"]), ("–", "0"))

    def test_what_takes_long(self):
        cells = self.cells("eigenpairs")
        self.assertEqual((cells["eigenpairs"], cells["time"]), ("100", "2 s"))
        self.assertEqual(cells["known to be complete"], "yes")
        self.assertEqual((cells["earth mover's distance"], cells["iterations"]), ("3 s", "500"))
        self.assertEqual(cells["gap of its bounds, %"], "2")
        self.assertEqual(cells["distance / geodesic one"], "0.9998")

    def test_splines(self):
        rows = [line for line in self.lines if line.startswith("| 10.2K |")]
        self.assertEqual(rows, ["| 10.2K | 80 | 8 | 50 ms |", "| 10.2K | 320 | 2 | 50 ms |"])

    def test_peers(self):
        start = "ball | CHOLMOD"
        row = next(line for line in self.lines if line.startswith(f"| {start} |"))
        self.assertEqual(row, f"| {start} | 500 ms | 0.5x | 10 ms | 2x | 50MB | 2x | 4.0e-13 |")
        # Beside our factorization, and our biharmonic column.
        row = next(line for line in self.lines if line.startswith("| ball | libigl, bi-Laplacian"))
        self.assertIn("| 6 s | 6x | 20 ms | 2x | 100MB | 4x | 2.0e-07 |", row)
        self.assertFalse(any("heat method" in line for line in self.lines))

    def test_spheres(self):
        cells = self.cells("error", "within 0.2 | 2562")
        self.assertEqual(cells["singularity subtraction"], "2.0e-04")
        expected = {"within 0.2": "2.00", "everywhere": "1.00", "largest": "0.00"}
        for title, order in expected.items():
            cells = self.cells("error", f"{title} | order")
            found = [cells[way].lstrip("-") for way in ("singularity subtraction", "vertex")]
            self.assertEqual(found, [order, order], title)
        self.assertIn("At 6 poles another method was used.", self.lines)
        self.assertEqual(self.lines[-1], "</details>")

    def test_order(self):
        # A line through points that are not on one: by hand, over edges 1, 1/2, 1/4.
        points = [(1, 1.0, 1.0), (2, 0.5, 0.5), (3, 0.25, 0.0625)]
        self.assertAlmostEqual(summarize_spectral.order(points), 2.0)
        self.assertIsNone(summarize_spectral.order(points[:1]))

    def test_parts(self):
        """What was not measured has no table."""
        path = write_results("spheres.json", [sphere(3, "Vertex", 0.5)])
        lines = summarize_spectral.summarize(path).splitlines()
        self.assertEqual([line for line in lines if line.startswith("**")], [])
        self.assertEqual(cells_of(lines, "within 0.2 | order", "vertex")["vertex"], "–")

    @unittest.skipUnless(importlib.util.find_spec("matplotlib"), "needs matplotlib")
    def test_plot(self):
        self.assertEqual(draw("plot_spectral.py", self.path, "spectral.png"), PNG)


if __name__ == "__main__":
    unittest.main()
