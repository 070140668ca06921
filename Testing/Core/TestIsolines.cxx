// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Isolines: accuracy of levels, validity on any mesh; loops within faces.
#include "GeodesicChecks.h"
#include "GraphChecks.h"
#include "IsolineChecks.h"
#include "TestMeshes.h"

#include "dggBands.h"
#include "dggFaceEnvelope.h"
#include "dggGraphSearch.h"
#include "dggIsolines.h"

using namespace dgg;
using namespace dggtest;

TEST(Isolines, AreCirclesInThePlane)
{
  const TestMesh test = Plane(9, 9, 0.25);
  const SurfaceMesh mesh = Build(test);
  const Id source = 4 * 10 + 5;
  const ExactField field(mesh, { VertexSource(source) });
  const double x = test.Point(source)[0];
  const double y = test.Point(source)[1];
  const std::vector<double> levels{ 0.01, 0.3, 1.0, 1.7, 2.9, 3.4 };
  const auto turnOf = [&](const SurfacePath& line) {
    double turn = 0.0;
    for (std::size_t p = 0; p + 1 < line.Points.size(); ++p)
    {
      const auto a = PositionOf(mesh, line.Points[p], test.Points.data());
      const auto b = PositionOf(mesh, line.Points[p + 1], test.Points.data());
      turn += std::atan2((a[0] - x) * (b[1] - y) - (a[1] - y) * (b[0] - x),
        (a[0] - x) * (b[0] - x) + (a[1] - y) * (b[1] - y));
    }
    return turn;
  };
  for (const SurfacePath& line : Trace(field.Local, levels, 0.0, IsolineMethod::Apollonius).Lines)
  {
    EXPECT_NEAR(turnOf(line), 2.0 * Pi, 1e-9);
  }
  for (const double tolerance : { 1e-2, 1e-4 })
  {
    for (const DistanceField* f : { &field.Exact, &field.Local })
    {
      const Isolines lines = Trace(*f, levels, tolerance);
      EXPECT_EQ(lines.Fallbacks, 0);
      ASSERT_EQ(lines.Lines.size(), levels.size());
      EXPECT_TRUE(AllClosed(lines));
      ExpectSound(*f, levels, lines, "plane");
      for (std::size_t i = 0; i < lines.Lines.size(); ++i)
      {
        const double level = levels[lines.Levels[i]];
        const SurfacePath& line = lines.Lines[i];
        for (std::size_t p = 0; p + 1 < line.Points.size(); ++p)
        {
          const auto a = PositionOf(mesh, line.Points[p], test.Points.data());
          const auto b = PositionOf(mesh, line.Points[p + 1], test.Points.data());
          EXPECT_NEAR(DistanceTo(a, x, y), level, 1e-12);
          EXPECT_NEAR(DistanceTo(Middle(a, b), x, y), level, 1.001 * tolerance);
        }
        EXPECT_NEAR(turnOf(line), 2.0 * Pi, 1e-9) << "what is nearer is on the left";
      }
    }
  }
}

/// Circles that are narrower than the sampling lattice of the faces that they cross.
TEST(Isolines, SmallCirclesCrossLongThinFaces)
{
  TestMesh test = Plane(1, 40);
  for (std::size_t i = 0; i < test.Points.size(); i += 3)
  {
    test.Points[i] *= 40.0;
    test.Points[i + 1] *= 0.02;
  }
  const SurfaceMesh mesh = Build(test);
  const GeodesicSource source = FaceSourceAt(mesh, 40, { { 0.34, 0.24, 0.42 } });
  const auto center = PositionOf(mesh, source.Point, test.Points.data());
  const ExactField field(mesh, { source });
  const std::vector<double> levels{ 0.05, 0.1, 0.2, 0.3 };
  const Isolines lines = Trace(field.Exact, levels, 1e-4);
  EXPECT_EQ(lines.Fallbacks, 0);
  EXPECT_TRUE(AllClosed(lines));
  ASSERT_EQ(lines.Lines.size(), levels.size());
  for (std::size_t i = 0; i < lines.Lines.size(); ++i)
  {
    const std::vector<SurfacePoint>& points = lines.Lines[i].Points;
    for (std::size_t p = 0; p + 1 < points.size(); ++p)
    {
      const auto middle = Middle(PositionOf(mesh, points[p], test.Points.data()),
        PositionOf(mesh, points[p + 1], test.Points.data()));
      EXPECT_NEAR(DistanceTo(middle, center[0], center[1]), levels[lines.Levels[i]], 1.001e-4);
    }
  }
}

