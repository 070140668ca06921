// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Looks for a shorter path close to another one. Internal.
#ifndef dggPathCorridor_h
#define dggPathCorridor_h

#include "dggSurfacePath.h" // for SurfacePath
#include "dggUnfolding.h"   // for Point2

#include <cstddef> // for std::size_t
#include <cstdint> // for the stamps
#include <vector>  // for the vertices

namespace dgg
{
/// Cuts a corridor out of the mesh, the faces around a path, and finds the exact shortest path in
/// it. As wide as an ellipse: a detour by way of any vertex in it would be longer than the path by
/// no more than a given fraction, were the surface flat. Keeps its memory from call to call.
class PathCorridor
{
public:
  explicit PathCorridor(const SurfaceMesh& mesh);

  /// Replace the path by the shortest one in its corridor. False when it is not shorter, or the
  /// solver would take too long: then the path stays as it is.
  bool Shorten(double detour, SurfacePath& path);
  /// Whether the solver was stopped in the last call, as it would have taken too long.
  bool IsStopped() const { return this->WasStopped; }

  /// Bytes that are kept, corridors left out.
  std::size_t GetMemorySize() const
  {
    return this->Vertices.size() * sizeof(Vertex) + this->FaceRuns.size() * sizeof(std::uint32_t);
  }

private:
  /// What is known of a vertex in this run.
  struct Vertex
  {
    std::uint32_t Run = 0;
    Id Local = NoId;
    Point2 Place;        ///< along the path and across
    bool IsNear = false; ///< all faces around it are in the corridor
  };

  void Begin();
  Vertex* Find(Id v) { return this->Vertices[v].Run == this->Run ? &this->Vertices[v] : nullptr; }
  void Put(Id v, const Point2& place, bool isNear);
  void AddFace(Id f);
  void LayPath(const SurfacePath& path);
  void Grow();
  Point2 PlaceBehind(Id exit, Id entry);
  bool IsWithin(const Point2& place) const;
  Status Build(SurfaceMesh& part);
  SurfacePoint ToPart(const SurfaceMesh& part, const SurfacePoint& point, Id face) const;
  SurfacePoint FromPart(const SurfaceMesh& part, const SurfacePoint& point) const;

  const SurfaceMesh& Mesh;
  std::vector<Vertex> Vertices;
  std::vector<std::uint32_t> FaceRuns; // per face, the run that it is in the corridor of
  std::uint32_t Run = 0;
  std::vector<Id> Faces; // of the corridor
  std::vector<Id> PartVertices;
  std::vector<Id> Triangles;
  std::vector<double> Lengths;
  bool WasStopped = false;
  double Length = 0.0;
  double Detour = 0.0;
};
}

#endif
