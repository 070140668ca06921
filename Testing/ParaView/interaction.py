# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Time of one step while a source is moved: distances, ten isolines, and rendering.

Usage: pvpython interaction.py MESH...    (with DGG_PLUGIN and DGG_TEST_OUTPUT in the environment)
"""

import sys
import time

import numpy as np
import support
from support import simple

STEPS = 12


def measure(mesh, make, **arguments):
    """Returns medians of a step in milliseconds: distances, isolines, and processor time of both.
    """
    mesh.UpdatePipeline()  # so that the source starts on the surface
    distance = make(Input=mesh, **arguments)
    places = support.points(mesh)
    largest = support.array(distance, "GeodesicDistance").max()
    lines = simple.GeodesicIsolines(Input=distance, Distances=list(largest * np.arange(1, 11) / 11))
    lines.UpdatePipeline()
    times = []
    for i in range(STEPS):
        place = places[(7919 * (i + 1)) % len(places)]
        distance.Source.Center = list(place)
        t = [time.perf_counter()]
        cpu = time.process_time()
        for proxy in (distance, lines):
            proxy.UpdatePipeline()
            t.append(time.perf_counter())
        times.append([1e3 * (t[1] - t[0]), 1e3 * (t[2] - t[1]), 1e3 * (time.process_time() - cpu)])
    return np.median(times, axis=0)


def main():
    print(f"{'':42}distance isolines      sum  processor, ms")
    for name in sys.argv[1:]:
        mesh = simple.OpenDataFile(name)
        count = len(support.points(mesh))
        ready = simple.GeodesicGraph(Input=mesh)
        for source, make, inside in (
            (ready, "GeodesicDistance", "GenerateVirtualSource"),
            (mesh, "InstantGeodesicDistance", "GenerateVirtualSource"),
            (mesh, "ExactGeodesicDistance", "GenerateWindows"),
        ):
            a, b, cpu = measure(source, getattr(simple, make), **{inside: 1})
            print(f"{make:27}{count:8} points {a:8.0f} {b:8.0f} {a + b:8.0f} {cpu:8.0f}")


if __name__ == "__main__":
    main()
