# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""The table of properties in the repository is that of the compiled classes."""

import importlib.util
import json
import pathlib
import unittest

SOURCES = pathlib.Path(__file__).parents[2] / "Wrapping" / "Python"


class PropertyTable(unittest.TestCase):
    def test_is_current(self):
        path = SOURCES / "generate_property_table.py"
        spec = importlib.util.spec_from_file_location(path.stem, path)
        generator = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(generator)
        found = generator.table()
        with open(SOURCES / "property_table.json", encoding="utf-8") as file:
            kept = json.load(file)
        for name, entry in found.items():  # a build may lack point clouds
            current, old = (generator.formatted({name: e}) for e in (entry, kept.get(name, {})))
            self.assertEqual(old, current, f"run {path.name} to update {name}")
        self.assertEqual(set(kept) - set(found) - {"vtkPointCloudDGG"}, set())


if __name__ == "__main__":
    unittest.main()
