# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writing of meshes, curves, clouds and numbers."""

from __future__ import annotations

import contextlib
import os
import shutil
import warnings
from typing import Any

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonMisc import vtkErrorCode
from vtkmodules.vtkIOLegacy import vtkPolyDataWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

from . import meshes
from .data_set import LEAST_CORNERS
from .errors import VTKError, check, depth_of_package
from .reading import reason_of
from .surface import CELLS, named_arrays
from .vtkDGGReaders import vtkDGGMeshWriter, vtkPCDWriter

__all__ = ["write"]

WRITERS = {
    ".obj": vtkDGGMeshWriter,
    ".off": vtkDGGMeshWriter,
    ".pcd": vtkPCDWriter,
    ".ply": vtkDGGMeshWriter,
    ".stl": vtkDGGMeshWriter,
    ".vtk": vtkPolyDataWriter,
    ".vtp": vtkXMLPolyDataWriter,
    ".xyz": vtkDGGMeshWriter,
}
TABLES = (".csv", ".npy")
# Formats that can hold an answer, by its kind.
FORMATS = {
    "values at points": (".csv", ".npy", ".pcd", ".ply", ".vtk", ".vtp"),
    "cells of a mesh": (".csv", ".npy", ".ply", ".vtk", ".vtp"),
    "curves": (".csv", ".npy", ".obj", ".vtk", ".vtp"),
    "points": (".csv", ".npy", ".obj", ".off", ".pcd", ".ply", ".vtk", ".vtp", ".xyz"),
    "a graph": (".vtk", ".vtp"),
    "a matrix": (".csv", ".npy"),
    "a picture": (".png",),
}


def write(file: Any, mesh: Any) -> None:
    """Write a mesh, curves or a point cloud to a file.

    Coordinates keep their digits. Arrays and cells that the format does not hold are named in a
    warning.

    Parameters
    ----------
    file : str or os.PathLike
        ``.ply .obj .stl .off .pcd .xyz .vtp .vtk .csv .npy``; .vtp and .vtk hold everything. A .csv
        file has a header line and a row for each point, a .npy file the same rows as a structured
        array. An existing file is replaced when the new one is complete, and keeps its mode.
    mesh : Mesh, vtkPolyData, or a mesh of another package
        As for `distance`.

    Raises
    ------
    ValueError
        When the format is unknown or cannot hold the cells.
    OSError
        When the file cannot be written or is read-only. The messages of both name the file.

    See Also
    --------
    read : reads these files.

    Examples
    --------
    >>> vtkdgg.write("distance.ply", vtkdgg.distance(mesh, 0, as_polydata=True))  # doctest: +SKIP
    """
    path = os.fspath(file)
    data, _ = meshes.take(mesh)
    extension = extension_of(path)
    known = (*WRITERS, *TABLES)
    if extension not in known:
        names = " ".join(known)
        raise ValueError(f"{path}: unknown extension '{extension}'; expected one of {names}")
    lost = left_out(path, data)
    if lost:
        warnings.warn(
            f"{extension} does not store {', '.join(lost)}; .vtk and .vtp do",
            RuntimeWarning,
            stacklevel=depth_of_package(),
        )
    if extension in TABLES:
        write_numbers(path, table_of(data))
        return
    if extension == ".vtp":
        _check_cells(path, data)
    write_by(WRITERS[extension](), path, data)


def _check_cells(path, data):
    """Raises an error for cells with too few corners."""
    for kind, (name, least) in zip(CELLS, LEAST_CORNERS.items()):
        sizes = np.diff(vtk_to_numpy(getattr(data, f"Get{kind}")().GetOffsetsArray()))
        for i in np.flatnonzero(sizes < least)[:1]:
            raise ValueError(
                f"{path}: {name}: cell {i} has {sizes[i]} corners, expected at least {least}; "
                "remove it or write a .vtk file"
            )


def write_by(writer, path, data):
    """Writes data to a file by a writer of VTK."""
    if hasattr(writer, "SetFileTypeToBinary"):
        writer.SetFileTypeToBinary()  # exact, and VTK does not read every NaN in a text
    writer.SetInputData(data)
    with replacing(path) as part:
        writer.SetFileName(part)
        try:
            check(writer)
        except VTKError as error:
            is_system_error = error.code < vtkErrorCode.FirstVTKErrorCode or error.code in (
                vtkErrorCode.CannotOpenFileError,
                vtkErrorCode.OutOfDiskSpaceError,
            )
            kind = OSError if is_system_error else ValueError
            text = error.messages[0].replace(part, path)
            raise kind(f"{path}: {reason_of(text, path)}") from None


