// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggVectorGraphics.h"

#include "dggGraphicsBand.h"
#include "dggGraphicsChecks.h"
#include "dggGraphicsDomain.h"
#include "dggGraphicsGiven.h"
#include "dggGraphicsLoads.h"
#include "dggGraphicsScale.h"
#include "dggPoissonSolver.h"
#include "dggPoissonSystem.h"
#include "dggProgressPart.h"

#include <algorithm>
#include <cmath>
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

bool Goes(const ProgressCallback& progress, double fraction)
{
  return !progress || progress(fraction);
}

std::size_t GetChainMemory(const std::vector<CurveChain>& chains)
{
  std::size_t bytes = chains.size() * sizeof(CurveChain);
  for (const CurveChain& chain : chains)
  {
    bytes += chain.Vertices.size() * sizeof(Id) + chain.Parameters.size() * sizeof(double) +
      chain.GivenPoints.size() * sizeof(Offset);
  }
  return bytes;
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
  Status AddBands(const std::vector<GraphicsCurve>& curves, const GraphicsOptions& options,
    const ProgressCallback& progress, std::vector<double>& values) const;
  double GetRunMemory(const GraphicsOptions& options) const;
  void MeasureNet(
    const std::vector<std::vector<double>>& columns, std::vector<double>& netSources) const;

  Id NumberOfFaces = 0; // of the mesh
  std::vector<CurveChain> Chains;
  GraphicsLoads Loads;
  std::vector<GraphicsCurveType> Types; // per curve
  std::vector<bool> AreClosed;          // per curve
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
  this->Chains.clear();
  this->NumberOfFaces = mesh.GetNumberOfFaces();
  this->Types.clear();
  this->AreClosed.clear();
  for (const GraphicsCurve& curve : curves)
  {
    this->Types.push_back(curve.Type);
    this->AreClosed.push_back(curve.IsClosed);
  }
  const double cut = PredictGraphicsMemory(static_cast<double>(surface.Faces.size()),
                       static_cast<double>(surface.Points.size()), this->HasPoisson()) +
    GraphicsLoads::PredictMemory(chains, curves) + static_cast<double>(GetChainMemory(chains));
  // What edges of chains are looked up with is gone before the equation is analyzed, which takes
  // more.
  GraphicsMemoryCheck checkMore;
  if (options.CheckMemory)
  {
    checkMore = [&, cut](double bytes, double held) {
      const std::size_t there = GetSurfaceMemory(surface) + this->GetMemorySize();
      return options.CheckMemory(cut + bytes, static_cast<double>(there) + held);
    };
  }
  Status status = checkMore ? checkMore(0.0, 0.0) : Status::Success();
  if (status.IsOk())
  {
    this->Chains = chains;
  }
  status = status.IsOk() ? CutForGraphics(mesh, surface, chains, curves, this->Domain) : status;
  if (status.IsOk() && !Goes(options.Progress, CutDone))
  {
    status = Status::Abort();
  }
  status = status.IsOk() ? this->Loads.Prepare(surface, this->NumberOfFaces, chains, curves,
                             checkMore, ProgressPart(options.Progress, CutDone, MeasuredDone))
                         : status;
  if (!status.IsOk())
  {
    return status;
  }
  PoissonOptions poisson;
  poisson.IntrinsicDelaunay = options.IntrinsicDelaunay;
  poisson.GivenVertices = FindGivenVertices(this->Domain, chains, curves);
  this->Solver = std::make_unique<PoissonSolver>(this->Domain.SolvedMesh);
  const double middle = 0.5 * (MeasuredDone + 1.0);
  status = this->Solver->Analyze(poisson, ProgressPart(options.Progress, MeasuredDone, middle));
  if (status.IsOk() && options.CheckMemory)
  {
    status = options.CheckMemory(
      this->GetRunMemory(options) + static_cast<double>(this->Solver->GetMissingMemory()),
      static_cast<double>(this->GetMemorySize()));
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
  const double sources = this->Loads.GetAddingMemory(this->Domain);
  return static_cast<double>(this->GetMemorySize()) + columns +
    std::max({ lanes, distances, sources });
}

Status VectorGraphics::Implementation::AddBands(const std::vector<GraphicsCurve>& curves,
  const GraphicsOptions& options, const ProgressCallback& progress,
  std::vector<double>& values) const
{
  const int channels = options.NumberOfChannels;
  GraphicsMemoryCheck checkMore;
  if (options.CheckMemory)
  {
    const double others = this->GetRunMemory(options);
    const double there =
      static_cast<double>(this->GetMemorySize() + values.size() * sizeof(double));
    checkMore = [&options, others, there](double bytes, double held) {
      return options.CheckMemory(others + bytes, there + held);
    };
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
      return status.IsAborted()
        ? status
        : Status::Invalid(NameOf(curves[k], k) + ": " + status.GetMessage());
    }
  }
  return Status::Success();
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

Status VectorGraphics::Implementation::Run(const std::vector<GraphicsCurve>& curves,
  const std::vector<GraphicsRegion>& regions, const GraphicsOptions& options,
  GraphicsResult& result)
{
  result = GraphicsResult();
  Status status = this->CheckRun(curves, regions, options);
  if (status.IsOk() && options.CheckMemory)
  {
    // Channels may be others than before.
    status =
      options.CheckMemory(this->GetRunMemory(options), static_cast<double>(this->GetMemorySize()));
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
  status = this->Loads.Add(this->Domain, this->Chains, scaled, regions, scale,
    ProgressPart(options.Progress, BandsDone, SourcesDone), columns);
  if (status.IsOk() && !Goes(options.Progress, SourcesDone))
  {
    status = Status::Abort();
  }
  if (!status.IsOk())
  {
    return status;
  }
  this->MeasureNet(columns, result.NetSources);
  SetGivenValues(this->Domain, this->Chains, scaled, bands, columns);
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
  return this->Domain.GetMemorySize() + this->Loads.GetMemorySize() + GetChainMemory(this->Chains) +
    (this->Solver ? this->Solver->GetMemorySize() : 0);
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
