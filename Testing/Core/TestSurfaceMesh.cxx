// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Connectivity, lengths, angles and vertex kinds of SurfaceMesh; degenerate faces, errors, reports.
#include "TestMeshes.h"

#include "dggPreparedSurface.h"
#include "dggSurfaceMesh.h"

namespace dggtest
{
namespace
{
using dgg::NoId;
using dgg::SurfaceMesh;
using dgg::VertexKind;

std::pair<Id, Id> EndsOf(const SurfaceMesh& mesh, Id h)
{
  return std::minmax(mesh.Origin(h), mesh.Destination(h));
}

/// Checks the invariants of any mesh.
void ExpectConsistent(const TestMesh& input, const SurfaceMesh& mesh)
{
  ASSERT_EQ(mesh.GetNumberOfVertices(), input.GetNumberOfVertices());
  ASSERT_EQ(mesh.GetNumberOfFaces(), input.GetNumberOfFaces());
  std::map<std::pair<Id, Id>, std::set<Id>> edges;
  for (Id h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
  {
    const Id f = SurfaceMesh::Face(h);
    // Faces keep their ids, and their corners up to orientation.
    std::multiset<Id> before(input.Triangles.begin() + 3 * f, input.Triangles.begin() + 3 * f + 3);
    const auto triangle = mesh.GetTriangle(f);
    ASSERT_EQ(before, std::multiset<Id>(triangle.begin(), triangle.end()));
    ASSERT_EQ(triangle[0], input.Triangles[3 * f]);
    ASSERT_EQ(triangle[mesh.IsFlipped(f) ? 2 : 1], input.Triangles[3 * f + 1]);
    ASSERT_EQ(SurfaceMesh::Next(SurfaceMesh::Previous(h)), h);
    ASSERT_EQ(mesh.Destination(h), mesh.Origin(SurfaceMesh::Next(h)));
    ASSERT_EQ(mesh.Apex(h), mesh.Origin(SurfaceMesh::Previous(h)));
    if (mesh.IsDropped(f))
    {
      ASSERT_EQ(mesh.Twin(h), NoId);
      continue;
    }
    edges[EndsOf(mesh, h)].insert(h);
    // The planar layout of the face reproduces its edge lengths.
    const double tolerance = 1e-12 * mesh.GetMaximumEdgeLength();
    ASSERT_GT(mesh.Length(h), 0.0);
    ASSERT_GT(mesh.ApexY(h), 0.0);
    ASSERT_NEAR(
      std::hypot(mesh.ApexX(h), mesh.ApexY(h)), mesh.Length(SurfaceMesh::Previous(h)), tolerance);
    ASSERT_NEAR(std::hypot(mesh.Length(h) - mesh.ApexX(h), mesh.ApexY(h)),
      mesh.Length(SurfaceMesh::Next(h)), tolerance);
    if (!input.Points.empty())
    {
      ASSERT_NEAR(mesh.Length(h), EuclideanDistance(input, mesh.Origin(h), mesh.Destination(h)),
        mesh.GetMollification() + 1e-15 * mesh.GetMaximumEdgeLength());
    }
  }
  // Twins link exactly the half-edges of an edge in one cycle, with equal lengths.
  for (const auto& edge : edges)
  {
    const Id first = *edge.second.begin();
    if (edge.second.size() == 1)
    {
      ASSERT_EQ(mesh.Twin(first), NoId);
      continue;
    }
    std::set<Id> circle;
    Id h = first;
    do
    {
      ASSERT_NE(h, NoId);
      ASSERT_TRUE(circle.insert(h).second);
      ASSERT_EQ(mesh.Length(h), mesh.Length(first));
      h = mesh.Twin(h);
    } while (h != first);
    ASSERT_EQ(circle, edge.second);
  }
  // The fans contain every regular corner once; angles sum up.
  std::set<Id> corners;
  double sum = 0.0;
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    double angle = 0.0;
    for (const Id* h = mesh.FanBegin(v); h != mesh.FanEnd(v); ++h)
    {
      ASSERT_EQ(mesh.Origin(*h), v);
      ASSERT_TRUE(corners.insert(*h).second);
      ASSERT_NEAR(mesh.PolarAngle(*h), angle, 1e-12);
      angle += mesh.CornerAngle(*h);
    }
    ASSERT_NEAR(mesh.TotalAngle(v), angle, 1e-12);
    ASSERT_EQ(mesh.Kind(v) == VertexKind::Isolated, mesh.FanBegin(v) == mesh.FanEnd(v));
    ASSERT_EQ(mesh.Kind(v) == VertexKind::Irregular, mesh.IsIrregular(v));
    sum += angle;
  }
  Id usable = 0;
  for (Id f = 0; f < mesh.GetNumberOfFaces(); ++f)
  {
    usable += mesh.IsDropped(f) ? 0 : 1;
  }
  EXPECT_EQ(static_cast<Id>(corners.size()), 3 * usable);
  // With mollification, the angles of degenerate faces are dominated by rounding errors.
  if (mesh.GetMollification() == 0.0)
  {
    EXPECT_NEAR(sum, usable * dgg::Pi, 1e-9 * (usable + 1));
  }
  EXPECT_GE(mesh.GetMemorySize(), 3 * mesh.GetNumberOfFaces() * 4 * sizeof(double));
}

Id CountKind(const SurfaceMesh& mesh, VertexKind kind)
{
  Id count = 0;
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    count += mesh.Kind(v) == kind ? 1 : 0;
  }
  return count;
}
}

