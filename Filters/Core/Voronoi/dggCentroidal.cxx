// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggCentroidal.h"

#include "dggCloudFrame.h"
#include "dggForest.h"
#include "dggGraphSeeds.h"
#include "dggStraightWalk.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace dgg
{
namespace
{
/// Lloyd's iteration from a current state. `energies` receives the energy at the start and after
/// each step that decreases it; after other steps, the step size is halved.
template <typename Centers>
Status Iterate(Centers& centers, const CentroidalOptions& options, typename Centers::State& current,
  std::vector<double>& energies)
{
  double reported = 0.0; // never decreases, although a step may search several times
  const auto report = [&](double done) {
    reported = std::max(reported, std::min(1.0, done / (options.NumberOfIterations + 1)));
    return !options.Progress || options.Progress(reported);
  };
  const auto within = [&report](double start) {
    return [&report, start](double part) { return report(start + 0.99 * part); };
  };
  Status status = centers.Evaluate(current, within(0.0));
  energies.assign(1, current.Energy);
  double part = 1.0;
  int halvings = 0;
  for (int i = 1; status.IsOk() && i <= options.NumberOfIterations &&
       halvings <= Centers::MostHalvings && !centers.IsSettled(current, options.Tolerance);)
  {
    if (!report(i))
    {
      return Status::Abort();
    }
    typename Centers::State next;
    status = centers.Step(current, part, within(i), next);
    if (status.IsOk() && next.Energy < current.Energy)
    {
      std::swap(current, next);
      energies.push_back(current.Energy);
      part = std::min(1.0, 2.0 * part);
      halvings = 0;
      ++i;
    }
    else
    {
      part *= 0.5;
      ++halvings;
    }
  }
  return status;
}

/// Lloyd's iteration on a surface.
class SurfaceCenters
{
public:
  /// Number of halvings of the step before the iteration ends.
  static constexpr int MostHalvings = 6;

  /// Sites, and the means of their cells.
  struct State
  {
    std::vector<SurfacePoint> Sites;
    std::vector<double> Angles;  ///< per site, direction to the mean of its cell
    std::vector<double> Lengths; ///< per site, distance to the mean of its cell
    double Energy = Infinity;
  };

  SurfaceCenters(const GraphSearch& search, const SurfaceMesh& mesh, const GraphBuilder& builder,
    double accuracy)
    : Search(search)
    , Mesh(mesh)
    , Builder(builder)
    , Accuracy(accuracy)
    , Areas(mesh.GetNumberOfVertices(), 0.0)
  {
    for (Id h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
    {
      const Id first = h - h % 3;
      if (!mesh.IsDropped(SurfaceMesh::Face(h)))
      {
        this->Areas[mesh.Origin(h)] += mesh.Length(first) * mesh.ApexY(first) / 6.0;
      }
    }
  }

  /// Computes the energy and the means of a state.
  Status Evaluate(State& state, const ProgressCallback& progress)
  {
    LinkedSites linked;
    DGG_RETURN_IF_ERROR(LinkSites(state.Sites, &this->Builder, this->Accuracy, linked));
    SearchOptions options;
    options.Correct = true;
    options.Progress = progress;
    DGG_RETURN_IF_ERROR(this->Search.Run(linked.Seeds, options, this->Result));
    if (this->Result.Corrected.empty())
    {
      return InvalidInput("The graph has no directions, which moving sites needs")
        .Fix("Use the graph of a mesh");
    }
    // The direction in which the path to each vertex leaves its site.
    this->Directions.assign(this->Mesh.GetNumberOfVertices(), 0.0);
    for (const Id v : SortForest(this->Result.Tails))
    {
      if (this->Result.Seeds[v] != NoId)
      {
        this->Directions[v] = this->FindDirection(v, linked);
      }
    }
    const std::size_t count = state.Sites.size();
    std::vector<Point2> sums(count);
    std::vector<double> weights(count, 0.0);
    state.Energy = 0.0;
    for (Id v = 0; v < this->Mesh.GetNumberOfVertices(); ++v)
    {
      const Id seed = this->Result.Seeds[v];
      if (seed == NoId)
      {
        continue;
      }
      const Id site = linked.Seeds[seed].Source;
      const double distance = this->Result.Corrected[v];
      const double area = this->Areas[v];
      const double angle = UnrollFactor(this->Mesh, state.Sites[site]) * this->Directions[v];
      state.Energy += area * distance * distance;
      sums[site].X += area * distance * std::cos(angle);
      sums[site].Y += area * distance * std::sin(angle);
      weights[site] += area;
    }
    state.Angles.assign(count, 0.0);
    state.Lengths.assign(count, 0.0);
    for (std::size_t i = 0; i < count; ++i)
    {
      if (weights[i] > 0.0)
      {
        // Divided first: squares of sums would exceed the range of numbers.
        state.Lengths[i] = Norm(sums[i].X / weights[i], sums[i].Y / weights[i]);
        state.Angles[i] = DirectionAt(this->Mesh, state.Sites[i],
          std::atan2(sums[i].Y, sums[i].X) / UnrollFactor(this->Mesh, state.Sites[i]));
      }
    }
    return Status::Success();
  }

  /// Returns true if no site would move far.
  bool IsSettled(const State& state, double tolerance) const
  {
    const auto farthest = std::max_element(state.Lengths.begin(), state.Lengths.end());
    return (farthest == state.Lengths.end() ? 0.0 : *farthest) <=
      tolerance * this->Mesh.GetMeanEdgeLength();
  }

  /// Moves the sites by a fraction of the distance to the means.
  Status Step(const State& from, double part, const ProgressCallback& progress, State& to)
  {
    SurfacePath path;
    for (std::size_t i = 0; i < from.Sites.size(); ++i)
    {
      DGG_RETURN_IF_ERROR(
        WalkStraight(this->Mesh, from.Sites[i], from.Angles[i], part * from.Lengths[i], path));
      to.Sites.push_back(path.Points.back());
    }
    return this->Evaluate(to, progress);
  }

private:
  /// Returns the direction of a vertex, given the direction of its tail.
  double FindDirection(Id v, const LinkedSites& linked) const
  {
    const SearchResult& result = this->Result;
    const Id u = result.Tails[v];
    const Id seed = result.Seeds[v];
    if (u == NoId)
    {
      return linked.Departures[seed];
    }
    const GraphView& graph = this->Search.GetGraph();
    const Offset edge = result.Edges[v];
    if (result.Tails[u] == NoId && linked.Seeds[seed].ArrivalAngle < 0.0)
    {
      return graph.Angles[edge]; // first edge: from the site itself, a vertex
    }
    // Like the distance, the path is straight as long as its virtual source is the site.
    if (result.Virtual[v].Offset != 0.0 || result.Virtual[u].Offset != 0.0)
    {
      return this->Directions[u];
    }
    const double total = this->Mesh.TotalAngle(u);
    double turn = graph.Angles[edge] - result.Virtual[u].Angle;
    if (this->Mesh.Kind(u) != VertexKind::Boundary)
    {
      turn -= total * std::rint(turn / total);
    }
    if (std::abs(turn) >= Pi)
    {
      return this->Directions[u];
    }
    const double length = graph.Length(edge);
    return this->Directions[u] -
      std::atan2(length * std::sin(turn), result.Virtual[u].Length - length * std::cos(turn));
  }

  const GraphSearch& Search;
  const SurfaceMesh& Mesh;
  const GraphBuilder& Builder;
  double Accuracy;
  std::vector<double> Areas; ///< per vertex
  SearchResult Result;
  std::vector<double> Directions; ///< per vertex, at its site
};

/// Lloyd's iteration on a cloud.
class CloudCenters
{
public:
  /// Number of halvings of the step; smaller steps are useless.
  static constexpr int MostHalvings = 5;

  /// Sites and what a search found from them.
  struct State
  {
    std::vector<Id> Sites;
    double Energy = Infinity; ///< in squares of the unit
    SearchResult Result;
  };

  CloudCenters(const GraphSearch& search, const double* positions)
    : Search(search)
    , Positions(positions)
  {
  }

  /// Searches from the sites of a state. The first state determines the unit of length, so that
  /// squares neither overflow nor vanish.
  Status Evaluate(State& state, const ProgressCallback& progress)
  {
    std::vector<GraphSeed> seeds;
    for (std::size_t i = 0; i < state.Sites.size(); ++i)
    {
      seeds.push_back({ state.Sites[i], 0.0, 0.0, static_cast<Id>(i), -1.0 });
    }
    SearchOptions options;
    options.Progress = progress;
    DGG_RETURN_IF_ERROR(this->Search.Run(seeds, options, state.Result));
    if (this->Unit == 0.0)
    {
      for (const double distance : state.Result.Distances)
      {
        this->Unit = distance < Infinity ? std::max(this->Unit, distance) : this->Unit;
      }
      this->Unit = this->Unit > 0.0 ? this->Unit : 1.0;
    }
    state.Energy = 0.0;
    for (const double distance : state.Result.Distances)
    {
      if (distance < Infinity)
      {
        const double d = distance / this->Unit;
        state.Energy += d * d;
      }
    }
    return Status::Success();
  }

  /// Moves all sites by a fraction of the distance to the means of their cells. Returns true if any
  /// site moves.
  bool Move(const State& from, double part, State& to) const
  {
    const std::vector<Point3> aims = this->FindAims(from, part);
    to.Sites = from.Sites;
    std::vector<double> closest(aims.size());
    for (std::size_t i = 0; i < aims.size(); ++i)
    {
      closest[i] = this->SquaredDistance(aims[i], from.Sites[i]);
    }
    // In order of ids, so that ties are resolved in favor of the first point.
    const std::vector<Id>& cells = from.Result.Seeds;
    for (Id v = 0; v < static_cast<Id>(cells.size()); ++v)
    {
      const Id site = cells[v];
      const double distance = site == NoId ? Infinity : this->SquaredDistance(aims[site], v);
      if (site != NoId && distance < closest[site])
      {
        closest[site] = distance;
        to.Sites[site] = v;
      }
    }
    return to.Sites != from.Sites;
  }

  /// Selects the moves that improve the previous cells of the sites, that is, after which the
  /// points of the cell are closer in total. Returns true if there are some, but not all.
  bool SelectMoves(const State& from, const State& to, State& selected) const
  {
    std::vector<double> gains(from.Sites.size(), 0.0);
    for (std::size_t v = 0; v < from.Result.Seeds.size(); ++v)
    {
      const Id site = from.Result.Seeds[v];
      if (site != NoId)
      {
        const double before = from.Result.Distances[v] / this->Unit;
        const double after = to.Result.Distances[v] / this->Unit;
        gains[site] += before * before - after * after;
      }
    }
    selected.Sites = from.Sites;
    for (std::size_t i = 0; i < gains.size(); ++i)
    {
      selected.Sites[i] = gains[i] > 0.0 ? to.Sites[i] : from.Sites[i];
    }
    return selected.Sites != from.Sites && selected.Sites != to.Sites;
  }

  /// Converts an energy to model units.
  double ToModel(double energy) const { return energy * this->Unit * this->Unit; }
  bool IsSettled(const State& /*state*/, double /*tolerance*/) const { return false; }

  /// Moves all sites or, failing that, only those that are then closer to the points of their
  /// cells.
  Status Step(const State& from, double part, const ProgressCallback& progress, State& to)
  {
    if (!this->Move(from, part, to))
    {
      return Status::Success();
    }
    Status status = this->Evaluate(to, progress);
    State selected;
    if (status.IsOk() && !(to.Energy < from.Energy) && this->SelectMoves(from, to, selected))
    {
      status = this->Evaluate(selected, progress);
      std::swap(to, selected);
    }
    return status;
  }

private:
  Point3 At(Id v) const { return PointAt(this->Positions, v); }

  /// Returns a squared distance in units.
  double SquaredDistance(const Point3& p, Id v) const
  {
    const Point3 d = p - this->At(v);
    const Point3 inUnits{ d.X / this->Unit, d.Y / this->Unit, d.Z / this->Unit };
    return Dot(inUnits, inUnits);
  }

  /// Returns, per vertex, the first vertex after its site on the path to it; NoId for sites and
  /// unreached vertices.
  std::vector<Id> FindDepartures(const State& state) const
  {
    const std::vector<Id>& tails = state.Result.Tails;
    std::vector<Id> departures(tails.size(), NoId);
    for (const Id v : SortForest(tails))
    {
      if (tails[v] != NoId)
      {
        departures[v] = tails[tails[v]] == NoId ? v : departures[tails[v]];
      }
    }
    return departures;
  }

  /// Returns the target positions of the sites.
  std::vector<Point3> FindAims(const State& state, double part) const
  {
    const std::vector<Id> departures = this->FindDepartures(state);
    std::vector<Point3> sums(state.Sites.size());
    std::vector<double> counts(state.Sites.size(), 0.0);
    for (Id v = 0; v < static_cast<Id>(departures.size()); ++v)
    {
      const Id site = state.Result.Seeds[v];
      if (site == NoId)
      {
        continue;
      }
      counts[site] += 1.0;
      if (departures[v] == NoId)
      {
        continue;
      }
      const Point3 way = this->At(departures[v]) - this->At(state.Sites[site]);
      const double length = std::hypot(way.X, way.Y, way.Z);
      if (length > 0.0) // zero for coincident points
      {
        const double distance = state.Result.Distances[v];
        sums[site] =
          sums[site] + distance * Point3{ way.X / length, way.Y / length, way.Z / length };
      }
    }
    for (std::size_t i = 0; i < sums.size(); ++i)
    {
      const Point3 mean = counts[i] > 0.0 ? (part / counts[i]) * sums[i] : Point3();
      sums[i] = this->At(state.Sites[i]) + mean;
    }
    return sums;
  }

  const GraphSearch& Search;
  const double* Positions;
  double Unit = 0.0;
};
}

Status LinkSites(const std::vector<SurfacePoint>& sites, const GraphBuilder* builder,
  double accuracy, LinkedSites& linked)
{
  linked = LinkedSites();
  for (std::size_t i = 0; i < sites.size(); ++i)
  {
    std::vector<GraphLink> links;
    std::vector<double> none;
    DGG_RETURN_IF_ERROR(FindLinks(builder, sites[i], accuracy, {}, links, none));
    AppendSeeds(links, linked.Seeds, static_cast<Id>(i));
    for (const GraphLink& link : links)
    {
      linked.Departures.push_back(link.DepartureAngle);
    }
  }
  return Status::Success();
}

Status MoveToCenters(const GraphSearch& search, const SurfaceMesh& mesh,
  const GraphBuilder& builder, double accuracy, const CentroidalOptions& options,
  std::vector<SurfacePoint>& sites, std::vector<double>& energies)
{
  SurfaceCenters centers(search, mesh, builder, accuracy);
  SurfaceCenters::State current;
  current.Sites = sites;
  Status status = Iterate(centers, options, current, energies);
  if (!status.IsOk())
  {
    energies.clear();
    return status;
  }
  sites = std::move(current.Sites);
  return status;
}

Status MoveToCloudCenters(const GraphSearch& search, const double* positions,
  const CentroidalOptions& options, std::vector<SurfacePoint>& sites, std::vector<double>& energies)
{
  CloudCenters centers(search, positions);
  CloudCenters::State current;
  for (const SurfacePoint& site : sites)
  {
    current.Sites.push_back(site.Vertex);
  }
  Status status = Iterate(centers, options, current, energies);
  if (!status.IsOk())
  {
    energies.clear();
    return status;
  }
  for (double& energy : energies)
  {
    energy = centers.ToModel(energy);
  }
  std::transform(current.Sites.begin(), current.Sites.end(), sites.begin(), SurfacePoint::AtVertex);
  return status;
}
}
