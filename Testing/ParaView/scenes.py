# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""A session as a user would script it: from a file to distances, isolines, a path, cells and a
Green's function, and pictures of them."""

from paraview import smtrace
from paraview.modules.vtkRemotingServerManager import vtkSMTrace
from support import bumpy, points, simple

SOURCE = [0.9, -0.4, 0.3]
STEPS = [0.25 * i for i in range(1, 10)]


def assign(proxy, **values):
    """Set properties as the panel of ParaView does, which a trace records."""
    item = smtrace.PropertiesModified(proxy.SMProxy) if vtkSMTrace.GetActiveTracer() else None
    for name, value in values.items():
        setattr(proxy, name, value)
    if item:
        item.finalize()


def build():
    """Returns the proxies of the pipeline by name."""
    mesh = bumpy()
    graph = simple.GeodesicGraph(registrationName="graph", Input=mesh, Accuracy=0.01)
    distance = simple.GeodesicDistance(
        registrationName="distance", Input=graph, GenerateVirtualSource=1
    )
    assign(distance.Source, Center=SOURCE)
    lines = simple.GeodesicIsolines(registrationName="lines", Input=distance, Distances=STEPS)
    path = simple.GeodesicPath(registrationName="path", Input=graph)
    assign(path.Ends, StartPoint=SOURCE, EndPoint=[-0.9, 0.2, 0.5])
    samples = simple.GeodesicSampler(registrationName="samples", Input=graph, NumberOfSamples=12)
    cells = simple.GeodesicVoronoiCells(registrationName="cells", Input=graph)
    assign(cells.Sites, Points=points(samples).ravel().tolist())  # a trace does not name the filter
    green = simple.GreensFunction(registrationName="green", Input=mesh)
    assign(green.Source, Center=SOURCE)
    return {
        "distance": distance,
        "lines": lines,
        "path": path,
        "samples": samples,
        "cells": cells,
        "green": green,
    }


def make_view():
    """Returns a small empty white view from an asymmetric direction."""
    view = simple.CreateView("RenderView")
    view.ViewSize = [320, 280]
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    view.OrientationAxesVisibility = 0
    view.CenterAxesVisibility = 0
    view.CameraPosition = [3.4, -2.1, 2.6]
    view.CameraFocalPoint = [0, 0, 0]
    view.CameraViewUp = [0, 0, 1]
    view.CameraViewAngle = 40
    return view


def show_surface(port, view, name, colors, association="POINTS", **properties):
    """Show a surface in the colors of an array."""
    display = simple.Show(port, view, Representation="Surface", **properties)
    simple.ColorBy(display, (association, name), separate=True)
    display.LookupTable.ApplyPreset(colors, True)
    display.RescaleTransferFunctionToDataRange(False, True)
    display.SetScalarBarVisibility(view, False)
    display.InterpolateScalarsBeforeMapping = 1
    return display


def show_lines(port, view, color, radius=0.012):
    """Show lines as tubes in one color."""
    tube = simple.Tube(Input=port, Radius=radius, NumberofSides=8, Scalars=None, Vectors=None)
    display = simple.Show(tube, view, Representation="Surface")
    display.ColorArrayName = [None, ""]
    display.DiffuseColor = display.AmbientColor = color
    return display


def draw(pipeline):
    """Returns a view for each picture, by name."""
    views = {name: make_view() for name in ("Distance", "Cells", "Green")}
    view = views["Distance"]
    show_surface(pipeline["distance"], view, "GeodesicDistance", "Viridis (matplotlib)")
    show_lines(pipeline["lines"], view, [0.1, 0.1, 0.1])
    show_lines(pipeline["path"], view, [0.9, 0.2, 0.1], 0.03)
    view = views["Cells"]
    show_surface(pipeline["cells"]["Cells"], view, "SiteId", "Jet", "CELLS")
    show_lines(pipeline["cells"]["Borders"], view, [0.1, 0.1, 0.1], 0.02)
    view = views["Green"]
    show_surface(pipeline["green"], view, "GreensFunction", "Inferno (matplotlib)")
    return views
