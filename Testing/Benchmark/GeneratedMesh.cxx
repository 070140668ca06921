// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GeneratedMesh.h"

#include "RandomNumbers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace
{
using Vector = std::array<double, 3>;
constexpr unsigned int Seed = 20190521u;

/// Returns a random number with uniform distribution in [-1, 1].
double Shift(RandomNumbers& random)
{
  return 2.0 * (4294967296.0 / 4294967295.0) * random() - 1.0;
}

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
  RandomNumbers random(Seed);
  for (std::size_t i = 0; i < mesh.Points.size(); i += 3)
  {
    Vector p = { mesh.Points[i], mesh.Points[i + 1], mesh.Points[i + 2] };
    for (double& c : p)
    {
      c += 0.2 * edge * Shift(random);
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
  RandomNumbers random(Seed);
  for (int i = 0; i < rings; ++i)
  {
    for (int j = 0; j < sides; ++j)
    {
      const double u = 2.0 * dgg::Pi * (i + 0.2 * Shift(random)) / rings;
      const double v = 2.0 * dgg::Pi * (j + 0.2 * Shift(random)) / sides;
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
