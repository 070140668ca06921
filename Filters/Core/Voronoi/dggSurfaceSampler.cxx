// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggSurfaceSampler.h"

#include "dggEdges.h"
#include "dggFarthestPoints.h"
#include "dggGraphSearch.h"
#include "dggGraphSeeds.h"
#include "dggProgressPart.h"
#include "dggStraightWalk.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

namespace dgg
{
namespace
{
/// With fewer vertices per sample than this, points between vertices are used as well.
constexpr Offset VerticesPerSample = 2;
/// Number of such points per sample, and limits of the number of points and samples.
constexpr Offset PlacesPerSample = 64;
constexpr Offset MostPlaces = 10000;
constexpr Offset MostSamplesInside = 1000;
/// Progress weight of linking these points.
constexpr double PlacesShare = 0.3;

/// The distance from a sample around a vertex: its square is |x|^2 - 2 x.Image + Constant, where x
/// is a position in the tangent plane of the vertex.
struct PlanarImage
{
  Point2 Image;
  double Constant = 0.0;

  /// Evaluates the squared distance without the term |x|^2, which is common to all images.
  double Evaluate(const Point2& x) const { return this->Constant - 2.0 * Dot(x, this->Image); }
};

/// Least squares over the neighbors of a vertex: (x, y, 1) . (a, b, c) = value.
struct PlaneFit
{
  Eigen::Matrix3d Matrix = Eigen::Matrix3d::Zero();
  Eigen::Vector3d Right = Eigen::Vector3d::Zero();

  void Add(const Point2& p, double value)
  {
    const Eigen::Vector3d row(p.X, p.Y, 1.0);
    this->Matrix += row * row.transpose();
    this->Right += value * row;
  }

  /// Returns true if the points determine a plane.
  bool IsSolvable() const
  {
    return this->Matrix.determinant() > 1e-6 * this->Matrix.diagonal().prod();
  }
};

/// Finds the point at equal distances from three images. Returns false if they are collinear.
bool Meet(const PlanarImage& a, const PlanarImage& b, const PlanarImage& c, Point2& meet)
{
  const Point2 u{ b.Image.X - a.Image.X, b.Image.Y - a.Image.Y };
  const Point2 v{ c.Image.X - a.Image.X, c.Image.Y - a.Image.Y };
  const double determinant = 2.0 * Cross(u, v);
  const double p = b.Constant - a.Constant;
  const double q = c.Constant - a.Constant;
  meet = { (p * v.Y - q * u.Y) / determinant, (q * u.X - p * v.X) / determinant };
  return std::abs(determinant) > 0.0 && std::isfinite(meet.X) && std::isfinite(meet.Y);
}

/// Points inside faces and on edges, several times as dense as the samples will be, and their
/// distances from the samples. The more samples there are compared to vertices, the less the
/// vertices represent the surface in between.
class InnerPlaces
{
public:
  InnerPlaces(const GraphView& graph, const SurfaceMesh& mesh, const GraphBuilder& builder,
    double accuracy, Offset count)
    : Builder(builder)
    , Accuracy(accuracy)
    , LinksOf(mesh.GetNumberOfVertices())
    , VertexDistances(mesh.GetNumberOfVertices(), Infinity)
  {
    double area = 0.0;
    for (Id f = 0; f < mesh.GetNumberOfFaces(); ++f)
    {
      area += CanHoldSamples(graph, mesh, f) ? AreaOf(mesh, f) : 0.0;
    }
    // Spacing of a lattice of `count` points.
    const double spacing = std::sqrt(area / static_cast<double>(count));
    for (Id f = 0; f < mesh.GetNumberOfFaces(); ++f)
    {
      if (CanHoldSamples(graph, mesh, f))
      {
        this->AddPlaces(mesh, f, spacing);
      }
    }
    this->Distances.assign(this->Points.size(), Infinity);
  }

