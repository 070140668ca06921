// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The distance along one edge.
#ifndef dggEdgeProfile_h
#define dggEdgeProfile_h

#include "dggCoreExport.h"    // for DGG_CORE_EXPORT
#include "dggCornerModel.h"   // for the models of the ends
#include "dggDistanceField.h" // for DistanceField
#include "dggFaceProfile.h"   // for the faces of an edge

#include <array>   // for the ends
#include <cstddef> // for std::size_t
#include <vector>  // for the windows

namespace dgg
{
/// The distance along an edge as a function of one variable. It depends on the edge and not on the
/// face that it is looked at from, so what is found on it is the same for all its faces, bit for
/// bit. An object can be moved from edge to edge, which saves allocations.
///
/// With windows, Enter() takes time that grows with the square of the number of windows and of
/// sources in the faces of the edge: these are few, but for edges of faces with hundreds of
/// sources.
class DGG_CORE_EXPORT EdgeProfile
{
public:
  explicit EdgeProfile(const DistanceField& field)
    : Field(field)
  {
  }

  /// Look at the edge of a half-edge, whose ends must be reached.
  void Enter(Id h);

  /// The half-edge that represents the edge. Abscissae run from its origin to its destination.
  Id GetHalfEdge() const { return this->HalfEdge; }
  double GetLength() const { return this->Length; }

  /// The distance at an abscissa. At the ends it is that of the vertex.
  double At(double x) const;

  /// Abscissae from 0 to the length between which the distance has no extremum, up to rounding
  /// (windows), or such that between two of them there is hardly more than one.
  /// FindCrossings() looks for that one, where it matters.
  const std::vector<double>& GetBreaks() const { return this->Breaks; }

  /// Append the abscissae, in increasing order, at which the distance crosses `level` (points at
  /// the level count as above it). Their number is even exactly when both ends are on the same
  /// side.
  void FindCrossings(double level, std::vector<double>& crossings);

private:
  /// A window or a source, seen from this edge.
  struct Piece
  {
    double Begin;
    double End;
    Point2 Image;
    double Offset;
    double Slack; // of the interval
  };

  /// A face of the edge, through which the wave of the opposite corner may come.
  struct Opposite
  {
    FaceProfile Profile;
    int Corner = 0;
    Point2 From; // the ends of the edge in its frame
    Point2 To;
  };

  void CollectWindows(Id h);
  void CollectSources(Id h);
  void CollectThroughFace(Id h);
  void FindWindowBreaks();
  double ExcessOfRising(double begin, double end, double x) const;
  bool FindPeak(double begin, double end, double& peak) const;
  void SetUpOpposites();
  /// How far the distance at an abscissa is above a level.
  struct Probe
  {
    double X;
    double Height;
  };

  /// The distance at a break, and on the way from there to the next one, once they are asked for.
  struct BreakState
  {
    double Distance = 0.0;
    double Crest = 0.0;
    bool HasDistance = false;
    bool HasCrest = false; // not only looked for
    bool IsSearched = false;
  };

  void FindModelBreaks();
  void FindSteepness();
  double AtBreak(std::size_t i);
  const BreakState& FindCrest(std::size_t i);
  void SetUpModels();
  double ModelAt(int end, double x) const;
  double LeastOfModels(double x) const;
  void CrossBetweenBreaks(
    double level, std::size_t first, std::size_t last, std::vector<double>& crossings);
  void Cross(
    double level, const Probe& begin, const Probe& end, std::vector<double>& crossings) const;

  const DistanceField& Field;
  Id HalfEdge = NoId;
  double Length = 0.0;
  std::array<double, 2> Ends{ { 0.0, 0.0 } };
  std::vector<Piece> Pieces;
  std::array<CornerModel, 2> Models;
  std::array<CornerModel::Ray, 2> Rays{};        // of the models along the edge
  std::array<double, 2> Missing{ { 0.0, 0.0 } }; // of the model of an end at the other one
  std::vector<Opposite> Opposites;
  std::size_t NumberOfOpposites = 0; // the others are kept for their memory
  bool HasLinearFace = false;        // one that is reached, without models
  bool IsLinear = false;             // neither end has a model, nor all faces
  double Steepness = 1.0;            // how much models change at most, per length
  std::vector<double> Breaks;
  std::vector<BreakState> BreakStates;
};
}

#endif
