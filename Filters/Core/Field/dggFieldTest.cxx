// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggFieldTest.h"

#include "dggDisjointSets.h"
#include "dggExactGeodesics.h"
#include "dggFastMarching.h"
#include "dggGeodesicSource.h"
#include "dggProgressPart.h"
#include "dggSteepestDescent.h"
#include "dggUnfolding.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>
#include <vector>

namespace dgg
{
namespace
{
/// A slope within this part of the expected one is as expected; so is a way within this part of the
/// distance.
constexpr double Tolerance = 0.1;
/// Most of the vertices that may be clearly nearer than their way from the minima. Measured: 0.09
/// for exact distances on scans and CAD models from up to three sources per vertex, 0.17 on coarse
/// ones, 0.09 for heat; 0.22 and more for coordinates, but for shapes along which a coordinate is
/// nearly a distance.
constexpr double LargestShortShare = 0.2;
/// Most of them that may be clearly farther away. Measured: 0.37 for heat at its worst, and 0.22 to
/// 0.8 for the root of a distance, which is told by its slopes.
constexpr double LargestFarShare = 0.2;
/// Part of the vertices with the expected slope from which on that counts as the slope of the
/// field. Measured: 0.6 and more for distances from few sources, 0.1 for the root of a distance.
constexpr double SmallestShare = 0.5;
/// Most of the edges that may be steeper than that. Measured: 0.074 for heat.
constexpr double LargestSteepShare = 0.1;
/// Differences below this part of what the values span are rounding.
constexpr double Rounding = 1e-6;
/// And below these parts of the values themselves, which may be far from 0: of values that are all
/// floats, and of others. So are those below the latter part of the longest edge, as distances are
/// sums of lengths; values that small may have lost all their digits.
constexpr double RoundingOfFloats = 2.4e-7;
constexpr double RoundingOfDoubles = 1e-14;
/// As many vertices may be equally far away from sources in the faces between them.
constexpr Offset FewVertices = 32;
/// From so many vertices on the steepest edge of a distance tells its unit, and few minima that
/// there are few sources.
constexpr Offset ManyVertices = 100;
/// With fewer, it is at least so steep somewhere.
constexpr double SmallestCoarseSlope = 0.5;
/// Most of the vertices that may be equally far away as all their neighbours and yet no minima: as
/// distances fall from everywhere, there are none but by rare chance, and many on CAD models when
/// the field is a coordinate.
constexpr double LargestFlatShare = 0.05;
/// What the way from a minimum may be too long, as the source may be in a face beside it: where the
/// minima are far from each other, in what the way to a neighbour is too long, and in edges; where
/// they are not, so that another source may hide the minimum, in edges at the minimum and at the
/// vertex.
constexpr double SlackOfGap = 1.25;
constexpr double SlackBesideGap = 0.1;
constexpr double SlackAtMinimum = 2.0;
constexpr double SlackAtVertex = 0.5;
/// A distance that comes in from the boundary rises at least so steeply to some neighbour.
constexpr double SlopeOfEntry = 0.5;
/// Minima are far from each other when each has so many vertices.
constexpr double VerticesOfMinimum = 25.0;
/// And when not so many vertices must have sources in the faces around them. Measured: 0.2 for
/// coordinates.
constexpr double LargestHiddenShare = 0.4;
/// Ways are exact on meshes with up to so many faces.
constexpr Id FacesOfCoarseMesh = 2000;
/// Share of the progress when slopes are known.
constexpr double SlopesDone = 0.3;

/// Slopes along edges and down from vertices.
struct Slopes
{
  std::vector<double> OfEdges;
  std::vector<double> FromVertices;

  /// The part of the vertices whose slope is about that.
  double ShareNear(double slope) const
  {
    return Share(
      this->FromVertices, [=](double s) { return std::abs(s - slope) <= Tolerance * slope; });
  }
  /// The part of the edges that are clearly steeper.
  double ShareAbove(double slope) const
  {
    return Share(this->OfEdges, [=](double s) { return s > (1.0 + Tolerance) * slope; });
  }

private:
  template <typename Predicate>
  static double Share(const std::vector<double>& slopes, const Predicate& predicate)
  {
    return slopes.empty()
      ? 0.0
      : static_cast<double>(std::count_if(slopes.begin(), slopes.end(), predicate)) /
        static_cast<double>(slopes.size());
  }
};

/// The finite values.
struct Range
{
  double Least = Infinity;
  double Greatest = -Infinity;
  double Rounding = 0.0; // differences up to that mean nothing

