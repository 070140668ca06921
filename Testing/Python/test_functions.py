# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Functions that return the results of one filter: distances at any points, patch layouts, vector
graphics. Flags of all functions."""

import inspect

import numpy as np
import support
import vtkdgg
from support import add_array, make, polydata
from vtkmodules.util.numpy_support import vtk_to_numpy

NAME = "GeodesicDistance"
RED_AND_BLUE = {"LeftColor": [[1.0, 0, 0]], "RightColor": [[0, 0, 1.0]]}


def points_of(mesh):
    return vtk_to_numpy(mesh.GetPoints().GetData())


def arrays_of(data):
    """Returns point, cell or field data as a dict of arrays."""
    names = [data.GetArrayName(i) for i in range(data.GetNumberOfArrays())]
    return {name: vtk_to_numpy(data.GetArray(name)) for name in names}


class Functions(support.Test):
    @classmethod
    def setUpClass(cls):
        cls.points, cls.triangles = support.bumpy()
        cls.surface = polydata(cls.points, cls.triangles)
        weights = np.random.default_rng(3).dirichlet([1, 1, 1], 40)
        cls.faces = list(zip(range(0, 1280, 32), weights))
        corners = cls.points[cls.triangles[::32]]
        cls.places = np.einsum("ij,ijk->ik", weights, corners)

    def equal(self, first, second):
        """Compares dicts of arrays bit for bit."""
        self.assertEqual(first.keys(), second.keys())
        for name, values in first.items():
            np.testing.assert_array_equal(values, second[name], err_msg=name)

    def probed(self, distances, places=None):
        """Returns the answer of the filter."""
        places = self.places if places is None else places
        probe = make("vtkGeodesicProbe", distances, ProbeData=polydata(places))
        return support.point_array(vtkdgg.check(probe), NAME)

    def test_probe(self):
        exact = vtkdgg.distance(self.points, self.triangles, 5)
        mesh = support.copy_of(self.surface)
        add_array(mesh.GetPointData(), NAME, exact)
        expected = self.probed(mesh)
        for found in (
            vtkdgg.probe(self.points, self.triangles, exact, self.places),
            vtkdgg.probe(mesh, exact, self.places),
            vtkdgg.probe(mesh, NAME, self.places),
            support.point_array(vtkdgg.probe(mesh, NAME, self.places, as_polydata=True), NAME),
        ):
            np.testing.assert_array_equal(found, expected)
        in_faces = vtkdgg.probe(mesh, exact, self.faces)
        np.testing.assert_allclose(in_faces, expected, atol=1e-9)
        np.testing.assert_allclose(vtkdgg.probe(mesh, exact, [5, 318]), exact[[5, 318]], atol=1e-12)

    def test_probe_uses_what_a_mesh_stores(self):
        """Windows, virtual sources and the marks of unreached points."""
        for kind, properties in (
            ("vtkExactGeodesicDistance", {"GenerateWindows": True}),
            ("vtkDGGDistance", {"GenerateVirtualSource": True}),
            ("vtkDGGDistance", {"MaximumDistance": 1.0, "UnreachedValue": 7.0}),
        ):
            distance = make(kind, self.surface, SourceIds=[5], **properties)
            mesh = vtkdgg.check(distance)
            found = vtkdgg.probe(mesh, NAME, self.places)
            np.testing.assert_array_equal(found, self.probed(mesh))
        self.assertTrue(0 < np.isnan(found).sum() < len(found))

    def test_distance_at(self):
        """Distances from sources to any points, in one call."""
        for method, kind, option in (
            ("exact", "vtkExactGeodesicDistance", "GenerateWindows"),
            ("fast", "vtkVirtualSourceGeodesicDistance", "GenerateVirtualSource"),
        ):
            made = make(kind, self.surface, SourceIds=[5], **{option: True})
            expected = self.probed(vtkdgg.check(made))
            options = {"at": self.places, "method": method}
            found = vtkdgg.distance(self.points, self.triangles, 5, **options)
            np.testing.assert_array_equal(found, expected)
            dots = vtkdgg.distance(self.surface, 5, as_polydata=True, **options)
            np.testing.assert_array_equal(support.point_array(dots, NAME), expected)
        near = vtkdgg.distance(self.surface, 5, at=self.places, maximum_distance=1, unreached=-1)
        self.assertTrue(((near == -1) | (near <= 1)).all() and (near == -1).any())
        cases = (
            ({"return_source": True}, "return_source: expected False"),
            ({"at": [9999]}, "at: point id 9999"),
        )
        self.refuse(
            lambda **given: vtkdgg.distance(self.surface, 5, **{"at": self.places, **given}), *cases
        )
        with self.assertRaisesRegex(ValueError, "at: applies to meshes"):
            vtkdgg.distance(self.points, [], 0, method="marching", at=[0])

    def test_wrong_probes(self):
        exact = vtkdgg.distance(self.surface, 5)
        self.refuse(
            lambda *given: vtkdgg.probe(self.surface, *given),
            ((exact[:4], [0]), "distances: expected one per point, 642, got 4"),
            (("Height", [0]), "distances: there is no point array 'Height'; the mesh has none"),
            ((exact, [642]), "at: point id 642"),
            ((exact,), "at: missing"),
        )
        with self.assertRaisesRegex(vtkdgg.Error, "Probe point 0") as caught:
            vtkdgg.probe(self.surface, exact, [[9.0, 0, 0]])
        self.assertEqual(caught.exception.index, 0)

    def test_patch_boundaries(self):
        ids, patches = [0, 40, 300, 500], [[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]]
        first, second = (self.points, self.triangles), polydata(2.0 * self.points, self.triangles)
        made = make(
            "vtkGeodesicPatchBoundaries", self.surface, SecondSurfaceData=second,
            FirstLandmarkIds=ids, SecondLandmarkIds=ids,
            LayoutData=polydata(np.zeros((4, 3)), patches),
        )  # fmt: skip
        vtkdgg.check(made)
        given = first, second, ids, ids, patches
        as_lists = vtkdgg.patch_boundaries(*given)
        as_polydata = vtkdgg.patch_boundaries(*given, as_polydata=True)
        for side, (curves, lines) in enumerate(zip(as_lists, as_polydata)):
            expected = made.GetOutput(side)
            np.testing.assert_array_equal(points_of(lines), points_of(expected))
            for kind in ("Point", "Cell"):
                found, wanted = (getattr(mesh, f"Get{kind}Data")() for mesh in (lines, expected))
                self.equal(arrays_of(found), arrays_of(wanted))
            cells, points = arrays_of(expected.GetCellData()), arrays_of(expected.GetPointData())
            self.assertEqual([c.landmarks for c in curves], list(map(tuple, cells["LayoutEdge"])))
            self.assertEqual([c.length for c in curves], cells["Length"].tolist())
            for i, curve in enumerate(curves):
                rows = [expected.GetCell(i).GetPointId(k) for k in range(len(curve.points))]
                np.testing.assert_array_equal(curve.points, points_of(expected)[rows])
                np.testing.assert_array_equal(curve.fractions, points["ArcFraction"][rows])
        edges = vtkdgg.patch_boundaries(*given[:4], edges=[[2, 0], [3, 1]])
        self.assertEqual([c.landmarks for c in edges[1]], [(2, 0), (3, 1)])
        mixed = [[0, 1, 2], [0, 2, 3, 1], [1, 3, 2]]
        self.assertEqual(len(vtkdgg.patch_boundaries(*given[:4], mixed)[0]), 5)

    def test_wrong_layouts(self):
        def draw(second=self.surface, landmarks=(0, 40, 300), **layout):
            return vtkdgg.patch_boundaries(
                self.surface, second, [0, 40, 300], list(landmarks), **layout
            )

        self.refuse(
            draw,
            ({}, "patches: missing; .* or `edges`"),
            ({"second": self.points, "edges": [[0, 1]]}, "second: expected one mesh"),
            ({"landmarks": [0, 1, 642], "edges": [[0, 1]]}, "second_landmarks: point id 642"),
            ({"edges": [[0, 1, 2]]}, r"edges: expected the shape \(m, 2\), got \(1, 3\)"),
            ({"patches": [[0, 1]]}, "patches: expected rows of at least three"),
            ({"patches": [0, 1, 2]}, "patches: expected rows of at least three"),
            ({"patches": [[0, 1, 1.5]]}, "patches: expected integers"),
        )
        self.refuse(
            draw,
            ({"landmarks": [0, 40], "edges": [[0, 1]]}, "3 landmarks on the first surface and 2"),
            ({"edges": [[0, 3]]}, "landmark 3"),
            error=vtkdgg.Error,
        )

    def test_vector_graphics(self):
        ends = self.points[[0, 10, 300, 310]]
        arrays = {"CurveType": [0, 1], "Strength": [[0.5], [0.5]]}
        arrays.update({name: rows * 2 for name, rows in RED_AND_BLUE.items()})
        curves = vtkdgg.Mesh(ends, lines=([0, 2, 4], [0, 1, 2, 3]), cell_data=arrays)
        regions = np.zeros(1280, dtype=int)
        regions[600:640] = 4
        strengths = 0.25 * (regions > 0)
        selected = self.points[self.triangles[:, 0], 0] > 0
        surface = support.copy_of(self.surface)
        add_array(surface.GetPointData(), "Height", self.points[:, 1])
        for values in (("Parts", regions), ("RegionStrength", strengths), ("Refine", selected * 1)):
            add_array(surface.GetCellData(), *values)
        made = make(
            "vtkPoissonVectorGraphics", surface, CurveData=curves.as_polydata(), Width=0.2,
            RegionArrayName="Parts", RefinementRegion=2, BackgroundColor=(0.1, 0.2, 0.3),
        )  # fmt: skip
        expected = vtkdgg.check(made)
        options = {
            "regions": regions, "region_strengths": strengths, "width": 0.2,
            "refinement_region": selected, "background_color": [0.1, 0.2, 0.3],
        }  # fmt: skip
        found = vtkdgg.vector_graphics(self.points, self.triangles, curves, **options)
        np.testing.assert_array_equal(found.points, points_of(expected))
        np.testing.assert_array_equal(found.triangles, support.triangles_of(expected))
        wanted = arrays_of(expected.GetPointData())
        self.equal(found.field_data, arrays_of(expected.GetFieldData()))
        output = vtkdgg.vector_graphics(surface, curves, as_polydata=True, **options)
        self.equal(arrays_of(output.GetPointData()), wanted)
        del wanted["Height"]
        self.equal(found.point_data, wanted)
        plain = vtkdgg.vector_graphics(surface, curves.as_polydata(), refinement_level=0)
        self.assertLess(len(plain.triangles), len(found.triangles))
        alone = vtkdgg.vector_graphics(surface, regions=regions, region_strengths=strengths)
        self.assertGreater(alone.point_data["Colors"].max(), 0)

    def test_wrong_graphics(self):
        line = vtkdgg.Mesh(self.points[[0, 10]], lines=([0, 2], [0, 1]), cell_data=RED_AND_BLUE)

        def color(curves=line, **options):
            return vtkdgg.vector_graphics(self.surface, curves, **options)

        self.refuse(
            color,
            ({"curves": self.points}, "curves: expected a Mesh.*, got a ndarray"),
            ({"regions": np.zeros(1280, int)}, "region_strengths: missing"),
            ({"regions": [1, 2], "region_strengths": [1, 2]}, "regions: expected 1280 rows"),
            ({"refinement_level": 9}, "refinement_level: expected 0 to 8, got 9"),
            ({"refinement_region": "Cells"}, "one number for each cell"),
            ({"refinement_region": "Near"}, "NearCurves"),
            ({"background_color": [1, 2]}, "background_color: expected one number or 3"),
            ({"width": -1}, "width.*-1"),
        )
        nothing = vtkdgg.Mesh(self.points[:2])
        white = vtkdgg.Mesh(line.points, lines=line.lines)
        self.refuse(
            color,
            ({"curves": nothing}, "nothing to draw. Add lines to `curves`, or set `regions`"),
            ({"curves": white}, "array 'LeftColor'"),
            error=vtkdgg.Error,
        )

    def test_flags(self):
        """Every argument that is annotated as bool refuses other objects."""
        graph = vtkdgg.Graph(self.points, self.triangles, accuracy=0.5)
        functions = [getattr(vtkdgg, name) for name in vtkdgg._WITHOUT_VTK]
        methods = inspect.getmembers(vtkdgg.Graph, inspect.isfunction)
        functions += [getattr(graph, name) for name, _ in methods if name[0] != "_"]
        tried = 0
        functions = [f for f in functions if callable(f) and not hasattr(f, "with_traceback")]
        for function in functions:
            signature = inspect.signature(function)
            required = [p for p in signature.parameters.values() if p.default is p.empty]
            given = [0 for p in required if p.kind is p.POSITIONAL_OR_KEYWORD]
            for name, parameter in signature.parameters.items():
                if parameter.annotation == "bool":
                    for value in ("no", 1, None):
                        with self.subTest(function=function.__qualname__, name=name):
                            pattern = f"{name}: expected True or False, got {value!r}"
                            with self.assertRaisesRegex(ValueError, pattern):
                                function(*given, **{name: value})
                    tried += 1
        self.assertGreater(tried, 30)
        both = vtkdgg.distance(self.surface, 0, return_source=np.bool_(True))
        self.assertEqual(len(both), 2)

    def test_not_connected(self):
        mesh = support.two_squares([3, 0, 0])
        graph = vtkdgg.Graph(*mesh)
        for find in (graph.path, lambda *ends: vtkdgg.path(mesh, *ends)):
            with self.assertRaisesRegex(vtkdgg.NotConnectedError, "not connected"):
                find(0, 5)
        with self.assertWarnsRegex(RuntimeWarning, r"Unconnected pairs have no polyline\.$"):
            self.assertIsNone(graph.paths([0, 0], [1, 5])[1])
        with self.assertWarnsRegex(RuntimeWarning, r"Missing loops have no polyline\.$"):
            self.assertEqual(vtkdgg.Graph(self.points, self.triangles).loop([0]), [])


if __name__ == "__main__":
    support.unittest.main()
