// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The published isolines: the pieces in faces.
#include "FieldChecks.h"
#include "GraphChecks.h"
#include "IsolineChecks.h"
#include "TestMeshes.h"

#include "dggApolloniusFace.h"
#include "dggFaceProfile.h"
#include "dggHermiteEdge.h"
#include "dggSourceFinding.h"

#include <algorithm>
#include <cmath>
#include <map>

using namespace dgg;
using namespace dggtest;

namespace
{
struct Parts
{
  Parts(const DistanceField& field, int steinerPoints, const std::vector<double>& levels,
    const ParallelFor& parallel = {})
  {
    LevelCrossings crossings;
    EXPECT_TRUE(
      Ok(FindApolloniusParts(field, steinerPoints, levels, parallel, {}, crossings, this->Curves)));
    this->Crossings = crossings.Crossings;
  }

  std::vector<LevelCrossing> Crossings;
  std::vector<FaceCurve> Curves;
};

/// Coordinates of a crossing in a face.
std::array<double, 3> PlaceIn(const SurfaceMesh& mesh, Id f, const LevelCrossing& crossing)
{
  std::array<double, 3> place{ { 0.0, 0.0, 0.0 } };
  for (int k = 0; k < 3; ++k)
  {
    const Id h = 3 * f + k;
    if (FindEdge(mesh, h) == crossing.HalfEdge)
    {
      const double t = crossing.X / mesh.Length(h);
      const bool isSame = mesh.Origin(h) == mesh.Origin(crossing.HalfEdge);
      place[k] = isSame ? 1.0 - t : t;
      place[(k + 1) % 3] = isSame ? t : 1.0 - t;
    }
  }
  EXPECT_GT(place[0] + place[1] + place[2], 0.5) << "not on the rim";
  return place;
}

std::vector<std::array<double, 3>> PointsOf(
  const SurfaceMesh& mesh, const Parts& parts, const FaceCurve& curve)
{
  std::vector<std::array<double, 3>> points = curve.Points;
  if (curve.First == NoId)
  {
    points.push_back(points.front());
  }
  else
  {
    points.insert(points.begin(), PlaceIn(mesh, curve.Face, parts.Crossings[curve.First]));
    points.push_back(PlaceIn(mesh, curve.Face, parts.Crossings[curve.Last]));
  }
  return points;
}

/// The measure of the thesis: how far the distance at the middles of segments is from the level,
/// relative to it.
struct MidpointError
{
  explicit MidpointError(const DistanceField& exact)
    : Profile(exact)
  {
  }
  void Add(Id f, const std::array<double, 3>& a, const std::array<double, 3>& b, double level)
  {
    this->Profile.Enter(f);
    const std::array<double, 3> middle{ { 0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]),
      0.5 * (a[2] + b[2]) } };
    this->Sum += std::abs(this->Profile.At(this->Profile.PlaceOf(middle)) - level) / level;
    ++this->Count;
  }
  double Mean() const { return this->Sum / static_cast<double>(this->Count); }

  FaceProfile Profile;
  double Sum = 0.0;
  std::size_t Count = 0;
};

double ErrorOf(
  const FieldCase& c, const DistanceField& field, int k, const std::vector<double>& levels)
{
  const Parts parts(field, k, levels);
  MidpointError error(c.Exact);
  for (const FaceCurve& curve : parts.Curves)
  {
    const std::vector<std::array<double, 3>> points = PointsOf(c.Mesh, parts, curve);
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
    {
      error.Add(curve.Face, points[i], points[i + 1], levels[curve.Level]);
    }
  }
  return error.Mean();
}

double LinearError(const FieldCase& c, const std::vector<double>& levels)
{
  MidpointError error(c.Exact);
  for (Id f = 0; f < c.Mesh.GetNumberOfFaces(); ++f)
  {
    for (const double level : levels)
    {
      std::vector<std::array<double, 3>> ends;
      for (int k = 0; k < 3; ++k)
      {
        const double a = c.Result.Distances[c.Mesh.Origin(3 * f + k)];
        const double b = c.Result.Distances[c.Mesh.Destination(3 * f + k)];
        if ((a < level) != (b < level))
        {
          std::array<double, 3> place{ { 0.0, 0.0, 0.0 } };
          place[(k + 1) % 3] = (level - a) / (b - a);
          place[k] = 1.0 - place[(k + 1) % 3];
          ends.push_back(place);
        }
      }
      if (ends.size() == 2)
      {
        error.Add(f, ends[0], ends[1], level);
      }
    }
  }
  return error.Mean();
}

