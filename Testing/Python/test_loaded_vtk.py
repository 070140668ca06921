# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Which classes the package offers with another VTK than the one that it was built with."""

import os
import shutil
import subprocess
import sys
import unittest

import support
import vtkdgg
from vtkdgg import build_info, loaded_vtk, property_table

PACKAGES = os.path.dirname(os.path.dirname(vtkdgg.__file__))


def import_with(version, *libraries, code="from vtkdgg import vtkDGGPLYReader"):
    """Runs code in a process whose vtkmodules is a stand-in of this version, after loading
    libraries."""
    folder = support.output_folder("another_vtk")
    os.makedirs(os.path.join(folder, "vtkmodules"), exist_ok=True)
    major, minor = version.split(".")
    with open(
        os.path.join(folder, "vtkmodules", "vtkCommonCore.py"), "w", encoding="utf-8"
    ) as file:
        file.write(
            "class vtkVersion:\n"
            f"    GetVTKMajorVersion = staticmethod(lambda: {major})\n"
            f"    GetVTKMinorVersion = staticmethod(lambda: {minor})\n"
        )
    with open(os.path.join(folder, "vtkmodules", "__init__.py"), "w", encoding="utf-8"):
        pass
    script = f"import ctypes, sys\nfor name in sys.argv[1:]: ctypes.CDLL(name)\n{code}"
    return subprocess.run(
        [sys.executable, "-c", script, *libraries],
        env={**os.environ, "PYTHONPATH": os.pathsep.join([folder, PACKAGES])},
        capture_output=True,
        text=True,
        check=False,
    )


class LoadedVTK(unittest.TestCase):
    def check_refused(self, result, *words):
        self.assertEqual(result.returncode, 1, result.stderr)  # an exception, not a crash
        reason = result.stderr.splitlines()[-1]
        self.assertRegex(reason, "^ImportError: vtkDGGPLYReader cannot be used: vtkdgg .* was built with VTK")
        for word in (build_info.VTK_VERSION, build_info.VTK_LIBRARY, "VTK_DIR", *words):
            self.assertIn(word, reason)

    def test_another_version(self):
        major, minor = build_info.VTK_VERSION.split(".")
        for version in (f"{major}.{int(minor) + 1}", f"{int(major) + 1}.{minor}"):
            with self.subTest(version):
                self.check_refused(import_with(version), f"loaded is VTK {version}")
                code = "import vtkdgg; print([n for n in vtkdgg.__all__ if n.startswith('vtk')])"
                found = import_with(version, code=code)
                self.assertEqual(found.stdout.strip(), str(sorted(property_table.TABLE)))

    @unittest.skipUnless(os.path.exists("/proc/self/maps"), "the system does not tell")
    def test_another_build_of_the_version(self):
        path = os.path.join(support.output_folder("another_vtk"), "libvtkCommonCore-pv5.11.so.1")
        with open("/proc/self/maps", encoding="utf-8") as maps:
            any_library = next(line.split()[-1] for line in maps if "/libm.so" in line)
        shutil.copyfile(any_library, path)
        result = import_with(build_info.VTK_VERSION, path)
        self.check_refused(result, "libvtkCommonCore-pv5.11")

    def test_the_right_one(self):
        self.assertIn(loaded_vtk._library(), (None, build_info.VTK_LIBRARY))
        self.assertEqual(vtkdgg.vtkDGGDistance.__module__, "vtkdgg.vtkDGGFiltersGeodesic")


if __name__ == "__main__":
    unittest.main()
