// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// From edges of the graph to faces of the mesh. Internal.
#ifndef dggPathTracer_h
#define dggPathTracer_h

#include "dggExactPath.h" // for ways that are not found otherwise
#include "dggStrip.h"     // for EdgeCrossing
#include "dggUnfolding.h" // for Point2

#include <cstddef> // for std::size_t
#include <memory>  // for the solver
#include <vector>  // for the beams

namespace dgg
{
/// An edge of the graph or a link, to be followed from its tail: a straight line of known length in
/// a direction known up to rounding.
struct GraphEdge
{
  Id Tail;
  double Angle;      ///< polar angle at the tail
  SurfacePoint Head; ///< where it arrives
  double Length;
};

/// Follows straight lines from vertices. As their directions are floats, no ray is sent out but a
/// beam, a cone as narrow as the rounding errors. It is split at every vertex that it meets, so
/// that a head can be missed on neither side.
class GraphEdgeTracer
{
public:
  explicit GraphEdgeTracer(const SurfaceMesh& mesh)
    : Mesh(mesh)
  {
  }

  /// The first face, and the crossings from there to the face of the head. False when the head is
  /// not where it should be.
  bool Trace(const GraphEdge& edge, Id& firstFace, std::vector<EdgeCrossing>& crossings);

  /// How far lengths in the graph may be from those on the mesh.
  double GetTolerance(double length) const;

  /// Beams followed over an edge in the last call.
  std::size_t GetNumberOfBeams() const { return this->NumberOfBeams; }

private:
  /// The part of the beam that goes through one edge, in the plane of the tail.
  struct Beam
  {
    EdgeCrossing Crossing;
    bool IsMirrored; ///< whether the face entered is laid out as its mirror image
    Point2 Left;     ///< end of the edge
    Point2 Axis;     ///< unit vector from there to the right end
    Id Before;       ///< the beam that it is a part of, or NoId
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
  Point2 Rays[2]; ///< bounds of the beam, left and right
  std::vector<Beam> Beams;
  std::size_t Limit = 0; ///< of the beams in one face of the tail
  std::size_t NumberOfBeams = 0;
  Id Found = NoId;
  double Arrival = 0.0; ///< polar angle at the tail under which the head was found
  bool IsSplit = false; ///< whether the beam has met a vertex
};

/// Traces a path, edge by edge, into a chain of strips. Keeps its memory from path to path.
class PathTracer
{
public:
  explicit PathTracer(const SurfaceMesh& mesh)
    : Mesh(mesh)
    , Tracer(mesh)
    , Chain(mesh)
  {
  }

  /// A new path. With `join` false every edge stays a strip of its own.
  void Begin(bool join)
  {
    this->Chain.Clear(join);
    this->NumberOfFallbacks = 0;
  }
  /// Append an edge, from its tail to its head or the other way round.
  Status Append(const GraphEdge& edge, bool isBackwards = false);
  /// Append a way of known length that is no edge of the graph, between points close together.
  Status Append(const SurfacePoint& from, const SurfacePoint& to, double length);
  void Append(const SurfacePath& path) { this->Chain.Append(path); }

  std::vector<Strip>& GetStrips() { return this->Chain.GetStrips(); }
  /// Edges whose direction did not lead to their head.
  Id GetNumberOfFallbacks() const { return this->NumberOfFallbacks; }

  /// Bytes of the solver that is kept; nothing else is as large as the mesh.
  std::size_t GetMemorySize() const { return this->Exact ? this->Exact->GetMemorySize() : 0; }

private:
  bool FindExactly(
    const SurfacePoint& from, const SurfacePoint& to, double length, SurfacePath& path);

  const SurfaceMesh& Mesh;
  GraphEdgeTracer Tracer;
  StripChain Chain;
  std::unique_ptr<ExactPathFinder> Exact; // made when it is first needed
  Id NumberOfFallbacks = 0;
};
}

#endif
