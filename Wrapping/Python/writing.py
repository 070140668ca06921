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

from . import _kernel
from .data_set import ATTRIBUTES, MINIMUM_CORNERS, DataSet
from .errors import VTKError, depth_of_package, needing_vtk
from .mesh import Mesh, checked_cells
from .reading import OWN, reason_of

__all__ = ["write"]

VTK = (".vtk", ".vtp")
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
    warning. Files of VTK (.vtp and .vtk) need VTK.

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
    ImportError
        When VTK is needed and not installed.

    See Also
    --------
    read : reads these files.

    Examples
    --------
    >>> vtkdgg.write("distance.ply", vtkdgg.distance(mesh, 0, as_polydata=True))  # doctest: +SKIP
    """
    if not isinstance(file, (str, os.PathLike)):
        raise ValueError(f"file: expected a file name, got a {type(file).__name__}")
    path = os.fspath(file)
    extension = extension_of(path)
    known = (*OWN, *VTK, *TABLES)
    if extension not in known:
        names = " ".join(known)
        raise ValueError(f"{path}: unknown extension '{extension}'; expected one of {names}")
    if extension in VTK:
        with needing_vtk(f"{path}: writing this format"):
            _write_by_vtk(path, extension, mesh)
        return
    data = mesh_from(mesh)
    lost = left_out(path, data)
    if lost:
        warnings.warn(
            f"{extension} does not store {', '.join(lost)}; .vtk and .vtp do",
            RuntimeWarning,
            stacklevel=depth_of_package(),
        )
    if extension in TABLES:
        write_numbers(path, table_of(data))
    else:
        _write_own(path, extension, data)


def mesh_from(data):
    """Returns a mesh of any kind as a Mesh."""
    if isinstance(data, Mesh):
        return data
    from . import meshes

    return meshes.take(data)[0].data.mesh()


def _write_own(path, extension, mesh):
    """Writes a Mesh to a file of a format of the kernel."""
    with replacing(path) as part:
        try:
            texts = _kernel.write_mesh(
                part,
                extension[1:],
                DataSet.of(mesh).stored_points(),
                verts=mesh.verts,
                lines=mesh.lines,
                polygons=mesh.polygons,
                point_data=mesh.point_data,
                cell_data=mesh.cell_data,
                field_data=mesh.field_data,
                active=_active_of(mesh),
            )
        except (OSError, ValueError, MemoryError) as error:
            kind = ValueError if isinstance(error, UnicodeError) else type(error)
            raise kind(f"{path}: {error}") from None
    for text in texts:
        warnings.warn(f"{path}: {text}", RuntimeWarning, stacklevel=depth_of_package())


def _active_of(mesh):
    """Returns the names of the active point arrays by their kinds."""
    active = {ATTRIBUTES.index("normals"): "Normals", **mesh._active}
    return {ATTRIBUTES[kind]: name for kind, name in active.items()}


def _write_by_vtk(path, extension, mesh):
    """Writes a mesh of any kind to a file of VTK."""
    from vtkmodules.vtkIOLegacy import vtkPolyDataWriter
    from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

    from . import meshes

    surface, _ = meshes.take(mesh)
    if extension == ".vtp":  # VTK ends the process when it reads cells with fewer corners
        for name, minimum in MINIMUM_CORNERS.items():
            try:
                checked_cells(surface.data.cells[name], name, surface.number_of_points, minimum)
            except ValueError as error:
                raise ValueError(f"{path}: {error}; .vtk files may have such cells") from None
    writer = vtkXMLPolyDataWriter() if extension == ".vtp" else vtkPolyDataWriter()
    write_by(writer, path, surface.polydata())


def write_by(writer, path, data):
    """Writes data to a file by a writer of VTK."""
    from vtkmodules.vtkCommonMisc import vtkErrorCode

    from .pipeline import check

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
    """Returns coordinates and point arrays of a mesh as a structured array.

    Curves have a row for each point of each line, with the index of the line and the cell arrays.
    """
    mesh = mesh_from(data)
    rows = slice(None)
    columns = {}
    sizes = np.diff(mesh.lines[0])
    if len(sizes) > 0:
        rows = mesh.lines[1]
        columns["line"] = np.repeat(np.arange(len(sizes)), sizes)
    columns.update(zip("xyz", DataSet.of(mesh).stored_points()[rows].T))
    for name, values in mesh.point_data.items():
        columns.update(_columns(name, values[rows]))
    if len(sizes) > 0:
        cells = len(mesh.verts[0]) - 1 + columns["line"]
        for name, values in mesh.cell_data.items():
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
    if extension in VTK:
        return []
    mesh = mesh_from(data)
    in_points, in_cells = list(mesh.point_data), list(mesh.cell_data)
    has_polygons = len(mesh.polygons[0]) > 1
    if extension in (".pcd", *TABLES):
        in_points = []
        in_cells = in_cells if has_polygons or extension == ".pcd" else []
    elif extension == ".ply":
        is_plain = len(mesh.lines[0]) + len(mesh.verts[0]) == 2
        in_points = []
        in_cells = [n for n, v in mesh.cell_data.items() if not is_plain or v.ndim > 1]
    elif extension in (".obj", ".off"):
        active = _active_of(mesh)
        kept = (active.get("normals"), active.get("tcoords"), "RGB", "RGBA")
        in_points = [name for name in in_points if name not in kept]
    lost = ["polygons"] if has_polygons and extension in (".pcd", ".xyz") else []
    return [*lost, *in_cells, *in_points]