  Status LinkAll(const ProgressCallback& progress)
  {
    std::vector<GraphLink> links;
    std::vector<double> direct;
    for (std::size_t i = 0; i < this->Points.size(); ++i)
    {
      if (i % ProgressInterval == 0)
      {
        DGG_RETURN_IF_ERROR(
          ReportTo(progress, static_cast<double>(i) / static_cast<double>(this->Points.size())));
      }
      DGG_RETURN_IF_ERROR(this->Builder.Link(this->Points[i], this->Accuracy, {}, links, direct));
      for (const GraphLink& link : links)
      {
        this->LinksOf[link.Vertex].push_back({ static_cast<Id>(i), link.Length });
      }
    }
    return Status::Success();
  }

  /// Updates distances after a sample has been added; `distances` are per vertex.
  Status Update(const SurfacePoint& sample, const std::vector<double>& distances)
  {
    std::vector<double> direct;
    if (sample.On != SurfacePoint::Support::Vertex)
    {
      std::vector<GraphLink> links;
      DGG_RETURN_IF_ERROR(this->Builder.Link(sample, this->Accuracy, this->Points, links, direct));
    }
    for (std::size_t v = 0; v < distances.size(); ++v)
    {
      if (distances[v] < this->VertexDistances[v])
      {
        this->VertexDistances[v] = distances[v];
        for (const PlaceLink& link : this->LinksOf[v])
        {
          this->Distances[link.Place] =
            std::min(this->Distances[link.Place], distances[v] + link.Length);
        }
      }
    }
    this->Farthest = NoId;
    for (std::size_t i = 0; i < this->Points.size(); ++i)
    {
      double& distance = this->Distances[i];
      distance = direct.empty() ? distance : std::min(distance, direct[i]);
      if (this->Farthest == NoId || distance > this->Distances[this->Farthest])
      {
        this->Farthest = static_cast<Id>(i);
      }
    }
    return Status::Success();
  }

  /// Returns the distance of the farthest point; 0 if there is none.
  double GetDistance() const
  {
    return this->Farthest == NoId ? 0.0 : this->Distances[this->Farthest];
  }
  const SurfacePoint& GetPoint() const { return this->Points[this->Farthest]; }

private:
  struct PlaceLink
  {
    Id Place;
    double Length;
  };

  static constexpr std::size_t ProgressInterval = 64;
  static constexpr int FewestPieces = 2; // minimum subdivision of the sides of a face

  static double AreaOf(const SurfaceMesh& mesh, Id f)
  {
    return 0.5 * mesh.Length(3 * f) * mesh.ApexY(3 * f);
  }

  /// Returns true for faces with area whose vertices have edges in the graph.
  static bool CanHoldSamples(const GraphView& graph, const SurfaceMesh& mesh, Id f)
  {
    bool matters = !mesh.IsDropped(f) && !mesh.IsMollified(f);
    for (Id h = 3 * f; h < 3 * f + 3 && matters; ++h)
    {
      matters = graph.Offsets[mesh.Origin(h)] < graph.Offsets[mesh.Origin(h) + 1];
    }
    return matters;
  }

  void AddPlaces(const SurfaceMesh& mesh, Id f, double spacing)
  {
    const int pieces = std::max(
      FewestPieces, static_cast<int>(std::ceil(std::sqrt(2.0 * AreaOf(mesh, f)) / spacing)));
    for (int i = 0; i <= pieces; ++i)
    {
      for (int j = 0; i + j <= pieces; ++j)
      {
        const int k = pieces - i - j;
        const bool isCorner = i == pieces || j == pieces || k == pieces;
        // Points on a side belong to one of its faces.
        const auto isOther = [&](Id h) { return FindEdge(mesh, h) != h; };
        const bool isElsewhere = (k == 0 && isOther(3 * f)) || (i == 0 && isOther(3 * f + 1)) ||
          (j == 0 && isOther(3 * f + 2));
        if (isCorner || isElsewhere)
        {
          continue;
        }
        const double n = pieces;
        this->Points.push_back(SurfacePoint::InTriangle(mesh, f, { { i / n, j / n, k / n } }));
      }
    }
  }

