// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A distance field on a surface: values at vertices, and optionally their sources.
#ifndef dggDistanceField_h
#define dggDistanceField_h

#include "dggEdgeWindows.h"    // for EdgeWindows
#include "dggSurfaceMesh.h"    // for SurfaceMesh
#include "dggVirtualSources.h" // for VirtualSources

#include <cstdint>    // for flags
#include <functional> // for ids

namespace dgg
{
class ProcessGroup;

/// Processes each of which has the field on a piece of a surface and on layers of cells around the
/// piece. Ids of vertices and faces are in the order of global ids.
struct FieldPieces
{
  ProcessGroup& Group;
  ///@{
  /// Edge lengths of the entire surface.
  double MeanEdgeLength;
  double LongestEdge;
  ///@}
  ///@{
  /// Global ids of points and cells.
  std::function<Offset(Id vertex)> GetPointId;
  std::function<Offset(Id face)> GetCellId;
  ///@}
};

/// Data from which the distance inside faces is computed. Does not own its arrays.
///
/// - With windows the distance is exact (Mitchell, Mount and Papadimitriou, "The discrete geodesic
///   problem", 1987): within a face it is the minimum over the windows through which a point is
///   visible, the paths through corners, and the sources in the face.
/// - With virtual sources, each corner k of a face has a model M_k of the distance around the
///   corner (dggCornerModel.h). If M_k predicts less than the distance d_j at another corner j, the
///   source of k is not visible from j; M_k is raised by the deficit, in proportion to the
///   barycentric coordinate of j. The path through the corner, d_k plus the length of the straight
///   line from k, is raised in the same manner; its prediction at j is too small if the values are
///   not distances. The estimate of corner k is the smaller of the two, or the path through k if
///   M_k is undefined. The distance in the face is the minimum over the three corners, but at least
///   d_j minus the length of the straight line from j, because a raised M_k may grow too fast. This
///   method reproduces arcs and ridges, and interpolates the given values at the corners. On an
///   edge the distance is the minimum over all reached faces of the edge, which may be less than
///   the distance in one of the faces, since the wavefront may arrive through any of them.
/// - Without windows and virtual sources, the distance is linear; it is also linear in faces
///   without a corner that has a model.
struct DistanceField
{
  const SurfaceMesh* Mesh = nullptr;
  const double* Distances = nullptr;       ///< per vertex; Infinity where unreached
  const EdgeWindows* Windows = nullptr;    ///< may be null or empty
  const VirtualSources* Sources = nullptr; ///< may be null or empty; used when there are no windows
  /// Per vertex, the index of the nearest source; only needed for FieldSample::Source.
  const Id* NearestSource = nullptr;
  /// Per face, its layer around the piece of this process: 0 in the piece, 1 for cells of other
  /// processes at its points, and so on. May be null.
  const std::uint8_t* Layers = nullptr;

  bool HasWindows() const { return this->Windows && !this->Windows->IsEmpty(); }
  bool HasSources() const
  {
    return !this->HasWindows() && this->Sources && !this->Sources->empty();
  }
  /// Returns true if the distance is defined everywhere in the face.
  bool IsReached(Id f) const
  {
    return !this->Mesh->IsDropped(f) && this->Distances[this->Mesh->Origin(3 * f)] < Infinity &&
      this->Distances[this->Mesh->Origin(3 * f + 1)] < Infinity &&
      this->Distances[this->Mesh->Origin(3 * f + 2)] < Infinity;
  }
  /// Returns true if the distance is defined in the face and the face is in the piece of this
  /// process, or in the layers around the piece up to `layer`.
  bool IsTraced(Id f, int layer = 0) const
  {
    return this->IsReached(f) && !(this->Layers && this->Layers[f] > layer);
  }
};

/// The distance at a point, with its gradient and source.
struct FieldSample
{
  double Distance = Infinity;
  Point2 Gradient; ///< points away from the source; unit length unless linear
  /// Image of the source in the same plane. The level sets are circles around this image, of radius
  /// level - Offset. Undefined unless HasImage.
  Point2 Image;
  double Offset = 0.0;
  bool HasImage = false;
  /// Id of the candidate that attains the minimum. Two samples of an envelope have equal ids if
  /// they belong to the same smooth piece.
  Id Candidate = NoId;
  /// Index of the nearest source. Defined if the field has windows and NearestSource.
  Id Source = NoId;
};
}

#endif
