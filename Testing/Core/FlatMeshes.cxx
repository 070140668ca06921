// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TestMeshes.h"

#include <stdexcept>

namespace dggtest
{
TestMesh Plane(Id nx, Id ny, double jitter, std::uint64_t seed)
{
  return Plate(
    nx, ny, [](Id, Id) { return true; }, jitter, seed);
}

TestMesh Plate(
  Id nx, Id ny, const std::function<bool(Id, Id)>& keep, double jitter, std::uint64_t seed)
{
  Random random(seed);
  auto kept = [&](Id i, Id j) { return i >= 0 && j >= 0 && i < nx && j < ny && keep(i, j); };
  TestMesh mesh;
  std::vector<Id> ids;
  for (Id j = 0; j <= ny; ++j)
  {
    for (Id i = 0; i <= nx; ++i)
    {
      const int cells = kept(i - 1, j - 1) + kept(i, j - 1) + kept(i - 1, j) + kept(i, j);
      const double dx = jitter * random.Uniform(-1.0, 1.0);
      const double dy = jitter * random.Uniform(-1.0, 1.0);
      const double move = cells == 4 ? 1.0 : 0.0;
      ids.push_back(cells > 0 ? mesh.AddPoint(i + move * dx, j + move * dy, 0.0) : dgg::NoId);
    }
  }
  for (Id j = 0; j < ny; ++j)
  {
    for (Id i = 0; i < nx; ++i)
    {
      if (kept(i, j))
      {
        const Id corner = j * (nx + 1) + i;
        mesh.AddQuad(ids[corner], ids[corner + 1], ids[corner + nx + 2], ids[corner + nx + 1]);
      }
    }
  }
  return mesh;
}

TestMesh SlitPlane(Id n, std::vector<bool>& isLower, double jitter, std::uint64_t seed)
{
  TestMesh mesh = Translated(Plane(2 * n, 2 * n), -n, -n, 0.0);
  Random random(seed);
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    double* p = mesh.Points.data() + 3 * v;
    const double dx = jitter * random.Uniform(-1.0, 1.0);
    const double dy = jitter * random.Uniform(-1.0, 1.0);
    const bool onRim = std::abs(p[0]) == n || std::abs(p[1]) == n;
    if (!onRim && !(p[1] == 0.0 && p[0] >= 0.0))
    {
      p[0] += dx;
      p[1] += dy;
    }
  }
  std::map<Id, Id> copies;
  const Id faces = mesh.GetNumberOfFaces();
  isLower.assign(mesh.GetNumberOfVertices(), false);
  for (Id f = 0; f < faces; ++f)
  {
    double y = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      y += mesh.Point(mesh.Triangles[3 * f + k])[1];
    }
    for (int k = 0; k < 3; ++k)
    {
      Id& v = mesh.Triangles[3 * f + k];
      const double px = mesh.Point(v)[0];
      if (y < 0.0 && px > 0.0 && mesh.Point(v)[1] == 0.0)
      {
        const auto found = copies.emplace(v, dgg::NoId);
        if (found.second)
        {
          found.first->second = mesh.AddPoint(px, 0.0, 0.0);
          isLower.push_back(true);
        }
        v = found.first->second;
      }
    }
  }
  for (std::size_t v = 0; v < isLower.size(); ++v)
  {
    isLower[v] = isLower[v] || mesh.Points[3 * v + 1] < 0.0;
  }
  return mesh;
}

TestMesh PrismSide(Id sides, Id columns, Id rows, double jitter, std::uint64_t seed)
{
  Random random(seed);
  const double radius = 0.5 / std::sin(dgg::Pi / sides);
  return Grid(
    sides * columns, rows + 1,
    [&](Id i, Id j) {
      const double angle = 2.0 * dgg::Pi * (i / columns) / sides;
      const double next = 2.0 * dgg::Pi * (i / columns + 1) / sides;
      const double t = static_cast<double>(i % columns) / columns;
      const double lift = jitter * random.Uniform(-1.0, 1.0);
      return std::array<double, 3>{ { radius * ((1.0 - t) * std::cos(angle) + t * std::cos(next)),
        radius * ((1.0 - t) * std::sin(angle) + t * std::sin(next)),
        j + (j > 0 && j < rows ? lift : 0.0) } };
    },
    true);
}

