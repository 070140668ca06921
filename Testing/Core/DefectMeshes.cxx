// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TestMeshes.h"

namespace dggtest
{
namespace
{
/// Merges vertex `from` into vertex `to`; `from` has no faces afterwards and is removed.
void Unite(TestMesh& mesh, Id from, Id to)
{
  for (Id& v : mesh.Triangles)
  {
    v = v == from ? to : v;
    v -= v > from ? 1 : 0;
  }
  mesh.Points.erase(mesh.Points.begin() + 3 * from, mesh.Points.begin() + 3 * from + 3);
}

/// Returns `rows` x `columns` squares, each cut into two faces. `id` returns the ids of vertices,
/// which may wrap around. Edge lengths are those of the unit square.
TestMesh LatticeByLengths(Id columns, Id rows, Id vertices, const std::function<Id(Id, Id)>& id)
{
  TestMesh mesh;
  mesh.AbstractVertices = vertices;
  const double diagonal = std::sqrt(2.0);
  for (Id j = 0; j < rows; ++j)
  {
    for (Id i = 0; i < columns; ++i)
    {
      mesh.AddQuad(id(i, j), id(i + 1, j), id(i + 1, j + 1), id(i, j + 1));
      mesh.Lengths.insert(mesh.Lengths.end(), { 1.0, 1.0, diagonal, diagonal, 1.0, 1.0 });
    }
  }
  return mesh;
}
}

TestMesh PinchedPlates(Id links)
{
  TestMesh mesh = Plane(3, 3, 0.2, 1);
  for (Id link = 1; link < links; ++link)
  {
    const Id last = mesh.GetNumberOfVertices() - 1; // upper right corner
    Append(mesh, Translated(Plane(3, 3, 0.2, 1 + link), 3.0 * link, 3.0 * link, 0.0));
    Unite(mesh, last + 1, last);
  }
  return mesh;
}

TestMesh TouchingSpheres(int level)
{
  TestMesh mesh = Icosphere(level);
  const double* p = mesh.Point(0);
  const double x = p[0];
  const double y = p[1];
  const double z = p[2];
  // The second sphere is the point reflection of the first one in vertex 0, so that its vertex 0
  // has the same position.
  TestMesh other = Scaled(mesh, -1.0);
  other = Translated(other, 2.0 * x, 2.0 * y, 2.0 * z);
  const Id first = mesh.GetNumberOfVertices();
  Append(mesh, other);
  Unite(mesh, first, 0);
  return mesh;
}

TestMesh Book(Id sheets, Id n, std::vector<Id>& sheetOf, double jitter, std::uint64_t seed)
{
  TestMesh mesh;
  sheetOf.clear();
  for (Id j = 0; j <= n; ++j)
  {
    mesh.AddPoint(0.0, j, 0.0);
    sheetOf.push_back(dgg::NoId);
  }
  for (Id s = 0; s < sheets; ++s)
  {
    const TestMesh sheet = Plane(n, n, jitter, seed + s);
    const double angle = 2.0 * dgg::Pi * s / sheets;
    std::vector<Id> ids;
    for (Id v = 0; v < sheet.GetNumberOfVertices(); ++v)
    {
      const double* p = sheet.Point(v);
      if (p[0] == 0.0)
      {
        ids.push_back(v / (n + 1));
        continue;
      }
      ids.push_back(mesh.AddPoint(p[0] * std::cos(angle), p[1], p[0] * std::sin(angle)));
      sheetOf.push_back(s);
    }
    for (const Id v : sheet.Triangles)
    {
      mesh.Triangles.push_back(ids[v]);
    }
  }
  return mesh;
}

TestMesh PlaneWithFin(Id n, Id& verticesOfPlane, double jitter, std::uint64_t seed)
{
  TestMesh mesh = Plane(2 * n, n, jitter, seed);
  // Make the cut straight.
  for (Id j = 0; j <= n; ++j)
  {
    mesh.Points[3 * (j * (2 * n + 1) + n)] = n;
  }
  verticesOfPlane = mesh.GetNumberOfVertices();
  const TestMesh fin = Plane(n, n, jitter, seed + 1);
  std::vector<Id> ids;
  for (Id v = 0; v < fin.GetNumberOfVertices(); ++v)
  {
    const double* p = fin.Point(v);
    ids.push_back(p[0] == 0.0 ? (v / (n + 1)) * (2 * n + 1) + n : mesh.AddPoint(n, p[1], p[0]));
  }
  // The fin has the heights of the cut, which are jittered in the plane, so the fin is planar.
  for (const Id v : fin.Triangles)
  {
    mesh.Triangles.push_back(ids[v]);
  }
  return mesh;
}

TestMesh MoebiusStrip(Id columns, Id rows)
{
  return LatticeByLengths(columns, rows, columns * (rows + 1),
    [=](Id i, Id j) { return i < columns ? j * columns + i : (rows - j) * columns; });
}

double MoebiusDistance(Id columns, double x1, double y1, double x2, double y2)
{
  double best = dgg::Infinity;
  for (int k = -4; k <= 4; ++k)
  {
    const double y = k % 2 == 0 ? y2 : -y2;
    best = std::min(best, std::hypot(x2 + k * columns - x1, y - y1));
  }
  return best;
}

TestMesh KleinBottle(Id columns, Id rows)
{
  return LatticeByLengths(columns, rows, columns * rows, [=](Id i, Id j) {
    const Id row = i < columns ? j : rows - j;
    return (row % rows) * columns + i % columns;
  });
}

TestMesh SliverPlane(Id n, double height)
{
  const Id middle = n / 2;
  return Grid(n + 1, n + 2, [=](Id i, Id j) {
    const double y = j <= middle ? j : (j == middle + 1 ? middle + height : j - 1.0);
    return std::array<double, 3>{ { static_cast<double>(i), y, 0.0 } };
  });
}

TestMesh NeedlePlane(Id n, double width)
{
  return Grid(2 * (n + 1), n + 1, [=](Id i, Id j) {
    const double x = i / 2 + (i % 2) * width;
    return std::array<double, 3>{ { x, static_cast<double>(j), 0.0 } };
  });
}

TestMesh CapPlane(Id n, double height)
{
  TestMesh mesh = Plane(n, n);
  const Id faces = mesh.GetNumberOfFaces();
  for (Id f = 0; f < faces; f += 3)
  {
    // The height of the face over its first edge is 1.
    SplitFace(mesh, f, { { 0.5 - 0.5 * height, 0.5 - 0.5 * height, height } });
  }
  return mesh;
}

TestMesh SeamPlane(Id n)
{
  TestMesh mesh = Plane(n / 2, n, 0.2, 3);
  Append(mesh, Translated(Plane(n - n / 2, n, 0.2, 4), n / 2, 0.0, 0.0));
  return mesh;
}

TestMesh ZippedPlane(Id n)
{
  TestMesh mesh = SeamPlane(n);
  const Id left = n / 2;
  const Id firstRight = (left + 1) * (n + 1);
  const Id right = n - left;
  for (Id j = 0; j < n; ++j)
  {
    const Id a = j * (left + 1) + left;
    const Id b = firstRight + j * (right + 1);
    mesh.AddQuad(a, b, b + right + 1, a + left + 1);
  }
  return mesh;
}

TestMesh CollinearPlane(Id n)
{
  TestMesh mesh = Plane(n, n);
  const Id faces = mesh.GetNumberOfFaces();
  for (Id f = 0; f < faces; f += 5)
  {
    // Split the first edge in this face only, and close the gap with a face of zero area.
    const Id a = mesh.Triangles[3 * f];
    const Id b = mesh.Triangles[3 * f + 1];
    const Id c = mesh.Triangles[3 * f + 2];
    const double* p = mesh.Point(a);
    const double* q = mesh.Point(b);
    const Id v = mesh.AddPoint(0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1]), 0.0);
    mesh.Triangles[3 * f + 1] = v;
    mesh.AddTriangle(v, b, c);
    mesh.AddTriangle(a, b, v);
  }
  return mesh;
}

