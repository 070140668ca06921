# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkDGGOFFReader from Python: paths, arrays as numpy, errors as exceptions."""

import os
import pathlib
import struct
import tempfile
import unittest

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy

import vtkdgg
from vtkdgg import vtkDGGOFFReader

TRIANGLE = "OFF\n3 1 3\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"


class OFFReaderTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.reader = vtkDGGOFFReader()

    def write(self, content, name="mesh.off"):
        path = self.folder / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path

    def read(self, content, name="mesh.off"):
        self.reader.SetFileName(os.fspath(self.write(content, name)))
        self.reader.Modified()
        return vtkdgg.check(self.reader)

    def assert_refused(self, content, *parts):
        with self.assertRaises(vtkdgg.VTKError) as caught:
            self.read(content)
        self.assertNotEqual(caught.exception.code, 0)
        text = str(caught.exception)
        for part in ("vtkDGGOFFReader", "mesh.off", *parts):
            self.assertIn(part, text)
        self.assertEqual(self.reader.GetOutput().GetNumberOfPoints(), 0)
        self.assertEqual(self.read(TRIANGLE).GetNumberOfPolys(), 1)

    def test_points_and_polygons(self):
        mesh = self.read("OFF 5 2 0\n0 0 0\n2 0 0\n2 1 0\n0 1 0\n1 2 0\n4 0 1 2 3\n3 3 2 4\n")
        points = vtk_to_numpy(mesh.GetPoints().GetData())
        self.assertEqual(points.dtype, numpy.float64)
        numpy.testing.assert_array_equal(points[4], [1, 2, 0])
        polygons = mesh.GetPolys()
        numpy.testing.assert_array_equal(vtk_to_numpy(polygons.GetOffsetsArray()), [0, 4, 7])
        numpy.testing.assert_array_equal(
            vtk_to_numpy(polygons.GetConnectivityArray()), [0, 1, 2, 3, 3, 2, 4]
        )

    def test_arrays(self):
        mesh = self.read("STCNOFF 2 0 0\n0 0 0 0 0 1 255 0 9 .5 .25\n1 1 1 0 1 0 0 7 0 1 0\n")
        data = mesh.GetPointData()
        numpy.testing.assert_array_equal(vtk_to_numpy(data.GetNormals()), [[0, 0, 1], [0, 1, 0]])
        numpy.testing.assert_array_equal(
            vtk_to_numpy(data.GetArray("RGB")), [[255, 0, 9], [0, 7, 0]]
        )
        numpy.testing.assert_array_equal(vtk_to_numpy(data.GetTCoords()), [[0.5, 0.25], [1, 0]])

    def test_paths(self):
        # A path object, and a name that is not plain ASCII.
        path = self.write(TRIANGLE, "Fläche mit Lücke.off")
        self.assertEqual(vtkDGGOFFReader.CanReadFile(path), 1)
        self.reader.SetFileName(path)
        self.assertEqual(self.reader.GetFileName(), os.fspath(path))
        self.assertEqual(vtkdgg.check(self.reader).GetNumberOfPolys(), 1)

    def test_malformed(self):
        self.assert_refused("ply\n", "line 1", "'ply'")
        self.assert_refused(b"OFF BINARY\n\0\0\0\1", "byte 15", "number of faces")
        with self.assertRaisesRegex(vtkdgg.VTKError, "SetFileName"):
            vtkdgg.check(vtkDGGOFFReader())

    def test_random_damage(self):
        """Damaged files are refused or read, and never crash."""
        content = bytearray(
            b"STCNOFF\n3 2 3\n0 0 0 0 0 1 255 0 0 0 0\n1 0 0 0 0 1 255 0 0 0 0\n"
            b"0 1 0 0 0 1 255 0 0 0 0\n3 0 1 2 10 20 30\n2 0 1\n"
        )
        binary = bytearray(b"OFF BINARY\n" + struct.pack(">3i", 3, 1, 0))
        binary += struct.pack(">9f5i", 0, 0, 0, 1, 0, 0, 0, 1, 0, 3, 0, 1, 2, 0)
        random = numpy.random.RandomState(7)
        refused = 0
        for original in (content, binary):
            for _ in range(300):
                damaged = bytearray(original)
                for _ in range(random.randint(1, 4)):
                    damaged[random.randint(len(damaged))] = random.randint(256)
                try:
                    self.read(bytes(damaged))
                except vtkdgg.VTKError:
                    refused += 1
                    self.assertEqual(self.reader.GetOutput().GetNumberOfPoints(), 0)
        self.assertGreater(refused, 200)


if __name__ == "__main__":
    unittest.main()
