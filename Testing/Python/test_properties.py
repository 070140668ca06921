# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Properties of all classes: what is set is returned, and counts as a change once."""

import math
import unittest

import vtkdgg
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm


def classes():
    """Yields all filters, readers and writers of the package that are not abstract."""
    for name in sorted(dir(vtkdgg)):
        kind = getattr(vtkdgg, name)
        if name.startswith("vtk") and isinstance(kind, type) and issubclass(kind, vtkAlgorithm):
            try:
                kind()
            except TypeError:  # abstract
                continue
            yield kind


def another(value, largest):
    """Returns a valid value that differs from the one of a property, or None for other types."""
    if isinstance(value, bool):
        return not value
    if isinstance(value, int):
        return value + 1 if largest is None or value < largest else value - 1
    if isinstance(value, float):
        return 0.25 if math.isnan(value) else 0.5 * value + 0.01
    return "other" if value is None or isinstance(value, str) else None


class Properties(unittest.TestCase):
    def check(self, algorithm, name):
        """Sets one property twice; returns true if the type of the property is tested."""
        set_value, get_value = getattr(algorithm, "Set" + name), getattr(algorithm, "Get" + name)
        largest = getattr(algorithm, f"Get{name}MaxValue", lambda: None)()
        try:
            value = another(get_value(), largest)
        except TypeError:  # the getter has arguments
            return False
        if value is None:
            return False
        before = algorithm.GetMTime()
        try:
            set_value(value)
        except TypeError:  # an object where None is the default
            return False
        self.assertEqual(get_value(), value)
        after = algorithm.GetMTime()
        self.assertGreater(after, before)
        set_value(value)
        self.assertEqual(algorithm.GetMTime(), after, "set to the value that it has")
        return True

    def test_all(self):
        inherited = set(dir(vtkAlgorithm))
        for kind in classes():
            tested = 0
            for setter in sorted(set(dir(kind)) - inherited):
                name = setter[3:]
                if setter.startswith("Set") and hasattr(kind, "Get" + name):
                    with self.subTest(kind=kind.__name__, property=name):
                        tested += self.check(kind(), name)
            with self.subTest(kind=kind.__name__):
                self.assertGreater(tested, 0)


if __name__ == "__main__":
    unittest.main()
