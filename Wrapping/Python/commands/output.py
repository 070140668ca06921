# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tables that commands print, and rows that the comparisons of meshes and clouds share."""

import numpy as np

from .. import _kernel
from ..checks import counted
from .words import notes_of


def print_table(rows, notes, warnings):
    """Prints rows, then notes and the warnings of filters, each once."""
    width = max([12, *(len(key) for key, _ in rows)])
    for key, value in rows:
        print(f"{key:<{width}} {value}")
    for note in [*notes, *notes_of(warnings)]:
        print(f"{'note':<{width}} {note}")


def defects(others, *counts):
    """Returns a line of the positive counts, each with its unit as for counted(), and of others."""
    return ", ".join([*(counted(*count) for count in counts if count[0]), *others]) or "none"


def position(location, point=None):
    """Returns coordinates as text, after the id of the point if the location is one."""
    text = "(" + ", ".join(f"{x:.6g}" for x in location) + ")"
    return f"point {point} at {text}" if isinstance(point, int) else text


def graph_rows(graph, build_time, query, more=""):
    """Returns rows on the size of a graph, followed by the text `more`, and on times."""
    size = graph._graph.memory_size / 1e6
    threads = counted(_kernel.get_number_of_threads(), "thread")
    return (
        ("build", f"{build_time:.3f} s on {threads}"),
        (
            "graph",
            f"degree {graph.degree:.1f}, {len(graph.targets)} edges, {size:.1f} MB{more}",
        ),
        (
            "query",
            f"{1e3 * query.time:.1f} ms for all distances "
            f"(the first: {1e3 * query.first_time:.1f} ms)",
        ),
    )


def distance_rows(distances, unit):
    """Returns rows on the number of reached points, in a unit, and on the largest distance."""
    reached = np.isfinite(distances)
    return (
        ("reached", f"{reached.sum()} of {reached.size} {unit}"),
        ("range", f"0 to {np.nanmax(np.append(distances, 0.0)):.6g} model units"),
    )
