// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What the tests of loops start from.
#ifndef LoopWorld_h
#define LoopWorld_h

#include "TestMeshes.h"

#include "dggHandleLoops.h"
#include "dggLoopFinder.h"

#include <memory>
#include <vector>

namespace dggtest
{
/// A mesh, its graph, and loops on it.
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
    this->Expect(this->Finder->Rope(points, taut, loop), loop);
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
  /// A closed path on the surface.
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
