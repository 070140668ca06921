# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Geodesics on meshes and point clouds, from the shell.

Exit codes: 0, success; 1, no result exists, or an error bound is violated; 2, wrong input or usage;
130, interrupted.
"""

import argparse
import difflib
import errno
import functools
import json
import os
import re
import shutil
import sys
import textwrap
import warnings

from . import _kernel, build_info, reading, writing
from .checks import counted
from .commands import answers, compare, files, places
from .commands.output import print_table
from .commands.words import HELP, in_options, notes_of
from .errors import Error, needing_vtk

EXAMPLES = """examples:
  vtkdgg info mesh.ply
  vtkdgg distance mesh.ply --source 0 --source 1.5,2,0 --out distance.vtp
  vtkdgg matrix mesh.ply --sources 0,5,9 --out matrix.csv
  vtkdgg path mesh.ply 0 1000 --out path.vtp
  vtkdgg isolines mesh.ply --source 0 --count 20 --accuracy 0.001 --out isolines.vtp
  vtkdgg voronoi mesh.ply --number 50 --iterations 10 --out cells.vtp
  vtkdgg render mesh.ply --source 0 --out picture.png
  vtkdgg explore mesh.ply
  vtkdgg compare mesh.ply --accuracy 0.01 --out folder"""
# Holds for most kinds of output.
KEEPS = "; .vtk and .vtp keep all arrays"
# Commands that need a display, which may be a virtual one.
DRAWING = ("compare", "render")


def version():
    """Returns the version and the build options in one line."""
    vtk = f"VTK {build_info.VTK_VERSION}, " * bool(build_info.VTK_VERSION)
    threads = counted(_kernel.get_number_of_threads(), "thread")
    clouds = "with" if hasattr(_kernel, "cloud_graph") else "without"
    return f"vtkdgg {build_info.VERSION}, {vtk}{threads}, {clouds} point clouds"


class Parser(argparse.ArgumentParser):
    """Reports errors as the rest of the program does: one line, exit code 2."""

    def error(self, message):
        message = message.removeprefix("argument ")
        raise ValueError(f"{message} (--help explains)")


def numbers(text):
    """Returns the numbers of a list with commas."""
    return [float(word) for word in text.split(",")]


# Options of several commands.
OPTIONS = {
    "source": {
        "action": "append",
        "metavar": places.POINT,
        "help": "source of the distances: a point id, coordinates on the surface, or "
        "face:ID:B0,B1,B2 with barycentric coordinates; may be repeated",
    },
    "sources": {"metavar": "ID,ID,...", "help": "point ids of several sources"},
    "source-file": {
        "metavar": "FILE",
        "help": "sources from a text file, one per line, with commas or blanks between coordinates",
    },
    "accuracy": {
        "type": float,
        "metavar": "E",
        "help": "largest relative error, 1e-6 to 0.5 (default: that of the graph in the file; else "
        "exact, and 0.01 where a graph is needed)",
    },
    "merge": {
        "action": "store_true",
        "help": "treat points of a mesh with equal coordinates as one (texture seams)",
    },
    "tolerance": {
        "type": float,
        "metavar": "T",
        "help": "largest distance of X,Y,Z from the surface, as a fraction of the diagonal "
        "(default: 0.01)",
    },
    "cloud": {"action": "store_true", "help": "use only the points, even of a mesh"},
    "json": {
        "action": "store_true",
        "help": "print the answer as JSON, in which null is an infinite or missing number",
    },
}


def make_parser():
    """Returns the parser of all commands and their options."""
    parser = Parser(
        prog="vtkdgg",
        description=__doc__,
        epilog=EXAMPLES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("--version", action="version", version=version())
    commands = parser.add_subparsers(dest="command", metavar="command", required=True)
    parser.commands = commands.choices

    def add(run, *shared, out="values at points", keeps=KEEPS, needs_out=False, example=""):
        name = run.__name__
        command = commands.add_parser(
            name,
            help=run.__doc__.rstrip("."),
            description=run.__doc__,
            epilog=f"example:\n  vtkdgg {name} mesh.ply {example}",
            formatter_class=argparse.RawDescriptionHelpFormatter,
        )
        command.add_argument("file", help=" ".join(reading.EXTENSIONS))
        if "source" in shared:
            shared = ("source", "sources", "source-file", *shared[1:])
        for option in (*shared, "cloud", "json"):
            command.add_argument(f"--{option}", **OPTIONS[option])
        if out:
            said = f"write {' '.join(writing.FORMATS[out])}{keeps}"
            check = functools.partial(files.writable, kind=out)
            command.add_argument("--out", metavar="FILE", required=needs_out, type=check, help=said)
        command.set_defaults(run=run)
        return command

    built = ("accuracy", "merge")
    values = "values at points"
    placed = (*built, "tolerance")
    add(answers.info, out="")
    add(answers.graph, *built, out="a graph", keeps="", example="--accuracy 0.001 --out graph.vtp")
    command = add(
        answers.distance, "source", *placed, out=values, example="--source 0 --out distance.vtp"
    )
    command.add_argument(
        "--method",
        choices=answers.METHODS,
        help="graph: within --accuracy; fast: virtual sources, no bound; marching: fast marching, "
        "no bound, also on clouds (default: graph with --accuracy, on clouds and where the file "
        "has one, else exact)",
    )
    command.add_argument("--maximum", type=float, metavar="D", help="stop at this distance")
    tabled = {"out": "a matrix", "keeps": "", "needs_out": True}
    listed = "--sources 0,5,9 --out matrix.csv"
    command = add(answers.matrix, "source", *placed, **tabled, example=listed)
    command.add_argument(
        "--targets",
        metavar="ID,ID,...",
        help="point ids of the columns (default: the sources; the matrix is symmetric)",
    )
    command = add(answers.path, *placed, out="curves", example="0 1000 --out path.vtp")
    command.add_argument(
        "--method",
        choices=answers.METHODS[:2],
        help="default: graph with --accuracy, on clouds and where the file has one, else exact",
    )
    for name in ("start", "end"):
        command.add_argument(name, metavar=places.POINT, help=f"{name} of the path")
    command = add(answers.loop, *placed, out="curves", example="--through 0 --taut --out loop.vtp")
    command.add_argument(
        "--through",
        action="append",
        metavar=places.POINT,
        help="a loop through this point; may be repeated (default: loops around handles)",
    )
    command.add_argument("--rope", action="store_true", help="one loop through all points")
    command.add_argument("--taut", action="store_true", help="pull the loops tight")
    lines = "--source 0 --count 20"
    command = add(answers.isolines, "source", *placed, out="curves", example=lines)
    command.add_argument(
        "--method",
        choices=answers.METHODS[:2],
        help="exact: accurate also inside long triangles (default: graph)",
    )
    which = command.add_mutually_exclusive_group()
    which.add_argument("--values", type=numbers, metavar="D,D,...", help="distances of the isolines")
    which.add_argument("--every", type=float, metavar="D", help="multiples of one distance")
    which.add_argument("--count", type=int, help="number of isolines (default: 10)")
    cells = "--number 50 --iterations 10 --out cells.vtp"
    command = add(answers.voronoi, *placed, example=cells)
    command.epilog += (
        "\n\n.csv, .npy and files of clouds contain the nearest site of each point; .ply, .vtk and "
        ".vtp\nfiles of meshes contain the cells. Cells do not fit into .pcd."
    )
    which = command.add_mutually_exclusive_group()
    which.add_argument("--site", action="append", metavar=places.POINT, help="a site")
    which.add_argument("--number", type=int, help="number of sites, spread evenly (default: 20)")
    command.add_argument("--in-faces", action="store_true", help="these inside triangles, too")
    command.add_argument(
        "--iterations",
        type=int,
        default=0,
        help="number of times that sites move to the centers of their cells (default: 0)",
    )
    points = "--number 500 --out samples.vtp"
    command = add(answers.sample, *built, out="points", example=points)
    command.add_argument("--number", type=int, required=True, help="number of samples")
    command.add_argument("--first", type=int, default=0, metavar="ID", help="first sample")
    command.add_argument("--in-faces", action="store_true", help="samples inside triangles, too")
    command = add(answers.greens, "source", "merge", "tolerance", out=values, example="--source 0")
    methods = ("SingularitySubtraction", "Localized", "Interpolated", "Vertex")
    command.add_argument("--method", choices=methods, default=methods[0])
    command.add_argument("--boundary", choices=("Neumann", "Dirichlet"), default="Neumann")
    drawn = "--source 0 --out picture.png"
    drawing = {"out": "a picture", "keeps": "", "needs_out": True}
    command = add(answers.render, "source", *placed, **drawing, example=drawn)
    command.add_argument(
        "--view",
        metavar="NAME|X,Y,Z",
        help="front, back, left, right, top, bottom or a direction to look from (default: the one "
        "that shows most of the surface, and the source)",
    )
    command.add_argument(
        "--array",
        default="GeodesicDistance",
        help="a point array; one that ends in Distance has isolines (default: %(default)s)",
    )
    numbered = {"out": "a picture", "keeps": ", numbered"}
    command = add(answers.explore, *built, **numbered, example="--source 0")
    command.epilog += "\n\nin the window:\n" + textwrap.indent(HELP, "  ")
    command.add_argument(
        "--source",
        metavar=places.POINT,
        help="first source (default: the point farthest from the center)",
    )
    command = commands.add_parser(
        "compare",
        help="Compare methods: their errors, times and pictures",
        description=compare.__doc__,
    )
    compare.add_arguments(command, OPTIONS)
    command.set_defaults(run=compare.run)
    command = commands.add_parser("paraview", help=paraview.__doc__, description=paraview.__doc__)
    command.set_defaults(run=paraview)
    return parser


def paraview(_options):
    """Print the file of the plugin for ParaView and how to load the file"""
    file = os.path.join(os.path.dirname(os.path.abspath(__file__)), "paraview", "Geodesics.py")
    print(f"""{file}

