// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Propagates windows from one source over a mesh and collects the graph edges of the source.
/// Internal.
#ifndef dggGraphWindowTracer_h
#define dggGraphWindowTracer_h

#include "dggCrossingBlocks.h"     // for the faces
#include "dggGraphRules.h"         // for relays beside a window
#include "dggGraphWindow.h"        // for GraphWindow
#include "dggGraphWindowMemory.h"  // for the careful mode
#include "dggGraphWindowTargets.h" // for points that windows meet
#include "dggHeap.h"               // for windows by distance
#include "dggPrefetch.h"           // for Prefetch
#include "dggSurfacePoint.h"       // for sources inside faces
#include "dggVertexStates.h"       // for labels and costs

#include <algorithm> // for std::min
#include <array>     // for barycentric coordinates
#include <cstddef>   // for std::size_t
#include <limits>    // for the largest number
#include <utility>   // for std::pair
#include <vector>    // for the workspace

namespace dgg
{
/// Work limits of one source.
struct WindowLimits
{
  /// Maximum number of windows of a source before construction fails.
  std::size_t Windows;
  /// Maximum number of windows in the fast mode, which does not check whether earlier windows of
  /// the source have been at the same location. Sources on an ordinary mesh need fewer windows.
  std::size_t FastWindowLimit;
  /// Maximum work of a source; see GraphWindowTracer::GetWork().
  std::size_t Work;
};

/// Follows windows from one source at a time until the rule ends the windows.
///
/// At non-manifold edges windows can multiply, and among nearly degenerate triangles windows can
/// circulate for long. Most sources meet such configurations rarely or not at all; their windows
/// are processed first in, first out. If the number of windows is large, windows propagate upper
/// bounds of distances, which end windows that wind around a tube or a cone again. A source that
/// still has too many windows is traced again in the careful mode: windows are processed in order
/// of distance, and only as long as no earlier window has a shorter path (GraphWindowMemory).
template <typename Rule>
class GraphWindowTracer
{
public:
  GraphWindowTracer(CrossingBlocks& crossings, const Rule& rule, const WindowLimits& limits)
    : Crossings(crossings)
    , Table(crossings.GetTable())
    , Mesh(this->Table.GetMesh())
    , GraphRule(rule)
    , Limits(limits)
    , Vertices(this->Table.GetNumberOfVertices())
    , Memory(Vertices)
  {
  }

  void SetRule(const Rule& rule) { this->GraphRule = rule; }

  /// Traces the edges of a vertex (id of the table) and returns them.
  const std::vector<FoundEdge>& TraceVertex(Id source)
  {
    return this->TraceFrom([&] {
      // The source has no cost: a window that returns to its source makes no progress.
      this->Source = source;
      this->Vertices.Touch(source).Label = 0.0;
      const Id v = this->Table.OldVertex(source);
      for (const Id* g = this->Mesh.FanBegin(v); g != this->Mesh.FanEnd(v); ++g)
      {
        this->StartAtCorner(*g);
      }
    });
  }

  /// Traces the edges that a point inside a face would have and returns them. For a point on an
  /// edge, pass all faces of the edge.
  const std::vector<FoundEdge>& TracePoint(
    const std::vector<std::pair<Id, std::array<double, 3>>>& positions,
    const GraphWindowTargets& targets)
  {
    this->Targets = &targets;
    this->TraceFrom([&] {
      for (const auto& position : positions)
      {
        this->StartInFace(position.first, position.second);
      }
    });
    this->Targets = nullptr;
    return this->Edges;
  }

  /// Returns true if windows of the last source have met the rim of a part of a mesh. Otherwise its
  /// edges are those in the entire mesh.
  bool HasReachedRim() const { return this->ReachesRim; }
  /// Returns true if the last source was abandoned because its windows multiplied without end.
  bool ExceededLimit() const { return this->HasExceededLimit; }
  std::size_t GetNumberOfWindows() const { return this->NumberOfWindows; }
  /// Returns the work of the last source, in units of one comparison between two windows.
  std::size_t GetWork() const
  {
    return (this->IsCareful ? WorkOfCarefulWindow : WorkOfWindow) *
      (this->NumberOfWindows - this->WindowsBefore) +
      this->Memory.GetWork();
  }

private:
  /// Measured work of a window without comparisons, in the same units.
  static constexpr std::size_t WorkOfWindow = 3;
  static constexpr std::size_t WorkOfCarefulWindow = 30;
  /// Relative tolerance within which two path lengths are equal.
  static constexpr double LengthTolerance = 1e-12;
  /// Additional windows once windows propagate labels, relative to the previous limit.
  static constexpr std::size_t PropagationFactor = 3;