TestMesh RepeatedVertexPlane(Id n)
{
  TestMesh mesh = Plane(n, n, 0.2, 5);
  mesh.AddTriangle(0, 0, 1);
  mesh.AddTriangle(2, 3, 2);
  mesh.AddTriangle(4, 4, 4);
  return mesh;
}

TestMesh DuplicateFaceCube(Id k)
{
  TestMesh mesh = Cube(k, 0.2, 6);
  const Id faces = mesh.GetNumberOfFaces();
  for (Id f = 0; f < faces; f += 3)
  {
    mesh.AddTriangle(mesh.Triangles[3 * f + 1], mesh.Triangles[3 * f + 2], mesh.Triangles[3 * f]);
  }
  return mesh;
}

namespace
{
using Ring = std::vector<std::array<double, 2>>;

Ring Ellipse(Id n, double a, double b)
{
  Ring ring;
  for (Id i = 0; i < n; ++i)
  {
    const double angle = 2.0 * dgg::Pi * i / n;
    ring.push_back({ { a * std::cos(angle), b * std::sin(angle) } });
  }
  return ring;
}

/// Fills the annulus between two rings with a random choice of the possible triangles. Inner points
/// follow the outer ones.
void FillAnnulus(const Ring& outer, const Ring& inner, Id first, Random& random, TestMesh& mesh)
{
  const Id m = static_cast<Id>(outer.size());
  const Id k = static_cast<Id>(inner.size());
  const auto isBeyond = [&](Id o, Id i) {
    const auto& p = outer[o % m];
    const auto& a = inner[(i + k) % k];
    const auto& b = inner[(i + 1) % k];
    return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]) < -1e-9;
  };
  const std::vector<Id> before = mesh.Triangles;
  for (Id o = 0, i = 0; o < m || i < k;)
  {
    const bool canOuter = o < m && (isBeyond(o + 1, i) || isBeyond(o + 1, i - 1));
    const bool canInner = i < k && isBeyond(o, i);
    const bool isOuter = canOuter && (!canInner || random.Uniform() < 0.5);
    if (isOuter)
    {
      mesh.AddTriangle(first + o % m, first + (o + 1) % m, first + m + i % k);
      ++o;
    }
    else if (canInner)
    {
      mesh.AddTriangle(first + o % m, first + m + (i + 1) % k, first + m + i % k);
      ++i;
    }
    else
    {
      mesh.Triangles = before; // no triangle fits: start again
      o = i = 0;
    }
  }
}
}