In ParaView: Tools > Manage Plugins > Load New, and select this file. In pvpython and pvbatch:
  from paraview.simple import *
  LoadPlugin({file!r}, remote=False, ns=globals())
The version of ParaView's Python must be {sys.version_info.major}.{sys.version_info.minor}.""")
    return 0


def said_with(found):
    """Returns an answer as rows of a table."""

    def text(value):
        if isinstance(value, float):
            return f"{value:.8g}"
        if value is None:
            return "none"
        if isinstance(value, list):
            return ", ".join(map(text, value)) or "none"
        return str(value)

    return [(key, text(value)) for key, value in found.items()]


def check_names(parser, arguments):
    """Raises an error for a command or an option that does not exist, with the most similar one."""

    def closest(name, known):
        words = {word.lstrip("-"): word for word in known}
        found = difflib.get_close_matches(name.lstrip("-"), words, 1)
        return f"; did you mean {words[found[0]]}?" if found else " (--help explains)"

    name = arguments[0]
    if name.startswith("-"):
        known, words = parser._option_string_actions, arguments[:1]
    elif name in parser.commands:
        known, words = parser.commands[name]._option_string_actions, arguments[1:]
    else:
        raise ValueError(f"unknown command {name}{closest(name, parser.commands)}")
    for option in (word.partition("=")[0] for word in words):
        if option.startswith("--") and not any(other.startswith(option) for other in known):
            raise ValueError(f"unknown option {option}{closest(option, known)}")


