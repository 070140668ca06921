// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggVectorGraphics.h"

#include "dggCounted.h"
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

// Poisson curves; notation of the class documentation:
//
// If l and r vary along the curve, they are extended into the band as harmonic functions with these
// values on both sides of the curve and natural conditions elsewhere. The values of the nearest
// curve point would jump where two curve points are equally near. The extension requires one more
// small system per such curve, solved whenever colors are computed. If the triangles of the band
// are too thin for that system, although those of the surface are not, the strengths of the nearest
// curve point are used instead, so that a small defect of the surface does not prevent the drawing.
//
// B and its slope vanish at the width. Therefore the sources on each side sum to 0, not only the
// sources of both sides together, and their first moment vanishes as well. By contrast, a layer of
// sources h on one side and -h on the other, the obvious model of a shadow beside a highlight, is a
// layer of dipoles, whose colors extend far beyond any width. With B, colors beyond the width do
// not change, up to rounding, unless a diffusion curve runs through the band. In that case the
// colors on the diffusion curve are unchanged, and the contribution of B is missing around the
// diffusion curve, nowhere by more than the largest B on it. With r = -l, a highlight appears on
// one side and a shadow on the other; with r = l, a glow appears.
//
// Discretely, B is linear in the faces of the mesh, and u = v + B with a function v that Poisson
// curves do not cut. The equation for v has the other sources and, on diffusion curves, the given
// colors minus B. This equation is equivalent to the equation for u with the Laplacian of B as
// source, whose integrals against hat functions sum to 0 up to rounding.

namespace dgg
{
namespace
{
/// Progress of Prepare() after cutting the surface and measuring curves, of Run() after the bands.
constexpr double CutDone = 0.2;
constexpr double MeasuredDone = 0.3;
constexpr double BandsDone = 0.6;
constexpr double SourcesDone = 0.8;

/// Bytes per face of a surface, two cuts and one mesh, and of the second mesh for Poisson curves.
constexpr double HeldPerFace = 370.0;
constexpr double MorePerFace = 140.0;
/// Workspace in bytes for computing colors (distances or blocks of solutions), and for a band with
/// blended strengths.
constexpr double WorkPerVertex = 200.0;
constexpr double BandPerFace = 180.0;

/// Poisson curves with less contrast are reported.
constexpr double SmallestContrast = 0.5;

/// Numbers from 2^-100 to 2^100 can be squared and multiplied by mesh quantities.
constexpr int UsualExponent = 100;

/// Updates the largest magnitude of each channel. Skips values that are not finite: unused values
/// are not checked.
void FindLargest(const std::vector<double>& values, std::vector<double>& largest)
{
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    double& found = largest[i % largest.size()];
    found = std::isfinite(values[i]) ? std::max(found, std::abs(values[i])) : found;
  }
}

/// Powers of two by which the channels of a drawing are divided during the solution. Colors are
/// linear in the input, so that overflow and underflow only occur if the final results do. Channels
/// of ordinary magnitude, from 2^-100 to 2^100, are not scaled; others are moved just into that
/// range, so that much smaller values in them are preserved.
class ChannelScale
{
public:
  /// Determines the scale from the largest value of each channel. All values must be finite, and
  /// their number must match.
  ChannelScale(const std::vector<GraphicsCurve>& curves, const std::vector<GraphicsRegion>& regions,
    const GraphicsOptions& options)
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
      this->Exponents.push_back(exponent - std::clamp(exponent, -UsualExponent, UsualExponent));
    }
  }

  /// Scales values, all channels of a point consecutively.
  std::vector<double> Apply(std::vector<double> values) const
  {
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      values[i] = std::ldexp(values[i], -this->Exponents[i % this->Exponents.size()]);
    }
    return values;
  }

  /// Scales the colors of curves.
  std::vector<GraphicsCurve> Apply(std::vector<GraphicsCurve> curves) const
  {
    for (GraphicsCurve& curve : curves)
    {
      curve.Left = this->Apply(std::move(curve.Left));
      curve.Right = this->Apply(std::move(curve.Right));
    }
    return curves;
  }

  /// Reverts the scaling of results. Fails if a value overflows; `what` names the values in the
  /// message.
  Status Undo(std::vector<double>& values, const std::string& what) const
  {
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      const std::size_t channel = i % this->Exponents.size();
      values[i] = std::ldexp(values[i], this->Exponents[channel]);
      if (!std::isfinite(values[i]))
      {
        return InvalidInput(
          what, " of channel ", channel, " exceed 1.8e308, the largest floating-point number")
          .Fix("Divide colours, strengths and background by a number");
      }
    }
    return Status::Success();
  }

