// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Ridges of distances: known ridges, no false ridges, and completeness.
#include "FieldChecks.h"
#include "GeodesicChecks.h"
#include "GraphChecks.h"
#include "TestMeshes.h"

#include "dggDistanceField.h"
#include "dggFaceEnvelope.h"
#include "dggFieldJumps.h"
#include "dggRidges.h"

using namespace dgg;
using namespace dggtest;

namespace
{
constexpr double Degree = Pi / 180.0;

/// Exact distances and their ridges.
struct RidgeCase : FieldCase
{
  RidgeCase(const TestMesh& test, const std::vector<GeodesicSource>& sources, double angle = 20.0,
    bool withWindows = true)
    : FieldCase(test, sources)
    , Test(test)
    , Field(withWindows ? this->Exact : this->Local)
  {
    this->Options.MinimumAngle = angle * Degree;
    EXPECT_TRUE(Ok(FindRidges(this->Field, this->Options, {}, {}, this->Found)));
    EXPECT_EQ(this->Found.Lines.size(), this->Found.Angles.size());
    for (std::size_t i = 0; i < this->Found.Lines.size(); ++i)
    {
      EXPECT_TRUE(Ok(CheckPath(this->Mesh, this->Found.Lines[i])));
      EXPECT_GE(this->Found.Lines[i].Points.size(), 2u);
      EXPECT_GE(this->Found.Angles[i], 0.999 * std::max(withWindows ? 0.1 : 10.0, angle) * Degree);
    }
  }

  std::array<double, 3> At(const SurfacePoint& point) const
  {
    return PositionOf(this->Mesh, point, this->Test.Points.data());
  }
  double DistanceTo(const SurfacePoint& point, Id v) const
  {
    const std::array<double, 3> p = this->At(point);
    const double* q = this->Test.Point(v);
    return std::sqrt((p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1]) +
      (p[2] - q[2]) * (p[2] - q[2]));
  }

  TestMesh Test;
  DistanceField Field;
  RidgeOptions Options;
  Ridges Found;
};

bool IsOnBoundary(const SurfaceMesh& mesh, const SurfacePoint& point)
{
  return point.On == SurfacePoint::Support::Vertex
    ? mesh.Kind(point.Vertex) == VertexKind::Boundary
    : point.On == SurfacePoint::Support::Edge && mesh.Twin(point.HalfEdge) == NoId;
}

double TotalLength(const Ridges& ridges)
{
  double sum = 0.0;
  for (const SurfacePath& line : ridges.Lines)
  {
    sum += line.Length;
  }
  return sum;
}

/// Returns the end points of a piece of a line in the frame of its face.
std::array<Point2, 2> PlaceOfPiece(
  const SurfaceMesh& mesh, const FaceEnvelope& envelope, const SurfacePath& line, std::size_t piece)
{
  std::array<Point2, 2> ends;
  for (std::size_t i = 0; i < 2; ++i)
  {
    std::array<double, 3> b{};
    EXPECT_TRUE(FindInFace(mesh, line.Points[piece + i], line.Faces[piece], b));
    ends[i] = envelope.PlaceOf(b);
  }
  return ends;
}

double DistanceToPiece(const std::array<Point2, 2>& piece, const Point2& p)
{
  const Point2 way = Difference(piece[1], piece[0]);
  const double square = Dot(way, way);
  const double t =
    square > 0.0 ? std::min(1.0, std::max(0.0, Dot(way, Difference(p, piece[0])) / square)) : 0.0;
  return Distance(p, { piece[0].X + t * way.X, piece[0].Y + t * way.Y });
}

bool IsInside(const FaceEnvelope& envelope, const Point2& p)
{
  const std::array<double, 3> b = envelope.BarycentricOf(p);
  return std::min({ b[0], b[1], b[2] }) > 0.0;
}

