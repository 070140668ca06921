# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Meshes and clouds of other packages. Where a package is not installed, objects with the same
attributes stand in for them, unless DGG_REAL_PACKAGES is set."""

import importlib
import os
import types

import numpy as np

Object = types.SimpleNamespace
IS_STRICT = bool(os.environ.get("DGG_REAL_PACKAGES"))


class Tensor:
    """A tensor of Open3D, which has no length."""

    def __init__(self, values):
        self._values = values

    def numpy(self):
        """Returns the values."""
        return self._values


class TensorMap:
    """Named tensors of Open3D. Other names raise a KeyError."""

    def __init__(self, **arrays):
        self._arrays = {name: Tensor(values) for name, values in arrays.items()}

    def __getattr__(self, name):
        return self.__dict__["_arrays"][name]


def _trimesh_scene(trimesh, points, triangles):
    # Two parts; points of the second follow those of the first.
    half = len(triangles) // 2
    parts = [trimesh.Trimesh(points, t, process=False) for t in np.split(triangles, [half])]
    return trimesh.Scene(parts)


def _open3d(open3d, points, triangles):
    vectors = open3d.utility
    return open3d.geometry.TriangleMesh(
        vectors.Vector3dVector(points), vectors.Vector3iVector(triangles)
    )


def _open3d_cloud(open3d, points):
    return open3d.geometry.PointCloud(open3d.utility.Vector3dVector(points))


def _pyvista(pyvista, points, triangles):
    return pyvista.PolyData.from_regular_faces(points, triangles)


#: By name: package, how it makes a mesh, and how a stand-in is made.
MESHES = {
    "trimesh": (
        "trimesh",
        lambda m, p, t: m.Trimesh(p, t, process=False),
        lambda p, t: Object(vertices=p, faces=t, triangles=p[t]),
    ),
    "meshio": (
        "meshio",
        lambda m, p, t: m.Mesh(p, [("vertex", [[0]]), ("triangle", t)]),
        lambda p, t: Object(points=p, cells=[Object(type="triangle", data=t)]),
    ),
    "PyVista": (
        "pyvista",
        _pyvista,
        lambda p, t: Object(points=p, faces=np.insert(t, 0, 3, axis=1).ravel()),
    ),
    "PyVista, grid": (
        "pyvista",
        lambda m, p, t: _pyvista(m, p, t).cast_to_unstructured_grid(),
        None,
    ),
    "Open3D": ("open3d", _open3d, lambda p, t: Object(vertices=p, triangles=t)),
    "Open3D, tensors": (
        "open3d",
        lambda m, p, t: m.t.geometry.TriangleMesh.from_legacy(_open3d(m, p, t)),
        lambda p, t: Object(vertex=TensorMap(positions=p), triangle=TensorMap(indices=t)),
    ),
    "vedo": ("vedo", lambda m, p, t: m.Mesh([p, t]), None),
    "nilearn": (
        "nilearn.surface",
        lambda m, p, t: m.InMemoryMesh(p, t),
        lambda p, t: Object(coordinates=p, faces=t),
    ),
}
#: Scenes concatenate their parts, so that ids differ from those of the mesh.
SCENES = {
    "trimesh, scene": (
        "trimesh",
        _trimesh_scene,
        lambda p, t: Object(
            to_mesh=lambda: Object(vertices=np.vstack([p, p]), faces=np.vstack([t, t + len(p)]))
        ),
    )
}
CLOUDS = {
    "trimesh": ("trimesh", lambda m, p: m.PointCloud(p), lambda p: Object(vertices=p)),
    "PyVista": ("pyvista", lambda m, p: m.PointSet(p), lambda p: Object(points=p)),
    "Open3D": ("open3d", _open3d_cloud, lambda p: Object(points=p)),
    "Open3D, tensors": (
        "open3d",
        lambda m, p: m.t.geometry.PointCloud.from_legacy(_open3d_cloud(m, p)),
        lambda p: Object(point=TensorMap(positions=p)),
    ),
    "vedo": ("vedo", lambda m, p: m.Points(p), None),
}


def make(table, *arrays):
    """Returns the objects of a table by name, without those that need a package and have no
    stand-in."""
    found = {}
    for name, (package, real, stand_in) in table.items():
        try:
            found[name] = real(importlib.import_module(package), *arrays)
        except ImportError:
            if IS_STRICT:
                raise
            if stand_in is not None:
                found[name] = stand_in(*arrays)
    return found
