// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FilterTestTools.h"

#include "TestMeshes.h"

#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <cctype>
#include <sstream>

namespace dggtest
{
vtkSmartPointer<vtkCellArray> MakeCells(const Cells& cells)
{
  vtkNew<vtkCellArray> array;
  for (const auto& cell : cells)
  {
    array->InsertNextCell(static_cast<vtkIdType>(cell.size()), cell.data());
  }
  return array.Get();
}

vtkSmartPointer<vtkCellArray> MakeContradictoryCells()
{
  vtkNew<vtkIdTypeArray> offsets;
  vtkNew<vtkIdTypeArray> connectivity;
  for (const vtkIdType value : { 0, 1 })
  {
    offsets->InsertNextValue(100000000 * value);
    connectivity->InsertNextValue(value);
  }
  vtkNew<vtkCellArray> cells;
  cells->SetData(offsets, connectivity);
  return cells.Get();
}

vtkSmartPointer<vtkPolyData> MakeSourcePoints(const Points& points)
{
  vtkNew<vtkPoints> array;
  array->SetDataTypeToDouble();
  for (const auto& p : points)
  {
    array->InsertNextPoint(p.data());
  }
  vtkNew<vtkPolyData> surface;
  surface->SetPoints(array);
  return surface.Get();
}

vtkSmartPointer<vtkPolyData> MakeSurface(const Points& points, const Cells& polygons)
{
  auto surface = MakeSourcePoints(points);
  surface->SetPolys(MakeCells(polygons));
  return surface;
}

vtkSmartPointer<vtkPolyData> MakeSurface(const TestMesh& mesh)
{
  Points points;
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    const double* p = mesh.Point(v);
    points.push_back({ { p[0], p[1], p[2] } });
  }
  Cells cells;
  for (std::size_t k = 0; k < mesh.Triangles.size(); k += 3)
  {
    cells.emplace_back(mesh.Triangles.begin() + k, mesh.Triangles.begin() + k + 3);
  }
  return MakeSurface(points, cells);
}

vtkSmartPointer<vtkPolyData> MakeGrid(int columns, int rows, GridCells cells, double unit)
{
  Points points;
  for (int j = 0; j <= rows; ++j)
  {
    for (int i = 0; i <= columns; ++i)
    {
      points.push_back({ { unit * i, unit * j, 0.0 } });
    }
  }
  Cells polygons;
  Cells strips;
  for (int j = 0; j < rows; ++j)
  {
    std::vector<vtkIdType> strip;
    for (int i = 0; i <= columns; ++i)
    {
      const vtkIdType a = j * (columns + 1) + i;
      const vtkIdType d = a + columns + 1;
      strip.insert(strip.end(), { d, a });
      if (i < columns && cells == GridCells::Quads)
      {
        polygons.push_back({ a, a + 1, d + 1, d });
      }
      else if (i < columns && cells == GridCells::Triangles)
      {
        polygons.push_back({ a, a + 1, d });
        polygons.push_back({ a + 1, d + 1, d });
      }
    }
    strips.push_back(strip);
  }
  auto surface = MakeSurface(points, polygons);
  if (cells == GridCells::Strips)
  {
    surface->SetStrips(MakeCells(strips));
  }
  return surface;
}

vtkSmartPointer<vtkPolyData> MakeCube()
{
  Points points;
  for (int i = 0; i < 8; ++i)
  {
    points.push_back({ { i % 2 * 1.0, i / 2 % 2 * 1.0, i / 4 * 1.0 } });
  }
  return MakeSurface(points,
    { { 0, 2, 3 }, { 0, 3, 1 }, { 4, 5, 7 }, { 4, 7, 6 }, { 0, 1, 5 }, { 0, 5, 4 }, { 2, 6, 7 },
      { 2, 7, 3 }, { 0, 4, 6 }, { 0, 6, 2 }, { 1, 3, 7 }, { 1, 7, 5 } });
}

double GetTerrainHeight(double x, double y)
{
  const double bump = std::hypot(x - 0.68, y - 0.36) / 0.17;
  return 0.07 * std::sin(5.0 * x + 2.0 * y * y) + 0.05 * std::cos(9.0 * y - x) +
    0.32 * std::exp(-bump * bump);
}

vtkSmartPointer<vtkPolyData> MakeTerrain(int n)
{
  auto surface = MakeGrid(n - 1, n - 1, GridCells::Triangles, 1.0 / (n - 1));
  MovePoints(surface, [&](double* p) { p[2] = GetTerrainHeight(p[0], p[1]); });
  return surface;
}

void MovePoints(vtkPolyData* data, const std::function<void(double*)>& move)
{
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    double p[3];
    data->GetPoint(i, p);
    move(p);
    data->GetPoints()->SetPoint(i, p);
  }
  if (data->GetPoints())
  {
    data->GetPoints()->Modified();
  }
}

