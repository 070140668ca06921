# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Computes distances on a mesh within an accuracy by a graph, and measures their errors against
exact distances. Prints a table, and writes distance.vtp, distance.png and error.png. For a point
cloud, computes distances and the path to the farthest point."""

import sys
import time
import warnings

from .. import reading
from . import files, places
from .output import print_table

DEFAULT_MESH = "/usr/share/glmark2/models/bunny.obj"
DEFAULT_ACCURACY = 0.01


def add_arguments(parser, shared):
    """Adds the arguments of the command to a parser. `shared` are options of several commands."""
    parser.add_argument(
        "mesh",
        nargs="?",
        default=DEFAULT_MESH,
        help=f"{' '.join(reading.EXTENSIONS)} (default: %(default)s)",
    )
    parser.add_argument(
        "--source",
        metavar=places.POINT,
        help="source of the distances: a point id, coordinates on the surface, or a face with "
        "barycentric coordinates (default: the point farthest from the center of the mesh)",
    )
    parser.add_argument("--tolerance", **{**shared["tolerance"], "default": 0.01})
    parser.add_argument(
        "--accuracy",
        type=float,
        metavar="E",
        help="largest relative error of a distance on a mesh, 1e-6 to 0.5 "
        f"(default: {DEFAULT_ACCURACY})",
    )
    parser.add_argument("--merge", **shared["merge"])
    parser.add_argument("--cloud", **shared["cloud"])
    parser.add_argument(
        "--methods",
        action="store_true",
        help="compare the errors of all methods: a table, and methods.png with maps and histograms",
    )
    parser.add_argument(
        "--out", metavar="DIR", default="out", help="folder of the results (default: ./%(default)s)"
    )


def run(options):
    """Runs the command, and returns its exit code: 1 if a bound or the accuracy is violated."""
    start = time.perf_counter()
    contents = reading.read(options.mesh)
    read_time = time.perf_counter() - start
    if options.cloud or files.is_cloud(contents):
        files.refuse_on_clouds(options, "accuracy", "merge", "methods")
        from .compare_cloud import on_cloud as compare  # rendering takes long to import
    else:
        from .compare_mesh import on_mesh as compare
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        rows, notes, violations = compare(options, contents, read_time)
    print_table(rows, notes, caught)
    for violation in violations:
        print(f"error: {violation}", file=sys.stderr)
    return 1 if violations else 0
