// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Finer faces in a part of a surface.
#include "CurveChecks.h"
#include "CurvedMeshes.h"
#include "DefectMeshes.h"
#include "FlatMeshes.h"
#include "GeodesicChecks.h"

#include "dggFaceRefinement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace dggtest
{
namespace
{
using dgg::RefinedSurface;
using dgg::SurfaceCurve;

std::vector<Id> Refine(
  const dgg::SurfaceMesh& mesh, const std::vector<Id>& faces, int levels, RefinedSurface& surface)
{
  std::vector<Id> parents;
  const dgg::Status status = dgg::RefineFaces(mesh, faces, levels, nullptr, surface, parents);
  EXPECT_TRUE(status.IsOk()) << status.GetMessage();
  return parents;
}

double AreaOf(const RefinedSurface& surface, Id f)
{
  return dgg::TriangleArea(
    surface.Lengths[3 * f], surface.Lengths[3 * f + 1], surface.Lengths[3 * f + 2]);
}

/// Faces are parts of their parents, and the chosen ones have parts of one size.
void ExpectParts(const RefinedSurface& before, const RefinedSurface& after,
  const std::vector<Id>& parents, const std::vector<Id>& chosen, int levels)
{
  ASSERT_EQ(parents.size(), after.Faces.size());
  std::vector<double> areas(before.Faces.size(), 0.0);
  std::vector<Id> counts(before.Faces.size(), 0);
  for (Id f = 0; f < after.GetNumberOfFaces(); ++f)
  {
    ASSERT_EQ(after.Faces[f], before.Faces[parents[f]]);
    areas[parents[f]] += AreaOf(after, f);
    ++counts[parents[f]];
  }
  const Id parts = 1 << (2 * levels);
  for (Id f = 0; f < before.GetNumberOfFaces(); ++f)
  {
    EXPECT_NEAR(areas[f], AreaOf(before, f), 1e-9 * areas[f]);
  }
  for (const Id f : chosen)
  {
    EXPECT_EQ(counts[f], parts);
  }
  for (Id f = 0; f < after.GetNumberOfFaces(); ++f)
  {
    if (std::find(chosen.begin(), chosen.end(), parents[f]) != chosen.end())
    {
      EXPECT_NEAR(parts * AreaOf(after, f), AreaOf(before, parents[f]), 1e-9 * areas[parents[f]]);
    }
  }
}

/// Equilateral triangles: rows of a plane pushed sideways.
TestMesh EquilateralPlane(Id n)
{
  TestMesh mesh = Plane(n, n);
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    double* p = mesh.Points.data() + 3 * static_cast<std::size_t>(v);
    p[0] -= 0.5 * p[1];
    p[1] *= std::sqrt(0.75);
  }
  return mesh;
}

double SmallestAngle(const RefinedSurface& surface)
{
  double smallest = dgg::Pi;
  for (Id h = 0; h < static_cast<Id>(surface.Triangles.size()); ++h)
  {
    const double a = surface.Lengths[h];
    const double b = surface.Lengths[dgg::SurfaceMesh::Previous(h)];
    const double c = surface.Lengths[dgg::SurfaceMesh::Next(h)];
    smallest = std::min(smallest, std::acos((a * a + b * b - c * c) / (2.0 * a * b)));
  }
  return smallest;
}
}

TEST(FaceRefinement, NothingToDo)
{
  const dgg::SurfaceMesh mesh = Build(Icosphere(1));
  const RefinedSurface before = Embed(mesh, {});
  RefinedSurface surface = before;
  std::vector<Id> all(before.Faces.size());
  std::iota(all.begin(), all.end(), 0);
  EXPECT_EQ(Refine(mesh, {}, 3, surface), all);
  EXPECT_EQ(surface.Triangles, before.Triangles);
  EXPECT_EQ(Refine(mesh, { 3, 4 }, 0, surface), all);
  EXPECT_EQ(surface.Triangles, before.Triangles);
}

TEST(FaceRefinement, AllFaces)
{
  for (const TestMesh& input : { NoisySphere(1, 0.3, 3), Plane(4, 3, 0.2, 5), Tetrahedron() })
  {
    const dgg::SurfaceMesh mesh = Build(input);
    const RefinedSurface before = Embed(mesh, {});
    RefinedSurface surface = before;
    std::vector<Id> all(before.Faces.size());
    std::iota(all.begin(), all.end(), 0);
    const std::vector<Id> parents = Refine(mesh, all, 3, surface);
    ExpectParts(before, surface, parents, all, 3);
    ExpectSoundEmbedding(input, mesh, {}, surface);
    EXPECT_EQ(surface.GetNumberOfVertices(), Subdivided(input, 8).GetNumberOfVertices());
  }
}