TEST(SurfaceMesh, IsConsistent)
{
  for (const NamedMesh& named : SoundMeshes())
  {
    SCOPED_TRACE(named.Name);
    const SurfaceMesh mesh = Build(named.Mesh);
    ExpectConsistent(named.Mesh, mesh);
    EXPECT_EQ(CountKind(mesh, VertexKind::Irregular), 0);
    EXPECT_EQ(mesh.GetMollification(), 0.0);
  }
  for (const NamedMesh& named : DefectMeshesAndSoups(100))
  {
    SCOPED_TRACE(named.Name);
    ExpectConsistent(named.Mesh, Build(named.Mesh));
  }
}

TEST(SurfaceMesh, ClassifiesVertices)
{
  const SurfaceMesh cube = Build(Cube(3));
  EXPECT_EQ(CountKind(cube, VertexKind::Convex), 8);
  EXPECT_EQ(CountKind(cube, VertexKind::Flat), 48); // includes vertices on edges of the cube
  const SurfaceMesh block = Build(TwoHoledBlock());
  EXPECT_EQ(CountKind(block, VertexKind::Convex), 8);
  EXPECT_EQ(CountKind(block, VertexKind::Saddle), 16); // corners of the holes: 5 pi / 2
  const SurfaceMesh plane = Build(Plane(3, 3, 0.2, 1));
  EXPECT_EQ(CountKind(plane, VertexKind::Flat), 4);
  EXPECT_EQ(CountKind(plane, VertexKind::Boundary), 12);
  EXPECT_NEAR(plane.TotalAngle(0), 0.5 * dgg::Pi, 1e-14);
  EXPECT_NEAR(cube.TotalAngle(0), 1.5 * dgg::Pi, 1e-14);

  std::vector<ConePoint> unused;
  EXPECT_EQ(Build(Cone(2.0 * dgg::Pi * (1.0 - 1e-10), 6, 2, unused)).Kind(0), VertexKind::Flat);
  EXPECT_EQ(Build(Cone(2.0 * dgg::Pi * (1.0 - 1e-8), 6, 2, unused)).Kind(0), VertexKind::Convex);
  EXPECT_EQ(Build(Cone(2.0 * dgg::Pi * (1.0 + 1e-8), 6, 2, unused)).Kind(0), VertexKind::Saddle);
}

