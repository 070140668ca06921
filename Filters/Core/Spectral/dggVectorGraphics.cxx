// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggVectorGraphics.h"

#include "dggGraphicsBand.h"
#include "dggGraphicsChecks.h"
#include "dggGraphicsDomain.h"
#include "dggGraphicsScale.h"
#include "dggGraphicsSources.h"
#include "dggPoissonSolver.h"
#include "dggPoissonSystem.h"
#include "dggProgressPart.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

namespace dgg
{
namespace
{
/// Parts of the progress: of Prepare() when the surface is cut and curves are measured, of Run()
/// when bands are found and sources are added.
constexpr double CutDone = 0.2;
constexpr double MeasuredDone = 0.3;
constexpr double BandsDone = 0.6;
constexpr double SourcesDone = 0.8;

/// The parts of the faces of the mesh that was refined.
class FaceParts
{
public:
  FaceParts(const RefinedSurface& surface, Id numberOfFaces)
    : Begins(static_cast<std::size_t>(numberOfFaces) + 1, 0)
    , Parts(numberOfFaces > 0 ? surface.Faces.size() : 0)
  {
    if (numberOfFaces == 0)
    {
      return;
    }
    for (const Id f : surface.Faces)
    {
      ++this->Begins[f];
    }
    std::partial_sum(this->Begins.begin(), this->Begins.end(), this->Begins.begin());
    for (auto part = static_cast<Id>(surface.Faces.size()); part-- > 0;)
    {
      this->Parts[--this->Begins[surface.Faces[part]]] = part;
    }
  }
  Id Count(Id face) const { return this->Begins[face + 1] - this->Begins[face]; }
  void Append(Id face, std::vector<Id>& parts) const
  {
    parts.insert(parts.end(), this->Parts.begin() + this->Begins[face],
      this->Parts.begin() + this->Begins[face + 1]);
  }

private:
  std::vector<Id> Begins; // per face; one more at the end
  std::vector<Id> Parts;
};

bool Goes(const ProgressCallback& progress, double fraction)
{
  return !progress || progress(fraction);
}

double GetCutMemory(const RefinedSurface& surface, bool hasPoisson)
{
  return PredictGraphicsMemory(static_cast<double>(surface.Faces.size()),
    static_cast<double>(surface.Points.size()), hasPoisson);
}
}

class VectorGraphics::Implementation
{
public:
  Status Prepare(const SurfaceMesh& mesh, const RefinedSurface& surface,
    const std::vector<CurveChain>& chains, const std::vector<GraphicsCurve>& curves,
    const GraphicsOptions& options);
  Status Run(const std::vector<GraphicsCurve>& curves, const std::vector<GraphicsRegion>& regions,
    const GraphicsOptions& options, GraphicsResult& result);

  std::size_t GetMemorySize() const;

  GraphicsDomain Domain;
  std::unique_ptr<PoissonSolver> Solver; // of the domain's mesh

private:
  Status CheckRun(const std::vector<GraphicsCurve>& curves,
    const std::vector<GraphicsRegion>& regions, const GraphicsOptions& options) const;
  bool HasPoisson() const;
  Status MeasureCurves(const RefinedSurface& surface, const std::vector<GraphicsCurve>& curves,
    const GraphicsOptions& options);
  Status FindRegions(const ChainEdges& edges, const std::vector<GraphicsCurve>& curves,
    const GraphicsOptions& options);
  void FindGivenVertices(const std::vector<GraphicsCurve>& curves, PoissonOptions& options) const;
  Status AddBands(const std::vector<GraphicsCurve>& curves, const GraphicsOptions& options,
    const ProgressCallback& progress, std::vector<double>& values) const;
  double GetRunMemory(const GraphicsOptions& options) const;
  Status AddSources(const std::vector<GraphicsCurve>& curves,
    const std::vector<GraphicsRegion>& regions, const ChannelScale& scale,
    const ProgressCallback& progress, std::vector<std::vector<double>>& columns) const;
  double CountWork(const std::vector<GraphicsRegion>& regions, const FaceParts& parts) const;
  void MeasureNet(
    const std::vector<std::vector<double>>& columns, std::vector<double>& netSources) const;
  void SetGivenValues(const std::vector<GraphicsCurve>& curves, const std::vector<double>& bands,
    std::vector<std::vector<double>>& columns) const;
  template <typename Visitor>
  void ForEachGiven(const std::vector<GraphicsCurve>& curves, Visitor&& visit) const;

