// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What holds for isolines of any distance on any surface.
#ifndef IsolineTestTools_h
#define IsolineTestTools_h

#include "vtkPolyData.h"

namespace dggtest
{
/// Ends and middle of every piece of the lines lie in the triangle of the surface that FaceId
/// names, up to 1e-9 of its longest edge. Returns the number of pieces.
vtkIdType ExpectPiecesInTheirFaces(vtkPolyData* surface, vtkPolyData* lines);
}

#endif
