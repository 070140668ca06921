// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A strip of faces laid out in the plane. Internal.
#ifndef dggStripUnfolding_h
#define dggStripUnfolding_h

#include "dggStrip.h"     // for Strip
#include "dggUnfolding.h" // for Point2

#include <array>  // for the sides
#include <vector> // for the portals

namespace dgg
{
/// An edge that the strip crosses, as it lies in the plane.
struct Portal
{
  /// Its ends, on the left and the right of who walks along the strip.
  std::array<Point2, 2> Ends;
  std::array<Id, 2> Vertices{ { NoId, NoId } };
};

/// The faces of a strip side by side in one plane, not turned over: a face of the other orientation
/// is laid out as its mirror image.
struct StripUnfolding
{
  static constexpr int Left = 0;
  static constexpr int Right = 1;

  Point2 Start;
  Point2 End;
  std::vector<Portal> Portals; ///< per crossing

  void Unfold(const SurfaceMesh& mesh, const Strip& strip);
};
}

#endif
