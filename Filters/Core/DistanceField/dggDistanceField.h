// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A distance on a surface: values at vertices, and what is known of where they come from.
#ifndef dggDistanceField_h
#define dggDistanceField_h

#include "dggEdgeWindows.h"    // for EdgeWindows
#include "dggSurfaceMesh.h"    // for SurfaceMesh
#include "dggVirtualSources.h" // for VirtualSources

namespace dgg
{
/// What a distance inside of faces is computed from. Nothing is owned.
///
///  - With windows it is exact (Mitchell, Mount and Papadimitriou, "The discrete geodesic problem",
///    1987): within a face the distance is the least of those of the windows through which a point
///    is seen, of the ways over corners, and of sources in the face.
///  - With virtual sources each corner k of a face has a model M_k of the distance around it
///    (dggCornerModel.h). Where M_k predicts less than the distance d_j at another corner j, the
///    source of k is not visible there; M_k is raised by what is missing, in proportion to the
///    barycentric coordinate of j. So is the way over the corner, d_k and the length of the
///    straight line from k, which predicts too little at j where the values are no distances. The
///    lesser of the two is what k knows, and the way alone where M_k says nothing. The distance in
///    the face is the least of the three corners, but no less than d_j minus the length of the
///    straight line from j: what M_k is raised by may rise faster. That follows arcs and ridges,
///    and at the corners it is what is given. On an edge it is the least of all faces of the edge
///    that are reached, which may be less than what one of them says: a wave may come through any.
///  - Without both it is linear; so it is in faces none of whose corners has a model.
struct DistanceField
{
  const SurfaceMesh* Mesh = nullptr;
  const double* Distances = nullptr;       ///< per vertex; Infinity where unreached
  const EdgeWindows* Windows = nullptr;    ///< may be null or empty
  const VirtualSources* Sources = nullptr; ///< may be null or empty; used when there are no windows

  bool HasWindows() const { return this->Windows && !this->Windows->IsEmpty(); }
  bool HasSources() const
  {
    return !this->HasWindows() && this->Sources && !this->Sources->empty();
  }
  /// Whether the distance is known everywhere in the face.
  bool IsReached(Id f) const
  {
    return !this->Mesh->IsDropped(f) && this->Distances[this->Mesh->Origin(3 * f)] < Infinity &&
      this->Distances[this->Mesh->Origin(3 * f + 1)] < Infinity &&
      this->Distances[this->Mesh->Origin(3 * f + 2)] < Infinity;
  }
};

/// The distance at a point, and where it comes from.
struct FieldSample
{
  double Distance = Infinity;
  Point2 Gradient; ///< points away from the source; of unit length but for linear fields
  /// The image of the source in the same plane: the level sets are circles around it, of radius
  /// level - Offset. Of no meaning when not HasImage.
  Point2 Image;
  double Offset = 0.0;
  bool HasImage = false;
  /// Which of the candidates it is: equal for two samples of a profile when they belong to the same
  /// smooth piece.
  Id Candidate = NoId;
};
}

#endif
