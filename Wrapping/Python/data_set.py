# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""The contents of a VTK file in NumPy arrays. This module imports no VTK."""

import numpy as np

from .checks import check_ids
from .mesh import Mesh, checked_cells, unpacked

POLYHEDRON = 42  # VTK_POLYHEDRON
# VTK ends the process on cells of POLYDATA with fewer corners.
MINIMUM_CORNERS = {"verts": 1, "lines": 2, "polygons": 3, "strips": 3}
# Kinds of active arrays, by their index in vtkDataSetAttributes.
ATTRIBUTES = (
    "scalars", "vectors", "normals", "tcoords", "tensors", "globalids", "pedigreeids", "edgeflag",
    "tangents", "rationalweights", "higherorderdegrees",
)  # fmt: skip


class DataSet:
    """Points, cells and arrays of numbers.

    Parameters
    ----------
    kind : str
        "POLYDATA", "UNSTRUCTURED_GRID" or "STRUCTURED_GRID".

    Attributes
    ----------
    points : numpy.ndarray, shape (n, 3)
        Coordinates in the precision of the file.
    cells : dict of str to pair of numpy.ndarray
        Offsets and corners: "verts", "lines", "polygons" and "strips" of POLYDATA in the order of
        cell ids, "cells" of an UNSTRUCTURED_GRID.
    types : numpy.ndarray
        Cell types of an UNSTRUCTURED_GRID.
    faces : dict of int to list of numpy.ndarray
        Point ids of the faces of polyhedra, by cell id.
    dimensions : list of int
        Number of points of a STRUCTURED_GRID along each axis.
    point_data, cell_data, field_data : dict of str to numpy.ndarray
        Arrays by name.
    active : dict of int to str
        Names of the active point arrays, by index in ATTRIBUTES.
    texts : list of str
        Names of arrays of strings, which are skipped.
    is_of_vtk_8 : bool
        True if Lagrange hexahedra have the order of nodes of VTK 8.
    is_single : bool
        True if coordinates that have not changed are those of a file in single precision.
    may_be_cut : bool
        True if the file ends with a number without a line end, which may have lost digits.
    """

    def __init__(self, kind):
        self.kind = kind
        self.points = np.zeros((0, 3))
        names = MINIMUM_CORNERS if kind == "POLYDATA" else ("cells",)
        self.cells = dict.fromkeys(names, (np.zeros(1, dtype=int), np.zeros(0, dtype=int)))
        self.types = np.zeros(0, dtype=int)
        self.faces = {}
        self.dimensions = [0, 0, 0]
        self.point_data, self.cell_data, self.field_data = {}, {}, {}
        self.active = {}
        self.texts = []
        self.is_of_vtk_8 = False
        self.is_single = False
        self.may_be_cut = False

    @classmethod
    def of(cls, mesh):
        """Returns the contents of a Mesh, whose arrays are shared."""
        result = cls("POLYDATA")
        result.points = mesh.points
        result.cells.update(verts=mesh.verts, lines=mesh.lines, polygons=mesh.polygons)
        result.point_data, result.cell_data = mesh.point_data, mesh.cell_data
        result.field_data, result.active = mesh.field_data, mesh._active
        result.is_single = mesh._is_single
        return result

    def stored_points(self):
        """Returns the coordinates, in single precision for unchanged ones of a file that stores it."""
        values = self.points
        if self.is_single and np.array_equal(values.astype(np.float32), values, equal_nan=True):
            values = values.astype(np.float32)
        return values

    def number_of_cells(self):
        """Returns the number of cells of all kinds."""
        if self.kind == "STRUCTURED_GRID":
            return int(np.prod([max(n - 1, 1) for n in self.dimensions], dtype=object))
        return sum(len(offsets) - 1 for offsets, _ in self.cells.values())

    def set_faces(self, cell, faces):
        """Sets the faces of a polyhedron."""
        if len(faces) < 4 or min(map(len, faces)) < 3:
            raise ValueError(f"cell {cell}: expected at least 4 faces with 3 corners")
        check_ids(np.concatenate(faces), len(self.points), f"faces of cell {cell}")
        self.faces[cell] = faces

    def remove_degenerate(self):
        """Removes cells of POLYDATA with too few corners, and returns their number."""
        kept = []
        for name, minimum in MINIMUM_CORNERS.items():
            offsets, corners = checked_cells(self.cells[name], name, len(self.points))
            sizes = np.diff(offsets)
            kept.append(sizes >= minimum)
            if not kept[-1].all():
                ends = np.cumsum(sizes[kept[-1]])
                self.cells[name] = np.append(0, ends), corners[np.repeat(kept[-1], sizes)]
        kept = np.concatenate(kept)
        if not kept.all():
            self.cell_data = {name: values[kept] for name, values in self.cell_data.items()}
        return np.count_nonzero(~kept)

    def mesh(self):
        """Returns POLYDATA as a Mesh. Strips become triangles."""
        cells = dict(self.cells)
        cell_data = self.cell_data
        strips = checked_cells(cells.pop("strips"), "strips", len(self.points))
        if len(strips[1]):
            triangles, strip = _triangles_of(*strips)
            offsets, corners = cells["polygons"]
            ends = offsets[-1] + 3 * np.arange(1, len(triangles) + 1)
            cells["polygons"] = (
                np.concatenate([offsets, ends]), np.concatenate([corners, triangles.ravel()])
            )  # fmt: skip
            first = self.number_of_cells() - len(strips[0]) + 1
            rows = np.concatenate([np.arange(first), first + strip])
            cell_data = {name: values[rows] for name, values in cell_data.items()}
        mesh = Mesh(
            self.points,
            **cells,
            point_data=self.point_data,
            cell_data=cell_data,
            field_data=self.field_data,
        )
        mesh._is_single = self.is_single or self.points.dtype == np.float32
        mesh._active = self.active
        return mesh