TestMesh WeldedPlates(Id layers, Id outer, Id inner, std::uint64_t seed)
{
  Random random(seed);
  TestMesh mesh;
  const Ring rings[2] = { Ellipse(outer, 2.2, 2.0), Ellipse(inner, 1.0, 1.0) };
  const Id n = outer + inner;
  for (Id layer = 0; layer <= layers; ++layer)
  {
    for (const Ring& ring : rings)
    {
      for (const auto& p : ring)
      {
        mesh.AddPoint(p[0], p[1], layer);
      }
    }
  }
  for (Id layer = 0; layer < layers; ++layer)
  {
    for (Id i = 0; i < n; ++i)
    {
      const Id next = i + 1 == outer ? 0 : i + 1 == n ? outer : i + 1;
      const Id a = layer * n + i;
      const Id b = layer * n + next;
      mesh.AddTriangle(a, b, b + n);
      mesh.AddTriangle(a, b + n, a + n);
    }
    FillAnnulus(rings[0], rings[1], layer * n, random, mesh);
    FillAnnulus(rings[0], rings[1], (layer + 1) * n, random, mesh);
  }
  return mesh;
}

TestMesh SphereWithIsolatedPoints(int level)
{
  TestMesh mesh;
  mesh.AddPoint(3.0, 0.0, 0.0);
  TestMesh half = NoisySphere(level, 0.1, 7);
  mesh.AddPoint(3.0, 1.0, 0.0);
  Append(mesh, half);
  mesh.AddPoint(3.0, 2.0, 0.0);
  return mesh;
}

TestMesh MisorientedSphere(int level, std::uint64_t seed)
{
  Random random(seed);
  TestMesh mesh = NoisySphere(level, 0.2, seed);
  for (Id f = 0; f < mesh.GetNumberOfFaces(); ++f)
  {
    if (random.Uniform() < 0.5)
    {
      std::swap(mesh.Triangles[3 * f], mesh.Triangles[3 * f + 2]);
    }
  }
  return mesh;
}

TestMesh CollapsedSphere(int level, Id count, std::uint64_t seed)
{
  Random random(seed);
  TestMesh mesh = NoisySphere(level, 0.2, seed);
  for (Id i = 0; i < count; ++i)
  {
    const Id h = random.Index(3 * mesh.GetNumberOfFaces());
    const Id from = mesh.Triangles[h];
    const Id to = mesh.Triangles[h % 3 == 2 ? h - 2 : h + 1];
    std::copy_n(mesh.Points.begin() + 3 * to, 3, mesh.Points.begin() + 3 * from);
  }
  return mesh;
}

std::vector<TestMesh> FlattenedMeshes()
{
  std::vector<TestMesh> meshes;
  for (const double height : { 0.0, 1e-15, 1e-9, 1e-4 })
  {
    for (const std::size_t firstAxis : { 2u, 1u })
    {
      meshes.push_back(NoisySphere(2, 0.3, 7));
      std::vector<double>& points = meshes.back().Points;
      for (std::size_t i = 0; i < points.size(); ++i)
      {
        points[i] *= i % 3 >= firstAxis ? height : 1.0;
      }
    }
  }
  meshes.push_back(Icosahedron());
  std::fill(meshes.back().Points.begin(), meshes.back().Points.end(), 1.0);
  return meshes;
}

