# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Triangles around the points of a cloud, for methods that need a Laplacian on it."""

import numpy as np
from vtkmodules.vtkCommonCore import vtkIdList
from vtkmodules.vtkCommonDataModel import vtkStaticPointLocator

NEIGHBORS = 24


def local_triangles(cloud, points):
    """The triangles at each point of the Delaunay triangulation of its neighbors in the plane that is
    fitted to them, as Sharp and Crane have them ("A Laplacian for nonmanifold triangle meshes", 2020,
    section 5.7). Theirs counts each a third for each corner that has it. Here one that two corners agree
    on is there, and others are not: where points of rough surfaces disagree, holes do less harm than
    several layers. A few edges have more than two triangles."""
    near = nearest(cloud, len(points), NEIGHBORS + 1)[:, 1:]
    ways = points[near] - points[:, None]
    # Plane through the point with the least sum of squared distances of its neighbors.
    _, axes = np.linalg.eigh(np.einsum("nki,nkj->nij", ways, ways))
    flat = np.einsum("nki,nij->nkj", ways, axes[:, :, 1:])
    squares = (flat**2).sum(axis=2)
    # Inversion maps circles through the point to lines: neighbors in the triangulation are corners
    # of the convex hull of the images.
    images = flat / np.maximum(squares, 1e-300)[:, :, None]
    triangles = [
        (point, *pair)
        for point, (ids, image) in enumerate(zip(near.tolist(), images.tolist()))
        for pair in fan(ids, image)
    ]
    found, counts = np.unique(np.sort(triangles, axis=1), axis=0, return_counts=True)
    return found[counts > 1]


def nearest(cloud, count, number):
    """Ids of the nearest points of each point, the point itself first."""
    locator = vtkStaticPointLocator()
    locator.SetDataSet(cloud)
    locator.BuildLocator()
    ids = vtkIdList()
    found = np.empty((count, number), dtype=int)
    for point in range(count):
        locator.FindClosestNPoints(number, cloud.GetPoint(point), ids)
        row = [ids.GetId(i) for i in range(number)]
        row.sort(key=lambda other, point=point: other != point)
        found[point] = row
    return found


def fan(ids, images):
    """Pairs of neighbors that make a triangle with the point: sides of the hull of the images, but
    for one that sees the point from outside, where the point is on the rim."""
    order = sorted(range(len(ids)), key=images.__getitem__)

    def chain(corners):
        kept = []
        for corner in corners:
            while len(kept) > 1 and turn(images[kept[-2]], images[kept[-1]], images[corner]) <= 0.0:
                kept.pop()
            kept.append(corner)
        return kept

    hull = chain(order)[:-1] + chain(order[::-1])[:-1]
    sides = zip(hull, hull[1:] + hull[:1])
    return [(ids[a], ids[b]) for a, b in sides if turn([0.0, 0.0], images[a], images[b]) > 0.0]


def turn(a, b, c):
    """Positive where a, b, c turn left."""
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
