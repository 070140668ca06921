// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Distances inside faces: exact with windows, approximate with virtual sources.
#include "FieldChecks.h"
#include "GeodesicChecks.h"
#include "TestMeshes.h"

#include "dggCornerModel.h"
#include "dggDistanceField.h"
#include "dggEdgeEnvelope.h"
#include "dggExactGeodesics.h"
#include "dggFaceEnvelope.h"

using namespace dgg;
using namespace dggtest;

namespace
{
double DistanceAt(FaceEnvelope& envelope, const SurfacePoint& point)
{
  envelope.Enter(point.Face);
  return envelope.At(envelope.PlaceOf(point.Barycentric));
}

std::vector<SurfacePoint> PointsInside(const SurfaceMesh& mesh, Id count, std::uint64_t seed)
{
  std::vector<SurfacePoint> points;
  for (const SurfacePoint& point : RandomSurfacePoints(mesh, count, seed))
  {
    if (point.On == SurfacePoint::Support::Face)
    {
      points.push_back(point);
    }
  }
  return points;
}

/// Returns the mean relative error over points inside faces.
double MeanError(
  const DistanceField& field, const ExactField& exact, const std::vector<SurfacePoint>& points)
{
  FaceEnvelope envelope(field);
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const double d = exact.Result.TargetDistances[i];
    if (d > 0.0 && d < Infinity)
    {
      sum += std::abs(DistanceAt(envelope, points[i]) - d) / d;
      ++count;
    }
  }
  return sum / static_cast<double>(count);
}

void ExpectExact(const SurfaceMesh& mesh, const std::vector<GeodesicSource>& sources,
  ExactEngine engine, double tolerance, const std::string& what)
{
  const std::vector<SurfacePoint> points = PointsInside(mesh, 300, 5);
  const ExactField field(mesh, sources, points, engine);
  const Status status = field.Result.Windows.Check(mesh);
  EXPECT_TRUE(status.IsOk()) << what << ": " << status.GetMessage();
  FaceEnvelope envelope(field.Exact);
  const double rounding = 1e-14 * mesh.GetMeanEdgeLength();
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const double d = field.Result.TargetDistances[i];
    if (d < Infinity)
    {
      ASSERT_NEAR(DistanceAt(envelope, points[i]), d, tolerance * std::abs(d) + rounding)
        << what << ", point " << i;
    }
  }
}

std::vector<GeodesicSource> VertexAndFaceSources(const SurfaceMesh& mesh)
{
  return { VertexSource(0), { PointsInside(mesh, 3, 11).front(), 0.1 * mesh.GetMeanEdgeLength() } };
}
}

TEST(DistanceField, WindowsGiveTheExactDistanceInFaces)
{
  for (const NamedMesh& named : SoundMeshes())
  {
    const SurfaceMesh mesh = Build(named.Mesh);
    const std::vector<GeodesicSource> sources = VertexAndFaceSources(mesh);
    ExpectExact(mesh, sources, ExactEngine::Triangle, 1e-12, named.Name);
    ExpectExact(mesh, sources, ExactEngine::Reference, 1e-12, named.Name + " (reference)");
  }
  for (const NamedMesh& named : DefectMeshes())
  {
    const SurfaceMesh mesh = Build(named.Mesh);
    ExpectExact(mesh, VertexAndFaceSources(mesh), ExactEngine::Triangle, 1e-9, named.Name);
  }
}

