# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Lengths and areas of a mesh; spacing and components of a point cloud."""

import itertools

import numpy as np

# Fraction of the mean edge length. Shorter distances consist of rounding errors and of the length
# that is added to triangles without area.
FLOOR = 1e-6
# Width of gaps that separate the components of a cloud, in spacings.
GAP = 5.0
# Largest median edge, as a fraction of the diagonal, without a remark: pictures interpolate
# distances linearly in triangles, which is inaccurate in large triangles.
LARGE = 0.05


def edge_lengths(mesh):
    """Returns the edge lengths of all triangles of a vtkPolyData; shared edges are repeated."""
    from ..vtk_data import coordinates_of, triangles_of

    corners = coordinates_of(mesh)[triangles_of(mesh)]
    return np.linalg.norm(np.roll(corners, -1, axis=1) - corners, axis=2).ravel()


def area_of(mesh):
    """Returns the area of the polygons of a Mesh; of a polygon that is not plane, the area of its
    projection onto its mean plane."""
    offsets, corners = mesh.polygons
    points = mesh.points[corners]
    points -= np.repeat(points[offsets[:-1]], np.diff(offsets), axis=0)
    following = np.arange(1, len(corners) + 1)
    following[offsets[1:] - 1] = offsets[:-1]
    vectors = np.add.reduceat(np.cross(points, points[following]), offsets[:-1])
    return float(np.linalg.norm(vectors, axis=1).sum() / 2)


def floor_of(mesh):
    """Returns the distance below which relative errors are meaningless."""
    return FLOOR * float(edge_lengths(mesh).mean())


def notes(mesh):
    """Returns remarks on pictures of the mesh."""
    share = float(np.median(edge_lengths(mesh))) / mesh.GetLength() if mesh.GetLength() > 0 else 0.0
    if share <= LARGE:
        return []
    return [
        f"triangles are large (half of the edges are longer than {100 * share:.0f} % of the "
        "diagonal): isolines and colors are accurate at points, and approximate between them"
    ]


def spacing_of(points):
    """Returns the median distance of some finite points from their fourth neighbors."""
    points = points[np.isfinite(points).all(axis=1)]
    if len(points) == 0:
        return 0.0
    count = len(points)
    rank = min(4, count - 1)
    extents = np.ptp(points, axis=0)
    axis = np.argmax(extents)
    ordered = points[np.argsort(points[:, axis])]
    lengths = []
    for point in points[:: max(1, count // 500)]:
        # A slab of this half-width has the neighbors that are not farther than the half-width.
        width = np.linalg.norm(extents) / np.sqrt(count)
        while True:
            low = np.searchsorted(ordered[:, axis], point[axis] - width)
            high = np.searchsorted(ordered[:, axis], point[axis] + width, side="right")
            near = np.sort(np.linalg.norm(ordered[low:high] - point, axis=1))
            if len(near) == count or (len(near) > rank and near[rank] <= width):
                break
            width *= 2.0
        lengths.append(near[rank])
    return float(np.median(lengths))


def components_of(points, spacing):
    """Returns the number of components of a cloud, which wide gaps separate."""
    reach = GAP * spacing
    if reach == 0.0:
        return len(np.unique(points, axis=0))
    # Points in one voxel belong to one component, since its diagonal is shorter than the gaps.
    voxels = np.floor((points - points.min(axis=0)) / (0.577 * reach)).astype(np.int64)
    order = np.lexsort(voxels.T)
    voxels = voxels[order]
    ends = 1 + np.flatnonzero((voxels[1:] != voxels[:-1]).any(axis=1))
    names = map(tuple, voxels[np.append(0, ends)].tolist())
    waiting = dict(zip(names, np.split(points[order], ends)))
    steps = sorted(itertools.product(range(-2, 3), repeat=3), key=lambda step: np.dot(step, step))
    count = 0
    while waiting:
        count += 1
        front = [waiting.popitem()]
        while front:
            (i, j, k), inside = front.pop()
            for a, b, c in steps:
                name = i + a, j + b, k + c
                others = waiting.get(name)
                if others is not None and _are_near(inside, others, reach):
                    front.append((name, waiting.pop(name)))
    return count


def _are_near(points, others, reach):
    """Returns true if the distance of two sets of points is at most `reach`."""
    square = reach * reach
    return any(((others - point) ** 2).sum(axis=1).min() <= square for point in points)
