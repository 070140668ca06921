// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Isolines: at their level, continuous, complete.
#include "CurvedMeshes.h"
#include "DefectMeshes.h"
#include "FieldChecks.h"
#include "FlatMeshes.h"
#include "GeodesicChecks.h"
#include "GraphChecks.h"

#include "dggEdges.h"
#include "dggFaceProfile.h"
#include "dggIsolines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

using namespace dgg;
using namespace dggtest;

namespace
{
Isolines Trace(const DistanceField& field, const std::vector<double>& levels,
  double tolerance = 0.0, IsolineMethod method = IsolineMethod::LocalSources)
{
  IsolineOptions options;
  options.Method = method;
  options.ChordTolerance = tolerance;
  Isolines lines;
  const Status status = TraceIsolines(field, levels, options, nullptr, nullptr, lines);
  EXPECT_TRUE(status.IsOk()) << status.GetMessage();
  EXPECT_EQ(lines.Lines.size(), lines.Levels.size());
  EXPECT_EQ(lines.Lines.size(), lines.IsClosed.size());
  return lines;
}

/// `count` levels between the least and the largest distance.
std::vector<double> EvenLevels(const DistanceField& field, Id count)
{
  double least = Infinity;
  double largest = -Infinity;
  for (Id v = 0; v < field.Mesh->GetNumberOfVertices(); ++v)
  {
    if (field.Distances[v] < Infinity)
    {
      least = std::min(least, field.Distances[v]);
      largest = std::max(largest, field.Distances[v]);
    }
  }
  std::vector<double> levels;
  for (Id i = 0; i < count; ++i)
  {
    levels.push_back(least + (largest - least) * (i + 0.5) / count);
  }
  return levels;
}

/// Edges with two faces that are reached conduct isolines; they end on others.
bool Conducts(const DistanceField& field, Id h)
{
  const Id twin = field.Mesh->Twin(h);
  return twin != NoId && field.Mesh->Twin(twin) == h && field.IsReached(SurfaceMesh::Face(h)) &&
    field.IsReached(SurfaceMesh::Face(twin));
}

/// All edges around the vertex.
template <typename Predicate>
bool AllAround(const SurfaceMesh& mesh, Id v, Predicate&& holds)
{
  for (const Id* g = mesh.FanBegin(v); g != mesh.FanEnd(v); ++g)
  {
    if (!holds(*g) || !holds(SurfaceMesh::Previous(*g)))
    {
      return false;
    }
  }
  return true;
}

/// What holds for isolines of any field on any mesh: they lie on the surface, end nowhere but where
/// the surface does, and miss no edge.
void ExpectSound(const DistanceField& field, const std::vector<double>& levels,
  const Isolines& lines, const std::string& what)
{
  const SurfaceMesh& mesh = *field.Mesh;
  std::set<std::pair<Id, Id>> crossed; // edges and levels
  std::set<std::pair<Id, Id>> touched; // vertices and levels
  for (std::size_t i = 0; i < lines.Lines.size(); ++i)
  {
    const SurfacePath& line = lines.Lines[i];
    ASSERT_GE(line.Points.size(), 2u) << what;
    const Status status = CheckPath(mesh, line);
    ASSERT_TRUE(status.IsOk()) << what << ", line " << i << ": " << status.GetMessage();
    for (std::size_t p = 0; p < line.Points.size(); ++p)
    {
      const SurfacePoint& point = line.Points[p];
      EXPECT_TRUE(point.Check(mesh).IsOk()) << what;
      EXPECT_TRUE(p == 0 || !IsSamePoint(line.Points[p - 1], point)) << what;
      if (point.On == SurfacePoint::Support::Edge)
      {
        crossed.insert({ FindEdge(mesh, point.HalfEdge), lines.Levels[i] });
      }
      if (point.On == SurfacePoint::Support::Vertex)
      {
        touched.insert({ point.Vertex, lines.Levels[i] });
      }
    }
    for (const Id f : line.Faces)
    {
      EXPECT_TRUE(field.IsReached(f)) << what;
    }
    if (lines.IsClosed[i])
    {
      EXPECT_TRUE(IsSamePoint(line.Points.front(), line.Points.back())) << what;
      continue;
    }
    for (const SurfacePoint* end : { &line.Points.front(), &line.Points.back() })
    {
      ASSERT_NE(end->On, SurfacePoint::Support::Face) << what << ", line " << i;
      if (end->On == SurfacePoint::Support::Edge)
      {
        EXPECT_FALSE(Conducts(field, end->HalfEdge)) << what << ", line " << i;
      }
      else
      {
        EXPECT_FALSE(AllAround(mesh, end->Vertex, [&](Id h) { return Conducts(field, h); }))
          << what << ", line " << i;
      }
    }
  }
  for (Id h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
  {
    if (!field.IsReached(SurfaceMesh::Face(h)))
    {
      continue;
    }
    const double a = field.Distances[mesh.Origin(h)];
    const double b = field.Distances[mesh.Destination(h)];
    for (std::size_t k = 0; k < levels.size(); ++k)
    {
      const Id level = static_cast<Id>(k);
      const double close = 1e-8 * mesh.Length(h); // lines may shrink to a vertex of that level
      if ((a < levels[k]) != (b < levels[k]) && std::abs(a - levels[k]) > close &&
        std::abs(b - levels[k]) > close)
      {
        EXPECT_TRUE(crossed.count({ FindEdge(mesh, h), level }) != 0 ||
          touched.count({ mesh.Origin(h), level }) != 0 ||
          touched.count({ mesh.Destination(h), level }) != 0)
          << what << ": edge " << h << ", level " << levels[k];
      }
    }
  }
}

/// The points of all lines, with their levels.
struct LevelPoints
{
  LevelPoints(const Isolines& lines, const std::vector<double>& levels)
  {
    for (std::size_t i = 0; i < lines.Lines.size(); ++i)
    {
      for (const SurfacePoint& point : lines.Lines[i].Points)
      {
        this->Points.push_back(point);
        this->Levels.push_back(levels[lines.Levels[i]]);
      }
    }
  }

  std::vector<SurfacePoint> Points;
  std::vector<double> Levels;
};

/// An exact run to all points of the lines finds them at their level.
void ExpectAtLevel(const SurfaceMesh& mesh, const std::vector<GeodesicSource>& sources,
  const std::vector<double>& levels, const Isolines& lines, double tolerance,
  const std::string& what)
{
  const LevelPoints points(lines, levels);
  ASSERT_FALSE(points.Points.empty()) << what;
  const ExactField truth(mesh, sources, points.Points);
  for (std::size_t i = 0; i < points.Points.size(); ++i)
  {
    // Points within 1e-9 of a vertex are moved to it.
    const double slack =
      points.Points[i].On == SurfacePoint::Support::Face ? 0.0 : 2e-9 * mesh.GetMaximumEdgeLength();
    EXPECT_NEAR(truth.Result.TargetDistances[i], points.Levels[i],
      tolerance * std::max(1.0, std::abs(points.Levels[i])) + slack)
      << what << ", point " << i;
  }
}

std::map<Id, int> LinesPerLevel(const Isolines& lines)
{
  std::map<Id, int> counts;
  for (const Id level : lines.Levels)
  {
    ++counts[level];
  }
  return counts;
}

bool AllClosed(const Isolines& lines)
{
  return std::all_of(lines.IsClosed.begin(), lines.IsClosed.end(), [](bool is) { return is; });
}

std::array<double, 3> Middle(const std::array<double, 3>& a, const std::array<double, 3>& b)
{
  return { { 0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]), 0.5 * (a[2] + b[2]) } };
}

