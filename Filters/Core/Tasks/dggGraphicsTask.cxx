// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggGraphicsTask.h"

#include "dggGraphicsFragments.h"
#include "dggProgressPart.h"
#include "dggPropertyChecks.h"
#include "dggSurfaceOutput.h"
#include "dggTaskContext.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace dgg
{
namespace
{
/// Progress after preparation, or after finding a kept preparation.
constexpr double FactorizedAt = 0.7;
constexpr double FoundAt = 0.01;
/// Progress within the preparation: after joining and embedding curves, and refinement.
constexpr double JoinedAt = 0.15;
constexpr double EmbeddedAt = 0.22;
constexpr double RefinedAt = 0.3;
/// Bytes per fragment, without colors.
constexpr double BytesPerFragment = sizeof(SurfacePoint) + 64.0;

constexpr const char* ShownName = "RGB";
constexpr const char* NetName = "NetSource";
constexpr const char* ComponentName = "Component"; // point array: tuple of NetName

/// Returns the bytes for the faces of the surface after refinement. Curves add a few faces.
double EstimateMesh(const SurfaceMesh& mesh, const GraphicsRefinement& refinement)
{
  double faces = 0.0;
  for (Id f = 0; f < mesh.GetNumberOfFaces(); ++f)
  {
    faces += mesh.IsDropped(f) ? 0.0 : 1.0;
  }
  return faces * VectorGraphics::BytesPerFace *
    (refinement.Part == RefinedPart::Everything ? std::pow(4.0, refinement.Levels) : 1.0);
}

/// Returns the approximate number of bytes per point of the output, including two triangles per
/// point.
double EstimateOutput(const GraphicsSettings& settings, int channels)
{
  constexpr double triangle = 4.0 * sizeof(Offset);
  return 3.0 * sizeof(double) + channels * sizeof(double) + 3.0 + sizeof(Offset) +
    settings.BytesPerPoint + 2.0 * (triangle + settings.BytesPerCell);
}

/// Writes points with their origins.
void WritePoints(
  const PreparedSurface& surface, const std::vector<SurfacePoint>& places, Output& output)
{
  WritePositions(surface, places, output);
  output.PointOrigins.emplace(places.size());
  std::transform(
    places.begin(), places.end(), output.PointOrigins->begin(), [&](const SurfacePoint& place) {
      return IsVertex(place)
        ? PointOrigin{ { { place.Vertex, NoId, NoId } }, {} }
        : PointOrigin{ surface.GetMesh().GetTriangle(place.Face), place.Barycentric };
    });
}

void WriteTriangles(const PreparedSurface& surface, const SubMesh& cut, Output& output)
{
  const std::size_t n = cut.Faces.size();
  output.Polygons.Offsets = Buffer<Offset>(n + 1);
  output.Polygons.Points = Buffer<Offset>(3 * n);
  std::copy(cut.Triangles.begin(), cut.Triangles.end(), output.Polygons.Points.begin());
  output.CellOrigins.emplace(n);
  for (std::size_t f = 0; f <= n; ++f)
  {
    output.Polygons.Offsets[f] = static_cast<Offset>(3 * f);
  }
  for (std::size_t f = 0; f < n; ++f)
  {
    if (surface.GetMesh().IsFlipped(cut.Faces[f]))
    {
      // same orientation as in the input
      std::swap(output.Polygons.Points[3 * f + 1], output.Polygons.Points[3 * f + 2]);
    }
    (*output.CellOrigins)[f] = surface.GetCell(cut.Faces[f]);
  }
}

/// Writes the values of points, all channels of a point in succession, and their colors for
/// display.
void WriteColors(
  const std::string& name, const std::vector<double>& values, int channels, Output& output)
{
  const auto count = static_cast<std::size_t>(channels);
  const std::size_t n = values.size() / count;
  output.PointData.AddValues<double>(name, values, channels);
  output.PointScalars = name;
  if (channels < 3)
  {
    return;
  }
  std::uint8_t* shown = output.PointData.Add<std::uint8_t>(ShownName, n, 3);
  output.PointScalars = ShownName;
  for (std::size_t v = 0; v < n; ++v)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      *shown++ = static_cast<std::uint8_t>(
        std::min(255.0, std::max(0.0, std::round(255.0 * values[v * count + c]))));
    }
  }
}

