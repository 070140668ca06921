# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""The explorer, with synthetic events: the window shows the answers of the functions."""

import json
import os
import re
import unittest
import warnings
from unittest import mock

import numpy as np
import support
import vtkdgg
from support import BUMPY, HAS_CLOUDS
from vtkdgg import explorer
from vtkdgg import Error
from vtkdgg.explorer import Explorer, Scene
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData

FOLDER = support.output_folder("explorer")


# Opens two windows, one after the other; each is closed by its key after 10 ms.
START = """
import sys
import vtkdgg
from vtkdgg import explorer

mesh = vtkdgg.read(sys.argv[1]).as_polydata()
for _ in range(2):
    scene = explorer.Scene(mesh)
    window = explorer.Explorer(scene, size=(300, 200), place=mesh.GetPoint(5))

    def leave(interactor, event):
        print(scene.used, len(scene.values))
        interactor.SetKeyEventInformation(0, 0, "q", 0, "q")
        interactor.InvokeEvent("CharEvent")

    window.interactor.Initialize()
    window.interactor.AddObserver("TimerEvent", leave)
    window.interactor.CreateOneShotTimer(10)
    window.start()
    print("graph" if scene._graph else "no graph", "open" if window.window else "closed", sep=", ")
"""


class Hand:
    """The events that a user causes in a window."""

    def __init__(self, test, surface, **options):
        for name in os.listdir(FOLDER):
            os.remove(os.path.join(FOLDER, name))
        self.scene = Scene(surface, **options)
        self.window = Explorer(self.scene, os.path.join(FOLDER, "shot.png"), (400, 300))
        test.addCleanup(self.window.close)
        self.window.window.Render()

    def pixel(self, place):
        """Returns the pixel that shows a position."""
        renderer = self.window.renderer
        renderer.SetWorldPoint(*place, 1.0)
        renderer.WorldToDisplay()
        return np.array(renderer.GetDisplayPoint()[:2])

    def middle(self, right=0, up=0):
        """Returns a pixel beside the middle of the surface."""
        x, y = self.pixel(self.scene.surface.GetCenter())
        return int(x) + right, int(y) + up

    def send(self, event, pixel, control=0):
        """Sends an event of the mouse."""
        self.window.interactor.SetEventInformation(*pixel, control, 0)
        self.window.interactor.InvokeEvent(event)

    def press(self, pixel, control=0):
        """Presses the left button."""
        self.send("LeftButtonPressEvent", pixel, control)

    def move(self, pixel):
        """Moves the mouse."""
        self.send("MouseMoveEvent", pixel)

    def release(self, pixel):
        """Releases the left button."""
        self.send("LeftButtonReleaseEvent", pixel)

    def click(self, *pixels):
        """Clicks on the pixels, one after the other."""
        for pixel in pixels:
            self.press(pixel)
            self.release(pixel)

    def key(self, *keys):
        """Presses keys."""
        for key in keys:
            self.window.interactor.SetKeyEventInformation(0, 0, key, 0, key)
            self.window.interactor.InvokeEvent("KeyPressEvent")
            self.window.interactor.InvokeEvent("CharEvent")

    def place(self, i=0):
        """Returns a chosen position, as functions take it."""
        return np.array(self.scene.places[i])

    def camera(self):
        """Returns the position of the camera."""
        return np.array(self.window.renderer.GetActiveCamera().GetPosition())

    def status(self):
        """Returns the text of the window."""
        return self.window._status.GetInput()


