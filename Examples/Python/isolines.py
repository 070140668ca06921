# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Isolines of the distance on coarse meshes by four methods: linear in each triangle, published
Apollonius diagrams, local sources, and exact, with ridges in red.

Without a mesh there are two rows: a smooth surface with one source, and a block with three. The
block has sharp edges and holes, so that ridges are where shortest paths around them meet.
"""

import argparse
import sys

import numpy as np
import vtkdgg
import vtkmodules.vtkInteractionStyle  # noqa: F401  (rendering factories)
import vtkmodules.vtkRenderingFreeType  # noqa: F401
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from example_arguments import integer, triple
from vtkdgg.pictures import actor_of, tubes, write_png
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkCleanPolyData
from vtkmodules.vtkFiltersModeling import vtkLinearSubdivisionFilter
from vtkmodules.vtkFiltersSources import vtkPlatonicSolidSource
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow, vtkTextActor

SURFACE = (0.93, 0.92, 0.88)
EDGES = (0.72, 0.72, 0.70)
LINES = (0.05, 0.20, 0.45)
RIDGES = (0.85, 0.10, 0.10)
PANEL = (480, 420)


def make_smooth():
    """Returns a coarse surface without sharp edges: a sphere with waves."""
    solid = vtkPlatonicSolidSource()
    solid.SetSolidTypeToIcosahedron()
    finer = vtkLinearSubdivisionFilter()
    finer.SetInputConnection(solid.GetOutputPort())
    finer.SetNumberOfSubdivisions(3)
    surface = vtkPolyData()
    surface.ShallowCopy(vtkdgg.check(finer))
    p = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
    p /= np.linalg.norm(p, axis=1)[:, None]
    p *= (1.0 + 0.16 * np.sin(3.0 * p[:, 0] + 1.0) * np.cos(2.5 * p[:, 1]) + 0.1 * p[:, 2] ** 2)[
        :, None
    ]
    points = vtkPoints()
    points.SetData(numpy_to_vtk(p, deep=True))
    surface.SetPoints(points)
    return surface


def make_block():
    """Returns a block of 6 x 4 x 2 unit cubes with a hole and a step."""
    filled = np.ones((6, 4, 2), dtype=bool)
    filled[1:3, 1:3, :] = False
    filled[4:, :, 1] = False
    inside = np.pad(filled, 1)
    corners = {}
    quads = vtkCellArray()

    def corner(place):
        return corners.setdefault(tuple(place), len(corners))

    for cube in np.argwhere(filled):
        for axis in range(3):
            for side in (0, 1):
                beyond = cube + 1
                beyond[axis] += 2 * side - 1
                if inside[tuple(beyond)]:
                    continue
                base = cube.copy()
                base[axis] += side
                u, v = np.eye(3, dtype=int)[[(axis + 1) % 3, (axis + 2) % 3]]
                ring = [base, base + u, base + u + v, base + v]
                if side == 0:
                    ring.reverse()
                ids = [corner(place) for place in ring]
                for triangle in ((0, 1, 2), (0, 2, 3)):
                    quads.InsertNextCell(3, [ids[i] for i in triangle])
    points = vtkPoints()
    points.SetDataTypeToDouble()
    for place in corners:
        points.InsertNextPoint(place)
    surface = vtkPolyData()
    surface.SetPoints(points)
    surface.SetPolys(quads)
    return surface


def measure(surface, sources):
    """Returns exact distances with windows, at points and inside triangles."""
    distance = vtkdgg.vtkExactGeodesicDistance()
    distance.SetInputData(surface)
    distance.SetSourceIds(sources)
    distance.GenerateVirtualSourceOn()
    distance.GenerateWindowsOn()
    return vtkdgg.check(distance)


def without(measured, windows):
    """Returns the same distances without windows and virtual sources."""
    copy = vtkPolyData()
    copy.ShallowCopy(measured)
    if not windows:
        for suffix in (".Windows", ".WindowOffsets", ".WindowSources", ".WindowInfo"):
            copy.GetFieldData().RemoveArray("GeodesicDistance" + suffix)
    return copy


def find_isolines(measured, method, count):
    """Returns a filter of `count` evenly spaced isolines."""
    farthest = measured.GetPointData().GetArray("GeodesicDistance").GetRange()[1]
    step = farthest / (count + 1)
    lines = vtkdgg.vtkApolloniusIsolines()
    lines.SetInputData(measured)
    lines.GenerateValues(count, step, farthest - step)
    getattr(lines, f"SetMethodTo{method}")()
    lines.SetGenerateRidges(method != "Linear")
    vtkdgg.check(lines)
    return lines


def make_tubes(lines, radius, colour):
    """Returns an actor of tubes around polylines."""
    clean = vtkCleanPolyData()
    clean.SetInputData(lines)
    clean.ConvertLinesToPointsOff()
    clean.ToleranceIsAbsoluteOn()
    clean.SetAbsoluteTolerance(0.1 * radius)
    return tubes(vtkdgg.check(clean), radius, colour, sides=12)


def make_surface(surface):
    """Returns an actor of a surface with its edges."""
    actor = actor_of(surface, SURFACE)
    look = actor.GetProperty()
    look.EdgeVisibilityOn()
    look.SetEdgeColor(EDGES)
    look.SetInterpolationToFlat()
    look.SetAmbient(0.45)
    look.SetDiffuse(0.6)
    return actor


def make_panel(surface, lines, title, view):
    """Returns a renderer of the surface with its lines."""
    renderer = vtkRenderer()
    renderer.SetBackground(1.0, 1.0, 1.0)
    radius = 0.0025 * surface.GetLength()
    renderer.AddActor(make_surface(surface))
    renderer.AddActor(make_tubes(lines.GetOutput(), radius, LINES))
    renderer.AddActor(make_tubes(lines.GetRidges(), 1.3 * radius, RIDGES))
    text = vtkTextActor()
    text.SetInput(title)
    text.SetPosition(12, 10)
    text.GetTextProperty().SetFontSize(18)
    text.GetTextProperty().SetColor(0.1, 0.1, 0.1)
    renderer.AddActor2D(text)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(view)
    camera.SetFocalPoint(0.0, 0.0, 0.0)
    camera.SetViewUp(0.0, 0.0, 1.0)
    renderer.ResetCamera()
    camera.Zoom(1.15)
    return renderer


def render(rows, picture_path):
    """Render rows of panels, from the top down."""
    window = vtkRenderWindow()
    window.OffScreenRenderingOn()
    window.SetMultiSamples(8)
    window.SetSize(PANEL[0] * len(rows[0]), PANEL[1] * len(rows))
    for i, row in enumerate(rows):
        for j, panel in enumerate(row):
            panel.SetViewport(
                j / len(row), 1.0 - (i + 1) / len(rows), (j + 1) / len(row), 1.0 - i / len(rows)
            )
            window.AddRenderer(panel)
    window.Render()
    write_png(picture_path, window)


def compare(surface, sources, count, view):
    """Returns a row of panels, and prints their errors."""
    exact = measure(surface, sources)
    local = without(exact, windows=False)
    row = []
    for title, data, method in (
        ("linear", local, "Linear"),
        ("Apollonius", local, "Apollonius"),
        ("local sources", local, "LocalSources"),
        ("exact", exact, "LocalSources"),
    ):
        lines = find_isolines(data, method, count)
        print(
            f"{title}: {lines.GetOutput().GetNumberOfLines()} lines of "
            f"{lines.GetOutput().GetNumberOfPoints()} points, "
            f"{lines.GetRidges().GetNumberOfLines()} ridges"
        )
        row.append(make_panel(surface, lines, title, view))
    return row


def main(options):
    """Run the pipeline."""
    if options.mesh:
        surface = vtkdgg.read(options.mesh).as_polydata()
        rows = [compare(surface, options.sources or [0], options.count, options.view)]
    else:
        rows = [
            compare(make_smooth(), [0], options.count, options.view),
            compare(make_block(), [0, 40, 75], options.count, options.view),
        ]
    render(rows, options.picture)


def parse(arguments):
    """Options from the command line."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("picture", help="the picture to write, a .png")
    parser.add_argument("--mesh", help="a surface (.ply .obj .stl .vtp .vtk .off)")
    parser.add_argument(
        "--sources", type=integer(0), nargs="+", metavar="ID", help="point ids of it (default 0)"
    )
    parser.add_argument(
        "--count", type=integer(1, 10000), default=14, help="of isolines (%(default)s)"
    )
    parser.add_argument(
        "--view", type=triple, metavar="X,Y,Z", default=(1.0, -1.6, 1.1), help="where to look from"
    )
    return parser.parse_args(arguments)


if __name__ == "__main__":
    options = parse(sys.argv[1:])
    try:
        main(options)
    except (OSError, ValueError, vtkdgg.VTKError) as problem:
        sys.exit(f"error: {problem}")
