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
/// A virtual source as seen from a vertex.
struct VirtualPlace
{
  double Length = 0.0; ///< straight distance
  Id HalfEdge = NoId;  ///< half-edge at the vertex from which Angle is measured; NoId at the source
  double Angle = 0.0;
};

class PropagationOutput
{
public:
  /// Relative tolerance at the maximum distance.
  static constexpr double LimitSlack = 1e-6;

  /// `shift` is the smallest initial distance.
  PropagationOutput(const SurfaceMesh& mesh, const PropagationOptions& options, double shift,
    PropagationResult& result);

  bool WantsLabels() const
  {
    return this->Options.WantNearestSource || this->Options.WantVirtualSource;
  }
  /// Sets the distance of a vertex. Returns false if it is beyond the maximum distance. Several
  /// threads may set different vertices.
  bool SetDistance(Id v, double distance);
  /// Returns true if the distance of a vertex was set to this value.
  bool IsAt(Id v, double distance) const
  {
    return this->Result.Distances[v] == std::min(distance, this->Options.MaximumDistance);
  }
  void SetSource(Id v, Id root, const VirtualPlace& place);
  Id GetNearest(Id v) const
  {
    return this->Options.WantNearestSource ? this->Result.NearestSource[v] : NoId;
  }
  /// Sets the exact distances of the sources and of the corners of their faces, which no label has
  /// reached.
  void TakeSources(const std::vector<GeodesicSource>& sources);

private:
  const SurfaceMesh& Mesh;
  const PropagationOptions& Options;
  const double Shift;
  PropagationResult& Result;
};
}

#endif
