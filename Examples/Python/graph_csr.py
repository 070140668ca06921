# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""The geodesic graph as a SciPy matrix, and SciPy's Dijkstra beside vtkDGGDistance. Needs SciPy.

Usage: graph_csr.py MESH SOURCE_ID
"""

import sys
from argparse import ArgumentTypeError

import numpy as np
import vtkdgg
from example_arguments import integer
from scipy.sparse import csr_matrix
from scipy.sparse.csgraph import dijkstra
from vtkmodules.util.numpy_support import vtk_to_numpy


def main(mesh_path, source_id):
    """Compute the same distances by both."""
    graph = vtkdgg.vtkDiscreteGeodesicGraph()
    graph.SetInputData(vtkdgg.read(mesh_path).as_polydata())
    graph.SetAccuracy(0.01)
    mesh = vtkdgg.check(graph)

    # The arrays of the graph are a sparse matrix. Copied, because SciPy may sort them in place and
    # the search depends on the order of the edges.
    n = mesh.GetNumberOfPoints()
    offsets, targets, lengths = (
        vtk_to_numpy(mesh.GetFieldData().GetArray(f"DGG.{name}"))
        for name in ("Offsets", "Targets", "Lengths")
    )
    matrix = csr_matrix((lengths, targets, offsets), shape=(n, n), copy=True)

    # Distances of the filter: lengths of paths, and corrected ones.
    distance = vtkdgg.vtkDGGDistance()
    distance.SetInputConnection(graph.GetOutputPort())
    distance.AddSourceId(source_id)
    distance.GenerateUpperBoundOn()
    result = vtkdgg.check(distance).GetPointData()
    bound = vtk_to_numpy(result.GetArray("GeodesicUpperBound"))
    corrected = vtk_to_numpy(result.GetArray("GeodesicDistance"))

    # Distances of SciPy; infinite instead of NaN if unreached.
    expected = dijkstra(matrix, indices=source_id)
    reached = np.isfinite(expected)
    if not np.array_equal(reached, ~np.isnan(bound)):
        raise AssertionError("SciPy reaches other points")
    difference = np.max(np.abs(bound - expected)[reached])
    correction = np.max((bound - corrected)[reached])
    print(f"{n} points, {matrix.nnz} edges")
    print(f"farthest point: {bound[reached].max():g}, difference to SciPy: {difference:.1e}")
    print(f"largest correction: {correction:.1e}")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    try:
        main(sys.argv[1], integer(0)(sys.argv[2]))
    except (OSError, ValueError, ArgumentTypeError, vtkdgg.VTKError) as problem:
        sys.exit(f"error: {problem}")
