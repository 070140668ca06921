// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Ridges within one face. Internal.
#ifndef dggFaceRidges_h
#define dggFaceRidges_h

#include "dggEdgeEnvelope.h" // for EdgeEnvelope
#include "dggFaceEnvelope.h" // for FaceEnvelope
#include "dggFieldJumps.h"   // for FieldJump
#include "dggRidges.h"       // for RidgeOptions

#include <array>   // for barycentric coordinates
#include <cstdint> // for the support of ends
#include <vector>  // for the pieces

namespace dgg
{
/// An end of a ridge segment within a face.
struct RidgeEnd
{
  enum class Support : std::uint8_t
  {
    Vertex, ///< the corner `Side`
    Edge,   ///< the half-edge 3f + Side, at the abscissa X
    Face    ///< at Barycentric
  };

  Support On = Support::Face;
  int Side = 0;
  double X = 0.0;
  std::array<double, 3> Barycentric{ { 0.0, 0.0, 0.0 } };
  double Angle = 0.0; ///< between the two directions
};

/// A ridge segment between two ends.
struct RidgePiece
{
  Id From = NoId;
  Id To = NoId;
  std::vector<std::array<double, 3>> Points; ///< points between the ends
};

/// Ridges within a face. The search region ends slightly inside the boundary of the face, so that
/// the result does not depend on rounding if a ridge runs along an edge. Corners are cut off as
/// well; a ridge that enters a cut-off corner ends at the vertex.
struct FaceRidges
{
  std::vector<RidgeEnd> Ends;
  std::vector<RidgePiece> Pieces;
  /// Polar angle of the gradient, in the frame of each half-edge, near its origin and near its
  /// destination.
  std::array<std::array<float, 2>, 3> RimAngles{};
};

/// Finds the ridges in faces, one face at a time, or the lines between points with different
/// nearest sources.
class FaceRidgeFinder
{
public:
  FaceRidgeFinder(const DistanceField& field, const RidgeOptions& options);

  /// Finds the ridges of a face. The face must be reached.
  void Find(Id f, FaceRidges& found);

  /// Inset of the search region from the edges, as a barycentric coordinate.
  static constexpr double RimInset = 1e-8;
  /// Inset of the search region from the vertices, as a barycentric coordinate.
  static constexpr double CornerInset = 1e-5;

  Id GetNumberOfFallbacks() const { return this->Fallbacks; }

private:
  /// A point on the boundary of a subregion of the face: a corner, or a point at which a ridge
  /// leaves.
  struct RimPoint
  {
    Point2 Place;
    Id Ridge; // index into Crossings, or NoId
  };
  using Rim = std::vector<RimPoint>;
  using Crossing = FieldJump; // a ridge point, located at the tie

  Rim MakeRim();
  void AddSide(int k, const Point2& from, const Point2& to, Rim& rim);
  void AddCorner(int k, const Point2& from, const Point2& to, Rim& rim);
  Id AddEnd(const RidgeEnd& end, const Crossing& crossing);
  void Connect(const Rim& rim);
  bool HidesSource(const Rim& rim) const;
  void Reveal(Id source);
  void Divide(const Rim& rim);
  bool FindJunction(const std::vector<Id>& ridges, const Rim& rim, Point2& place) const;
  Point2 MeanOf(const std::vector<Id>& ridges) const;
  void MakeJunction(const std::vector<Id>& ridges, const Point2& place);
  bool AddPiece(Id from, Id to, bool mayFail);
  bool Refine(const Crossing& from, const Crossing& to, int depth,
    std::vector<std::array<double, 3>>& points);
  bool FindBetween(const Crossing& from, const Crossing& to, Crossing& between) const;
  bool IsTie(const Crossing& crossing) const;
  bool IsNearest(const FieldSample& source, const Point2& p) const;

  const DistanceField& Field;
  const RidgeOptions Options;
  FaceEnvelope Envelope;
  EdgeEnvelope Edge;
  FieldJumpFinder Jumps;
  FaceRidges* Found = nullptr;
  double Size = 0.0;               // length of the longest edge
  std::vector<Crossing> Crossings; // per end
  std::vector<FieldSample> Hidden; // sources in the face whose cells are on no boundary so far
  Id Fallbacks = 0;
};
}

#endif
