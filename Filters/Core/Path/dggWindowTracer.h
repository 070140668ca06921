// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Follows the way of a window back to the source. Internal.
#ifndef dggWindowTracer_h
#define dggWindowTracer_h

#include "dggExactGeodesics.h" // for ExactResult, Predecessor
#include "dggSurfacePath.h"    // for SurfacePath
#include "dggUnfolding.h"      // for Point2

#include <cstddef> // for std::size_t
#include <vector>  // for the branches

namespace dgg
{
/// Traces paths back through the faces that their windows have crossed (window tracing, as in
/// Mitchell, Mount and Papadimitriou, "The discrete geodesic problem", 1987).
///
/// A window tells where the straight way to its root runs as long as it is known which faces it
/// unfolds. That is not always so: an edge of more than two faces can have been reached from any of
/// the others, and a way that runs through a vertex, up to rounding, may leave it on either side.
/// Then one choice is tried after the other. What decides is the length: any way as long as the
/// distance is a shortest path, whichever window it came from.
class WindowTracer
{
public:
  /// `result` is that of a run from one source alone, at distance 0.
  WindowTracer(const SurfaceMesh& mesh, const SurfacePoint& source, const ExactResult& result)
    : Mesh(mesh)
    , Source(source)
    , Result(result)
  {
  }

  /// Path from the source to a point that was reached, given its distance and how it got it. False
  /// when the way of the windows is not found again.
  bool Trace(
    const SurfacePoint& target, double distance, const Predecessor& last, SurfacePath& path);

  /// How often a way that was tried led nowhere and another one was tried, of all paths so far.
  std::size_t GetNumberOfRetries() const { return this->NumberOfRetries; }

private:
  /// A way that leaves a face and enters another one.
  struct Branch
  {
    Id Left = NoId;               ///< the half-edge of the face that is left
    double X = 0.0;               ///< where it is crossed
    Id Entered = NoId;            ///< the half-edge of the face that is entered
    Point2 Image;                 ///< of the root, in the frame of Entered; Y > 0
    std::size_t PointsBefore = 0; ///< of the path
    double LengthSoFar = 0.0;     ///< of this straight piece
  };

  bool TraceBack(const SurfacePoint& target, double distance, const Predecessor& last);
  bool TracePiece(const SurfacePoint& start, double distance, const Predecessor& last, Id& reached);
  void Leave(Id h, const Point2& from, const Point2& image, double lengthSoFar);
  bool Follow(const Branch& branch, Id& reached);
  bool EndInSharedFace(const SurfacePoint& start, Id root);
  bool EndAtCorner(const SurfacePoint& start, Id& reached);
  bool MayEndAt(Id vertex, double lengthSoFar) const;
  bool AgreesWithLabels(Id h, double x, double lengthSoFar) const;
  void Add(const SurfacePoint& point, Id face);

  const SurfaceMesh& Mesh;
  const SurfacePoint& Source;
  const ExactResult& Result;
  std::vector<SurfacePoint> Points; // from the target to the source
  std::vector<Id> Faces;            // of the pieces between them
  std::vector<Branch> Branches;     // not tried yet
  Id Root = NoId;                   // of the straight piece on its way
  double Distance = 0.0;            // at its start
  double PieceLength = 0.0;
  double Tolerance = 0.0; // of lengths
  std::size_t FirstFace = 0;
  double Slack = 0.0; // of places, within this piece
  std::size_t NumberOfRetries = 0;
};
}

#endif
