// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The results of a propagation of virtual sources, in the units of the mesh. Internal.
#ifndef dggPropagationOutput_h
#define dggPropagationOutput_h

#include "dggSourcePropagation.h" // for PropagationResult

#include <algorithm> // for std::min
#include <vector>    // for sources

namespace dgg
{
/// A virtual source as a vertex sees it.
struct VirtualPlace
{
  double Length = 0.0; ///< straight distance
  Id HalfEdge = NoId;  ///< of the vertex, from which the angle is measured; NoId at the source
  double Angle = 0.0;
};

class PropagationOutput
{
public:
  /// Rounding at the largest distance that is asked for, relative.
  static constexpr double LimitSlack = 1e-6;

  /// `shift` is the least initial distance.
  PropagationOutput(const SurfaceMesh& mesh, const PropagationOptions& options, double shift,
    PropagationResult& result);

  bool WantsLabels() const
  {
    return this->Options.WantNearestSource || this->Options.WantVirtualSource;
  }
  /// False when it is beyond the maximum distance. Several threads may set different vertices.
  bool SetDistance(Id v, double distance);
  /// Whether that is what it has been set to.
  bool IsAt(Id v, double distance) const
  {
    return this->Result.Distances[v] == std::min(distance, this->Options.MaximumDistance);
  }
  void SetSource(Id v, Id root, const VirtualPlace& place);
  Id GetNearest(Id v) const
  {
    return this->Options.WantNearestSource ? this->Result.NearestSource[v] : NoId;
  }
  /// The sources themselves, and the corners of the faces that they lie in, are known exactly; no
  /// label has come to them.
  void TakeSources(const std::vector<GeodesicSource>& sources);

private:
  const SurfaceMesh& Mesh;
  const PropagationOptions& Options;
  const double Shift;
  PropagationResult& Result;
};
}

#endif
