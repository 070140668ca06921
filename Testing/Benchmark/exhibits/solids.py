# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tools for triangulated solids: planar regions with holes, skins, split edges."""

import numpy as np

WELDED = 1e-7  # size of the cells in which points are merged, as a fraction of the extent
COCIRCULAR = 1e-9  # in-circle test below which an edge is not flipped, relative


class Solid:
    """A surface of planar regions and skins, which are welded at equal points. `is_delaunay` chooses
    the triangles of regions: constrained Delaunay, or those of ear clipping."""

    def __init__(self, is_delaunay=True):
        self._is_delaunay = is_delaunay
        self._corners = []

    def fill(self, outline, *holes):
        """Adds the region between planar rings. The outline is counterclockwise from outside."""
        rings = [np.asarray(ring, dtype=float) for ring in (outline, *holes)]
        normal = np.cross(rings[0], np.roll(rings[0], -1, axis=0)).sum(axis=0)
        u = np.cross(normal, np.eye(3)[np.argmin(np.abs(normal))])
        axes = np.stack([u, np.cross(normal, u)], axis=1)
        flat = [ring @ (axes / np.linalg.norm(axes, axis=0)) for ring in rings]
        for k in range(1, len(rings)):
            if cross(flat[k], np.roll(flat[k], -1, axis=0)).sum() > 0.0:
                flat[k], rings[k] = flat[k][::-1], rings[k][::-1]
        triangles = triangulate(flat, self._is_delaunay)
        self._corners.append(np.concatenate(rings)[triangles])
        return self

    def skin(self, rings, is_closed=True):
        """Adds a skin over rings with equal numbers of points. Rings that follow each other upwards
        are counterclockwise from above. Rings that are not closed are curves."""
        rings = np.asarray(rings, dtype=float)
        count = rings.shape[1]
        points = rings.reshape(-1, 3)
        i = np.arange(count if is_closed else count - 1)
        below = count * np.arange(len(rings) - 1)[:, None]
        quads = np.stack([i, (i + 1) % count, (i + 1) % count + count, i + count], axis=-1)
        self._corners.append(points[halves((quads + below[..., None]).reshape(-1, 4))])
        return self

    def arrays(self):
        """Returns points and triangles."""
        corners = np.concatenate(self._corners).reshape(-1, 3)
        # A shift of the cells, because coordinates are often round numbers.
        cells = np.rint(corners / (WELDED * np.ptp(corners, axis=0).max()) + 0.314)
        _, first, ids = np.unique(cells, axis=0, return_index=True, return_inverse=True)
        triangles = ids.reshape(-1, 3)
        is_used = (triangles != np.roll(triangles, -1, axis=1)).all(axis=1)
        return corners[first], triangles[is_used]


def extrude(outlines, height, is_delaunay=False, twist=0.0, taper=1.0, rows=1, is_closed=True):
    """Returns a solid of a height over a region between outlines, counterclockwise except for
    holes. On the way up the region turns by `twist` degrees and shrinks by `taper`, in `rows` steps.
    An open solid has no top and bottom."""
    flat = np.concatenate(outlines)
    points = []
    for t in np.linspace(0.0, 1.0, rows + 1):
        c, s = np.cos(np.radians(twist * t)), np.sin(np.radians(twist * t))
        turn = (1.0 + (taper - 1.0) * t) * np.array([[c, s], [-s, c]])
        points.append(np.column_stack([flat @ turn, np.full(len(flat), height * t)]))
    walls = [np.column_stack([ids, np.roll(ids, -1)]) for ids in rings_of(outlines)]
    walls = np.concatenate([np.column_stack([w, w[:, ::-1] + len(flat)]) for w in walls])
    triangles = [halves(walls + k * len(flat)) for k in range(rows)]
    if is_closed:
        top = triangulate(outlines, is_delaunay)
        triangles = [top + rows * len(flat), top[:, ::-1], *triangles]
    return np.vstack(points), np.ascontiguousarray(np.concatenate(triangles))


def halves(quads, other_diagonal=False):
    """Returns two triangles for each quad; `other_diagonal` chooses the diagonal of each."""
    quads = np.where(np.reshape(other_diagonal, (-1, 1)), np.roll(quads, 1, axis=1), quads)
    return np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])


def cross(u, v):
    """Returns the cross products of vectors in the plane."""
    return u[..., 0] * v[..., 1] - u[..., 1] * v[..., 0]


# --- Planar regions ------------------------------------------------------------------------------


def rings_of(outlines):
    """Returns the ids of the points of each outline, numbered one outline after the other."""
    first = np.cumsum([0] + [len(outline) for outline in outlines])
    return [np.arange(begin, end) for begin, end in zip(first[:-1], first[1:])]


def triangulate(outlines, is_delaunay=False):
    """Returns triangles of the region between outlines, counterclockwise except for holes."""
    flat, rings = np.concatenate(outlines), rings_of(outlines)
    triangles = clip_ears(flat, bridged(flat, rings))
    if not is_delaunay:
        return triangles
    fixed = np.concatenate([np.column_stack([ids, np.roll(ids, -1)]) for ids in rings])
    return flip_edges(flat, triangles, fixed)


