// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The distance inside one face.
#ifndef dggFaceEnvelope_h
#define dggFaceEnvelope_h

#include "dggCoreExport.h"    // for DGG_CORE_EXPORT
#include "dggCornerModel.h"   // for the models of the corners
#include "dggDistanceField.h" // for DistanceField

#include <array>  // for the corners
#include <vector> // for the windows

namespace dgg
{
/// The distance inside a face as the lower envelope of its candidates: windows, sources in the
/// face, and paths through its corners or the models of these; in the plane, in the frame of
/// half-edge 3f. If the distance comes from windows or is linear, it equals the distance of
/// EdgeEnvelope on the boundary of the face, up to rounding. With models, the distance of
/// EdgeEnvelope may be shorter, through another face of the edge. An object can be reused for other
/// faces, which saves allocations.
class DGG_CORE_EXPORT FaceEnvelope
{
public:
  explicit FaceEnvelope(const DistanceField& field)
    : Field(field)
  {
  }

  /// Selects a face, which must be reached (DistanceField::IsReached()).
  void Enter(Id f);

  Id GetFace() const { return this->Face; }
  const std::array<Point2, 3>& GetCorners() const { return this->Corners; }
  double GetCornerDistance(int k) const { return this->Distances[k]; }
  Point2 PlaceOf(const std::array<double, 3>& barycentric) const;
  /// Returns a point in the frame of half-edge 3f + k.
  Point2 InFrameOf(int k, const Point2& p) const;
  std::array<double, 3> BarycentricOf(const Point2& p) const;

  /// Returns the distance at a point of the face.
  double At(const Point2& p) const;
  FieldSample SampleAt(const Point2& p) const;
  /// Returns the field of the candidate of a sample, even if another candidate is nearer.
  FieldSample SampleOfCandidate(const FieldSample& sample, const Point2& p) const;

  /// Returns the largest amount by which the model of a corner is raised at another corner.
  double GetLargestRaise() const;

  /// Returns true if the face may contain a local maximum, because wavefronts arrive from all
  /// sides.
  bool MayHavePeak() const;

  /// Returns true if points of the face may have different nearest sources (FieldSample::Source).
  bool MayHaveSeveralSources() const;

  /// Returns the sources inside the face or on its edges.
  const std::vector<FieldSample>& GetSources() const { return this->Sources; }

private:
  /// A window and its image in the plane of the face.
  struct SeenWindow
  {
    double Begin;
    double End;
    Point2 Image; // in the frame of its half-edge
    Point2 Place; // image in the frame of the face
    double Offset;
    Id Source;
  };

  /// The virtual source of a corner in the plane of the face.
  struct SeenSource
  {
    Point2 Image;
    /// 0 if the source is visible from the entire face. Otherwise the source is visible from one
    /// side of the line through image and corner; the value is the sign of the cross product of the
    /// vectors from the corner to the image and to the point.
    double Side;
  };

  /// Images of one virtual source: one image, or two if the cut of the cone around the corner runs
  /// through the face.
  struct SeenSources
  {
    std::array<SeenSource, 2> Sources;
    int Count = 0;
  };

  /// Prediction of a corner at a point, without the gradient, which is needed only for the smallest
  /// of the three predictions.
  struct Wave
  {
    double Distance = Infinity;
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
  Wave FindNearest(const Point2& p, const std::array<double, 3>& barycentric) const;
  FieldSample SampleOf(Id candidate, const Point2& p, const std::array<double, 3>& b) const;
  FieldSample FromLowerBound(int k, const Point2& p) const;
  FieldSample Linear(const Point2& p) const;
  Id SourceOf(Id root) const;

  const DistanceField& Field;
  Id Face = NoId;
  std::array<Point2, 3> Corners;
  std::array<Point2, 3> Axes;  // directions of the half-edges
  std::array<Point2, 3> Rises; // gradients of the barycentric coordinates
  std::array<double, 3> Distances{ { 0.0, 0.0, 0.0 } };
  std::vector<SeenWindow> Windows; // windows of the three half-edges, concatenated
  std::array<std::size_t, 4> FirstWindows{ { 0, 0, 0, 0 } };
  std::vector<FieldSample> Sources;
  std::array<CornerModel, 3> Models;
  std::array<SeenSources, 3> Seen;                         // sources of the models
  std::array<bool, 3> IsRaised{ { false, false, false } }; // true if the model is raised somewhere
  std::array<std::array<double, 3>, 3>
    Missing{}; // deficit of the model of corner [k] at corner [j]
  std::array<std::array<double, 3>, 3>
    MissingOver{}; // deficit of the path through corner [k] at corner [j]
  std::array<double, 3> LowerBounds{ { 0.0, 0.0,
    0.0 } };               // lower bounds of the distance at the corners
  double Negligible = 0.0; // threshold for deficits
  bool HasModels = false;
  bool HasLowerBounds = false;
};
}

#endif