vtkSmartPointer<vtkPolyData> MakePlateWithHole()
{
  constexpr int sides = 40;
  constexpr int rows = 6;
  constexpr double radius = 0.15;
  const double turn = 2.0 * std::acos(-1.0) / sides;
  Points points;
  Cells cells;
  const vtkIdType n = sides + 4; // points per level, starting with the corners of the plate
  for (int row = 0; row <= rows; ++row)
  {
    const double z = row * radius * turn;
    points.insert(points.end(),
      { { { 0.0, 0.0, z } }, { { 3.0, 0.0, z } }, { { 3.0, 1.0, z } }, { { 0.0, 1.0, z } } });
    for (int i = 0; i < sides; ++i)
    {
      points.push_back(
        { { 1.5 + radius * std::cos(turn * i), 0.5 + radius * std::sin(turn * i), z } });
    }
  }
  const auto addWall = [&](vtkIdType a, vtkIdType b) {
    for (vtkIdType level = 0; level < rows * n; level += n)
    {
      cells.push_back({ a + level, b + level, b + level + n });
      cells.push_back({ a + level, b + level + n, a + level + n });
    }
  };
  const auto addFaces = [&](vtkIdType a, vtkIdType b, vtkIdType c) {
    cells.push_back({ c, b, a });
    cells.push_back({ a + rows * n, b + rows * n, c + rows * n });
  };
  for (int i = 0; i < sides; ++i)
  {
    const vtkIdType corner = (2 + 4 * i / sides) % 4; // corner of the same quarter of the plate
    const vtkIdType a = 4 + i;
    const vtkIdType b = 4 + (i + 1) % sides;
    addWall(b, a);
    addFaces(b, a, corner);
    if (4 * (i + 1) % sides == 0)
    {
      addFaces(b, corner, (corner + 1) % 4);
      addWall((corner + 2) % 4, (corner + 3) % 4);
    }
  }
  return MakeSurface(points, cells);
}

vtkSmartPointer<vtkPolyData> Beside(vtkPolyData* first, vtkPolyData* second, double shift)
{
  Points points;
  Cells cells;
  for (const bool isSecond : { false, true })
  {
    vtkPolyData* part = isSecond ? second : first; // `first` and `second` may be the same object
    const auto offset = static_cast<vtkIdType>(points.size());
    for (vtkIdType i = 0; i < part->GetNumberOfPoints(); ++i)
    {
      std::array<double, 3> p;
      part->GetPoint(i, p.data());
      p[0] += isSecond ? shift : 0.0;
      points.push_back(p);
    }
    for (vtkIdType c = 0; c < part->GetNumberOfCells(); ++c)
    {
      cells.emplace_back();
      vtkNew<vtkIdList> ids;
      part->GetCellPoints(c, ids);
      for (const vtkIdType id : *ids)
      {
        cells.back().push_back(id + offset);
      }
    }
  }
  return MakeSurface(points, cells);
}

std::string DescribeGeometry(vtkPolyData* output)
{
  std::ostringstream os;
  os.precision(17);
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const double* p = output->GetPoint(i);
    os << p[0] << " " << p[1] << " " << p[2] << "\n";
  }
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < output->GetNumberOfCells(); ++i)
  {
    output->GetCellPoints(i, ids);
    for (const vtkIdType id : *ids)
    {
      os << id << " ";
    }
    os << "\n";
  }
  return os.str();
}

double GetReported(vtkGeodesicAlgorithm* filter, const char* name)
{
  vtkTable* table = filter->GetMeshReportTable();
  EXPECT_NE(table->GetColumnByName(name), nullptr) << name;
  return table->GetValueByName(0, name).ToDouble();
}

std::vector<double> GetDistances(vtkGeodesicDistanceAlgorithm* filter)
{
  vtkDataArray* array =
    filter->GetOutput()->GetPointData()->GetArray(filter->GetDistanceArrayName());
  std::vector<double> values;
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    values.push_back(array->GetComponent(i, 0));
  }
  return values;
}

std::vector<int> GetNearestSources(vtkGeodesicDistanceAlgorithm* filter)
{
  vtkDataArray* array = filter->GetOutput()->GetPointData()->GetArray(filter->GetSourceArrayName());
  std::vector<int> values;
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    values.push_back(static_cast<int>(array->GetComponent(i, 0)));
  }
  return values;
}

double EuclideanDistance(vtkPolyData* surface, vtkIdType a, vtkIdType b)
{
  double p[3];
  double q[3];
  surface->GetPoint(a, p);
  surface->GetPoint(b, q);
  return std::sqrt(vtkMath::Distance2BetweenPoints(p, q));
}

void ExpectEuclidean(vtkGeodesicDistanceAlgorithm* filter, vtkPolyData* plate, double tolerance)
{
  const auto distances = GetDistances(filter);
  ASSERT_EQ(static_cast<vtkIdType>(distances.size()), plate->GetNumberOfPoints());
  for (vtkIdType i = 0; i < plate->GetNumberOfPoints(); ++i)
  {
    EXPECT_NEAR(distances[i], EuclideanDistance(plate, filter->GetSourceId(0), i), tolerance) << i;
  }
}

