# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""The mesh or cloud that a function is applied to."""

import copy

import numpy as np

from . import _kernel
from .checks import counted
from .data_set import ATTRIBUTES, DataSet
from .errors import Error, call, needing_vtk
from .graph_info import arrays_of
from .mesh import Mesh
from .results import GRAPH_ARRAYS, is_on_input, window_arrays

_NORMALS, _SCALARS = ATTRIBUTES.index("normals"), ATTRIBUTES.index("scalars")
# Keys of a state that can be pickled, and the corresponding cells and arrays of a DataSet.
_CELLS = {"Verts": "verts", "Lines": "lines", "Polys": "polygons", "Strips": "strips"}
_ARRAYS = {"PointData": "point_data", "CellData": "cell_data", "FieldData": "field_data"}


class Surface:
    """Points, polygons and strips for the kernel, and the other data that results pass on.

    Parameters
    ----------
    data : DataSet
        Contents of the kind POLYDATA.
    polydata : vtkPolyData, optional
        A copy of the object that the contents come from, for outputs.
    """

    def __init__(self, data, polydata=None):
        self.data = data
        self._polydata = polydata
        self._default_normals = "Normals" if polydata is None else None

    @classmethod
    def of(cls, mesh):
        """Returns the surface of a Mesh, whose arrays are shared."""
        return cls(DataSet.of(mesh))

    @classmethod
    def of_points(cls, points):
        """Returns a cloud with checked coordinates."""
        data = DataSet("POLYDATA")
        data.points = points
        return cls(data)

    @property
    def points(self):
        """Coordinates, shape (n, 3)."""
        return self.data.points

    @property
    def number_of_points(self):
        """Number of points, n."""
        return len(self.data.points)

    @property
    def number_of_cells(self):
        """Number of cells, including verts and lines."""
        return self.data.number_of_cells()

    @property
    def polygons(self):
        """Offsets and corners of the polygons."""
        return self.data.cells["polygons"]

    @property
    def first_polygon(self):
        """Cell id of the first polygon, which follows verts and lines."""
        return sum(len(self.data.cells[name][0]) - 1 for name in ("verts", "lines"))

    @property
    def has_polygons(self):
        """True if there are polygons or strips."""
        return self.number_of_cells > self.first_polygon

    @property
    def has_strips(self):
        """True if there are triangle strips."""
        return len(self.data.cells["strips"][0]) > 1

    @property
    def field_data(self):
        """Field arrays by name."""
        return self.data.field_data

    @property
    def normals(self):
        """The active normals, shape (n, 3), or None."""
        name = self.data.active.get(_NORMALS, self._default_normals)
        values = self.data.point_data.get(name)
        return values if np.shape(values)[1:] == (3,) else None

    def add_point_array(self, name, values):
        """Adds a point array, or replaces the one with this name."""
        self.data.point_data = {**self.data.point_data, name: values}
        if self._polydata is not None:
            from . import vtk_output

            self._polydata.GetPointData().AddArray(vtk_output.vtk_array(values, name))

    def copy(self):
        """Returns the surface without a graph, with copies of points and cells, which others cannot
        change."""
        data = copy.copy(self.data)
        graph = arrays_of(self.field_data)
        data.field_data = {k: v for k, v in self.field_data.items() if k not in graph}
        polydata = self._polydata
        if polydata is not None:
            from . import vtk_data

            polydata = vtk_data.copy_surface(polydata)
            for name in graph:
                polydata.GetFieldData().RemoveArray(name)
        data.points = self.data.points.copy()
        data.cells = {
            name: tuple(array.copy() for array in pair) for name, pair in data.cells.items()
        }
        return Surface(data, polydata)

    def prepared(self, is_merged=False, merge_tolerance=0.0, is_cloud=False, issued=None):
        """Returns the surface or cloud of the kernel. `issued` is as for call()."""
        if not (is_cloud or self.has_polygons):
            raise Error(
                [
                    f"triangles: there are {counted(self.number_of_points, 'point')} but no "
                    "polygons; use vtkdgg.CloudGraph for points without triangles"
                ],
                "triangles",
                reason="InvalidInput",
            )
        strips = {"strips": self.data.cells["strips"]} if self.has_strips and not is_cloud else {}
        return call(
            _kernel.Surface,
            self.data.stored_points(),
            self.polygons,
            first_cell=self.first_polygon,
            merge_coincident_points=is_merged,
            merge_tolerance=merge_tolerance,
            cloud=is_cloud,
            issued=issued,
            **strips,
        )

    def polydata(self, result=None, graph=None):
        """Returns the surface as a new vtkPolyData, or the output of a function of the kernel.

        Its arrays are kept for the next call. `graph` has arrays of a graph, which become field
        data of the surface.
        """
        with needing_vtk("as_polydata"):
            from . import vtk_data, vtk_output

        if self._polydata is None:
            self._polydata = vtk_data.polydata_of(self.data)
        data = self._polydata.GetFieldData()
        for name, values in (graph or {}).items():
            if not data.HasArray(name):
                vtk_data.add_array(data, name, values, is_shared=True)
        surface = vtk_data.shallow_copy(self._polydata)
        return surface if result is None else vtk_output.polydata_of_result(result, surface)

    def mesh(self, result=None):
        """Returns the surface as a new Mesh, or the output of a function of the kernel, in which
        new points have no arrays of the surface."""
        if result is None:
            return self.data.mesh()
        if is_on_input(result):
            mesh = self.data.mesh()
        else:
            skipped = {*GRAPH_ARRAYS, *window_arrays(self.field_data)}
            fields = {name: v for name, v in self.field_data.items() if name not in skipped}
            mesh = Mesh(result.points, **result.cells, field_data=fields)
        for name in _ARRAYS.values():
            getattr(mesh, name).update(getattr(result, name))
        if result.active["points"]:
            mesh._active = {**mesh._active, _SCALARS: result.active["points"]}
        return mesh

    def state(self, graph):
        """Returns a dict that can be pickled, without arrays of texts and bits. `graph` has arrays
        of a graph, which become field data."""
        state = {"Points": self.points}
        state.update((key, self.data.cells[name]) for key, name in _CELLS.items())
        for key, name in _ARRAYS.items():
            arrays = getattr(self.data, name)
            arrays = {**arrays, **graph} if key == "FieldData" else arrays
            state[key] = list(arrays.items())
        state["Active"] = {ATTRIBUTES[i]: name for i, name in self.data.active.items()}
        return state

    @classmethod
    def from_state(cls, state):
        """Returns the surface of a dict that state() or version 1.0.0 returned."""
        data = DataSet("POLYDATA")
        data.points = state["Points"]
        data.cells = {name: state[key] for key, name in _CELLS.items()}
        for key, name in _ARRAYS.items():
            arrays = getattr(data, name)
            for array_name, *parts in state[key]:  # version 1.0.0 stored the type before the values
                arrays[array_name] = next(part for part in parts if isinstance(part, np.ndarray))
        active = state.get("Active", {})
        data.active = {ATTRIBUTES.index(kind): name for kind, name in active.items()}
        return cls(data)
