# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Helpers of the replacement modules."""

from __future__ import annotations

from typing import Any, Callable, NoReturn

import numpy as np

from .. import arguments
from ..distances import field_of, set_sources
from ..errors import run


def missing(name: str, remedy: str) -> Callable[..., NoReturn]:
    """Returns a stand-in for a function, method or class that vtkDGG does not have."""

    def refuse(*_: Any, **__: Any) -> NoReturn:
        raise NotImplementedError(f"{name} is not available. {remedy}")

    refuse.__name__ = refuse.__qualname__ = name
    refuse.__doc__ = f"Not available. {remedy}"
    return refuse


def find_distances(solver, sources, max_distance=np.inf, initial_distances=None):
    """Returns distances, infinite where unreached, and the index of the nearest source."""
    sources = arguments.surface_points(sources, "sources", solver.GetInput())
    set_sources(solver, sources, initial_distances)
    solver.SetMaximumDistance(arguments.limit(max_distance, "max_distance"))
    solver.SetUnreachedValue(np.inf)
    solver.GenerateNearestSourceOn()
    run(solver)
    return field_of(solver, True)


def vertices(indices, name, count):
    """Returns vertex indices as a list, after a check."""
    indices = arguments.numbers(indices, name, "integer").ravel()
    arguments.check_ids(indices, count, name)
    return indices.tolist()