  template <typename Starter>
  const std::vector<FoundEdge>& TraceFrom(Starter start)
  {
    this->Begin(false);
    start();
    this->Trace();
    if (this->HasTooManyWindows())
    {
      this->Begin(true);
      start();
      this->Trace();
    }
    return this->Edges;
  }

  void Begin(bool isCareful)
  {
    this->Vertices.Reset();
    this->Edges.clear();
    this->Relays.clear();
    this->Queue.clear();
    this->Order.Clear();
    this->Reached.Clear();
    this->Memory.Clear();
    this->Behind = NoId;
    this->Source = NoId;
    this->HasOverlap = false;
    this->HasExceededLimit = false;
    this->ReachesRim = false;
    this->IsCareful = isCareful;
    this->WindowsBefore = this->NumberOfWindows;
    this->PropagatesLabels = false;
    this->WindowLimit = isCareful ? std::numeric_limits<std::size_t>::max()
                                  : this->NumberOfWindows + this->Limits.FastWindowLimit;
    if (isCareful)
    {
      this->Memory.Prepare(this->Mesh.GetNumberOfHalfEdges());
    }
  }

  bool HasTooManyWindows() const { return this->NumberOfWindows > this->WindowLimit; }

  /// Makes windows propagate labels along the sides of faces, which ends windows that wind around a
  /// tube again. Returns false if labels were already propagated.
  bool EnableBoundPropagation()
  {
    if (this->PropagatesLabels || Rule::ByDistance)
    {
      return false;
    }
    this->PropagatesLabels = true;
    this->HasOverlap = true;
    this->WindowLimit += PropagationFactor * this->Limits.FastWindowLimit;
    return true;
  }

  /// Starts in the face of an outgoing half-edge of the source. Its far ends are the first relays.
  void StartAtCorner(Id g)
  {
    const Id across = SurfaceMesh::Next(g);
    const Id back = SurfaceMesh::Previous(g);
    const FaceCrossing& face = this->Crossings[this->Table.EntryOf(g)];
    const Point2 a = face.Apex;
    const Point2 b{ this->Mesh.Length(g), 0.0 };
    GraphWindow window;
    window.Frame = g;
    window.Ends[0] = a;
    window.Ends[1] = b;
    window.Axis = face.Direction[FaceCrossing::Right];
    const Point2 fromB{ -window.Axis.X, -window.Axis.Y };
    window.Relays[1] =
      this->ReachCorner({ NoId, this->Mesh.Length(g), b, g, fromB, across, false });
    window.Relays[0] =
      this->ReachCorner({ NoId, this->Mesh.Length(back), a, g, { -a.X, -a.Y }, back, false });
    this->Enter(this->Crossings.CodeBehind(across), window);
  }

  /// Starts from a source inside a face. Reaches the three corners and the three edges, except
  /// edges that contain the source. The plane is rotated for each edge, since directions at the
  /// source are not needed.
  void StartInFace(Id f, const std::array<double, 3>& barycentric)
  {
    for (Id h = 3 * f; h < 3 * f + 3; ++h)
    {
      const Point2 source = PlaceInFrame(this->Mesh, h, barycentric);
      const Point2 origin{ -source.X, -source.Y };
      // The direction of arrival is given relative to the half-edge, which leaves its origin along
      // the x axis.
      const Id corner =
        this->ReachCorner({ NoId, Norm(origin.X, origin.Y), origin, h, { 1.0, 0.0 }, h, false });
      if (barycentric[(h + 2) % 3] == 0.0)
      {
        continue;
      }
      const Point2 end{ this->Mesh.Length(h) - source.X, -source.Y };
      const double length =
        DistanceToCorner(this->Mesh, f, barycentric, static_cast<int>((h + 1) % 3));
      GraphWindow window;
      window.Frame = h;
      window.Ends[0] = end;
      window.Ends[1] = origin;
      window.Axis = { -1.0, 0.0 };
      window.Relays[1] = corner;
      window.Relays[0] =
        this->AddRelay(this->GraphRule.MakeRelay(end, length, this->GraphRule.CostOfEdge(length)));
      this->Enter(this->Crossings.CodeBehind(h), window);
    }
    this->Targets->ReachFrom(f, barycentric);
  }

