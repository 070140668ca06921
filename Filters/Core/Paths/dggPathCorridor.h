// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Finds a shorter path in the vicinity of a given path. Internal.
#ifndef dggPathCorridor_h
#define dggPathCorridor_h

#include "dggSubMesh.h"     // for FaceSelector
#include "dggSurfacePath.h" // for SurfacePath
#include "dggUnfolding.h"   // for Point2

#include <cstddef> // for std::size_t
#include <cstdint> // for the stamps
#include <vector>  // for the vertices

namespace dgg
{
/// Extracts a corridor from the mesh, the faces around a path, and finds the exact shortest path in
/// the corridor. The corridor has the width of an ellipse: on a flat surface, a detour through any
/// vertex of the corridor would exceed the length of the path by at most a given fraction. Buffers
/// are reused between calls.
class PathCorridor
{
public:
  /// `isRim` flags the vertices of a submesh at which faces of its parent are missing; may be null.
  explicit PathCorridor(const SurfaceMesh& mesh, const std::uint8_t* isRim = nullptr);

  /// Replaces the path by the shortest one in its corridor. Returns false, leaving the path
  /// unchanged, if the new path is not shorter or the solver would take too long.
  bool Shorten(double detour, SurfacePath& path);
  /// Returns true if the last call stopped the solver because it would have taken too long.
  bool IsStopped() const { return this->WasStopped; }

  /// Returns true if faces may have been missing in the corridor of the last call.
  bool MeetsRim() const { return this->HasMetRim; }

  /// Returns the size of the reused buffers in bytes, excluding corridors.
  std::size_t GetMemorySize() const { return this->Selector.GetMemorySize(); }

private:
  /// Per-vertex state of the current run.
  struct Vertex
  {
    Point2 Place;        ///< position along the path and across
    bool IsNear = false; ///< all faces around it are in the corridor
  };

  Vertex& At(Id v) { return this->Vertices[this->Selector.GetVertexId(v)]; }
  void Put(Id v, const Point2& place, bool isNear);
  void LayPath(const SurfacePath& path);
  void Grow();
  Point2 PlaceBehind(Id exit, Id entry);
  bool IsWithin(const Point2& place) const;

  const SurfaceMesh& Mesh;
  const std::uint8_t* IsRim;
  FaceSelector Selector;
  std::vector<Vertex> Vertices; // vertices of the corridor
  bool WasStopped = false;
  bool HasMetRim = false;
  double Length = 0.0;
  double Detour = 0.0;
};
}

#endif
