# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Geodesic distances on meshes and point clouds.

`read`, `write`, `Mesh`
    files, and a mesh in NumPy arrays,
`distance`, `path`
    on a mesh, in one call,
`Graph`, `CloudGraph`
    for many calls: a graph of a mesh or cloud is built once; distances, paths and more then take
    milliseconds,
`probe`
    distances at points anywhere on a mesh,
`patch_boundaries`
    the same layout of curves on two meshes,
`greens_function`, `biharmonic`, `earth_movers`, `interpolate`, `vector_graphics`
    functions based on the Laplacian of a mesh,
`show_progress`
    turns progress bars on or off,
`vtkdgg.distributed`
    matrices of distances on a Dask cluster,
`vtkdgg.compat`
    functions and classes with the names and arguments of other packages, one submodule for each.

With VTK there are also the filters (``from vtkdgg import vtkExactGeodesicDistance``), and

`check`
    update an algorithm; a VTK error becomes a Python exception, a `VTKError`,
`vtkdgg.explorer`
    a window to explore a mesh or cloud by clicks and drags,
`vtkdgg.pictures`
    colors of distances and errors, actors of clouds, tubes and markers.
"""

import importlib
import importlib.util

from .build_info import CLASSES
from .build_info import VERSION as __version__  # noqa: F401
from .cloud_graph import CloudGraph
from .distances import distance, probe
from .errors import Error, VTKError, needing_vtk
from .graph import Graph
from .graphics import vector_graphics
from .layouts import patch_boundaries
from .mesh import Mesh
from .paths import NotConnectedError, path
from .progress import show_progress
from .property_table import TABLE
from .reading import read
from .results import EarthMovers, Isoline, Loop, PatchBoundary, Path, Samples, Voronoi
from .spectral import biharmonic, earth_movers, greens_function, interpolate
from .writing import write

# Objects that need VTK, which are imported on first use.
_OF_VTK = {"check", *CLASSES, *TABLE}
_WITHOUT_VTK = [
    "CloudGraph",
    "EarthMovers",
    "Error",
    "Graph",
    "Isoline",
    "Loop",
    "Mesh",
    "NotConnectedError",
    "PatchBoundary",
    "Path",
    "Samples",
    "VTKError",
    "Voronoi",
    "biharmonic",
    "distance",
    "earth_movers",
    "greens_function",
    "interpolate",
    "patch_boundaries",
    "path",
    "probe",
    "read",
    "show_progress",
    "vector_graphics",
    "write",
]


def __getattr__(name):
    if name == "__all__":
        return _WITHOUT_VTK + _served()
    if name in ("compat", "distributed", "explorer", "pictures"):
        return importlib.import_module(f".{name}", __name__)
    if name not in _OF_VTK:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    with needing_vtk(f"vtkdgg.{name}"):
        if name == "check":
            from .pipeline import check as found
        else:
            from .loaded_vtk import find_class

            found = find_class(name)
    globals()[name] = found
    return found


def __dir__():
    return sorted({*globals(), *_WITHOUT_VTK, *_served()})


def _served():
    """Returns the names of the objects that need VTK and that the VTK found here serves."""
    if importlib.util.find_spec("vtkmodules") is None:
        return []
    from .loaded_vtk import served_classes

    return sorted({"check", *served_classes()})
