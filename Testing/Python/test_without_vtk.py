# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""The package where NumPy is installed and VTK is not."""

import contextlib
import io
import json
import math
import os
import pickle
import re
import sys
import tempfile
import unittest
from unittest import mock

if "vtkdgg" not in sys.modules:  # it is, where other tests run in the same process
    for name in ("vtk", "vtkmodules", "scipy"):
        sys.modules[name] = None

import numpy as np
import vtkdgg
from vtkdgg.command_line import main

x, y = np.meshgrid(np.arange(11.0), np.arange(11.0))
POINTS = np.column_stack([x.ravel(), y.ravel(), np.zeros(121)])
CORNERS = np.arange(120).reshape(-1, 1)
CORNERS = CORNERS[CORNERS[:, 0] % 11 < 10][:100]
QUADS = CORNERS + [0, 1, 12, 11]
TRIANGLES = np.concatenate([QUADS[:, :3], QUADS[:, [0, 2, 3]]])
FROM_0 = np.hypot(POINTS[:, 0], POINTS[:, 1])


def answer(line, folder, expected=0):
    """Runs a command with names of files in a folder, and returns its JSON or its message."""
    words = [os.path.join(folder, w) if re.search(r"\.[a-z]{3}$", w) else w for w in line.split()]
    out, err = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        code = main([*words, *["--json"] * (words[0] != "compare")])
    if code != expected:
        raise AssertionError(f"{line}: {code}, {err.getvalue()}")
    return err.getvalue() if code else json.loads(out.getvalue())


