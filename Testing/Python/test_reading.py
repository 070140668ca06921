# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkdgg.read, vtkdgg.write and vtkdgg.Mesh with files of all formats."""

import base64
import itertools
import os
import re
import struct
import sys
import types
import unittest
from unittest import mock

import formats
import numpy as np
import support
import vtkdgg
from support import warnings_as
from vtkmodules.vtkCommonCore import VTK_DOUBLE, VTK_FLOAT, vtkBitArray, vtkIdList, vtkStringArray
from vtkmodules.vtkCommonDataModel import (
    VTK_BEZIER_QUADRILATERAL,
    VTK_HEXAHEDRON,
    VTK_LAGRANGE_HEXAHEDRON,
    VTK_POLYHEDRON,
    vtkStructuredGrid,
    vtkUnstructuredGrid,
)
from vtkmodules.vtkFiltersCore import vtkAppendFilter
from vtkmodules.vtkFiltersSources import vtkCellTypeSource
from vtkmodules.vtkIOLegacy import (
    vtkPolyDataWriter,
    vtkStructuredGridWriter,
    vtkUnstructuredGridReader,
    vtkUnstructuredGridWriter,
)
from vtkmodules.vtkIOXML import (
    vtkXMLPolyDataWriter,
    vtkXMLUnstructuredGridReader,
    vtkXMLUnstructuredGridWriter,
)

FOLDER = support.output_folder("reading")


def path_of(name, contents):
    """Writes a file with these contents, and returns its path."""
    path = os.path.join(FOLDER, name)
    formats.save(path, contents)
    return path


