// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggWindowPropagation.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace dgg
{
namespace
{
/// Directions this close to the border of a shadow count as inside, radians: larger than rounding
/// errors of angles, and smaller than the angle of a separate window (PieceTolerance of the
/// envelopes). With 1e-6, half of all windows were overlaps of this kind.
constexpr double ShadowSlack = 1e-10;
/// A manifold mesh of n faces requires 0.2 n^1.5 windows, as measured on finely divided spheres. A
/// mesh whose windows scatter may require about twenty times as many; a mesh of long strips without
/// interior points, where each vertex sees all faces, a hundred times, but these windows are cheap.
constexpr double MostScattered =
  4.4; // windows per face, divided by the root of the number of faces
constexpr double MostOnManifold = 20.0;
constexpr double FewWindows = 1e6; // always allowed, because they take little time

std::size_t LimitWindows(const SurfaceMesh& mesh)
{
  bool scatters = mesh.GetNumberOfDegenerateFaces() > 0;
  for (Id h = 0; h < mesh.GetNumberOfHalfEdges() && !scatters; ++h)
  {
    scatters = mesh.IsNonManifold(h);
  }
  const double faces = mesh.GetNumberOfFaces();
  const double most = (scatters ? MostScattered : MostOnManifold) * faces * std::sqrt(faces);
  return static_cast<std::size_t>(std::max(FewWindows, most));
}

/// Finds the sources of a face that are nearest nowhere in the face. Among sources with equal
/// initial distances only duplicates are dominated, which makes thousands of them cheap.
void FindDominated(
  const SurfaceMesh& mesh, const FaceSource* begin, const FaceSource* end, std::vector<bool>& found)
{
  const auto count = static_cast<std::size_t>(end - begin);
  found.assign(count, false);
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
    return begin[i].Offset != begin[j].Offset ? begin[i].Offset < begin[j].Offset
                                              : begin[i].Barycentric < begin[j].Barycentric;
  });
  std::vector<std::size_t> kept;
  for (const std::size_t i : order)
  {
    const FaceSource& source = begin[i];
    found[i] = !kept.empty() && begin[kept.back()].Offset == source.Offset &&
      begin[kept.back()].Barycentric == source.Barycentric;
    for (std::size_t k = 0; k < kept.size() && !found[i]; ++k)
    {
      const FaceSource& other = begin[kept[k]];
      if (!(other.Offset < source.Offset))
      {
        break;
      }
      found[i] = source.Offset >=
        other.Offset + DistanceInFace(mesh, source.Face, other.Barycentric, source.Barycentric);
    }
    if (!found[i])
    {
      kept.push_back(i);
    }
  }
}

/// Removes sources, sorted by face, that are nearest nowhere in their face.
void DropDominated(const SurfaceMesh& mesh, std::vector<FaceSource>& sources)
{
  std::vector<bool> isDominated;
  std::size_t size = 0;
  for (std::size_t begin = 0; begin < sources.size();)
  {
    std::size_t end = begin + 1;
    while (end < sources.size() && sources[end].Face == sources[begin].Face)
    {
      ++end;
    }
    FindDominated(mesh, sources.data() + begin, sources.data() + end, isDominated);
    for (std::size_t i = begin; i < end; ++i)
    {
      if (!isDominated[i - begin])
      {
        sources[size++] = sources[i];
      }
    }
    begin = end;
  }
  sources.resize(size);
}

Status CheckOptions(const SurfaceMesh& mesh, const ExactOptions& options)
{
  if (std::isnan(options.MaximumDistance))
  {
    return InvalidValue("MaximumDistance", options.MaximumDistance).Fix("Use a number or infinity");
  }
  if (options.KeepWindows && options.StopAtTargets)
  {
    return InvalidInput("Windows cannot be kept if the run stops at targets")
      .Fix("Turn off KeepWindows or StopAtTargets");
  }
  for (std::size_t t = 0; t < options.Targets.size(); ++t)
  {
    DGG_RETURN_IF_ERROR(options.Targets[t].Check(mesh).Of(JoinText("Target ", t)));
  }
  return Status::Success();
}
}

WindowPropagation::WindowPropagation(const SurfaceMesh& mesh)
  : Mesh(mesh)
  , Store(mesh)
  , MostWindows(LimitWindows(mesh))
{
}

