# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tables of exhibits: rows are dictionaries of figures, columns say how these are written."""

from benchmark_results import DASH, count_text, digits, in_form, number, tabulate


def column(title, form, *keys):
    """Returns a column of the figures below these keys of a row, with a dash where there is none."""

    def cell(row):
        for key in keys:
            if isinstance(row, dict) and key not in row:
                return DASH
            row = row[key]
        return form(row)

    return title, cell


def listing(columns, rows, note=""):
    """A table of columns (title, function of a row), below a note."""
    return (note and f"{note}\n\n") + tabulate(columns, [(row,) for row in rows])


def joined(form, *keys):
    """Returns a function that writes several figures of a dictionary."""
    return lambda figures: " / ".join(form(figures[key]) for key in keys)


def named(rows):
    """Rows of a dictionary, which have their key as "name"."""
    return [{"name": name, **row} for name, row in rows.items()]


def errors_text(errors):
    """As in the other tables."""
    parts = " / ".join(digits(100.0 * errors[key]) for key in ("mean", "p999", "max"))
    return parts + " %" + (f", {errors['missed']} missed" if errors.get("missed") else "")


def vertices_text(count):
    """Of the mesh of a table, in the note."""
    return f"{count_text(count)} vertices"


tenths = in_form("{:.1f}")
hundredths = in_form("{:.2f}")
short = in_form("{:g}")
DEGREE = column("degree", number, "degree")
ERRORS = column("error: mean / 99.9 % / max", errors_text, "error")
