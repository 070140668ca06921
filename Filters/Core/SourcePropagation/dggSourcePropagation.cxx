// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggSourcePropagation.h"

#include "dggPrefetch.h"
#include "dggPropagationFaces.h"
#include "dggPropagationLabel.h"
#include "dggPropagationOutput.h"
#include "dggPropagationRounds.h"
#include "dggRoundTeam.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>
#include <thread>
#include <type_traits>

namespace dgg
{
namespace
{
/// What the offset of a source adds to the key that it competes with: less than any difference
/// that matters, more than rounding.
constexpr float OffsetPenalty = 1e-5F;
/// How much earlier than any way found so far a source may reach the end of an edge, as a part of
/// the edge. Ways that have yet to be found are shorter by less than that, shadows hide more.
constexpr float ShadowTolerance = 0.05F;
/// Initial distances beyond this, in mean edges, are all the same: in single precision nothing is
/// left of the surface there.
constexpr double LargestOffset = 1e30;
/// Labels that are nearer by less would go round in circles, for a gain by rounding each time.
constexpr float Rounding = 5e-7F;
/// What a thread takes at one time.
constexpr std::size_t LabelsPerChunk = 64;
constexpr Offset VerticesPerBlock = 4096;
constexpr Offset ValuesPerBlock = 65536;
/// So many labels for each face, and so many more, do not settle.
constexpr std::size_t MostLabelsPerFace = 7;
constexpr std::size_t ManyLabels = 100000;
/// Progress is reported about so often, but not after fewer labels: threads start anew each time.
constexpr double NumberOfReports = 12.0;
constexpr double FewestLabelsPerReport = 8192.0;
/// Fronts are too short for more threads, about.
constexpr Id FacesPerThread = 10000;
/// Labels that are propagated.
constexpr double FastLabelsPerFace = 1.2;
constexpr double HighLabelsPerFace = 1.9;
constexpr double LargestProgress = 0.99;

/// A part of a round.
struct alignas(64) Chunk
{
  int Thread = 0;                         ///< that works on it
  std::vector<PropagationLabel> Labels;   ///< of faces or edges
  std::vector<PropagationLabel> Vertices; ///< of vertices, which are the entries
  /// Of edges of many faces, by the half-edge that they leave through.
  std::vector<PropagationLabel> Edges;
  std::size_t Known = 0; ///< slots that have been propagated before

  std::size_t GetNumberOfLabels() const
  {
    return this->Labels.size() + this->Vertices.size() + this->Edges.size();
  }
};

void Lower(std::atomic<float>& value, float candidate)
{
  float old = value.load(std::memory_order_relaxed);
  while (candidate < old && !value.compare_exchange_weak(old, candidate, std::memory_order_relaxed))
  {
  }
}

/// One propagation. In `High` quality each edge has a slot, at its smallest half-edge, else each
/// face.
template <bool High>
class Propagation
{
public:
  Propagation(const SurfaceMesh& mesh, const PropagationFaces& faces, double shift, float radius,
    const ParallelFor& parallel, int threads)
    : Mesh(mesh)
    , Faces(faces)
    , Shift(shift)
    , Radius(radius)
    , FirstHub(High ? mesh.GetNumberOfHalfEdges() : mesh.GetNumberOfFaces())
    , Rounds(threads)
    , Entries(static_cast<std::size_t>(threads))
    , Chunks(static_cast<std::size_t>(threads))
  {
    // Not by constructors: to touch this memory first takes as long as a tenth of the rounds.
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
    fill(this->Distances, mesh.GetNumberOfVertices(), [](std::atomic<float>& distance) {
      distance.store(UnreachedKey, std::memory_order_relaxed);
    });
  }

  void Start(const std::vector<GeodesicSource>& sources);
  /// Some rounds. Nothing is left to do when IsDone() holds.
  Status Advance(RoundTeam& team);
  bool IsDone() const { return this->HasEnded; }
  double GetProgress() const
  {
    return std::min(LargestProgress, static_cast<double>(this->Propagated) / this->CountExpected());
  }