class Surface(support.Test):
    @classmethod
    def setUpClass(cls):
        cls.mesh = vtkdgg.read(BUMPY).as_polydata()
        cls.graph = vtkdgg.Graph(cls.mesh)

    def setUp(self):
        self.hand = Hand(self, self.mesh)
        self.scene = self.hand.scene

    def assert_equal(self, found, expected):
        np.testing.assert_allclose(found, expected, rtol=1e-12, atol=1e-12)

    def test_source_and_drag(self):
        hand, scene = self.hand, self.scene
        self.assertIsNone(scene.values)
        for i, pixel in enumerate((hand.middle(), hand.middle(30, 20))):
            with mock.patch.object(vtkdgg._kernel, "Surface", None):  # it was prepared before
                hand.press(pixel) if i == 0 else hand.move(pixel)
            self.assertLess(np.abs(hand.pixel(hand.place()) - pixel).max(), 0.6)
            # The position is on the surface: nothing has to be projected.
            fast = vtkdgg.distance(self.mesh, hand.place(), method="fast", projection_tolerance=0)
            self.assert_equal(scene.distances, fast)
            self.assertEqual((scene.used, scene.shown, len(scene.places)), ("fast", "distance", 1))
            values = np.unique(vtk_to_numpy(scene.lines.GetCellData().GetArray("IsoValue")))
            count = np.ceil(fast.max() / scene.step)
            self.assert_equal(values, scene.step * np.arange(1, count))
            self.assertEqual(scene.lines, hand.window._lines.GetMapper().GetInput())
            text = hand.status()
            at = "({:.6g}, {:.6g}, {:.6g})".format(*hand.place())
            nearest = np.linalg.norm(support.bumpy()[0] - hand.place(), axis=1).argmin()
            said = f"h: help\nsource: {at}, nearest point {nearest}"
            self.assertEqual(hand.window._help.GetInput(), said)
            self.assertRegex(text, r"by fast: nothing is promised\nfast [\d.]+ ms, isolines [\d.]+")
        self.assertRegex(text, r"\n\d+ frames a second without rendering\Z")
        self.assertGreater(hand.window.seconds, 0.0)
        # At rest by the graph.
        hand.release(pixel)
        self.assert_equal(scene.distances, self.graph.distance(hand.place()))
        self.assertRegex(hand.status(), r"by graph: accuracy 0.01\nbuild [\d.]+ ms")
        self.assertGreater(scene.cells.GetNumberOfCells(), self.mesh.GetNumberOfCells())
        # Hovering changes nothing.
        before = hand.place()
        hand.move(hand.middle())
        self.assert_equal(hand.place(), before)

    def test_suggestion(self):
        hand, scene = self.hand, self.scene
        suggested = np.array(self.mesh.GetPoint(5))
        for pixel in (hand.middle(), hand.pixel(suggested)):
            scene.suggest(suggested)
            scene.update()
            self.assert_equal(scene.distances, self.graph.distance(suggested))
            hand.click(tuple(int(x) for x in pixel))
            # The first click has replaced the suggestion, or holds it.
            self.assertEqual(len(scene.places), 1)
            hand.click(hand.middle(20, 20))
            self.assertEqual(len(scene.places), 2)

    def test_path_and_loop(self):
        hand, scene = self.hand, self.scene
        first, second, third = hand.middle(), hand.middle(40, 10), hand.middle(10, -40)
        hand.click(first, second)
        expected = self.graph.path(hand.place(0), hand.place(1))
        self.assert_equal(scene.path.points, expected.points)
        said = f"path: {expected.length:.6g} model units"
        self.assertIn(said, hand.status())
        self.assertIsNone(scene.loop)
        # The end can be moved, and the path follows.
        distances = scene.distances
        hand.press(second)
        hand.move(hand.middle(50, 20))
        self.assertEqual(len(scene.places), 2)
        expected = self.graph.path(hand.place(0), hand.place(1))
        self.assertNotIn(said, hand.status())
        self.assert_equal(scene.path.length, expected.length)
        self.assertIs(scene.distances, distances)
        hand.release(hand.middle(50, 20))
        hand.click(third)
        places = [hand.place(i) for i in range(3)]
        lengths = [self.graph.path(places[i - 1], places[i]).length for i in range(3)]
        self.assertAlmostEqual(scene.loop.length, sum(lengths), delta=1e-6)
        self.assert_equal(scene.loop.points[0], scene.loop.points[-1])
        self.assertIn(f"loop: {scene.loop.length:.6g} model", hand.status())
        # A further click starts again.
        hand.click(hand.middle(-30, 30))
        self.assertEqual(len(scene.places), 1)
        self.assertIsNone(scene.path)
        self.assertIsNone(scene.loop)

    def test_beside(self):
        hand = self.hand
        for start, control in (((3, 3), 0), (hand.middle(), 1)):
            before = hand.camera()
            hand.press(start, control)
            hand.move((start[0] + 40, start[1] + 10))
            hand.release((start[0] + 40, start[1] + 10))
            self.assertGreater(np.linalg.norm(hand.camera() - before), 0.1)
            self.assertEqual(self.scene.places, [])
        # A drag that leaves the surface keeps the last place on it.
        hand.press(hand.middle())
        place, camera = hand.place(), hand.camera()
        hand.move((3, 3))
        hand.release((3, 3))
        self.assert_equal(hand.place(), place)
        self.assert_equal(hand.camera(), camera)
        self.assert_equal(self.scene.distances, self.graph.distance(place))

    def test_method_and_accuracy(self):
        hand, scene = self.hand, self.scene
        hand.click(hand.middle())
        for method in ("exact", "fast", "graph"):
            hand.key("m")
            self.assertEqual(scene.used, method)
            choice = {"accuracy": 0.01} if method == "graph" else {"method": method}
            self.assert_equal(scene.distances, vtkdgg.distance(self.mesh, hand.place(), **choice))
        hand.key("+")
        self.assertEqual(scene.graph.accuracy, 0.003)
        expected = vtkdgg.distance(self.mesh, hand.place(), accuracy=0.003)
        self.assert_equal(scene.distances, expected)
        self.assertIn("accuracy 0.003", hand.status())
        for _ in range(3):
            hand.key("-")
        self.assertEqual(scene.graph.accuracy, 0.1)
        hand.key("-")
        self.assertEqual(scene.graph.accuracy, 0.1)
        self.assertIn("accuracies are from 0.1 to 0.001", hand.status())

    def test_graph_of_the_surface(self):
        mesh = vtkdgg.Graph(vtkdgg.read(BUMPY).as_polydata(), accuracy=0.05).polydata
        scene = Scene(mesh)
        self.assertEqual((scene.accuracy, scene.graph.used_input_graph), (0.05, True))
        scene.suggest(mesh.GetPoint(5))
        scene.update()
        self.assertIn("by graph: accuracy 0.05", scene.status()[0])
        scene.change_accuracy(1)
        self.assertEqual((scene.accuracy, scene.graph.used_input_graph), (0.03, False))
        self.assertFalse(Scene(mesh, accuracy=0.05001).graph.used_input_graph)

    def test_error(self):
        hand, scene = self.hand, self.scene
        hand.click(hand.middle())
        hand.key("e")
        exact = vtkdgg.distance(self.mesh, hand.place())
        errors = np.abs(self.graph.distance(hand.place()) / exact - 1.0)
        np.testing.assert_allclose(scene.values, 100.0 * errors, atol=1e-9)
        said = r"promised 1 %, measured (\S+) % on average, (\S+) % at most"
        found = [float(number) for number in re.search(said, hand.status()).groups()]
        np.testing.assert_allclose(found, [100 * errors.mean(), 100 * errors.max()], rtol=0.06)
        self.assertEqual(scene.limits[1], 1.0)
        # Distances while the source is moved, errors at rest.
        hand.press(hand.middle())
        hand.move(hand.middle(20, 10))
        self.assertEqual(scene.shown, "distance")
        hand.release(hand.middle(20, 10))
        self.assertEqual(scene.shown, "error")
        hand.key("m")
        self.assertEqual(scene.errors.largest, 0.0)
        hand.key("e")
        self.assertEqual(scene.shown, "distance")

    def test_voronoi(self):
        hand, scene = self.hand, self.scene
        hand.click(hand.middle(-30, 0))
        hand.key("v")
        hand.press(hand.middle(30, 0))
        hand.move(hand.middle(30, 10))
        self.assertIsNone(scene.cells)
        both = [vtkdgg.distance(self.mesh, hand.place(i), method="fast") for i in range(2)]
        clear = np.abs(both[0] - both[1]) > 0.05
        np.testing.assert_array_equal(scene.values[clear], np.argmin(both, axis=0)[clear])
        hand.release(hand.middle(30, 10))
        hand.click(hand.middle(0, 40))
        sites = np.array([hand.place(i) for i in range(3)])
        _, nearest = self.graph.distance(sites, return_source=True)
        np.testing.assert_array_equal(scene.values, nearest)
        sizes = np.bincount(vtk_to_numpy(scene.cells.GetCellData().GetArray("SiteId")))
        expected = self.graph.voronoi(sites, as_polydata=True).GetCellData().GetArray("SiteId")
        np.testing.assert_array_equal(sizes, np.bincount(vtk_to_numpy(expected)))
        hand.click(hand.middle(0, -40))
        self.assertEqual(len(scene.places), 4)
        # The first three become source, end and corner.
        hand.key("v")
        self.assertEqual(len(scene.places), 3)
        self.assert_equal(scene.distances, self.graph.distance(sites[0]))
        self.assertIsNotNone(scene.loop)

    def test_greens(self):
        hand, scene = self.hand, self.scene
        hand.key("g")
        self.assertIsNone(scene.values)
        hand.click(hand.middle())
        expected = vtkdgg.greens_function(self.mesh, hand.place())
        self.assert_equal(scene.values, expected)
        self.assertGreater(scene.lines.GetNumberOfLines(), 5)
        self.assertIn("Green's function", hand.status())
        hand.key("g")
        self.assert_equal(scene.values, self.graph.distance(hand.place()))

    def test_other_keys(self):
        hand, window = self.hand, self.hand.window
        hand.click(hand.middle())
        hand.key("h")
        for key in "m+-evgcrsxhq":
            self.assertRegex(window._help.GetInput(), rf"(?m)^(\+ and )?{re.escape(key)}[: ]")
        hand.key("h")
        self.assertRegex(window._help.GetInput(), "\\Ah: help\nsource: ")
        hand.key("s", "s")
        for number in (1, 2):
            path = os.path.join(FOLDER, f"shot-{number}.png")
            self.assertEqual(window.written[number - 1], path)
            self.assertGreater(support.number_of_colours(path), 500)
        self.assertIn(f"written: {path}", hand.status())
        window.renderer.GetActiveCamera().Zoom(7.0)
        hand.key("r")
        corners = np.array(self.mesh.GetBounds()).reshape(3, 2).T
        for corner in corners:
            self.assertTrue((0 < hand.pixel(corner)).all())
        hand.key("c")
        self.assertEqual(self.scene.places, [])
        self.assertIsNone(self.scene.values)
        self.assertFalse(window._lines.GetVisibility())
        hand.key("x")
        self.assertIn("written: nothing", hand.status())
        hand.key("z")  # has no meaning

    def test_export(self):
        hand, scene = self.hand, self.scene
        hand.click(hand.middle(), hand.middle(40, 10))
        for view, name in (("", "GeodesicDistance"), ("e", "ErrorPercent")):
            if view:
                hand.key(view)
            values, path = scene.values, scene.path.points
            hand.key("x")
            *_, surface, table, line, points = hand.window.written
            found = vtkdgg.read(surface).point_data[name]
            np.testing.assert_array_equal(found, values)
            with open(table, encoding="utf-8") as file:
                self.assertEqual(file.readline().strip(), f"x,y,z,{name}")
                np.testing.assert_array_equal(np.loadtxt(file, delimiter=",")[:, 3], values)
            self.assertEqual(vtkdgg.read(line).lines[0].tolist(), [0, len(path)])
            found = np.genfromtxt(points, delimiter=",", names=True)
            np.testing.assert_array_equal(np.column_stack([found[axis] for axis in "xyz"]), path)
        self.assertTrue(surface.endswith("shot-points-2.vtp") and points.endswith("path-2.csv"))

    def test_start(self):
        # In a process of its own: VTK remembers earlier windows when an event loop starts.
        result = support.python(START, BUMPY)
        self.assertEqual(result.stderr, "")
        # The first picture has not waited for a graph.
        self.assertEqual(result.stdout, 2 * "fast 642\nno graph, closed\n")

    def test_two_parts(self):
        points, triangles = support.grid(4, 4)
        points = np.vstack([points, points + [6, 0, 0]])
        hand = Hand(self, support.polydata(points, np.vstack([triangles, triangles + 25])))
        pixels = [
            tuple(hand.pixel(place).astype(int)) for place in ([2, 2, 0], [8, 2, 0], [7, 1, 0])
        ]
        hand.click(*pixels[:2])
        self.assertEqual(np.isnan(hand.scene.values).sum(), 25)
        self.assertIsNone(hand.scene.path)
        self.assertRegex(hand.status(), "not connected by the surface")
        self.assertIsNone(hand.scene.cells)
        self.assertIsNotNone(hand.scene.lines)
        hand.click(pixels[2])
        self.assertIsNone(hand.scene.loop)
        hand.key("v")
        self.assertEqual(set(hand.scene.values), {0.0, 1.0, 2.0})
        hand.key("e", "s")
        self.assertEqual(len(hand.window.written), 1)

    def test_surfaces(self):
        points, triangles = support.grid(3, 3)
        for cells in ({"Polys": [[0, 3, 15, 12]]}, {"Strips": [[0, 1, 4, 5, 8, 9]]}):
            hand = Hand(self, support.polydata(points, **cells))
            hand.click(hand.pixel([0.6, 0.5, 0.0]).astype(int))
            self.assertAlmostEqual(hand.scene.values[0], np.hypot(*hand.place()[:2]), delta=0.02)
        self.refuse(
            Scene,
            ((vtkPolyData(),), "no points"),
            ({"surface": self.mesh, "accuracy": 0.7}, "accuracy"),
            ((support.polydata(points, Lines=[[0, 1]]),), "surface: contains no surface"),
            ((support.polydata(points, Verts=[[0]]),), "surface: contains no surface"),
        )
        for wrong in (np.nan, np.inf):
            points[5, 1] = wrong
            mesh = support.polydata(points, triangles)
            self.refuse(Scene, ((mesh,), "points: row 5 is not finite"))
        # One triangle without area.
        hand = Hand(self, support.polydata([[0, 0, 0], [1, 0, 0], [2, 0, 0]], [[0, 1, 2]]))
        hand.scene.press(np.array([0.0, 0.0, 0.0]))
        hand.window.draw()
        np.testing.assert_allclose(hand.scene.values, [0, 1, 2], atol=1e-4)
        # The refusal of a filter is shown.
        hand.scene.move(np.array([0.0, 9.0, 0.0]))
        hand.window.draw()
        self.assertIsNone(hand.scene.values)
        self.assertIn("projection_tolerance", hand.status())
        # Nothing is held.
        hand.scene.places, hand.scene.held = [np.zeros(3)], None
        hand.scene.update(is_moving=True)
        np.testing.assert_allclose(hand.scene.values, [0, 1, 2], atol=1e-4)

    def test_no_errors(self):
        # Distances succeed, the exact distances that they are compared with fail.
        hand, scene = self.hand, self.scene
        hand.click(hand.middle())
        search = scene._search

        def refuse(method, is_moving=False):
            if method == "exact":
                raise Error(["no exact distances today"])
            return search(method, is_moving)

        with mock.patch.object(scene, "_search", refuse):
            hand.key("e")
        self.assertIn("no exact distances today", hand.status())
        for name in ("distances", "values", "lines", "cells", "errors"):
            self.assertIsNone(getattr(scene, name), name)
        hand.key("e", "e")
        self.assertIsNotNone(scene.errors)

    def test_no_screenshot(self):
        hand = self.hand
        hand.window._picture = os.path.join(FOLDER, "missing", "shot.png")
        # An exception in an observer is printed and lost.
        with mock.patch("sys.excepthook") as lost:
            hand.key("s")
        lost.assert_not_called()
        self.assertEqual(hand.window.written, [])
        self.assertRegex(hand.status(), "Unable to open file .*shot-1.png")


