// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What distances at the vertices say of where they come from. Internal.
#ifndef dggDescent_h
#define dggDescent_h

#include "dggSurfaceMesh.h" // for SurfaceMesh

#include <vector> // for distances

namespace dgg
{
/// A vertex that is reached from a source straight.
struct DescentSeed
{
  Id Vertex;
  Id Source;
  double Distance;
};

/// The source of every vertex, found by going down the distances along edges as steeply as
/// possible, and over the lowest pass where there is no way down; NoId where distances are
/// Infinity.
std::vector<Id> FindNearestByDescent(const SurfaceMesh& mesh, const std::vector<double>& distances,
  const std::vector<DescentSeed>& seeds);

/// The polar angle at every vertex towards the source, per vertex: the mean over its faces of the
/// direction to the point whose distances to the corners are as given, `offsets` subtracted (that
/// is exact where the faces lie in a plane with the source). Angles around inner vertices are
/// scaled to a full turn for the mean. At irregular vertices the direction of the face that it
/// points into best.
std::vector<double> FindDirectionsOfDescent(const SurfaceMesh& mesh,
  const std::vector<double>& distances, const std::vector<double>& offsets);
}

#endif