  const GraphBuilder& Builder;
  double Accuracy;
  std::vector<SurfacePoint> Points;
  std::vector<std::vector<PlaceLink>> LinksOf; ///< per vertex
  std::vector<double> VertexDistances;         ///< per vertex
  std::vector<double> Distances;               ///< per point
  Id Farthest = NoId;
};

/// Farthest-point sampling at vertices.
class Sampler
{
public:
  Sampler(
    SampleDistances& points, const SamplerOptions& options, std::vector<SurfaceSample>& samples)
    : Options(options)
    , Samples(samples)
    , Points(points)
  {
  }
  virtual ~Sampler() = default;

  /// Takes the seeds of the given samples.
  Status Run(const std::vector<std::vector<GraphSeed>>& given)
  {
    for (std::size_t i = 0; i < given.size(); ++i)
    {
      DGG_RETURN_IF_ERROR(this->Add(this->Options.Given[i], given[i]));
    }
    if (this->Samples.empty() && this->Options.NumberOfSamples > 0)
    {
      DGG_RETURN_IF_ERROR(this->AddFirst());
    }
    while (this->GetRadius() > std::max(0.0, this->Options.CoveringRadius) &&
      static_cast<Offset>(this->Samples.size()) < this->Options.NumberOfSamples)
    {
      const double done = static_cast<double>(this->Samples.size()) /
        static_cast<double>(this->Options.NumberOfSamples);
      DGG_RETURN_IF_ERROR(ReportTo(
        this->Options.Progress, this->ProgressAtStart + (1.0 - this->ProgressAtStart) * done));
      DGG_RETURN_IF_ERROR(this->AddFarthest());
    }
    return Status::Success();
  }

protected:
  /// Returns the distance of the farthest vertex or point from the samples.
  virtual double GetRadius() const
  {
    return this->Farthest.Vertex == NoId ? 0.0 : this->Farthest.Distance;
  }
  virtual Status AddFarthest() { return this->AddVertex(this->Farthest.Vertex); }
  /// Called when the distances from a new sample are known.
  virtual Status Update(const SurfacePoint&) { return Status::Success(); }

  Status AddVertex(Id v) { return this->Add(SurfacePoint::AtVertex(v), { SeedAt(v) }); }

  Status Add(const SurfacePoint& point, const std::vector<GraphSeed>& seeds)
  {
    DGG_RETURN_IF_ERROR(this->Points.Add(seeds, {}));
    DGG_RETURN_IF_ERROR(this->Update(point));
    DGG_RETURN_IF_ERROR(this->Points.FindFarthest(this->Farthest));
    this->Samples.push_back({ point, this->GetRadius() });
    return Status::Success();
  }

  const SamplerOptions& Options;
  std::vector<SurfaceSample>& Samples;
  FarthestVertex Farthest;
  double ProgressAtStart = 0.0;

private:
  Status AddFirst()
  {
    FarthestVertex first{ this->Options.FirstVertex };
    if (first.Vertex == NoId)
    {
      DGG_RETURN_IF_ERROR(this->Points.FindFarthest(first));
      if (first.Vertex == NoId)
      {
        return Status::Success(); // no edges
      }
      DGG_RETURN_IF_ERROR(this->Points.Add({ SeedAt(first.Vertex) }, {}));
      DGG_RETURN_IF_ERROR(this->Points.FindFarthestReached(first));
      this->Points.Reset();
    }
    return this->AddVertex(first.Vertex);
  }

  static GraphSeed SeedAt(Id vertex)
  {
    GraphSeed seed;
    seed.Vertex = vertex;
    return seed;
  }

  SampleDistances& Points;
};

/// Farthest-point sampling at vertices and in faces.
class FaceSampler : public Sampler
{
public:
  FaceSampler(const GraphView& graph, const SurfaceMesh& mesh, const GraphBuilder& builder,
    double accuracy, FarthestPoints& points, const SamplerOptions& options,
    std::vector<SurfaceSample>& samples)
    : Sampler(points, options, samples)
    , Graph(graph)
    , Mesh(mesh)
    , Builder(builder)
    , Accuracy(accuracy)
    , Points(points)
  {
  }

