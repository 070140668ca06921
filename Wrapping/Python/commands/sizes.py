# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Edge lengths of a mesh."""

import numpy as np

# Fraction of the mean edge length. Shorter distances consist of rounding errors and of the length
# that is added to triangles without area.
FLOOR = 1e-6
# Largest median edge, as a fraction of the diagonal, without a remark: pictures interpolate
# distances linearly in triangles, which is inaccurate in large triangles.
LARGE = 0.05


def edge_lengths(mesh):
    """Returns the edge lengths of all triangles of a vtkPolyData; shared edges are repeated."""
    from ..vtk_data import coordinates_of, triangles_of

    corners = coordinates_of(mesh)[triangles_of(mesh)]
    return np.linalg.norm(np.roll(corners, -1, axis=1) - corners, axis=2).ravel()


def floor_of(mesh):
    """Returns the distance below which relative errors are meaningless."""
    return FLOOR * float(edge_lengths(mesh).mean())


def notes(mesh):
    """Returns remarks on pictures of the mesh."""
    share = float(np.median(edge_lengths(mesh))) / mesh.GetLength() if mesh.GetLength() > 0 else 0.0
    if share <= LARGE:
        return []
    return [
        f"triangles are large (half of the edges are longer than {100 * share:.0f} % of the "
        "diagonal): isolines and colors are accurate at points, and approximate between them"
    ]