/// Expects the directions on both sides of each piece inside a face to differ by the minimum angle,
/// and points inside faces to have equal distances from both sources up to rounding, with few
/// exceptions. Returns the number of tested pieces.
int ExpectTies(const RidgeCase& test, double share, const std::string& what)
{
  FaceEnvelope envelope(test.Field);
  const double mean = test.Mesh.GetMeanEdgeLength();
  int count = 0;
  int wrong = 0;
  int apart = 0;
  double farthest = 0.0;
  for (const SurfacePath& line : test.Found.Lines)
  {
    for (std::size_t i = 0; i < line.Faces.size(); ++i)
    {
      envelope.Enter(line.Faces[i]);
      const std::array<Point2, 2> piece = PlaceOfPiece(test.Mesh, envelope, line, i);
      const Point2 way = Difference(piece[1], piece[0]);
      const double length = Norm(way.X, way.Y);
      auto across = [&](const Point2& p, double distance) {
        return Point2{ p.X - distance * way.Y / length, p.Y + distance * way.X / length };
      };
      const double side = 2e-3 * mean; // twice the tolerance
      const Point2 middle{ 0.5 * (piece[0].X + piece[1].X), 0.5 * (piece[0].Y + piece[1].Y) };
      const Point2 left = across(middle, side);
      const Point2 right = across(middle, -side);
      if (length < 4.0 * side || !IsInside(envelope, left) || !IsInside(envelope, right))
      {
        continue;
      }
      ++count;
      wrong += AngleBetween(envelope.SampleAt(left), envelope.SampleAt(right)) <
          0.7 * test.Options.MinimumAngle
        ? 1
        : 0;
      if (i > 0 && line.Points[i].On == SurfacePoint::Support::Face)
      {
        const FieldSample atLeft = envelope.SampleAt(across(piece[0], 1e-4 * mean));
        const FieldSample atRight = envelope.SampleAt(across(piece[0], -1e-4 * mean));
        const double difference =
          DistanceFromSource(atLeft, piece[0]) - DistanceFromSource(atRight, piece[0]);
        apart += std::abs(difference) > 1e-12 * (atLeft.Distance + mean) ? 1 : 0;
        farthest = std::max(farthest, std::abs(difference) / mean);
      }
    }
  }
  EXPECT_LE(wrong, share * count) << what << ": " << wrong << " of " << count;
  // Where ridges meet, other sources may be nearest on the two sides.
  EXPECT_LE(apart, 1 + 0.03 * count) << what << ": " << apart << " of " << count;
  EXPECT_LT(farthest, 1e-4) << what;
  return count;
}

/// Expects jumps of the direction on random segments in faces to lie on lines. Returns the number
/// of jumps.
int ExpectComplete(const RidgeCase& test, double share, std::uint64_t seed, const std::string& what)
{
  std::vector<std::vector<std::pair<std::size_t, std::size_t>>> piecesOf(
    test.Mesh.GetNumberOfFaces());
  for (std::size_t l = 0; l < test.Found.Lines.size(); ++l)
  {
    for (std::size_t i = 0; i < test.Found.Lines[l].Faces.size(); ++i)
    {
      piecesOf[test.Found.Lines[l].Faces[i]].push_back({ l, i });
    }
  }
  FaceEnvelope envelope(test.Field);
  const FieldJumpFinder finder(envelope, 1.3 * test.Options.MinimumAngle);
  Random random(seed);
  int count = 0;
  int missing = 0;
  const double close = 2e-2 * test.Mesh.GetMeanEdgeLength();
  for (Id f = 0; f < test.Mesh.GetNumberOfFaces(); ++f)
  {
    if (!test.Field.IsReached(f) || test.Mesh.IsMollified(f))
    {
      continue;
    }
    envelope.Enter(f);
    std::array<Point2, 2> ends;
    for (Point2& end : ends)
    {
      const double u = 0.02 + 0.94 * random.Uniform();
      const double v = (0.98 - u) * random.Uniform() + 0.01;
      end = envelope.PlaceOf({ { 1.0 - u - v, u, v } });
    }
    std::vector<FieldJump> jumps;
    finder.Find(ends[0], ends[1], 8, 1e-10, jumps);
    for (const FieldJump& jump : jumps)
    {
      double nearest = Infinity;
      for (const auto& piece : piecesOf[f])
      {
        nearest = std::min(nearest,
          DistanceToPiece(
            PlaceOfPiece(test.Mesh, envelope, test.Found.Lines[piece.first], piece.second),
            jump.Place));
      }
      ++count;
      missing += nearest > close ? 1 : 0;
    }
  }
  EXPECT_LE(missing, share * count) << what << ": " << missing << " of " << count;
  return count;
}
}

