// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggCentroidal.h"

#include "dggStraightWalk.h"

#include <algorithm>
#include <cmath>

namespace dgg
{
namespace
{
/// How often steps are halved before the iteration ends.
constexpr int MostHalvings = 6;

/// A length that others are measured in: a power of two, so that this changes no digit. Energies
/// are of the fourth power of lengths, and so are intermediate results.
double ChooseUnit(const SurfaceMesh& mesh)
{
  const double length = mesh.GetMeanEdgeLength();
  return length > 0.0 ? std::ldexp(1.0, std::ilogb(length)) : 1.0;
}

/// Sites, and where they would like to go.
struct State
{
  std::vector<SurfacePoint> Sites;
  std::vector<double> Angles;  ///< per site, direction to the mean of its cell
  std::vector<double> Lengths; ///< per site, distance of it
  double Energy = Infinity;    ///< in units of lengths
};

class Centers
{
public:
  Centers(const GraphSearch& search, const SurfaceMesh& mesh, const GraphBuilder& builder,
    double accuracy)
    : Search(search)
    , Mesh(mesh)
    , Builder(builder)
    , Accuracy(accuracy)
    , Unit(ChooseUnit(mesh))
    , Areas(mesh.GetNumberOfVertices(), 0.0)
  {
    for (Id h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
    {
      const Id first = h - h % 3;
      if (!mesh.IsDropped(SurfaceMesh::Face(h)))
      {
        this->Areas[mesh.Origin(h)] +=
          (mesh.Length(first) / this->Unit) * (mesh.ApexY(first) / this->Unit) / 6.0;
      }
    }
  }

  /// Energy and means of sites.
  Status Look(State& state, const ProgressCallback& progress)
  {
    LinkedSites linked;
    Status status = LinkSites(state.Sites, &this->Builder, this->Accuracy, linked);
    if (status.IsOk())
    {
      SearchOptions options;
      options.Correct = true;
      options.Progress = progress;
      status = this->Search.Run(linked.Seeds, options, this->Result);
    }
    if (!status.IsOk())
    {
      return status;
    }
    if (this->Result.Corrected.empty())
    {
      return Status::Invalid("sites cannot be moved over a graph without directions");
    }
    this->FindDirections(linked);
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
      const double distance = this->Result.Corrected[v] / this->Unit;
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
        state.Lengths[i] = this->Unit * (Norm(sums[i].X, sums[i].Y) / weights[i]);
        state.Angles[i] = DirectionAt(this->Mesh, state.Sites[i],
          std::atan2(sums[i].Y, sums[i].X) / UnrollFactor(this->Mesh, state.Sites[i]));
      }
    }
    return status;
  }

  /// An energy in units of the mesh.
  double ToMesh(double energy) const
  {
    const double square = this->Unit * this->Unit;
    return energy * square * square;
  }

  /// Where a part of the way to the means leads.
  Status Move(const State& from, double part, State& to) const
  {
    to.Sites.clear();
    SurfacePath path;
    for (std::size_t i = 0; i < from.Sites.size(); ++i)
    {
      Status status =
        WalkStraight(this->Mesh, from.Sites[i], from.Angles[i], part * from.Lengths[i], path);
      if (!status.IsOk())
      {
        return status;
      }
      to.Sites.push_back(path.Points.back());
    }
    return Status::Success();
  }

private:
  /// The direction in which the way to each vertex leaves its site, down the tree of ways.
  void FindDirections(const LinkedSites& linked)
  {
    const Id n = this->Mesh.GetNumberOfVertices();
    this->Directions.assign(n, 0.0);
    std::vector<char> isKnown(n, 0);
    std::vector<Id> climbed;
    for (Id first = 0; first < n; ++first)
    {
      Id v = first;
      while (v != NoId && !isKnown[v] && this->Result.Seeds[v] != NoId)
      {
        climbed.push_back(v);
        v = this->Result.Tails[v];
      }
      for (; !climbed.empty(); climbed.pop_back())
      {
        v = climbed.back();
        this->Directions[v] = this->FindDirection(v, linked);
        isKnown[v] = 1;
      }
    }
  }

