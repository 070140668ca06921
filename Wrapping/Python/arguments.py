# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Checks of arguments, and their way into VTK. What is wrong is a ValueError that names it."""

import operator

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData


def numbers(values, name, kind="number"):
    """`values` as an array of the kind ("integer", "number")."""
    if np.ma.is_masked(values):  # what is masked would be treated as numbers
        raise ValueError(f"{name}: has masked entries; remove or fill them")
    try:
        array = np.asarray(values)
    except ValueError as error:  # rows of unequal length
        raise ValueError(f"{name}: not an array of numbers ({error})") from None
    if array.dtype == object and all(isinstance(value, int) for value in array.flat):
        largest = max(array.flat, key=abs)  # integers that NumPy has no type for
        raise ValueError(f"{name}: {largest} does not fit into 64 bits")
    allowed = {"integer": "iu", "number": "iuf"}[kind]
    if array.size and array.dtype.kind not in allowed:
        raise ValueError(f"{name}: {kind}s are wanted, not {array.dtype}")
    return array


def coordinates(values, name):
    """An array of shape (n, 3) of finite numbers."""
    array = numbers(values, name)
    if array.size == 0 and array.ndim < 2:
        return np.empty((0, 3))
    if array.ndim != 2 or array.shape[1] != 3:
        raise ValueError(f"{name}: the shape must be (n, 3), not {array.shape}")
    array = np.ascontiguousarray(array, dtype=np.float64)
    finite = np.isfinite(array).all(axis=1)
    if not finite.all():
        row = int(np.argmin(finite))
        raise ValueError(f"{name}: row {row} is not finite: {array[row]}")
    return array


def places(values, name, number_of_points):
    """Places on the surface: a list of ids and None, or None and an array of coordinates. Integers
    are ids, floats are coordinates, whatever their number."""
    array = numbers(values, name)
    if array.size == 0:
        raise ValueError(f"{name}: at least one is wanted")
    if array.dtype.kind == "f" and (array.shape == (3,) or array.ndim == 2):
        return None, coordinates(np.atleast_2d(array), name)
    if array.dtype.kind == "f" or array.ndim > 1:
        raise ValueError(
            f"{name}: point ids (an integer or a sequence of integers) or coordinates (floats of "
            f"shape (3,) or (k, 3)) are wanted, not {array.dtype} of shape {array.shape}"
        )
    array = np.atleast_1d(array)
    if number_of_points:
        check_ids(array, number_of_points, name)
    return [int(i) for i in array], None


def place(value, name, number_of_points):
    """A place on the surface: an id, or an array of three coordinates."""
    array = numbers(value, name)
    if array.dtype.kind == "f" and array.shape == (3,):
        return coordinates(array[np.newaxis], name)[0]
    if array.ndim > 0 or array.dtype.kind == "f":
        raise ValueError(
            f"{name}: a point id (an integer) or coordinates (floats of shape (3,)) are wanted, "
            f"not {array.dtype} of shape {array.shape}"
        )
    check_ids(array[np.newaxis], number_of_points, name)
    return int(array)


def finite_numbers(values, name, count):
    """`count` finite numbers, or one for all."""
    array = numbers(values, name)
    if array.size == 0 or array.shape not in ((), (count,)):
        wanted = "one number is" if count == 1 else f"one number, or {count} are"
        raise ValueError(f"{name}: {wanted} wanted, not shape {array.shape}")
    array = np.array(np.broadcast_to(array, (count,)), dtype=np.float64)
    if not np.isfinite(array).all():
        entry = int(np.argmin(np.isfinite(array)))
        raise ValueError(f"{name}: entry {entry} is not finite: {array[entry]}")
    return array


def number(value, name):
    """One number; text is none, even where it could be read as one."""
    try:
        if isinstance(value, (str, bytes)):
            raise TypeError
        return float(value)
    except (TypeError, ValueError, OverflowError):
        raise ValueError(f"{name}: a number is wanted, not {value!r}") from None


def integer(value, name):
    """One integer of 32 bits."""
    try:
        result = operator.index(value)
    except TypeError:
        raise ValueError(f"{name}: an integer is wanted, not {value!r}") from None
    if not -(2**31) <= result < 2**31:
        raise ValueError(f"{name}: must fit into 32 bits, is {result}")
    return result


def limit(value, name):
    """A number that is not negative; infinity for None."""
    result = np.inf if value is None else number(value, name)
    if not result >= 0.0:
        raise ValueError(f"{name}: must not be negative or NaN, is {result}")
    return result


def projection_tolerance(value):
    """A number that is not negative; for None the default of the filters."""
    return 0.01 if value is None else limit(value, "projection_tolerance")


def number_of_bytes(value, name):
    """A positive integer; 0 for None, as the filters take it."""
    if value is None:
        return 0
    if not 1.0 <= number(value, name) < 2.0**63:
        raise ValueError(f"{name}: must be a number of bytes, from 1 to 2^63 - 1, is {value}")
    return int(value)


def check_ids(array, number_of_points, name):
    outside = (array < 0) | (array >= number_of_points)
    if outside.any():
        place = np.unravel_index(int(np.argmax(outside)), array.shape)
        known = "is 1 point" if number_of_points == 1 else f"are {number_of_points} points"
        raise ValueError(
            f"{name}: point id {array[place]} (entry {', '.join(map(str, place))}) does not exist; "
            f"there {known}"
        )


def polydata(points):
    """Coordinates that have been checked, as points without cells."""
    result = vtkPolyData()
    vtk_points = vtkPoints()
    vtk_points.SetData(numpy_to_vtk(points, deep=True))  # a pipeline may outlive the array
    result.SetPoints(vtk_points)
    return result
