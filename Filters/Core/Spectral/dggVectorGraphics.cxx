// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggVectorGraphics.h"

#include "dggGraphicsBand.h"
#include "dggGraphicsChecks.h"
#include "dggGraphicsDomain.h"
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
/// Parts of the progress: of Prepare() when the surface is cut, of Run() when bands are found.
constexpr double CutDone = 0.3;
constexpr double BandsDone = 0.7;

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
}

class VectorGraphics::Implementation
{
public:
  Status Prepare(const SurfaceMesh& mesh, const RefinedSurface& surface,
    const std::vector<CurveChain>& chains, const std::vector<GraphicsCurve>& curves,
    const GraphicsOptions& options);
  Status Run(const std::vector<GraphicsCurve>& curves, const std::vector<GraphicsRegion>& regions,
    const GraphicsOptions& options, GraphicsResult& result);

  GraphicsDomain Domain;
  std::unique_ptr<PoissonSolver> Solver; // of the domain's mesh

private:
  Status CheckRun(const std::vector<GraphicsCurve>& curves,
    const std::vector<GraphicsRegion>& regions, const GraphicsOptions& options) const;
  Status MeasureCurves(const RefinedSurface& surface, const std::vector<GraphicsCurve>& curves);
  void FindGivenVertices(const std::vector<GraphicsCurve>& curves, PoissonOptions& options) const;
  Status AddBands(const std::vector<GraphicsCurve>& curves, const GraphicsOptions& options,
    const ProgressCallback& progress, std::vector<double>& values) const;
  double GetRunMemory(const GraphicsOptions& options) const;
  void AddSources(const std::vector<GraphicsCurve>& curves,
    const std::vector<GraphicsRegion>& regions, std::vector<std::vector<double>>& columns) const;
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
  const bool hasPoisson =
    std::count(this->Types.begin(), this->Types.end(), GraphicsCurveType::Poisson) > 0;
  Status status;
  if (options.CheckMemory)
  {
    status = options.CheckMemory(PredictGraphicsMemory(surface, hasPoisson));
  }
  status = status.IsOk() ? CutForGraphics(mesh, surface, chains, curves, this->Domain) : status;
  status = status.IsOk() ? this->MeasureCurves(surface, curves) : status;
  if (status.IsOk() && !Goes(options.Progress, CutDone))
  {
    status = Status::Abort();
  }
  if (!status.IsOk())
  {
    return status;
  }
  PoissonOptions poisson;
  poisson.IntrinsicDelaunay = options.IntrinsicDelaunay;
  this->FindGivenVertices(curves, poisson);
  this->Solver = std::make_unique<PoissonSolver>(this->Domain.SolvedMesh);
  const double middle = 0.5 * (CutDone + 1.0);
  status = this->Solver->Analyze(poisson, ProgressPart(options.Progress, CutDone, middle));
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

Status VectorGraphics::Implementation::MeasureCurves(
  const RefinedSurface& surface, const std::vector<GraphicsCurve>& curves)
{
  this->RegionFaces.assign(curves.size(), {});
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
    if (curves[k].Type != GraphicsCurveType::Region)
    {
      continue;
    }
    Status status =
      FindFacesOnLeft(edges, this->Chains[k], curves[k].IsClosed, this->RegionFaces[k]);
    if (!status.IsOk())
    {
      return Status::Invalid(NameOf(curves[k], k) + ": " + status.GetMessage());
    }
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
  const bool hasPoisson =
    std::count(this->Types.begin(), this->Types.end(), GraphicsCurveType::Poisson) > 0;
  const double columns = options.NumberOfChannels * sizeof(double) * (drawn + solved);
  const double lanes = solved * sizeof(double) * (options.NumberOfChannels > 4 ? 24.0 : 4.0);
  const double distances =
    hasPoisson ? drawn * 2.0 * (sizeof(double) + sizeof(Id) + sizeof(Predecessor)) : 0.0;
  const double held = static_cast<double>(this->Domain.GetMemorySize()) +
    static_cast<double>(this->Solver->GetMemorySize());
  return held + columns + std::max(lanes, distances);
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

void VectorGraphics::Implementation::AddSources(const std::vector<GraphicsCurve>& curves,
  const std::vector<GraphicsRegion>& regions, std::vector<std::vector<double>>& columns) const
{
  const CutSurface& surface = this->Domain.Solved.Surface;
  RegionSources adder(this->Domain.SolvedMesh, surface);
  for (std::size_t k = 0; k < curves.size(); ++k)
  {
    if (curves[k].Type == GraphicsCurveType::Source)
    {
      AddLineSource(surface, this->Chains[k], this->ChainParts[k], curves[k], columns);
    }
    if (curves[k].Type == GraphicsCurveType::Region)
    {
      adder.Add(this->RegionFaces[k], curves[k].Left, columns);
    }
  }
  const FaceParts parts(surface, regions.empty() ? 0 : this->NumberOfFaces);
  for (const GraphicsRegion& region : regions)
  {
    std::vector<Id> faces;
    for (const Id f : region.Faces)
    {
      parts.Append(f, faces);
    }
    adder.Add(faces, region.Strength, columns);
  }
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
  std::vector<double> bands(channels * drawn, 0.0);
  status = this->AddBands(curves, options, ProgressPart(options.Progress, 0.0, BandsDone), bands);
  if (!status.IsOk())
  {
    return status;
  }
  std::vector<std::vector<double>> columns(
    channels, std::vector<double>(this->Domain.Solved.Surface.Points.size(), 0.0));
  this->AddSources(curves, regions, columns);
  this->MeasureNet(columns, result.NetSources);
  this->SetGivenValues(curves, bands, columns);
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
    const bool isFree = !options.Background.empty() && system.IsFree(system.GetComponent(v));
    for (std::size_t c = 0; c < channels; ++c)
    {
      result.Values[channels * d + c] += columns[c][v] + (isFree ? options.Background[c] : 0.0);
    }
  }
  return status;
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
  return this->Internals->Domain.GetMemorySize() +
    (this->Internals->Solver ? this->Internals->Solver->GetMemorySize() : 0);
}
}