  /// Prepares points between vertices if there are about as many samples as vertices.
  Status Prepare()
  {
    Offset vertices = 0;
    for (Id v = 0; v < this->Graph.NumberOfVertices; ++v)
    {
      vertices += this->Graph.Offsets[v] < this->Graph.Offsets[v + 1] ? 1 : 0;
    }
    const Offset count = this->Options.NumberOfSamples;
    if (count > MostSamplesInside || VerticesPerSample * count <= vertices)
    {
      return Status::Success();
    }
    this->Inside = std::make_unique<InnerPlaces>(this->Graph, this->Mesh, this->Builder,
      this->Accuracy, std::min(MostPlaces, PlacesPerSample * count));
    this->ProgressAtStart = PlacesShare;
    return this->Inside->LinkAll(ProgressPart(this->Options.Progress, 0.0, PlacesShare));
  }

private:
  /// Seeds of a surface point as a sample.
  struct Linked
  {
    std::vector<GraphSeed> Seeds;
    double Distance = Infinity; ///< straight-line distance from other samples
  };

  double GetRadius() const override
  {
    const double radius = Sampler::GetRadius();
    return this->Inside ? std::max(radius, this->Inside->GetDistance()) : radius;
  }

  Status AddFarthest() override
  {
    if (this->Inside &&
      (this->Farthest.Vertex == NoId || this->Inside->GetDistance() > this->Farthest.Distance))
    {
      const SurfacePoint place = this->Inside->GetPoint();
      Linked linked;
      DGG_RETURN_IF_ERROR(this->Link(place, {}, linked));
      return this->Add(place, linked.Seeds);
    }
    const Id v = this->Farthest.Vertex;
    SurfacePoint point;
    if (this->FindBetter(v, point))
    {
      Linked linked;
      DGG_RETURN_IF_ERROR(this->Link(point, this->Inner, linked));
      // A point only qualifies if it is verified to be farther from other samples than the vertex.
      double distance = linked.Distance;
      for (const GraphSeed& seed : linked.Seeds)
      {
        distance = std::min(distance, seed.Distance + this->Points.GetDistances()[seed.Vertex]);
      }
      if (distance > this->Farthest.Distance)
      {
        return this->Add(point, linked.Seeds);
      }
    }
    return Sampler::AddFarthest();
  }

  Status Update(const SurfacePoint& point) override
  {
    if (!IsVertex(point))
    {
      this->Inner.push_back(point);
    }
    return this->Inside ? this->Inside->Update(point, this->Points.GetDistances())
                        : Status::Success();
  }

  Status Link(
    const SurfacePoint& point, const std::vector<SurfacePoint>& others, Linked& linked) const
  {
    std::vector<GraphLink> links;
    std::vector<double> direct;
    Status status = FindLinks(&this->Builder, point, this->Accuracy, others, links, direct);
    AppendSeeds(links, linked.Seeds);
    for (const double distance : direct)
    {
      linked.Distance = std::min(linked.Distance, distance);
    }
    return status;
  }

  /// Searches for a point close to a vertex that is farther from the samples. Returns false if
  /// there is none.
  bool FindBetter(Id v, SurfacePoint& point) const
  {
    if (!this->Graph.Angles || !(this->Farthest.Distance < Infinity) ||
      this->Mesh.Kind(v) == VertexKind::Irregular)
    {
      return false;
    }
    const std::vector<PlanarImage> images = this->FitImages(v);
    double reach = 0.0;
    for (const Id* h = this->Mesh.FanBegin(v); h != this->Mesh.FanEnd(v); ++h)
    {
      reach = std::max(reach, this->Mesh.Length(*h));
    }
    Point2 best;
    double largest = ValueAt(images, best);
    bool isFound = false;
    for (std::size_t i = 0; i < images.size(); ++i)
    {
      for (std::size_t j = i + 1; j < images.size(); ++j)
      {
        for (std::size_t k = j + 1; k < images.size(); ++k)
        {
          Point2 meet;
          if (Meet(images[i], images[j], images[k], meet) && Norm(meet.X, meet.Y) <= reach &&
            ValueAt(images, meet) > largest)
          {
            largest = ValueAt(images, meet);
            best = meet;
            isFound = true;
          }
        }
      }
    }
    if (!isFound)
    {
      return false;
    }
    SurfacePath path;
    const SurfacePoint start = SurfacePoint::AtVertex(v);
    const double angle =
      DirectionAt(this->Mesh, start, std::atan2(best.Y, best.X) / UnrollFactor(this->Mesh, start));
    Status status = WalkStraight(this->Mesh, start, angle, Norm(best.X, best.Y), path);
    point = status.IsOk() ? path.Points.back() : start;
    return point.On != SurfacePoint::Support::Vertex;
  }