std::vector<NamedMesh> DefectMeshes()
{
  std::vector<Id> sheetOf;
  Id unused = 0;
  return { { "PinchedPlates", PinchedPlates(3) }, { "TouchingSpheres", TouchingSpheres(1) },
    { "ThreeSheets", Book(3, 4, sheetOf, 0.2, 2) }, { "FiveSheets", Book(5, 3, sheetOf, 0.2, 3) },
    { "PlaneWithFin", PlaneWithFin(4, unused, 0.2, 4) },
    { "CubesOnEdge", VoxelSurface(2, 2, 1, [](Id i, Id j, Id) { return i == j; }) },
    { "CubesAtCorner", VoxelSurface(2, 2, 2, [](Id i, Id j, Id k) { return i == j && j == k; }) },
    { "Slivers1e-3", SliverPlane(6, 1e-3) }, { "Slivers1e-6", SliverPlane(6, 1e-6) },
    { "Slivers1e-9", SliverPlane(6, 1e-9) }, { "Needles1e-6", NeedlePlane(4, 1e-6) },
    { "Needles1e-9", NeedlePlane(4, 1e-9) },
    { "NeedlesTurned1e-9", MovedRigidly(NeedlePlane(4, 1e-9), 0.7, { { 0.1, 0.2, 0.3 } }) },
    { "Caps1e-3", CapPlane(6, 1e-3) }, { "Caps1e-6", CapPlane(6, 1e-6) },
    { "Caps1e-9", CapPlane(6, 1e-9) }, { "Seam", SeamPlane(6) }, { "Zipped", ZippedPlane(6) },
    { "Collinear", CollinearPlane(6) }, { "RepeatedVertices", RepeatedVertexPlane(5) },
    { "DuplicateFaces", DuplicateFaceCube(3) }, { "IsolatedPoints", SphereWithIsolatedPoints(1) },
    { "Misoriented", MisorientedSphere(2, 8) }, { "Collapsed", CollapsedSphere(2, 12, 9) },
    { "Moebius", MoebiusStrip(9, 4) }, { "KleinBottle", KleinBottle(7, 5) } };
}

TestMesh RandomSoup(Id vertices, Id faces, std::uint64_t seed)
{
  Random random(seed);
  TestMesh mesh;
  for (Id v = 0; v < vertices; ++v)
  {
    const double kind = random.Uniform();
    if (v > 1 && kind < 0.1) // coincides with an earlier point
    {
      const Id u = random.Index(v);
      mesh.AddPoint(mesh.Points[3 * u], mesh.Points[3 * u + 1], mesh.Points[3 * u + 2]);
    }
    else if (v > 1 && kind < 0.25) // midpoint of two earlier points
    {
      const Id a = random.Index(v);
      const Id b = random.Index(v);
      mesh.AddPoint(0.5 * (mesh.Points[3 * a] + mesh.Points[3 * b]),
        0.5 * (mesh.Points[3 * a + 1] + mesh.Points[3 * b + 1]),
        0.5 * (mesh.Points[3 * a + 2] + mesh.Points[3 * b + 2]));
    }
    else if (kind < 0.6) // point of a small lattice
    {
      mesh.AddPoint(random.Index(3), random.Index(3), random.Index(2));
    }
    else
    {
      const double x = random.Uniform(0.0, 2.0);
      const double y = random.Uniform(0.0, 2.0);
      mesh.AddPoint(x, y, random.Uniform(0.0, 2.0));
    }
  }
  for (Id f = 0; f < faces; ++f)
  {
    const Id a = random.Index(vertices);
    // Close ids make shared edges likely.
    const Id b =
      random.Uniform() < 0.6 ? (a + 1 + random.Index(3)) % vertices : random.Index(vertices);
    const Id c =
      random.Uniform() < 0.6 ? (a + 1 + random.Index(5)) % vertices : random.Index(vertices);
    mesh.AddTriangle(a, b, c);
  }
  return mesh;
}

std::vector<NamedMesh> SmallSoups(int count)
{
  std::vector<NamedMesh> meshes;
  for (int seed = 1; seed <= count; ++seed)
  {
    Random random(seed);
    const Id vertices = 3 + random.Index(20);
    const Id faces = 1 + random.Index(50);
    meshes.push_back({ "soup " + std::to_string(seed), RandomSoup(vertices, faces, seed) });
  }
  return meshes;
}

std::vector<NamedMesh> DefectMeshesAndSoups(int soups)
{
  return Joined(DefectMeshes(), SmallSoups(soups));
}

std::vector<NamedMesh> BrokenMeshes(int soups, int collapsed)
{
  std::vector<NamedMesh> meshes = SmallSoups(soups);
  for (int seed = 1; seed <= collapsed; ++seed)
  {
    meshes.push_back({ "collapsed " + std::to_string(seed), CollapsedSphere(2, seed, seed) });
  }
  for (const TestMesh& mesh : FlattenedMeshes())
  {
    meshes.push_back({ "flattened", mesh });
  }
  return meshes;
}

std::vector<NamedMesh> AllMeshes()
{
  return Joined(SoundMeshes(), DefectMeshes());
}
}
