# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""All exhibits, in the order of the thesis."""

from . import clouds, fields, graphs, greens, isolines, searches, sweeps


def _place(exhibit):
    """Tables first, as numbers."""
    chapter, number = exhibit.name[1:].split(".")
    return (exhibit.name[0] != "T", int(chapter), int(number))


ALL = sorted(
    (
        exhibit
        for module in (clouds, fields, graphs, greens, isolines, searches, sweeps)
        for exhibit in module.EXHIBITS
    ),
    key=_place,
)
