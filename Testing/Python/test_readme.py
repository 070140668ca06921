# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""The pages of the documentation: their code runs, and their links exist."""

import contextlib
import io
import os
import re
import shutil
import unittest
import warnings

import numpy as np
import pages
import support
import vtkdgg
from support import BUMPY, HAS_CLOUDS, run
from vtkdgg.commands.words import HELP
from vtkmodules.util.numpy_support import vtk_to_numpy


FOLDER = support.output_folder("readme")


def path_of(name, mesh=None):
    """Returns the path of a file of a page, with this mesh or with the bumpy sphere."""
    path = os.path.join(FOLDER, name)
    shutil.copy(BUMPY, path) if mesh is None else vtkdgg.write(path, mesh)
    return path


def cloud_of(name):
    """Returns the path of a PCD file of 1500 points of a sphere."""
    return path_of(name, vtkdgg.Mesh(support.sphere_points(1500)))


def execute(block, names):
    """Runs a block, and returns the text that it prints."""
    with contextlib.redirect_stdout(io.StringIO()) as printed:
        exec(block, names)  # noqa: S102
    return printed.getvalue()


def code(*path):
    """Returns a source file of the examples without its license lines."""
    with open(os.path.join(support.EXAMPLES, *path), encoding="utf-8") as file:
        return "".join(line for line in file if "SPDX-" not in line)


class Pages(unittest.TestCase):
    def test_all_are_known(self):
        found = set()
        for folder, folders, files in os.walk(support.ROOT):
            folders[:] = [f for f in folders if not f.startswith(".") and f not in ("build", "out")]
            names = (name for name in files if name.endswith(".md"))
            found.update(os.path.relpath(os.path.join(folder, n), support.ROOT) for n in names)
        self.assertEqual(found, set(pages.PAGES))

    def test_front_page_is_short(self):
        self.assertLessEqual(len(pages.text_of("README.md").splitlines()), 150)

    def test_changes_begin_with_this_version(self):
        heading = re.search(r"(?m)^## ([\d.]+)", pages.text_of("CHANGELOG.md"))
        self.assertEqual(heading[1], vtkdgg.__version__)

    def test_links(self):
        for page in pages.PAGES:
            for target in pages.links(page):
                if re.match(r"https?:", target):
                    continue
                with self.subTest(page=page, target=target):
                    path, _, anchor = target.partition("#")
                    other = os.path.normpath(os.path.join(os.path.dirname(page), path))
                    other = other if path else page
                    self.assertTrue(os.path.exists(os.path.join(support.ROOT, other)))
                    if anchor:
                        self.assertIn(anchor, pages.anchors(other))

    def test_blocks_are_tested(self):
        # A new block needs a test below.
        counts = {
            ("README.md", "python"): 2,
            ("README.md", "cpp"): 1,
            ("Examples/README.md", "python"): len(Gallery.EXPECTED),
            ("Examples/Solved.md", "python"): 29,
            ("Examples/Tutorial.md", "python"): 5,
            ("Filters/Geodesic/Curves.md", "python"): 1,
            ("Filters/Geodesic/Distances.md", "python"): 1,
            ("Filters/Geodesic/Distances.md", "py"): 1,
            ("Filters/Geodesic/README.md", "python"): 2,
            ("Filters/Parallel/README.md", "cmake"): 1,
            ("Filters/Parallel/README.md", "cpp"): 1,
            ("Filters/Parallel/README.md", "python"): 1,
            ("Filters/PointCloud/README.md", "python"): 2,
            ("Filters/Spectral/README.md", "python"): 2,
            ("Readers/README.md", "python"): 2,
            ("Readers/README.md", "cpp"): 1,
            ("Wrapping/ParaView/README.md", "python"): 3,  # tested in ParaView
            ("Wrapping/Python/Files.md", "python"): 1,
            ("Wrapping/Python/Packages.md", "python"): 2,  # the second needs 3D Slicer
            ("Wrapping/Python/PyVista.md", "python"): 1,  # tested with PyVista
            ("Wrapping/Python/README.md", "python"): 2,
        }
        for page in pages.PAGES:
            for language in ("python", "py", "cpp", "cmake"):
                with self.subTest(page=page, language=language):
                    found = len(pages.blocks(page, language))
                    self.assertEqual(found, counts.get((page, language), 0))

    def test_all_classes_are_listed(self):
        # Abstract base classes are not listed, because users do not choose them.
        front = pages.text_of("README.md")
        for name in dir(vtkdgg):
            if name.startswith("vtk") and isinstance(getattr(vtkdgg, name), type):
                if not name.endswith(("Algorithm", "MeshReader")):
                    self.assertRegex(front, rf"\[[^\]]*\b{name}\b[^\]]*\]\(")


