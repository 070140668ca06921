# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""The graph in the field data of a surface: how it was built, and whether functions use it."""

from . import _kernel, arguments
from .errors import call

PREFIX = "DGG."


def arrays_of(field_data):
    """Returns the arrays of a graph, which may be damaged, as read-only views by name."""
    found = {}
    for name, values in field_data.items():
        if name.startswith(PREFIX):
            found[name] = values.view()
            found[name].flags.writeable = False
    return found


def find_info(field_data):
    """Returns the parameters of the graph in field data; None without readable ones."""
    try:
        return _kernel.graph_info(arrays_of(field_data))
    except _kernel.Error:
        return None


def options_like(info):
    """Returns the options that build a graph like the one with these parameters; {} without one of
    a mesh."""
    if info is None or info.is_cloud:
        return {}
    names = ("construction", "accuracy", "number_of_neighbors")
    return {"accept_coarser_graph": True, **{name: getattr(info, name) for name in names}}


def find_or_build(surface, prepared, accuracy, info):
    """Returns the graph on a surface. Without a usable one, returns a graph of the given accuracy,
    or else like the one on the surface."""
    options = options_like(info) if accuracy is None else {"accuracy": accuracy}
    return call(_kernel.Graph, prepared, stored=arrays_of(surface.field_data), **options)


def choose_method(method, accuracy, surface, methods):
    """Returns the method, and the parameters of the graph on the surface if the method uses it.

    By default a graph is used if the surface has one or an accuracy is given.
    """
    info = find_info(surface.field_data)
    if method is None:
        # A graph that cannot be used causes a warning.
        has_graph = bool(arrays_of(surface.field_data))
        method = "graph" if accuracy is not None or has_graph else "exact"
    if not isinstance(method, str) or method not in methods:
        raise ValueError(f"method: expected one of {', '.join(map(repr, methods))}, got {method!r}")
    if accuracy is not None and method != "graph":
        raise ValueError(f"accuracy: applies to `method` 'graph' only, got {method!r}")
    if accuracy is not None and info is not None and info.is_cloud:
        raise ValueError(
            "accuracy: applies to meshes, not to point clouds; vtkdgg.CloudGraph(points, "
            "accuracy=...) builds a graph with less pruning"
        )
    return method, info if method == "graph" else None


def merging(is_merged, tolerance, info=None):
    """Returns how points are merged: as given, or else as in the graph with these parameters."""
    tolerance = arguments.number(tolerance, "merge_tolerance")
    if info is not None and info.merge_coincident_points and not is_merged:
        return True, info.merge_tolerance
    return is_merged, tolerance
