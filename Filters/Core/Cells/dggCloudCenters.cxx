// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggCloudCenters.h"

#include "dggCloudFrame.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace dgg
{
namespace
{
/// Steps that are smaller than this part of what the means ask for are of no use.
constexpr int MostHalvings = 5;

/// Sites and what a search found from them.
struct State
{
  std::vector<Id> Sites;
  double Energy = 0.0; ///< in squares of the unit
  SearchResult Result;
};

class Centers
{
public:
  Centers(const GraphSearch& search, const double* positions)
    : Search(search)
    , Positions(positions)
  {
  }

  /// Search from the sites of a state. The first state chooses the unit of length, so that squares
  /// neither overflow nor vanish.
  Status Look(State& state, const ProgressCallback& progress)
  {
    std::vector<GraphSeed> seeds;
    for (std::size_t i = 0; i < state.Sites.size(); ++i)
    {
      seeds.push_back({ state.Sites[i], 0.0, 0.0, static_cast<Id>(i), -1.0 });
    }
    SearchOptions options;
    options.Progress = progress;
    Status status = this->Search.Run(seeds, options, state.Result);
    if (!status.IsOk())
    {
      return status;
    }
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
    return status;
  }

  /// Move all sites by a part of the way to the means of their cells. Returns whether any moves.
  bool Move(const State& from, double part, State& to) const
  {
    const std::vector<Point3> aims = this->FindAims(from, part);
    to.Sites = from.Sites;
    std::vector<double> closest(aims.size());
    for (std::size_t i = 0; i < aims.size(); ++i)
    {
      closest[i] = this->SquaredDistance(aims[i], from.Sites[i]);
    }
    // In the order of ids, so that of several points at the same distance the first one is taken.
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

  /// The moves from one state to the next that are good for the cells that the sites had: where the
  /// points of the cell are closer to the new sites together. Returns whether there are any, but
  /// not all.
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

  double ToCloud(double energy) const { return energy * this->Unit * this->Unit; }

private:
  Point3 At(Id v) const { return PointAt(this->Positions, v); }

  /// In units.
  double SquaredDistance(const Point3& p, Id v) const
  {
    const Point3 d = p - this->At(v);
    const Point3 inUnits{ d.X / this->Unit, d.Y / this->Unit, d.Z / this->Unit };
    return Dot(inUnits, inUnits);
  }

  /// Per vertex, the first vertex after its site on the way to it; NoId for sites and where no site
  /// reaches.
  std::vector<Id> FindDepartures(const State& state) const
  {
    const SearchResult& result = state.Result;
    const auto n = static_cast<Id>(result.Seeds.size());
    std::vector<Id> departures(n, NoId);
    std::vector<Id> climbed;
    for (Id start = 0; start < n; ++start)
    {
      Id v = start;
      while (departures[v] == NoId && result.Tails[v] != NoId)
      {
        climbed.push_back(v);
        v = result.Tails[v];
      }
      for (; !climbed.empty(); climbed.pop_back())
      {
        const Id w = climbed.back();
        const Id tail = result.Tails[w];
        departures[w] = result.Tails[tail] == NoId ? w : departures[tail];
      }
    }
    return departures;
  }

  /// Where the sites are to go.
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
      if (length > 0.0) // not so for points in the same place
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

Status MoveToCloudCenters(const GraphSearch& search, const double* positions,
  const CentroidalOptions& options, std::vector<SurfacePoint>& sites, std::vector<double>& energies)
{
  energies.clear();
  // An iteration may search several times, and does not go back then.
  double told = 0.0;
  const auto report = [&options, &told](double done) {
    told = std::max(told, std::min(1.0, done / (options.NumberOfIterations + 1)));
    return !options.Progress || options.Progress(told);
  };
  const auto within = [&report](double start) {
    return [&report, start](double part) { return report(start + 0.99 * part); };
  };
  Centers centers(search, positions);
  State current;
  for (const SurfacePoint& site : sites)
  {
    current.Sites.push_back(site.Vertex);
  }
  Status status = centers.Look(current, within(0.0));
  std::vector<double> found{ centers.ToCloud(current.Energy) };
  double part = 1.0;
  int halvings = 0;
  for (int i = 1; status.IsOk() && i <= options.NumberOfIterations && halvings <= MostHalvings;)
  {
    State next;
    if (!report(i))
    {
      status = Status::Abort();
      break;
    }
    const bool moves = centers.Move(current, part, next);
    if (moves)
    {
      status = centers.Look(next, within(i));
    }
    State selected;
    if (moves && status.IsOk() && !(next.Energy < current.Energy) &&
      centers.SelectMoves(current, next, selected))
    {
      status = centers.Look(selected, within(i));
      std::swap(next, selected);
    }
    if (moves && status.IsOk() && next.Energy < current.Energy)
    {
      std::swap(current, next);
      found.push_back(centers.ToCloud(current.Energy));
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
  if (status.IsOk())
  {
    for (std::size_t i = 0; i < sites.size(); ++i)
    {
      sites[i] = SurfacePoint::AtVertex(current.Sites[i]);
    }
    energies = found;
  }
  return status;
}
}
