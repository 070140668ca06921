// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Curves through points of a surface: straight in faces, shortest paths between them.
#include "CurveChecks.h"
#include "CurvedMeshes.h"
#include "DefectMeshes.h"
#include "FlatMeshes.h"
#include "GeodesicChecks.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dggtest
{
namespace
{
using dgg::NoId;
using dgg::SurfaceCurve;
using dgg::SurfacePoint;

std::string ErrorOf(
  const dgg::SurfaceMesh& mesh, const std::vector<SurfacePoint>& points, bool isClosed = false)
{
  SurfaceCurve curve;
  curve.Path.Points.resize(2); // something to be cleared
  curve.Parameters.resize(2);
  const dgg::Status status = dgg::JoinPoints(mesh, points, isClosed, nullptr, curve);
  EXPECT_FALSE(status.IsOk());
  EXPECT_TRUE(curve.Path.IsEmpty());
  EXPECT_TRUE(curve.Parameters.empty());
  EXPECT_TRUE(curve.GivenPoints.empty());
  return status.GetMessage();
}
}

TEST(SurfaceCurve, IsStraightInThePlane)
{
  const TestMesh input = Plane(9, 7, 0.25, 3);
  const dgg::SurfaceMesh mesh = Build(input);
  const std::vector<SurfacePoint> points = RandomSurfacePoints(mesh, 30, 5);
  const SurfaceCurve curve = Curve(mesh, points, true);
  ExpectSoundCurve(mesh, points, curve);
  EXPECT_GT(curve.Path.Points.size(), 100u);
  auto positionOf = [&](const SurfacePoint& point) {
    return dgg::PositionOf(mesh, point, input.Points.data());
  };
  for (std::size_t i = 0; i < curve.Path.Points.size(); ++i)
  {
    const auto leg = static_cast<std::size_t>(curve.Parameters[i]) % points.size();
    const double t = curve.Parameters[i] - std::floor(curve.Parameters[i]);
    const auto from = positionOf(points[leg]);
    const auto to = positionOf(points[(leg + 1) % points.size()]);
    const auto at = positionOf(curve.Path.Points[i]);
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_NEAR(at[c], (1.0 - t) * from[c] + t * to[c], 1e-9) << i;
    }
  }
}

TEST(SurfaceCurve, IsAsLongAsTheDistancesBetweenItsPoints)
{
  for (const NamedMesh& named : SoundMeshes())
  {
    SCOPED_TRACE(named.Name);
    const dgg::SurfaceMesh mesh = Build(named.Mesh);
    std::vector<SurfacePoint> points;
    std::vector<Id> components(1, 0);
    Id count = 0;
    components = mesh.ComputeComponents(count);
    for (const SurfacePoint& point : RandomSurfacePoints(mesh, 40, 8))
    {
      if (components[mesh.Origin(3 * point.Face)] == 0 && points.size() < 6)
      {
        points.push_back(point);
      }
    }
    points.push_back(SurfacePoint::AtVertex(0));
    const SurfaceCurve curve = Curve(mesh, points);
    ExpectSoundCurve(mesh, points, curve);
    double length = 0.0;
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
    {
      length += DistancesTo(mesh, dgg::ExactEngine::Reference, points[i], { points[i + 1] })[0];
    }
    EXPECT_NEAR(curve.Path.Length, length, 1e-9 * length);
  }
}

TEST(SurfaceCurve, DoesWhateverItIsTold)
{
  Random random(17);
  for (const TestMesh& input :
    { Plane(3, 3), NoisySphere(1, 0.3, 3), Torus(8, 5), MisorientedSphere(1, 8) })
  {
    const dgg::SurfaceMesh mesh = Build(input);
    for (int i = 0; i < 100; ++i)
    {
      const std::vector<SurfacePoint> points =
        RandomCurvePoints(mesh, 1 + random.Index(12), random);
      ExpectSoundCurve(mesh, points, Curve(mesh, points, i % 2 == 1));
      ASSERT_FALSE(HasFailure()) << i;
    }
  }
}

TEST(SurfaceCurve, FewPoints)
{
  const dgg::SurfaceMesh mesh = Build(Icosphere(1));
  const SurfacePoint point = SurfacePoint::InFace(mesh, 7, { { 0.2, 0.3, 0.5 } });
  for (const bool isClosed : { false, true })
  {
    EXPECT_TRUE(Curve(mesh, {}, isClosed).Path.IsEmpty());
    const SurfaceCurve single = Curve(mesh, { point }, isClosed);
    ExpectSoundCurve(mesh, { point }, single);
    EXPECT_EQ(single.Path.Points.size(), 1u);
    const SurfaceCurve twice = Curve(mesh, { point, point }, isClosed);
    ExpectSoundCurve(mesh, { point, point }, twice);
    EXPECT_EQ(twice.Path.Points.size(), isClosed ? 3u : 2u);
    EXPECT_EQ(twice.Path.Length, 0.0);
  }
  // There and back.
  const SurfacePoint other = SurfacePoint::AtVertex(3);
  const SurfaceCurve open = Curve(mesh, { point, other });
  const SurfaceCurve closed = Curve(mesh, { point, other }, true);
  EXPECT_NEAR(closed.Path.Length, 2.0 * open.Path.Length, 1e-12);
}