  double GetDistance(Id v) const
  {
    return this->Distances[v] * this->Faces.GetUnit() + this->Shift;
  }
  bool IsReached(Id v) const { return this->Distances[v] < UnreachedKey; }
  /// The label around a vertex that reaches it first; false without one.
  bool FindLabel(Id v, PropagationLabel& label, VirtualPlace& place) const;

private:
  /// Labels, about; it takes as many as it takes.
  double CountExpected() const
  {
    return (High ? HighLabelsPerFace : FastLabelsPerFace) * this->Mesh.GetNumberOfFaces();
  }
  Id SlotOf(Id entry) const;
  void Radiate(const PropagationLabel& from, Id v, Chunk& chunk);
  void CrossInto(Id t, Id exit, PropagationLabel label, Chunk& chunk);
  void ReachHub(Id v, float distance, Id root, Chunk& chunk);
  void Collect(const BucketQueue::Entry* begin, const BucketQueue::Entry* end, Chunk& chunk);
  void Propagate(Chunk& chunk);
  DGG_INLINE void Leave(const PropagationLabel& label, int side, Chunk& chunk);
  DGG_INLINE void Cross(Id exit, PropagationLabel label, Chunk& chunk);
  DGG_INLINE void Enter(PropagationLabel label, Chunk& chunk);
  DGG_INLINE void Offer(float key, const PropagationLabel& label, Id id, Chunk& chunk);
  DGG_INLINE void StayOutOfShadows(
    PropagationLabel& label, float length, Id atOrigin, Id atEnd) const;

  const SurfaceMesh& Mesh;
  const PropagationFaces& Faces;
  const double Shift;
  const float Radius;
  const Id FirstHub; ///< slots from here on are those of hubs
  std::unique_ptr<PropagationSlot[]> Slots;
  /// Lengths of ways to the vertices.
  std::unique_ptr<std::atomic<float>[]> Distances;
  PropagationRounds Rounds;
  std::vector<std::vector<BucketQueue::Entry>> Entries; ///< of a round, by threads
  std::vector<std::vector<Chunk>> Chunks;               ///< the same in parts
  bool IsShared = false;
  bool HasEnded = false;
  std::size_t Propagated = 0; ///< labels
};

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

template <bool High>
void Propagation<High>::Start(const std::vector<GeodesicSource>& sources)
{
  Chunk chunk;
  const double unit = this->Faces.GetUnit();
  for (std::size_t k = 0; k < sources.size(); ++k)
  {
    const SurfacePoint& point = sources[k].Point;
    const auto root = static_cast<Id>(k);
    const auto offset = static_cast<float>(
      std::min((sources[k].InitialDistance - this->Shift) / unit, LargestOffset));
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
        // From behind the edge, with the face on its other side.
        const Point2 place = PlaceInFrame(this->Mesh, h, b);
        this->Cross(h,
          { static_cast<float>((this->Mesh.Length(h) - place.X) / unit),
            -static_cast<float>(place.Y / unit), offset, NoId, root },
          chunk);
      }
    });
  }
}

/// A vertex as source, in all faces around it.
template <bool High>
void Propagation<High>::Radiate(const PropagationLabel& from, Id v, Chunk& chunk)
{
  for (const Id* g = this->Mesh.FanBegin(v); g != this->Mesh.FanEnd(v); ++g)
  {
    this->Enter({ 0.0F, 0.0F, from.Offset, *g, from.Root }, chunk);
  }
}

