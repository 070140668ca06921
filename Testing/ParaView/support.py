# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Functions that the tests of the plugin share.

DGG_WRITE_BASELINE=1 in the environment replaces the baselines of pictures. Inspect them before
committing."""

import os
import pathlib
import sys
import unittest

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkImagingCore import vtkImageDifference
from vtkmodules.vtkIOImage import vtkPNGReader

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
DATA = REPOSITORY / "Testing" / "Data"
BASELINE = pathlib.Path(__file__).resolve().parent / "Baseline"
OUTPUT = pathlib.Path(os.environ["DGG_TEST_OUTPUT"])
PLUGIN = os.environ["DGG_PLUGIN"]
IS_COMPILED = not PLUGIN.endswith(".py")
# Largest difference by rounding on another processor, as measured by vtkImageDifference.
LIMIT = 40.0

# As users do: the functions are added to the module of ParaView's functions.
simple.LoadPlugin(PLUGIN, remote=False, ns=vars(simple))
simple._DisableFirstRenderCameraReset()


def bumpy():
    """Returns a reader of an asymmetric surface of 642 points, 2 across."""
    return simple.PLYReader(FileNames=[str(DATA / "bumpy.ply")])


def fetch(proxy, port=0):
    """Returns the data of an output."""
    proxy.UpdatePipeline()
    return proxy.SMProxy.GetClientSideObject().GetOutputDataObject(port)


def array(proxy, name, port=0, cells=False):
    """Returns a copy of an array of an output."""
    data = fetch(proxy, port)
    attributes = data.GetCellData() if cells else data.GetPointData()
    return vtk_to_numpy(attributes.GetArray(name)).copy()


def points(proxy, port=0):
    """Returns a copy of the coordinates of an output."""
    return vtk_to_numpy(fetch(proxy, port).GetPoints().GetData()).copy()


class Listener:
    """Collects the messages of the filters of proxies instead of printing them."""

    def __init__(self, *proxies):
        self.errors, self.warnings = [], []
        for proxy in proxies:
            self._watch(proxy, "ErrorEvent", self.errors)
            self._watch(proxy, "WarningEvent", self.warnings)

    def _watch(self, proxy, event, texts):
        def hear(caller, event, text):
            texts.append(text)

        hear.CallDataType = "string0"
        proxy.SMProxy.GetClientSideObject().AddObserver(event, hear)


def read_image(path):
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def difference(first, second):
    """Returns the pixel-wise difference of two pictures; VTK's defaults tolerate shifts."""
    compare = vtkImageDifference()
    compare.AllowShiftOff()
    compare.AveragingOff()
    compare.SetThreshold(0)
    compare.SetInputData(first)
    compare.SetImageData(second)
    compare.Update()
    return compare.GetThresholdedError()


def changed(image, change):
    """Returns a copy of a picture, changed as an array of rows, columns and colors."""
    columns, rows, _ = image.GetDimensions()
    values = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(rows, columns, -1)
    copy = image.NewInstance()
    copy.DeepCopy(image)
    vtk_to_numpy(copy.GetPointData().GetScalars())[:] = change(values).reshape(rows * columns, -1)
    return copy


def check_picture(test, file):
    """Checks that a picture equals the baseline of its name, and differs from all others."""
    baseline = BASELINE / file.name
    if os.environ.get("DGG_WRITE_BASELINE"):
        baseline.write_bytes(file.read_bytes())
    drawn, expected = read_image(file), read_image(baseline)
    test.assertLess(difference(drawn, expected), LIMIT, file.name)
    for change in (lambda v: v[:, ::-1], lambda v: np.roll(v, 1, axis=1)):
        test.assertGreater(difference(changed(drawn, change), expected), 5 * LIMIT, file.name)


def main():
    """Runs the tests of a script. sys.exit() after pictures have been drawn causes an X error."""
    if not unittest.main(verbosity=2, exit=False).result.wasSuccessful():
        sys.exit(1)