private:
  std::vector<int> Exponents; // per channel
};
}

/// Prepared data.
struct VectorGraphics::Implementation
{
  double EstimateHeld() const;
  double EstimateRun(const std::vector<GraphicsCurve>& curves, int channels) const;
  Status AddBands(const std::vector<GraphicsCurve>& curves, const GraphicsOptions& options,
    const ProgressCallback& progress, std::vector<double>& values, std::string& warning) const;
  void MeasureNet(
    const std::vector<std::vector<double>>& columns, std::vector<double>& netSources) const;

  GraphicsDomain Domain;
  std::unique_ptr<PoissonSolver> Solver; // solver on Domain.SolvedMesh
  std::vector<CurveChain> Chains;
  GraphicsLoads Loads;
  bool HasPoisson = false; // true if there is a Poisson curve
};

double VectorGraphics::Implementation::EstimateHeld() const
{
  const auto faces = static_cast<double>(this->Domain.Solved.Surface.Faces.size());
  return faces * (HeldPerFace + (this->HasPoisson ? MorePerFace : 0.0)) +
    this->Loads.GetMemorySize() + this->Solver->GetEstimatedMemory();
}

/// Returns the memory while colors are computed. A band, and its equations, may cover the entire
/// surface.
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
  const GraphicsOptions& options, const ProgressCallback& progress, std::vector<double>& values,
  std::string& warning) const
{
  const int channels = options.NumberOfChannels;
  std::size_t blurred = 0; // number of curves
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
    DGG_RETURN_IF_ERROR(ReportTo(progress, begin));
    double contrast = 0.0;
    DGG_RETURN_IF_ERROR(AddBand(this->Domain.DrawnMesh,
      this->Domain.Drawn.Sides[this->Domain.SidesInDrawn[k]], this->Chains[k], curves[k], channels,
      *exact, ProgressPart(progress, begin, begin + 1.0 / count), values, contrast)
                          .Of(NameOf(curves[k], k)));
    if (contrast < SmallestContrast && curves[k].Left != curves[k].Right && blurred++ == 0)
    {
      warning = JoinText(NameOf(curves[k], k), " is short for its width of ", curves[k].Width,
        ": its sides blend around its ends, and at most ", std::lround(100.0 * contrast),
        " % of the difference between them remains");
    }
  }
  if (blurred > 0)
  {
    warning +=
      JoinText(blurred > 1 ? ". The same applies to " + Counted(blurred - 1, "other curve") : "",
        ". Use widths of at most half of the length of such curves, and much shorter edges");
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

VectorGraphics::VectorGraphics()
  : Internals(std::make_unique<Implementation>())
{
}

VectorGraphics::~VectorGraphics() = default;

Status VectorGraphics::Prepare(const SurfaceMesh& mesh, const SubMesh& surface,
  const std::vector<CurveChain>& chains, const std::vector<GraphicsCurve>& curves,
  const GraphicsOptions& options)
{
  Implementation& held = *this->Internals;
  held.Solver.reset();
  DGG_RETURN_IF_ERROR(ReportTo(options.Progress, 0.0));
  held.HasPoisson = std::any_of(curves.begin(), curves.end(),
    [](const GraphicsCurve& curve) { return curve.Type == GraphicsCurveType::Poisson; });
  held.Chains = chains;
  GraphicsMemoryCheck checkRegions;
  if (options.CheckMemory)
  {
    checkRegions = [&](double bytes, double) {
      const double all = BytesPerFace * static_cast<double>(surface.Faces.size()) + bytes;
      return options.CheckMemory(all, all);
    };
  }
  DGG_RETURN_IF_ERROR(CutForGraphics(mesh, surface, chains, curves, held.Domain));
  DGG_RETURN_IF_ERROR(ReportTo(options.Progress, CutDone));
  DGG_RETURN_IF_ERROR(held.Loads.Prepare(surface, mesh.GetNumberOfFaces(), chains, curves,
    checkRegions, ProgressPart(options.Progress, CutDone, MeasuredDone)));
  PoissonOptions poisson;
  poisson.IntrinsicDelaunay = options.IntrinsicDelaunay;
  poisson.DirichletVertices = FindDirichletVertices(held.Domain, chains, curves);
  held.Solver = std::make_unique<PoissonSolver>(held.Domain.SolvedMesh);
  return held.Solver->Prepare(
    poisson, ProgressPart(options.Progress, MeasuredDone, 1.0), [&](double, double missing) {
      const double run = held.EstimateRun(curves, options.NumberOfChannels);
      return options.CheckMemory ? options.CheckMemory(held.EstimateHeld() + run, missing + run)
                                 : Status::Success();
    });
}

Status VectorGraphics::Run(const std::vector<GraphicsCurve>& curves,
  const std::vector<GraphicsRegion>& regions, const GraphicsOptions& options,
  GraphicsResult& result)
{
  result = GraphicsResult();
  const Implementation& held = *this->Internals;
  if (!held.Solver || !held.Solver->IsReady() || curves.size() != held.Chains.size())
  {
    return InvalidInput("The surface is not prepared for these curves").Fix("Call Prepare() first");
  }
  if (options.CheckMemory)
  {
    // The number of channels may have changed.
    const double run = held.EstimateRun(curves, options.NumberOfChannels);
    DGG_RETURN_IF_ERROR(options.CheckMemory(held.EstimateHeld() + run, run));
  }
  DGG_RETURN_IF_ERROR(ReportTo(options.Progress, 0.0));
  const auto channels = static_cast<std::size_t>(options.NumberOfChannels);
  const std::size_t drawn = held.Domain.Drawn.Surface.Points.size();
  const ChannelScale scale(curves, regions, options);
  const std::vector<GraphicsCurve> scaled = scale.Apply(curves);
  const std::vector<double> background = scale.Apply(options.Background);
  std::vector<std::vector<double>> strengths;
  strengths.reserve(regions.size());
  for (const GraphicsRegion& region : regions)
  {
    strengths.push_back(scale.Apply(region.Strength));
  }
  std::vector<double> bands(channels * drawn, 0.0);
  std::string warning;
  DGG_RETURN_IF_ERROR(
    held.AddBands(scaled, options, ProgressPart(options.Progress, 0.0, BandsDone), bands, warning));
  std::vector<std::vector<double>> columns(
    channels, std::vector<double>(held.Domain.Solved.Surface.Points.size(), 0.0));
  DGG_RETURN_IF_ERROR(held.Loads.Add(held.Domain, held.Chains, scaled, regions, strengths,
    ProgressPart(options.Progress, BandsDone, SourcesDone), columns));
  DGG_RETURN_IF_ERROR(ReportTo(options.Progress, SourcesDone));
  std::vector<double> netSources;
  held.MeasureNet(columns, netSources);
  SetDirichletValues(held.Domain, held.Chains, scaled, bands, columns);
  DGG_RETURN_IF_ERROR(held.Solver->Solve(columns));
  DGG_RETURN_IF_ERROR(ReportTo(options.Progress, 1.0));
  const PoissonSystem& system = held.Solver->GetSystem();
  std::vector<Id> components(drawn);
  for (std::size_t d = 0; d < drawn; ++d)
  {
    const Id v = held.Domain.SolvedVertexOf[d];
    components[d] = system.GetComponent(v);
    const bool isFree = !background.empty() && system.IsFree(components[d]);
    for (std::size_t c = 0; c < channels; ++c)
    {
      bands[channels * d + c] += columns[c][v] + (isFree ? background[c] : 0.0);
    }
  }
  DGG_RETURN_IF_ERROR(scale.Undo(bands, "Colours"));
  DGG_RETURN_IF_ERROR(scale.Undo(netSources, "Net sources"));
  result = { std::move(bands), std::move(netSources), std::move(components), std::move(warning) };
  return Status::Success();
}

const SubMesh& VectorGraphics::GetSurface() const
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
