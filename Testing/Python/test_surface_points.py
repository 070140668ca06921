# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Surface points by id, by coordinates and by face: the same answers from all functions and
commands, also on slits, seams, coincident layers and files; wrong ones are refused."""

import gzip
import json
import os
import unittest

import numpy as np
import support
import vtkdgg
from support import warnings_as
from vtkdgg.explorer_scene import Scene

FOLDER = support.output_folder("surface_points")
SEEDS = range(0, int(os.environ.get("DGG_TEST_SEEDS", 4)), 3)
SIDE = 9  # points of a layer along each side
# Formats that keep ids; the first two keep lines as well.
FORMATS = (".vtp", ".vtk", ".ply", ".obj", ".off", ".ply.gz", ".off.gz")


def cut(points, triangles, line):
    """Doubles the points of a line x = const; triangles to the right of the line get the copies."""
    copies = np.arange(len(points))
    copies[line] = len(points) + np.arange(len(line))
    is_right = points[triangles, 0].mean(axis=1) > points[line[0], 0]
    triangles = np.where(is_right[:, None], copies[triangles], triangles)
    return np.vstack([points, points[line]]), triangles


class Surface:
    """A random surface with a slit. Some surfaces have a seam that splits them into two components,
    a second layer in the same position, or both. Ids and corners are in random order."""

    def __init__(self, seed):
        self.random = np.random.default_rng(seed)
        points, triangles = support.grid(SIDE - 1, SIDE - 1)
        points[:, 1:] += self.random.uniform(-0.2, 0.2, (len(points), 2))
        column = SIDE * np.arange(SIDE)
        points, triangles = cut(points, triangles, column[: self.random.integers(3, SIDE - 1)] + 3)
        sides = [3, SIDE * SIDE]  # the two points at the open end of the slit
        if seed % 2:
            points, triangles = cut(points, triangles, column + 6)
        if seed % 4 > 1:
            triangles = np.vstack([triangles, triangles + len(points)])
            points = np.vstack([points, points])
        order = self.random.permutation(len(points))
        self.sides = order[sides].tolist()
        self.points = np.empty_like(points)
        self.points[order] = points
        triangles = self.random.permutation(order[triangles])
        turns = self.random.integers(0, 3, len(triangles))
        self.triangles = np.array([np.roll(t, k) for t, k in zip(triangles, turns)])
        self.mesh = self.points, self.triangles
        # Component of the first triangle.
        part = {int(self.triangles[0, 0])}
        while True:
            self.part = np.isin(self.triangles, list(part)).any(axis=1)
            grown = set(self.triangles[self.part].ravel().tolist())
            if len(grown) == len(part):
                break
            part = grown
        self.ids = self.random.permutation(sorted(part))[:5].tolist()

    def polydata(self):
        """Returns the surface with a line, so that ids of cells are not rows of triangles."""
        return support.polydata(*self.mesh, Lines=[[0, 1]])

    def write(self, path):
        """Writes the surface, with the line if the format keeps it. Returns the id of the first
        triangle."""
        keeps_lines = path.endswith(FORMATS[:2])
        plain = path.removesuffix(".gz")
        vtkdgg.write(plain, self.polydata() if keeps_lines else support.polydata(*self.mesh))
        if path != plain:
            with open(plain, "rb") as file, gzip.open(path, "wb") as target:
                target.write(file.read())
        return int(keeps_lines)

    def faces_of(self, ids):
        """Returns points as pairs of a triangle around each and coordinates of its corner."""
        found = []
        for i in ids:
            faces, corners = np.nonzero(self.triangles == i)
            k = self.random.integers(len(faces))
            found.append((int(faces[k]), tuple(np.eye(3)[corners[k]])))
        return found

    def points_in_faces(self):
        """Returns five points inside triangles of the component, as pairs and as coordinates."""
        faces = self.random.permutation(np.flatnonzero(self.part))[:5]
        weights = self.random.dirichlet([2.0, 2.0, 2.0], 5)
        corners = self.points[self.triangles[faces]]
        return list(zip(faces, weights)), (weights[:, :, None] * corners).sum(axis=1)


def shifted(pairs, first=1):
    """Returns the pairs with ids of cells of a surface with this id of the first triangle."""
    return [(face + first, weights) for face, weights in pairs]


def mixed(*namings):
    """Returns points, each in the naming whose turn it is."""
    return [namings[i % len(namings)][i] for i in range(len(namings[0]))]


def numbers_of(result):
    """Returns all numbers of a result, but those that identify points."""
    if isinstance(result, (list, tuple)):
        return np.concatenate([numbers_of(one) for one in result] or [np.empty(0)])
    if hasattr(result, "toarray"):
        return result.toarray().ravel()
    if isinstance(result, vtkdgg.Isoline):  # its points depend on all edges of the mesh
        return np.array([result.value, support.length_of(result.points)])
    if isinstance(result, np.ndarray) or np.isscalar(result):
        return np.ravel(result).astype(float)
    names = [name for name in vars(result) if name not in ("faces", "point_ids", "barycentric")]
    return numbers_of([getattr(result, name) for name in names])


def functions(mesh, merge=False):
    """Returns functions of five surface points, by name."""
    options = {"merge_coincident_points": merge}
    graph = vtkdgg.Graph(*mesh, **options)

    def function(of, *first, **more):
        """Returns a function of some of the points."""
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


#: Functions whose answers depend on other components than those of the points.
ALL_PARTS = ("earth_movers", "fast", "interpolate", "sample", "sample in faces")


class Functions(support.Test):
    def agree(self, expected_on, expected_of, namings, merge=False, left_out=()):
        """Expects that all functions give the same numbers for all namings of points."""
        first = functions(expected_on, merge)
        for mesh, points in namings:
            others = functions(mesh, merge)
            for name in sorted(set(first) - set(left_out)):
                with self.subTest(function=name, points=points), warnings_as("ignore"):
                    expected = numbers_of(first[name](expected_of))
                    found = numbers_of(others[name](points))
                    self.assertTrue(np.isfinite(expected).any())
                    is_drawn = name in ("isolines", "voronoi", "moved")
                    relative, absolute = (1e-4, 1e-5) if is_drawn else (0.0, 1e-6)
                    np.testing.assert_allclose(found, expected, rtol=relative, atol=absolute)

    def test_namings(self):
        for surface in map(Surface, SEEDS):
            mesh, of_vtk = surface.mesh, (surface.polydata(),)
            faces = surface.faces_of(surface.ids)
            namings = (mesh, faces), (mesh, mixed(surface.ids, faces)), (of_vtk, shifted(faces))
            left_out = () if surface.part.all() else ("interpolate",)
            self.agree(mesh, surface.ids, namings, left_out=left_out)
            positions = surface.points[surface.ids]
            # Sites must differ.
            left_out = () if len(np.unique(positions, axis=0)) == 5 else ("interpolate",)
            namings = [(mesh, mixed(faces, positions))]
            self.agree(mesh, surface.ids, namings, merge=True, left_out=left_out)

    def test_inside_faces(self):
        for seed in SEEDS:
            surface = Surface(seed)
            faces, positions = surface.points_in_faces()
            # Coordinates identify points where no other component is in the same position.
            alone = surface.points, surface.triangles[surface.part]
            mixture = mixed(faces, positions) if seed % 4 < 2 else faces
            namings = (surface.mesh, mixture), ((surface.polydata(),), shifted(faces))
            # Steps to means near the boundary depend on rounding errors.
            left_out = ("moved",) if surface.part.all() else ("moved", *ALL_PARTS)
            self.agree(alone, positions, namings, left_out=left_out)

    def test_wrong_points(self):
        """All functions of several points refuse the same."""
        surface = Surface(0)
        mesh, graph = surface.mesh, vtkdgg.Graph(*surface.mesh, accuracy=0.1)
        for call in (
            lambda points: vtkdgg.distance(*mesh, points),
            graph.distance,
            graph.matrix,
            lambda points: graph.paths(points, 19),
            graph.voronoi,
            lambda points: graph.isolines(points, 3),
            lambda points: graph.sample(5, start=points or [0.5]),
            lambda points: vtkdgg.greens_function(*mesh, points),
            lambda points: vtkdgg.biharmonic(*mesh, points),
            lambda points: vtkdgg.earth_movers(*mesh, points, 7),
        ):
            for points in (
                [[0, 0, 1]], [[0, 0]], [0.5, 1.0], 1.5, [], "x", [True], [0, 999], None,
                (999, (0.5, 0.5, 0.0)), [2, [3, (0.5, 0.25, 0.25)]],
            ):  # fmt: skip
                self.refuse(call, ((points,), ""))

    def test_wrong_faces(self):
        points, triangles = support.grid(2, 1)
        mesh = points, [*triangles[:-1].tolist(), [0, 1, 4, 3]]
        inside = (0.2, 0.3, 0.5)
        self.refuse(
            lambda sources: vtkdgg.distance(*mesh, sources),
            (((4, inside),), r"sources: face 4 \(entry 0\) does not exist; there are 4 cells"),
            (([0, (-1, inside)],), r"face -1 \(entry 1\) does not exist"),
            (((3, inside),), "face 3 .* is not a triangle"),
            (((0, (0.2, 0.3, 0.6)),), "barycentric coordinates .* with the sum 1"),
            (((0, (1.2, -0.2, 0.0)),), "expected non-negative numbers"),
            (((0, (np.nan, 0.5, 0.5)),), "expected non-negative numbers"),
            (((0, (0.5, 0.5)),), "three barycentric coordinates"),
            (((0.0, inside),), "an integer"),
            (([0, "a"],), r"sources\[1\]: "),
            (([0, [1, 2, 3]],), r"sources\[1\]: expected a point id"),
            (([0, [1.0, 2.0]],), r"sources\[1\]: expected a point id"),
            (([[0, inside]],), r"sources\[0\]: expected .* a tuple \(face, .*, got a list"),
        )
        # A list is a list of points.
        found = vtkdgg.distance(*mesh, [0, tuple(points[4])])
        np.testing.assert_array_equal(found, vtkdgg.distance(*mesh, [0, 4]))
        wrong = {"points": points, "triangles": [], "sources": (0, inside), "method": "marching"}
        self.refuse(vtkdgg.distance, (wrong, "face 0"))
        if support.HAS_CLOUDS:
            cloud = vtkdgg.CloudGraph(support.bumpy()[0])
            self.refuse(cloud.distance, (((0, inside),), "a point cloud has no faces"))


# Commands, with five surface points in braces. Render writes a picture, the others a table.
COMMANDS = (
    "distance --source {0} --source {1}",
    "distance --source {0} --source {1} --accuracy 0.1 --maximum 2.5",
    "distance --source {0} --source {1} --method fast",
    "distance --source {0} --source {1} --method marching",
    "matrix --source {0} --source {1} --source {2} --source {3} --source {4}",
    "matrix --source {0} --source {1} --targets 3,1,4,1,5",
    "path {0} {1}",
    "path {0} {1} --accuracy 0.1",
    "isolines --source {0} --source {1} --count 3",
    "isolines --source {0} --source {1} --values 0.7,2 --method exact",
    "loop --through {0} --through {1} --through {2} --rope",
    "voronoi --site {2} --site {3} --site {4} --accuracy 0.1",
    "greens --source {0} --source {1}",
    "render --source {0} --source {1}",
)


def text_of(point):
    """Returns a surface point as commands take it."""
    if isinstance(point, tuple):
        return "face:{}:{},{},{}".format(point[0], *point[1])
    return ",".join(map(repr, point)) if np.ndim(point) else str(point)


class Commands(support.Test):
    """Commands of the shell, on files of all formats."""

    def answer(self, *words):
        result = support.call(*words, "--json")
        self.assertEqual(result.returncode, 0, result.stderr)
        found = json.loads(result.stdout)
        return {key: found[key] for key in found if key not in ("seconds", "written", "warnings")}

    def answers(self, path, points):
        """Returns the answers of the commands, and the numbers of the files that they write."""
        found = []
        for line in COMMANDS:
            name, *words = line.format(*map(text_of, points)).split()
            out = os.path.join(FOLDER, "a.png" if name == "render" else "answer.csv")
            answer = self.answer(name, path, *words, "--out", out)
            numbers = np.empty(0)
            if name != "render":
                with open(out, encoding="utf-8") as file:
                    has_header = file.readline()[0].isalpha()
                numbers = np.loadtxt(out, delimiter=",", skiprows=int(has_header), ndmin=2)
            if name == "isolines":  # the points depend on all edges of the mesh
                curves = np.split(numbers[:, 1:4], np.flatnonzero(np.diff(numbers[:, 0])) + 1)
                numbers = np.array(list(map(support.length_of, curves)))
            elif name in ("loop", "path"):  # points on edges have several faces
                numbers = numbers[:, :4]
            found.append((line, answer, numbers))
        return found

    def test_same_answers(self):
        for seed in SEEDS:
            surface = Surface(seed)
            path = os.path.join(FOLDER, f"surface{FORMATS[seed // 3 % len(FORMATS)]}")
            first = surface.write(path)
            faces = shifted(surface.faces_of(surface.ids), first)
            pairs = [(surface.ids, faces)]
            if seed % 4 < 2:  # where no other layer is in the same position
                faces, positions = surface.points_in_faces()
                pairs.append((positions.tolist(), shifted(faces, first)))
            for pair in pairs:
                both = [self.answers(path, points) for points in pair]
                for (line, answer, numbers), (_, known, others) in zip(*both):
                    with self.subTest(line):
                        self.assertEqual(answer.keys(), known.keys())
                        for key, value in answer.items():
                            if isinstance(value, (str, type(None))):
                                self.assertEqual(value, known[key])
                            else:
                                np.testing.assert_allclose(value, known[key], rtol=0.0, atol=1e-6)
                        # Isolines move far where the distance has a small slope.
                        tolerance = 1e-4 if line.startswith("isolines") else 1e-6
                        np.testing.assert_allclose(numbers, others, rtol=0.0, atol=tolerance)

    def test_slit(self):
        """The comparison and the explorer distinguish the sides of a slit."""
        surface = Surface(0)
        side, other = surface.sides
        path, out = (os.path.join(FOLDER, name) for name in ("slit.off", "compared"))
        surface.write(path)
        ((face, corner),) = surface.faces_of([side])
        fields = []
        for source in (side, "face:{}:{:.0f},{:.0f},{:.0f}".format(face, *corner)):
            result = support.call("compare", path, "--source", source, "--out", out)
            self.assertEqual(result.returncode, 0, result.stderr)
            data = vtkdgg.read(os.path.join(out, "distance.vtp")).point_data
            fields.append(data["GeodesicDistance"])
        scene = Scene(support.polydata(*surface.mesh))
        scene.press(side)
        for distances in (*fields, scene.distances):
            self.assertEqual(distances[side], 0.0)
            self.assertGreater(distances[other], 1.0)

    def test_cells_of_samples(self):
        """Samples of coincident layers have cells of their own."""
        path = os.path.join(FOLDER, "twice.vtp")
        points, triangles = support.bumpy()
        twice = np.vstack([points, points]), np.vstack([triangles, triangles + len(points)])
        vtkdgg.write(path, support.polydata(*twice))
        with warnings_as("ignore"):
            self.assertGreater(min(self.answer("voronoi", path, "--number", 8)["areas"]), 0.1)


if __name__ == "__main__":
    unittest.main()
