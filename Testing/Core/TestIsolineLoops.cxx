// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Isolines: loops within faces, around sources and farthest points.
#include "GeodesicChecks.h"
#include "GraphChecks.h"
#include "IsolineChecks.h"
#include "TestMeshes.h"

#include "dggFaceProfile.h"
#include "dggIsolines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

using namespace dgg;
using namespace dggtest;

namespace
{
/// A piece of a circle that is in no other disc.
struct FreeArc
{
  std::array<double, 2> Begin;
  std::array<double, 2> End;
};

/// Closed curves around the union of equal discs, none of which is within others.
std::size_t CountLoopsOfDiscs(const std::vector<std::array<double, 3>>& centers, double radius)
{
  std::size_t loops = 0;
  std::vector<FreeArc> arcs;
  for (const std::array<double, 3>& center : centers)
  {
    std::vector<std::pair<double, double>> covered; // angles, from 0 to a turn
    for (const std::array<double, 3>& other : centers)
    {
      const double distance = DistanceTo(other, center[0], center[1]);
      if (&other == &center || distance >= 2.0 * radius)
      {
        continue;
      }
      const double half = std::acos(distance / (2.0 * radius));
      double begin = std::atan2(other[1] - center[1], other[0] - center[0]) - half;
      begin += begin < 0.0 ? 2.0 * Pi : 0.0;
      begin += begin < 0.0 ? 2.0 * Pi : 0.0;
      covered.emplace_back(begin, begin + 2.0 * half);
      covered.emplace_back(begin - 2.0 * Pi, begin + 2.0 * half - 2.0 * Pi);
    }
    if (covered.empty())
    {
      ++loops;
      continue;
    }
    std::sort(covered.begin(), covered.end());
    // From one that begins in the turn to the same one, a turn later.
    const auto first = std::lower_bound(covered.begin(), covered.end(), std::make_pair(0.0, 0.0));
    const double turn = first->first + 2.0 * Pi;
    double reached = first->first;
    const auto at = [&](double angle) {
      return std::array<double, 2>{ { center[0] + radius * std::cos(angle),
        center[1] + radius * std::sin(angle) } };
    };
    const auto leave = [&](double until) {
      if (until > reached)
      {
        arcs.push_back({ at(reached), at(until) });
      }
    };
    for (const std::pair<double, double>& c : covered)
    {
      leave(std::min(c.first, turn));
      reached = std::max(reached, c.second);
    }
    leave(turn);
  }
  std::vector<bool> isDone(arcs.size(), false);
  for (std::size_t i = 0; i < arcs.size(); ++i)
  {
    loops += isDone[i] ? 0 : 1;
    for (std::size_t k = i; !isDone[k];)
    {
      isDone[k] = true;
      const std::array<double, 2> end = arcs[k].End;
      const auto miss = [&](const FreeArc& arc) {
        return std::hypot(arc.Begin[0] - end[0], arc.Begin[1] - end[1]);
      };
      k = std::min_element(arcs.begin(), arcs.end(),
            [&](const FreeArc& a, const FreeArc& b) { return miss(a) < miss(b); }) -
        arcs.begin();
    }
  }
  return loops;
}
}

/// Waves that meet in strips narrower than the lattice that isolines are looked for with.
TEST(Isolines, LoopsAroundManySourcesThatMeetInAFace)
{
  const TestMesh test = SingleTriangle();
  const SurfaceMesh mesh = Build(test);
  for (std::uint64_t seed = 1; seed <= 3; ++seed)
  {
    Random random(seed);
    std::vector<GeodesicSource> sources;
    std::vector<std::array<double, 3>> centers;
    for (int i = 0; i < 300; ++i)
    {
      double s = random.Uniform(0.0, 1.0);
      double t = random.Uniform(0.0, 1.0);
      if (s + t > 1.0)
      {
        s = 1.0 - s;
        t = 1.0 - t;
      }
      // Away from the rim, so that all loops are closed.
      s = 0.1 + 0.7 * s;
      t = 0.1 + 0.7 * t;
      sources.push_back(FaceSourceAt(mesh, 0, { { 1.0 - s - t, s, t } }));
      centers.push_back(PositionOf(mesh, sources.back().Point, test.Points.data()));
    }
    const ExactField field(mesh, sources);
    for (const double radius : { 0.002, 0.004, 0.006 })
    {
      const double level = radius * mesh.GetMeanEdgeLength();
      const Isolines lines = Trace(field.Exact, { level });
      EXPECT_TRUE(AllClosed(lines));
      EXPECT_EQ(lines.Lines.size(), CountLoopsOfDiscs(centers, level)) << seed << " " << radius;
    }
  }
}

TEST(Isolines, SmallLoopsAroundASourceInAFace)
{
  const TestMesh test = SingleTriangle();
  const SurfaceMesh mesh = Build(test);
  for (const std::array<double, 3>& b :
    { std::array<double, 3>{ { 0.3, 0.3, 0.4 } }, std::array<double, 3>{ { 0.5, 0.25, 0.25 } },
      std::array<double, 3>{ { 0.5, 0.3, 0.2 } }, std::array<double, 3>{ { 0.98, 0.01, 0.01 } } })
  {
    const GeodesicSource source = FaceSourceAt(mesh, 0, b);
    const ExactField field(mesh, { source });
    const auto at = PositionOf(mesh, source.Point, test.Points.data());
    const std::vector<double> levels{ 1e-6, 1e-4, 0.01, 0.02 };
    for (const DistanceField* f : { &field.Exact, &field.Local })
    {
      const Isolines lines = Trace(*f, levels, 1e-5);
      ASSERT_EQ(lines.Lines.size(), levels.size()) << b[0] << " " << b[1] << (f == &field.Exact);
      EXPECT_TRUE(AllClosed(lines));
      EXPECT_EQ(lines.Fallbacks, 0);
      for (std::size_t i = 0; i < levels.size(); ++i)
      {
        for (const SurfacePoint& point : lines.Lines[i].Points)
        {
          const auto p = PositionOf(mesh, point, test.Points.data());
          EXPECT_NEAR(DistanceTo(p, at[0], at[1]), levels[i], 4e-12);
        }
        EXPECT_NEAR(lines.Lines[i].Length, 2.0 * Pi * levels[i], 0.1 * levels[i]);
      }
    }
  }
}

