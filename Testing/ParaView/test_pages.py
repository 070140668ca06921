# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""The page of the plugin and its code, and the pages in ParaView's help."""

import os
import re
import shutil
import subprocess
import tempfile

import support
import test_gui
from paraview import servermanager as sm
from support import simple, unittest

PAGE = (support.REPOSITORY / "Wrapping" / "ParaView" / "README.md").read_text()


class Page(unittest.TestCase):
    def tearDown(self):
        simple.ResetSession()

    def test_is_short(self):
        self.assertLessEqual(len(PAGE.splitlines()), 250)

    def test_names_every_filter(self):
        tasks = PAGE[PAGE.index("## Filters by task") :]
        for name in test_gui.filters():
            proxy = sm.ProxyManager().GetPrototypeProxy("filters", name)
            row = rf"{proxy.GetXMLLabel()}( \| | \()`{proxy.GetVTKClassName()}`"
            self.assertRegex(tasks, row)

    def test_code(self):
        load, session, stop = re.findall(r"^```python\n(.*?)^```$", PAGE, re.M | re.S)
        folder = tempfile.mkdtemp(dir=support.OUTPUT)
        shutil.copy(support.DATA / "bumpy.ply", os.path.join(folder, "mesh.ply"))
        before = os.getcwd()
        os.chdir(folder)
        self.addCleanup(os.chdir, before)
        names = {"plugin": support.PLUGIN}
        path = re.search(r'LoadPlugin\("(.*?)"', load)[1]
        version = simple.GetParaViewVersion()
        built = path.replace("5.11", f"{version.major}.{version.minor}")
        self.assertTrue(support.PLUGIN.endswith(built.partition("/lib/")[2]))
        exec(load.replace(path, support.PLUGIN), {})
        exec(session, names)
        self.assertTrue(os.path.getsize("session.png") > 1000)
        self.assertGreater(support.array(names["path"], "Length", cells=True)[0], 1.0)
        exec(stop, names)
        names["distance"].Source.Center = [0, 1, 0]
        self.assertEqual(support.fetch(names["distance"]).GetNumberOfPoints(), 0)

    @unittest.skipIf(os.environ["DGG_QT_VERSION"] > "5", "ParaView builds help only with Qt 5")
    def test_help_has_the_pages(self):
        pages = support.OUTPUT.parents[1] / "Wrapping/ParaView/Geodesics/paraview_help"
        for name in ("GeodesicPage", "SpectralPage", "ParaViewPage", "filters.GeodesicDistance"):
            self.assertTrue((pages / f"{name}.html").is_file(), name)
        toc = next(pages.glob("*.qhp")).read_text()
        self.assertIn('ref="GeodesicPage.html"', toc)

    def test_another_version_is_told(self):
        load = f"from paraview import simple; simple.LoadPlugin({support.PLUGIN!r}, remote=False)"
        for preload, expected in ("", 0), (os.environ["DGG_OTHER_VERSION"], 1):
            run = subprocess.run(
                ["pvpython", "-c", load],
                env={**os.environ, "LD_PRELOAD": preload, "PV_PLUGIN_PATH": ""},
                stderr=subprocess.PIPE,
                text=True,
            )
            words = r"built for VTK [\d.]+, .*has VTK 9\.9\.9: .*paraview\.sh"
            told = re.findall(words, run.stderr)
            self.assertEqual(len(told), expected, run.stderr)


if __name__ == "__main__":
    support.main()