TestMesh Cone(double total, Id wedges, Id rings, std::vector<ConePoint>& coordinates, double jitter,
  std::uint64_t seed)
{
  Random random(seed);
  TestMesh mesh;
  coordinates.assign(1, ConePoint());
  for (Id ring = 1; ring <= rings; ++ring)
  {
    for (Id i = 0; i < wedges; ++i)
    {
      const double move = ring < rings ? jitter : 0.0;
      coordinates.push_back({ (ring + move * random.Uniform(-1.0, 1.0)) / rings,
        total * (i + move * random.Uniform(-1.0, 1.0)) / wedges });
    }
  }
  mesh.AbstractVertices = static_cast<Id>(coordinates.size());
  for (Id i = 0; i < wedges; ++i)
  {
    const Id next = (i + 1) % wedges;
    mesh.AddTriangle(0, 1 + i, 1 + next);
    for (Id ring = 1; ring < rings; ++ring)
    {
      const Id in = 1 + (ring - 1) * wedges;
      const Id out = in + wedges;
      mesh.AddQuad(in + i, out + i, out + next, in + next);
    }
  }
  for (Id h = 0; h < 3 * mesh.GetNumberOfFaces(); ++h)
  {
    const Id a = mesh.Triangles[h];
    const Id b = mesh.Triangles[h % 3 == 2 ? h - 2 : h + 1];
    mesh.Lengths.push_back(
      ConeDistance(total, coordinates[std::min(a, b)], coordinates[std::max(a, b)]));
  }
  return mesh;
}

double ConeDistance(double total, const ConePoint& p, const ConePoint& q)
{
  double turn = std::abs(std::fmod(p.Angle - q.Angle, total));
  turn = std::min(turn, total - turn);
  if (turn >= dgg::Pi)
  {
    return p.Radius + q.Radius;
  }
  const double s = std::sin(0.5 * turn);
  const double difference = p.Radius - q.Radius;
  return std::sqrt(difference * difference + 4.0 * p.Radius * q.Radius * s * s);
}

TestMesh Box(
  Id nx, Id ny, Id nz, double sx, double sy, double sz, double jitter, std::uint64_t seed)
{
  Random random(seed);
  TestMesh mesh;
  const std::array<Id, 3> n{ { nx, ny, nz } };
  const std::array<double, 3> s{ { sx, sy, sz } };
  std::map<std::array<Id, 3>, Id> ids;
  auto vertex = [&](const std::array<Id, 3>& at) {
    const auto found = ids.emplace(at, dgg::NoId);
    if (found.second)
    {
      std::array<double, 3> p{};
      int fixed = 0;
      for (int i = 0; i < 3; ++i)
      {
        fixed += at[i] == 0 || at[i] == n[i] ? 1 : 0;
      }
      for (int i = 0; i < 3; ++i)
      {
        const bool moves = fixed == 1 && at[i] > 0 && at[i] < n[i];
        p[i] = s[i] * (at[i] + (moves ? jitter * random.Uniform(-1.0, 1.0) : 0.0));
      }
      found.first->second = mesh.AddPoint(p[0], p[1], p[2]);
    }
    return found.first->second;
  };
  for (int axis = 0; axis < 3; ++axis)
  {
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    for (int side = 0; side < 2; ++side)
    {
      for (Id i = 0; i < n[u]; ++i)
      {
        for (Id j = 0; j < n[v]; ++j)
        {
          auto corner = [&](Id di, Id dj) {
            std::array<Id, 3> at{};
            at[axis] = side * n[axis];
            at[u] = i + di;
            at[v] = j + dj;
            return vertex(at);
          };
          const Id a = corner(0, 0);
          const Id b = corner(1, 0);
          const Id c = corner(1, 1);
          const Id d = corner(0, 1);
          if (side == 1)
          {
            mesh.AddQuad(a, b, c, d);
          }
          else
          {
            mesh.AddQuad(a, d, c, b);
          }
        }
      }
    }
  }
  return mesh;
}

TestMesh Cube(Id k, double jitter, std::uint64_t seed)
{
  return Box(k, k, k, 1.0 / k, 1.0 / k, 1.0 / k, jitter, seed);
}

