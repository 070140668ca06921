// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Faces split in four, and their neighbours so that all fits.
#include "CurveChecks.h"
#include "CurvedMeshes.h"
#include "DefectMeshes.h"
#include "FlatMeshes.h"

#include "dggFaceSubdivision.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace dggtest
{
namespace
{
using dgg::RefinedSurface;
using dgg::SurfaceMesh;
using dgg::SurfacePoint;

constexpr dgg::Offset Many = 1000000;

dgg::Status Subdivide(const SurfaceMesh& mesh, const std::vector<Id>& faces,
  RefinedSurface& surface, dgg::Offset mostFaces = Many)
{
  std::vector<std::uint8_t> isMeant(surface.Faces.size(), faces.empty() ? 1 : 0);
  for (const Id f : faces)
  {
    isMeant[f] = 1;
  }
  return dgg::SubdivideFaces(mesh, isMeant, mostFaces, surface);
}

double SmallestAngle(const RefinedSurface& surface)
{
  double smallest = dgg::Pi;
  for (std::size_t h = 0; h < surface.Lengths.size(); ++h)
  {
    const double a = surface.Lengths[h];
    const double b = surface.Lengths[dgg::SurfaceMesh::Previous(static_cast<Id>(h))];
    const double c = surface.Lengths[dgg::SurfaceMesh::Next(static_cast<Id>(h))];
    smallest =
      std::min(smallest, std::acos(std::min(1.0, (a * a + b * b - c * c) / (2.0 * a * b))));
  }
  return smallest;
}
}

TEST(FaceSubdivision, AllFacesAreSplitInFour)
{
  for (const NamedMesh& named : SoundMeshes())
  {
    const SurfaceMesh mesh = Build(named.Mesh);
    RefinedSurface surface = Embed(mesh, {});
    const Id before = surface.GetNumberOfFaces();
    ASSERT_TRUE(Subdivide(mesh, {}, surface).IsOk());
    EXPECT_EQ(surface.GetNumberOfFaces(), 4 * before) << named.Name;
    if (!named.Mesh.Points.empty())
    {
      ExpectSoundEmbedding(named.Mesh, mesh, {}, surface);
    }
    SurfaceMesh fine;
    ASSERT_TRUE(surface.Build(mesh, fine).IsOk()) << named.Name;
    Id components[2];
    mesh.ComputeComponents(components[0]);
    fine.ComputeComponents(components[1]);
    EXPECT_EQ(components[0], components[1]) << named.Name;
  }
}

TEST(FaceSubdivision, CurvesAndTheirPlacesStay)
{
  Random random(5);
  for (const NamedMesh& named : SoundMeshes())
  {
    if (named.Mesh.Points.empty())
    {
      continue;
    }
    const SurfaceMesh mesh = Build(named.Mesh);
    std::vector<SurfacePoint> points;
    for (int k = 0; k < 4; ++k)
    {
      points.push_back(PointIn(mesh, random.Index(mesh.GetNumberOfFaces()), { { 0.2, 0.5, 0.3 } }));
    }
    Id count = 0;
    const std::vector<Id> components = mesh.ComputeComponents(count);
    if (count > 1)
    {
      continue;
    }
    const std::vector<dgg::SurfaceCurve> curves = { Curve(mesh, points, true),
      Curve(mesh, { points[0], points[2] }) };
    RefinedSurface surface = Embed(mesh, curves);
    for (int level = 0; level < 3; ++level)
    {
      // Around one vertex of the curve, so that edges of the curve outside are not split.
      std::vector<Id> faces;
      const Id center = surface.Paths[0][surface.Paths[0].size() / 2];
      for (std::size_t h = 0; h < surface.Triangles.size(); ++h)
      {
        if (surface.Triangles[h] == center)
        {
          faces.push_back(static_cast<Id>(h / 3));
        }
      }
      const std::size_t before = surface.Paths[0].size();
      ASSERT_TRUE(Subdivide(mesh, faces, surface).IsOk());
      EXPECT_GT(surface.Paths[0].size(), before) << named.Name;
      ExpectSoundEmbedding(named.Mesh, mesh, curves, surface);
    }
  }
}

TEST(FaceSubdivision, AnglesDoNotDegenerate)
{
  const TestMesh plane = Plane(6, 6, 0.25);
  const SurfaceMesh mesh = Build(plane);
  RefinedSurface surface = Embed(mesh, {});
  const double before = SmallestAngle(surface);
  for (int level = 0; level < 6; ++level)
  {
    ASSERT_TRUE(Subdivide(mesh, { 30, 31 }, surface).IsOk()); // smaller and smaller
    EXPECT_GE(SmallestAngle(surface), 0.5 * before) << level;
  }
  ExpectSoundEmbedding(plane, mesh, {}, surface);
  EXPECT_LT(surface.GetNumberOfFaces(), 72 + 6 * 40); // it stays local
}

TEST(FaceSubdivision, EdgesOfManyFacesAreSplitInAll)
{
  TestMesh book = TwoTriangles(1.0);
  const Id page = book.AddPoint(1.0, 0.0, 2.0);
  book.AddTriangle(book.Triangles[0], book.Triangles[1], page);
  const SurfaceMesh mesh = Build(book);
  RefinedSurface surface = Embed(mesh, {});
  ASSERT_TRUE(Subdivide(mesh, {}, surface).IsOk());
  ExpectSoundEmbedding(book, mesh, {}, surface);
  SurfaceMesh fine;
  ASSERT_TRUE(surface.Build(mesh, fine).IsOk());
  const auto countWings = [](const SurfaceMesh& m) {
    Id wings = 0;
    for (Id h = 0; h < m.GetNumberOfHalfEdges(); ++h)
    {
      Id around = 1;
      for (Id e = m.Twin(h); e != dgg::NoId && e != h; e = m.Twin(e))
      {
        ++around;
      }
      wings += around == 3 ? 1 : 0;
    }
    return wings;
  };
  EXPECT_EQ(countWings(mesh), 3);
  EXPECT_EQ(countWings(fine), 6);
}

TEST(FaceSubdivision, TooManyFacesAreRefused)
{
  const SurfaceMesh mesh = Build(Icosphere(1));
  RefinedSurface surface = Embed(mesh, {});
  const std::vector<Id> before = surface.Triangles;
  EXPECT_FALSE(Subdivide(mesh, {}, surface, 319).IsOk());
  EXPECT_EQ(surface.Triangles, before);
  EXPECT_TRUE(Subdivide(mesh, {}, surface, 320).IsOk());
  EXPECT_FALSE(dgg::SubdivideFaces(mesh, { 1 }, Many, surface).IsOk());
}
}
