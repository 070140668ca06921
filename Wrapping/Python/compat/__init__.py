# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Names and arguments of other packages, answered by this one. Existing code changes its import::

    import vtkdgg.compat.potpourri3d as pp3d
    import vtkdgg.compat.pygeodesic.geodesic as geodesic
    import vtkdgg.compat.gdist as gdist

Every public name of the original exists. What vtkDGG cannot answer raises a NotImplementedError
that names the remedy. Wrong input raises a ValueError or a VTKError, whatever the original does.
"""

from .gdist import compute_gdist, distance_matrix_of_selected_points, local_gdist_matrix
from .potpourri3d import (
    EdgeFlipGeodesicSolver,
    MeshHeatMethodDistanceSolver,
    compute_distance,
    compute_distance_multisource,
)
from .pygeodesic.geodesic import PyGeodesicAlgorithmExact, read_mesh_from_file

# These names were here before each package had its submodule.
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
