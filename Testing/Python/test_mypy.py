# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""mypy on the stubs, in a virtual environment beside the VTK that the package was built with."""

import os
import re
import subprocess
import tempfile
import unittest
import venv

import vtkdgg

UNREACHED = "NewConnectionError|NameResolutionError|ConnectTimeout|ReadTimeout|ProxyError"


class Types(unittest.TestCase):
    def run_module(self, python, *words, cwd=None):
        return subprocess.run(
            [python, "-m", *words], cwd=cwd, capture_output=True, text=True, check=False
        )

    def test_stubs(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        venv.create(folder.name, system_site_packages=True, with_pip=True)
        python = os.path.join(folder.name, "bin", "python")
        found = self.run_module(python, "pip", "install", "--quiet", "--retries", "1", "mypy")
        if re.search(UNREACHED, found.stderr):
            self.skipTest(f"PyPI cannot be reached: {found.stderr.strip()[-200:]}")
        self.assertEqual(found.returncode, 0, found.stderr)
        package = os.path.dirname(vtkdgg.__file__)
        stubs = [name for name in os.listdir(package) if name.endswith(".pyi")]
        words = ("mypy", "--strict", "--follow-imports=silent", *stubs)
        found = self.run_module(python, *words, cwd=package)
        # VTK 9.1 has no stubs: its modules are skipped, and its classes are Any.
        known = "Skipping analyzing|Cannot find implementation|Class cannot subclass"
        errors = re.findall(rf'^.* error: (?!(?:{known}).* "vtk).*', found.stdout, re.M)
        self.assertIn("checked", found.stdout)
        self.assertEqual(errors, [])


if __name__ == "__main__":
    unittest.main()
