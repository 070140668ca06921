# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""A window to explore a surface or a cloud by clicks, drags and keys."""

from __future__ import annotations

import itertools
import os
import sys
import time

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkInteractionStyle import vtkInteractorStyleTrackballCamera
from vtkmodules.vtkRenderingCore import vtkRenderWindow, vtkRenderWindowInteractor

from . import pictures, writing
from .commands import cloud_pictures, places
from .commands.words import HELP
from .errors import Error
from .explorer_props import CloudSkin, Skin, bar_of, lines_actor, table_of
from .explorer_scene import Scene
from .vtk_data import coordinates_of

__all__ = ["Explorer", "Scene", "explore"]

# Colors of source, end and corner.
MARKERS = ((0.86, 0.12, 0.16), pictures.INK, (0.10, 0.35, 0.75))
PATH_COLOR = (0.86, 0.12, 0.16)
LOOP_COLOR = (0.10, 0.35, 0.75)
# Distance at which a click grabs a marker, and thickness of curves, as fractions of the diagonal.
REACH = 0.02
WIDTH = 0.0028


class Explorer:
    """A window on a `Scene`.

    Parameters
    ----------
    scene : Scene
    picture : str, optional
        Name of screenshots, which are numbered: explore-1.png and so on.
    size : tuple of int, optional
        Size of the window, pixels.
    place : int, or array_like of float, shape (3,), optional
        First source: an id on a cloud, otherwise coordinates. Default: the point farthest from the
        center.

    Attributes
    ----------
    window, renderer, interactor : objects of VTK
        None after the window is closed.
    seconds : float
        Duration of the last step of dragging, without rendering.
    written : list of str
        Screenshots and exported files.

    Raises
    ------
    OSError
        When there is no display.
    """

    def __init__(self, scene, picture="explore.png", size=(1280, 960), place=None):
        if sys.platform == "linux" and not os.environ.get("DISPLAY"):
            # VTK would end the process or, since 9.4, render off screen.
            raise OSError("there is no display to open a window on")
        self.window = vtkRenderWindow()
        self.scene = scene
        self._start = far_place(scene) if place is None else place
        self.seconds = 0.0
        self.written = []
        self._picture = picture
        if scene.is_cloud:
            self._skin = CloudSkin(scene.surface)
        else:
            self._skin = Skin(scene.surface, scene.locator)
        self._lines = lines_actor()
        self._table = self._known = None
        self._passing = []
        self._status = pictures.text("", 0.01, 0.015, 20)
        self._help = pictures.text("", 0.01, 0.985, 20)
        self._shows_help = False
        self._help.GetTextProperty().SetVerticalJustificationToTop()
        for prop in (self._status, self._help):
            look = prop.GetTextProperty()
            look.SetBackgroundColor(1.0, 1.0, 1.0)
            pictures.configured(look, LineSpacing=1.2, BackgroundOpacity=0.75)

        self.renderer = pictures.stage((self._skin.actor, self._lines, self._status, self._help))
        self.window.SetWindowName("vtkdgg explore")
        pictures.configured(self.window, Size=[*size], MultiSamples=4)
        self.window.AddRenderer(self.renderer)

        self.interactor = vtkRenderWindowInteractor()
        self.interactor.SetRenderWindow(self.window)
        self._style = vtkInteractorStyleTrackballCamera()
        self.interactor.SetInteractorStyle(self._style)
        # Observers of the style replace its own actions.
        for event, action in (
            ("LeftButtonPressEvent", self._on_press),
            ("MouseMoveEvent", self._on_move),
            ("LeftButtonReleaseEvent", self._on_release),
            ("CharEvent", self._on_char),
        ):
            self._style.AddObserver(event, action)
        self.look()
        self.refresh()

    def start(self):
        """Opens the window with a first source, and returns when it is closed."""
        self.window.Render()
        self.scene.suggest(self._start)
        if self.scene.is_cloud:  # needs its graph, and is seen meanwhile
            self._settle()
        else:
            self.scene.held = 0
            self.scene.update(is_moving=True)  # which does not wait for a graph
            self.scene.held = None
            self.draw()
        self.interactor.Start()
        self.close()

    def close(self):
        """Releases the window."""
        if self.window is None:
            return
        self._style.RemoveAllObservers()
        self.window.Finalize()
        self.window = self.renderer = self.interactor = self._style = None
        self._passing = []

    def look(self):
        """Aims the camera at the whole surface, so that the first source is visible."""
        surface = self.scene.surface
        up = pictures.up_of(surface)
        place = self._where(self._start)
        if self.scene.is_cloud:
            points = coordinates_of(surface)
            direction = cloud_pictures.best_direction(
                points, place[np.newaxis], up, self._skin.spacing
            )
        else:
            direction = pictures.best_direction(surface, place, up)
        center = np.array(surface.GetCenter())
        camera = self.renderer.GetActiveCamera()
        camera.SetFocalPoint(*center)
        camera.SetPosition(*(center + direction * pictures.size_of(surface)))
        camera.SetViewUp(*up)
        camera.SetWindowCenter(0.12, -0.10)  # beside the legend, above the text
        self.renderer.ResetCamera()
        camera.Zoom(1.12)

    def refresh(self):
        """Updates actors and text."""
        scene = self.scene
        known = None if scene.values is None else (scene.shown, scene.limits, scene.step)
        if known != self._known:
            self._table = None if scene.values is None else table_of(scene)
            self._known = known
        self._skin.show(scene.values, scene.cells, self._table, scene.shown != "voronoi")
        self._lines.SetVisibility(scene.lines is not None)
        if scene.lines is not None:
            self._lines.GetMapper().SetInputData(scene.lines)
        for prop in self._passing:
            self.renderer.RemoveViewProp(prop)
        self._passing = [*self._markers(), *self._curves()]
        if scene.values is not None:
            self._passing += bar_of(scene, self._table)
        for prop in self._passing:
            self.renderer.AddViewProp(prop)
        self._say(scene.status())
        if not self._shows_help:
            self._help.SetInput("\n".join(filter(None, ["h: help", scene.last_place()])))

    def draw(self):
        """Updates actors and text, and renders."""
        self.refresh()
        self.window.Render()

    def save_picture(self, path=None):
        """Writes a screenshot, to a new file unless one is given, and returns its name."""
        path = path or self._new_name("", os.path.splitext(self._picture)[1])
        pictures.write_png(path, self.window)
        self.written.append(path)
        return path

    def export(self):
        """Writes what is shown to new .vtp and .csv files, and returns their names."""
        names = []
        for part, data in self.scene.answer().items():
            names += [self._new_name(f"-{part}", extension) for extension in (".vtp", ".csv")]
            writing.write(names[-2], data)
            writing.write_numbers(names[-1], writing.table_of(data))
        self.written += names
        return names

    def _new_name(self, part, extension):
        """Returns the numbered name of a file that does not exist."""
        stem = os.path.splitext(self._picture)[0] + part
        names = (f"{stem}-{number}{extension}" for number in itertools.count(1))
        return next(name for name in names if not os.path.exists(name))

    def _where(self, place):
        return np.array(self.scene.surface.GetPoint(place) if isinstance(place, int) else place)

    def _markers(self):
        size = pictures.size_of(self.scene.surface)
        for i, place in enumerate(self.scene.places):
            color = MARKERS[0 if self.scene.view == "voronoi" else i]
            yield pictures.marker(self._where(place), size, color)

    def _curves(self):
        size = pictures.size_of(self.scene.surface)
        curves = ((self.scene.loop, LOOP_COLOR, 0.8), (self.scene.path, PATH_COLOR, 1.0))
        for curve, color, width in curves:
            if curve and len(curve.points) > 1:
                yield cloud_pictures.tube(curve.points, width * WIDTH * size, color)

    def _say(self, lines):
        if self.seconds and self.scene.held is not None:
            lines = [*lines, f"{1.0 / self.seconds:.0f} frames a second without rendering"]
        self._status.SetInput("\n".join(lines))

    def _settle(self):
        """Computes and shows the scene at rest."""
        self._announce()
        self.scene.update()
        self.draw()

    def _announce(self):
        """Announces a long computation before it starts."""
        wait = self.scene.waits_for()
        if wait:
            self._say([*self.scene.status(), wait])
            self.window.Render()

    def _on_press(self, style, event):
        x, y = self.interactor.GetEventPosition()
        is_camera = self.interactor.GetControlKey() or self.interactor.GetShiftKey()
        style.FindPokedRenderer(x, y)
        place = None if is_camera else self._skin.pick(x, y, self.renderer)
        if place is not None:
            if self.scene.is_cloud:  # which has no answer without the graph
                self._announce()
            self._drag(lambda: self.scene.press(place, self._handle_at(place)))
        elif self.interactor.GetControlKey():
            style.StartRotate()
        else:
            style.OnLeftButtonDown()

    def _on_move(self, style, event):
        if self.scene.held is None:
            style.OnMouseMove()
            return
        start = time.perf_counter()
        place = self._skin.pick(*self.interactor.GetEventPosition(), self.renderer)
        if place is not None:
            self._drag(lambda: self.scene.move(place), start)

    def _on_release(self, style, event):
        if self.scene.held is None:
            style.OnLeftButtonUp()
            return
        self.scene.held = None
        self._settle()

    def _drag(self, step, start=None):
        start = start or time.perf_counter()
        step()
        self.refresh()
        self.seconds = time.perf_counter() - start
        self.window.Render()

    def _handle_at(self, place):
        """Returns the index of the source, end or corner near a location, None without one."""
        if not self.scene.places:
            return None
        places_there = np.array([self._where(other) for other in self.scene.places])
        distances = np.linalg.norm(places_there - self._where(place), axis=1)
        nearest = int(np.argmin(distances))
        is_near = distances[nearest] <= REACH * pictures.size_of(self.scene.surface)
        return nearest if is_near else None

    def _on_char(self, style, event):
        key = self.interactor.GetKeyCode()
        scene = self.scene
        views = {"e": "error", "v": "voronoi", "g": "greens"}
        if key in views:
            self._change(lambda: scene.toggle(views[key]))
        elif key == "m":
            self._change(scene.next_method)
        elif key in ("+", "=", "-"):
            self._change(lambda: scene.change_accuracy(-1 if key == "-" else 1))
        elif key == "c":
            self._change(scene.clear)
        elif key == "s":
            self._change(lambda: self._report([self.save_picture()]), self.draw)
        elif key == "x":
            self._change(lambda: self._report(self.export()), self.draw)
        elif key in ("h", "?"):
            self._change(self._turn_help, self.draw)
        elif key == "r":
            self._change(self.renderer.ResetCamera, self.window.Render)
        elif key == "q":
            self.interactor.TerminateApp()

    def _change(self, change, show=None):
        """Applies a change, and shows its result or its error; by default the scene at rest."""
        try:
            change()
        except (OSError, ValueError, Error) as refusal:
            self.scene.message = " ".join(str(refusal).split())
            self.draw()
        else:
            (show or self._settle)()

    def _report(self, names):
        self.scene.message = f"written: {', '.join(names) or 'nothing, as nothing is shown'}"

    def _turn_help(self):
        self._shows_help = not self._shows_help
        self._help.SetInput(HELP)


def far_place(scene):
    """Returns the location of the first source: the point farthest from the center."""
    if not scene.is_cloud:
        return np.array(scene.surface.GetPoint(places.far_point(scene.surface)))
    points = vtk_to_numpy(scene.surface.GetPoints().GetData())
    return int(np.nanargmax(np.linalg.norm(points - scene.surface.GetCenter(), axis=1)))


def explore(scene, place=None, picture="explore.png"):
    """Opens a window on a scene, and returns it when it is closed. The default of `place` is the
    point farthest from the center.

    Examples
    --------
    >>> explore(Scene(mesh))  # doctest: +SKIP
    """
    window = Explorer(scene, picture, place=place)
    window.start()
    return window
