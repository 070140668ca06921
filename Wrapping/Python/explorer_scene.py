# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""The contents of the explorer and their computation, without a window."""

from __future__ import annotations

import contextlib
import time

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from . import _kernel, arguments, meshes
from .checks import counted
from .cloud_graph import CloudGraph
from .commands.measured import Errors
from .commands.sizes import floor_of
from .distances import METHODS as FUNCTIONS
from .errors import Error, call
from .graph import Graph, find_isolines
from .graph_info import find_info
from .pictures import nice_step
from .vtk_data import (
    add_array,
    closest_cell,
    locator_of,
    polyline,
    structure_of,
    triangulated,
    with_arrays,
)

# Roles of the places, and names of the array of each view in files.
ROLES = ("source", "end", "corner")
ARRAYS = {
    "distance": "GeodesicDistance",
    "error": "ErrorPercent",
    "voronoi": "GeodesicSource",
    "greens": "GreensFunction",
}
ACCURACIES = (0.1, 0.03, 0.01, 0.003, 0.001)
METHODS = ("graph", "exact", "fast")


class Scene:
    """Source, end and corner on a surface or a cloud, and the answers that they determine.

    The surface is a mesh as for `distance`, or a cloud with `is_cloud`. Polygons and strips are
    triangulated; a surface without triangles or with a point that is not finite is a ValueError.
    The graph on the surface is used unless an accuracy is given; the default accuracy is 0.01.

    The first place is a source of distances, the second the end of a path, the third makes it a
    loop; in the view "voronoi" all are sources. A place is a point id or, on a surface,
    three coordinates.

    Attributes
    ----------
    places : list
        The places. `held` is the index of the place that is being moved, or None.
    view : {"distance", "error", "voronoi", "greens"}
        Requested view. `shown` is the view of the results: distances while a source is moved.
    method : {"graph", "exact", "fast"}
        Method of distances at rest. `used` is the method of the results.
    distances, values : numpy.ndarray of float64, shape (n,), or None
        Distances of the points, and the colored values: distances, absolute errors in percent,
        indices of cells, or a Green's function.
    limits, step : tuple of float, float
        Range of the colors, and width of the bands.
    lines, cells : vtkPolyData or None
        Isolines; the surface in bands or cells, whose cell array "Shown" replaces the values.
    path, loop : Path or None, Loop or None
    errors : Errors or None
        Against exact distances, in the view "error".
    times : dict of str to float
        Durations of the parts of the last update, seconds.
    message : str
        Reason of a missing result.
    """

    def __init__(self, surface, is_cloud=False, accuracy=None, merge=False):
        surface = meshes.cloud_of(surface) if is_cloud else meshes.take(surface)[0]
        info = find_info(surface.field_data) if accuracy is None and not is_cloud else None
        surface = surface.polydata()
        if surface.GetNumberOfPoints() == 0:
            raise ValueError("there are no points to explore")
        if accuracy is not None:
            call(_kernel.Graph.check, accuracy=accuracy)
        self.surface = surface if is_cloud else _triangles_of(surface)
        # Without arrays, which isolines would interpolate.
        self._mesh, _ = meshes.take(structure_of(self.surface))
        self.is_cloud = is_cloud
        self._uses_input_graph = info is not None
        if info is not None:
            self.accuracy = info.accuracy if info.is_guaranteed else None
        else:
            self.accuracy = 0.01 if accuracy is None else accuracy
        self.view = "distance"
        self.method = "graph"
        self.message = ""
        tolerance = info.merge_tolerance if info is not None else 0.0
        self._merging = merge or bool(info and info.merge_coincident_points), tolerance
        self._graph = None
        self._fastest = {}
        self._issued = set()
        self._wanted = None
        if not is_cloud:
            self._prepared = self._mesh.prepared(*self._merging, issued=self._issued)
            self.locator = locator_of(self.surface)
        self.clear()
        self.update()

    @property
    def graph(self):
        """The graph, built on first use."""
        if self._graph is None:
            with self._timed("build"):
                if self.is_cloud:
                    self._graph = CloudGraph(self.surface)
                else:
                    self._graph = Graph(
                        self.surface,
                        accuracy=None if self._uses_input_graph else self.accuracy,
                        merge_coincident_points=self._merging[0],
                        merge_tolerance=self._merging[1],
                    )
        return self._graph

    @property
    def sources(self):
        """The sources of the distances."""
        return self.places if self.view == "voronoi" else self.places[:1]

    # The following five methods require an update afterwards.

    def suggest(self, place):
        """Sets a source that the first click replaces."""
        self.clear()
        self.places = [place]
        self._is_suggested = True

    def clear(self):
        """Removes all places."""
        self._is_suggested = False
        self.places = []
        self.held = None
        self._last = 0
        self._reach = 0.0

    def toggle(self, view):
        """Switches to a view, or from it back to distances."""
        if self.is_cloud and view in ("error", "greens"):
            raise ValueError("on clouds there are no exact distances, and no Laplacian")
        self.view = "distance" if self.view == view else view
        self.held = None
        if self.view != "voronoi":
            self.places = self.places[: 2 if self.is_cloud else 3]
        self._reach = 0.0

    def next_method(self):
        """Switches to the next method."""
        if self.is_cloud:
            raise ValueError("on clouds there are distances by the graph only")
        self.method = METHODS[(METHODS.index(self.method) + 1) % len(METHODS)]

    def change_accuracy(self, step):
        """Switches to the next finer (step > 0) or coarser accuracy."""
        if self.is_cloud:
            raise ValueError("on clouds no accuracy is promised")
        known = ACCURACIES if step > 0 else ACCURACIES[::-1]
        now = self.accuracy
        others = [a for a in known if now is None or (a < now if step > 0 else a > now)]
        if not others:
            raise ValueError(f"accuracies are from {ACCURACIES[0]:g} to {ACCURACIES[-1]:g} here")
        self.accuracy = others[0]
        self._uses_input_graph = False
        self._graph = None
        self._fastest.pop("graph", None)

    def press(self, place, handle=None):
        """Holds the place with this index, or a new one. A place after the last that a view uses
        replaces all others."""
        if handle is None:
            is_full = len(self.places) >= (2 if self.is_cloud else 3)
            if self._is_suggested or (self.view != "voronoi" and is_full):
                self.places = []
            handle = len(self.places)
            self.places.append(place)
        self._is_suggested = False
        self.held = self._last = handle
        self.move(place)

    def move(self, place):
        """Moves the marker that is held, if any."""
        if self.held is not None:
            self.places[self.held] = place
            self.update(is_moving=True)

    def waits_for(self):
        """Returns a text that names the long part of an update at rest; empty without one."""
        if not (self.places or self.is_cloud):
            return ""
        is_searched = self.view == "voronoi" or (self.method == "graph" and self.view != "greens")
        if self._graph is None and (is_searched or len(self.places) > 1):
            return "building the graph ..."
        if self.view == "greens":
            return "solving for the Green's function ..."
        return "searching exactly ..." if "exact" in (self.method, self.view) else ""

    def update(self, is_moving=False):
        """Computes the view; faster and coarser while a place is moved."""
        self.message = ""
        self.times = {}
        places = [tuple(np.ravel(place)) for place in self.sources]
        wanted = is_moving, self.view, self.method, self.accuracy, places
        is_beside = is_moving and self.held is not None and self.held >= len(places)
        is_changed = wanted != self._wanted and not is_beside
        try:
            if is_changed:
                self._wanted = None  # until the values are complete
                self._find_values(is_moving)
                self._wanted = wanted
            self._find_curves(is_moving)
        except (ImportError, ValueError, Error) as problem:
            self.message = " ".join(str(problem).split())
            if self._wanted is None:  # incomplete results must not be shown
                self._forget()

    def status(self):
        """Returns lines of text that describe the view."""
        lines = [counted(self.surface.GetNumberOfPoints(), "point")]
        if self.values is not None and self.shown == "greens":
            lines[0] += ", Green's function"
        elif self.values is not None:
            what = {"error": "errors of distances", "voronoi": "Voronoi cells"}
            how = "without error" if self.used == "exact" else "nothing is promised"
            if self._promise() is not None:
                how = f"accuracy {self.accuracy:g}"
            lines[0] += f", {what.get(self.shown, 'distances')} by {self.used}: {how}"
        if self.errors:
            promise = self._promise()
            promised = "" if promise is None else f"promised {100 * promise:g} %, "
            sizes = self.errors.mean, self.errors.largest
            measured = "measured {:.2g} % on average, {:.2g} % at most".format(
                *(100 * size for size in sizes)
            )
            lines.append(promised + measured)
        for name, curve in (("path", self.path), ("loop", self.loop)):
            if curve:
                lines.append(f"{name}: {curve.length:.6g} model units")
        if self.times:
            parts = (f"{name} {1e3 * seconds:.1f} ms" for name, seconds in self.times.items())
            lines.append(", ".join(parts))
        return [*lines, self.message] if self.message else lines

    def last_place(self):
        """Returns a text of the place that was clicked or moved last: its coordinates, and the id
        of the point there or of the nearest corner of its triangle. Empty without places."""
        if self._last >= len(self.places):
            return ""
        place = self.places[self._last]
        role = "source" if self.view == "voronoi" else ROLES[self._last]
        if isinstance(place, int):
            x, y, z = self.surface.GetPoint(place)
            return f"{role}: point {place} at ({x:.6g}, {y:.6g}, {z:.6g})"
        _, corners = closest_cell(self.locator, place)
        offsets = np.array([self.surface.GetPoint(i) for i in corners]) - place
        nearest = corners[int(np.argmin((offsets**2).sum(axis=1)))]
        x, y, z = place
        return f"{role}: ({x:.6g}, {y:.6g}, {z:.6g}), nearest point {nearest}"

    def answer(self):
        """Returns the displayed data by name: the surface or cloud with the values as a point
        array, the path and the loop."""
        found = {}
        if self.values is not None:
            found["points"] = with_arrays(self.surface, {ARRAYS[self.shown]: self.values})
        for name, curve in (("path", self.path), ("loop", self.loop)):
            if curve:
                found[name] = polyline(curve.points)
        return found

    def _promise(self):
        """Returns the largest relative error of the distances, None without a bound."""
        return self.accuracy if self.used == "graph" and not self.is_cloud else None

    def _forget(self):
        self.distances = self.values = self.lines = self.cells = self.errors = None

    def _find_values(self, is_moving):
        self._forget()
        self.shown = self.view
        self.used = "graph" if self.view == "voronoi" else self.method
        if is_moving and self.view != "voronoi":
            self.shown = "distance"
        if not self.places:
            return
        if self.shown == "greens":
            self._solve()
            return
        if is_moving:
            self.used = self._soonest()
        has_lines = not (is_moving or self.is_cloud)
        # With virtual sources, distances of a graph may be exact; its own are shown.
        field = self._search(self.used, has_lines and self.used != "graph")
        if is_moving:
            fastest = self._fastest.get(self.used, np.inf)
            self._fastest[self.used] = min(self.times[self.used], fastest)
        self.distances = field.point_data["GeodesicDistance"]
        self.values = self.distances
        reached = self.distances[np.isfinite(self.distances)]
        high = float(reached.max()) if reached.size else 0.0
        # The range of colors does not shrink while sources move.
        self._reach = max(self._reach, high)
        self.limits = 0.0, self._reach or 1.0
        self.step = nice_step(self.limits[1])
        inside = self._search("graph", True) if has_lines and self.used == "graph" else field
        self._find_lines(inside, 0.0, high, is_moving)
        if self.shown == "error":
            self._measure()
        elif self.shown == "voronoi":
            nearest = field.point_data["GeodesicSource"].astype(float)
            self.values = np.where(nearest < 0, np.nan, nearest)
            self.limits = 0.0, float(max(1, len(self.sources) - 1))
            self.cells = None
            if not (is_moving or self.is_cloud):
                self.cells = self.graph.voronoi(self.sources, as_polydata=True)
                sites = vtk_to_numpy(self.cells.GetCellData().GetArray("SiteId"))
                self._add_to_cells(sites.astype(float))

    def _soonest(self):
        """Returns the fastest method: the graph once it is built, unless it is slower."""
        if self.is_cloud:
            return "graph"
        if self.used != "graph" or self._graph is None:
            return "fast"
        is_slower = self._fastest.get("graph", 0.0) > self._fastest.get("fast", np.inf)
        return "fast" if is_slower else "graph"

    def _search(self, method, has_lines=False):
        """Returns the distances by a method as a result of the kernel, with what isolines at rest
        need if requested, which takes longer."""
        options = {"generate_nearest_source": self.view == "voronoi"}
        if has_lines:
            kind = "generate_windows" if method == "exact" else "generate_virtual_source"
            options[kind] = True
        target = self.graph._graph if method == "graph" else self._prepared
        name = "graph for isolines" if has_lines and method == "graph" else method
        return self._run(FUNCTIONS[method], target, name, **options)

    def _run(self, function, target, name, **options):
        """Returns the result of a function of the kernel for the sources."""
        with self._timed(name):
            sources = arguments.surface_points(self.sources, "sources", self._mesh)
            return call(function, target, sources.in_kernel(), issued=self._issued, **options)

    @contextlib.contextmanager
    def _timed(self, name):
        """Stores the duration of a part of the update, in seconds."""
        start = time.perf_counter()
        yield
        self.times[name] = time.perf_counter() - start

    def _find_lines(self, field, low, high, is_moving):
        """Finds isolines at multiples of the step, and at rest the bands between them."""
        first, last = int(np.floor(low / self.step)) + 1, int(np.ceil(high / self.step)) - 1
        if self.is_cloud or last < first:
            return
        is_linear = is_moving or self.shown == "greens"
        is_whole = bool(np.isfinite(self.values).all())
        has_bands = not is_linear and is_whole and self.shown == "distance"
        with self._timed("isolines"):
            lines, _, bands = find_isolines(
                self._prepared,
                field,
                self.step * np.arange(first, last + 1),
                self._issued,
                method="Linear" if is_linear else "LocalSources",
                generate_bands=has_bands,
                chord_tolerance=0.02,  # finer than can be seen
            )
            self.lines = self._mesh.polydata(lines)
            if has_bands:
                self.cells = self._mesh.polydata(bands)
                self._add_to_cells((bands.cell_data["Band"] + 0.5) * self.step)

    def _add_to_cells(self, values):
        add_array(self.cells.GetCellData(), "Shown", values)
        self.cells.GetCellData().SetActiveScalars("Shown")

    def _measure(self):
        """Measures the errors of the distances."""
        truth = self._search("exact").point_data["GeodesicDistance"]
        self.errors = Errors(self.distances, truth, floor_of(self.surface))
        self.values = 100.0 * np.abs(self.errors.signed)
        most = self._promise() or self.errors.largest
        most = most if 0.0 < most < np.inf else 1.0
        self.limits = 0.1 * most, 100.0 * most

    def _solve(self):
        """Computes the Green's function of the source."""
        solution, _ = self._run(_kernel.greens_function, self._prepared, "Green's function")
        self.values = solution.point_data["GreensFunction"]
        # It has a pole at the source.
        low, high = np.nanmin(self.values), np.nanquantile(self.values, 0.999)
        high = float(high) if high > low else float(low) + 1.0
        self.step = nice_step(high - low)
        self.limits = self.step * float(np.floor(low / self.step)), high
        self._find_lines(solution, *self.limits, False)

    def _find_curves(self, is_moving):
        """Finds the path from the first place to the second, and the loop through three."""
        self.path = self.loop = None
        if self.view == "voronoi" or len(self.places) < 2:
            return
        if is_moving and self._graph is None:
            return
        graph = self.graph
        with self._timed("path"):
            self.path = graph.path(*self.places[:2])
        if len(self.places) > 2:
            with self._timed("loop"):
                loops = graph.loop(self.places, rope=True)
            if loops:
                self.loop = loops[0]
            else:
                self.message = "no loop: it contracts to a point, or the surface has gaps"


def _triangles_of(surface):
    """Returns the triangles of a surface."""
    arguments.coordinates(vtk_to_numpy(surface.GetPoints().GetData()), "points")
    return triangulated(surface, "surface")
