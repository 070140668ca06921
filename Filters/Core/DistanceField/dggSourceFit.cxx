// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggSourceFinding.h"

#include "dggCornerModel.h"
#include "dggEdges.h"
#include "dggProgressPart.h"
#include "dggUnfolding.h"

#include <algorithm>
#include <cmath>

namespace dgg
{
namespace
{
/// Vertices per task.
constexpr Offset VerticesPerTask = 512;
/// Vertices between two progress reports.
constexpr Offset VerticesAtOnce = 16384;
/// Residual at which a neighbor has half the weight, as a fraction of the edge length.
constexpr double SmallTolerance = 0.02;
/// Factor of the tolerance in a wide fit, in which all neighbors count. If the narrow fit excludes
/// a neighbor, it is repeated starting from the wide fit.
constexpr double WideFactor = 25.0;
constexpr double GoodMisfit = 0.2;
/// Range of curvatures, divided by the mean length of the edges. The smallest curvature represents
/// a plane wave: on closed surfaces and behind extended sources, wavefronts are flatter than
/// wavefronts of a point source at the same distance.
constexpr double SmallestCurvature = 1e-6;
constexpr double LargestCurvature = 1e4;
constexpr int MostSteps = 20;
/// Damping of the steps, relative to the diagonal of the equations.
constexpr double FirstDamping = 1e-3;
constexpr double LargestDamping = 1e6;
/// Step length below which the fit has converged, in angle (radians) and in curvature times the
/// mean length.
constexpr double SmallestStep = 1e-8;
/// Number of directions tried at a local minimum.
constexpr int NumberOfDirections = 6;

struct Neighbor
{
  double Length;
  double Angle;
  double Rise; // increase of the distance
};

/// A candidate virtual source, in polar coordinates of the vertex.
struct Guess
{
  double Angle = 0.0;
  double Curvature = 0.0;
};

/// Direction of steepest descent at a vertex.
struct SteepestDescent
{
  double Slope = 0.0; // 0 at a local minimum
  double Angle = 0.0; // polar angle at the vertex
};

/// Returns the steepest descent of a field that is linear in faces. Non-finite values are ignored.
SteepestDescent FindSteepestDescent(const SurfaceMesh& mesh, const double* values, Id v)
{
  SteepestDescent best;
  auto take = [&](double slope, double angle) {
    if (slope > best.Slope)
    {
      best.Slope = slope;
      best.Angle = angle;
    }
  };
  for (const Id* g = mesh.FanBegin(v); g != mesh.FanEnd(v); ++g)
  {
    const Id before = SurfaceMesh::Previous(*g);
    const double corner = mesh.CornerAngle(*g);
    const double first = (values[mesh.Destination(*g)] - values[v]) / mesh.Length(*g);
    const double second = (values[mesh.Origin(before)] - values[v]) / mesh.Length(before);
    if (std::isfinite(first))
    {
      take(-first, mesh.PolarAngle(*g));
    }
    if (std::isfinite(second))
    {
      take(-second, mesh.PolarAngle(*g) + corner);
    }
    if (std::isfinite(first) && std::isfinite(second) && !mesh.IsMollified(SurfaceMesh::Face(*g)))
    {
      const Point2 fall{ -first, (first * std::cos(corner) - second) / std::sin(corner) };
      const double direction = std::atan2(fall.Y, fall.X);
      if (direction > 0.0 && direction < corner)
      {
        take(Norm(fall.X, fall.Y), mesh.PolarAngle(*g) + direction);
      }
    }
  }
  return best;
}

/// Fits the virtual source of one vertex at a time.
class VertexFit
{
public:
  VertexFit(const SurfaceMesh& mesh, const double* distances)
    : Mesh(mesh)
    , Distances(distances)
  {
  }

  /// Finds the best guess for vertex v. Returns false if the vertex itself is the best virtual
  /// source.
  bool Fit(Id v, Guess& best);

private:
  /// Normal equations of the weighted least squares.
  struct Equations
  {
    double Misfit = 0.0;
    double AngleAngle = 0.0;
    double AngleCurvature = 0.0;
    double CurvatureCurvature = 0.0;
    double Angle = 0.0; // right-hand sides
    double Curvature = 0.0;
  };

