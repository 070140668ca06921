// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FilterCases.h"

#include <sstream>

namespace dggtest
{
void PrintTo(const FilterCase& filter, std::ostream* os)
{
  *os << filter.Name;
}

Refusal RefuseMemoryLimit(vtkTypeInt64 limit)
{
  return { [limit](vtkGeodesicAlgorithm* f) { f->SetMemoryLimit(limit); }, { "MemoryLimit" } };
}

std::vector<Refusal> RefuseInput()
{
  using F = vtkGeodesicAlgorithm;
  return {
    Refuse<F>([](F* f) { f->SetInputConnection(nullptr); }, { "no input" }),
  };
}

std::vector<Refusal> RefusePoints(const FilterCase& filter, const std::string& words)
{
  const auto refuse = [&](const std::array<double, 3>& point, const std::string& part) {
    const auto spoil = [set = filter.SetPoints, point](vtkGeodesicAlgorithm* f) {
      Points points = GetPointsOnEdges(MakeRelief(VTK_DOUBLE));
      points[0] = point;
      set(f, MakeSourcePoints(points));
    };
    return Refusal{ spoil, { "0, at (", part } };
  };
  return { refuse({ { 0.5, std::nan(""), 0.0 } }, "not finite"), refuse(FarFromRelief, words) };
}

std::string DescribeOutputs(vtkGeodesicAlgorithm* filter, bool withFieldData)
{
  std::ostringstream os;
  os.precision(17);
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    vtkDataObject* output = filter->GetOutputDataObject(port);
    if (auto* surface = vtkPolyData::SafeDownCast(output))
    {
      os << DescribeGeometry(surface);
    }
    for (int kind = 0; kind < vtkDataObject::NUMBER_OF_ATTRIBUTE_TYPES; ++kind)
    {
      const bool isDescribed = withFieldData || kind != vtkDataObject::FIELD;
      vtkFieldData* data = output->GetAttributesAsFieldData(kind);
      for (int a = 0; data && isDescribed && a < data->GetNumberOfArrays(); ++a)
      {
        vtkDataArray* array = data->GetArray(a);
        os << data->GetArrayName(a);
        for (vtkIdType i = 0; array && i < array->GetNumberOfValues(); ++i)
        {
          os << " "
             << array->GetComponent(
                  i / array->GetNumberOfComponents(), i % array->GetNumberOfComponents());
        }
        os << "\n";
      }
    }
  }
  return os.str();
}

vtkSmartPointer<vtkPolyData> MakeRelief(int dataType, int n)
{
  auto surface = MakeGrid(n, n);
  vtkNew<vtkPoints> points;
  points->SetDataType(dataType);
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double p[3];
    surface->GetPoint(i, p);
    points->InsertNextPoint(10.0 * p[0], 10.0 * p[1], static_cast<double>(i * i * 7 % 9));
  }
  surface->SetPoints(points);
  return surface;
}

vtkIdType OnRelief(vtkPolyData* relief, vtkIdType id)
{
  const auto points = static_cast<double>(relief->GetNumberOfPoints());
  const vtkIdType side = points > 0.0 ? static_cast<vtkIdType>(std::lround(std::sqrt(points))) : 9;
  return id / 9 * (side - 1) / 8 * side + id % 9 * (side - 1) / 8;
}

std::vector<vtkIdType> OnRelief(vtkPolyData* relief, std::vector<vtkIdType> ids)
{
  for (vtkIdType& id : ids)
  {
    id = OnRelief(relief, id);
  }
  return ids;
}

Points GetPointsOnEdges(vtkPolyData* relief)
{
  Points points;
  for (const vtkIdType id : OnRelief(relief, { 20, 24, 60, 56, 40 }))
  {
    double p[3];
    double q[3];
    relief->GetPoint(id, p);
    relief->GetPoint(id + 1, q);
    points.push_back(
      { { 0.75 * p[0] + 0.25 * q[0], 0.75 * p[1] + 0.25 * q[1], 0.75 * p[2] + 0.25 * q[2] } });
  }
  return points;
}

void AddNote(vtkPolyData* surface, const char* name)
{
  vtkNew<vtkStringArray> note;
  note->SetName(name);
  note->InsertNextValue("kept");
  surface->GetFieldData()->AddArray(note);
}

double AddSpaceDistances(vtkPolyData* surface)
{
  vtkNew<vtkDoubleArray> distances;
  distances->SetName("GeodesicDistance");
  double largest = 0.0;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    distances->InsertNextValue(EuclideanDistance(surface, 0, i));
    largest = std::max(largest, distances->GetValue(i));
  }
  surface->GetPointData()->AddArray(distances);
  return largest;
}
}