class FrontPage(unittest.TestCase):
    def test_ten_lines_of_python(self):
        self.assertEqual(code("Python", "ten_lines.py"), pages.blocks("README.md", "python")[0])
        path_of("mesh.ply")
        result = run("ten_lines.py", cwd=FOLDER)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertRegex(result.stdout, r"farthest point: \d\.\d+ model units away")

    def test_ten_lines_of_cxx(self):
        # Built and run by the tests of the install tree.
        self.assertEqual([code("Cxx", "TenLines.cxx")], pages.blocks("README.md", "cpp"))

    def test_many_queries(self):
        points, triangles = support.bumpy()
        names = {"points": points, "triangles": triangles}
        execute(pages.blocks("README.md", "python")[1], names)
        exact = vtkdgg.distance(points, triangles, 0)
        self.assertTrue((np.abs(names["d"] - exact) <= 0.01 * exact * (1 + 1e-6)).all())


class PythonPage(unittest.TestCase):
    def test_blocks(self):
        one_line, several = pages.blocks("Wrapping/Python/README.md", "python")
        names = {}
        execute(one_line, names)
        np.testing.assert_allclose(names["d"], [0.0, 3.0, 4.0], rtol=1e-12)
        points, triangles = support.bumpy()
        names = {"points": points, "triangles": triangles}
        execute(several, names)
        exact = vtkdgg.distance(points, triangles, [0, 10, 20])
        self.assertTrue((np.abs(names["d"] - exact) <= 0.01 * exact * (1 + 1e-6)).all())
        self.assertEqual(names["m"].shape, (2, 3))
        self.assertEqual(len({line.value for line in names["lines"]}), 10)
        self.assertEqual(names["cells"].areas.shape, (20,))
        length = vtkdgg.path(points, triangles, 0, 10).length
        self.assertTrue(length * (1 - 1e-9) <= names["p"].length <= 1.01 * length)

    def test_files(self):
        (page,) = pages.blocks("Wrapping/Python/Files.md", "python")
        block = page.replace('"mesh.ply"', repr(path_of("mesh.ply")))
        block = block.replace('"distance.ply"', repr(os.path.join(FOLDER, "distance.ply")))
        names = {}
        self.assertIn(f"# {execute(block, names).strip()}\n", page)
        written = vtkdgg.read(os.path.join(FOLDER, "distance.ply"))
        np.testing.assert_array_equal(written.point_data["distance"], names["d"])

    def test_other_packages(self):
        names = {}
        execute(pages.blocks("Wrapping/Python/Packages.md", "python")[0], names)
        points, triangles = support.bumpy()
        expected = vtkdgg.distance(points, triangles, 0)
        np.testing.assert_array_equal(names["gdist"].compute_gdist(points, triangles), expected)
        names["pp3d"].validate_mesh(points, triangles)
        names["geodesic"].PyGeodesicAlgorithmExact(points, triangles)

    def test_from_the_shell(self):
        lines = pages.blocks("Wrapping/Python/Shell.md", "sh")[0].splitlines()
        self.assertEqual(len(lines), 7)
        path_of("mesh.ply")
        for line in lines:
            words = line.replace(" 1.5,2,0", " 300").replace(" 1000", " 600").split()
            self.assertEqual(words[0], "vtkdgg")
            is_file = re.compile(r"[a-z]+\.[a-z]+").fullmatch
            words = [os.path.join(FOLDER, word) if is_file(word) else word for word in words[1:]]
            result = support.command(*words)
            self.assertEqual(result.returncode, 0, result.stderr)

    def test_keys_of_the_explorer(self):
        page = pages.text_of("Wrapping/Python/Shell.md")
        keys = re.findall(r"(?m)^(\S)(?: and (\S))?: ", HELP)
        self.assertEqual(len(keys), 11)
        for key in filter(None, (key for pair in keys for key in pair)):
            self.assertIn(f"`{key}`", page)