def bridged(flat, rings):
    """Returns one ring of ids of an outline and of its holes, which are joined one by one."""
    ring, holes = rings[0], sorted(rings[1:], key=lambda ids: -flat[ids, 0].max())
    while holes:
        hole = holes.pop(0)
        edges = [np.column_stack([ids, np.roll(ids, -1)]) for ids in [ring, hole, *holes]]
        i, j = bridge(flat, ring, hole, flat[np.concatenate(edges)].transpose(1, 0, 2))
        hole = np.roll(hole, -j)
        ring = np.concatenate([ring[: i + 1], hole, hole[:1], ring[i:]])
    return ring


def bridge(flat, ring, hole, edges):
    """Returns the indices of points of a ring and a hole that see each other."""
    _, once, times = np.unique(ring, return_index=True, return_counts=True)
    once = once[times == 1]  # from ends of bridges, only one side is visible
    p, q = edges
    for j in np.argsort(-flat[hole, 0]):
        a = flat[hole[j]]
        for i in once[np.argsort(np.linalg.norm(flat[ring[once]] - a, axis=1))]:
            b = flat[ring[i]]
            crossed = cross(q - p, a - p) * cross(q - p, b - p) < 0
            crossed &= cross(b - a, p - a) * cross(b - a, q - a) < 0
            if not crossed.any():
                return i, j
    raise ValueError("no bridge to a hole")


def clip_ears(flat, ring):
    """Returns the triangles of a simple polygon by ear clipping."""
    triangles, i = [], 0
    while len(ring) > 2:
        for _ in range(len(ring)):
            i %= len(ring)
            ids = ring[[i - 1, i, (i + 1) % len(ring)]]
            a, b, c = flat[ids]
            if cross(b - a, c - a) > 0:
                inside = (ring != ids[0]) & (ring != ids[1]) & (ring != ids[2])
                for p, q in ((a, b), (b, c), (c, a)):
                    inside[inside] = cross(q - p, flat[ring[inside]] - p) >= 0
                if not inside.any():
                    break
            i += 1
        triangles.append(ids)
        ring = np.delete(ring, i % len(ring))
    return np.array(triangles)


def flip_edges(flat, triangles, fixed):
    """Returns the constrained Delaunay triangles of a region by flips (Lawson, "Software for C1
    surface interpolation", 1977). The edges `fixed` remain."""
    apexes = {}  # of directed edges
    for a, b, c in triangles.tolist():
        apexes.update({(a, b): c, (b, c): a, (c, a): b})
    points = flat.tolist()
    kept = {frozenset(edge) for edge in fixed.tolist()}
    pending = [edge for edge in apexes if edge[0] < edge[1] and frozenset(edge) not in kept]
    while pending:
        a, b = pending.pop()
        c, d = apexes.get((a, b)), apexes.get((b, a))
        if c is None or d is None or not is_in_circle(*(points[i] for i in (a, b, c, d))):
            continue
        for edge in ((a, b), (b, a)):
            del apexes[edge]
        for triangle in ((a, d, c), (d, b, c)):
            for k in range(3):
                apexes[triangle[k], triangle[k - 2]] = triangle[k - 1]
        outer = ((a, d), (d, b), (b, c), (c, a))
        pending += [edge for edge in outer if frozenset(edge) not in kept]
    found = {(a, b, c) for (a, b), c in apexes.items() if a < b and a < c}
    return np.array(sorted(found))


def is_in_circle(a, b, c, d):
    """Returns true if d lies inside the circle through the counterclockwise points a, b, c."""
    (ax, ay), (bx, by), (cx, cy) = ((p[0] - d[0], p[1] - d[1]) for p in (a, b, c))
    aa, bb, cc = ax * ax + ay * ay, bx * bx + by * by, cx * cx + cy * cy
    terms = (aa * (bx * cy - by * cx), bb * (cx * ay - cy * ax), cc * (ax * by - ay * bx))
    return sum(terms) > COCIRCULAR * sum(map(abs, terms))


# --- Splitting edges -----------------------------------------------------------------------------


def edges_apart(rng, triangles, count):
    """Returns edges with two triangles, no triangle twice: (a, b, triangle, triangle)."""
    faces_of = {}
    for face, (a, b, c) in enumerate(triangles.tolist()):
        for edge in ((a, b), (b, c), (c, a)):
            faces_of.setdefault(frozenset(edge), []).append(face)
    candidates = [(edge, faces) for edge, faces in faces_of.items() if len(faces) == 2]
    taken, found = set(), []
    for i in rng.permutation(len(candidates)):
        edge, faces = candidates[i]
        if len(found) < count and not taken.intersection(faces):
            taken.update(faces)
            found.append((*sorted(edge), *faces))
    return found


def split_edges(points, triangles, edges, fractions):
    """Returns the mesh with edges of `edges_apart` split at fractions of their lengths."""
    places, faces = list(points), [list(t) for t in triangles]
    for (a, b, one, two), fraction in zip(edges, fractions):
        m = len(places)
        places.append(places[a] + fraction * (places[b] - places[a]))
        for face in (one, two):
            faces.append([m if i == a else i for i in faces[face]])
            faces[face] = [m if i == b else i for i in faces[face]]
    return np.array(places), np.array(faces)
