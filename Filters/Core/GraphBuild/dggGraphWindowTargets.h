// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Surface points to which windows measure straight lines. Internal.
#ifndef dggGraphWindowTargets_h
#define dggGraphWindowTargets_h

#include "dggGraphWindow.h"    // for GraphWindow
#include "dggSurfacePoint.h"   // for DistanceInFace
#include "dggUnfoldingTable.h" // for FaceCrossing

#include <algorithm> // for std::lower_bound
#include <array>     // for barycentric coordinates
#include <cstddef>   // for std::size_t
#include <vector>    // for the targets

namespace dgg
{
/// A point to which the shortest straight line is sought.
struct GraphWindowTarget
{
  Id Face = NoId; ///< face of the mesh
  std::size_t Index = 0;
  std::array<double, 3> Barycentric{ { 0.0, 0.0, 0.0 } };
};

/// Measures straight lines to targets; `shortest[Index]` becomes the length of the shortest one.
class GraphWindowTargets
{
public:
  /// Stores references to both lists, which must outlive this object. `targets` must be sorted by
  /// face.
  GraphWindowTargets(const SurfaceMesh& mesh, const std::vector<GraphWindowTarget>& targets,
    std::vector<double>& shortest)
    : Mesh(mesh)
    , Targets(targets)
    , Shortest(shortest)
  {
  }

  /// Measures targets in the face of the source.
  void ReachFrom(Id f, const std::array<double, 3>& source) const
  {
    this->Reach(f, [&](const GraphWindowTarget& target) {
      return DistanceInFace(this->Mesh, f, source, target.Barycentric);
    });
  }

  /// Measures targets in the face that a window enters, inside the window or on its border.
  void Reach(const GraphWindow& window, const Relay& left, const Relay& right,
    const FaceCrossing& face) const
  {
    const Id h = face.GetHalfEdge();
    this->Reach(SurfaceMesh::Face(h), [&](const GraphWindowTarget& target) {
      const Point2 place = PlaceInEntered(
        this->Mesh, h, face.IsMirrored(), PlaceInFrame(this->Mesh, h, target.Barycentric));
      const Point2 p = FromFrame(window.Ends[0], window.Axis, place);
      const double distance = Norm(p.X, p.Y);
      const double slack = -WidthOfBorder * distance;
      return Cross(p, left.Position) >= slack * left.Distance &&
          Cross(right.Position, p) >= slack * right.Distance
        ? distance
        : -1.0;
    });
  }

private:
  /// Angular tolerance (radians): points this close to a bounding ray are reached by the windows on
  /// both sides.
  static constexpr double WidthOfBorder = 1e-12;

  /// Updates every target in a face with the length that `measure` returns; negative means none.
  template <typename Measure>
  void Reach(Id f, Measure&& measure) const
  {
    auto target = std::lower_bound(this->Targets.begin(), this->Targets.end(), f,
      [](const GraphWindowTarget& t, Id face) { return t.Face < face; });
    for (; target != this->Targets.end() && target->Face == f; ++target)
    {
      const double length = measure(*target);
      double& shortest = this->Shortest[target->Index];
      shortest = length >= 0.0 && length < shortest ? length : shortest;
    }
  }

  const SurfaceMesh& Mesh;
  const std::vector<GraphWindowTarget>& Targets;
  std::vector<double>& Shortest;
};
}

#endif