TEST(Isolines, TurnOnTheBisectorOfTwoSources)
{
  const TestMesh test = Plane(12, 9, 0.25);
  const SurfaceMesh mesh = Build(test);
  const Id a = 4 * 13 + 4;
  const Id b = 5 * 13 + 8;
  const ExactField field(mesh, { VertexSource(a), VertexSource(b, 0.4) });
  const std::vector<double> levels{ 1.0, 2.5, 2.9, 3.1 };
  for (const DistanceField* f : { &field.Exact, &field.Local })
  {
    const Isolines lines = Trace(*f, levels);
    ExpectSound(*f, levels, lines, "two sources");
    EXPECT_EQ(lines.Fallbacks, 0);
    EXPECT_EQ(LinesPerLevel(lines)[0], 2);
    EXPECT_EQ(LinesPerLevel(lines)[1], 1);
    for (std::size_t i = 0; i < lines.Lines.size(); ++i)
    {
      const double level = levels[lines.Levels[i]];
      int corners = 0;
      const std::vector<SurfacePoint>& points = lines.Lines[i].Points;
      for (std::size_t p = 0; p + 1 < points.size(); ++p)
      {
        const auto at = PositionOf(mesh, points[p], test.Points.data());
        const double toA = DistanceTo(at, test.Point(a)[0], test.Point(a)[1]);
        const double toB = DistanceTo(at, test.Point(b)[0], test.Point(b)[1]) + 0.4;
        EXPECT_NEAR(std::min(toA, toB), level, 1e-12);
        corners += std::abs(toA - toB) < 1e-11 ? 1 : 0;
      }
      // Where the models of two face corners differ, a kink of the line may lie next to the ridge.
      EXPECT_LE(corners, lines.Levels[i] == 0 ? 0 : 2);
      EXPECT_GE(corners, lines.Levels[i] == 0 ? 0 : f == &field.Exact ? 2 : 1);
    }
  }
}

/// Between two fronts that are about to meet there is an arbitrarily narrow strip.
TEST(Isolines, StripsAlongRidgesMayBeNarrow)
{
  for (std::uint64_t seed = 1; seed <= 12; ++seed)
  {
    const TestMesh test = Plane(12, 9, 0.28, seed);
    const SurfaceMesh mesh = Build(test);
    const Id a = 4 * 13 + 4;
    const Id b = 5 * 13 + 8;
    const ExactField field(mesh, { VertexSource(a), VertexSource(b) });
    const double half = 0.5 * EuclideanDistance(test, a, b);
    const std::vector<double> levels{ half - 1e-2, half - 1e-4, half - 1e-6, half + 1e-6,
      half + 1e-4, half + 1e-2 };
    const Isolines lines = Trace(field.Exact, levels);
    ExpectSound(field.Exact, levels, lines, "strip");
    EXPECT_TRUE(AllClosed(lines));
    EXPECT_EQ(lines.Fallbacks, 0) << seed;
    std::map<Id, int> counts = LinesPerLevel(lines);
    for (Id level = 0; level < 6; ++level)
    {
      EXPECT_EQ(counts[level], level < 3 ? 2 : 1) << seed << ", " << level;
    }
  }
}

TEST(Isolines, AreAtTheirLevelOnRoughSurfaces)
{
  for (const NamedMesh& named : SoundMeshes())
  {
    const SurfaceMesh mesh = Build(named.Mesh);
    const std::vector<GeodesicSource> sources{ VertexSource(0),
      { RandomSurfacePoints(mesh, 1, 11).front(), 0.1 * mesh.GetMeanEdgeLength() } };
    const ExactField field(mesh, sources);
    const std::vector<double> levels = EvenLevels(field.Exact, 12);
    const Isolines lines = Trace(field.Exact, levels);
    ExpectAtLevel(mesh, sources, levels, lines, 1e-11, named.Name);
  }
}

