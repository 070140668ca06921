// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggPropagation.h"

#include "dggPrefetch.h"

#include <algorithm>
#include <cmath>
#include <thread>
#include <type_traits>

namespace dgg
{
namespace
{
/// Penalty of the offset in the key with which sources compete: below any relevant difference,
/// above rounding errors.
constexpr float OffsetPenalty = 1e-5F;
/// Work per chunk of a thread.
constexpr std::size_t LabelsPerChunk = 64;
constexpr Offset ValuesPerBlock = 65536;
/// Maximum number of labels: per face, plus a constant. Beyond this, labels do not settle.
constexpr std::size_t MostLabelsPerFace = 7;
constexpr std::size_t ManyLabels = 100000;
/// Approximate number of progress reports, and minimum number of labels in between, because threads
/// are restarted each time.
constexpr double NumberOfReports = 12.0;
constexpr double FewestLabelsPerReport = 8192.0;
/// Expected number of propagated labels per face.
constexpr double FastLabelsPerFace = 1.2;
constexpr double HighLabelsPerFace = 1.9;
constexpr double LargestProgress = 0.99;

void Lower(std::atomic<float>& value, float candidate)
{
  float old = value.load(std::memory_order_relaxed);
  while (candidate < old && !value.compare_exchange_weak(old, candidate, std::memory_order_relaxed))
  {
  }
}
}

template <bool High>
Propagation<High>::Propagation(const SurfaceMesh& mesh, const PropagationFaces& faces,
  PropagationPieces* pieces, double shift, float radius, const ParallelFor& parallel, int threads)
  : Mesh(mesh)
  , Faces(faces)
  , Pieces(pieces)
  , Shift(shift)
  , Radius(radius)
  , FirstHub(High ? mesh.GetNumberOfHalfEdges() : mesh.GetNumberOfFaces())
  , Rounds(threads)
  , Entries(static_cast<std::size_t>(threads))
  , Chunks(static_cast<std::size_t>(threads), std::vector<PropagationChunk>(1))
{
  // Filled in parallel rather than by constructors, because the first touch of this memory takes a
  // tenth of the time of the rounds.
  const auto fill = [&](auto& array, Offset size, const auto& value) {
    using Value = std::decay_t<decltype(array[0])>;
    array.reset(new Value[static_cast<std::size_t>(size)]);
    ForRange(parallel, size, ValuesPerBlock, [&](Offset begin, Offset end) {
      for (Offset i = begin; i < end; ++i)
      {
        value(array[i]);
      }
    });
  };
  fill(this->Slots, Offset(this->FirstHub) + faces.GetNumberOfHubs(),
    [](PropagationSlot& slot) { slot.Clear(); });
  fill(this->Distances, mesh.GetNumberOfVertices(),
    [](std::atomic<float>& distance) { distance.store(UnreachedKey, std::memory_order_relaxed); });
}

template <bool High>
double Propagation<High>::CountExpected() const
{
  return (High ? HighLabelsPerFace : FastLabelsPerFace) *
    static_cast<double>(this->GetNumberOfFaces());
}

template <bool High>
std::size_t Propagation<High>::MaximumCount() const
{
  return ManyLabels + MostLabelsPerFace * static_cast<std::size_t>(this->GetNumberOfFaces());
}

template <bool High>
double Propagation<High>::GetProgress() const
{
  return std::min(LargestProgress, static_cast<double>(this->Propagated) / this->CountExpected());
}

template <bool High>
Id Propagation<High>::SlotOf(Id entry) const
{
  if (!High)
  {
    return SurfaceMesh::Face(entry);
  }
  const Id twin = this->Faces[SurfaceMesh::Face(entry)].Behind[entry % 3];
  return twin >= 0 ? std::min(entry, twin) : entry;
}

/// Returns true if this process has the slot of a label that enters a face of another process: in
/// High quality, the processes of both faces of an edge have it, and receive the same labels.
template <bool High>
bool Propagation<High>::IsSlotHere(Id entry) const
{
  const Id twin = this->Faces[SurfaceMesh::Face(entry)].Behind[entry % 3];
  return High && twin >= 0 && this->IsHere(SurfaceMesh::Face(twin));
}

template <bool High>
void Propagation<High>::Start(const std::vector<GeodesicSource>& sources, bool wantsLabels)
{
  this->HasRivals = sources.size() > 1;
  this->WantsLabels = wantsLabels;
  PropagationChunk& chunk = this->Chunks.front().front();
  const double unit = this->Faces.GetUnit();
  for (std::size_t k = 0; k < sources.size(); ++k)
  {
    const SurfacePoint& point = sources[k].Point;
    if (IsVertex(point) && point.Vertex == NoId)
    {
      continue; // only known to other processes
    }
    const auto root = static_cast<Id>(k);
    const auto offset = static_cast<float>((sources[k].InitialDistance - this->Shift) / unit);
    if (point.On == SurfacePoint::Support::Vertex)
    {
      Lower(this->Distances[point.Vertex], offset);
      if (this->Faces.GetHub(point.Vertex) != NoId)
      {
        this->ReachHub(point.Vertex, offset, root, chunk);
      }
      else
      {
        this->Radiate({ 0.0F, 0.0F, offset, NoId, root }, point.Vertex, chunk);
      }
      continue;
    }
    ForEachFaceAround(this->Mesh, point, [&](Id f, const std::array<double, 3>& b) {
      for (Id h = 3 * f; h < 3 * f + 3; ++h)
      {
        const float distance =
          offset + static_cast<float>(DistanceToCorner(this->Mesh, f, b, h % 3) / unit);
        Lower(this->Distances[this->Mesh.Origin(h)], distance);
        this->ReachHub(this->Mesh.Origin(h), distance, root, chunk);
      }
      for (Id h = 3 * f; h < 3 * f + 3; ++h)
      {
        // In the frame of the opposite half-edge, with the face on its other side.
        const Point2 place = PlaceInFrame(this->Mesh, h, b);
        this->Cross(h,
          { static_cast<float>((this->Mesh.Length(h) - place.X) / unit),
            -static_cast<float>(place.Y / unit), offset, NoId, root },
          chunk);
      }
    });
  }
  this->TakeShortcuts(chunk);
  chunk.Crossing.clear(); // other processes start there
}

/// Emits a vertex as source into all faces around it.
template <bool High>
void Propagation<High>::Radiate(const PropagationLabel& from, Id v, PropagationChunk& chunk)
{
  for (const Id* g = this->Mesh.FanBegin(v); g != this->Mesh.FanEnd(v); ++g)
  {
    this->Enter({ 0.0F, 0.0F, from.Offset, *g, from.Root }, chunk);
  }
}

/// Reaches a hub: other fans of the vertex are only reached through the hub.
template <bool High>
void Propagation<High>::ReachHub(Id v, float distance, Id root, PropagationChunk& chunk)
{
  const Id hub = this->Faces.GetHub(v);
  if (hub != NoId && distance <= this->Radius)
  {
    this->Offer(distance, { 0.0F, 0.0F, distance, v, root }, this->FirstHub + hub, chunk);
  }
}

template <bool High>
Status Propagation<High>::Advance(RoundTeam& team)
{
  const double step = std::max(FewestLabelsPerReport, this->CountExpected() / NumberOfReports);
  const std::size_t stop = this->Propagated + static_cast<std::size_t>(step);
  RoundTeam::Counts counts{};
  while (this->Propagated < stop)
  {
    this->HasEnded = !this->IsSettled();
    if (!this->HasEnded)
    {
      DGG_RETURN_IF_ERROR(
        this->Rounds.Next(this->Slots.get(), this->Pieces, this->Entries, this->HasEnded));
    }
    if (this->HasEnded)
    {
      break;
    }
    for (std::size_t t = 0; t < this->Entries.size(); ++t)
    {
      const std::size_t count = (this->Entries[t].size() + LabelsPerChunk - 1) / LabelsPerChunk;
      this->Chunks[t].resize(std::max(this->Chunks[t].size(), count));
      counts[t] = static_cast<Offset>(count);
    }
    // One round; its results are used in the next one.
    this->IsShared = team.IsShared();
    team.ForEach(counts, this->IsShared, [&](int owner, Offset i, int) {
      const std::vector<BucketQueue::Entry>& entries = this->Entries[owner];
      const std::size_t begin = static_cast<std::size_t>(i) * LabelsPerChunk;
      const std::size_t end = std::min(entries.size(), begin + LabelsPerChunk);
      this->Collect(entries.data() + begin, entries.data() + end, this->Chunks[owner][i]);
    });
    if (this->Pieces)
    {
      std::vector<Id> lowered;
      bool isOver = false;
      DGG_RETURN_IF_ERROR(this->Pieces->ShareDistances(this->Distances.get(), lowered, isOver));
    }
    team.ForEach(counts, this->IsShared, [&](int owner, Offset i, int thread) {
      this->Chunks[owner][i].Thread = thread;
      this->Propagate(this->Chunks[owner][i]);
    });
    PropagationCounts done;
    std::vector<PropagationLabel> crossing;
    for (std::size_t t = 0; t < this->Chunks.size(); ++t)
    {
      for (Offset i = 0; i < counts[t]; ++i)
      {
        PropagationChunk& chunk = this->Chunks[t][i];
        done.Add({ chunk.GetNumberOfLabels(), chunk.Known });
        this->TakeShortcuts(chunk);
        crossing.insert(crossing.end(), chunk.Crossing.begin(), chunk.Crossing.end());
        chunk.Crossing.clear();
      }
    }
    if (this->Pieces)
    {
      DGG_RETURN_IF_ERROR(this->Pieces->Sum(done));
      DGG_RETURN_IF_ERROR(this->ExchangeLabels(crossing));
    }
    this->Rounds.AdjustWidth(done.Labels, done.Known);
    this->Propagated += done.Labels;
  }
  return Status::Success();
}

/// Sends labels to other processes, and enters the faces of this process with those received.
template <bool High>
Status Propagation<High>::ExchangeLabels(std::vector<PropagationLabel>& crossing)
{
  DGG_RETURN_IF_ERROR(this->Pieces->ExchangeLabels(crossing));
  PropagationChunk& chunk = this->Chunks.front().front();
  chunk.Thread = 0;
  for (const PropagationLabel& label : crossing)
  {
    this->Enter(label, chunk);
  }
  this->TakeShortcuts(chunk);
  return Status::Success();
}

/// Collects the changed labels, and their distances to the vertices behind their edges.
template <bool High>
void Propagation<High>::Collect(
  const BucketQueue::Entry* begin, const BucketQueue::Entry* end, PropagationChunk& chunk)
{
  chunk.Labels.clear();
  chunk.Vertices.clear();
  chunk.Edges.clear();
  chunk.Known = 0;
  for (const BucketQueue::Entry* entry = begin; entry != end; ++entry)
  {
    PropagationSlot& slot = this->Slots[entry->Vertex];
    if (slot.IsPending.load(std::memory_order_relaxed) &&
      slot.IsPending.exchange(false, std::memory_order_relaxed))
    {
      const PropagationLabel& label = slot.Best;
      const bool isKnown = slot.Threshold < UnreachedKey;
      slot.Threshold = (1.0F - PropagationRounding) * slot.Key.load(std::memory_order_relaxed);
      if (entry->Vertex < this->FirstHub && !this->IsHere(SurfaceMesh::Face(label.Entry)))
      {
        continue; // the process of the face propagates the label
      }
      chunk.Known += isKnown ? 1 : 0;
      if (entry->Vertex >= this->FirstHub)
      {
        const bool isVertex = entry->Vertex < this->FirstHub + this->Faces.GetNumberOfVertexHubs();
        (isVertex ? chunk.Vertices : chunk.Edges).push_back(label);
        continue;
      }
      const int k = label.Entry % 3;
      const PropagationFace& face = this->Faces[SurfaceMesh::Face(label.Entry)];
      const int apex = PreviousOf(k);
      Lower(this->Distances[face.Corners[apex]], WayTo(apex, label, face).GetDistance());
      if (IsAtOrigin(label))
      {
        Lower(this->Distances[face.Corners[NextOf(k)]], label.Offset + face.Lengths[k]);
      }
      chunk.Labels.push_back(label);
      for (const int side : { PreviousOf(k), NextOf(k) })
      {
        const Id behind = face.Behind[side];
        if (behind >= 0)
        {
          const Id exit = 3 * SurfaceMesh::Face(label.Entry) + side;
          Prefetch(&this->Faces[SurfaceMesh::Face(behind)]);
          Prefetch(&this->Slots[High ? std::min(exit, behind) : SurfaceMesh::Face(behind)]);
        }
      }
    }
  }
}

template <bool High>
void Propagation<High>::Propagate(PropagationChunk& chunk)
{
  for (const PropagationLabel& label : chunk.Labels)
  {
    const int k = label.Entry % 3;
    this->Leave(label, PreviousOf(k), chunk);
    this->Leave(label, NextOf(k), chunk);
    const PropagationFace& face = this->Faces[SurfaceMesh::Face(label.Entry)];
    if (face.IsIrregular)
    {
      for (const int corner : { PreviousOf(k), NextOf(k) })
      {
        if (corner == PreviousOf(k) || IsAtOrigin(label))
        {
          const float distance = WayTo(corner, label, face).GetDistance();
          this->ReachHub(face.Corners[corner], distance, label.Root, chunk);
        }
      }
    }
  }
  for (const PropagationLabel& label : chunk.Vertices)
  {
    this->Radiate(label, label.Entry, chunk);
  }
  for (const PropagationLabel& label : chunk.Edges)
  {
    this->EnterAllBehind(label.Entry, label, chunk);
  }
}

/// Propagates a label through one of the two other edges of the face that it has entered.
template <bool High>
void Propagation<High>::Leave(const PropagationLabel& label, int side, PropagationChunk& chunk)
{
  const Id f = SurfaceMesh::Face(label.Entry);
  const PropagationFace& face = this->Faces[f];
  if (face.Behind[side] == PropagationFaces::Nothing)
  {
    return;
  }
  PropagationLabel image = label;
  if (High)
  {
    const int k = label.Entry % 3;
    const float base = face.Lengths[k];
    const float left = face.Lengths[PreviousOf(k)];
    const float x = left * face.Cosines[k] + (side == PreviousOf(k) ? 0.0F : base);
    BendAround(image, base, 0.5F * x, 0.5F * left * face.Sines[k]);
  }
  UnfoldTo(side, image, face);
  const float length = face.Lengths[side];
  const int origin = NextOf(side); // origin of the twin
  const float a = this->Load(face.Corners[origin]);
  const float b = this->Load(face.Corners[side]);
  if (std::abs(a - b) > length + PropagationRounding * a)
  {
    chunk.Shortcuts.push_back(
      a < b ? WayAlongEdge(f, face, origin, side, a) : WayAlongEdge(f, face, side, origin, b));
  }
  if (this->Faces.HasShadows())
  {
    const float height = face.Lengths[PreviousOf(side)] * face.Sines[side];
    StayOutOfShadows(image, length, height, a, b);
  }
  this->Cross(3 * f + side, image, chunk);
}

/// Propagates a label into all faces behind an edge. The label is in the frame of a consistently
/// oriented twin.
template <bool High>
void Propagation<High>::Cross(Id exit, PropagationLabel label, PropagationChunk& chunk)
{
  const PropagationFace& face = this->Faces[SurfaceMesh::Face(exit)];
  const Id behind = face.Behind[exit % 3];
  if (behind >= 0)
  {
    label.Entry = behind;
    this->Enter(label, chunk);
  }
  else if (behind == PropagationFaces::AskMesh)
  {
    this->EnterAllBehind(exit, label, chunk);
  }
  else if (behind <= PropagationFaces::FirstGate)
  {
    // The label that is best at the midpoint is propagated.
    const float length = face.Lengths[exit % 3];
    const float distance = label.Offset + PlaneLength(0.5F * length - label.X, label.Y);
    if (distance <= this->Radius + length)
    {
      label.Entry = exit;
      this->Offer(distance, label, this->FirstHub + PropagationFaces::FirstGate - behind, chunk);
    }
  }
}

/// Enters all faces behind an edge with the label of a twin that is oriented consistently.
template <bool High>
void Propagation<High>::EnterAllBehind(
  Id exit, const PropagationLabel& label, PropagationChunk& chunk)
{
  ForEachFaceBehind(this->Mesh, exit, false, [&](Id e, bool isMirrored) {
    PropagationLabel copy = label;
    copy.X =
      isMirrored ? this->Faces[SurfaceMesh::Face(exit)].Lengths[exit % 3] - label.X : label.X;
    copy.Entry = e;
    this->Enter(copy, chunk);
  });
}

template <bool High>
void Propagation<High>::Enter(PropagationLabel label, PropagationChunk& chunk)
{
  if (this->Pieces && !this->Pieces->IsHere(SurfaceMesh::Face(label.Entry)))
  {
    chunk.Crossing.push_back(label);
    if (!this->IsSlotHere(label.Entry))
    {
      return;
    }
  }
  const PropagationFace& face = this->Faces[SurfaceMesh::Face(label.Entry)];
  const int k = label.Entry % 3;
  const float length = face.Lengths[k];
  float x = 0.5F * length;
  float y = 0.0F;
  if (!High)
  {
    // Labels of a face compete at its centroid; in the plane all of them are exact there.
    const float left = face.Lengths[PreviousOf(k)];
    x = (length + left * face.Cosines[k]) / 3.0F;
    y = left * face.Sines[k] / 3.0F;
    BendAround(label, length, x, y);
  }
  const float distance = label.Offset + PlaneLength(x - label.X, y - label.Y);
  const float reach =
    std::max(length, std::max(face.Lengths[NextOf(k)], face.Lengths[PreviousOf(k)]));
  if (distance <= this->Radius + reach)
  {
    this->Offer(distance + OffsetPenalty * label.Offset, label, this->SlotOf(label.Entry), chunk);
  }
}

template <bool High>
void Propagation<High>::Offer(
  float key, const PropagationLabel& label, Id id, PropagationChunk& chunk)
{
  PropagationSlot& slot = this->Slots[id];
  if (!(key <= slot.Key.load(std::memory_order_relaxed) && key < slot.Threshold))
  {
    if (this->HasRivals)
    {
      this->Lose(id, label, chunk);
    }
    return;
  }
  while (this->IsShared && slot.IsLocked.exchange(true, std::memory_order_acquire))
  {
    std::this_thread::yield();
  }
  const float best = slot.Key.load(std::memory_order_relaxed);
  const bool isBetter = key < best || (key == best && ComesBefore(label, slot.Best));
  if (this->HasRivals && best < UnreachedKey)
  {
    this->Lose(id, isBetter ? slot.Best : label, chunk);
  }
  if (isBetter)
  {
    slot.Key.store(key, std::memory_order_relaxed);
    slot.Best = label;
    slot.IsPending.store(true, std::memory_order_relaxed);
  }
  slot.IsLocked.store(false, std::memory_order_release);
  if (isBetter)
  {
    this->Rounds.Push(chunk.Thread, key, id);
  }
}

/// Handles a label that a face or an edge rejects: it may still be the first to reach a corner.
template <bool High>
void Propagation<High>::Lose(Id id, const PropagationLabel& label, PropagationChunk& chunk) const
{
  if (id >= this->FirstHub)
  {
    return;
  }
  const PropagationFace& face = this->Faces[SurfaceMesh::Face(label.Entry)];
  const auto look = [&](int corner) {
    const Id v = face.Corners[corner];
    const float distance = WayTo(corner, label, face).GetDistance();
    if (distance <= this->Load(v))
    {
      chunk.Shortcuts.push_back({ v, distance, label });
    }
  };
  const int k = label.Entry % 3;
  look(PreviousOf(k));
  if (IsAtOrigin(label))
  {
    look(NextOf(k));
  }
}

template <bool High>
void Propagation<High>::TakeShortcuts(PropagationChunk& chunk)
{
  for (const PropagationShortcut& way : chunk.Shortcuts)
  {
    Lower(this->Distances[way.Vertex], way.Distance);
    if (way.Label.Root != NoId)
    {
      this->ReachHub(way.Vertex, way.Distance, way.Label.Root, chunk);
    }
  }
  if (this->WantsLabels)
  {
    this->Shortcuts.insert(this->Shortcuts.end(), chunk.Shortcuts.begin(), chunk.Shortcuts.end());
  }
  chunk.Shortcuts.clear();
}

template <bool High>
Way Propagation<High>::SeeFrom(Id v, const PropagationLabel& label, VirtualPlace& place) const
{
  const Id f = SurfaceMesh::Face(label.Entry);
  const PropagationFace& face = this->Faces[f];
  const int corner = face.Corners[0] == v ? 0 : face.Corners[1] == v ? 1 : 2;
  const Id at = 3 * f + corner;
  const Way way = WayTo(corner, label, face);
  const Point2 direction =
    DirectionInFrame(this->Mesh, label.Entry, at, { way.Label.X - way.X, way.Label.Y - way.Y });
  place = { way.Length * this->Faces.GetUnit(), at, std::atan2(direction.Y, direction.X) };
  return way;
}

template <bool High>
bool Propagation<High>::FindLabel(Id v, PropagationLabel& label, VirtualPlace& place) const
{
  float nearest = UnreachedKey;
  for (const Id* g = this->Mesh.FanBegin(v); g != this->Mesh.FanEnd(v); ++g)
  {
    const Id f = SurfaceMesh::Face(*g);
    for (Id h = 3 * f; h < 3 * f + 3; ++h)
    {
      const PropagationLabel& best = this->Slots[this->SlotOf(h)].Best;
      VirtualPlace seen;
      if (best.Entry != h)
      {
        continue;
      }
      const Way way = this->SeeFrom(v, best, seen);
      const float rank = way.GetDistance() + OffsetPenalty * way.Label.Offset;
      if (rank < nearest)
      {
        nearest = rank;
        label = way.Label;
        place = seen;
      }
    }
  }
  return nearest < UnreachedKey;
}

template class Propagation<false>;
template class Propagation<true>;
}
