# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""The command vtkdgg; `compare` has tests of its own."""

import gzip
import json
import os
import re
import shlex
import shutil
import signal
import subprocess
import sys
import time
import unittest
from unittest import mock

import numpy as np
import support
import vtkdgg
from support import BUMPY, HAS_CLOUDS, TETRAHEDRON
from support import call as command
from vtkdgg.command_line import make_parser, script
from vtkdgg.vtk_data import with_arrays

PACKAGES = os.path.dirname(os.path.dirname(vtkdgg.__file__))
FOLDER = support.output_folder("command")


def out(name):
    """Returns the path of a file that a test writes; an older one is removed."""
    path = os.path.join(FOLDER, name)
    if os.path.exists(path):
        os.remove(path)
    return path


def array_of(path, name="GeodesicDistance"):
    """Returns a point array of a file."""
    return vtkdgg.read(path).point_data[name]


# Names of classes and properties, which users of the shell have never seen.
CPLUSPLUS = r"\bvtk(?!dgg)\w+|\bSet[A-Z]|\b(?!GeodesicDistance)[A-Z][a-z]+[A-Z]\w*"


# Wrong commands, with names of files in capitals, and patterns of the message.
MISTAKES = (
    ("fly MESH", r"unknown command fly \(--help"),
    ("distence MESH", r"unknown command distence; did you mean distance\?"),
    ("--verson", r"option --verson; did you mean --version\?"),
    ("distance MESH --sorce 0", r"option --sorce; did you mean --source\?"),
    ("sample MESH --numer=3", r"option --numer; did you mean --number\?"),
    ("isolines MESH --number 0", r"option --number \(--help"),
    ("distance MESH --sources 0,5,", "--sources '': expected a point id"),
    ("info", "file"),
    ("info missing.ply", "missing.ply: no such file"),
    ("info CUT", "error: .*cut.ply: line 4: the header declares 642 records"),
    ("info PROGRAM", "test_command.py: unknown extension '.py'; expected one of .gii .obj"),
    ("info FOLDER", "expected a file, got a folder"),
    ("info DEVICE", "expected a file, got a device"),
    ("distance MESH", "--source"),
    ("distance MESH --source 642", "--source 642: point id 642 .*there are 642 points"),
    ("distance MESH --source 1,2", "expected a point id, X,Y,Z or face:"),
    ("distance MESH --source nan,0,0", "expected a point id, X,Y,Z or face:"),
    ("distance MESH --source face:5:0.5,0.5", "face:5:0.5,0.5: expected a point"),
    ("distance MESH --source face:9999:1,0,0", "--source face:9999:1,0,0: .* there are 1280 cells"),
    ("distance MESH --source 9,9,9", "or raise --tolerance"),
    ("distance MESH --sources 0,642", "--sources 642: point id 642 .*does not exist"),
    ("distance MESH --sources 0.5,1,2", "--sources 0.5: expected a point id$"),
    ("distance MESH --source-file none.txt", "error: none.txt: no such file$"),
    ("distance MESH --source-file WRONG", "wrong.txt, line 2: 1,2: expected a"),
    ("distance MESH --source 0 --method best", "invalid choice"),
    ("distance MESH --source 0 --accuracy x", "error: --accuracy: invalid"),
    ("distance MESH --source 0 --out a.abc", "'.abc' cannot store values at points"),
    ("distance MESH --source 0 --out none/a.vtp", "the folder none does not"),
    ("distance MESH --source 0 --out none/a.off", "none/a.off"),
    ("graph MESH --accuracy 2", "--accuracy is 2. Use a number from"),
    ("graph MESH --cloud --merge", "--merge applies to meshes"),
    ("path MESH 0 3 --accuracy 2", "--accuracy is 2. Use a number"),
    ("path MESH 9,9,9 3", r"error: Start of pair 0, at \(9, 9, 9\), is 14"),
    ("path MESH 3 9,9,9", r"error: End of pair 0, at \(9, 9, 9\), is 14"),
    ("loop MESH --through 9,9,9", r"error: Loop point 0, at \(9, 9, 9\), is 14"),
    ("loop MESH --rope", "--through"),
    ("matrix MESH --source 0 --targets face:3:1,0,0 --out m.csv", "--targets face:3:1: expected a"),
    ("matrix MESH --sources 0 --targets 642 --out m.csv", "--targets 642"),
    ("isolines MESH --source 0 --every 0", "--every: expected a positive number"),
    ("isolines MESH --source 0 --count -1", "--count: expected 1 to 10000"),
    ("isolines MESH --source 0 --every 1e-9", "--every 1e-09 makes more than 10000 isolines"),
    ("isolines MESH --source 0 --values a,b", "--values"),
    ("isolines MESH --source 0 --count 10 --values 0.1", "--values: not .* with .*--count"),
    ("sample MESH --number 0", "error: --number is 0. Use a number of at least 1"),
    ("voronoi MESH --number 0", "error: --number is 0. Use a number of at least 1"),
    ("voronoi MESH --number 20 --site 3", "--site: not .* with .*--number"),
    ("render MESH --source 0 --out a.png --view=up", "--view: expected"),
    ("render MESH --source 0 --array foo --out a.png", "give another --array"),
    ("render TETRAHEDRON --out a.png", "no point array 'GeodesicDistance'"),
    ("render COLOURED --array Erorr --out a.png", "found: Error, Colour"),
)


