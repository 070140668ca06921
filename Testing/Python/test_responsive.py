# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Long updates: other threads continue, and Ctrl-C stops filters, which can be used again."""

import os
import signal
import threading
import time
import unittest

import numpy as np
import support
import vtkdgg
from vtkmodules.vtkFiltersCore import vtkTriangleFilter

# Longest pause, seconds. Pauses are far shorter on an idle machine; tests run beside others.
PATIENCE = 1.0


def terrain(size):
    """Returns points and triangles of hills."""
    points, triangles = support.grid(size, size)
    points[:, 2] = 3.0 * np.sin(points[:, 0] / 5.0) * np.cos(points[:, 1] / 7.0)
    return points, triangles


POINTS, TRIANGLES = terrain(180)
SURFACE = support.polydata(POINTS, TRIANGLES)
SMALL = support.polydata(*terrain(60))


def made(kind, surface=SURFACE, **properties):
    """Returns a filter of the surface with these properties."""
    return support.make(kind, surface, **properties)


def isolines():
    """Returns a filter of isolines of exact distances."""
    search = made("vtkExactGeodesicDistance", SourceIds=[5], GenerateWindows=True)
    contour = made("vtkApolloniusIsolines", vtkdgg.check(search))
    contour.GenerateValues(100, 0.0, 200.0)
    return contour


WORK = {
    "graph": lambda: made("vtkDiscreteGeodesicGraph"),
    "exact": lambda: made("vtkExactGeodesicDistance", SourceIds=[5]),
    "heat": lambda: made("vtkHeatGeodesicDistance", SourceIds=[5]),
    "Green's function": lambda: made("vtkDiscreteGreensFunction", SourceIds=[5]),
    "sampler": lambda: made("vtkGeodesicSampler", SMALL, NumberOfSamples=400),
    "matrix": lambda: made(
        "vtkGeodesicDistanceMatrix", RowIds=list(range(64)), ColumnIds=list(range(500))
    ),
    "isolines": isolines,
}


class Heartbeat(threading.Thread):
    """A thread that records the times at which it runs."""

    def __init__(self):
        super().__init__()
        self.beats = []
        self._is_done = threading.Event()

    def run(self):
        while not self._is_done.wait(0.005):
            self.beats.append(time.monotonic())

    def __enter__(self):
        self.start()
        while not self.beats:
            time.sleep(0.001)
        return self

    def __exit__(self, *_):
        self._is_done.set()
        self.join()


class OtherThreads(unittest.TestCase):
    def test_they_continue(self):
        for name, make in WORK.items():
            with self.subTest(name), Heartbeat() as heart:
                algorithm = make()
                start = time.monotonic()
                vtkdgg.check(algorithm)
                end = time.monotonic()
                within = [start] + [beat for beat in heart.beats if start < beat < end] + [end]
                self.assertGreater(len(within), 5, f"{end - start:.2f} s")
                self.assertLess(max(np.diff(within)), PATIENCE)

    def test_they_may_change_the_arguments(self):
        """The arrays of the arguments are overwritten during the update."""
        points, triangles = terrain(150)
        expected = vtkdgg.distance(points, triangles, 7)
        mesh = support.polydata(points, triangles)
        view = support.vtk_to_numpy(mesh.GetPoints().GetData())
        for given, array in (((points, triangles), points), ((mesh,), view)):
            began = threading.Event()
            keep = array.copy()

            def scribble(array=array, began=began):
                began.wait()
                array[:] = np.nan

            scribbler = threading.Thread(target=scribble)
            scribbler.start()

            def call(*arguments, began=began, scribbler=scribbler, **options):
                began.set()
                scribbler.join()
                return original(*arguments, **options)

            original, vtkdgg.distances.call = vtkdgg.distances.call, call
            try:
                np.testing.assert_array_equal(vtkdgg.distance(*given, 7), expected)
            finally:
                vtkdgg.distances.call = original
            array[:] = keep

    def test_several_updates_at_once(self):
        """Each update waits while another one runs, in any function."""
        points, triangles = terrain(60)
        graph = vtkdgg.Graph(points, triangles, accuracy=0.05)
        work = [
            lambda: graph.distance(7),
            lambda: graph.matrix(np.arange(0, 3721, 40)),
            lambda: graph.path(7, 3700).points,
            lambda: vtkdgg.distance(points, triangles, [7, 3000]),
            lambda: vtkdgg.Graph(points, triangles, accuracy=0.02).distance([1.5, 2.0, 0.5]),
            lambda: vtkdgg.greens_function(points, triangles, 7),
        ]
        expected = [task() for task in work]
        found = [[] for _ in work]

        def repeat(i):
            for _ in range(3):
                found[i].append(work[i]())

        threads = [threading.Thread(target=repeat, args=(i,)) for i in range(len(work))]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for answers, answer in zip(found, expected):
            self.assertEqual(len(answers), 3)
            for other in answers:
                np.testing.assert_array_equal(other, answer)


