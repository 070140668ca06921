// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Shortens closed paths to closed geodesics. Internal.
#ifndef dggLoopShortener_h
#define dggLoopShortener_h

#include "dggPathShortener.h"  // for sections between two passages of a vertex
#include "dggStrip.h"          // for Strip
#include "dggStripUnfolding.h" // for StripUnfolding
#include "dggSurfacePath.h"    // for SurfacePath

#include <vector> // for the crossings

namespace dgg
{
/// Shortens a closed path, which may move everywhere, to a closed geodesic by iteration. Each step
/// computes the shortest closed path in the ring of faces; unless straight, this path bends around
/// vertices. The ring is cut open at one of these vertices, shortened with both ends at the vertex,
/// and rerouted around the other side of the vertex if that route is shorter. If straight closed
/// paths are parallel, as around a cylinder, all have equal length, and the iteration ends at the
/// path in the middle of its ring. If they are parallel only up to FoundLoop::KinkTolerance, as
/// with rounded coordinates, the iteration ends at this path if the path would otherwise contract
/// to a point.
class LoopShortener
{
public:
  /// Tolerance, radians, by which the angle of a closed path at a vertex may be smaller than pi.
  /// The possible gain is of second order.
  static constexpr double AngleTolerance = 1e-9;

  explicit LoopShortener(const SurfaceMesh& mesh)
    : Mesh(mesh)
    , Shortener(mesh)
  {
  }

  /// Shortens a closed path. `ring` contains the crossings of the path, in order; the last crossing
  /// leads into the face that the first one leaves. Returns false if the path contracts to a point.
  bool Shorten(std::vector<EdgeCrossing> ring, SurfacePath& loop);

  /// Shortens a path whose last point equals its first, like Shorten(). Also returns false if the
  /// path passes through a vertex in which faces only touch, because the path cannot be moved at
  /// such a vertex.
  bool PullTight(const SurfacePath& path, SurfacePath& loop);

  /// Returns the smaller of the two angles of a closed path at the start of a segment, at most pi;
  /// pi for a geodesic.
  static double AngleAt(const SurfaceMesh& mesh, const SurfacePath& loop, std::size_t piece);

private:
  /// The ring, cut open at the edge of its first crossing.
  struct Cut
  {
    Strip Open;
    Point2 Starts[2]; ///< the two ends of the edge, at the start of the strip
    Point2 Ends[2];   ///< the two ends of the edge, at the end of the strip
  };

  bool Tighten(std::vector<EdgeCrossing>& ring, SurfacePath& loop, SurfacePath& spare);
  static void CloseUp(std::vector<EdgeCrossing>& ring);
  void CutAt(const std::vector<EdgeCrossing>& ring);
  double LayAt(double t);
  double SlopeAt(double t);
  double Minimize();
  double FindStraight(double& t);
  Id FindBend(const std::vector<EdgeCrossing>& ring, double t, std::size_t& place) const;
  bool IsAt(Id vertex, const EdgeCrossing& crossing) const;
  bool OpenAt(
    const std::vector<EdgeCrossing>& ring, Id vertex, std::size_t place, Strip& open) const;
  void AppendStraight(const std::vector<EdgeCrossing>& ring, double t, SurfacePath& loop);

  const SurfaceMesh& Mesh;
  PathShortener Shortener;
  Cut TheCut;
  StripUnfolding Plane;
  Funnel TheFunnel;
  std::vector<StripBend> Bends;
};
}

#endif