/// Around the point of a face that is farthest from its corners.
TEST(Isolines, SmallLoopsAroundAFarthestPoint)
{
  TestMesh test;
  test.AddPoint(0.0, 0.0, 0.0);
  test.AddPoint(2.0, 0.0, 0.0);
  test.AddPoint(1.1, 1.6, 0.0);
  test.AddTriangle(0, 1, 2);
  const SurfaceMesh mesh = Build(test);
  const std::vector<GeodesicSource> sources{ VertexSource(0), VertexSource(1), VertexSource(2) };
  const ExactField field(mesh, sources);
  const double y = (1.1 * 1.1 + 1.6 * 1.6 - 2.0 * 1.1) / (2.0 * 1.6);
  const double farthest = std::hypot(1.0, y); // from the circumcentre
  const std::vector<double> levels{ 0.2, 0.9, 1.0 + 0.5 * (farthest - 1.0), farthest - 1e-4,
    farthest + 1e-6 };
  for (const DistanceField* f : { &field.Exact, &field.Local })
  {
    const Isolines lines = Trace(*f, levels);
    std::map<Id, int> counts = LinesPerLevel(lines);
    EXPECT_EQ(counts[0], 3);
    EXPECT_EQ(counts[2], 1);
    EXPECT_EQ(counts[3], 1);
    EXPECT_EQ(counts[4], 0);
    ExpectSound(*f, levels, lines, "triangle");
    ExpectAtLevel(mesh, sources, levels, lines, 1e-12, "triangle");
    for (std::size_t i = 0; i < lines.Lines.size(); ++i)
    {
      EXPECT_EQ(lines.IsClosed[i], lines.Levels[i] >= 2);
    }
  }
}

TEST(Isolines, DoNotRunBack)
{
  const TestMesh test = WithNoise(Ellipsoid(4, 0.5), 0.01, 3);
  const SurfaceMesh mesh = Build(test);
  const ExactField field(mesh, { VertexSource(11) });
  const double farthest =
    *std::max_element(field.Result.Distances.begin(), field.Result.Distances.end());
  std::vector<double> levels;
  for (int i = 1; i < 20; ++i)
  {
    levels.push_back(0.05 * i * farthest);
  }
  std::vector<double> lengths;
  for (const double tolerance : { 1e-2, 1e-4, 1e-6 })
  {
    const Isolines lines = Trace(field.Exact, levels, tolerance * mesh.GetMeanEdgeLength());
    int turns = 0;
    double length = 0.0;
    for (const SurfacePath& line : lines.Lines)
    {
      length += line.Length;
      for (std::size_t i = 1; i + 1 < line.Points.size(); ++i)
      {
        double cosine = 0.0;
        const auto a = PositionOf(mesh, line.Points[i - 1], test.Points.data());
        const auto b = PositionOf(mesh, line.Points[i], test.Points.data());
        const auto c = PositionOf(mesh, line.Points[i + 1], test.Points.data());
        double before = 0.0;
        double after = 0.0;
        for (int k = 0; k < 3; ++k)
        {
          cosine += (b[k] - a[k]) * (c[k] - b[k]);
          before += (b[k] - a[k]) * (b[k] - a[k]);
          after += (c[k] - b[k]) * (c[k] - b[k]);
        }
        const double least = 1e-7 * mesh.GetMeanEdgeLength();
        turns +=
          std::min(before, after) > least * least && cosine < -0.994 * std::sqrt(before * after);
      }
    }
    EXPECT_EQ(turns, 0) << tolerance;
    lengths.push_back(length);
  }
  // Finer chords are longer, by less and less.
  EXPECT_LE(lengths[0], lengths[1] * (1.0 + 1e-9));
  EXPECT_LE(lengths[1], lengths[2] * (1.0 + 1e-9));
  EXPECT_NEAR(lengths[1], lengths[2], 1e-4 * lengths[2]);
}

TEST(Isolines, WithoutWindowsThereAreHardlyMoreLoops)
{
  // Edges that saw crests where a wave comes across from a face had loops around them.
  // Apart, so that meshes do not make up for each other.
  double surplus = 0.0;
  double missing = 0.0;
  for (const NamedMesh& named : SoundMeshes())
  {
    const SurfaceMesh mesh = Build(named.Mesh);
    const ExactField field(mesh, { VertexSource(0) });
    const std::vector<double> levels = EvenLevels(field.Exact, 100);
    const auto exact = static_cast<double>(Trace(field.Exact, levels).Lines.size());
    const auto local = static_cast<double>(Trace(field.Local, levels).Lines.size());
    surplus += std::max(0.0, local - exact);
    missing += std::max(0.0, exact - local);
  }
  EXPECT_LE(surplus, 10.0);
  EXPECT_LE(missing, 15.0);
}
