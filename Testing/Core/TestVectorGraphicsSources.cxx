// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Vector graphics: sources and sinks of regions of any shape and of curves that touch other curves.
#include "GraphicsTestTools.h"
#include "PathChecks.h"
#include "TestMeshes.h"

#include "dggGraphicsSources.h"
#include "dggPoissonSolver.h"
#include "dggPoissonSystem.h"

namespace dggtest
{
namespace
{
/// Returns the faces with their midpoint in one of the boxes: x from, x to, y from, y to.
std::vector<Id> FacesIn(const Drawing& drawing, const std::vector<std::array<double, 4>>& boxes)
{
  std::vector<Id> faces;
  for (Id f = 0; f < drawing.Mesh.GetNumberOfFaces(); ++f)
  {
    double x = 0.0;
    double y = 0.0;
    for (const Id v : drawing.Mesh.GetTriangle(f))
    {
      x += drawing.Input.Point(v)[0] / 3.0;
      y += drawing.Input.Point(v)[1] / 3.0;
    }
    if (std::any_of(boxes.begin(), boxes.end(), [&](const std::array<double, 4>& box) {
          return x > box[0] && x < box[1] && y > box[2] && y < box[3];
        }))
    {
      faces.push_back(f);
    }
  }
  return faces;
}
}

TEST(VectorGraphicsSources, EachPatchOfARegionIsBalanced)
{
  // A small and a large square of one region: the source of each square is balanced at its own rim.
  Drawing drawing(Plane(30, 12));
  drawing.Regions = { { FacesIn(drawing, { { 1, 3, 1, 3 }, { 20, 26, 3, 9 } }), { 0.75 } } };
  drawing.Run();
  EXPECT_NEAR(drawing.Result.NetSources[0], 0.0, 1e-12);
  dgg::PoissonSolver solver(drawing.Mesh);
  ASSERT_TRUE(solver.Prepare({}, nullptr).IsOk());
  const std::vector<double> flow = solver.GetSystem().Multiply(drawing.Result.Values);
  double sums[2] = { 0.0, 0.0 };
  Id inside = 0;
  for (Id v = 0; v < drawing.Mesh.GetNumberOfVertices(); ++v)
  {
    const double* p = drawing.Input.Point(v);
    sums[p[0] < 10.0 ? 0 : 1] += flow[v];
    const bool isInSmall = p[0] > 1.5 && p[0] < 2.5 && p[1] > 1.5 && p[1] < 2.5;
    const bool isInLarge = p[0] > 20.5 && p[0] < 25.5 && p[1] > 3.5 && p[1] < 8.5;
    if (isInSmall || isInLarge)
    {
      const double density = 4.0 * dgg::Pi * 0.75 / (isInSmall ? 4.0 : 36.0);
      EXPECT_NEAR(flow[v], density * solver.GetAreas()[v], 1e-9);
      ++inside;
    }
  }
  EXPECT_EQ(inside, 1 + 25);
  EXPECT_NEAR(sums[0], 0.0, 1e-9);
  EXPECT_NEAR(sums[1], 0.0, 1e-9);
}

TEST(VectorGraphicsSources, RegionsOnSeveralComponents)
{
  // Patches on two components; then the whole second component, which has no rim.
  TestMesh planes = Plane(8, 8);
  Append(planes, Translated(Plane(8, 8), 20.0, 0.0, 0.0));
  Drawing drawing(planes);
  drawing.Regions = { { FacesIn(drawing, { { 1, 3, 1, 3 }, { 21, 27, 1, 7 } }), { 1.0 } } };
  drawing.Run();
  ASSERT_EQ(drawing.Result.NetSources.size(), 2u);
  EXPECT_NEAR(drawing.Result.NetSources[0], 0.0, 1e-12);
  EXPECT_NEAR(drawing.Result.NetSources[1], 0.0, 1e-12);
  drawing.Regions = { { FacesIn(drawing, { { 1, 3, 1, 3 }, { 20, 28, 0, 8 } }), { 1.0 } } };
  drawing.Options.Background = { 0.5 };
  drawing.Run();
  EXPECT_NEAR(drawing.Result.NetSources[0], 0.0, 1e-12);
  EXPECT_NEAR(drawing.Result.NetSources[1], 4.0 * dgg::Pi, 1e-12);
  double brightest = 0.0;
  for (std::size_t v = 0; v < drawing.GetNumberOfValues(); ++v)
  {
    brightest = std::max(brightest, drawing.Value(v));
    if (drawing.Place(static_cast<Id>(v))[0] > 10.0)
    {
      EXPECT_NEAR(drawing.Value(v), 0.5, 1e-12);
    }
  }
  EXPECT_GT(brightest, 1.0);
}

TEST(VectorGraphicsSources, EachCurveFindsItsOwnLeft)
{
  // Nested squares, a square that crosses them, and a clockwise square. Results do not depend on
  // earlier queries; open curves are refused.
  const SurfaceMesh mesh = Build(Plane(8, 8));
  const auto square = [&](Id from, Id to, bool isClockwise) {
    std::vector<SurfacePoint> corners;
    for (const std::array<Id, 2>& c :
      { std::array<Id, 2>{ { from, from } }, { { to, from } }, { { to, to } }, { { from, to } } })
    {
      corners.push_back(SurfacePoint::AtVertex(9 * c[1] + c[0]));
    }
    if (isClockwise)
    {
      std::reverse(corners.begin(), corners.end());
    }
    return Curve(mesh, corners, true);
  };
  const std::vector<SurfaceCurve> curves = { square(1, 7, false), square(2, 6, false),
    square(3, 5, true), square(1, 4, false), square(2, 6, false) };
  const std::size_t counts[] = { 72, 32, 128 - 8, 18, 32 };
  const SubMesh surface = Embed(mesh, curves);
  std::vector<dgg::CurveChain> chains;
  for (std::size_t k = 0; k < curves.size(); ++k)
  {
    chains.push_back(dgg::FollowCurve(surface, curves, k));
  }
  const dgg::PathEdges edges(surface, surface.Paths);
  dgg::LeftFaces left(edges);
  std::vector<Id> faces;
  for (std::size_t k = 0; k < curves.size(); ++k)
  {
    EXPECT_FALSE(left.Find(chains[k], false, faces).IsOk());
    EXPECT_TRUE(faces.empty());
    ASSERT_TRUE(left.Find(chains[k], true, faces).IsOk());
    std::sort(faces.begin(), faces.end());
    EXPECT_EQ(faces.size(), counts[k]) << k;
    EXPECT_EQ(std::unique(faces.begin(), faces.end()), faces.end());
  }
}

TEST(VectorGraphicsSources, DiffusionCurvesTakePatchesApart)
{
  // A region from x = 2 to 6 with a curve at x = 3 and one at x = 5 through it. The middle patch
  // has rims above and below; the outer patches have rims on three sides.
  Drawing drawing(Plane(8, 8));
  for (const double x : { 3.0, 5.0 })
  {
    drawing.AddLine(Diffusion, { x, 0.0 }, { x, 8.0 }, 0.0, 0.0);
  }
  drawing.Regions = { { FacesIn(drawing, { { 2, 6, 0, 8 } }), { 1.0 } } };
  drawing.Run(2);
  // Between the curves -u'' = 4 pi / 16, without any rim.
  drawing.ForEachCorner([&](Id v, const Position& p, const Position& m) {
    if (m[0] > 3.0 && m[0] < 5.0)
    {
      const double density = 4.0 * dgg::Pi / 16.0;
      EXPECT_NEAR(drawing.Value(v), 0.5 * density * (p[0] - 3.0) * (5.0 - p[0]), 1e-9);
    }
    // The source of the left patch flows out at x = 2, and the flux beyond is zero.
    if (m[0] < 1.0)
    {
      const double density = 4.0 * dgg::Pi / 8.0;
      EXPECT_NEAR(drawing.Value(v), -0.5 * density, 5e-3); // discretization error at the boundary
    }
  });
}

TEST(VectorGraphicsSources, RimsHaveTheSameSinkPerLength)
{
  // The eight faces of a square are a region; a fin is attached to one of its inner edges and is
  // not in the region.
  TestMesh input = Plane(2, 2);
  const Id top = input.AddPoint(1.0, 0.5, 1.0);
  input.AddTriangle(1, 4, top);
  const SurfaceMesh mesh = Build(input);
  dgg::CurveCut cut = CutOpen(Embed(mesh, {}));
  std::vector<Id> faces(8);
  std::iota(faces.begin(), faces.end(), 0);
  std::vector<std::vector<double>> loads(2, std::vector<double>(input.Points.size() / 3, 0.0));
  dgg::RegionSources sources(mesh, cut.Surface);
  sources.Add(faces, { 1.0, -2.0 }, loads);
  // The entire sink is at this edge.
  const auto expectSinks = [&](double sign) {
    double sum = 0.0;
    for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
    {
      double area = 0.0;
      for (const Id f : faces)
      {
        const std::array<Id, 3> corners = mesh.GetTriangle(f);
        area += std::count(corners.begin(), corners.end(), v) > 0 ? 0.5 / 3.0 : 0.0;
      }
      const double source = 4.0 * dgg::Pi * area / 4.0;
      const double sink = v == 1 || v == 4 ? 2.0 * dgg::Pi : 0.0;
      EXPECT_NEAR(loads[0][v], sign * (source - sink), 1e-12) << v;
      EXPECT_NEAR(loads[1][v], -2.0 * loads[0][v], 1e-12);
      sum += loads[0][v];
    }
    EXPECT_NEAR(sum, 0.0, 1e-12);
  };
  expectSinks(1.0);
  // The sink exists even if the edge has zero length. A region may be added again and may contain
  // faces twice.
  std::fill(cut.Surface.Lengths.begin(), cut.Surface.Lengths.end(), 0.0);
  for (std::vector<double>& channel : loads)
  {
    std::fill(channel.begin(), channel.end(), 0.0);
  }
  faces.push_back(3);
  sources.Add(faces, { 1.0, -2.0 }, loads);
  faces.pop_back();
  expectSinks(1.0);
}

TEST(VectorGraphicsSources, SourcesFlowIntoTheirOwnSheet)
{
  // Two layers touch in one point. A diffusion curve runs through the point on one layer, and a
  // source ends at the point on the other layer, which has no sink. The order of the layers must
  // not matter.
  for (const bool isSourceFirst : { false, true })
  {
    TestMesh input;
    for (const double x : { 0.0, 1.0, 2.0 })
    {
      for (const double y : { 0.0, 1.0, 2.0 })
      {
        input.AddPoint(x - 1.0, y - 1.0, 0.0);
      }
    }
    const Id other = input.AddPoint(3.0, 0.0, 4.0);
    for (const auto& p : { Position{ { 0, 3, 4 } }, { { -3, 0, 4 } }, { { 0, -3, 4 } } })
    {
      input.AddPoint(p[0], p[1], p[2]);
    }
    const auto addFlat = [&] {
      const Id around[] = { 0, 3, 6, 7, 8, 5, 2, 1 };
      for (int k = 0; k < 8; ++k)
      {
        input.AddTriangle(4, around[k], around[(k + 1) % 8]);
      }
    };
    const auto addCone = [&] {
      for (int k = 0; k < 4; ++k)
      {
        input.AddTriangle(4, other + k, other + (k + 1) % 4);
      }
    };
    isSourceFirst ? addCone() : addFlat();
    isSourceFirst ? addFlat() : addCone();
    Drawing drawing(input);
    drawing.Add(Diffusion, AtVertices({ 3, 4, 5 }), { 1, 1, 1 }, { 2, 2, 2 });
    drawing.Add(Source, AtVertices({ other, 4 }), { 0.5, 0.5 }, {});
    drawing.Run();
    std::vector<double> net = drawing.Result.NetSources;
    std::sort(net.begin(), net.end());
    EXPECT_NEAR(net.back(), 2.5, 1e-12) << isSourceFirst; // length 5 times density 0.5
    EXPECT_EQ(net.front(), 0.0);
  }
}

// Vector graphics: small far effects of regions that are not round.

namespace
{
double RadiusOf(const Drawing& drawing, std::size_t v)
{
  const Position p = drawing.Place(static_cast<Id>(v));
  return std::hypot(p[0], p[1]);
}
}

TEST(VectorGraphicsFar, ColorsThatAreGivenFarAwayStay)
{
  // With a distant diffusion curve around the region, the background does not become darker.
  Drawing drawing(Translated(Scaled(Plane(30, 30, 0.2), 1.0 / 3.0), -5.0, -5.0, 0.0));
  const std::vector<double> given(48, 0.25);
  drawing.Add(Region, drawing.FindEllipse(1.0, 0.5, 48), std::vector<double>(48, 1.0), {}, true);
  drawing.Add(Diffusion, drawing.FindEllipse(4.5, 4.5, 48), given, given, true);
  drawing.Run(1);
  for (std::size_t v = 0; v < drawing.GetNumberOfValues(); ++v)
  {
    const double r = RadiusOf(drawing, v);
    EXPECT_NEAR(drawing.Value(v), 0.25, r > 4.51 ? 1e-9 : r > 2.0 ? 0.024 : 1.0);
  }
}

// Vector graphics: colors of any magnitude.

namespace
{
constexpr double Largest = std::numeric_limits<double>::max();

/// Adds all kinds of curves and regions to a drawing. Values of the first channel are scaled by
/// `factor`, values of a second channel are not. Colors are within [-1, 1] times the factor, and so
/// are net sources.
void DrawAll(Drawing& drawing, double factor, int channels)
{
  const auto colors = [&](double first, double last) {
    std::vector<double> values;
    for (const double value : { first, last })
    {
      for (int c = 0; c < channels; ++c)
      {
        values.push_back(c == 1 ? value : factor * value);
      }
    }
    return values;
  };
  drawing.Options.NumberOfChannels = channels;
  drawing.Add(Diffusion, { drawing.Find(6.3, 2.0), drawing.Find(7.1, 6.2) }, colors(0.5, -0.25),
    colors(0.75, 0.1));
  // Diffusion and blended strengths add at most 0.3.
  drawing
    .Add(Poisson, { drawing.Find(1.2, 6.5), drawing.Find(3.3, 6.2) }, colors(0.1, 0.2),
      colors(-0.2, -0.1))
    .Width = 1.5;
  drawing.Add(Source, { drawing.Find(2.0, 1.0), drawing.Find(3.0, 1.0) }, colors(0.02, 0.01), {});
  drawing.Add(
    Region, { drawing.Find(4, 4), drawing.Find(5.5, 4), drawing.Find(4.5, 5.5) },
    [&] {
      std::vector<double> values = colors(0.02, 0.02);
      values.resize(static_cast<std::size_t>(3 * channels), 0.0);
      return values;
    }(),
    {}, true);
  drawing.Regions = { { { 3, 4, 5 }, std::vector<double>(channels, 0.05 * factor) } };
  drawing.Options.Background = std::vector<double>(channels, 0.125 * factor);
  if (channels > 1)
  {
    drawing.Regions[0].Strength[1] = 0.05;
    drawing.Options.Background[1] = 0.125;
  }
}

/// Returns two squares, one of which will have a diffusion curve.
TestMesh TwoSquares()
{
  TestMesh both = Plane(8, 8, 0.2);
  Append(both, Translated(Plane(3, 3), 20.0, 0.0, 0.0));
  return both;
}
}

TEST(VectorGraphicsScale, ColorsOfAnySizeAreSolved)
{
  for (const int channels : { 1, 2, 6 }) // six channels are solved simultaneously
  {
    Drawing usual(TwoSquares());
    DrawAll(usual, 1.0, channels);
    usual.Run(1);
    for (const double factor : { 1e-300, 1e-150, 1e100, 1e155, 1e307, 0.5 * Largest })
    {
      Drawing drawing(TwoSquares());
      DrawAll(drawing, factor, channels);
      drawing.Run(1);
      ASSERT_FALSE(HasFatalFailure()) << factor;
      ASSERT_EQ(drawing.Result.Values.size(), usual.Result.Values.size());
      for (std::size_t i = 0; i < drawing.Result.Values.size(); ++i)
      {
        const double size = channels > 1 && i % channels == 1 ? 1.0 : factor;
        ASSERT_NEAR(drawing.Result.Values[i] / size, usual.Result.Values[i], 1e-12) << factor;
      }
      for (std::size_t i = 0; i < drawing.Result.NetSources.size(); ++i)
      {
        const double size = channels > 1 && i % channels == 1 ? 1.0 : factor;
        ASSERT_NEAR(drawing.Result.NetSources[i] / size, usual.Result.NetSources[i], 1e-12);
      }
    }
  }
}

}
