# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Helpers of the replacement modules."""

from __future__ import annotations

from typing import Any, Callable, NoReturn

import numpy as np

from .. import arguments
from ..distances import field_of, field_options
from ..errors import call


def missing(name: str, remedy: str) -> Callable[..., NoReturn]:
    """Returns a stand-in for a function, method or class that vtkDGG does not have."""

    def refuse(*_: Any, **__: Any) -> NoReturn:
        raise NotImplementedError(f"{name} is not available. {remedy}")

    refuse.__name__ = refuse.__qualname__ = name
    refuse.__doc__ = f"Not available. {remedy}"
    return refuse


def find_distances(
    function, surface, prepared, sources, max_distance=np.inf, initial_distances=None, **options
):
    """Returns distances by a function of the kernel, infinite where unreached, and the index of the
    nearest source."""
    sources = arguments.surface_points(sources, "sources", surface)
    options.update(field_options(sources, max_distance, initial_distances, None))
    options.update(unreached_value=np.inf, generate_nearest_source=True)
    return field_of(call(function, prepared, sources.in_kernel(), **options), True)


def vertices(indices, name, count):
    """Returns vertex indices as a list, after a check."""
    indices = arguments.numbers(indices, name, "integer").ravel()
    arguments.check_ids(indices, count, name)
    return indices.tolist()
