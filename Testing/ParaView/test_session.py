# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""A session: pictures, handles, ports, state files and traces."""

import numpy as np
import scenes
import support
from paraview import smstate, smtrace
from support import simple, unittest


def arrays(pipeline):
    """Returns the results of a session as arrays."""
    return {
        "distance": support.array(pipeline["distance"], "GeodesicDistance"),
        "lines": support.points(pipeline["lines"]),
        "path": support.points(pipeline["path"]),
        "cells": support.array(pipeline["cells"], "SiteId", 2, cells=True),
        "green": support.array(pipeline["green"], "GreensFunction"),
    }


def in_session():
    """Returns the pipeline that a state file or a script has created."""
    names = ("distance", "lines", "path", "cells", "green")
    return {name: simple.FindSource(name) for name in names}


def run(script):
    exec(compile(script, "script", "exec"), {})


class Session(unittest.TestCase):
    def setUp(self):
        simple.ResetSession()
        self.pipeline = scenes.build()
        self.found = arrays(self.pipeline)

    def tearDown(self):
        simple.ResetSession()  # open views cause an X error at the end

    def assert_same(self, other, names=None):
        for name in names or self.found:
            np.testing.assert_array_equal(other[name], self.found[name], err_msg=name)

    def test_pictures(self):
        for name, view in scenes.draw(self.pipeline).items():
            file = support.OUTPUT / f"ParaView{name}.png"
            simple.SaveScreenshot(str(file), view, ImageResolution=[320, 280])
            support.check_picture(self, file)

    def test_ports_have_names(self):
        cells = self.pipeline["cells"]
        kinds = {name: support.fetch(cells, i) for i, name in enumerate(
            ("Labels", "Borders", "Cells", "Sites"))}
        for i, name in enumerate(kinds):
            self.assertEqual(cells[name].Port, i)
        self.assertEqual(kinds["Sites"].GetNumberOfPoints(), 12)
        self.assertGreater(kinds["Borders"].GetNumberOfLines(), 12)

    def test_handle_moves(self):
        """Results after moving a source equal those of a new source at that position."""
        moved = [-0.2, 0.9, 0.4]
        distance = self.pipeline["distance"]
        distance.Source.Center = moved
        after = arrays(self.pipeline)
        self.assertGreater(np.abs(after["distance"] - self.found["distance"]).max(), 0.5)
        fresh = simple.GeodesicDistance(Input=distance.Input, GenerateVirtualSource=1)
        fresh.Source.Center = moved
        np.testing.assert_array_equal(support.array(fresh, "GeodesicDistance"), after["distance"])
        self.assert_same(after, ["path", "cells", "green"])
        distance.Source.Center = scenes.SOURCE
        self.assert_same(arrays(self.pipeline))

    def test_handles_start_on_the_data(self):
        mesh = support.bumpy()
        mesh.UpdatePipeline()
        low, high = np.reshape(mesh.GetDataInformation().GetBounds(), (3, 2)).T
        distance = simple.GeodesicDistance(Input=mesh)
        # In the middle of the top, where it is visible.
        np.testing.assert_allclose(distance.Source.Center[:2], (low + high)[:2] / 2)
        np.testing.assert_allclose(distance.Source.Center[2], high[2])
        self.assertEqual(simple.GeodesicSampler(Input=mesh).CoveringRadius, 0.0)
        path = simple.GeodesicPath(Input=mesh)
        np.testing.assert_allclose(path.Ends.StartPoint, low)
        np.testing.assert_allclose(path.Ends.EndPoint, high)
        simple.GeodesicLoop(Input=mesh, Points="Several points").UpdatePipeline()

    def test_points_of_the_pipeline_are_sources(self):
        graph, samples = self.pipeline["distance"].Input, self.pipeline["samples"]
        direct = simple.GeodesicDistance(Input=graph, Source=samples)
        chosen = simple.GeodesicDistance(Input=graph, Source="Points of the pipeline")
        chosen.Source.Input = samples
        found = support.array(chosen, "GeodesicDistance")
        np.testing.assert_array_equal(found, support.array(direct, "GeodesicDistance"))
        sites = support.array(self.pipeline["cells"], "GeodesicDistance")
        np.testing.assert_allclose(found, sites, rtol=0.02)

    def test_sites_and_places_have_handles(self):
        """Handles of sites and probe points give the results of points of the pipeline."""
        graph = self.pipeline["distance"].Input
        points = [*scenes.SOURCE, -0.9, 0.2, 0.5, 0.1, 0.9, -0.4]
        line = simple.PolyLineSource(Points=points)
        cells = simple.GeodesicVoronoiCells(Input=graph)
        self.assertEqual(support.fetch(cells, 3).GetNumberOfPoints(), 2)
        cells.Sites.Points = points
        same = simple.GeodesicVoronoiCells(Input=graph, Sites="Points of the pipeline")
        same.Sites.Input = line
        found = support.array(cells, "SiteId", 2, cells=True)
        self.assertEqual(set(found), {0, 1, 2})
        np.testing.assert_array_equal(found, support.array(same, "SiteId", 2, cells=True))
        alone = simple.GeodesicVoronoiCells(Input=graph, Sites="Point")
        alone.Sites.Center = scenes.SOURCE
        self.assertEqual(set(support.array(alone, "SiteId", 2, cells=True)), {0})
        probe = simple.GeodesicProbe(Input=self.pipeline["distance"])
        probe.Places.Center = scenes.SOURCE
        self.assertLess(support.array(probe, "GeodesicDistance")[0], 1e-6)

    def test_isolines_of_what_is_chosen(self):
        """The default is one isoline at half the range; values out of range are reported once."""
        distance = simple.Calculator(
            Input=self.pipeline["distance"], ResultArrayName="Twice", Function="2*GeodesicDistance")
        distance.UpdatePipeline()
        lines = simple.GeodesicIsolines(Input=distance)
        self.assertEqual(list(lines.ContourBy), ["POINTS", "GeodesicDistance"])
        low, high = np.nanmin(self.found["distance"]), np.nanmax(self.found["distance"])
        np.testing.assert_allclose(lines.Distances, [(low + high) / 2])
        self.assertGreater(support.fetch(lines).GetNumberOfLines(), 0)
        listener = support.Listener(lines)
        lines.Distances = [1.5 * high]
        self.assertEqual(support.fetch(lines).GetNumberOfLines(), 0)
        lines.Distances = []
        self.assertEqual(support.fetch(lines).GetNumberOfLines(), 0)
        self.assertEqual(len(listener.warnings), 1)
        self.assertIn(f"to {high:.6g}", listener.warnings[0])
        lines.Method = "Linear"  # of an array without distances
        lines.ContourBy = ["POINTS", "Twice"]
        lines.Distances = [1.5 * high]
        self.assertGreater(support.fetch(lines).GetNumberOfLines(), 0)
        self.assertEqual(len(listener.warnings), 1)

    def test_an_error_is_told_once(self):
        """An error is reported once, whatever the number of outputs; filters that depend on it are
        empty."""
        graph = simple.GeodesicGraph(Input=support.bumpy(), Accuracy=0.9)
        distance = simple.GeodesicDistance(Input=graph)
        cells = simple.GeodesicVoronoiCells(Input=graph)
        lines = simple.GeodesicIsolines(Input=distance)
        later = (distance, cells, lines)
        listener, others = support.Listener(graph), support.Listener(*later)
        view = scenes.make_view()
        for port in (*later, cells["Cells"], lines["Bands"]):
            simple.Show(port, view)
        simple.Render(view)
        self.assertEqual(len(listener.errors), 1, listener.errors)
        self.assertIn("Accuracy is 0.9", listener.errors[0])
        self.assertEqual(others.errors, [])
        graph.Accuracy = 0.8
        simple.Render(view)
        self.assertEqual(len(listener.errors), 2, listener.errors)
        graph.Accuracy = 0.1
        simple.Render(view)
        self.assertEqual(len(listener.errors), 2, listener.errors)
        self.assertEqual(others.errors, [])
        self.assertGreater(support.fetch(cells, 2).GetNumberOfCells(), 0)

    @unittest.skipUnless(support.IS_COMPILED, "Python filters accept one surface")
    def test_blocks(self):
        """A source belongs to the nearest block; an empty one between them changes nothing."""
        first = support.bumpy()
        moved = simple.Transform(Input=first)
        moved.Transform.Translate = [5.0, 0.0, 0.0]
        nothing = simple.Clip(Input=first, Invert=0)
        nothing.ClipType.Origin = [100.0, 0.0, 0.0]
        empty = simple.ExtractSurface(Input=nothing)
        blocks = simple.GroupDatasets(Input=[first, empty, moved])
        place = [5.0 + scenes.SOURCE[0], *scenes.SOURCE[1:]]
        alone = simple.GeodesicDistance(Input=moved)
        together = simple.GeodesicDistance(Input=simple.GeodesicGraph(Input=blocks))
        alone.Source.Center = together.Source.Center = place
        output = support.fetch(together)
        values = [
            support.vtk_to_numpy(output.GetBlock(i).GetPointData().GetArray("GeodesicDistance"))
            for i in (0, 2)
        ]
        self.assertEqual(output.GetBlock(1).GetNumberOfPoints(), 0)
        self.assertTrue(np.isnan(values[0]).all() or np.isinf(values[0]).all())
        np.testing.assert_allclose(
            values[1], support.array(alone, "GeodesicDistance"), rtol=1e-12)

    def test_state_files(self):
        scenes.draw(self.pipeline)
        name = str(support.OUTPUT / "session.pvsm")
        simple.SaveState(name)
        script = smstate.get_state()
        for load in (lambda: simple.LoadState(name), lambda: run(script)):
            simple.ResetSession()
            load()
            self.assert_same(arrays(in_session()))

    def test_trace_replays(self):
        simple.ResetSession()
        smtrace.start_trace()
        scenes.draw(scenes.build())
        script = smtrace.stop_trace()
        self.assertIn("GeodesicIsolines(", script)
        simple.ResetSession()
        run(script)
        self.assert_same(arrays(in_session()))


if __name__ == "__main__":
    support.main()