double DistanceTo(const std::array<double, 3>& p, double x, double y)
{
  return std::hypot(p[0] - x, p[1] - y);
}

double TotalLength(const Isolines& lines)
{
  double sum = 0.0;
  for (const SurfacePath& line : lines.Lines)
  {
    sum += line.Length;
  }
  return sum;
}

GeodesicSource FaceSourceAt(
  const SurfaceMesh& mesh, Id face, const std::array<double, 3>& barycentric)
{
  return { SurfacePoint::InFace(mesh, face, barycentric), 0.0 };
}

/// How far the middles of pieces are from their levels, on average along all lines.
double MeanErrorOfPieces(const SurfaceMesh& mesh, const std::vector<GeodesicSource>& sources,
  const std::vector<double>& levels, const Isolines& lines)
{
  std::vector<SurfacePoint> middles;
  std::vector<double> values;
  std::vector<double> lengths;
  for (std::size_t i = 0; i < lines.Lines.size(); ++i)
  {
    const SurfacePath& line = lines.Lines[i];
    for (std::size_t p = 0; p < line.Faces.size(); ++p)
    {
      std::array<double, 3> a{};
      std::array<double, 3> b{};
      EXPECT_TRUE(FindInFace(mesh, line.Points[p], line.Faces[p], a));
      EXPECT_TRUE(FindInFace(mesh, line.Points[p + 1], line.Faces[p], b));
      std::array<double, 3> middle = Middle(a, b);
      if (mesh.IsFlipped(line.Faces[p]))
      {
        std::swap(middle[1], middle[2]);
      }
      middles.push_back(SurfacePoint::InFace(mesh, line.Faces[p], middle));
      values.push_back(levels[lines.Levels[i]]);
      lengths.push_back(MeasurePiece(mesh, line, p));
    }
  }
  const ExactField truth(mesh, sources, middles);
  double sum = 0.0;
  for (std::size_t i = 0; i < middles.size(); ++i)
  {
    sum += lengths[i] * std::abs(truth.Result.TargetDistances[i] - values[i]);
  }
  return sum / std::accumulate(lengths.begin(), lengths.end(), 0.0);
}