TEST(Ridges, BisectorOfTwoSourcesInThePlane)
{
  for (const bool withWindows : { true, false })
  {
    const Id a = 10;
    const Id b = 52;
    const RidgeCase test(Plane(8, 8, 0.2), { VertexSource(a), VertexSource(b) }, 20.0, withWindows);
    ASSERT_EQ(test.Found.Lines.size(), 1u);
    EXPECT_EQ(test.Found.Fallbacks, 0);
    const SurfacePath& line = test.Found.Lines[0];
    EXPECT_TRUE(IsOnBoundary(test.Mesh, line.Points.front()));
    EXPECT_TRUE(IsOnBoundary(test.Mesh, line.Points.back()));
    for (const SurfacePoint& point : line.Points)
    {
      EXPECT_NEAR(test.DistanceTo(point, a), test.DistanceTo(point, b), 1e-12);
    }
    const std::array<double, 3> p = test.At(line.Points.front());
    const std::array<double, 3> q = test.At(line.Points.back());
    EXPECT_NEAR(line.Length, std::hypot(p[0] - q[0], p[1] - q[1]), 1e-12); // the line is straight
  }
}

TEST(Ridges, HyperbolaOfTwoInitialDistances)
{
  const Id a = 20;
  const Id b = 52;
  const RidgeCase test(Plane(8, 8, 0.2), { VertexSource(a), { VertexSource(b).Point, 1.5 } });
  ASSERT_EQ(test.Found.Lines.size(), 1u);
  for (const SurfacePoint& point : test.Found.Lines[0].Points)
  {
    EXPECT_NEAR(test.DistanceTo(point, a), test.DistanceTo(point, b) + 1.5, 1e-12);
  }
  EXPECT_GT(test.Found.Lines[0].Points.size(), 30u); // the line bends
}

TEST(Ridges, ThreeBisectorsMeetInTheCircumcentre)
{
  const std::vector<Id> sources{ 10, 60, 16 };
  std::vector<GeodesicSource> all;
  for (const Id v : sources)
  {
    all.push_back(VertexSource(v));
  }
  for (const double jitter : { 0.0, 0.2 })
  {
    const RidgeCase test(Plane(8, 8, jitter), all);
    ASSERT_EQ(test.Found.Lines.size(), 3u);
    std::array<double, 3> centre{};
    for (std::size_t i = 0; i < 3; ++i)
    {
      const SurfacePath& line = test.Found.Lines[i];
      const bool isForward = IsOnBoundary(test.Mesh, line.Points.front());
      const SurfacePoint& inner = isForward ? line.Points.back() : line.Points.front();
      EXPECT_TRUE(IsOnBoundary(test.Mesh, isForward ? line.Points.front() : line.Points.back()));
      for (const Id v : sources)
      {
        EXPECT_NEAR(test.DistanceTo(inner, v), test.DistanceTo(inner, sources[0]), 1e-12);
      }
      const std::array<double, 3> p = test.At(inner);
      for (std::size_t c = 0; c < 3 && i > 0; ++c)
      {
        EXPECT_EQ(p[c], centre[c]); // all lines share this point
      }
      centre = p;
    }
  }
}

