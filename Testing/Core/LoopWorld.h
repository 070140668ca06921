// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Shared setup for tests of loops.
#ifndef LoopWorld_h
#define LoopWorld_h

#include "TestMeshes.h"

#include "dggHandleLoops.h"
#include "dggLoopFinder.h"

namespace dggtest
{
/// Triangulation of the ends of a prism.
enum class Cap
{
  Fan, ///< fan around one of the corners
  Strip,
  Spokes ///< triangles around a central point
};

constexpr double PrismHeight = 6.0;

/// Returns a closed prism of height 6 over a regular polygon of radius 1. The diagonals of the wall
/// are chosen at random.
inline TestMesh CappedPrism(Id sides, Id rows, Cap cap, std::uint64_t seed)
{
  TestMesh mesh;
  Random random(seed);
  for (Id j = 0; j <= rows; ++j)
  {
    for (Id i = 0; i < sides; ++i)
    {
      const double angle = 2.0 * dgg::Pi * i / sides;
      mesh.AddPoint(std::cos(angle), std::sin(angle), PrismHeight * j / rows);
    }
  }
  for (Id j = 0; j < rows; ++j)
  {
    for (Id i = 0; i < sides; ++i)
    {
      const Id a = j * sides + i;
      const Id b = j * sides + (i + 1) % sides;
      if (random.Uniform() < 0.5)
      {
        mesh.AddQuad(a, b, b + sides, a + sides);
      }
      else
      {
        mesh.AddQuad(b, b + sides, a + sides, a);
      }
    }
  }
  for (const Id first : { Id(0), rows * sides })
  {
    if (cap == Cap::Spokes)
    {
      const Id middle = mesh.AddPoint(0.0, 0.0, first > 0 ? PrismHeight : 0.0);
      for (Id i = 0; i < sides; ++i)
      {
        mesh.AddTriangle(middle, first + i, first + (i + 1) % sides);
      }
    }
    for (Id i = 1; i + 1 < sides && cap == Cap::Fan; ++i)
    {
      mesh.AddTriangle(first, first + i, first + i + 1);
    }
    Id low = first;
    Id high = first + sides - 1;
    for (bool isLow = true; low + 1 < high && cap == Cap::Strip; isLow = !isLow)
    {
      const Id next = isLow ? low + 1 : high - 1;
      mesh.AddTriangle(low, next, high);
      (isLow ? low : high) = next;
    }
  }
  return mesh;
}

/// A mesh, its graph, and loops on the mesh.
class LoopWorld
{
public:
  explicit LoopWorld(const TestMesh& mesh, double accuracy = 0.02)
    : Mesh(Build(mesh))
    , Builder(Mesh)
  {
    dgg::GraphOptions options;
    options.Accuracy = accuracy;
    EXPECT_TRUE(Ok(this->Builder.Build(options, this->Graph)));
    this->Search = std::make_unique<dgg::GraphSearch>(this->Graph.View(), &this->Mesh);
    this->Finder =
      std::make_unique<dgg::LoopFinder>(this->Mesh, *this->Search, &this->Builder, nullptr);
  }

  dgg::FoundLoop ThroughPoint(const dgg::SurfacePoint& point, bool taut = false) const
  {
    dgg::FoundLoop loop;
    this->Expect(this->Finder->ThroughPoint(point, taut, loop), loop);
    return loop;
  }

  dgg::FoundLoop Rope(const std::vector<dgg::SurfacePoint>& points, bool taut) const
  {
    dgg::FoundLoop loop;
    bool isConnected = true;
    this->Expect(this->Finder->Rope(points, taut, loop, isConnected), loop);
    return loop;
  }

  std::vector<dgg::FoundLoop> AroundHandles() const
  {
    std::vector<dgg::FoundLoop> loops;
    const dgg::Status status = dgg::FindHandleLoops(this->Mesh, {}, loops);
    EXPECT_TRUE(status.IsOk()) << status.GetMessage();
    for (const dgg::FoundLoop& loop : loops)
    {
      this->Expect(status, loop);
    }
    return loops;
  }

  dgg::SurfaceMesh Mesh;
  dgg::GraphBuilder Builder;
  dgg::GeodesicGraph Graph;
  std::unique_ptr<dgg::GraphSearch> Search;
  std::unique_ptr<dgg::LoopFinder> Finder;

private:
  /// Expects a loop to be empty or a valid closed path on the surface.
  void Expect(const dgg::Status& status, const dgg::FoundLoop& loop) const
  {
    ASSERT_TRUE(status.IsOk()) << status.GetMessage();
    EXPECT_TRUE(Ok(dgg::CheckPath(this->Mesh, loop.Loop)));
    if (!loop.Loop.IsEmpty())
    {
      const dgg::SurfacePoint& first = loop.Loop.Points.front();
      const dgg::SurfacePoint& last = loop.Loop.Points.back();
      EXPECT_EQ(first.On, last.On);
      EXPECT_EQ(first.Vertex, last.Vertex);
      EXPECT_GT(loop.Loop.Length, 0.0);
      EXPECT_LE(loop.Angle, dgg::Pi);
    }
  }
};
}

#endif
