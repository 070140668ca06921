# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""The tests of meshes with the real packages of PyPI, and mypy on the stubs, in a virtual
environment beside the VTK that the package was built with."""

import os
import re
import subprocess
import tempfile
import unittest
import venv

import numpy as np
import vtkdgg

# PyVista 0.45 and newer needs a newer VTK than 9.1. None brings a VTK of its own.
PACKAGES = (
    "meshio==5.3.*",
    "nilearn==0.14.*",
    "open3d==0.20.*",
    "pyvista==0.44.2",
    "trimesh==5.2.*",
    "vedo==2026.6.*",
)
# Packages that these packages import.
REQUIRED = """
    Pygments addict configargparse dash flask joblib matplotlib nbformat nibabel packaging>=26.1
    pandas pillow plotly pooch requests rich scikit-learn scooby typing-extensions werkzeug
""".split()
UNREACHED = "NewConnectionError|NameResolutionError|ConnectTimeout|ReadTimeout|ProxyError"


def install(python, *arguments):
    """Install with pip."""
    found = subprocess.run(
        [python, "-m", "pip", "install", "--quiet", "--retries", "1", *arguments],
        capture_output=True,
        text=True,
        check=False,
    )
    if found.returncode != 0:
        if re.search(UNREACHED, found.stderr):
            raise unittest.SkipTest(f"PyPI cannot be reached: {found.stderr.strip()[-200:]}")
        raise AssertionError(found.stderr)


class OtherPackages(unittest.TestCase):
    def test_real_ones(self):
        folder = tempfile.TemporaryDirectory()  # more than a gigabyte
        self.addCleanup(folder.cleanup)
        venv.create(folder.name, system_site_packages=True, with_pip=True)
        python = os.path.join(folder.name, "bin", "python")
        major = int(np.__version__.split(".", 1)[0])
        install(python, *REQUIRED, f"numpy>={np.__version__},<{major + 1}")
        install(python, "--no-deps", *PACKAGES)
        for words in (["test_meshes.py"], ["test_reading.py", "Formats.test_nibabel"]):
            found = subprocess.run(
                [python, *words],
                cwd=os.path.dirname(os.path.abspath(__file__)),
                env={**os.environ, "DGG_REAL_PACKAGES": "1"},
                capture_output=True,
                text=True,
                check=False,
            )
            self.assertEqual(found.returncode, 0, found.stdout + found.stderr)
        install(python, "mypy")
        package = os.path.dirname(vtkdgg.__file__)
        stubs = [name for name in os.listdir(package) if name.endswith(".pyi")]
        found = subprocess.run(
            [python, "-m", "mypy", "--strict", "--follow-imports=silent", *stubs],
            cwd=package,
            capture_output=True,
            text=True,
            check=False,
        )
        # VTK 9.1 has no stubs: its modules are skipped, and its classes are Any.
        known = "Skipping analyzing|Cannot find implementation|Class cannot subclass"
        errors = re.findall(rf'^.* error: (?!(?:{known}).* "vtk).*', found.stdout, re.M)
        self.assertIn("checked", found.stdout)
        self.assertEqual(errors, [])


if __name__ == "__main__":
    unittest.main()
