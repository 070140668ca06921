# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""The plugin without compiled classes: every Python filter has a proxy and updates."""

import pathlib
import runpy
import shutil
import sys
import tempfile
from unittest import mock

import numpy as np
import support
from paraview import servermanager as sm
from support import simple, unittest
from test_proxies import Updates, properties  # noqa: F401
from vtkdgg import python_filters
from vtkdgg.property_table import TABLE


def changed(prop, described):
    """Sets a property to another value, and returns the value."""
    if described["type"] == "string":
        value = "Something"
    elif described["type"] == "bool":
        value = not prop.GetElement(0)
    elif described["type"] == "ids":
        prop.SetNumberOfElements(1)
        value = 3
    elif "choices" in described:
        value = next(v for v in described["choices"].values() if v != prop.GetElement(0))
    elif described["type"] == "int":
        value = prop.GetElement(0) + 1
    else:
        value = prop.GetElement(0) / 2 + 1
        value = int(value) if described["type"] == "id" else value
        value = min(value, described.get("range", [value])[-1])
    prop.SetElement(0, value)
    return value


class Plugin(unittest.TestCase):
    def test_every_filter_has_a_proxy(self):
        """Every property reaches the object, and the panel has the documentation of the table."""
        pxm = sm.ProxyManager()
        iterator = pxm.NewDefinitionIterator("filters")
        seen = set()
        while not iterator.IsDoneWithTraversal():
            xml = iterator.GetProxyDefinition()
            iterator.GoToNextItem()
            module, _, kind = (xml.GetAttribute("class") or "").rpartition(".")
            if module != python_filters.__name__:
                continue
            seen.add(kind)
            proxy = pxm.NewProxy("filters", xml.GetAttribute("name"))
            proxy.UpdateVTKObjects()
            found = proxy.GetClientSideObject()
            self.assertIsInstance(found, python_filters.get(kind))
            menu = proxy.GetHints().FindNestedElementByName("ShowInMenu")
            self.assertEqual(menu.GetAttribute("category"), "Geodesics", kind)
            described = python_filters.get(kind).properties
            shown = properties(proxy)
            self.assertEqual(
                sum(p.IsA("vtkSMInputProperty") for p in shown.values()),
                found.GetNumberOfInputPorts(), kind)
            for name in set(shown) & set(described):
                with self.subTest(f"{kind}: {name}"):
                    self.assertTrue(shown[name].GetDocumentation().GetDescription())
                    value = changed(shown[name], described[name])
                    proxy.UpdateVTKObjects()
                    now = found.get(name)
                    self.assertEqual(now[0] if isinstance(now, list) else now, value)
        self.assertEqual(seen, {kind for kind, entry in TABLE.items() if "inputs" in entry})

    def test_distances_on_a_sphere(self):
        """Distances are those on a sphere up to its approximation by triangles and Accuracy."""
        sphere = simple.Sphere(Radius=1.0, ThetaResolution=128, PhiResolution=128)
        angles = np.arccos(np.clip(support.points(sphere)[:, 2], -1, 1))
        for make, error in (
            (simple.ExactGeodesicDistance, 0.001),
            (simple.GeodesicDistance, 0.01),
            (simple.InstantGeodesicDistance, 0.05),
        ):
            distance = make(Input=sphere)
            distance.Source.Center = [0.0, 0.0, 1.0]
            found = support.array(distance, "GeodesicDistance")
            np.testing.assert_allclose(found, angles, atol=error * np.pi, err_msg=make.__name__)
            self.assertGreater(found.max(), 3.1)

    def test_blocks_are_an_error(self):
        blocks = simple.GroupDatasets(Input=[support.bumpy(), support.bumpy()])
        graph = simple.GeodesicGraph(Input=blocks)
        listener = support.Listener(graph)
        self.assertEqual(support.fetch(graph).GetNumberOfElements(0), 0)
        self.assertEqual(len(listener.errors), 1)
        self.assertIn("Python filters need a vtkPolyData", listener.errors[0])

    def test_another_python(self):
        """A package that cannot be imported is an error with the remedy."""
        with tempfile.TemporaryDirectory() as folder:
            package = pathlib.Path(folder, "vtkdgg")
            plugin = package / "paraview" / "Geodesics.py"
            plugin.parent.mkdir(parents=True)
            shutil.copy(support.PLUGIN, plugin)
            (package / "__init__.py").write_text("from . import _kernel")
            with mock.patch.dict(sys.modules):
                for name in [name for name in sys.modules if name.startswith("vtkdgg")]:
                    del sys.modules[name]
                with self.assertRaisesRegex(RuntimeError, "Install vtkdgg with this version"):
                    runpy.run_path(str(plugin))


if __name__ == "__main__":
    support.main()
