// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Isolines face by face. Internal.
#ifndef dggFaceIsolines_h
#define dggFaceIsolines_h

#include "dggFaceProfile.h"       // for FaceProfile
#include "dggIsolineParts.h"      // for FaceCurve
#include "dggMarchingTriangles.h" // for MarchingTriangles

#include <array>  // for the sides
#include <vector> // for the curves

namespace dgg
{
/// Connects the crossings on the rim of a face by curves that do not cross, level by level, and
/// finds the isolines that are closed within the face: around sources, and around points that are
/// farther away than all others. An object can be moved from face to face.
///
/// For each level the sources in the face that start below it are looked for in the lattice, one by
/// one: in a face with hundreds of sources the time grows with the square of their number.
class FaceIsolines
{
public:
  /// `levels` increase. Curves are as close as `tolerance` to the level sets.
  FaceIsolines(const DistanceField& field, const std::vector<double>& levels, double tolerance,
    const LevelCrossings& crossings);

  /// Append the curves of a face that is reached, in order of levels. Returns how many of them may
  /// be farther than the tolerance from the level sets.
  Id Trace(Id f, std::vector<FaceCurve>& curves);

private:
  /// A place around which isolines may be closed: of levels above its distance around a source, of
  /// levels not above it around a peak.
  struct Seed
  {
    Point2 Place;
    double Distance = 0.0;
    bool IsPeak = false;
  };

  bool MayHoldSource(Id f) const;
  void FindSeeds();
  void AddSource(const FieldSample& sample);
  void FindPeak();
  void CollectSeeds(Id level);
  void CollectRim(Id level);
  Id TraceLevel(Id level, std::vector<FaceCurve>& curves);
  bool TraceDirectly(const LevelArc& arc, Id level, std::vector<FaceCurve>& curves);
  bool TraceChain(const LevelArc& arc, const LevelChain& chain, Id level, FaceCurve& curve);
  LevelPoint LookAtRim(const LevelArc& arc, Id crossing) const;

  const DistanceField& Field;
  const std::vector<double>& Levels;
  double Tolerance;
  const LevelCrossings& Crossings;
  FaceProfile Profile;
  MarchingTriangles Triangles;
  LevelRim Rim;
  std::array<Id, 3> Edges{ { NoId, NoId, NoId } }; // their half-edges
  std::array<Id, 3> NextCrossings{ { 0, 0, 0 } };  // on them, while levels rise
  std::vector<Seed> Seeds;
  std::vector<Point2> SeedsOfLevel;
  std::vector<LevelPoint> Way;
  std::vector<Point2> Points;
};
}

#endif
