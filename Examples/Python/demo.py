# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Exact geodesic distance on a mesh file: a table, distance.vtp and distance.png."""

import argparse
import math
import os
import sys
import time
import warnings

import demo_bounds
import demo_picture
import numpy as np
import vtkdgg
from mesh_file import READERS, MeshFileError, read_triangles
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import reference, vtkIdTypeArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData, vtkStaticCellLocator
from vtkmodules.vtkFiltersCore import vtkPolyDataConnectivityFilter
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

DEFAULT_MESH = "/usr/share/glmark2/models/bunny.obj"


class UsageError(Exception):
    """A wrong argument; the text says which."""


class Parser(argparse.ArgumentParser):
    """Reports errors as the rest of the program does: one line, exit code 2."""

    def error(self, message):
        raise UsageError(f"{message} (--help explains)")


def parse(arguments):
    """Command line to options."""
    parser = Parser(prog="demo.sh", description=__doc__)
    parser.add_argument(
        "mesh",
        nargs="?",
        default=DEFAULT_MESH,
        help=f"{' '.join(sorted(READERS))} (default: %(default)s)",
    )
    parser.add_argument(
        "--source",
        metavar="ID|X,Y,Z",
        help="where distances start: a point id, or coordinates on the surface "
        "(default: the point farthest from the centre of the mesh)",
    )
    parser.add_argument(
        "--merge",
        action="store_true",
        help="treat points with equal coordinates as one (texture seams)",
    )
    parser.add_argument(
        "--out", metavar="DIR", default="out", help="folder of the results (default: ./%(default)s)"
    )
    # argparse would take coordinates that start with a minus sign for an option.
    joined = []
    for argument in arguments:
        if joined and joined[-1] == "--source":
            joined[-1] = f"--source={argument}"
        else:
            joined.append(argument)
    return parser.parse_args(joined)


def parse_source(text, mesh):
    """A point id (int) or coordinates (list of 3 floats)."""
    if text is None:
        return default_source(mesh)
    try:
        if "," not in text:
            source = int(text)
        else:
            source = [float(word) for word in text.split(",")]
            if len(source) != 3 or not all(math.isfinite(x) for x in source):
                raise ValueError
    except ValueError:
        raise UsageError(f"--source {text}: neither a point id nor X,Y,Z") from None
    count = mesh.GetNumberOfPoints()
    if isinstance(source, int) and not 0 <= source < count:
        raise UsageError(f"--source {source}: the mesh has points 0 to {count - 1}")
    return source


def default_source(mesh):
    """The point of the largest piece that is farthest from the centre: an ear, a foot, a nose."""
    ids = vtkIdTypeArray()
    ids.SetName("Id")
    ids.SetNumberOfValues(mesh.GetNumberOfPoints())
    vtk_to_numpy(ids)[:] = np.arange(mesh.GetNumberOfPoints())
    numbered = vtkPolyData()
    numbered.SetPoints(mesh.GetPoints())
    numbered.SetPolys(mesh.GetPolys())
    numbered.GetPointData().AddArray(ids)
    largest = vtkPolyDataConnectivityFilter()
    largest.SetInputData(numbered)
    largest.SetExtractionModeToLargestRegion()
    piece = vtkdgg.check(largest)

    used = np.unique(vtk_to_numpy(piece.GetPolys().GetConnectivityArray()))
    used = vtk_to_numpy(piece.GetPointData().GetArray("Id"))[used]
    points = vtk_to_numpy(mesh.GetPoints().GetData()).astype(float)[used]
    offset = points - np.array(mesh.GetCenter())
    return int(used[np.argmax((offset * offset).sum(axis=1))])


def source_location(mesh, source):
    """Where the source is on the surface, and the corners of the triangle that holds it."""
    if isinstance(source, int):
        return np.array(mesh.GetPoint(source)), [source]
    locator = vtkStaticCellLocator()
    locator.SetDataSet(mesh)
    locator.BuildLocator()
    closest = [0.0, 0.0, 0.0]
    cell, sub, squared = reference(0), reference(0), reference(0.0)
    locator.FindClosestPoint(source, closest, cell, sub, squared)
    ids = mesh.GetCell(cell.get()).GetPointIds()
    return np.array(closest), [ids.GetId(i) for i in range(ids.GetNumberOfIds())]


