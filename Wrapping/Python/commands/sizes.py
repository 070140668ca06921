# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""How large the triangles of a mesh are, and what that means for its results."""

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

# Of the mean edge. Distances below consist of rounding and of the length added to triangles
# without area.
FLOOR = 1e-6
# Of the diagonal. Isolines are drawn as if distances were linear in a triangle.
LARGE = 0.05


def edge_lengths(mesh):
    """The lengths of the sides of all triangles."""
    points = vtk_to_numpy(mesh.GetPoints().GetData()).astype(float)
    triangles = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    ends = points[np.roll(triangles, -1, axis=1)]
    return np.linalg.norm(ends - points[triangles], axis=2).ravel()


def floor_of(mesh):
    """The distance below which relative errors mean nothing."""
    return FLOOR * float(edge_lengths(mesh).mean())


def notes(mesh):
    """What there is to say of pictures of the mesh."""
    share = float(np.median(edge_lengths(mesh))) / mesh.GetLength() if mesh.GetLength() > 0 else 0.0
    if share <= LARGE:
        return []
    return [
        f"triangles are large (half of the edges are longer than {100 * share:.0f} % of the "
        "diagonal): isolines and colours are right at points, and only roughly between them"
    ]