  /// Records the edge to a corner of the source's face, whose half-edge of arrival starts at the
  /// corner. Returns the relay of the corner.
  Id ReachCorner(FoundEdge edge)
  {
    edge.Target = this->Table.NewVertex(this->Mesh.Origin(edge.Arrival));
    this->ReachesRim = this->ReachesRim || this->Table.IsRim(edge.Target);
    if (edge.Target == this->Source) // on a surface glued of very few faces
    {
      return this->AddRelay(this->GraphRule.MakeRelay(
        edge.Departure, edge.Length, this->GraphRule.CostOfEdge(edge.Length)));
    }
    VertexStates::State& state = this->Vertices.Touch(edge.Target);
    this->SetLabel(edge.Target, state, edge.Length);
    state.Cost = std::min(state.Cost, this->GraphRule.CostOfEdge(edge.Length));
    this->Record(state, edge);
    return this->AddRelay(this->GraphRule.MakeRelay(edge.Departure, edge.Length, state.Cost));
  }

  Id AddRelay(const Relay& relay)
  {
    this->Relays.push_back(relay);
    return static_cast<Id>(this->Relays.size() - 1);
  }

  /// Records an edge. Of several edges to a vertex the shortest one is kept.
  void Record(VertexStates::State& state, const FoundEdge& edge)
  {
    if (state.Edge == NoId)
    {
      state.Edge = static_cast<Id>(this->Edges.size());
      this->Edges.push_back(edge);
    }
    else if (edge.Length < this->Edges[state.Edge].Length)
    {
      this->Edges[state.Edge] = edge;
    }
  }

  /// Queues a window behind its edge.
  void Enter(Id code, GraphWindow& window)
  {
    this->ReachesRim = this->ReachesRim || code == UnfoldingTable::RimCode;
    if (!this->IsCareful)
    {
      this->Table.ForEach(code, [&](Id entry) { this->Push(entry, window); });
      return;
    }
    const Relay& left = this->Relays[window.Relays[0]];
    const Relay& right = this->Relays[window.Relays[1]];
    this->Table.ForEach(code, [&](Id entry) {
      const FaceCrossing& face = this->Crossings[entry];
      const Id h = face.GetHalfEdge();
      GraphWindow copy = window;
      copy.Number = this->Memory.Admit(
        { h, face.IsMirrored(), this->Table.NewVertex(this->Mesh.Origin(h)),
          this->Table.NewVertex(this->Mesh.Destination(h)), this->Behind, this->BehindAt },
        left, right, window);
      if (copy.Number != NoId)
      {
        this->Push(entry, copy);
      }
    });
  }

  void Push(Id entry, GraphWindow& window)
  {
    window.Face = &this->Crossings[entry];
    if (Rule::ByDistance || this->IsCareful)
    {
      this->Order.Push(
        DistanceOfEdge(this->Relays[window.Relays[0]], this->Relays[window.Relays[1]], window),
        static_cast<Id>(this->Queue.size()));
    }
    Prefetch(window.Face);
    this->Queue.push_back(window);
  }

  void Trace()
  {
    if constexpr (Rule::ByDistance)
    {
      this->TraceNearest();
    }
    else if (this->IsCareful)
    {
      this->TraceByDistance();
    }
    else
    {
      // First in, first out approximates the order of distance, and is much cheaper than a heap.
      for (std::size_t next = 0; next < this->Queue.size() && !this->HasTooManyWindows(); ++next)
      {
        GraphWindow window = this->Queue[next];
        this->Follow(window);
        if (this->Queue.size() > this->Limits.Windows)
        {
          this->GiveUp();
          return;
        }
      }
    }
  }

  void FollowNext(Id next)
  {
    GraphWindow window = this->Queue[next];
    if (!this->IsCareful || this->Memory.IsLive(window.Number))
    {
      this->Follow(window);
    }
    if (this->Queue.size() > this->Limits.Windows || this->GetWork() > this->Limits.Work)
    {
      this->GiveUp();
    }
  }

  /// Abandons the current source, whose work exceeds a limit, and releases the buffers.
  void GiveUp()
  {
    this->HasExceededLimit = true;
    std::vector<GraphWindow>().swap(this->Queue);
    std::vector<Relay>().swap(this->Relays);
    this->Memory = GraphWindowMemory(this->Vertices);
    this->Order = DistanceHeap();
    this->Reached = DistanceHeap();
  }

