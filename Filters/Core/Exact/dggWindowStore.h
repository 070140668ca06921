// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Keeps the windows that an exact engine propagates. Internal.
#ifndef dggWindowStore_h
#define dggWindowStore_h

#include "dggEdgeWindows.h"    // for the result
#include "dggWindowEnvelope.h" // for WindowList

#include <vector> // for the lists

namespace dgg
{
/// Collects, half-edge by half-edge, the windows that enter faces, and when all is done leaves
/// those that may carry shortest paths. What light from the other side of an edge makes useless is
/// not looked for: that is one window in two hundred.
class WindowStore
{
public:
  explicit WindowStore(const SurfaceMesh& mesh)
    : Mesh(mesh)
  {
  }

  /// Forget everything. Nothing is kept unless `isOn`.
  void Start(bool isOn);
  bool IsOn() const { return !this->Lists.empty(); }

  /// Windows that enter the face of half-edge h, in order and disjoint.
  void Add(Id h, const WindowList& windows);
  /// A window that enters the face of half-edge h.
  void Add(Id h, const Window& window);

  /// Move the windows to `windows`, given the final labels of the vertices.
  /// `shift` is added to distances.
  void Finish(const std::vector<double>& labels, double shift, EdgeWindows& windows);

private:
  void RemoveStale(WindowList& list, const std::vector<double>& labels) const;
  void TrimByLabels(Id h, const std::vector<double>& labels);

  const SurfaceMesh& Mesh;
  std::vector<WindowList> Lists; // per half-edge, lower envelopes
  WindowList Scratch;
  WindowList Merged;
};
}

#endif
