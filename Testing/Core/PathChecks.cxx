// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PathChecks.h"

#include "GeodesicChecks.h"

#include "dggExactGeodesics.h"
#include "dggExactPath.h"

namespace dggtest
{
namespace
{
using dgg::Id;
using dgg::SurfacePath;
using dgg::SurfacePoint;

/// Relative position on the adjacent pieces at which the neighborhood of a point is sampled.
constexpr double Fraction = 1e-3;

/// Returns a surface point on piece `i` of a path, close to the end point `at` of the piece.
SurfacePoint Beside(
  const dgg::SurfaceMesh& mesh, const SurfacePath& path, std::size_t i, std::size_t at)
{
  const Id face = path.Faces[i];
  std::array<double, 3> near{};
  std::array<double, 3> far{};
  dgg::FindInFace(mesh, path.Points[at], face, near);
  dgg::FindInFace(mesh, path.Points[at == i ? i + 1 : i], face, far);
  std::array<double, 3> between{};
  for (int k = 0; k < 3; ++k)
  {
    between[k] = (1.0 - Fraction) * near[k] + Fraction * far[k];
  }
  if (mesh.IsFlipped(face))
  {
    std::swap(between[1], between[2]);
  }
  return SurfacePoint::InFace(mesh, face, between);
}

/// Expects the path to be locally shortest at the point where two pieces meet.
void ExpectShortestBetween(const dgg::SurfaceMesh& mesh, dgg::ExactGeodesics& solver,
  const SurfacePath& path, std::size_t in, std::size_t out)
{
  const double before = dgg::MeasurePiece(mesh, path, in);
  const double after = dgg::MeasurePiece(mesh, path, out);
  if (std::min(before, after) < 1e-3 * mesh.GetMeanEdgeLength())
  {
    return; // too short: rounding errors dominate
  }
  dgg::ExactOptions options;
  options.Targets = { Beside(mesh, path, out, out) };
  options.StopAtTargets = true;
  dgg::ExactResult result;
  ASSERT_TRUE(Ok(solver.Run({ { Beside(mesh, path, in, in + 1), 0.0 } }, options, result)));
  EXPECT_GT(result.TargetDistances[0], Fraction * (before + after) * (1.0 - 1e-6))
    << "bend at point " << out;
}
}

std::vector<SurfacePoint> AtVertices(const std::vector<Id>& vertices)
{
  std::vector<SurfacePoint> points;
  for (const Id v : vertices)
  {
    points.push_back(SurfacePoint::AtVertex(v));
  }
  return points;
}

std::vector<SurfacePoint> SomePoints(
  const dgg::SurfaceMesh& mesh, Id inFaces, Id atVertices, std::uint64_t seed)
{
  std::vector<SurfacePoint> points = RandomSurfacePoints(mesh, inFaces, seed);
  const std::vector<SurfacePoint> more = AtVertices(SomeVertices(mesh, atVertices, seed + 1));
  points.insert(points.end(), more.begin(), more.end());
  return points;
}

SurfacePoint PointInPlane(const TestMesh& points, const dgg::SurfaceMesh& mesh, double x, double y)
{
  for (Id f = 0; f < mesh.GetNumberOfFaces(); ++f)
  {
    std::array<const double*, 3> p{};
    for (int k = 0; k < 3; ++k)
    {
      p[k] = points.Points.data() + 3 * points.Triangles[3 * f + k];
    }
    const auto area = [](double ax, double ay, double bx, double by, double cx, double cy) {
      return (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
    };
    const double whole = area(p[0][0], p[0][1], p[1][0], p[1][1], p[2][0], p[2][1]);
    const double b1 = area(p[0][0], p[0][1], x, y, p[2][0], p[2][1]) / whole;
    const double b2 = area(p[0][0], p[0][1], p[1][0], p[1][1], x, y) / whole;
    if (b1 >= -1e-12 && b2 >= -1e-12 && b1 + b2 <= 1.0 + 1e-12)
    {
      return SurfacePoint::InFace(mesh, f, { { 1.0 - b1 - b2, b1, b2 } });
    }
  }
  ADD_FAILURE() << "not on the mesh";
  return SurfacePoint();
}

std::vector<SurfacePath> FindPaths(
  const dgg::SurfaceMesh& mesh, const SurfacePoint& from, const std::vector<SurfacePoint>& to)
{
  std::vector<SurfacePath> paths;
  EXPECT_TRUE(Ok(dgg::ExactPathFinder(mesh).Find(from, to, nullptr, paths)));
  paths.resize(to.size());
  return paths;
}

SurfacePath PathBetween(const dgg::SurfaceMesh& mesh, Id from, Id to)
{
  return FindPaths(mesh, SurfacePoint::AtVertex(from), { SurfacePoint::AtVertex(to) })[0];
}

void AppendPath(const SurfacePath& more, SurfacePath& path)
{
  path.Points.insert(
    path.Points.end(), more.Points.begin() + (path.Points.empty() ? 0 : 1), more.Points.end());
  path.Faces.insert(path.Faces.end(), more.Faces.begin(), more.Faces.end());
  path.Length += more.Length;
}

void ExpectLocallyShortest(
  const dgg::SurfaceMesh& mesh, const SurfacePath& path, bool isSmoothAtStart)
{
  dgg::ExactGeodesics solver(mesh);
  // Test about a dozen points of long paths.
  const std::size_t step = 1 + path.Faces.size() / 12;
  for (std::size_t i = 1; i < path.Faces.size(); i += step)
  {
    ExpectShortestBetween(mesh, solver, path, i - 1, i);
  }
  if (isSmoothAtStart && !path.Faces.empty())
  {
    ExpectShortestBetween(mesh, solver, path, path.Faces.size() - 1, 0);
  }
}
}