def faces_of(stream):
    """Returns the faces of a polyhedron in one row [number of faces, size, ids, size, ids, ...]."""
    try:
        sizes, ids = unpacked(stream[1:])
    except (IndexError, ValueError):
        sizes = []
    if len(sizes) == 0 or len(sizes) != stream[0]:
        raise ValueError("the sizes of faces contradict the number of entries of a polyhedron")
    return np.split(ids, np.cumsum(sizes)[:-1])


def in_rows(values, components):
    """Returns the values of an array, in rows if they have several components."""
    if components == 0:
        raise ValueError("expected at least 1 component, got 0")
    return values if components == 1 else values.reshape(-1, components)


def parsed(text, dtype):
    """Returns the numbers of a text as an array."""
    dtype = np.dtype(dtype)
    in_word = np.frombuffer(text, np.uint8) > 32
    number = np.count_nonzero(in_word[1:] & ~in_word[:-1]) + in_word[:1].sum()
    if number == 0:
        return np.zeros(0, dtype)
    kind, widest = (float, np.float64) if dtype.kind == "f" else (int, np.int64)
    try:
        values = np.fromstring(text, widest, sep=" ")
    except (DeprecationWarning, ValueError):
        values = ()
    # At a word that is not a number, some versions of NumPy return the numbers before the word, and
    # the digits at its beginning.
    if len(values) != number or not _is_number(text.rsplit(None, 1)[-1], kind):
        word = next((word for word in text.split() if not _is_number(word, kind)), text)
        raise ValueError(f"expected numbers, got {word[:30].decode('latin-1')!r}")
    with np.errstate(over="ignore"):  # numbers beyond single precision become infinite
        found = values.astype(dtype, copy=False)
    if dtype.kind != "f":
        wide, limits = np.iinfo(np.int64), np.iinfo(dtype)
        # Larger numbers than those of int64 have become its limits.
        doubtful = (found != values) | (values == wide.min) | (values == wide.max)
        words = text.split() if doubtful.any() else ()
        for i in np.flatnonzero(doubtful).tolist():
            if not limits.min <= int(words[i]) <= limits.max:
                raise ValueError(f"{words[i][:30].decode('latin-1')} does not fit into {dtype}")
            found[i] = int(words[i])
    return found


def _is_number(word, kind):
    try:
        kind(word.replace(b"_", b"?"))  # Python allows 1_000
    except ValueError:
        return False
    return True


def merged(pieces):
    """Returns several pieces as one DataSet, without their field data."""
    result = DataSet(pieces[0].kind)
    result.active = pieces[0].active
    result.points = np.concatenate([piece.points for piece in pieces])
    result.types = np.concatenate([piece.types for piece in pieces])
    starts = np.cumsum([0] + [len(piece.points) for piece in pieces])
    for name in result.cells:
        sizes = np.concatenate([np.diff(piece.cells[name][0]) for piece in pieces])
        corners = [piece.cells[name][1] + start for piece, start in zip(pieces, starts)]
        offsets = np.concatenate([[0], np.cumsum(sizes)])
        result.cells[name] = (offsets, np.concatenate(corners))
    cell = 0
    for piece, start in zip(pieces, starts):
        for i, faces in piece.faces.items():
            result.faces[cell + i] = [ids + start for ids in faces]
        cell += piece.number_of_cells()
    result.point_data = _joined([piece.point_data for piece in pieces])
    # Cells are sorted by their kinds in each piece, and so they are in the result.
    numbers = [[len(offsets) - 1 for offsets, _ in piece.cells.values()] for piece in pieces]
    kinds = np.concatenate([np.repeat(np.arange(len(row)), row) for row in numbers])
    order = np.argsort(kinds, kind="stable")
    cell_data = _joined([piece.cell_data for piece in pieces])
    result.cell_data = {name: values[order] for name, values in cell_data.items()}
    return result


def _joined(parts):
    """Returns the arrays of all pieces."""
    if any(part.keys() != parts[0].keys() for part in parts):
        raise ValueError(f"not all pieces have the same arrays ({', '.join(parts[0])})")
    return {name: np.concatenate([part[name] for part in parts]) for name in parts[0]}


def _triangles_of(offsets, corners):
    """Returns the triangles of strips, shape (m, 3), and the index of the strip of each."""
    sizes = np.diff(offsets) - 2
    strip = np.repeat(np.arange(len(sizes)), sizes)
    step = np.arange(len(strip)) - np.repeat(np.cumsum(sizes) - sizes, sizes)
    at = offsets[strip] + step
    odd = step % 2  # every second triangle has the opposite orientation
    return corners[np.column_stack([at + odd, at + 1 - odd, at + 2])], strip