  Id NumberOfFaces = 0; // of the mesh
  std::vector<CurveChain> Chains;
  std::vector<GraphicsCurveType> Types;           // per curve
  std::vector<bool> AreClosed;                    // per curve
  std::vector<std::vector<Id>> RegionFaces;       // per curve, where it is a region
  std::vector<std::vector<ChainPart>> ChainParts; // per curve, where it is a source
  bool IsReady = false;
};

Status VectorGraphics::Implementation::Prepare(const SurfaceMesh& mesh,
  const RefinedSurface& surface, const std::vector<CurveChain>& chains,
  const std::vector<GraphicsCurve>& curves, const GraphicsOptions& options)
{
  this->IsReady = false;
  this->Solver.reset();
  if (chains.size() != curves.size())
  {
    return Status::Invalid("there are " + std::to_string(chains.size()) + " chains for " +
      std::to_string(curves.size()) + " curves: give one for each");
  }
  if (!Goes(options.Progress, 0.0))
  {
    return Status::Abort();
  }
  this->Chains = chains;
  this->NumberOfFaces = mesh.GetNumberOfFaces();
  this->Types.clear();
  this->AreClosed.clear();
  for (const GraphicsCurve& curve : curves)
  {
    this->Types.push_back(curve.Type);
    this->AreClosed.push_back(curve.IsClosed);
  }
  Status status;
  if (options.CheckMemory)
  {
    status = options.CheckMemory(GetCutMemory(surface, this->HasPoisson()));
  }
  status = status.IsOk() ? CutForGraphics(mesh, surface, chains, curves, this->Domain) : status;
  if (status.IsOk() && !Goes(options.Progress, CutDone))
  {
    status = Status::Abort();
  }
  status = status.IsOk() ? this->MeasureCurves(surface, curves, options) : status;
  if (!status.IsOk())
  {
    return status;
  }
  PoissonOptions poisson;
  poisson.IntrinsicDelaunay = options.IntrinsicDelaunay;
  this->FindGivenVertices(curves, poisson);
  this->Solver = std::make_unique<PoissonSolver>(this->Domain.SolvedMesh);
  const double middle = 0.5 * (MeasuredDone + 1.0);
  status = this->Solver->Analyze(poisson, ProgressPart(options.Progress, MeasuredDone, middle));
  if (status.IsOk() && options.CheckMemory)
  {
    status = options.CheckMemory(
      this->GetRunMemory(options) + static_cast<double>(this->Solver->GetMissingMemory()));
  }
  if (status.IsOk())
  {
    status = this->Solver->Factorize(ProgressPart(options.Progress, middle, 1.0));
  }
  this->IsReady = status.IsOk();
  return status;
}

bool VectorGraphics::Implementation::HasPoisson() const
{
  return std::count(this->Types.begin(), this->Types.end(), GraphicsCurveType::Poisson) > 0;
}

Status VectorGraphics::Implementation::MeasureCurves(const RefinedSurface& surface,
  const std::vector<GraphicsCurve>& curves, const GraphicsOptions& options)
{
  this->ChainParts.assign(curves.size(), {});
  std::vector<char> isMeant;
  for (const GraphicsCurve& curve : curves)
  {
    isMeant.push_back(
      curve.Type == GraphicsCurveType::Source || curve.Type == GraphicsCurveType::Region);
  }
  const ChainEdges edges(surface, this->Chains, isMeant);
  for (std::size_t k = 0; k < curves.size(); ++k)
  {
    if (curves[k].Type == GraphicsCurveType::Source)
    {
      this->ChainParts[k] = SplitChain(edges, this->Chains[k]);
    }
  }
  return this->FindRegions(edges, curves, options);
}

/// The faces on the left of regions; of many regions they may be many more than the surface has.
Status VectorGraphics::Implementation::FindRegions(
  const ChainEdges& edges, const std::vector<GraphicsCurve>& curves, const GraphicsOptions& options)
{
  const RefinedSurface& surface = edges.GetSurface();
  this->RegionFaces.assign(curves.size(), {});
  LeftFaces left(edges);
  const auto faces = static_cast<double>(surface.Faces.size());
  const auto regions = static_cast<double>(
    std::count(this->Types.begin(), this->Types.end(), GraphicsCurveType::Region));
  WorkProgress work(ProgressPart(options.Progress, CutDone, MeasuredDone), regions * faces);
  double found = 0.0;
  double asked = 0.0; // for how many faces
  for (std::size_t k = 0; k < curves.size(); ++k)
  {
    if (curves[k].Type != GraphicsCurveType::Region)
    {
      continue;
    }
    if (options.CheckMemory && found + 3.0 * faces > asked) // this one may have them all, and grows
    {
      asked = found + 4.0 * faces;
      Status status =
        options.CheckMemory(GetCutMemory(surface, this->HasPoisson()) + asked * sizeof(Id));
      if (!status.IsOk())
      {
        return status;
      }
    }
    Status status = left.Find(this->Chains[k], curves[k].IsClosed, work, this->RegionFaces[k]);
    if (!status.IsOk())
    {
      return status.IsAborted()
        ? status
        : Status::Invalid(NameOf(curves[k], k) + ": " + status.GetMessage());
    }
    this->RegionFaces[k].shrink_to_fit();
    found += static_cast<double>(this->RegionFaces[k].size());
  }
  return Status::Success();
}

/// Call `visit(vertex, curve, values, parameter)` for every end of an edge of a diffusion curve, on
/// both sides.
template <typename Visitor>
void VectorGraphics::Implementation::ForEachGiven(
  const std::vector<GraphicsCurve>& curves, Visitor&& visit) const
{
  for (std::size_t k = 0; k < curves.size(); ++k)
  {
    if (curves[k].Type != GraphicsCurveType::Diffusion)
    {
      continue;
    }
    const CurveSides& sides = this->Domain.Solved.Sides[this->Domain.SidesInSolved[k]];
    const std::vector<double>& parameters = this->Chains[k].Parameters;
    for (const bool isLeft : { true, false })
    {
      const std::vector<EdgeSide>& edges = isLeft ? sides.Left : sides.Right;
      for (std::size_t i = 0; i < edges.size(); ++i)
      {
        if (edges[i].Face != NoId)
        {
          visit(edges[i].From, curves[k], isLeft, parameters[i]);
          visit(edges[i].To, curves[k], isLeft, parameters[i + 1]);
        }
      }
    }
  }
}

void VectorGraphics::Implementation::FindGivenVertices(
  const std::vector<GraphicsCurve>& curves, PoissonOptions& options) const
{
  std::vector<Id>& vertices = options.GivenVertices;
  this->ForEachGiven(
    curves, [&](Id v, const GraphicsCurve&, bool, double) { vertices.push_back(v); });
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
}

Status VectorGraphics::Implementation::CheckRun(const std::vector<GraphicsCurve>& curves,
  const std::vector<GraphicsRegion>& regions, const GraphicsOptions& options) const
{
  if (!this->IsReady || curves.size() != this->Chains.size())
  {
    return Status::Invalid("the surface is not prepared for these curves: call Prepare() first");
  }
  for (std::size_t k = 0; k < curves.size(); ++k)
  {
    if (curves[k].Type != this->Types[k] || curves[k].IsClosed != this->AreClosed[k])
    {
      return Status::Invalid(NameOf(curves[k], k) +
        " is not of the type that the surface was prepared for: call Prepare() again");
    }
  }
  Status status = CheckGraphicsOptions(options);
  const auto channels = static_cast<std::size_t>(std::max(0, options.NumberOfChannels));
  for (std::size_t k = 0; k < curves.size() && status.IsOk(); ++k)
  {
    status = CheckGraphicsCurve(curves[k], k, channels * this->Chains[k].GivenPoints.size());
  }
  for (std::size_t r = 0; r < regions.size() && status.IsOk(); ++r)
  {
    status = CheckGraphicsRegion(regions[r], r, channels, this->NumberOfFaces);
  }
  return status;
}

/// What is held, and the colours while they are found: bands, sources, what Solve() works with and,
/// of Poisson curves, distances from both sides.
double VectorGraphics::Implementation::GetRunMemory(const GraphicsOptions& options) const
{
  const auto solved = static_cast<double>(this->Domain.Solved.Surface.Points.size());
  const auto drawn = static_cast<double>(this->Domain.Drawn.Surface.Points.size());
  const double columns = options.NumberOfChannels * sizeof(double) * (drawn + solved);
  const double lanes = solved * sizeof(double) * (options.NumberOfChannels > 4 ? 24.0 : 4.0);
  // Of both sides, and what the distances are found with.
  const double distances = this->HasPoisson()
    ? drawn * (2.0 * (sizeof(double) + sizeof(Id) + sizeof(Predecessor)) + 32.0) +
      static_cast<double>(this->Domain.Drawn.Surface.Faces.size()) * 20.0
    : 0.0;
  // Marks, a patch and its rim; for sets of faces also their parts.
  const double sources =
    static_cast<double>(this->Domain.Solved.Surface.Faces.size()) * (1.0 + 4.0 * sizeof(Id)) +
    this->NumberOfFaces * sizeof(Id);
  return static_cast<double>(this->GetMemorySize()) + columns +
    std::max({ lanes, distances, sources });
}

Status VectorGraphics::Implementation::AddBands(const std::vector<GraphicsCurve>& curves,
  const GraphicsOptions& options, const ProgressCallback& progress,
  std::vector<double>& values) const
{
  const int channels = options.NumberOfChannels;
  std::function<Status(double)> checkMore;
  if (options.CheckMemory)
  {
    const double others = this->GetRunMemory(options);
    checkMore = [&options, others](double bytes) { return options.CheckMemory(others + bytes); };
  }
  std::unique_ptr<ExactGeodesics> exact;
  for (std::size_t k = 0; k < curves.size(); ++k)
  {
    if (curves[k].Type != GraphicsCurveType::Poisson)
    {
      continue;
    }
    if (!exact)
    {
      exact = std::make_unique<ExactGeodesics>(this->Domain.DrawnMesh);
    }
    const auto count = static_cast<double>(curves.size());
    const double begin = static_cast<double>(k) / count;
    if (!Goes(progress, begin))
    {
      return Status::Abort();
    }
    Status status = AddBand(this->Domain.DrawnMesh,
      this->Domain.Drawn.Sides[this->Domain.SidesInDrawn[k]], this->Chains[k], curves[k], channels,
      *exact, checkMore, ProgressPart(progress, begin, begin + 1.0 / count), values);
    if (!status.IsOk())
    {
      return status;
    }
  }
  return Status::Success();
}

Status VectorGraphics::Implementation::AddSources(const std::vector<GraphicsCurve>& curves,
  const std::vector<GraphicsRegion>& regions, const ChannelScale& scale,
  const ProgressCallback& progress, std::vector<std::vector<double>>& columns) const
{
  const CutSurface& surface = this->Domain.Solved.Surface;
  const FaceParts parts(surface, regions.empty() ? 0 : this->NumberOfFaces);
  WorkProgress work(progress, this->CountWork(regions, parts));
  RegionSources adder(this->Domain.SolvedMesh, surface);
  Status status;
  for (std::size_t k = 0; k < curves.size() && status.IsOk(); ++k)
  {
    if (curves[k].Type == GraphicsCurveType::Source)
    {
      AddLineSource(surface, this->Chains[k], this->ChainParts[k], curves[k], columns);
    }
    if (curves[k].Type == GraphicsCurveType::Region)
    {
      status = adder.Add(this->RegionFaces[k], curves[k].Left, work, columns);
    }
  }
  for (std::size_t r = 0; r < regions.size() && status.IsOk(); ++r)
  {
    std::vector<Id> faces;
    for (const Id f : regions[r].Faces)
    {
      parts.Append(f, faces);
    }
    status = adder.Add(faces, scale.Apply(regions[r].Strength), work, columns);
  }
  return status;
}

/// What sources of regions take, as WorkProgress is told.
double VectorGraphics::Implementation::CountWork(
  const std::vector<GraphicsRegion>& regions, const FaceParts& parts) const
{
  double faces = 0.0;
  for (const std::vector<Id>& found : this->RegionFaces)
  {
    faces += static_cast<double>(found.size());
  }
  for (const GraphicsRegion& region : regions)
  {
    for (const Id f : region.Faces)
    {
      faces += parts.Count(f);
    }
  }
  return RegionSources::WorkPerFace * faces;
}

void VectorGraphics::Implementation::MeasureNet(
  const std::vector<std::vector<double>>& columns, std::vector<double>& netSources) const
{
  const PoissonSystem& system = this->Solver->GetSystem();
  const std::size_t channels = columns.size();
  netSources.assign(channels * static_cast<std::size_t>(system.GetNumberOfComponents()), 0.0);
  for (std::size_t v = 0; v < this->Domain.Solved.Surface.Points.size(); ++v)
  {
    const Id component = system.GetComponent(static_cast<Id>(v));
    for (std::size_t c = 0; c < channels && system.IsFree(component); ++c)
    {
      netSources[channels * static_cast<std::size_t>(component) + c] += columns[c][v];
    }
  }
}

/// Where colours are given, what the bands have not made of them already. A vertex that bands have
/// cut has several values of theirs, of which the mean counts.
void VectorGraphics::Implementation::SetGivenValues(const std::vector<GraphicsCurve>& curves,
  const std::vector<double>& bands, std::vector<std::vector<double>>& columns) const
{
  const std::size_t channels = columns.size();
  const std::size_t n = this->Domain.Solved.Surface.Points.size();
  std::vector<double> counts(n, 0.0);
  std::vector<double> color(channels);
  this->ForEachGiven(curves, [&](Id v, const GraphicsCurve& curve, bool isLeft, double parameter) {
    InterpolateOnCurve(isLeft ? curve.Left : curve.Right, static_cast<int>(channels),
      curve.IsClosed, parameter, color.data());
    for (std::size_t c = 0; c < channels; ++c)
    {
      columns[c][v] = (counts[v] == 0.0 ? 0.0 : columns[c][v]) + color[c];
    }
    counts[v] += 1.0;
  });
  std::vector<double> copies(n, 0.0);
  for (const Id v : this->Domain.SolvedVertexOf)
  {
    copies[v] += 1.0;
  }
  for (std::size_t c = 0; c < channels; ++c)
  {
    for (std::size_t v = 0; v < n; ++v)
    {
      columns[c][v] /= std::max(1.0, counts[v]);
    }
    for (std::size_t d = 0; d < this->Domain.SolvedVertexOf.size(); ++d)
    {
      const Id v = this->Domain.SolvedVertexOf[d];
      columns[c][v] -= counts[v] > 0.0 ? bands[channels * d + c] / copies[v] : 0.0;
    }
  }
}

Status VectorGraphics::Implementation::Run(const std::vector<GraphicsCurve>& curves,
  const std::vector<GraphicsRegion>& regions, const GraphicsOptions& options,
  GraphicsResult& result)
{
  result = GraphicsResult();
  Status status = this->CheckRun(curves, regions, options);
  if (status.IsOk() && options.CheckMemory)
  {
    status = options.CheckMemory(this->GetRunMemory(options)); // other numbers of channels
  }
  if (status.IsOk() && !Goes(options.Progress, 0.0))
  {
    status = Status::Abort();
  }
  if (!status.IsOk())
  {
    return status;
  }
  const auto channels = static_cast<std::size_t>(options.NumberOfChannels);
  const std::size_t drawn = this->Domain.Drawn.Surface.Points.size();
  const ChannelScale scale(curves, regions, options);
  const std::vector<GraphicsCurve> scaled = scale.Apply(curves);
  const std::vector<double> background = scale.Apply(options.Background);
  std::vector<double> bands(channels * drawn, 0.0);
  status = this->AddBands(scaled, options, ProgressPart(options.Progress, 0.0, BandsDone), bands);
  if (!status.IsOk())
  {
    return status;
  }
  std::vector<std::vector<double>> columns(
    channels, std::vector<double>(this->Domain.Solved.Surface.Points.size(), 0.0));
  status = this->AddSources(
    scaled, regions, scale, ProgressPart(options.Progress, BandsDone, SourcesDone), columns);
  if (status.IsOk() && !Goes(options.Progress, SourcesDone))
  {
    status = Status::Abort();
  }
  if (!status.IsOk())
  {
    return status;
  }
  this->MeasureNet(columns, result.NetSources);
  this->SetGivenValues(scaled, bands, columns);
  status = this->Solver->Solve(columns);
  if (status.IsOk() && !Goes(options.Progress, 1.0))
  {
    status = Status::Abort();
  }
  if (!status.IsOk())
  {
    result = GraphicsResult();
    return status;
  }
  const PoissonSystem& system = this->Solver->GetSystem();
  result.Values = std::move(bands);
  result.Components.resize(drawn);
  for (std::size_t d = 0; d < drawn; ++d)
  {
    const Id v = this->Domain.SolvedVertexOf[d];
    result.Components[d] = system.GetComponent(v);
    const bool isFree = !background.empty() && system.IsFree(system.GetComponent(v));
    for (std::size_t c = 0; c < channels; ++c)
    {
      result.Values[channels * d + c] += columns[c][v] + (isFree ? background[c] : 0.0);
    }
  }
  status = scale.Undo(result.Values, "colours");
  status = status.IsOk() ? scale.Undo(result.NetSources, "net sources") : status;
  if (!status.IsOk())
  {
    result = GraphicsResult();
  }
  return status;
}

std::size_t VectorGraphics::Implementation::GetMemorySize() const
{
  std::size_t bytes =
    this->Domain.GetMemorySize() + (this->Solver ? this->Solver->GetMemorySize() : 0);
  for (const std::vector<Id>& faces : this->RegionFaces)
  {
    bytes += faces.size() * sizeof(Id);
  }
  for (const std::vector<ChainPart>& parts : this->ChainParts)
  {
    bytes += parts.size() * sizeof(ChainPart);
  }
  return bytes;
}

VectorGraphics::VectorGraphics()
  : Internals(std::make_unique<Implementation>())
{
}

VectorGraphics::~VectorGraphics() = default;

Status VectorGraphics::Prepare(const SurfaceMesh& mesh, const RefinedSurface& surface,
  const std::vector<CurveChain>& chains, const std::vector<GraphicsCurve>& curves,
  const GraphicsOptions& options)
{
  return this->Internals->Prepare(mesh, surface, chains, curves, options);
}

Status VectorGraphics::Run(const std::vector<GraphicsCurve>& curves,
  const std::vector<GraphicsRegion>& regions, const GraphicsOptions& options,
  GraphicsResult& result)
{
  return this->Internals->Run(curves, regions, options, result);
}

const CutSurface& VectorGraphics::GetSurface() const
{
  return this->Internals->Domain.Drawn.Surface;
}

void VectorGraphics::Clear()
{
  this->Internals = std::make_unique<Implementation>();
}

std::size_t VectorGraphics::GetMemorySize() const
{
  return this->Internals->GetMemorySize();
}

double VectorGraphics::PredictMemory(double faces, double vertices, bool hasPoisson)
{
  return PredictGraphicsMemory(faces, vertices, hasPoisson);
}
}