class WithoutVTK(unittest.TestCase):
    def test_functions(self):
        for cells in (TRIANGLES, QUADS):
            np.testing.assert_allclose(vtkdgg.distance(POINTS, cells, 0), FROM_0)
        self.assertAlmostEqual(vtkdgg.path(POINTS, TRIANGLES, 0, 120).length, math.hypot(10, 10))
        for method in ("fast", "marching"):
            found = vtkdgg.distance(POINTS, TRIANGLES, 0, method=method)
            np.testing.assert_allclose(found, FROM_0, rtol=0.1)
        mesh = vtkdgg.Mesh(POINTS, TRIANGLES)
        self.assertEqual(vtkdgg.greens_function(mesh, [0, 5]).shape, (121, 2))
        self.assertEqual(vtkdgg.biharmonic(mesh, 0).shape, (121,))
        values = vtkdgg.interpolate(mesh, [0, 60, 120], [1.0, 2.0, 3.0])
        np.testing.assert_allclose(values[[0, 60, 120]], [1, 2, 3])
        self.assertLess(vtkdgg.earth_movers(mesh, 0, 10).lower_bound, 10.1)
        places = [[2.5, 7.5, 0.0], [9.3, 0.2, 0.0]]
        for found in (
            vtkdgg.distance(mesh, 0, at=places),
            vtkdgg.probe(POINTS, TRIANGLES, FROM_0, places),
        ):
            np.testing.assert_allclose(found, np.hypot(*np.transpose(places)[:2]), rtol=1e-9)
        ids = [0, 10, 120]
        curves, _ = vtkdgg.patch_boundaries(mesh, mesh, ids, ids, [[0, 1, 2]])
        np.testing.assert_allclose([c.length for c in curves], [10, 10, math.hypot(10, 10)])
        white = {"LeftColor": [[1.0, 1, 1]], "RightColor": [[1.0, 1, 1]]}
        line = vtkdgg.Mesh(POINTS[[24, 90]], lines=([0, 2], [0, 1]), cell_data=white)
        self.assertEqual(vtkdgg.vector_graphics(mesh, line).point_data["RGB"].min(), 255)

    def test_graphs(self):
        graph = vtkdgg.Graph(POINTS, TRIANGLES, accuracy=0.01)
        copy = pickle.loads(pickle.dumps(graph, 5))  # noqa: S301
        for made in (graph, copy):
            np.testing.assert_allclose(made.distance([0.0, 0, 0]), FROM_0, rtol=0.01)
        self.assertAlmostEqual(graph.matrix([0], [120])[0, 0], math.hypot(10, 10), delta=0.15)
        self.assertEqual(len(graph.isolines(0, [5.0])), 1)
        self.assertEqual(len(graph.voronoi([0, 120]).areas), 2)
        self.assertEqual(len(graph.sample(4).points), 4)
        self.assertEqual(len(graph.paths([0, 1], [120, 119])), 2)
        self.assertEqual(len(graph.neighborhood(60, 1.0)[0]), 5)
        if hasattr(vtkdgg._kernel, "cloud_graph"):
            self.assertEqual(vtkdgg.CloudGraph(POINTS).distance(0).shape, (121,))

    def test_files(self):
        mesh = vtkdgg.Mesh(POINTS, TRIANGLES, point_data={"height": POINTS[:, 2]})
        with tempfile.TemporaryDirectory() as folder:
            for name in ("a.ply", "a.obj", "a.off", "a.stl"):
                path = os.path.join(folder, name)
                with mock.patch("warnings.warn"):  # formats without arrays
                    vtkdgg.write(path, mesh)
                self.assertEqual(len(vtkdgg.read(path).triangles), 200)

    def test_commands(self):
        square = np.tile([[0, 0], [1, 0], [1, 1], [0, 1]], (3, 1))
        side = np.arange(8)
        right = side // 4 * 4 + (side + 1) % 4
        tube = vtkdgg.Mesh(
            np.column_stack([square, np.repeat([0, 1, 2], 4)]),
            np.column_stack([side, right, right + 4, side + 4]),
        )
        plane = vtkdgg.Mesh(POINTS, TRIANGLES, point_data={"slope": POINTS @ [2.0, 1.0, 0.0]})
        diagonal = math.hypot(10, 10)
        with tempfile.TemporaryDirectory() as folder:

            def ask(line, **expected):
                found = answer(line, folder)
                for key, value in expected.items():
                    np.testing.assert_allclose(found[key], value, rtol=1e-9, err_msg=line)
                return found

            def rows():
                return np.load(os.path.join(folder, "out.npy"))

            vtkdgg.write(os.path.join(folder, "a.ply"), plane)
            vtkdgg.write(os.path.join(folder, "tube.off"), tube)
            ask("info a.ply", area=100, bounds=[0, 10, 0, 10, 0, 0], diagonal=diagonal, genus=0)
            ask("info a.ply --cloud", spacing=1, components=1)
            ask("info tube.off", area=8, triangles=16, components=1)
            ask("graph a.ply --accuracy 0.05", accuracy=0.05, points=121)
            for method in ("exact", "graph --accuracy 1e-6"):
                ask(f"distance a.ply --source 0 --method {method} --out out.npy", largest=diagonal)
                np.testing.assert_allclose(rows(), FROM_0, rtol=1e-6)
            ask("distance a.ply --source 0 --out b.ply", reached=121)
            written = vtkdgg.read(os.path.join(folder, "b.ply"))
            np.testing.assert_allclose(written.point_data["GeodesicDistance"], FROM_0)
            np.testing.assert_array_equal(written.point_data["slope"], plane.point_data["slope"])
            ask("matrix a.ply --sources 0,10 --targets 110,120 --out out.npy")
            np.testing.assert_allclose(rows(), [[10, diagonal], [diagonal, 10]], rtol=0.01)
            for method in ("exact", "graph"):
                path = f"path a.ply 0 2.5,7.5,0 --method {method} --out out.npy"
                ask(path, length=math.hypot(2.5, 7.5))
                np.testing.assert_allclose(rows()["y"], 3.0 * rows()["x"], atol=1e-9)
            ask("loop tube.off", lengths=[4])
            for method in ("exact", "graph"):
                ask(f"isolines a.ply --source 0 --values 5 --method {method} --out out.npy")
                np.testing.assert_allclose(np.hypot(rows()["x"], rows()["y"]), 5, rtol=0.01)
            ask("voronoi a.ply --site 0 --site 120 --out b.ply", areas=[50, 50], sites=2)
            self.assertIn("SiteId", vtkdgg.read(os.path.join(folder, "b.ply")).cell_data)
            found = ask("sample a.ply --number 4 --out b.ply")
            self.assertEqual(sorted(found["ids"]), [0, 10, 110, 120])
            self.assertAlmostEqual(found["covering radius"], diagonal / 2, delta=0.1)
            ask("greens a.ply --sources 0,50 --method Vertex --out out.npy", sources=2)
            self.assertAlmostEqual(rows()[50, 0], rows()[0, 1])  # it is symmetric
            for line in (
                "distance a.ply --source 0 --out out.vtp",
                "render a.ply --source 0 --out out.png",
                "explore a.ply",
                "compare a.ply",
            ):
                with mock.patch.dict(os.environ, DISPLAY=":0"):
                    said = answer(line, folder, 2)
                self.assertRegex(said, r"needs VTK, .* \(pip install vtkdgg\[vtk\]\)")

    def test_what_vtk_serves(self):
        mesh = vtkdgg.Mesh(POINTS, TRIANGLES)
        graph = vtkdgg.Graph(mesh)
        for ask in (
            mesh.as_polydata,
            lambda: graph.polydata,
            lambda: graph.distance(0, as_polydata=True),
            lambda: vtkdgg.distance(mesh, 0, as_polydata=True),
            lambda: vtkdgg.write("a.vtp", mesh),
            lambda: vtkdgg.check,
            lambda: vtkdgg.vtkDGGDistance,
        ):
            with self.assertRaisesRegex(ImportError, r"pip install vtkdgg\[vtk\]"):
                ask()
        with self.assertRaisesRegex(ImportError, "needs SciPy"):
            graph.csr  # noqa: B018
        self.assertNotIn("vtkDGGDistance", vtkdgg.__all__)
        with self.assertRaises(AttributeError):
            vtkdgg.vtkNothing  # noqa: B018


if __name__ == "__main__":
    unittest.main()