class Formats(support.Test):
    def test_table(self):
        for extension, name, cells in formats.table():
            with self.subTest(format=extension, dialect=name):
                wrong = {key: value for key, value in cells.items() if value not in (True, None)}
                self.assertEqual(wrong, {})

    def test_random_damage(self):
        """A damaged file of any dialect is read or refused, and never ends the process."""
        random, refused = np.random.default_rng(7), 0
        for extension, name, contents, _ in formats.dialects():
            whole = contents if isinstance(contents, bytes) else contents.encode()
            for _ in range(20):
                damaged = bytearray(whole)
                for at in random.integers(0, len(whole), 3):
                    damaged[at] = random.integers(256)
                with self.subTest(extension=extension, dialect=name), warnings_as("ignore"):
                    try:
                        vtkdgg.read(path_of(f"random{extension}", bytes(damaged)))
                    except ValueError as error:
                        self.assertIn(f"random{extension}", str(error))
                        refused += 1
        self.assertGreater(refused, 200)

    def test_damaged_legacy_files(self):
        """Files that VTK's reader accepts in part, or that end its process."""
        start = "# vtk DataFile Version 3.0\ntitle\nASCII\n\nDATASET POLYDATA\nPOINTS 3 float\n"
        start += "0 0 0 1 0 0 0 1 0\n"
        cases = (
            (start + "POLYGONS 1 4\n3 0 1\n", "'POLYGONS 1 4': the file ends too early"),
            (start + "POLYGONS 2 4\n3 0 1 2\n", "expected 2 cells, got 1"),
            (start + "POLYGONS 1 4\n7 0 1 2\n", "'POLYGONS 1 4': the sizes of cells contradict"),
            (start + "POLYGONS 1 4\n3 0 1 9\n", "point id 9"),
            (start + "POLYG", "'POLYG': the keyword is unknown"),
            (start + "POLYGONS 1\n", "'POLYGONS 1': the line is damaged"),
            (start + "POLYGONS 1 4\n3 0 1 999999999999\n", "999999999999 does not fit into int32"),
            (start + f"POLYGONS 1 4\n3 0 1 {'9' * 25}\n", f"{'9' * 25} does not fit into int32"),
            (start + f"POLYGONS 1 {'9' * 25}\n3 0 1 2\n", "the file ends too early"),
            (start + "POLYGONS 1 4\n3 0 1 2x\n", "expected numbers, got '2x'"),
            (start + "POLYGONS 1 4\n3 0 1 -2\n", "point id -2"),
            (start + "CELL_TYPES 1\n42\n", "'CELL_TYPES 1': the line is damaged"),
            (start + "POINT_DATA 4\n", "the number of points is 3"),
            (start + "POINT_DATA 3\nNORMALS a float\n" + "0 " * 8, "the file ends too early"),
            (start + "FIELD f 1\na 0 3 float\n", "expected at least 1 component"),
            (start.replace("POLYDATA", "STRUCTURED_GRID\nDIMENSIONS 3 1"), "three positive"),
            (start + "CELL_DATA 0\n", "arrays are missing"),
            (start + "METADATA\nINFORMATION 0\n", "the file ends too early"),
            (start + "METAD", "'METAD': the keyword is unknown"),
            (start.replace("3.0", "999999999.0"), "version 999999999 is unknown"),
            (start.replace("float", "real"), "the type 'real' is unknown"),
            ("# vtk DataFile", "header"),
            (start.replace("POLYDATA", "STRUCTURED_POINTS"), "expected a DATASET POLYDATA or "),
        )
        self.refuse(
            lambda text: vtkdgg.read(path_of("damaged.vtk", text)),
            *(((text,), pattern) for text, pattern in cases),
        )
        with self.assertWarnsRegex(RuntimeWarning, "cut.vtk: the last line has no end"):
            vtkdgg.read(path_of("cut.vtk", start + "POLYGONS 1 4\n3 0 1 2"))

    def test_damaged_vtk_files(self):
        """Bytes missing or added and wrong numbers, with which VTK's readers end the process."""
        points, triangles, values = formats.surface()
        mesh = vtkdgg.Mesh(points, triangles, point_data={"value": values}).as_polydata()
        append = vtkAppendFilter()
        append.AddInputData(mesh)
        for writer, data, extension in (
            (vtkXMLPolyDataWriter, mesh, ".vtp"),
            (vtkXMLUnstructuredGridWriter, vtkdgg.check(append), ".vtu"),
        ):
            for compressor, header, is_base64 in itertools.product(
                ("None", "ZLib", "LZMA", "LZ4"), (32, 64), (False, True)
            ):
                settings = {f"SetCompressorTypeTo{compressor}": ()}
                settings[f"SetHeaderTypeToUInt{header}"] = ()
                settings["SetEncodeAppendedData"] = (is_base64,)
                whole = formats.of_vtk(writer(), data, **settings)
                start, end = whole.index(b"   _") + 4, whole.index(b"\n  </AppendedData>")
                for at in np.linspace(start, end - 1, 9).astype(int):
                    self.refuse_file(extension, whole[:at] + whole[at + 1 :])
                    self.refuse_file(extension, whole[:at] + b"U" + whole[at:])
            for match in re.finditer(rb'(?<=NumberOf)\w+="(\d+)|offset="(\d+)', whole):
                for number in (b"999999999999", b"9" * 25, b"-1", b"2"):
                    first, last = match.span(match.lastindex)
                    self.refuse_file(extension, whole[:first] + number + whole[last:])
            text = formats.of_vtk(writer(), data, SetDataModeToAscii=())
            for match in re.finditer(rb'"(?:connectivity|offsets|types)"[^>]*>\s*(\d+)', text):
                for number in (b"200", b"-1", b"9" * 12, b"9" * 25):
                    first, last = match.span(1)
                    self.refuse_file(extension, text[:first] + number + text[last:])
            for word in (b"<PointData", b"<Points", b"<DataArray", b" Name", b" type", b"Float64"):
                self.refuse_file(extension, text.replace(word, word + b"x", 1))
        for version, word in ((42, b"POLYGONS"), (51, b"CONNECTIVITY")):
            settings = {"SetFileTypeToBinary": (), "SetFileVersion": (version,)}
            whole = formats.of_vtk(vtkPolyDataWriter(), mesh, **settings)
            ids = whole.index(b"\n", whole.index(word)) + 1
            for at in (ids - 200, ids + 200, len(whole) - 20):
                self.refuse_file(".vtk", whole[:at] + whole[at + 1 :])
                self.refuse_file(".vtk", whole[:at] + b"U" + whole[at:])
            for number in (b"\xff" * 8, b"\x7f" + b"\xff" * 7):
                self.refuse_file(".vtk", whole[:ids] + number + whole[ids + 8 :])

        for compressor, size in (("ZLib", 2**63), ("LZ4", 2**50)):
            header = base64.b64encode(struct.pack("<4Q", 1, size, 0, 4)).decode()
            self.refuse_file(
                ".vtp",
                '<VTKFile type="PolyData" header_type="UInt64" '
                f'compressor="vtk{compressor}DataCompressor"><PolyData><FieldData>'
                f'<DataArray type="UInt8" Name="a" NumberOfTuples="{size}" format="binary">'
                f"{header}AAAAAA==</DataArray></FieldData></PolyData></VTKFile>",
            )

    def refuse_file(self, extension, contents):
        """Expects an error that names the file."""
        path = path_of(f"damaged{extension}", contents)
        with self.assertRaisesRegex(ValueError, re.escape(path)):
            self.fail(f"{vtkdgg.read(path)} of a damaged file")

    def test_kinds_of_vtk_files(self):
        """Cells and arrays of all types, in all encodings."""
        points = support.grid(4, 4)[0]
        mesh = support.polydata(
            points,
            Verts=[[3], [4, 5]],
            Lines=[[0, 1, 6]],
            Polys=[[5, 6, 11, 10], [6, 7, 12]],
            Strips=[[0, 5, 1, 6, 2], [2, 7, 3]],
        )
        arrays = {
            f"%a {kind}{shape[1:]}": (90.0 * np.random.default_rng(4).random(shape)).astype(kind)
            for kind in ("i1", "u1", "i2", "u2", "i4", "u4", "i8", "u8", "f4", "f8")
            for shape in ((25,), (25, 2))
        }
        for data, rows in (("Point", 25), ("Cell", 7), ("Field", 3)):
            for name, values in arrays.items():
                support.add_array(getattr(mesh, f"Get{data}Data")(), name, values[:rows])
        mesh.GetPointData().SetActiveScalars("%a f4()")
        files = [(".vtk", {"SetFileTypeToBinary": (), "SetFileVersion": (v,)}) for v in (42, 51)]
        for compressor, header, order, mode in itertools.product(
            ("None", "ZLib", "LZMA", "LZ4"), (32, 64), ("Little", "Big"), ("Binary", "Appended")
        ):
            names = f"CompressorTypeTo{compressor}", f"HeaderTypeToUInt{header}"
            names += f"ByteOrderTo{order}Endian", f"DataModeTo{mode}"
            files.append((".vtp", {"SetBlockSize": (64,), **{f"Set{name}": () for name in names}}))
        files.append((".vtp", {"SetNumberOfPieces": (2,)}))
        for extension, settings in files:
            writer = vtkPolyDataWriter() if extension == ".vtk" else vtkXMLPolyDataWriter()
            path = path_of("all" + extension, formats.of_vtk(writer, mesh, **settings))
            found = vtkdgg.read(path)
            # Each piece is a copy. The triangles of strips follow the polygons of all pieces.
            copies = settings.get("SetNumberOfPieces", (1,))[0]
            starts = 25 * np.arange(copies)[:, None]
            strips = [0, 5, 1, 1, 5, 6, 1, 6, 2, 2, 7, 3]
            corners = [(starts + part).ravel() for part in ([5, 6, 11, 10, 6, 7, 12], strips)]
            rows = [np.tile(part, copies) for part in ([0, 1], [2], [3, 4], [5, 5, 5, 6])]
            with self.subTest(settings):
                np.testing.assert_array_equal(found.points, np.tile(points, (copies, 1)))
                np.testing.assert_array_equal(found.lines[1], (starts + [0, 1, 6]).ravel())
                np.testing.assert_array_equal(found.polygons[1], np.concatenate(corners))
                for data, chosen in (
                    (found.point_data, np.tile(np.arange(25), copies)),
                    (found.cell_data, np.concatenate(rows)),
                    (found.field_data, np.arange(3)),
                ):
                    self.assertEqual(data.keys(), arrays.keys())
                    for name, values in data.items():
                        self.assertEqual(values.dtype, arrays[name].dtype)
                        np.testing.assert_array_equal(values, arrays[name][chosen])
                active = found.as_polydata().GetPointData().GetScalars()
                self.assertEqual(active.GetName(), "%a f4()")

    def test_grids_of_vtk_files(self):
        """A hexahedron, a polyhedron and a structured grid of the same shape."""
        z, y, x = np.meshgrid(*[[0.0, 1.0]] * 3, indexing="ij")
        points = np.column_stack([x.ravel(), y.ravel(), z.ravel()])
        block = vtkStructuredGrid()
        block.SetDimensions(2, 2, 2)
        ids = [0, 1, 3, 2, 4, 5, 7, 6]
        sides = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (1, 3, 7, 5), (3, 2, 6, 7), (2, 0, 4, 6)]
        faces = [6, *(i for side in sides for i in (4, *side))]
        grids = [vtkUnstructuredGrid(), vtkUnstructuredGrid()]
        for grid, kind, row in zip(grids, (VTK_HEXAHEDRON, VTK_POLYHEDRON), (ids, faces)):
            cell = vtkIdList()
            for i in row:
                cell.InsertNextId(i)
            grid.InsertNextCell(kind, cell)
        for grid in (block, *grids):
            grid.SetPoints(support.polydata(points).GetPoints())
            writers = [(".vtk", vtkStructuredGridWriter, (42, 51))]
            if grid is not block:
                writers = [
                    (".vtk", vtkUnstructuredGridWriter, (42, 51)),
                    (".vtu", vtkXMLUnstructuredGridWriter, (None,)),
                ]
            for extension, writer, versions in writers:
                for version in versions:
                    settings = {"SetFileVersion": (version,)} if version else {}
                    path = path_of("grid" + extension, formats.of_vtk(writer(), grid, **settings))
                    with self.assertWarnsRegex(RuntimeWarning, "of 6 faces"):
                        offsets, corners = vtkdgg.read(path).polygons
                    found = sorted(tuple(sorted(row)) for row in corners.reshape(6, 4).tolist())
                    self.assertEqual(found, sorted(tuple(sorted(side)) for side in sides))

    def test_other_arrays(self):
        """Arrays of text are skipped with a warning; bits and large integers are read."""
        labels, bits = vtkStringArray(), vtkBitArray()
        labels.SetName("labels")
        bits.SetName("bits")
        bits.SetNumberOfComponents(2)  # VTK writes whole bytes only
        points, triangles = support.grid(1, 1)
        large = np.array([2**63 - 1, 2**63, 2**64 - 1, 0], np.uint64)
        mesh = vtkdgg.Mesh(points, triangles, point_data={"large": large}).as_polydata()
        for i in range(4):
            labels.InsertNextValue(f"point {i}")
            bits.InsertNextTuple((1, i % 2))
        mesh.GetPointData().AddArray(labels)
        mesh.GetPointData().AddArray(bits)
        for kind, mode in itertools.product(
            (vtkPolyDataWriter, vtkXMLPolyDataWriter), ("ASCII", "Binary", "Ascii")
        ):
            call = f"SetFileTypeTo{mode}" if kind is vtkPolyDataWriter else f"SetDataModeTo{mode}"
            if not hasattr(kind, call):
                continue
            extension = ".vtk" if kind is vtkPolyDataWriter else ".vtp"
            path = path_of("other" + extension, formats.of_vtk(kind(), mesh, **{call: ()}))
            with self.subTest(call), self.assertWarnsRegex(RuntimeWarning, "skipped: labels"):
                found = vtkdgg.read(path).point_data
            self.assertEqual(sorted(found), ["bits", "large"])
            np.testing.assert_array_equal(found["large"], large)
            self.assertEqual(found["bits"].dtype, np.uint8)
            np.testing.assert_array_equal(found["bits"], [[1, i % 2] for i in range(4)])

    def test_degenerate_cells(self):
        """Cells with too few corners, on which VTK ends the process, are left out."""
        start = "# vtk DataFile Version 3.0\ntitle\nASCII\nDATASET POLYDATA\nPOINTS 4 float\n"
        start += "0 0 0 1 0 0 1 1 0 0 1 0\n"
        for cells in (
            "LINES 2 5\n1 3 2 1 2\n",
            "POLYGONS 3 9\n1 3 2 0 1 3 0 1 2\n",
            "POLYGONS 2 5\n0 3 0 1 2\n",
            "TRIANGLE_STRIPS 2 7\n2 0 1 3 0 1 2\n",
        ):
            count = int(cells.split()[1])
            values = " ".join(map(str, range(count)))
            cells += f"CELL_DATA {count}\nSCALARS id int\nLOOKUP_TABLE default\n{values}\n"
            with self.subTest(cells):
                path = path_of("degenerate.vtk", start + cells)
                with self.assertWarnsRegex(RuntimeWarning, "degenerate.vtk: cells .* are ignored: "):
                    mesh = vtkdgg.read(path)
                self.assertEqual(mesh.cell_data["id"].tolist(), [count - 1])
        mesh = support.polydata(support.grid(1, 1)[0], Strips=[[0, 1]])
        wrong = (os.path.join(FOLDER, "x.vtp"), mesh), "strips: a strip has 2 corners"
        self.refuse(vtkdgg.write, wrong)

    def test_cells_of_higher_order(self):
        """Lagrange cells as VTK reads them, which changes the order of nodes of old files. The
        surface of Bezier cells does not contain their points."""
        source = vtkCellTypeSource()
        source.SetBlocksDimensions(1, 1, 1)
        source.SetCellOrder(3)
        source.SetCellType(VTK_LAGRANGE_HEXAHEDRON)
        grid = vtkdgg.check(source)
        for writer, reader, old, new in (
            (vtkUnstructuredGridWriter, vtkUnstructuredGridReader, b"5.1", b"4.2"),
            (vtkXMLUnstructuredGridWriter, vtkXMLUnstructuredGridReader, b'"2.2"', b'"1.0"'),
        ):
            path = "cells.vtu" if "XML" in writer.__name__ else "cells.vtk"
            contents = formats.of_vtk(writer(), grid)
            settings = {"SetFileVersion": (42,)} if path == "cells.vtk" else {}
            old_contents = formats.of_vtk(writer(), grid, **settings).replace(old, new)
            for whole in (contents, old_contents):
                expected = reader()
                expected.SetFileName(path_of(path, whole))
                with warnings_as("ignore"):
                    found = vtkdgg.read(os.path.join(FOLDER, path)).polygons
                    surface, _ = vtkdgg.meshes.take(vtkdgg.check(expected))
                np.testing.assert_array_equal(found[1], surface.polygons[1])
            self.assertNotEqual(contents, old_contents)
        source.SetCellType(VTK_BEZIER_QUADRILATERAL)
        with self.assertRaisesRegex(ValueError, "cell 0 is a vtkBezierQuadrilateral, .* expected"):
            vtkdgg.distance(vtkdgg.check(source), 0)

    def test_wrong_files(self):
        cases = (
            ("empty.ply", "", r"empty.ply: "),
            ("none.xyz", "# nothing\n", "none.xyz: .*no points"),
            ("late.vtp", "<VTKFile></VTKFile>x", "late.vtp: text follows </VTKFile>"),
            ("noise.vtp", "geodesics", "noise.vtp: the file is not XML"),
            ("cut.vtp", "<VTKFile>", "cut.vtp: .* it is truncated"),
            ("utf.vtp", "<VTKFile></VTKFile>".encode("utf-16"), "utf.vtp: .* got UTF-16"),
            ("lfs.ply", "version https://git-lfs.github.com/spec/v1\n", "lfs.ply: .*Git LFS"),
            ("mesh.abc", "v 0 0 0\n", r"mesh.abc: unknown extension '.abc'; expected one of .gii"),
        )
        self.refuse(
            lambda name, contents: vtkdgg.read(path_of(name, contents)),
            *((file, pattern) for *file, pattern in cases),
        )
        wrong = ("missing.ply",), "missing.ply: no such file"
        self.refuse(vtkdgg.read, wrong, error=FileNotFoundError)

    def test_nibabel(self):
        """GIFTI and FreeSurfer surfaces, or the name of the package that reads them."""
        points, triangles = support.bumpy()
        freesurfer = b"\xff\xff\xfecreated by test\n\n" + struct.pack(
            ">2i", len(points), len(triangles)
        )
        freesurfer += points.astype(">f4").tobytes() + triangles.astype(">i4").tobytes()
        path = path_of("lh.pial", freesurfer)
        try:
            import nibabel
        except ImportError:
            with self.assertRaisesRegex(ImportError, "pip install nibabel"):
                vtkdgg.read(path)
            # A stand-in with the attributes that are used.
            surface = types.SimpleNamespace(
                agg_data={"pointset": points, "triangle": triangles}.get
            )
            nibabel = types.ModuleType("nibabel")
            nibabel.load = lambda name: surface
            nibabel.freesurfer = types.SimpleNamespace(
                read_geometry=lambda name: (points, triangles)
            )
            gifti = path_of("surface.gii", "")
        else:
            image = nibabel.gifti.GiftiImage()
            for values, intent in ((points, "POINTSET"), (triangles, "TRIANGLE")):
                kind = "float32" if intent == "POINTSET" else "int32"
                image.add_gifti_data_array(
                    nibabel.gifti.GiftiDataArray(values.astype(kind), f"NIFTI_INTENT_{intent}")
                )
            gifti = os.path.join(FOLDER, "surface.gii")
            nibabel.save(image, gifti)
            with open(gifti, "rb") as file:
                cut = path_of("cut.gii", file.read()[:9000])
            for name in (cut, path_of("cut.pial", freesurfer[:9000])):
                self.refuse(vtkdgg.read, ((name,), f"{name}: nibabel cannot read"))
        with mock.patch.dict(sys.modules, nibabel=nibabel):
            for name in (path, gifti):
                mesh = vtkdgg.read(name)
                np.testing.assert_allclose(mesh.points, points, rtol=1e-6)
                np.testing.assert_array_equal(mesh.triangles, triangles)