/// Every crossing is an end of one curve in each face that is reached; curves run with the lower
/// side on their left; all points lie in their faces.
void ExpectSound(const DistanceField& field, int k, const std::vector<double>& levels,
  const Parts& parts, const std::string& what)
{
  const SurfaceMesh& mesh = *field.Mesh;
  std::map<std::pair<Id, Id>, int> ends; // face, crossing
  for (const FaceCurve& curve : parts.Curves)
  {
    ASSERT_TRUE(field.IsReached(curve.Face)) << what;
    ASSERT_EQ(curve.First == NoId, curve.Last == NoId) << what;
    if (curve.First == NoId)
    {
      ASSERT_GE(curve.Points.size(), 3u) << what;
    }
    else
    {
      for (const Id end : { curve.First, curve.Last })
      {
        ASSERT_EQ(parts.Crossings[end].Level, curve.Level) << what;
        ++ends[{ curve.Face, end }];
      }
    }
    for (const std::array<double, 3>& p : curve.Points)
    {
      ASSERT_NEAR(p[0] + p[1] + p[2], 1.0, 1e-12) << what;
      ASSERT_GE(std::min(p[0], std::min(p[1], p[2])), -1e-12) << what;
    }
  }
  HermiteEdge edge(field, k);
  for (std::size_t c = 0; c < parts.Crossings.size(); ++c)
  {
    const LevelCrossing& crossing = parts.Crossings[c];
    edge.Enter(crossing.HalfEdge);
    ASSERT_EQ(edge.GetHalfEdge(), crossing.HalfEdge) << what;
    ASSERT_GE(crossing.X, 0.0);
    ASSERT_LE(crossing.X, edge.GetLength());
    Id h = crossing.HalfEdge;
    int faces = 0;
    do
    {
      if (field.IsReached(SurfaceMesh::Face(h)))
      {
        ++faces;
        ASSERT_EQ((ends[{ SurfaceMesh::Face(h), static_cast<Id>(c) }]), 1) << what;
      }
      h = mesh.Twin(h);
    } while (h != NoId && h != crossing.HalfEdge);
    ASSERT_GT(faces, 0) << what;
    // On the interpolant.
    const std::vector<RimNode>& nodes = edge.GetNodes();
    double smallest = Infinity;
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
    {
      const double t = (crossing.X - nodes[i].X) / (nodes[i + 1].X - nodes[i].X);
      if (t > -1e-9 && t < 1.0 + 1e-9)
      {
        smallest = std::min(smallest,
          std::abs((1.0 - t) * nodes[i].Value + t * nodes[i + 1].Value - levels[crossing.Level]));
      }
    }
    ASSERT_LT(smallest, 1e-8 * edge.GetLength()) << what;
  }
  // As many as the signs of the ends say, modulo two.
  std::map<std::pair<Id, Id>, int> counts;
  for (const LevelCrossing& crossing : parts.Crossings)
  {
    ++counts[{ crossing.HalfEdge, crossing.Level }];
  }
  for (Id f = 0; f < mesh.GetNumberOfFaces(); ++f)
  {
    for (Id h = 3 * f; h < 3 * f + 3 && field.IsReached(f); ++h)
    {
      for (std::size_t l = 0; l < levels.size(); ++l)
      {
        const auto count = counts.find({ FindEdge(mesh, h), static_cast<Id>(l) });
        const bool isOdd = count != counts.end() && count->second % 2 == 1;
        ASSERT_EQ(isOdd,
          (field.Distances[mesh.Origin(h)] < levels[l]) !=
            (field.Distances[mesh.Destination(h)] < levels[l]))
          << what;
      }
    }
  }
}

bool IsSame(const Parts& a, const Parts& b)
{
  return !a.Curves.empty() &&
    std::equal(a.Crossings.begin(), a.Crossings.end(), b.Crossings.begin(), b.Crossings.end(),
      [](const LevelCrossing& x, const LevelCrossing& y) {
        return x.HalfEdge == y.HalfEdge && x.X == y.X && x.Level == y.Level;
      }) &&
    std::equal(a.Curves.begin(), a.Curves.end(), b.Curves.begin(), b.Curves.end(),
      [](const FaceCurve& x, const FaceCurve& y) {
        return x.Face == y.Face && x.Level == y.Level && x.First == y.First && x.Last == y.Last &&
          x.Points == y.Points;
      });
}
}

TEST(ApolloniusParts, AreSoundOnAnySurface)
{
  std::size_t curves = 0;
  for (const NamedMesh& named : AllMeshes())
  {
    const SurfaceMesh mesh = Build(named.Mesh);
    const FieldCase c(named.Mesh,
      { VertexSource(0),
        { RandomSurfacePoints(mesh, 3, 11).front(), 0.1 * mesh.GetMeanEdgeLength() } });
    std::vector<double> levels = EvenLevels(c.Exact, 5);
    levels.push_back(0.01 * mesh.GetMeanEdgeLength());
    levels.push_back(c.Result.Distances[mesh.GetNumberOfVertices() / 2]); // through a vertex
    if (!(levels.back() < Infinity))
    {
      levels.pop_back();
    }
    std::sort(levels.begin(), levels.end());
    for (const int k : { 0, 2 })
    {
      for (const DistanceField* field : { &c.Local, &c.ExactWithSources })
      {
        const Parts parts(*field, k, levels);
        ExpectSound(*field, k, levels, parts, named.Name);
        curves += parts.Curves.size();
      }
    }
  }
  EXPECT_GT(curves, 10000u);
}

