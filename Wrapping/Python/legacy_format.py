# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""A check of legacy VTK files, because VTK's readers return a part of a truncated file without an
error, or end the process."""

import itertools
import re

import numpy as np

from .mesh import unpacked

_WORD = re.compile(rb"\S+")
# Bytes of a value in a binary file.
_SIZES = {
    "bit": 0.125, "char": 1, "signed_char": 1, "unsigned_char": 1, "short": 2, "unsigned_short": 2,
    "int": 4, "unsigned_int": 4, "vtkidtype": 4, "float": 4, "double": 8, "long": 8,
    "unsigned_long": 8, "vtktypeint64": 8, "vtktypeuint64": 8,
}  # fmt: skip
_COMPONENTS = {
    "vectors": 3, "normals": 3, "tensors": 9, "tensors6": 6, "global_ids": 1, "pedigree_ids": 1,
    "edge_flags": 1,
}  # fmt: skip
_CELLS = ("vertices", "lines", "polygons", "triangle_strips", "cells")


class LegacyFile:
    """A legacy file in memory.

    Parameters
    ----------
    data : bytes

    Attributes
    ----------
    kind : str
        The word after DATASET, such as "POLYDATA".
    may_be_cut : bool
        True if the file ends with a number without a line end, which may have lost digits. Set by
        `check`.
    """

    def __init__(self, data):
        self._data = data
        self._at = 0
        first, _, self._mode, dataset = (self._line() for _ in range(4))
        version = re.match(rb"# vtk DataFile Version (\d+)\.", first)
        words = dataset.split()
        if not version or len(words) != 2 or words[0].upper() != b"DATASET":
            raise ValueError("the header of a legacy VTK file is missing or incomplete")
        self._is_new = int(version[1]) >= 5
        self._is_binary = self._mode.strip().upper() == b"BINARY"
        self.kind = words[1].decode("latin-1").upper()
        self.may_be_cut = False

    def check(self):
        """Raises a ValueError if data are missing or contradict their counts."""
        rows = None
        while True:
            line = self._next_line()
            if line is None:
                return
            words = line.decode("latin-1").lower().split()
            try:
                if words[0] in ("point_data", "cell_data"):
                    rows = int(words[1])
                else:
                    self._section(words, rows)
            except (IndexError, KeyError, TypeError, ValueError) as error:
                reason = str(error) if type(error) is ValueError else "the line is damaged"
                text = line.decode("latin-1")[:40]
                raise ValueError(f"in the section {text!r}: {reason}") from None

    def _section(self, words, rows):
        """Skips the data that follow a line of keywords."""
        key = words[0]
        if key == "points":
            self._skip(3 * int(words[1]), words[2])
        elif key in _CELLS:
            self._cells(int(words[1]), int(words[2]))
        elif key == "cell_types":
            self._skip(int(words[1]), "int")
        elif key == "scalars":
            self._keyword("lookup_table")
            self._skip(rows * int(words[3] if len(words) > 3 else 1), words[2])
        elif key == "lookup_table":
            self._skip(4 * int(words[2]), "unsigned_char")
        elif key == "color_scalars":
            self._skip(rows * int(words[2]), "unsigned_char")
        elif key == "texture_coordinates":
            self._skip(rows * int(words[2]), words[3])
        elif key in _COMPONENTS:
            self._skip(rows * _COMPONENTS[key], words[2])
        elif key == "field":
            self._field(int(words[2]))
        elif key == "metadata":
            while self._line().strip():
                pass
        elif key != "dimensions":
            raise ValueError("the keyword is unknown")

    def _field(self, count):
        while count > 0:
            words = self._keyword().decode("latin-1").split()
            if words[0].upper() == "METADATA":
                self._section(["metadata"], None)
                continue
            self._skip(int(words[1]) * int(words[2]), words[3].lower())
            count -= 1

    def _cells(self, first, second):
        if not self._is_new:
            row = self._ids(second, "int")
            try:
                sizes, _ = unpacked(row) if second else ([], None)
            except ValueError:
                raise ValueError("the sizes of cells contradict the number of entries") from None
            if len(sizes) != first:
                raise ValueError(f"it contains {len(sizes)} cells")
            return
        if first == 0:
            return
        offsets = self._ids(first, self._keyword("offsets").split()[1].decode().lower())
        self._skip(second, self._keyword("connectivity").split()[1].decode().lower())
        if offsets[0] != 0 or offsets[-1] != second or (np.diff(offsets) < 0).any():
            raise ValueError(f"offsets must rise from 0 to {second}")

    def _ids(self, count, kind):
        """Returns the next integers."""
        data = self._skip(count, kind)
        if self._is_binary:
            return np.frombuffer(data, dtype=f">i{_SIZES[kind]}").astype(np.int64)
        return np.array(data.split()).astype(np.int64)

    def _skip(self, count, kind):
        """Moves behind values of a type, and returns their bytes."""
        start = self._at
        if kind not in _SIZES:  # text; the rest of the file is not checked
            self._at = len(self._data)
        elif self._is_binary:
            self._at += -int(-count * _SIZES[kind] // 1)
            if self._at > len(self._data):
                raise ValueError(self._end())
        elif count > 0:
            last = next(itertools.islice(_WORD.finditer(self._data, start), count - 1, None), None)
            if last is None:
                raise ValueError(self._end())
            self._at = last.end()
            self.may_be_cut = self._at == len(self._data)
        return self._data[start : self._at]

    def _keyword(self, word=None):
        """Returns the next line; an error unless its first word is the given one."""
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
