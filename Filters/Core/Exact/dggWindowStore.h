// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Keeps the windows that an exact engine propagates. Internal.
#ifndef dggWindowStore_h
#define dggWindowStore_h

#include "dggEdgeWindows.h"    // for the result
#include "dggWindowEnvelope.h" // for WindowList

#include <cstddef> // for std::size_t
#include <vector>  // for the lists

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
  static std::size_t SizeOf(const WindowList& list) { return list.capacity() * sizeof(Window); }
  std::size_t CountWindows() const;
  void RemoveStale(WindowList& list, const std::vector<double>& labels) const;
  void TrimByLabels(Id h, const std::vector<double>& labels);

  const SurfaceMesh& Mesh;
  std::vector<WindowList> Lists; // per half-edge, lower envelopes
  std::size_t Bytes = 0;         // of the windows in them
  WindowList Scratch;
  WindowList Merged;
};
}

#endif
