// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Vector graphics: finer faces, any curves, what is refused, when it stops.
#include "CurvedMeshes.h"
#include "FlatMeshes.h"
#include "GraphicsTestTools.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace dggtest
{
TEST(VectorGraphics, AnyCurvesOnAnySurface)
{
  // Curves that run along edges and boundaries, cross each other and themselves, come back. With
  // diffusion curves alone, no colour lies outside of those that are given.
  for (const NamedMesh& named : SoundMeshes())
  {
    Id count = 0;
    Build(named.Mesh).ComputeComponents(count);
    if (named.Mesh.Points.empty() || count > 1)
    {
      continue;
    }
    for (const bool isDiffusion : { true, false })
    {
      SCOPED_TRACE(named.Name);
      Random random(isDiffusion ? 17 : 18);
      Drawing drawing(named.Mesh);
      drawing.Options.IntrinsicDelaunay = true;
      drawing.Options.NumberOfChannels = 2;
      for (int k = 0; k < 4; ++k)
      {
        const bool isClosed = k % 2 == 1;
        const std::vector<SurfacePoint> points = RandomCurvePoints(drawing.Mesh, 6, random);
        std::vector<double> colors[2];
        for (std::size_t i = 0; i < 2 * points.size(); ++i)
        {
          colors[0].push_back(random.Uniform(-1.0, 1.0));
          colors[1].push_back(random.Uniform(-1.0, 1.0));
        }
        const GraphicsCurveType type = isDiffusion || k == 0 ? Diffusion
          : k == 3                                           ? Source
                                                             : Poisson;
        drawing.Add(type, points, colors[0], colors[1], isClosed).Width =
          2.0 * drawing.Mesh.GetMeanEdgeLength();
      }
      drawing.Run(random.Index(2));
      ASSERT_FALSE(HasFatalFailure());
      for (const double value : drawing.Result.Values)
      {
        ASSERT_TRUE(std::isfinite(value));
        ASSERT_TRUE(!isDiffusion || std::abs(value) <= 1.0 + 1e-9) << value;
      }
    }
  }
}

TEST(VectorGraphics, FacesAroundCurvesAreRefined)
{
  const TestMesh plane = Plane(30, 30, 0.2);
  const SurfaceMesh mesh = Build(plane);
  const SurfacePoint a = PointIn(mesh, 30 * 60 / 2 + 20, { { 0.3, 0.3, 0.4 } });
  const SurfacePoint b = PointIn(mesh, 30 * 60 / 2 + 25, { { 0.3, 0.3, 0.4 } });
  const RefinedSurface before = Embed(mesh, { Curve(mesh, { a, b }) });
  dgg::GraphicsRefinement refinement;
  refinement.Levels = 2;
  refinement.Part = dgg::RefinedPart::AroundCurves;
  RefinedSurface surface = before;
  ASSERT_TRUE(dgg::RefineForGraphics(mesh, refinement, surface).IsOk());
  EXPECT_EQ(surface.Paths[0].size(), 4 * before.Paths[0].size() - 3);
  // Some faces are as they were.
  EXPECT_GT(std::count_if(surface.Lengths.begin(), surface.Lengths.end(),
              [](double length) { return length > 0.6; }),
    1000);
  refinement.MostFaces = before.GetNumberOfFaces() + 10;
  EXPECT_FALSE(dgg::RefineForGraphics(mesh, refinement, surface).IsOk());
  refinement.MostFaces = dgg::GraphicsRefinement().MostFaces;
  surface = before;
  refinement.Part = dgg::RefinedPart::Faces;
  refinement.Faces = { 3, 900, 3, 1799 }; // far from the curve
  refinement.Levels = 1;
  ASSERT_TRUE(dgg::RefineForGraphics(mesh, refinement, surface).IsOk());
  EXPECT_EQ(std::count(surface.Faces.begin(), surface.Faces.end(), 3), 4);
  EXPECT_EQ(std::count(surface.Faces.begin(), surface.Faces.end(), 1799), 4);
  EXPECT_EQ(std::count(surface.Faces.begin(), surface.Faces.end(), 600), 1);
  EXPECT_EQ(surface.Paths[0].size(), before.Paths[0].size());
  surface = before;
  refinement.Progress = [](double) { return false; };
  EXPECT_TRUE(dgg::RefineForGraphics(mesh, refinement, surface).IsAborted());
}

TEST(VectorGraphics, RefusesWhatItCannotDraw)
{
  const auto fails = [](Drawing& drawing, const std::string& word) {
    const dgg::Status status = drawing.Prepare();
    EXPECT_FALSE(status.IsOk()) << word;
    EXPECT_NE(status.GetMessage().find(word), std::string::npos) << status.GetMessage();
  };
  const auto across = [](Drawing& drawing) {
    return std::vector<SurfacePoint>{ drawing.Find(1.5, 0.5), drawing.Find(1.5, 3.5) };
  };
  {
    Drawing drawing(Plane(4, 4));
    drawing.Add(Diffusion, { drawing.Find(1, 1), drawing.Find(1, 1) }, { 1, 1 }, { 1, 1 });
    fails(drawing, "no length");
  }
  {
    Drawing drawing(Plane(4, 4));
    drawing.Add(Region, across(drawing), { 1, 1 }, {});
    fails(drawing, "open");
  }
  {
    // Around a torus: the left is the right.
    Drawing drawing(Torus(12, 8));
    drawing.Add(Region,
      { SurfacePoint::AtVertex(0), SurfacePoint::AtVertex(32), SurfacePoint::AtVertex(64) },
      { 1, 1, 1 }, {}, true);
    fails(drawing, "does not separate");
  }
  {
    // Faces that name a point twice are left out, also as the last ones.
    TestMesh plane = Plane(4, 4);
    plane.AddTriangle(3, 3, 4);
    Drawing drawing(plane);
    drawing.Regions = { { { 3, 32 }, { 1.0 } } };
    drawing.Run();
  }
  {
    // A curve over an edge of three faces has no sides.
    TestMesh book = Plane(4, 4);
    const Id top = book.AddPoint(1.5, 1.5, 3.0);
    book.AddTriangle(6, 7, top); // on the edge from (1, 1) to (2, 1)
    Drawing drawing(book);
    drawing.Add(Diffusion, across(drawing), { 1, 1 }, { 1, 1 });
    fails(drawing, "more than two faces");
  }
  {
    // Prepared for other curves.
    Drawing drawing(Plane(4, 4));
    drawing.Add(Diffusion, across(drawing), { 1, 1 }, { 1, 1 });
    ASSERT_TRUE(drawing.Prepare().IsOk());
    drawing.Curves.clear();
    EXPECT_FALSE(drawing.Solve().IsOk());
  }
  dgg::VectorGraphics graphics;
  dgg::GraphicsResult result;
  EXPECT_FALSE(graphics.Run({}, {}, {}, result).IsOk());
}

TEST(VectorGraphics, StopsWhenAskedTo)
{
  Drawing drawing(Plane(10, 10));
  drawing.Add(Poisson, { drawing.Find(2.5, 2.5), drawing.Find(7.5, 7.5) }, { 1, 1 }, { 0, 0 })
    .Width = 3.0;
  drawing.Regions = { { { 3, 4 }, { 1.0 } }, { { 30 }, { 1.0 } } };
  int calls = 0;
  drawing.Options.Progress = [&](double) {
    ++calls;
    return true;
  };
  ASSERT_TRUE(drawing.Prepare().IsOk());
  const int whilePreparing = calls;
  ASSERT_TRUE(drawing.Solve().IsOk());
  const int all = calls;
  EXPECT_GT(whilePreparing, 3);
  EXPECT_GE(all, whilePreparing + 2);
  for (int stop = 0; stop < all; ++stop)
  {
    calls = 0;
    double last = 0.0;
    drawing.Options.Progress = [&](double done) {
      last = done;
      return calls++ < stop;
    };
    dgg::Status status = drawing.Prepare();
    status = status.IsOk() ? drawing.Solve() : status;
    EXPECT_TRUE(status.IsAborted()) << stop;
    EXPECT_LE(last, 1.0);
  }
}

TEST(VectorGraphics, MemoryIsAskedForBeforeItIsTaken)
{
  for (const bool hasPoisson : { false, true })
  {
    Drawing drawing(Icosphere(4));
    const std::vector<double> two = { 0.0, 1.0 };
    drawing
      .Add(hasPoisson ? Poisson : Diffusion,
        { SurfacePoint::AtVertex(3), SurfacePoint::AtVertex(40) }, two, two)
      .Width = 0.5;
    std::vector<double> asked;
    std::size_t allowed = 0;
    drawing.Options.CheckMemory = [&](double bytes, double missing) {
      EXPECT_LT(missing, bytes);
      asked.push_back(missing);
      return asked.size() <= allowed ? dgg::Status::Success() : dgg::Status::Invalid("too much");
    };
    // Before it is factorized.
    EXPECT_EQ(drawing.Prepare().GetMessage(), "too much");
    EXPECT_EQ(asked.size(), 1u);
    EXPECT_FALSE(drawing.Solve().IsOk());
    // When colours are found, for which the factor is there.
    asked.clear();
    allowed = 1;
    ASSERT_TRUE(drawing.Prepare().IsOk());
    EXPECT_EQ(drawing.Solve().GetMessage(), "too much");
    ASSERT_EQ(asked.size(), 2u);
    EXPECT_LT(asked[1], asked[0]);
    allowed = 100;
    ASSERT_TRUE(drawing.Solve().IsOk());
  }
}
}
