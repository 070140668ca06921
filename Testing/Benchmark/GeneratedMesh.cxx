// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GeneratedMesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <tuple>
#include <utility>

namespace
{
using Vector = std::array<double, 3>;

/// Random numbers that are the same with every standard library (the standard's distributions
/// differ).
class Shift
{
public:
  /// Returns a number with uniform distribution in [-1, 1].
  double operator()() { return 2.0 * static_cast<double>(this->Engine()) / 4294967295.0 - 1.0; }

private:
  std::mt19937 Engine{ 20190521u };
};

Vector PointOf(const MeshArrays& mesh, dgg::Id id)
{
  return { mesh.Points[3 * id], mesh.Points[3 * id + 1], mesh.Points[3 * id + 2] };
}

dgg::Id AddPoint(MeshArrays& mesh, const Vector& p)
{
  mesh.Points.insert(mesh.Points.end(), p.begin(), p.end());
  return static_cast<dgg::Id>(mesh.GetNumberOfVertices()) - 1;
}

void AddTriangle(MeshArrays& mesh, dgg::Id a, dgg::Id b, dgg::Id c)
{
  mesh.Triangles.insert(mesh.Triangles.end(), { a, b, c });
}

void Normalize(Vector& p)
{
  const double norm = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
  for (double& c : p)
  {
    c /= norm;
  }
}

MeshArrays Icosahedron()
{
  const double g = 0.5 * (1.0 + std::sqrt(5.0));
  MeshArrays mesh;
  mesh.Points = { -1, g, 0, 1, g, 0, -1, -g, 0, 1, -g, 0, 0, -1, g, 0, 1, g, 0, -1, -g, 0, 1, -g, g,
    0, -1, g, 0, 1, -g, 0, -1, -g, 0, 1 };
  mesh.Triangles = { 0, 11, 5, 0, 5, 1, 0, 1, 7, 0, 7, 10, 0, 10, 11, 1, 5, 9, 5, 11, 4, 11, 10, 2,
    10, 7, 6, 7, 1, 8, 3, 9, 4, 3, 4, 2, 3, 2, 6, 3, 6, 8, 3, 8, 9, 4, 9, 5, 2, 4, 11, 6, 2, 10, 8,
    6, 7, 9, 8, 1 };
  return mesh;
}

/// Splits every triangle into four.
void Split(MeshArrays& mesh)
{
  std::map<std::pair<dgg::Id, dgg::Id>, dgg::Id> middles;
  const auto middle = [&](dgg::Id a, dgg::Id b) {
    const auto inserted = middles.insert({ std::minmax(a, b), 0 });
    if (inserted.second)
    {
      const Vector p = PointOf(mesh, a);
      const Vector q = PointOf(mesh, b);
      inserted.first->second =
        AddPoint(mesh, { 0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1]), 0.5 * (p[2] + q[2]) });
    }
    return inserted.first->second;
  };
  const std::vector<dgg::Id> old = std::move(mesh.Triangles);
  mesh.Triangles.clear();
  for (std::size_t h = 0; h < old.size(); h += 3)
  {
    const dgg::Id ab = middle(old[h], old[h + 1]);
    const dgg::Id bc = middle(old[h + 1], old[h + 2]);
    const dgg::Id ca = middle(old[h + 2], old[h]);
    AddTriangle(mesh, old[h], ab, ca);
    AddTriangle(mesh, old[h + 1], bc, ab);
    AddTriangle(mesh, old[h + 2], ca, bc);
    AddTriangle(mesh, ab, bc, ca);
  }
}
}

MeshArrays Icosphere(int level)
{
  MeshArrays mesh = Icosahedron();
  for (int i = 0; i < level; ++i)
  {
    Split(mesh);
  }
  for (std::size_t i = 0; i < mesh.Points.size(); i += 3)
  {
    Vector p = { mesh.Points[i], mesh.Points[i + 1], mesh.Points[i + 2] };
    Normalize(p);
    std::copy(p.begin(), p.end(), mesh.Points.begin() + static_cast<std::ptrdiff_t>(i));
  }
  return mesh;
}

MeshArrays BumpySphere(int level, double amplitude)
{
  MeshArrays mesh = Icosphere(level);
  const double edge = 1.1 / static_cast<double>(1 << level);
  Shift shift;
  for (std::size_t i = 0; i < mesh.Points.size(); i += 3)
  {
    Vector p = { mesh.Points[i], mesh.Points[i + 1], mesh.Points[i + 2] };
    for (double& c : p)
    {
      c += 0.2 * edge * shift();
    }
    Normalize(p);
    const double r = 1.0 +
      amplitude * std::sin(7.0 * p[0] + 1.0) * std::sin(5.0 * p[1]) * std::cos(6.0 * p[2] - 0.5);
    for (std::size_t k = 0; k < 3; ++k)
    {
      mesh.Points[i + k] = r * p[k];
    }
  }
  return mesh;
}

