# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Replacements for potpourri3d, pygeodesic and gdist with the same names and arguments. Only the
imports change::

    import vtkdgg.compat.potpourri3d as pp3d
    import vtkdgg.compat.pygeodesic.geodesic as geodesic
    import vtkdgg.compat.gdist as gdist

Every public name of the original exists. Functions without a counterpart raise a
NotImplementedError that names an alternative. Wrong input raises a ValueError or a VTKError,
whatever the original does.
"""

from .gdist import compute_gdist, distance_matrix_of_selected_points, local_gdist_matrix
from .potpourri3d import (
    EdgeFlipGeodesicSolver,
    MeshHeatMethodDistanceSolver,
    compute_distance,
    compute_distance_multisource,
)
from .pygeodesic.geodesic import PyGeodesicAlgorithmExact, read_mesh_from_file

# Names of version 1.0
__all__ = [
    "EdgeFlipGeodesicSolver",
    "MeshHeatMethodDistanceSolver",
    "PyGeodesicAlgorithmExact",
    "compute_distance",
    "compute_distance_multisource",
    "compute_gdist",
    "distance_matrix_of_selected_points",
    "local_gdist_matrix",
    "read_mesh_from_file",
]