@support.needs_clouds
class Cloud(unittest.TestCase):
    def test_cloud(self):
        points = support.sphere_points(1500)
        hand = Hand(self, vtkdgg.Mesh(points), is_cloud=True)
        scene = hand.scene
        graph = vtkdgg.CloudGraph(points)
        pixels = hand.middle(), hand.middle(40, 10)
        hand.press(pixels[0])
        self.assertIsInstance(scene.places[0], int)
        self.assertLess(np.linalg.norm(hand.pixel(points[scene.places[0]]) - pixels[0]), 6.0)
        np.testing.assert_allclose(scene.distances, graph.distance(scene.places[0]))
        hand.move(hand.middle(0, 20))
        hand.release(hand.middle(0, 20))
        np.testing.assert_allclose(scene.distances, graph.distance(scene.places[0]))
        self.assertIn("by graph: nothing is promised", hand.status())
        hand.click(pixels[1])
        path = graph.path(*scene.places)
        np.testing.assert_allclose(scene.path.points, path.points)
        for key, message in (
            ("e", "no exact distances"),
            ("g", "no Laplacian"),
            ("m", "by the graph only"),
            ("+", "no accuracy is promised"),
        ):
            hand.key(key)
            self.assertIn(message, hand.status())
        hand.key("v")
        _, nearest = graph.distance(scene.places, return_source=True)
        np.testing.assert_array_equal(scene.values, nearest)
        hand.key("v")
        hand.click(hand.middle(-40, -20))  # no loops on clouds
        self.assertEqual(len(scene.places), 1)
        hand.press((3, 3))
        hand.release((3, 3))
        self.assertEqual(len(scene.places), 1)


