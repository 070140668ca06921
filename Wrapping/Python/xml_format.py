# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""VTK's XML files of polygons and unstructured grids.

VTK's own readers are not used: they end the process on some inconsistent files.
"""

import base64
import lzma
import re
import zlib
from xml.etree import ElementTree

import numpy as np

from .data_set import ATTRIBUTES, POLYHEDRON, DataSet, faces_of, in_rows, merged, parsed
from .mesh import checked_cells

_KINDS = {"PolyData": "POLYDATA", "UnstructuredGrid": "UNSTRUCTURED_GRID"}
_TYPES = {
    "Bit": "u1", "Int8": "i1", "UInt8": "u1", "Int16": "i2", "UInt16": "u2", "Int32": "i4",
    "UInt32": "u4", "Int64": "i8", "UInt64": "u8", "Float32": "f4", "Float64": "f8",
}  # fmt: skip
_ARRAYS = ("Array", "DataArray")
_ORDERS = {"LittleEndian": "<", "BigEndian": ">"}
# Elements of cells and their names in a DataSet.
_CELLS = {
    "PolyData": {"Verts": "verts", "Lines": "lines", "Polys": "polygons", "Strips": "strips"},
    "UnstructuredGrid": {"Cells": "cells"},
}


class XMLFile:
    """An XML file in memory.

    Parameters
    ----------
    data : bytes
    """

    def __init__(self, data):
        if not re.search(rb"</VTKFile>\s*\Z", data[-1000:]):
            reason = "the file ends before </VTKFile>: it is truncated"
            if b"</VTKFile>" in data:
                reason = "text follows </VTKFile>, the end of the contents"
            elif data[:2] in (b"\xff\xfe", b"\xfe\xff"):
                reason = "expected UTF-8, got UTF-16"
            elif not re.match(rb"(\xef\xbb\xbf)?\s*(<|\Z)", data):
                reason = "the file is not XML: expected < at the beginning"
            raise ValueError(reason)
        start = data.find(b"<AppendedData")
        start = len(data) if start < 0 else data.find(b">", start) + 1
        has_appended = start < len(data)
        try:
            root = ElementTree.fromstring(
                data[:start] + b"</AppendedData></VTKFile>" if has_appended else data
            )
        except (ElementTree.ParseError, LookupError, ValueError) as error:
            raise ValueError(f"the XML is damaged ({error})") from None
        self._type = _choice(root, "type", _KINDS)
        self._order = _ORDERS[_choice(root, "byte_order", _ORDERS, "LittleEndian")]
        word = _choice(root, "header_type", ("UInt32", "UInt64"), "UInt32")
        self._word = np.dtype(self._order + _TYPES[word])
        self._unpack = _COMPRESSORS[_choice(root, "compressor", _COMPRESSORS, "")]
        self._contents = _child(root, self._type)
        self._is_of_vtk_8 = float(root.get("version", 0)) < 2.1
        self._texts = []
        self._appended = None
        if has_appended:
            encoding = _choice(_child(root, "AppendedData"), "encoding", ("base64", "raw"))
            self._appended = _Stream(_appended(data, start), encoding == "base64")
            self._check_appended()

    def read(self):
        """Returns a DataSet. Raises a ValueError if data are missing or contradict their counts."""
        _check_children(self._contents, ("FieldData", "Piece"))
        pieces = [self._piece(piece) for piece in self._contents.findall("Piece")]
        pieces = [piece for piece in pieces if len(piece.points) or piece.number_of_cells()]
        if len(pieces) > 1:
            pieces = [merged(pieces)]
        result = pieces[0] if pieces else DataSet(_KINDS[self._type])
        result.field_data = self._data(self._contents, "FieldData", None)
        result.texts = self._texts
        result.is_of_vtk_8 = self._is_of_vtk_8
        return result

    def _piece(self, piece):
        _check_children(piece, ("Points", "PointData", "CellData", *_CELLS[self._type]))
        result = DataSet(_KINDS[self._type])
        count = _count(piece, "NumberOfPoints")
        if count or piece.find("Points/DataArray") is not None:
            result.points = self._values(_child(piece, "Points/DataArray"), count, "Points")
        if count and result.points.shape != (count, 3):
            raise ValueError(f"points: expected the shape ({count}, 3), got {result.points.shape}")
        for tag, name in _CELLS[self._type].items():
            number = _count(piece, f"NumberOf{tag}")
            if number or piece.find(f"{tag}/DataArray") is not None:
                cells = _child(piece, tag)
                result.cells[name] = self._cells(cells, "offsets", "connectivity", number)
                checked_cells(result.cells[name], name, count)
                if name == "cells":
                    result.types = self._ids(cells, "types", number)
                    self._add_faces(result, cells)
        result.point_data = self._data(piece, "PointData", count)
        result.cell_data = self._data(piece, "CellData", result.number_of_cells())
        for element in piece.findall("PointData"):
            names = {key.lower(): name for key, name in element.attrib.items()}
            result.active = {i: names[k] for i, k in enumerate(ATTRIBUTES) if k in names}
        return result

    def _cells(self, parent, offsets, connectivity, number):
        """Returns offsets and corners. Files omit the first offset, which is 0."""
        ends = np.concatenate([[0], self._ids(parent, offsets, number)])
        return ends, self._ids(parent, connectivity, int(ends[-1]))

    def _add_faces(self, result, cells):
        """Adds the faces of polyhedra."""
        polyhedra = np.flatnonzero(result.types == POLYHEDRON).tolist()
        if not polyhedra:
            return
        number = len(result.types)
        if any(array.get("Name") == "faces" for array in cells):
            ends = self._ids(cells, "faceoffsets", number)[polyhedra].tolist()
            stream = self._ids(cells, "faces", ends[-1])
            for i, start, end in zip(polyhedra, [0, *ends], ends):
                result.set_faces(i, faces_of(stream[start:end]))
            return
        ends, faces = self._cells(cells, "polyhedron_offsets", "polyhedron_to_faces", number)
        number = int(faces.max(initial=-1)) + 1
        checked_cells((ends, faces), "cells", number)
        offsets, corners = self._cells(cells, "face_offsets", "face_connectivity", number)
        checked_cells((offsets, corners), "faces", len(result.points))
        for i in polyhedra:
            chosen = faces[ends[i] : ends[i + 1]]
            result.set_faces(i, [corners[offsets[k] : offsets[k + 1]] for k in chosen])

    def _data(self, parent, tag, rows):
        """Returns arrays of numbers by name, of the first time step. `rows` is None if each array
        has its own number of rows."""
        found = {}
        for element in parent.findall(tag):
            _check_children(element, _ARRAYS)
        for array in parent.findall(f"{tag}/*"):
            name = array.get("Name")
            if not name:
                raise ValueError(f"{tag} has an array without a name")
            if array.get("type") == "String":
                self._texts.append(name)
            elif name not in found:
                number = _count(array, "NumberOfTuples") if rows is None else rows
                found[name] = self._values(array, number, tag)
        return found

    def _ids(self, parent, name, rows):
        """Returns an array of integers as int64."""
        for array in parent.findall("DataArray"):
            if array.get("Name") == name:
                values = self._values(array, rows, parent.tag)
                if values.ndim == 1 and values.dtype.kind in "iu":
                    return values.astype(np.int64)
        raise ValueError(f"{parent.tag} has no array of integers {name!r}")

    def _values(self, array, rows, tag):
        """Returns the values of a DataArray, in rows if they have several components."""
        try:
            _check_children(array, ("InformationKey",))
            kind = _TYPES[_choice(array, "type", _TYPES)]
            components = _count(array, "NumberOfComponents", 1)
            if _choice(array, "format", ("ascii", "appended", "binary"), "ascii") == "ascii":
                values = parsed(_text(array), kind)
                _compare(len(values), "numbers", rows, components)
            elif array.get("type") == "Bit":
                count = rows * components
                packed = np.frombuffer(self._bytes(array, (count + 7) // 8, 1, 1), np.uint8)
                values = np.unpackbits(packed, count=count)
            else:
                kind = np.dtype(self._order + kind)
                contents = self._bytes(array, rows, components, kind.itemsize)
                values = np.frombuffer(contents, kind).astype(kind.newbyteorder("="), copy=False)
            return in_rows(values, components)
        except ValueError as error:
            name = array.get("Name")
            name = f"array {name!r}" if name else "array without a name"
            raise ValueError(f"{tag}, {name}: {error}") from None

    def _bytes(self, array, rows, components, size):
        """Returns the bytes of an array in base64 or appended."""
        if array.get("format") == "appended":
            stream, at = self._appended, _count(array, "offset")
            if stream is None:
                raise ValueError("there are no appended data")
        else:
            stream, at = _Stream(_text(array).strip(), True), 0
        if not stream.text:
            _compare(0, "bytes", rows, components, size)
            return b""
        start, header, packed, sizes, end = self._layout(stream, at)
        _compare(sum(sizes), "bytes", rows, components, size)
        if array.get("format") != "appended" and end != len(stream.text):
            raise ValueError(f"expected {end} characters of base64, got {len(stream.text)}")
        contents = stream.take(start, header + sum(packed))[header:]
        if self._unpack is None:
            return contents
        ends = np.cumsum([0, *packed]).tolist()
        blocks = []
        for first, last, size in zip(ends, ends[1:], sizes):
            block = self._unpack(contents[first:last], size)
            if len(block) != size:
                raise ValueError("compressed data are damaged")
            blocks.append(block)
        return b"".join(blocks)

    def _layout(self, stream, at):
        """Returns the layout of an array: position of its data, size of the header there, sizes of
        its blocks in the file and after decompression, position of its end."""
        width = self._word.itemsize
        if self._unpack is None:
            size = self._words(stream, at, 1)
            return at, width, size, size, stream.end(at, width + size[0])
        number, size, rest = self._words(stream, at, 3)
        packed = self._words(stream, at, 3 + number)[3:]
        sizes = [size] * number
        if number and rest:
            sizes[-1] = rest
        start = stream.end(at, width * (3 + number))
        return start, 0, packed, sizes, stream.end(start, sum(packed))

    def _words(self, stream, at, number):
        return np.frombuffer(stream.take(at, number * self._word.itemsize), self._word).tolist()

    def _check_appended(self):
        """Raises an error unless arrays are appended one after another without a gap."""
        arrays = (a for a in self._contents.iter() if a.get("format") == "appended")
        starts = sorted({_count(array, "offset") for array in arrays})
        text = self._appended.text
        blank = b" \t\r\n" if self._appended.is_base64 else b""
        last = 0
        for at in starts:
            if at < last or bytes(text[last:at]).strip(blank):
                raise ValueError(
                    f"appended data: an array begins at byte {at}, the one before it ends at {last}"
                )
            try:
                last = self._layout(self._appended, at)[-1]
            except ValueError as error:
                raise ValueError(f"appended data at byte {at}: {error}") from None
        # A line break follows the last array, in some files nothing.
        pattern = rb"\s*" if self._appended.is_base64 else rb"(\n[ \t]*)?"
        if last > len(text) or not re.fullmatch(pattern, text[last:]):
            raise ValueError(
                f"appended data: the last array ends at byte {last}, the data at {len(text)}"
            )


class _Stream:
    """Text that contains arrays one after another, raw or in base64."""

    def __init__(self, text, is_base64):
        self.text = text
        self.is_base64 = is_base64

    def take(self, at, count):
        """Returns `count` bytes from a position of the text."""
        found = self.text[at : self.end(at, count)]
        if self.is_base64:
            try:
                found = memoryview(base64.b64decode(found, validate=True))[:count]
            except ValueError as error:
                raise ValueError(f"the base64 is damaged ({error})") from None
        if len(found) < count:
            raise ValueError(f"expected {count} bytes, got {len(found)}")
        return found

    def end(self, at, count):
        """Returns the position after `count` bytes."""
        return at + (-(-count // 3) * 4 if self.is_base64 else count)


def _appended(data, start):
    """Returns the bytes between the underscore and </AppendedData>."""
    end = re.search(rb"</AppendedData>\s*</VTKFile>\s*\Z", data[-1000:])
    mark = data.find(b"_", start)
    if mark < 0 or data[start:mark].strip() or not end:
        raise ValueError("expected appended data between an underscore and </AppendedData>")
    return memoryview(data)[mark + 1 : len(data) - len(end[0])]


def _compare(number, unit, rows, components, size=1):
    """Raises an error if an array does not have the expected number of bytes or numbers."""
    if number != rows * components * size:
        each = f" of {size} bytes" if unit == "bytes" else ""
        raise ValueError(f"expected {rows} x {components} numbers{each}, got {number} {unit}")


def _text(array):
    """Returns the text of an element without that of elements inside."""
    texts = [array.text, *(element.tail for element in array)]
    return b"".join(text.encode() for text in texts if text)


def _check_children(parent, known):
    """Raises an error if an element contains others than the known ones."""
    for child in parent:
        if child.tag not in known:
            raise ValueError(f"{parent.tag} has an unknown element {child.tag}")


def _child(parent, path):
    found = parent.find(path)
    if found is None:
        raise ValueError(f"{parent.tag} has no element {path}")
    return found


def _choice(element, key, known, default=None):
    """Returns an attribute that must be one of the known words."""
    value = element.get(key, default)
    if value not in known:
        words = ", ".join(filter(None, known))
        raise ValueError(f"the {key} of {element.tag} is {value!r}; expected one of {words}")
    return value


def _count(element, key, default=0):
    """Returns an attribute that must be a count."""
    value = element.get(key, default)
    if not re.fullmatch(r"\s*[0-9]+\s*", str(value)):
        raise ValueError(f"the {key} of {element.tag} is {value!r}; expected a whole number")
    return int(value)


def _unpack(unpacker, data, size):
    try:
        found = unpacker.decompress(data, size + 1)
    except (EOFError, OverflowError, lzma.LZMAError, zlib.error):
        return b""
    return found if unpacker.eof and not unpacker.unused_data else b""


def _unpack_lz4(data, size):
    from vtkmodules.vtkIOCore import vtkLZ4DataCompressor  # Python has no LZ4

    if size > 255 * len(data):  # beyond the limit of the format; VTK would allocate it
        return b""
    compressor = vtkLZ4DataCompressor()
    compressor.AddObserver("ErrorEvent", lambda *_: None)
    found = compressor.Uncompress(bytes(data), len(data), size)
    return b"" if found is None else bytes(memoryview(found))


# Functions that decompress a block of a known size. The result is empty if the block is damaged.
_COMPRESSORS = {
    "": None,
    "vtkZLibDataCompressor": lambda *block: _unpack(zlib.decompressobj(), *block),
    "vtkLZMADataCompressor": lambda *block: _unpack(lzma.LZMADecompressor(), *block),
    "vtkLZ4DataCompressor": _unpack_lz4,
}
