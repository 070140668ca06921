// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggOffsetCurves.h"

#include "dggEdgeSplitting.h"
#include "dggExactGeodesics.h"
#include "dggIsolines.h"
#include "dggProgressPart.h"
#include "dggStatus.h"
#include "dggSurfaceRefinement.h"

#include <algorithm>
#include <cmath>

namespace dgg
{
namespace
{
/// Spacing of points on the path, as a fraction of half the width. The error of their distance is
/// at most an eighth of the square of the spacing.
constexpr double Spacing = 9e-3;
/// Maximum number of points on a path.
constexpr double MostSources = 1e5;
/// Maximum length of edges that an offset curve may cross, as a fraction of half the width.
constexpr double LongestEdge = 0.5;
/// Maximum distance of an offset curve from the exact curve, as a fraction of half the width: a
/// hundred times the error due to sampling of the path.
constexpr double ChordTolerance = 1e-3;
/// Length, as a fraction of half the width, below which closed curves are discarded.
constexpr double ShortestRim = 0.5;
/// Coarser spacings of the path while edges are split, as a fraction of the edges and as a fraction
/// of half the width.
constexpr double CoarseSpacing = 0.25;
constexpr double CoarsestSpacing = 0.1;
/// Maximum number of steps, each of which halves the longest edges. More steps would only be needed
/// for lengths that are practically zero.
constexpr int MostSteps = 100;

/// Returns points along a chain of vertices, at most `spacing` apart.
std::vector<GeodesicSource> SampleChain(
  const SurfaceMesh& mesh, const std::vector<Id>& chain, double spacing)
{
  std::vector<GeodesicSource> sources;
  for (std::size_t i = 0; i < chain.size(); ++i)
  {
    sources.push_back({ SurfacePoint::AtVertex(chain[i]), 0.0 });
    for (const Id* g = mesh.FanBegin(chain[i]); i + 1 < chain.size() && g != mesh.FanEnd(chain[i]);
         ++g)
    {
      const Id back = SurfaceMesh::Previous(*g);
      const bool isForward = mesh.Destination(*g) == chain[i + 1];
      if (!isForward && mesh.Origin(back) != chain[i + 1])
      {
        continue;
      }
      const Id h = isForward ? *g : back;
      const auto pieces = static_cast<int>(std::ceil(mesh.Length(h) / spacing));
      for (int k = 1; k < pieces; ++k)
      {
        sources.push_back({ SurfacePoint::OnEdge(mesh, h, static_cast<double>(k) / pieces), 0.0 });
      }
      break;
    }
  }
  return sources;
}

/// Returns a curve of the refined surface as a curve of the mesh, with all its points.
SurfacePath ToMesh(const SurfaceMesh& mesh, const SubMesh& refined, const SurfaceMesh& part,
  const SurfacePath& curve, bool isClosed)
{
  SurfacePath path;
  for (std::size_t i = 0; i < curve.Points.size(); ++i)
  {
    const Id face = curve.Faces[i > 0 ? i - 1 : 0];
    const SurfacePoint point = isClosed && i + 1 == curve.Points.size()
      ? path.Points.front()
      : refined.ToParent(mesh, part, face, curve.Points[i]);
    path.Append(mesh, point, refined.Faces[face]);
  }
  return path;
}

/// A surface that is split along a path, and the isolines of the distance from the path. Faces are
/// refined until faces that isolines may cross are small. Without refinement, many points on the
/// path in the same large faces would cost far more.
class OffsetCurveMaker
{
public:
  OffsetCurveMaker(const SurfaceMesh& mesh, double distance, const ProgressCallback& progress)
    : Mesh(mesh)
    , Distance(distance)
    , Progress(progress)
  {
  }

  Status Run(const SurfacePath& path, std::vector<SurfacePath>& rims)
  {
    RefinementOptions options;
    options.InsertCrossings = true; // self-crossings of the path
    DGG_RETURN_IF_ERROR(RefineAlongPaths(this->Mesh, { path }, options, this->Refined));
    this->Longest = this->Refined.Lengths.empty()
      ? 0.0
      : *std::max_element(this->Refined.Lengths.begin(), this->Refined.Lengths.end());
    bool isDone = false;
    for (int step = 0; step < MostSteps && !isDone; ++step)
    {
      DGG_RETURN_IF_ERROR(this->Step(isDone));
    }
    if (!isDone)
    {
      DGG_RETURN_IF_ERROR(this->Refined.Build(this->Mesh, this->Part)); // after the last split
    }
    return this->Trace(rims);
  }

private:
  /// Halves the longest edges. `isDone` becomes true if all edges are short enough.
  Status Step(bool& isDone)
  {
    DGG_RETURN_IF_ERROR(this->Refined.Build(this->Mesh, this->Part));
    if (!this->Report())
    {
      return Status::Abort();
    }
    const double spacing = std::max(Spacing * this->Distance,
      std::min(CoarseSpacing * this->Longest, CoarsestSpacing * this->Distance));
    const double left = 0.6 - this->Done;
    ExactOptions options;
    options.Progress = ProgressPart(this->Progress, this->Done, this->Done + 0.2 * left);
    ExactResult result;
    DGG_RETURN_IF_ERROR(this->Measure(spacing, this->Longest + spacing, options, result));
    this->Done += 0.2 * left;
    std::vector<char> isSplit(this->Refined.Triangles.size(), 0);
    isDone = !this->MarkLongEdges(result.Distances, spacing, isSplit);
    if (!isDone)
    {
      SplitEdges(this->Mesh, isSplit, this->Refined);
    }
    return this->Report() ? Status::Success() : Status::Abort();
  }

