// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The distance along one edge.
#ifndef dggEdgeEnvelope_h
#define dggEdgeEnvelope_h

#include "dggCoreExport.h"    // for DGG_CORE_EXPORT
#include "dggDistanceField.h" // for DistanceField
#include "dggFaceEnvelope.h"  // for the faces of an edge

#include <array>   // for the ends
#include <cstddef> // for std::size_t
#include <vector>  // for the windows

namespace dgg
{
/// The distance along an edge as the lower envelope of the candidates of its faces, a function of
/// one variable with breaks and crossings. The function depends on the edge only,
/// not on the face from which the function is evaluated, so that results are bitwise identical for
/// all faces of the edge. An object can be reused for other edges, which saves allocations.
///
/// With windows, the cost of Enter() is quadratic in the number of windows and sources in the faces
/// of the edge. This number is small, except for faces with hundreds of sources.
class DGG_CORE_EXPORT EdgeEnvelope
{
public:
  explicit EdgeEnvelope(const DistanceField& field)
    : Field(field)
  {
  }

  /// Selects the edge of a half-edge, whose ends must be reached.
  void Enter(Id h);

  /// Returns the half-edge that represents the edge. Abscissae run from its origin to its
  /// destination.
  Id GetHalfEdge() const { return this->HalfEdge; }
  double GetLength() const { return this->Length; }

  /// Returns the distance at an abscissa. At the ends, the result is the distance of the vertex.
  double At(double x) const;

  /// Returns abscissae from 0 to the length that separate the extrema of the distance. With
  /// windows, a single one is nearest between consecutive abscissae, and no extremum lies between
  /// them, up to rounding. Without windows, rarely more than one extremum lies between them;
  /// FindCrossings() searches for such extrema when necessary.
  const std::vector<double>& GetBreaks() const { return this->Breaks; }

  /// Selects the edge of a half-edge, and returns increasing fractions of the half-edge: the middle
  /// between each two breaks.
  std::vector<double> FindPlacesBetweenBreaks(Id h);

  /// Appends the abscissae, in increasing order, at which the distance crosses `level` (points at
  /// the level count as above). The number of crossings is even iff both ends are on the same side.
  void FindCrossings(double level, std::vector<double>& crossings);

private:
  /// A window, a source or a path along the edge from an end, in the frame of this edge.
  struct Piece
  {
    double Begin;
    double End;
    Point2 Image;
    double Offset;
    double Slack; // tolerance of the interval
  };

  /// A face through which wavefronts arrive at the edge.
  struct FaceOfEdge
  {
    FaceEnvelope Envelope;
    Point2 From; // ends of the edge in the frame of the face
    Point2 To;
  };

  static double DistanceOf(const Piece& piece, double x);
  const Piece& ShortestOf(const std::vector<Piece>& pieces, double x) const;
  void Divide(
    const std::vector<Piece>& pieces, double begin, double end, std::vector<double>& changes) const;
  void CollectWindows(Id h);
  void CollectSources(Id h);
  void CollectThroughFace(Id h);
  void FindWindowBreaks();
  void SetUpFaces();
  /// Difference between the distance at an abscissa and a level.
  struct Probe
  {
    double X;
    double Height;
  };

  /// Lazily computed values: the distance at a break, and at the crest between this break and the
  /// next one.
  struct BreakState
  {
    double Distance = 0.0;
    double Crest = 0.0;
    bool HasDistance = false;
    bool HasCrest = false; // true if a crest was found, not merely searched
    bool IsSearched = false;
  };

  double AtBreak(std::size_t i);
  const BreakState& FindCrest(std::size_t i);
  void CrossBetweenBreaks(
    double level, std::size_t first, std::size_t last, std::vector<double>& crossings);
  void Cross(
    double level, const Probe& begin, const Probe& end, std::vector<double>& crossings) const;

  const DistanceField& Field;
  Id HalfEdge = NoId;
  double Length = 0.0;
  std::array<double, 2> Ends{ { 0.0, 0.0 } };
  std::vector<Piece> Pieces;
  std::vector<FaceOfEdge> Faces;
  std::size_t NumberOfFaces = 0; // further entries are kept to reuse their memory
  double Steepness = 1.0;        // Lipschitz constant of the models
  std::vector<double> Breaks;
  std::vector<BreakState> BreakStates;
};
}

#endif
