// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Shortens paths to geodesics. Internal.
#ifndef dggPathShortener_h
#define dggPathShortener_h

#include "dggStrip.h"          // for Strip
#include "dggStripUnfolding.h" // for StripUnfolding
#include "dggSurfacePath.h"    // for SurfacePath

#include <cstddef> // for std::size_t
#include <cstdint> // for flags
#include <vector>  // for the bends

namespace dgg
{
/// Shortens the path in a strip of faces: the shortest path in the strip, computed in the plane, is
/// a geodesic except at the strip vertices around which it bends. Wherever the angle on the other
/// side of such a vertex is below pi, the strip is rerouted around that side, and the path becomes
/// shorter (Xin and Wang, "Efficiently determining a locally exact shortest path on polyhedral
/// surfaces", 2007). The result is a locally shortest path: all of its bends have angles of at
/// least pi on both sides, or lie on the boundary. Buffers are reused between calls.
class PathShortener
{
public:
  /// `isRim` flags the vertices of a submesh at which faces of its parent are missing; may be null.
  explicit PathShortener(const SurfaceMesh& mesh, const std::uint8_t* isRim = nullptr)
    : Mesh(mesh)
    , IsRim(isRim)
  {
  }

  ///@{
  /// Returns true if a path has bent at a vertex of the rim, where faces may be missing.
  bool MeetsRim() const { return this->HasMetRim; }
  void ForgetRim() { this->HasMetRim = false; }
  ///@}

  /// Shortens until the path is locally shortest. Returns its length.
  double Shorten(Strip& strip);

  /// Appends the shortest path in a strip to `path`, which must be empty or end where the strip
  /// starts.
  void Append(const Strip& strip, SurfacePath& path);

  /// Returns the total number of crossings of unfolded strips, which dominates the running time.
  std::size_t GetWork() const { return this->Work; }

private:
  /// A vertex on the border of a strip, and the portals that end in it.
  struct Corner
  {
    Id Vertex;
    int Side;
    std::size_t First;
    std::size_t Last;
    Point2 Position;
  };

  double Lay(const Strip& strip);
  Corner CornerAt(const StripBend& bend) const;
  bool Reroute(Strip& strip);
  bool IsShorterBehind(const Strip& strip, const Corner& corner, const Point2& before,
    const Point2& after, std::vector<EdgeCrossing>& detour) const;
  bool WalkBehind(
    const Strip& strip, const Corner& corner, std::vector<EdgeCrossing>& detour) const;
  double AngleInStrip(
    const Strip& strip, const Corner& corner, const Point2& before, const Point2& after) const;

  const SurfaceMesh& Mesh;
  const std::uint8_t* IsRim;
  bool HasMetRim = false;
  StripUnfolding Plane;
  Funnel TheFunnel;
  std::vector<StripBend> Bends;
  std::vector<EdgeCrossing> Crossings;
  std::vector<EdgeCrossing> Detour;
  std::size_t Work = 0;
};
}

#endif
