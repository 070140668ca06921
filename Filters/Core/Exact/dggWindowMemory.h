// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Remembers what light has passed through a half-edge. Internal.
#ifndef dggWindowMemory_h
#define dggWindowMemory_h

#include "dggSurfaceMesh.h"    // for SurfaceMesh
#include "dggWindowEnvelope.h" // for WindowList

#include <cstddef>       // for std::size_t
#include <unordered_map> // for the lists

namespace dgg
{
/// Labels stop light that has become longer on its way, and that is enough on a manifold. Around
/// faces without area light comes back no longer than it was, and a non-manifold edge sends on a
/// copy of it into every further face: there it could run for ever, unless what has passed is
/// remembered.
class WindowMemory
{
public:
  /// Whether light through h has to be remembered: its face has no area, or its edge more than two
  /// faces.
  static bool IsNeeded(const SurfaceMesh& mesh, Id h)
  {
    const Id t = mesh.Twin(h);
    return mesh.IsDegenerate(SurfaceMesh::Face(h)) || (t != NoId && mesh.Twin(t) != h);
  }

  /// Leave in the envelope only what is shorter than all that has come to h before, and remember
  /// it.
  void KeepNews(Id h, double length, WindowList& list);

  void Clear() { this->Known.clear(); }
  std::size_t GetMemorySize() const;

private:
  std::unordered_map<Id, WindowList> Known; // per half-edge, a lower envelope
  WindowList Merged;
};
}

#endif
