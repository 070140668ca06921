// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Paths traced from a graph: they lie on the surface, have the length of the graph path, and become
// locally shortest when straightened.
#include "GeodesicChecks.h"
#include "GraphChecks.h"
#include "PathChecks.h"
#include "TestMeshes.h"

#include "dggExactPath.h"
#include "dggPathCorridor.h"
#include "dggPathFinder.h"

namespace dggtest
{
namespace
{
using dgg::FoundPath;
using dgg::PathOptions;
using dgg::SurfacePath;
using dgg::SurfacePoint;

PathOptions Raw()
{
  PathOptions options;
  options.Straighten = false;
  return options;
}

PathOptions Straight(double detour = 0.0)
{
  PathOptions options;
  options.Detour = detour;
  return options;
}

/// A mesh, its graph, and paths in the graph.
class PathWorld
{
public:
  explicit PathWorld(const TestMesh& mesh, double accuracy = 0.05)
    : Input(mesh)
    , Mesh(Build(mesh))
    , Builder(Mesh)
  {
    dgg::GraphOptions options;
    options.Accuracy = accuracy;
    EXPECT_TRUE(Ok(this->Builder.Build(options, this->Graph)));
    this->Search = std::make_unique<dgg::GraphSearch>(this->Graph.View(), &this->Mesh);
    this->Finder = std::make_unique<dgg::PathFinder>(this->Mesh, *this->Search, &this->Builder,
      this->Input.Points.empty() ? nullptr : this->Input.Points.data());
  }

  FoundPath Find(const SurfacePoint& from, const SurfacePoint& to, const PathOptions& options) const
  {
    FoundPath found;
    EXPECT_TRUE(Ok(this->Finder->Find(from, to, options, found)));
    return found;
  }