TEST(ApolloniusParts, AreSoundForFieldsThatAreNoDistances)
{
  const TestMesh test = Icosphere(2);
  const SurfaceMesh mesh = Build(test);
  Random random(3);
  std::vector<double> values;
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    values.push_back(v % 11 == 0 ? Infinity : random.Uniform(0.0, 5.0));
  }
  values[7] = std::nan("");
  VirtualSources fitted;
  FitVirtualSources(mesh, values.data(), {}, fitted);
  const DistanceField field{ &mesh, values.data(), nullptr, &fitted };
  const DistanceField bare{ &mesh, values.data(), nullptr, nullptr };
  const std::vector<double> levels = { 1.0, 1.0, 2.0, 2.5, 3.0 };
  for (const int k : { 0, 1, 5 })
  {
    const Parts parts(field, k, levels);
    EXPECT_GT(parts.Curves.size(), 100u);
    ExpectSound(field, k, levels, parts, "random");
    // Without virtual sources they are fitted.
    EXPECT_TRUE(IsSame(parts, Parts(bare, k, levels)));
  }
}

TEST(ApolloniusParts, LoopsWithinAFaceAreFound)
{
  const TestMesh test = SingleTriangle();
  const SurfaceMesh mesh = Build(test);
  SurfacePoint inside;
  inside.On = SurfacePoint::Support::Face;
  inside.Face = 0;
  inside.Barycentric = { { 0.3, 0.3, 0.4 } };
  const FieldCase c(test, { { inside, 0.0 } });
  const std::vector<double> levels = { 0.9 };
  const Parts parts(c.ExactWithSources, 5, levels);
  ASSERT_EQ(parts.Curves.size(), 1u);
  EXPECT_EQ(parts.Curves[0].First, NoId);
  EXPECT_TRUE(parts.Crossings.empty());
  ExpectSound(c.ExactWithSources, 5, levels, parts, "loop");
}

TEST(ApolloniusParts, LowerSideIsOnTheLeft)
{
  const FieldCase c(Icosphere(3), { VertexSource(3) });
  const std::vector<double> levels = EvenLevels(c.Exact, 7);
  const Parts parts(c.ExactWithSources, 2, levels);
  FaceProfile profile(c.Exact);
  int right = 0;
  int wrong = 0;
  for (const FaceCurve& curve : parts.Curves)
  {
    profile.Enter(curve.Face);
    const std::vector<std::array<double, 3>> points = PointsOf(c.Mesh, parts, curve);
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
    {
      const Point2 a = profile.PlaceOf(points[i]);
      const Point2 b = profile.PlaceOf(points[i + 1]);
      const FieldSample sample = profile.SampleAt({ 0.5 * (a.X + b.X), 0.5 * (a.Y + b.Y) });
      ++(Cross(Difference(b, a), sample.Gradient) <= 0.0 ? right : wrong);
    }
  }
  EXPECT_GT(right, 1000);
  EXPECT_LT(100 * wrong, right); // on ridges the gradient may be that of the other side
}

TEST(ApolloniusParts, ConvergeInThePlane)
{
  const FieldCase one(Plane(10, 10, 0.2), { VertexSource(48) });
  const FieldCase two(Plane(10, 10, 0.2), { VertexSource(27), VertexSource(93, 0.2) });
  for (const FieldCase* c : { &one, &two })
  {
    const std::vector<double> levels = EvenLevels(c->Exact, 15);
    double last = LinearError(*c, levels);
    for (const int k : { 0, 1, 2, 5, 11 })
    {
      const double error = ErrorOf(*c, c->Local, k, levels);
      EXPECT_LT(error, last) << k;
      last = error;
    }
    EXPECT_LT(10.0 * last, LinearError(*c, levels));
  }
}

TEST(ApolloniusParts, BeatLinearInterpolation)
{
  for (const TestMesh& test : { Icosphere(3), Ellipsoid(3, 0.4), Torus(24, 14) })
  {
    const FieldCase c(test, { VertexSource(3) });
    const std::vector<double> levels = EvenLevels(c.Exact, 15);
    const double linear = LinearError(c, levels);
    EXPECT_LT(3.0 * ErrorOf(c, c.Local, 2, levels), linear);
    EXPECT_LT(3.0 * ErrorOf(c, c.ExactWithSources, 2, levels), linear);
    EXPECT_LT(2.0 * ErrorOf(c, c.Linear, 2, levels), linear); // sources fitted
  }
}
