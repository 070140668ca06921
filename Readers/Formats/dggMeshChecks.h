// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Checks and steps between a front end and the writers. Internal.
#ifndef dggMeshChecks_h
#define dggMeshChecks_h

#include "dggFormats.h"

namespace dgg
{
/// Throws FileError if a cell or an array does not fit the points. Removes cells without points and
/// their values.
void CheckMesh(MeshData& mesh);

/// Adds a warning for each array whose integers a PLY file rounds.
void WarnOfRounding(MeshData& mesh);

/// Replaces polygons by triangles, and removes the cell arrays if there are other polygons than
/// triangles. Throws FileError if there are too many points.
void TriangulatePolygons(MeshData& mesh);
}

#endif