  /// That of a vertex whose tail has one.
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
      return graph.Angles[edge]; // from the site itself, a vertex
    }
    // As the distance, the way is straight as long as its virtual source is the site.
    if (result.Virtual.Offsets[v] != 0.0 || result.Virtual.Offsets[u] != 0.0)
    {
      return this->Directions[u];
    }
    const double total = this->Mesh.TotalAngle(u);
    double turn = graph.Angles[edge] - result.Virtual.Angles[u];
    if (this->Mesh.Kind(u) != VertexKind::Boundary)
    {
      turn -= total * std::rint(turn / total);
    }
    if (std::abs(turn) >= Pi)
    {
      return this->Directions[u];
    }
    const double hop = graph.Length(edge);
    return this->Directions[u] -
      std::atan2(hop * std::sin(turn), result.Virtual.Lengths[u] - hop * std::cos(turn));
  }

  const GraphSearch& Search;
  const SurfaceMesh& Mesh;
  const GraphBuilder& Builder;
  double Accuracy;
  double Unit;
  std::vector<double> Areas; ///< per vertex, in squares of the unit
  SearchResult Result;
  std::vector<double> Directions; ///< per vertex, at its site
};
}

Status LinkSites(const std::vector<SurfacePoint>& sites, const GraphBuilder* builder,
  double accuracy, LinkedSites& linked)
{
  linked = LinkedSites();
  for (std::size_t i = 0; i < sites.size(); ++i)
  {
    const auto number = static_cast<Id>(i);
    if (sites[i].On == SurfacePoint::Support::Vertex)
    {
      linked.Seeds.push_back({ sites[i].Vertex, 0.0, 0.0, number, -1.0 });
      linked.Departures.push_back(0.0);
      continue;
    }
    if (!builder)
    {
      return Status::Invalid("sites that are not vertices need a mesh");
    }
    std::vector<GraphLink> links;
    std::vector<double> direct;
    Status status = builder->Link(sites[i], accuracy, {}, links, direct);
    if (!status.IsOk())
    {
      return status;
    }
    for (const GraphLink& link : links)
    {
      linked.Seeds.push_back({ link.Vertex, link.Length, 0.0, number, link.ArrivalAngle });
      linked.Departures.push_back(link.DepartureAngle);
    }
  }
  return Status::Success();
}

Status MoveToCenters(const GraphSearch& search, const SurfaceMesh& mesh,
  const GraphBuilder& builder, double accuracy, const CentroidalOptions& options,
  std::vector<SurfacePoint>& sites, std::vector<double>& energies)
{
  energies.clear();
  const auto report = [&options](double done) {
    return !options.Progress ||
      options.Progress(std::min(1.0, done / (options.NumberOfIterations + 1)));
  };
  const auto within = [&report](double start) {
    return [&report, start](double part) { return report(start + 0.99 * part); };
  };
  Centers centers(search, mesh, builder, accuracy);
  State current;
  current.Sites = sites;
  Status status = centers.Look(current, within(0.0));
  std::vector<double> found{ centers.ToMesh(current.Energy) };
  double part = 1.0;
  int halvings = 0;
  for (int i = 1; status.IsOk() && i <= options.NumberOfIterations && halvings <= MostHalvings;)
  {
    const double farthest = current.Lengths.empty()
      ? 0.0
      : *std::max_element(current.Lengths.begin(), current.Lengths.end());
    if (farthest <= options.Tolerance * mesh.GetMeanEdgeLength())
    {
      break;
    }
    if (!report(i))
    {
      status = Status::Abort();
      break;
    }
    State next;
    status = centers.Move(current, part, next);
    if (status.IsOk())
    {
      status = centers.Look(next, within(i));
    }
    if (status.IsOk() && next.Energy < current.Energy)
    {
      current = next;
      found.push_back(centers.ToMesh(current.Energy));
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
    sites = current.Sites;
    energies = found;
  }
  return status;
}
}