Id VertexAt(const TestMesh& mesh, double x, double y, double z)
{
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    const double* p = mesh.Point(v);
    if (std::hypot(p[0] - x, p[1] - y, p[2] - z) < 1e-9)
    {
      return v;
    }
  }
  throw std::runtime_error("no vertex at the wanted position");
}

TestMesh Tetrahedron()
{
  // Vertices at alternate corners of a cube of edge 1/sqrt(2).
  const double a = 0.5 / std::sqrt(2.0);
  TestMesh mesh;
  mesh.Points = { a, a, a, a, -a, -a, -a, a, -a, -a, -a, a };
  mesh.Triangles = { 0, 1, 2, 0, 2, 3, 0, 3, 1, 1, 3, 2 };
  return mesh;
}

TestMesh Octahedron()
{
  const double a = 1.0 / std::sqrt(2.0);
  TestMesh mesh;
  mesh.Points = { a, 0, 0, -a, 0, 0, 0, a, 0, 0, -a, 0, 0, 0, a, 0, 0, -a };
  mesh.Triangles = { 0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5 };
  return mesh;
}

TestMesh Icosahedron()
{
  const double g = 0.25 * (1.0 + std::sqrt(5.0));
  TestMesh mesh;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const double s : { 0.5, -0.5 })
    {
      for (const double t : { g, -g })
      {
        std::array<double, 3> p{};
        p[(axis + 1) % 3] = s;
        p[(axis + 2) % 3] = t;
        mesh.AddPoint(p[0], p[1], p[2]);
      }
    }
  }
  // The faces are the triples of vertices at mutual distance 1, oriented outward.
  auto adjacent = [&](Id a, Id b) { return std::abs(EuclideanDistance(mesh, a, b) - 1.0) < 1e-9; };
  for (Id a = 0; a < 12; ++a)
  {
    for (Id b = a + 1; b < 12; ++b)
    {
      for (Id c = b + 1; c < 12; ++c)
      {
        if (adjacent(a, b) && adjacent(b, c) && adjacent(c, a))
        {
          const double* p = mesh.Point(a);
          const double* q = mesh.Point(b);
          const double* r = mesh.Point(c);
          const double volume = p[0] * (q[1] * r[2] - q[2] * r[1]) +
            p[1] * (q[2] * r[0] - q[0] * r[2]) + p[2] * (q[0] * r[1] - q[1] * r[0]);
          mesh.AddTriangle(a, volume > 0.0 ? b : c, volume > 0.0 ? c : b);
        }
      }
    }
  }
  return mesh;
}

TestMesh Dodecahedron()
{
  // The dodecahedron has a vertex above each face of an icosahedron and a pentagon around each of
  // the vertices.
  const TestMesh dual = Icosahedron();
  TestMesh mesh;
  for (Id f = 0; f < dual.GetNumberOfFaces(); ++f)
  {
    std::array<double, 3> p{};
    for (int k = 0; k < 3; ++k)
    {
      for (int i = 0; i < 3; ++i)
      {
        p[i] += dual.Point(dual.Triangles[3 * f + k])[i] / 3.0;
      }
    }
    mesh.AddPoint(p[0], p[1], p[2]);
  }
  for (Id v = 0; v < dual.GetNumberOfVertices(); ++v)
  {
    // Turn around v: the face that contains (v, b) follows the face (v, a, b).
    std::map<Id, std::pair<Id, Id>> step; // from a to b, through a face
    for (Id f = 0; f < dual.GetNumberOfFaces(); ++f)
    {
      for (int k = 0; k < 3; ++k)
      {
        if (dual.Triangles[3 * f + k] == v)
        {
          step[dual.Triangles[3 * f + (k + 1) % 3]] = { dual.Triangles[3 * f + (k + 2) % 3], f };
        }
      }
    }
    std::vector<Id> pentagon;
    Id at = step.begin()->first;
    for (int i = 0; i < 5; ++i)
    {
      pentagon.push_back(step.at(at).second);
      at = step.at(at).first;
    }
    for (int i = 1; i + 1 < 5; ++i)
    {
      mesh.AddTriangle(pentagon[0], pentagon[i], pentagon[i + 1]);
    }
  }
  const double edge = EuclideanDistance(mesh, mesh.Triangles[0], mesh.Triangles[1]);
  return Scaled(mesh, 1.0 / edge);
}