  /// Returns the squared distance from the samples.
  static double ValueAt(const std::vector<PlanarImage>& images, const Point2& place)
  {
    double least = Infinity;
    for (const PlanarImage& image : images)
    {
      least = std::min(least, image.Evaluate(place));
    }
    return least + Dot(place, place);
  }

  /// Fits the images of the samples around a vertex to the distances of its graph neighbors.
  std::vector<PlanarImage> FitImages(Id v) const
  {
    const double unroll = UnrollFactor(this->Mesh, SurfacePoint::AtVertex(v));
    const std::vector<double>& distances = this->Points.GetDistances();
    const std::vector<Id>& nearest = this->Points.GetNearestSamples();
    std::map<Id, PlaneFit> fits;
    for (Offset e = this->Graph.Offsets[v]; e < this->Graph.Offsets[v + 1]; ++e)
    {
      const Id t = this->Graph.Targets[e];
      const double angle = unroll * this->Graph.Angles[e];
      const double length = this->Graph.Length(e);
      fits[nearest[t]].Add({ length * std::cos(angle), length * std::sin(angle) },
        distances[t] * distances[t] - length * length);
    }
    std::vector<PlanarImage> images;
    for (const auto& [sample, fit] : fits)
    {
      if (fit.IsSolvable())
      {
        const Eigen::Vector3d s = fit.Matrix.inverse() * fit.Right;
        images.push_back({ { -0.5 * s[0], -0.5 * s[1] }, s[2] });
      }
    }
    return images;
  }

  const GraphView& Graph;
  const SurfaceMesh& Mesh;
  const GraphBuilder& Builder;
  double Accuracy;
  FarthestPoints& Points;
  std::vector<SurfacePoint> Inner;     ///< samples that are not vertices
  std::unique_ptr<InnerPlaces> Inside; ///< null if vertices are dense enough
};
}

Status SampleVertices(SampleDistances& points, const std::vector<std::vector<GraphSeed>>& given,
  const SamplerOptions& options, std::vector<SurfaceSample>& samples)
{
  return Sampler(points, options, samples).Run(given);
}

Status SampleSurface(const GraphView& graph, const SurfaceMesh* mesh, const GraphBuilder* builder,
  double accuracy, const SamplerOptions& options, std::vector<SurfaceSample>& samples)
{
  samples.clear();
  if (std::isnan(options.CoveringRadius))
  {
    return InvalidValue("CoveringRadius", options.CoveringRadius).Fix("Use a number");
  }
  if (options.Given.empty() && options.FirstVertex != NoId)
  {
    DGG_RETURN_IF_ERROR(CheckVertex(options.FirstVertex, graph.NumberOfVertices));
  }
  std::vector<std::vector<GraphSeed>> given;
  for (const SurfacePoint& point : options.Given)
  {
    std::vector<GraphLink> links;
    std::vector<double> direct;
    DGG_RETURN_IF_ERROR(FindLinks(builder, point, accuracy, {}, links, direct));
    given.push_back(MakeSeeds(links));
  }
  FarthestPoints points(graph, mesh);
  Status status;
  if (options.InFaces && mesh && builder)
  {
    FaceSampler sampler(graph, *mesh, *builder, accuracy, points, options, samples);
    status = sampler.Prepare();
    status = status.IsOk() ? sampler.Run(given) : status;
  }
  else
  {
    status = SampleVertices(points, given, options, samples);
  }
  if (!status.IsOk())
  {
    samples.clear();
  }
  return status;
}
}