void WriteFragments(const PreparedSurface& surface, const GraphicsFragments& fragments,
  const std::string& name, int channels, Output& output)
{
  const std::size_t n = fragments.Places.size();
  WritePoints(surface, fragments.Places, output);
  WriteVerts(n, output);
  std::transform(fragments.Faces.begin(), fragments.Faces.end(),
    output.PointData.Add<Offset>("FaceId", n),
    [&](Id face) { return GetOriginalCell(surface, face); });
  WriteColors(name, fragments.Values, channels, output);
}
}

//------------------------------------------------------------------------------
bool GraphicsTask::Sketch::IsSame(const Sketch& other) const
{
  const auto isSameCurve = [](const GraphicsCurve& a, const GraphicsCurve& b) {
    return a.Type == b.Type && a.IsClosed == b.IsClosed;
  };
  return this->MeshBuild == other.MeshBuild && this->Sizes == other.Sizes &&
    this->Refinement.Levels == other.Refinement.Levels &&
    this->Refinement.Part == other.Refinement.Part &&
    this->Refinement.Faces == other.Refinement.Faces &&
    this->IsIntrinsicDelaunay == other.IsIntrinsicDelaunay &&
    std::equal(this->Curves.begin(), this->Curves.end(), other.Curves.begin(), other.Curves.end(),
      isSameCurve) &&
    std::equal(this->Places.begin(), this->Places.end(), other.Places.begin(), other.Places.end(),
      IsSamePoint);
}

//------------------------------------------------------------------------------
/// Draws the curves, refines and cuts the surface, factorizes the matrix.
Status GraphicsTask::Draw(const TaskContext& context, const Sketch& sketch,
  const GraphicsOptions& options, const std::string& remedy, const ProgressCallback& progress)
{
  const SurfaceMesh& mesh = context.Surface.GetMesh();
  const std::size_t count = sketch.Curves.size();
  DGG_RETURN_IF_ERROR(
    context.Memory.Check("The refined mesh", EstimateMesh(mesh, sketch.Refinement), remedy));
  std::vector<SurfaceCurve> joined(count);
  auto place = sketch.Places.begin();
  for (std::size_t k = 0; k < count; ++k)
  {
    const double part = JoinedAt / static_cast<double>(count);
    const double begin = static_cast<double>(k) * part;
    const auto end = place + static_cast<std::ptrdiff_t>(sketch.Sizes[k]);
    DGG_RETURN_IF_ERROR(JoinPoints(mesh, { place, end }, sketch.Curves[k].IsClosed,
      ProgressPart(progress, begin, begin + part), joined[k])
                          .Of(sketch.Curves[k].Name));
    place = end;
  }
  SubMesh refined;
  DGG_RETURN_IF_ERROR(
    EmbedCurves(mesh, joined, ProgressPart(progress, JoinedAt, EmbeddedAt), refined));
  GraphicsRefinement refinement = sketch.Refinement;
  refinement.MostFaces =
    static_cast<Offset>(std::min(context.Memory.GetBytes() / VectorGraphics::BytesPerFace,
      static_cast<double>(refinement.MostFaces)));
  refinement.Progress = ProgressPart(progress, EmbeddedAt, RefinedAt);
  const Status status = RefineForGraphics(mesh, refinement, refined, &this->RefinedFaces);
  if (!status.IsOk())
  {
    return status.GetCode() == Status::Code::OutOfMemory
      ? status.Fix(remedy, ", or raise {MemoryLimit}")
      : status;
  }
  std::vector<CurveChain> chains;
  for (std::size_t k = 0; k < count; ++k)
  {
    chains.push_back(FollowCurve(refined, joined, k));
  }
  GraphicsOptions own = options;
  own.Progress = ProgressPart(progress, RefinedAt, 1.0);
  return this->Graphics.Prepare(mesh, refined, chains, sketch.Curves, own);
}

//------------------------------------------------------------------------------
/// Draws the curves and keeps the result. After a failure nothing is kept.
Status GraphicsTask::Prepare(const TaskContext& context, const Sketch& sketch,
  const GraphicsOptions& options, const std::string& remedy, const ProgressCallback& progress)
{
  this->IsKept = false;
  this->Graphics.Clear();
  this->RefinedFaces = std::vector<Id>();
  this->Kept = Sketch();
  const Status status = this->Draw(context, sketch, options, remedy, progress);
  if (!status.IsOk())
  {
    this->Graphics.Clear();
    return status;
  }
  ++this->NumberOfFactorizations;
  this->Kept = sketch;
  for (GraphicsCurve& curve : this->Kept.Curves) // colors do not affect the factorization
  {
    curve.Left = std::vector<double>();
    curve.Right = std::vector<double>();
  }
  this->IsKept = true;
  return status;
}