void ExpectSameLines(const Isolines& a, const Isolines& b, const std::string& what)
{
  ASSERT_EQ(a.Lines.size(), b.Lines.size()) << what;
  EXPECT_EQ(a.Levels, b.Levels) << what;
  EXPECT_EQ(a.IsClosed, b.IsClosed) << what;
  EXPECT_EQ(a.Fallbacks, b.Fallbacks) << what;
  for (std::size_t i = 0; i < a.Lines.size(); ++i)
  {
    EXPECT_EQ(a.Lines[i].Faces, b.Lines[i].Faces) << what;
    ASSERT_EQ(a.Lines[i].Points.size(), b.Lines[i].Points.size()) << what;
    for (std::size_t p = 0; p < a.Lines[i].Points.size(); ++p)
    {
      EXPECT_EQ(a.Lines[i].Points[p].Barycentric, b.Lines[i].Points[p].Barycentric) << what;
      EXPECT_TRUE(IsSamePoint(a.Lines[i].Points[p], b.Lines[i].Points[p])) << what;
    }
  }
}
}

TEST(Isolines, AreCirclesInThePlane)
{
  const TestMesh test = Plane(9, 9, 0.25);
  const SurfaceMesh mesh = Build(test);
  const Id source = 4 * 10 + 5;
  const ExactField field(mesh, { VertexSource(source) });
  const double x = test.Point(source)[0];
  const double y = test.Point(source)[1];
  const std::vector<double> levels{ 0.01, 0.3, 1.0, 1.7, 2.9, 3.4 };
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
        double turn = 0.0;
        for (std::size_t p = 0; p + 1 < line.Points.size(); ++p)
        {
          const auto a = PositionOf(mesh, line.Points[p], test.Points.data());
          const auto b = PositionOf(mesh, line.Points[p + 1], test.Points.data());
          EXPECT_NEAR(DistanceTo(a, x, y), level, 1e-12);
          EXPECT_NEAR(DistanceTo(Middle(a, b), x, y), level, 1.001 * tolerance);
          turn += std::atan2((a[0] - x) * (b[1] - y) - (a[1] - y) * (b[0] - x),
            (a[0] - x) * (b[0] - x) + (a[1] - y) * (b[1] - y));
        }
        EXPECT_NEAR(turn, 2.0 * Pi, 1e-9) << "what is nearer is on the left";
      }
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
      // Where the models of corners differ by what is missing, a corner may be just beside.
      EXPECT_LE(corners, lines.Levels[i] == 0 ? 0 : 2);
      EXPECT_GE(corners, lines.Levels[i] == 0 ? 0 : f == &field.Exact ? 2 : 1);
    }
  }
}

