// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Flips of edges, Delaunay triangulations, and the cotangent Laplacian on them.
#include "TestMeshes.h"

#include "dggLaplaceSystem.h"

#include <algorithm>
#include <cmath>

namespace dggtest
{
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

/// Returns the number of flips.
dgg::Offset Flip(dgg::IntrinsicTriangulation& triangulation)
{
  dgg::Offset flips = 0;
  EXPECT_TRUE(dgg::MakeDelaunay(triangulation, nullptr, flips).IsOk());
  return flips;
}

/// Of the two corners that face an edge; it is Delaunay when that is not negative.
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

/// Meshes far from Delaunay, of moderate cotangents.
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
    // Faces that were lengthened a little have angles as uncertain as that.
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
      // Sides of the square have one corner of 45 degrees opposite, the diagonals none.
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
    // The energy of a linear function is its squared slope times the area.
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
  // Right-angled needles.
  for (const double size : { 1e-5, 1e-9 })
  {
    TestMesh mesh;
    mesh.AddPoint(0.0, 0.0, 0.0);
    mesh.AddPoint(size, 0.0, 0.0);
    mesh.AddPoint(0.0, 1.0, 0.0);
    mesh.AddTriangle(0, 1, 2);
    const dgg::IntrinsicTriangulation needle(Build(mesh));
    EXPECT_NEAR(needle.Cotangent(2) * size, 1.0, 1e-6);
    EXPECT_NEAR(needle.Cotangent(1), size, size); // what the rounding of lengths leaves of it
    EXPECT_NEAR(needle.Cotangent(0), 0.0, size);
    mesh.Points[3] = 1.0; // a cap: a base of 1, the apex above its middle
    mesh.Points[6] = 0.5;
    mesh.Points[7] = size;
    const dgg::IntrinsicTriangulation cap(Build(mesh));
    if (size > 1e-6) // else the edges are as long as the base, in doubles
    {
      EXPECT_NEAR(cap.Cotangent(0) * 2.0 * size, 1.0, 1e-5);
    }
  }
}
}