TEST(DistanceField, EdgesAndFacesAgree)
{
  for (const TestMesh& test : { Icosphere(3), Terrain(14, 0.6, 3), Torus(16, 10) })
  {
    const SurfaceMesh mesh = Build(test);
    const ExactField field(mesh, VertexAndFaceSources(mesh));
    const double scale = mesh.GetMeanEdgeLength();
    for (const DistanceField* f : { &field.Exact, &field.Local, &field.Linear })
    {
      EdgeEnvelope edge(*f);
      FaceEnvelope face(*f);
      FaceEnvelope beyond(*f);
      for (Id h = 0; h < mesh.GetNumberOfHalfEdges(); h += 7)
      {
        edge.Enter(h);
        face.Enter(SurfaceMesh::Face(h));
        const Id twin = mesh.Twin(h); // twins have opposite directions on these meshes
        if (twin != NoId)
        {
          beyond.Enter(SurfaceMesh::Face(twin));
        }
        const bool isSame =
          edge.GetHalfEdge() == h || mesh.Origin(edge.GetHalfEdge()) == mesh.Origin(h);
        for (double t : { 0.0, 0.1, 0.35, 0.5, 0.8, 1.0 })
        {
          std::array<double, 3> b{ { 0.0, 0.0, 0.0 } };
          b[h % 3] = 1.0 - t;
          b[(h + 1) % 3] = t;
          const double onEdge = edge.At((isSame ? t : 1.0 - t) * edge.GetLength());
          const double inFace = face.At(face.PlaceOf(b));
          if (f == &field.Local)
          {
            // The wavefront may arrive through the other face.
            std::array<double, 3> other{ { 0.0, 0.0, 0.0 } };
            if (twin != NoId)
            {
              other[twin % 3] = t;
              other[(twin + 1) % 3] = 1.0 - t;
            }
            const double inOther = twin == NoId ? inFace : beyond.At(beyond.PlaceOf(other));
            EXPECT_NEAR(std::min(inFace, inOther), onEdge, 1e-9 * scale);
            EXPECT_LE(inFace, onEdge + 0.2 * scale);
          }
          else
          {
            EXPECT_NEAR(inFace, onEdge, 1e-9 * scale);
          }
        }
      }
    }
  }
}

/// Rays that enter the face through its leaning side meet the boundary edge, or diverge from it.
TEST(DistanceField, WavefrontsReachTheBoundaryOfLeaningFaces)
{
  TestMesh leaning;
  leaning.Points = { 0, 0, 0, 1, 0, 0, 3, 1, 0, 4, 0, 0 };
  leaning.Triangles = { 0, 1, 2, 1, 3, 2 };
  const SurfaceMesh mesh = Build(leaning);
  const std::array<double, 3> source{ { 2.0 / 3.0, 2.0 / 15.0, 0.2 } }; // (1.8, 0.2)
  const ExactField field(mesh, { { SurfacePoint::InTriangle(mesh, 1, source), 0.0 } });
  EdgeEnvelope edge(field.Exact);
  edge.Enter(0);
  for (const double x : { 0.1, 0.3, 0.5, 0.7, 0.9 })
  {
    EXPECT_NEAR(edge.At(x), std::hypot(1.8 - x, 0.2), 1e-12);
  }
}