  void CollectNeighbors(Id v);
  double Predict(const Neighbor& n, const Guess& guess, double& byAngle, double& byCurvature) const;
  Equations Evaluate(const Guess& guess) const;
  double MisfitOfVertex() const;
  double Improve(Guess& guess) const;

  const SurfaceMesh& Mesh;
  const double* Distances;
  std::vector<Neighbor> Neighbors;
  CornerModel Around; // only its angles are used
  double MeanLength = 0.0;
  double Tolerance = SmallTolerance;
};

void VertexFit::CollectNeighbors(Id v)
{
  this->Neighbors.clear();
  this->MeanLength = 0.0;
  ForEachNeighbor(this->Mesh, v, [&](Id w, double length, double angle) {
    if (std::isfinite(this->Distances[w]))
    {
      this->Neighbors.push_back({ length, angle, this->Distances[w] - this->Distances[v] });
      this->MeanLength += length;
    }
  });
  this->MeanLength /= std::max<double>(1.0, static_cast<double>(this->Neighbors.size()));
}

/// Returns the predicted increase of the distance from the vertex to a neighbor, and its
/// derivatives.
double VertexFit::Predict(
  const Neighbor& n, const Guess& guess, double& byAngle, double& byCurvature) const
{
  CornerModel model = this->Around;
  model.Angle = guess.Angle;
  const double angle = model.AngleFrom(n.Angle);
  byAngle = 0.0;
  byCurvature = 0.0;
  if (std::abs(angle) >= Pi)
  {
    return n.Length;
  }
  // (sqrt(1 - 2 k l cos + k^2 l^2) - 1) / k, in a form that is accurate for small k as well.
  const double cosine = std::cos(angle);
  const double bend = guess.Curvature * n.Length;
  const double root = std::sqrt((1.0 - bend) * (1.0 - bend) + 2.0 * bend * (1.0 - cosine));
  const double rise = n.Length * (bend - 2.0 * cosine) / (root + 1.0);
  if (root > 0.0)
  {
    byAngle = n.Length * std::sin(angle) / root;
    byCurvature = n.Length * (n.Length - rise * (bend - cosine) / root) / (root + 1.0);
  }
  return rise;
}

/// Returns the misfit of a guess and the normal equations. The unknowns are the angle and the
/// curvature times the mean length. The misfit is the sum of the Geman-McClure penalties of the
/// residuals. A penalty is bounded, so that a neighbor reached by another path adds a constant cost
/// and no gradient.
VertexFit::Equations VertexFit::Evaluate(const Guess& guess) const
{
  Equations e;
  for (const Neighbor& n : this->Neighbors)
  {
    double byAngle = 0.0;
    double byCurvature = 0.0;
    const double scale = 1.0 / (this->Tolerance * n.Length);
    const double residual = scale * (n.Rise - this->Predict(n, guess, byAngle, byCurvature));
    byAngle *= scale;
    byCurvature *= scale / this->MeanLength;
    const double more = 1.0 / (1.0 + residual * residual);
    const double weight = more * more;
    e.Misfit += residual * residual * more;
    e.AngleAngle += weight * byAngle * byAngle;
    e.AngleCurvature += weight * byAngle * byCurvature;
    e.CurvatureCurvature += weight * byCurvature * byCurvature;
    e.Angle += weight * byAngle * residual;
    e.Curvature += weight * byCurvature * residual;
  }
  return e;
}

double VertexFit::MisfitOfVertex() const
{
  double misfit = 0.0;
  for (const Neighbor& n : this->Neighbors)
  {
    const double residual = (n.Rise - n.Length) / (this->Tolerance * n.Length);
    misfit += residual * residual / (1.0 + residual * residual);
  }
  return misfit;
}

/// Improves a guess by damped Gauss-Newton steps (Levenberg-Marquardt) with the weights of the
/// penalty. Returns the misfit.
double VertexFit::Improve(Guess& guess) const
{
  Equations e = this->Evaluate(guess);
  double damping = FirstDamping;
  for (int step = 0; step < MostSteps; ++step)
  {
    const double more = damping * (e.AngleAngle + e.CurvatureCurvature);
    const double aa = e.AngleAngle + more;
    const double cc = e.CurvatureCurvature + more;
    const double ac = e.AngleCurvature;
    const double determinant = aa * cc - ac * ac;
    if (!(determinant > 0.0))
    {
      break;
    }
    Guess next;
    next.Angle = guess.Angle + (e.Angle * cc - e.Curvature * ac) / determinant;
    if (this->Around.IsOpen)
    {
      // A virtual source may lie beyond the boundary, where the field is truncated.
      next.Angle = std::min(this->Around.Total + Pi, std::max(-Pi, next.Angle));
    }
    next.Curvature =
      this->MeanLength * guess.Curvature + (e.Curvature * aa - e.Angle * ac) / determinant;
    next.Curvature =
      std::min(LargestCurvature, std::max(SmallestCurvature, next.Curvature)) / this->MeanLength;
    const Equations after = this->Evaluate(next);
    if (after.Misfit <= e.Misfit)
    {
      const double change = std::abs(next.Angle - guess.Angle) +
        this->MeanLength * std::abs(next.Curvature - guess.Curvature);
      guess = next;
      e = after;
      damping *= 0.1;
      if (change < SmallestStep)
      {
        break;
      }
    }
    else
    {
      damping *= 10.0;
      if (damping > LargestDamping)
      {
        break;
      }
    }
  }
  return e.Misfit;
}

bool VertexFit::Fit(Id v, Guess& best)
{
  this->CollectNeighbors(v);
  this->Around = CornerModel(this->Mesh, v, {});
  if (!this->Around.IsKnown || this->Neighbors.size() < 2)
  {
    return false;
  }
  double bestMisfit = this->MisfitOfVertex();
  bool isFound = false;
  auto attempt = [&](double angle, double curvature, bool isWide) {
    Guess guess{ angle, curvature };
    if (isWide)
    {
      this->Tolerance = WideFactor * SmallTolerance;
      this->Improve(guess);
      this->Tolerance = SmallTolerance;
    }
    const double misfit = this->Improve(guess);
    if (misfit < bestMisfit)
    {
      bestMisfit = misfit;
      best = guess;
      isFound = true;
    }
  };
  const SteepestDescent descent = FindSteepestDescent(this->Mesh, this->Distances, v);
  if (descent.Slope > 0.0)
  {
    // Initial guess: the entire distance comes from one source.
    const double curvature = 1.0 / std::max(this->MeanLength, std::abs(this->Distances[v]));
    attempt(descent.Angle, curvature, false);
    if (bestMisfit > GoodMisfit)
    {
      attempt(descent.Angle, curvature, true);
    }
  }
  else
  {
    for (int i = 0; i < NumberOfDirections; ++i)
    {
      attempt(this->Around.Total * (i + 0.5) / NumberOfDirections, 1.0 / this->MeanLength, true);
    }
  }
  return isFound;
}
}

Status FitVirtualSources(const SurfaceMesh& mesh, const double* distances,
  const ParallelFor& parallel, VirtualSources& found, const ProgressCallback& progress)
{
  const Offset n = mesh.GetNumberOfVertices();
  found.assign(static_cast<std::size_t>(n), {});
  for (Offset first = 0; first < n; first += VerticesAtOnce)
  {
    DGG_RETURN_IF_ERROR(ReportTo(progress, static_cast<double>(first) / static_cast<double>(n)));
    const Offset count = std::min(VerticesAtOnce, n - first);
    ForRange(parallel, count, VerticesPerTask, [&](Offset begin, Offset end) {
      VertexFit fit(mesh, distances);
      for (Id v = static_cast<Id>(first + begin); v < first + end; ++v)
      {
        if (!std::isfinite(distances[v]))
        {
          continue;
        }
        Guess guess;
        const double length = fit.Fit(v, guess) ? 1.0 / guess.Curvature : 0.0;
        found[v] = { distances[v] - length, length, guess.Angle };
      }
    });
  }
  return Status::Success();
}
}