  /// Processes windows and vertices in order of distance: windows propagate through faces, vertices
  /// propagate their labels to neighbors. In this order, most windows that turn out to be dominated
  /// are so before their turn, and are skipped.
  void TraceByDistance()
  {
    while (!this->Order.IsEmpty() && !this->HasExceededLimit)
    {
      const DistanceHeap::Entry key = this->Order.Pop();
      while (!this->Reached.IsEmpty() && this->Reached.Top().Key <= key.Key)
      {
        const DistanceHeap::Entry reached = this->Reached.Pop();
        if (this->Vertices[reached.Index].Label == reached.Key)
        {
          this->ReachNeighbors(reached.Index, reached.Key);
        }
      }
      this->FollowNext(key.Index);
    }
  }

  /// Processes windows in order of distance until enough vertices are final. The resulting edges
  /// lead to the final vertices that are reached by a straight line.
  void TraceNearest()
  {
    Id count = 0;
    double last = Infinity;
    while (!this->Order.IsEmpty())
    {
      const DistanceHeap::Entry key = this->Order.Pop();
      while (count < this->GraphRule.Count && !this->Reached.IsEmpty() &&
        this->Reached.Top().Key <= key.Key)
      {
        const DistanceHeap::Entry reached = this->Reached.Pop();
        if (this->Vertices[reached.Index].Label == reached.Key)
        {
          last = reached.Key;
          ++count;
        }
      }
      if (count >= this->GraphRule.Count)
      {
        break;
      }
      last = Infinity;
      this->FollowNext(key.Index);
      if (this->HasExceededLimit)
      {
        return;
      }
    }
    this->Edges.erase(std::remove_if(this->Edges.begin(), this->Edges.end(),
                        [&](const FoundEdge& edge) {
                          const double label = this->Vertices[edge.Target].Label;
                          return label > last || edge.Length > label * (1.0 + LengthTolerance);
                        }),
      this->Edges.end());
  }

  /// Follows a window through the faces until a vertex splits it, or it ends.
  void Follow(GraphWindow& window)
  {
    const Relay& left = this->Relays[window.Relays[0]];
    const Relay& right = this->Relays[window.Relays[1]];
    // Most windows are split in the first face, and hardly any window ends earlier. Therefore the
    // stop point is computed after the first face.
    bool isStarted = !Rule::StartsLate;
    for (;;)
    {
      const FaceCrossing& face = *window.Face;
      ++this->NumberOfWindows;
      if (this->HasTooManyWindows() && !this->EnableBoundPropagation())
      {
        return;
      }
      const Point2 apex = FromFrame(window.Ends[0], window.Axis, face.Apex);
      if (this->Targets)
      {
        this->Targets->Reach(window, left, right, face);
      }
      const bool isRightOfLeft = Cross(apex, left.Position) > 0.0;
      const bool isLeftOfRight = Cross(right.Position, apex) > 0.0;
      if (isRightOfLeft && isLeftOfRight)
      {
        this->Split(window, face, apex);
        return;
      }
      // Separate branches with constant indices keep the window in registers.
      const Id code = face.Behind[isRightOfLeft ? FaceCrossing::Left : FaceCrossing::Right];
      if (isRightOfLeft)
      {
        this->Turn(window, face, FaceCrossing::Left, apex);
      }
      else
      {
        this->Turn(window, face, FaceCrossing::Right, apex);
      }
      if (code == NoId || (!isStarted && !StartWindow(this->GraphRule, this->Relays, window)) ||
        this->GraphRule.Ends(left, right, window) || this->IsUseless(window))
      {
        return;
      }
      isStarted = true;
      if (code < 0 || Rule::ByDistance || this->IsCareful)
      {
        this->Enter(code, window);
        return;
      }
      window.Face = &this->Crossings[code];
    }
  }

  /// Advances to the left or right edge of a face. The apex of the face is the right end of the
  /// left edge and the left end of the right edge.
  void Turn(
    GraphWindow& window, const FaceCrossing& face, FaceCrossing::Side side, const Point2& apex)
  {
    const int end = 1 - side;
    if (this->IsCareful)
    {
      const Id h = face.GetHalfEdge();
      const bool isOrigin = (end == 0) != face.IsMirrored();
      this->Behind =
        this->Table.NewVertex(isOrigin ? this->Mesh.Origin(h) : this->Mesh.Destination(h));
      this->BehindAt = window.Ends[end];
    }
    if (this->PropagatesLabels)
    {
      this->PropagateLabel(face);
    }
    window.Ends[end] = apex;
    window.Axis = Turned(window.Axis, face.Direction[side]);
    if (this->HasOverlap)
    {
      const double label = this->Vertices[face.ApexVertex].Label;
      window.Labels[end] =
        label * label < Dot(apex, apex) * (1.0 - LengthTolerance) ? label : Infinity;
    }
  }

