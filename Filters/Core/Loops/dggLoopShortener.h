// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Pulls closed paths tight. Internal.
#ifndef dggLoopShortener_h
#define dggLoopShortener_h

#include "dggPathShortener.h"  // for what is between two passages of a vertex
#include "dggStrip.h"          // for Strip
#include "dggStripUnfolding.h" // for StripUnfolding
#include "dggSurfacePath.h"    // for SurfacePath

#include <vector> // for the crossings

namespace dgg
{
/// Shortens a closed path, which may move everywhere, to a closed geodesic, in turns: the shortest
/// closed path in its ring of faces is found; it bends around vertices, unless it is straight all
/// around. It is cut open at one of them, shortened with both ends there, and led around that
/// vertex if it is shorter there. Where straight closed paths lie side by side, as around a
/// cylinder, all are as long: it ends at the one in the middle of its ring. Where they are parallel
/// only up to FoundLoop::KinkTolerance, as with rounded coordinates, it ends there if it would
/// contract to a point otherwise.
class LoopShortener
{
public:
  /// A closed path may be smaller than pi at a vertex by this much: what could be gained is the
  /// square.
  static constexpr double AngleTolerance = 1e-9;

  explicit LoopShortener(const SurfaceMesh& mesh)
    : Mesh(mesh)
    , Shortener(mesh)
  {
  }

  /// `ring` are the crossings of the closed path, in order; the last one leads into the face that
  /// the first one leaves. False when the path contracts to a point.
  bool Shorten(std::vector<EdgeCrossing> ring, SurfacePath& loop);

  /// The same for a path whose last point is its first one. False as well when it passes through a
  /// vertex in which faces meet in nothing else: there it cannot be moved.
  bool PullTight(const SurfacePath& path, SurfacePath& loop);

  /// The smaller angle that a closed path makes with itself where a piece starts, pi at most: pi
  /// for a geodesic.
  static double AngleAt(const SurfaceMesh& mesh, const SurfacePath& loop, std::size_t piece);

private:
  /// The ring, cut open at the edge of its first crossing.
  struct Cut
  {
    Strip Open;
    Point2 Starts[2]; ///< the two ends of the edge, where the strip starts
    Point2 Ends[2];   ///< and where it ends
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
