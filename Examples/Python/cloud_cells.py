# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Even cells on a point cloud: samples, moved to the centers of their cells.

Usage: cloud_cells.py CLOUD NUMBER_OF_CELLS PICTURE.png
"""

import sys
from argparse import ArgumentTypeError

import numpy as np
import vtkdgg
import vtkmodules.vtkInteractionStyle  # noqa: F401  (rendering factories)
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from example_arguments import integer
from vtkdgg.pictures import disc_radii, discs, spacings_of, write_png
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkGlyph3DMapper, vtkRenderer, vtkRenderWindow

COLOURS = (
    (0.90, 0.47, 0.42),
    (0.96, 0.76, 0.42),
    (0.95, 0.92, 0.55),
    (0.65, 0.82, 0.45),
    (0.40, 0.68, 0.52),
    (0.53, 0.83, 0.85),
    (0.45, 0.60, 0.85),
    (0.68, 0.58, 0.84),
    (0.93, 0.68, 0.82),
    (0.72, 0.60, 0.50),
)
UNREACHED = (0.75, 0.75, 0.75)


def main(cloud_path, number_of_cells, picture_path):
    """Run the pipeline."""
    # The graph of the points: built once, for both filters.
    graph = vtkdgg.vtkPointCloudDGG()
    graph.SetInputData(vtkdgg.read(cloud_path).as_polydata())

    # Points that are far from each other, ...
    sampler = vtkdgg.vtkGeodesicSampler()
    sampler.SetInputConnection(graph.GetOutputPort())
    sampler.SetNumberOfSamples(number_of_cells)

    # ... each moved to the center of its cell.
    voronoi = vtkdgg.vtkGeodesicVoronoi()
    voronoi.SetInputConnection(graph.GetOutputPort())
    voronoi.SetSiteConnection(sampler.GetOutputPort())
    voronoi.CentroidalOn()
    cloud = vtkdgg.check(voronoi)

    labels = vtk_to_numpy(cloud.GetPointData().GetArray("GeodesicSource"))
    count = voronoi.GetSites().GetNumberOfPoints()
    colours = choose_colours(cloud, labels, count)
    render(graph, voronoi, np.where(labels < 0, -1, colours[labels]), picture_path)
    sizes = np.bincount(labels[labels >= 0], minlength=count)
    energy = vtk_to_numpy(cloud.GetFieldData().GetArray("Energy"))
    print(f"{count} cells, with {sizes.min()} to {sizes.max()} of {len(labels)} points")
    print(f"energy {energy[0]:g}, after {len(energy) - 1} iterations {energy[-1]:g}")


def choose_colours(cloud, labels, count):
    """Returns a color index per cell that differs from those of its neighbors, preferring rare
    colors."""
    offsets, targets = (
        vtk_to_numpy(cloud.GetFieldData().GetArray("DGG." + name))
        for name in ("Offsets", "Targets")
    )
    # Cells are neighbors if an edge of the graph connects them.
    edges = np.column_stack([np.repeat(labels, np.diff(offsets)), labels[targets]])
    first, second = np.unique(edges[edges[:, 0] != edges[:, 1]], axis=0).T
    colours = np.full(count, -1)
    for cell in range(count):
        around = colours[second[first == cell]]
        taken = np.bincount(around[around >= 0], minlength=len(COLOURS))
        used = np.bincount(colours[:cell], minlength=len(COLOURS))
        colours[cell] = np.lexsort((used, taken))[0]
    return colours


def lookup_table():
    """Returns a table of the colors by index; -1 is the color of unreached points."""
    table = vtkLookupTable()
    table.SetNumberOfTableValues(len(COLOURS) + 1)
    table.SetTableRange(-1, len(COLOURS) - 1)
    for i, colour in enumerate((UNREACHED, *COLOURS)):
        table.SetTableValue(i, *colour, 1.0)
    return table


def site_balls(voronoi, radius):
    """Returns an actor of a dark ball at each site."""
    ball = vtkSphereSource()
    ball.SetRadius(radius)
    ball.SetThetaResolution(32)
    ball.SetPhiResolution(32)
    mapper = vtkGlyph3DMapper()
    mapper.SetInputConnection(voronoi.GetSitesPort())
    mapper.SetSourceConnection(ball.GetOutputPort())
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(0.12, 0.12, 0.14)
    return actor


def render(graph, voronoi, colours, picture_path):
    """Render the points as discs and the sites as balls off-screen, and save the picture."""
    cloud = voronoi.GetOutput()
    points = vtk_to_numpy(cloud.GetPoints().GetData())
    finite = np.isfinite(points).all(axis=1)
    drawn = vtkdgg.Mesh(points[finite]).as_polydata()
    radii = disc_radii(spacings_of(graph)[finite])
    renderer = vtkRenderer()
    renderer.SetBackground(1.0, 1.0, 1.0)
    renderer.AddActor(discs(drawn, radii, colours[finite], lookup_table()))
    renderer.AddActor(site_balls(voronoi, 0.006 * drawn.GetLength()))
    window = vtkRenderWindow()
    window.OffScreenRenderingOn()
    window.SetMultiSamples(8)
    window.SetSize(800, 800)
    window.AddRenderer(renderer)
    renderer.ResetCamera()
    renderer.GetActiveCamera().Elevation(15.0)
    renderer.GetActiveCamera().Zoom(1.3)
    renderer.ResetCameraClippingRange()
    window.Render()
    write_png(picture_path, window)


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    try:
        main(sys.argv[1], integer(1)(sys.argv[2]), sys.argv[3])
    except (OSError, ValueError, ArgumentTypeError, vtkdgg.VTKError) as problem:
        sys.exit(f"error: {problem}")
