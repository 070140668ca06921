# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Fixtures of the tests of tables and plots."""

import os

HERE = os.path.dirname(os.path.abspath(__file__))
OUTPUT = os.environ["DGG_TEST_OUTPUT"]


def cells_of(lines, start, header):
    """Returns a row by column: the first row that starts with `start`, in the first table that has
    the column `header`."""
    first = next(i for i, line in enumerate(lines) if f"| {header} |" in line)
    names = [name.strip() for name in lines[first].split("|")[1:-1]]
    row = next(line for line in lines[first:] if line.startswith(f"| {start} |"))
    return dict(zip(names, (cell.strip() for cell in row.split("|")[1:-1])))


PNG = b"\x89PNG\r\n\x1a\n"