Status WindowPropagation::Run(const std::vector<GeodesicSource>& sources,
  const ExactOptions& options, ExactResult& result, bool isAgain)
{
  const bool isLocal = isAgain && this->KnowsReached;
  this->KnowsReached = false; // until the run has succeeded
  this->NotesReached = isAgain;
  if (!isLocal)
  {
    result = ExactResult();
  }
  Status status = CheckSources(this->Mesh, sources);
  status = status.IsOk() ? CheckOptions(this->Mesh, options) : status;
  if (!status.IsOk())
  {
    result = ExactResult();
    return status;
  }

  // Labels must not be negative, because tolerances are relative; therefore negative initial
  // distances shift the origin.
  double shift = Infinity;
  for (const GeodesicSource& source : sources)
  {
    shift = std::min(shift, source.InitialDistance);
  }
  std::vector<GeodesicSource> shifted = sources;
  for (GeodesicSource& source : shifted)
  {
    source.InitialDistance -= shift;
  }

  this->Options = &options;
  this->Result = &result;
  this->Radius = options.MaximumDistance - shift;
  this->IsOutOfMemory = false;
  this->HasExceededLimit = false;

  this->Store.Start(options.KeepWindows);
  this->ResetResult(isLocal);
  if (isLocal)
  {
    this->ResetReached(this->Reached);
  }
  else
  {
    this->Reset();
  }
  this->Reached.clear();
  this->RegisterTargets();
  this->Start(shifted);
  const bool finished = this->Propagate() && this->FinishWindows(shifted, shift);
  if (finished)
  {
    this->FinishTargets();
    this->ForgetBeyondRadius();
    this->ForEachReached([&](std::size_t v) { result.Distances[v] += shift; });
    for (double& d : result.TargetDistances)
    {
      d += shift;
    }
  }
  this->Store.Start(false);
  this->Result = nullptr;
  this->Options = nullptr;
  if (!finished)
  {
    result = ExactResult();
    if (this->IsOutOfMemory)
    {
      this->Release();
      return Status(Status::Code::OutOfMemory,
        JoinText("The propagation of windows needs more memory than the limit of ",
          options.MemoryLimit, " bytes"))
        .At("MemoryLimit")
        .Fix("Use fewer points, set a smaller {MaximumDistance}, turn off {GenerateWindows}, or "
             "raise {MemoryLimit}");
    }
    return this->HasExceededLimit
      ? InvalidInput("The windows multiply among non-manifold edges or long triangles of little "
                     "area, far beyond those of a clean mesh of this size")
          .Fix("Remove inner walls, duplicate faces and such triangles, or set a smaller "
               "{MaximumDistance}")
      : Status::Abort();
  }
  this->KnowsReached = isAgain;
  return Status::Success();
}

/// Resets the result to unreached. If `isLocal`, only entries that the last run has reached are
/// reset.
void WindowPropagation::ResetResult(bool isLocal)
{
  ExactResult& result = *this->Result;
  if (isLocal)
  {
    for (const Id v : this->Reached)
    {
      result.Distances[v] = Infinity;
      result.NearestSource[v] = NoId;
      result.Predecessors[v] = Predecessor();
    }
    result.Windows = EdgeWindows();
    result.NumberOfWindows = 0;
    result.PeakMemory = 0;
  }
  else
  {
    const auto n = static_cast<std::size_t>(this->Mesh.GetNumberOfVertices());
    result.Distances.assign(n, Infinity);
    result.NearestSource.assign(n, NoId);
    result.Predecessors.assign(n, Predecessor());
  }
  const std::size_t targets = this->Options->Targets.size();
  result.TargetDistances.assign(targets, Infinity);
  result.TargetNearestSource.assign(targets, NoId);
  result.TargetPredecessors.assign(targets, Predecessor());
}

/// Calls `visit(v)` for all vertices that may have a label.
template <typename Function>
void WindowPropagation::ForEachReached(Function&& visit) const
{
  if (this->NotesReached)
  {
    std::for_each(this->Reached.begin(), this->Reached.end(), visit);
    return;
  }
  for (std::size_t v = 0; v < this->Result->Distances.size(); ++v)
  {
    visit(v);
  }
}

bool WindowPropagation::Lower(Id v, double distance, const Predecessor& predecessor, Id source)
{
  double& label = this->Result->Distances[v];
  if (!(distance < label))
  {
    return false;
  }
  if (this->NotesReached && label == Infinity)
  {
    this->Reached.push_back(v);
  }
  label = distance;
  this->Result->Predecessors[v] = predecessor;
  this->Result->NearestSource[v] = source;
  this->LabelDropped(v);
  return true;
}

