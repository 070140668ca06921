# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Generated surfaces: the same on every machine, so that figures of them can be compared."""

import re

import numpy as np
import vtkdgg

from . import parts

NAME = re.compile(
    r"^(?P<kind>sphere|bumpy|torus|terrain)-(?P<size>[0-9]+)"
    r"(?:-noise-(?P<noise>[0-9.]+))?(?:-stretched-(?P<factor>[0-9.]+))?$"
)
SEED = 7
JITTER = 0.2  # fraction of a mean edge, along the surface


def make(name):
    """A surface by its name, or None. See `make_arrays`."""
    arrays = make_arrays(name)
    return None if arrays is None else from_arrays(*arrays)


def make_arrays(name):
    """Points and triangles of a surface by its name, or None.

    sphere-K and bumpy-K come from an icosahedron split K times (10 * 4^K + 2 vertices), torus-K
    has K rings of K/2 vertices, terrain-K K by K. All but the sphere have vertices moved at random.
    -noise-X moves each vertex along the normal by X mean edges on average, -stretched-X makes the
    first axis X times as long. The names of machine parts are those of `parts.PARTS`.
    """
    match = NAME.match(name)
    if not match:
        return parts.make_arrays(name)
    size = int(match["size"])
    random = np.random.default_rng(SEED)
    points, triangles = {
        "sphere": lambda: icosphere(size),
        "bumpy": lambda: bumpy(size, random),
        "torus": lambda: torus(size, random),
        "terrain": lambda: terrain(size, random),
    }[match["kind"]]()
    if match["noise"]:
        away = vertex_normals(points, triangles)
        size = float(match["noise"]) * mean_edge(points, triangles) * np.sqrt(np.pi / 2.0)
        points = points + away * (size * random.standard_normal(len(points)))[:, None]
    if match["factor"]:
        points = points * [float(match["factor"]), 1.0, 1.0]
    return points, triangles


def from_arrays(points, triangles):
    """A vtkPolyData of these arrays."""
    return vtkdgg.Mesh(points, triangles).as_polydata()


def icosphere(level):
    """A sphere of radius 1."""
    golden = 0.5 * (1.0 + 5.0**0.5)
    points = [
        p
        for a in (-1.0, 1.0)
        for b in (-golden, golden)
        for p in ((a, b, 0.0), (0.0, a, b), (b, 0.0, a))
    ]
    points = np.array(points) / np.sqrt(1.0 + golden**2)
    edge = min(np.linalg.norm(points[0] - p) for p in points[1:]) * 1.01
    near = np.linalg.norm(points[:, None] - points[None], axis=2) < edge
    triangles = [
        (i, j, k)
        for i in range(12)
        for j in range(i + 1, 12)
        for k in range(j + 1, 12)
        if near[i, j] and near[j, k] and near[i, k]
    ]
    triangles = np.array(
        [t if np.linalg.det(points[list(t)]) > 0.0 else (t[0], t[2], t[1]) for t in triangles]
    )
    for _ in range(level):
        points, triangles = split(points, triangles)
        points = points / np.linalg.norm(points, axis=1)[:, None]
    return points, triangles


def split(points, triangles):
    """Each triangle into four, by the middles of its edges."""
    sides = np.sort(np.concatenate([triangles[:, [i, (i + 1) % 3]] for i in range(3)]), axis=1)
    edges, place = np.unique(sides, axis=0, return_inverse=True)
    middles = 0.5 * (points[edges[:, 0]] + points[edges[:, 1]])
    a, b, c = triangles.T
    ab, bc, ca = len(points) + place.reshape(3, -1)
    quarters = ((a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca))
    return np.vstack([points, middles]), np.vstack([np.column_stack(q) for q in quarters])


def bumpy(level, random):
    """A sphere with waves, convex and saddle vertices, irregular triangles."""
    points, triangles = icosphere(level)
    points = points + JITTER * mean_edge(points, triangles) * random.uniform(-1, 1, points.shape)
    points /= np.linalg.norm(points, axis=1)[:, None]
    x, y, z = points.T
    waves = np.sin(5.0 * x) * np.sin(4.0 * y + 1.0) + 0.5 * np.sin(9.0 * z + 2.0 * x)
    return points * (1.0 + 0.1 * waves)[:, None], triangles


