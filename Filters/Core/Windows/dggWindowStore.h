// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What exact engines keep of windows: those of the result, and what has passed. Internal.
#ifndef dggWindowStore_h
#define dggWindowStore_h

#include "dggEdgeWindows.h"    // for the result
#include "dggWindowEnvelope.h" // for WindowList

#include <cstddef>       // for std::size_t
#include <unordered_map> // for what has passed
#include <vector>        // for the lists

namespace dgg
{
/// Collects, half-edge by half-edge, the windows that enter faces, and when all is done leaves
/// those that may carry shortest paths. What windows from the other side of an edge make useless is
/// not looked for: that is one window in two hundred.
class WindowStore
{
public:
  explicit WindowStore(const SurfaceMesh& mesh)
    : Mesh(mesh)
  {
  }

  /// Forget everything, and release its memory. Nothing is kept unless `isOn`.
  void Start(bool isOn);
  bool IsOn() const { return !this->Lists.empty(); }

  /// Windows that enter the face of half-edge h, in order and disjoint.
  void Add(Id h, const WindowList& windows);
  /// A window that enters the face of half-edge h.
  void Add(Id h, const Window& window);

  /// Drop the windows that carry no shortest path, given the final labels of the vertices.
  void Trim(const std::vector<double>& labels);
  /// Move the windows to `windows`, after Trim(). `shift` is added to distances.
  void MoveTo(EdgeWindows& windows, double shift);

  /// Bytes held.
  std::size_t GetMemorySize() const;
  /// Most bytes held by this and the result during MoveTo().
  std::size_t GetMemoryToMove() const;

private:
  std::size_t CountWindows() const;
  void RemoveStale(WindowList& list, const std::vector<double>& labels) const;
  void TrimByLabels(Id h, const std::vector<double>& labels);

  const SurfaceMesh& Mesh;
  std::vector<WindowList> Lists; // per half-edge, lower envelopes
  std::size_t Held = 0;          // windows that they have room for
  WindowList Scratch;
  WindowList Merged;
};

/// Labels stop windows that have become longer on their way, and that is enough on a manifold.
/// Around faces without area they come back no longer than they were, and a non-manifold edge sends
/// on a copy of it into every further face: there it could run for ever, unless what has passed is
/// remembered.
class WindowMemory
{
public:
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
