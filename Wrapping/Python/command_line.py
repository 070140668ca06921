# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""The command ``vtkdgg``."""

import argparse

from vtkmodules.vtkCommonCore import vtkSMPTools, vtkVersion

from . import build_info


def version():
    """What is there, in one line."""
    threads = vtkSMPTools.GetEstimatedNumberOfThreads()
    clouds = "with" if build_info.HAS_POINT_CLOUDS else "without"
    return (
        f"vtkdgg {build_info.VERSION}, VTK {vtkVersion.GetVTKVersion()}, {threads} threads "
        f"({vtkSMPTools.GetBackend()}), {clouds} point clouds"
    )


def main(arguments=None):
    """Run it; the exit code."""
    parser = argparse.ArgumentParser(prog="vtkdgg", description="Geodesics on meshes and clouds.")
    parser.add_argument("--version", action="version", version=version())
    parser.parse_args(arguments)
    parser.print_help()
    return 0
