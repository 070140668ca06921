// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TestMeshes.h"

namespace dggtest
{
TestMesh Icosphere(int level)
{
  TestMesh mesh = Icosahedron();
  for (int i = 0; i < level; ++i)
  {
    mesh = Subdivided(mesh, 2);
  }
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    double* p = mesh.Points.data() + 3 * v;
    const double norm = std::hypot(p[0], p[1], p[2]);
    for (int i = 0; i < 3; ++i)
    {
      p[i] /= norm;
    }
  }
  return mesh;
}

TestMesh NoisySphere(int level, double noise, std::uint64_t seed)
{
  const TestMesh sphere = Icosphere(level);
  return WithNoise(sphere, noise * MeanEdge(sphere), seed);
}

TestMesh Ellipsoid(int level, double ratio)
{
  TestMesh mesh = Icosphere(level);
  for (std::size_t i = 0; i < mesh.Points.size(); i += 3)
  {
    mesh.Points[i] *= ratio;
  }
  return mesh;
}

TestMesh Terrain(Id n, double roughness, std::uint64_t seed)
{
  TestMesh mesh = Plane(n, n, 0.25, seed);
  Random random(seed + 1);
  for (std::size_t i = 2; i < mesh.Points.size(); i += 3)
  {
    mesh.Points[i] = random.Uniform(-roughness, roughness);
  }
  return mesh;
}

TestMesh Torus(Id nu, Id nv)
{
  return Grid(
    nu, nv,
    [=](Id i, Id j) {
      const double u = 2.0 * dgg::Pi * i / nu;
      const double v = 2.0 * dgg::Pi * j / nv;
      const double r = 1.0 + 0.4 * std::cos(v);
      return std::array<double, 3>{ { r * std::cos(u), r * std::sin(u), 0.4 * std::sin(v) } };
    },
    true, true);
}

TestMesh VoxelSurface(Id nx, Id ny, Id nz, const std::function<bool(Id, Id, Id)>& filled)
{
  const std::array<Id, 3> n{ { nx, ny, nz } };
  auto isFilled = [&](const std::array<Id, 3>& c) {
    for (int i = 0; i < 3; ++i)
    {
      if (c[i] < 0 || c[i] >= n[i])
      {
        return false;
      }
    }
    return filled(c[0], c[1], c[2]);
  };
  TestMesh mesh;
  std::map<std::array<Id, 3>, Id> ids;
  auto vertex = [&](const std::array<Id, 3>& at) {
    const auto found = ids.emplace(at, dgg::NoId);
    if (found.second)
    {
      found.first->second = mesh.AddPoint(at[0], at[1], at[2]);
    }
    return found.first->second;
  };
  for (Id i = 0; i < nx; ++i)
  {
    for (Id j = 0; j < ny; ++j)
    {
      for (Id k = 0; k < nz; ++k)
      {
        const std::array<Id, 3> cell{ { i, j, k } };
        for (int axis = 0; axis < 3 && isFilled(cell); ++axis)
        {
          for (int side = 0; side < 2; ++side)
          {
            std::array<Id, 3> neighbor = cell;
            neighbor[axis] += side == 0 ? -1 : 1;
            if (isFilled(neighbor))
            {
              continue;
            }
            auto corner = [&](Id du, Id dv) {
              std::array<Id, 3> at = cell;
              at[axis] += side;
              at[(axis + 1) % 3] += du;
              at[(axis + 2) % 3] += dv;
              return vertex(at);
            };
            if (side == 1)
            {
              mesh.AddQuad(corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1));
            }
            else
            {
              mesh.AddQuad(corner(0, 0), corner(0, 1), corner(1, 1), corner(1, 0));
            }
          }
        }
      }
    }
  }
  return mesh;
}

TestMesh TwoHoledBlock()
{
  return VoxelSurface(5, 3, 1, [](Id i, Id j, Id) { return !(j == 1 && (i == 1 || i == 3)); });
}