void WindowPropagation::RelaxNeighbors(Id v)
{
  const double label = this->Label(v);
  const Id source = this->Result->NearestSource[v];
  const Predecessor along{ NoId, v, 0.0, 0.0 };
  for (const Id* g = this->Mesh.FanBegin(v); g != this->Mesh.FanEnd(v); ++g)
  {
    this->Lower(this->Mesh.Destination(*g), label + this->Mesh.Length(*g), along, source);
    const Id incoming = SurfaceMesh::Previous(*g);
    this->Lower(this->Mesh.Origin(incoming), label + this->Mesh.Length(incoming), along, source);
  }
}

void WindowPropagation::EmitEverywhere(Id v)
{
  const double sigma = this->Label(v);
  for (const Id* g = this->Mesh.FanBegin(v); g != this->Mesh.FanEnd(v); ++g)
  {
    this->EmitInto(*g, sigma, 0.0, 2.0 * Pi);
  }
}

void WindowPropagation::EmitIntoShadow(Id v)
{
  double incoming = 0.0;
  if (this->IsSource(v) || this->Mesh.Kind(v) == VertexKind::Irregular ||
    !this->FindIncomingAngle(v, incoming))
  {
    this->EmitEverywhere(v);
    return;
  }
  const double sigma = this->Label(v);
  const double total = this->Mesh.TotalAngle(v);
  const bool boundary = this->Mesh.Kind(v) == VertexKind::Boundary;
  // The shadow is the range of directions [begin, begin + width], angles measured from `origin`.
  const double begin = incoming + Pi - ShadowSlack;
  const double width = total - 2.0 * Pi + 2.0 * ShadowSlack;
  for (const Id* g = this->Mesh.FanBegin(v); g != this->Mesh.FanEnd(v); ++g)
  {
    const double angle = this->Mesh.PolarAngle(*g);
    const double corner = this->Mesh.CornerAngle(*g);
    if (boundary)
    {
      // No path leads around the vertex outside the surface: both ends of the range of directions
      // are open.
      this->EmitInto(*g, sigma, begin - angle, corner);
      this->EmitInto(*g, sigma, 0.0, incoming - Pi + ShadowSlack - angle);
      continue;
    }
    // The shadow may begin before this corner or, one turn further, inside the corner.
    double before = std::fmod(begin - angle, total);
    before -= before > 0.0 ? total : 0.0; // in (-total, 0]
    this->EmitInto(*g, sigma, before, before + width);
    this->EmitInto(*g, sigma, before + total, before + total + width);
  }
}

bool WindowPropagation::FindIncomingAngle(Id v, double& angle) const
{
  const Predecessor& p = this->Result->Predecessors[v];
  if (p.HalfEdge != NoId)
  {
    const Point2 back = Difference({ p.ImageX, p.ImageY }, ApexOf(this->Mesh, p.HalfEdge));
    angle = PolarAngleAtApex(this->Mesh, p.HalfEdge, back);
    // False if the path bends at the end of a window, see Window::DistanceThrough().
    return p.Root < 0 ||
      !(this->Label(v) > (this->Label(p.Root) + Norm(back.X, back.Y)) * (1.0 + LengthTolerance));
  }
  if (p.Root < 0)
  {
    return false;
  }
  // Along a mesh edge.
  int matches = 0;
  for (const Id* g = this->Mesh.FanBegin(v); g != this->Mesh.FanEnd(v); ++g)
  {
    const Id incoming = SurfaceMesh::Previous(*g);
    if (this->Mesh.Destination(*g) == p.Root)
    {
      angle = this->Mesh.PolarAngle(*g);
      ++matches;
    }
    else if (this->Mesh.Twin(incoming) == NoId && this->Mesh.Origin(incoming) == p.Root)
    {
      angle = this->Mesh.TotalAngle(v);
      ++matches;
    }
  }
  return matches == 1;
}

void WindowPropagation::EmitInto(Id g, double sigma, double from, double to)
{
  const double corner = this->Mesh.CornerAngle(g);
  if (to <= 0.0 || from >= corner || from >= to)
  {
    return;
  }
  const Id exit = SurfaceMesh::Next(g);
  const double length = this->Mesh.Length(exit);
  // Intersection of the direction `angle` with the edge, as a fraction from its origin; in the
  // frame of g.
  const double reach = this->Mesh.Length(g);
  auto meet = [&](double angle) {
    const double bx = this->Mesh.ApexX(g);
    const double by = this->Mesh.ApexY(g);
    const double sine = std::sin(angle);
    return sine * reach / (std::cos(angle) * by - sine * (bx - reach));
  };
  // Very close to the edge, the rounding error of a position on the edge exceeds ShadowSlack.
  const double first =
    from <= 0.0 ? 0.0 : std::min(1.0, std::max(0.0, meet(from) - PositionRounding));
  const double last =
    to >= corner ? 1.0 : std::min(1.0, std::max(0.0, meet(to) + PositionRounding));
  Window window;
  // In the frame of the other side of the edge. Not length - ApexX(exit), which is inaccurate for
  // needles.
  window.Image = { FootOnEdge(length, this->Mesh.Length(SurfaceMesh::Next(exit)), reach),
    -this->Mesh.ApexY(exit) };
  window.Sigma = sigma;
  window.Root = this->Mesh.Origin(g);
  window.SetInterval(length * (1.0 - last), length * (1.0 - first));
  if (!window.IsTooNarrow(length))
  {
    this->Cross(exit, window);
  }
}

