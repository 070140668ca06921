# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Texts of tables and of the explorer, and messages in terms of the options of the shell."""

import re

from ..errors import in_arguments

# Help of the explorer.
HELP = """click: source of the distances, then the end of a path, then the corner of a loop
drag: move a marker; beside the surface, or with Ctrl, turn the camera
middle button, wheel: move the camera, zoom
m: method (graph, exact, fast)
+ and -: accuracy of the graph
e: errors against exact distances
v: Voronoi cells; each click adds a source
g: Green's function
c: clear
r: all in view
s: screenshot
x: export what is shown (.vtp, .csv)
h: this help
q: quit"""


def counted(count, one, many=None):
    """Returns a count with its unit in the singular or the plural."""
    return f"{count} {one if count == 1 else many or one + 's'}"


# Patterns of words in messages of filters and functions, and their replacements in the shell.
IN_OPTIONS = {
    r"\bvtk(?!dgg)\w+: ": "",
    r"\Apoints: expected points for a rope": "--through: expected points for a rope",
    r"\bset merge_coincident_points=True(?:, and a merge_tolerance of [\d.e-]*\d)?": "add --merge",
    r"\bmerge_coincident_points may join them": "--merge may join them",
    r"\bgive an accuracy\b": "give an --accuracy",
    r", or turn InFaces on": "",
    r'method="exact" or "graph"': "--method exact or --method graph",
    r"\bGetMeanAnisotropy\(\)": "the mean anisotropy",
    r"Use vtkExactGeodesicDistance with GenerateWindowsOn\(\)": "Use --method exact",
    r", or Radius too small": "",
    r", or set Radius": "",
    r"\buse Neumann conditions": "use --boundary Neumann",
    r"\bthe method 'graph'": "--method graph",
    r", or (?:set )?a higher memory_limit": "",
    r"\b(larger|and) accuracy\b": r"\1 --accuracy",
    r"\bcall Set(\w+)\(\) with": r"set \1 to",
}
# Properties of filters and arguments of functions, and the options that set them.
OPTIONS = {
    "Accuracy": "--accuracy",
    "MergeCoincidentPoints": "--merge",
    "NumberOfIterations": "--iterations",
    "maximum_distance": "--maximum",
    "number_of_samples": "--number",
    "projection_tolerance": "--tolerance",
}
# Options and arguments of the same name that are also common words: replaced in front only.
FIRST_WORDS = ("accuracy", "first", "iterations", "values")


def in_options(text):
    """Returns a message of a filter or a function in terms of the options of the shell."""
    text = in_arguments(text)
    for pattern, words in IN_OPTIONS.items():
        text = re.sub(pattern, words, text)
    text = re.sub(rf"\b({'|'.join(OPTIONS)})\b", lambda match: OPTIONS[match[1]], text)
    first, colon, rest = text.partition(": ")
    return ("--" if first in FIRST_WORDS else "") + first + colon + rest


def notes_of(caught):
    """Returns the texts of warnings, each once: every filter reports defects of the input."""
    return list(dict.fromkeys(in_options(str(warning.message)) for warning in caught))