  /// Lowers the label of the apex to the length of the path through another corner and along the
  /// side between that corner and the apex.
  void PropagateLabel(const FaceCrossing& face)
  {
    const Id h = face.GetHalfEdge();
    const auto bound = [&](Id corner, Id side) {
      return this->Vertices[this->Table.NewVertex(corner)].Label + this->Mesh.Length(side);
    };
    VertexStates::State& state = this->Vertices.Touch(face.ApexVertex);
    state.Label = std::min({ state.Label, bound(this->Mesh.Origin(h), SurfaceMesh::Previous(h)),
      bound(this->Mesh.Destination(h), SurfaceMesh::Next(h)) });
  }

  /// Returns true if the path through an end of the edge and along the edge is shorter at every
  /// point that the window reaches. By the triangle inequality, the label of the end is then
  /// shorter than the straight line to the end.
  bool IsUseless(const GraphWindow& window) const
  {
    return this->HasOverlap && (this->IsUseless(window, 0) || this->IsUseless(window, 1));
  }

  /// Tests one end. The farthest point from it is where the other bounding ray meets the edge.
  bool IsUseless(const GraphWindow& window, int end) const
  {
    if (window.Labels[end] == Infinity)
    {
      return false;
    }
    const Point2 x = MeetEdge(window, this->Relays[window.Relays[1 - end]].Position);
    return window.Labels[end] + Distance(window.Ends[end], x) <=
      Norm(x.X, x.Y) * (1.0 - LengthTolerance);
  }

  /// The best relay on one side of a window for a vertex that the window reaches.
  struct Cover
  {
    Id Relay;
    double Cost; ///< cost of the vertex by this relay
    bool IsCovered;
  };
  Cover FindCover(const GraphWindow& window, int side, const Point2& apex, double distance) const
  {
    const bool isOuter = window.Outer[side] != NoId && IsVisible(this->Relays, window, side, apex);
    const Id id = isOuter ? window.Outer[side] : window.Relays[side];
    const Relay& relay = this->Relays[id];
    const double cost = this->GraphRule.CostBehind(relay, Distance(relay.Position, apex));
    return { id, cost, this->GraphRule.Covers(cost, distance) };
  }

  /// Splits a window at a vertex. The vertex may become an edge, and is a relay of the two new
  /// windows. A relay that covers the vertex also covers the interval of the edge between its own
  /// ray and the vertex, so that the window on this side has ended.
  void Split(GraphWindow& window, const FaceCrossing& face, const Point2& apex)
  {
    const double distance = Norm(apex.X, apex.Y);
    const Cover left = this->FindCover(window, 0, apex, distance);
    const Cover right = this->FindCover(window, 1, apex, distance);
    const double cost =
      this->ReachApex(window, face, apex, distance, std::min(left.Cost, right.Cost));

    const bool goesLeft = face.Behind[FaceCrossing::Left] != NoId &&
      !(Rule::EndsBesideCovered && left.IsCovered) &&
      !IsNarrow(apex, distance, this->Relays[window.Relays[0]]);
    const bool goesRight = face.Behind[FaceCrossing::Right] != NoId &&
      !(Rule::EndsBesideCovered && right.IsCovered) &&
      !IsNarrow(apex, distance, this->Relays[window.Relays[1]]);
    if (!goesLeft && !goesRight)
    {
      return;
    }
    const Id relay = this->AddRelay(this->GraphRule.MakeRelay(apex, distance, cost));
    if (goesLeft)
    {
      GraphWindow child = window;
      child.Outer[1] = Rule::KeepsOuterRelays && right.IsCovered ? right.Relay : NoId;
      this->SendOn(child, face, FaceCrossing::Left, apex, relay);
    }
    if (goesRight)
    {
      window.Outer[0] = Rule::KeepsOuterRelays && left.IsCovered ? left.Relay : NoId;
      this->SendOn(window, face, FaceCrossing::Right, apex, relay);
    }
  }