/// Between two waves that are about to meet there is a strip as narrow as can be.
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

TEST(Isolines, AreAtTheirLevelOnCones)
{
  for (const double total : { 1.3 * Pi, 1.8 * Pi, 2.6 * Pi })
  {
    std::vector<ConePoint> coordinates;
    const SurfaceMesh mesh = Build(Cone(total, 9, 6, coordinates, 0.2, 3));
    const std::vector<GeodesicSource> sources{ VertexSource(20) };
    const ExactField field(mesh, sources);
    const std::vector<double> levels = EvenLevels(field.Exact, 15);
    const Isolines lines = Trace(field.Exact, levels);
    const std::string what = "cone of " + std::to_string(total);
    ExpectSound(field.Exact, levels, lines, what);
    ExpectAtLevel(mesh, sources, levels, lines, 1e-12, what);
    EXPECT_EQ(lines.Fallbacks, 0) << what;
  }
}

TEST(Isolines, AreAtTheirLevelOnACube)
{
  const SurfaceMesh mesh = Build(Cube(4, 0.2, 5));
  const std::vector<GeodesicSource> sources{ FaceSourceAt(mesh, 5, { { 0.3, 0.3, 0.4 } }) };
  const ExactField field(mesh, sources);
  const std::vector<double> levels = EvenLevels(field.Exact, 20);
  const Isolines lines = Trace(field.Exact, levels);
  ExpectSound(field.Exact, levels, lines, "cube");
  ExpectAtLevel(mesh, sources, levels, lines, 1e-12, "cube");
  EXPECT_TRUE(AllClosed(lines));
  EXPECT_EQ(lines.Fallbacks, 0);
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

/// Chords as well, not points alone.
TEST(Isolines, AreAsCloseAsWished)
{
  const SurfaceMesh mesh = Build(Terrain(14, 0.6, 3));
  const ExactField field(mesh, { VertexSource(0) });
  const std::vector<double> levels = EvenLevels(field.Exact, 12);
  const double tolerance = 1e-4 * mesh.GetMeanEdgeLength();
  for (const DistanceField* f : { &field.Exact, &field.Linear })
  {
    const Isolines lines = Trace(*f, levels, tolerance);
    FaceProfile profile(*f);
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
        profile.Enter(line.Faces[p]);
        const double d = profile.At(profile.PlaceOf(Middle(a, b)));
        far += std::abs(d - levels[lines.Levels[i]]) > 1.5 * tolerance ? 1 : 0;
        ++all;
      }
    }
    EXPECT_LE(far, lines.Fallbacks + all / 1000) << all;
  }
}

/// At ridges isolines have long tips, and what is farther away than a level may be a narrow strip.
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