class Solved(unittest.TestCase):
    """The answers run one after the other, as the page says."""

    @classmethod
    def setUpClass(cls):
        names = cls.names = {}
        cls.printed = []
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", RuntimeWarning)
            for block in pages.blocks("Examples/Solved.md", "python"):
                if "CloudGraph" not in block or HAS_CLOUDS:
                    cls.printed += execute(block.replace("mesh.ply", BUMPY), names).splitlines()

    def test_distances(self):
        names = self.names
        closest = np.linalg.norm(names["points"] - names["curve"].points[5], axis=1).argmin()
        self.assertLess(names["from_curve"][closest], 0.2)
        hits = vtk_to_numpy(names["hits"].GetData())
        self.assertLess(np.linalg.norm(hits - names["middle"], axis=1).min(), 1e-6)
        self.assertEqual(hits[:, 2].argmax(), 0)
        matrix = names["matrix"]
        np.testing.assert_array_equal(matrix, matrix.T)
        np.testing.assert_allclose(matrix[[0, 50, 100]], names["fields"], rtol=0.02)
        close = names["close"].toarray()
        np.testing.assert_array_equal(close > 0, (matrix <= 0.3) & (matrix > 0))
        self.assertEqual(set(names["labels"]), {"front", "top", "back"})
        self.assertLess(names["error"].mean(), 0.02)

    def test_paths(self):
        names = self.names
        path = names["path"] if not HAS_CLOUDS else names["graph"].path(0, 100)
        self.assertEqual([names["corners"][0], names["corners"][-1]], [0, 100])
        self.assertGreater(len(names["crossed"]), 5)
        self.assertGreaterEqual(path.length, names["exact"][100] * (1 - 1e-9))
        self.assertIn("start and end are not connected", "".join(self.printed))
        self.assertEqual(names["loops"], [])

    def test_curves_and_regions(self):
        names = self.names
        self.assertEqual({line.value for line in names["offsets"]}, {0.1, 0.2})
        self.assertEqual({line.value for line in names["lines"]}, {0.25, 0.5, 0.75})
        self.assertGreater(names["bands"].GetNumberOfCells(), 100)
        self.assertTrue(0.3 < names["area"] < np.pi * 0.25)
        further = names["around"] - names["exact"]
        self.assertGreater(np.nanmin(further), -1e-9)
        self.assertGreater(np.nanmax(further), 0.05)
        self.assertEqual(names["cells"].areas.shape, (30,))

    def test_input(self):
        names = self.names
        soup = vtkdgg.distance(names["soup"], names["apart"], 0, merge_coincident_points=True)
        at = names["triangles"].ravel()
        start = names["triangles"][0, 0]
        exact = vtkdgg.distance(names["points"], names["triangles"], int(start))
        np.testing.assert_allclose(soup, exact[at], rtol=1e-9)
        self.assertIn("1 point is on no triangle", self.printed)


