# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkdgg.check(): VTK errors as exceptions."""

import gc
import os
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


def exact(source, size=2):
    """Returns a filter of a grid; source 9 does not exist on the default one."""
    mesh = support.polydata(*support.grid(size, size))
    return support.make("vtkExactGeodesicDistance", mesh, SourceIds=[source])


class Check(support.Test):
    def refuse_check(self, algorithm, pattern=""):
        self.refuse(vtkdgg.check, ((algorithm,), pattern), error=vtkdgg.VTKError)

    def test_writers(self):
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
                    self.refuse_check(writer)
        self.assertEqual(support.read_image(path).GetDimensions(), (5, 4, 1))

    def test_errors(self):
        distance = exact(9)
        for _ in range(3):  # until the cause is gone
            with self.assertRaises(vtkdgg.VTKError) as caught:
                vtkdgg.check(distance)
            text = str(caught.exception)
            self.assertRegex(text, "vtkExactGeodesicDistance.*9")
            self.assertNotRegex(text, r"\.cxx|0x")  # neither file and line, nor addresses
            self.assertEqual(len(caught.exception.messages), 1)
            self.assertNotEqual(caught.exception.code, 0)
            self.assertIsInstance(caught.exception, RuntimeError)
        distance.SetSourceIds([8])
        self.assertEqual(support.distances_of(distance)[8], 0.0)
        self.refuse_check(vtkTriangleFilter(), "Input port 0 of algorithm vtkTriangleFilter")
        wrong = (((thing,), "") for thing in (None, 3, "reader", vtkPolyData()))
        self.refuse(vtkdgg.check, *wrong, error=TypeError)

    def test_errors_in_another_process(self):
        """Nothing is printed; an update outside of check() prints the error and fails later."""
        source = "import test_check as t, vtkdgg\nd = t.exact(9)\n{}try:\n    vtkdgg.check(d)\n"
        source += "except vtkdgg.VTKError as error:\n    print(error)\n"
        result = support.python(source.format(""))
        self.assertRegex(result.stdout, r"\AvtkExactGeodesicDistance: [^\n]*\n\Z")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        result = support.python(source.format("d.Update()\n"))
        self.assertRegex(result.stdout, r"\AvtkExactGeodesicDistance")
        self.assertEqual(result.returncode, 0)

    def test_readers_that_keep_their_error_code(self):
        """Two readers of VTK do not reset the code when they succeed after a failure."""
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
                    self.refuse_check(reader)
                reader.SetFileName(path)
                self.assertGreater(vtkdgg.check(reader).GetNumberOfPoints(), 0)

    def test_error_upstream(self):
        for reader in (vtkPLYReader(), vtkXMLPolyDataReader(), vtkdgg.vtkDGGOFFReader()):
            reader.SetFileName(os.path.join(support.OUTPUT, "missing.file"))
            triangulate = support.make(vtkTriangleFilter, reader)
            for _ in range(2):
                self.refuse_check(triangulate, reader.GetClassName())

    def test_while_warnings_are_not_displayed(self):
        vtkObject.GlobalWarningDisplayOff()
        try:
            self.refuse_check(exact(9), "9")
            self.assertEqual(vtkObject.GetGlobalWarningDisplay(), 0)
        finally:
            vtkObject.GlobalWarningDisplayOn()

    def test_warnings_are_python_warnings(self):
        distance = exact(0)
        distance.SetInputData(vtkPolyData())
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            vtkdgg.check(distance)
        self.assertEqual(len(caught), 1)
        self.assertIn("empty", str(caught[0].message))

    def test_an_abort_is_no_error(self):
        distance = exact(0, 3)
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
                triangles = support.make(vtkTriangleFilter, mesh)
                last = support.make(vtkTriangleFilter, triangles)
                gone += [weakref.ref(triangles), weakref.ref(last)]
                vtkdgg.check(last)
            del triangles, last
            self.assertEqual([reference() for reference in gone], [None] * 6)
        finally:
            gc.enable()


if __name__ == "__main__":
    unittest.main()
