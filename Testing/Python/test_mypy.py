# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""mypy on the stubs, and on a program that uses the package. Unless this Python has mypy, a virtual
environment gets it, beside the VTK that the package was built with."""

import importlib.util
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import venv

import vtkdgg

PROGRAM = """
import numpy as np
import vtkdgg
from vtkdgg import *
from vtkdgg import NotConnectedError, vtkDGGDistance

points, triangles = np.eye(3), np.array([[0, 1, 2]])
path([points, triangles], 0, 1).length + 1
vtkdgg.probe(points, triangles, [0, 1, 2], [points[0]]).shape
vtkdgg.vector_graphics(points, triangles, "curves.vtp").point_data
vtkdgg.patch_boundaries("a.ply", "b.ply", [0, 1], [0, 1], edges=[[0, 1]])[1][0].landmarks[1] + 1
function = vtkDGGDistance()
function.SetAccuracy(0.01)
function.SetSourceIds([0, 1])
vtkdgg.vtkApolloniusIsolines().SetMethodToApollonius()
"""
WRONG = """
path([points, triangles], 0, 1).size
vtkdgg.distance(points, triangles, 0, as_polydata="no")
vtkdgg.nothing
function.SetAccuracy("fine")
"""
UNREACHED = "NewConnectionError|NameResolutionError|ConnectTimeout|ReadTimeout|ProxyError"


class Types(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder, cls.python = folder.name, sys.executable
        if importlib.util.find_spec("mypy"):
            return
        venv.create(folder.name, system_site_packages=True, with_pip=True)
        cls.python = os.path.join(folder.name, "bin", "python")
        found = cls.run_module("pip", "install", "--quiet", "--retries", "1", "mypy")
        if re.search(UNREACHED, found.stderr):
            raise unittest.SkipTest(f"PyPI cannot be reached: {found.stderr.strip()[-200:]}")
        if found.returncode:
            raise AssertionError(found.stderr)

    @classmethod
    def run_module(cls, *words, cwd=None):
        environment = {**os.environ, "MYPYPATH": os.environ.get("PYTHONPATH", "")}
        return subprocess.run(
            [cls.python, "-m", *words],
            cwd=cwd or cls.folder, env=environment, capture_output=True, text=True, check=False,
        )  # fmt: skip

    def errors(self, *files, cwd=None):
        """Returns the messages of mypy on files, without those on a VTK that has no stubs."""
        words = ("mypy", "--strict", "--follow-imports=silent", *files)
        found = self.run_module(*words, cwd=cwd)
        # VTK 9.1 has no stubs: its modules are skipped, and its classes are Any.
        known = "Skipping analyzing|Cannot find implementation|Class cannot subclass"
        self.assertRegex(found.stdout, "checked|no issues", found.stderr)
        return re.findall(rf'^.* error: (?!(?:{known}).* "vtk).*', found.stdout, re.M)

    def test_stubs(self):
        # A copy, because mypy would take other modules beside the package for parts of the program.
        copy = os.path.join(self.folder, "copy")
        package = os.path.join(copy, "vtkdgg")
        shutil.copytree(os.path.dirname(vtkdgg.__file__), package)
        stubs = [f"vtkdgg/{name}" for name in os.listdir(package) if name.endswith(".pyi")]
        self.assertEqual(self.errors(*stubs, cwd=copy), [])

    def test_program(self):
        """A program has no errors, except those of its wrong lines, one each."""
        path = os.path.join(self.folder, "program.py")
        with open(path, "w", encoding="utf-8") as file:
            file.write(PROGRAM + WRONG)
        first = len(PROGRAM.splitlines()) + 1
        expected = list(range(first + 1, first + len(WRONG.splitlines())))
        lines = [int(text.split(":")[1]) for text in self.errors("program.py")]
        self.assertEqual(lines, expected)


if __name__ == "__main__":
    unittest.main()