  TestMesh Input;
  dgg::SurfaceMesh Mesh;
  dgg::GraphBuilder Builder;
  dgg::GeodesicGraph Graph;
  std::unique_ptr<dgg::GraphSearch> Search;
  std::unique_ptr<dgg::PathFinder> Finder;
};

bool IsSamePlace(const dgg::SurfaceMesh& mesh, const SurfacePoint& a, const SurfacePoint& b)
{
  const Id face = dgg::FindFaceOf(mesh, a);
  std::array<double, 3> p{};
  std::array<double, 3> q{};
  return face == dgg::NoId ? a.Vertex == b.Vertex
                           : dgg::FindInFace(mesh, a, face, p) &&
      dgg::FindInFace(mesh, b, face, q) && dgg::DistanceInFace(mesh, face, p, q) == 0.0;
}

struct Tally
{
  int Paths = 0;
  int Shortest = 0;
};

/// Checks all guarantees of a path.
void ExpectGoodPaths(const TestMesh& input, double accuracy, std::uint64_t seed, Tally& tally)
{
  const PathWorld world(input, accuracy);
  const dgg::SurfaceMesh& mesh = world.Mesh;
  const bool isMollified = mesh.GetNumberOfDegenerateFaces() > 0;
  const double tolerance = 1e-9 + (isMollified ? 1e-6 : 0.0);
  const std::vector<SurfacePoint> to = SomePoints(mesh, 6, 6, seed + 10);
  for (const SurfacePoint& from : SomePoints(mesh, 3, 3, seed))
  {
    const std::vector<double> exact = DistancesTo(mesh, dgg::ExactEngine::Triangle, from, to);
    for (std::size_t t = 0; t < to.size(); ++t)
    {
      SCOPED_TRACE(t);
      const FoundPath raw = world.Find(from, to[t], Raw());
      const FoundPath straight = world.Find(from, to[t], Straight());
      const FoundPath best = world.Find(from, to[t], Straight(1e-3));
      EXPECT_EQ(raw.NumberOfFallbacks, 0);
      EXPECT_EQ(raw.GraphLength, straight.GraphLength);
      EXPECT_FALSE(raw.IsStraightened && raw.GraphLength > 0.0);
      for (const FoundPath* found : { &raw, &straight, &best })
      {
        ASSERT_EQ(found->Path.IsEmpty(), exact[t] == dgg::Infinity);
        ASSERT_EQ(found->GraphLength == dgg::Infinity, exact[t] == dgg::Infinity);
        if (found->Path.IsEmpty())
        {
          continue;
        }
        ASSERT_TRUE(Ok(dgg::CheckPath(mesh, found->Path)));
        EXPECT_TRUE(IsSamePlace(mesh, found->Path.Points.front(), from));
        EXPECT_TRUE(IsSamePlace(mesh, found->Path.Points.back(), to[t]));
        EXPECT_GE(found->Path.Length, exact[t] * (1.0 - tolerance));
        EXPECT_LE(found->Path.Length, found->GraphLength * (1.0 + tolerance))
          << (found == &raw ? "raw " : "straight ")
          << found->Path.Length / found->GraphLength - 1.0;
        EXPECT_LE(found->GraphLength, (1.0 + accuracy) * exact[t] * (1.0 + 1e-6));
        for (std::size_t i = 1; i + 1 < found->Path.Points.size(); ++i)
        {
          EXPECT_NE(found->Path.Points[i].On, SurfacePoint::Support::Face);
        }
      }
      if (exact[t] == dgg::Infinity || exact[t] == 0.0)
      {
        continue;
      }
      EXPECT_LE(straight.Path.Length, raw.Path.Length * (1.0 + 1e-10));
      EXPECT_LE(best.Path.Length, straight.Path.Length * (1.0 + 1e-10));
      if (!isMollified)
      {
        ExpectLocallyShortest(mesh, straight.Path);
        ExpectLocallyShortest(mesh, best.Path);
      }
      ++tally.Paths;
      tally.Shortest += best.Path.Length <= exact[t] * (1.0 + 1e-6) ? 1 : 0;
    }
  }
}

/// Checks paths on several meshes, and expects at least the fraction `share` to be globally
/// shortest.
void ExpectShortestPaths(
  const std::vector<NamedMesh>& meshes, double accuracy, std::uint64_t seed, double share)
{
  Tally tally;
  for (const NamedMesh& named : meshes)
  {
    SCOPED_TRACE(named.Name);
    ExpectGoodPaths(named.Mesh, accuracy, seed, tally);
  }
  EXPECT_GT(tally.Shortest, share * tally.Paths);
}
}

TEST(PathFinder, GoodPathsEverywhere)
{
  ExpectShortestPaths(SoundMeshes(), 0.05, 3, 0.9);
  ExpectShortestPaths(DefectMeshes(), 0.05, 5, 0.9);
  std::vector<NamedMesh> soups;
  for (std::uint64_t seed = 0; seed < 40; ++seed)
  {
    soups.push_back({ "soup " + std::to_string(seed), RandomSoup(20, 40, seed) });
  }
  ExpectShortestPaths(soups, 0.1, 1, 0.9);
}

TEST(PathFinder, FineGraph)
{
  std::vector<NamedMesh> meshes = SoundMeshes();
  meshes.erase(std::remove_if(meshes.begin(), meshes.end(),
                 [](const NamedMesh& m) { return m.Mesh.GetNumberOfVertices() >= 500; }),
    meshes.end());
  ExpectShortestPaths(meshes, 5e-6, 7, 0.99); // lengths are stored as double
}

/// Narrow faces split windows, so that a corridor needs more windows than the solver may process.
/// The result is then the locally shortest path, as without a corridor.
TEST(PathFinder, CorridorsThatTakeTooLong)
{
  const PathWorld world(Torus(6, 1000), 0.2);
  const SurfacePoint from = SurfacePoint::AtVertex(1);
  const SurfacePoint to = SurfacePoint::AtVertex(3010); // on the opposite side
  const FoundPath straight = world.Find(from, to, Straight());
  const FoundPath best = world.Find(from, to, Straight(1.0));
  dgg::PathCorridor corridor(world.Mesh);
  SurfacePath path = straight.Path;
  EXPECT_FALSE(corridor.Shorten(1.0, path));
  EXPECT_TRUE(corridor.IsStopped());
  EXPECT_TRUE(best.IsStraightened);
  EXPECT_EQ(best.Path.Length, straight.Path.Length);
  EXPECT_EQ(best.Path.Faces, straight.Path.Faces);
  EXPECT_LE(best.Path.Length, best.GraphLength);
  ExpectLocallyShortest(world.Mesh, best.Path);
}

TEST(PathFinder, SamePoint)
{
  const PathWorld world(Icosphere(2));
  for (const SurfacePoint& point : SomePoints(world.Mesh, 5, 5, 1))
  {
    for (const PathOptions& options : { Raw(), Straight(1e-3) })
    {
      const FoundPath found = world.Find(point, point, options);
      EXPECT_EQ(found.Path.Points.size(), 1u);
      EXPECT_TRUE(found.Path.Faces.empty());
      EXPECT_EQ(found.Path.Length, 0.0);
      EXPECT_EQ(found.GraphLength, 0.0);
    }
  }
}

}
