// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Engine T: lists of windows, triangle by triangle, in the order of the vertices. Internal.
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
/// Windows cross faces of the region at once, whole lists at a time, and wait on its front until
/// one of the ends of their edge has its turn. Each waiting list is a lower envelope, so hardly any
/// window is propagated that does not carry a shortest path. No split rule is needed then.
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
  /// A list is about to enter the face of half-edge h: an engine that is content with less may
  /// change it.
  virtual void Simplify(Id, WindowList&) {}

private:
  /// Windows that leave a face through one of its edges. On stretched triangles the children of
  /// thousands of windows lie across each other; those far from their place wait, as putting each
  /// among the others at once would take the square of their number.
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
  std::vector<std::uint8_t> IsOpen;        // per face: in the region
  std::vector<std::uint8_t> IsQueued;      // per half-edge
  std::vector<std::uint8_t> IsVisited;     // per vertex: has had its turn
  std::vector<double> Emitted;             // per vertex: label at its last emission
  std::vector<Id> Queue;                   // half-edges whose lists can move on, first in first out
  std::size_t QueueHead = 0;

  // Lists live in a pool: their storage is used again and again.
  std::vector<Id> ListOf; // per half-edge
  std::vector<WindowList> Pool;
  std::vector<Id> FreeLists;

  WindowMemory Memory;

  WindowList Passing; // the list on its way through a face
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