/// Not only the points but also the chords are within the tolerance.
TEST(Isolines, AreAsCloseAsWished)
{
  const SurfaceMesh mesh = Build(Terrain(14, 0.6, 3));
  const ExactField field(mesh, { VertexSource(0) });
  const std::vector<double> levels = EvenLevels(field.Exact, 12);
  const double tolerance = 1e-4 * mesh.GetMeanEdgeLength();
  for (const DistanceField* f : { &field.Exact, &field.Linear })
  {
    const Isolines lines = Trace(*f, levels, tolerance);
    FaceEnvelope envelope(*f);
    std::size_t far = 0;
    std::size_t all = 0;
    for (std::size_t i = 0; i < lines.Lines.size(); ++i)
    {
      const SurfacePath& line = lines.Lines[i];
      for (std::size_t p = 0; p < line.Faces.size(); ++p)
      {
        std::array<double, 3> a{};
        std::array<double, 3> b{};
        ASSERT_TRUE(FindInFace(mesh, line.Points[p], line.Faces[p], a));
        ASSERT_TRUE(FindInFace(mesh, line.Points[p + 1], line.Faces[p], b));
        envelope.Enter(line.Faces[p]);
        const double d = envelope.At(envelope.PlaceOf(Middle(a, b)));
        far += std::abs(d - levels[lines.Levels[i]]) > 1.5 * tolerance ? 1 : 0;
        ++all;
      }
    }
    EXPECT_LE(far, lines.Fallbacks + all / 1000) << all;
  }
}

/// At ridges isolines have long tips, and the region beyond a level may be a narrow strip.
TEST(Isolines, TipsAndStripsAreFound)
{
  for (const TestMesh& test :
    { Terrain(20, 0.6, 3), NoisySphere(3, 0.5, 5), NoisySphere(3, 0.3, 7), Torus(24, 14) })
  {
    const SurfaceMesh mesh = Build(test);
    const std::vector<GeodesicSource> sources{ VertexSource(0) };
    const ExactField field(mesh, sources);
    const std::vector<double> levels = EvenLevels(field.Exact, 40);
    const double tolerance = 1e-4 * mesh.GetMeanEdgeLength();
    EXPECT_EQ(Trace(field.Exact, levels, tolerance).Fallbacks, 0);
  }
}

TEST(Isolines, ShowTheFieldBetterThanLinearOnes)
{
  for (const TestMesh& test : { Icosphere(3), Ellipsoid(3, 0.4), Torus(24, 14) })
  {
    const SurfaceMesh mesh = Build(test);
    const std::vector<GeodesicSource> sources{ VertexSource(3) };
    const ExactField field(mesh, sources);
    const std::vector<double> levels = EvenLevels(field.Exact, 20);
    std::vector<double> errors;
    for (const DistanceField* f : { &field.Exact, &field.Local, &field.Linear })
    {
      errors.push_back(MeanErrorOfPieces(mesh, sources, levels, Trace(*f, levels)));
    }
    EXPECT_LT(errors[0], 5e-4 * mesh.GetMeanEdgeLength());
    EXPECT_LT(4.0 * errors[1], errors[2]);
  }
}

//
// Isolines: continuous and complete for any field, on any mesh; threads, progress, bad arguments.

using namespace dgg;
using namespace dggtest;

TEST(Isolines, AreSoundOnAllMeshes)
{
  for (const NamedMesh& named : AllMeshes())
  {
    const SurfaceMesh mesh = Build(named.Mesh);
    const std::vector<GeodesicSource> sources{ VertexSource(1),
      { RandomSurfacePoints(mesh, 1, 11).front(), 0.1 * mesh.GetMeanEdgeLength() } };
    const ExactField field(mesh, sources);
    std::vector<double> levels = EvenLevels(field.Exact, 9);
    levels.push_back(0.02 * mesh.GetMeanEdgeLength());
    levels.push_back(field.Result.Distances[mesh.GetNumberOfVertices() / 2]);
    levels.erase(std::remove_if(levels.begin(), levels.end(),
                   [](double level) { return !std::isfinite(level); }),
      levels.end());
    for (const DistanceField* f : { &field.Exact, &field.Local, &field.Linear })
    {
      const Isolines lines = Trace(*f, levels);
      ExpectSound(*f, levels, lines,
        named.Name +
          (f == &field.Exact      ? ""
              : f == &field.Local ? " (local)"
                                  : " (linear)"));
    }
    for (const DistanceField* f : { &field.Local, &field.ExactWithSources })
    {
      ExpectSound(*f, levels, Trace(*f, levels, 0.0, IsolineMethod::Apollonius),
        named.Name + " (Apollonius)");
    }
  }
}