/// A hub is reached: other fans of the vertex are reached through it only.
template <bool High>
void Propagation<High>::ReachHub(Id v, float distance, Id root, Chunk& chunk)
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
  const std::size_t most =
    ManyLabels + MostLabelsPerFace * static_cast<std::size_t>(this->Mesh.GetNumberOfFaces());
  const double step = std::max(FewestLabelsPerReport, this->CountExpected() / NumberOfReports);
  const std::size_t stop = this->Propagated + static_cast<std::size_t>(step);
  RoundTeam::Counts counts{};
  while (this->Propagated < stop)
  {
    if (!this->Rounds.Next(this->Slots.get(), this->Entries))
    {
      this->HasEnded = true;
      break;
    }
    for (std::size_t t = 0; t < this->Entries.size(); ++t)
    {
      const std::size_t count = (this->Entries[t].size() + LabelsPerChunk - 1) / LabelsPerChunk;
      this->Chunks[t].resize(std::max(this->Chunks[t].size(), count));
      counts[t] = static_cast<Offset>(count);
    }
    // A round: what was found in it counts in the next one.
    this->IsShared = team.IsShared();
    team.ForEach(counts, this->IsShared, [&](int owner, Offset i, int) {
      const std::vector<BucketQueue::Entry>& entries = this->Entries[owner];
      const std::size_t begin = static_cast<std::size_t>(i) * LabelsPerChunk;
      const std::size_t end = std::min(entries.size(), begin + LabelsPerChunk);
      this->Collect(entries.data() + begin, entries.data() + end, this->Chunks[owner][i]);
    });
    team.ForEach(counts, this->IsShared, [&](int owner, Offset i, int thread) {
      this->Chunks[owner][i].Thread = thread;
      this->Propagate(this->Chunks[owner][i]);
    });
    std::size_t labels = 0;
    std::size_t known = 0;
    for (std::size_t t = 0; t < this->Chunks.size(); ++t)
    {
      for (Offset i = 0; i < counts[t]; ++i)
      {
        labels += this->Chunks[t][i].GetNumberOfLabels();
        known += this->Chunks[t][i].Known;
      }
    }
    this->Rounds.AdjustWidth(labels, known);
    this->Propagated += labels;
    if (this->Propagated > most)
    {
      return Status::Invalid("the triangles are too irregular for virtual sources: distances did "
                             "not settle; use another method");
    }
  }
  return Status::Success();
}

/// The labels that have changed, and how far they are from the vertices behind their edges.
template <bool High>
void Propagation<High>::Collect(
  const BucketQueue::Entry* begin, const BucketQueue::Entry* end, Chunk& chunk)
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
      chunk.Known += slot.Threshold < UnreachedKey ? 1 : 0;
      slot.Threshold = (1.0F - Rounding) * slot.Key.load(std::memory_order_relaxed);
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
void Propagation<High>::Propagate(Chunk& chunk)
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
    for (Id t = this->Mesh.Twin(label.Entry); t != label.Entry; t = this->Mesh.Twin(t))
    {
      this->CrossInto(t, label.Entry, label, chunk);
    }
  }
}

/// Through one of the two other edges of the face that a label has entered.
template <bool High>
void Propagation<High>::Leave(const PropagationLabel& label, int side, Chunk& chunk)
{
  const Id f = SurfaceMesh::Face(label.Entry);
  const PropagationFace& face = this->Faces[f];
  if (face.Behind[side] == PropagationFaces::Nothing)
  {
    return;
  }
  const int k = label.Entry % 3;
  const float base = face.Lengths[k];
  const float length = face.Lengths[side];
  const bool isLeft = side == PreviousOf(k);
  PropagationLabel image = label;
  if (High)
  {
    const float left = face.Lengths[PreviousOf(k)];
    const float x = left * face.Cosines[k];
    BendAround(image, base, 0.5F * (isLeft ? x : x + base), 0.5F * left * face.Sines[k]);
  }
  // As in FaceUnfolding.
  const float x = isLeft ? image.X : base - image.X;
  const float cosine = face.Cosines[isLeft ? k : side];
  const float sine = face.Sines[isLeft ? k : side];
  const float along = cosine * x + sine * image.Y;
  image.Y = cosine * image.Y - sine * x;
  image.X = isLeft ? along : length - along;
  if (image.Y > 0.0F)
  {
    // The source is on the far side, as behind a hole: the way bends around the nearer end.
    const float end = 2.0F * image.X < length ? 0.0F : length;
    image.Offset += PlaneLength(image.X - end, image.Y);
    image.X = end;
    image.Y = 0.0F;
  }
  if (this->Faces.HasShadows())
  {
    this->StayOutOfShadows(image, length, face.Corners[NextOf(side)], face.Corners[side]);
  }
  this->Cross(3 * f + side, image, chunk);
}

