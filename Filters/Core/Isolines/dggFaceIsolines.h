// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Isolines within one face. Internal.
#ifndef dggFaceIsolines_h
#define dggFaceIsolines_h

#include "dggEdgeEnvelope.h"      // for EdgeEnvelope
#include "dggFaceEnvelope.h"      // for FaceEnvelope
#include "dggIsolineParts.h"      // for FaceCurve
#include "dggMarchingTriangles.h" // for MarchingTriangles

#include <array>  // for the sides
#include <vector> // for the curves

namespace dgg
{
/// Connects the crossings on the boundary of a face by non-intersecting curves, level by level, and
/// finds the isolines that are closed within the face: around sources, and around local maxima. An
/// object can be reused for other faces.
///
/// For each level, the sources in the face that start below the level are located in the lattice
/// one by one: in a face with hundreds of sources the cost is quadratic in their number.
class FaceIsolines
{
public:
  /// Prepares tracing. `levels` must be increasing. Curves approximate the level sets within
  /// `tolerance`.
  FaceIsolines(const DistanceField& field, const std::vector<double>& levels, double tolerance,
    const LevelCrossings& crossings);

  /// Appends the curves of a reached face, sorted by level. Returns the number of curves that may
  /// exceed the tolerance.
  Id Trace(Id f, std::vector<FaceCurve>& curves);

private:
  /// A point around which isolines may be closed. Around a source these are isolines of levels
  /// above its distance, around a local maximum isolines of levels not above its distance.
  struct Seed
  {
    Point2 Place;
    double Distance = 0.0;
    bool IsPeak = false;
  };

  bool MayHoldSource(Id f) const;
  void FindSeeds();
  void AddSource(const FieldSample& sample);
  void AddSeed(const Seed& seed);
  void AddWave(const FieldSample& wave, std::vector<FieldSample>& waves) const;
  void AddPeak(const FieldSample& first, const FieldSample& second, const FieldSample& third,
    std::vector<FieldSample>& waves);
  void CollectRim(Id level);
  Id TraceLevel(Id level, std::vector<FaceCurve>& curves);
  bool TraceDirectly(const LevelArc& arc, Id level, std::vector<FaceCurve>& curves);
  bool TraceChain(const LevelArc& arc, const LevelChain& chain, Id level, FaceCurve& curve);
  LevelPoint EvaluateCrossing(const LevelArc& arc, Id crossing) const;

  const DistanceField& Field;
  const std::vector<double>& Levels;
  double Tolerance;
  const LevelCrossings& Crossings;
  FaceEnvelope Envelope;
  EdgeEnvelope Edge;
  MarchingTriangles Triangles;
  LevelRim Rim;
  std::array<Id, 3> Edges{ { NoId, NoId, NoId } }; // half-edges of the sides
  std::array<Id, 3> NextCrossings{ { 0, 0, 0 } };  // next crossing per side, as levels increase
  std::vector<Seed> Seeds;
  std::vector<Point2> SeedsOfLevel;
  std::vector<LevelPoint> Curve;
  std::vector<Point2> Points;
};
}

#endif