class Command(support.Test):
    @classmethod
    def setUpClass(cls):
        cls.mesh = vtkdgg.read(BUMPY).as_polydata()
        cls.exact = vtkdgg.distance(cls.mesh, 5)

    def answer(self, line, *more):
        """Returns the JSON of a command, whose keys are in its table as well. MESH in the line
        stands for the bumpy sphere."""
        arguments = [BUMPY if word == "MESH" else word for word in line.split()] + list(more)
        result = command(*arguments, "--json")
        self.assertEqual(result.returncode, 0, result.stderr)
        found = json.loads(result.stdout)
        result = command(*arguments)
        self.assertEqual(result.returncode, 0, result.stderr)
        for key in set(found) - {"warnings"}:
            self.assertRegex(result.stdout, rf"(?m)^{re.escape(key)} ")
        return found

    def test_version_and_help(self):
        result = support.command("--version")
        self.assertRegex(result.stdout, rf"\Avtkdgg {vtkdgg.__version__}, VTK 9\.\d.*, \d+ threads")
        names = list(make_parser().commands)
        self.assertEqual(
            names,
            "info graph distance matrix path loop isolines voronoi sample greens render explore "
            "compare paraview".split(),
        )
        result = command("--help")
        for name in names:
            self.assertRegex(result.stdout, rf"(?m)^    {name} +[A-Z]")
            said = command(name, "--help")
            self.assertEqual(said.returncode, 0)
            option = {"info": "--json", "paraview": "--help"}.get(name, "--out")
            self.assertIn(option, said.stdout)
            if name not in ("compare", "paraview"):
                self.assertIn(f"example:\n  vtkdgg {name} mesh.ply", said.stdout)

    def test_paraview(self):
        said = command("paraview")
        self.assertEqual(said.returncode, 0, said.stderr)
        plugin = said.stdout.splitlines()[0]
        self.assertTrue(os.path.isfile(plugin), plugin)
        self.assertIn(f"LoadPlugin({plugin!r}", said.stdout)

    @unittest.skipUnless(shutil.which("bash"), "no bash")
    def test_completion(self):
        folder = os.path.dirname(os.path.dirname(os.path.dirname(PACKAGES)))
        script = os.path.join(folder, "share", "bash-completion", "completions", "vtkdgg")
        for words, at, expected in (
            (["vtkdgg", "vo"], 1, ["voronoi"]),
            (["vtkdgg", "--v"], 1, ["--version"]),
            (["vtkdgg", "path", "--acc"], 2, ["--accuracy"]),
            (["vtkdgg", "path", "mesh"], 2, []),
        ):
            line = f"source {script}; COMP_WORDS=({' '.join(words)}); COMP_CWORD={at}; _vtkdgg; "
            words = ["bash", "-c", line + 'echo "${COMPREPLY[@]}"']
            said = subprocess.run(words, capture_output=True, text=True, check=True)
            self.assertEqual(said.stdout.split(), expected)

    def test_man_page(self):
        folder = os.path.dirname(os.path.dirname(os.path.dirname(PACKAGES)))
        with gzip.open(os.path.join(folder, "share", "man", "man1", "vtkdgg.1.gz"), "rt") as file:
            parts = re.split(r"^\.S[SH] ", file.read(), flags=re.M)[1:]
        sections = dict(part.split("\n", 1) for part in parts)
        self.assertRegex(sections["NAME"], r"^vtkdgg \\- geodesics on meshes")
        for name, parser in make_parser().commands.items():
            for option in set(parser._option_string_actions) - {"-h", "--help"}:
                self.assertIn("\n.B " + option.replace("-", "\\-"), sections[name])

    def test_info(self):
        found = self.answer("info", BUMPY)
        self.assertEqual((found["points"], found["polygons"], found["genus"]), (642, 1280, 0))
        self.assertEqual((found["kind"], found["components"]), ("surface", 1))
        corners = np.array(support.bumpy()[0])[support.triangles_of(self.mesh)].swapaxes(0, 1)
        products = np.cross(corners[1] - corners[0], corners[2] - corners[0])
        self.assertAlmostEqual(found["area"], np.linalg.norm(products, axis=1).sum() / 2)
        headed = out("head.xyz")
        with open(headed, "w", encoding="utf-8") as file:
            file.write("x y z\n0 0 0\n1 0 0\n")
        self.assertEqual(self.answer("info", headed)["points"], 2)
        x, y = np.meshgrid(np.arange(40.0), np.arange(10.0))
        for gap, components in ((0.0, 1), (20.0, 2)):
            path = out("gap.xyz")
            points = np.column_stack([(x + gap * (x > 19)).ravel(), y.ravel(), 0 * x.ravel()])
            vtkdgg.write(path, vtkdgg.Mesh(points))
            found = self.answer("info", path)
            self.assertEqual((found["spacing"], found["components"]), (1.0, components))
        self.assertEqual(self.answer("info", BUMPY, "--cloud")["kind"], "point cloud")

    def test_curves(self):
        path = out("curve.obj")
        self.answer("path", BUMPY, 5, 100, "--out", path)
        found = self.answer("info", path)
        self.assertEqual((found["kind"], found["lines"]), ("curves", 1))
        self.assertIn("--cloud uses the points only", found["warnings"][0])
        self.assertEqual(self.answer("info", path, "--cloud")["kind"], "point cloud")
        for name in (("distance", path, "--source", 0), ("loop", path), ("compare", path)):
            result = command(*name)
            self.assertEqual(result.returncode, 2)
            self.assertIn("contains curves and no surface; --cloud uses the poi", result.stderr)
        found = self.answer("distance", path, "--source", 0, "--cloud", "--method", "marching")
        self.assertGreater(found["largest"], 0.0)

    def test_answers(self):
        exact, tube = self.exact, out("tube.ply")
        vtkdgg.write(tube, support.polydata(*support.prism(9, 6)))
        first = "{},{},{}".format(*min(self.mesh.GetPoint(i) for i in range(642)))  # minus sign
        listed = out("sources.txt")
        with open(listed, "w", encoding="utf-8") as file:
            place = "  {} {} {}".format(*self.mesh.GetPoint(100))
            file.write(f"# id, coordinates, face\n5\n\n{place}\nface:3:0.2,0.3,0.5\n")
        far = vtkdgg.distance(self.mesh, [5, 100, (3, (0.2, 0.3, 0.5)), 300]).max()
        greens = vtkdgg.greens_function(self.mesh, [5, 7], method="Vertex").max(axis=0)
        count = int(exact.max() / 0.5)
        near = int((exact <= 1.0).sum())
        for line, key, expected, tolerance in (
            ("distance MESH --source 5", "largest", exact.max(), 1e-12),
            ("distance MESH --source 5 --maximum 1 --method exact", "reached", near, 0),
            *(
                (f"distance MESH --source 5 --method {method}", "largest", exact.max(), 0.04)
                for method in ("graph", "fast", "marching")
            ),
            (f"distance MESH --source-file {listed} --source 300", "largest", far, 1e-6),
            ("graph MESH --accuracy 0.05", "accuracy", 0.05, 0),
            ("path MESH 5 100", "length", exact[100], 1e-9),
            ("path MESH 5 100 --accuracy 0.05", "length", exact[100], 0.05),
            (f"path MESH {first} 5", "method", "exact", 0),
            ("isolines MESH --source 5 --values 0.5,1", "values", [0.5, 1.0], 0),
            ("isolines MESH --source 5 --values 0.5,1 --method exact", "values", [0.5, 1.0], 0),
            ("isolines MESH --source 5 --every 0.5", "values", 0.5 * np.arange(1, count + 1), 1e-9),
            (f"loop {tube}", "lengths", [9.0], 1e-6),
            (f"loop {tube} --through 28 --through 31 --through 34 --rope", "lengths", [9.0], 1e-6),
            ("sample MESH --number 12", "samples", 12, 0),
            ("voronoi MESH --number 6 --iterations 5", "sites", 6, 0),
            ("voronoi MESH --number 700 --in-faces", "sites", 700, 0),
            ("greens MESH --source 5 --source 7 --method Vertex", "largest", greens, 1e-9),
        ):
            with self.subTest(line):
                found = self.answer(line)[key]
                if isinstance(expected, str):
                    self.assertEqual(found, expected)
                else:
                    np.testing.assert_allclose(found, expected, rtol=tolerance)
        for line in ("isolines MESH --source 5", "isolines MESH --source 5 --method exact"):
            self.assertEqual(len(self.answer(line)["values"]), 10)

    def test_matrix(self):
        expected = vtkdgg.Graph(self.mesh, accuracy=0.05).matrix([0, 5, 9], [7, 500])
        file, graph = [BUMPY, "--accuracy", 0.05], out("matrix_graph.vtp")
        command("graph", *file, "--out", graph)
        asked = "--sources", "0,5,9", "--targets", "7,500", "--out"
        for where, origin in ((file, "built"), ([graph], "of the file")):
            for name in ("matrix.csv", "matrix.npy"):
                path = out(name)
                found = self.answer("matrix", *where, *asked, path)
                self.assertEqual((found["rows"], found["columns"]), (3, 2))
                self.assertEqual((found["graph"], found["largest"]), (origin, expected.max()))
                load = np.load if name.endswith("npy") else lambda p: np.loadtxt(p, delimiter=",")
                np.testing.assert_array_equal(load(path), expected)
        cloud = ["--cloud"] if HAS_CLOUDS else []
        place = "{},{},{}".format(*self.mesh.GetPoint(7))
        self.answer("matrix", BUMPY, *cloud, "--source", place, "--source", "9", "--out", path)
        self.assertEqual(np.load(path).shape, (2, 2))
        # After an error the older file is unchanged.
        for older in (out("old.npy"), out("old.csv")):
            command("matrix", BUMPY, "--source", "9", "--out", older)
            with open(older, "rb") as file:
                before = file.read()
            for source in ("9,9,9", "642"):
                result = command("matrix", BUMPY, "--source", source, "--out", older)
                self.assertEqual(result.returncode, 2)
            with open(older, "rb") as file:
                self.assertEqual(file.read(), before)
        self.assertEqual([name for name in os.listdir(FOLDER) if ".part" in name], [])

    def test_graph_of_the_file(self):
        path = out("fine.vtp")
        self.answer("graph", BUMPY, "--accuracy", 0.003, "--out", path)
        source = "--source", 5
        for asked in (
            ("distance", path, *source),
            ("path", path, 5, 100),
            ("isolines", path, *source, "--values", "1"),
            ("loop", path, "--through", 5, "--through", 100, "--through", 300, "--rope"),
            ("sample", path, "--number", 3),
            ("voronoi", path, "--number", 3),
            ("graph", path),
        ):
            with self.subTest(command=asked[0]):
                found = self.answer(*asked)
                used = [found[key] for key in ("method", "accuracy", "graph", "warnings")]
                self.assertEqual(used, ["graph", 0.003, "of the file", []])
                found = self.answer(*asked, "--accuracy", 0.002)
                if asked[0] == "graph":
                    self.assertEqual((found["accuracy"], found["graph"]), (0.002, "built"))
                else:
                    self.assertEqual((found["accuracy"], found["graph"]), (0.003, "of the file"))
                    self.assertIn("but --accuracy is 0.002", found["warnings"][-1])
        for asked in (("distance", path, *source), ("path", path, 5, 100)):
            self.assertEqual(self.answer(*asked, "--method", "exact")["method"], "exact")
        self.assertEqual(self.answer("info", path)["graph"], "Guaranteed, accuracy 0.003, current")
        stale, moved = out("stale.vtp"), vtkdgg.read(path)
        moved.points[7] *= 1.01
        vtkdgg.write(stale, moved)
        self.assertIn("accuracy 0.003. The graph on ", self.answer("info", stale)["graph"])
        del moved.field_data["DGG.Info"]
        vtkdgg.write(stale, moved)
        self.assertIn("damaged: ", self.answer("info", stale)["graph"])
        damaged = vtkdgg.read(path)
        damaged.field_data["DGG.Lengths"][100] = 7.0
        vtkdgg.write(path, damaged)
        for more, accuracy in (((), 0.003), (("--accuracy", 0.05), 0.05)):
            found = self.answer("distance", path, *source, *more)
            self.assertEqual((found["accuracy"], found["graph"]), (accuracy, "built"))
            self.assertIn("is damaged", found["warnings"][0])
        found = self.answer("distance", BUMPY, *source, "--accuracy", 0.05)
        self.assertEqual((found["accuracy"], found["graph"]), (0.05, "built"))

    def test_graph_is_left_out(self):
        path, kept, again = out("without.vtp"), out("with.vtp"), out("again.vtp")
        asked = "--source", 5, "--method", "graph", "--out"
        self.answer("distance", BUMPY, *asked, path)
        self.assertEqual(vtkdgg.read(path).field_data, {})
        self.answer("graph", BUMPY, "--out", kept)
        self.answer("distance", kept, *asked, again)
        self.assertIn("DGG.Info", vtkdgg.read(again).field_data)
        np.testing.assert_array_equal(array_of(path), array_of(again))

    def test_valid_json(self):
        def refuse(name):
            self.fail(f"{name} is not JSON")

        two = out("parts.off")
        points, triangles = support.grid(2, 2)
        points = np.vstack([points, points + [9, 0, 0]])
        vtkdgg.write(two, support.polydata(points, np.vstack([triangles, triangles + 9])))
        for asked in (("sample", two, "--number", 1), ("voronoi", two, "--site", 0)):
            result = command(*asked, "--json")
            found = json.loads(result.stdout, parse_constant=refuse)
            if asked[0] == "sample":
                self.assertIsNone(found["covering radius"])
                self.assertIn("larger --number", found["warnings"][-1])

    def test_without_arguments(self):
        result = command()
        self.assertEqual((result.returncode, result.stderr), (2, ""))
        self.assertRegex(result.stdout, r"(?m)^    distance +Distances")

    def test_notes_name_options(self):
        points, triangles = support.grid(3, 3)
        for name, mesh, asked, pattern in (
            ("seam", [points, points + [3, 0, 0]], "distance --source 0", "Turn on --merge if"),
            ("parts", [points, points + [9, 0, 0]], "sample --number 1", "larger --number"),
            ("one", [points], "sample --number 99", "subdivide the surface"),
            ("one", [points], "greens --source 5", "Refine the mesh there"),
            ("long", [points * [1, 20, 1]], "distance --source 5 --method fast", "distances or a graph"),
        ):
            path = out(f"{name}.off")
            cells = np.vstack([triangles + 16 * i for i in range(len(mesh))])
            vtkdgg.write(path, support.polydata(np.vstack(mesh), cells))
            word, *rest = asked.split()
            with self.subTest(asked=asked):
                result = command(word, path, *rest)
                self.assertRegex(result.stdout, f"note .*{pattern}")
                self.assertNotRegex(result.stdout.split("note", 1)[1], CPLUSPLUS)
        result = command("path", os.path.join(FOLDER, "parts.off"), 0, 20)
        self.assertRegex(result.stderr, "--merge may join them")

    def test_formats(self):
        curves, scalars = ".csv .npy .obj .vtk .vtp", ".csv .npy .pcd .ply .vtk .vtp"
        points = ".csv .npy .obj .off .pcd .ply .vtk .vtp .xyz"
        field = "distance", BUMPY, "--source", 5, "--out"
        for arguments, known in (
            (("path", BUMPY, 5, 100, "--out", out("p.stl")), curves),
            (("path", BUMPY, 5, 100, "--out", out("p.ply")), curves),
            (("isolines", BUMPY, "--source", 5, "--out", out("i.pcd")), curves),
            (("matrix", BUMPY, "--source", 5, "--out", out("m.vtp")), ".csv .npy"),
            (("loop", BUMPY, "--through", 5, "--out", out("l.off")), curves),
            (("graph", BUMPY, "--out", out("g.ply")), ".vtk .vtp"),
            (("sample", BUMPY, "--number", 3, "--out", out("s.stl")), points),
            (("render", BUMPY, "--source", 5, "--out", out("r.jpg")), ".png"),
            *(((*field, out(f"d{kind}")), scalars) for kind in (".obj", ".off", ".stl", ".xyz")),
            (("voronoi", BUMPY, "--number", 3, "--out", out("v.obj")), scalars),
        ):
            result = command(*arguments)
            self.assertEqual((result.returncode, result.stdout), (2, ""))
            self.assertRegex(
                result.stderr, rf"cannot store .*; expected {re.escape(known)} \(--help"
            )
            self.assertFalse(os.path.exists(arguments[-1]))
        result = command("voronoi", BUMPY, "--number", 3, "--out", out("v.pcd"))
        self.assertEqual(result.returncode, 2)
        self.assertIn("cannot store cells of a mesh; expected .csv .npy .ply .vtk", result.stderr)
        for extension, lost in ((".vtp", ""), (".vtk", ""), (".ply", ""), (".pcd", "polygons")):
            path = out("distance" + extension)
            note = f"{extension} does not store {lost}; .vtk and .vtp do"
            self.assertEqual(self.answer(*field, path)["warnings"], [note] if lost else [])
            self.assertEqual(f"note         {note}" in command(*field, path).stdout, bool(lost))
            written = vtkdgg.read(path)
            np.testing.assert_array_equal(written.point_data["GeodesicDistance"], self.exact)
            self.assertEqual(len(written.polygons[1]) > 0, not lost)
        said = " ".join(command("sample", "--help").stdout.split())
        self.assertIn(".vtk and .vtp keep all arrays", said)

    def test_tables(self):
        """Answers in .csv and .npy files."""
        csv, npy = out("answer.csv"), out("answer.npy")
        for path in (csv, npy):
            self.answer("distance", BUMPY, "--source", 5, "--out", path)
        np.testing.assert_array_equal(np.load(npy), self.exact)
        table = np.genfromtxt(csv, delimiter=",", names=True)
        np.testing.assert_array_equal(table["GeodesicDistance"], self.exact)
        self.assertEqual([table[i][7] for i in "xyz"], list(self.mesh.GetPoint(7)))
        for path in (csv, npy):
            found = self.answer("path", BUMPY, 5, 100, "--out", path)
        table = np.load(npy)
        self.assertEqual(table["vtkOriginalPointIds"][[0, -1]].tolist(), [5, 100])
        points = np.column_stack([table[i] for i in "xyz"])
        np.testing.assert_array_equal(points, found["points"])
        self.assertAlmostEqual(support.length_of(points), found["length"])
        names = np.genfromtxt(csv, delimiter=",", names=True).dtype.names
        self.assertEqual(names, table.dtype.names)
        lines = self.answer("isolines", BUMPY, "--source", 5, "--count", 3, "--out", npy)["lines"]
        table = np.load(npy)
        self.assertEqual([len(np.unique(table[n])) for n in ("line", "IsoValue")], [lines, 3])
        found = self.answer("sample", BUMPY, "--number", 12, "--out", npy)
        self.assertEqual(np.load(npy)["vtkOriginalPointIds"].tolist(), found["ids"])
        self.answer("voronoi", BUMPY, "--site", 5, "--site", 100, "--out", npy)
        nearest = vtkdgg.Graph(self.mesh).voronoi([5, 100]).nearest
        np.testing.assert_array_equal(np.load(npy), nearest)
        cells = out("cells.vtp")
        self.answer("voronoi MESH --site 5 --site 100 --out", cells)
        self.assertIn("SiteId", vtkdgg.read(cells).cell_data)

    def test_render(self):
        first, second = out("first.png"), out("second.png")
        kept = out("kept.vtp")
        self.answer("distance", BUMPY, "--source", 5, "--out", kept)
        for arguments in ((BUMPY, "--source", 5, "--out", first), (kept, "--out", second)):
            result = support.command("render", *arguments)
            self.assertEqual(result.returncode, 0, result.stderr)
        self.assertGreater(support.number_of_colours(first), 1000)
        difference = np.abs(support.pixels(first) - support.pixels(second)).max(axis=2)
        self.assertLess((difference > 12).mean(), 1e-4)

    def test_missing_display(self):
        """Only the program replaces its process, by one with a virtual display."""
        arguments = ["render", BUMPY, "--source", "0", "--out", out("display.png")]
        with mock.patch.dict(os.environ), mock.patch("os.execvpe", side_effect=SystemExit) as start:
            os.environ.pop("DISPLAY", None)
            result = command(*arguments)
            self.assertEqual(result.returncode, 2)
            self.assertRegex(result.stderr, r"\Aerror: there is no display to draw with; ")
            start.assert_not_called()
            with mock.patch("shutil.which"), mock.patch("sys.argv", ["vtkdgg", *arguments]):
                self.assertRaises(SystemExit, script)
            self.assertEqual(start.call_args[0][1][-6:], arguments)

    def test_views(self):
        # A flat L seen from the top: x to the right, y up; from below it is mirrored.
        points = np.array([[0, 0, 0], [3, 0, 0], [3, 1, 0], [1, 1, 0], [1, 3, 0], [0, 3, 0]], float)
        path, picture = out("letter.off"), out("letter.png")
        cells = [[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 5]]
        vtkdgg.write(path, support.polydata(points, cells))
        for view, empty in (("top", (1, 1)), ("0,0,2", (1, 1)), ("bottom", (0, 1))):
            asked = "render", path, "--source", 0, f"--view={view}", "--out", picture
            result = support.command(*asked)
            self.assertEqual(result.returncode, 0, result.stderr)
            image = support.pixels(picture)[:, :1280]
            rows, columns = np.nonzero(np.ptp(image, axis=2) > 60)  # coloured ones
            rows = 2 * (rows - rows.min()) // (np.ptp(rows) + 1)
            columns = 2 * (columns - columns.min()) // (np.ptp(columns) + 1)
            counts = np.bincount(2 * rows + columns, minlength=4).reshape(2, 2)
            self.assertEqual(np.unravel_index(counts.argmin(), (2, 2)), empty)

    def test_render_another_array(self):
        kept, picture = out("error.vtp"), out("error.png")
        wave = np.sin(10.0 * self.exact)
        arrays = {"ErrorPercent": wave, "RelativeError": wave, "ExactDistance": self.exact}
        vtkdgg.write(kept, with_arrays(self.mesh, arrays))
        images = []
        for name in arrays:
            result = support.command("render", kept, "--array", name, "--out", picture)
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertEqual("isolines every" in result.stdout, name == "ExactDistance")
            images.append(support.pixels(picture))
        left = np.arange(1600) < 1280  # left of the scalar bar, whose title is the name
        differs = (images[0] != images[1]).any(axis=(0, 2))
        self.assertTrue(differs.any() and not differs[left].any())
        ink = [np.count_nonzero(image[:, left].max(axis=2) < 60) for image in images]
        self.assertLess(10 * ink[0], ink[2])

    @support.needs_clouds
    def test_clouds(self):
        cloud = out("cloud.pcd")
        vtkdgg.write(cloud, vtkdgg.Mesh(support.plane(41, 21)))
        self.assertEqual(self.answer("info", cloud)["kind"], "point cloud")
        kept = out("cloud.vtp")
        self.assertGreater(self.answer("graph", cloud, "--out", kept)["edges"], 861)
        found = self.answer("distance", cloud, "--source", 0)
        again = self.answer("distance", kept, "--source", 0)
        self.assertEqual((found.pop("graph"), again.pop("graph")), ("built", "of the file"))
        points_only = out("points_only.vtp")  # with the polygons of the mesh
        self.answer("graph", BUMPY, "--cloud", "--out", points_only)
        used = self.answer("distance", points_only, "--source", 5)["graph"]
        self.assertEqual(used, "of the file")
        self.assertEqual(again, found)
        self.assertAlmostEqual(found["largest"], np.sqrt(5.0), delta=0.02)
        self.assertAlmostEqual(
            self.answer("path", cloud, 0, 860)["length"], np.sqrt(5.0), delta=0.03
        )
        self.assertEqual(self.answer("voronoi", cloud, "--number", 4)["sites"], 4)
        for name in ("loop", "greens --source 0", "isolines --source 0"):
            name, *rest = name.split()
            result = command(name, cloud, *rest)
            self.assertEqual(result.returncode, 2)
            self.assertIn(f"contains no surface, which {name} needs", result.stderr)
        for method in ("exact", "fast"):
            result = command("distance", cloud, "--source", 0, "--method", method)
            self.assertEqual(result.returncode, 2)
            self.assertRegex(result.stderr, f"--method {method} .*expected graph or marching")
        rough = self.answer("distance", cloud, "--source", 0, "--method", "marching")
        self.assertAlmostEqual(rough["largest"], np.sqrt(5.0), delta=0.1)
        path = out("answer.vtp")
        for asked in ("distance --source 0 --method graph", "voronoi --site 3"):
            name, *rest = asked.split()
            self.answer(name, cloud, *rest, "--out", path)
            self.assertNotIn("DGG.Info", vtkdgg.read(path).field_data)

    def test_no_answer(self):
        two = out("two.ply")
        vtkdgg.write(two, support.polydata(*support.two_squares([5, 0, 0])))
        for arguments, pattern in (
            (("path", two, 0, 5), "not connected"),
            (("loop", BUMPY), "every loop contracts"),
            (("isolines", BUMPY, "--source", 5, "--every", 50), "--every 50 is above the largest"),
        ):
            result = command(*arguments)
            self.assertEqual((result.returncode, result.stdout), (1, ""))
            self.assertRegex(result.stderr, rf"\Ano answer: .*{pattern}")

    def test_mistakes(self):
        coloured = out("coloured.vtp")
        vtkdgg.write(coloured, with_arrays(self.mesh, {"Error": self.exact, "Colour": self.exact}))
        truncated = out("cut.ply")
        with open(BUMPY, "rb") as file, open(truncated, "wb") as cut:
            cut.write(file.read(4000))
        wrong = out("wrong.txt")
        with open(wrong, "w", encoding="utf-8") as file:
            file.write("5\n1 2\n")
        names = {
            "MESH": BUMPY, "TETRAHEDRON": TETRAHEDRON, "CUT": truncated, "WRONG": wrong,
            "FOLDER": FOLDER, "DEVICE": os.devnull, "PROGRAM": __file__, "COLOURED": coloured,
        }  # fmt: skip
        for line, pattern in MISTAKES:
            with self.subTest(line):
                arguments = [names.get(word, word) for word in shlex.split(line)]
                # Commands that draw start again where there is no display.
                start = support.command if arguments[:1] == ["render"] else command
                result = start(*arguments)
                self.assertEqual(result.returncode, 2, result.stdout + result.stderr)
                self.assertRegex(result.stderr, r"\Aerror: [^\n]+\n\Z")
                # Folders may have any names.
                self.assertNotRegex(re.sub(r"/\S+/", "", result.stderr), CPLUSPLUS)
                self.assertRegex(result.stderr, pattern)

    def test_interrupted(self):
        x, y = np.meshgrid(np.arange(250.0), np.arange(250.0))
        points, triangles = support.grid(249, 249)
        points[:, 2] = 3.0 * np.sin(x.ravel() / 5.0) * np.cos(y.ravel() / 7.0)
        path = out("large.vtp")
        vtkdgg.write(path, support.polydata(points, triangles))
        code = (
            "import sys; from vtkdgg.command_line import main; print(flush=True); sys.exit(main())"
        )
        running = subprocess.Popen(
            [sys.executable, "-c", code, "graph", path, "--accuracy", "0.001"],
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )
        running.stdout.readline()  # after the imports
        time.sleep(1.0)
        running.send_signal(signal.SIGINT)
        _, said = running.communicate(timeout=60)
        self.assertEqual((running.returncode, said), (130, "interrupted\n"))


if __name__ == "__main__":
    unittest.main()
