# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Legacy VTK files of polygons, unstructured and structured grids.

VTK's own readers are not used: they return a part of a truncated file without an error, or end the
process.
"""

import itertools
import re
from urllib.parse import unquote_to_bytes

import numpy as np

from .checks import counted
from .data_set import ATTRIBUTES, POLYHEDRON, DataSet, faces_of, in_rows, parsed
from .mesh import unpacked

_KINDS = ("POLYDATA", "UNSTRUCTURED_GRID", "STRUCTURED_GRID")
# Types in binary files.
_TYPES = {
    "bit": "u1", "char": "i1", "signed_char": "i1", "unsigned_char": "u1", "short": "i2",
    "unsigned_short": "u2", "int": "i4", "unsigned_int": "u4", "vtkidtype": "i4", "float": "f4",
    "double": "f8", "long": "i8", "unsigned_long": "u8", "vtktypeint64": "i8",
    "vtktypeuint64": "u8",
}  # fmt: skip
_TEXTS = ("string", "utf8_string", "variant")
# Sections of one array with a fixed number of components, and the kind of active array.
_COMPONENTS = {
    "vectors": (3, "vectors"), "normals": (3, "normals"), "tensors": (9, "tensors"),
    "tensors6": (6, "tensors"), "global_ids": (1, "globalids"),
    "pedigree_ids": (1, "pedigreeids"), "edge_flags": (1, "edgeflag"),
}  # fmt: skip
_CELLS = {
    "vertices": "verts", "lines": "lines", "polygons": "polygons", "triangle_strips": "strips",
    "cells": "cells",
}  # fmt: skip
_DATA = ("point_data", "cell_data")
_WORD = re.compile(rb"\S+")


class LegacyFile:
    """A legacy file in memory.

    Parameters
    ----------
    data : bytes
    """

    def __init__(self, data):
        self._data = data
        self._at = 0
        first, _ = self._line(), self._line()
        mode, dataset = (self._next_line() or b"" for _ in range(2))
        version = re.match(rb"# vtk DataFile Version (\d+)\.(\d*)", first)
        words = dataset.decode("latin-1").upper().split()
        if not version or len(words) != 2 or words[0] != "DATASET":
            raise ValueError("the header of a legacy VTK file is missing or incomplete")
        if len(version[1]) > 1 or version[1] > b"5":
            raise ValueError(f"version {version[1][:20].decode()} is unknown; expected at most 5.1")
        if words[1] not in _KINDS:
            raise ValueError(f"expected a DATASET {' or '.join(_KINDS)}, got {words[1][:40]}")
        if mode.upper() not in (b"ASCII", b"BINARY"):
            raise ValueError(f"expected ASCII or BINARY in line 3, got {mode[:20]}")
        self._is_new = version[1] == b"5"
        self._is_binary = mode.upper() == b"BINARY"
        self._line_ends = set()
        self._result = DataSet(words[1])
        self._result.is_of_vtk_8 = (version[1], version[2]) < (b"5", b"1")
        # Arrays of the current section, and their number of rows.
        self._arrays, self._rows = self._result.field_data, None

    def read(self):
        """Returns a DataSet. Raises a ValueError if data are missing or contradict their counts."""
        key = None
        while True:
            line = self._next_line()
            if line is None and key in _DATA:
                raise ValueError(f"{self._end()}: arrays are missing")
            if line is None:
                return self._result
            words = line.split()
            key = words[0].decode("latin-1").lower()
            try:
                self._section(key, words)
            except (AttributeError, LookupError, TypeError, ValueError) as error:
                reason = str(error) if type(error) is ValueError else "the line is damaged"
                text = line.decode("latin-1")[:40]
                raise ValueError(f"in the section {text!r}: {reason}") from None

    def _section(self, key, words):
        """Reads the data that follow a line of keywords."""
        data = self._result
        rows = self._rows
        if key == "metadata":
            self._metadata()
        elif key == "field":
            self._fields(_count(words[2]))
        elif key in _DATA:
            number = len(data.points) if key == "point_data" else data.number_of_cells()
            if _count(words[1]) != number:
                raise ValueError(f"the number of {key[:-5]}s is {number}")
            self._arrays, self._rows = getattr(data, key), number
        elif rows is None:
            self._geometry(key, words)
        elif key == "scalars":
            self._keyword("lookup_table")
            self._add(words, words[2], _count(words[3]) if len(words) > 3 else 1, "scalars")
        elif key == "color_scalars":
            self._add(words, None, _count(words[2]), "scalars")
        elif key == "texture_coordinates":
            self._add(words, words[3], _count(words[2]), "tcoords")
        elif key == "lookup_table":
            self._colors(4 * _count(words[2]))
        elif key in _COMPONENTS:
            self._add(words, words[2], *_COMPONENTS[key])
        else:
            raise ValueError("the keyword is unknown")

    def _geometry(self, key, words):
        data = self._result
        if key == "dimensions":
            data.dimensions = [_count(word) for word in words[1:4]]
            if len(data.dimensions) < 3 or 0 in data.dimensions:
                raise ValueError("expected three positive numbers")
        elif key == "points":
            values = self._values(3 * _count(words[1]), words[2])
            data.points = values.reshape(-1, 3)
        elif key == "cell_types":
            data.types = self._ids(_count(words[1]), b"int")
            self._split_polyhedra()
        elif _CELLS.get(key) in data.cells:
            data.cells[_CELLS[key]] = self._cells(_count(words[1]), _count(words[2]))
        else:
            raise ValueError("the keyword is unknown")

    def _add(self, words, kind, components, attribute):
        """Adds an array. The first of its kind becomes active."""
        name = _name(words[1])
        if kind is None:
            values = self._colors(self._rows * components)
        else:
            values = self._values(self._rows * components, kind)
        if values is None:
            self._result.texts.append(name)
            return
        self._arrays[name] = in_rows(values, components)
        if self._arrays is self._result.point_data:
            self._result.active.setdefault(ATTRIBUTES.index(attribute), name)

    def _fields(self, number):
        """Reads the arrays of a field."""
        while number > 0:
            words = self._keyword().split()
            if words[0].upper() == b"METADATA":
                self._metadata()
                continue
            name, components, rows = _name(words[0]), _count(words[1]), _count(words[2])
            if self._rows not in (None, rows):
                raise ValueError(
                    f"expected {counted(self._rows, 'row')}, got array {name!r} of {rows}"
                )
            values = self._values(components * rows, words[3])
            if values is None:
                self._result.texts.append(name)
            else:
                self._arrays[name] = in_rows(values, components)
            number -= 1

    def _metadata(self):
        """Skips lines up to a blank one."""
        line = b"-"
        while line.strip():
            line = self._line()
        if not line:
            raise ValueError(self._end())

    def _cells(self, first, second):
        """Returns offsets and corners."""
        if not self._is_new:
            row = self._ids(second, b"int")
            try:
                sizes, corners = unpacked(row) if second else ([], row)
            except ValueError:
                raise ValueError("the sizes of cells contradict the number of entries") from None
            if len(sizes) != first:
                raise ValueError(f"expected {counted(first, 'cell')}, got {len(sizes)}")
            return np.concatenate([[0], np.cumsum(sizes)]).astype(np.int64), corners
        if first == 0:
            return np.zeros(1, dtype=np.int64), np.zeros(0, dtype=np.int64)
        offsets = self._ids(first, self._keyword("offsets").split()[1])
        corners = self._ids(second, self._keyword("connectivity").split()[1])
        if offsets[0] != 0 or offsets[-1] != second or (np.diff(offsets) < 0).any():
            raise ValueError(f"expected offsets that rise from 0 to {second}")
        return offsets, corners

    def _split_polyhedra(self):
        """Replaces the rows of faces, by which a file describes polyhedra, by their corners."""
        data = self._result
        polyhedra = np.flatnonzero(data.types == POLYHEDRON).tolist()
        if not polyhedra:
            return
        offsets, corners = data.cells["cells"]
        parts = np.split(corners, offsets[1:-1])
        for i in polyhedra:
            data.set_faces(i, faces_of(parts[i]))
            parts[i] = np.unique(np.concatenate(data.faces[i]))
        ends = np.cumsum([0] + [len(part) for part in parts])
        data.cells["cells"] = (ends, np.concatenate(parts))

    def _ids(self, count, kind):
        """Returns the next integers as int64."""
        values = self._values(count, kind)
        if values.dtype.kind == "f":
            raise ValueError(f"expected integers, got {values.dtype}")
        return values.astype(np.int64)

    def _values(self, count, kind):
        """Returns the next numbers; None for texts, which are skipped."""
        kind = kind.decode("latin-1").lower()
        if kind in _TEXTS:
            self._skip_texts(count, kind)
            return None
        if kind == "bit" and self._is_binary:
            packed = np.frombuffer(self._bytes((count + 7) // 8), np.uint8)
            return np.unpackbits(packed, count=count)
        if kind not in _TYPES:
            raise ValueError(f"the type {kind[:20]!r} is unknown")
        dtype = np.dtype(_TYPES[kind])
        if self._is_binary:
            values = np.frombuffer(self._bytes(count * dtype.itemsize), dtype.newbyteorder(">"))
            values = values.astype(dtype, copy=False)
            # In a file, either all arrays are followed by a line end, or none. If an array lacks a
            # byte, the line end after it is read as part of the array.
            if count:
                self._line_ends.add(self._data[self._at : self._at + 1] == b"\n")
            if len(self._line_ends) > 1:
                raise ValueError("bytes are missing or superfluous here or in an earlier section")
        else:
            values = parsed(self._words(count), dtype)
        return values.astype(np.int64) if kind == "vtkidtype" else values

    def _colors(self, count):
        """Returns the next colors, which are numbers between 0 and 1 in a text."""
        if self._is_binary:
            return self._values(count, b"unsigned_char")
        values = self._values(count, b"float")
        if not ((values >= 0.0) & (values <= 1.0)).all():
            raise ValueError("expected colors from 0 to 1")
        return (255.0 * values.astype(np.float64) + 0.5).astype(np.uint8)

    def _skip_texts(self, count, kind):
        """Skips texts. Each is a line; in binary files its length precedes it. Variants are pairs
        of words in both."""
        if kind == "variant":
            self._words(2 * count)
        for _ in range(count if kind != "variant" else 0):
            if self._at >= len(self._data):
                raise ValueError(self._end())
            if self._is_binary:
                # The first two bits encode the number of bytes of the length.
                width = 8 >> (self._data[self._at] >> 6)
                length = int.from_bytes(self._bytes(width), "big") & (1 << 8 * width - 2) - 1
                self._bytes(length)
            else:
                self._line()

    def _bytes(self, count):
        """Returns the next bytes."""
        start = self._at
        self._at += count
        if self._at > len(self._data):
            raise ValueError(self._end())
        return self._data[start : self._at]

    def _words(self, count):
        """Returns the next words, as one text."""
        if count == 0:
            return b""
        start = self._at
        words = _WORD.finditer(self._data, start)
        last = next(itertools.islice(words, min(count, len(self._data)) - 1, None), None)
        if last is None:
            raise ValueError(self._end())
        self._at = last.end()
        self._result.may_be_cut = self._at == len(self._data)
        return self._data[start : self._at]

    def _keyword(self, word=None):
        """Returns the next line. Raises an error if it does not begin with `word`."""
        line = self._next_line()
        if line is None:
            raise ValueError(self._end())
        if word and line.split()[0].decode("latin-1").lower() != word:
            raise ValueError(f"expected {word.upper()}, got {line[:20].decode('latin-1')!r}")
        return line

    def _next_line(self):
        """Returns the next line that is not blank; None at the end."""
        while self._at < len(self._data):
            line = self._line().strip()
            if line:
                return line
        return None

    def _line(self):
        end = self._data.find(b"\n", self._at)
        start, self._at = self._at, len(self._data) if end < 0 else end + 1
        return self._data[start : self._at]

    def _end(self):
        return f"the file ends too early, after {len(self._data)} bytes"


def _count(word):
    """Returns a count."""
    if not word.isdigit():
        raise ValueError(f"{word[:20].decode('latin-1')!r} is not a count")
    return int(word)


def _name(word):
    """Returns a name in which special characters are written as %20 and the like."""
    return unquote_to_bytes(word).decode("utf-8", "replace")