/// On long thin faces, the search for ridges between two nodes may leave the face, as with the
/// first three seeds.
TEST(Isolines, StayInFacesThatAreLongAndThin)
{
  for (const std::uint64_t seed : { 922, 1039, 1997, 1, 2, 3 })
  {
    SCOPED_TRACE(seed);
    const SurfaceMesh mesh = Build(DrilledBar(seed));
    const GeodesicGraph graph = BuildGraph(mesh, 0.01);
    const GraphSearch search(graph.View(), &mesh);
    for (const Id source : { Id{ 1 }, mesh.GetNumberOfVertices() / 2 })
    {
      const ExactField exact(mesh, { VertexSource(source) });
      GraphSeed start;
      start.Vertex = source;
      SearchOptions options;
      options.Correct = true;
      SearchResult result;
      ASSERT_TRUE(search.Run({ start }, options, result).IsOk());
      const DistanceField local{ &mesh, result.Corrected.data(), nullptr, &result.Virtual };
      for (const DistanceField* field : { &exact.Exact, &local })
      {
        const std::vector<double> levels = EvenLevels(*field, 20);
        const Isolines lines = Trace(*field, levels);
        ExpectSound(*field, levels, lines, field == &local ? "graph" : "windows");
        Bands bands;
        EXPECT_TRUE(Ok(MakeBands(*field, levels, lines, nullptr, bands)));
      }
    }
  }
}

TEST(Isolines, OfAnyNumbersAreSound)
{
  for (const TestMesh& test : { Icosphere(2), Terrain(10, 0.6, 3), RandomSoup(60, 120, 4) })
  {
    const SurfaceMesh mesh = Build(test);
    Random random(9);
    std::vector<double> values;
    VirtualSources sources;
    for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
    {
      values.push_back(v % 17 == 16 ? Infinity : random.Uniform(-3.0, 3.0));
      const double length = random.Uniform(0.0, 2.0);
      sources.push_back({ values.back() - length, length, random.Uniform(-9.0, 9.0) });
    }
    const DistanceField linear{ &mesh, values.data(), nullptr, nullptr };
    const DistanceField local{ &mesh, values.data(), nullptr, &sources };
    const std::vector<double> levels{ -2.0, -1.0, 0.0, 0.1, 2.5 };
    for (const DistanceField& field : { linear, local })
    {
      const Isolines lines = Trace(field, levels);
      EXPECT_GT(lines.Lines.size(), 4u);
      ExpectSound(field, levels, lines, field.HasSources() ? "noise (local)" : "noise");
      ExpectSound(field, levels, Trace(field, levels, 0.0, IsolineMethod::Apollonius),
        field.HasSources() ? "noise (Apollonius, local)" : "noise (Apollonius)");
    }
  }
}

TEST(Isolines, OfNumbersThatOverflowLieOnTheSurface)
{
  const SurfaceMesh mesh = Build(Plane(3, 3, 0.2));
  for (const double huge : { 1e17, 1e150, 1e300, 1.7e308 })
  {
    Random random(3);
    std::vector<double> values;
    VirtualSources sources;
    for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
    {
      values.push_back(huge * random.Uniform(-1.0, 1.0));
      sources.push_back({ values.back(), v % 2 == 0 ? huge : 1.0, random.Uniform(0.0, 6.0) });
    }
    const DistanceField linear{ &mesh, values.data(), nullptr, nullptr };
    const DistanceField local{ &mesh, values.data(), nullptr, &sources };
    for (const DistanceField& field : { linear, local })
    {
      for (const IsolineMethod method : { IsolineMethod::LocalSources, IsolineMethod::Apollonius })
      {
        const Isolines lines = Trace(field, { -0.5 * huge, 0.0, 0.5 * huge }, 0.0, method);
        EXPECT_FALSE(lines.Lines.empty());
        for (const SurfacePath& line : lines.Lines)
        {
          const Status status = CheckPath(mesh, line);
          EXPECT_TRUE(status.IsOk()) << huge << ": " << status.GetMessage();
        }
      }
    }
  }
}

