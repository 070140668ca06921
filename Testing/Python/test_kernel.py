# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""The module vtkdgg._kernel: closed forms, filters on the same input, threads, interruption,
errors, kinds of arrays. Runs without VTK, except the comparison with filters."""

import gc
import math
import os
import pickle
import signal
import sys
import tempfile
import threading
import unittest
from concurrent.futures import ThreadPoolExecutor

import numpy as np
from vtkdgg import _kernel as kernel

try:
    import vtkdgg
    from vtkmodules.util.numpy_support import vtk_to_numpy

    HAS_FILTERS = hasattr(vtkdgg, "vtkExactGeodesicDistance")
except ImportError:
    HAS_FILTERS = False


def grid(columns, rows):
    """Points and triangles of a rectangle of unit squares."""
    x, y = np.meshgrid(np.arange(columns + 1.0), np.arange(rows + 1.0))
    points = np.column_stack([x.ravel(), y.ravel(), np.zeros(x.size)])
    corner = (np.arange(columns) + (columns + 1) * np.arange(rows)[:, None]).ravel()
    up = corner + columns + 1
    return points, np.vstack(
        [np.column_stack([corner, corner + 1, up + 1]), np.column_stack([corner, up + 1, up])]
    )


def torus(around=24, across=12):
    """Points and triangles of a torus."""
    u, v = (np.arange(n) * 2 * np.pi / n for n in (around, across))
    u, v = (a.ravel() for a in np.meshgrid(u, v, indexing="ij"))
    radius = 3 + np.cos(v)
    points = np.column_stack([radius * np.cos(u), radius * np.sin(u), np.sin(v)])
    i, j = (a.ravel() for a in np.meshgrid(range(around), range(across), indexing="ij"))
    a, b, c, d = (
        (i + di) % around * across + (j + dj) % across
        for di, dj in ((0, 0), (1, 0), (1, 1), (0, 1))
    )
    return points, np.vstack([np.column_stack([a, b, c]), np.column_stack([a, c, d])])


PLANE = grid(20, 20)
SURFACE = kernel.Surface(*PLANE)
TORUS = kernel.Surface(*torus())
GRAPH = kernel.Graph(SURFACE)
FROM_0 = np.linalg.norm(PLANE[0], axis=1)
DISTANCE = "GeodesicDistance"


def field(function, *arguments, **options):
    return function(*arguments, **options).point_data[DISTANCE]


class ClosedForms(unittest.TestCase):
    def test_distances(self):
        for function, target, error in (
            (kernel.exact_distance, SURFACE, 1e-12),
            (kernel.virtual_source_distance, SURFACE, 1e-5),
            (kernel.fast_marching_distance, SURFACE, 1e-9),
            (kernel.heat_distance, SURFACE, 1.0),
            (kernel.Graph.distance, GRAPH, 1e-6),
        ):
            with self.subTest(function=function):
                np.testing.assert_allclose(field(function, target, 0), FROM_0, atol=error)
                both = function(target, [0, 440], generate_nearest_source=True).point_data
                np.testing.assert_array_equal(both["GeodesicSource"][[0, 440]], [0, 1])
                near = field(function, target, 0, maximum_distance=5.0, unreached_value=-1.0)
                self.assertEqual(near[-1], -1.0)

    def test_upper_bound_and_offsets(self):
        data = GRAPH.distance(
            [0], initial_distances=[2.0], generate_upper_bound=True, generate_virtual_source=True
        ).point_data
        self.assertTrue((data["GeodesicUpperBound"] >= 2.0 + FROM_0 - 1e-9).all())
        self.assertTrue((data["GeodesicUpperBound"] <= 2.0 + 1.01 * FROM_0 + 1e-5).all())
        self.assertEqual(data["GeodesicVirtualSource"].shape, (441, 3))

    def test_sources(self):
        inside = np.linalg.norm(PLANE[0] - [3.25, 4.5, 0], axis=1)
        triangle = PLANE[0][PLANE[1][100]]
        for sources, expected in (
            ([3.25, 4.5, 0], inside),
            ([[3.25, 4.5, 0.1]], inside),
            ({"points": np.float32([[3.25, 4.5, 0]])}, inside),
            ({"cells": [100], "barycentric": [[0.5, 0.25, 0.25]]},
             np.linalg.norm(PLANE[0] - [0.5, 0.25, 0.25] @ triangle, axis=1)),
            ({"ids": [0], "points": [[0, 0, 0]]}, FROM_0),
        ):  # fmt: skip
            found = field(kernel.exact_distance, SURFACE, sources)
            np.testing.assert_allclose(found, expected, atol=1e-9)

    def test_matrix_and_rows(self):
        ids = [0, 20, 440, 215]
        points = PLANE[0][ids]
        expected = np.linalg.norm(points[:, None] - points, axis=2)
        matrix = GRAPH.matrix(ids)
        np.testing.assert_allclose(matrix, expected, rtol=0.01)
        np.testing.assert_array_equal(matrix, matrix.T)
        np.testing.assert_array_equal(GRAPH.matrix(ids, points[:1])[:, 0], matrix[:, 0])
        offsets, columns, distances = GRAPH.neighborhood(ids, maximum_distance=1.5)
        np.testing.assert_array_equal(offsets, [0, 4, 8, 12, 21])
        np.testing.assert_allclose(distances[columns == 21], [1.0])

    def test_curves(self):
        for target, method in ((SURFACE, "Exact"), (GRAPH, "Graph")):
            paths = kernel.paths(target, [[0, 440], [3, 17]], method=method)
            np.testing.assert_allclose(
                paths.cell_data["Length"], [math.hypot(20, 20), 14], rtol=1e-6
            )
            self.assertEqual(paths.number_of_fallbacks, 0)
        offsets, ids = paths.cells["lines"]
        np.testing.assert_allclose(paths.points[ids[offsets[0]]], PLANE[0][0])
        loops, tapes = kernel.loops(TORUS, mode="AroundHandles", tape_width=0.1)
        lengths = np.sort(loops.cell_data["Length"])
        self.assertEqual(len(lengths), 2)
        self.assertAlmostEqual(lengths[0], 24 * math.sin(math.pi / 12), 1)
        self.assertGreaterEqual(len(tapes.cells["lines"][0]), 3)
        through, _ = kernel.loops(kernel.Graph(TORUS), [0])
        self.assertLess(through.cell_data["Length"][0], lengths[1] + 8)

    def test_regions(self):
        surface, boundaries, cells, sites = kernel.voronoi(GRAPH, [210, 230])
        np.testing.assert_allclose(sites.point_data["CellArea"], [200, 200], rtol=1e-6)
        self.assertEqual(set(surface.point_data["GeodesicSource"][[0, 20]]), {0, 1})
        self.assertEqual(set(cells.cell_data["SiteId"].tolist()), {0, 1})
        self.assertEqual(boundaries.cell_data["SiteId"].tolist(), [[0, 1]])
        samples = kernel.samples(GRAPH, number_of_samples=4, first_sample=0)
        ids = samples.point_data["vtkOriginalPointIds"]
        self.assertEqual(set(ids.tolist()), {0, 20, 420, 440})
        given = kernel.samples(GRAPH, PLANE[0][:2], number_of_samples=3)
        self.assertEqual(given.point_data["vtkOriginalPointIds"][:2].tolist(), [0, 1])

    def test_fields(self):
        exact = kernel.exact_distance(SURFACE, 0, generate_windows=True)
        distances = exact.point_data[DISTANCE]
        windows = {"field_data": exact.field_data}
        lines, ridges, bands = kernel.isolines(
            SURFACE, distances, values=[5.0, 7.5], generate_bands=True, **windows
        )
        radii = np.linalg.norm(lines.points, axis=1)
        np.testing.assert_allclose(np.unique(radii.round(9)), [5.0, 7.5])
        self.assertEqual(len(ridges.points), 0)
        self.assertEqual(set(bands.cell_data["Band"].tolist()), {0, 1, 2})
        points = np.column_stack([np.random.default_rng(1).random((50, 2)) * 20, np.zeros(50)])
        values = kernel.probe(SURFACE, distances, points, **windows).point_data[DISTANCE]
        np.testing.assert_allclose(values, np.linalg.norm(points, axis=1), atol=1e-9)
        closest = SURFACE.closest_points(points + [0, 0, 3])
        np.testing.assert_allclose(closest.points, points, atol=1e-12)
        with self.assertRaises(kernel.Error):
            SURFACE.closest_points(points + [0, 0, 3], projection_tolerance=0.01)
        spoiled = dict(exact.field_data, **{f"{DISTANCE}.Windows": np.zeros((3, 5))})
        found = kernel.probe(SURFACE, distances, [0], field_data=spoiled)
        self.assertRegex(found.warnings[0], "They are ignored")
        far = kernel.isolines(SURFACE, distances, values=[99.0], **windows)[0]
        self.assertRegex(far.warnings[0], "There are no isolines")
        heat = kernel.heat_distance(SURFACE, 0, time_step_factor=1000)
        self.assertRegex(heat.warnings[0], "`time_step_factor` is 1000")

    def test_spectral(self):
        ids = [0, 100, 200]
        for function, name in (
            (kernel.greens_function, "GreensFunction"),
            (kernel.biharmonic_distance, "BiharmonicDistance"),
        ):
            surface, at = function(TORUS, ids, evaluation=ids)
            table = surface.point_data[name][ids]
            np.testing.assert_allclose(table, table.T, rtol=0.05, atol=1e-3)
            np.testing.assert_allclose(at.point_data[name], table, rtol=1e-6, atol=1e-9)
        values = np.zeros(288)
        values[ids] = [1.0, 2.0, 3.0]
        spline, _ = kernel.harmonic_spline(TORUS, ids, surface_values=values)
        np.testing.assert_allclose(spline.point_data["Interpolation"][ids], values[ids])
        self.assertEqual(spline.used_sites.tolist(), ids)

    def test_earth_movers(self):
        found = kernel.earth_movers_distance(SURFACE, from_points=[0], to_points=[20])
        self.assertLessEqual(found.distance, 20 * 1.01)
        self.assertGreater(found.lower_bound, 18)
        self.assertEqual(found.cell_data["EarthMoversFlow"].shape, (800, 3))

    def test_vector_graphics(self):
        colors = [[1.0, 0.5, 0.25]]
        curves = {
            "points": [[2.2, 10, 0], [17.7, 10, 0]],
            "lines": ([0, 2], [0, 1]),
            "cell_data": {"CurveType": [0], "LeftColor": colors, "RightColor": colors},
        }
        surface, _ = kernel.vector_graphics(SURFACE, curves, refinement_level=0)
        found = surface.point_data["Colors"]
        np.testing.assert_allclose(found, np.repeat(colors, len(found), 0), atol=1e-6)
        self.assertEqual(surface.origins["points"].shape, (len(found), 3))

    def test_patch_boundaries(self):
        corners = [0, 20, 420]
        both = kernel.patch_boundaries(
            SURFACE, SURFACE, corners, PLANE[0][corners], edges=[[0, 1], [1, 2]]
        )
        for lines in both:
            np.testing.assert_allclose(lines.cell_data["Length"], [20, math.hypot(20, 20)])

    def test_cloud_size(self):
        """Components of a cloud with sparse and dense parts are those of all pairs within the
        gap."""
        draw = np.random.default_rng(2)
        counts = set()
        for gap in (1.1, 1.5, 2.0, 5.0):  # not 1: a spacing is the length of a pair
            points = np.concatenate([draw.random((300, 3)), 0.5 + 1e-3 * draw.random((200, 3))])
            points[0] = np.nan
            spacing, count = kernel.cloud_size(points, gap=gap)
            finite = points[1:]
            lengths = np.linalg.norm(finite[:, None] - finite, axis=2)
            self.assertAlmostEqual(spacing, np.median(np.sort(lengths)[:, 4]))
            labels = np.arange(len(finite))
            near = lengths <= gap * spacing
            while True:
                least = np.where(near, labels, len(finite)).min(axis=1)
                if (least == labels).all():
                    break
                labels = least
            self.assertEqual(count, len(np.unique(labels)))
            counts.add(count)
        self.assertGreater(len(counts), 2)
        self.assertEqual(kernel.cloud_size(np.zeros((0, 3)), gap=5.0), (0.0, 0))

    @unittest.skipUnless(hasattr(kernel, "cloud_graph"), "built without point clouds")
    def test_clouds(self):
        cloud = kernel.Surface(PLANE[0], cloud=True)
        built = kernel.cloud_graph(cloud)
        self.assertEqual(built.component_sizes.tolist(), [441])
        for function, target in (
            (kernel.Graph.distance, built.graph),
            (kernel.fast_marching_distance, cloud),
        ):
            np.testing.assert_allclose(field(function, target, 0), FROM_0, rtol=0.1, atol=0.5)
        copy = kernel.Graph.from_arrays(cloud, built.graph.arrays)
        np.testing.assert_array_equal(copy.matrix([0, 9]), built.graph.matrix([0, 9]))


@unittest.skipUnless(HAS_FILTERS, "built without VTK")
class Filters(unittest.TestCase):
    """Filters and functions give the same bits."""

    @classmethod
    def setUpClass(cls):
        cls.mesh = vtkdgg.meshes.take(*torus())[0].polydata()

    def check(self, results, name, *settings, data=None):
        """Compares all arrays of results with those of the output ports of a filter."""
        solver = getattr(vtkdgg, name)()
        solver.SetInputData(data or self.mesh)
        for method, *values in settings:
            getattr(solver, method)(*values)
        vtkdgg.check(solver)
        for port, found in enumerate(results):
            output = solver.GetOutput(port)
            for kind in ("point", "cell", "field"):
                data = getattr(output, f"Get{kind.title()}Data")()
                for key, values in getattr(found, f"{kind}_data").items():
                    expected = vtk_to_numpy(data.GetArray(key))
                    np.testing.assert_array_equal(values, expected, err_msg=f"{name} {key}")
            if len(found.points) > 0:
                expected = vtk_to_numpy(output.GetPoints().GetData())
                np.testing.assert_array_equal(found.points, expected, err_msg=name)
        return solver.GetOutput()

    def test_distances(self):
        wanted = {"generate_nearest_source": True, "generate_virtual_source": True}
        settings = (("SetSourceIds", [5, 100]), ("GenerateNearestSourceOn",),
                    ("GenerateVirtualSourceOn",))  # fmt: skip
        graph = kernel.Graph(TORUS)
        for function, target, name in (
            (kernel.virtual_source_distance, TORUS, "vtkVirtualSourceGeodesicDistance"),
            (kernel.heat_distance, TORUS, "vtkHeatGeodesicDistance"),
            (kernel.fast_marching_distance, TORUS, "vtkDGGFastMarchingDistance"),
            (kernel.Graph.distance, graph, "vtkDGGDistance"),
        ):
            self.check([function(target, [5, 100], **wanted)], name, *settings)
        exact = kernel.exact_distance(TORUS, [5, 100], generate_windows=True, **wanted)
        name = "vtkExactGeodesicDistance"
        data = self.check([exact], name, ("GenerateWindowsOn",), *settings)
        distances = exact.point_data[DISTANCE]
        lines = kernel.isolines(TORUS, distances, field_data=exact.field_data, values=[1.5, 2.5],
                                generate_ridges=True, generate_bands=True)  # fmt: skip
        settings = (("SetValue", 0, 1.5), ("SetValue", 1, 2.5), ("GenerateRidgesOn",),
                    ("GenerateBandsOn",))  # fmt: skip
        self.check(lines, "vtkApolloniusIsolines", *settings, data=data)

    def test_others(self):
        graph = kernel.Graph(TORUS)
        pairs = kernel.paths(graph, [[0, 100], [7, 200]])
        self.check([pairs], "vtkDGGPath", ("AddPair", 0, 100), ("AddPair", 7, 200))
        cells = kernel.voronoi(graph, [0, 50, 150])
        self.check(cells, "vtkGeodesicVoronoi", ("SetSiteIds", [0, 50, 150]))
        cells = kernel.voronoi(TORUS, [0, 50, 150], preview=True)
        settings = (("SetSiteIds", [0, 50, 150]), ("PreviewOn",))
        self.check(cells, "vtkGeodesicVoronoi", *settings)
        samples = kernel.samples(graph, number_of_samples=9)
        self.check([samples], "vtkGeodesicSampler", ("SetNumberOfSamples", 9))
        for function, name in (
            (kernel.greens_function, "vtkDiscreteGreensFunction"),
            (kernel.biharmonic_distance, "vtkBiharmonicDistance"),
            (kernel.harmonic_spline, "vtkHarmonicBSpline"),
        ):
            self.check([function(TORUS, [0, 100])[0]], name, ("SetSourceIds", [0, 100]))


class Calls(unittest.TestCase):
    def test_arrays(self):
        points, triangles = PLANE
        wide = np.zeros((441, 6))
        wide[:, ::2] = points
        locked = points.copy()
        locked.flags.writeable = False
        offsets = np.arange(0, 2401, 3)
        cells = ((offsets, triangles.ravel()), triangles.astype(np.int32), triangles.tolist())
        for p in (wide[:, ::2], locked, np.asfortranarray(points), points.astype(np.float32)):
            for c in (triangles, *cells):
                np.testing.assert_array_equal(
                    field(kernel.exact_distance, kernel.Surface(p, c), 0),
                    field(kernel.exact_distance, SURFACE, 0),
                )
        surface = kernel.Surface(points.copy(), triangles.copy(), merge_coincident_points=True)
        self.assertEqual(surface.number_of_points, 441)
        self.assertEqual(surface.report()["number_of_boundary_loops"], 1)
        self.assertEqual(surface.warnings, [])
        coordinates = surface.points
        del surface
        np.testing.assert_array_equal(coordinates, points)

    def test_arrays_are_copied(self):
        points, triangles = (array.copy() for array in PLANE)
        surface = kernel.Surface(points, triangles)
        points[:], triangles[:] = 7.0, 0
        for sources in ([0], {"cells": [100], "barycentric": [[0.5, 0.25, 0.25]]}):
            np.testing.assert_array_equal(
                field(kernel.exact_distance, surface, sources),
                field(kernel.exact_distance, SURFACE, sources),
            )

    def test_reuse(self):
        """Calls of one kind reuse their data until release()."""
        surface = kernel.Surface(*PLANE)
        for count, function in enumerate(
            (
                kernel.virtual_source_distance,
                kernel.fast_marching_distance,
                kernel.heat_distance,
                kernel.greens_function,
                kernel.biharmonic_distance,
                kernel.harmonic_spline,
            ),
            1,
        ):
            for source in (0, 5):
                function(surface, [source])
                self.assertEqual(surface.number_of_sessions, count)
        surface.release()
        self.assertEqual(surface.number_of_sessions, 0)

    def test_copies_of_graphs(self):
        arrays = GRAPH.arrays
        self.assertFalse(any(array.flags.writeable for array in arrays.values()))
        for given in (arrays, pickle.loads(pickle.dumps(arrays))):  # noqa: S301
            copy = kernel.Graph.from_arrays(SURFACE, given)
            np.testing.assert_array_equal(
                field(copy.distance, [3.3, 4, 0]), field(GRAPH.distance, [3.3, 4, 0])
            )
            self.assertEqual(copy.number_of_edges, GRAPH.number_of_edges)
        lines = GRAPH.lines()
        self.assertEqual(2 * len(lines.cell_data["Length"]), GRAPH.number_of_edges)
        self.assertGreater(kernel.Graph.estimate(SURFACE).edges, 0)
        info = kernel.graph_info(arrays)
        self.assertEqual((info.construction, info.accuracy, info.is_guaranteed),
                         ("Guaranteed", 0.01, True))  # fmt: skip
        for options, is_stored, pattern in (
            ({}, True, "^$"),
            ({"accuracy": 0.1}, True, "^$"),
            ({"accuracy": 0.001}, True, "has the accuracy 0.01, but `accuracy` is 0.001"),
            ({"accuracy": 0.001, "accept_coarser_graph": True}, True, "^$"),
            ({"accuracy": 0.1, "must_match": True}, False, "^$"),
            ({"accuracy": 0.01, "must_match": True}, True, "^$"),
        ):
            graph = kernel.Graph(SURFACE, stored=arrays, **options)
            self.assertEqual(graph.is_stored, is_stored)
            self.assertRegex("".join(graph.warnings), pattern)
        graph = kernel.Graph(TORUS, stored=arrays)
        self.assertFalse(graph.is_stored or graph.damage)
        self.assertRegex(graph.warnings[0], "out of date|does not fit")
        arrays["DGG.Targets"] = np.flip(arrays["DGG.Targets"])
        self.assertIn("DGG.Targets", kernel.Graph(SURFACE, stored=arrays).damage)
        for surface, given, code in (
            (SURFACE, arrays, "DamagedGraph"),
            (TORUS, GRAPH.arrays, "InvalidInput"),
            (SURFACE, {}, "DamagedGraph"),
        ):
            with self.assertRaises(kernel.Error) as caught:
                kernel.Graph.from_arrays(surface, given)
            self.assertEqual(caught.exception.code, code)

    def test_threads(self):
        surface = kernel.Surface(*grid(60, 60))
        graphs = [kernel.Graph(surface, number_of_threads=n).arrays for n in (1, 3, 8)]
        for graph in graphs[1:]:
            for name, array in graph.items():
                np.testing.assert_array_equal(array, graphs[0][name])
        graph = kernel.Graph.from_arrays(surface, graphs[0])
        ids = list(range(0, 3000, 97))
        with ThreadPoolExecutor(8) as pool:
            found = list(pool.map(lambda i: field(graph.distance, [i, 3000 - i]), ids))
        for i, distances in zip(ids, found):
            np.testing.assert_array_equal(distances, field(graph.distance, [i, 3000 - i]))
        kernel.set_number_of_threads(2)
        self.assertEqual(kernel.get_number_of_threads(), 2)
        if hasattr(os, "fork"):
            child = os.fork()
            if child == 0:
                os._exit(0 if graph.matrix(ids).shape == (31, 31) else 1)
            self.assertEqual(os.waitpid(child, 0)[1], 0)

    def test_interruption(self):
        surface = kernel.Surface(*grid(250, 250))
        reports = []
        kernel.exact_distance(surface, 0, progress=reports.append)
        self.assertEqual(reports, sorted(reports))
        self.assertEqual((reports[0], reports[-1]), (0.0, 1.0))

        def refuse(fraction):
            if fraction > 0.1:
                raise LookupError("enough")

        with self.assertRaisesRegex(LookupError, "enough"):
            kernel.exact_distance(surface, 0, progress=refuse)
        threading.Timer(0.05, os.kill, (os.getpid(), signal.SIGINT)).start()
        with self.assertRaises(KeyboardInterrupt):
            for _ in range(1000):
                kernel.exact_distance(surface, 0)
        self.assertEqual(len(field(kernel.exact_distance, surface, 0)), 251**2)

    def test_errors(self):
        for call, parameter, index, pattern in (
            (lambda: kernel.exact_distance(SURFACE, [0, 441]), "sources", 441, "id 441 is out of"),
            (lambda: kernel.exact_distance(SURFACE, []), "sources", None, "`sources`"),
            (lambda: kernel.exact_distance(SURFACE, 0, maximum_distance=-1), "maximum_distance",
             None, "`maximum_distance` is -1"),
            (lambda: kernel.exact_distance(SURFACE, [9, 9, 9.0]), None, 0,
             "Move the point, or raise `projection_tolerance`"),
            (lambda: kernel.Graph(SURFACE, accuracy=2), "accuracy", None, "`accuracy` is 2"),
            (lambda: kernel.Graph(SURFACE, memory_limit=9), "memory_limit", None, "memory_limit"),
            (lambda: kernel.Surface(*PLANE[:1]), "cells", None, "441 points but no polygons"),
            (lambda: kernel.Surface(PLANE[0], [[0, 1, 441]]), None, None, "441"),
            (lambda: kernel.paths(SURFACE, [0, 1]), "graph", None, "Pass a Graph"),
            (lambda: kernel.heat_distance(SURFACE, 0, time_step_factor=0), "time_step_factor",
             None, "`time_step_factor`"),
            (lambda: kernel.exact_distance(SURFACE, 0, generate_nearest_source=True,
                                           source_array_name=DISTANCE), "source_array_name",
             None, "`distance_array_name` and `source_array_name` are both"),
            (lambda: kernel.isolines(SURFACE, FROM_0, values=[1], chord_tolerance=0),
             "chord_tolerance", None, "1e-06"),
            (lambda: kernel.samples(GRAPH, number_of_samples=0), "number_of_samples", None,
             "at least 1"),
            (lambda: kernel.fast_marching_distance(SURFACE, 0, band_radius=0.1), "band_radius",
             None, "0.5 to 1000"),
        ):  # fmt: skip
            with self.subTest(pattern=pattern), self.assertRaisesRegex(kernel.Error, pattern) as c:
                call()
            error = c.exception
            self.assertEqual((error.parameter, error.index), (parameter, index))
            self.assertEqual(str(error), error.message)
            self.assertIn(error.problem, error.message)
            self.assertIn(error.code, ("InvalidInput", "OutOfMemory"))
        for call, error, pattern in (
            (lambda: kernel.exact_distance(SURFACE, 0, depth=1), TypeError, "`depth`"),
            (lambda: kernel.exact_distance(SURFACE, 0, engine="Slow"), ValueError, '"Triangle"'),
            (lambda: kernel.exact_distance(SURFACE, 0, progress=1), TypeError, "callable"),
            (lambda: kernel.exact_distance(SURFACE, 0, number_of_threads=0), ValueError, "from 1"),
            (lambda: kernel.exact_distance(SURFACE, "a"), ValueError, "integers"),
            (lambda: kernel.Surface([[1, 2]], [[0, 1, 2]]), ValueError, r"shape \(n, 3\)"),
            (lambda: kernel.Surface(PLANE[0], [[0.5, 1, 2]]), ValueError, "integers"),
            (lambda: kernel.Surface(PLANE[0], ([0, 5], [0, 1, 2])), ValueError, "ascend"),
            (lambda: kernel.probe(SURFACE, [1, 2], [0]), ValueError, "one per point, 441"),
            (lambda: kernel.paths(GRAPH, [0]), ValueError, "even number"),
            (lambda: kernel.paths(GRAPH, [0, 1], straighten="no"), ValueError, "expected a bool"),
        ):
            with self.subTest(pattern=pattern), self.assertRaisesRegex(error, pattern):
                call()

    def test_leaks(self):
        points, triangles = PLANE

        def work():
            surface = kernel.Surface(points, triangles)
            graph = kernel.Graph(surface, accuracy=0.1)
            kernel.paths(graph, [[0, 440]], progress=lambda fraction: None)
            kernel.heat_distance(surface, [0])
            with self.assertRaises(kernel.Error):
                graph.distance([-1])
            return graph.arrays

        counted = []
        for _ in range(4):
            for _ in range(5):
                work()
            gc.collect()
            counted.append((len(gc.get_objects()), sys.getrefcount(points), sys.getrefcount(None)))
        self.assertEqual(counted[1][:2], counted[-1][:2])
        self.assertLess(abs(counted[-1][2] - counted[1][2]), 50)


class Files(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = os.path.join(folder.name, "gr\u00fcn")

    def write_and_read(self, file_format, *mesh, **options):
        """Returns the contents of a file, whose arrays must be writeable after the next call."""
        self.assertEqual(kernel.write_mesh(self.path, file_format, *mesh, **options), [])
        found = kernel.read_mesh(self.path, file_format.partition("_")[0])
        for array in (found.points, *found.cells["polygons"], *found.point_data.values()):
            array += 0
        return found

    def test_round_trip(self):
        points, triangles = PLANE
        random = np.random.default_rng(3)
        points = points + random.random(points.shape)
        data = {
            "id": np.arange(len(points), dtype=">i4"),
            "Normals": random.random(points.shape),
            "RGB": random.integers(0, 256, points.shape, dtype=np.uint8),
        }
        for file_format, names, has_polygons in (
            ("obj", ["Normals", "RGB"], True),
            ("off", ["Normals", "RGB"], True),
            ("ply", ["Normals", "RGB", "id"], True),
            ("stl", [], True),
            ("pcd", ["Normals", "RGB", "id"], False),
            ("pcd_text", ["Normals", "RGB", "id"], False),
            ("pcd_compressed", ["Normals", "RGB", "id"], False),
            ("xyz", [], False),
        ):
            with self.subTest(file_format):
                found = self.write_and_read(
                    file_format,
                    points,
                    polygons=triangles,
                    point_data=data,
                    active={"normals": "Normals"},
                )
                self.assertEqual(list(found.point_data), names)
                for name in names:
                    np.testing.assert_allclose(found.point_data[name], data[name], rtol=1e-6)
                    self.assertEqual(found.point_data[name].dtype.kind, data[name].dtype.kind)
                if names:
                    self.assertEqual(found.active, {"normals": "Normals", "scalars": "RGB"})
                if has_polygons:  # points of STL files are in the order of the triangles
                    corners = found.points[found.cells["polygons"][1]]
                    np.testing.assert_array_equal(corners, points[triangles.ravel()])
                else:
                    np.testing.assert_array_equal(found.points, points)

    def test_precision_and_layout(self):
        layout = {"PCD.Dimensions": [7, 63], "PCD.Viewpoint": [1, 2, 3, 1, 0, 0, 0]}
        for dtype in (np.float32, np.float64):
            points = PLANE[0].astype(dtype)
            found = self.write_and_read("pcd", points, field_data=layout)
            self.assertEqual(found.points.dtype, dtype)
            for name, values in layout.items():
                self.assertEqual(found.field_data[name].tolist(), values)

    def test_triangles_of_polygons(self):
        """A polygon in the shape of an L, of area 3."""
        points = [[0, 0, 0], [2, 0, 0], [2, 1, 0], [1, 1, 0], [1, 2, 0], [0, 2, 0]]
        found = self.write_and_read("stl", points, polygons=[range(6)])
        corners = found.points[found.cells["polygons"][1]].reshape(-1, 3, 3)
        normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        np.testing.assert_array_equal(0.5 * normals.sum(axis=0), [0, 0, 3])
        self.assertTrue((normals[:, 2] > 0).all())

    def test_errors(self):
        points, triangles = PLANE
        ply = {"polygons": triangles}
        for error, text, *arguments in (
            (ValueError, "format: expected one of", self.path, "abc", points),
            (ValueError, "id that is out of range", self.path, "ply", points[:9], ply),
            (ValueError, "point array a has 1 values for 441", self.path, "ply", points,
             {"point_data": {"a": [1]}}),
            (ValueError, "a: expected numbers", self.path, "ply", points,
             {"point_data": {"a": ["x"] * len(points)}}),
            (ValueError, "cannot store lines", self.path, "xyz", points, {"lines": [[0, 1]]}),
            (OSError, "cannot be opened", self.path + "/none/x.ply", "ply", points, ply),
        ):  # fmt: skip
            options = arguments.pop() if isinstance(arguments[-1], dict) else {}
            with self.subTest(text), self.assertRaisesRegex(error, text):
                kernel.write_mesh(*arguments, **options)
            self.assertFalse(os.path.exists(self.path))
        with self.assertRaises(FileNotFoundError):
            kernel.read_mesh(self.path, "ply")
        with open(self.path, "wb") as file:
            file.write(b"ply\nformat ascii 1.0\nelement vertex 9\n")
        with self.assertRaisesRegex(ValueError, "truncated"):
            kernel.read_mesh(self.path, "ply")
        rounded = {"point_data": {"a": np.full(len(points), 2**53)}}
        texts = kernel.write_mesh(self.path, "ply", points, **rounded)
        self.assertIn("The array a has integers", texts[0])


if __name__ == "__main__":
    unittest.main()
