# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Checks of arrays and flags, and counts in messages. This module imports no VTK."""

import numpy as np


def counted(count, one, many=None):
    """Returns a count with its unit in the singular or the plural."""
    return f"{count} {one if count == 1 else many or one + 's'}"


def there_are(count, one):
    """Returns a clause such as "there are 2 points"."""
    return f"there {'is' if count == 1 else 'are'} {counted(count, one)}"


def check_flag(value, name):
    """Raises an error unless the value is a bool. Other objects have truth values as well."""
    if not isinstance(value, (bool, np.bool_)):
        raise ValueError(f"{name}: expected True or False, got {value!r}")


def numbers(values, name, kind="number"):
    """Returns `values` as an array of the kind "integer" or "number"."""
    if np.ma.is_masked(values):  # masked entries would be treated as numbers
        raise ValueError(f"{name}: has masked entries; remove or fill them")
    try:
        array = np.asarray(values)
    except ValueError:
        raise ValueError(
            f"{name}: expected an array of numbers, got elements of unequal lengths"
        ) from None
    if array.dtype == object and all(isinstance(value, int) for value in array.flat):
        array = np.array(array.tolist())
        if array.dtype == object:  # NumPy has no type for such integers
            largest = max(array.flat, key=abs)
            raise ValueError(f"{name}: {largest} does not fit into 64 bits")
    allowed = {"integer": "iu", "number": "iuf"}[kind]
    if array.size and array.dtype.kind not in allowed:
        got = array.dtype
        if got == object:
            others = (value for value in array.flat if not isinstance(value, (int, float, np.number)))
            got = next((type(value).__name__ for value in others), got)
        remedy = "; convert them by .astype(int)" if kind == "integer" and array.dtype.kind == "f" else ""
        raise ValueError(f"{name}: expected {kind}s, got {got}{remedy}")
    return array


def coordinates(values, name, is_finite=True):
    """Returns `values` as float64 of shape (n, 3), finite by default."""
    array = numbers(values, name)
    if array.size == 0 and array.ndim < 2:
        return np.empty((0, 3))
    if array.ndim != 2 or array.shape[1] != 3:
        raise ValueError(f"{name}: expected the shape (n, 3), got {array.shape}")
    array = np.ascontiguousarray(array, dtype=np.float64)
    finite = np.isfinite(array).all(axis=1)
    if is_finite and not finite.all():
        row = int(np.argmin(finite))
        raise ValueError(f"{name}: row {row} is not finite: {array[row]}")
    return array


def check_ids(array, number_of_points, name):
    """Raises an error that names the first id that is out of range."""
    outside = (array < 0) | (array >= number_of_points)
    if outside.any():
        entry = np.unravel_index(int(np.argmax(outside)), array.shape)
        starts_at_1 = bool(array.size > 1 and array.min() == 1 and array.max() == number_of_points)
        raise ValueError(
            f"{name}: point id {array[entry]} (entry {', '.join(map(str, entry))}) does not exist; "
            f"{there_are(number_of_points, 'point')}{', with ids from 0' * starts_at_1}"
        )
