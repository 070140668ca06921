# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Read what may be a point cloud: points without polygons, in any format that the examples know."""

import os

import numpy as np
import vtkdgg
from mesh_file import READERS, MeshFileError, read_all
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData

EXTENSIONS = sorted([*READERS, ".pcd", ".xyz"])


def read(path):
    """All that the file holds, which is a point at least."""
    contents = _read(path)
    if contents.GetNumberOfPoints() == 0:
        raise MeshFileError(f"{path}: holds no points")
    return contents


def _read(path):
    extension = os.path.splitext(path)[1].lower()
    if extension not in EXTENSIONS:
        known = " ".join(EXTENSIONS)
        raise MeshFileError(f"{path}: unknown extension '{extension}'; known are {known}")
    if not os.path.isfile(path):
        raise MeshFileError(f"{path}: no such file")
    if extension == ".xyz":
        return cloud_of(read_xyz(path))
    if extension == ".pcd":
        reader = vtkdgg.vtkPCDReader()
        reader.SetFileName(path)
        return read_all(path, reader)
    return read_all(path)


def is_cloud(contents):
    """Whether these are points, and no polygon uses them."""
    polygons = contents.GetNumberOfPolys() + contents.GetNumberOfStrips()
    return polygons == 0


def make_graph(contents):
    """The filter that makes a graph of these points."""
    if not hasattr(vtkdgg, "vtkPointCloudDGG"):
        raise MeshFileError("this vtkDGG has no graphs of point clouds: build it with DGG_WITH_PCL")
    graph = vtkdgg.vtkPointCloudDGG()
    graph.SetInputData(contents)
    return graph


def cloud_of(points):
    """Points without cells."""
    vtk_points = vtkPoints()
    vtk_points.SetData(numpy_to_vtk(np.ascontiguousarray(points, dtype=float), deep=True))
    cloud = vtkPolyData()
    cloud.SetPoints(vtk_points)
    return cloud


def read_xyz(path):
    """The points of a text file: the first three numbers of each line, of which there may be more.

    Blanks, commas or semicolons part the numbers; `#` and `//` start comments; the first line may
    be the number of points. VTK's vtkSimplePointsReader ends at the first `nan`, takes normals and
    colours for points, and rounds to float.
    """
    points = []
    may_be_count = True
    # Any byte is a character of this encoding: comments may be in any other one.
    with open(path, encoding="latin-1") as file:
        for number, line in enumerate(file, 1):
            for mark in ("#", "//"):
                line = line.split(mark, 1)[0]
            words = line.replace(",", " ").replace(";", " ").split()
            if not words or (may_be_count and len(words) == 1 and words[0].isdigit()):
                may_be_count = may_be_count and not words
                continue
            may_be_count = False
            try:
                point = [float(word) for word in words[:3]]
            except ValueError:
                point = []
            if len(point) != 3:
                shown = ascii(line.strip()[:40])
                raise MeshFileError(f"{path}: line {number}: {shown} does not start with X Y Z")
            points.append(point)
    return np.array(points, dtype=float).reshape(-1, 3)
