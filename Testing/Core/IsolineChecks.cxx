// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "IsolineChecks.h"

#include "dggEdges.h"
#include "dggSurfacePath.h"

namespace dggtest
{
using namespace dgg;

Isolines Trace(const DistanceField& field, const std::vector<double>& levels, double tolerance,
  IsolineMethod method)
{
  IsolineOptions options;
  options.Method = method;
  options.ChordTolerance = tolerance;
  Isolines lines;
  EXPECT_TRUE(Ok(TraceIsolines(field, levels, options, nullptr, nullptr, lines)));
  EXPECT_EQ(lines.Lines.size(), lines.Levels.size());
  EXPECT_EQ(lines.Lines.size(), lines.IsClosed.size());
  return lines;
}

std::vector<double> EvenLevels(const DistanceField& field, Id count)
{
  double least = Infinity;
  double largest = -Infinity;
  for (Id v = 0; v < field.Mesh->GetNumberOfVertices(); ++v)
  {
    if (field.Distances[v] < Infinity)
    {
      least = std::min(least, field.Distances[v]);
      largest = std::max(largest, field.Distances[v]);
    }
  }
  std::vector<double> levels;
  for (Id i = 0; i < count; ++i)
  {
    levels.push_back(least + (largest - least) * (i + 0.5) / count);
  }
  return levels;
}

bool Conducts(const DistanceField& field, Id h)
{
  const Id twin = field.Mesh->Twin(h);
  return twin != NoId && field.Mesh->Twin(twin) == h && field.IsReached(SurfaceMesh::Face(h)) &&
    field.IsReached(SurfaceMesh::Face(twin));
}

void ExpectSound(const DistanceField& field, const std::vector<double>& levels,
  const Isolines& lines, const std::string& what)
{
  const SurfaceMesh& mesh = *field.Mesh;
  std::set<std::pair<Id, Id>> crossed; // pairs of edge and level
  std::set<std::pair<Id, Id>> touched; // pairs of vertex and level
  for (std::size_t i = 0; i < lines.Lines.size(); ++i)
  {
    const SurfacePath& line = lines.Lines[i];
    ASSERT_GE(line.Points.size(), 2u) << what;
    const Status status = CheckPath(mesh, line);
    ASSERT_TRUE(status.IsOk()) << what << ", line " << i << ": " << status.GetMessage();
    for (std::size_t p = 0; p < line.Points.size(); ++p)
    {
      const SurfacePoint& point = line.Points[p];
      EXPECT_TRUE(point.Check(mesh).IsOk()) << what;
      EXPECT_TRUE(p == 0 || !IsSamePoint(line.Points[p - 1], point)) << what;
      if (point.On == SurfacePoint::Support::Edge)
      {
        crossed.insert({ FindEdge(mesh, point.HalfEdge), lines.Levels[i] });
      }
      if (point.On == SurfacePoint::Support::Vertex)
      {
        touched.insert({ point.Vertex, lines.Levels[i] });
      }
    }
    for (const Id f : line.Faces)
    {
      EXPECT_TRUE(field.IsReached(f)) << what;
    }
    if (lines.IsClosed[i])
    {
      EXPECT_TRUE(IsSamePoint(line.Points.front(), line.Points.back())) << what;
      continue;
    }
    for (const SurfacePoint* end : { &line.Points.front(), &line.Points.back() })
    {
      ASSERT_NE(end->On, SurfacePoint::Support::Face) << what << ", line " << i;
      if (end->On == SurfacePoint::Support::Edge)
      {
        EXPECT_FALSE(Conducts(field, end->HalfEdge)) << what << ", line " << i;
      }
      else
      {
        EXPECT_FALSE(AllAround(mesh, end->Vertex, [&](Id h) { return Conducts(field, h); }))
          << what << ", line " << i;
      }
    }
  }
  for (Id h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
  {
    if (!field.IsReached(SurfaceMesh::Face(h)))
    {
      continue;
    }
    const double a = field.Distances[mesh.Origin(h)];
    const double b = field.Distances[mesh.Destination(h)];
    for (std::size_t k = 0; k < levels.size(); ++k)
    {
      const Id level = static_cast<Id>(k);
      const double close = 1e-8 * mesh.Length(h); // lines may shrink to a vertex at their level
      if ((a < levels[k]) != (b < levels[k]) && std::abs(a - levels[k]) > close &&
        std::abs(b - levels[k]) > close)
      {
        EXPECT_TRUE(crossed.count({ FindEdge(mesh, h), level }) != 0 ||
          touched.count({ mesh.Origin(h), level }) != 0 ||
          touched.count({ mesh.Destination(h), level }) != 0)
          << what << ": edge " << h << ", level " << levels[k];
      }
    }
  }
}

void ExpectAtLevel(const SurfaceMesh& mesh, const std::vector<GeodesicSource>& sources,
  const std::vector<double>& levels, const Isolines& lines, double tolerance,
  const std::string& what)
{
  const LevelPoints points(lines, levels);
  ASSERT_FALSE(points.Points.empty()) << what;
  const ExactField truth(mesh, sources, points.Points);
  for (std::size_t i = 0; i < points.Points.size(); ++i)
  {
    // Points within 1e-9 of a vertex are moved to it.
    const double slack =
      points.Points[i].On == SurfacePoint::Support::Face ? 0.0 : 2e-9 * mesh.GetMaximumEdgeLength();
    EXPECT_NEAR(truth.Result.TargetDistances[i], points.Levels[i],
      tolerance * std::max(1.0, std::abs(points.Levels[i])) + slack)
      << what << ", point " << i;
  }
}

std::map<Id, int> LinesPerLevel(const Isolines& lines)
{
  std::map<Id, int> counts;
  for (const Id level : lines.Levels)
  {
    ++counts[level];
  }
  return counts;
}

bool AllClosed(const Isolines& lines)
{
  return std::all_of(lines.IsClosed.begin(), lines.IsClosed.end(), [](bool is) { return is; });
}

std::array<double, 3> Middle(const std::array<double, 3>& a, const std::array<double, 3>& b)
{
  return { { 0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]), 0.5 * (a[2] + b[2]) } };
}

