# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Checked numbers from the command lines of the examples."""

import math
from argparse import ArgumentTypeError

# Largest id in VTK.
LARGEST = 2**63 - 1


def integer(least, most=LARGEST):
    """Returns a function that converts a text to an integer in a range."""

    def convert(text):
        try:
            number = int(text)
        except ValueError:
            raise ArgumentTypeError(f"'{text}' is not an integer") from None
        if not least <= number <= most:
            limits = f"at least {least}" if most == LARGEST else f"from {least} to {most}"
            raise ArgumentTypeError(f"{text} is out of range: a number {limits} is needed")
        return number

    return convert


def triple(text):
    """Returns the finite numbers of a text X,Y,Z."""
    try:
        x, y, z = (float(number) for number in text.split(","))
    except ValueError:
        raise ArgumentTypeError(f"'{text}' is not of the form X,Y,Z") from None
    if not all(map(math.isfinite, (x, y, z))):
        raise ArgumentTypeError(f"'{text}' has a number that is not finite")
    return x, y, z
