// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Records the edge intervals through which the windows of one source have entered faces. Internal.
#ifndef dggGraphWindowMemory_h
#define dggGraphWindowMemory_h

#include "dggGraphWindow.h"  // for GraphWindow
#include "dggVertexStates.h" // for labels

#include <array>   // for corners
#include <cstddef> // for std::size_t
#include <vector>  // for the intervals

namespace dgg
{
/// Record of the windows of one source. A non-manifold edge sends a copy of every window into each
/// further face, and behind the edge copies meet again, as in two layers on top of each other:
/// their number doubles from edge to edge. Among nearly degenerate triangles windows overlap in the
/// same manner. But a window can carry shortest paths only on the interval where no other window of
/// the same source enters the same face through the same edge with a shorter path, and no path
/// through a vertex of the previous face is shorter. The window itself is not cut, since its relays
/// are still needed. A window is followed only while its *live* part, the interval where no other
/// path dominates, reaches an edge.
class GraphWindowMemory
{
public:
  explicit GraphWindowMemory(const VertexStates& vertices)
    : Vertices(&vertices)
  {
  }

  /// Allocates the record. Must be called before the first window of a source.
  void Prepare(Id numberOfHalfEdges) { this->Last.resize(numberOfHalfEdges, NoId); }

  /// An edge through which a window enters a face.
  struct Passage
  {
    Id HalfEdge;     ///< half-edge of the face
    bool IsReversed; ///< true if the edge of the window runs opposite to HalfEdge
    Id Origin;       ///< ends of the edge, ids of the table
    Id Destination;
    Id Behind; ///< third vertex of the previous face, or NoId
    Point2 BehindAt;
  };

  /// Records a window that enters a face. Returns an id for the window, or NoId if no part of the
  /// window is live.
  Id Admit(
    const Passage& passage, const Relay& left, const Relay& right, const GraphWindow& window);
  /// Returns true if part of an admitted window is still live.
  bool IsLive(Id number) { return this->Trim(this->Entries[number], number); }

  /// Returns the number of comparisons with other paths since the last Clear(). Comparisons
  /// dominate the running time.
  std::size_t GetWork() const { return this->Work; }

  void Clear();

private:
  /// A point relative to the line of a half-edge: position of its foot on the line, and its
  /// distance from the line.
  struct Image
  {
    double Foot;
    double Depth;

    double DistanceAt(double x) const { return Norm(x - this->Foot, this->Depth); }
  };
  /// Paths that start at an image with an initial distance.
  struct Way
  {
    Image From;
    double Label;
  };
  /// The live part of a window on a half-edge.
  struct Entry
  {
    Id HalfEdge;
    Id Before; ///< previous entry on the same half-edge
    bool IsReversed;
    double Begin;
    double End;
    Point2 AtBegin; ///< position of Begin, in the plane of the window
    Point2 AtEnd;
    Image Source;
    std::array<Id, 3> Corners; ///< previous face: ends of the half-edge, third corner
    std::array<Image, 3> CornersAt;
  };
  struct Interval
  {
    double Begin;
    double End;
  };

  bool Trim(Entry& entry, Id number);
  void FindDominated(const Entry& entry, Id number);
  void Compare(const Entry& entry, const Way& other, double begin, double end, double factor);

  const VertexStates* Vertices;
  std::vector<Id> Last; // per half-edge
  std::vector<Entry> Entries;
  std::vector<Interval> Dominated;
  std::size_t Work = 0;
};
}

#endif
