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

import numpy as np

from . import _kernel
from .data_set import ATTRIBUTES
from .errors import VTKError, depth_of_package, needing_vtk
from .legacy_format import LegacyFile
from .mesh import Mesh
from .xml_format import XMLFile

__all__ = ["read"]

OWN = (".obj", ".off", ".pcd", ".ply", ".stl", ".xyz")
VTK = {".vtk": LegacyFile, ".vtp": XMLFile, ".vtu": XMLFile}
EXTENSIONS = sorted([*OWN, *VTK, ".gii"])
_LFS = b"version https://git-lfs.github.com/spec/"  # a file that stands for another one
_FREESURFER = b"\xff\xff\xfe"  # first bytes of a file with triangles


def read(file: Any) -> Mesh:
    """Read a mesh, curves or a point cloud from a file.

    Coordinates keep all digits of the file, and points their order. Truncated and inconsistent
    files are an error. The surface of a volume mesh is extracted, with a warning. Grids (``.vtu``
    and some ``.vtk`` files) need VTK.

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
        When nibabel or VTK is needed and not installed.

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
    with open(path, "rb") as head:
        if head.read(len(_LFS)) == _LFS:
            raise ValueError(f"{path}: the file is a pointer of Git LFS; run git lfs pull")
    try:
        if extension in OWN:
            mesh = _read_own(path, extension)
        elif extension in VTK:
            mesh = _read_vtk(path, extension)
        else:
            with _decompressed(path, extension) as plain:
                mesh = _read_by_nibabel(plain, extension, path)
    except (ValueError, VTKError, EOFError, gzip.BadGzipFile, zlib.error) as error:
        raise ValueError(f"{path}: {reason_of(error, path)}") from None
    if len(mesh.points) == 0:
        raise ValueError(f"{path}: contains no points")
    return mesh


def extension_of(path):
    """Returns the extension that names the format, without .gz."""
    stem, extension = os.path.splitext(path.lower())
    return os.path.splitext(stem)[1] if extension == ".gz" else extension


def _read_own(path, extension):
    """Returns the Mesh of a file that the kernel's parsers read."""
    try:
        found = _kernel.read_mesh(path, extension[1:])
    except (OSError, MemoryError) as error:
        raise type(error)(f"{path}: {error}") from None
    for text in found.warnings:
        warnings.warn(f"{path}: {text}", RuntimeWarning, stacklevel=depth_of_package())
    mesh = Mesh(
        found.points,
        **found.cells,
        point_data=found.point_data,
        cell_data=found.cell_data,
        field_data=found.field_data,
    )
    mesh._is_single = found.points.dtype == np.float32
    mesh._active = {ATTRIBUTES.index(kind): name for kind, name in found.active.items()}
    return mesh


def _read_vtk(path, extension):
    """Returns the Mesh of a VTK file."""
    with gzip.open(path) if path.lower().endswith(".gz") else open(path, "rb") as file:
        data = VTK[extension](file.read()).read()
    is_surface = data.kind == "POLYDATA"
    removed = data.remove_degenerate() if is_surface else 0
    notes = {
        f"arrays of strings are skipped: {', '.join(dict.fromkeys(data.texts))}": data.texts,
        f"cells with too few corners are ignored: {removed}": removed,
        "the last line has no end; the file may be truncated": data.may_be_cut,
    }
    for note in (text for text, applies in notes.items() if applies):
        warnings.warn(f"{path}: {note}", RuntimeWarning, stacklevel=depth_of_package())
    if is_surface:
        return data.mesh()
    with needing_vtk(f"{path}: reading grids"):
        from .vtk_data import data_set_of, grid_of, surface_of
    return data_set_of(surface_of(grid_of(data), path)).mesh()


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
    """Returns the Mesh of a GIFTI or FreeSurfer surface. `name` is the name for messages."""
    with open(path, "rb") as file:
        if extension != ".gii" and file.read(len(_FREESURFER)) != _FREESURFER:
            known = " ".join(EXTENSIONS)
            raise ValueError(
                f"unknown extension '{extension}'; expected one of {known}, optionally with .gz"
            )
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
            return Mesh(image.agg_data("pointset"), image.agg_data("triangle"))
        return Mesh(*nibabel.freesurfer.read_geometry(path))
    except Exception as error:  # errors of its parsers have no common class
        raise ValueError(f"nibabel cannot read the file ({error})") from None


def reason_of(error, path):
    """Returns the message of an error in one line, without class and file name."""
    text = " ".join(str(error).split())
    speaker, _, rest = text.partition(": ")
    text = rest if speaker.startswith("vtk") else text
    return re.sub(rf"\ACannot (read|write) {re.escape(path)}: ", "", text)
