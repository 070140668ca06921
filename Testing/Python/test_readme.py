# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""The code in the README."""

import contextlib
import io
import os
import re
import shutil
import unittest

import numpy as np
import support
import vtkdgg
from support import BUMPY, run
from vtkmodules.vtkIOPLY import vtkPLYWriter


class Readme(unittest.TestCase):
    """What the README shows is what is tested."""

    @classmethod
    def setUpClass(cls):
        with open(os.path.join(support.ROOT, "README.md"), encoding="utf-8") as file:
            cls.readme = file.read()

    def blocks(self, language):
        return re.findall(rf"^```{language}\n(.*?)^```$", self.readme, re.M | re.S)

    def code(self, *path):
        """A source file without its licence lines."""
        with open(os.path.join(support.EXAMPLES, *path), encoding="utf-8") as file:
            return "".join(line for line in file if "SPDX-" not in line)

    def test_ten_lines_of_python(self):
        self.assertIn(self.code("Python", "ten_lines.py"), self.blocks("python"))
        folder = support.output_folder("readme")
        shutil.copy(BUMPY, os.path.join(folder, "mesh.ply"))
        result = run("ten_lines.py", cwd=folder)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertRegex(result.stdout, r"farthest point: \d\.\d+ model units away")

    def test_ten_lines_of_cxx(self):
        # Built and run by the tests of the install tree.
        self.assertIn(self.code("Cxx", "TenLines.cxx"), self.blocks("cpp"))

    def test_one_liner(self):
        blocks = [block for block in self.blocks("python") if "vtkdgg.distance(" in block]
        self.assertEqual(len(blocks), 1)
        names = {}
        exec(blocks[0], names)  # noqa: S102
        np.testing.assert_allclose(names["d"], [0.0, 3.0, 4.0], rtol=1e-12)

    def test_many_queries(self):
        blocks = [block for block in self.blocks("python") if "vtkdgg.Graph(" in block]
        self.assertEqual(len(blocks), 1)
        points, triangles = support.bumpy()
        names = {"points": points, "triangles": triangles}
        exec(blocks[0], names)  # noqa: S102
        exact = vtkdgg.distance(points, triangles, [0, 10, 20])
        self.assertTrue((np.abs(names["d"] - exact) <= 0.01 * exact * (1 + 1e-6)).all())
        self.assertEqual(names["m"].shape, (2, 3))
        exact = vtkdgg.path(points, triangles, 0, 10)
        self.assertLessEqual(names["p"].length, exact.length * 1.01)
        self.assertGreaterEqual(names["p"].length, exact.length * (1 - 1e-9))

    def test_ten_lines_of_paths(self):
        blocks = [block for block in self.blocks("python") if "vtkDGGPath()" in block]
        self.assertEqual(len(blocks), 1)
        self.assertLessEqual(len([line for line in blocks[0].splitlines() if line]), 10)
        names = {}
        with contextlib.redirect_stdout(io.StringIO()) as printed:
            exec(blocks[0].replace("mesh.ply", BUMPY), names)  # noqa: S102
        exact = vtkdgg.distance(*support.bumpy(), 0)[20]
        said = re.fullmatch(r"from 0 to 20: (\S+) model units\n", printed.getvalue())
        self.assertAlmostEqual(float(said[1]), exact, delta=1e-6)

    def test_greens_functions(self):
        blocks = [block for block in self.blocks("python") if "vtkDiscreteGreensFunction()" in block]
        self.assertEqual(len(blocks), 1)
        names = {}
        with contextlib.redirect_stdout(io.StringIO()) as printed:
            exec(blocks[0].replace("mesh.ply", BUMPY), names)  # noqa: S102
        said = re.fullmatch(
            r"from 0 to 10: (\S+)\nfarthest point: (\S+) model units away\n", printed.getvalue()
        )
        greens = names["greens"].GetOutput().GetPointData().GetArray("GreensFunction")
        self.assertAlmostEqual(float(said[1]), greens.GetComponent(0, 1), 2)
        farthest = vtkdgg.distance(*support.bumpy(), 0).max()
        self.assertTrue(0.05 * farthest < float(said[2]) < farthest)

    def test_vector_graphics(self):
        blocks = [
            block for block in self.blocks("python") if "vtkPoissonVectorGraphics()" in block
        ]
        self.assertEqual(len(blocks), 1)
        names = {}
        with contextlib.redirect_stdout(io.StringIO()) as printed:
            exec(blocks[0].replace("mesh.ply", BUMPY), names)  # noqa: S102
        painted = names["painted"]
        self.assertEqual(printed.getvalue(), f"colours of {painted.GetNumberOfPoints()} points\n")
        self.assertGreater(painted.GetNumberOfPoints(), names["surface"].GetNumberOfPoints())
        self.assertEqual(painted.GetPointData().GetScalars().GetName(), "RGB")
        colors = painted.GetPointData().GetArray("Colors")
        self.assertAlmostEqual(colors.GetRange(0)[0], 0.1, 6)
        self.assertAlmostEqual(colors.GetRange(0)[1], 1.0, 6)

    def test_ten_lines_of_loops(self):
        blocks = [block for block in self.blocks("python") if "vtkDGGLoop()" in block]
        self.assertEqual(len(blocks), 1)
        path = os.path.join(support.output_folder("pipeline"), "prism.ply")
        writer = vtkPLYWriter()
        writer.SetInputData(support.polydata(*support.prism(9, 6)))
        writer.SetFileName(path)
        vtkdgg.check(writer)
        names = {}
        with contextlib.redirect_stdout(io.StringIO()) as printed:
            exec(blocks[0].replace("mesh.ply", path), names)  # noqa: S102
        self.assertEqual(printed.getvalue(), "1 loops, the shortest one 9 model units long\n")

    def test_other_blocks_run(self):
        for name, said in (
            ("vtkGeodesicSampler()", r"no point of the mesh is farther than 0\.\d+ model units .*"),
            ("vtkGeodesicVoronoi()", r"the cells have areas of \d\S* \d\S* \d\S*"),
            ("vtkGeodesicPatchBoundaries()", r"6 curves on each surface; .*"),
            ("vtkGeodesicProbe()", r"farthest triangle: \d\.\d+ model units away"),
            ("GeodesicDistance\")()", r"(\w+: farthest point \d\.\d+ model units away\n?){3}"),
        ):
            with self.subTest(name):
                blocks = [block for block in self.blocks("python") if name in block]
                self.assertEqual(len(blocks), 1)
                with contextlib.redirect_stdout(io.StringIO()) as printed:
                    exec(blocks[0].replace("mesh.ply", BUMPY), {})  # noqa: S102
                self.assertRegex(printed.getvalue().strip(), rf"\A{said}\Z")

    def write_cloud(self, name):
        """A PCD file of points on the unit sphere, evenly spread; its folder."""
        folder = support.output_folder("readme")
        i = np.arange(1500)
        z = 1.0 - (2.0 * i + 1.0) / len(i)
        angle = np.pi * (3.0 - np.sqrt(5.0)) * i
        radius = np.sqrt(1.0 - z * z)
        points = np.column_stack([radius * np.cos(angle), radius * np.sin(angle), z])
        writer = vtkdgg.vtkPCDWriter()
        writer.SetInputData(support.polydata(points, np.empty((0, 3), dtype=int)))
        writer.SetFileName(os.path.join(folder, name))
        vtkdgg.check(writer)
        return folder

    @unittest.skipUnless(hasattr(vtkdgg, "vtkPointCloudDGG"), "built without PCL")
    def test_ten_lines_of_point_clouds(self):
        blocks = [block for block in self.blocks("python") if "vtkPointCloudDGG()" in block]
        self.assertEqual(len(blocks), 1)
        self.assertLessEqual(len([line for line in blocks[0].splitlines() if line]), 10)
        path = os.path.join(self.write_cloud("sphere.pcd"), "sphere.pcd")
        with contextlib.redirect_stdout(io.StringIO()) as printed:
            exec(blocks[0].replace("cloud.pcd", path), {})  # noqa: S102
        said = re.fullmatch(r"farthest point: (\S+) model units away\n", printed.getvalue())
        # The first point is near a pole.
        self.assertAlmostEqual(float(said[1]), np.pi, delta=0.05)

    @unittest.skipUnless(hasattr(vtkdgg, "vtkPointCloudDGG"), "built without PCL")
    def test_properties_of_point_clouds(self):
        table = self.readme[self.readme.index("| property | default |") :].split("\n\n")[0]
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

    def test_pcd_files(self):
        blocks = [block for block in self.blocks("python") if "vtkPCDWriter()" in block]
        self.assertEqual(len(blocks), 1)
        folder = self.write_cloud("cloud.pcd")
        code = blocks[0]
        for name in ("cloud.pcd", "copy.pcd"):
            code = code.replace(name, os.path.join(folder, name))
        names = {}
        exec(code, names)  # noqa: S102
        self.assertEqual(names["cloud"].GetNumberOfPoints(), 1500)
        reader = vtkdgg.vtkPCDReader()
        reader.SetFileName(os.path.join(folder, "copy.pcd"))
        self.assertEqual(vtkdgg.check(reader).GetNumberOfPoints(), 1500)

    def test_lines_of_clouds_of_pcl(self):
        # Built and run by the tests of the install tree.
        block = next(block for block in self.blocks("cpp") if "ToPolyData" in block)
        code = self.code("Cxx", "PointCloud.cxx")
        for line in block.splitlines():
            line = line.split("//")[0].strip()
            if line and not line.startswith(("pcl::", "vtkDGG::From", "distance->AddSourceId")):
                self.assertIn(line, code)

    def test_examples_are_listed(self):
        for folder, ending in (("Python", ".py"), ("Cxx", ".cxx")):
            for file in os.listdir(os.path.join(support.EXAMPLES, folder)):
                name, extension = os.path.splitext(file)
                is_part = name.startswith("demo_") or name in (
                    "cloud_discs",
                    "cloud_file",
                    "example_arguments",
                    "mesh_file",
                    "surface_canvas",
                )
                if extension == ending and not is_part:
                    self.assertIn(f"`{name}`", self.readme)

    def test_isolines(self):
        blocks = [block for block in self.blocks("python") if "vtkApolloniusIsolines()" in block]
        self.assertEqual(len(blocks), 1)
        with contextlib.redirect_stdout(io.StringIO()) as printed:
            exec(blocks[0].replace("mesh.ply", BUMPY), {})  # noqa: S102
        self.assertEqual(printed.getvalue(), "True True\n")

    def test_matrix_in_one_line(self):
        line = self.blocks("py")[0].strip()
        self.assertIn(line, self.code("Python", "graph_csr.py"))

    def test_links(self):
        for target in re.findall(r"\]\((?!https?:|#)([^)]+)\)", self.readme):
            self.assertTrue(os.path.exists(os.path.join(support.ROOT, target)), target)


if __name__ == "__main__":
    unittest.main()
