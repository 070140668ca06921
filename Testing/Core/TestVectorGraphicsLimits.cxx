// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Vector graphics: finer faces, any curves, what is refused, when it stops.
#include "GraphicsTestTools.h"
#include "TestMeshes.h"

#include "dggGraphicsFragments.h"

#include <algorithm>
#include <cmath>

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

}