TEST(Isolines, LevelsOfVerticesAreNoTrouble)
{
  const TestMesh test = Plane(8, 8);
  const SurfaceMesh mesh = Build(test);
  const Id source = 4 * 9 + 4;
  const ExactField field(mesh, { VertexSource(source) });
  const std::vector<double> levels{ 0.0, 1.0, 2.0, 3.0, 4.0 };
  for (const DistanceField* f : { &field.Exact, &field.Local, &field.Linear })
  {
    const Isolines lines = Trace(*f, levels);
    ExpectSound(*f, levels, lines, "grid");
    std::map<Id, int> counts = LinesPerLevel(lines);
    EXPECT_EQ(counts[0], 0); // no point is nearer
    for (Id level = 1; level < 4; ++level)
    {
      EXPECT_EQ(counts[level], 1) << level;
    }
    for (std::size_t i = 0; i < lines.Lines.size(); ++i)
    {
      EXPECT_TRUE(lines.IsClosed[i] || lines.Levels[i] == 4);
      std::set<Id> vertices;
      for (const SurfacePoint& point : lines.Lines[i].Points)
      {
        if (IsVertex(point))
        {
          vertices.insert(point.Vertex);
        }
      }
      EXPECT_TRUE(vertices.size() >= 4u || !lines.IsClosed[i]);
    }
  }
}

TEST(Isolines, FlatFieldsHaveNone)
{
  const SurfaceMesh mesh = Build(Icosphere(1));
  const std::vector<double> ones(mesh.GetNumberOfVertices(), 1.0);
  const DistanceField field{ &mesh, ones.data(), nullptr, nullptr };
  EXPECT_TRUE(Trace(field, { 0.5, 1.0, 1.5 }).Lines.empty());
  EXPECT_TRUE(Trace(field, {}).Lines.empty());

  std::vector<double> step = ones;
  step[3] = 2.0; // the only vertex above the level
  const DistanceField peak{ &mesh, step.data(), nullptr, nullptr };
  EXPECT_TRUE(Trace(peak, { 1.0 }).Lines.empty());
  EXPECT_EQ(Trace(peak, { 1.5 }).Lines.size(), 1u);
  EXPECT_TRUE(Trace(peak, { 2.0 }).Lines.empty()); // the isoline shrinks to the vertex
}

TEST(Isolines, EndWhereNothingIsReached)
{
  const SurfaceMesh mesh = Build(Plane(10, 10, 0.2));
  ExactOptions options;
  options.KeepWindows = true;
  options.MaximumDistance = 4.0;
  ExactResult limited;
  ASSERT_TRUE(ExactGeodesics(mesh).Run({ VertexSource(60) }, options, limited).IsOk());
  const DistanceField field{ &mesh, limited.Distances.data(), &limited.Windows, nullptr };
  const std::vector<double> levels{ 1.0, 2.0, 3.0, 3.9 };
  const Isolines lines = Trace(field, levels);
  EXPECT_GE(lines.Lines.size(), 4u);
  EXPECT_FALSE(AllClosed(lines));
  ExpectSound(field, levels, lines, "limited");
}

