# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Texts of tables and of the explorer, and messages in terms of the options of the shell."""

import re

from ..errors import render

# Help of the explorer.
HELP = """click: source of the distances, then the end of a path, then the corner of a loop
drag: move a marker; beside the surface, or with Ctrl, rotate the camera
middle button, wheel: move the camera, zoom
m: method (graph, exact, fast)
+ and -: accuracy of the graph
e: errors relative to exact distances
v: Voronoi cells; each click adds a source
g: Green's function
c: clear
r: all in view
s: screenshot
x: export what is shown (.vtp, .csv)
h: this help
q: quit"""

# Arguments of functions, and the options that set them.
OPTIONS = {
    "accuracy": "--accuracy",
    "boundary": "--boundary",
    "first": "--first",
    "in_faces": "--in-faces",
    "iterations": "--iterations",
    "maximum_distance": "--maximum",
    "merge_coincident_points": "--merge",
    "method": "--method",
    "number_of_samples": "--number",
    "projection_tolerance": "--tolerance",
    "values": "--values",
}


def in_options(text):
    """Returns a message of a filter or a function with options in place of arguments, which are in
    backticks or in front. The name of the filter is removed."""
    text = re.sub(r"\bvtk(?!dgg)\w+: ", "", text)
    return render(text, lambda name: OPTIONS.get(name, name), "of the file")


def notes_of(caught):
    """Returns the texts of warnings, each once: every method reports defects of the input."""
    return list(dict.fromkeys(in_options(str(warning.message)) for warning in caught))
