# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""The same surface with triangles that meet the condition of Delaunay, by vertices on its edges, to
compare with intrinsic flips (Y.-J. Liu, C.-X. Xu, D. Fan, Y. He, "Efficient construction and
simplification of Delaunay meshes", ACM Trans. Graph. 34(6), 2015).

Edges of the surface are split, those within one of its faces are flipped, until opposite angles sum
to no more than 180 degrees. Edges that begin at a vertex of the surface are split at distances from
it that are powers of two: edges side by side get the same ones, or they would split each other for
ever.
"""

import math

import numpy as np


class DelaunayMesh:
    """Points, the first of which are those given, and triangles."""

    def __init__(self, points, triangles, most=50):
        self.points = [np.array(point) for point in points]
        self.given = len(points)
        self.limit = most * len(points)
        self.faces = {}  # {face: (corners, face of the surface that contains it)}
        self.across = {}  # {(a, b): face with this directed edge}
        self.count = 0
        for i, corners in enumerate(triangles.tolist()):
            self.add(corners, i)
        self.pending = list(self.across)
        while self.pending:
            self.mend(*self.pending.pop())

    def add(self, corners, parent):
        self.faces[self.count] = (corners, parent)
        for i in range(3):
            self.across[corners[i], corners[(i + 1) % 3]] = self.count
        self.count += 1

    def remove(self, face):
        corners, parent = self.faces.pop(face)
        for i in range(3):
            del self.across[corners[i], corners[(i + 1) % 3]]
        return parent

    def apex(self, a, b):
        """The corner opposite to an edge of a face."""
        return next(c for c in self.faces[self.across[a, b]][0] if c not in (a, b))

    def angle(self, a, b):
        """The angle opposite to that edge."""
        apex = self.points[self.apex(a, b)]
        u, v = self.points[a] - apex, self.points[b] - apex
        return math.atan2(np.linalg.norm(np.cross(u, v)), u @ v)

    def mend(self, a, b):
        """Split or flip an edge that does not meet the condition; those around are looked at again."""
        if (a, b) not in self.across or (b, a) not in self.across:
            return  # removed, or on the boundary
        if self.angle(a, b) + self.angle(b, a) <= math.pi + 1e-9:
            return
        c, d = self.apex(a, b), self.apex(b, a)
        left = self.remove(self.across[a, b])
        right = self.remove(self.across[b, a])
        if left == right:
            self.add([c, a, d], left)
            self.add([c, d, b], left)
        else:
            middle = self.split(a, b)
            for corners in ([c, a, middle], [c, middle, b]):
                self.add(corners, left)
            for corners in ([d, middle, a], [d, b, middle]):
                self.add(corners, right)
            self.pending += [(c, middle), (d, middle), (a, middle), (middle, b)]
        self.pending += [(c, a), (a, d), (d, b), (b, c)]

    def split(self, a, b):
        """A new point on an edge."""
        if len(self.points) >= self.limit:
            raise ValueError("more and more vertices")
        if a >= self.given:
            a, b = b, a
        way = self.points[b] - self.points[a]
        length = np.linalg.norm(way)
        half = 2.0 ** round(math.log2(0.5 * length)) if a < self.given else 0.5 * length
        self.points.append(self.points[a] + way * (half / length))
        return len(self.points) - 1

    def arrays(self):
        return np.array(self.points), np.array([corners for corners, _ in self.faces.values()])