Window WindowPropagation::Mirrored(const Window& window, double length)
{
  Window mirrored = window;
  mirrored.Begin = length - window.End;
  mirrored.End = length - window.Begin;
  mirrored.Image.X = length - window.Image.X;
  std::swap(mirrored.DistanceAtBegin, mirrored.DistanceAtEnd);
  return mirrored;
}

void WindowPropagation::Start(const std::vector<GeodesicSource>& sources)
{
  for (std::size_t k = 0; k < sources.size(); ++k)
  {
    const SurfacePoint& point = sources[k].Point;
    const double offset = sources[k].InitialDistance;
    const Id source = static_cast<Id>(k);
    if (point.On == SurfacePoint::Support::Vertex)
    {
      this->Lower(point.Vertex, offset, { NoId, point.Vertex, 0.0, 0.0 }, source);
      continue;
    }
    ForEachFaceAround(this->Mesh, point,
      [&](Id f, const std::array<double, 3>& b) { this->StartInFace(f, b, offset, source); });
  }
}

void WindowPropagation::StartInFace(Id f, const std::array<double, 3>& b, double offset, Id source)
{
  for (int k = 0; k < 3; ++k)
  {
    const Id h = 3 * f + k;
    this->Lower(this->Mesh.Origin(h), offset + DistanceToCorner(this->Mesh, f, b, k),
      { NoId, ~source, 0.0, 0.0 }, source);
    const Point2 position = PlaceInFrame(this->Mesh, h, b);
    if (b[(k + 2) % 3] == 0.0)
    {
      continue; // the source lies on this edge
    }
    const double length = this->Mesh.Length(h);
    Window window;
    window.Image = { length - position.X, -position.Y };
    window.Sigma = offset;
    window.Root = ~source;
    window.SetInterval(0.0, length);
    this->Cross(h, window);
  }
  // Targets in the same face are reached directly.
  if (this->HasTargets(f))
  {
    for (const Target& target : this->Targets)
    {
      if (target.Face == f)
      {
        this->ReachTarget(target.Index,
          offset + DistanceInFace(this->Mesh, f, b, target.Barycentric),
          { NoId, ~source, 0.0, 0.0 }, source);
      }
    }
  }
}

void WindowPropagation::RegisterTargets()
{
  for (const Target& target : this->Targets) // targets of the last run
  {
    this->TargetFlags[target.Face] = 0;
  }
  this->Targets.clear();
  const std::vector<SurfacePoint>& points = this->Options->Targets;
  for (std::size_t t = 0; t < points.size(); ++t)
  {
    if (points[t].On != SurfacePoint::Support::Vertex)
    {
      this->TargetFlags.resize(this->Mesh.GetNumberOfFaces(), 0);
      ForEachFaceAround(this->Mesh, points[t], [&](Id f, const std::array<double, 3>& b) {
        this->Targets.push_back({ f, t, b });
        this->TargetFlags[f] = 1;
      });
    }
  }
  std::sort(this->Targets.begin(), this->Targets.end(), [](const Target& a, const Target& b) {
    return a.Face != b.Face ? a.Face < b.Face : a.Index < b.Index;
  });
}

void WindowPropagation::ReachTarget(
  std::size_t index, double distance, const Predecessor& predecessor, Id source)
{
  if (distance < this->Result->TargetDistances[index])
  {
    this->Result->TargetDistances[index] = distance;
    this->Result->TargetNearestSource[index] = source;
    this->Result->TargetPredecessors[index] = predecessor;
  }
}

void WindowPropagation::OfferTargets(Id h, const Window& window)
{
  const Id f = SurfaceMesh::Face(h);
  const double tolerance = window.Tolerance(SeenTolerance, this->Mesh.Length(h));
  auto target = std::lower_bound(this->Targets.begin(), this->Targets.end(), f,
    [](const Target& t, Id face) { return t.Face < face; });
  for (; target != this->Targets.end() && target->Face == f; ++target)
  {
    const Point2 p = PlaceInFrame(this->Mesh, h, target->Barycentric);
    const double x = Crossing(window.Image, p);
    if (x >= window.Begin - tolerance && x <= window.End + tolerance)
    {
      this->ReachTarget(target->Index, window.DistanceThrough(x, p),
        { h, window.Root, window.Image.X, window.Image.Y }, this->SourceOf(window.Root));
    }
  }
}

