// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Joins strips of faces, one after the other, into as few as possible. Internal.
#ifndef dggStripChain_h
#define dggStripChain_h

#include "dggStrip.h"       // for Strip
#include "dggSurfacePath.h" // for SurfacePath

#include <vector> // for the strips

namespace dgg
{
/// The faces that a path runs through. Where it passes through a vertex, the faces around the
/// vertex on one side of it are added, so that there is a single strip, unless faces meet in
/// nothing but that vertex: there the path is pinned, and a new strip begins.
class StripChain
{
public:
  explicit StripChain(const SurfaceMesh& mesh)
    : Mesh(mesh)
  {
  }

  /// With `join` false every strip stays alone, and the path keeps to the vertices between them.
  void Clear(bool join = true)
  {
    this->Strips.clear();
    this->IsJoining = join;
  }
  /// Append a strip that starts where the last one ends, in a vertex. (Elsewhere, both have to be
  /// in the same face there.)
  void Append(const Strip& strip);
  /// Append the faces that a path runs through.
  void Append(const SurfacePath& path);

  std::vector<Strip>& GetStrips() { return this->Strips; }

private:
  void AppendPiece(const SurfacePoint& from, const SurfacePoint& to, Id face);

  const SurfaceMesh& Mesh;
  std::vector<Strip> Strips;
  bool IsJoining = true;
};
}

#endif
