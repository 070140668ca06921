# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Updates that are observed, aborted, overtaken by changes, and closed while they run."""

import os
import pathlib
import random
import shutil
import signal
import socket
import subprocess
import sys
import time

import numpy as np
import support
from paraview import servermanager as sm
from support import simple, unittest

# Filters that may take more than a second on a surface of 41,000 points, and their properties.
LONG = {
    "GeodesicGraph": {"Accuracy": 0.001},
    "GeodesicDistance": {"Accuracy": 0.001},
    "ExactGeodesicDistance": {},
    "GeodesicSampler": {"NumberOfSamples": 3000},
    "GeodesicVoronoiCells": {"Centroidal": 1},
    "GreensFunction": {},
    "BiharmonicDistance": {},
    "HeatGeodesicDistance": {},
    "HarmonicBSpline": {},
}


def large():
    """Returns an uneven surface of 41,000 points."""
    mesh = support.bumpy()
    fine = simple.LoopSubdivision(Input=mesh, NumberofSubdivisions=3)
    fine.UpdatePipeline()
    return fine


class Watch:
    """Observes the updates of a filter, and aborts them at the first progress on request. With
    several outputs there are several updates, since ParaView requests each output and an aborted
    one is missing."""

    def __init__(self, proxy, stops=False, then=None):
        self.filter = proxy.SMProxy.GetClientSideObject()
        self.stops, self.then = stops, then
        self.seen = []
        self.stopped = None
        self.tag = self.filter.AddObserver("ProgressEvent", self.look)

    def look(self, *_):
        self.seen.append(self.filter.GetProgress())
        if self.stops and self.seen[-1] > 0:
            self.filter.SetAbortExecute(1)
            if self.stopped is None:
                self.stopped = time.monotonic()
                if self.then:
                    self.then()

    def close(self):
        self.filter.RemoveObserver(self.tag)


class Updates(unittest.TestCase):
    def setUp(self):
        simple.ResetSession()

    def test_progress_and_abort(self):
        """ParaView's progress bar receives progress, and an abort takes effect immediately."""
        mesh = large()
        handler = sm.ActiveConnection.Session.GetProgressHandler()
        interval = handler.GetProgressInterval()
        handler.SetProgressInterval(0.01)  # 0.1 s is half of the time of a fast machine
        bar = []
        tag = handler.AddObserver("ProgressEvent", lambda *_: bar.append(handler.GetLastProgress()))
        for name, arguments in LONG.items():
            with self.subTest(name):
                if name == "GeodesicVoronoiCells":
                    arguments["Sites"] = simple.PointSource(NumberOfPoints=9, Radius=0.9)
                proxy = getattr(simple, name)(Input=mesh, **arguments)
                proxy.SMProxy.UpdateVTKObjects()
                watch = Watch(proxy, stops=True)
                proxy.UpdatePipeline()
                ended = time.monotonic()
                self.assertIsNotNone(watch.stopped)
                # Limit while other tests run; it is 0.2 s for a single test.
                self.assertLess(ended - watch.stopped, 1.0)
                self.assertEqual(support.fetch(proxy).GetNumberOfElements(0), 0)
                watch.close()
                simple.Delete(proxy)
        del bar[:]
        proxy = simple.ExactGeodesicDistance(Input=mesh)
        watch = Watch(proxy)
        proxy.UpdatePipeline()
        self.assertGreater(len(set(watch.seen)), 5)
        self.assertEqual(watch.seen, sorted(watch.seen))
        self.assertGreater(len(set(bar)), 2)
        handler.RemoveObserver(tag)
        handler.SetProgressInterval(interval)

    def test_changes_that_overtake_each_other(self):
        """The next change aborts each update; the last result equals that of a first update."""
        mesh = large()
        distance = simple.GeodesicDistance(Input=mesh, Accuracy=0.1)
        lines = simple.GeodesicIsolines(Input=distance, Distances=[0.3, 0.6, 0.9])
        chance = random.Random(7)
        aborted = 0
        for _ in range(15):
            distance.Source.Center = [chance.uniform(-1, 1) for _ in range(3)]
            distance.Accuracy = chance.choice([0.05, 0.1, 0.2])
            lines.Distances = sorted(chance.uniform(0.1, 2.0) for _ in range(5))
            watch = Watch(chance.choice([distance, lines]), stops=True)
            lines.UpdatePipeline()
            aborted += watch.stopped is not None
            watch.close()
        self.assertGreater(aborted, 5)
        distance.Source.Center = [0.5, 0.5, 0.5]
        fresh = simple.GeodesicDistance(Input=mesh, Accuracy=distance.Accuracy)
        fresh.Source.Center = distance.Source.Center
        fresh_lines = simple.GeodesicIsolines(Input=fresh, Distances=lines.Distances)
        lines.UpdatePipeline()
        np.testing.assert_array_equal(
            support.array(distance, "GeodesicDistance"), support.array(fresh, "GeodesicDistance")
        )
        np.testing.assert_array_equal(support.points(lines), support.points(fresh_lines))

    def test_closing_while_it_runs(self):
        """The observer of an update deletes all proxies, including sources."""
        mesh = large()
        for name in ("ExactGeodesicDistance", "GeodesicGraph", "BiharmonicDistance"):
            proxy = getattr(simple, name)(Input=mesh)
            kept = proxy.SMProxy.GetClientSideObject()
            watch = Watch(proxy, stops=True, then=lambda p=proxy: simple.Delete(p))
            kept.Update()
            self.assertIsNotNone(watch.stopped, name)
            watch.close()
            self.assertIsNone(simple.FindSource(proxy.SMProxy.GetXMLName()))
            del proxy, kept, watch
        simple.Delete(mesh)
        simple.ResetSession()
        again = simple.ExactGeodesicDistance(Input=support.bumpy())
        self.assertGreater(support.array(again, "GeodesicDistance").max(), 2.0)