TEST(SurfaceMesh, KnowsWhereGeodesicsMayBend)
{
  const SurfaceMesh cube = Build(Cube(2));
  for (Id v = 0; v < cube.GetNumberOfVertices(); ++v)
  {
    EXPECT_EQ(cube.IsPassThrough(v), cube.Kind(v) == VertexKind::Flat);
  }
  // An L: three convex corners, one reflex one, straight rims.
  const TestMesh l = Plate(2, 2, [](Id i, Id j) { return !(i == 1 && j == 1); });
  const SurfaceMesh plate = Build(l);
  EXPECT_TRUE(plate.IsPassThrough(VertexAt(l, 1.0, 1.0, 0.0)));
  EXPECT_TRUE(plate.IsPassThrough(VertexAt(l, 1.0, 0.0, 0.0))); // straight
  EXPECT_FALSE(plate.IsPassThrough(VertexAt(l, 0.0, 0.0, 0.0)));
  EXPECT_FALSE(plate.IsPassThrough(VertexAt(l, 2.0, 1.0, 0.0)));
  const SurfaceMesh spheres = Build(TouchingSpheres(1));
  EXPECT_EQ(spheres.Kind(0), VertexKind::Irregular);
  EXPECT_TRUE(spheres.IsPassThrough(0));
}

TEST(SurfaceMesh, KeepsIrregularVerticesApart)
{
  std::vector<Id> sheetOf;
  const TestMesh book = Book(3, 4, sheetOf);
  const SurfaceMesh mesh = Build(book);
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    EXPECT_EQ(mesh.Kind(v) == VertexKind::Irregular, sheetOf[v] == NoId) << v;
  }
  // Each edge of the spine has three half-edges in its cycle.
  Id spineHalfEdges = 0;
  for (Id h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
  {
    const Id twin = mesh.Twin(h);
    spineHalfEdges += twin != NoId && mesh.Twin(twin) != h ? 1 : 0;
  }
  EXPECT_EQ(spineHalfEdges, 12);
}

