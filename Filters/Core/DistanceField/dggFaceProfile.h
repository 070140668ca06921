// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The distance inside one face.
#ifndef dggFaceProfile_h
#define dggFaceProfile_h

#include "dggCoreExport.h"    // for DGG_CORE_EXPORT
#include "dggCornerModel.h"   // for the models of the corners
#include "dggDistanceField.h" // for DistanceField

#include <array>  // for the corners
#include <vector> // for the windows

namespace dgg
{
/// The distance inside a face as a function of the plane, in the frame of half-edge 3f. On the rim
/// of the face it is that of EdgeProfile up to rounding when it comes from windows or is linear;
/// with models, that of EdgeProfile may be shorter, through another face of the edge. An object can
/// be moved from face to face, which saves allocations.
class DGG_CORE_EXPORT FaceProfile
{
public:
  explicit FaceProfile(const DistanceField& field)
    : Field(field)
  {
  }

  /// Look at a face, which must be reached (DistanceField::IsReached()).
  void Enter(Id f);

  Id GetFace() const { return this->Face; }
  const std::array<Point2, 3>& GetCorners() const { return this->Corners; }
  double GetCornerDistance(int k) const { return this->Distances[k]; }
  Point2 PlaceOf(const std::array<double, 3>& barycentric) const;
  std::array<double, 3> BarycentricOf(const Point2& p) const;

  /// The distance at a point of the face.
  double At(const Point2& p) const { return this->SampleAt(p).Distance; }
  FieldSample SampleAt(const Point2& p) const;
  /// That of one candidate of models alone, also where another one is nearer.
  FieldSample SampleOfCandidate(Id candidate, const Point2& p) const;

  /// Whether the distance comes from models of the corners, and that of one of them alone at a
  /// point.
  /// @{
  bool IsModelled() const { return this->HasModels; }
  double ModelAt(int k, const Point2& p) const
  {
    return this->FromModel(k, p, this->BarycentricOf(p)).Distance;
  }
  /// @}
  /// The most that the model of a corner is raised by at another corner.
  double GetLargestRaise(int k) const;
  /// The least distance that the corners allow at a point, and the corner that says so. -Infinity
  /// where no model is raised, as no model is below it then.
  struct LowerBound
  {
    double Distance = -Infinity;
    int Corner = 0;
  };
  LowerBound GetLowerBound(const Point2& p) const;

  /// Whether the waves that reach the face come from all sides, so that a point inside it may be
  /// farther away than all around it. When in doubt, true.
  bool MayHavePeak() const;

  /// Sources inside the face, or on its edges.
  const std::vector<FieldSample>& GetSources() const { return this->Sources; }

private:
  /// A window and its image in the plane of the face.
  struct SeenWindow
  {
    double Begin;
    double End;
    Point2 Image; // in the frame of its half-edge
    Point2 Place; // of the image, in that of the face
    double Offset;
  };

  /// The virtual source of a corner in the plane of the face.
  struct SeenSource
  {
    Point2 Image;
    /// Seen from all the face if 0. Else from one side only of the line through image and corner:
    /// the sign of the cross product of the ways from the corner to the image and to the point.
    double Side;
  };

  /// On one side of the tip of the cone around the corner, or on both, if the cut runs through the
  /// face.
  struct SeenSources
  {
    std::array<SeenSource, 2> Sources;
    int Count = 0;
  };

  /// What a corner knows of a point: most of a sample, but for its gradient, which only the least
  /// of three is asked for.
  struct Wave
  {
    double Distance = Infinity;
    int Corner = 0;
    bool IsOverCorner = false;
    Point2 Image;
    Id Candidate = NoId;
  };

  void CollectWindows();
  void CollectSources();
  void SetUpModels();
  void FindSources(int k);
  double DistanceToSource(int k, const Point2& p, int& nearest) const;
  FieldSample FromCorner(int k, const Point2& p) const;
  FieldSample FromWindows(const Point2& p) const;
  Wave FromModel(int k, const Point2& p, const std::array<double, 3>& barycentric) const;
  FieldSample SampleOf(const Wave& wave, const Point2& p, const std::array<double, 3>& b) const;
  FieldSample FromModels(const Point2& p) const;
  FieldSample FromLowerBound(int k, const Point2& p) const;
  FieldSample Linear(const Point2& p) const;
  Point2 InFrameOf(int k, const Point2& p) const;

  const DistanceField& Field;
  Id Face = NoId;
  std::array<Point2, 3> Corners;
  std::array<Point2, 3> Axes;  // of the half-edges
  std::array<Point2, 3> Rises; // gradients of the barycentric coordinates
  std::array<double, 3> Distances{ { 0.0, 0.0, 0.0 } };
  std::vector<SeenWindow> Windows; // those of the three half-edges, one after the other
  std::array<std::size_t, 4> FirstWindows{ { 0, 0, 0, 0 } };
  std::vector<FieldSample> Sources;
  std::array<CornerModel, 3> Models;
  std::array<SeenSources, 3> Seen;                         // of the models
  std::array<bool, 3> IsRaised{ { false, false, false } }; // whether a model misses something
  std::array<std::array<double, 3>, 3> Missing{};         // of the model of a corner at another one
  std::array<std::array<double, 3>, 3> MissingOver{};     // of the way over a corner at another one
  std::array<double, 3> LowerBounds{ { 0.0, 0.0, 0.0 } }; // of the distance, at corners
  double Negligible = 0.0;                                // of what is missing
  bool HasModels = false;
  bool HasLowerBounds = false;
};
}

#endif