/// Fronts that are about to meet or have just met, in strips narrower than the sampling lattice of
/// isolines: pairs of sources in a face, slightly more or less than two radii apart.
TEST(Isolines, LoopsAroundManySourcesThatMeetInAFace)
{
  const SurfaceMesh mesh = Build(SingleTriangle());
  constexpr double radius = 0.01;
  for (const double gap : { -1e-2, -1e-3, 1e-3, 1e-2 })
  {
    Random random(3);
    std::vector<GeodesicSource> sources;
    for (int i = 1; i < 16; ++i)
    {
      for (int j = 1; i + j < 16; ++j)
      {
        // The corners are at (0, 0), (4, 0) and (1, 3).
        const double angle = random.Uniform(0.0, Pi);
        for (const double side : { 1.0 + 0.5 * gap, -1.0 - 0.5 * gap })
        {
          const double x = side * radius * std::cos(angle);
          const double y = side * radius * std::sin(angle);
          const double t = j / 16.0 + y / 3.0;
          const double s = i / 16.0 + 0.25 * (x - y / 3.0);
          sources.push_back(FaceSourceAt(mesh, 0, { { 1.0 - s - t, s, t } }));
        }
      }
    }
    const ExactField field(mesh, sources);
    const Isolines lines = Trace(field.Exact, { radius });
    EXPECT_TRUE(AllClosed(lines));
    EXPECT_EQ(lines.Lines.size(), gap > 0.0 ? sources.size() : sources.size() / 2) << gap;
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

/// Loops around the point of a face that is farthest from its corners.
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
  const double farthest = std::hypot(1.0, y); // distance from the circumcenter
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

/// Loops around points of faces that are farther than the boundary of the face.
TEST(Isolines, LoopsAroundMaximaOfFaces)
{
  constexpr int Steps = 64;
  int maxima = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
  {
    const SurfaceMesh mesh = Build(WithNoise(Icosahedron(), 0.2, seed));
    const ExactField field(mesh, { VertexSource(0) });
    FaceEnvelope envelope(field.Exact);
    for (Id f = 0; f < mesh.GetNumberOfFaces(); ++f)
    {
      envelope.Enter(f);
      double inside = 0.0;
      double around = 0.0;
      for (int i = 0; i <= Steps; ++i)
      {
        for (int j = 0; i + j <= Steps; ++j)
        {
          const double a = static_cast<double>(i) / Steps;
          const double b = static_cast<double>(j) / Steps;
          double& farthest = i == 0 || j == 0 || i + j == Steps ? around : inside;
          farthest = std::max(farthest, envelope.At(envelope.PlaceOf({ { a, b, 1.0 - a - b } })));
        }
      }
      if (inside > around + 0.01)
      {
        ++maxima;
        const Isolines lines = Trace(field.Exact, { inside - 0.001 });
        EXPECT_TRUE(std::any_of(lines.Lines.begin(), lines.Lines.end(),
          [f](const SurfacePath& l) {
            return std::all_of(l.Faces.begin(), l.Faces.end(), [f](Id face) { return face == f; });
          }))
          << seed << " " << f;
      }
    }
  }
  EXPECT_GT(maxima, 5);
}

TEST(Isolines, DoNotRunBack)
{
  const TestMesh test = WithNoise(Ellipsoid(4, 0.5), 0.01, 3);
  const SurfaceMesh mesh = Build(test);
  const ExactField field(mesh, { VertexSource(11) });
  const double least = 1e-7 * mesh.GetMeanEdgeLength();
  const Isolines lines =
    Trace(field.Exact, EvenLevels(field.Exact, 20), 1e-4 * mesh.GetMeanEdgeLength());
  for (const SurfacePath& line : lines.Lines)
  {
    for (std::size_t i = 1; i + 1 < line.Points.size(); ++i)
    {
      const auto a = PositionOf(mesh, line.Points[i - 1], test.Points.data());
      const auto b = PositionOf(mesh, line.Points[i], test.Points.data());
      const auto c = PositionOf(mesh, line.Points[i + 1], test.Points.data());
      double product = 0.0;
      for (int k = 0; k < 3; ++k)
      {
        product += (b[k] - a[k]) * (c[k] - b[k]);
      }
      const double before = MeasurePiece(mesh, line, i - 1);
      const double after = MeasurePiece(mesh, line, i);
      EXPECT_TRUE(std::min(before, after) < least || product > -0.994 * before * after);
    }
  }
}

TEST(Isolines, WithoutWindowsThereAreHardlyMoreLoops)
{
  // Edges that detected crests of a wave from an adjacent face had spurious loops around them.
  // Surplus and missing loops are counted separately, so that meshes cannot compensate each other.
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
