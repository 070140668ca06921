# SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
# SPDX-License-Identifier: BSD-3-Clause
"""Files of meshes, curves and point clouds."""

from __future__ import annotations

import contextlib
import gzip
import os
import re
import shutil
import tempfile
import warnings
import zlib
from typing import Any

from vtkmodules.vtkIOLegacy import (
    vtkPolyDataReader,
    vtkStructuredGridReader,
    vtkUnstructuredGridReader,
)
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLUnstructuredGridReader

from .errors import VTKError, check, depth_of_package
from .legacy_format import LegacyFile
from .mesh import Mesh
from .surface import mesh_of, surface_of
from .vtkDGGReaders import (
    vtkDGGOBJReader,
    vtkDGGOFFReader,
    vtkDGGPLYReader,
    vtkDGGSTLReader,
    vtkDGGXYZReader,
    vtkPCDReader,
)

__all__ = ["read"]

OWN = {
    ".obj": vtkDGGOBJReader,
    ".off": vtkDGGOFFReader,
    ".pcd": vtkPCDReader,
    ".ply": vtkDGGPLYReader,
    ".stl": vtkDGGSTLReader,
    ".xyz": vtkDGGXYZReader,
}
XML = {".vtp": vtkXMLPolyDataReader, ".vtu": vtkXMLUnstructuredGridReader}
LEGACY = {
    "POLYDATA": vtkPolyDataReader,
    "STRUCTURED_GRID": vtkStructuredGridReader,
    "UNSTRUCTURED_GRID": vtkUnstructuredGridReader,
}
EXTENSIONS = sorted([*OWN, *XML, ".gii", ".vtk"])
_FREESURFER = b"\xff\xff\xfe"  # first bytes of a file with triangles


def read(file: Any) -> Mesh:
    """Read a mesh, curves or a point cloud from a file.

    Coordinates keep all digits of the file, and points their order. Truncated and inconsistent
    files are an error. The surface of a volume mesh is extracted, with a warning.

    Parameters
    ----------
    file : str or os.PathLike
        ``.ply .obj .stl .off .pcd .xyz .vtp .vtk .vtu``, all of these also compressed as ``.gz``;
        GIFTI (``.gii``) and FreeSurfer surfaces where nibabel is installed.

    Returns
    -------
    Mesh
        At least one point.

    Raises
    ------
    ValueError
        When the format is unknown, or the file is truncated, damaged or empty. The message names
        the file.
    OSError
        When there is no such file, or it cannot be opened.
    ImportError
        When nibabel is needed and not installed.

    See Also
    --------
    write : writes such files.

    Examples
    --------
    >>> mesh = vtkdgg.read("bunny.ply")  # doctest: +SKIP
    >>> d = vtkdgg.distance(mesh, 0)  # doctest: +SKIP
    """
    path = os.fspath(file)
    extension = extension_of(path)
    if not os.path.exists(path):
        raise FileNotFoundError(f"{path}: no such file")
    if os.path.isdir(path):
        raise IsADirectoryError(f"{path}: expected a file, got a folder")
    if not os.path.isfile(path):
        raise OSError(f"{path}: expected a file, got a device or pipe")
    try:
        if extension in OWN:
            mesh = mesh_of(_update(OWN[extension](), path))
        else:
            with _decompressed(path, extension) as plain:
                mesh = _read_others(plain, extension, path)
    except (ValueError, VTKError, EOFError, gzip.BadGzipFile, zlib.error) as error:
        raise ValueError(f"{path}: {reason_of(error, path)}") from None
    if len(mesh.points) == 0:
        raise ValueError(f"{path}: holds no points")
    return mesh


def extension_of(path):
    """Returns the extension that names the format, without .gz."""
    stem, extension = os.path.splitext(path.lower())
    return os.path.splitext(stem)[1] if extension == ".gz" else extension


def _read_others(path, extension, name):
    """Reads a file by VTK or nibabel. `name` is the name before decompression, for messages."""
    with open(path, "rb") as file:
        start = file.read(len(_FREESURFER))
        if extension in XML:
            file.seek(max(0, os.path.getsize(path) - 100))
            if not file.read().rstrip().endswith(b"</VTKFile>"):
                raise ValueError("the file ends before </VTKFile>: it is truncated")
            return _mesh_of_vtk(_update(XML[extension](), path), name)
    if extension == ".vtk":
        return _mesh_of_vtk(_read_legacy(path, name), name)
    if extension == ".gii" or start == _FREESURFER:
        return Mesh(*_read_by_nibabel(path, extension, name))
    known = " ".join(EXTENSIONS)
    raise ValueError(f"unknown extension '{extension}'; known are {known}, and .gz after these")


def _read_legacy(path, name):
    with open(path, "rb") as file:
        contents = LegacyFile(file.read())
    if contents.kind not in LEGACY:
        raise ValueError(
            f"a DATASET {contents.kind} has no surface; expected one of {', '.join(LEGACY)}"
        )
    contents.check()
    if contents.may_be_cut:
        warnings.warn(
            f"{name}: the last line has no end; the file may be truncated",
            RuntimeWarning,
            stacklevel=depth_of_package(),
        )
    return _update(LEGACY[contents.kind](), path)


def _mesh_of_vtk(data, name):
    return mesh_of(data if data.IsA("vtkPolyData") else surface_of(data, name))


def _update(reader, path):
    """Returns the output of a reader, with all arrays of the file."""
    reader.SetFileName(path)
    for name in ("ReadAllScalarsOn", "ReadAllVectorsOn", "ReadAllNormalsOn", "ReadAllTCoordsOn",
                 "ReadAllTensorsOn", "ReadAllFieldsOn", "ReadAllColorScalarsOn"):  # fmt: skip
        if hasattr(reader, name):  # legacy readers read the first array of a kind by default
            getattr(reader, name)()
    return check(reader)


@contextlib.contextmanager
def _decompressed(path, extension):
    """Yields the path, or that of a temporary copy without compression."""
    if not path.lower().endswith(".gz"):
        yield path
        return
    with tempfile.TemporaryDirectory() as folder:
        plain = os.path.join(folder, "file" + extension)
        with gzip.open(path) as source, open(plain, "wb") as target:
            shutil.copyfileobj(source, target)
        yield plain


def _read_by_nibabel(path, extension, name):
    """Returns points and triangles of a GIFTI or FreeSurfer surface."""
    try:
        import nibabel
    except ImportError:
        raise ImportError(
            f"{name}: reading GIFTI and FreeSurfer surfaces needs nibabel, which is not installed "
            "(Debian: python3-nibabel, else: pip install nibabel)"
        ) from None
    try:
        if extension == ".gii":
            image = nibabel.load(path)
            return image.agg_data("pointset"), image.agg_data("triangle")
        return nibabel.freesurfer.read_geometry(path)
    except Exception as error:  # of its parsers, which have no common class
        raise ValueError(f"nibabel cannot read the file ({error})") from None


def reason_of(error, path):
    """Returns the message of an error in one line, without class and file name."""
    text = " ".join(str(error).split())
    speaker, _, rest = text.partition(": ")
    text = rest if speaker.startswith("vtk") else text
    return re.sub(rf"\ACannot (read|write) {re.escape(path)}: ", "", text)