TEST(DistanceField, CrossingsOfEdgesAreAtTheLevelAndAlternate)
{
  const SurfaceMesh mesh = Build(Terrain(14, 0.6, 3));
  const ExactField field(mesh, VertexAndFaceSources(mesh));
  for (const DistanceField* f : { &field.Exact, &field.Local, &field.Linear })
  {
    EdgeEnvelope edge(*f);
    int found = 0;
    for (Id h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
    {
      edge.Enter(h);
      const double begin = edge.At(0.0);
      const double end = edge.At(edge.GetLength());
      for (double level : { 0.5 * (begin + end), begin, end, begin + 0.01 * edge.GetLength() })
      {
        std::vector<double> crossings;
        edge.FindCrossings(level, crossings);
        EXPECT_EQ(crossings.size() % 2 == 1, (begin >= level) != (end >= level));
        EXPECT_TRUE(std::is_sorted(crossings.begin(), crossings.end()));
        for (double x : crossings)
        {
          EXPECT_NEAR(edge.At(x), level, 1e-12);
          ++found;
        }
      }
    }
    EXPECT_GT(found, mesh.GetNumberOfHalfEdges() / 2);
  }
}

/// Parts that cannot reach a level are skipped. The bound must also hold for steep fields that are
/// not distances.
TEST(DistanceField, NoCrossingOfSteepModelsIsLost)
{
  const SurfaceMesh mesh = Build(Terrain(14, 0.6, 3));
  const ExactField field(mesh, VertexAndFaceSources(mesh));
  std::vector<double> distances = field.Result.Distances;
  for (std::size_t v = 0; v < distances.size(); ++v)
  {
    distances[v] *= v % 3 == 0 ? 4.0 : 1.0;
  }
  DistanceField steep = field.Local;
  steep.Distances = distances.data();
  for (const DistanceField* f : { &field.Local, static_cast<const DistanceField*>(&steep) })
  {
    EdgeEnvelope edge(*f);
    for (Id h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
    {
      edge.Enter(h);
      const std::vector<double>& breaks = edge.GetBreaks();
      for (double t = 0.03; t < 1.0; t += 0.1)
      {
        const double level = edge.At(t * edge.GetLength());
        std::vector<double> crossings;
        edge.FindCrossings(level, crossings);
        for (std::size_t i = 1; i < breaks.size(); ++i)
        {
          const auto inside = [&](double x) { return x >= breaks[i - 1] && x <= breaks[i]; };
          const bool isCrossed = (edge.At(breaks[i - 1]) >= level) != (edge.At(breaks[i]) >= level);
          ASSERT_TRUE(!isCrossed || std::any_of(crossings.begin(), crossings.end(), inside))
            << "half-edge " << h << ", level " << level;
        }
      }
    }
  }
}

/// Behind ridges, wavefronts from both ends of an edge meet inside the edge.
TEST(DistanceField, NoExtremumIsBetweenBreaks)
{
  for (const NamedMesh& named : SoundMeshes())
  {
    const SurfaceMesh mesh = Build(named.Mesh);
    const ExactField field(mesh, VertexAndFaceSources(mesh));
    const double rounding = 1e-9 * mesh.GetMeanEdgeLength();
    EdgeEnvelope edge(field.Exact);
    for (Id h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
    {
      edge.Enter(h);
      const std::vector<double>& breaks = edge.GetBreaks();
      for (std::size_t i = 1; i < breaks.size(); ++i)
      {
        if (breaks[i] - breaks[i - 1] <= 1e-6 * edge.GetLength())
        {
          continue; // very narrow windows are not stored
        }
        const double begin = edge.At(breaks[i - 1]);
        const double end = edge.At(breaks[i]);
        for (double t = 0.05; t < 1.0; t += 0.05)
        {
          const double d = edge.At(breaks[i - 1] + t * (breaks[i] - breaks[i - 1]));
          ASSERT_LE(d, std::max(begin, end) + rounding) << named.Name << ", half-edge " << h;
          ASSERT_GE(d, std::min(begin, end) - rounding) << named.Name << ", half-edge " << h;
        }
      }
    }
  }
}

TEST(DistanceField, ModelsAreExactInThePlane)
{
  const SurfaceMesh mesh = Build(Plane(9, 9, 0.2));
  const std::vector<SurfacePoint> points = PointsInside(mesh, 400, 5);
  for (const std::vector<GeodesicSource>& sources :
    { std::vector<GeodesicSource>{ VertexSource(30) },
      std::vector<GeodesicSource>{ { PointsInside(mesh, 3, 2).front(), 0.0 } } })
  {
    const ExactField field(mesh, sources, points);
    EXPECT_LT(MeanError(field.Local, field, points), 1e-12);
    EXPECT_GT(MeanError(field.Linear, field, points), 1e-3);
  }
}

TEST(DistanceField, ModelsBeatLinearInterpolation)
{
  for (const TestMesh& test : { Icosphere(3), Ellipsoid(3, 0.4), Torus(24, 14) })
  {
    const SurfaceMesh mesh = Build(test);
    const std::vector<SurfacePoint> points = PointsInside(mesh, 3000, 5);
    const ExactField field(mesh, { VertexSource(3) }, points);
    EXPECT_LT(8.0 * MeanError(field.Local, field, points), MeanError(field.Linear, field, points));
    EXPECT_LT(MeanError(field.Exact, field, points), 1e-14);
  }
}

TEST(DistanceField, GradientsAreThoseOfTheDistance)
{
  const SurfaceMesh mesh = Build(Terrain(14, 0.6, 3));
  const ExactField field(mesh, VertexAndFaceSources(mesh));
  for (const DistanceField* f : { &field.Exact, &field.Local, &field.Linear })
  {
    FaceEnvelope envelope(*f);
    int smooth = 0;
    const std::vector<SurfacePoint> points = PointsInside(mesh, 400, 5);
    for (const SurfacePoint& point : points)
    {
      envelope.Enter(point.Face);
      const Point2 p = envelope.PlaceOf(point.Barycentric);
      const double step = 1e-6 * mesh.GetMeanEdgeLength();
      const FieldSample here = envelope.SampleAt(p);
      const FieldSample right = envelope.SampleAt({ p.X + step, p.Y });
      const FieldSample up = envelope.SampleAt({ p.X, p.Y + step });
      if (here.Candidate == right.Candidate && here.Candidate == up.Candidate)
      {
        EXPECT_NEAR(here.Gradient.X, (right.Distance - here.Distance) / step, 1e-4);
        EXPECT_NEAR(here.Gradient.Y, (up.Distance - here.Distance) / step, 1e-4);
        ++smooth;
      }
    }
    EXPECT_GT(2 * smooth, static_cast<int>(points.size()));
  }
}
