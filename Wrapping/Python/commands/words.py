# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Words of tables and of the explorer."""

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


def in_options(text):
    """What a filter says, with the options of the command beside its properties."""
    for words, option in (
        ("raise ProjectionTolerance", "--tolerance"),
        ("turn MergeCoincidentPoints on", "--merge"),
    ):
        text = text.replace(words, f"{words} ({option})")
    return text
