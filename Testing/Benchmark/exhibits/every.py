# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""All exhibits, in the order of the thesis."""

from . import clouds, differences, fields, graphs, greens, isolines, laws, rivals, searches, sweeps


MODULES = (
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


def place(name):
    """Returns the order of exhibits: tables, figures, then what the thesis does not show, by number."""
    chapter, number = name[1:].split(".")
    return ("TFDRL".index(name[0]), int(chapter), int(number))


ALL = sorted(
    (exhibit for module in MODULES for exhibit in module.EXHIBITS),
    key=lambda exhibit: place(exhibit.name),
)
