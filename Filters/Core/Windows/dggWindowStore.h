// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Storage of windows for exact engines: the windows of the result, and the windows that have
/// passed each edge. Internal.
#ifndef dggWindowStore_h
#define dggWindowStore_h

#include "dggEdgeWindows.h"    // for the result
#include "dggWindowEnvelope.h" // for WindowList

#include <cstddef>       // for std::size_t
#include <unordered_map> // for recorded windows
#include <vector>        // for the lists

namespace dgg
{
/// Collects the windows that enter faces, per half-edge, and finally keeps those that may carry
/// shortest paths. Windows that are only dominated by windows from the other side of their edge are
/// kept: about one window in two hundred.
class WindowStore
{
public:
  explicit WindowStore(const SurfaceMesh& mesh)
    : Mesh(mesh)
  {
  }

  /// Clears the store and releases its memory. Nothing is stored unless `isOn`.
  void Start(bool isOn);
  bool IsOn() const { return !this->Lists.empty(); }

  /// Adds sorted, disjoint windows that enter the face of half-edge h.
  void Add(Id h, const WindowList& windows);
  /// Adds a window that enters the face of half-edge h.
  void Add(Id h, const Window& window);

  /// Removes the windows that carry no shortest path, given the final vertex labels.
  void Trim(const std::vector<double>& labels);
  /// Moves the windows to `windows`; to be called after Trim(). `shift` is added to distances.
  void MoveTo(EdgeWindows& windows, double shift);

  /// Returns the number of bytes held.
  std::size_t GetMemorySize() const;
  /// Returns the peak memory of the store and the result during MoveTo(), in bytes.
  std::size_t GetMemoryToMove() const;

private:
  std::size_t CountWindows() const;
  void RemoveStale(WindowList& list, const std::vector<double>& labels) const;
  void TrimByLabels(Id h, const std::vector<double>& labels);

  const SurfaceMesh& Mesh;
  std::vector<WindowList> Lists; // per half-edge, lower envelopes
  std::size_t Held = 0;          // total capacity of the lists, in windows
  WindowList Scratch;
  WindowList Merged;
};

/// Remembers the windows that have entered faces behind degenerate faces and non-manifold edges. On
/// a manifold, labels suffice to stop windows that have become longer along their path. But around
/// degenerate faces windows return no longer than before, and a non-manifold edge copies a window
/// into every further face, so that propagation might never end without such a record.
class WindowMemory
{
public:
  /// Reduces the envelope to the parts that are shorter than all earlier windows at h, and records
  /// them.
  void KeepNews(Id h, double length, WindowList& list);

  void Clear() { this->Known.clear(); }
  std::size_t GetMemorySize() const;

private:
  std::unordered_map<Id, WindowList> Known; // per half-edge, a lower envelope
  WindowList Merged;
};
}

#endif