//------------------------------------------------------------------------------
class Listener::Command : public vtkCommand
{
public:
  static Command* New() { return new Command; }

  void Execute(vtkObject*, unsigned long event, void* text) override
  {
    auto& texts = event == vtkCommand::ErrorEvent ? this->Owner->Errors : this->Owner->Warnings;
    texts.emplace_back(static_cast<const char*>(text));
  }

  Listener* Owner = nullptr;
};

Listener::Listener(vtkObject* subject)
  : Subject(subject)
{
  auto command = vtkSmartPointer<Command>::New();
  command->Owner = this;
  this->Observer = command;
  subject->AddObserver(vtkCommand::ErrorEvent, this->Observer);
  subject->AddObserver(vtkCommand::WarningEvent, this->Observer);
}

Listener::~Listener()
{
  this->Subject->RemoveObserver(this->Observer);
}

//------------------------------------------------------------------------------
namespace
{
void ExpectParts(const std::string& text, const std::vector<std::string>& parts)
{
  for (const std::string& part : parts)
  {
    const auto isSame = [](unsigned char a, unsigned char b) {
      return std::tolower(a) == std::tolower(b);
    };
    const bool isFound =
      std::search(text.begin(), text.end(), part.begin(), part.end(), isSame) != text.end();
    EXPECT_TRUE(isFound) << "'" << part << "' is missing in: " << text;
  }
}
}

void ExpectEmptyOutput(vtkAlgorithm* filter)
{
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    vtkDataObject* output = filter->GetOutputDataObject(port);
    for (int kind = 0; kind < vtkDataObject::NUMBER_OF_ATTRIBUTE_TYPES; ++kind)
    {
      if (kind != vtkDataObject::FIELD)
      {
        EXPECT_EQ(output->GetNumberOfElements(kind), 0) << port << " " << kind;
      }
      if (vtkFieldData* arrays = output->GetAttributesAsFieldData(kind))
      {
        EXPECT_EQ(arrays->GetNumberOfArrays(), 0) << port << " " << kind;
      }
    }
  }
}

void ExpectError(vtkAlgorithm* filter, const std::vector<std::string>& parts)
{
  Listener listener(filter);
  filter->Update();
  ASSERT_EQ(listener.Errors.size(), 1u);
  ExpectParts(listener.Errors[0], { filter->GetClassName() });
  ExpectParts(listener.Errors[0], parts);
  EXPECT_NE(filter->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError));
  ExpectEmptyOutput(filter);
}

void ExpectSuccess(vtkAlgorithm* filter)
{
  Listener listener(filter);
  filter->Update();
  EXPECT_EQ(listener.Errors, std::vector<std::string>());
  EXPECT_EQ(listener.Warnings, std::vector<std::string>());
  EXPECT_EQ(filter->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError));
}

void ExpectWarning(vtkAlgorithm* filter, const std::vector<std::string>& parts)
{
  Listener listener(filter);
  filter->Update();
  EXPECT_EQ(listener.Errors, std::vector<std::string>());
  EXPECT_EQ(filter->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError));
  ASSERT_EQ(listener.Warnings.size(), 1u);
  ExpectParts(listener.Warnings[0], parts);
}

//------------------------------------------------------------------------------
ProgressWatch::ProgressWatch(vtkAlgorithm* filter)
  : Filter(filter)
  , Tag(filter->AddObserver(vtkCommand::ProgressEvent, this, &ProgressWatch::Observe))
{
}

ProgressWatch::~ProgressWatch()
{
  this->Filter->RemoveObserver(this->Tag);
}

void ProgressWatch::Observe(vtkObject* caller, unsigned long, void*)
{
  auto* algorithm = vtkAlgorithm::SafeDownCast(caller);
  if (algorithm->GetAbortExecute() && algorithm->GetProgress() == 1.0)
  {
    return; // later versions of VTK report the end after an abort, too
  }
  this->Progress.push_back(algorithm->GetProgress());
  if (this->Progress.back() >= this->StopAt)
  {
    algorithm->AbortExecuteOn();
  }
}

void ProgressWatch::ExpectGrowth(int steps) const
{
  ASSERT_GT(this->Progress.size(), 2u);
  EXPECT_EQ(this->Progress.front(), 0.0);
  EXPECT_EQ(this->Progress.back(), 1.0);
  int inTheMiddle = 0;
  for (std::size_t i = 1; i < this->Progress.size(); ++i)
  {
    EXPECT_GE(this->Progress[i], this->Progress[i - 1]) << i;
    inTheMiddle += this->Progress[i] > 0.1 && this->Progress[i] < 0.9 ? 1 : 0;
  }
  EXPECT_GE(inTheMiddle, steps);
}
}
