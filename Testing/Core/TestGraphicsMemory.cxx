// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Vector graphics take no more memory than is asked for, at any time.
#include "../Benchmark/MemoryProbe.h"
#include "CurvedMeshes.h"
#include "FlatMeshes.h"
#include "GraphicsTestTools.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <string>
#include <vector>

namespace dggtest
{
namespace
{
double PredictFor(const RefinedSurface& surface, bool hasPoisson)
{
  return dgg::VectorGraphics::PredictMemory(
    surface.GetNumberOfFaces(), surface.GetNumberOfVertices(), hasPoisson);
}
}

TEST(GraphicsMemory, RefiningTakesLessThanIsAskedFor)
{
  // Also of what is refined in a part, and not at all.
  const std::vector<NamedMesh> meshes = { { "sphere", NoisySphere(4, 0.03, 3) },
    { "plane", Plane(60, 60, 0.3) } };
  for (const NamedMesh& named : meshes)
  {
    const SurfaceMesh mesh = Build(named.Mesh);
    Random random(7);
    const std::vector<SurfaceCurve> curves = { dggtest::Curve(
      mesh, RandomCurvePoints(mesh, 6, random)) };
    for (const int levels : { 0, 1, 2, 3 })
    {
      for (const bool isNearCurves : { false, true })
      {
        const MemoryProbe probe;
        RefinedSurface surface;
        ASSERT_TRUE(dgg::EmbedCurves(mesh, curves, nullptr, surface).IsOk());
        dgg::GraphicsRefinement refinement;
        refinement.Levels = levels;
        refinement.Part =
          isNearCurves ? dgg::RefinedPart::AroundCurves : dgg::RefinedPart::Everything;
        std::vector<Id> parts;
        ASSERT_TRUE(dgg::RefineForGraphics(mesh, refinement, surface, &parts).IsOk());
        const double predicted = PredictFor(surface, false);
        const auto peak = static_cast<double>(probe.GetHeapPeak());
        EXPECT_LE(peak, 0.6 * predicted) << named.Name << " " << levels; // no near miss
      }
    }
  }
}

TEST(GraphicsMemory, IsAskedForBeforeItIsTaken)
{
  // What has been asked for is never exceeded: while the surface is refined and cut, while the
  // equation is prepared, and while colours are found. Many regions that have nearly everything on
  // their left, too.
  const TestMesh sphere = Icosphere(4);
  for (const bool hasPoisson : { false, true })
  {
    for (const int regions : { 0, 100 })
    {
      Drawing drawing(sphere);
      const std::vector<double> two = { 0.0, 1.0 };
      drawing
        .Add(hasPoisson ? Poisson : Diffusion,
          { SurfacePoint::AtVertex(3), SurfacePoint::AtVertex(40) }, two, two)
        .Width = 0.5;
      for (int k = 0; k < regions; ++k)
      {
        const std::array<Id, 3> corners = drawing.Mesh.GetTriangle(50 + 31 * k);
        drawing.Add(Region,
          { SurfacePoint::AtVertex(corners[0]), SurfacePoint::AtVertex(corners[2]),
            SurfacePoint::AtVertex(corners[1]) },
          { 0.1, 0.0, 0.0 }, {}, true);
      }
      drawing.Regions = { { { 1, 2, 3 }, { 0.5 } } };
      drawing.Options.IntrinsicDelaunay = hasPoisson;
      double asked = dgg::VectorGraphics::PredictMemory(
        4.0 * drawing.Mesh.GetNumberOfFaces(), 2.0 * drawing.Mesh.GetNumberOfFaces(), hasPoisson);
      const MemoryProbe probe;
      const auto expectEnough = [&](const char* when) {
        EXPECT_LE(static_cast<double>(probe.GetHeapPeak()), asked)
          << when << " " << hasPoisson << " " << regions;
      };
      int count = 0;
      drawing.Options.CheckMemory = [&](double bytes, double) {
        expectEnough("meanwhile");
        asked = std::max(asked, bytes);
        ++count;
        return dgg::Status::Success();
      };
      ASSERT_TRUE(drawing.Prepare(1).IsOk());
      expectEnough("prepared");
      EXPECT_GE(count, 2);
      drawing.Surface = RefinedSurface(); // it is not needed any more
      ASSERT_TRUE(drawing.Solve().IsOk());
      expectEnough("solved");
      EXPECT_GE(count, 3);
      EXPECT_LE(asked, 1.5 * static_cast<double>(probe.GetHeapPeak())); // nor far too much
    }
  }
}

TEST(GraphicsMemory, WhatIsHeldIsTold)
{
  // Whoever subtracts what is held from what is asked for knows what will be taken from what is
  // free: enough in any case, while it is factorized and whenever colours are found.
  for (const bool hasPoisson : { false, true })
  {
    Drawing drawing(Icosphere(5));
    const std::vector<double> two = { 0.0, 1.0 };
    drawing
      .Add(hasPoisson ? Poisson : Diffusion,
        { SurfacePoint::AtVertex(3), SurfacePoint::AtVertex(40) }, two, two)
      .Width = 0.5;
    const MemoryProbe probe;
    double surface = 0.0;
    int count = 0;
    drawing.Options.CheckMemory = [&](double bytes, double held) {
      SCOPED_TRACE(std::to_string(hasPoisson) + " " + std::to_string(count));
      auto there = static_cast<double>(probe.GetHeapGrowth());
      surface = count == 0 ? there : surface;
      there -= count == 1 ? surface : 0.0; // it is not asked for again
      EXPECT_LE(held, 1.02 * there);
      EXPECT_GE(held, 0.92 * there);
      EXPECT_LE(held, bytes);
      ++count;
      return dgg::Status::Success();
    };
    ASSERT_TRUE(drawing.Prepare().IsOk());
    drawing.Surface = RefinedSurface();
    EXPECT_EQ(count, 2);
    ASSERT_TRUE(drawing.Solve().IsOk());
    EXPECT_EQ(count, hasPoisson ? 5 : 3);
  }
}

TEST(GraphicsMemory, OfSetsOfFaces)
{
  // All but a face, and then half as many: one patch that is as large as can be. A tree of faces,
  // each with one neighbour at first: a rim that is as long as can be. Together, small ones first.
  const TestMesh sphere = Icosphere(5);
  for (const int level : { 0, 1 })
  {
    Drawing drawing(sphere);
    const Id faces = drawing.Mesh.GetNumberOfFaces();
    std::vector<Id> all(faces - 1);
    std::iota(all.begin(), all.end(), 1);
    const std::vector<Id> half(all.begin(), all.begin() + faces / 2);
    std::vector<Id> tree = { 7 };
    std::vector<char> isInTree(faces, 0);
    isInTree[7] = 1;
    for (std::size_t i = 0; i < tree.size(); ++i)
    {
      for (Id h = 3 * tree[i]; h < 3 * tree[i] + 3; ++h)
      {
        const Id f = SurfaceMesh::Face(drawing.Mesh.Twin(h));
        int neighbours = 0;
        for (Id e = 3 * f; e < 3 * f + 3; ++e)
        {
          neighbours += isInTree[SurfaceMesh::Face(drawing.Mesh.Twin(e))];
        }
        if (!isInTree[f] && neighbours == 1)
        {
          isInTree[f] = 1;
          tree.push_back(f);
        }
      }
    }
    EXPECT_GT(static_cast<double>(tree.size()), 0.5 * faces);
    const std::vector<std::vector<GraphicsRegion>> drawings = { { { all, { 0.5 } } },
      { { tree, { 0.5 } } }, { { half, { 0.5 } }, { tree, { 0.25 } }, { all, { 0.5 } } } };
    ASSERT_TRUE(drawing.Prepare(level).IsOk());
    for (const std::vector<GraphicsRegion>& regions : drawings)
    {
      SCOPED_TRACE(std::to_string(level) + " " + std::to_string(&regions - drawings.data()));
      drawing.Regions = regions;
      drawing.Result = dgg::GraphicsResult();
      double missing = 0.0;
      drawing.Options.CheckMemory = [&](double bytes, double held) {
        missing = bytes - held;
        return dgg::Status::Success();
      };
      const MemoryProbe probe;
      ASSERT_TRUE(drawing.Solve().IsOk());
      const auto peak = static_cast<double>(probe.GetHeapPeak());
      EXPECT_LE(peak, missing);
      EXPECT_LE(missing, 1.5 * peak); // nor far too much
    }
  }
}

TEST(GraphicsMemory, OfCurvesThroughAllVertices)
{
  // So that all edges are looked up: that takes much less than what is asked for at first, the rest
  // of which the equation needs. Several of them have sources on the same edges.
  for (const std::size_t count : { 1, 8 })
  {
    SCOPED_TRACE(count);
    Drawing drawing(Icosphere(4));
    std::vector<SurfacePoint> points;
    for (Id v = 0; v < drawing.Mesh.GetNumberOfVertices(); ++v)
    {
      points.push_back(SurfacePoint::AtVertex(v));
    }
    drawing.Add(Source, points, std::vector<double>(points.size(), 0.5), {});
    drawing.Surface = Embed(drawing.Mesh, drawing.Lines);
    const dgg::CurveChain chain = dgg::FollowCurve(drawing.Surface, drawing.Lines, 0);
    const std::vector<dgg::CurveChain> chains(count, chain);
    drawing.Curves.resize(count, drawing.Curves[0]);
    double asked = 0.0;
    drawing.Options.CheckMemory = [&](double bytes, double held) {
      asked = asked == 0.0 ? bytes - held : asked;
      return dgg::Status::Success();
    };
    const MemoryProbe probe;
    double peak = 0.0; // before the equation is analyzed
    drawing.Options.Progress = [&](double done) {
      peak = done < 0.4 ? static_cast<double>(probe.GetHeapPeak()) : peak;
      return true;
    };
    ASSERT_TRUE(drawing.Graphics
                  .Prepare(drawing.Mesh, drawing.Surface, chains, drawing.Curves, drawing.Options)
                  .IsOk());
    EXPECT_LE(peak, count == 1 ? 0.475 * asked : asked);
    EXPECT_LE(static_cast<double>(probe.GetHeapPeak()), asked);
  }
}
}