def check_writable(path):
    """Raises a PermissionError for a file without write permission, also for root, who may write
    to any file."""
    if os.path.isfile(path) and not (os.access(path, os.W_OK) and os.stat(path).st_mode & 0o222):
        raise PermissionError(f"{path}: the file is read-only")


@contextlib.contextmanager
def replacing(path):
    """Yields the name of a new file in the same folder, which replaces `path` at the end and gets
    its mode. After an error, an older file at `path` is unchanged."""
    check_writable(path)
    target = os.path.realpath(path)
    stem, extension = os.path.splitext(target)
    part = f"{stem}.{os.getpid()}.part{extension}"  # unique, for several writers of one file
    if os.path.exists(target) and not os.path.isfile(target):
        part = target  # a device or pipe
    try:
        yield part
        if os.path.isfile(target):
            shutil.copymode(target, part)
        os.replace(part, target)
    except BaseException as error:
        if part != target:
            with contextlib.suppress(OSError):
                os.remove(part)
        if isinstance(error, OSError) and error.filename == part:
            error.filename = path
        raise


def write_numbers(path, values):
    """Writes an array to a .csv or .npy file. CSV files of structured arrays have a header line."""
    if extension_of(path) == ".npy":
        # np.save() adds an extension to names such as x.NPY
        with replacing(path) as part, open(part, "wb") as file:
            np.save(file, values)
        return
    names = values.dtype.names
    kinds = [values.dtype[i].kind for i in range(len(names))] if names else [values.dtype.kind]
    formats = ["%d" if kind in "iub" else "%.17g" for kind in kinds]
    formats = formats if names else formats[0]
    header = ",".join(names or ())
    with replacing(path) as part:
        np.savetxt(part, values, fmt=formats, delimiter=",", header=header, comments="")


def table_of(data):
    """Returns coordinates and point arrays of a vtkPolyData as a structured array.

    Curves have a row for each point of each line, with the index of the line and the cell arrays.
    """
    points = vtk_to_numpy(data.GetPoints().GetData())
    rows = slice(None)
    columns = {}
    if data.GetNumberOfLines() > 0:
        sizes = np.diff(vtk_to_numpy(data.GetLines().GetOffsetsArray()))
        rows = vtk_to_numpy(data.GetLines().GetConnectivityArray())
        columns["line"] = np.repeat(np.arange(len(sizes)), sizes)
    columns.update(zip("xyz", points[rows].T))
    for name, values in named_arrays(data.GetPointData()).items():
        columns.update(_columns(name, values[rows]))
    if data.GetNumberOfLines() > 0:
        cells = data.GetNumberOfVerts() + columns["line"]
        for name, values in named_arrays(data.GetCellData()).items():
            columns.update(_columns(name, values[cells]))
    table = np.empty(len(columns["x"]), dtype=[(key, v.dtype) for key, v in columns.items()])
    for key, values in columns.items():
        table[key] = values
    return table


def _columns(name, values):
    if values.ndim == 1:
        return {name: values}
    return {f"{name}_{i}": column for i, column in enumerate(values.T)}


def extension_of(path):
    """Returns the extension in lower case."""
    return os.path.splitext(path)[1].lower()


def left_out(path, data):
    """Returns the names of arrays and cells of the data that the format does not hold."""
    extension = extension_of(path)
    if extension in (".vtk", ".vtp"):
        return []
    points, cells = data.GetPointData(), named_arrays(data.GetCellData())
    in_points = list(named_arrays(points))
    in_cells = list(cells)
    has_polygons = data.GetNumberOfPolys() + data.GetNumberOfStrips() > 0
    if extension in (".pcd", *TABLES):
        in_points = []
        in_cells = in_cells if has_polygons or extension == ".pcd" else []
    elif extension == ".ply":
        is_plain = data.GetNumberOfPolys() == data.GetNumberOfCells()
        in_points = []
        in_cells = [n for n, values in cells.items() if not is_plain or values.ndim > 1]
    elif extension in (".obj", ".off"):
        active = filter(None, (points.GetNormals(), points.GetTCoords()))
        kept = [array.GetName() for array in active] + ["RGB", "RGBA"]
        in_points = [name for name in in_points if name not in kept]
    lost = ["polygons"] if has_polygons and extension in (".pcd", ".xyz") else []
    return [*lost, *in_cells, *in_points]
