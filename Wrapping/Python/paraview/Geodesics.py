# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""All filters as a plugin for ParaView, which loads this file: Tools > Manage Plugins > Load New.

With the environment variable PV_PLUGIN_PATH, ParaView loads every file in a folder: no other file
may be in this one."""

import importlib.util
import pathlib
import sys
from types import SimpleNamespace

_FOLDER = pathlib.Path(__file__).resolve().parents[1]


def _import_package():
    """Imports the package that this file belongs to. Other packages beside it, such as another
    NumPy, remain hidden from ParaView."""
    if "vtkdgg" in sys.modules:
        return
    files = {"submodule_search_locations": [str(_FOLDER)]}
    spec = importlib.util.spec_from_file_location("vtkdgg", _FOLDER / "__init__.py", **files)
    sys.modules["vtkdgg"] = package = importlib.util.module_from_spec(spec)
    try:
        spec.loader.exec_module(package)
    except ImportError as error:  # for which ParaView would try another way to import this file
        del sys.modules["vtkdgg"]
        found = [file.name for file in _FOLDER.glob("_kernel*")]
        raise RuntimeError(
            f"vtkdgg cannot be imported: {error}. ParaView uses Python {sys.version.split()[0]}, "
            f"and {_FOLDER} contains {found}. Install vtkdgg with this version of Python."
        ) from error


_import_package()

from vtkdgg import __version__, python_filters  # noqa: E402
from vtkdgg.paraview_xml import configuration  # noqa: E402
from vtkdgg.property_table import TABLE  # noqa: E402

# ParaView reads the name, the version, and `_pvsm_proxy_xml` of any variable.
paraview_plugin_name = "Geodesics"
paraview_plugin_version = __version__
filters = SimpleNamespace(_pvsm_proxy_xml=configuration(TABLE, python_filters.__name__))
