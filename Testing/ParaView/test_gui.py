# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""ParaView's user interface: its menu creates every filter, and a source has a handle."""

import os
import subprocess
from xml.sax.saxutils import quoteattr

import support
from paraview import servermanager as sm
from paraview import simple
from support import unittest

WINDOW = "pqClientMainWindow"
PANEL = f"{WINDOW}/propertiesDock/propertiesPanel"
MENUS = f"{WINDOW}/menubar"
CANCEL = f"{WINDOW}/SelectInputDialog/buttonBox/1QPushButton1"


def filters():
    """Returns the filters of the category by name, and for each true if it requires further inputs.
    """
    pxm = sm.ProxyManager()
    found = {}
    iterator = pxm.NewDefinitionIterator("filters")
    while not iterator.IsDoneWithTraversal():
        xml = iterator.GetProxyDefinition()
        hints = xml.FindNestedElementByName("Hints")
        menu = hints and hints.FindNestedElementByName("ShowInMenu")
        if menu and menu.GetAttribute("category") == "Geodesics":
            name = xml.GetAttribute("name")
            prototype = pxm.GetPrototypeProxy("filters", name)
            properties = prototype.NewPropertyIterator()
            found[name] = False
            while not properties.IsAtEnd():
                p = properties.GetProperty()
                required = not (p.GetHints() and p.GetHints().FindNestedElementByName("Optional"))
                if p.IsA("vtkSMInputProperty") and required and properties.GetKey() != "Input":
                    found[name] |= p.FindDomain("vtkSMProxyListDomain") is None
                properties.Next()
        iterator.GoToNextItem()
    return found


def event(place, name=""):
    """Returns an event that presses a button or selects a menu entry."""
    return f'<pqevent object={quoteattr(place)} command="activate" arguments={quoteattr(name)} />'


def choose(name):
    """Returns events that select a filter in its menu, which ParaView 5.13 fills when it opens."""
    return [event(MENUS, "menuFilters"), event(f"{MENUS}/menuFilters/Geodesics", name)]


class Window(unittest.TestCase):
    def play(self, events, picture):
        """Open a surface, play `events`, and take a picture of the view."""
        # ParaView opens a dialog for .ply files, which two readers support.
        surface = support.OUTPUT / "bumpy.vtp"
        simple.SaveData(str(surface), proxy=support.bumpy())
        script = support.OUTPUT / "window.xml"
        script.write_text("<?xml version='1.0' ?><pqevents>" + "".join(events) + "</pqevents>")
        picture.unlink(missing_ok=True)  # a missing baseline is written
        run = subprocess.run(
            [
                "paraview",
                "--dr",
                f"--data={surface}",
                f"--test-script={script}",
                f"--test-baseline={picture}",
                f"--test-directory={support.OUTPUT}",
                "--exit",
            ],
            env={**os.environ, "PV_PLUGIN_PATH": os.path.dirname(support.PLUGIN)},
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            timeout=300,
        )
        return run.stdout

    def test_menu_and_handle(self):
        known = filters()
        self.assertGreater(len(known), 15)
        events = [event(f"{PANEL}/Accept")]
        for name, asks in known.items():
            events += [*choose(name), event(CANCEL if asks else f"{PANEL}/Delete")]
        events += [*choose("GeodesicDistance"), event(f"{PANEL}/Accept")]
        picture = support.OUTPUT / "ParaViewHandle.png"
        output = self.play(events, picture)
        self.assertRegex(output, "is finished. Success = +true", output)
        self.assertNotRegex(output, "(?i)error|warn", output)
        support.check_picture(self, picture)

    def test_that_it_could_fail(self):
        output = self.play(choose("NoSuchFilter"), support.OUTPUT / "nothing.png")
        self.assertIn("NoSuchFilter", output)
        self.assertNotRegex(output, "Success = +true")


if __name__ == "__main__":
    support.main()
