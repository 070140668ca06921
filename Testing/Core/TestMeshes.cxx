// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TestMeshes.h"

#include <stdexcept>

namespace dggtest
{
std::vector<double> RandomValues(std::size_t count, std::uint64_t seed)
{
  Random random(seed);
  std::vector<double> values(count);
  for (double& value : values)
  {
    value = random.Uniform(-1.0, 1.0);
  }
  return values;
}

Id TestMesh::AddPoint(double x, double y, double z)
{
  this->Points.insert(this->Points.end(), { x, y, z });
  return this->GetNumberOfVertices() - 1;
}

void TestMesh::AddTriangle(Id a, Id b, Id c)
{
  this->Triangles.insert(this->Triangles.end(), { a, b, c });
}

void TestMesh::AddQuad(Id a, Id b, Id c, Id d)
{
  this->AddTriangle(a, b, c);
  this->AddTriangle(a, c, d);
}

std::vector<NamedMesh> Joined(std::vector<NamedMesh> some, const std::vector<NamedMesh>& others)
{
  some.insert(some.end(), others.begin(), others.end());
  return some;
}

dgg::SurfaceMesh Build(const TestMesh& mesh)
{
  dgg::SurfaceMesh result;
  dgg::Status status;
  if (!mesh.Twins.empty())
  {
    status = dgg::SurfaceMesh::FromGluedLengths(mesh.GetNumberOfVertices(), mesh.Triangles.data(),
      mesh.GetNumberOfFaces(), mesh.Lengths.data(), mesh.Twins.data(), result);
  }
  else if (!mesh.Lengths.empty())
  {
    status = dgg::SurfaceMesh::FromLengths(mesh.GetNumberOfVertices(), mesh.Triangles.data(),
      mesh.GetNumberOfFaces(), mesh.Lengths.data(), result);
  }
  else
  {
    status = dgg::SurfaceMesh::FromPoints(mesh.Points.data(), mesh.GetNumberOfVertices(),
      mesh.Triangles.data(), mesh.GetNumberOfFaces(), result);
  }
  if (!status.IsOk())
  {
    throw std::runtime_error(status.GetMessage());
  }
  return result;
}

TestMesh Grid(Id columns, Id rows, const std::function<std::array<double, 3>(Id, Id)>& place,
  bool rowsGoAround, bool columnsGoAround)
{
  TestMesh mesh;
  for (Id j = 0; j < rows; ++j)
  {
    for (Id i = 0; i < columns; ++i)
    {
      const std::array<double, 3> p = place(i, j);
      mesh.AddPoint(p[0], p[1], p[2]);
    }
  }
  for (Id j = 0; j < (columnsGoAround ? rows : rows - 1); ++j)
  {
    for (Id i = 0; i < (rowsGoAround ? columns : columns - 1); ++i)
    {
      const Id right = (i + 1) % columns;
      const Id up = (j + 1) % rows * columns;
      mesh.AddQuad(j * columns + i, j * columns + right, up + right, up + i);
    }
  }
  return mesh;
}

double EuclideanDistance(const TestMesh& mesh, Id a, Id b)
{
  const double* p = mesh.Point(a);
  const double* q = mesh.Point(b);
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

double DirectionOf(const TestMesh& plane, Id from, Id to)
{
  return std::atan2(
    plane.Point(to)[1] - plane.Point(from)[1], plane.Point(to)[0] - plane.Point(from)[0]);
}

double FanAngle(const TestMesh& plane, const dgg::SurfaceMesh& mesh, Id v)
{
  return DirectionOf(plane, v, mesh.Destination(*mesh.FanBegin(v)));
}

void Append(TestMesh& mesh, const TestMesh& other)
{
  const Id shift = mesh.GetNumberOfVertices();
  mesh.Points.insert(mesh.Points.end(), other.Points.begin(), other.Points.end());
  for (const Id v : other.Triangles)
  {
    mesh.Triangles.push_back(v + shift);
  }
}

TestMesh Translated(const TestMesh& mesh, double x, double y, double z)
{
  TestMesh result = mesh;
  const double shift[3] = { x, y, z };
  for (std::size_t i = 0; i < result.Points.size(); ++i)
  {
    result.Points[i] += shift[i % 3];
  }
  return result;
}

TestMesh Scaled(const TestMesh& mesh, double factor)
{
  TestMesh result = mesh;
  for (double& x : result.Points)
  {
    x *= factor;
  }
  for (double& x : result.Lengths)
  {
    x *= factor;
  }
  return result;
}

TestMesh MovedRigidly(const TestMesh& mesh, double angle, const std::array<double, 3>& shift)
{
  // Rodrigues' formula.
  const double norm = std::sqrt(14.0);
  const double axis[3] = { 1.0 / norm, 2.0 / norm, 3.0 / norm };
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  TestMesh result = mesh;
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    const double* p = mesh.Point(v);
    const double along = axis[0] * p[0] + axis[1] * p[1] + axis[2] * p[2];
    for (int i = 0; i < 3; ++i)
    {
      const int j = (i + 1) % 3;
      const int k = (i + 2) % 3;
      const double cross = axis[j] * p[k] - axis[k] * p[j];
      result.Points[3 * v + i] = c * p[i] + s * cross + (1.0 - c) * along * axis[i] + shift[i];
    }
  }
  return result;
}

TestMesh WithNoise(const TestMesh& mesh, double amount, std::uint64_t seed)
{
  Random random(seed);
  TestMesh result = mesh;
  for (double& x : result.Points)
  {
    x += random.Uniform(-amount, amount);
  }
  return result;
}

TestMesh Renumbered(const TestMesh& mesh, const std::vector<Id>& newIds, std::uint64_t seed)
{
  TestMesh result;
  result.AbstractVertices = mesh.AbstractVertices;
  result.Points.resize(mesh.Points.size());
  for (std::size_t i = 0; i < mesh.Points.size(); ++i)
  {
    result.Points[3 * static_cast<std::size_t>(newIds[i / 3]) + i % 3] = mesh.Points[i];
  }
  Random random(seed);
  for (const Id f : RandomPermutation(mesh.GetNumberOfFaces(), seed + 1))
  {
    const Id first = random.Index(3);
    for (Id k = 0; k < 3; ++k)
    {
      result.Triangles.push_back(newIds[mesh.Triangles[3 * f + (first + k) % 3]]);
      if (!mesh.Lengths.empty())
      {
        result.Lengths.push_back(mesh.Lengths[3 * f + (first + k) % 3]);
      }
    }
  }
  return result;
}

std::vector<Id> RandomPermutation(Id count, std::uint64_t seed)
{
  Random random(seed);
  std::vector<Id> ids(static_cast<std::size_t>(count));
  std::iota(ids.begin(), ids.end(), 0);
  for (Id i = count - 1; i > 0; --i)
  {
    std::swap(ids[i], ids[random.Index(i + 1)]);
  }
  return ids;
}

Id SplitFace(TestMesh& mesh, Id face, const std::array<double, 3>& barycentric)
{
  std::array<Id, 3> corner{};
  std::array<double, 3> p{};
  for (int k = 0; k < 3; ++k)
  {
    corner[k] = mesh.Triangles[3 * face + k];
    for (int i = 0; i < 3; ++i)
    {
      p[i] += barycentric[k] * mesh.Point(corner[k])[i];
    }
  }
  const Id v = mesh.AddPoint(p[0], p[1], p[2]);
  mesh.Triangles[3 * face + 2] = v;
  mesh.AddTriangle(corner[1], corner[2], v);
  mesh.AddTriangle(corner[2], corner[0], v);
  return v;
}

Id SplitEdge(TestMesh& mesh, Id a, Id b, double t)
{
  std::array<double, 3> p{};
  for (int i = 0; i < 3; ++i)
  {
    p[i] = (1.0 - t) * mesh.Point(a)[i] + t * mesh.Point(b)[i];
  }
  const Id v = mesh.AddPoint(p[0], p[1], p[2]);
  const Id faces = mesh.GetNumberOfFaces();
  for (Id f = 0; f < faces; ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Id u = mesh.Triangles[3 * f + k];
      const Id w = mesh.Triangles[3 * f + (k + 1) % 3];
      if ((u == a && w == b) || (u == b && w == a))
      {
        const Id apex = mesh.Triangles[3 * f + (k + 2) % 3];
        mesh.Triangles[3 * f + (k + 1) % 3] = v;
        mesh.AddTriangle(v, w, apex);
        break;
      }
    }
  }
  return v;
}

