// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// The heat method, and Laplacians on intrinsic triangulations.
#include "GeodesicChecks.h"
#include "TestMeshes.h"

#include "dggHeatMethod.h"
#include "dggLaplaceSystem.h"

namespace dggtest
{
namespace
{
/// A prepared heat method.
class Heat
{
public:
  explicit Heat(const dgg::SurfaceMesh& mesh, const dgg::HeatOptions& options = {})
    : Method(mesh)
  {
    EXPECT_TRUE(Ok(this->Method.Prepare(options, nullptr)));
  }

  dgg::HeatResult Run(
    const std::vector<dgg::GeodesicSource>& sources, const dgg::HeatQuery& query = {}) const
  {
    dgg::HeatResult result;
    EXPECT_TRUE(Ok(this->Method.Run(sources, query, result)));
    return result;
  }

  dgg::HeatMethod Method;
};

dgg::HeatOptions Direct()
{
  dgg::HeatOptions options;
  options.IntrinsicDelaunay = false;
  return options;
}

dgg::HeatOptions WithBoundary(dgg::HeatBoundary boundary)
{
  dgg::HeatOptions options;
  options.Boundary = boundary;
  return options;
}

double MeanError(const std::vector<double>& actual, const std::vector<double>& expected)
{
  return Compare(actual, expected).Mean;
}

/// Number of columns of a strip so long that heat underflows in doubles.
constexpr Id StripColumns = 1500;
TestMesh LongStrip()
{
  return Plane(StripColumns, 2);
}
}

TEST(HeatMethod, ConvergesInThePlane)
{
  double previous = 1.0;
  for (const Id n : { 10, 20, 40, 80 })
  {
    const TestMesh plane = Plane(n, n, 0.2, 3);
    const Id source = (n / 2) * (n + 1) + n / 2;
    const double error = MeanError(Heat(Build(plane)).Run({ VertexSource(source) }).Distances,
      EuclideanDistances(plane, source));
    EXPECT_LT(error, 0.75 * previous) << n;
    previous = error;
  }
  EXPECT_LT(previous, 0.012);
}

TEST(HeatMethod, FlipsHelpOnLongTriangles)
{
  const dgg::SurfaceMesh mesh = Build(Ellipsoid(4, 20.0));
  const auto exact = DistancesFrom(mesh, dgg::ExactEngine::Triangle, 7);
  const double flipped = MeanError(Heat(mesh).Run({ VertexSource(7) }).Distances, exact);
  const double direct = MeanError(Heat(mesh, Direct()).Run({ VertexSource(7) }).Distances, exact);
  EXPECT_LT(flipped, direct);
  EXPECT_LT(flipped, 0.08);
}

TEST(HeatMethod, AnotherComponentChangesNothing)
{
  const TestMesh input = NoisySphere(3, 0.2, 9);
  const dgg::SurfaceMesh alone = Build(input);
  const auto expected = Heat(alone).Run({ VertexSource(5) }).Distances;
  TestMesh both = input;
  Append(both, Translated(Scaled(Icosphere(2), 1000.0), 5000.0, 0.0, 0.0));
  both.AddPoint(1.0, 2.0, 3.0); // isolated
  const dgg::SurfaceMesh mesh = Build(both);
  const Heat heat(mesh);
  const auto distances = heat.Run({ VertexSource(5) }).Distances;
  for (std::size_t v = 0; v < distances.size(); ++v)
  {
    if (v < expected.size())
    {
      EXPECT_NEAR(distances[v], expected[v], 1e-9);
    }
    else
    {
      EXPECT_EQ(distances[v], dgg::Infinity);
    }
  }
  // An isolated source reaches only itself.
  const Id last = mesh.GetNumberOfVertices() - 1;
  const auto fromLast = heat.Run({ VertexSource(last, 0.5) }).Distances;
  EXPECT_EQ(fromLast[last], 0.5);
  EXPECT_EQ(fromLast[0], dgg::Infinity);
}

TEST(HeatMethod, FartherThanHeatReaches)
{
  const TestMesh strip = LongStrip();
  const dgg::SurfaceMesh mesh = Build(strip);
  for (const dgg::HeatOptions& options : { dgg::HeatOptions(),
         WithBoundary(dgg::HeatBoundary::Average), WithBoundary(dgg::HeatBoundary::Dirichlet) })
  {
    const Id source = StripColumns + 1 + 3; // in the middle row
    const auto distances = Heat(mesh, options).Run({ VertexSource(source) }).Distances;
    double slope = 0.0;
    for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
    {
      ASSERT_TRUE(std::isfinite(distances[v])) << v;
      const double expected = EuclideanDistance(strip, source, v);
      // With Dirichlet conditions all gradients in such a strip point to the rim; values only have
      // to be finite.
      if (expected > 20.0 && options.Boundary != dgg::HeatBoundary::Dirichlet)
      {
        EXPECT_NEAR(distances[v] / expected, 1.0, 0.05) << v;
      }
      slope = std::max(slope, distances[v]);
    }
    EXPECT_GT(slope, options.Boundary == dgg::HeatBoundary::Dirichlet ? 100.0 : 1400.0);
  }
}

TEST(HeatMethod, LittleHeatIsAsGoodAsMuch)
{
  // Compares the field in doubles with the field in numbers of a larger range. A source with a
  // large initial distance, which has no influence, selects the larger range.
  const dgg::SurfaceMesh mesh = Build(NoisySphere(3, 0.2, 9));
  const Heat heat(mesh);
  const auto doubles = heat.Run({ VertexSource(5) }).Distances;
  const double far = 1000.0 * mesh.GetMeanEdgeLength();
  const auto wide = heat.Run({ VertexSource(5), VertexSource(60, far) }).Distances;
  ExpectSameField(doubles, wide, 1e-9, "field");
  // A smaller initial distance without influence: still in doubles.
  const double near = 50.0 * mesh.GetMeanEdgeLength();
  ExpectSameField(
    doubles, heat.Run({ VertexSource(5), VertexSource(60, near) }).Distances, 1e-9, "field");
}

TEST(HeatMethod, SourcesAnywhere)
{
  const TestMesh plane = Plane(30, 30, 0.2, 5);
  const dgg::SurfaceMesh mesh = Build(plane);
  const Heat heat(mesh);
  std::vector<dgg::SurfacePoint> points = RandomSurfacePoints(mesh, 6, 3);
  points.push_back(dgg::SurfacePoint::OnEdge(mesh, 1000, 0.3));
  for (const dgg::SurfacePoint& point : points)
  {
    const auto exact = Solve(mesh, dgg::ExactEngine::Triangle, { { point, 0.25 } }).Distances;
    const auto distances = heat.Run({ { point, 0.25 } }).Distances;
    EXPECT_LT(MeanError(distances, exact), 0.06);
    for (std::size_t v = 0; v < distances.size(); ++v)
    {
      EXPECT_NEAR(distances[v], exact[v], 3.0) << v;
    }
  }
}

TEST(HeatMethod, Boundaries)
{
  const TestMesh plane = Plane(24, 24, 0.2, 5);
  const dgg::SurfaceMesh mesh = Build(plane);
  const Id middle = 12 * 25 + 12;
  const auto exact = DistancesFrom(mesh, dgg::ExactEngine::Triangle, middle);
  const Heat neumann(mesh);
  const Heat dirichlet(mesh, WithBoundary(dgg::HeatBoundary::Dirichlet));
  const Heat average(mesh, WithBoundary(dgg::HeatBoundary::Average));
  std::vector<double> means;
  for (const Heat* heat : { &neumann, &dirichlet, &average })
  {
    const auto distances = heat->Run({ VertexSource(middle) }).Distances;
    EXPECT_LT(MeanError(distances, exact), 0.12);
    means.push_back(distances[0]);
  }
  // At a corner the two boundary conditions give different distances.
  EXPECT_NE(means[0], means[1]);
  EXPECT_GT(means[2], std::min(means[0], means[1]));
  EXPECT_LT(means[2], std::max(means[0], means[1]));

  // With Dirichlet conditions, a source on the boundary has no heat.
  dgg::HeatResult result;
  const dgg::Status status =
    dirichlet.Method.Run({ VertexSource(middle), VertexSource(3) }, {}, result);
  EXPECT_FALSE(status.IsOk());
  EXPECT_TRUE(Says(status, "Source 1 lies on the boundary"));
  EXPECT_LT(MeanError(average.Run({ VertexSource(3) }).Distances,
              DistancesFrom(mesh, dgg::ExactEngine::Triangle, 3)),
    0.12);
}

namespace
{
struct Measures
{
  double Area = 0.0;
  std::vector<double> Angles; // per vertex
};

Measures Measure(const dgg::IntrinsicTriangulation& triangulation)
{
  Measures measures;
  measures.Angles.assign(triangulation.GetNumberOfVertices(), 0.0);
  for (Id h = 0; h < triangulation.GetNumberOfHalfEdges(); ++h)
  {
    measures.Area += triangulation.Area(h / 3) / 3.0;
    measures.Angles[triangulation.Origin(h)] += std::atan2(1.0, triangulation.Cotangent(h));
  }
  return measures;
}

void ExpectConsistent(const dgg::IntrinsicTriangulation& triangulation)
{
  for (Id h = 0; h < triangulation.GetNumberOfHalfEdges(); ++h)
  {
    const Id t = triangulation.Twin(h);
    if (t == dgg::NoId)
    {
      continue;
    }
    ASSERT_NE(t, h);
    ASSERT_EQ(triangulation.Length(t), triangulation.Length(h)) << h;
    const auto ends = std::minmax({ triangulation.Origin(h), triangulation.Destination(h) });
    ASSERT_EQ(ends, std::minmax({ triangulation.Origin(t), triangulation.Destination(t) })) << h;
    Id g = t;
    for (int steps = 0; g != h; g = triangulation.Twin(g))
    {
      ASSERT_LT(++steps, 1000) << "the list of edge " << h << " is not closed";
    }
  }
}

/// Flips edges and returns the number of flips.
dgg::Offset Flip(dgg::IntrinsicTriangulation& triangulation)
{
  dgg::Offset flips = 0;
  EXPECT_TRUE(dgg::MakeDelaunay(triangulation, nullptr, flips).IsOk());
  return flips;
}

/// Returns the sum of the cotangents of the two corners opposite to an edge. The edge is Delaunay
/// if the sum is not negative.
double CotangentSum(const dgg::IntrinsicTriangulation& triangulation, Id h)
{
  return triangulation.Cotangent(dgg::SurfaceMesh::Previous(h)) +
    triangulation.Cotangent(dgg::SurfaceMesh::Previous(triangulation.Twin(h)));
}

double LeastCotangentSum(const dgg::IntrinsicTriangulation& triangulation)
{
  double least = dgg::Infinity;
  for (Id h = 0; h < triangulation.GetNumberOfHalfEdges(); ++h)
  {
    if (triangulation.IsFlippable(h))
    {
      least = std::min(least, CotangentSum(triangulation, h));
    }
  }
  return least;
}

dgg::CotanLaplacian LaplacianOf(const dgg::SurfaceMesh& mesh)
{
  return dgg::MakeCotanLaplacian(dgg::IntrinsicTriangulation(mesh));
}

/// Returns meshes far from Delaunay with moderate cotangents.
std::vector<NamedMesh> FlipMeshes()
{
  std::vector<Id> sheetOf;
  return Joined(SoundMeshes(),
    { { "Moebius", MoebiusStrip(9, 4) }, { "Klein", KleinBottle(5, 7) },
      { "misoriented", MisorientedSphere(3, 5) },
      { "coarse torus", FlatTorus(1.0, 3.3, 0.4, 1, 1, true) },
      { "sheared torus", FlatTorus(1.0, 7.3, 0.9, 2, 3, true) }, { "pinched", PinchedPlates(3) },
      { "book", WithNoise(Book(3, 5, sheetOf, 0.25, 6), 0.2, 7) } });
}
}

TEST(IntrinsicDelaunay, CotangentsAddUpToNothingNegative)
{
  dgg::Offset flips = 0;
  for (const NamedMesh& named : FlipMeshes())
  {
    SCOPED_TRACE(named.Name);
    dgg::IntrinsicTriangulation triangulation(Build(named.Mesh));
    flips += Flip(triangulation);
    EXPECT_GE(LeastCotangentSum(triangulation), -1e-10);
    ExpectConsistent(triangulation);
    EXPECT_EQ(Flip(triangulation), 0);
  }
  EXPECT_GT(flips, 1000);
}

TEST(IntrinsicDelaunay, AreasAnglesAndBoundariesStay)
{
  for (const NamedMesh& named : Joined(FlipMeshes(), DefectMeshes()))
  {
    SCOPED_TRACE(named.Name);
    const dgg::SurfaceMesh surface = Build(named.Mesh);
    dgg::IntrinsicTriangulation triangulation(surface);
    const Measures before = Measure(triangulation);
    const auto collectFixed = [&] {
      std::vector<double> lengths;
      for (Id h = 0; h < triangulation.GetNumberOfHalfEdges(); ++h)
      {
        const Id t = triangulation.Twin(h);
        if (t == dgg::NoId || triangulation.Twin(t) != h)
        {
          lengths.push_back(triangulation.Length(h));
        }
      }
      std::sort(lengths.begin(), lengths.end());
      return lengths;
    };
    const std::vector<double> fixed = collectFixed();
    Flip(triangulation);
    ExpectConsistent(triangulation);
    EXPECT_EQ(collectFixed(), fixed);
    const Measures after = Measure(triangulation);
    EXPECT_NEAR(after.Area, before.Area, 1e-9 * before.Area);
    // Mollified faces have angles with an uncertainty of this size.
    const double tolerance = surface.GetMollification() > 0.0 ? 2e-3 : 1e-8;
    for (std::size_t v = 0; v < before.Angles.size(); ++v)
    {
      EXPECT_NEAR(after.Angles[v], before.Angles[v], tolerance) << v;
    }
  }
}

TEST(CotanLaplacian, Conventions)
{
  // Two right triangles with legs of 1: cotangents are 1 at the acute corners, 0 at the right ones.
  const dgg::CotanLaplacian square = LaplacianOf(Build(Plane(1, 1)));
  double total = 0.0;
  for (Id i = 0; i < 4; ++i)
  {
    double row = 0.0;
    for (Id j = 0; j < 4; ++j)
    {
      const double entry = square.Stiffness.coeff(i, j);
      EXPECT_EQ(entry, square.Stiffness.coeff(j, i));
      row += entry;
      // Sides of the square have one opposite corner of 45 degrees, diagonals none.
      const bool isSide = ((i ^ j) == 1) || ((i ^ j) == 2);
      EXPECT_NEAR(entry, i == j ? 1.0 : (isSide ? -0.5 : 0.0), 1e-15) << i << " " << j;
    }
    EXPECT_NEAR(row, 0.0, 1e-15);
    total += square.Mass[i];
  }
  EXPECT_NEAR(total, 1.0, 1e-15);
}

TEST(CotanLaplacian, LinearFunctionsInThePlane)
{
  const TestMesh plane = Plane(12, 9, 0.25, 7);
  const dgg::SurfaceMesh surface = Build(plane);
  dgg::IntrinsicTriangulation flipped(surface);
  EXPECT_GT(Flip(flipped), 0);
  for (const dgg::CotanLaplacian& laplacian :
    { LaplacianOf(surface), dgg::MakeCotanLaplacian(flipped) })
  {
    Eigen::VectorXd values(surface.GetNumberOfVertices());
    for (Id v = 0; v < surface.GetNumberOfVertices(); ++v)
    {
      values[v] = 3.0 * plane.Point(v)[0] - 2.0 * plane.Point(v)[1] + 5.0;
    }
    const Eigen::VectorXd image = laplacian.Stiffness * values;
    for (Id v = 0; v < surface.GetNumberOfVertices(); ++v)
    {
      if (surface.Kind(v) == dgg::VertexKind::Flat)
      {
        EXPECT_NEAR(image[v], 0.0, 1e-12);
      }
    }
    // The energy of a linear function is its squared gradient times the area.
    EXPECT_NEAR(values.dot(image), 13.0 * 108.0, 1e-9);
    EXPECT_NEAR(laplacian.Mass.sum(), 108.0, 1e-11);
  }
}

TEST(CotanLaplacian, PositiveSemidefinite)
{
  for (const NamedMesh& named : AllMeshes())
  {
    SCOPED_TRACE(named.Name);
    const dgg::SurfaceMesh surface = Build(named.Mesh);
    const dgg::CotanLaplacian laplacian = LaplacianOf(surface);
    for (std::uint64_t seed = 1; seed <= 5; ++seed)
    {
      const std::vector<double> random = RandomValues(surface.GetNumberOfVertices(), seed);
      const auto values = Eigen::Map<const Eigen::VectorXd>(random.data(), random.size());
      const Eigen::VectorXd image = laplacian.Stiffness * values;
      EXPECT_GE(values.dot(image), -1e-12 * image.cwiseAbs().sum());
      EXPECT_NEAR(image.sum(), 0.0, 1e-11 * image.cwiseAbs().sum());
    }
    EXPECT_GE(laplacian.Mass.minCoeff(), 0.0);
  }
}

TEST(CotanLaplacian, SliversAreAccurate)
{
  // Right-angled needle triangles.
  for (const double size : { 1e-5, 1e-9 })
  {
    TestMesh mesh;
    mesh.AddPoint(0.0, 0.0, 0.0);
    mesh.AddPoint(size, 0.0, 0.0);
    mesh.AddPoint(0.0, 1.0, 0.0);
    mesh.AddTriangle(0, 1, 2);
    const dgg::IntrinsicTriangulation needle(Build(mesh));
    EXPECT_NEAR(needle.Cotangent(2) * size, 1.0, 1e-6);
    EXPECT_NEAR(needle.Cotangent(1), size, size); // rounding error of lengths
    EXPECT_NEAR(needle.Cotangent(0), 0.0, size);
    mesh.Points[3] = 1.0; // a cap: base of length 1, apex above its midpoint
    mesh.Points[6] = 0.5;
    mesh.Points[7] = size;
    const dgg::IntrinsicTriangulation cap(Build(mesh));
    if (size > 1e-6) // otherwise the edges are as long as the base, in doubles
    {
      EXPECT_NEAR(cap.Cotangent(0) * 2.0 * size, 1.0, 1e-5);
    }
  }
}
}
