// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The windows of a finished exact propagation: the distance of every point of the surface.
#ifndef dggEdgeWindows_h
#define dggEdgeWindows_h

#include "dggCoreExport.h"  // for DGG_CORE_EXPORT
#include "dggSurfaceMesh.h" // for SurfaceMesh
#include "dggUnfolding.h"   // for Point2

#include <array>  // for barycentric coordinates
#include <vector> // for the windows

namespace dgg
{
/// Paths that enter the face of a half-edge h through an interval of it, in the frame of h
/// (dggUnfolding.h): the distance of a point p of the face that is seen through the interval is
/// Offset + |p - Image|.
struct EdgeWindow
{
  double Begin = 0.0; ///< 0 <= Begin < End <= length of the half-edge
  double End = 0.0;
  Point2 Image;        ///< of the pseudo-source, Y < 0
  double Offset = 0.0; ///< distance at the pseudo-source
  Id Root = NoId;      ///< the pseudo-source: a vertex, or ~k for source k inside a face or an edge
};

/// A source inside a face, or on an edge of it (then once for each face of the edge).
struct FaceSource
{
  Id Face = NoId;
  std::array<double, 3> Barycentric{ { 1.0, 0.0, 0.0 } };
  double Offset = 0.0; ///< the distance that it starts with
  Id Root = NoId;      ///< ~k for source k
};

/// The windows of the first paths that enter faces, but for a few further ones, edge by edge.
/// With the labels of the vertices it gives the exact distance at every point of the surface: the
/// least of those of the windows that the point is seen through, of the ways over the corners of
/// its face, and of the straight ways from sources in the face.
struct DGG_CORE_EXPORT EdgeWindows
{
  /// The windows of half-edge h, disjoint and in order: [Offsets[h], Offsets[h + 1]). Empty when
  /// windows were not kept.
  std::vector<Offset> Offsets;
  std::vector<EdgeWindow> Windows;
  /// In order of faces; those are left out that are nowhere in their face nearer than another one.
  std::vector<FaceSource> Sources;

  bool IsEmpty() const { return this->Offsets.empty(); }
  const EdgeWindow* Begin(Id h) const { return this->Windows.data() + this->Offsets[h]; }
  const EdgeWindow* End(Id h) const { return this->Windows.data() + this->Offsets[h + 1]; }

  /// Fails with a message when these cannot be the windows of the mesh: numbers that are not finite
  /// or intervals outside of their edges.
  Status Check(const SurfaceMesh& mesh) const;
};
}

#endif
