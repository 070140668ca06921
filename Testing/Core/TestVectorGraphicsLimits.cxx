// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Vector graphics: finer faces, any curves, what is refused, when it stops.
#include "GraphicsTestTools.h"
#include "TestMeshes.h"

#include "dggGraphicsFragments.h"

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
        const auto left = RandomValues(2 * points.size(), k + 20);
        const auto right = RandomValues(2 * points.size(), k + 30);
        const GraphicsCurveType type = isDiffusion || k == 0 ? Diffusion
          : k == 3                                           ? Source
                                                             : Poisson;
        drawing.Add(type, points, left, right, isClosed).Width =
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
    EXPECT_TRUE(Says(status, word));
  };
  const auto across = [](Drawing& drawing) {
    return std::vector<SurfacePoint>{ drawing.Find(1.5, 0.5), drawing.Find(1.5, 3.5) };
  };
  {
    Drawing drawing(Plane(4, 4));
    drawing.AddLine(Diffusion, { 1, 1 }, { 1, 1 }, 1, 1);
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
  drawing.AddLine(Poisson, { 2.5, 2.5 }, { 7.5, 7.5 }, 1, 0).Width = 3.0;
  drawing.Regions = { { { 3, 4 }, { 1.0 } }, { { 30 }, { 1.0 } } };
  ProgressListener preparing;
  drawing.Options.Progress = std::ref(preparing);
  ASSERT_TRUE(drawing.Prepare().IsOk());
  EXPECT_GT(preparing.Calls, 3);
  ProgressListener solving;
  drawing.Options.Progress = std::ref(solving);
  ASSERT_TRUE(drawing.Solve().IsOk());
  EXPECT_GE(solving.Calls, 2);
  for (int stop = 0; stop < preparing.Calls + solving.Calls; ++stop)
  {
    int calls = 0;
    drawing.Options.Progress = [&](double) { return calls++ < stop; };
    const dgg::Status status = drawing.Prepare();
    EXPECT_TRUE((status.IsOk() ? drawing.Solve() : status).IsAborted()) << stop;
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

// Fragments of coloured surfaces: where they are, their colours, in which faces.

TEST(VectorGraphics, FragmentsAreTheMiddlesOfEqualParts)
{
  // A function that is linear on each side of a curve: fragments have its values at their places,
  // which spread evenly, and on their own side.
  for (const int division : { 1, 2, 3, 5 })
  {
    Drawing drawing(Plane(5, 4, 0.3));
    drawing.Options.NumberOfChannels = 2;
    drawing.Add(Diffusion, { drawing.Find(0.0, 0.0), drawing.Find(0.0, 4.0) }, { 0, 9, 0, 9 },
      { 1, 3, 1, 3 });
    drawing.Add(Diffusion, { drawing.Find(2.6, 0.0), drawing.Find(2.6, 4.0) }, { 2, 0, 2, 0 },
      { 7, 8, 7, 8 });
    drawing.Run(1);
    const dgg::CutSurface& surface = drawing.Graphics.GetSurface();
    std::vector<Id> faces;
    for (Id f = 0; f < surface.GetNumberOfFaces(); f += 2)
    {
      faces.push_back(f);
    }
    const dgg::GraphicsFragments fragments =
      dgg::MakeFragments(drawing.Mesh, surface, faces, drawing.Result.Values, 2, division);
    const auto each = static_cast<std::size_t>(division * division);
    ASSERT_EQ(fragments.Places.size(), each * faces.size());
    ASSERT_EQ(fragments.Faces.size(), each * faces.size());
    ASSERT_EQ(fragments.Values.size(), 2 * each * faces.size());
    for (std::size_t i = 0; i < fragments.Places.size(); ++i)
    {
      const Position p =
        dgg::PositionOf(drawing.Mesh, fragments.Places[i], drawing.Input.Points.data());
      EXPECT_EQ(fragments.Faces[i], fragments.Places[i].Face);
      EXPECT_EQ(fragments.Faces[i], surface.Faces[faces[i / each]]);
      const double t = p[0] / 2.6;
      EXPECT_NEAR(fragments.Values[2 * i], t < 1.0 ? 1.0 + t : 7.0, 1e-9);
      EXPECT_NEAR(fragments.Values[2 * i + 1], t < 1.0 ? 3.0 - 3.0 * t : 8.0, 1e-9);
    }
    // Their first and second moments in a triangle: those of the parts about their own middles are
    // all that is missing, 1/division^2 of those of the triangle.
    for (std::size_t f = 0; f < faces.size(); ++f)
    {
      Position corners[3];
      double middle = 0.0;
      for (int k = 0; k < 3; ++k)
      {
        corners[k] = drawing.Place(surface.Triangles[3 * faces[f] + k]);
        middle += corners[k][0] / 3.0;
      }
      double first = 0.0;
      double second = 0.0;
      double whole = 0.0;
      for (std::size_t i = each * f; i < each * (f + 1); ++i)
      {
        const double x =
          dgg::PositionOf(drawing.Mesh, fragments.Places[i], drawing.Input.Points.data())[0];
        first += (x - middle) / each;
        second += (x - middle) * (x - middle) / each;
      }
      for (const Position& corner : corners)
      {
        whole += (corner[0] - middle) * (corner[0] - middle) / 12.0;
      }
      EXPECT_NEAR(first, 0.0, 1e-12);
      EXPECT_NEAR(second, whole * (1.0 - 1.0 / each), 1e-12);
    }
  }
}

TEST(VectorGraphics, RefinementReportsThePartsOfWhatWasChosen)
{
  Drawing drawing(Plane(9, 8, 0.2));
  drawing.AddLine(Diffusion, { 2.2, 3.1 }, { 5.4, 3.7 }, 0, 0);
  const RefinedSurface coarse = Embed(drawing.Mesh, drawing.Lines);
  std::vector<char> isPassed(coarse.Points.size(), 0);
  for (const Id v : coarse.Paths[0])
  {
    isPassed[v] = 1;
  }
  std::size_t touched = 0;
  for (Id f = 0; f < coarse.GetNumberOfFaces(); ++f)
  {
    const Id* corners = coarse.Triangles.data() + 3 * f;
    touched += isPassed[corners[0]] || isPassed[corners[1]] || isPassed[corners[2]] ? 1 : 0;
  }
  const Id chosen = 2 * 9 * 6 + 3; // far from the curve, which leaves it whole
  for (const int levels : { 0, 1, 2 })
  {
    const std::size_t parts = std::size_t(1) << (2 * levels);
    dgg::GraphicsRefinement refinement;
    refinement.Levels = levels;
    std::vector<Id> found = { 77 };
    RefinedSurface surface = coarse;
    ASSERT_TRUE(dgg::RefineForGraphics(drawing.Mesh, refinement, surface, &found).IsOk());
    EXPECT_EQ(found.size(), surface.Faces.size()); // everything
    EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));

    surface = coarse;
    refinement.Part = dgg::RefinedPart::Faces;
    refinement.Faces = { chosen };
    ASSERT_TRUE(dgg::RefineForGraphics(drawing.Mesh, refinement, surface, &found).IsOk());
    EXPECT_EQ(found.size(), parts);
    for (const Id f : found)
    {
      EXPECT_EQ(surface.Faces[f], chosen);
    }

    surface = coarse;
    refinement.Part = dgg::RefinedPart::AroundCurves;
    ASSERT_TRUE(dgg::RefineForGraphics(drawing.Mesh, refinement, surface, &found).IsOk());
    EXPECT_EQ(found.size(), parts * touched);
    EXPECT_LT(found.size(), surface.Faces.size());
  }
}
}