TestMesh RandomlyRefined(const TestMesh& mesh, Id count, std::uint64_t seed, double smallestArea)
{
  Random random(seed);
  TestMesh result = mesh;
  for (Id i = 0; i < count; ++i)
  {
    const Id f = random.Index(result.GetNumberOfFaces());
    if (FaceArea(result, f) <= smallestArea)
    {
      continue;
    }
    if (i % 2 == 0)
    {
      const double a = random.Uniform(0.2, 1.0);
      const double b = random.Uniform(0.2, 1.0);
      const double c = random.Uniform(0.2, 1.0);
      const double sum = a + b + c;
      SplitFace(result, f, { { a / sum, b / sum, c / sum } });
    }
    else
    {
      const Id k = random.Index(3);
      SplitEdge(result, result.Triangles[3 * f + k], result.Triangles[3 * f + (k + 1) % 3],
        random.Uniform(0.25, 0.75));
    }
  }
  return result;
}

TestMesh Subdivided(const TestMesh& mesh, Id k)
{
  TestMesh result;
  result.Points = mesh.Points;
  std::map<std::array<Id, 3>, Id> onEdges; // smaller end, larger end, steps from the smaller end
  auto edgePoint = [&](Id a, Id b, Id steps) {
    if (steps == 0)
    {
      return a;
    }
    if (steps == k)
    {
      return b;
    }
    if (a > b)
    {
      std::swap(a, b);
      steps = k - steps;
    }
    const auto found = onEdges.emplace(std::array<Id, 3>{ { a, b, steps } }, dgg::NoId);
    if (found.second)
    {
      const double t = static_cast<double>(steps) / k;
      std::array<double, 3> p{};
      for (int i = 0; i < 3; ++i)
      {
        p[i] = (1.0 - t) * mesh.Point(a)[i] + t * mesh.Point(b)[i];
      }
      found.first->second = result.AddPoint(p[0], p[1], p[2]);
    }
    return found.first->second;
  };
  for (Id f = 0; f < mesh.GetNumberOfFaces(); ++f)
  {
    const Id a = mesh.Triangles[3 * f];
    const Id b = mesh.Triangles[3 * f + 1];
    const Id c = mesh.Triangles[3 * f + 2];
    std::vector<std::vector<Id>> rows; // row i has the points i steps away from a
    for (Id i = 0; i <= k; ++i)
    {
      std::vector<Id> row;
      for (Id j = 0; j <= i; ++j)
      {
        if (j == 0)
        {
          row.push_back(edgePoint(a, b, i));
        }
        else if (j == i)
        {
          row.push_back(edgePoint(a, c, i));
        }
        else if (i == k)
        {
          row.push_back(edgePoint(b, c, j));
        }
        else
        {
          const double wa = static_cast<double>(k - i) / k;
          const double wb = static_cast<double>(i - j) / k;
          const double wc = static_cast<double>(j) / k;
          std::array<double, 3> p{};
          for (int axis = 0; axis < 3; ++axis)
          {
            p[axis] =
              wa * mesh.Point(a)[axis] + wb * mesh.Point(b)[axis] + wc * mesh.Point(c)[axis];
          }
          row.push_back(result.AddPoint(p[0], p[1], p[2]));
        }
      }
      rows.push_back(row);
    }
    for (Id i = 0; i < k; ++i)
    {
      for (Id j = 0; j <= i; ++j)
      {
        result.AddTriangle(rows[i][j], rows[i + 1][j], rows[i + 1][j + 1]);
        if (j < i)
        {
          result.AddTriangle(rows[i][j], rows[i + 1][j + 1], rows[i][j + 1]);
        }
      }
    }
  }
  return result;
}

double FaceArea(const TestMesh& mesh, Id face)
{
  const double* a = mesh.Point(mesh.Triangles[3 * face]);
  const double* b = mesh.Point(mesh.Triangles[3 * face + 1]);
  const double* c = mesh.Point(mesh.Triangles[3 * face + 2]);
  std::array<double, 3> cross{};
  for (int i = 0; i < 3; ++i)
  {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    cross[i] = (b[j] - a[j]) * (c[k] - a[k]) - (b[k] - a[k]) * (c[j] - a[j]);
  }
  return 0.5 * std::hypot(cross[0], cross[1], cross[2]);
}

double MeanEdge(const TestMesh& mesh)
{
  double sum = 0.0;
  for (Id f = 0; f < mesh.GetNumberOfFaces(); ++f)
  {
    for (int k = 0; k < 3; ++k)
    {
      sum +=
        EuclideanDistance(mesh, mesh.Triangles[3 * f + k], mesh.Triangles[3 * f + (k + 1) % 3]);
    }
  }
  return mesh.Triangles.empty() ? 0.0 : sum / static_cast<double>(mesh.Triangles.size());
}
}
