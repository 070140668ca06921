// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Isolines in pieces, edge by edge and face by face. Internal.
#ifndef dggIsolineParts_h
#define dggIsolineParts_h

#include "dggTypes.h" // for Id

#include <array>  // for barycentric coordinates
#include <vector> // for the pieces

namespace dgg
{
/// A point where an isoline crosses an edge. All faces of the edge share it.
struct LevelCrossing
{
  Id HalfEdge = NoId; ///< the representative of the edge (FindEdge())
  double X = 0.0;     ///< abscissa from its origin, in [0, length]
  Id Level = 0;       ///< index into the levels
};

/// A piece of an isoline within one face, from one crossing on its rim to another, or closed. It
/// has the lower distance on its left.
struct FaceCurve
{
  Id Face = NoId;
  Id Level = 0;
  Id First = NoId; ///< crossing that it starts from; NoId for a closed curve
  Id Last = NoId;
  /// Coordinates of the points in between, with respect to SurfaceMesh::GetTriangle(); of all
  /// points of a closed curve, the first one not repeated.
  std::vector<std::array<double, 3>> Points;
};
}

#endif