TEST(SurfaceCurve, FindsCommonFaces)
{
  const dgg::SurfaceMesh mesh = Build(Plane(2, 1)); // faces 0 and 1 of the left cell, 2 and 3
  const auto at = [](Id v) { return SurfacePoint::AtVertex(v); };
  for (Id f = 0; f < 4; ++f)
  {
    const SurfacePoint inside = SurfacePoint::InFace(mesh, f, { { 0.2, 0.3, 0.5 } });
    for (Id h = 3 * f; h < 3 * f + 3; ++h)
    {
      const SurfacePoint onSide = SurfacePoint::OnEdge(mesh, h, 0.25);
      EXPECT_EQ(dgg::FindCommonFace(mesh, inside, onSide), f);
      EXPECT_EQ(dgg::FindCommonFace(mesh, onSide, inside), f);
      EXPECT_EQ(dgg::FindCommonFace(mesh, inside, at(mesh.Origin(h))), f);
      EXPECT_EQ(dgg::FindCommonFace(mesh, at(mesh.Origin(h)), inside), f);
      const Id twin = mesh.Twin(h);
      const Id smallest = twin == NoId ? f : std::min(f, twin / 3);
      EXPECT_EQ(dgg::FindCommonFace(mesh, at(mesh.Origin(h)), at(mesh.Destination(h))), smallest);
      EXPECT_EQ(dgg::FindCommonFace(mesh, onSide, SurfacePoint::OnEdge(mesh, h, 0.5)), smallest);
      EXPECT_EQ(dgg::FindCommonFace(mesh, onSide, at(mesh.Apex(h))), f);
    }
  }
  EXPECT_EQ(dgg::FindCommonFace(mesh, at(0), at(2)), NoId);
  EXPECT_EQ(dgg::FindCommonFace(mesh, SurfacePoint::InFace(mesh, 0, { { 0.2, 0.3, 0.5 } }),
              SurfacePoint::InFace(mesh, 1, { { 0.2, 0.3, 0.5 } })),
    NoId);
}

TEST(SurfaceCurve, SaysWhatIsWrong)
{
  const dgg::SurfaceMesh mesh = Build(SeveralComponents());
  Id components = 0;
  const std::vector<Id> componentOf = mesh.ComputeComponents(components);
  ASSERT_EQ(components, 3);
  const Id other = mesh.GetNumberOfVertices() - 1;
  ASSERT_NE(componentOf[other], componentOf[0]);
  const auto at = [](Id v) { return SurfacePoint::AtVertex(v); };
  std::string message = ErrorOf(mesh, { at(0), at(1), at(other) });
  EXPECT_NE(message.find("points 1 and 2 of the curve are not connected"), std::string::npos)
    << message;
  message = ErrorOf(mesh, { at(0), at(1), at(mesh.GetNumberOfVertices()) });
  EXPECT_NE(message.find("point 2 of the curve: vertex"), std::string::npos) << message;
  SurfacePoint outside = SurfacePoint::InFace(mesh, 0, { { 0.7, 0.7, -0.4 } });
  message = ErrorOf(mesh, { outside, at(0) });
  EXPECT_NE(message.find("point 0 of the curve: the barycentric"), std::string::npos) << message;
  outside = SurfacePoint::InFace(mesh, 0, { { std::nan(""), 0.5, 0.5 } });
  message = ErrorOf(mesh, { at(0), outside }, true);
  EXPECT_NE(message.find("point 1 of the curve"), std::string::npos) << message;
  const dgg::SurfaceMesh isolated = Build(SphereWithIsolatedPoints(1));
  Id alone = 0;
  while (isolated.Kind(alone) != dgg::VertexKind::Isolated)
  {
    ++alone;
  }
  message = ErrorOf(isolated, { at(alone), at(alone + 1) });
  EXPECT_NE(message.find("not connected"), std::string::npos) << message;
}

TEST(SurfaceCurve, StopsWhenTold)
{
  const dgg::SurfaceMesh mesh = Build(NoisySphere(3, 0.3, 2));
  const std::vector<SurfacePoint> points = RandomSurfacePoints(mesh, 10, 3);
  std::vector<double> reports;
  SurfaceCurve curve;
  const auto listen = [&](double done) {
    reports.push_back(done);
    return true;
  };
  ASSERT_TRUE(dgg::JoinPoints(mesh, points, true, listen, curve).IsOk());
  EXPECT_TRUE(std::is_sorted(reports.begin(), reports.end()));
  EXPECT_GE(reports.front(), 0.0);
  EXPECT_LE(reports.back(), 1.0);
  const std::size_t count = reports.size();
  EXPECT_GT(count, 1u);
  for (std::size_t stop = 0; stop < count; ++stop)
  {
    std::size_t calls = 0;
    const dgg::Status status = dgg::JoinPoints(
      mesh, points, true, [&](double) { return calls++ < stop; }, curve);
    EXPECT_TRUE(status.IsAborted());
    EXPECT_TRUE(curve.Path.IsEmpty());
  }
}
}
