# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""A table of file formats and their dialects: the data that `vtkdgg.read` keeps, whether it refuses
truncated files, and the data that `vtkdgg.write` keeps.

Usage: DGG_TEST_OUTPUT=FOLDER build/test/bin/vtkdgg-python Testing/Python/formats.py

A small grid at UTM coordinates is written in each dialect. The columns: coordinates have all
digits; ids and polygons are those of the file; values at points are kept; 20 files that are cut at
random positions are refused; `vtkdgg.write` followed by `vtkdgg.read` returns the same mesh. A "-"
marks a property that a format does not have. Formats without counts (.obj, .xyz) are complete after
any line; a cut within a line has to cause a warning or an error."""

import gzip
import os
import struct
import sys
import warnings

import numpy as np
import support
import vtkdgg
from vtkmodules.vtkFiltersCore import vtkAppendFilter
from vtkmodules.vtkIOLegacy import vtkPolyDataWriter, vtkUnstructuredGridWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter, vtkXMLUnstructuredGridWriter

FOLDER = support.output_folder("formats")
CUTS = 20
COLUMNS = ("digits", "ids", "polygons", "values", "truncation", "written")


def surface(size=9):
    """Returns points and triangles of a jittered grid at UTM coordinates, and values at the points.
    """
    points, triangles = support.grid(size - 1, size - 1)
    random = np.random.default_rng(1)
    points += 0.2 * random.random(points.shape)
    points = np.round(0.5 * points + [512345.678, 5403210.987, 80.0], 3)
    return points, triangles, np.round(np.sin(points[:, 0]), 6)


def rows(values, form="%.17g", before=""):
    """Returns lines of text."""
    return "".join(before + " ".join(form % x for x in row) + "\n" for row in values)


def obj(points, cells, textured=False, relative=False):
    """Returns an OBJ file. Textured ones have a corner of texture for each corner of a triangle."""
    text = rows(points, "%.3f", "v ")
    if textured:
        text += rows(np.random.default_rng(2).random((cells.size, 2)), "%.6f", "vt ") + "vn 0 0 1\n"
        names = np.arange(1, cells.size + 1).reshape(cells.shape)
        corners = [[f"{i + 1}/{t}/1" for i, t in zip(*pair)] for pair in zip(cells, names)]
    else:
        first = -len(points) if relative else 1
        corners = [[str(i + first) for i in cell] for cell in cells]
    return text + rows(corners, "%s", "f ")


def ply(points, cells, values, mode, kind="double"):
    """Returns a PLY file."""
    header = f"ply\nformat {mode} 1.0\ncomment test\nelement vertex {len(points)}\n"
    header += "".join(f"property {kind} {axis}\n" for axis in "xyz") + "property double value\n"
    header += f"element face {len(cells)}\nproperty list uchar int vertex_indices\nend_header\n"
    if mode == "ascii":
        return header + rows(np.column_stack([points, values])) + rows(cells, "%d", "3 ")
    order = "<" if "little" in mode else ">"
    letter = {"double": "d", "float": "f"}[kind]
    body = [struct.pack(f"{order}3{letter}d", *p, v) for p, v in zip(points, values)]
    body += [struct.pack(f"{order}B3i", 3, *cell) for cell in cells]
    return header.encode() + b"".join(body)


def stl(points, cells, is_binary):
    """Returns an STL file."""
    corners = points[cells]
    if is_binary:
        body = [struct.pack("<12fH", 0, 0, 1, *c.ravel(), 0) for c in corners]
        return bytes(80) + struct.pack("<I", len(cells)) + b"".join(body)
    facets = [
        "facet normal 0 0 1\nouter loop\n" + rows(c, before="vertex ") + "endloop\nendfacet\n"
        for c in corners
    ]
    return "solid test\n" + "".join(facets) + "endsolid test\n"


def off(points, cells, keyword="OFF\n", colours=""):
    """Returns an OFF file."""
    lines = rows(points).splitlines()
    text = f"{keyword}{len(points)} {len(cells)} 0\n" + "".join(f"{x}{colours}\n" for x in lines)
    return text + rows(cells, "%d", "3 ")


def binary_off(points, cells):
    """Returns a binary OFF file, which has 32 bits for each number."""
    body = struct.pack(">3i", len(points), len(cells), 0) + points.astype(">f4").tobytes()
    faces = np.column_stack([np.full(len(cells), 3), cells, np.zeros(len(cells))])
    return b"OFF BINARY\n" + body + faces.astype(">i4").tobytes()


def pcd(points, values, mode):
    """Returns a PCD file."""
    header = "VERSION .7\nFIELDS x y z value\nSIZE 8 8 8 8\nTYPE F F F F\nCOUNT 1 1 1 1\n"
    header += f"WIDTH {len(points)}\nHEIGHT 1\nPOINTS {len(points)}\nDATA {mode}\n"
    data = np.column_stack([points, values])
    return header + rows(data) if mode == "ascii" else header.encode() + data.tobytes()


def of_vtk(writer, data, **settings):
    """Returns the bytes that a writer of VTK writes."""
    path = os.path.join(FOLDER, "vtk.tmp")
    writer.SetFileName(path)
    writer.SetInputData(data)
    for name, arguments in settings.items():
        getattr(writer, name)(*arguments)
    vtkdgg.check(writer)
    with open(path, "rb") as file:
        return file.read()


def dialects():
    """Yields extension, name, contents and the expected points, polygons and values; None for those
    that the dialect does not hold."""
    points, cells, values = surface()
    single = points.astype(np.float32).astype(float)
    quads = cells.reshape(2, -1, 3)
    quads = np.column_stack([quads[0], quads[1][:, 2]])
    mesh = vtkdgg.Mesh(points, cells, point_data={"value": values}).as_polydata()
    append = vtkAppendFilter()
    append.AddInputData(mesh)
    grid = vtkdgg.check(append)
    # STL has no ids: points are numbered as they appear.
    _, first = np.unique(cells.ravel(), return_index=True)
    order = cells.ravel()[np.sort(first)]
    in_order = np.argsort(order)[cells]
    bare, full, cloud = (points, cells, None), (points, cells, values), (points, None, values)
    yield ".obj", "plain", obj(points, cells), bare
    yield ".obj", "v/vt/vn", obj(points, cells, textured=True), bare
    yield ".obj", "relative ids", obj(points, cells, relative=True), bare
    yield ".obj", "quadrangles", obj(points, quads), (points, quads, None)
    yield ".ply", "ascii", ply(points, cells, values, "ascii"), full
    yield ".ply", "little endian", ply(points, cells, values, "binary_little_endian"), full
    yield ".ply", "big endian", ply(points, cells, values, "binary_big_endian"), full
    floats = ply(points, cells, values, "binary_little_endian", "float")
    yield ".ply", "float", floats, (single, cells, values)
    yield ".stl", "text", stl(points, cells, False), (points[order], in_order, None)
    yield ".stl", "binary", stl(points, cells, True), (single[order], in_order, None)
    yield ".off", "plain", off(points, cells), bare
    yield ".off", "joined counts", off(points, cells, "OFF"), bare
    yield ".off", "lower case", off(points, cells, "off\n"), bare
    yield ".off", "no keyword", off(points, cells, ""), bare
    yield ".off", "RGBA", off(points, cells, "COFF\n", " 255 0 9 128"), bare
    yield ".off", "RGBA, OFF", off(points, cells, "OFF\n", " 255 0 9 128"), bare
    yield ".off", "binary", binary_off(points, cells), (single, cells, None)
    yield ".pcd", "ascii", pcd(points, values, "ascii"), cloud
    yield ".pcd", "binary", pcd(points, values, "binary"), cloud
    yield ".xyz", "plain", rows(points), (points, None, None)
    yield ".xyz", "count, commas", f"{len(points)}\n" + rows(points).replace(" ", ", "), (
        points, None, None,
    )  # fmt: skip
    yield ".xyz", "header", "x y z\n" + rows(points), (points, None, None)
    for name, call in (("text", "SetFileTypeToASCII"), ("binary", "SetFileTypeToBinary")):
        writer, old = vtkPolyDataWriter(), vtkPolyDataWriter()
        yield ".vtk", name, of_vtk(writer, mesh, **{call: ()}), full
        content = of_vtk(old, mesh, **{call: ()}, SetFileVersion=(42,))
        yield ".vtk", f"{name}, 4.2", content, full
        yield ".vtk", f"{name}, grid", of_vtk(vtkUnstructuredGridWriter(), grid, **{call: ()}), full
    for name, settings in (
        ("text", {"SetDataModeToAscii": ()}),
        ("base64", {"SetDataModeToBinary": ()}),
        ("appended", {"SetDataModeToAppended": ()}),
        ("raw", {"SetDataModeToAppended": (), "EncodeAppendedDataOff": ()}),
    ):
        yield ".vtp", name, of_vtk(vtkXMLPolyDataWriter(), mesh, **settings), full
        yield ".vtu", name, of_vtk(vtkXMLUnstructuredGridWriter(), grid, **settings), full


def save(path, contents):
    """Writes a file of text or bytes."""
    with open(path, "wb") as file:
        file.write(contents if isinstance(contents, bytes) else contents.encode())


def read(path):
    """Returns the mesh or the message of the error, and true if there is a warning."""
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        try:
            return vtkdgg.read(path), bool(caught)
        except ValueError as error:
            return str(error), bool(caught)


def compare(mesh, points, cells, values):
    """Returns the cells of a row about a mesh, or the text of an error as the first cell."""
    if isinstance(mesh, str):
        return {**dict.fromkeys(COLUMNS, None), "digits": mesh}
    found = {"digits": np.array_equal(np.sort(mesh.points, axis=0), np.sort(points, axis=0))}
    found["ids"] = np.array_equal(mesh.points, points)
    expected = np.empty((0, 3), dtype=int) if cells is None else cells
    offsets, corners = mesh.polygons
    found["polygons"] = (
        np.array_equal(corners, expected.ravel()) and (np.diff(offsets) == expected.shape[1]).all()
    )
    name = next((key for key in ("value", "scalar_value") if key in mesh.point_data), None)
    has_values = name is not None and np.array_equal(mesh.point_data[name], values)
    found["values"] = None if values is None else has_values
    return {key: value if value is None else bool(value) for key, value in found.items()}


def truncation(path, contents, whole):
    """Returns true if each cut file is refused with its name, causes a warning or has all polygons;
    otherwise a text with the position of a cut and the message or mesh."""
    contents = contents if isinstance(contents, bytes) else contents.encode()
    extension = os.path.splitext(path)[1]
    cut = os.path.join(FOLDER, "cut" + extension)
    for at in np.random.default_rng(3).integers(1, len(contents) - 1, CUTS):
        save(cut, contents[:at])
        mesh, is_warned = read(cut)
        is_line = extension in (".obj", ".xyz") and contents[:at].endswith(b"\n")
        if isinstance(mesh, str):
            is_good = cut in mesh
        else:
            is_good = is_warned or is_line or np.array_equal(mesh.polygons[1], whole.polygons[1])
        if not is_good:
            return f"cut at {at}: {mesh}"
    return True


def row(extension, name, contents, expected):
    """Returns the cells of a row: true, false, None if not applicable, or the text of an error."""
    path = os.path.join(FOLDER, name.replace(" ", "_").replace("/", "") + extension)
    save(path, contents)
    mesh, _ = read(path)
    found = compare(mesh, *expected)
    if isinstance(mesh, str):
        return found
    found["truncation"] = truncation(path, contents, mesh)
    found["written"] = None
    if extension != ".vtu":
        vtkdgg.write(path, mesh)
        found["written"] = all(
            v in (True, None) for v in compare(read(path)[0], *expected).values()
        )
    return found


def table():
    """Yields extension, name and row of all dialects, and of compressed text formats."""
    for extension, name, contents, expected in dialects():
        yield extension, name, row(extension, name, contents, expected)
        if isinstance(contents, str) and name in ("plain", "ascii", "text"):
            path = os.path.join(FOLDER, f"compressed{extension}.gz")
            packed = gzip.compress(contents.encode())
            save(path, packed)
            mesh = read(path)[0]
            found = {"written": None, **compare(mesh, *expected)}
            if not isinstance(mesh, str):
                found["truncation"] = truncation(path, packed, mesh)
            yield extension + ".gz", name, found


def main():
    """Prints the table; the exit code is 1 if a cell is wrong."""
    words = {True: "yes", False: "WRONG", None: "-"}
    print("".join(f"{title:<16}" for title in ("format", "dialect", *COLUMNS)))
    is_right = True
    for extension, name, cells in table():
        texts = [words.get(cells[key], cells[key]) for key in COLUMNS]
        print("".join(f"{text!s:<16}" for text in (extension, name, *texts)))
        is_right = is_right and all(value in (True, None) for value in cells.values())
    return 0 if is_right else 1


if __name__ == "__main__":
    sys.exit(main())