double DistanceTo(const std::array<double, 3>& p, double x, double y)
{
  return std::hypot(p[0] - x, p[1] - y);
}

GeodesicSource FaceSourceAt(
  const SurfaceMesh& mesh, Id face, const std::array<double, 3>& barycentric)
{
  return { SurfacePoint::InFace(mesh, face, barycentric), 0.0 };
}

double MeanErrorOfPieces(const SurfaceMesh& mesh, const std::vector<GeodesicSource>& sources,
  const std::vector<double>& levels, const Isolines& lines)
{
  std::vector<SurfacePoint> middles;
  std::vector<double> values;
  std::vector<double> lengths;
  for (std::size_t i = 0; i < lines.Lines.size(); ++i)
  {
    const SurfacePath& line = lines.Lines[i];
    for (std::size_t p = 0; p < line.Faces.size(); ++p)
    {
      std::array<double, 3> a{};
      std::array<double, 3> b{};
      EXPECT_TRUE(FindInFace(mesh, line.Points[p], line.Faces[p], a));
      EXPECT_TRUE(FindInFace(mesh, line.Points[p + 1], line.Faces[p], b));
      std::array<double, 3> middle = Middle(a, b);
      if (mesh.IsFlipped(line.Faces[p]))
      {
        std::swap(middle[1], middle[2]);
      }
      middles.push_back(SurfacePoint::InFace(mesh, line.Faces[p], middle));
      values.push_back(levels[lines.Levels[i]]);
      lengths.push_back(MeasurePiece(mesh, line, p));
    }
  }
  const ExactField truth(mesh, sources, middles);
  double sum = 0.0;
  for (std::size_t i = 0; i < middles.size(); ++i)
  {
    sum += lengths[i] * std::abs(truth.Result.TargetDistances[i] - values[i]);
  }
  return sum / std::accumulate(lengths.begin(), lengths.end(), 0.0);
}
}