class Command(unittest.TestCase):
    def explore(self, *arguments):
        """Returns what the command prints; its window is closed immediately."""

        def start(window):
            window.scene.press(window._start)
            window.scene.held = None
            window.refresh()
            window.close()

        with mock.patch.object(explorer.Explorer, "start", start):
            result = support.call("explore", *arguments, "--json")
        self.assertEqual(result.returncode, 0, result.stderr)
        return json.loads(result.stdout)

    def test_command(self):
        found = self.explore(BUMPY)
        self.assertRegex(found["shown"][0], "642 points, distances by fast")
        self.assertEqual(found["written"], [])
        self.explore(BUMPY, "--source", 5, "--accuracy", 0.1, "--merge")
        if HAS_CLOUDS:
            found = self.explore(BUMPY, "--cloud", "--source", "1,0,0")
            self.assertRegex(found["shown"][0], "642 points, distances by graph: nothing")

    def test_mistakes(self):
        empty = os.path.join(support.output_folder("explorer"), "empty.vtp")
        vtkdgg.write(empty, vtkdgg.Mesh(np.empty((0, 3))))
        for arguments, pattern in (
            ((empty,), "contains no points"),
            (("missing.ply",), "no such file"),
            ((BUMPY, "--accuracy", "2"), "--accuracy is 2. Use a number from"),
            ((BUMPY, "--source", "642"), "point id 642 .* does not exist"),
            ((BUMPY,), "no display to open a window on"),
        ):
            with mock.patch.dict(os.environ):
                if arguments == (BUMPY,):
                    os.environ.pop("DISPLAY", None)
                result = support.call("explore", *arguments)
            self.assertEqual(result.returncode, 2)
            self.assertRegex(result.stderr, pattern)


if __name__ == "__main__":
    warnings.simplefilter("ignore", RuntimeWarning)  # warning about a missing path
    unittest.main()
