// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Vector graphics: closed forms, locality, convergence orders, arbitrary curves, fragments.
#include "GraphicsTestTools.h"
#include "TestMeshes.h"

#include "dggExactGeodesics.h"
#include "dggGraphicsFragments.h"
#include "dggPoissonSolver.h"
#include "dggPoissonSystem.h"

namespace dggtest
{
TEST(VectorGraphics, CurvesAcrossASquareHaveALinearFunctionOnEachSide)
{
  // Curves across the whole square at x = 1, 2.35 and 5, directed upward: smaller x is on their
  // left. Between two curves colors are linear in x; beyond the outer curves they are constant.
  for (const bool delaunay : { false, true })
  {
    Drawing drawing(Plane(6, 5, 0.25));
    drawing.Options.IntrinsicDelaunay = delaunay;
    const double xs[] = { 1.0, 2.35, 5.0 };
    const double lefts[] = { 0.1, 0.9, 0.3 };
    const double rights[] = { 0.7, -0.4, 2.0 };
    for (int k = 0; k < 3; ++k)
    {
      drawing.AddLine(Diffusion, { xs[k], 0.0 }, { xs[k], 5.0 }, lefts[k], rights[k]);
    }
    drawing.Run();
    Id corners = 0;
    drawing.ForEachCorner([&](Id v, const Position& p, const Position& middle) {
      const double x = middle[0];
      double expected = x < xs[0] ? lefts[0] : rights[2];
      for (int k = 0; k < 2; ++k)
      {
        const double t = (p[0] - xs[k]) / (xs[k + 1] - xs[k]);
        expected = x > xs[k] && x < xs[k + 1] ? (1.0 - t) * rights[k] + t * lefts[k + 1] : expected;
      }
      EXPECT_NEAR(drawing.Value(v), expected, 1e-10) << p[0] << ", " << p[1];
      ++corners;
    });
    EXPECT_GT(corners, 180);
  }
}

TEST(VectorGraphics, ColorsAreLinearAlongCurves)
{
  // A curve around a square with colors linear in x and y at its corners: the solution is linear
  // inside. The curve is closed and has its interior on the left.
  Drawing drawing(Plane(7, 7, 0.25));
  const double corners[4][2] = { { 1.0, 1.5 }, { 6.0, 1.5 }, { 6.0, 5.0 }, { 1.0, 5.0 } };
  const auto linear = [](double x, double y) { return 2.0 + 0.5 * x - 0.25 * y; };
  std::vector<SurfacePoint> points;
  std::vector<double> left;
  for (const auto& c : corners)
  {
    points.push_back(drawing.Find(c[0], c[1]));
    left.push_back(linear(c[0], c[1]));
  }
  drawing.Add(Diffusion, points, left, { 8.0, 8.0, 8.0, 8.0 }, true);
  drawing.Run();
  Id inside = 0;
  drawing.ForEachCorner([&](Id v, const Position& p, const Position& m) {
    const bool isInside = m[0] > 1.0 && m[0] < 6.0 && m[1] > 1.5 && m[1] < 5.0;
    inside += isInside ? 1 : 0;
    EXPECT_NEAR(drawing.Value(v), isInside ? linear(p[0], p[1]) : 8.0, 1e-9);
  });
  EXPECT_GT(inside, 90);
}

TEST(VectorGraphics, PoissonCurveFadesAsItSays)
{
  // A curve along x = 3.3 from side to side, directed upward: B is known.
  Drawing drawing(Plane(7, 5, 0.2));
  drawing.Options.NumberOfChannels = 2;
  const std::vector<double> left = { 0.3, 1.0, 0.3, 1.0 };
  const std::vector<double> right = { -0.3, 0.25, -0.3, 0.25 };
  drawing.Add(Poisson, { drawing.Find(3.3, 0.0), drawing.Find(3.3, 5.0) }, left, right).Width = 2.0;
  drawing.Options.Background = { 0.5, 0.125 };
  drawing.Run(1);
  Id copies = 0;
  drawing.ForEachCorner([&](Id v, const Position& p, const Position& m) {
    const double t = std::abs(p[0] - 3.3) / 2.0;
    const double fade = t < 1.0 ? (1.0 - t * t) * (1.0 - t * t) : 0.0;
    const int side = m[0] < 3.3 ? 0 : 2;
    for (int c = 0; c < 2; ++c)
    {
      const double expected =
        drawing.Options.Background[c] + fade * (side == 0 ? left[c] : right[c]);
      EXPECT_NEAR(drawing.Value(v, c), expected, 2e-3) << p[0] << ", " << p[1];
    }
    copies += t < 1e-12 ? 1 : 0;
  });
  EXPECT_GT(copies, 20);
}

TEST(VectorGraphics, FarColorsStayWhereAPoissonCurveIsAdded)
{
  // A sphere with a diffusion curve and a region, and between them a Poisson curve that bends and
  // ends in the interior. Beyond the width of the Poisson curve nothing changes, up to rounding.
  Drawing before(Icosphere(3));
  const auto near = [&](double x, double y, double z) {
    Id best = 0;
    for (Id v = 0; v < before.Mesh.GetNumberOfVertices(); ++v)
    {
      const double* p = before.Input.Point(v);
      const double* q = before.Input.Point(best);
      best = p[0] * x + p[1] * y + p[2] * z > q[0] * x + q[1] * y + q[2] * z ? v : best;
    }
    return SurfacePoint::AtVertex(best);
  };
  const std::vector<SurfacePoint> far = { near(0, 0, -1), near(1, 0, -1), near(1, 1, -1) };
  const std::vector<SurfacePoint> bent = { near(1, 0.1, 0.5), near(0, 0, 1), near(0, 1, 0.6) };
  const double width = 0.35;
  before.Add(Diffusion, far, { 0.0, 0.5, 1.0 }, { 1.0, 0.75, 0.5 });
  // The same mesh, with a curve of zero strength.
  before.Add(Poisson, bent, { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 0.0 }).Width = width;
  before.Regions.push_back({ { 5, 6, 7, 100 }, { 0.5 } });
  before.Run(1);
  Drawing after(Icosphere(3));
  after.Add(Diffusion, far, { 0.0, 0.5, 1.0 }, { 1.0, 0.75, 0.5 });
  after.Add(Poisson, bent, { 0.6, 0.8, 0.6 }, { -0.6, -0.8, -0.6 }).Width = width;
  after.Regions = before.Regions;
  after.Run(1);
  ASSERT_EQ(before.GetNumberOfValues(), after.GetNumberOfValues());
  // Distances of vertices from the curve.
  SurfaceMesh fine;
  ASSERT_TRUE(after.Surface.Build(after.Mesh, fine).IsOk());
  std::vector<dgg::GeodesicSource> sources;
  for (const Id v : after.Surface.Paths[1])
  {
    sources.push_back({ SurfacePoint::AtVertex(v) });
  }
  dgg::ExactResult distances;
  ASSERT_TRUE(dgg::ExactGeodesics(fine).Run(sources, {}, distances).IsOk());
  double largest = 0.0;
  double largestFar = 0.0;
  for (std::size_t v = 0; v < after.GetNumberOfValues(); ++v)
  {
    const double change = std::abs(after.Value(v) - before.Value(v));
    largest = std::max(largest, change);
    const Id uncut = after.Graphics.GetSurface().VertexOf[v];
    largestFar = std::max(largestFar, distances.Distances[uncut] > width ? change : 0.0);
  }
  EXPECT_NEAR(largest, 0.8, 1e-3);
  EXPECT_LT(largestFar, 1e-12);
}

TEST(VectorGraphics, StrengthsThatChangeAreBlended)
{
  // A closed Poisson curve with strength 1 on one half and 0 on the other, and a width of twice its
  // radius. Near the line that is equidistant from both halves, colors are continuous and within
  // [0, 1].
  const double radius = 4.0;
  double previous = 0.0;
  for (const int level : { 0, 1, 2 })
  {
    Drawing drawing(Translated(Plane(20, 20, 0.2), -10.0, -10.0, 0.0));
    const std::vector<SurfacePoint> circle = drawing.FindEllipse(radius, radius, 64, 0.5);
    std::vector<double> strengths;
    for (int k = 0; k < 64; ++k)
    {
      strengths.push_back(k < 16 || k >= 48 ? 1.0 : 0.0);
    }
    drawing.Add(Poisson, circle, strengths, strengths, true).Width = 2.0 * radius;
    drawing.Run(level);
    ASSERT_FALSE(HasFatalFailure());
    const dgg::SubMesh& surface = drawing.Graphics.GetSurface();
    const double background = [&] { // B is added to the background value
      double far = 0.0;
      for (std::size_t v = 0; v < drawing.GetNumberOfValues(); ++v)
      {
        const Position p = drawing.Place(static_cast<Id>(v));
        far = std::hypot(p[0], p[1]) > 13.5 ? drawing.Value(v) : far;
      }
      return far;
    }();
    const auto radiusOf = [&](
                            Id v) { return std::hypot(drawing.Place(v)[0], drawing.Place(v)[1]); };
    double largest = 0.0; // largest change along an edge, away from the curve
    for (std::size_t h = 0; h < surface.Triangles.size(); ++h)
    {
      const Id a = surface.Triangles[h];
      const Id b = surface.Triangles[SurfaceMesh::Next(static_cast<Id>(h))];
      const double change = std::abs(drawing.Value(a) - drawing.Value(b));
      largest = radiusOf(a) < 0.5 * radius && radiusOf(b) < 0.5 * radius ? std::max(largest, change)
                                                                         : largest;
      EXPECT_GE(drawing.Value(a) - background, -1e-9);
      EXPECT_LE(drawing.Value(a) - background, 1.0 + 1e-9);
    }
    EXPECT_LT(largest, level == 0 ? 0.3 : 0.7 * previous) << level;
    previous = largest;
    // At the curve, values equal the given strengths on both sides.
    int given = 0;
    drawing.ForEachCorner([&](Id v, const Position& p, const Position&) {
      for (int k = 0; k < 64; ++k)
      {
        const Position q = dgg::PositionOf(drawing.Mesh, circle[k], drawing.Input.Points.data());
        if (std::hypot(p[0] - q[0], p[1] - q[1]) < 1e-9)
        {
          EXPECT_NEAR(drawing.Value(v) - background, strengths[k], 1e-9);
          ++given;
        }
      }
    });
    EXPECT_GT(given, 250);
  }
}

TEST(VectorGraphics, GivenColorsHoldInsideOfBands)
{
  // The band of a Poisson curve overlaps a diffusion curve.
  Drawing drawing(Plane(20, 20, 0.2));
  drawing.AddLine(Diffusion, { 4.0, 12.0 }, { 16.0, 12.0 }, 0.2, 0.6);
  drawing.AddLine(Poisson, { 5.0, 10.0 }, { 15.0, 10.0 }, 1.0, -1.0).Width = 5.0;
  drawing.Run();
  Id given = 0;
  drawing.ForEachCorner([&](Id v, const Position& p, const Position& m) {
    if (std::abs(p[1] - 12.0) < 1e-9 && p[0] > 4.01 && p[0] < 15.99)
    {
      EXPECT_NEAR(drawing.Value(v), m[1] > 12.0 ? 0.2 : 0.6, 1e-12);
      ++given;
    }
    if (std::abs(p[1] - 12.0) < 1e-9 && std::abs(std::abs(p[0] - 10.0) - 6.0) < 1e-9)
    {
      EXPECT_NEAR(drawing.Value(v), 0.4, 1e-12); // the end points have the mean of both sides
    }
  });
  EXPECT_GT(given, 60);
}

TEST(VectorGraphics, RoundRegionBrightensItsMiddleAndNothingElse)
{
  // -Laplace u = c in a disk, balanced by a sink on its rim: u = c (R^2 - r^2) / 4 inside, 0
  // outside, so that Strength is the increase at the center.
  double previous = 0.0;
  for (const int level : { 1, 2, 3 })
  {
    Drawing drawing(Translated(Plane(10, 10, 0.2), -5.0, -5.0, 0.0));
    const double radius = 3.0;
    drawing.Add(
      Region, drawing.FindEllipse(radius, radius, 96), std::vector<double>(96, 0.8), {}, true);
    drawing.Run(level);
    ASSERT_EQ(drawing.Result.NetSources.size(), 1u);
    EXPECT_NEAR(drawing.Result.NetSources[0], 0.0, 1e-12);
    double corner = 0.0; // value outside the disk; the solutions differ by a constant
    double worst = 0.0;
    for (const bool isLast : { false, true })
    {
      for (std::size_t v = 0; v < drawing.GetNumberOfValues(); ++v)
      {
        const Position p = drawing.Place(static_cast<Id>(v));
        const double r = std::hypot(p[0], p[1]);
        const double expected = r < radius ? 0.8 * (1.0 - r * r / (radius * radius)) : 0.0;
        corner = r > 7.0 ? drawing.Value(v) : corner;
        worst = isLast ? std::max(worst, std::abs(drawing.Value(v) - corner - expected)) : 0.0;
      }
    }
    if (level > 1)
    {
      EXPECT_LT(worst, 0.4 * previous);
    }
    previous = worst;
  }
  EXPECT_LT(previous, 5e-3);
}

TEST(VectorGraphics, WhatSourcesSumToIsTakenOffAndReported)
{
  // A source of 0.5 to 1.5 per length along a curve of length 4, on a square without a sink; in the
  // second drawing a diffusion curve is the sink.
  Drawing drawing(Plane(8, 6, 0.2));
  drawing.Add(Source, { drawing.Find(2.2, 3.3), drawing.Find(6.2, 3.3) }, { 0.5, 1.5 }, {});
  drawing.Options.Background = { 0.25 };
  drawing.Run(1);
  ASSERT_EQ(drawing.Result.NetSources.size(), 1u);
  EXPECT_NEAR(drawing.Result.NetSources[0], 4.0, 1e-12);
  dgg::SurfaceMesh fine;
  ASSERT_TRUE(drawing.Surface.Build(drawing.Mesh, fine).IsOk());
  dgg::PoissonSolver solver(fine);
  ASSERT_TRUE(solver.Prepare({}, nullptr).IsOk());
  const std::vector<double> flow = solver.GetSystem().Multiply(drawing.Result.Values);
  double mean = 0.0;
  double moment = 0.0;
  for (Id v = 0; v < fine.GetNumberOfVertices(); ++v)
  {
    mean += drawing.Value(v) * solver.GetAreas()[v] / 48.0;
    const double taken = flow[v] + 4.0 * solver.GetAreas()[v] / 48.0;
    const Position p = drawing.Place(v);
    EXPECT_TRUE(std::abs(p[1] - 3.3) < 1e-9 || std::abs(taken) < 1e-10);
    moment += taken * (p[0] - 4.2);
  }
  EXPECT_NEAR(mean, 0.25, 1e-12);
  EXPECT_NEAR(moment, 16.0 / 12.0, 1e-9); // for a density 1 + x / 4 with x from -2 to 2

  Drawing taken(Plane(8, 6, 0.2));
  taken.Add(Source, { taken.Find(2.0, 0.0), taken.Find(2.0, 6.0) }, { 1.0, 1.0 }, {});
  taken.AddLine(Diffusion, { 5.0, 0.0 }, { 5.0, 6.0 }, 0.5, 0.5);
  taken.Run();
  EXPECT_EQ(*std::max_element(taken.Result.NetSources.begin(), taken.Result.NetSources.end()), 0.0);
  taken.ForEachCorner([&](Id v, const Position& p, const Position&) {
    // The source flows entirely to the right.
    const double expected = p[0] < 2.0 ? 3.5 : p[0] < 5.0 ? 0.5 + 5.0 - p[0] : 0.5;
    EXPECT_NEAR(taken.Value(v), expected, 1e-10);
  });
}

TEST(VectorGraphics, OrderTwoBesideCurves)
{
  // x^2 - y^2 is harmonic. It is given on both sides of a closed curve with dense points, with
  // another constant outside. Errors are discretization errors and errors of the polygon's colors.
  Convergence errors(1.7);
  for (const int level : { 0, 1, 2 })
  {
    const Id n = 12;
    Drawing drawing(Translated(Scaled(Plane(n, n, 0.2), 4.0 / n), -2.0, -2.0, 0.0));
    std::vector<SurfacePoint> points;
    std::vector<double> left;
    for (int k = 0; k < 720; ++k)
    {
      const double angle = 2.0 * dgg::Pi * k / 720.0;
      const double x = 1.7 * std::cos(angle);
      const double y = 1.4 * std::sin(angle);
      points.push_back(drawing.Find(x, y));
      left.push_back(x * x - y * y);
    }
    drawing.Add(Diffusion, points, left, std::vector<double>(720, 3.0), true);
    drawing.Run(level);
    double sum = 0.0;
    Id count = 0;
    for (std::size_t v = 0; v < drawing.GetNumberOfValues(); ++v)
    {
      const Position p = drawing.Place(static_cast<Id>(v));
      if (std::hypot(p[0] / 1.7, p[1] / 1.4) < 0.9)
      {
        const double error = drawing.Value(v) - (p[0] * p[0] - p[1] * p[1]);
        sum += error * error;
        ++count;
      }
    }
    errors.Add(std::sqrt(sum / count));
  }
  EXPECT_LT(errors.Last, 1e-3);
}

TEST(VectorGraphics, AnyCurvesOnAnySurface)
{
  // Curves that run along edges and boundaries, cross each other and themselves, and return. With
  // diffusion curves alone, all colors lie within the range of the given colors.
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
  const SubMesh before = Embed(mesh, { Curve(mesh, { a, b }) });
  dgg::GraphicsRefinement refinement;
  refinement.Levels = 2;
  refinement.Part = dgg::RefinedPart::AroundCurves;
  SubMesh surface = before;
  ASSERT_TRUE(dgg::RefineForGraphics(mesh, refinement, surface).IsOk());
  EXPECT_EQ(surface.Paths[0].size(), 4 * before.Paths[0].size() - 3);
  // Some faces are unchanged.
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
}

// Fragments of colored surfaces: positions, colors, faces.

TEST(VectorGraphics, FragmentsAreTheMiddlesOfEqualParts)
{
  // A function that is linear on each side of a curve: fragments have its values at their
  // positions, are evenly spread, and lie on the correct side.
  for (const int division : { 1, 2, 3, 5 })
  {
    Drawing drawing(Plane(5, 4, 0.3));
    drawing.Options.NumberOfChannels = 2;
    drawing.Add(Diffusion, { drawing.Find(0.0, 0.0), drawing.Find(0.0, 4.0) }, { 0, 9, 0, 9 },
      { 1, 3, 1, 3 });
    drawing.Add(Diffusion, { drawing.Find(2.6, 0.0), drawing.Find(2.6, 4.0) }, { 2, 0, 2, 0 },
      { 7, 8, 7, 8 });
    drawing.Run(1);
    const dgg::SubMesh& surface = drawing.Graphics.GetSurface();
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
    // First and second moments of the fragments of a triangle: only the second moments of the parts
    // about their own centers are missing, 1/division^2 of those of the triangle.
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