def grid(rows, columns, wraps):
    """Triangles of a grid, closed both ways or open."""
    i, j = np.meshgrid(
        np.arange(rows - (not wraps)), np.arange(columns - (not wraps)), indexing="ij"
    )

    def at(a, b):
        return ((i + a) % rows * columns + (j + b) % columns).ravel()

    corners = at(0, 0), at(1, 0), at(1, 1), at(0, 1)
    lower = np.column_stack([corners[0], corners[1], corners[2]])
    upper = np.column_stack([corners[0], corners[2], corners[3]])
    return np.vstack([lower, upper])


def torus(rings, random):
    """Radii 1 and 0.4."""
    sides = rings // 2
    u, v = np.meshgrid(np.arange(rings), np.arange(sides), indexing="ij")
    u = (u + JITTER * random.uniform(-1, 1, u.shape)) * 2.0 * np.pi / rings
    v = (v + JITTER * random.uniform(-1, 1, v.shape)) * 2.0 * np.pi / sides
    out = 1.0 + 0.4 * np.cos(v)
    points = np.stack([out * np.cos(u), out * np.sin(u), 0.4 * np.sin(v)], axis=-1)
    return points.reshape(-1, 3), grid(rings, sides, True)


def terrain(side, random):
    """A hilly square with sides of length 1; hills of all sizes, as eroded land has them."""
    x, y = np.meshgrid(np.linspace(0.0, 1.0, side), np.linspace(0.0, 1.0, side), indexing="ij")
    height = np.zeros_like(x)
    for octave in range(1, 7):
        for _ in range(4):
            direction, phase = 2.0 * np.pi * random.random(2)
            along = x * np.cos(direction) + y * np.sin(direction)
            height += 0.08 / 2**octave * np.sin(2.0**octave * np.pi * along + phase)
    points = np.stack([x, y, height], axis=-1).reshape(-1, 3)
    return points, grid(side, side, False)


def arrays_of(mesh):
    """Points and triangles of a surface."""
    from vtkmodules.util.numpy_support import vtk_to_numpy

    points = vtk_to_numpy(mesh.GetPoints().GetData()).astype(float)
    triangles = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    return points, triangles.astype(np.int64)


def corner_angles(points, triangles):
    """Angles at the corners, shape (m, 3)."""
    angles = np.empty(triangles.shape)
    for i in range(3):
        a, b, c = (points[triangles[:, (i + k) % 3]] for k in range(3))
        across = np.linalg.norm(np.cross(b - a, c - a), axis=1)
        angles[:, i] = np.arctan2(across, ((b - a) * (c - a)).sum(axis=1))
    return angles


def total_angles(points, triangles):
    """Of the corners at each vertex, and whether the vertex is on the boundary."""
    total = np.zeros(len(points))
    np.add.at(total, triangles, corner_angles(points, triangles))
    sides = np.sort(np.concatenate([triangles[:, [i, (i + 1) % 3]] for i in range(3)]), axis=1)
    edges, counts = np.unique(sides, axis=0, return_counts=True)
    is_rim = np.zeros(len(points), bool)
    is_rim[edges[counts == 1].ravel()] = True
    return total, is_rim


def anisotropy(points, triangles):
    """Mean of longest edge times half of the perimeter over 2 sqrt(3) areas: 1 for equilateral
    triangles. Triangles without area are left out."""
    corners = points[triangles]
    lengths = np.linalg.norm(corners - np.roll(corners, -1, axis=1), axis=2)
    areas = 0.5 * np.linalg.norm(
        np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1
    )
    used = areas > 1e-14 * np.ptp(points, axis=0).max() ** 2
    if not used.any():
        return float("nan")
    ratios = (
        lengths[used].max(axis=1) * lengths[used].sum(axis=1) / (4.0 * 3.0**0.5 * areas[used])
    )
    return float(ratios.mean())


def mean_edge(points, triangles):
    """Mean length of the sides of triangles."""
    corners = points[triangles]
    return float(np.linalg.norm(corners - np.roll(corners, -1, axis=1), axis=2).mean())


def vertex_normals(points, triangles):
    """Of length 1, weighted by area."""
    a, b, c = (points[triangles[:, i]] for i in range(3))
    normals = np.zeros_like(points)
    for i in range(3):
        np.add.at(normals, triangles[:, i], np.cross(b - a, c - a))
    return normals / np.linalg.norm(normals, axis=1)[:, None]
