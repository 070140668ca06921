// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggTriangleEngine.h"

#include <algorithm>
#include <functional>

namespace dgg
{
namespace
{
/// Windows and vertices between two progress reports: some milliseconds.
constexpr std::size_t ProgressInterval = 20000;
/// Minimum number of windows and vertices between two updates of the radius: small, so that a run
/// with targets close to the source ends soon.
constexpr std::size_t RadiusInterval = 64;
/// A child is inserted into the envelope directly if at most this many windows lie beyond it.
constexpr std::ptrdiff_t MostBeyond = 64;
}

void TriangleEngine::Reset()
{
  const auto n = static_cast<std::size_t>(this->Mesh.GetNumberOfVertices());
  const auto halfEdges = static_cast<std::size_t>(this->Mesh.GetNumberOfHalfEdges());
  this->IsOpen.assign(halfEdges / 3, 0);
  this->IsQueued.assign(halfEdges, 0);
  this->IsVisited.assign(n, 0);
  this->Emitted.assign(n, Infinity);
  this->ListOf.assign(halfEdges, NoId);
  this->ResetRun();
}

/// Vertices without a label have not been processed and have opened no faces. Nothing is queued at
/// the end of a run.
void TriangleEngine::ResetReached(const std::vector<Id>& vertices)
{
  if (this->FreeLists.size() != this->Pool.size() || this->Emitted.empty())
  {
    this->Reset(); // a list waits on an edge, or the arrays were released
    return;
  }
  for (const Id v : vertices)
  {
    this->IsVisited[v] = 0;
    this->Emitted[v] = Infinity;
    for (const Id* g = this->Mesh.FanBegin(v); g != this->Mesh.FanEnd(v); ++g)
    {
      this->IsOpen[SurfaceMesh::Face(*g)] = 0;
    }
  }
  this->ResetRun();
}

/// Resets state whose size does not depend on the mesh.
void TriangleEngine::ResetRun()
{
  this->Heap.clear();
  this->Queue.clear();
  this->QueueHead = 0;
  this->Pool.clear();
  this->FreeLists.clear();
  this->Memory.Clear();
  this->NumberOfVisited = 0;
  this->WorkSinceReport = 0;
  this->WorkSinceRadius = 0;
}

void TriangleEngine::Release()
{
  std::vector<WindowList>().swap(this->Pool);
  std::vector<Id>().swap(this->FreeLists);
  std::vector<Id>().swap(this->ListOf);
  std::vector<Id>().swap(this->Queue);
  std::vector<std::pair<double, Id>>().swap(this->Heap);
  std::vector<double>().swap(this->Emitted);
  for (WindowList* list : { &this->Passing, &this->LeftChildren.Envelope,
         &this->LeftChildren.Misplaced, &this->RightChildren.Envelope,
         &this->RightChildren.Misplaced, &this->Merged, &this->Scratch })
  {
    WindowList().swap(*list);
  }
  this->Memory.Clear();
}

void TriangleEngine::LabelDropped(Id v)
{
  this->Heap.emplace_back(this->Label(v), v);
  std::push_heap(this->Heap.begin(), this->Heap.end(), std::greater<std::pair<double, Id>>());
}

void TriangleEngine::Receive(Id h, const Window& window)
{
  Window w = window;
  this->Scratch.clear();
  this->RightChildren.Envelope.clear();
  this->AddChild(w, this->Mesh.Length(h), this->Label(this->Mesh.Origin(h)),
    this->Label(this->Mesh.Destination(h)), this->RightChildren);
  if (!this->RightChildren.Envelope.empty())
  {
    this->Join(h, this->RightChildren.Envelope);
  }
}

bool TriangleEngine::Propagate()
{
  bool shouldContinue = true;
  while (shouldContinue && !this->IsFinished())
  {
    const std::pair<double, Id> top = this->Heap.front();
    std::pop_heap(this->Heap.begin(), this->Heap.end(), std::greater<std::pair<double, Id>>());
    this->Heap.pop_back();
    if (top.first <= this->Label(top.second)) // otherwise the label has been lowered since
    {
      shouldContinue = this->ProcessVertex(top.second);
    }
  }
  return shouldContinue && this->MeasureMemory();
}

/// Returns true if nothing is left within the radius. A window may be nearer than both ends of its
/// edge, so that labels alone do not decide.
bool TriangleEngine::IsFinished() const
{
  return this->Heap.empty() ||
    (this->Heap.front().first > this->GetRadius() && this->FreeLists.size() == this->Pool.size());
}

/// Counts work, and reports progress periodically. Returns false if aborted.
bool TriangleEngine::Report(std::size_t work)
{
  this->WorkSinceReport += work;
  this->WorkSinceRadius += work;
  if (this->WorkSinceRadius >= std::max(RadiusInterval, this->Options->Targets.size()))
  {
    this->WorkSinceRadius = 0;
    this->UpdateRadius();
  }
  if (this->WorkSinceReport < ProgressInterval)
  {
    return true;
  }
  this->WorkSinceReport = 0;
  return this->MeasureMemory() &&
    (!this->Options->Progress ||
      this->Options->Progress(
        static_cast<double>(this->NumberOfVisited) / this->Mesh.GetNumberOfVertices()));
}

bool TriangleEngine::ProcessVertex(Id v)
{
  this->NumberOfVisited += this->IsVisited[v] ? 0 : 1;
  this->RelaxNeighbors(v);
  // Emit once per label, up to rounding.
  if ((this->IsSource(v) || this->Mesh.IsPassThrough(v)) &&
    this->Label(v) * (1.0 + 0.1 * LengthTolerance) < this->Emitted[v] &&
    this->Label(v) <= this->GetRadius())
  {
    this->Emitted[v] = this->Label(v);
    this->EmitIntoShadow(v);
  }
  if (!this->IsVisited[v])
  {
    this->IsVisited[v] = 1;
    this->OpenFacesAround(v);
  }
  for (; this->QueueHead < this->Queue.size(); ++this->QueueHead)
  {
    const Id h = this->Queue[this->QueueHead];
    this->IsQueued[h] = 0;
    if (!this->Report(this->PropagateList(h)))
    {
      return false;
    }
  }
  this->Queue.clear();
  this->QueueHead = 0;
  return this->Report(1);
}

void TriangleEngine::OpenFacesAround(Id v)
{
  for (const Id* g = this->Mesh.FanBegin(v); g != this->Mesh.FanEnd(v); ++g)
  {
    const Id f = SurfaceMesh::Face(*g);
    if (!this->IsOpen[f])
    {
      this->IsOpen[f] = 1;
      for (Id h = 3 * f; h < 3 * f + 3; ++h)
      {
        if (this->ListOf[h] != NoId)
        {
          this->Enqueue(h);
        }
      }
    }
  }
}

void TriangleEngine::Enqueue(Id h)
{
  if (!this->IsQueued[h])
  {
    this->IsQueued[h] = 1;
    this->Queue.push_back(h);
  }
}

/// Returns the number of windows.
std::size_t TriangleEngine::PropagateList(Id h)
{
  const Id slot = this->ListOf[h];
  this->ListOf[h] = NoId;
  this->FreeLists.push_back(slot);
  this->Passing.swap(this->Pool[slot]);
  this->Pool[slot].clear();

  const FaceUnfolding face = EnteredFace(this->Mesh, h).Plane;
  const auto stale = std::remove_if(
    this->Passing.begin(), this->Passing.end(), [&](const Window& w) { return this->IsStale(w); });
  this->Passing.erase(stale, this->Passing.end());
  this->Simplify(h, this->Passing);
  const std::size_t windows = this->Passing.size();
  this->Result->NumberOfWindows += windows;
  if (this->HasTargets(SurfaceMesh::Face(h)))
  {
    for (const Window& w : this->Passing)
    {
      this->OfferTargets(h, w);
    }
  }
  if (this->Store.IsOn())
  {
    this->Store.Add(h, this->Passing);
  }
  this->ReachApex(h, face);
  this->MakeChildren(h, face);
  this->Passing.swap(this->Pool[slot]); // return the storage
  this->Pool[slot].clear();
  this->Deliver(SurfaceMesh::Previous(h), this->LeftChildren.Envelope);
  this->Deliver(SurfaceMesh::Next(h), this->RightChildren.Envelope);
  return windows;
}

/// Updates the label of the apex first, because it trims the children.
void TriangleEngine::ReachApex(Id h, const FaceUnfolding& face)
{
  const Id apex = this->Mesh.Apex(h);
  for (const Window& w : this->Passing)
  {
    const double crossing = Crossing(w.Image, face.GetApex());
    const double tolerance = w.Tolerance(SeenTolerance, face.GetBase());
    if (crossing >= w.Begin - tolerance && crossing <= w.End + tolerance)
    {
      this->Lower(apex, w.DistanceThrough(crossing, face.GetApex()),
        { h, w.Root, w.Image.X, w.Image.Y }, this->SourceOf(w.Root));
    }
  }
}

void TriangleEngine::MakeChildren(Id h, const FaceUnfolding& face)
{
  this->LeftChildren.Envelope.clear();
  this->RightChildren.Envelope.clear();
  const bool hasLeft = this->Mesh.Twin(SurfaceMesh::Previous(h)) != NoId;
  const bool hasRight = this->Mesh.Twin(SurfaceMesh::Next(h)) != NoId;
  const double atOrigin = this->Label(this->Mesh.Origin(h));
  const double atEnd = this->Label(this->Mesh.Destination(h));
  const double atApex = this->Label(this->Mesh.Apex(h));
  Window child;
  for (const Window& w : this->Passing)
  {
    const double crossing = Crossing(w.Image, face.GetApex());
    const bool left = crossing > w.Begin;
    const bool right = crossing < w.End;
    if (left && hasLeft)
    {
      MakeLeftChild(face, w, right, child);
      this->AddChild(child, face.GetLeft(), atOrigin, atApex, this->LeftChildren);
    }
    if (right && hasRight)
    {
      MakeRightChild(face, w, left, child);
      this->AddChild(child, face.GetRight(), atApex, atEnd, this->RightChildren);
    }
  }
  this->AddMisplaced(face.GetLeft(), this->LeftChildren);
  this->AddMisplaced(face.GetRight(), this->RightChildren);
}

void TriangleEngine::AddChild(
  Window& child, double length, double atOrigin, double atEnd, ChildList& list)
{
  if (!child.FacesEdge(length) || child.IsTooNarrow(length) ||
    !TrimByEnds(child, length, atOrigin, atEnd) || child.MinimumDistance() > this->GetRadius())
  {
    return;
  }
  if (!InsertIntoEnvelope(list.Envelope, child, length, this->Scratch, MostBeyond))
  {
    list.Misplaced.push_back(child);
  }
}

void TriangleEngine::AddMisplaced(double length, ChildList& list)
{
  if (!list.Misplaced.empty())
  {
    const Window* begin = list.Misplaced.data();
    const WindowList others = MakeEnvelope(begin, begin + list.Misplaced.size(), length);
    MergeEnvelopes(list.Envelope, others, length, this->Merged);
    list.Envelope.swap(this->Merged);
    list.Misplaced.clear();
  }
}

void TriangleEngine::Deliver(Id exit, WindowList& list)
{
  if (list.empty())
  {
    return;
  }
  if (this->Scatters(exit))
  {
    for (Window& w : list)
    {
      w.HasScattered = true;
    }
  }
  ForEachFaceBehind(this->Mesh, exit, false, [&](Id e, bool isMirrored) {
    if (!isMirrored && !this->Mesh.IsNonManifold(exit))
    {
      this->Join(e, list); // the only face, which may take over the list
      return;
    }
    WindowList copy = list;
    if (isMirrored)
    {
      std::reverse(copy.begin(), copy.end());
      for (Window& w : copy)
      {
        w = Mirrored(w, this->Mesh.Length(e));
      }
    }
    this->Join(e, copy);
  });
}

/// Merges a list into the list that waits on h. May take over its storage.
void TriangleEngine::Join(Id h, WindowList& list)
{
  if (this->Scatters(h))
  {
    this->Memory.KeepNews(h, this->Mesh.Length(h), list);
    if (list.empty())
    {
      return;
    }
  }
  Id& slot = this->ListOf[h];
  if (slot == NoId)
  {
    if (this->FreeLists.empty())
    {
      this->FreeLists.push_back(static_cast<Id>(this->Pool.size()));
      this->Pool.emplace_back();
    }
    slot = this->FreeLists.back();
    this->FreeLists.pop_back();
    this->Pool[slot].swap(list);
  }
  else
  {
    MergeEnvelopes(this->Pool[slot], list, this->Mesh.Length(h), this->Merged);
    this->Pool[slot].swap(this->Merged);
  }
  if (this->IsOpen[SurfaceMesh::Face(h)])
  {
    this->Enqueue(h);
  }
}

/// Updates the memory statistics. Returns false if the limit is exceeded.
bool TriangleEngine::MeasureMemory()
{
  std::size_t windows = 0;
  for (const WindowList& list : this->Pool)
  {
    windows += list.capacity();
  }
  const std::size_t arrays = this->Emitted.size() * (sizeof(double) + sizeof(this->Heap[0])) +
    this->ListOf.size() * (2 * sizeof(Id));
  return this->NoteMemory(windows * sizeof(Window) + arrays + this->Memory.GetMemorySize());
}
}