/// Move a source to where it does not reach an end of the axis earlier than any way found so far.
template <bool High>
void Propagation<High>::StayOutOfShadows(
  PropagationLabel& label, float length, Id atOrigin, Id atEnd) const
{
  const float tolerance = ShadowTolerance * length;
  float a = PlaneLength(label.X, label.Y);
  float b = PlaneLength(length - label.X, label.Y);
  const float knownA = this->Distances[atOrigin].load(std::memory_order_relaxed);
  const float knownB = this->Distances[atEnd].load(std::memory_order_relaxed);
  const bool isHiddenA = knownA < UnreachedKey && knownA - label.Offset > a + tolerance;
  const bool isHiddenB = knownB < UnreachedKey && knownB - label.Offset > b + tolerance;
  if (!isHiddenA && !isHiddenB)
  {
    return;
  }
  a = isHiddenA ? knownA - label.Offset : a;
  b = isHiddenB ? knownB - label.Offset : b;
  if (std::abs(a - b) <= length)
  {
    label.X = 0.5F * (length + (a - b) * (a + b) / length);
    label.Y = -std::sqrt(std::max(0.0F, a * a - label.X * label.X));
  }
  else
  {
    label.Offset += std::min(a, b);
    label.X = a < b ? 0.0F : length;
    label.Y = 0.0F;
  }
}

/// Into all faces behind an edge. The label is in the frame of a twin that is oriented alike.
template <bool High>
void Propagation<High>::Cross(Id exit, PropagationLabel label, Chunk& chunk)
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
    for (Id t = this->Mesh.Twin(exit); t != exit && t != NoId; t = this->Mesh.Twin(t))
    {
      this->CrossInto(t, exit, label, chunk);
    }
  }
  else if (behind <= PropagationFaces::FirstGate)
  {
    // The label that is the best one at the middle goes on.
    const float length = face.Lengths[exit % 3];
    const float distance = label.Offset + PlaneLength(0.5F * length - label.X, label.Y);
    if (distance <= this->Radius + length)
    {
      label.Entry = exit;
      this->Offer(distance, label, this->FirstHub + PropagationFaces::FirstGate - behind, chunk);
    }
  }
}

/// Into one of several faces of an edge.
template <bool High>
void Propagation<High>::CrossInto(Id t, Id exit, PropagationLabel label, Chunk& chunk)
{
  if (this->Mesh.Origin(t) == this->Mesh.Origin(exit))
  {
    label.X = this->Faces[SurfaceMesh::Face(exit)].Lengths[exit % 3] - label.X;
  }
  label.Entry = t;
  this->Enter(label, chunk);
}