TestMesh FlatTorus(double ux, double vx, double vy, Id nx, Id ny, bool glued)
{
  TestMesh mesh;
  mesh.AbstractVertices = nx * ny;
  auto id = [&](Id i, Id j) { return (j % ny) * nx + i % nx; };
  const double along = ux / nx;
  const double up = std::hypot(vx, vy) / ny;
  const double diagonal = std::hypot(ux / nx + vx / ny, vy / ny);
  for (Id j = 0; j < ny; ++j)
  {
    for (Id i = 0; i < nx; ++i)
    {
      mesh.AddQuad(id(i, j), id(i + 1, j), id(i + 1, j + 1), id(i, j + 1));
      mesh.Lengths.insert(mesh.Lengths.end(), { along, up, diagonal, diagonal, along, up });
      if (glued)
      {
        // Half-edges of the parallelogram: 0 bottom, 1 right, 2 and 3 diagonal, 4 top, 5 left.
        auto half = [&](Id a, Id b, Id k) { return 6 * ((b % ny) * nx + a % nx) + k; };
        mesh.Twins.insert(mesh.Twins.end(),
          { half(i, j + ny - 1, 4), half(i + 1, j, 5), half(i, j, 3), half(i, j, 2),
            half(i, j + 1, 0), half(i + nx - 1, j, 1) });
      }
    }
  }
  return mesh;
}

double FlatTorusDistance(double ux, double vx, double vy, double dx, double dy)
{
  double best = dgg::Infinity;
  for (int i = -4; i <= 4; ++i)
  {
    for (int j = -4; j <= 4; ++j)
    {
      best = std::min(best, std::hypot(dx + i * ux + j * vx, dy + j * vy));
    }
  }
  return best;
}

TestMesh DoublyCoveredPolygon(Id sides, Id rings, std::vector<bool>& isBack)
{
  TestMesh mesh;
  isBack.clear();
  auto addRing = [&](Id ring, bool back) {
    for (Id i = 0; i < sides; ++i)
    {
      const double angle = 2.0 * dgg::Pi * i / sides;
      const double radius = static_cast<double>(ring) / rings;
      mesh.AddPoint(radius * std::cos(angle), radius * std::sin(angle), 0.0);
      isBack.push_back(back);
    }
  };
  addRing(rings, false); // shared rim
  for (int side = 0; side < 2; ++side)
  {
    const Id centre = mesh.AddPoint(0.0, 0.0, 0.0);
    isBack.push_back(side == 1);
    for (Id ring = 1; ring < rings; ++ring)
    {
      addRing(ring, side == 1);
    }
    auto first = [&](Id ring) { return ring == rings ? 0 : centre + 1 + (ring - 1) * sides; };
    for (Id i = 0; i < sides; ++i)
    {
      const Id next = (i + 1) % sides;
      auto add = [&](
                   Id a, Id b, Id c) { mesh.AddTriangle(a, side == 0 ? b : c, side == 0 ? c : b); };
      add(centre, first(1) + i, first(1) + next);
      for (Id ring = 1; ring < rings; ++ring)
      {
        add(first(ring) + i, first(ring + 1) + i, first(ring + 1) + next);
        add(first(ring) + i, first(ring + 1) + next, first(ring) + next);
      }
    }
  }
  return mesh;
}

TestMesh SingleTriangle()
{
  TestMesh mesh;
  mesh.Points = { 0.0, 0.0, 0.0, 4.0, 0.0, 0.0, 1.0, 3.0, 0.0 };
  mesh.Triangles = { 0, 1, 2 };
  return mesh;
}

TestMesh TwoTriangles(double fold)
{
  TestMesh mesh;
  mesh.Points = { 0.0, 0.0, 0.0, 0.0, 2.0, 0.0, -1.5, 0.5, 0.0, 2.0 * std::cos(fold), 1.25,
    2.0 * std::sin(fold) };
  mesh.Triangles = { 0, 1, 2, 1, 0, 3 };
  return mesh;
}
}
