// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Isolines by the published method, as a comparison. Internal.
#ifndef dggApolloniusParts_h
#define dggApolloniusParts_h

#include "dggDistanceField.h" // for DistanceField
#include "dggIsolineParts.h"  // for the pieces
#include "dggParallel.h"      // for ParallelFor
#include "dggTypes.h"         // for Status

#include <vector> // for levels and pieces

namespace dgg
{
/// Most Steiner points per edge.
constexpr int MaximumSteinerPoints = 50;

/// The isolines of some levels, edge by edge and face by face, from the Apollonius diagrams of
/// points on the rims of faces: cubics along edges, linear in the triangles that the diagrams cut
/// faces into (dggHermiteEdge.h, dggApolloniusFace.h). Along edges the distance is linear between
/// the nodes of HermiteEdge.
///
/// Both ends of a curve are crossings of its level; each crossing is an end of one curve in each of
/// the faces of its edge that are reached, so no curve dangles. Points at the level count as above
/// it; the lower side is on the left of a curve as seen with the orientation of the face. Crossings
/// are in order of edges, levels and abscissae, curves in that of faces and levels. The result does
/// not depend on threads.
///
/// Directions come from Sources, which may be there besides windows. Where neither is there, they
/// are fitted to the distances (dggSourceFit.h).
///
/// Fails when the number of Steiner points per edge is not 0 to 50 or a level is not finite; then
/// and when stopped there are no pieces.
Status FindApolloniusParts(const DistanceField& field, int steinerPoints,
  const std::vector<double>& levels, const ParallelFor& parallel, const ProgressCallback& progress,
  std::vector<LevelCrossing>& crossings, std::vector<FaceCurve>& curves);
}

#endif
