// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Vector graphics: colours of any size.
#include "CurvedMeshes.h"
#include "FlatMeshes.h"
#include "GraphicsTestTools.h"

#include <cmath>
#include <limits>
#include <string>

namespace dggtest
{
namespace
{
constexpr double Largest = std::numeric_limits<double>::max();

/// A drawing with everything, each number of the first channel times `factor`, and a second channel
/// that has none. Colours are within [-1, 1] times the factor, as are net sources.
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
  // At most as much as 0.3 is added by both: diffusion and strengths that are blended.
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

/// Two squares, of which one has a diffusion curve.
TestMesh TwoSquares()
{
  TestMesh both = Plane(8, 8, 0.2);
  Append(both, Translated(Plane(3, 3), 20.0, 0.0, 0.0));
  return both;
}
}

TEST(VectorGraphicsScale, ColorsOfAnySizeAreSolved)
{
  for (const int channels : { 1, 2, 6 }) // six are solved for together
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

TEST(VectorGraphicsScale, ResultsThatAreTooLargeAreRefused)
{
  const auto fails = [](Drawing& drawing, const std::string& word) {
    ASSERT_TRUE(drawing.Prepare().IsOk());
    const dgg::Status status = drawing.Solve();
    EXPECT_FALSE(status.IsOk());
    EXPECT_NE(status.GetMessage().find(word), std::string::npos) << status.GetMessage();
    EXPECT_NE(status.GetMessage().find("channel 1"), std::string::npos) << status.GetMessage();
    EXPECT_TRUE(drawing.Result.Values.empty());
    EXPECT_TRUE(drawing.Result.NetSources.empty());
    EXPECT_TRUE(drawing.Result.Components.empty());
  };
  {
    // Two highlights on each other.
    Drawing drawing(Plane(8, 8));
    drawing.Options.NumberOfChannels = 2;
    for (const double y : { 3.9, 4.1 })
    {
      drawing
        .Add(Poisson, { drawing.Find(2.0, y), drawing.Find(6.0, y) }, { 1, 0.8e308, 1, 0.8e308 },
          { 1, 0.8e308, 1, 0.8e308 })
        .Width = 2.0;
    }
    drawing.Options.Background = { 1.0, 1.5e308 };
    fails(drawing, "colours");
  }
  {
    // What flows in is too much to be told, along a curve so close to the one that takes it in
    // that colours are not.
    Drawing drawing(Plane(8, 8));
    drawing.Options.NumberOfChannels = 2;
    drawing.Add(
      Source, { drawing.Find(4.0, 0.0), drawing.Find(4.0, 8.0) }, { 1, 1e308, 1, 1e308 }, {});
    fails(drawing, "net sources");
  }
}
}
