// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggReferenceEngine.h"

#include <algorithm>
#include <cmath>

namespace dgg
{
namespace
{
/// Two rays to an apex coincide if they cross the half-edge this close together, relative to its
/// length.
constexpr double CoincidenceTolerance = 1e-9;
constexpr std::size_t ProgressInterval = 4096;
}

void ReferenceEngine::Reset()
{
  this->Windows = {};
  this->Vertices = {};
  this->Memory.Clear();
  this->Winners.assign(this->Mesh.GetNumberOfHalfEdges(), Winner());
  this->Emitted.assign(this->Mesh.GetNumberOfVertices(), Infinity);
}

void ReferenceEngine::Release()
{
  this->Windows = {};
  this->Vertices = {};
  this->Memory.Clear();
  std::vector<Winner>().swap(this->Winners);
  std::vector<double>().swap(this->Emitted);
}

void ReferenceEngine::LabelDropped(Id v)
{
  this->Vertices.push({ this->Label(v), v });
}

/// Window filter: returns true if the path through an end of the half-edge and along it is at least
/// as short at every point of the interval, or if nothing behind it can be within the radius.
bool ReferenceEngine::IsUseless(Id h, const Window& w) const
{
  const double length = this->Mesh.Length(h);
  return w.IsTooNarrow(length) ||
    this->Label(this->Mesh.Origin(h)) + w.End <= w.DistanceAtEnd * (1.0 - LengthTolerance) ||
    this->Label(this->Mesh.Destination(h)) + (length - w.Begin) <=
    w.DistanceAtBegin * (1.0 - LengthTolerance) ||
    w.MinimumDistance() > this->GetRadius();
}

void ReferenceEngine::Receive(Id h, const Window& window)
{
  Window received = window;
  if (received.FacesEdge(this->Mesh.Length(h)) && !this->IsUseless(h, received))
  {
    this->Windows.push({ received.MinimumDistance(), h, received });
  }
}

bool ReferenceEngine::Propagate()
{
  const Id n = this->Mesh.GetNumberOfVertices();
  std::size_t steps = 0;
  while (!this->Windows.empty() || !this->Vertices.empty())
  {
    if (++steps % ProgressInterval == 0)
    {
      this->UpdateRadius();
      if (this->Options->Progress)
      {
        // Windows are processed in order of distance, so that processed vertices are final.
        const auto done = std::count_if(this->Emitted.begin(), this->Emitted.end(),
          [](double label) { return label < Infinity; });
        if (!this->Options->Progress(static_cast<double>(done) / n))
        {
          return false;
        }
      }
    }
    if (!this->Vertices.empty() &&
      (this->Windows.empty() || this->Vertices.top().Key <= this->Windows.top().Key))
    {
      const QueuedVertex queued = this->Vertices.top();
      this->Vertices.pop();
      this->ProcessVertex(queued);
    }
    else
    {
      const QueuedWindow queued = this->Windows.top();
      this->Windows.pop();
      if (!this->IsStale(queued.Passing) && !this->IsUseless(queued.HalfEdge, queued.Passing))
      {
        this->ProcessNews(queued.HalfEdge, queued.Passing);
      }
    }
    if (!this->NoteMemory(this->Windows.size() * sizeof(QueuedWindow) +
          this->Vertices.size() * sizeof(QueuedVertex) + this->Winners.size() * sizeof(Winner) +
          this->Emitted.size() * sizeof(double)))
    {
      return false;
    }
  }
  return true;
}

/// Processes the new parts of a window if earlier windows are remembered (WindowMemory); otherwise
/// the entire window.
void ReferenceEngine::ProcessNews(Id h, const Window& w)
{
  if (!this->Scatters(h))
  {
    this->ProcessWindow(h, w);
    return;
  }
  this->News.assign(1, w);
  this->Memory.KeepNews(h, this->Mesh.Length(h), this->News);
  for (const Window& piece : this->News)
  {
    this->ProcessWindow(h, piece);
  }
}

void ReferenceEngine::ProcessVertex(const QueuedVertex& queued)
{
  const Id v = queued.Vertex;
  const double label = this->Label(v);
  // Emit once per label, up to rounding.
  if (queued.Key != label || this->Emitted[v] <= label * (1.0 + 0.1 * LengthTolerance) ||
    label > this->GetRadius())
  {
    return;
  }
  this->Emitted[v] = label;
  this->RelaxNeighbors(v);
  if (this->IsSource(v) || this->Mesh.IsPassThrough(v))
  {
    this->EmitEverywhere(v);
  }
}

void ReferenceEngine::ProcessWindow(Id h, const Window& w)
{
  ++this->Result->NumberOfWindows;
  if (this->Store.IsOn())
  {
    this->Store.Add(h, w);
  }
  if (this->HasTargets(SurfaceMesh::Face(h)))
  {
    this->OfferTargets(h, w);
  }
  const FaceUnfolding face = EnteredFace(this->Mesh, h).Plane;
  const double crossing = Crossing(w.Image, face.GetApex());
  // Only split windows have seams with vertices on them (ProcessNews); elsewhere flat vertices emit
  // again.
  const bool mayBePiece = w.HasScattered || this->Scatters(h);
  const double tolerance = mayBePiece ? w.Tolerance(SeenTolerance, face.GetBase()) : 0.0;
  if (crossing >= w.Begin - tolerance && crossing <= w.End + tolerance)
  {
    this->Lower(this->Mesh.Apex(h), w.DistanceThrough(crossing, face.GetApex()),
      { h, w.Root, w.Image.X, w.Image.Y }, this->SourceOf(w.Root));
  }
  bool left = crossing > w.Begin;
  bool right = crossing < w.End;
  const bool straddles = left && right;
  if (straddles)
  {
    this->DecideChildren(h, w, crossing, left, right);
  }
  Window child;
  if (left)
  {
    MakeLeftChild(face, w, straddles, child);
    this->Cross(SurfaceMesh::Previous(h), child);
  }
  if (right)
  {
    MakeRightChild(face, w, straddles, child);
    this->Cross(SurfaceMesh::Next(h), child);
  }
}

/// The Chen-Han rule: of all windows that reach an apex through a half-edge, only the one that is
/// shortest there has two children. A loser keeps the child on its own side of the winner's ray,
/// because the winner's path, followed back, would have to cross the loser's rays to the other
/// side. Not applied
/// - if the rays coincide: the winner may be a pseudo-source exactly on the loser's ray;
/// - if the winner is rooted inside a face or on an edge: that root can lie inside the loser's
///   cone;
/// - if either has scattered: across a non-manifold edge they may have come through different
///   layers, so that their paths need not cross.
void ReferenceEngine::DecideChildren(
  Id h, const Window& w, double crossing, bool& left, bool& right)
{
  const double distance = w.DistanceTo(ApexOf(this->Mesh, h));
  Winner& winner = this->Winners[h];
  if (distance < winner.Distance)
  {
    winner = { distance, crossing, w.Root >= 0 && !w.HasScattered };
  }
  else if (distance > winner.Distance * (1.0 + LengthTolerance) && winner.Rules &&
    !w.HasScattered &&
    std::abs(crossing - winner.Crossing) > CoincidenceTolerance * this->Mesh.Length(h))
  {
    left = crossing < winner.Crossing;
    right = !left;
  }
}
}
