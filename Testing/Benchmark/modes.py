# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Library of the modes that measure the Python module: command line, meshes, clocks.

VTK is imported by the functions that use it, since the mode peers runs without VTK."""

import argparse
import ctypes
import json
import os
import sys
import time

import numpy as np
import vtkdgg
from exhibits import surfaces

BUNNY = "/usr/share/glmark2/models/bunny.obj"
ROUNDS = 5
ENOUGH_SECONDS = 1.0


def values_of(kind):
    """Returns a parser of comma-separated values."""
    return lambda text: tuple(kind(word) for word in text.split(",") if word)


def parse(usage, arguments=None, **defaults):
    """Returns the options OUT.json OUT.md [--name=value ...] [MESH ...]. The default of an option
    determines its type."""
    formatter = argparse.RawDescriptionHelpFormatter
    parser = argparse.ArgumentParser(description=usage, formatter_class=formatter)
    parser.add_argument("json")
    parser.add_argument("table")
    parser.add_argument("meshes", nargs="*")
    for name, default in defaults.items():
        kind = type(default)
        if kind is tuple:
            kind = values_of(type(default[0]) if default else str)
        parser.add_argument(f"--{name}", type=kind, default=default)
    return parser.parse_intermixed_args(arguments)


def write(options, results, text):
    """Writes the results and their tables, and prints the tables."""
    with open(options.json, "w", encoding="utf-8") as file:
        json.dump(results, file, indent=1)
    with open(options.table, "w", encoding="utf-8") as file:
        file.write(text)
    print(text)


def run(measure, tables, options):
    """Measures on one thread, and writes what was measured."""
    from vtkmodules.vtkCommonCore import vtkSMPTools

    vtkSMPTools.Initialize(1)
    vtkdgg._kernel.set_number_of_threads(1)
    results = measure(options)
    write(options, results, tables(results))


def open_mesh(name):
    """Returns the title and the surface of a file, or of the name of a generated surface, with
    double precision."""
    mesh = surfaces.make(name)
    if mesh is not None:
        return name, mesh
    from vtkdgg.vtk_data import triangulated

    mesh = triangulated(vtkdgg.read(name).as_polydata(), name)
    title = os.path.splitext(os.path.basename(name))[0]
    return title, surfaces.from_arrays(*surfaces.arrays_of(mesh))


def open_arrays(name):
    """Returns the title, points and triangles of a file or of a generated surface."""
    arrays = surfaces.make_arrays(name)
    if arrays is None:
        mesh = vtkdgg.read(name)
        if mesh.triangles is None:
            sys.exit(f"error: {name}: some polygons have more than three corners")
        name, arrays = os.path.splitext(os.path.basename(name))[0], (mesh.points, mesh.triangles)
    return name, np.ascontiguousarray(arrays[0]), np.ascontiguousarray(arrays[1])


def maker(kind, **properties):
    """Returns a function that makes a filter with these properties."""
    from vtkdgg.vtk_data import configured

    return lambda: configured(kind(), **properties)


def default_meshes(*generated):
    """Returns the names of generated surfaces, and the bunny where it is installed."""
    return [*generated, *filter(os.path.isfile, [BUNNY])]


def _updated(algorithm, mesh):
    algorithm.SetInputData(mesh)
    return vtkdgg.check(algorithm)


def _used_points(mesh):
    """Returns the surface without points that belong to no face."""
    from vtkmodules.vtkFiltersCore import vtkCleanPolyData

    clean = vtkCleanPolyData()
    clean.PointMergingOff()
    return _updated(clean, mesh)


def decimated(mesh, vertices):
    """Returns a surface with about this number of vertices."""
    from vtkmodules.vtkFiltersCore import vtkQuadricDecimation

    decimation = vtkQuadricDecimation()
    decimation.SetTargetReduction(1.0 - vertices / mesh.GetNumberOfPoints())
    decimation.VolumePreservationOn()
    return _used_points(_updated(decimation, mesh))


def subdivided(mesh):
    """Returns the surface after a step of Loop subdivision."""
    from vtkmodules.vtkFiltersModeling import vtkLoopSubdivisionFilter

    subdivision = vtkLoopSubdivisionFilter()
    subdivision.SetNumberOfSubdivisions(1)
    return _updated(subdivision, _used_points(mesh))


def timed(function, clock=time.process_time):
    """Returns the time of a call, and its result."""
    start = clock()
    result = function()
    return clock() - start, result


def fastest(function, clock=time.process_time):
    """Returns the shortest time of several calls, and the last result. Other processes disturb only
    some of the calls."""
    times = []
    while len(times) < ROUNDS and sum(times) < ENOUGH_SECONDS:
        seconds, result = timed(function, clock)
        times.append(seconds)
    return min(times), result


class ResidentPeak:
    """Largest growth of the resident set since construction, in bytes; 0 where the system does not
    report it."""

    def __init__(self):
        if hasattr(ctypes.CDLL(None), "malloc_trim"):
            # Free blocks that the allocator keeps would hide growth.
            ctypes.CDLL(None).malloc_trim(0)
        try:
            with open("/proc/self/clear_refs", "w", encoding="ascii") as file:
                file.write("5")  # resets the peak
        except OSError:
            pass
        self.before = self._read("VmRSS")

    def growth(self):
        return max(0, self._read("VmHWM") - self.before)

    @staticmethod
    def _read(key):
        try:
            with open("/proc/self/status", encoding="ascii") as file:
                found = dict(line.split(":", 1) for line in file)
        except OSError:
            return 0
        return 1024 * int(found[key].split()[0])
