// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Windows of a finished exact propagation: they give the distance at every surface point.
#ifndef dggEdgeWindows_h
#define dggEdgeWindows_h

#include "dggCoreExport.h"  // for DGG_CORE_EXPORT
#include "dggSurfaceMesh.h" // for SurfaceMesh
#include "dggUnfolding.h"   // for Point2

#include <array>  // for barycentric coordinates
#include <vector> // for the windows

namespace dgg
{
/// A bundle of paths that enter the face of a half-edge h through an interval of h, in the frame of
/// h (dggUnfolding.h). The distance of a point p of the face that is visible from the image through
/// the interval is Offset + |p - Image|.
struct EdgeWindow
{
  double Begin = 0.0; ///< 0 <= Begin < End <= length of the half-edge
  double End = 0.0;
  Point2 Image;        ///< unfolded position of the pseudo-source, Y < 0
  double Offset = 0.0; ///< distance at the pseudo-source
  Id Root = NoId;      ///< the pseudo-source: a vertex, or ~k for source k inside a face or an edge
};

/// A source inside a face or on an edge; on an edge it is listed once for each incident face.
struct FaceSource
{
  Id Face = NoId;
  std::array<double, 3> Barycentric{ { 1.0, 0.0, 0.0 } };
  double Offset = 0.0; ///< initial distance
  Id Root = NoId;      ///< ~k for source k
};

/// The windows that carry shortest paths into faces, plus a few redundant ones, grouped by
/// half-edge. Together with the vertex labels they give the exact distance at every surface point:
/// the minimum over the windows through which the point is visible, the paths through the corners
/// of its face, and the straight lines from sources in that face.
struct DGG_CORE_EXPORT EdgeWindows
{
  /// The windows of half-edge h, disjoint and sorted: [Offsets[h], Offsets[h + 1]). Empty if
  /// windows were not stored.
  std::vector<Offset> Offsets;
  std::vector<EdgeWindow> Windows;
  /// Sorted by face. Sources that are nearest nowhere in their face are omitted.
  std::vector<FaceSource> Sources;

  bool IsEmpty() const { return this->Offsets.empty(); }
  const EdgeWindow* Begin(Id h) const { return this->Windows.data() + this->Offsets[h]; }
  const EdgeWindow* End(Id h) const { return this->Windows.data() + this->Offsets[h + 1]; }

  /// Fails if these cannot be windows of the mesh: non-finite values, or intervals outside their
  /// edges.
  Status Check(const SurfaceMesh& mesh) const;
};
}

#endif
