# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""What Python adds to the compiled classes: kinds of ids, arrays as NumPy, paths, and objects that
are released. Their results are tested in C++."""

import gc
import os
import pathlib
import tempfile
import unittest

import numpy as np
import support
import vtkdgg
from support import distances_of
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIdList

# Classes with ids, and the name of their property.
IDS = (
    (vtkdgg.vtkExactGeodesicDistance, "Source"),
    (vtkdgg.vtkDiscreteGreensFunction, "Source"),
    (vtkdgg.vtkDGGLoop, "Point"),
    (vtkdgg.vtkGeodesicPatchBoundaries, "FirstLandmark"),
    (vtkdgg.vtkGeodesicVoronoi, "Site"),
)


def made(kind, mesh=None, **properties):
    """Returns a filter of a mesh, by default a grid, with these properties."""
    return support.make(kind, mesh or support.polydata(*support.grid(4, 4)), **properties)


class Ids(support.Test):
    def for_all(self, test):
        """Calls a test with functions of each class: set ids, add one, get one, get all."""
        for kind, name in IDS:
            algorithm = kind()

            def ids(algorithm=algorithm, name=name):
                count = getattr(algorithm, f"GetNumberOf{name}Ids")()
                return [getattr(algorithm, f"Get{name}Id")(i) for i in range(count)]

            accessors = [f"Set{name}Ids", f"Add{name}Id", f"Get{name}Id"]
            with self.subTest(kind=kind.__name__, name=name):
                test(*(getattr(algorithm, accessor) for accessor in accessors), ids)

    def test_kinds(self):
        def check(set_ids, add_id, get_id, ids):
            for name in ("int8", "uint8", "int16", "uint16", "int32", "uint32", "int64", "uint64"):
                kind = np.dtype(name).type
                set_ids(np.array([3, 1, 2], dtype=kind))
                add_id(kind(7))
                self.assertEqual(ids(), [3, 1, 2, 7])
            listed = vtkIdList()
            listed.InsertNextId(6)
            for given, expected in (
                (np.arange(10)[::3], [0, 3, 6, 9]),
                (np.arange(12).reshape(3, 4)[:, 1], [1, 5, 9]),
                (np.flatnonzero([0, 1, 0, 1]), [1, 3]),
                (range(2, 5), [2, 3, 4]),
                ([np.int64(4), 5], [4, 5]),
                ((4, 9), [4, 9]),
                (np.array([], dtype=int), []),
                (listed, [6]),
                (None, []),
                ([], []),
            ):
                set_ids(given)
                self.assertEqual(ids(), expected)
            set_ids([5])
            self.refuse(get_id, ((-1,), ""), ((1,), ""))

        self.for_all(check)

    def test_others_change_nothing(self):
        def check(set_ids, add_id, _, ids):
            set_ids([1, 2])
            wrong = 5, "12", 1.5, [1.5], ["1"], [None], {1: 2}, np.ones(1), np.zeros((2, 2), int)
            self.refuse(set_ids, *(((bad,), "") for bad in wrong), error=TypeError)
            self.refuse(set_ids, (([2**70],), ""), error=(TypeError, OverflowError))
            self.refuse(add_id, (("a",), ""), error=TypeError)
            self.assertEqual(ids(), [1, 2])

        self.for_all(check)

    def test_initial_distances(self):
        distance = made(vtkdgg.vtkDGGDistance)
        distance.AddSourceId(4)
        distance.AddSourceId(7, 0.5)
        self.assertEqual(distance.GetSourceInitialDistance(1), 0.5)
        expected = distances_of(distance)
        distance.SetSourceIds(np.array([4, 7]), np.array([0.0, 0.5]))
        np.testing.assert_array_equal(distances_of(distance), expected)


class Kinds(unittest.TestCase):
    def test_bases_are_abstract(self):
        for base, kind in (
            (vtkdgg.vtkGeodesicAlgorithm, vtkdgg.vtkGeodesicDistanceMatrix),
            (vtkdgg.vtkGeodesicDistanceAlgorithm, vtkdgg.vtkDGGDistance),
        ):
            self.assertTrue(issubclass(kind, base))
            with self.assertRaises(TypeError):
                base()

    def test_random_cells(self):
        """Any cells give an answer or an error, and never end the process."""
        random = np.random.default_rng(12)
        answers = 0
        for trial in range(300):
            n = int(random.integers(1, 12))
            # Every other surface has coincident, collinear and coplanar points.
            points = random.random((n, 3))
            points = np.floor(5.0 * points) if trial % 4 < 2 else points
            if trial % 10 == 0:
                points[random.integers(n), random.integers(3)] = random.choice([np.nan, np.inf])
            mesh = support.polydata(points, random.integers(0, n + trial % 2, (15, 3)))
            source = int(random.integers(n))
            distance = made(vtkdgg.vtkExactGeodesicDistance, mesh, SourceIds=[source])
            distance.SetMergeCoincidentPoints(trial % 3 == 0)
            with support.warnings_as("ignore"):
                try:
                    result = distances_of(distance)
                except vtkdgg.VTKError:
                    self.assertNotEqual(distance.GetErrorCode(), 0)
                    self.assertEqual(distance.GetOutput().GetNumberOfPoints(), 0)
                    continue
            answers += 1
            self.assertEqual(result[source], 0.0)
            straight = np.linalg.norm(points - points[source], axis=1)
            self.assertFalse((result < straight - 1e-6).any())
        self.assertGreater(answers, 60)


class Objects(unittest.TestCase):
    def test_the_input_may_be_released(self):
        distance = made(vtkdgg.vtkExactGeodesicDistance, SourceIds=[0])
        before = distances_of(distance)
        for _ in range(20):  # new objects may get the addresses of old ones
            for size, expected in ((2, None), (4, before)):
                distance.SetInputData(support.polydata(*support.grid(size, size)))
                gc.collect()
                found = distances_of(distance)
                self.assertEqual(len(found), (size + 1) ** 2)
                if expected is not None:
                    np.testing.assert_array_equal(found, expected)

    def test_outputs_outlive_the_filter(self):
        graph = made(vtkdgg.vtkDiscreteGeodesicGraph)
        matrix = made(vtkdgg.vtkGeodesicDistanceMatrix, RowIds=[0, 5, 20])
        vtkdgg.check(matrix)
        lengths = vtkdgg.check(graph).GetFieldData().GetArray("DGG.Lengths")
        views = [vtk_to_numpy(lengths), vtk_to_numpy(matrix.GetMatrix())]
        kept = [view.copy() for view in views]
        matrix.ReleaseMatrix()
        del graph, matrix, lengths
        gc.collect()
        for view, values in zip(views, kept):
            np.testing.assert_array_equal(view, values)

    def test_files(self):
        """Readers take paths, and work again after an error."""
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "Fläche mit Lücke"
            for kind, content in (
                (vtkdgg.vtkDGGOFFReader, "OFF\n3 1 3\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"),
                (vtkdgg.vtkPCDReader, "FIELDS x y z\nWIDTH 3\nDATA ascii\n0 1 2\n4 5 6\n7 8 9\n"),
            ):
                self.assertEqual(kind.CanReadFile(path.with_suffix(".none")), 0)
                reader = kind()
                reader.SetFileName(path)
                self.assertEqual(reader.GetFileName(), os.fspath(path))
                for text, count in ((content, 3), ("ply\n", 0), (content, 3)):
                    path.write_text(text, encoding="ascii")
                    reader.Modified()
                    if count:
                        self.assertEqual(kind.CanReadFile(path), 1)
                        self.assertEqual(vtkdgg.check(reader).GetNumberOfPoints(), count)
                        continue
                    with self.assertRaisesRegex(vtkdgg.VTKError, "line 1.*'ply'") as caught:
                        vtkdgg.check(reader)
                    self.assertNotEqual(caught.exception.code, 0)


if __name__ == "__main__":
    unittest.main()