//------------------------------------------------------------------------------
Status GraphicsTask::Run(const TaskContext& context, const GraphicsDrawing& drawing,
  const std::vector<SurfacePoint>& places, const GraphicsSettings& settings, Output& surface,
  Output& fragments)
{
  Sketch sketch;
  sketch.MeshBuild = context.Surface.GetBuildNumber();
  sketch.Curves = drawing.Curves;
  sketch.Places = places;
  sketch.Sizes = drawing.Sizes;
  sketch.Refinement.Levels = settings.RefinementLevel;
  sketch.Refinement.Part = settings.Refinement;
  sketch.Refinement.Faces = drawing.RefinedFaces;
  sketch.IsIntrinsicDelaunay = settings.IsIntrinsicDelaunay;

  const int channels = drawing.NumberOfChannels;
  GraphicsOptions options;
  options.NumberOfChannels = channels;
  options.Background = settings.Background;
  options.Background.resize(static_cast<std::size_t>(channels), 0.0);
  if (!std::all_of(options.Background.begin(), options.Background.end(),
        [](double x) { return std::isfinite(x); }))
  {
    return InvalidInput("{BackgroundColor} is not finite")
      .At("BackgroundColor")
      .Fix("Use finite numbers");
  }
  options.IntrinsicDelaunay = settings.IsIntrinsicDelaunay;
  options.CheckMemory = [&](double bytes, double missing) {
    const double points = static_cast<double>(this->Graphics.GetSurface().Points.size());
    const double own = !context.Memory.IsExplicit() ? missing : bytes;
    return context.Memory.Check("The factorization with the colors",
      own + points * EstimateOutput(settings, channels), settings.MemoryRemedy);
  };
  const bool isKept = this->IsKept && this->Kept.IsSame(sketch);
  const double prepared = isKept ? FoundAt : FactorizedAt;
  if (!isKept)
  {
    DGG_RETURN_IF_ERROR(this->Prepare(context, sketch, options, settings.MemoryRemedy,
      ProgressPart(context.Progress, 0.0, prepared)));
  }
  GraphicsResult result;
  options.Progress = ProgressPart(context.Progress, prepared, 1.0);
  DGG_RETURN_IF_ERROR(this->Graphics.Run(drawing.Curves, drawing.Regions, options, result));
  if (settings.WantFragments)
  {
    // Memory as fragments and as arrays.
    const double bytes = BytesPerFragment + 2.0 * channels * sizeof(double);
    const double count = static_cast<double>(this->RefinedFaces.size()) *
      std::pow(static_cast<double>(settings.FragmentDivision), 2);
    DGG_RETURN_IF_ERROR(context.Memory.Check("The output of fragments", count * bytes,
      "Use a smaller {FragmentDivision}, or refine near curves only"));
  }
  const SubMesh& cut = this->Graphics.GetSurface();
  WritePoints(context.Surface, cut.Points, surface);
  WriteTriangles(context.Surface, cut, surface);
  WriteColors(settings.ResultName, result.Values, channels, surface);
  surface.Warn(result.Warning);
  surface.FieldData.AddValues<double>(NetName, result.NetSources, channels);
  surface.PointData.AddValues<Offset>(ComponentName, result.Components);
  if (settings.WantFragments)
  {
    WriteFragments(context.Surface,
      MakeFragments(context.Surface.GetMesh(), cut, this->RefinedFaces, result.Values, channels,
        settings.FragmentDivision),
      settings.ResultName, channels, fragments);
  }
  return Status::Success();
}

//------------------------------------------------------------------------------
Status GraphicsTask::CheckName(const std::string& resultName)
{
  if (resultName != ShownName && resultName != ComponentName)
  {
    return CheckNames({ { "ResultArrayName", resultName } });
  }
  return InvalidInput(
    "{ResultArrayName} is '", resultName, "', the name of another array of the output")
    .At("ResultArrayName")
    .Fix("Use another name");
}

//------------------------------------------------------------------------------
void GraphicsTask::WriteEmpty(const std::string& resultName, Output& output)
{
  WriteColors(resultName, {}, 3, output);
  output.FieldData.AddValues<double>(NetName, std::vector<double>(), 3);
}
}
