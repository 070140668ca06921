# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Words of tables and of the explorer."""

import re

from ..errors import in_arguments

# Of the window of the explorer.
HELP = """click: source of the distances, then the end of a path, then the corner of a loop
drag: move what is there; beside the surface, or with Ctrl, turn the camera
middle button, wheel: move the camera, zoom
m: method (graph, exact, fast)
+ and -: accuracy of the graph
e: errors against exact distances
v: Voronoi cells, of one more source with each click
g: Green's function
c: clear
r: all in view
s: screenshot
h: this help
q: quit"""


def counted(count, one, many=None):
    """A count and what is counted, in the singular or the plural."""
    return f"{count} {one if count == 1 else many or one + 's'}"


# What functions call the options of the command.
ARGUMENTS = {
    "first": "--first",
    "iterations": "--iterations",
    "maximum_distance": "--maximum",
    "number_of_samples": "--number",
    "projection_tolerance": "--tolerance",
    "values": "--values",
}


def in_options(text):
    """What a filter or a function says, in the options of the command."""
    text = in_arguments(re.sub(r"\Avtk\w+: ", "", text))
    name, colon, said = text.partition(": ")
    text = ARGUMENTS.get(name, name) + colon + said
    for words, option in (
        ("raise ProjectionTolerance", "--tolerance"),
        ("turn MergeCoincidentPoints on", "--merge"),
        ("points: a rope needs some", "--through"),
    ):
        text = text.replace(words, f"{words} ({option})")
    return text
