# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Calls of the kernel: errors as Python exceptions, warnings, and progress bars."""

from __future__ import annotations

import contextlib
import re
import sys
import warnings
from typing import List, Optional

from . import _kernel
from .progress import Bar

__all__ = ["Error", "VTKError"]

# Arguments of the kernel that have another name in the functions of the package.
_ARGUMENTS = {
    "evaluation": "at",
    "first_sample": "first",
    "number_of_iterations": "iterations",
    "region_array_name": "regions",
    "unreached_value": "unreached",
}
# Clauses on field arrays of filters, which lists of curves do not have.
_STATUS = re.compile(r", and the (value 1 in the )?field array \w+Status( is \d)?")


class Error(RuntimeError):
    """An error that a function of the package reports.

    Attributes
    ----------
    messages : list of str
        Messages, one entry per error, in order.
    parameter : str or None
        Argument at fault.
    index : int or None
        Id or index of the element at fault.
    reason : str
        "InvalidInput", "NotConnected", "DamagedGraph" or "OutOfMemory"; empty if unknown.
    """

    def __init__(
        self,
        messages: List[str],
        parameter: Optional[str] = None,
        index: Optional[int] = None,
        reason: str = "",
    ) -> None:
        super().__init__("\n".join(messages))
        self.messages = list(messages)
        self.parameter = parameter
        self.index = index
        self.reason = reason

    def __reduce__(self):
        return type(self), (self.messages,), vars(self)


class ArgumentError(Error, ValueError):
    """An error that the kernel reports about the value of an argument."""


class VTKError(Error):
    """An error that a VTK algorithm reported.

    Attributes
    ----------
    code : int
        ``GetErrorCode()`` of the algorithm that failed first; 0 without a code.
    """

    def __init__(self, messages: List[str], code: int = 0) -> None:
        super().__init__(messages)
        self.code = code


def call(function, *arguments, issued=None, bar=Bar, check=None, names=_ARGUMENTS, **options):
    """Calls a function of the kernel with a progress bar, and returns its result. Its errors become
    an Error.

    Warnings in the set `issued` are not repeated; others are added to the set. `bar` makes the
    progress bar. `check` is called with the result before warnings are issued. `names` has the names
    in errors of arguments that the caller calls differently.
    """
    shown = bar()
    name = function.__name__.replace("_", " ")
    try:
        result = function(
            *arguments, progress=lambda fraction: shown.show(name, fraction), **options
        )
    except _kernel.Error as error:
        parameter = names.get(error.parameter, error.parameter)
        is_argument = error.code == "InvalidInput" and error.parameter in options
        kind = ArgumentError if is_argument else Error
        text = in_arguments(error.message, names)
        raise kind([text], parameter, error.index, error.code) from None
    except ValueError as error:
        raise ValueError(in_arguments(str(error), names)) from None
    finally:
        shown.close()
    if check is not None:
        check(result)
    for output in result if isinstance(result, tuple) else (result,):
        warn(getattr(output, "warnings", ()), issued)
    return result


def warn(texts, issued=None):
    """Issues texts as warnings. Texts in the set `issued` are skipped; the others are added to it."""
    for text in texts:
        if issued is None or text not in issued:
            warnings.warn(in_arguments(text), RuntimeWarning, stacklevel=depth_of_package())
        if issued is not None:
            issued.add(text)


def render(text, name_of, arrays, quote=""):
    """Returns a message of the kernel in the terms of a front.

    `name_of` returns the name of an argument, which is in backticks or begins the message. `arrays`
    replaces "in `arrays`". `quote` encloses names within the message.
    """
    text = text.replace("in `arrays`", arrays)
    text = re.sub(r"`(\w+)`", lambda match: f"{quote}{name_of(match[1])}{quote}", text)
    return re.sub(r"\A[a-z]\w*(?=: )", lambda match: name_of(match[0]), text)


def in_arguments(text, names=_ARGUMENTS):
    """Returns a message of the kernel with the names of arguments of the package."""
    text = _STATUS.sub("", text)
    return render(text, lambda name: names.get(name, name), "on the mesh", "`")


def depth_of_package():
    """Returns the stack level of the first function outside the package, for a warning."""
    frame, level = sys._getframe(1), 1
    while frame.f_back and f"{frame.f_globals.get('__package__')}.".startswith(f"{__package__}."):
        frame, level = frame.f_back, level + 1
    return level


@contextlib.contextmanager
def needing_vtk(purpose):
    """Names the extra to install if an import within fails because there is no VTK."""
    try:
        yield
    except ModuleNotFoundError as error:
        if (error.name or "").partition(".")[0] != "vtkmodules":
            raise
        raise missing_vtk(purpose) from None


def missing_vtk(purpose):
    """Returns the error for a purpose that needs VTK."""
    return ImportError(f"{purpose} needs VTK, which is not installed (pip install vtkdgg[vtk])")