TEST(Isolines, AreSingleLoopsOnSpheres)
{
  const SurfaceMesh mesh = Build(Icosphere(3));
  const ExactField field(mesh, { VertexSource(7) });
  const std::vector<double> levels{ 0.2, 0.5, 1.0, 1.5, 2.0, 2.5, 2.9 };
  for (const DistanceField* f : { &field.Exact, &field.Local, &field.Linear })
  {
    const Isolines lines = Trace(*f, levels);
    EXPECT_EQ(lines.Lines.size(), levels.size());
    EXPECT_TRUE(AllClosed(lines));
    ExpectSound(*f, levels, lines, "sphere");
    for (std::size_t i = 0; i < lines.Lines.size(); ++i)
    {
      const double length = 2.0 * Pi * std::sin(levels[lines.Levels[i]]);
      EXPECT_NEAR(lines.Lines[i].Length, length, 0.05 * length + 0.1);
    }
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

TEST(Isolines, AreSoundOnAllMeshes)
{
  std::vector<NamedMesh> meshes = SoundMeshes();
  for (NamedMesh& named : DefectMeshes())
  {
    meshes.push_back(std::move(named));
  }
  for (const NamedMesh& named : meshes)
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
      sources.Lengths.push_back(random.Uniform(0.0, 2.0));
      sources.Offsets.push_back(values.back() - sources.Lengths.back());
      sources.Angles.push_back(random.Uniform(-9.0, 9.0));
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

TEST(Isolines, LoopsAroundManySourcesInAFace)
{
  const TestMesh test = SingleTriangle();
  const SurfaceMesh mesh = Build(test);
  std::vector<GeodesicSource> sources;
  double nearest = Infinity; // to one another
  for (int i = 1; i < 20; ++i)
  {
    for (int j = 1; i + j < 20; ++j)
    {
      sources.push_back(FaceSourceAt(mesh, 0, { { i / 20.0, j / 20.0, (20 - i - j) / 20.0 } }));
      // Starts too late to be nearest anywhere.
      const std::array<double, 3> beside{ { (i + 0.1) / 20.0, j / 20.0, (19.9 - i - j) / 20.0 } };
      sources.push_back(FaceSourceAt(mesh, 0, beside));
      sources.back().InitialDistance = 0.2;
    }
  }
  for (std::size_t i = 2; i < sources.size(); i += 2)
  {
    nearest = std::min(
      nearest, DistanceInFace(mesh, 0, sources[0].Point.Barycentric, sources[i].Point.Barycentric));
  }
  sources.push_back(sources[0]); // again
  const ExactField field(mesh, sources);
  EXPECT_EQ(field.Result.Windows.Sources.size(), 171u);
  const std::vector<double> levels{ 0.1 * nearest, 0.3 * nearest };
  const Isolines lines = Trace(field.Exact, levels, 1e-5);
  EXPECT_EQ(lines.Lines.size(), 2u * 171);
  EXPECT_TRUE(AllClosed(lines));
  EXPECT_EQ(lines.Fallbacks, 0);
  for (std::size_t i = 0; i < lines.Lines.size(); ++i)
  {
    const double radius = levels[lines.Levels[i]];
    EXPECT_NEAR(lines.Lines[i].Length, 2.0 * Pi * radius, 0.1 * radius);
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

TEST(Isolines, LoopsAroundFarthestPointsInFacesAreFound)
{
  // A third wave may be the last to come to the middle of a face of two others.
  for (std::uint64_t seed = 0; seed < 40; ++seed)
  {
    const SurfaceMesh mesh = Build(WithNoise(Icosahedron(), 0.15, seed));
    const ExactField field(mesh, { VertexSource(0) });
    FaceProfile profile(field.Exact);
    double farthest = 0.0;
    for (Id f = 0; f < mesh.GetNumberOfFaces(); ++f)
    {
      profile.Enter(f);
      for (int i = 0; i <= 60; ++i)
      {
        for (int j = 0; i + j <= 60; ++j)
        {
          farthest = std::max(
            farthest, profile.At(profile.PlaceOf({ { i / 60.0, j / 60.0, (60 - i - j) / 60.0 } })));
        }
      }
    }
    for (const double below : { 0.005, 0.02, 0.1 })
    {
      const Isolines lines = Trace(field.Exact, { farthest - below * mesh.GetMeanEdgeLength() });
      EXPECT_GE(lines.Lines.size(), 1u) << seed << " " << below;
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
    EXPECT_EQ(counts[0], 0); // nothing is nearer
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
  step[3] = 2.0; // the only one above
  const DistanceField peak{ &mesh, step.data(), nullptr, nullptr };
  EXPECT_TRUE(Trace(peak, { 1.0 }).Lines.empty());
  EXPECT_EQ(Trace(peak, { 1.5 }).Lines.size(), 1u);
  EXPECT_TRUE(Trace(peak, { 2.0 }).Lines.empty()); // shrunk to the vertex
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

TEST(Isolines, MayBeAskedForInAnyOrder)
{
  const SurfaceMesh mesh = Build(Icosphere(2));
  const ExactField field(mesh, { VertexSource(0) });
  const std::vector<double> levels{ 2.0, 0.5, 1.0, 0.5 };
  const Isolines lines = Trace(field.Exact, levels);
  EXPECT_EQ(lines.Levels, (std::vector<Id>{ 1, 3, 2, 0 }));
  EXPECT_EQ(lines.Lines[0].Points.size(), lines.Lines[1].Points.size());
  EXPECT_LT(lines.Lines[0].Length, lines.Lines[2].Length);
}

TEST(Isolines, DoNotDependOnThreads)
{
  const SurfaceMesh mesh = Build(Terrain(40, 1.0, 3));
  const ExactField field(mesh, { VertexSource(0), VertexSource(800) });
  const std::vector<double> levels = EvenLevels(field.Exact, 20);
  for (const DistanceField* f : { &field.Exact, &field.Local, &field.Linear })
  {
    const Isolines expected = Trace(*f, levels);
    ASSERT_GT(TotalLength(expected), 0.0);
    for (const ParallelFor& parallel :
      { WithThreads(2, 0), WithThreads(7, 0), WithThreads(3, 1), WithThreads(2, 1 << 30) })
    {
      Isolines lines;
      ASSERT_TRUE(TraceIsolines(*f, levels, {}, parallel, nullptr, lines).IsOk());
      ExpectSameLines(expected, lines, "threads");
    }
  }
}

TEST(Isolines, TellProgressAndCanBeStopped)
{
  const SurfaceMesh mesh = Build(Terrain(40, 1.0, 3));
  const ExactField field(mesh, { VertexSource(0) });
  const std::vector<double> levels = EvenLevels(field.Exact, 5);
  std::vector<double> told;
  Isolines lines;
  const auto tell = [&](double done) {
    told.push_back(done);
    return true;
  };
  ASSERT_TRUE(TraceIsolines(field.Exact, levels, {}, nullptr, tell, lines).IsOk());
  EXPECT_GE(told.size(), 4u);
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_EQ(told.back(), 1.0);
  const std::size_t steps = told.size();
  for (std::size_t stop = 1; stop <= steps; ++stop)
  {
    told.clear();
    const auto stopAt = [&](double done) {
      told.push_back(done);
      return told.size() < stop;
    };
    EXPECT_TRUE(TraceIsolines(field.Exact, levels, {}, nullptr, stopAt, lines).IsAborted());
    EXPECT_EQ(told.size(), stop);
    EXPECT_TRUE(lines.Lines.empty());
  }
}

TEST(Isolines, BadArgumentsAreRefused)
{
  const SurfaceMesh mesh = Build(Icosphere(1));
  const ExactField field(mesh, { VertexSource(0) });
  Isolines lines;
  const auto refuses = [&](const DistanceField& f, const std::vector<double>& levels, double t) {
    IsolineOptions options;
    options.ChordTolerance = t;
    const Status status = TraceIsolines(f, levels, options, nullptr, nullptr, lines);
    return status.GetCode() == Status::Code::InvalidInput && lines.Lines.empty();
  };
  EXPECT_FALSE(refuses(field.Exact, { 1.0 }, 0.0));
  EXPECT_TRUE(refuses(field.Exact, { 1.0, Infinity }, 0.0));
  EXPECT_TRUE(refuses(field.Exact, { std::nan("") }, 0.0));
  EXPECT_TRUE(refuses(field.Exact, { 1.0 }, -1.0));
  EXPECT_TRUE(refuses(field.Exact, { 1.0 }, std::nan("")));
  EXPECT_TRUE(refuses({ &mesh, nullptr, nullptr, nullptr }, { 1.0 }, 0.0));
  EXPECT_TRUE(refuses({}, { 1.0 }, 0.0));
}
