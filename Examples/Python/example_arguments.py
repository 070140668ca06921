# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Numbers from the command line of the examples. What is wrong with them is said in words."""

import math
from argparse import ArgumentTypeError

# The largest id that VTK has.
LARGEST = 2**63 - 1


def integer(least, most=LARGEST):
    """What makes an integer in a range of a text."""

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
    """X,Y,Z as finite numbers."""
    try:
        x, y, z = (float(number) for number in text.split(","))
    except ValueError:
        raise ArgumentTypeError(f"'{text}' is not of the form X,Y,Z") from None
    if not all(map(math.isfinite, (x, y, z))):
        raise ArgumentTypeError(f"'{text}' has a number that is not finite")
    return x, y, z
