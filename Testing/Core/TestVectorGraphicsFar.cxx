// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Vector graphics: how little regions that are not round change far away.
#include "FlatMeshes.h"
#include "GraphicsTestTools.h"

#include <algorithm>
#include <cmath>

namespace dggtest
{
namespace
{
double RadiusOf(const Drawing& drawing, std::size_t v)
{
  const Position p = drawing.Place(static_cast<Id>(v));
  return std::hypot(p[0], p[1]);
}
}

TEST(VectorGraphicsFar, EllipsesHardlyChangeWhatIsFar)
{
  // Relative to the height of the highlight, beyond twice and beyond three times the longer half
  // axis: what the class documentation says. In the middle of a plane without end, a layer of
  // sources and one of sinks around it leave a quadrupole, which gives 2.4 % and 1.1 % at 2 : 1,
  // 3.6 % and 1.6 % at 5 : 1.
  struct Case
  {
    double Ratio;
    double Farther;
    double Farthest;
    double Height;
  };
  for (const Case& known : { Case{ 1.0, 0.0, 0.0, 1.0 }, Case{ 2.0, 0.027, 0.012, 0.9 },
         Case{ 5.0, 0.042, 0.0185, 0.65 } })
  {
    SCOPED_TRACE(known.Ratio);
    Drawing drawing(Translated(Scaled(Plane(50, 50, 0.2), 0.2), -5.0, -5.0, 0.0));
    drawing.Add(Region, drawing.FindEllipse(1.0, 1.0 / known.Ratio, 96),
      std::vector<double>(96, 1.0), {}, true);
    drawing.Run(1);
    double sum = 0.0;
    double count = 0.0;
    std::size_t middle = 0;
    for (std::size_t v = 0; v < drawing.GetNumberOfValues(); ++v)
    {
      const double r = RadiusOf(drawing, v);
      sum += r > 3.0 ? drawing.Value(v) : 0.0;
      count += r > 3.0 ? 1.0 : 0.0;
      middle = r < RadiusOf(drawing, middle) ? v : middle;
    }
    const double shift = sum / count;
    const double height = drawing.Value(middle) - shift;
    double farther = 0.0;
    double farthest = 0.0;
    for (std::size_t v = 0; v < drawing.GetNumberOfValues(); ++v)
    {
      const double r = RadiusOf(drawing, v);
      const double change = std::abs(drawing.Value(v) - shift) / height;
      farther = std::max(farther, r > 2.0 ? change : 0.0);
      farthest = std::max(farthest, r > 3.0 ? change : 0.0);
    }
    EXPECT_NEAR(farther, known.Farther, 1.5e-3);
    EXPECT_NEAR(farthest, known.Farthest, 1e-3);
    EXPECT_NEAR(height, known.Height, 0.04);
    // The mean stays, so that all that is far is darker by that of the highlight: of a round one
    // half of its strength times its part of the area; of ellipses up to a third more of it.
    const double half = 0.5 * dgg::Pi / known.Ratio / 100.0;
    EXPECT_GT(-shift, 0.98 * half);
    EXPECT_LT(-shift, 1.3 * half);
  }
}

TEST(VectorGraphicsFar, ColorsThatAreGivenFarAwayStay)
{
  // With a diffusion curve around it, which is far, nothing is darker there.
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
}