TEST(Ridges, LinesAlongEdgesAreFound)
{
  // The bisector x = 4 consists of edges, and so does the diagonal.
  const Id n = 8;
  auto vertex = [&](Id i, Id j) { return j * (n + 1) + i; };
  const RidgeCase upright(Plane(n, n), { VertexSource(vertex(2, 3)), VertexSource(vertex(6, 3)) });
  ASSERT_EQ(upright.Found.Lines.size(), 1u);
  EXPECT_NEAR(upright.Found.Lines[0].Length, 8.0, 1e-12);
  for (const SurfacePoint& point : upright.Found.Lines[0].Points)
  {
    EXPECT_EQ(upright.At(point)[0], 4.0);
  }
  for (const bool isUp : { true, false })
  {
    const RidgeCase diagonal(Plane(n, n),
      { VertexSource(isUp ? vertex(2, 5) : vertex(2, 3)),
        VertexSource(isUp ? vertex(5, 2) : vertex(5, 6)) });
    ASSERT_EQ(diagonal.Found.Lines.size(), 1u);
    EXPECT_NEAR(diagonal.Found.Lines[0].Length, std::sqrt(2.0) * 8.0, 1e-12);
  }
}

TEST(Ridges, CubeFromAFaceCentre)
{
  for (const double angle : { 20.0, 0.0 })
  {
    for (const Id k : { 2, 4, 6 })
    {
      const TestMesh cube = Cube(k);
      const RidgeCase test(cube, { VertexSource(VertexAt(cube, 0.5, 0.5, 0.0)) }, angle);
      const Id centre = VertexAt(cube, 0.5, 0.5, 1.0);
      ASSERT_EQ(test.Found.Lines.size(), 4u);
      for (const SurfacePath& line : test.Found.Lines)
      {
        // One edge of the cube and half a diagonal.
        EXPECT_NEAR(line.Length, 1.0 + std::sqrt(0.5), 1e-9);
        EXPECT_TRUE(IsVertex(line.Points.front()) && IsVertex(line.Points.back()));
        EXPECT_TRUE(line.Points.front().Vertex == centre || line.Points.back().Vertex == centre);
        for (const SurfacePoint& point : line.Points)
        {
          const std::array<double, 3> p = test.At(point);
          EXPECT_NEAR(std::abs(p[0] - 0.5), std::abs(p[1] - 0.5), 1e-12);
        }
      }
    }
  }
}

TEST(Ridges, CubeFromACorner)
{
  const TestMesh cube = Cube(3, 0.2);
  const RidgeCase test(cube, { VertexSource(VertexAt(cube, 0.0, 0.0, 0.0)) }, 2.0);
  // The lines start at the six corners that are neither the source nor opposite to it: three edges,
  // three diagonals.
  ASSERT_EQ(test.Found.Lines.size(), 6u);
  EXPECT_NEAR(TotalLength(test.Found), 3.0 + 3.0 * std::sqrt(2.0), 1e-9);
}

TEST(Ridges, ConesHaveOneUnlessTheyAreSaddles)
{
  for (const double jitter : { 0.0, 0.2 })
  {
    for (const double total : { 2.0, 4.0, 6.0 })
    {
      std::vector<ConePoint> coordinates;
      const TestMesh cone = Cone(total, 12, 5, coordinates, jitter);
      const Id source = 20;
      const RidgeCase test(cone, { VertexSource(source) }, 1.0);
      ASSERT_EQ(test.Found.Lines.size(), 1u) << total;
      const SurfacePath& line = test.Found.Lines[0];
      const bool isForward = IsVertex(line.Points.front()) && line.Points.front().Vertex == 0;
      EXPECT_TRUE(isForward || (IsVertex(line.Points.back()) && line.Points.back().Vertex == 0));
      EXPECT_GT(line.Length, 0.95);
      EXPECT_LT(line.Length, 1.0 + 1e-12);
      if (jitter == 0.0)
      {
        for (const SurfacePoint& point : line.Points)
        {
          // Points lie on the generator opposite to the source; the apex has no angle.
          ASSERT_TRUE(IsVertex(point));
          const double angle = coordinates[point.Vertex].Angle - coordinates[source].Angle;
          EXPECT_TRUE(point.Vertex == 0 ||
            std::abs(std::abs(std::remainder(angle, total)) - 0.5 * total) < 1e-9);
        }
      }
    }
    std::vector<ConePoint> coordinates;
    const RidgeCase saddle(Cone(8.0, 12, 5, coordinates, jitter), { VertexSource(20) }, 1.0);
    EXPECT_TRUE(saddle.Found.Lines.empty());
  }
}

