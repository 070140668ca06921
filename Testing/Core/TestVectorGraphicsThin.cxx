// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Vector graphics: curves on parts of a surface with triangles too thin for equations of their own.
#include "FlatMeshes.h"
#include "GraphicsTestTools.h"

#include <cmath>

namespace dggtest
{
namespace
{
/// A square, and below it, apart, a strip of thin triangles as long as that.
TestMesh SquareAndStrip(Id n, double height)
{
  TestMesh strip = Plane(n, 4);
  for (std::size_t k = 1; k < strip.Points.size(); k += 3)
  {
    strip.Points[k] = -1.0 + 0.25 * height * strip.Points[k];
  }
  TestMesh mesh = Plane(n, n);
  Append(mesh, strip);
  return mesh;
}
}

TEST(VectorGraphics, StrengthsThatChangeOnThinTriangles)
{
  // The strip is next to nothing of the surface, so its triangles do not matter to the drawing; nor
  // must they to the strengths of a curve there, on which no other triangles are near.
  const Id n = 12;
  for (const double height : { 1e-4, 1e-7, 1e-8, 1e-10, 1e-12 })
  {
    SCOPED_TRACE(height);
    Drawing drawing(SquareAndStrip(n, height));
    // Along the middle of the strip, from end to end, and as wide as half of it is high.
    const Id begin = (n + 1) * (n + 1) + 2 * (n + 1);
    std::vector<SurfacePoint> points;
    std::vector<double> left;
    std::vector<double> right;
    for (Id i = 0; i <= n; ++i)
    {
      points.push_back(SurfacePoint::AtVertex(begin + i));
      left.push_back(i * i);
      right.push_back(-i);
    }
    drawing.Add(Poisson, points, left, right).Width = 0.5 * height;
    // Another one, and a diffusion curve, on the square.
    drawing
      .Add(Poisson, { drawing.Find(2.0, 2.0), drawing.Find(6.0, 3.0) }, { 1.0, 2.0 }, { 1.0, 2.0 })
      .Width = 1.0;
    drawing.Add(
      Diffusion, { drawing.Find(0.0, 0.0), drawing.Find(12.0, 0.0) }, { 0.5, 0.5 }, { 0.5, 0.5 });
    drawing.Run();
    ASSERT_FALSE(HasFatalFailure());
    int found = 0;
    drawing.ForEachCorner([&](Id v, const Position& p, const Position& middle) {
      if (p[1] > -0.5)
      {
        EXPECT_GE(drawing.Value(v), 0.5 - 1e-3);
        EXPECT_LE(drawing.Value(v), 2.5 + 1e-3);
        return;
      }
      const double distance = std::abs(p[1] + 1.0 - 0.5 * height);
      const double fade = std::pow(1.0 - std::pow(distance / (0.5 * height), 2), 2);
      const double strength = middle[1] + 1.0 > 0.5 * height ? p[0] * p[0] : -p[0];
      // Far from one end of the strip the other one is no nearer place.
      EXPECT_NEAR(drawing.Value(v), fade * strength, 0.01 * (1.0 + std::abs(strength)));
      ++found;
    });
    EXPECT_EQ(found, 3 * 2 * 4 * n);
  }
}
}
