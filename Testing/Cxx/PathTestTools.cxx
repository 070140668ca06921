// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PathTestTools.h"

#include "vtkCellType.h"

namespace dggtest
{
namespace
{
constexpr double Tolerance = 1e-9;

double Distance(const std::array<double, 3>& p, const std::array<double, 3>& q)
{
  return std::sqrt(vtkMath::Distance2BetweenPoints(p.data(), q.data()));
}

std::array<double, 3> Minus(const std::array<double, 3>& p, const std::array<double, 3>& q)
{
  return { { p[0] - q[0], p[1] - q[1], p[2] - q[2] } };
}

double DistanceFromSegment(
  const std::array<double, 3>& p, const std::array<double, 3>& a, const std::array<double, 3>& b)
{
  const auto edge = Minus(b, a);
  const double square = vtkMath::Dot(edge.data(), edge.data());
  const double along = square > 0.0 ? vtkMath::Dot(Minus(p, a).data(), edge.data()) / square : 0.0;
  const double t = std::min(1.0, std::max(0.0, along));
  return Distance(p, { { a[0] + t * edge[0], a[1] + t * edge[1], a[2] + t * edge[2] } });
}

/// Returns the distance of a point from a triangle. The result is also accurate for degenerate
/// triangles, because distances from the edges are included.
double DistanceFromTriangle(
  const std::array<double, 3>& p, const std::array<std::array<double, 3>, 3>& corners)
{
  double distance = VTK_DOUBLE_MAX;
  const auto ab = Minus(corners[1], corners[0]);
  const auto ac = Minus(corners[2], corners[0]);
  double normal[3];
  vtkMath::Cross(ab.data(), ac.data(), normal);
  bool isInside = vtkMath::Normalize(normal) > 0.0;
  for (int k = 0; k < 3; ++k)
  {
    const auto& a = corners[k];
    const auto& b = corners[(k + 1) % 3];
    distance = std::min(distance, DistanceFromSegment(p, a, b));
    double inwards[3];
    vtkMath::Cross(normal, Minus(b, a).data(), inwards);
    isInside = isInside && vtkMath::Dot(inwards, Minus(p, a).data()) >= 0.0;
  }
  return isInside ? std::min(distance, std::abs(vtkMath::Dot(normal, Minus(p, corners[0]).data())))
                  : distance;
}

/// Returns the distance of a point from a triangle strip or a convex polygon.
double DistanceFromCell(vtkPolyData* surface, vtkIdType cell, const std::array<double, 3>& p)
{
  vtkNew<vtkIdList> ids;
  surface->GetCellPoints(cell, ids);
  const bool isStrip = surface->GetCellType(cell) == VTK_TRIANGLE_STRIP;
  double distance = VTK_DOUBLE_MAX;
  for (vtkIdType i = 2; i < ids->GetNumberOfIds(); ++i)
  {
    std::array<std::array<double, 3>, 3> corners;
    surface->GetPoint(ids->GetId(isStrip ? i - 2 : 0), corners[0].data());
    surface->GetPoint(ids->GetId(i - 1), corners[1].data());
    surface->GetPoint(ids->GetId(i), corners[2].data());
    distance = std::min(distance, DistanceFromTriangle(p, corners));
  }
  return distance;
}

double GetValue(vtkDataSetAttributes* data, const char* name, vtkIdType tuple)
{
  return data->GetArray(name)->GetComponent(tuple, 0);
}
}

bool PathLine::operator==(const PathLine& other) const
{
  return this->Positions == other.Positions && this->Faces == other.Faces &&
    this->PointIds == other.PointIds && this->ArcLengths == other.ArcLengths &&
    this->Length == other.Length && this->Straightened == other.Straightened &&
    this->Pair == other.Pair &&
    (this->GraphLength == other.GraphLength ||
      (std::isnan(this->GraphLength) && std::isnan(other.GraphLength)));
}

bool HasPolylines(vtkPolyData* output, const std::vector<const char*>& cellArrays)
{
  for (const char* name : { "FaceId", "vtkOriginalPointIds", "ArcLength" })
  {
    vtkDataArray* array = output->GetPointData()->GetArray(name);
    if (!array || array->GetNumberOfTuples() != output->GetNumberOfPoints())
    {
      ADD_FAILURE() << "point data " << name;
      return false;
    }
  }
  for (const char* name : cellArrays)
  {
    vtkDataArray* array = output->GetCellData()->GetArray(name);
    if (!array || array->GetNumberOfTuples() != output->GetNumberOfCells())
    {
      ADD_FAILURE() << "cell data " << name;
      return false;
    }
  }
  return output->GetNumberOfLines() == output->GetNumberOfCells();
}

void ReadPolyline(vtkPolyData* output, vtkIdType line, PathLine& path)
{
  path.Length = GetValue(output->GetCellData(), "Length", line);
  vtkIdType size = 0;
  const vtkIdType* ids = nullptr;
  output->GetLines()->GetCellAtId(line, size, ids);
  for (const vtkIdType* id = ids; id != ids + size; ++id)
  {
    path.Positions.emplace_back();
    output->GetPoint(*id, path.Positions.back().data());
    vtkPointData* data = output->GetPointData();
    path.Faces.push_back(static_cast<vtkIdType>(GetValue(data, "FaceId", *id)));
    path.PointIds.push_back(static_cast<vtkIdType>(GetValue(data, "vtkOriginalPointIds", *id)));
    path.ArcLengths.push_back(GetValue(data, "ArcLength", *id));
  }
}

std::vector<PathLine> GetPaths(vtkDGGPath* filter)
{
  vtkPolyData* output = filter->GetOutput();
  std::vector<PathLine> paths;
  if (!HasPolylines(output, { "Length", "GraphLength", "Straightened", "PairId" }))
  {
    return paths;
  }
  for (vtkIdType c = 0; c < output->GetNumberOfCells(); ++c)
  {
    PathLine path;
    ReadPolyline(output, c, path);
    path.GraphLength = GetValue(output->GetCellData(), "GraphLength", c);
    path.Straightened = static_cast<int>(GetValue(output->GetCellData(), "Straightened", c));
    path.Pair = static_cast<vtkIdType>(GetValue(output->GetCellData(), "PairId", c));
    paths.push_back(path);
  }
  return paths;
}

std::vector<int> GetPathStatus(vtkDGGPath* filter)
{
  vtkDataArray* array = filter->GetOutput()->GetFieldData()->GetArray("PathStatus");
  std::vector<int> values;
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    values.push_back(static_cast<int>(array->GetComponent(i, 0)));
  }
  return values;
}

