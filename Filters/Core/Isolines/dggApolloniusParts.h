// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Isolines by the published method of Apollonius diagrams, for comparison. Internal.
#ifndef dggApolloniusParts_h
#define dggApolloniusParts_h

#include "dggDistanceField.h" // for DistanceField
#include "dggIsolineParts.h"  // for FaceCurve

#include <vector> // for the curves

namespace dgg
{
/// Finds the isolines of increasing levels, edge by edge and face by face, from the Apollonius
/// diagrams of points on the boundaries of faces. The distance is a cubic along edges, and linear
/// in the triangles into which the diagrams subdivide faces. Along edges the distance is linear
/// between the nodes.
///
/// Both ends of a curve are crossings of its level. Each crossing is an end of exactly one curve in
/// each reached face of its edge, so that no curve dangles. Points at the level count as above. The
/// lower side is on the left of a curve with respect to the orientation of the face. Curves are
/// sorted by face and level. The result does not depend on the number of threads.
///
/// Directions are taken from Sources, which may be set in addition to windows. If neither is set,
/// directions are fitted to the distances (dggSourceFinding.h). Fails when stopped.
Status FindApolloniusParts(const DistanceField& field, int steinerPoints,
  const std::vector<double>& levels, const ParallelFor& parallel, const ProgressCallback& progress,
  LevelCrossings& crossings, std::vector<FaceCurve>& curves);
}

#endif
