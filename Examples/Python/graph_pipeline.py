# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Two queries on one graph: distances from two points, side by side in a picture.

Usage: graph_pipeline.py MESH SOURCE_ID SOURCE_ID PICTURE.png
"""

import sys
from argparse import ArgumentTypeError

import vtkdgg
import vtkmodules.vtkInteractionStyle  # noqa: F401  (rendering factories)
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from example_arguments import integer
from vtkdgg.pictures import write_png
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkFiltersModeling import vtkBandedPolyDataContourFilter
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow


BANDS = 24


def main(mesh_path, source_ids, picture_path):
    """Run the pipeline."""
    mesh = vtkdgg.read(mesh_path).as_polydata()

    # Build the graph once.
    graph = vtkdgg.vtkDiscreteGeodesicGraph()
    graph.SetInputData(mesh)
    graph.SetAccuracy(0.01)

    # Each query takes milliseconds.
    queries = []
    for source_id in source_ids:
        distance = vtkdgg.vtkDGGDistance()
        distance.SetInputConnection(graph.GetOutputPort())
        distance.AddSourceId(source_id)
        vtkdgg.check(distance)
        queries.append(distance)

    render([make_bands(query) for query in queries], picture_path)
    print(f"{graph.GetNumberOfGraphEdges()} edges, {graph.GetMeanDegree():.1f} per point")
    for source_id, query in zip(source_ids, queries):
        _, high = query.GetOutput().GetPointData().GetArray("GeodesicDistance").GetRange()
        print(f"from point {source_id}: up to {high:g}")


def make_bands(distance):
    """Returns a filter of the surface in bands of equal width."""
    bands = vtkBandedPolyDataContourFilter()
    bands.SetInputConnection(distance.GetOutputPort())
    bands.GenerateValues(BANDS + 1, distance.GetOutput().GetPointData().GetScalars().GetRange())
    bands.SetScalarModeToIndex()
    return bands


def make_colours():
    """Returns a table from yellow to violet in which every other band is slightly darker."""
    colours = vtkLookupTable()
    colours.SetNumberOfTableValues(BANDS)
    colours.SetTableRange(0, BANDS - 1)
    colours.SetHueRange(0.14, 0.76)
    colours.SetSaturationRange(0.6, 0.6)
    colours.Build()
    for i in range(0, BANDS, 2):
        colours.SetTableValue(i, [0.8 * part for part in colours.GetTableValue(i)[:3]] + [1.0])
    return colours


def render(surfaces, picture_path):
    """Render the surfaces side by side, off-screen, and save the picture."""
    window = vtkRenderWindow()
    window.OffScreenRenderingOn()
    window.SetMultiSamples(8)
    window.SetSize(600 * len(surfaces), 600)
    for i, surface in enumerate(surfaces):
        mapper = vtkPolyDataMapper()
        mapper.SetInputConnection(surface.GetOutputPort())
        mapper.SetScalarModeToUseCellData()
        mapper.SetLookupTable(make_colours())
        mapper.UseLookupTableScalarRangeOn()
        actor = vtkActor()
        actor.SetMapper(mapper)
        renderer = vtkRenderer()
        renderer.SetBackground(1.0, 1.0, 1.0)
        renderer.SetViewport(i / len(surfaces), 0.0, (i + 1) / len(surfaces), 1.0)
        renderer.AddActor(actor)
        window.AddRenderer(renderer)
        renderer.ResetCamera()
        renderer.GetActiveCamera().Zoom(1.4)
    window.Render()
    write_png(picture_path, window)


if __name__ == "__main__":
    if len(sys.argv) != 5:
        sys.exit(__doc__)
    try:
        main(sys.argv[1], (integer(0)(sys.argv[2]), integer(0)(sys.argv[3])), sys.argv[4])
    except (OSError, ValueError, ArgumentTypeError, vtkdgg.VTKError) as problem:
        sys.exit(f"error: {problem}")