  Range(const SurfaceMesh& mesh, const double* values)
  {
    bool areFloats = true;
    for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
    {
      if (std::isfinite(values[v]))
      {
        this->Least = std::min(this->Least, values[v]);
        this->Greatest = std::max(this->Greatest, values[v]);
        areFloats = areFloats && std::abs(values[v]) <= std::numeric_limits<float>::max() &&
          static_cast<double>(static_cast<float>(values[v])) == values[v];
      }
    }
    const double largest = std::max(std::abs(this->Least), std::abs(this->Greatest));
    this->Rounding = std::max(RoundingOfDoubles * mesh.GetMaximumEdgeLength(),
      dgg::Rounding * (this->Greatest - this->Least) +
        (areFloats ? RoundingOfFloats : RoundingOfDoubles) * largest);
  }
};

Slopes CollectSlopes(const SurfaceMesh& mesh, const double* values)
{
  const double rounding = Range(mesh, values).Rounding;
  Slopes slopes;
  for (Id h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
  {
    const double difference = std::abs(values[mesh.Destination(h)] - values[mesh.Origin(h)]);
    if (!mesh.IsDropped(SurfaceMesh::Face(h)) && std::isfinite(difference))
    {
      slopes.OfEdges.push_back(std::max(0.0, difference - rounding) / mesh.Length(h));
    }
  }
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    const SteepestDescent descent = FindSteepestDescent(mesh, values, v);
    if (descent.IsKnown)
    {
      slopes.FromVertices.push_back(descent.Slope);
    }
  }
  return slopes;
}

/// Where a distance with these values may start: at its minima, equal neighbours together, and
/// where it comes in from what is not known or not there.
class MinimumFinder
{
public:
  MinimumFinder(const SurfaceMesh& mesh, const double* values)
    : Mesh(mesh)
    , Values(values)
    , Known(mesh, values)
    , Plateaus(mesh.GetNumberOfVertices())
    , Longest(mesh.GetNumberOfVertices(), 0.0)
    , Gaps(mesh.GetNumberOfVertices(), 0.0)
    , IsRim(mesh.GetNumberOfVertices(), 0)
    , Rises(mesh.GetNumberOfVertices(), 0)
    , IsEven(mesh.GetNumberOfVertices(), 1)
  {
    for (Id h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
    {
      if (!mesh.IsDropped(SurfaceMesh::Face(h)))
      {
        this->LookAt(h, mesh.Origin(h), mesh.Destination(h));
        this->LookAt(h, mesh.Destination(h), mesh.Origin(h));
      }
    }
  }

  /// Their distances count from the least value on. `hasHidden` tells that sources may be so dense
  /// that hardly any is seen.
  std::vector<GeodesicSource> Find(bool hasHidden)
  {
    const Id n = this->Mesh.GetNumberOfVertices();
    this->FindLowPlateaus();
    std::vector<GeodesicSource> minima;
    Offset groups = 0;
    for (Id v = 0; v < n; ++v)
    {
      if (std::isfinite(this->Values[v]) && this->Longest[v] > 0.0 &&
        (this->IsLow[this->Plateaus.Find(v)] || this->ComesIn(v)))
      {
        minima.push_back(this->SourceAt(v));
        groups += this->Plateaus.Find(v) == v && this->IsLow[v] ? 1 : 0;
      }
    }
    const std::vector<GeodesicSource> hidden = this->FindHidden(minima);
    const bool areHidden = hasHidden &&
      this->Known.Greatest - this->Known.Least <= this->Mesh.GetMaximumEdgeLength() &&
      static_cast<double>(hidden.size()) >= LargestHiddenShare * n;
    this->AreFew = VerticesOfMinimum * static_cast<double>(groups) < n && !areHidden;
    this->AreSparse = this->AreFew && n > ManyVertices;
    if (!this->AreSparse)
    {
      minima.insert(minima.end(), hidden.begin(), hidden.end());
    }
    return minima;
  }

  /// The part of the vertices with neighbours that are even with all of them, and no minima: these
  /// are as far away as each other, while gentle slopes may join any number of steps. After Find().
  double FindFlatShare()
  {
    const double fewSteps = 4.0;
    const double few = fewSteps * this->Known.Rounding;
    Offset count = 0;
    Offset flat = 0;
    for (Id v = 0; v < this->Mesh.GetNumberOfVertices(); ++v)
    {
      if (std::isfinite(this->Values[v]) && this->Longest[v] > 0.0)
      {
        ++count;
        const Id plateau = this->Plateaus.Find(v);
        const bool isMinimum =
          this->IsLow[plateau] && this->Values[v] <= this->Least[plateau] + few;
        flat += this->IsEven[v] && !isMinimum ? 1 : 0;
      }
    }
    return static_cast<double>(flat) / static_cast<double>(std::max<Offset>(1, count));
  }

  /// By how much the way from a minimum may be too long.
  double SlackOf(Id minimum, Id v) const
  {
    return this->AreSparse
      ? SlackOfGap * this->Gaps[minimum] + SlackBesideGap * this->Longest[minimum]
      : SlackAtMinimum * this->Longest[minimum] + SlackAtVertex * this->Longest[v];
  }
  /// Whether there are few minima for the number of vertices.
  bool HasFew() const { return this->AreFew; }
  double GetLeast() const { return this->Known.Least; }

private:
  /// Those from which no edge leads below their least value. There is one at least, as gentle
  /// slopes may join what is far apart to a plateau, but the least value of all is nowhere below.
  void FindLowPlateaus()
  {
    const Id n = this->Mesh.GetNumberOfVertices();
    this->Least.assign(n, Infinity);
    for (Id v = 0; v < n; ++v)
    {
      double& value = this->Least[this->Plateaus.Find(v)];
      value = std::min(value, this->Values[v]);
    }
    this->IsLow.assign(n, 1);
    auto compare = [&](Id from, Id to) {
      const Id plateau = this->Plateaus.Find(from);
      if (this->Plateaus.Find(to) != plateau && this->Values[to] < this->Least[plateau])
      {
        this->IsLow[plateau] = 0;
      }
    };
    for (Id h = 0; h < this->Mesh.GetNumberOfHalfEdges(); ++h)
    {
      if (!this->Mesh.IsDropped(SurfaceMesh::Face(h)))
      {
        compare(this->Mesh.Origin(h), this->Mesh.Destination(h));
        compare(this->Mesh.Destination(h), this->Mesh.Origin(h));
      }
    }
  }

  /// From one vertex to its neighbour.
  void LookAt(Id h, Id from, Id to)
  {
    const double length = this->Mesh.Length(h);
    this->Longest[from] = std::max(this->Longest[from], length);
    if (this->Mesh.Twin(h) == NoId || !std::isfinite(this->Values[to]))
    {
      this->IsRim[from] = 1;
    }
    const double fall = this->Values[from] - this->Values[to];
    if (!std::isfinite(fall))
    {
      return;
    }
    if (std::abs(fall) <= this->Known.Rounding)
    {
      this->Plateaus.Join(from, to);
      return;
    }
    this->IsEven[from] = 0;
    this->Gaps[from] = std::max(this->Gaps[from], std::min(2.0 * length, length + fall));
    this->Rises[from] |= -fall >= SlopeOfEntry * length ? 1 : 0;
  }

  /// No way from beyond the faces around a vertex is as short as its value, if values on the rim of
  /// these faces are as small as can be: there is a source in one of the faces.
  std::vector<GeodesicSource> FindHidden(const std::vector<GeodesicSource>& minima) const
  {
    std::vector<double> reach(this->Longest.size(), Infinity);
    std::vector<char> isKnown(this->Longest.size(), 1); // all around
    for (Id h = 0; h < this->Mesh.GetNumberOfHalfEdges(); ++h)
    {
      if (this->Mesh.IsDropped(SurfaceMesh::Face(h)))
      {
        continue;
      }
      const Id v = this->Mesh.Apex(h);
      const double length = this->Mesh.Length(h);
      const double first = this->Values[this->Mesh.Origin(h)];
      const double second = this->Values[this->Mesh.Destination(h)];
      if (!std::isfinite(first) || !std::isfinite(second))
      {
        isKnown[v] = 0;
        continue;
      }
      // Values fall by 1 at most from either end; the best point is where both come down to the
      // same.
      const double x = std::max(0.0, std::min(length, 0.5 * (length + first - second)));
      reach[v] = std::min(reach[v],
        std::max(first - x, second - (length - x)) +
          Norm(this->Mesh.ApexX(h) - x, this->Mesh.ApexY(h)));
    }
    std::vector<GeodesicSource> found;
    for (const GeodesicSource& minimum : minima)
    {
      isKnown[minimum.Point.Vertex] = 0; // once is enough
    }
    for (Id v = 0; v < this->Mesh.GetNumberOfVertices(); ++v)
    {
      if (std::isfinite(this->Values[v]) && isKnown[v] && reach[v] < Infinity &&
        reach[v] > this->Values[v] + this->Known.Rounding)
      {
        found.push_back(this->SourceAt(v));
      }
    }
    return found;
  }

  GeodesicSource SourceAt(Id v) const
  {
    GeodesicSource source;
    source.Point = SurfacePoint::AtVertex(v);
    source.InitialDistance = this->Values[v] - this->Known.Least;
    return source;
  }

  bool ComesIn(Id v) const
  {
    return this->IsRim[v] && this->Rises[v] &&
      FindSteepestDescent(this->Mesh, this->Values, v).Slope < 1.0 - Tolerance;
  }

  const SurfaceMesh& Mesh;
  const double* Values;
  const Range Known;
  DisjointSets Plateaus;
  std::vector<double> Longest; // of the edges of a vertex
  std::vector<double> Gaps;    // the way to a neighbour less the difference there
  std::vector<char> IsRim;
  std::vector<char> Rises;   // to a neighbour, clearly
  std::vector<char> IsEven;  // with all neighbours
  std::vector<char> IsLow;   // per plateau
  std::vector<double> Least; // per plateau
  bool AreFew = false;
  bool AreSparse = false; // minima
};

/// How values compare to the ways from their minima.
struct WayShares
{
  Offset Count = 0; // of vertices that are no minima
  double Short = 0.0;
  double Far = 0.0;
  double Flat = 0.0; // of all vertices
  bool HasFewMinima = false;
};

/// By fast marching, or exactly where that is as fast, as fast marching errs on coarse meshes.
Status FindWays(const SurfaceMesh& mesh, const std::vector<GeodesicSource>& minima,
  const ProgressCallback& progress, std::vector<double>& ways, std::vector<Id>& sources)
{
  if (mesh.GetNumberOfFaces() <= FacesOfCoarseMesh)
  {
    ExactOptions options;
    options.Progress = progress;
    ExactResult result;
    Status status = ExactGeodesics(mesh).Run(minima, options, result);
    ways = std::move(result.Distances);
    sources = std::move(result.NearestSource);
    return status;
  }
  MarchingOptions options;
  options.Progress = progress;
  MarchingResult result;
  Status status = FastMarching(mesh).Run(minima, options, result);
  ways = std::move(result.Distances);
  sources = std::move(result.NearestSource);
  return status;
}

Status CompareWithWays(const SurfaceMesh& mesh, const double* values, bool hasHidden,
  const ProgressCallback& progress, WayShares& shares)
{
  shares = WayShares();
  const Range known(mesh, values);
  if (!std::isfinite(known.Greatest - known.Least))
  {
    shares.Short = 1.0; // farther apart than any way is long
    return Status::Success();
  }
  MinimumFinder finder(mesh, values);
  const std::vector<GeodesicSource> minima = finder.Find(hasHidden);
  shares.Flat = finder.FindFlatShare();
  shares.HasFewMinima = finder.HasFew();
  std::vector<double> ways;
  std::vector<Id> sources;
  Status status = FindWays(mesh, minima, progress, ways, sources);
  if (!status.IsOk())
  {
    return status;
  }
  Offset tooShort = 0;
  Offset tooFar = 0;
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    const Id nearest = sources[v];
    if (!std::isfinite(values[v]) || nearest == NoId)
    {
      continue;
    }
    const double way = ways[v] - minima[nearest].InitialDistance;
    if (way > 0.0)
    {
      const double difference = values[v] - finder.GetLeast() - ways[v];
      const double slack = finder.SlackOf(minima[nearest].Point.Vertex, v) + Tolerance * way;
      ++shares.Count;
      tooShort += difference < -slack ? 1 : 0;
      tooFar += difference > slack ? 1 : 0;
    }
  }
  const auto count = static_cast<double>(std::max<Offset>(1, shares.Count));
  shares.Short = static_cast<double>(tooShort) / count;
  shares.Far = static_cast<double>(tooFar) / count;
  return progress && !progress(1.0) ? Status::Abort() : status;
}

std::string WithNumber(const char* format, double number)
{
  char text[256];
  std::snprintf(text, sizeof(text), format, number);
  return text;
}
/// Slopes of the whole field.
void Summarize(Slopes& slopes, FieldReport& report)
{
  const auto middle = slopes.FromVertices.begin() + report.NumberOfVertices / 2;
  std::nth_element(slopes.FromVertices.begin(), middle, slopes.FromVertices.end());
  report.MedianSlope = *middle;
  report.WorstSlope = *std::max_element(slopes.OfEdges.begin(), slopes.OfEdges.end());
  report.ShareOfSteepEdges = slopes.ShareAbove(1.0);
  report.ShareOfUnitSlopes = slopes.ShareNear(1.0);
}

/// Why a field is no distance; empty when it is one.
std::string FindFault(const FieldReport& report, const WayShares& ways, bool hasScale)
{
  const std::string start = "The field is hardly a distance: ";
  const std::string end = ". Pass the distance itself, in the units of the points.";
  const double percent = 100.0;
  const bool hasUnitSlopes = report.ShareOfUnitSlopes >= SmallestShare;
  if (ways.Count == 0 && report.NumberOfVertices > FewVertices)
  {
    return start + "it is about the same at all points" + end;
  }
  if (report.ShareOfSteepEdges > LargestSteepShare)
  {
    return start +
      WithNumber("along %.0f %% of the edges it changes by more than their length",
        percent * report.ShareOfSteepEdges) +
      end;
  }
  // Nowhere steeper than what is usual, which is less than it should be; by far less on coarse
  // meshes.
  const double scale = report.MedianSlope;
  const bool isCoarse = report.NumberOfVertices <= ManyVertices;
  if (hasScale && ways.HasFewMinima && report.NumberOfVertices > FewVertices &&
    scale < (isCoarse ? SmallestCoarseSlope : 1.0 - Tolerance) &&
    report.WorstSlope < (1.0 + 0.5 * Tolerance) * scale)
  {
    return start + WithNumber("it changes by %.2g per unit of length at most", report.WorstSlope) +
      end;
  }
  if (ways.Flat > LargestFlatShare)
  {
    return start +
      WithNumber(
        "%.0f %% of the points are as far away as all their neighbours", percent * ways.Flat) +
      end;
  }
  if (ways.Short > LargestShortShare)
  {
    return start +
      WithNumber("on %.0f %% of the points it is clearly less than the way from its minima",
        percent * ways.Short) +
      end;
  }
  if (ways.Far > LargestFarShare && !hasUnitSlopes)
  {
    return start +
      WithNumber("on %.0f %% of the points it is clearly more than the way from its minima",
        percent * ways.Far) +
      end;
  }
  return std::string();
}
}

Status TestField(const SurfaceMesh& mesh, const double* values, const ProgressCallback& progress,
  FieldReport& report)
{
  report = FieldReport();
  Slopes slopes = CollectSlopes(mesh, values);
  report.NumberOfEdges = static_cast<Offset>(slopes.OfEdges.size());
  report.NumberOfVertices = static_cast<Offset>(slopes.FromVertices.size());
  if (slopes.FromVertices.empty())
  {
    report.Sentence = "The field is not known at any two neighbouring points: pass finite values.";
    return Status::Success();
  }
  Summarize(slopes, report);
  if (progress && !progress(SlopesDone))
  {
    return Status::Abort();
  }
  const double halfWay = 0.5 * (1.0 + SlopesDone);
  const double scale = report.MedianSlope;
  const bool hasScale = slopes.ShareNear(scale) >= SmallestShare;
  WayShares ways;
  Status status =
    CompareWithWays(mesh, values, !hasScale, ProgressPart(progress, SlopesDone, halfWay), ways);
  if (!status.IsOk())
  {
    return status;
  }
  report.ShareOfShortcuts = ways.Short;
  report.ShareOfFlatVertices = ways.Flat;
  report.Sentence = FindFault(report, ways, hasScale);
  if (report.Sentence.empty())
  {
    report.Verdict = FieldVerdict::Distance;
    return status;
  }
  report.Verdict = FieldVerdict::NotADistance;
  if (scale > 0.0 && hasScale && std::abs(scale - 1.0) > Tolerance &&
    slopes.ShareAbove(scale) <= LargestSteepShare)
  {
    std::vector<double> scaled(values, values + mesh.GetNumberOfVertices());
    std::for_each(scaled.begin(), scaled.end(), [=](double& value) { value /= scale; });
    WayShares scaledWays;
    status =
      CompareWithWays(mesh, scaled.data(), false, ProgressPart(progress, halfWay, 1.0), scaledWays);
    if (status.IsOk() && scaledWays.Short <= LargestShortShare &&
      scaledWays.Flat <= LargestFlatShare)
    {
      report.Verdict = FieldVerdict::Scaled;
      report.Sentence = WithNumber("The field seems to be a distance in other units than those of "
                                   "the points: divide it by about %.3g.",
        scale);
    }
  }
  return status;
}
}