TEST(FaceRefinement, GreenFacesAreSplitOnce)
{
  const TestMesh input = EquilateralPlane(12);
  const dgg::SurfaceMesh mesh = Build(input);
  const RefinedSurface before = Embed(mesh, {});
  ASSERT_NEAR(SmallestAngle(before), dgg::Pi / 3.0, 1e-12);
  for (int levels = 1; levels <= 4; ++levels)
  {
    RefinedSurface surface = before;
    const std::vector<Id> chosen{ 130, 131, 155 };
    const std::vector<Id> parents = Refine(mesh, chosen, levels, surface);
    ExpectParts(before, surface, parents, chosen, levels);
    ExpectSoundEmbedding(input, mesh, {}, surface);
    EXPECT_NEAR(SmallestAngle(surface), dgg::Pi / 6.0, 1e-9) << levels;
  }
}

TEST(FaceRefinement, CurvesStayCurves)
{
  std::uint64_t seed = 40;
  for (const TestMesh& input : { SingleTriangle(), Plane(4, 3, 0.25, 7), NoisySphere(1, 0.4, 3),
         WithNoise(Torus(7, 4), 0.1, 5), MisorientedSphere(1, 8), NeedlePlane(2, 1e-5) })
  {
    SCOPED_TRACE(seed);
    const dgg::SurfaceMesh mesh = Build(input);
    Random random(++seed);
    for (int i = 0; i < 30; ++i)
    {
      SCOPED_TRACE(i);
      std::vector<SurfaceCurve> curves;
      for (int c = 0; c < 3; ++c)
      {
        curves.push_back(Curve(mesh, RandomCurvePoints(mesh, 6, random), c == 0));
      }
      RefinedSurface surface = Embed(mesh, curves);
      std::vector<Id> faces;
      for (Id f = 0; f < surface.GetNumberOfFaces(); ++f)
      {
        if (random.Index(20) == 0)
        {
          faces.push_back(f);
        }
      }
      const Id before = surface.GetNumberOfFaces();
      const std::vector<Id> parents = Refine(mesh, faces, 1 + random.Index(2), surface);
      EXPECT_TRUE(faces.empty() || surface.GetNumberOfFaces() > before);
      EXPECT_TRUE(std::is_sorted(parents.begin(), parents.end()));
      ExpectSoundEmbedding(input, mesh, curves, surface);
      ExpectSoundCut(surface, CutOpen(surface));
      ASSERT_FALSE(HasFailure());
    }
  }
}

TEST(FaceRefinement, EdgesWithManyFaces)
{
  std::vector<Id> sheetOf;
  const TestMesh input = Book(5, 3, sheetOf);
  const dgg::SurfaceMesh mesh = Build(input);
  RefinedSurface surface = Embed(mesh, {});
  std::vector<Id> all(surface.Faces.size() / 2);
  std::iota(all.begin(), all.end(), 0);
  Refine(mesh, all, 2, surface);
  ExpectSoundEmbedding(input, mesh, {}, surface);
}

TEST(FaceRefinement, ParametersBetweenPointsInOnePlace)
{
  // Points 1 to 3 are one vertex; the middle of the edge behind is halfway from point 3 to 4.
  const dgg::SurfaceMesh mesh = Build(Plane(1, 1));
  const dgg::SurfacePoint start = dgg::SurfacePoint::AtVertex(0);
  const dgg::SurfacePoint stop = dgg::SurfacePoint::AtVertex(1);
  const std::vector<SurfaceCurve> curves{ Curve(
    mesh, { start, stop, stop, stop, dgg::SurfacePoint::AtVertex(3) }) };
  RefinedSurface surface = Embed(mesh, curves);
  Refine(mesh, { 0, 1 }, 1, surface);
  const dgg::CurveChain chain = dgg::FollowCurve(surface, curves, 0);
  EXPECT_EQ(chain.Parameters, (std::vector<double>{ 0.0, 0.5, 1.0, 3.5, 4.0 }));
  EXPECT_EQ(chain.GivenPoints, (std::vector<dgg::Offset>{ 0, 2, 2, 2, 4 }));
}

TEST(FaceRefinement, SaysWhatIsWrong)
{
  const dgg::SurfaceMesh mesh = Build(Icosphere(1));
  const RefinedSurface before = Embed(mesh, {});
  RefinedSurface surface = before;
  std::vector<Id> parents{ 1, 2, 3 };
  auto errorOf = [&](const std::vector<Id>& faces, int levels) {
    const dgg::Status status = dgg::RefineFaces(mesh, faces, levels, nullptr, surface, parents);
    EXPECT_FALSE(status.IsOk());
    EXPECT_EQ(surface.Triangles, before.Triangles);
    EXPECT_TRUE(parents.empty());
    return status.GetMessage();
  };
  EXPECT_NE(errorOf({ 80 }, 1).find("face 80 does not exist"), std::string::npos);
  EXPECT_NE(errorOf({ 0, -1 }, 1).find("face -1 does not exist"), std::string::npos);
  EXPECT_NE(errorOf({ 0 }, -1).find("negative"), std::string::npos);
  int calls = 0;
  const dgg::Status status = dgg::RefineFaces(
    mesh, { 0 }, 3, [&](double) { return ++calls < 3; }, surface, parents);
  EXPECT_TRUE(status.IsAborted());
  EXPECT_EQ(calls, 3);
  EXPECT_EQ(surface.Triangles, before.Triangles);
}
}
