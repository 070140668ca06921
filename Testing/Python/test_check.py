# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkdgg.check(): VTK errors as exceptions."""

import gc
import os
import subprocess
import sys
import unittest
import warnings
import weakref

import numpy as np
import support
import vtkdgg
from vtkmodules.vtkCommonCore import vtkObject
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkTriangleFilter
from vtkmodules.vtkIOGeometry import vtkSTLReader, vtkSTLWriter
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOLegacy import vtkPolyDataReader, vtkPolyDataWriter
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter


class Check(unittest.TestCase):
    def test_returns_the_output(self):
        reader = vtkdgg.vtkDGGOFFReader()
        reader.SetFileName(os.path.join(support.DATA, "tetrahedron.off"))
        self.assertEqual(vtkdgg.check(reader).GetNumberOfPoints(), 4)

    def test_writers_write(self):
        folder = support.output_folder("check")
        mesh = support.polydata(*support.grid(1, 1))
        image = support.image_of(np.zeros((4, 5, 3)))
        for writer, data in ((vtkXMLPolyDataWriter(), mesh), (vtkPNGWriter(), image)):
            with self.subTest(writer=writer.GetClassName()):
                path = os.path.join(folder, writer.GetClassName())
                if os.path.exists(path):
                    os.remove(path)
                writer.SetInputData(data)
                writer.SetFileName(path)
                vtkdgg.check(writer)
                self.assertGreater(os.path.getsize(path), 0)
                writer.SetFileName(os.path.join(folder, "missing", "file"))
                for _ in range(2):
                    with self.assertRaises(vtkdgg.VTKError):
                        vtkdgg.check(writer)
        self.assertEqual(support.read_image(path).GetDimensions(), (5, 4, 1))

    def test_error_of_the_algorithm(self):
        distance = vtkdgg.vtkExactGeodesicDistance()
        distance.SetInputData(support.polydata(*support.grid(2, 2)))
        distance.AddSourceId(9)
        with self.assertRaises(vtkdgg.VTKError) as caught:
            vtkdgg.check(distance)
        text = str(caught.exception)
        self.assertIn("vtkExactGeodesicDistance", text)
        self.assertIn("9", text)
        # Neither file and line, nor addresses.
        self.assertNotIn(".cxx", text)
        self.assertNotIn("0x", text)
        self.assertEqual(len(caught.exception.messages), 1)
        self.assertNotEqual(caught.exception.code, 0)
        self.assertIsInstance(caught.exception, RuntimeError)

    def test_error_of_an_earlier_update(self):
        # Updated outside: the message is gone, but the failure is not.
        source = (
            "import support, vtkdgg\n"
            "d = vtkdgg.vtkExactGeodesicDistance()\n"
            "d.SetInputData(support.polydata(*support.grid(2, 2)))\n"
            "d.AddSourceId(9)\n"
            "d.Update()\n"
            "try:\n"
            "    vtkdgg.check(d)\n"
            "except vtkdgg.VTKError as error:\n"
            "    print('raised:', error)\n"
        )
        result = self.run_python(source)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("raised: vtkExactGeodesicDistance", result.stdout)

    def test_repeats_until_the_cause_is_gone(self):
        distance = vtkdgg.vtkExactGeodesicDistance()
        distance.SetInputData(support.polydata(*support.grid(2, 2)))
        distance.AddSourceId(9)
        for _ in range(3):
            with self.assertRaises(vtkdgg.VTKError):
                vtkdgg.check(distance)
        distance.RemoveAllSources()
        distance.AddSourceId(8)
        output = vtkdgg.check(distance)
        self.assertEqual(support.point_array(output, "GeodesicDistance")[8], 0.0)

    def test_readers_that_keep_their_error_code(self):
        """Two readers of VTK do not reset it when they succeed after a failure."""
        mesh = support.polydata(*support.grid(1, 1))
        folder = support.output_folder("kept_code")
        for reader, writer in (
            (vtkSTLReader(), vtkSTLWriter()),
            (vtkPolyDataReader(), vtkPolyDataWriter()),
        ):
            with self.subTest(reader=reader.GetClassName()):
                path = os.path.join(folder, reader.GetClassName())
                writer.SetInputData(mesh)
                writer.SetFileName(path)
                vtkdgg.check(writer)
                reader.SetFileName(os.path.join(folder, "missing"))
                for _ in range(2):
                    with self.assertRaises(vtkdgg.VTKError):
                        vtkdgg.check(reader)
                reader.SetFileName(path)
                self.assertGreater(vtkdgg.check(reader).GetNumberOfPoints(), 0)

    def test_error_upstream(self):
        for reader, name in (
            (vtkPLYReader(), "missing.ply"),
            (vtkXMLPolyDataReader(), "missing.vtp"),
            (vtkdgg.vtkDGGOFFReader(), "missing.off"),
        ):
            with self.subTest(name):
                reader.SetFileName(os.path.join(support.OUTPUT, name))
                triangulate = vtkTriangleFilter()
                triangulate.SetInputConnection(reader.GetOutputPort())
                for _ in range(2):
                    with self.assertRaises(vtkdgg.VTKError) as caught:
                        vtkdgg.check(triangulate)
                    self.assertIn(reader.GetClassName(), str(caught.exception))

    def test_missing_input(self):
        # Reported by the pipeline, not by the filter.
        with self.assertRaises(vtkdgg.VTKError) as caught:
            vtkdgg.check(vtkTriangleFilter())
        self.assertIn("Input port 0 of algorithm vtkTriangleFilter", str(caught.exception))

    def test_works_while_warnings_are_not_displayed(self):
        vtkObject.GlobalWarningDisplayOff()
        try:
            distance = vtkdgg.vtkExactGeodesicDistance()
            distance.SetInputData(support.polydata(*support.grid(2, 2)))
            distance.AddSourceId(9)
            with self.assertRaisesRegex(vtkdgg.VTKError, "9"):
                vtkdgg.check(distance)
            self.assertEqual(vtkObject.GetGlobalWarningDisplay(), 0)
        finally:
            vtkObject.GlobalWarningDisplayOn()

    def test_prints_nothing(self):
        source = (
            "import support, vtkdgg\n"
            "d = vtkdgg.vtkExactGeodesicDistance()\n"
            "d.SetInputData(support.polydata(*support.grid(2, 2)))\n"
            "d.AddSourceId(9)\n"
            "try:\n"
            "    vtkdgg.check(d)\n"
            "except vtkdgg.VTKError:\n"
            "    pass\n"
        )
        result = self.run_python(source)
        self.assertEqual((result.returncode, result.stdout, result.stderr), (0, "", ""))

    def test_warnings_are_python_warnings(self):
        distance = vtkdgg.vtkExactGeodesicDistance()
        distance.SetInputData(vtkPolyData())
        distance.AddSourceId(0)
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            vtkdgg.check(distance)
        self.assertEqual(len(caught), 1)
        self.assertIn("empty", str(caught[0].message))

    def test_an_abort_is_no_error(self):
        distance = vtkdgg.vtkExactGeodesicDistance()
        distance.SetInputData(support.polydata(*support.grid(3, 3)))
        distance.SetSourceIds([0])
        tag = distance.AddObserver("ProgressEvent", lambda caller, event: caller.AbortExecuteOn())
        self.assertEqual(vtkdgg.check(distance).GetNumberOfPoints(), 0)
        self.assertTrue(distance.GetAbortExecute())
        distance.RemoveObserver(tag)
        self.assertEqual(vtkdgg.check(distance).GetNumberOfPoints(), 16)
        self.assertFalse(distance.GetAbortExecute())

    def test_keeps_nothing(self):
        gone = []
        gc.disable()
        try:
            mesh = support.polydata(*support.grid(1, 1))
            for _ in range(3):
                triangles = vtkTriangleFilter()
                triangles.SetInputData(mesh)
                last = vtkTriangleFilter()
                last.SetInputConnection(triangles.GetOutputPort())
                gone += [weakref.ref(triangles), weakref.ref(last)]
                vtkdgg.check(last)
            del triangles, last
            self.assertEqual([reference() for reference in gone], [None] * 6)
        finally:
            gc.enable()

    def test_not_an_algorithm(self):
        for thing in (None, 3, "reader", vtkPolyData()):
            with self.subTest(thing=type(thing)), self.assertRaises(TypeError):
                vtkdgg.check(thing)

    @staticmethod
    def run_python(source):
        return subprocess.run(
            [sys.executable, "-c", source],
            cwd=os.path.dirname(os.path.abspath(__file__)),
            capture_output=True,
            text=True,
            check=False,
        )


if __name__ == "__main__":
    unittest.main()