  bool Report() const { return !this->Progress || this->Progress(this->Done); }

  /// Computes distances from points of the path, up to the distance that isolines may reach, plus
  /// one edge.
  Status Measure(double spacing, double longest, ExactOptions& options, ExactResult& result) const
  {
    options.MaximumDistance = this->Distance + longest;
    return ExactGeodesics(this->Part)
      .Run(SampleChain(this->Part, this->Refined.Paths.front(), spacing), options, result);
  }

  /// Marks edges on which the distance may be attained, given the distances of their ends. Returns
  /// true if an edge is marked.
  bool MarkLongEdges(
    const std::vector<double>& distances, double spacing, std::vector<char>& isSplit)
  {
    const auto size = static_cast<Id>(isSplit.size());
    std::vector<char> mayBeCrossed(size, 0);
    double longest = 0.0;
    for (Id h = 0; h < size; ++h)
    {
      const double length = this->Refined.Lengths[h];
      const double sum =
        distances[this->Refined.Origin(h)] + distances[this->Refined.Destination(h)];
      mayBeCrossed[h] = 0.5 * (sum - length) - spacing <= this->Distance &&
        0.5 * (sum + length) + spacing >= this->Distance;
      longest = mayBeCrossed[h] ? std::max(longest, length) : longest;
    }
    const double target = std::max(LongestEdge * this->Distance, 0.5 * longest);
    bool isAny = false;
    for (Id h = 0; h < size; ++h)
    {
      if (mayBeCrossed[h] && this->Refined.Lengths[h] > target)
      {
        isSplit[h] = 1;
        isAny = true;
      }
    }
    this->Longest = std::min(this->Longest, longest);
    return isAny;
  }

  Status Trace(std::vector<SurfacePath>& rims) const
  {
    ExactOptions options;
    options.KeepWindows = true;
    options.Progress = ProgressPart(this->Progress, 0.6, 0.8);
    ExactResult result;
    DGG_RETURN_IF_ERROR(this->Measure(Spacing * this->Distance, this->Longest, options, result));
    const DistanceField field{ &this->Part, result.Distances.data(), &result.Windows, nullptr };
    IsolineOptions isolineOptions;
    isolineOptions.ChordTolerance = ChordTolerance * this->Distance;
    Isolines isolines;
    DGG_RETURN_IF_ERROR(TraceIsolines(field, { this->Distance }, isolineOptions, ParallelFor(),
      ProgressPart(this->Progress, 0.8, 1.0), isolines));
    for (std::size_t i = 0; i < isolines.Lines.size(); ++i)
    {
      if (!isolines.IsClosed[i] || isolines.Lines[i].Length >= ShortestRim * this->Distance)
      {
        rims.push_back(
          ToMesh(this->Mesh, this->Refined, this->Part, isolines.Lines[i], isolines.IsClosed[i]));
      }
    }
    return Status::Success();
  }

  const SurfaceMesh& Mesh;
  const double Distance;
  const ProgressCallback& Progress;
  SubMesh Refined;
  SurfaceMesh Part;
  double Longest = 0.0; // longest edge that an offset curve may have crossed before the last step
  double Done = 0.0;    // progress so far
};
}

Status MakeOffsetCurves(const SurfaceMesh& mesh, const SurfacePath& path, double width,
  const ProgressCallback& progress, std::vector<SurfacePath>& rims)
{
  rims.clear();
  if (!(width > 0.0 && std::isfinite(width)))
  {
    return InvalidInput("The width of the tape is ", width)
      .At("TapeWidth")
      .Fix("Use a finite positive number");
  }
  if (width < GetSmallestOffsetWidth(path))
  {
    return InvalidInput("The width of the tape is ", width, ", too small for the length ",
      path.Length, " of the curve")
      .At("TapeWidth")
      .Fix("Use a width of at least ", GetSmallestOffsetWidth(path));
  }
  Status status = OffsetCurveMaker(mesh, 0.5 * width, progress).Run(path, rims);
  if (!status.IsOk())
  {
    rims.clear();
  }
  return status;
}

double GetSmallestOffsetWidth(const SurfacePath& path)
{
  return 2.0 * path.Length / (MostSources * Spacing);
}
}
