// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggVectorGraphics.h"

#include "dggGraphicsBand.h"
#include "dggGraphicsDomain.h"
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

/// Of a surface, two cuts and the mesh of one; of the mesh of the other, which Poisson curves need.
constexpr double HeldPerFace = 370.0;
constexpr double MorePerFace = 140.0;
/// What colours are found with: distances or blocks of solutions, and of a band whose strengths are
/// blended.
constexpr double WorkPerVertex = 200.0;
constexpr double BandPerFace = 180.0;
}

class VectorGraphics::Implementation
{
public:
  Status Prepare(const SurfaceMesh& mesh, const RefinedSurface& surface,
    const std::vector<CurveChain>& chains, const std::vector<GraphicsCurve>& curves,
    const GraphicsOptions& options);
  Status Run(const std::vector<GraphicsCurve>& curves, const std::vector<GraphicsRegion>& regions,
    const GraphicsOptions& options, GraphicsResult& result);

  double EstimateHeld() const;

  GraphicsDomain Domain;
  std::unique_ptr<PoissonSolver> Solver; // of the domain's mesh

private:
  Status AddBands(const std::vector<GraphicsCurve>& curves, const GraphicsOptions& options,
    const ProgressCallback& progress, std::vector<double>& values) const;
  double EstimateRun(const std::vector<GraphicsCurve>& curves, int channels) const;
  void MeasureNet(
    const std::vector<std::vector<double>>& columns, std::vector<double>& netSources) const;

  std::vector<CurveChain> Chains;
  GraphicsLoads Loads;
  bool HasPoisson = false; // a curve of that type
};

Status VectorGraphics::Implementation::Prepare(const SurfaceMesh& mesh,
  const RefinedSurface& surface, const std::vector<CurveChain>& chains,
  const std::vector<GraphicsCurve>& curves, const GraphicsOptions& options)
{
  this->Solver.reset();
  if (!Goes(options.Progress, 0.0))
  {
    return Status::Abort();
  }
  this->HasPoisson = std::any_of(curves.begin(), curves.end(),
    [](const GraphicsCurve& curve) { return curve.Type == GraphicsCurveType::Poisson; });
  this->Chains = chains;
  GraphicsMemoryCheck checkRegions;
  if (options.CheckMemory)
  {
    checkRegions = [&](double bytes, double) {
      const double all = BytesPerFace * static_cast<double>(surface.Faces.size()) + bytes;
      return options.CheckMemory(all, all);
    };
  }
  Status status = CutForGraphics(mesh, surface, chains, curves, this->Domain);
  if (status.IsOk() && !Goes(options.Progress, CutDone))
  {
    status = Status::Abort();
  }
  status = status.IsOk() ? this->Loads.Prepare(surface, mesh.GetNumberOfFaces(), chains, curves,
                             checkRegions, ProgressPart(options.Progress, CutDone, MeasuredDone))
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
    const double run = this->EstimateRun(curves, options.NumberOfChannels);
    status =
      options.CheckMemory(this->EstimateHeld() + run, this->Solver->GetEstimatedMemory() + run);
  }
  return status.IsOk() ? this->Solver->Factorize(ProgressPart(options.Progress, middle, 1.0))
                       : status;
}

double VectorGraphics::Implementation::EstimateHeld() const
{
  const auto faces = static_cast<double>(this->Domain.Solved.Surface.Faces.size());
  return faces * (HeldPerFace + (this->HasPoisson ? MorePerFace : 0.0)) +
    this->Loads.GetNumberOfRegionFaces() * sizeof(Id) + this->Solver->GetEstimatedMemory();
}

/// The colours, while they are found. A band may be all of the surface, and as many equations.
double VectorGraphics::Implementation::EstimateRun(
  const std::vector<GraphicsCurve>& curves, int channels) const
{
  const auto points = static_cast<double>(this->Domain.Drawn.Surface.Points.size());
  const auto faces = static_cast<double>(this->Domain.Drawn.Surface.Faces.size());
  const double columns = 2.0 * channels * sizeof(double) * points;
  const bool isBlended = std::any_of(curves.begin(), curves.end(), [&](const GraphicsCurve& curve) {
    return curve.Type == GraphicsCurveType::Poisson && IsBlended(curve, channels);
  });
  return points * WorkPerVertex + columns +
    (isBlended ? faces * BandPerFace + columns + this->Solver->GetEstimatedMemory() : 0.0);
}

Status VectorGraphics::Implementation::AddBands(const std::vector<GraphicsCurve>& curves,
  const GraphicsOptions& options, const ProgressCallback& progress,
  std::vector<double>& values) const
{
  const int channels = options.NumberOfChannels;
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
      *exact, ProgressPart(progress, begin, begin + 1.0 / count), values);
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
  Status status;
  if (!this->Solver || !this->Solver->IsReady() || curves.size() != this->Chains.size())
  {
    return Status::Invalid("the surface is not prepared for these curves: call Prepare() first");
  }
  if (options.CheckMemory)
  {
    // Channels may be others than before.
    const double run = this->EstimateRun(curves, options.NumberOfChannels);
    status = options.CheckMemory(this->EstimateHeld() + run, run);
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

double VectorGraphics::GetEstimatedMemory() const
{
  return this->Internals->Solver ? this->Internals->EstimateHeld() : 0.0;
}
}