class Gallery(unittest.TestCase):
    """The snippets run one after the other, as the page says."""

    # A part of each snippet, and the pattern of the text that it prints.
    EXPECTED = (
        ("vtkDGGPLYReader()", ""),
        ("vtkDiscreteGeodesicGraph()", r"\d\d\.\d edges per point"),
        ("vtkDGGDistance()", r"(farthest from \d+: \d\.\d+ model units away\n?){3}"),
        ("vtkGeodesicDistanceMatrix()", r"from 10 to 40: (\S+)"),
        ("vtkExactGeodesicDistance()", r"farthest point: (\S+) model units away"),
        (
            "vtkdgg.vtkHeatGeodesicDistance,",
            r"(\w+: farthest point \d\.\d+ model units away\n?){4}",
        ),
        ("vtkGeodesicProbe()", r"farthest triangle: \d\.\d+ model units away"),
        ("vtkDGGPath()", r"from 0 to 20: (\S+) model units"),
        ("vtkDGGLoop()", r"1 loops, two for each handle"),
        ("vtkApolloniusIsolines()", r"True True"),
        ("vtkGeodesicPatchBoundaries()", r"6 curves on each surface; .*"),
        ("vtkGeodesicSampler()", r"no point of the mesh is farther than 0\.\d+ model units .*"),
        ("vtkGeodesicVoronoi()", r"the cells have areas from \d\S* to \d\S*"),
        ("vtkDiscreteGreensFunction()", r"from 0 to 10: (\S+)"),
        ("vtkBiharmonicDistance()", r"farthest point: (\S+) model units away"),
        ("vtkSurfaceEarthMoversDistance()", r"mass is moved by (\S+) model units on average"),
        ("vtkHarmonicBSpline()", r"40 functions with the sum 1\.0"),
        ("SetOrderToBiharmonic()", r"from 1\d\S* to 2\d\S* degrees"),
        ("vtkPoissonVectorGraphics()", r"colors of (\d+) points"),
        ("vtkPointCloudDGG()", r"farthest point: (\S+) model units away"),
    )

    @classmethod
    def setUpClass(cls):
        cls.names = {}
        cls.printed = {}
        cls.blocks = pages.blocks("Examples/README.md", "python")
        for block, (key, _) in zip(cls.blocks, cls.EXPECTED):
            if key == "vtkPointCloudDGG()":
                if HAS_CLOUDS:
                    block = block.replace("cloud.pcd", cloud_of("sphere.pcd"))
                    cls.printed[key] = execute(block, {}).strip()
                continue
            if key == "vtkDGGLoop()":  # a surface with a loop: a tube with nine sides of length 1
                reader = cls.names["reader"]
                reader.SetFileName(path_of("prism.ply", vtkdgg.Mesh(*support.prism(9, 6))))
                cls.printed[key] = execute(block, cls.names).strip()
                reader.SetFileName(BUMPY)
                continue
            cls.printed[key] = execute(block.replace("mesh.ply", BUMPY), cls.names).strip()

    def number(self, key):
        return float(re.fullmatch(dict(self.EXPECTED)[key], self.printed[key])[1])

    def test_prints(self):
        for block, (key, said) in zip(self.blocks, self.EXPECTED):
            with self.subTest(key):
                self.assertIn(key, block)
                self.assertLessEqual(len([line for line in block.splitlines() if line]), 20)
                if key in self.printed:
                    self.assertRegex(self.printed[key], rf"\A{said}\Z")

    def test_answers(self):
        exact = vtkdgg.distance(*support.bumpy(), 0)
        self.assertAlmostEqual(self.number("vtkExactGeodesicDistance()"), exact.max(), 12)
        self.assertAlmostEqual(self.number("vtkDGGPath()"), exact[20], delta=1e-6)
        length = self.names["loops"].GetCellData().GetArray("Length").GetValue(0)
        self.assertAlmostEqual(length, 9.0, delta=1e-6)  # the file has floats
        found = support.point_array(self.names["smooth"].GetOutput(), "Interpolation")
        for point, value in self.names["known"].items():
            self.assertAlmostEqual(found[point], value, 6)
        painted = self.names["painted"]
        self.assertGreater(painted.GetNumberOfPoints(), self.names["surface"].GetNumberOfPoints())
        self.assertEqual(painted.GetPointData().GetScalars().GetName(), "RGB")
        if HAS_CLOUDS:
            self.assertAlmostEqual(self.number("vtkPointCloudDGG()"), np.pi, delta=0.05)

    def test_examples_are_listed(self):
        page = pages.text_of("Examples/README.md")
        for folder, ending in (("Python", ".py"), ("Cxx", ".cxx")):
            for file in os.listdir(os.path.join(support.EXAMPLES, folder)):
                name, extension = os.path.splitext(file)
                is_part = name in ("example_arguments", "surface_canvas")
                if extension == ending and not is_part:
                    self.assertIn(f"`{name}`", page)

    def test_pictures(self):
        # Each picture of the folder is shown on some page.
        shown = {os.path.basename(link) for page in pages.PAGES for link in pages.links(page)}
        pictures = set(os.listdir(os.path.join(support.EXAMPLES, "Images")))
        self.assertEqual(pictures - shown, set())


