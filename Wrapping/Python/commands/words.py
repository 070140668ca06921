# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Words of tables."""


def counted(count, one, many=None):
    """A count and what is counted, in the singular or the plural."""
    return f"{count} {one if count == 1 else many or one + 's'}"


def in_options(text):
    """What a filter says, with the options of the command beside its properties."""
    for words, option in (
        ("raise ProjectionTolerance", "--tolerance"),
        ("turn MergeCoincidentPoints on", "--merge"),
    ):
        text = text.replace(words, f"{words} ({option})")
    return text
