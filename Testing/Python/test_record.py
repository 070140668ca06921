# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""record.py: two records of the same build are the same, and a comparison misses nothing."""

import argparse
import contextlib
import copy
import io
import os
import unittest
import unittest.mock

import record
import support


def recorded(cases, graphs=None):
    """Returns answers and refusals of some cases on a small mesh, and true if threads matter."""
    options = argparse.Namespace(folder="", graphs=graphs, meshes="terrain", cases=cases, verbose=0)
    result = record.Record(options)
    return result.content, result.run()


def differences(old, new):
    """Returns the text of a comparison, or an empty text if there are no differences."""
    with contextlib.redirect_stdout(io.StringIO()) as output:
        found = record.compare(old, new)
    return output.getvalue() if found else ""


class Record(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.graphs = support.output_folder("record_graphs")
        cls.old, cls.differs = recorded("distance", cls.graphs)

    def test_twice(self):
        written = os.path.join(self.graphs, "terrain-Guaranteed.vtp")
        before = os.stat(written).st_mtime_ns
        new, _ = recorded("distance", self.graphs)
        self.assertEqual(differences(self.old, new), "")
        self.assertEqual(os.stat(written).st_mtime_ns, before)

    def test_what_is_in_it(self):
        self.assertFalse(self.differs)
        answer = self.old["answers"]["terrain/distance"]
        self.assertEqual(answer["numbers"]["GetUsedInputGraph"], "True")
        self.assertIn("0 PointData GeodesicDistance", answer["arrays"])
        refusals = self.old["refusals"]
        for what, text in (
            ("SourceIds [-1]", "out of range"),
            ("port 0 nothing", "no input"),
            ("FieldData DGG.Targets next", "damaged"),
        ):
            self.assertIn(text, refusals[f"terrain/distance/{what}"]["messages"][0])
        self.assertIn("vtkDGGDistance", self.old["classes"])

    def test_nothing(self):
        path = os.path.join(self.graphs, "nothing.json")
        words = ["record.py", path, "", "--meshes", "unknown"]
        with unittest.mock.patch("sys.argv", words), self.assertRaises(SystemExit) as leaving:
            with contextlib.redirect_stderr(io.StringIO()) as complained:
                record.main()
        self.assertEqual(leaving.exception.code, 2)
        self.assertIn("No mesh has 'unknown'", complained.getvalue())
        self.assertFalse(os.path.exists(path))

    def test_differences(self):
        new = copy.deepcopy(self.old)
        answer = new["answers"]["terrain/distance"]
        name = "0 PointData GeodesicDistance"
        answer["arrays"][name] = self.old["answers"]["terrain/distance-raw"]["arrays"][name]
        new["refusals"]["terrain/distance/port 0 nothing"]["messages"] = []
        new["classes"]["vtkDGGDistance"]["methods"].remove("GetAccuracy")
        del new["answers"]["terrain/distance-raw"]
        new["answers"]["terrain/distance-alone"]["peaks"][1] += 100.0
        text = differences(self.old, new)
        for part in (
            f"terrain/distance, arrays, {name}: ",
            "of 72 values differ, by at most ",
            "port 0 nothing, messages: no longer: Error: vtkDGGDistance:",
            "classes: vtkDGGDistance, methods: no longer: GetAccuracy",
            "terrain/distance-raw: only in the old record",
            "peak memory: terrain/distance-alone: ",
            " 5 differences",
        ):
            self.assertIn(part, text)


if __name__ == "__main__":
    unittest.main()
