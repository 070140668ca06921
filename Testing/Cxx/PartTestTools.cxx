// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PartTestTools.h"

#include "vtkPartitionedDataSet.h"
#include "vtkTable.h"

#include <random>

namespace dggtest
{
namespace
{
std::vector<std::vector<vtkIdType>> GetPolygons(vtkPolyData* surface)
{
  std::vector<std::vector<vtkIdType>> polygons;
  vtkNew<vtkIdList> ids;
  for (vtkIdType c = 0; c < surface->GetNumberOfPolys(); ++c)
  {
    surface->GetPolys()->GetCellAtId(c, ids);
    polygons.emplace_back(ids->begin(), ids->end());
  }
  return polygons;
}

vtkSmartPointer<vtkIdTypeArray> MakeIds(const char* name)
{
  auto ids = vtkSmartPointer<vtkIdTypeArray>::New();
  ids->SetName(name);
  return ids;
}

vtkSmartPointer<vtkUnsignedCharArray> MakeMarks()
{
  auto marks = vtkSmartPointer<vtkUnsignedCharArray>::New();
  marks->SetName(vtkDataSetAttributes::GhostArrayName());
  return marks;
}

/// Expects the same points in the same number of cells in any order, or empty output in processes
/// other than the first.
void ExpectSameSet(vtkPolyData* found, vtkPolyData* expected, bool isFirst)
{
  EXPECT_EQ(found->GetNumberOfPoints(), isFirst ? expected->GetNumberOfPoints() : 0);
  EXPECT_EQ(found->GetNumberOfCells(), isFirst ? expected->GetNumberOfCells() : 0);
  for (vtkIdType i = 0; isFirst && i < expected->GetNumberOfPoints(); ++i)
  {
    double p[3];
    expected->GetPoint(i, p);
    double nearest = VTK_DOUBLE_MAX;
    for (vtkIdType j = 0; j < found->GetNumberOfPoints(); ++j)
    {
      double q[3];
      found->GetPoint(j, q);
      nearest = std::min(nearest, std::sqrt(vtkMath::Distance2BetweenPoints(p, q)));
    }
    ASSERT_LT(nearest, FloatTolerance * expected->GetLength());
  }
}

void ExpectSameRows(vtkTable* found, vtkTable* expected, bool isFirst)
{
  ASSERT_EQ(found->GetNumberOfRows(), isFirst ? expected->GetNumberOfRows() : 0);
  for (vtkIdType row = 0; row < found->GetNumberOfRows(); ++row)
  {
    for (vtkIdType column = 0; column < expected->GetNumberOfColumns(); ++column)
    {
      const double value = expected->GetValue(row, column).ToDouble();
      EXPECT_NEAR(found->GetValue(row, column).ToDouble(), value, FloatTolerance * value);
    }
  }
}
}

Labels LabelStrips(vtkPolyData* surface, int parts)
{
  const auto polygons = GetPolygons(surface);
  std::vector<double> middles;
  for (const auto& polygon : polygons)
  {
    double x = 0.0;
    for (const vtkIdType id : polygon)
    {
      x += surface->GetPoint(id)[0];
    }
    middles.push_back(x / static_cast<double>(polygon.size()));
  }
  std::vector<std::size_t> order(polygons.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
    [&](std::size_t a, std::size_t b) { return middles[a] < middles[b]; });
  Labels labels(polygons.size());
  for (std::size_t k = 0; k < order.size(); ++k)
  {
    labels[order[k]] = static_cast<int>(k * parts / order.size());
  }
  return labels;
}

Labels LabelRandomly(vtkPolyData* surface, int parts, unsigned int seed)
{
  const auto polygons = GetPolygons(surface);
  std::map<std::array<vtkIdType, 2>, std::vector<std::size_t>> atEdges;
  for (std::size_t c = 0; c < polygons.size(); ++c)
  {
    for (std::size_t k = 0; k < polygons[c].size(); ++k)
    {
      const vtkIdType a = polygons[c][k];
      const vtkIdType b = polygons[c][(k + 1) % polygons[c].size()];
      atEdges[{ { std::min(a, b), std::max(a, b) } }].push_back(c);
    }
  }
  std::vector<std::vector<std::size_t>> neighbors(polygons.size());
  for (const auto& edge : atEdges)
  {
    for (const std::size_t c : edge.second)
    {
      neighbors[c].insert(neighbors[c].end(), edge.second.begin(), edge.second.end());
    }
  }
  std::mt19937 random(seed);
  Labels labels(polygons.size(), -1);
  std::vector<std::size_t> front;
  for (int part = 0; part < parts; ++part)
  {
    front.push_back(random() % polygons.size());
    labels[front.back()] = part;
  }
  while (!front.empty())
  {
    std::swap(front[random() % front.size()], front.back());
    const std::size_t cell = front.back();
    front.pop_back();
    for (const std::size_t neighbor : neighbors[cell])
    {
      if (labels[neighbor] < 0)
      {
        labels[neighbor] = labels[cell];
        front.push_back(neighbor);
      }
    }
  }
  return labels;
}

Labels LabelBisection(vtkPolyData* surface, int parts)
{
  const auto polygons = GetPolygons(surface);
  Labels labels(polygons.size());
  const std::function<void(std::vector<std::size_t>, int, int, int)> divide =
    [&](std::vector<std::size_t> cells, int first, int count, int axis) {
      if (count == 1)
      {
        std::for_each(cells.begin(), cells.end(), [&](std::size_t cell) { labels[cell] = first; });
        return;
      }
      std::stable_sort(cells.begin(), cells.end(), [&](std::size_t a, std::size_t b) {
        return surface->GetPoint(polygons[a][0])[axis] < surface->GetPoint(polygons[b][0])[axis];
      });
      const auto middle = cells.begin() +
        static_cast<std::ptrdiff_t>(
          cells.size() * static_cast<std::size_t>(count / 2) / static_cast<std::size_t>(count));
      divide({ cells.begin(), middle }, first, count / 2, 1 - axis);
      divide({ middle, cells.end() }, first + count / 2, count - count / 2, 1 - axis);
    };
  std::vector<std::size_t> all(polygons.size());
  std::iota(all.begin(), all.end(), 0);
  divide(all, 0, parts, 0);
  return labels;
}

Labels LabelScattered(vtkPolyData* surface, int parts)
{
  std::mt19937 random(3);
  Labels labels(static_cast<std::size_t>(surface->GetNumberOfPolys()));
  std::generate(labels.begin(), labels.end(),
    [&] { return static_cast<int>(random() % static_cast<unsigned int>(parts)); });
  return labels;
}

vtkSmartPointer<vtkPolyData> TakePart(
  vtkPolyData* surface, const Labels& labels, int label, PartIds ids, bool ghosts)
{
  const auto polygons = GetPolygons(surface);
  std::vector<bool> isOwn(static_cast<std::size_t>(surface->GetNumberOfPoints()), false);
  std::vector<int> owners(isOwn.size(), std::numeric_limits<int>::max());
  for (std::size_t c = 0; c < polygons.size(); ++c)
  {
    for (const vtkIdType id : polygons[c])
    {
      isOwn[id] = isOwn[id] || labels[c] == label;
      owners[id] = std::min(owners[id], labels[c]);
    }
  }
  vtkNew<vtkPoints> points;
  points->SetDataType(surface->GetPoints()->GetDataType());
  vtkNew<vtkCellArray> cells;
  auto part = vtkSmartPointer<vtkPolyData>::New();
  const auto whole = MakeIds("Whole");
  const auto pointIds = MakeIds("GlobalPointIds");
  const auto cellIds = MakeIds("GlobalCellIds");
  const auto pointMarks = MakeMarks();
  const auto cellMarks = MakeMarks();
  part->GetPointData()->CopyAllocate(surface->GetPointData());
  part->GetCellData()->CopyAllocate(surface->GetCellData());
  std::map<vtkIdType, vtkIdType> numbers;
  for (std::size_t c = 0; c < polygons.size(); ++c)
  {
    const bool touches =
      std::any_of(polygons[c].begin(), polygons[c].end(), [&](vtkIdType id) { return isOwn[id]; });
    if (labels[c] != label && !(ghosts && touches))
    {
      continue;
    }
    std::vector<vtkIdType> polygon;
    for (const vtkIdType id : polygons[c])
    {
      const auto found = numbers.insert({ id, points->GetNumberOfPoints() });
      polygon.push_back(found.first->second);
      if (found.second)
      {
        points->InsertNextPoint(surface->GetPoint(id));
        part->GetPointData()->CopyData(surface->GetPointData(), id, found.first->second);
        whole->InsertNextValue(id);
        pointIds->InsertNextValue(id);
        pointMarks->InsertNextValue(owners[id] == label ? 0 : vtkDataSetAttributes::DUPLICATEPOINT);
      }
    }
    const vtkIdType cell =
      cells->InsertNextCell(static_cast<vtkIdType>(polygon.size()), polygon.data());
    part->GetCellData()->CopyData(surface->GetCellData(), static_cast<vtkIdType>(c), cell);
    cellIds->InsertNextValue(static_cast<vtkIdType>(c));
    cellMarks->InsertNextValue(labels[c] == label ? 0 : vtkDataSetAttributes::DUPLICATECELL);
  }
  part->SetPoints(points);
  part->SetPolys(cells);
  part->GetPointData()->AddArray(whole);
  if (ids == PartIds::Global)
  {
    part->GetPointData()->SetGlobalIds(pointIds);
    part->GetCellData()->SetGlobalIds(cellIds);
  }
  if (ghosts)
  {
    part->GetPointData()->AddArray(pointMarks);
    part->GetCellData()->AddArray(cellMarks);
  }
  return part;
}

void ExpectArray(vtkPolyData* part, vtkPolyData* whole, const std::string& name, double tolerance)
{
  vtkDataArray* array = part->GetPointData()->GetArray(name.c_str());
  vtkDataArray* expected = whole->GetPointData()->GetArray(name.c_str());
  vtkDataArray* ids = part->GetPointData()->GetArray("Whole");
  // Readers give no arrays to processes without a piece.
  ASSERT_TRUE(array && expected && (ids || part->GetNumberOfPoints() == 0)) << name;
  ASSERT_EQ(array->GetNumberOfTuples(), part->GetNumberOfPoints());
  ASSERT_EQ(array->GetNumberOfComponents(), expected->GetNumberOfComponents());
  const double range = std::max(std::abs(expected->GetRange()[0]), expected->GetRange()[1]);
  for (vtkIdType i = 0; i < part->GetNumberOfPoints(); ++i)
  {
    const auto id = static_cast<vtkIdType>(ids->GetComponent(i, 0));
    for (int k = 0; k < array->GetNumberOfComponents(); ++k)
    {
      ASSERT_NEAR(array->GetComponent(i, k), expected->GetComponent(id, k), tolerance * range)
        << name << " at point " << id;
    }
  }
}

void ExpectOutputsOfParts(vtkAlgorithm* onParts, vtkAlgorithm* onWhole, bool isFirst)
{
  for (int port = 0; port < onWhole->GetNumberOfOutputPorts(); ++port)
  {
    SCOPED_TRACE(port);
    vtkDataObject* found = onParts->GetOutputDataObject(port);
    vtkDataObject* expected = onWhole->GetOutputDataObject(port);
    auto* whole = vtkPolyData::SafeDownCast(expected);
    std::vector<vtkPolyData*> parts;
    if (auto* partitions = vtkPartitionedDataSet::SafeDownCast(found))
    {
      for (unsigned int i = 0; i < partitions->GetNumberOfPartitions(); ++i)
      {
        parts.push_back(vtkPolyData::SafeDownCast(partitions->GetPartitionAsDataObject(i)));
      }
    }
    else if (vtkPolyData::SafeDownCast(found))
    {
      parts.push_back(vtkPolyData::SafeDownCast(found));
    }
    if (parts.size() > 1 || (!parts.empty() && parts[0]->GetPointData()->HasArray("Whole")))
    {
      for (vtkPolyData* part : parts)
      {
        for (int a = 0; a < whole->GetPointData()->GetNumberOfArrays(); ++a)
        {
          ExpectArray(part, whole, whole->GetPointData()->GetArrayName(a), FloatTolerance);
        }
      }
    }
    else if (whole)
    {
      ExpectSameSet(parts.at(0), whole, isFirst);
    }
    else
    {
      ExpectSameRows(vtkTable::SafeDownCast(found), vtkTable::SafeDownCast(expected), isFirst);
    }
  }
}

vtkSmartPointer<vtkPolyData> MakeSeam(int n)
{
  auto surface = MakeTerrain(n);
  vtkPoints* points = surface->GetPoints();
  const vtkIdType row = static_cast<vtkIdType>(n / 2) * n;
  std::map<vtkIdType, vtkIdType> copies;
  for (vtkIdType i = n / 3; i < n; ++i)
  {
    double p[3];
    points->GetPoint(row + i, p);
    copies[row + i] = points->InsertNextPoint(p);
  }
  Cells cells;
  for (auto polygon : GetPolygons(surface))
  {
    const bool isAbove =
      std::any_of(polygon.begin(), polygon.end(), [&](vtkIdType id) { return id >= row + n; });
    for (vtkIdType& id : polygon)
    {
      id = isAbove && copies.count(id) ? copies[id] : id;
    }
    cells.push_back(polygon);
  }
  surface->SetPolys(MakeCells(cells));
  return surface;
}
}
