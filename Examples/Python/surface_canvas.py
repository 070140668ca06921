# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Curves in a picture plane, and their projection onto a surface along the viewing direction."""

import numpy as np
import vtkdgg
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import mutable
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkStaticCellLocator, vtkStaticPointLocator
from vtkmodules.vtkFiltersCore import vtkContourFilter, vtkStripper

STEP = 0.016  # distance between points of curves


def smooth(points, is_closed=False):
    """Returns a Catmull-Rom curve through points, in steps of STEP."""
    points = np.asarray(points, dtype=float)
    if is_closed:
        points = np.concatenate([points[-1:], points, points[:2]])
    else:
        before, after = 2 * points[0] - points[1], 2 * points[-1] - points[-2]
        points = np.concatenate([[before], points, [after]])
    t = np.linspace(0.0, 1.0, 33)[:-1, None]
    a, b, c, d = (points[k : len(points) - 3 + k, None] for k in range(4))
    fine = b + 0.5 * t * (c - a + t * (2 * a - 5 * b + 4 * c - d + t * (3 * (b - c) + d - a)))
    return resample(np.concatenate([fine.reshape(-1, points.shape[1]), points[-2:-1]]), is_closed)


def resample(points, is_closed, step=STEP):
    """Returns a polyline in equal steps. A closed polyline ends with its first point; the result
    omits this last point."""
    along = np.cumsum(np.linalg.norm(np.diff(points, axis=0, prepend=points[:1]), axis=1))
    count = max(8 if is_closed else 3, int(round(along[-1] / step)) + 1)
    at = np.linspace(0.0, along[-1], count)
    new = np.stack([np.interp(at, along, x) for x in points.T], axis=1)
    return new[:-1] if is_closed else new


def ellipse(u, v, width, height, turn=0.0):
    """Returns points around a position of the picture plane, counter-clockwise."""
    count = max(12, int(round(np.pi * (width + height) / STEP)))
    angle = np.linspace(0.0, 2.0 * np.pi, count + 1)[:-1]
    x, y = width * np.cos(angle), height * np.sin(angle)
    c, s = np.cos(turn), np.sin(turn)
    return np.stack([u + c * x - s * y, v + s * x + c * y], axis=1)


def tangents(points, is_closed):
    """Returns tangents along a polyline, not normalized."""
    if is_closed:
        return np.roll(points, -1, axis=0) - np.roll(points, 1, axis=0)
    return np.gradient(points, axis=0)


def ids_of(lines):
    """Returns the point ids of each polyline of a vtkCellArray."""
    offsets = vtk_to_numpy(lines.GetOffsetsArray())
    return np.split(vtk_to_numpy(lines.GetConnectivityArray()), offsets[1:-1])


def lines_of(data):
    """Returns the coordinates of each polyline of a vtkPolyData."""
    points = np.array(vtk_to_numpy(data.GetPoints().GetData()), dtype=float)
    return [points[ids] for ids in ids_of(data.GetLines())]


class Field:
    """A function on a grid of the picture plane."""

    def __init__(self, low, high, step):
        u, v = (np.arange(first, last, step) for first, last in zip(low, high))
        self.origin, self.step = low, step
        self.places = np.stack(np.meshgrid(u, v), axis=-1)
        self.values = np.full(self.places.shape[:2], np.inf)

    def add_stroke(self, line, radius):
        """Make the function negative within a radius, which varies along the polyline."""
        for a, b, r in zip(line[:-1], line[1:], radius):
            away, along = self.places - a, b - a
            t = np.clip(away @ along / (along @ along), 0.0, 1.0)
            distance = np.hypot(*np.moveaxis(away - t[..., None] * along, -1, 0))
            self.values = np.minimum(self.values, distance - r)

    def outlines(self):
        """Returns the closed polylines where the function is 0, counter-clockwise around negative
        values."""
        image = vtkImageData()
        image.SetDimensions(self.values.shape[1], self.values.shape[0], 1)
        image.SetOrigin(*self.origin, 0.0)
        image.SetSpacing(self.step, self.step, 1.0)
        image.GetPointData().SetScalars(numpy_to_vtk(self.values.ravel(), deep=True))
        contour = vtkContourFilter()
        contour.SetInputData(image)
        contour.SetValue(0, 0.0)
        join = vtkStripper()
        join.SetInputConnection(contour.GetOutputPort())
        join.JoinContiguousSegmentsOn()
        join.SetMaximumLength(self.values.size)
        lines = [resample(line[:, :2], True, 0.011) for line in lines_of(vtkdgg.check(join))]
        areas = [np.cross(line, np.roll(line, -1, axis=0)).sum() for line in lines]
        return [line if area > 0.0 else line[::-1] for line, area in zip(lines, areas)]