class Meshes(support.Test):
    def test_arrays(self):
        points, triangles, values = formats.surface()
        mesh = vtkdgg.Mesh(
            points,
            triangles,
            lines=([0, 3], [0, 1, 2]),
            verts=([0, 1], [4]),
            point_data={"value": values, "Normals": np.ones_like(points), "mask": values > 0.0},
            cell_data={"id": np.arange(2 + len(triangles))},
            field_data={"year": [2026]},
        )
        self.assertEqual(repr(mesh), "<vtkdgg.Mesh: 81 points, 1 line, 128 polygons>")
        self.assertIsNone(mesh.graph)
        for name in ("no_folder/arrays.vtp", "no_folder/arrays.obj", "no_folder/arrays.csv"):
            with warnings_as("ignore"):
                self.refuse(vtkdgg.write, ((name, mesh), name), error=OSError)
        path = os.path.join(FOLDER, "arrays.NPY")
        with self.assertWarns(RuntimeWarning):
            vtkdgg.write(path, mesh)
        np.testing.assert_array_equal(np.load(path)["value"], values[[0, 1, 2]])
        path = path_of("arrays.vtp", "")
        os.chmod(path, 0o444)
        wrong = (path, mesh), "arrays.vtp: the file is read-only"
        self.refuse(vtkdgg.write, wrong, error=PermissionError)
        os.chmod(path, 0o640)
        vtkdgg.write(path, mesh)
        self.assertEqual(os.stat(path).st_mode & 0o777, 0o640)
        again = vtkdgg.read(path)
        np.testing.assert_array_equal(again.points, points)
        np.testing.assert_array_equal(again.triangles, triangles)
        np.testing.assert_array_equal(again.lines[1], [0, 1, 2])
        np.testing.assert_array_equal(again.verts[1], [4])
        first = again.cell_data["id"][2]  # the first polygon follows a vert and a line
        distances = vtkdgg.distance(again, [(first, (1, 0, 0))])
        self.assertEqual(distances[triangles[0][0]], 0.0)
        for name in ("point_data", "cell_data", "field_data"):
            expected, found = getattr(mesh, name), getattr(again, name)
            self.assertEqual(list(expected), list(found))
            for key, array in expected.items():
                np.testing.assert_array_equal(found[key], array)
        self.assertEqual(mesh.as_polydata().GetPointData().GetNormals().GetName(), "Normals")

    def test_texture_coordinates(self):
        points, triangles, _ = formats.surface()
        mesh = vtkdgg.Mesh(points, triangles, point_data={"TCoords": points[:, :2]})
        surface = mesh.as_polydata()
        surface.GetPointData().SetActiveTCoords("TCoords")
        for name in ("texture.obj", "texture.off"):
            path = os.path.join(FOLDER, name)
            with self.subTest(name), warnings_as("error"):
                vtkdgg.write(path, surface)
                found = vtkdgg.read(path).point_data["TCoords"]
                np.testing.assert_allclose(found, points[:, :2], rtol=1e-6)

    def test_polygons(self):
        cells = [[0, 1, 3, 2], [0, 1, 3]]
        mesh = vtkdgg.Mesh(support.grid(1, 1)[0], cells)
        self.assertIsNone(mesh.triangles)
        self.assertEqual(
            [part.tolist() for part in mesh.polygons], [[0, 4, 7], cells[0] + cells[1]]
        )

    def test_wrong_arrays(self):
        points, triangles = support.grid(1, 1)
        self.refuse(
            lambda points=points, **given: vtkdgg.Mesh(points, **given),
            ({"triangles": [[0, 1, 9]]}, "triangles: point id 9"),
            ({"polygons": ([0, 2], [0, 1])}, "polygons: a polygon has 2 corners"),
            ({"lines": ([0, 1], [0])}, "lines: a line has 1 corners"),
            ({"polygons": ([0, 3], [0, 1])}, "polygons: expected offsets that rise from 0 .* 2"),
            ({"point_data": {"a": [1]}}, r"point_data\['a'\]: expected 4 rows, got shape \(1,\)"),
            ({"cell_data": {"a": [1]}}, r"cell_data\['a'\]: expected 0 rows"),
            ({"point_data": {"a": ["x"] * 4}}, r"point_data\['a'\]: expected numbers"),
            ({"points": points[0]}, "points: expected the shape"),
        )

    def test_single_precision_is_kept(self):
        """So that filters can warn of coordinates without enough digits."""
        points, triangles, values = formats.surface()
        path = path_of(
            "float.ply", formats.ply(points, triangles, values, "binary_little_endian", "float")
        )
        mesh = vtkdgg.read(path)
        self.assertEqual(mesh.points.dtype, np.float64)
        self.assertEqual(mesh.as_polydata().GetPoints().GetDataType(), VTK_FLOAT)
        mesh.points += 1e-9
        self.assertEqual(mesh.as_polydata().GetPoints().GetDataType(), VTK_DOUBLE)


if __name__ == "__main__":
    unittest.main()