def make_filter(mesh, source, merge):
    """The distance filter, ready to update."""
    distance = vtkdgg.vtkExactGeodesicDistance()
    distance.SetInputData(mesh)
    distance.SetMergeCoincidentPoints(merge)
    if isinstance(source, int):
        distance.AddSourceId(source)
    else:
        points = vtkPoints()
        points.SetDataTypeToDouble()
        points.InsertNextPoint(source)
        place = vtkPolyData()
        place.SetPoints(points)
        distance.SetInputData(1, place)
    return distance


def defects(distance):
    """One line on what is wrong with the mesh."""
    counts = (
        (distance.GetNumberOfNonManifoldEdges(), "non-manifold edges"),
        (distance.GetNumberOfNonManifoldVertices(), "non-manifold vertices"),
        (distance.GetNumberOfDroppedFaces(), "faces with repeated points"),
        (distance.GetNumberOfDegenerateFaces(), "triangles without area"),
        (distance.GetNumberOfDuplicateFaces(), "duplicate triangles"),
        (distance.GetNumberOfCoincidentPoints(), "coincident points"),
        (distance.GetNumberOfIsolatedPoints(), "isolated points"),
    )
    found = [f"{count} {what}" for count, what in counts if count]
    if not distance.GetOrientable():
        found.append("no consistent orientation")
    return ", ".join(found) or "none"


def topology(distance):
    """One line on components, boundary and genus."""
    genus = distance.GetGenus()
    return (
        f"components {distance.GetNumberOfComponents()}, "
        f"boundary loops {distance.GetNumberOfBoundaryLoops()}, "
        + (f"genus {genus}" if genus >= 0 else "no genus")
    )


def bound_line(bound, name):
    """One line on the agreement with a bound."""
    return (
        f"{bound['violations']} violations at {bound['points']} points, "
        f"mean distance / {name} = {bound['ratio']:.4f}"
    )


def main(arguments):
    """Run the demo; returns the exit code."""
    options = parse(arguments)
    start = time.perf_counter()
    mesh = read_triangles(options.mesh)
    source = parse_source(options.source, mesh)
    read_time = time.perf_counter() - start
    location, corners = source_location(mesh, source)

    distance = make_filter(mesh, source, options.merge)
    start = time.perf_counter()
    with warnings.catch_warnings(record=True) as notes:
        warnings.simplefilter("always")
        output = vtkdgg.check(distance)
    time_taken = time.perf_counter() - start

    name = distance.GetDistanceArrayName()
    distances = vtk_to_numpy(output.GetPointData().GetArray(name))
    bounds = demo_bounds.compare(
        distances,
        demo_bounds.upper_bound(mesh, location, corners),
        demo_bounds.lower_bound(mesh, location),
    )

    os.makedirs(options.out, exist_ok=True)
    data_path = os.path.join(options.out, "distance.vtp")
    picture_path = os.path.join(options.out, "distance.png")
    writer = vtkXMLPolyDataWriter()
    writer.SetFileName(data_path)
    writer.SetInputData(output)
    vtkdgg.check(writer)
    step = demo_picture.save(picture_path, output, name, location)

    place = ", ".join(f"{x:.6g}" for x in location)
    which = f"point {source} at " if isinstance(source, int) else ""
    reached = np.isfinite(distances)
    rows = (
        ("mesh", options.mesh),
        ("vertices", mesh.GetNumberOfPoints()),
        ("triangles", mesh.GetNumberOfPolys()),
        ("topology", topology(distance)),
        ("defects", defects(distance)),
        ("source", f"{which}({place})"),
        ("time", f"{time_taken:.3f} s for all distances (reading: {read_time:.3f} s)"),
        ("range", f"0 to {np.nanmax(np.append(distances, 0.0)):.6g} model units"),
        ("reached", f"{reached.sum()} of {reached.size} vertices"),
        ("upper bound", bound_line(bounds["upper"], "edge graph")),
        ("lower bound", bound_line(bounds["lower"], "Euclid")),
        ("isolines", f"every {step:g} model units"),
        ("written", f"{data_path}, {picture_path}"),
    )
    for key, value in rows:
        print(f"{key:<12} {value}")
    for note in notes:
        print(f"{'note':<12} {str(note.message).split(': ', 1)[-1]}")
    broken = bounds["upper"]["violations"] + bounds["lower"]["violations"]
    if broken:
        print(f"error: {broken} distances break a bound", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    except (UsageError, MeshFileError, vtkdgg.VTKError, OSError) as problem:
        print(f"error: {' '.join(str(problem).split())}", file=sys.stderr)
        sys.exit(2)
