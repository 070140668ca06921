// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Traces graph edges through the faces of the mesh. Internal.
#ifndef dggPathTracer_h
#define dggPathTracer_h

#include "dggExactPath.h" // for paths that are not found otherwise
#include "dggStrip.h"     // for EdgeCrossing
#include "dggUnfolding.h" // for Point2

#include <cstddef> // for std::size_t
#include <memory>  // for the solver
#include <vector>  // for the windows

namespace dgg
{
/// A graph edge or a link to be traced from its tail: a straight line of known length, in a
/// direction known up to rounding.
struct GraphEdge
{
  Id Tail;
  double Angle;      ///< polar angle at the tail
  SurfacePoint Head; ///< end point
  double Length;
};

/// Traces straight lines from vertices. Since directions are stored as floats, a narrow cone of the
/// width of the rounding error is traced instead of a ray. The cone is split at every vertex inside
/// it, so that the head cannot be missed on either side. A window is the part of the cone that
/// crosses one edge.
class GraphEdgeTracer
{
public:
  explicit GraphEdgeTracer(const SurfaceMesh& mesh)
    : Mesh(mesh)
  {
  }

  /// Finds the first face and the crossings from there to the face of the head. Returns false if
  /// the head is not found in the cone.
  bool Trace(const GraphEdge& edge, Id& firstFace, std::vector<EdgeCrossing>& crossings);

  /// Returns the tolerance between lengths in the graph and on the mesh.
  double GetTolerance(double length) const;

  /// Returns the number of windows that were processed in the last call.
  std::size_t GetNumberOfBeams() const { return this->NumberOfBeams; }

private:
  /// A window: the part of the cone that crosses one edge, in the plane of the tail.
  struct Beam
  {
    EdgeCrossing Crossing;
    bool IsMirrored; ///< true if the entered face is unfolded as its mirror image
    Point2 Left;     ///< end of the edge
    Point2 Axis;     ///< unit vector from the left to the right end
    Id Before;       ///< parent window, or NoId
  };

  double AngleFrom(const GraphEdge& edge, Id g, double halfWidth) const;
  bool TraceFrom(const GraphEdge& edge, Id g, double angle, double halfWidth);
  void Cross(Id exit, bool mirrored, const Point2& left, const Point2& axis, Id before);
  bool TraceBeam(
    const GraphEdge& edge, double halfWidth, Id& firstFace, std::vector<EdgeCrossing>& crossings);
  void Refine(const GraphEdge& edge, Id& firstFace, std::vector<EdgeCrossing>& crossings);
  bool Reaches(const GraphEdge& edge, const Beam& beam, Point2& arrival) const;
  void Continue(const GraphEdge& edge, Id index);

  const SurfaceMesh& Mesh;
  Point2 Rays[2]; ///< bounding rays of the cone, left and right
  std::vector<Beam> Beams;
  std::size_t Limit = 0; ///< maximum number of windows per face of the tail
  std::size_t NumberOfBeams = 0;
  Id Found = NoId;
  double Arrival = 0.0; ///< polar angle at the tail, towards the head
  bool IsSplit = false; ///< true if a vertex has split the cone
};

/// Traces a path, edge by edge, into a chain of strips. Buffers are reused between paths.
class PathTracer
{
public:
  explicit PathTracer(const SurfaceMesh& mesh)
    : Mesh(mesh)
    , Tracer(mesh)
    , Chain(mesh)
  {
  }

  /// Starts a new path. If `join` is false, every edge remains a separate strip.
  void Begin(bool join)
  {
    this->Chain.Clear(join);
    this->NumberOfFallbacks = 0;
  }
  /// Appends an edge, from its tail to its head or, if `isBackwards`, from head to tail.
  Status Append(const GraphEdge& edge, bool isBackwards = false);
  /// Appends a path of known length that is no graph edge, between points close together.
  Status Append(const SurfacePoint& from, const SurfacePoint& to, double length);
  void Append(const SurfacePath& path) { this->Chain.Append(path); }

  std::vector<Strip>& GetStrips() { return this->Chain.GetStrips(); }
  /// Returns the number of edges whose direction did not lead to their head.
  Id GetNumberOfFallbacks() const { return this->NumberOfFallbacks; }

  /// Returns the size of the exact solver in bytes; nothing else is as large as the mesh.
  std::size_t GetMemorySize() const { return this->Exact ? this->Exact->GetMemorySize() : 0; }

private:
  bool FindExactly(
    const SurfacePoint& from, const SurfacePoint& to, double length, SurfacePath& path);

  const SurfaceMesh& Mesh;
  GraphEdgeTracer Tracer;
  StripChain Chain;
  std::unique_ptr<ExactPathFinder> Exact; // created on first use
  Id NumberOfFallbacks = 0;
};
}

#endif
