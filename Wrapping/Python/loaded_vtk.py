# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Check that the package was built with the loaded VTK. With another VTK, the first object would
crash."""

import os
import re

import vtkmodules
from vtkmodules.vtkCommonCore import vtkVersion

from . import build_info


def require():
    """Raises an ImportError if another VTK is loaded."""
    version = f"{vtkVersion.GetVTKMajorVersion()}.{vtkVersion.GetVTKMinorVersion()}"
    library = _library()
    if version == build_info.VTK_VERSION and library in (None, build_info.VTK_LIBRARY):
        return
    raise ImportError(
        f"vtkdgg {build_info.VERSION} was built with VTK {build_info.VTK_VERSION} "
        f"({build_info.VTK_LIBRARY}), but loaded is VTK {version} ({library or 'of unknown name'}) "
        f"of {os.path.dirname(vtkmodules.__file__)}. Run the Python that VTK "
        f"{build_info.VTK_VERSION} belongs to, or build vtkDGG with the VTK that is loaded: cmake "
        "-DVTK_DIR=<its folder with vtk-config.cmake>. For ParaView, build and load the plugin."
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