void ExpectOnSurface(const PathLine& path, vtkPolyData* surface, double slack)
{
  ASSERT_FALSE(path.Positions.empty());
  EXPECT_EQ(path.ArcLengths.front(), 0.0);
  const double unit = std::max(path.Length, surface->GetLength());
  double sum = 0.0;
  for (std::size_t i = 0; i < path.Positions.size(); ++i)
  {
    if (path.PointIds[i] >= 0)
    {
      std::array<double, 3> p;
      surface->GetPoint(path.PointIds[i], p.data());
      EXPECT_EQ(p, path.Positions[i]) << i;
    }
    const vtkIdType face = path.Faces[i];
    if (face < 0)
    {
      EXPECT_EQ(path.Length, 0.0); // an isolated point
      continue;
    }
    ASSERT_LT(face, surface->GetNumberOfCells());
    EXPECT_LE(DistanceFromCell(surface, face, path.Positions[i]), Tolerance * unit) << i;
    if (i + 1 < path.Positions.size())
    {
      EXPECT_LE(DistanceFromCell(surface, face, path.Positions[i + 1]), Tolerance * unit) << i;
      sum += Distance(path.Positions[i], path.Positions[i + 1]);
      EXPECT_NEAR(path.ArcLengths[i + 1], sum, Tolerance * unit + slack) << i;
    }
  }
  EXPECT_NEAR(path.Length, sum, Tolerance * sum + slack);
  EXPECT_NEAR(path.ArcLengths.back(), path.Length, Tolerance * sum);
}

vtkIdType ExpectPiecesInTheirFaces(vtkPolyData* surface, vtkPolyData* lines)
{
  vtkDataArray* faces = lines->GetPointData()->GetArray("FaceId");
  EXPECT_NE(faces, nullptr);
  vtkIdType count = 0;
  vtkNew<vtkIdList> ids;
  for (vtkIdType line = 0; faces && line < lines->GetNumberOfCells(); ++line)
  {
    lines->GetCellPoints(line, ids);
    for (vtkIdType i = 0; i + 1 < ids->GetNumberOfIds(); ++i, ++count)
    {
      // The midpoint of a segment lies between its ends, because triangles are convex.
      const auto face = static_cast<vtkIdType>(faces->GetComponent(ids->GetId(i), 0));
      const double unit = std::sqrt(surface->GetCell(face)->GetLength2());
      for (const vtkIdType id : { ids->GetId(i), ids->GetId(i + 1) })
      {
        std::array<double, 3> p;
        lines->GetPoint(id, p.data());
        EXPECT_LE(DistanceFromCell(surface, face, p), Tolerance * unit)
          << "line " << line << ", piece " << i << ", face " << face;
      }
    }
  }
  return count;
}

vtkSmartPointer<vtkPolyData> MakePairs(const Points& ends)
{
  auto data = MakeSourcePoints(ends);
  Cells lines;
  for (vtkIdType i = 0; i + 1 < static_cast<vtkIdType>(ends.size()); i += 2)
  {
    lines.push_back({ i, i + 1 });
  }
  data->SetLines(MakeCells(lines));
  return data;
}
}
