# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Classes for the VTK that is loaded: the compiled ones if they were built with it, otherwise Python
filters. With another VTK, the first compiled object would crash."""

import contextlib
import importlib
import os
import re

import vtkmodules
from vtkmodules.vtkCommonCore import vtkVersion

from . import build_info
from .property_table import TABLE


def find_class(name):
    """Returns a class by its name. Readers and writers exist as compiled classes only."""
    problem = _problem()
    if not problem and name in build_info.CLASSES:
        with contextlib.suppress(ModuleNotFoundError):  # VTK was built without MPI
            importlib.import_module("._parallel", __package__)
        module = importlib.import_module(f".{build_info.CLASSES[name]}", __package__)
        return getattr(module, name)
    if name in TABLE:
        from . import python_filters

        return python_filters.get(name)
    raise ImportError(f"{name} cannot be used: {problem}")


def served_classes():
    """Returns the names of the classes that find_class() returns."""
    return {*TABLE, *(() if _problem() else build_info.CLASSES)}


def _problem():
    """Returns a text if another VTK is loaded than the one that the package was built with."""
    version = f"{vtkVersion.GetVTKMajorVersion()}.{vtkVersion.GetVTKMinorVersion()}"
    library = _library()
    if version == build_info.VTK_VERSION and library in (None, build_info.VTK_LIBRARY):
        return ""
    return (
        f"vtkdgg {build_info.VERSION} was built with VTK {build_info.VTK_VERSION} "
        f"({build_info.VTK_LIBRARY}), but loaded is VTK {version} ({library or 'of unknown name'}) "
        f"of {os.path.dirname(vtkmodules.__file__)}. Use vtkdgg.read and vtkdgg.write, run the "
        f"Python that VTK {build_info.VTK_VERSION} belongs to, or build vtkDGG with the VTK that is "
        "loaded: cmake -DVTK_DIR=<its folder with vtk-config.cmake>."
    )


def _library():
    """Returns the name of VTK's core library in this process, None if the system hides the name.
    Builds of one version differ, such as that of ParaView, and two in one process conflict."""
    try:
        with open("/proc/self/maps", encoding="utf-8", errors="replace") as maps:
            found = re.search(r"/(libvtkCommonCore[^/\n]*)\.so", maps.read())
    except OSError:
        return None
    return found and found[1]
