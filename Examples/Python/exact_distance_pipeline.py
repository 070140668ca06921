# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""A small complete pipeline: read a mesh, compute distances, color, render off-screen, save.

Usage: exact_distance_pipeline.py MESH SOURCE_ID PICTURE.png
"""

import sys
from argparse import ArgumentTypeError

import vtkdgg
import vtkmodules.vtkInteractionStyle  # noqa: F401  (rendering factories)
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from example_arguments import integer
from vtkdgg.pictures import write_png
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow


def main(mesh_path, source_id, picture_path):
    """Run the pipeline."""
    # Read.
    mesh = vtkdgg.read(mesh_path).as_polydata()

    # Distance from one point. check() updates the filter, and raises an error if that fails.
    distance = vtkdgg.vtkExactGeodesicDistance()
    distance.SetInputData(mesh)
    distance.AddSourceId(source_id)
    mesh = vtkdgg.check(distance)
    array = mesh.GetPointData().GetArray("GeodesicDistance")

    # Colour.
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(distance.GetOutputPort())
    mapper.SelectColorArray("GeodesicDistance")
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SetScalarRange(array.GetRange())
    actor = vtkActor()
    actor.SetMapper(mapper)

    # Render off-screen.
    renderer = vtkRenderer()
    renderer.SetBackground(1.0, 1.0, 1.0)
    renderer.AddActor(actor)
    window = vtkRenderWindow()
    window.OffScreenRenderingOn()
    window.SetSize(800, 600)
    window.AddRenderer(renderer)
    renderer.ResetCamera()
    window.Render()

    # Save.
    write_png(picture_path, window)

    low, high = array.GetRange()
    print(f"{mesh.GetNumberOfPoints()} points, distances {low:g} to {high:g}, {picture_path}")


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    try:
        main(sys.argv[1], integer(0)(sys.argv[2]), sys.argv[3])
    except (OSError, ValueError, ArgumentTypeError, vtkdgg.VTKError) as problem:
        sys.exit(f"error: {problem}")