TestMesh DrilledBar(std::uint64_t seed)
{
  Random random(seed);
  const Id holes = 1 + random.Index(3);
  const Id sides = 8 + random.Index(40);
  const double pitch = random.Uniform(10.0, 40.0);
  const double width = random.Uniform(1.0, 5.0);
  const double radius = width * random.Uniform(0.1, 0.3);
  const double thickness = random.Uniform(0.1, 1.1);
  TestMesh mesh;
  using Section = std::array<Id, 4>;
  std::vector<Section> sections; // sections across the bar, between the holes
  for (Id i = 0; i <= holes; ++i)
  {
    const double x = i * pitch;
    sections.push_back({ { mesh.AddPoint(x, 0.0, 0.0), mesh.AddPoint(x, width, 0.0),
      mesh.AddPoint(x, width, thickness), mesh.AddPoint(x, 0.0, thickness) } });
  }
  mesh.AddQuad(sections[0][0], sections[0][3], sections[0][2], sections[0][1]);
  mesh.AddQuad(sections[holes][0], sections[holes][1], sections[holes][2], sections[holes][3]);
  for (Id i = 0; i < holes; ++i)
  {
    const Section& a = sections[i];
    const Section& b = sections[i + 1];
    mesh.AddQuad(a[0], b[0], b[3], a[3]);
    mesh.AddQuad(b[1], a[1], a[2], b[2]);
    // Bottom and top faces around the hole.
    const Section low{ { a[0], b[0], b[1], a[1] } };
    const Section high{ { a[3], b[3], b[2], a[2] } };
    const double x = (i + random.Uniform(0.3, 0.7)) * pitch;
    const double y = 0.5 * width;
    const double turn = random.Uniform();
    std::array<double, 4> angles{};
    for (int c = 0; c < 4; ++c)
    {
      angles[c] = std::atan2(mesh.Point(low[c])[1] - y, mesh.Point(low[c])[0] - x);
    }
    const Id first = mesh.GetNumberOfVertices();
    std::vector<int> nearest; // nearest corner per direction
    for (Id k = 0; k < sides; ++k)
    {
      const double angle = 2.0 * dgg::Pi * (k + turn) / sides;
      const double px = x + radius * std::cos(angle);
      const double py = y + radius * std::sin(angle);
      mesh.AddPoint(px, py, 0.0);
      mesh.AddPoint(px, py, thickness);
      auto isNearer = [&](double p, double q) {
        return std::abs(std::remainder(angle - p, 2.0 * dgg::Pi)) <
          std::abs(std::remainder(angle - q, 2.0 * dgg::Pi));
      };
      nearest.push_back(static_cast<int>(
        std::min_element(angles.begin(), angles.end(), isNearer) - angles.begin()));
    }
    for (Id k = 0; k < sides; ++k)
    {
      const Id p = first + 2 * k;
      const Id q = first + 2 * ((k + 1) % sides);
      mesh.AddQuad(p, p + 1, q + 1, q);
      mesh.AddTriangle(low[nearest[k]], p, q);
      mesh.AddTriangle(high[nearest[k]], q + 1, p + 1);
      for (int c = nearest[k]; c != nearest[(k + 1) % sides]; c = (c + 1) % 4)
      {
        mesh.AddTriangle(low[(c + 1) % 4], low[c], q);
        mesh.AddTriangle(high[c], high[(c + 1) % 4], q + 1);
      }
    }
  }
  return mesh;
}

TestMesh Shaft(Id sides)
{
  TestMesh mesh;
  for (const auto& [radius, height] :
    { std::pair(5.0, 0.0), std::pair(0.5, 0.2), std::pair(0.5, 2.0) })
  {
    for (Id i = 0; i < sides; ++i)
    {
      const double angle = 2.0 * dgg::Pi * i / sides;
      mesh.AddPoint(radius * std::cos(angle), radius * std::sin(angle), height);
    }
  }
  for (Id i = 0; i < sides; ++i)
  {
    const Id next = (i + 1) % sides;
    for (const Id ring : { Id(0), sides })
    {
      mesh.AddTriangle(ring + i, ring + next, ring + sides + next);
      mesh.AddTriangle(ring + i, ring + sides + next, ring + sides + i);
    }
    if (i > 0 && next > 0)
    {
      mesh.AddTriangle(0, next, i);
      mesh.AddTriangle(2 * sides, 2 * sides + i, 2 * sides + next);
    }
  }
  return mesh;
}

TestMesh SeveralComponents()
{
  TestMesh mesh = Icosphere(1);
  Append(mesh, Translated(Torus(9, 6), 5.0, 0.0, 0.0));
  Append(mesh, Translated(Plane(4, 3, 0.2, 5), 0.0, 5.0, 0.0));
  return mesh;
}

std::vector<NamedMesh> SoundMeshes()
{
  return { { "SphereNoise0", NoisySphere(2, 0.0, 1) }, { "SphereNoise10", NoisySphere(2, 0.1, 2) },
    { "SphereNoise25", NoisySphere(2, 0.25, 3) }, { "SphereNoise50", NoisySphere(2, 0.5, 4) },
    { "SphereNoise50Fine", NoisySphere(3, 0.5, 5) }, { "Ellipsoid20", Ellipsoid(2, 20.0) },
    { "Ellipsoid20Noisy", WithNoise(Ellipsoid(2, 20.0), 0.1, 6) },
    { "TerrainGentle", Terrain(14, 0.5, 7) }, { "TerrainRough", Terrain(14, 3.0, 8) },
    { "Torus", Torus(16, 10) }, { "TorusNoisy", WithNoise(Torus(16, 10), 0.08, 9) },
    { "TwoHoles", Subdivided(TwoHoledBlock(), 2) },
    { "TwoHolesNoisy", WithNoise(Subdivided(TwoHoledBlock(), 2), 0.15, 10) },
    { "SeveralComponents", SeveralComponents() }, { "CubeRegular", Cube(5) },
    { "CubeJittered", Cube(5, 0.25, 11) }, { "Grid", Plane(10, 8) },
    { "GridWithHole",
      Plate(
        10, 8, [](Id i, Id j) { return !(i >= 3 && i < 7 && j >= 2 && j < 5); }, 0.2, 12) } };
}
}
