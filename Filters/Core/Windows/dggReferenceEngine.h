// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Reference engine for exact geodesics: one window at a time. Internal.
#ifndef dggReferenceEngine_h
#define dggReferenceEngine_h

#include "dggWindowPropagation.h" // for WindowPropagation

#include <queue>  // for the window queue
#include <vector> // for std::vector

namespace dgg
{
/// Processes windows in order of their smallest distance, with the Chen-Han split rule and the
/// vertex filter. Written to be verified by reading; the triangle engine is tested against it.
class ReferenceEngine : public WindowPropagation
{
public:
  using WindowPropagation::WindowPropagation;

protected:
  void Receive(Id h, const Window& window) override;
  void LabelDropped(Id v) override;
  bool Propagate() override;
  void Reset() override;
  void ResetReached(const std::vector<Id>&) override { this->Reset(); }
  void Release() override;

private:
  struct QueuedWindow
  {
    double Key;
    Id HalfEdge;
    Window Passing;
    bool operator<(const QueuedWindow& other) const { return this->Key > other.Key; }
  };
  struct QueuedVertex
  {
    double Key;
    Id Vertex;
    bool operator<(const QueuedVertex& other) const { return this->Key > other.Key; }
  };
  /// The window that may have two children at a half-edge (Chen-Han "one angle, one split"): its
  /// distance at the apex, and where its ray to the apex crosses the half-edge.
  struct Winner
  {
    double Distance = Infinity;
    double Crossing = 0.0;
    bool Rules = false; // see DecideChildren()
  };

  bool IsUseless(Id h, const Window& window) const;
  void ProcessNews(Id h, const Window& window);
  void ProcessVertex(const QueuedVertex& queued);
  void ProcessWindow(Id h, const Window& window);
  void DecideChildren(Id h, const Window& window, double crossing, bool& left, bool& right);

  std::priority_queue<QueuedWindow> Windows;
  std::priority_queue<QueuedVertex> Vertices;
  std::vector<Winner> Winners; // per half-edge
  WindowMemory Memory;
  WindowList News;
  std::vector<double> Emitted; // per vertex, the label at its last emission
};
}

#endif
