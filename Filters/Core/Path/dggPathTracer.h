// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// From edges of the graph to faces of the mesh. Internal.
#ifndef dggPathTracer_h
#define dggPathTracer_h

#include "dggExactPath.h"  // for ways that are not found otherwise
#include "dggHopTracer.h"  // for Hop
#include "dggStripChain.h" // for StripChain

#include <cstddef> // for std::size_t
#include <memory>  // for the solver

namespace dgg
{
/// Traces a path, hop by hop, into a chain of strips. Keeps its memory from path to path.
class PathTracer
{
public:
  explicit PathTracer(const SurfaceMesh& mesh)
    : Mesh(mesh)
    , Tracer(mesh)
    , Chain(mesh)
  {
  }

  /// A new path. With `join` false every hop stays a strip of its own.
  void Begin(bool join)
  {
    this->Chain.Clear(join);
    this->NumberOfFallbacks = 0;
  }
  /// Append a hop, from its tail to its head or the other way round.
  Status Append(const Hop& hop, bool isBackwards = false);
  /// Append a way of known length that no edge of the graph tells, between points close together.
  Status Append(const SurfacePoint& from, const SurfacePoint& to, double length);
  void Append(const SurfacePath& path) { this->Chain.Append(path); }

  std::vector<Strip>& GetStrips() { return this->Chain.GetStrips(); }
  /// Hops whose direction did not lead to their head.
  Id GetNumberOfFallbacks() const { return this->NumberOfFallbacks; }

  /// Bytes of the solver that is kept; nothing else is as large as the mesh.
  std::size_t GetMemorySize() const { return this->Exact ? this->Exact->GetMemorySize() : 0; }

private:
  bool FindExactly(
    const SurfacePoint& from, const SurfacePoint& to, double length, SurfacePath& path);

  const SurfaceMesh& Mesh;
  HopTracer Tracer;
  StripChain Chain;
  std::unique_ptr<ExactPathFinder> Exact; // made when it is first needed
  Id NumberOfFallbacks = 0;
};
}

#endif
