// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Remembers which parts of which edges the windows of one source have entered. Internal.
#ifndef dggGraphWindowMemory_h
#define dggGraphWindowMemory_h

#include "dggGraphWindow.h"  // for GraphWindow
#include "dggVertexStates.h" // for labels

#include <array>   // for corners
#include <cstddef> // for std::size_t
#include <vector>  // for the intervals

namespace dgg
{
/// A non-manifold edge sends a copy of every window into each further face, and behind it copies
/// meet again, as in two sheets that cover each other: their number doubles from edge to edge.
/// Among triangles that are all but lines windows overlap in the same way. But a window can only
/// matter where no other one of the same source enters the same face by the same edge on a shorter
/// way, and no way through a vertex of the face before is shorter: what it finds elsewhere is not
/// at the end of a shortest path. The window itself is not cut, since its relays count; but it is
/// followed only while the part of it that may matter, its *live* part, reaches anything.
class GraphWindowMemory
{
public:
  explicit GraphWindowMemory(const VertexStates& vertices)
    : Vertices(&vertices)
  {
  }

  /// To be called before the first window of a source.
  void Prepare(Id numberOfHalfEdges) { this->Last.resize(numberOfHalfEdges, NoId); }

  /// An edge through which a window enters a face.
  struct Passage
  {
    Id HalfEdge;     ///< of the face
    bool IsReversed; ///< whether the edge of the window runs against it
    Id Origin;       ///< its ends, ids of the table
    Id Destination;
    Id Behind; ///< the third vertex of the face before, if not NoId
    Point2 BehindAt;
  };

  /// Take note of a window that enters a face. Returns a number for the window, or NoId when
  /// nothing of it is live.
  Id Admit(
    const Passage& passage, const Relay& left, const Relay& right, const GraphWindow& window);
  /// Whether anything of an admitted window is still live.
  bool IsLive(Id number) { return this->Trim(this->Entries[number], number); }

  /// Comparisons with other ways since the last Clear(): what most of the time goes into.
  std::size_t GetWork() const { return this->Work; }

  void Clear();

private:
  /// A point beside the line of a half-edge: its foot on the line, and its distance from it.
  struct Image
  {
    double Foot;
    double Depth;

    double DistanceAt(double x) const { return Norm(x - this->Foot, this->Depth); }
  };
  /// A way that starts with a distance at an image.
  struct Way
  {
    Image From;
    double Label;
  };
  /// The live part of a window on a half-edge.
  struct Entry
  {
    Id HalfEdge;
    Id Before; ///< the entry before it on the same half-edge
    bool IsReversed;
    double Begin;
    double End;
    Point2 AtBegin; ///< in the plane of the window
    Point2 AtEnd;
    Image Source;
    std::array<Id, 3> Corners; ///< of the face before: ends of the half-edge, and the third
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