def answer(options):
    """Runs a command that answers a question, and prints the answer."""
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        found = options.run(options)
    if options.json:
        text = json.dumps({**found, "warnings": notes_of(caught)})
        found = json.loads(text, parse_constant=lambda _: None)  # JSON has no NaN and no infinity
        print(json.dumps(found, indent=2))
    else:
        print_table(said_with(found), [], caught)
    return 0


def restart_with_display(arguments):
    """Replaces this process by the same command with a virtual display."""
    if shutil.which("xvfb-run") is None:
        raise ValueError("there is no display to draw with, and no xvfb-run to make one")
    packages = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
    known = [packages, *filter(None, [os.environ.get("PYTHONPATH")])]
    screen = ["xvfb-run", "-a", "-s", "-screen 0 1920x1440x24 -noreset"]
    os.execvpe(
        screen[0],
        [*screen, sys.executable, "-m", "vtkdgg", *arguments],
        {**os.environ, "PYTHONPATH": os.pathsep.join(known)},
    )


def reason_of(problem):
    """Returns the text of an exception; for an error of the system, file and reason."""
    if not isinstance(problem, OSError) or problem.errno is None:
        return str(problem)
    is_missing = problem.errno == errno.ENOENT
    return f"{problem.filename}: {'no such file' if is_missing else problem.strerror}"


def main(arguments=None):
    """Runs the command in this process, and returns its exit code. Drawing needs a display."""
    return _run(sys.argv[1:] if arguments is None else list(map(str, arguments)))


def script():
    """Runs the command as a program, and returns its exit code. Without a display, a command that
    draws replaces the process by one with a virtual display."""
    return _run(sys.argv[1:], restart_with_display)


def _run(arguments, restart=None):
    """Runs the command, and returns its exit code. `restart`, if any, is called with the arguments
    when a display is missing."""
    try:
        parser = make_parser()
        if not arguments:
            parser.print_help()
            return 2
        check_names(parser, arguments)
        # argparse takes coordinates with a minus sign for an option unless a blank precedes them.
        options = parser.parse_args([re.sub(r"^-(?=[\d.])", " -", a) for a in arguments])
        if options.command in DRAWING:
            if sys.platform == "linux" and not os.environ.get("DISPLAY"):
                if restart is None:
                    raise ValueError("there is no display to draw with; set DISPLAY")
                restart(arguments)
        prints = options.command in ("compare", "paraview")
        with needing_vtk(f"vtkdgg {options.command}"):
            code = options.run(options) if prints else answer(options)
        sys.stdout.flush()
        return code
    except BrokenPipeError:  # the reader of a pipe has closed it
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 0
    except answers.Negative as reason:
        print(f"no answer: {in_options(str(reason))}", file=sys.stderr)
        return 1
    except (ValueError, Error, ImportError, OSError) as problem:
        print(f"error: {in_options(' '.join(reason_of(problem).split()))}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        print("interrupted", file=sys.stderr)
        return 130