class Server(unittest.TestCase):
    """A server that its client leaves while it computes."""

    CLIENT = """
import os
import sys
sys.path.insert(0, {folder!r})
from paraview import simple
simple.Connect("127.0.0.1", {port})
simple.LoadPlugin({plugin!r}, remote=True, ns=vars(simple))
simple.LoadPlugin({plugin!r}, remote=False, ns=vars(simple))
mesh = simple.PLYReader(FileNames=[{mesh!r}])
fine = simple.LoopSubdivision(Input=mesh, NumberofSubdivisions=3)
fine.UpdatePipeline()
os.write(1, b"ready\\n")  # unbuffered, unlike print() in pvpython
graph = simple.GeodesicGraph(Input=fine, Accuracy={accuracy})
graph.UpdatePipeline()
print(graph.GetDataInformation().GetNumberOfPoints(), flush=True)
"""

    def run_client(self, accuracy):
        with socket.socket() as probe:
            probe.bind(("127.0.0.1", 0))
            port = probe.getsockname()[1]
        folder = pathlib.Path(shutil.which("pvserver") or "").parent
        server = subprocess.Popen(
            [str(folder / "pvserver"), f"--server-port={port}"],
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
        )
        self.addCleanup(server.kill)
        for line in server.stdout:
            if "Accepting" in line:
                break
        client = subprocess.Popen(
            [
                "pvpython",
                "-c",
                self.CLIENT.format(
                    folder=os.path.dirname(__file__),
                    port=port,
                    plugin=support.PLUGIN,
                    mesh=str(support.DATA / "bumpy.ply"),
                    accuracy=accuracy,
                ),
            ],
            stdout=subprocess.PIPE,
            text=True,
        )
        self.addCleanup(client.kill)
        return server, client

    def test_of_a_server(self):
        server, client = self.run_client(0.05)
        out, _ = client.communicate(timeout=120)
        self.assertIn("40", out)
        self.assertEqual(client.returncode, 0)
        server.communicate(timeout=60)
        self.assertEqual(server.returncode, 0)

    def test_that_its_client_leaves(self):
        server, client = self.run_client(0.0005)
        for line in client.stdout:
            if line.startswith("ready"):
                break
        time.sleep(1.0)
        self.assertIsNone(client.poll(), "it is done already")
        client.send_signal(signal.SIGKILL)
        server.communicate(timeout=120)
        self.assertGreaterEqual(server.returncode, 0, "ended by a signal")


if __name__ == "__main__":
    support.main()