template <bool High>
void Propagation<High>::Enter(PropagationLabel label, Chunk& chunk)
{
  const PropagationFace& face = this->Faces[SurfaceMesh::Face(label.Entry)];
  const int k = label.Entry % 3;
  const float length = face.Lengths[k];
  float x = 0.5F * length;
  float y = 0.0F;
  if (!High)
  {
    // Labels of a face compete at its centroid: in the plane they are all exact then.
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
void Propagation<High>::Offer(float key, const PropagationLabel& label, Id id, Chunk& chunk)
{
  PropagationSlot& slot = this->Slots[id];
  if (!(key <= slot.Key.load(std::memory_order_relaxed) && key < slot.Threshold))
  {
    return;
  }
  while (this->IsShared && slot.IsLocked.exchange(true, std::memory_order_acquire))
  {
    std::this_thread::yield();
  }
  const float best = slot.Key.load(std::memory_order_relaxed);
  const bool isBetter = key < best || (key == best && ComesBefore(label, slot.Best));
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

template <bool High>
bool Propagation<High>::FindLabel(Id v, PropagationLabel& label, VirtualPlace& place) const
{
  float nearest = UnreachedKey;
  const auto look = [&](Id entry, int corner) {
    const PropagationSlot& slot = this->Slots[this->SlotOf(entry)];
    if (slot.Best.Entry != entry)
    {
      return;
    }
    const Way way = WayTo(corner, slot.Best, this->Faces[SurfaceMesh::Face(entry)]);
    const float rank = way.GetDistance() + OffsetPenalty * way.Label.Offset;
    if (rank < nearest)
    {
      nearest = rank;
      label = way.Label;
      const Id at = 3 * SurfaceMesh::Face(entry) + corner;
      const Point2 direction =
        DirectionInFrame(this->Mesh, entry, at, { label.X - way.X, label.Y - way.Y });
      place = { way.Length * this->Faces.GetUnit(), at, std::atan2(direction.Y, direction.X) };
    }
  };
  for (const Id* g = this->Mesh.FanBegin(v); g != this->Mesh.FanEnd(v); ++g)
  {
    const Id f = SurfaceMesh::Face(*g);
    for (Id h = 3 * f; h < 3 * f + 3; ++h)
    {
      look(h, *g % 3);
    }
  }
  return nearest < UnreachedKey;
}

/// Run with either quality.
template <bool High>
Status RunPropagation(const SurfaceMesh& mesh, const PropagationFaces& faces,
  const std::vector<GeodesicSource>& sources, const PropagationOptions& options,
  PropagationResult& result)
{
  // Distances are measured from the least initial one, so that the largest ones do not decide on
  // rounding.
  double shift = Infinity;
  for (const GeodesicSource& source : sources)
  {
    shift = std::min(shift, source.InitialDistance);
  }
  const double radius = (options.MaximumDistance - shift) / faces.GetUnit();
  // Comparisons with single precision must not lose what is at the very distance.
  const auto limit =
    static_cast<float>(std::min(radius * (1.0 + PropagationOutput::LimitSlack), 1e37));
  const int threads =
    std::min(mesh.GetNumberOfFaces() / FacesPerThread, static_cast<Id>(RoundTeam::LargestTeam));
  const ParallelFor parallel = threads > 1 ? options.Parallel : ParallelFor();
  Propagation<High> propagation(mesh, faces, shift, limit, parallel, parallel ? threads : 1);
  propagation.Start(sources);
  while (!propagation.IsDone())
  {
    Status status;
    RoundTeam::Run(parallel, threads, [&](RoundTeam& team) { status = propagation.Advance(team); });
    DGG_RETURN_IF_ERROR(status);
    // Not while others wait for the leader: observers may have loops of their own.
    if (options.Progress && !options.Progress(propagation.GetProgress()))
    {
      return Status::Abort();
    }
  }
  PropagationOutput output(mesh, options, shift, result);
  ForRange(parallel, mesh.GetNumberOfVertices(), VerticesPerBlock, [&](Offset begin, Offset end) {
    for (auto v = static_cast<Id>(begin); v < end; ++v)
    {
      PropagationLabel label{};
      VirtualPlace place;
      if (propagation.IsReached(v) && output.SetDistance(v, propagation.GetDistance(v)) &&
        output.WantsLabels() && propagation.FindLabel(v, label, place))
      {
        output.SetSource(v, label.Root, place);
      }
    }
  });
  output.TakeSources(sources);
  return Status::Success();
}
}

SourcePropagation::SourcePropagation(const SurfaceMesh& mesh)
  : Mesh(mesh)
  , Faces(std::make_unique<PropagationFaces>(mesh))
{
}

SourcePropagation::~SourcePropagation() = default;

Status SourcePropagation::Run(const std::vector<GeodesicSource>& sources,
  const PropagationOptions& options, PropagationResult& result) const
{
  result = PropagationResult();
  DGG_RETURN_IF_ERROR(CheckSources(this->Mesh, sources));
  if (std::isnan(options.MaximumDistance))
  {
    return Status::Invalid("the maximum distance is not a number");
  }
  return options.Quality == PropagationQuality::High
    ? RunPropagation<true>(this->Mesh, *this->Faces, sources, options, result)
    : RunPropagation<false>(this->Mesh, *this->Faces, sources, options, result);
}
}