class Interrupted(unittest.TestCase):
    def interrupt(self, work, seconds):
        """Interrupts work by Ctrl-C after some seconds. Returns the seconds until it stops."""
        late = []

        def press():
            time.sleep(seconds)
            late.append(time.monotonic())
            os.kill(os.getpid(), signal.SIGINT)

        finger = threading.Thread(target=press)
        finger.start()
        with self.assertRaises(KeyboardInterrupt):
            try:
                work()
            finally:
                late.append(time.monotonic())
                finger.join()
        return late[1] - late[0]

    def test_stops_and_can_be_used_again(self):
        for name, make in WORK.items():
            with self.subTest(name):
                first = make()
                start = time.monotonic()
                expected = vtkdgg.check(first)
                seconds = time.monotonic() - start
                again = make()
                late = self.interrupt(lambda: vtkdgg.check(again), 0.3 * seconds)
                self.assertLess(late, PATIENCE)
                self.assertEqual(signal.getsignal(signal.SIGINT), signal.default_int_handler)
                output = vtkdgg.check(again)
                found, expected = ([data.GetNumberOfElements(kind) for kind in range(7)]
                                   for data in (output, expected))  # fmt: skip
                self.assertEqual(found, expected)

    def test_filters_of_others(self):
        """The incomplete output of an interrupted filter is not used."""
        chain = made(vtkTriangleFilter)
        distance = made("vtkExactGeodesicDistance", chain, SourceIds=[5])
        tag = chain.AddObserver("ProgressEvent", lambda *_: os.kill(os.getpid(), signal.SIGINT))
        with self.assertRaises(KeyboardInterrupt):
            vtkdgg.check(distance)
        chain.RemoveObserver(tag)
        found = support.distances_of(distance)
        np.testing.assert_array_equal(found, vtkdgg.distance(SURFACE, 5))

    def test_any_handler(self):
        """Handlers of the user are called, and their exceptions are raised."""

        class TimeOut(Exception):
            pass

        def give_up(number, frame):
            raise TimeOut

        calls = []
        for handler, raised in ((give_up, TimeOut), (lambda *_: calls.append(1), None)):
            before = signal.signal(signal.SIGALRM, handler)
            try:
                signal.setitimer(signal.ITIMER_REAL, 0.1)
                algorithm = made("vtkHeatGeodesicDistance", SourceIds=[5])
                if raised:
                    with self.assertRaises(raised):
                        vtkdgg.check(algorithm)
                else:
                    self.assertGreater(vtkdgg.check(algorithm).GetNumberOfPoints(), 0)
                self.assertIs(signal.getsignal(signal.SIGALRM), handler)
            finally:
                signal.signal(signal.SIGALRM, before)
        self.assertEqual(calls, [1])

    def test_end_of_the_program(self):
        result = support.python(
            "import os, signal, threading\n"
            "import test_responsive as t, vtkdgg\n"
            "threading.Timer(0.2, os.kill, (os.getpid(), signal.SIGINT)).start()\n"
            "vtkdgg.Graph(t.POINTS, t.TRIANGLES, accuracy=0.001)\n"
        )
        self.assertEqual(result.returncode, -signal.SIGINT, result.stderr)
        self.assertTrue(result.stderr.rstrip().endswith("KeyboardInterrupt"), result.stderr)


class Bar(unittest.TestCase):
    """Texts about the progress."""

    def shown(self, is_terminal, modules="", on=True, seconds=0.0):
        """Returns the standard error of a graph that is built in a process of its own."""
        script = (
            "import io, sys, types\n"
            "class Terminal(io.StringIO):\n"
            f"    isatty = lambda self: {is_terminal}\n"
            "real, sys.stderr = sys.stderr, Terminal()\n"
            "sys.modules['tqdm'] = None\n"
            f"{modules}\n"
            "import test_responsive as t, vtkdgg\n"
            f"vtkdgg.show_progress({on})\n"
            f"vtkdgg.progress._PATIENCE = {seconds}\n"
            "vtkdgg.progress._PAUSE = 0.0\n"
            "vtkdgg.Graph(*t.terrain(60), accuracy=0.05)\n"
            "real.write(sys.stderr.getvalue())\n"
        )
        # Not as text, which would replace \r.
        return support.python(script, text=False).stderr.decode()

    def test_terminal(self):
        self.assertRegex(self.shown(True), r"\A((\r\w+: +\d+ %)+\r\x1b\[K)+\Z")
        self.assertEqual(self.shown(False), "")
        self.assertEqual(self.shown(True, on=False), "")
        self.assertEqual(self.shown(True, seconds=1000.0), "")

    def test_tqdm(self):
        stand_in = (
            "class Tqdm:\n"
            "    desc, n = '', 0\n"
            "    def __init__(self, total, leave, bar_format): sys.stderr.write(f'of {total}\\n')\n"
            "    def refresh(self): sys.stderr.write(f'{self.desc} {self.n:.0f}\\n')\n"
            "    def close(self): sys.stderr.write('closed\\n')\n"
            "sys.modules['tqdm'] = types.ModuleType('tqdm')\n"
            "sys.modules['tqdm.auto'] = types.SimpleNamespace(tqdm=Tqdm)\n"
        )
        for is_terminal, modules in ((True, ""), (False, "sys.modules['ipykernel'] = sys\n")):
            text = self.shown(is_terminal, stand_in + modules)
            self.assertRegex(text, r"\A(of 100\n(\w+ \d+\n)+closed\n)+\Z")


if __name__ == "__main__":
    unittest.main()
