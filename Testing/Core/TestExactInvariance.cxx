// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// What holds on every mesh: bounds, symmetry, and changes of the mesh that change no distance.
#include "EdgeGraph.h"
#include "GeodesicChecks.h"
#include "TestMeshes.h"

#include <cmath>

namespace dggtest
{
class ExactInvariance : public EngineTest
{
protected:
  using Check = std::function<void(const TestMesh&, const dgg::SurfaceMesh&)>;

  static void ForEachMesh(const std::vector<NamedMesh>& meshes, const Check& check)
  {
    for (const NamedMesh& named : meshes)
    {
      SCOPED_TRACE(named.Name);
      check(named.Mesh, Build(named.Mesh));
    }
  }

  /// Expect distances from a vertex to be those in a changed mesh, in which they are longer by a
  /// factor and vertex v has the id `ids[v]`, v if there are none.
  void ExpectUnchanged(const dgg::SurfaceMesh& mesh, const dgg::SurfaceMesh& changed, Id source,
    const std::vector<Id>& ids = {}, double factor = 1.0, double tolerance = 1e-9)
  {
    const auto idOf = [&](Id v) { return ids.empty() ? v : ids[v]; };
    const auto expected = DistancesFrom(mesh, this->Engine(), source);
    const auto there = DistancesFrom(changed, this->Engine(), idOf(source));
    std::vector<double> distances;
    for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
    {
      distances.push_back(there[idOf(v)] / factor);
    }
    ExpectSameField(expected, distances, tolerance * LargestFinite(expected), "changed");
  }
};
DGG_WITH_BOTH_ENGINES(ExactInvariance);

TEST_P(ExactInvariance, LiesBetweenEuclidAndTheEdgeGraph)
{
  this->ForEachMesh(AllMeshes(), [&](const TestMesh& input, const dgg::SurfaceMesh& mesh) {
    for (const Id source : SomeVertices(mesh, 4, 3))
    {
      const auto distances = DistancesFrom(mesh, this->Engine(), source);
      const auto bound = dggtest::EdgeGraphDistances(mesh, { VertexSource(source) });
      const double diameter = LargestFinite(bound);
      for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
      {
        ASSERT_EQ(distances[v] < dgg::Infinity, bound[v] < dgg::Infinity) << v;
        ASSERT_LE(distances[v], bound[v] * (1.0 + 1e-14)) << v;
        if (!input.Points.empty() && distances[v] < dgg::Infinity)
        {
          ASSERT_GE(distances[v], EuclideanDistance(input, source, v) - 1e-9 * diameter) << v;
        }
      }
    }
  });
}

TEST_P(ExactInvariance, IsOneLipschitzAlongEdges)
{
  this->ForEachMesh(AllMeshes(), [&](const TestMesh&, const dgg::SurfaceMesh& mesh) {
    for (const Id source : SomeVertices(mesh, 4, 5))
    {
      const auto distances = DistancesFrom(mesh, this->Engine(), source);
      const double tolerance = 1e-13 * LargestFinite(distances);
      for (Id h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
      {
        const double a = distances[mesh.Origin(h)];
        const double b = distances[mesh.Destination(h)];
        if (!mesh.IsDropped(h / 3) && a < dgg::Infinity)
        {
          ASSERT_LE(std::abs(a - b), mesh.Length(h) + tolerance) << h;
        }
      }
    }
  });
}

TEST_P(ExactInvariance, IsSymmetricBetweenPointsAnywhere)
{
  this->ForEachMesh(AllMeshes(), [&](const TestMesh&, const dgg::SurfaceMesh& mesh) {
    const auto points = RandomSurfacePoints(mesh, 8, 9);
    std::vector<std::vector<double>> table;
    for (const dgg::SurfacePoint& point : points)
    {
      table.push_back(DistancesTo(mesh, this->Engine(), point, points));
    }
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      ASSERT_NEAR(table[i][i], 0.0, 1e-13 * mesh.GetMaximumEdgeLength());
      for (std::size_t j = 0; j < i; ++j)
      {
        if (table[i][j] != table[j][i])
        {
          ASSERT_NEAR(table[i][j], table[j][i], 1e-10 * LargestFinite(table[i])) << i << " " << j;
        }
      }
    }
  });
}

TEST_P(ExactInvariance, ObeysTheTriangleInequality)
{
  this->ForEachMesh(AllMeshes(), [&](const TestMesh&, const dgg::SurfaceMesh& mesh) {
    const auto vertices = SomeVertices(mesh, 4, 11);
    std::vector<std::vector<double>> fields;
    for (const Id v : vertices)
    {
      fields.push_back(DistancesFrom(mesh, this->Engine(), v));
    }
    for (std::size_t i = 0; i < vertices.size(); ++i)
    {
      for (std::size_t j = 0; j < vertices.size(); ++j)
      {
        const double between = fields[i][vertices[j]];
        for (Id v = 0; v < mesh.GetNumberOfVertices() && between < dgg::Infinity; ++v)
        {
          if (fields[i][v] < dgg::Infinity)
          {
            ASSERT_LE(fields[i][v], between + fields[j][v] + 1e-10 * LargestFinite(fields[i]));
          }
        }
      }
    }
  });
}

TEST_P(ExactInvariance, InsertedVerticesChangeNothing)
{
  this->ForEachMesh(SoundMeshes(), [&](const TestMesh& input, const dgg::SurfaceMesh& mesh) {
    const double area = 1e-4 * mesh.GetMeanEdgeLength() * mesh.GetMeanEdgeLength();
    const dgg::SurfaceMesh refined = Build(RandomlyRefined(input, 60, 13, area));
    for (const Id source : SomeVertices(mesh, 4, 13))
    {
      const auto expected = DistancesFrom(mesh, this->Engine(), source);
      auto distances = DistancesFrom(refined, this->Engine(), source);
      distances.resize(expected.size());
      for (std::size_t v = 0; v < expected.size(); ++v)
      {
        if (expected[v] != distances[v])
        {
          ASSERT_NEAR(expected[v], distances[v], 1e-9 * expected[v]) << source << " " << v;
        }
      }
    }
  });
}

TEST_P(ExactInvariance, InsertedVerticesChangeNothingAtSpines)
{
  std::vector<Id> sheetOf;
  Id unused = 0;
  for (const TestMesh& input : { WithNoise(Book(3, 4, sheetOf, 0.2, 2), 0.15, 3),
         WithNoise(PlaneWithFin(4, unused, 0.2, 4), 0.15, 5),
         VoxelSurface(2, 2, 1, [](Id i, Id j, Id) { return i == j; }), PinchedPlates(3) })
  {
    const dgg::SurfaceMesh mesh = Build(input);
    for (std::uint64_t seed = 1; seed <= 3; ++seed)
    {
      const dgg::SurfaceMesh refined = Build(RandomlyRefined(input, 60, seed, 1e-4));
      for (const Id source : SomeVertices(mesh, 5, seed))
      {
        this->ExpectUnchanged(mesh, refined, source);
      }
    }
  }
}

TEST_P(ExactInvariance, ScalesWithTheMesh)
{
  this->ForEachMesh(AllMeshes(), [&](const TestMesh& input, const dgg::SurfaceMesh& mesh) {
    for (const double factor : { 1e6, 1e-6, 1024.0 })
    {
      // Faces that are degenerate up to rounding are lengthened by what rounding left of them.
      const double tolerance = mesh.GetNumberOfDegenerateFaces() > 0 ? 1e-6 : 1e-9;
      this->ExpectUnchanged(mesh, Build(Scaled(input, factor)), 0, {}, factor, tolerance);
    }
  });
}

TEST_P(ExactInvariance, DoesNotDependOnNumbering)
{
  this->ForEachMesh(AllMeshes(), [&](const TestMesh& input, const dgg::SurfaceMesh& mesh) {
    const auto newIds = RandomPermutation(mesh.GetNumberOfVertices(), 19);
    const dgg::SurfaceMesh renumbered = Build(Renumbered(input, newIds, 20));
    for (const Id source : SomeVertices(mesh, 3, 21))
    {
      this->ExpectUnchanged(mesh, renumbered, source, newIds);
    }
  });
}

TEST_P(ExactInvariance, DoesNotDependOnOrientation)
{
  this->ForEachMesh(AllMeshes(), [&](const TestMesh& input, const dgg::SurfaceMesh& mesh) {
    if (input.Points.empty())
    {
      return;
    }
    TestMesh turned = input;
    Random random(23);
    for (Id f = 0; f < turned.GetNumberOfFaces(); ++f)
    {
      if (random.Uniform() < 0.5)
      {
        std::swap(turned.Triangles[3 * f + 1], turned.Triangles[3 * f + 2]);
      }
    }
    this->ExpectUnchanged(mesh, Build(turned), 1);
  });
}

TEST_P(ExactInvariance, DoesNotDependOnThePlaceInSpace)
{
  this->ForEachMesh(SoundMeshes(), [&](const TestMesh& input, const dgg::SurfaceMesh& mesh) {
    for (const double angle : { 0.3, 2.0 })
    {
      this->ExpectUnchanged(mesh, Build(MovedRigidly(input, angle, { { 3.0, -7.0, 11.0 } })), 0);
    }
  });
}

TEST_P(ExactInvariance, SeamsAndUnusedPointsChangeNothing)
{
  // Isolated points, and faces that take no part, beside the mesh.
  const TestMesh sphere = NoisySphere(2, 0.2, 3);
  TestMesh crowded = sphere;
  crowded.AddPoint(9.0, 9.0, 9.0);
  crowded.AddTriangle(0, 0, 5);
  crowded.AddTriangle(3, 4, 3);
  const auto expected = DistancesFrom(Build(sphere), this->Engine(), 0);
  auto distances = DistancesFrom(Build(crowded), this->Engine(), 0);
  EXPECT_EQ(distances.back(), dgg::Infinity);
  distances.pop_back();
  EXPECT_EQ(distances, expected);
}

TEST_P(ExactInvariance, ZippedSeamsConduct)
{
  // Faces of zero area across a seam make the plane whole again, up to the mollification.
  ExpectEuclid(ZippedPlane(6), this->Engine(), 0.0, 1e-11);
}
}