class OtherPages(unittest.TestCase):
    def test_modules(self):
        for page, array in (
            ("Geodesic/README", "distances"),
            ("Geodesic/Distances", "distance"),
            ("Geodesic/Curves", "lengths"),
            ("Spectral/README", "columns"),
        ):
            with self.subTest(page):
                names = {}
                for block in pages.blocks(f"Filters/{page}.md", "python"):
                    execute(block.replace("mesh.ply", BUMPY), names)
                self.assertIn(array, names)

    @support.needs_clouds
    def test_cloud_in_one_solve(self):
        block = pages.blocks("Filters/PointCloud/README.md", "python")[0]
        names = {}
        execute(block.replace("cloud.pcd", cloud_of("solve.pcd")), names)
        self.assertAlmostEqual(names["distances"].GetRange()[1], np.pi, delta=0.05)

    def test_matrix_in_one_line(self):
        block = pages.blocks("Filters/Geodesic/Distances.md", "py")[0]
        self.assertIn(block.strip(), code("Python", "graph_csr.py"))

    def test_readers(self):
        meshes, clouds = pages.blocks("Readers/README.md", "python")
        with open(os.path.join(FOLDER, "mesh.obj"), "w", encoding="ascii") as file:
            file.write("v 0.1 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
        cloud_of("cloud.pcd")
        for block, first, copy, count in (
            (meshes, "mesh.obj", "copy.ply", 3),
            (clouds, "cloud.pcd", "copy.pcd", 1500),
        ):
            for name in (first, copy):
                block = block.replace(f'"{name}"', repr(os.path.join(FOLDER, name)))
            execute(block, {})
            written, read = (vtkdgg.read(os.path.join(FOLDER, name)) for name in (copy, first))
            self.assertEqual(len(written.points), count)
            np.testing.assert_array_equal(written.points[0], read.points[0])

    def test_lines_of_graphs_in_pieces(self):
        # Run under mpiexec by other tests, in Python and from the install tree.
        for language, program in (
            ("cpp", code("Cxx", "GraphInPieces.cxx")),
            ("cmake", code("Cxx", "CMakeLists.txt")),
            ("python", code("..", "Testing", "Python", "test_pieces.py")),
        ):
            for line in pages.blocks("Filters/Parallel/README.md", language)[0].splitlines():
                self.assertIn(line.strip(), program)

    def test_lines_of_clouds_of_pcl(self):
        # Built and run by the tests of the install tree.
        block = pages.blocks("Readers/README.md", "cpp")[0]
        self.assertIn("ToPolyData", block)
        program = code("Cxx", "PointCloud.cxx")
        for line in block.splitlines():
            line = line.split("//")[0].strip()
            if line and not line.startswith(("pcl::", "vtkDGG::From", "distance->AddSourceId")):
                self.assertIn(line, program)

    @support.needs_clouds
    def test_properties_of_point_clouds(self):
        page = pages.text_of("Filters/PointCloud/README.md")
        table = page[page.index("| property | default |") :].split("\n\n")[0]
        graph = vtkdgg.vtkPointCloudDGG()
        said = {}
        for row in table.splitlines()[2:]:
            names, defaults, _ = row.strip("| ").split(" | ")
            for name, default in zip(re.findall(r"`(\w+)`", names), defaults.split(", ")):
                said[name] = default.split(":")[0]
        words = {"C": graph.C, "on": True, "off": False}
        for name, default in said.items():
            value = words[default] if default in words else float(default)
            self.assertEqual(getattr(graph, "Get" + name)(), value, name)
        known = {name[3:] for name in dir(graph) if name.startswith("Set") and "Array" not in name}
        own = known & set(re.findall(r"Set(\w+)", " ".join(vars(vtkdgg.vtkPointCloudDGG))))
        self.assertEqual({name for name in own if not name.startswith("SchemeTo")}, set(said))

    @support.needs_clouds
    def test_scan_lines(self):
        # Lines 0.8 apart on a plane, with points 0.05 apart on them.
        x, y = np.meshgrid(np.arange(0.0, 10.0, 0.05), np.arange(0.0, 8.0, 0.8))
        points = np.column_stack([x.ravel(), y.ravel(), np.zeros(x.size)])
        cloud = support.polydata(points)
        graph = support.make("vtkPointCloudDGG", cloud)
        vtkdgg.check(graph)
        self.assertGreater(graph.GetNumberOfComponents(), 1)
        block = pages.blocks("Filters/PointCloud/README.md", "python")[1]
        execute(block, {"cloud": cloud, "graph": graph})
        vtkdgg.check(graph)
        self.assertEqual(graph.GetNumberOfComponents(), 1)


if __name__ == "__main__":
    unittest.main()