void WindowPropagation::UpdateRadius()
{
  if (!this->Options->StopAtTargets || this->Options->Targets.empty())
  {
    return;
  }
  // Nothing beyond the farthest target needs to be computed. Upper bounds suffice, since they only
  // decrease.
  double farthest = 0.0;
  for (std::size_t t = 0; t < this->Options->Targets.size(); ++t)
  {
    const SurfacePoint& point = this->Options->Targets[t];
    double bound = this->Result->TargetDistances[t];
    if (point.On == SurfacePoint::Support::Vertex)
    {
      bound = this->Label(point.Vertex);
    }
    else
    {
      for (int k = 0; k < 3; ++k)
      {
        bound = std::min(bound,
          this->Label(this->Mesh.Origin(3 * point.Face + k)) +
            DistanceToCorner(this->Mesh, point.Face, point.Barycentric, k));
      }
    }
    farthest = std::max(farthest, bound * (1.0 + LengthTolerance));
  }
  this->Radius = std::min(this->Radius, farthest);
}

void WindowPropagation::FinishTargets()
{
  const std::vector<SurfacePoint>& points = this->Options->Targets;
  for (std::size_t t = 0; t < points.size(); ++t)
  {
    if (points[t].On == SurfacePoint::Support::Vertex)
    {
      const Id v = points[t].Vertex;
      this->ReachTarget(
        t, this->Label(v), this->Result->Predecessors[v], this->Result->NearestSource[v]);
      continue;
    }
    ForEachFaceAround(this->Mesh, points[t], [&](Id f, const std::array<double, 3>& b) {
      for (int k = 0; k < 3; ++k)
      {
        const Id corner = this->Mesh.Origin(3 * f + k);
        this->ReachTarget(t, this->Label(corner) + DistanceToCorner(this->Mesh, f, b, k),
          { NoId, corner, 0.0, 0.0 }, this->Result->NearestSource[corner]);
      }
    });
  }
}

/// Moves the windows to the result. Returns false if memory is insufficient.
bool WindowPropagation::FinishWindows(const std::vector<GeodesicSource>& sources, double shift)
{
  if (!this->Store.IsOn())
  {
    return true;
  }
  this->Release(); // before windows are stored twice
  this->Store.Trim(this->Result->Distances);
  if (!this->NoteAllMemory(this->Store.GetMemoryToMove()))
  {
    return false;
  }
  EdgeWindows& windows = this->Result->Windows;
  this->Store.MoveTo(windows, shift);
  for (std::size_t k = 0; k < sources.size(); ++k)
  {
    if (sources[k].Point.On != SurfacePoint::Support::Vertex)
    {
      ForEachFaceAround(this->Mesh, sources[k].Point, [&](Id f, const std::array<double, 3>& b) {
        windows.Sources.push_back(
          { f, b, sources[k].InitialDistance + shift, ~static_cast<Id>(k) });
      });
    }
  }
  std::stable_sort(windows.Sources.begin(), windows.Sources.end(),
    [](const FaceSource& a, const FaceSource& b) { return a.Face < b.Face; });
  DropDominated(this->Mesh, windows.Sources);
  return true;
}

bool WindowPropagation::NoteAllMemory(std::size_t bytes)
{
  this->Result->PeakMemory = std::max(this->Result->PeakMemory, bytes);
  this->IsOutOfMemory |= this->Options->MemoryLimit != 0 && bytes > this->Options->MemoryLimit;
  this->HasExceededLimit |= this->Result->NumberOfWindows > this->MostWindows;
  return !this->IsOutOfMemory && !this->HasExceededLimit;
}

void WindowPropagation::ForgetBeyondRadius()
{
  this->UpdateRadius();
  const double limit = this->Radius;
  this->ForEachReached([&](std::size_t v) {
    if (this->Result->Distances[v] > limit)
    {
      this->Result->Distances[v] = Infinity;
      this->Result->NearestSource[v] = NoId;
      this->Result->Predecessors[v] = Predecessor();
    }
  });
  for (std::size_t t = 0; t < this->Result->TargetDistances.size(); ++t)
  {
    if (this->Result->TargetDistances[t] > limit)
    {
      this->Result->TargetDistances[t] = Infinity;
      this->Result->TargetNearestSource[t] = NoId;
      this->Result->TargetPredecessors[t] = Predecessor();
    }
  }
}
}
