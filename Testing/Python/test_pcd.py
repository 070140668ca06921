# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkPCDReader and vtkPCDWriter from Python: paths, arrays as numpy, errors as exceptions."""

import os
import pathlib
import tempfile
import unittest

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData

import vtkdgg
from vtkdgg import vtkPCDReader, vtkPCDWriter

HEADER = "FIELDS x y z i\nSIZE 4 4 4 2\nTYPE F F F U\nWIDTH 2\nHEIGHT 1\nPOINTS 2\nDATA "
GOOD = HEADER + "ascii\n0 1 2 3\n4 5 6 7\n"


def cloud(points, **arrays):
    """A vtkPolyData of points and arrays."""
    data = vtkPolyData()
    vtk_points = vtkPoints()
    vtk_points.SetData(numpy_to_vtk(points, deep=True))
    data.SetPoints(vtk_points)
    for name, values in arrays.items():
        array = numpy_to_vtk(values, deep=True)
        array.SetName(name)
        data.GetPointData().AddArray(array)
    return data


class PCDTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.reader = vtkPCDReader()

    def read(self, content, name="cloud.pcd"):
        path = self.folder / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        self.reader.SetFileName(path)
        self.reader.Modified()
        return vtkdgg.check(self.reader)

    def write(self, data, mode=vtkPCDWriter.BINARY):
        writer = vtkPCDWriter()
        writer.SetInputData(data)
        writer.SetFileName(self.folder / "written.pcd")
        writer.SetDataMode(mode)
        self.assertEqual(writer.Write(), 1)
        self.assertEqual(writer.GetErrorCode(), 0)
        return self.folder / "written.pcd"

    def assert_refused(self, content, *parts):
        with self.assertRaises(vtkdgg.VTKError) as caught:
            self.read(content)
        self.assertNotEqual(caught.exception.code, 0)
        for part in ("vtkPCDReader", "cloud.pcd", *parts):
            self.assertIn(part, str(caught.exception))
        self.assertEqual(self.reader.GetOutput().GetNumberOfPoints(), 0)
        self.assertEqual(self.read(GOOD).GetNumberOfPoints(), 2)

    def test_text(self):
        data = self.read(GOOD)
        points = vtk_to_numpy(data.GetPoints().GetData())
        self.assertEqual(points.dtype, numpy.float32)
        numpy.testing.assert_array_equal(points, [[0, 1, 2], [4, 5, 6]])
        values = vtk_to_numpy(data.GetPointData().GetArray("i"))
        self.assertEqual(values.dtype, numpy.uint16)
        numpy.testing.assert_array_equal(values, [3, 7])
        self.assertEqual(data.GetNumberOfVerts(), 2)

    def test_round_trip(self):
        random = numpy.random.RandomState(1)
        points = random.standard_normal((1000, 3))
        points[10] = numpy.nan
        arrays = {
            "intensity": random.standard_normal(1000).astype(numpy.float32),
            "label": random.randint(-(2**31), 2**31, 1000).astype(numpy.int32),
            "fpfh": random.standard_normal((1000, 33)).astype(numpy.float32),
            "time": random.standard_normal(1000) * 1e-300,
        }
        for kind in (numpy.float32, numpy.float64):
            data = cloud(points.astype(kind), **arrays)
            for mode in (vtkPCDWriter.ASCII, vtkPCDWriter.BINARY, vtkPCDWriter.BINARY_COMPRESSED):
                read = self.read(self.write(data, mode).read_bytes())
                back = vtk_to_numpy(read.GetPoints().GetData())
                self.assertEqual(back.dtype, kind)
                numpy.testing.assert_array_equal(back, points.astype(kind))
                self.assertEqual(read.GetPointData().GetNumberOfArrays(), len(arrays))
                self.assertEqual(read.GetNumberOfVerts(), 999)
                for name, values in arrays.items():
                    array = vtk_to_numpy(read.GetPointData().GetArray(name))
                    self.assertEqual(array.dtype, values.dtype)
                    numpy.testing.assert_array_equal(array, values)

    def test_paths(self):
        path = self.folder / "Wolke mit Lücke.pcd"
        path.write_text(GOOD)
        self.assertEqual(vtkPCDReader.CanReadFile(path), 1)
        self.assertEqual(vtkPCDReader.CanReadFile(self.folder / "none"), 0)
        self.reader.SetFileName(path)
        self.assertEqual(self.reader.GetFileName(), os.fspath(path))
        self.assertEqual(vtkdgg.check(self.reader).GetNumberOfPoints(), 2)

    def test_malformed(self):
        self.assert_refused("ply\n", "line 1", "'ply'")
        self.assert_refused(GOOD.replace("4 5 6 7", "4 5 6 -7"), "line 9", "'i' of point 1: '-7'")

    def test_unwritable(self):
        writer = vtkPCDWriter()
        writer.SetInputData(cloud(numpy.zeros((1, 3))))
        errors = []
        writer.AddObserver("ErrorEvent", lambda *_: errors.append(1))
        self.assertEqual(writer.Write(), 0)
        writer.SetFileName(self.folder / "none" / "cloud.pcd")
        self.assertEqual(writer.Write(), 0)
        self.assertNotEqual(writer.GetErrorCode(), 0)
        self.assertEqual(len(errors), 2)


if __name__ == "__main__":
    unittest.main()