class Canvas:
    """A surface with normals, and the picture plane in front of it. The viewing direction is given
    by an angle around the y axis and an elevation, degrees."""

    def __init__(self, mesh, around, above):
        self.mesh = mesh
        self.normals = vtk_to_numpy(mesh.GetPointData().GetNormals())
        a, e = np.radians((around, above))
        self.sight = np.array([np.sin(a) * np.cos(e), np.sin(e), np.cos(a) * np.cos(e)])
        right = np.array([np.cos(a), 0.0, -np.sin(a)])
        self.axes = np.stack([right, np.cross(self.sight, right)])
        self.rays = vtkStaticCellLocator()
        self.rays.SetDataSet(mesh)
        self.rays.BuildLocator()
        self.points = vtkStaticPointLocator()
        self.points.SetDataSet(mesh)
        self.points.BuildLocator()

    def place(self, drawn, sign=1.0):
        """Returns the surface points seen at points of the picture plane; from behind with sign -1.
        """
        result = np.empty((len(drawn), 3))
        t, part, cell, hit, inside = mutable(0.0), mutable(0), mutable(0), [0.0] * 3, [0.0] * 3
        far = sign * self.mesh.GetLength() * self.sight
        for k, point in enumerate(np.asarray(drawn) @ self.axes):
            if not self.rays.IntersectWithLine(
                point + far, point - far, 1e-9, t, hit, inside, part, cell
            ):
                where = "{:.3g}, {:.3g}".format(*drawn[k])
                raise ValueError(f"a curve is drawn at {where}, but no surface is there")
            result[k] = hit
        return result

    def nearest(self, points):
        """Returns the ids of the closest points of the mesh."""
        return [self.points.FindClosestPoint(point) for point in points]

    def flat(self, u, v):
        """Returns the images in the picture plane of the directions right and up of the tangent
        plane."""
        near = self.place(ellipse(u, v, 0.05, 0.05))
        normal = self.normals[self.nearest(near)].mean(axis=0)
        normal /= np.linalg.norm(normal)
        up = self.axes[1] - normal * (normal @ self.axes[1])
        up /= np.linalg.norm(up)
        return np.stack([np.cross(up, normal), up]) @ self.axes.T

    def left(self, points, is_closed):
        """Returns unit vectors to the left of a curve."""
        left = np.cross(self.normals[self.nearest(points)], tangents(points, is_closed))
        return left / np.maximum(np.linalg.norm(left, axis=1), 1e-30)[:, None]

    def with_left(self, points, direction):
        """Returns a closed curve, reversed if needed to have that direction on its left."""
        return points if self.left(points, True).sum(axis=0) @ direction > 0.0 else points[::-1]


class Polar:
    """Polar coordinates around a surface point, as seen in the picture plane."""

    def __init__(self, canvas, u, v, radius, turn):
        self.middle, self.turn = np.array([u, v]), turn
        self.axes = radius * canvas.flat(u, v)

    def at(self, r, angle):
        """Returns points of the picture plane."""
        angle = angle + self.turn
        return self.middle + np.stack([r * np.cos(angle), r * np.sin(angle)], axis=-1) @ self.axes

    def coordinates(self, points):
        """Returns radius and angle of points of the picture plane."""
        x, y = np.moveaxis((points - self.middle) @ np.linalg.inv(self.axes), -1, 0)
        return np.hypot(x, y), np.arctan2(y, x) - self.turn