TEST(SurfaceMesh, TurnsFacesOver)
{
  const TestMesh input = MisorientedSphere(2, 8);
  const SurfaceMesh mesh = Build(input);
  Id flipped = 0;
  for (Id h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
  {
    EXPECT_EQ(mesh.Origin(mesh.Twin(h)), mesh.Destination(h));
    flipped += h % 3 == 0 && mesh.IsFlipped(h / 3) ? 1 : 0;
  }
  EXPECT_GT(flipped, mesh.GetNumberOfFaces() / 4);
  EXPECT_LE(flipped, mesh.GetNumberOfFaces() / 2); // the smaller half is reversed
  // Consistently oriented meshes are unchanged, including inside-out ones.
  TestMesh inside = Icosphere(1);
  for (Id f = 0; f < inside.GetNumberOfFaces(); ++f)
  {
    std::swap(inside.Triangles[3 * f], inside.Triangles[3 * f + 1]);
  }
  const SurfaceMesh kept = Build(inside);
  for (Id f = 0; f < kept.GetNumberOfFaces(); ++f)
  {
    EXPECT_FALSE(kept.IsFlipped(f));
  }
}

TEST(SurfaceMesh, FindsWhatCannotBeOriented)
{
  for (const TestMesh& input : { MoebiusStrip(9, 4), KleinBottle(7, 5) })
  {
    const SurfaceMesh mesh = Build(input);
    Id inconsistent = 0;
    for (Id h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
    {
      const Id twin = mesh.Twin(h);
      if (twin != NoId && mesh.Origin(twin) == mesh.Origin(h))
      {
        ++inconsistent;
        EXPECT_EQ(mesh.Kind(mesh.Origin(h)), VertexKind::Irregular);
      }
    }
    EXPECT_GT(inconsistent, 0);
  }
}

TEST(SurfaceMesh, ComputesComponents)
{
  const TestMesh input = SphereWithIsolatedPoints(1);
  Id count = 0;
  std::vector<Id> component = Build(input).ComputeComponents(count);
  EXPECT_EQ(count, 4);
  EXPECT_EQ(component[0], 0);
  EXPECT_EQ(component[1], 1);
  EXPECT_TRUE(std::all_of(component.begin() + 2, component.end() - 1, [](Id c) { return c == 2; }));
  EXPECT_EQ(component.back(), 3);

  // A point contact connects components.
  component = Build(TouchingSpheres(1)).ComputeComponents(count);
  EXPECT_EQ(count, 1);
  Build(SeveralComponents()).ComputeComponents(count);
  EXPECT_EQ(count, 3);
  Build(SeamPlane(6)).ComputeComponents(count);
  EXPECT_EQ(count, 2);
}

namespace
{
using dgg::NoId;
using dgg::SurfaceMesh;
using dgg::VertexKind;

void ExpectRefused(const dgg::Status& status, const SurfaceMesh& mesh, const std::string& message)
{
  EXPECT_EQ(status.GetCode(), dgg::Status::Code::InvalidInput);
  EXPECT_TRUE(Says(status, message));
  EXPECT_EQ(mesh.GetNumberOfVertices(), 0);
  EXPECT_EQ(mesh.GetNumberOfFaces(), 0);
}

/// Builds a mesh from points, lengths or glued lengths, whichever the input has.
dgg::Status Try(const TestMesh& input, SurfaceMesh& mesh)
{
  const Id vertices = input.GetNumberOfVertices();
  const Id faces = input.GetNumberOfFaces();
  const Id* triangles = input.Triangles.data();
  const double* lengths = input.Lengths.data();
  return input.Lengths.empty()
    ? SurfaceMesh::FromPoints(input.Points.data(), vertices, triangles, faces, mesh)
    : input.Twins.empty()
    ? SurfaceMesh::FromLengths(vertices, triangles, faces, lengths, mesh)
    : SurfaceMesh::FromGluedLengths(vertices, triangles, faces, lengths, input.Twins.data(), mesh);
}

/// Expects an error that leaves an empty mesh.
void ExpectRefused(const TestMesh& input, const std::string& message)
{
  SurfaceMesh mesh = Build(SingleTriangle());
  ExpectRefused(Try(input, mesh), mesh, message);
}

}

TEST(SurfaceMeshLengths, EqualPoints)
{
  // The lengths of an embedded mesh give the same mesh, including misoriented faces.
  TestMesh input = MisorientedSphere(1, 4);
  const SurfaceMesh byPoints = Build(input);
  for (Id h = 0; h < 3 * input.GetNumberOfFaces(); ++h)
  {
    input.Lengths.push_back(
      EuclideanDistance(input, input.Triangles[h], input.Triangles[SurfaceMesh::Next(h)]));
  }
  const SurfaceMesh byLengths = Build(input);
  ASSERT_EQ(byLengths.GetNumberOfHalfEdges(), byPoints.GetNumberOfHalfEdges());
  for (Id h = 0; h < byPoints.GetNumberOfHalfEdges(); ++h)
  {
    EXPECT_EQ(byLengths.Origin(h), byPoints.Origin(h));
    EXPECT_EQ(byLengths.Twin(h), byPoints.Twin(h));
    EXPECT_NEAR(byLengths.Length(h), byPoints.Length(h), 1e-15);
    EXPECT_NEAR(byLengths.PolarAngle(h), byPoints.PolarAngle(h), 1e-13);
  }
}

TEST(SurfaceMeshLengths, GiveFlatSurfaces)
{
  for (const bool glued : { false, true })
  {
    const SurfaceMesh torus = Build(FlatTorus(4.0, 0.5, 3.0, 4, 3, glued));
    for (Id v = 0; v < torus.GetNumberOfVertices(); ++v)
    {
      EXPECT_EQ(torus.Kind(v), VertexKind::Flat);
      EXPECT_NEAR(torus.TotalAngle(v), 2.0 * dgg::Pi, 1e-13);
    }
  }
}

TEST(SurfaceMeshLengths, GlueFewTriangles)
{
  // One vertex, two triangles, three edges: a torus. The faces are kept although all their corners
  // are the same vertex.
  const SurfaceMesh torus = Build(FlatTorus(2.0, 0.0, 1.0, 1, 1, true));
  ASSERT_EQ(torus.GetNumberOfVertices(), 1);
  ASSERT_EQ(torus.GetNumberOfFaces(), 2);
  EXPECT_FALSE(torus.IsDropped(0));
  EXPECT_FALSE(torus.IsDropped(1));
  EXPECT_EQ(torus.Kind(0), VertexKind::Flat);
  EXPECT_EQ(torus.FanEnd(0) - torus.FanBegin(0), 6);
  EXPECT_NEAR(torus.TotalAngle(0), 2.0 * dgg::Pi, 1e-14);
  for (Id h = 0; h < 6; ++h)
  {
    EXPECT_EQ(torus.Twin(torus.Twin(h)), h);
    EXPECT_NE(SurfaceMesh::Face(torus.Twin(h)), SurfaceMesh::Face(h));
  }
}

TEST(SurfaceMeshLengths, TakeTheLargerOfTwoHalves)
{
  TestMesh input;
  input.AbstractVertices = 4;
  input.Triangles = { 0, 1, 2, 1, 0, 3 };
  input.Lengths = { 1.0, 1.0, 1.0, 1.0 + 5e-10, 1.0, 1.0 };
  const SurfaceMesh mesh = Build(input);
  EXPECT_EQ(mesh.Length(0), 1.0 + 5e-10);
  EXPECT_EQ(mesh.Length(3), 1.0 + 5e-10);
}

TEST(SurfaceMeshDegenerate, IsMollifiedAsLittleAsNeeded)
{
  for (const TestMesh& input : { ZippedPlane(6), CollinearPlane(6), CollapsedSphere(2, 12, 9) })
  {
    const SurfaceMesh mesh = Build(input);
    EXPECT_GT(mesh.GetNumberOfDegenerateFaces(), 0);
    EXPECT_GE(mesh.GetNumberOfMollifiedFaces(), mesh.GetNumberOfDegenerateFaces());
    EXPECT_GT(mesh.GetMollification(), 0.0);
    EXPECT_LT(mesh.GetMollification(), 1e-12 * mesh.GetMaximumEdgeLength());
    Id strict = 0;
    for (Id f = 0; f < mesh.GetNumberOfFaces(); ++f)
    {
      const double a = mesh.Length(3 * f);
      const double b = mesh.Length(3 * f + 1);
      const double c = mesh.Length(3 * f + 2);
      strict += a + b > c && b + c > a && c + a > b ? 1 : 0;
    }
    EXPECT_EQ(strict, mesh.GetNumberOfFaces());
  }
}

TEST(SurfaceMeshDegenerate, LeavesLegalSliversAlone)
{
  for (const TestMesh& input : { SliverPlane(6, 1e-9), CapPlane(6, 1e-3), NeedlePlane(4, 1e-9) })
  {
    const SurfaceMesh mesh = Build(input);
    EXPECT_EQ(mesh.GetNumberOfDegenerateFaces(), 0);
    EXPECT_EQ(mesh.GetMollification(), 0.0);
  }
}

TEST(SurfaceMeshDegenerate, TouchesOnlyTheFacesConcerned)
{
  const TestMesh input = CollinearPlane(6);
  const SurfaceMesh mesh = Build(input);
  Id lengthened = 0;
  for (Id h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
  {
    const double length = EuclideanDistance(input, mesh.Origin(h), mesh.Destination(h));
    lengthened += mesh.Length(h) > length * (1.0 + 1e-15) ? 1 : 0;
  }
  EXPECT_GT(lengthened, 0);
  EXPECT_LE(lengthened, 6 * mesh.GetNumberOfMollifiedFaces());
  EXPECT_LT(lengthened, mesh.GetNumberOfHalfEdges() / 2);
}

TEST(SurfaceMeshDegenerate, DropsRepeatedVertices)
{
  const TestMesh input = RepeatedVertexPlane(5);
  const SurfaceMesh mesh = Build(input);
  for (Id f = 0; f < mesh.GetNumberOfFaces(); ++f)
  {
    EXPECT_EQ(mesh.IsDropped(f), f >= mesh.GetNumberOfFaces() - 3);
  }
  const SurfaceMesh plane = Build(Plane(5, 5, 0.2, 5));
  for (Id h = 0; h < plane.GetNumberOfHalfEdges(); ++h)
  {
    EXPECT_EQ(mesh.Twin(h), plane.Twin(h));
  }
}

TEST(SurfaceMeshErrors, RefuseTooManyTriangles)
{
  // No array is read before the counts have been checked.
  SurfaceMesh mesh = Build(SingleTriangle());
  const dgg::Offset many = dgg::Offset(1) << 30;
  ExpectRefused(SurfaceMesh::FromPoints(nullptr, 3, nullptr, many, mesh), mesh, "too large");
  ExpectRefused(SurfaceMesh::FromPoints(nullptr, many << 8, nullptr, 0, mesh), mesh, "too large");
  ExpectRefused(
    SurfaceMesh::FromPoints(nullptr, 3, nullptr, std::numeric_limits<dgg::Offset>::max(), mesh),
    mesh, "too large");
  dgg::SurfaceArrays points;
  points.NumberOfPoints = dgg::Offset(1) << 31;
  dgg::PreparedSurface::Pointer surface;
  EXPECT_TRUE(
    Says(dgg::PreparedSurface::Make(points, dgg::Domain(), {}, surface), "more than 2147483647"));
  ExpectRefused(SurfaceMesh::FromLengths(-1, nullptr, 0, nullptr, mesh), mesh, "-1 points");
  ExpectRefused(SurfaceMesh::FromLengths(1, nullptr, -1, nullptr, mesh), mesh, "-1 triangles");
}

TEST(SurfaceMeshErrors, NameTheBadLength)
{
  const TestMesh good = FlatTorus(4.0, 0.0, 3.0, 4, 3, false);
  for (const double bad : { std::numeric_limits<double>::quiet_NaN(), dgg::Infinity, -1.0 })
  {
    TestMesh input = good;
    input.Lengths[7] = bad;
    ExpectRefused(input, "Use lengths that are finite, not negative");
  }
  TestMesh input = good;
  input.Lengths[7] *= 1.0 + 1e-8; // its twin has a different length
  ExpectRefused(input, "equal on all halves of an edge");
}

TEST(SurfaceMeshErrors, NameTheFaceThatIsNoTriangle)
{
  TestMesh input;
  input.AbstractVertices = 4;
  input.AddTriangle(0, 1, 2);
  input.AddTriangle(0, 2, 3);
  input.Lengths = { 1.0, 1.0, 1.5, 1.5, 1.0, 100.0 };
  SurfaceMesh mesh;
  ExpectRefused(input, "Face 1");
  input.Lengths = { 1.0, 1.0, 2.0, 2.0, 1.0, 1.0 }; // degenerate: mollified, not refused
  ASSERT_TRUE(Try(input, mesh).IsOk());
  EXPECT_EQ(mesh.GetNumberOfDegenerateFaces(), 2);
}

TEST(SurfaceMeshErrors, RefuseBadGluing)
{
  const TestMesh good = FlatTorus(4.0, 0.0, 3.0, 2, 2, true);
  for (const Id bad : { 24, -2, 0, 8 }) // out of range, negative, itself, other vertices
  {
    TestMesh input = good;
    input.Twins[0] = bad;
    ExpectRefused(input, "Half-edge 0 cannot be the twin of half-edge");
  }
  TestMesh input = good;
  input.Twins[0] = NoId;
  ExpectRefused(input, "has a twin in one direction only");
  input = good;
  // Two half-edges with the same twin.
  for (Id h = 1; h < 24; ++h)
  {
    if (h != input.Twins[0] && input.Triangles[h] == input.Triangles[0] &&
      input.Triangles[SurfaceMesh::Next(h)] == input.Triangles[1])
    {
      input.Twins[h] = input.Twins[0];
    }
  }
  ExpectRefused(input, "cannot be the twin of");
}

/// A small face cut out of a large one has the rounding errors of the large face.
TEST(SurfaceMeshLengths, RoundingOfSmallFaces)
{
  TestMesh input;
  input.AbstractVertices = 6;
  input.Triangles = { 0, 1, 2, 3, 4, 5 };
  SurfaceMesh mesh;
  input.Lengths = { 1.0, 1.0, 1.0, 2e-10, 1e-11, 2.1e-10 + 2e-13 };
  EXPECT_TRUE(Try(input, mesh).IsOk());
  EXPECT_TRUE(mesh.IsDegenerate(1));
  EXPECT_GT(mesh.GetMollification(), 0.0);
  input.Lengths.back() = 2.1e-10 + 2e-12;
  ExpectRefused(input, "violate the triangle inequality");
}
}
