# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Samples of a surface, moved to the centers of their Voronoi cells, and a picture of the cells.

Usage: voronoi_cells.py MESH NUMBER_OF_SITES PICTURE.png
"""

import sys
from argparse import ArgumentTypeError
from colorsys import hsv_to_rgb

import vtkdgg
import vtkmodules.vtkInteractionStyle  # noqa: F401  (rendering factories)
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from example_arguments import integer
from vtkdgg.pictures import write_png
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow


def main(mesh_path, number_of_sites, picture_path):
    """Run the pipeline."""
    mesh = vtkdgg.read(mesh_path).as_polydata()

    # The graph: built once, for both filters.
    graph = vtkdgg.vtkDiscreteGeodesicGraph()
    graph.SetInputData(mesh)

    # Points that are far from each other, ...
    sampler = vtkdgg.vtkGeodesicSampler()
    sampler.SetInputConnection(graph.GetOutputPort())
    sampler.SetNumberOfSamples(number_of_sites)

    # ... each moved to the center of its cell.
    voronoi = vtkdgg.vtkGeodesicVoronoi()
    voronoi.SetInputConnection(graph.GetOutputPort())
    voronoi.SetSiteConnection(sampler.GetOutputPort())
    voronoi.CentroidalOn()
    vtkdgg.check(voronoi)

    render(voronoi, picture_path)
    sites = voronoi.GetSites()
    energy = voronoi.GetOutput().GetFieldData().GetArray("Energy")
    last = energy.GetNumberOfTuples() - 1
    low, high = sites.GetPointData().GetArray("CellArea").GetRange()
    print(f"{sites.GetNumberOfPoints()} cells, areas from {low:g} to {high:g}")
    print(f"energy {energy.GetValue(0):g}, after {last} iterations {energy.GetValue(last):g}")


def make_colours(number):
    """Returns a table in which neighboring indices have distant hues, alternately light and dark.
    """
    colours = vtkLookupTable()
    colours.SetNumberOfTableValues(number)
    colours.SetTableRange(0, number - 1)
    for i in range(number):
        rgb = hsv_to_rgb(0.618034 * i % 1.0, (0.45, 0.3, 0.55)[i % 3], (0.95, 0.8)[i % 2])
        colours.SetTableValue(i, [*rgb, 1.0])
    return colours


def make_actor(port):
    """Returns an actor of an output, and its mapper."""
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(port)
    actor = vtkActor()
    actor.SetMapper(mapper)
    return actor, mapper


def bring_forward(mapper):
    """Draw lines and points that lie on a surface in front of it."""
    mapper.SetResolveCoincidentTopologyToPolygonOffset()
    mapper.SetRelativeCoincidentTopologyLineOffsetParameters(-2.0, -60.0)
    mapper.SetRelativeCoincidentTopologyPointOffsetParameter(-60.0)


def render(voronoi, picture_path):
    """Render cells, borders and sites off-screen, and save the picture."""
    cells, mapper = make_actor(voronoi.GetCellsPort())
    mapper.SetScalarModeToUseCellFieldData()
    mapper.SelectColorArray("SiteId")
    mapper.SetLookupTable(make_colours(voronoi.GetSites().GetNumberOfPoints()))
    mapper.UseLookupTableScalarRangeOn()
    borders, mapper = make_actor(voronoi.GetBoundariesPort())
    mapper.ScalarVisibilityOff()
    bring_forward(mapper)
    borders.GetProperty().SetColor(0.15, 0.15, 0.15)
    borders.GetProperty().SetLineWidth(3)
    borders.GetProperty().LightingOff()
    sites, mapper = make_actor(voronoi.GetSitesPort())
    mapper.ScalarVisibilityOff()
    bring_forward(mapper)
    sites.GetProperty().SetColor(0.1, 0.1, 0.1)
    sites.GetProperty().SetPointSize(11)
    sites.GetProperty().RenderPointsAsSpheresOn()
    renderer = vtkRenderer()
    renderer.SetBackground(1.0, 1.0, 1.0)
    for actor in (cells, borders, sites):
        renderer.AddActor(actor)
    window = vtkRenderWindow()
    window.OffScreenRenderingOn()
    window.SetMultiSamples(8)
    window.SetSize(800, 800)
    window.AddRenderer(renderer)
    renderer.ResetCamera()
    renderer.GetActiveCamera().Zoom(1.4)
    window.Render()
    write_png(picture_path, window)


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    try:
        main(sys.argv[1], integer(1)(sys.argv[2]), sys.argv[3])
    except (OSError, ValueError, ArgumentTypeError, vtkdgg.VTKError) as problem:
        sys.exit(f"error: {problem}")
