// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Triangle-oriented engine for exact geodesics: lists of windows, propagated triangle by triangle
/// in the order of the vertices. Internal.
#ifndef dggTriangleEngine_h
#define dggTriangleEngine_h

#include "dggWindowEnvelope.h"    // for WindowList
#include "dggWindowPropagation.h" // for WindowPropagation

#include <cstddef> // for std::size_t
#include <utility> // for the vertex heap
#include <vector>  // for std::vector

namespace dgg
{
/// The region of traversed faces grows around one vertex after the other, in order of their labels.
/// Whole lists of windows cross the faces of the region immediately and wait on its front until an
/// end of their edge is processed. Each waiting list is a lower envelope, so hardly any window is
/// propagated that carries no shortest path, and no split rule is needed.
class TriangleEngine : public WindowPropagation
{
public:
  using WindowPropagation::WindowPropagation;

protected:
  void Receive(Id h, const Window& window) override;
  void LabelDropped(Id v) override;
  bool Propagate() override;
  void Reset() override;
  void ResetReached(const std::vector<Id>& vertices) override;
  void Release() override;
  /// Called before a list enters the face of half-edge h. An approximate engine may simplify the
  /// list.
  virtual void Simplify(Id, WindowList&) {}

private:
  /// Windows that leave a face through one of its edges. On stretched triangles the children of
  /// thousands of windows overlap. Children far from their sorted position are collected in
  /// Misplaced and sorted later, because inserting each one immediately would take quadratic time.
  struct ChildList
  {
    WindowList Envelope;
    WindowList Misplaced;
  };

  void ResetRun();
  bool IsFinished() const;
  bool Report(std::size_t work);
  bool ProcessVertex(Id v);
  void OpenFacesAround(Id v);
  void Enqueue(Id h);
  std::size_t PropagateList(Id h);
  void ReachApex(Id h, const FaceUnfolding& face);
  void MakeChildren(Id h, const FaceUnfolding& face);
  void AddChild(Window& child, double length, double atOrigin, double atEnd, ChildList& list);
  void AddMisplaced(double length, ChildList& list);
  void Deliver(Id exit, WindowList& list);
  void Join(Id h, WindowList& list);
  bool MeasureMemory();

  std::vector<std::pair<double, Id>> Heap; // labels of vertices, lazily deleted
  std::vector<std::uint8_t> IsOpen;        // per face: true if in the region
  std::vector<std::uint8_t> IsQueued;      // per half-edge
  std::vector<std::uint8_t> IsVisited;     // per vertex: true if processed
  std::vector<double> Emitted;             // per vertex: label at its last emission
  std::vector<Id> Queue;                   // half-edges with lists to propagate, FIFO
  std::size_t QueueHead = 0;

  // Lists are taken from a pool to reuse their storage.
  std::vector<Id> ListOf; // per half-edge
  std::vector<WindowList> Pool;
  std::vector<Id> FreeLists;

  WindowMemory Memory;

  WindowList Passing; // the list that crosses a face now
  ChildList LeftChildren;
  ChildList RightChildren;
  WindowList Merged;
  WindowList Scratch;
  Id NumberOfVisited = 0;
  std::size_t WorkSinceReport = 0;
  std::size_t WorkSinceRadius = 0;
};
}

#endif
