// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggVectorGraphics.h"

#include "dggGraphicsBand.h"
#include "dggGraphicsDomain.h"
#include "dggGraphicsSources.h"
#include "dggPoissonSolver.h"
#include "dggPoissonSystem.h"
#include "dggProgressPart.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

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

/// Numbers from 2^-100 to 2^100 can be multiplied by those of meshes, and squared.
constexpr int UsualExponent = 100;

/// What is not used may be anything.
void FindLargest(const std::vector<double>& values, std::vector<double>& largest)
{
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    double& found = largest[i % largest.size()];
    found = std::isfinite(values[i]) ? std::max(found, std::abs(values[i])) : found;
  }
}

/// Powers of two by which the channels of a drawing are divided while its colours are found. These
/// are linear in what is given, so that nothing overflows or vanishes on the way that does not do
/// so in the end. Channels of usual size, from 2^-100 to 2^100, stay as they are; others are moved
/// just into that range, so that what is much smaller in them is not lost.
class ChannelScale
{
public:
  /// By the largest number of each channel. All must be finite, and as many as are needed.
  ChannelScale(const std::vector<GraphicsCurve>& curves, const std::vector<GraphicsRegion>& regions,
    const GraphicsOptions& options);

  /// Divide numbers, all channels after each other.
  std::vector<double> Apply(std::vector<double> values) const;
  /// The colours of curves divided.
  std::vector<GraphicsCurve> Apply(std::vector<GraphicsCurve> curves) const;
  /// The strengths of regions divided.
  std::vector<std::vector<double>> Apply(const std::vector<GraphicsRegion>& regions) const;
  /// Multiply results again. Fails, with a message that says `what` they are, where one is beyond
  /// the largest number.
  Status Undo(std::vector<double>& values, const std::string& what) const;

private:
  std::vector<int> Exponents; // per channel
  bool IsNeeded = false;      // one of them is not 0
};

ChannelScale::ChannelScale(const std::vector<GraphicsCurve>& curves,
  const std::vector<GraphicsRegion>& regions, const GraphicsOptions& options)
{
  std::vector<double> largest(static_cast<std::size_t>(options.NumberOfChannels), 0.0);
  FindLargest(options.Background, largest);
  for (const GraphicsCurve& curve : curves)
  {
    FindLargest(curve.Left, largest);
    FindLargest(curve.Right, largest);
  }
  for (const GraphicsRegion& region : regions)
  {
    FindLargest(region.Strength, largest);
  }
  for (const double value : largest)
  {
    const int exponent = value > 0.0 ? std::ilogb(value) : 0;
    const int usual = std::min(std::max(exponent, -UsualExponent), UsualExponent);
    this->Exponents.push_back(exponent - usual);
    this->IsNeeded = this->IsNeeded || exponent != usual;
  }
}

std::vector<double> ChannelScale::Apply(std::vector<double> values) const
{
  for (std::size_t i = 0; i < values.size() && this->IsNeeded; ++i)
  {
    values[i] = std::ldexp(values[i], -this->Exponents[i % this->Exponents.size()]);
  }
  return values;
}

std::vector<GraphicsCurve> ChannelScale::Apply(std::vector<GraphicsCurve> curves) const
{
  for (GraphicsCurve& curve : curves)
  {
    curve.Left = this->Apply(std::move(curve.Left));
    curve.Right = this->Apply(std::move(curve.Right));
  }
  return curves;
}

std::vector<std::vector<double>> ChannelScale::Apply(
  const std::vector<GraphicsRegion>& regions) const
{
  std::vector<std::vector<double>> strengths;
  for (const GraphicsRegion& region : regions)
  {
    strengths.push_back(this->Apply(region.Strength));
  }
  return strengths;
}

Status ChannelScale::Undo(std::vector<double>& values, const std::string& what) const
{
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const std::size_t channel = i % this->Exponents.size();
    values[i] = this->IsNeeded ? std::ldexp(values[i], this->Exponents[channel]) : values[i];
    if (!std::isfinite(values[i]))
    {
      return Status::Invalid(what + " of channel " + std::to_string(channel) +
        " are beyond the largest number, 1.8e308: divide its colours, strengths and background by "
        "a number");
    }
  }
  return Status::Success();
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
  DGG_RETURN_IF_ERROR(status.IsOk()
      ? this->Loads.Prepare(surface, mesh.GetNumberOfFaces(), chains, curves, checkRegions,
          ProgressPart(options.Progress, CutDone, MeasuredDone))
      : status);
  PoissonOptions poisson;
  poisson.IntrinsicDelaunay = options.IntrinsicDelaunay;
  poisson.DirichletVertices = FindDirichletVertices(this->Domain, chains, curves);
  this->Solver = std::make_unique<PoissonSolver>(this->Domain.SolvedMesh);
  return this->Solver->Prepare(
    poisson, ProgressPart(options.Progress, MeasuredDone, 1.0), [&](double, double missing) {
      const double run = this->EstimateRun(curves, options.NumberOfChannels);
      return options.CheckMemory ? options.CheckMemory(this->EstimateHeld() + run, missing + run)
                                 : Status::Success();
    });
}

double VectorGraphics::Implementation::EstimateHeld() const
{
  const auto faces = static_cast<double>(this->Domain.Solved.Surface.Faces.size());
  return faces * (HeldPerFace + (this->HasPoisson ? MorePerFace : 0.0)) +
    this->Loads.GetMemorySize() + this->Solver->GetEstimatedMemory();
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
  DGG_RETURN_IF_ERROR(
    this->AddBands(scaled, options, ProgressPart(options.Progress, 0.0, BandsDone), bands));
  std::vector<std::vector<double>> columns(
    channels, std::vector<double>(this->Domain.Solved.Surface.Points.size(), 0.0));
  status = this->Loads.Add(this->Domain, this->Chains, scaled, regions, scale.Apply(regions),
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
  SetDirichletValues(this->Domain, this->Chains, scaled, bands, columns);
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
