# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Random meshes with the defects of real ones: parts with holes and without points inside faces,
duplicate walls, shared faces, slivers, many components.

A mesh depends on its seed only."""

import os
import sys
from typing import NamedTuple

import numpy as np
import support

sys.path.append(os.path.join(support.TESTING, "Benchmark"))

# pylint: disable=wrong-import-position
from exhibits.solids import edges_apart, extrude, halves, split_edges


class Mesh(NamedTuple):
    """A surface as arrays, and true if coincident points are to be merged."""

    name: str
    points: np.ndarray
    triangles: np.ndarray
    merge: bool = False
    seed: int = None


# --- Blocks of a lattice -------------------------------------------------------------------------


def box_quads(low, high):
    """Returns the unit squares on the surface of a box with integer corners, counterclockwise from
    outside: an array of shape (n, 4, 3)."""
    sides = []
    for axis in range(3):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        a, b = np.meshgrid(np.arange(low[u], high[u]), np.arange(low[v], high[v]))
        a, b = a.ravel(), b.ravel()
        for place in (low[axis], high[axis]):
            quads = np.empty((a.size, 4, 3), dtype=np.int64)
            quads[..., axis] = place
            quads[..., u] = np.column_stack([a, a + 1, a + 1, a])
            quads[..., v] = np.column_stack([b, b, b + 1, b + 1])
            sides.append(quads if place == high[axis] else quads[:, ::-1])
    return np.concatenate(sides)


def weld(quads):
    """Returns the distinct points of squares with integer corners, and the squares as ids of
    points."""
    points, ids = np.unique(quads.reshape(-1, 3), axis=0, return_inverse=True)
    return points.astype(float), ids.reshape(-1, 4)


def sphere(resolution):
    """A sphere of 6 resolution^2 + 2 points with low waves, in regular triangles."""
    points, quads = weld(box_quads((0, 0, 0), (resolution,) * 3))
    points = np.tan((points / resolution - 0.5) * (np.pi / 2))
    points /= np.linalg.norm(points, axis=1)[:, None]
    waves = np.sin(3 * points[:, 0]) * np.cos(2 * points[:, 1] + 1) + np.sin(4 * points[:, 2])
    return points * (1 + 0.05 * waves)[:, None], halves(quads)


def clean(number):
    """Returns the reference surface for times, of about as many points."""
    return sphere(max(1, round(np.sqrt(max(number - 2, 6) / 6))))


# --- Families: each takes a random generator and about how many points are wanted ----------------


def thin_sheet(rng, number):
    """An open grid, its rows and columns at random distances from each other."""
    columns = int(np.clip(np.sqrt(number) * np.exp(rng.uniform(-1, 1)), 2, number // 3))
    rows = max(2, number // (columns + 1) - 1)
    points, triangles = support.grid(columns, rows)
    for axis, count in ((0, columns), (1, rows)):
        steps = np.exp(rng.normal(0.0, rng.choice([0.0, 0.5, 2.0]), count))
        points[:, axis] = np.append(0.0, np.cumsum(steps))[points[:, axis].astype(int)]
    points /= points.max()
    points[:, 2] = rng.choice([0.0, 0.05, 0.3]) * np.sin(rng.uniform(2, 8) * points[:, 0])
    return points, triangles


def closed_sphere(rng, number):
    """A sphere as regular as the clean one."""
    return clean(number)


def plate(rng, number):
    """A plate with holes as of a CAD system: no points but those of its outlines."""
    columns, rows = rng.integers(1, 5), rng.integers(1, 4)
    size = rng.uniform(1.0, 6.0, 2)
    sides = int(np.clip(number / 2 / (columns * rows), 3, 96))
    cell = size / (columns, rows)
    outlines = [np.array([[0, 0], [1, 0], [1, 1], [0, 1]]) * size]
    for i, j in np.ndindex(columns, rows):
        angle = -2 * np.pi * (np.arange(sides) + rng.uniform()) / sides
        slot = rng.uniform(0.05, 0.48, 2) if rng.random() < 0.3 else rng.uniform(0.1, 0.48)
        ring = np.column_stack([np.cos(angle), np.sin(angle)])
        outlines.append((np.array([i, j]) + 0.5) * cell + ring * slot * cell.min())
    return extrude(outlines, rng.choice([0.01, 0.1, 1.0]) * rng.uniform(0.5, 2.0))


def welded_boxes(rng, number):
    """Boxes glued to each other by whole faces or parts of them, whose squares are there once for
    each box or once for all."""
    count = rng.integers(2, 6)
    size = max(1, int(np.sqrt(number / count / 6)))
    boxes = [(np.zeros(3, dtype=int), rng.integers(1, 2 * size + 1, 3))]
    for _ in range(count - 1):
        low, high = boxes[rng.integers(len(boxes))]
        axis = rng.integers(3)
        extent = high - low if rng.random() < 0.4 else rng.integers(1, 2 * size + 1, 3)
        # Anywhere that the faces overlap.
        start = np.array([rng.integers(l - e + 1, h) for l, h, e in zip(low, high, extent)])
        if np.array_equal(extent, high - low):
            start = low.copy()
        start[axis] = high[axis] if rng.random() < 0.5 else low[axis] - extent[axis]
        boxes.append((start, start + extent))
    points, quads = weld(np.concatenate([box_quads(low, high) for low, high in boxes]))
    keep = rng.choice(["both", "one", "crossed", "mixed"])
    diagonal = np.zeros(len(quads), dtype=bool)
    _, first = np.unique(np.sort(quads, axis=1), axis=0, return_index=True)
    again = np.setdiff1d(np.arange(len(quads)), first)
    if keep == "one":
        quads, diagonal = quads[first], diagonal[first]
    elif keep == "crossed":
        diagonal[again] = True
    elif keep == "mixed":
        diagonal = rng.random(len(quads)) < 0.5
    # Planes of the lattice at random distances.
    points -= points.min(axis=0)
    spread = rng.choice([0.0, 0.3, 1.5])
    for axis in range(3):
        steps = np.exp(rng.normal(0.0, spread, int(points[:, axis].max())))
        points[:, axis] = np.append(0.0, np.cumsum(steps))[points[:, axis].astype(int)]
    return points, halves(quads, diagonal)


def book(rng, number):
    """Sheets that share one edge or several, as the pages of a book or the walls of a honeycomb."""
    if rng.random() < 0.5:
        return honeycomb(rng, number)
    sheets = rng.integers(3, 13)
    rows = max(1, int(np.sqrt(number / sheets)))
    columns = max(1, number // sheets // (rows + 1))
    all_points, all_triangles = [], []
    angles = rng.uniform(0, 2 * np.pi, sheets)
    if rng.random() < 0.3:
        angles[1] = angles[0]  # two pages in the same place, with points of their own
    for sheet, angle in enumerate(angles):
        points, triangles = support.grid(columns, rows)
        points /= (columns, rows, 1.0)
        u, v = rng.uniform(0.2, 2.0) * points[:, 0], points[:, 1]
        ids = np.arange(len(points)) + sheet * len(points)
        ids[points[:, 0] == 0.0] = np.arange(rows + 1) * (columns + 1)  # the spine of the first
        all_points.append(np.column_stack([u * np.cos(angle), u * np.sin(angle), v]))
        all_triangles.append(ids[triangles])
    return used_only(np.concatenate(all_points), np.concatenate(all_triangles))


def honeycomb(rng, number):
    """Upright walls along the lines of a grid: three or four of them meet in an edge."""
    columns, rows = rng.integers(1, 6, 2)
    height = max(1, int(number / ((columns + 1) * (rows + 1)) / rng.choice([1, 2, 4])))
    quads = np.concatenate(
        [
            box_quads((i, j, 0), (i + 1, j + 1, height))
            for i, j in np.ndindex(int(columns), int(rows))
        ]
    )
    upright = quads[..., 2].min(axis=1) < quads[..., 2].max(axis=1)
    points, quads = weld(quads[upright])
    if rng.random() < 0.5:
        _, first = np.unique(np.sort(quads, axis=1), axis=0, return_index=True)
        quads = quads[first]
    points[:, 2] *= rng.uniform(0.1, 1.0)
    return points, halves(quads)


def grid_with_holes(rng, number):
    """A rough open grid of which triangles are missing, so that it hangs together by points here
    and there."""
    side = max(3, int(np.sqrt(number)))
    points, triangles = support.grid(side, side)
    points /= side
    points[:, 2] = rng.choice([0.0, 0.1, 1.0]) / side * rng.normal(size=len(points))
    return used_only(points, triangles[rng.random(len(triangles)) > rng.choice([0.05, 0.2, 0.45])])


def components(rng, number):
    """Very many small pieces: soups of single triangles, tetrahedra, sheets, of random sizes."""
    pieces = []
    kinds = [
        (np.eye(3), np.array([[0, 1, 2]])),
        (np.eye(4, 3, -1), np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]])),
        support.grid(2, 2),
    ]
    while sum(len(points) for points, _ in pieces) < number:
        points, triangles = kinds[rng.integers(len(kinds))]
        points = points @ rotation(rng) * np.exp(rng.normal(-3.0, 1.5))
        pieces.append((points + rng.uniform(0, 1, 3), triangles))
    return joined(pieces)


def soup(rng, number):
    """A surface whose triangles share no points: to be merged, or not, or with small gaps."""
    points, triangles = rng.choice([closed_sphere, thin_sheet])(rng, number // 6 + 8)
    points = points[triangles.ravel()]
    if rng.random() < 0.3:
        points = points + rng.uniform(-1e-7, 1e-7, points.shape)
    return points, np.arange(triangles.size).reshape(-1, 3)


def fan(rng, number):
    """A point with very many triangles around it: a cone, sharp or flat, or a saddle of many
    turns."""
    sides = int(np.clip(number // rng.integers(1, 6), 3, 500))
    rings = max(1, number // sides)
    angle = 2 * np.pi * rng.choice([1, 1, 2, 7]) * np.arange(sides) / sides
    height = rng.choice([0.0, 0.5, 20.0]) * np.ones(sides)
    if rng.random() < 0.4:
        height = rng.normal(0.0, 1.0, sides)
    ring = np.column_stack([np.cos(angle), np.sin(angle), height])
    points = np.vstack([np.zeros((1, 3))] + [ring * (r / rings) for r in range(1, rings + 1)])
    i = np.arange(sides)
    right = (i + 1) % sides
    triangles = [np.column_stack([np.zeros(sides, dtype=int), 1 + i, 1 + right])]
    for r in range(rings - 1):
        below = 1 + r * sides
        quads = np.column_stack([i, i + sides, right + sides, right]) + below
        triangles.append(halves(quads))
    return points, np.concatenate(triangles)


def prism(rng, number):
    """A cylinder of long thin triangles, with flat caps or without, or a strip with one side."""
    sides = int(np.clip(number / rng.integers(2, 5), 3, 600))
    rows = max(1, number // sides - 1)
    points, triangles = support.prism(sides, rows)
    points[:, 2] *= np.exp(rng.uniform(-3, 5))
    kind = rng.integers(3)
    if kind == 1:
        ears = np.array([[0, i + 1, i] for i in range(1, sides - 1)])
        return points, np.concatenate([triangles, ears, ears[:, ::-1] + rows * sides])
    if kind == 2:
        points, triangles = support.grid(sides, rows)
        i, j = points[:, 0].astype(int), points[:, 1].astype(int)
        ids = np.where(i < sides, np.arange(len(points)), (rows - j) * (sides + 1))
        angle, across = 2 * np.pi * i / sides, rng.uniform(0.1, 1.8) * (j / rows - 0.5)
        radius = 1 + across * np.cos(angle / 2)
        points = np.column_stack(
            [radius * np.cos(angle), radius * np.sin(angle), across * np.sin(angle / 2)]
        )
        return used_only(points, ids[triangles])
    return points, triangles


def rough(rng, number):
    """A surface with so much noise that it goes through itself."""
    points, triangles = rng.choice([closed_sphere, thin_sheet])(rng, number)
    size = np.ptp(points, axis=0).max() / np.sqrt(len(points))
    return points + rng.choice([0.1, 1.0, 3.0]) * size * rng.normal(size=points.shape), triangles


BASES = [closed_sphere, thin_sheet, plate, welded_boxes, prism]


def base(rng, number):
    return BASES[rng.integers(len(BASES))](rng, number)


def doubled(rng, number):
    """Every triangle twice, or some of them, in either orientation."""
    points, triangles = base(rng, number)
    part = rng.choice([0.02, 0.3, 1.0, 1.0])
    again = triangles[rng.random(len(triangles)) < part]
    way = rng.choice(["same", "turned", "mixed"])
    turned = np.full(len(again), way == "turned")
    if way == "mixed":
        turned = rng.random(len(again)) < 0.5
    again = np.where(turned[:, None], again[:, ::-1], again)
    return points, np.concatenate([triangles, again])


def caps(rng, number):
    """Chains of points on long edges that belong to one side only, closed by triangles of next to
    no area: T-junctions that have been filled."""
    points, triangles = base(rng, max(8, number // 2))
    places, faces = list(points), [list(t) for t in triangles]
    chain = int(rng.choice([1, 3, 20]))
    shift = rng.choice([0.0, 1e-15, 1e-9, 1e-6, 1e-3])
    for a, b, one, _ in edges_apart(rng, triangles, number // (2 * chain) + 1):
        (c,) = set(faces[one]) - {a, b}
        start, end = rotated(faces[one], c)
        along = np.sort(rng.uniform(0, 1, chain))
        edge = places[end] - places[start]
        ids = [start]
        for t in along:
            ids.append(len(places))
            aside = shift * np.linalg.norm(edge) * rng.normal(size=3)
            places.append(places[start] + t * edge + aside)
        ids.append(end)
        faces[one] = [c, ids[0], ids[1]]
        faces += [[c, i, j] for i, j in zip(ids[1:-1], ids[2:])]
        faces += [[start, j, i] for i, j in zip(ids[1:-1], ids[2:])]
    return np.array(places), np.array(faces)


def needles(rng, number):
    """Edges split very close to one of their ends: triangles with a side of next to nothing."""
    points, triangles = base(rng, max(8, number // 2))
    part = rng.choice([0.0, 1e-13, 1e-9, 1e-5, 1e-2])
    edges = edges_apart(rng, triangles, number // 2 + 1)
    return split_edges(points, triangles, edges, part * rng.uniform(0.5, 1.0, len(edges)))


def stretched(rng, number):
    """Any surface, long along one axis."""
    points, triangles = base(rng, number)
    points = points * np.exp([0.0, rng.uniform(0, 3), rng.uniform(4, 14)])[rng.permutation(3)]
    return points, triangles


FAMILIES = [
    plate,
    doubled,
    welded_boxes,
    book,
    caps,
    components,
    stretched,
    needles,
    grid_with_holes,
    rough,
    soup,
    fan,
    prism,
    thin_sheet,
]


# --- Tools ---------------------------------------------------------------------------------------


def rotated(face, corner):
    """Returns the two corners after one."""
    i = face.index(corner)
    return face[(i + 1) % 3], face[(i + 2) % 3]


def joined(pieces):
    """Returns several meshes as one."""
    first = np.cumsum([0] + [len(points) for points, _ in pieces])
    return (
        np.concatenate([points for points, _ in pieces]),
        np.concatenate([triangles + start for (_, triangles), start in zip(pieces, first)]),
    )


def used_only(points, triangles):
    """Returns the mesh without the points that no triangle uses."""
    used, ids = np.unique(triangles, return_inverse=True)
    return points[used], ids.reshape(-1, 3)


def rotation(rng):
    """Returns a random rotation."""
    q, r = np.linalg.qr(rng.normal(size=(3, 3)))
    q = q * np.sign(np.diag(r))
    return q * np.linalg.det(q)


def generate(seed):
    """Returns the mesh of a seed, of about 50 to 3000 points."""
    rng = np.random.default_rng(seed)
    family = FAMILIES[seed % len(FAMILIES)]
    number = int(np.exp(rng.uniform(np.log(50), np.log(3000))))
    points, triangles = family(rng, number)
    # Numbered and turned at random, of any size and anywhere.
    order = rng.permutation(len(points))
    triangles = np.argsort(order)[triangles[rng.permutation(len(triangles))]]
    first = rng.integers(0, 3, (len(triangles), 1))
    triangles = np.take_along_axis(triangles, (first + np.arange(3)) % 3, axis=1)
    extent = np.ptp(points, axis=0).max()
    points = points[order] @ rotation(rng)
    points = points + extent * rng.choice([0.0, 1.0, 100.0]) * rng.normal(size=3)
    points = points * 10.0 ** rng.uniform(-6, 6)
    if rng.random() < 0.3:
        points = points.astype(np.float32).astype(float)  # as in files
    merge = bool(rng.random() < (0.7 if family is soup else 0.1))
    return Mesh(f"{family.__name__}-{seed}", points, triangles, merge, seed)
