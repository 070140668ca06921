# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Path planning on a terrain: the shortest path on the surface between two points, and the shortest
one along mesh edges by vtkDijkstraGraphGeodesicPath.

Usage: terrain_path.py PICTURE.png
"""

import sys

import numpy as np
import vtkdgg
import vtkmodules.vtkInteractionStyle  # noqa: F401  (rendering factories)
import vtkmodules.vtkRenderingFreeType  # noqa: F401
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkdgg.pictures import actor_of, tubes, write_png
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLookupTable, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkContourFilter, vtkPolyDataNormals
from vtkmodules.vtkFiltersModeling import vtkDijkstraGraphGeodesicPath
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkLight, vtkRenderer, vtkRenderWindow, vtkTextActor

SIDE = 150  # points
EXTENT = 12.0  # km
START = (1.2, 2.6)  # km
END = (10.8, 8.1)
# Mountains: position, height, width along and across, in km, and the direction of the ridge.
HILLS = (
    (4.3, 2.4, 2.3, 1.6, 0.7, 2.0),
    (3.5, 6.2, 1.9, 2.0, 0.8, 1.5),
    (7.2, 5.2, 2.6, 1.9, 0.8, 1.9),
    (7.9, 9.3, 1.5, 1.2, 0.9, 0.6),
    (9.9, 3.0, 1.2, 1.3, 1.0, 0.2),
    (1.7, 9.7, 1.0, 1.0, 1.4, 0.5),
    (10.4, 6.1, 0.6, 0.5, 0.9, 1.1),
)
STEP = 0.2  # km, between lines of equal height
# Colours by height.
COLOURS = (
    (0.42, 0.60, 0.38),
    (0.62, 0.71, 0.44),
    (0.84, 0.80, 0.56),
    (0.72, 0.56, 0.40),
    (0.58, 0.45, 0.38),
    (0.88, 0.87, 0.86),
)
ON_SURFACE = (0.80, 0.05, 0.12)
ALONG_EDGES = (0.08, 0.16, 0.55)


def height(x, y):
    """Returns the height of the ground in km."""
    z = 0.0 * x
    for x0, y0, top, along, across, direction in HILLS:
        c, s = np.cos(direction), np.sin(direction)
        u, v = c * (x - x0) + s * (y - y0), c * (y - y0) - s * (x - x0)
        z = z + top * np.exp(-((u / along) ** 2) - (v / across) ** 2)
    for k in range(1, 9):  # ever smaller waves in all directions
        a, b = 1.3**k * np.cos(2.4 * k), 1.3**k * np.sin(2.4 * k)
        z = z + 0.09 / 1.25**k * np.sin(a * x + b * y + np.sin(0.7 * b * x - 0.6 * a * y + k))
    return z


def make_terrain():
    """Returns a triangle mesh of the terrain on an irregular grid."""
    j, i = np.divmod(np.arange(SIDE * SIDE), SIDE)
    inside = (i > 0) & (i < SIDE - 1) & (j > 0) & (j < SIDE - 1)
    shift = np.where(inside, 0.3, 0.0)
    x = EXTENT / (SIDE - 1) * (i + shift * np.sin(12.9 * i + 78.2 * j))
    y = EXTENT / (SIDE - 1) * (j + shift * np.sin(39.3 * i + 11.1 * j))
    corner = np.arange(SIDE * (SIDE - 1))
    corner = corner[corner % SIDE < SIDE - 1]
    a, b, c, d = corner, corner + 1, corner + SIDE + 1, corner + SIDE
    # Squares are divided along alternating diagonals.
    turn = ((corner % SIDE + corner // SIDE) % 2 == 0)[:, np.newaxis]
    triangles = np.vstack(
        [
            np.where(turn, np.column_stack([a, b, c]), np.column_stack([a, b, d])),
            np.where(turn, np.column_stack([a, c, d]), np.column_stack([b, c, d])),
        ]
    )
    points = vtkPoints()
    points.SetData(numpy_to_vtk(np.column_stack([x, y, height(x, y)]), deep=True))
    cells = vtkCellArray()
    cells.SetData(
        numpy_to_vtkIdTypeArray(np.arange(0, triangles.size + 1, 3, dtype=np.int64), deep=True),
        numpy_to_vtkIdTypeArray(triangles.ravel().astype(np.int64), deep=True),
    )
    terrain = vtkPolyData()
    terrain.SetPoints(points)
    terrain.SetPolys(cells)
    heights = numpy_to_vtk(height(x, y), deep=True)
    heights.SetName("Height")
    terrain.GetPointData().SetScalars(heights)
    return terrain


def closest_point(terrain, place):
    """Returns the id of the mesh point closest to a position on the map, where both paths end."""
    points = vtk_to_numpy(terrain.GetPoints().GetData())
    return int(np.argmin(np.hypot(points[:, 0] - place[0], points[:, 1] - place[1])))


def path_on_surface(terrain, start, end):
    """Returns a shortest path on the surface as a polyline, and its length."""
    path = vtkdgg.vtkDGGPath()
    path.SetInputData(terrain)
    path.AddPair(start, end)
    polyline = vtkdgg.check(path)
    return polyline, polyline.GetCellData().GetArray("Length").GetValue(0)


def path_along_edges(terrain, start, end):
    """Returns the shortest path along mesh edges, and its length."""
    dijkstra = vtkDijkstraGraphGeodesicPath()
    dijkstra.SetInputData(terrain)
    dijkstra.SetStartVertex(start)
    dijkstra.SetEndVertex(end)
    polyline = vtkdgg.check(dijkstra)
    points = vtk_to_numpy(polyline.GetPoints().GetData()).astype(float)
    return polyline, np.linalg.norm(np.diff(points, axis=0), axis=1).sum()


def surface_actor(terrain):
    """Returns an actor of the terrain, colored by height."""
    table = vtkLookupTable()
    table.SetNumberOfTableValues(256)
    channels = np.array(COLOURS).T
    for i in range(256):
        t = i / 255.0 * (len(COLOURS) - 1)
        table.SetTableValue(i, *(float(np.interp(t, range(len(COLOURS)), c)) for c in channels))
    normals = vtkPolyDataNormals()
    normals.SetInputData(terrain)
    normals.SplittingOff()
    actor = actor_of(vtkdgg.check(normals))
    mapper = actor.GetMapper()
    mapper.SetLookupTable(table)
    mapper.SetScalarRange(terrain.GetPointData().GetScalars().GetRange())
    mapper.InterpolateScalarsBeforeMappingOn()
    actor.GetProperty().SetAmbient(0.25)
    actor.GetProperty().SetDiffuse(0.85)
    return actor


def contour_actor(terrain):
    """Returns an actor of lines of equal height."""
    contour = vtkContourFilter()
    contour.SetInputData(terrain)
    low, high = terrain.GetPointData().GetScalars().GetRange()
    for i, level in enumerate(np.arange(np.ceil(low / STEP), high / STEP)):
        contour.SetValue(i, level * STEP)
    actor = actor_of(vtkdgg.check(contour), (0.33, 0.33, 0.22))
    actor.SetPosition(0.0, 0.0, 0.01)  # slightly above the ground, to be visible
    actor.GetProperty().LightingOff()
    return actor


def tube_actor(polyline, colour, radius):
    """Returns an actor of a path as a tube."""
    actor = tubes(polyline, radius, colour, sides=16, is_capped=True)
    actor.GetProperty().SetAmbient(0.35)
    return actor


def ball_actor(place):
    """Returns an actor of a ball at an end of the paths."""
    ball = vtkSphereSource()
    ball.SetCenter(place)
    ball.SetRadius(0.12)
    ball.SetThetaResolution(32)
    ball.SetPhiResolution(32)
    return actor_of(vtkdgg.check(ball), (1.0, 0.95, 0.85))


def text_actor(text, colour, row):
    """Returns an actor of a line of the legend."""
    actor = vtkTextActor()
    actor.SetInput(text)
    actor.GetPositionCoordinate().SetCoordinateSystemToNormalizedViewport()
    actor.SetPosition(0.03, 0.94 - 0.045 * row)
    look = actor.GetTextProperty()
    look.SetFontFamilyToArial()
    look.SetFontSize(22)
    look.BoldOn()
    look.SetColor(*colour)
    return actor


def render(props, picture_path):
    """Render the terrain from above, off-screen, and save the picture."""
    renderer = vtkRenderer()
    renderer.SetBackground(1.0, 1.0, 1.0)
    for prop in props:
        renderer.AddViewProp(prop)
    for position, intensity in (((-8.0, 14.0, 12.0), 0.75), ((9.0, -20.0, 25.0), 0.4)):
        light = vtkLight()  # the sun, and light of the sky in the shadows
        light.SetPosition(position)
        light.SetFocalPoint(0.5 * EXTENT, 0.5 * EXTENT, 0.0)
        light.SetIntensity(intensity)
        renderer.AddLight(light)
    camera = renderer.GetActiveCamera()
    camera.SetFocalPoint(0.5 * EXTENT, 0.55 * EXTENT, 0.0)
    camera.SetPosition(0.58 * EXTENT, -0.45 * EXTENT, 2.15 * EXTENT)
    camera.SetViewUp(0.0, 0.0, 1.0)
    camera.SetViewAngle(28.8)
    renderer.ResetCameraClippingRange()
    window = vtkRenderWindow()
    window.OffScreenRenderingOn()
    window.SetMultiSamples(8)
    window.SetSize(1000, 780)
    window.AddRenderer(renderer)
    window.Render()
    write_png(picture_path, window)


def main(picture_path):
    """Find both paths, print their lengths, and render them."""
    terrain = make_terrain()
    start, end = closest_point(terrain, START), closest_point(terrain, END)
    surface_path, length = path_on_surface(terrain, start, end)
    edge_path, edge_length = path_along_edges(terrain, start, end)
    lines = (
        f"on the surface: {length:.3f} km",
        f"along mesh edges: {edge_length:.3f} km, {100 * (edge_length / length - 1):.1f} % longer",
    )
    print("\n".join(lines))
    render(
        [
            surface_actor(terrain),
            contour_actor(terrain),
            tube_actor(edge_path, ALONG_EDGES, 0.035),
            tube_actor(surface_path, ON_SURFACE, 0.045),
            *(ball_actor(terrain.GetPoint(point)) for point in (start, end)),
            text_actor("Shortest path " + lines[0], ON_SURFACE, 0),
            text_actor("Shortest path " + lines[1], ALONG_EDGES, 1),
        ],
        picture_path,
    )


if __name__ == "__main__":
    if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
        sys.exit(__doc__)
    try:
        main(sys.argv[1])
    except (OSError, vtkdgg.VTKError) as problem:
        sys.exit(f"error: {problem}")