TEST(Ridges, PrismHasTheOppositeLine)
{
  for (const auto& [angle, jitter] : std::vector<std::pair<double, double>>{
         { 20.0, 0.0 }, { 20.0, 0.2 }, { 0.0, 0.0 }, { 0.0, 0.2 } })
  {
    const RidgeCase test(PrismSide(6, 2, 6, jitter), { VertexSource(40) }, angle);
    ASSERT_EQ(test.Found.Lines.size(), 1u);
    EXPECT_NEAR(test.Found.Lines[0].Length, 6.0, 1e-9);
    const double* source = test.Test.Point(40);
    for (const SurfacePoint& point : test.Found.Lines[0].Points)
    {
      EXPECT_NEAR(test.At(point)[0], -source[0], 1e-9);
      EXPECT_NEAR(test.At(point)[1], -source[1], 1e-9);
    }
  }
}

TEST(Ridges, AreTiesAndComplete)
{
  int ties = 0;
  int jumps = 0;
  for (const NamedMesh& named : SoundMeshes())
  {
    const RidgeCase test(named.Mesh, { VertexSource(0) });
    ties += ExpectTies(test, 0.0, named.Name);
    jumps += ExpectComplete(test, 0.0, 7, named.Name);
  }
  EXPECT_GT(ties, 300);
  EXPECT_GT(jumps, 100);
}

TEST(Ridges, OfSmallAnglesAreTiesAndComplete)
{
  for (const TestMesh& mesh : { Icosphere(3), NoisySphere(3, 0.2, 3), Torus(16, 10) })
  {
    const RidgeCase test(mesh, { VertexSource(3) }, 4.0);
    EXPECT_GT(ExpectTies(test, 0.0, "small"), 100);
    EXPECT_GT(ExpectComplete(test, 0.0, 7, "small"), 15);
  }
}

TEST(Ridges, OfVirtualSourcesAreCloseToThoseOfWindows)
{
  const TestMesh mesh = Torus(32, 18);
  const RidgeCase exact(mesh, { VertexSource(3) });
  const RidgeCase local(mesh, { VertexSource(3) }, 20.0, false);
  EXPECT_NEAR(TotalLength(local.Found), TotalLength(exact.Found), 0.35 * TotalLength(exact.Found));
}

TEST(Ridges, DefectsAreSurvived)
{
  for (const NamedMesh& named : DefectMeshes())
  {
    SCOPED_TRACE(named.Name);
    for (const bool withWindows : { true, false })
    {
      for (const double angle : { 20.0, 1.0 })
      {
        const RidgeCase test(named.Mesh, { VertexSource(0) }, angle, withWindows);
      }
    }
  }
}

TEST(Ridges, OfRoundingAloneComeToAnEnd)
{
  // At such distances from the sources, gradients consist of rounding errors or values overflow.
  const SurfaceMesh mesh = Build(Plane(3, 3));
  for (const double far : { 1e17, 1.7e308 })
  {
    Random random(3);
    std::vector<double> values;
    VirtualSources sources;
    for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
    {
      const bool isFar = far > 1e300;
      values.push_back(isFar ? far * random.Uniform(-1.0, 1.0) : random.Uniform(0.0, 2.0));
      const double length = isFar ? random.Uniform(0.0, 2.0) : far;
      sources.push_back({ values.back() - length, length, random.Uniform(0.0, 6.0) });
    }
    Ridges ridges;
    const DistanceField field{ &mesh, values.data(), nullptr, &sources };
    EXPECT_TRUE(FindRidges(field, {}, {}, {}, ridges).IsOk());
    EXPECT_TRUE(far > 1e300 || ridges.Fallbacks > 0);
    for (const SurfacePath& line : ridges.Lines)
    {
      EXPECT_TRUE(Ok(CheckPath(mesh, line)));
    }
  }
}