MeshArrays Torus(int rings, int sides)
{
  MeshArrays mesh;
  Shift shift;
  for (int i = 0; i < rings; ++i)
  {
    for (int j = 0; j < sides; ++j)
    {
      const double u = 2.0 * dgg::Pi * (i + 0.2 * shift()) / rings;
      const double v = 2.0 * dgg::Pi * (j + 0.2 * shift()) / sides;
      const double r = 1.0 + 0.4 * std::cos(v);
      AddPoint(mesh, { r * std::cos(u), r * std::sin(u), 0.4 * std::sin(v) });
    }
  }
  for (int i = 0; i < rings; ++i)
  {
    for (int j = 0; j < sides; ++j)
    {
      const int a = i * sides + j;
      const int b = (i + 1) % rings * sides + j;
      const int c = (i + 1) % rings * sides + (j + 1) % sides;
      const int d = i * sides + (j + 1) % sides;
      AddTriangle(mesh, a, b, c);
      AddTriangle(mesh, a, c, d);
    }
  }
  return mesh;
}

MeshArrays HillWithHole(int side)
{
  const int holeBegin = side / 3;
  const int holeEnd = 2 * side / 3;
  const auto inHole = [&](int i, int j) {
    return i >= holeBegin && i < holeEnd && j >= holeBegin && j < holeEnd;
  };

  MeshArrays mesh;
  Shift shift;
  std::vector<dgg::Id> ids(static_cast<std::size_t>(side) * side, dgg::NoId);
  for (int i = 0; i < side; ++i)
  {
    for (int j = 0; j < side; ++j)
    {
      const double step = 1.0 / (side - 1);
      const double x = step * (i + 0.2 * shift());
      const double y = step * (j + 0.2 * shift());
      const double z = 0.15 * std::sin(9.0 * x) * std::cos(7.0 * y);
      // The points strictly inside the hole have no face.
      const bool used =
        !(inHole(i, j) && inHole(i - 1, j) && inHole(i, j - 1) && inHole(i - 1, j - 1));
      ids[i * side + j] = used ? AddPoint(mesh, { x, y, z }) : dgg::NoId;
    }
  }
  for (int i = 0; i + 1 < side; ++i)
  {
    for (int j = 0; j + 1 < side; ++j)
    {
      if (!inHole(i, j))
      {
        const dgg::Id* row = ids.data() + i * side + j;
        AddTriangle(mesh, row[0], row[side], row[side + 1]);
        AddTriangle(mesh, row[0], row[side + 1], row[1]);
      }
    }
  }
  return mesh;
}

MeshArrays Cuboid(double x, double y, double z, int steps, double jitter)
{
  const Vector extent = { x, y, z };
  const double step = std::max({ x, y, z }) / steps;
  std::array<int, 3> count;
  for (int k = 0; k < 3; ++k)
  {
    count[k] = std::max(1, static_cast<int>(std::lround(extent[k] / step)));
  }

  MeshArrays mesh;
  Shift shift;
  std::map<std::tuple<int, int, int>, dgg::Id> ids;
  const auto idOf = [&](const std::array<int, 3>& at) {
    const auto inserted = ids.insert({ std::make_tuple(at[0], at[1], at[2]), 0 });
    if (inserted.second)
    {
      Vector p;
      int rims = 0;
      for (int k = 0; k < 3; ++k)
      {
        p[k] = extent[k] * at[k] / count[k];
        rims += at[k] == 0 || at[k] == count[k] ? 1 : 0;
      }
      for (int k = 0; k < 3; ++k)
      {
        // Points on edges of the cuboid are not moved, because the shape must not change.
        if (rims == 1 && at[k] != 0 && at[k] != count[k])
        {
          p[k] += jitter * extent[k] / count[k] * shift();
        }
      }
      inserted.first->second = AddPoint(mesh, p);
    }
    return inserted.first->second;
  };
  for (int axis = 0; axis < 3; ++axis)
  {
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    for (int end = 0; end < 2; ++end)
    {
      for (int i = 0; i < count[u]; ++i)
      {
        for (int j = 0; j < count[v]; ++j)
        {
          const auto corner = [&](int du, int dv) {
            std::array<int, 3> at;
            at[axis] = end * count[axis];
            at[u] = i + du;
            at[v] = j + dv;
            return idOf(at);
          };
          const dgg::Id a = corner(0, 0);
          const dgg::Id b = end == 1 ? corner(1, 0) : corner(0, 1);
          const dgg::Id c = corner(1, 1);
          const dgg::Id d = end == 1 ? corner(0, 1) : corner(1, 0);
          AddTriangle(mesh, a, b, c);
          AddTriangle(mesh, a, c, d);
        }
      }
    }
  }
  return mesh;
}
