// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggExactPath.h"

#include "dggStatus.h"
#include "dggUnfolding.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace dgg
{
namespace
{
/// Tolerance of the length of a path: relative to the distance, and relative to the length of an
/// adjacent edge. The smallest tolerance nearly always suffices; among narrow faces, points that
/// windows reach just beyond their ends require larger ones.
struct LengthTolerance
{
  double Relative;
  double Rounding;
};
constexpr LengthTolerance LengthTolerances[] = { { 1e-12, 4e-15 }, { 5e-11, 4e-15 },
  { 1e-9, 1e-13 }, { 1e-7, 1e-12 } };
/// Points this close together, relative to an adjacent edge, coincide.
constexpr double CoincidenceTolerance = 4e-15;
/// Larger relative errors of labels indicate that the trace is wrong.
constexpr double LabelTolerance = 1e-7;
/// A crossing this close to the end of an edge, relative to the edge length, is at the vertex.
constexpr double VertexTolerance = 1e-13;
/// Tolerance by which a crossing may lie beyond the end of its edge. Windows extend farther beyond
/// their ends (SeenTolerance), but paths bend there.
constexpr double CrossingTolerance = 1e-8;
/// Sine of the angle from the direction of an apex within which a path may pass on either side.
constexpr double ApexTolerance = 1e-9;
/// Rounding error of the position of an image, relative to its distance; relevant for very short
/// edges.
constexpr double SlackTolerance = 1e-13;
/// Maximum number of branches tried: this number per face of the mesh, but at least LeastBranches.
constexpr std::size_t BranchesPerFace = 16;
constexpr std::size_t LeastBranches = 4096;

/// Returns a point of an edge, snapped only within rounding, so that short segments keep their
/// length.
SurfacePoint PointOnEdge(const SurfaceMesh& mesh, Id h, double t)
{
  if (t <= VertexTolerance)
  {
    return SurfacePoint::AtVertex(mesh.Origin(h));
  }
  if (t >= 1.0 - VertexTolerance)
  {
    return SurfacePoint::AtVertex(mesh.Destination(h));
  }
  return SurfacePoint::InsideEdge(h, t);
}

double LongestEdge(const SurfaceMesh& mesh, Id f)
{
  return f == NoId
    ? 0.0
    : std::max(mesh.Length(3 * f), std::max(mesh.Length(3 * f + 1), mesh.Length(3 * f + 2)));
}

template <typename Visitor>
void ForEachFaceOf(const SurfaceMesh& mesh, const SurfacePoint& point, Visitor&& visit)
{
  if (point.On != SurfacePoint::Support::Vertex)
  {
    ForEachFaceAround(mesh, point, visit);
    return;
  }
  for (const Id* g = mesh.FanBegin(point.Vertex); g != mesh.FanEnd(point.Vertex); ++g)
  {
    visit(SurfaceMesh::Face(*g), CoordinatesOfCorner(*g % 3));
  }
}

/// Traces paths back through the faces that their windows have crossed (window tracing, as in
/// Mitchell, Mount and Papadimitriou, "The discrete geodesic problem", 1987).
///
/// A window determines the straight line to its root if the sequence of unfolded faces is known.
/// This is not always the case: a non-manifold edge may have been reached from any other face, and
/// a line that passes through a vertex, up to rounding, may leave it on either side. Then all
/// choices are tried in turn. The length decides: any path whose length equals the distance is a
/// shortest path, no matter from which window.
class WindowTracer
{
public:
  /// `result` must come from a run from one source with initial distance 0.
  WindowTracer(const SurfaceMesh& mesh, const SurfacePoint& source, const ExactResult& result)
    : Mesh(mesh)
    , Source(source)
    , Result(result)
  {
  }

  /// Traces the path from the source to a reached point, given its distance and predecessor.
  /// Returns false if the path cannot be traced back.
  bool Trace(
    const SurfacePoint& target, double distance, const Predecessor& last, SurfacePath& path);

private:
  /// A possible continuation from one face into another.
  struct Branch
  {
    Id Left = NoId;               ///< half-edge of the face that is left
    double X = 0.0;               ///< position of the crossing
    Id Entered = NoId;            ///< half-edge of the face that is entered
    Point2 Image;                 ///< image of the root, in the frame of Entered; Y > 0
    std::size_t PointsBefore = 0; ///< number of path points before the branch
    double LengthSoFar = 0.0;     ///< length of this straight segment so far
  };

  bool TraceBack(const SurfacePoint& target, double distance, const Predecessor& last);
  bool TracePiece(const SurfacePoint& start, double distance, const Predecessor& last, Id& reached);
  void Leave(Id h, const Point2& from, const Point2& image, double lengthSoFar);
  bool Follow(const Branch& branch, Id& reached);
  bool EndInSharedFace(const SurfacePoint& start, Id root);
  bool EndAtCorner(const SurfacePoint& start, Id& reached);
  bool MayEndAt(Id vertex, double lengthSoFar) const;
  bool AgreesWithLabels(Id h, double x, double lengthSoFar) const;
  void Add(const SurfacePoint& point, Id face);

  const SurfaceMesh& Mesh;
  const SurfacePoint& Source;
  const ExactResult& Result;
  std::vector<SurfacePoint> Points; // from the target to the source
  std::vector<Id> Faces;            // faces of the segments
  std::vector<Branch> Branches;     // branches not tried yet
  Id Root = NoId;                   // root of the current segment
  double Distance = 0.0;            // distance at the start of the current segment
  double PieceLength = 0.0;
  double Tolerance = 0.0; // tolerance of lengths
  std::size_t FirstFace = 0;
  double Slack = 0.0; // tolerance of positions, within this segment
};

bool WindowTracer::Trace(
  const SurfacePoint& target, double distance, const Predecessor& last, SurfacePath& path)
{
  path.Clear();
  const double edge = LongestEdge(this->Mesh, FindFaceOf(this->Mesh, target));
  if (distance <= CoincidenceTolerance * edge)
  {
    path.Points.assign(1, target);
    return true;
  }
  for (const LengthTolerance& close : LengthTolerances)
  {
    this->Tolerance = close.Relative * distance + close.Rounding * edge;
    if (this->TraceBack(target, distance, last))
    {
      path.Points.assign(this->Points.rbegin(), this->Points.rend());
      path.Faces.assign(this->Faces.rbegin(), this->Faces.rend());
      path.Points.front() = this->Source;
      for (std::size_t piece = 0; piece < path.Faces.size(); ++piece)
      {
        path.Length += MeasurePiece(this->Mesh, path, piece);
      }
      return std::abs(path.Length - distance) <=
        2.0 * (LengthTolerances[3].Relative * distance + LengthTolerances[3].Rounding * edge);
    }
  }
  return false;
}

bool WindowTracer::TraceBack(const SurfacePoint& target, double distance, const Predecessor& last)
{
  this->Points.assign(1, target);
  this->Faces.clear();
  SurfacePoint start = target;
  double startDistance = distance;
  Predecessor way = last;
  Id reached = NoId;
  do
  {
    if (!this->TracePiece(start, startDistance, way, reached))
    {
      return false;
    }
    if (reached >= 0)
    {
      start = SurfacePoint::AtVertex(reached);
      startDistance = this->Result.Distances[reached];
      way = this->Result.Predecessors[reached];
    }
  } while (reached >= 0 && way.Root != reached);
  return true;
}

/// Traces one straight segment; `reached` receives its start, a vertex or ~0 for the source.
bool WindowTracer::TracePiece(
  const SurfacePoint& start, double distance, const Predecessor& last, Id& reached)
{
  this->Root = last.Root;
  this->Distance = distance;
  if (last.HalfEdge == NoId)
  {
    reached = last.Root;
    return this->EndInSharedFace(start, last.Root);
  }
  std::array<double, 3> barycentric{};
  if (!FindInFace(this->Mesh, start, SurfaceMesh::Face(last.HalfEdge), barycentric))
  {
    return false;
  }
  const Point2 from = PlaceInFrame(this->Mesh, last.HalfEdge, barycentric);
  const Point2 image{ last.ImageX, last.ImageY };
  this->PieceLength = dgg::Distance(from, image);
  this->Slack = SlackTolerance * this->PieceLength + 4.0 * this->Mesh.GetMollification();
  this->FirstFace = this->Faces.size();
  const std::size_t points = this->Points.size();
  this->Branches.clear();
  this->Leave(last.HalfEdge, from, image, 0.0);
  std::size_t budget = std::max(
    LeastBranches, BranchesPerFace * static_cast<std::size_t>(this->Mesh.GetNumberOfFaces()));
  for (; !this->Branches.empty() && budget > 0; --budget)
  {
    const Branch branch = this->Branches.back();
    this->Branches.pop_back();
    this->Points.resize(branch.PointsBefore);
    this->Faces.resize(branch.PointsBefore - 1);
    if (this->Follow(branch, reached))
    {
      return true;
    }
  }
  this->Points.resize(points);
  this->Faces.resize(points - 1);
  return this->EndAtCorner(start, reached);
}

/// Leaves the face of h through h, from a point of the face towards the image: adds one branch for
/// each face behind.
void WindowTracer::Leave(Id h, const Point2& from, const Point2& image, double lengthSoFar)
{
  const double length = this->Mesh.Length(h);
  if (image.Y >= 0.0 || from.Y < 0.0)
  {
    return; // not on the path
  }
  // Computed from the point, not from the image, which may be far away.
  const double crossing = from.X + (image.X - from.X) * (from.Y / (from.Y - image.Y));
  const double beyond = CrossingTolerance * length + this->Slack;
  if (!(crossing >= -beyond && crossing <= length + beyond))
  {
    return;
  }
  Branch branch;
  branch.Left = h;
  branch.X = std::min(std::max(crossing, 0.0), length);
  branch.PointsBefore = this->Points.size();
  branch.LengthSoFar = lengthSoFar + Norm(branch.X - from.X, from.Y);
  if (!this->AgreesWithLabels(h, branch.X, branch.LengthSoFar))
  {
    return;
  }
  const bool choice = this->Mesh.IsNonManifold(h);
  ForEachFaceBehind(this->Mesh, h, false, [&](Id e, bool isMirrored) {
    // A shortest path does not return to a face.
    if (!choice ||
      std::find(this->Faces.begin() + static_cast<std::ptrdiff_t>(this->FirstFace),
        this->Faces.end(), SurfaceMesh::Face(e)) == this->Faces.end())
    {
      branch.Entered = e;
      branch.Image = { isMirrored ? image.X : length - image.X, -image.Y };
      this->Branches.push_back(branch);
    }
  });
}

/// Crosses one more face. Returns true if the segment ends there.
bool WindowTracer::Follow(const Branch& branch, Id& reached)
{
  const Id e = branch.Entered;
  const double length = this->Mesh.Length(e);
  if (branch.LengthSoFar > 0.0) // otherwise the segment starts on the edge
  {
    const SurfacePoint point = PointOnEdge(this->Mesh, branch.Left, branch.X / length);
    this->Add(point, SurfaceMesh::Face(branch.Left));
    if (point.On == SurfacePoint::Support::Vertex &&
      this->MayEndAt(point.Vertex, branch.LengthSoFar))
    {
      reached = point.Vertex;
      return true;
    }
  }
  const Id f = SurfaceMesh::Face(e);
  const bool against = this->Mesh.Origin(e) == this->Mesh.Destination(branch.Left);
  const Point2 from{ against ? length - branch.X : branch.X, 0.0 };
  const FaceUnfolding face = EnteredFace(this->Mesh, e).Plane;
  const Point2& apex = face.GetApex();
  std::array<double, 3> barycentric{};
  if (this->Root < 0 && FindInFace(this->Mesh, this->Source, f, barycentric))
  {
    const Point2 source = PlaceInFrame(this->Mesh, e, barycentric);
    if (branch.LengthSoFar + dgg::Distance(from, source) <= this->PieceLength + this->Tolerance)
    {
      this->Add(this->Source, f);
      reached = this->Root;
      return true;
    }
  }
  const double toApex = dgg::Distance(from, apex);
  if (this->MayEndAt(this->Mesh.Apex(e), branch.LengthSoFar + toApex))
  {
    reached = this->Mesh.Apex(e);
    this->Add(SurfacePoint::AtVertex(reached), f);
    return true;
  }

  const Point2 toImage{ branch.Image.X - from.X, branch.Image.Y };
  const double sine = dgg::Cross({ apex.X - from.X, apex.Y }, toImage);
  const double band = (ApexTolerance * toApex + this->Slack) * Norm(toImage.X, toImage.Y);
  // In the frames of the unfolding the face lies below the axis.
  auto leaveLeft = [&]() {
    const Point2 p = face.ImageInLeft(from);
    const Point2 image = face.ImageInLeft(branch.Image);
    this->Leave(SurfaceMesh::Previous(e), { face.GetLeft() - p.X, -p.Y },
      { face.GetLeft() - image.X, -image.Y }, branch.LengthSoFar);
  };
  auto leaveRight = [&]() {
    const Point2 p = face.ImageInRight(from);
    const Point2 image = face.ImageInRight(branch.Image);
    this->Leave(SurfaceMesh::Next(e), { face.GetRight() - p.X, -p.Y },
      { face.GetRight() - image.X, -image.Y }, branch.LengthSoFar);
  };
  // The more likely branch is pushed last, because it is tried first.
  if (sine > 0.0)
  {
    if (sine <= band)
    {
      leaveRight();
    }
    leaveLeft();
  }
  else
  {
    if (sine >= -band)
    {
      leaveLeft();
    }
    leaveRight();
  }
  return false;
}

/// Ends with a segment within one face: along a mesh edge, or between points of the face.
bool WindowTracer::EndInSharedFace(const SurfacePoint& start, Id root)
{
  const SurfacePoint end = root >= 0 ? SurfacePoint::AtVertex(root) : this->Source;
  Id best = NoId;
  double shortest = Infinity;
  ForEachFaceOf(this->Mesh, start, [&](Id f, const std::array<double, 3>& p) {
    std::array<double, 3> q{};
    if (FindInFace(this->Mesh, end, f, q))
    {
      const double length = DistanceInFace(this->Mesh, f, p, q);
      if (length < shortest)
      {
        shortest = length;
        best = f;
      }
    }
  });
  if (best == NoId)
  {
    return false;
  }
  this->Add(end, best);
  return true;
}

/// Ends the segment at a corner of a face that contains its start, if that path is equally short.
/// Last resort if the path of a window is lost among degenerate faces.
bool WindowTracer::EndAtCorner(const SurfacePoint& start, Id& reached)
{
  Id best = NoId;
  double shortest = Infinity;
  ForEachFaceOf(this->Mesh, start, [&](Id f, const std::array<double, 3>& b) {
    for (int k = 0; k < 3; ++k)
    {
      const Id corner = this->Mesh.Origin(3 * f + k);
      const double length = DistanceToCorner(this->Mesh, f, b, k);
      if (this->MayEndAt(corner, length) && this->Result.Distances[corner] + length < shortest)
      {
        shortest = this->Result.Distances[corner] + length;
        best = corner;
      }
    }
  });
  reached = best;
  return best != NoId && this->EndInSharedFace(start, best);
}

/// Returns true if the path through a vertex is as short as the straight line. This always holds at
/// the root; elsewhere labels must decrease, otherwise the path could return.
bool WindowTracer::MayEndAt(Id vertex, double lengthSoFar) const
{
  const double label = this->Result.Distances[vertex];
  return label + lengthSoFar <= this->Distance + this->Tolerance &&
    (vertex == this->Root || label < this->Distance);
}

/// Returns true if the distance at a point of h, assuming that the path runs through the point, is
/// consistent with the labels of the ends. An inconsistency shows that the trace is wrong.
bool WindowTracer::AgreesWithLabels(Id h, double x, double lengthSoFar) const
{
  const double here = this->Distance - lengthSoFar;
  const double slack = LabelTolerance * this->Distance;
  auto agrees = [&](double label, double away) {
    // Labels beyond the last target have been discarded.
    return here <= label + away + slack && (label == Infinity || label <= here + away + slack);
  };
  return agrees(this->Result.Distances[this->Mesh.Origin(h)], x) &&
    agrees(this->Result.Distances[this->Mesh.Destination(h)], this->Mesh.Length(h) - x);
}

void WindowTracer::Add(const SurfacePoint& point, Id face)
{
  const SurfacePoint& last = this->Points.back();
  if (point.On == SurfacePoint::Support::Vertex && last.On == SurfacePoint::Support::Vertex &&
    point.Vertex == last.Vertex)
  {
    return; // around a vertex
  }
  this->Points.push_back(point);
  this->Faces.push_back(face);
}
}

//------------------------------------------------------------------------------
ExactPathFinder::ExactPathFinder(const SurfaceMesh& mesh)
  : Mesh(mesh)
  , Fitness(CheckCorners(mesh))
  , Solver(std::make_unique<ExactGeodesics>(mesh))
{
}

ExactPathFinder::~ExactPathFinder() = default;

std::size_t ExactPathFinder::GetMemorySize() const
{
  const ExactResult& kept = this->Solver->GetKept();
  return this->MemorySize + kept.Distances.capacity() * sizeof(double) +
    kept.NearestSource.capacity() * sizeof(Id) + kept.Predecessors.capacity() * sizeof(Predecessor);
}

Status ExactPathFinder::Find(const SurfacePoint& from, const std::vector<SurfacePoint>& to,
  const ProgressCallback& progress, std::vector<SurfacePath>& paths, double maximumDistance)
{
  paths.clear();
  this->NumberOfWindows = 0;
  if (!this->Fitness.IsOk())
  {
    return this->Fitness;
  }
  ExactOptions options;
  options.Targets = to;
  options.StopAtTargets = true;
  options.MaximumDistance = maximumDistance;
  options.Progress = progress;
  Status status = this->Solver->RunKept({ { from, 0.0 } }, options);
  const ExactResult& result = this->Solver->GetKept();
  this->MemorySize = std::max(this->MemorySize, result.PeakMemory);
  if (!status.IsOk())
  {
    return status;
  }
  this->NumberOfWindows = result.NumberOfWindows;
  paths.resize(to.size());
  WindowTracer tracer(this->Mesh, from, result);
  for (std::size_t t = 0; t < to.size(); ++t)
  {
    const double distance = result.TargetDistances[t];
    if (distance < Infinity &&
      !tracer.Trace(to[t], distance, result.TargetPredecessors[t], paths[t]))
    {
      paths.clear();
      return InvalidInput("The path to target ", t, ", at distance ", distance,
        ", cannot be traced: the faces that it crosses are too narrow")
        .Fix("Improve these faces");
    }
  }
  return Status::Success();
}
}
