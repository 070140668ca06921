# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""All exhibits, in the order of the thesis."""

from . import clouds, differences, fields, graphs, greens, isolines, laws, rivals, searches, sweeps


def _place(exhibit):
    """Tables, then figures, then what the thesis does not show; by their numbers."""
    chapter, number = exhibit.name[1:].split(".")
    return ("TFDRL".index(exhibit.name[0]), int(chapter), int(number))


ALL = sorted(
    (
        exhibit
        for module in (
            clouds,
            differences,
            fields,
            graphs,
            greens,
            isolines,
            laws,
            rivals,
            searches,
            sweeps,
        )
        for exhibit in module.EXHIBITS
    ),
    key=_place,
)