  /// Queues the part of a window on one side of a relay, unless it has ended.
  void SendOn(GraphWindow& window, const FaceCrossing& face, FaceCrossing::Side side,
    const Point2& apex, Id relay)
  {
    window.Relays[1 - side] = relay;
    this->Turn(window, face, side, apex);
    if constexpr (!Rule::StartsLate)
    {
      const Relay& left = this->Relays[window.Relays[0]];
      const Relay& right = this->Relays[window.Relays[1]];
      if (!this->GraphRule.Start(left, right, window) || this->GraphRule.Ends(left, right, window))
      {
        return;
      }
    }
    if (!this->IsUseless(window))
    {
      this->Enter(face.Behind[side], window);
    }
  }

  /// Handles an apex that is reached at a distance and covered at a cost by the relays of the
  /// window: records an edge unless the apex is covered. Returns the cost of the apex as a relay.
  double ReachApex(const GraphWindow& window, const FaceCrossing& face, const Point2& apex,
    double distance, double costByRelays)
  {
    VertexStates::State& state = this->Vertices.Touch(face.ApexVertex);
    double cost = std::min(state.Cost, costByRelays);
    if (distance <= state.Label * (1.0 + LengthTolerance))
    {
      if (state.Edge != NoId || !this->GraphRule.Covers(cost, distance))
      {
        const Point2& origin = window.Ends[face.IsMirrored() ? 1 : 0];
        this->Record(state,
          { face.ApexVertex, distance, apex, window.Frame, { origin.X - apex.X, origin.Y - apex.Y },
            SurfaceMesh::Previous(face.GetHalfEdge()), face.IsMirrored() });
        cost = std::min(cost, this->GraphRule.CostOfEdge(distance));
      }
      this->SetLabel(face.ApexVertex, state, distance);
    }
    else
    {
      this->HasOverlap = true;
    }
    state.Cost = std::min(state.Cost, cost);
    return cost;
  }

  void SetLabel(Id v, VertexStates::State& state, double distance)
  {
    if (!(distance < state.Label))
    {
      return;
    }
    state.Label = distance;
    if (Rule::ByDistance || this->IsCareful)
    {
      this->Reached.Push(distance, v);
    }
    if (Rule::ByDistance)
    {
      this->ReachNeighbors(v, distance);
    }
  }

  /// Lowers the labels of neighbors along mesh edges, also of vertices that no window reaches.
  void ReachNeighbors(Id v, double distance)
  {
    this->ReachesRim = this->ReachesRim || this->Table.IsRim(v);
    const Id old = this->Table.OldVertex(v);
    for (const Id* g = this->Mesh.FanBegin(old); g != this->Mesh.FanEnd(old); ++g)
    {
      const Id back = SurfaceMesh::Previous(*g);
      this->ReachNeighbor(this->Mesh.Destination(*g), distance + this->Mesh.Length(*g));
      this->ReachNeighbor(this->Mesh.Origin(back), distance + this->Mesh.Length(back));
    }
  }
  void ReachNeighbor(Id old, double distance)
  {
    const Id v = this->Table.NewVertex(old);
    VertexStates::State& state = this->Vertices.Touch(v);
    if (distance < state.Label)
    {
      state.Label = distance;
      this->Reached.Push(distance, v);
    }
  }

  CrossingBlocks& Crossings;
  const UnfoldingTable& Table;
  const SurfaceMesh& Mesh;
  Rule GraphRule;
  WindowLimits Limits;
  VertexStates Vertices;
  bool IsCareful = false;
  /// True if a vertex has been reached by a path longer than its label. Until then no window can be
  /// useless, so that labels need not be compared.
  bool HasOverlap = false;
  bool HasExceededLimit = false;
  bool ReachesRim = false;
  /// True if labels are propagated along the sides of faces: there are many windows.
  bool PropagatesLabels = false;
  Id Source = NoId;
  GraphWindowMemory Memory;
  Id Behind = NoId; // careful mode: the vertex that a window has just passed
  Point2 BehindAt;
  std::vector<FoundEdge> Edges;
  std::vector<Relay> Relays;
  std::vector<GraphWindow> Queue;
  DistanceHeap Order;   // windows by distance, if processed in this order
  DistanceHeap Reached; // vertices by label, in the same case
  const GraphWindowTargets* Targets = nullptr;
  std::size_t NumberOfWindows = 0;
  std::size_t WindowsBefore = 0; // windows of earlier sources
  std::size_t WindowLimit = 0;   // limit of NumberOfWindows, see WindowLimits
};
}

#endif
