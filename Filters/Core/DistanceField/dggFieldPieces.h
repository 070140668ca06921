// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The surface of a field that several processes have in pieces. Internal.
#ifndef dggFieldPieces_h
#define dggFieldPieces_h

#include "dggProcessGroup.h" // for messages
#include "dggTypes.h"        // for Offset

#include <functional> // for ids

namespace dgg
{
/// Processes each of which has the field on a piece of a surface and on layers of cells around the
/// piece. Ids of vertices and faces are in the order of global ids.
struct FieldPieces
{
  ProcessGroup& Group;
  ///@{
  /// Edge lengths of the entire surface.
  double MeanEdgeLength;
  double LongestEdge;
  ///@}
  ///@{
  /// Global ids of points and cells.
  std::function<Offset(Id vertex)> GetPointId;
  std::function<Offset(Id face)> GetCellId;
  ///@}
};
}

#endif
