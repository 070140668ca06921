# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Surface points by id, by coordinates and by face: the same answers from all functions and
commands, on slits, seams and coincident layers too, and on meshes that were written and read."""

import gzip
import json
import os
import unittest
import warnings

import numpy as np
import support
import vtkdgg
from vtkdgg.explorer_scene import Scene
from vtkmodules.vtkCommonDataModel import vtkCellArray

FOLDER = support.output_folder("surface_points")
SEEDS = range(0, int(os.environ.get("DGG_TEST_SEEDS", 4)), 3)
SIDE = 9  # points of a layer along each side
# Formats that keep ids; the first two keep lines as well.
FORMATS = (".vtp", ".vtk", ".ply", ".obj", ".off", ".ply.gz", ".off.gz")


def slit_grid():
    """A grid of 21 x 21 points with a slit along x = 0.5, y < 0.79, and the points of the slit:
    those on the left, and the copies on the right."""
    x, y = np.meshgrid(np.linspace(0, 1, 21), np.linspace(0, 1, 21), indexing="ij")
    points = np.column_stack([x.ravel(), y.ravel(), np.zeros(441)])
    corner = (21 * np.arange(20)[:, None] + np.arange(20)).ravel()
    triangles = np.vstack(
        [
            np.column_stack([corner, corner + 21, corner + 22]),
            np.column_stack([corner, corner + 22, corner + 1]),
        ]
    )
    left = 210 + np.flatnonzero(points[210:231, 1] < 0.79)
    return cut(points, triangles, left)


def cut(points, triangles, line):
    """Doubles the points of a line x = const; triangles to the right of it get the copies."""
    copies = np.arange(len(points))
    copies[line] = len(points) + np.arange(len(line))
    is_right = points[triangles, 0].mean(axis=1) > points[line[0], 0]
    triangles = np.where(is_right[:, None], copies[triangles], triangles)
    return np.vstack([points, points[line]]), triangles, line, copies[line]


class Surface:
    """A random surface with a slit. Others have a seam that splits them into two parts, a second
    layer in the same position, or both. Ids of points and triangles, and corners, are in random
    order."""

    def __init__(self, seed):
        self.random = np.random.default_rng(seed)
        points, triangles = support.grid(SIDE - 1, SIDE - 1)
        points[:, 1:] += self.random.uniform(-0.2, 0.2, (len(points), 2))
        column = SIDE * np.arange(SIDE)
        slit = column[: self.random.integers(3, SIDE - 1)] + 3
        points, triangles, *_ = cut(points, triangles, slit)
        if seed % 2:
            points, triangles, *_ = cut(points, triangles, column + 6)
        if seed % 4 > 1:
            triangles = np.vstack([triangles, triangles + len(points)])
            points = np.vstack([points, points])
        order = self.random.permutation(len(points))
        self.points = np.empty_like(points)
        self.points[order] = points
        triangles = self.random.permutation(order[triangles])
        turns = self.random.integers(0, 3, len(triangles))
        self.triangles = np.array([np.roll(t, k) for t, k in zip(triangles, turns)])
        # A part, which is not always all of it.
        part = {int(self.triangles[0, 0])}
        while True:
            self.part = np.isin(self.triangles, list(part)).any(axis=1)
            grown = set(self.triangles[self.part].ravel().tolist())
            if len(grown) == len(part):
                break
            part = grown
        self.ids = self.random.permutation(sorted(part))[:5].tolist()

    def polydata(self):
        """The surface with a line, so that ids of cells are not rows of triangles."""
        result = support.polydata(self.points, self.triangles)
        line = vtkCellArray()
        line.InsertNextCell(2, [0, 1])
        result.SetLines(line)
        return result

    def write(self, path):
        """Writes the surface, with the line if the format keeps it. Returns the id of the first
        triangle."""
        keeps_lines = path.endswith(FORMATS[:2])
        plain = path.removesuffix(".gz")
        mesh = self.polydata() if keeps_lines else support.polydata(self.points, self.triangles)
        vtkdgg.write(plain, mesh)
        if path != plain:
            with open(plain, "rb") as file, gzip.open(path, "wb") as target:
                target.write(file.read())
        return int(keeps_lines)

    def faces_of(self, ids):
        """Points as pairs of a triangle around each and coordinates of its corner."""
        found = []
        for i in ids:
            faces, corners = np.nonzero(self.triangles == i)
            k = self.random.integers(len(faces))
            found.append((int(faces[k]), tuple(np.eye(3)[corners[k]])))
        return found

    def points_in_faces(self):
        """Five points inside triangles of the part, as pairs and as coordinates."""
        faces = self.random.permutation(np.flatnonzero(self.part))[:5]
        weights = self.random.dirichlet([2.0, 2.0, 2.0], 5)
        corners = self.points[self.triangles[faces]]
        return list(zip(faces, weights)), (weights[:, :, None] * corners).sum(axis=1)


def shifted(pairs, first=1):
    """Returns the pairs with ids of cells of a surface with this id of the first triangle."""
    return [(face + first, weights) for face, weights in pairs]


def mixed(*namings):
    """A point of each in turn."""
    return [namings[i % len(namings)][i] for i in range(len(namings[0]))]


def numbers_of(result):
    """All numbers of a result, but those that identify points."""
    if isinstance(result, (list, tuple)):
        return np.concatenate([numbers_of(one) for one in result] or [np.empty(0)])
    if hasattr(result, "toarray"):
        return result.toarray().ravel()
    if isinstance(result, vtkdgg.Isoline):  # whose points depend on all edges of the mesh
        return np.array([result.value, result.arc_lengths[-1]])
    if isinstance(result, np.ndarray) or np.isscalar(result):
        return np.ravel(result).astype(float)
    names = [name for name in vars(result) if name not in ("faces", "point_ids", "barycentric")]
    return numbers_of([getattr(result, name) for name in names])


def lengths_of(curves):
    """The length of each curve, from rows of a curve, x, y, z."""
    steps = np.linalg.norm(np.diff(curves[:, 1:4], axis=0), axis=1)
    steps[np.diff(curves[:, 0]) != 0] = 0.0
    return np.bincount(curves[1:, 0].astype(int), steps)


def functions(mesh, merge):
    """By name, functions of five surface points."""
    options = {"merge_coincident_points": merge}
    graph = vtkdgg.Graph(*mesh, **options)

    def function(of, *first, **more):
        """A function of some of the points."""
        return lambda p: of(*mesh, *(p[part] for part in first), **more, **options)

    pair, rest = slice(2), slice(2, 5)
    return {
        "exact": function(vtkdgg.distance, pair, return_source=True),
        "bounded": function(vtkdgg.distance, pair, maximum_distance=2.5),
        "initial": function(vtkdgg.distance, pair, initial_distances=[0.5, 0.25]),
        "graph": function(vtkdgg.distance, pair, method="graph"),
        "fast": function(vtkdgg.distance, pair, method="fast"),
        "marching": function(vtkdgg.distance, pair, method="marching"),
        "path": function(vtkdgg.path, 0, 1),
        "path in graph": function(vtkdgg.path, 0, 1, accuracy=0.1),
        "greens": function(vtkdgg.greens_function, pair),
        "greens at": lambda p: function(vtkdgg.greens_function, pair, at=p[rest])(p),
        "biharmonic": function(vtkdgg.biharmonic, pair, method="Exact"),
        "biharmonic at": lambda p: function(vtkdgg.biharmonic, pair, method="Exact", at=p[rest])(p),
        "earth_movers": lambda p: function(vtkdgg.earth_movers, pair, slice(2, 4))(p).lower_bound,
        "interpolate": lambda p: vtkdgg.interpolate(
            *mesh, p[:3], [1.0, 4.0, 2.0], at=p[rest], **options
        ),
        "Graph.distance": lambda p: graph.distance(p, initial_distances=0.5, return_source=True),
        "Graph.distance, bounded": lambda p: graph.distance(p[pair], maximum_distance=2.5),
        "matrix": lambda p: graph.matrix(p[pair], p[rest]),
        "filled matrix": lambda p: graph.matrix(p[pair], p[rest], out=np.empty((2, 3))),
        "symmetric matrix": graph.matrix,
        "sparse_matrix": lambda p: graph.sparse_matrix(3.0, p[pair]),
        "Graph.path": lambda p: graph.path(p[0], p[1]),
        "paths": lambda p: graph.paths(p[pair], p[2:4]),
        "paths from one": lambda p: graph.paths(p[:1], p[1:]),
        "sample": lambda p: graph.sample(7, start=p[pair]),
        "sample in faces": lambda p: graph.sample(7, start=p[pair], in_faces=True),
        "voronoi": graph.voronoi,
        "moved": lambda p: graph.voronoi(p, iterations=2),
        "isolines": lambda p: graph.isolines(p[pair], [0.7, 2.0]),
        "neighborhood": lambda p: graph.neighborhood(p[0], 2.0),
        "loop": lambda p: graph.loop(p[:3], rope=True),
    }


#: Commands that write curves.
CURVES = ("isolines", "loop", "path")
#: Functions whose answers depend on other parts than those of the points.
ALL_PARTS = ("earth_movers", "fast", "interpolate", "sample", "sample in faces")


class Functions(unittest.TestCase):
    def setUp(self):
        warnings.simplefilter("ignore")

    def agree(self, expected_on, expected_of, namings, merge=False, left_out=()):
        """All functions of the points on a mesh give what they give on others."""
        first = functions(expected_on, merge)
        for mesh, points in namings:
            others = functions(mesh, merge)
            for name in sorted(set(first) - set(left_out)):
                with self.subTest(function=name, points=points):
                    expected = numbers_of(first[name](expected_of))
                    found = numbers_of(others[name](points))
                    self.assertTrue(np.isfinite(expected).any())
                    tolerance = 1e-4 if name == "isolines" else 0.0
                    np.testing.assert_allclose(found, expected, rtol=tolerance, atol=1e-6)

    def test_ids_and_corners(self):
        for seed in SEEDS:
            surface = Surface(seed)
            mesh, of_vtk = (surface.points, surface.triangles), (surface.polydata(),)
            faces = surface.faces_of(surface.ids)
            self.agree(
                mesh,
                surface.ids,
                [(mesh, faces), (mesh, mixed(surface.ids, faces)), (of_vtk, shifted(faces))],
                left_out=() if surface.part.all() else ("interpolate",),
            )

    def test_inside_faces(self):
        for seed in SEEDS:
            surface = Surface(seed)
            faces, positions = surface.points_in_faces()
            mesh, of_vtk = (surface.points, surface.triangles), (surface.polydata(),)
            # Coordinates identify points where no other part is in the same position.
            alone = surface.points, surface.triangles[surface.part]
            mixture = mixed(faces, positions) if seed % 4 < 2 else faces
            self.agree(
                alone,
                positions,
                [(mesh, mixture), (of_vtk, shifted(faces))],
                # Steps to means near the boundary depend on rounding errors.
                left_out=("moved",) if surface.part.all() else ("moved", *ALL_PARTS),
            )

    def test_files(self):
        for seed in SEEDS:
            surface = Surface(seed)
            faces = surface.faces_of(surface.ids)
            namings = []
            for extension in FORMATS:
                path = os.path.join(FOLDER, f"file{extension}")
                first = surface.write(path)
                again = vtkdgg.read(path)
                np.testing.assert_array_equal(again.points, surface.points)
                np.testing.assert_array_equal(again.triangles, surface.triangles)
                namings.append(((again,), mixed(surface.ids, shifted(faces, first))))
            self.agree(
                (surface.points, surface.triangles),
                surface.ids,
                namings,
                left_out=() if surface.part.all() else ("interpolate",),
            )

    def test_merged(self):
        for seed in SEEDS:
            surface = Surface(seed)
            mesh = surface.points, surface.triangles
            faces = surface.faces_of(surface.ids)
            positions = surface.points[surface.ids]
            self.agree(
                mesh,
                surface.ids,
                [(mesh, mixed(faces, positions))],
                merge=True,
                # Sites must differ.
                left_out=() if len(np.unique(positions, axis=0)) == 5 else ("interpolate",),
            )


class Commands(unittest.TestCase):
    """Commands of the shell."""

    def answer(self, *words):
        result = support.call(*words, "--json")
        self.assertEqual(result.returncode, 0, result.stderr)
        found = json.loads(result.stdout)
        return {key: found[key] for key in found if key not in ("seconds", "written", "warnings")}

    def answers(self, path, words_of):
        """Returns commands, their answers, and the numbers of the files that they write; that with
        --iterations is the last one. `words_of` returns the options for some of five points."""
        pair, rest, graph = slice(2), slice(2, 5), ("--accuracy", 0.1)
        source = words_of("--source", pair)
        found = []
        for words in (
            ("distance", *source),
            ("distance", *source, *graph),
            ("distance", *source, "--maximum", 2.5),
            ("distance", *source, *graph, "--maximum", 2.5),
            ("distance", *source, "--method", "fast"),
            ("distance", *source, "--method", "marching"),
            ("matrix", *words_of("--source", slice(5))),
            ("matrix", *source, "--targets", "3,1,4,1,5"),
            ("path", *words_of(None, pair)),
            ("path", *words_of(None, pair), *graph),
            ("isolines", *source, "--count", 3),
            ("isolines", *source, "--values", "0.7,2", "--method", "exact"),
            ("loop", *words_of("--through", slice(3)), "--rope"),
            ("voronoi", *words_of("--site", rest), "--accuracy", 0.1),
            ("greens", *source),
            ("voronoi", *words_of("--site", slice(5)), "--iterations", 2),
        ):
            out = os.path.join(FOLDER, "answer.csv")
            answer = self.answer(words[0], path, *words[1:], "--out", out)
            with open(out, encoding="utf-8") as file:
                has_header = file.readline()[0].isalpha()
            numbers = np.loadtxt(out, delimiter=",", skiprows=int(has_header), ndmin=2)
            if words[0] == "isolines":  # whose points depend on all edges of the mesh
                numbers = lengths_of(numbers)
            elif words[0] in CURVES:  # whose points on edges have several faces: coordinates only
                numbers = numbers[:, :4]
            found.append((words, answer, numbers))
        picture = os.path.join(FOLDER, "a.png")
        answer = self.answer("render", path, *source, "--out", picture)
        return [(["render", *source], answer, np.empty(0)), *found]

    def agree(self, found, expected):
        for (words, answer, numbers), (_, known, others) in zip(found, expected):
            with self.subTest(command=words):
                self.assertEqual(answer.keys(), known.keys())
                for key, value in answer.items():
                    if isinstance(value, (str, type(None))):
                        self.assertEqual(value, known[key])
                    else:
                        np.testing.assert_allclose(value, known[key], rtol=0.0, atol=1e-6)
                # Isolines move far where the distance has a small slope.
                tolerance = 1e-4 if words[0] == "isolines" else 1e-6
                np.testing.assert_allclose(numbers, others, rtol=0.0, atol=tolerance)

    def test_same_answers(self):
        for seed in SEEDS:
            surface = Surface(seed)
            path = os.path.join(FOLDER, f"surface{FORMATS[seed // 3 % len(FORMATS)]}")
            first = surface.write(path)

            def named(points):
                """Returns a function for the options of some of the points."""
                texts = [
                    "face:{}:{},{},{}".format(p[0], *p[1]) if isinstance(p, tuple)
                    else ",".join(map(repr, p)) if np.ndim(p) else str(p)
                    for p in points
                ]  # fmt: skip
                return lambda option, part: [
                    word for text in texts[part] for word in (option, text) if word
                ]

            def listed(option, part):
                """Returns options of ids, which are in --sources and in a file where possible."""
                if option != "--source":
                    return named(surface.ids)(option, part)
                name = os.path.join(FOLDER, f"sources_{part.stop}.txt")
                with open(name, "w", encoding="utf-8") as file:
                    file.write("# ids\n\n")
                    file.writelines(f"  {i}\n" for i in surface.ids[part][1:])
                return ["--sources", surface.ids[part][0], "--source-file", name]

            faces = shifted(surface.faces_of(surface.ids), first)
            expected = self.answers(path, named(surface.ids))
            for words_of in (named(faces), named(mixed(surface.ids, faces)), listed):
                self.agree(self.answers(path, words_of), expected)
            if seed % 4 < 2:  # where no other layer is in the same position
                faces, positions = surface.points_in_faces()
                both = positions.tolist(), shifted(faces, first)
                # Steps of --iterations near the boundary depend on rounding errors.
                self.agree(*(self.answers(path, named(points))[:-1] for points in both))


class Slit(unittest.TestCase):
    """Values that are known."""

    @classmethod
    def setUpClass(cls):
        warnings.simplefilter("ignore")
        cls.points, cls.triangles, cls.left, cls.right = slit_grid()
        cls.mesh = cls.points, cls.triangles
        cls.graph = vtkdgg.Graph(*cls.mesh)

    def test_samples_to_begin_with(self):
        for i in (*self.left, *self.right):
            self.assertEqual(self.graph.sample(2, start=[i]).point_ids[0], i)

    def test_ids_beside_coordinates(self):
        i, copy = self.left[2], self.right[2]
        near = [0.55, 0.1, 0.0]
        for find in (lambda *ends: vtkdgg.path(*self.mesh, *ends), self.graph.path):
            self.assertAlmostEqual(find(copy, near).length, 0.05, delta=1e-9)
            self.assertGreater(find(i, near).length, 1.3)
        lengths = [path.length for path in self.graph.paths([i, copy], [near, near])]
        np.testing.assert_allclose(
            self.graph.matrix([i, near, copy])[1], [lengths[0], 0.0, lengths[1]], rtol=0.01
        )
        distances = vtkdgg.distance(*self.mesh, [i, [0.05, 0.95, 0.0]])
        self.assertEqual(distances[i], 0.0)
        self.assertGreater(distances[copy], 1.0)

    def test_command(self):
        path, out = (os.path.join(FOLDER, name) for name in ("slit.vtp", "distance.vtp"))
        vtkdgg.write(path, support.polydata(*self.mesh))
        sources = "--source", 212, "--source", "0.05,0.95,0"
        self.assertEqual(support.call("distance", path, *sources, "--out", out).returncode, 0)
        self.assertEqual(vtkdgg.read(out).point_data["GeodesicDistance"][212], 0.0)

    def test_explorer(self):
        scene = Scene(support.polydata(*self.mesh))
        scene.press(int(self.left[2]))
        self.assertEqual(scene.distances[self.left[2]], 0.0)
        self.assertGreater(scene.distances[self.right[2]], 1.0)

    def test_comparison(self):
        path, out = (os.path.join(FOLDER, name) for name in ("slit.vtp", "compared"))
        vtkdgg.write(path, support.polydata(*self.mesh))
        for source in (self.left[2], "face:{}:{:.0f},{:.0f},{:.0f}".format(*self.corner(212))):
            result = support.call("compare", path, "--source", source, "--out", out)
            self.assertEqual(result.returncode, 0, result.stderr)
            result = vtkdgg.read(os.path.join(out, "distance.vtp"))
            self.assertEqual(result.point_data["GeodesicDistance"][212], 0.0)

    def corner(self, i):
        """A triangle around a point and the coordinates of its corner."""
        faces, corners = np.nonzero(self.triangles == i)
        return faces[0], *np.eye(3)[corners[0]]


class Layers(unittest.TestCase):
    """A sphere that is present twice."""

    @classmethod
    def setUpClass(cls):
        warnings.simplefilter("ignore")
        points, triangles = support.bumpy()
        cls.count = len(triangles)
        cls.mesh = np.vstack([points, points]), np.vstack([triangles, triangles + len(points)])
        cls.graph = vtkdgg.Graph(*cls.mesh, accuracy=0.05)

    def test_cells_of_samples(self):
        path = os.path.join(FOLDER, "twice.vtp")
        vtkdgg.write(path, support.polydata(*self.mesh))
        areas = json.loads(support.call("voronoi", path, "--number", 8, "--json").stdout)["areas"]
        self.assertGreater(min(areas), 0.1)

    def test_results_identify_their_points(self):
        samples = self.graph.sample(12, in_faces=True)
        cells = self.graph.voronoi(list(zip(samples.faces, samples.barycentric)), iterations=3)
        self.assertEqual((cells.faces < self.count).sum(), 6)
        again = self.graph.voronoi(list(zip(cells.faces, cells.barycentric)))
        np.testing.assert_allclose(again.areas, cells.areas, atol=1e-9)
        path = self.graph.path(
            *zip(cells.faces[cells.faces >= self.count][:2], cells.barycentric[:2])
        )
        self.assertTrue((path.faces >= self.count).all())
        for found in (samples, path):
            corners = self.mesh[0][self.mesh[1][found.faces]]
            positions = (found.barycentric[:, :, None] * corners).sum(axis=1)
            np.testing.assert_allclose(positions, found.points, atol=1e-12)


class Mistakes(unittest.TestCase):
    def test_faces(self):
        points, triangles = support.grid(2, 1)
        mesh = points, [*triangles[:-1].tolist(), [0, 1, 4, 3]]
        inside = (0.2, 0.3, 0.5)
        for sources, pattern in (
            ((4, inside), r"sources: face 4 \(entry 0\) does not exist; there are 4 cells"),
            ([0, (-1, inside)], r"face -1 \(entry 1\) does not exist"),
            ((3, inside), "face 3 .* is not a triangle"),
            ((0, (0.2, 0.3, 0.6)), "barycentric coordinates .* have the sum 1"),
            ((0, (1.2, -0.2, 0.0)), "expected numbers that are not negative"),
            ((0, (np.nan, 0.5, 0.5)), "expected numbers that are not negative"),
            ((0, (0.5, 0.5)), "three barycentric coordinates"),
            ((0.0, inside), "an integer"),
            ([0, "a"], r"sources\[1\]: "),
            ([0, [1, 2, 3]], r"sources\[1\]: expected a point id"),
            ([0, [1.0, 2.0]], r"sources\[1\]: expected a point id"),
            ([[0, inside]], r"sources\[0\]: expected .* a tuple \(face, .*, got a list"),
        ):
            with self.subTest(sources=sources):
                with self.assertRaisesRegex(ValueError, pattern):
                    vtkdgg.distance(*mesh, sources)
        # A list is a list of points.
        near = tuple(points[4])
        np.testing.assert_array_equal(
            vtkdgg.distance(*mesh, [0, near]), vtkdgg.distance(*mesh, [0, 4])
        )
        with self.assertRaisesRegex(ValueError, "start: expected .* a tuple .*, got a list"):
            vtkdgg.path(*mesh, [0, inside], 4)
        with self.assertRaisesRegex(ValueError, "face 0"):
            vtkdgg.distance(points, [], (0, inside), method="marching")
        if support.HAS_CLOUDS:
            cloud = vtkdgg.CloudGraph(support.bumpy()[0])
            with self.assertRaisesRegex(ValueError, "a point cloud has no faces"):
                cloud.distance((0, inside))


if __name__ == "__main__":
    unittest.main()
