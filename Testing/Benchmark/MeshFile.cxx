// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshFile.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkPLYReader.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataReader.h>
#include <vtkSTLReader.h>
#include <vtkTriangleFilter.h>
#include <vtkXMLPolyDataReader.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <map>

namespace
{
template <class Reader>
vtkSmartPointer<vtkPolyData> ReadWith(const std::string& path)
{
  vtkNew<Reader> reader;
  reader->SetFileName(path.c_str());
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(reader->GetOutputPort());
  triangles->PassVertsOff();
  triangles->PassLinesOff();
  triangles->Update();
  return triangles->GetOutput();
}

std::string ExtensionOf(const std::string& path)
{
  const auto dot = path.find_last_of('.');
  std::string extension = dot == std::string::npos ? "" : path.substr(dot + 1);
  std::transform(extension.begin(), extension.end(), extension.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}
}

vtkSmartPointer<vtkPolyData> ReadPolyData(const std::string& path)
{
  static const std::map<std::string, vtkSmartPointer<vtkPolyData> (*)(const std::string&)>
    readers = { { "ply", ReadWith<vtkPLYReader> }, { "obj", ReadWith<vtkOBJReader> },
      { "stl", ReadWith<vtkSTLReader> }, { "vtp", ReadWith<vtkXMLPolyDataReader> },
      { "vtk", ReadWith<vtkPolyDataReader> } };
  const auto reader = readers.find(ExtensionOf(path));
  return reader == readers.end() ? vtkSmartPointer<vtkPolyData>::New() : reader->second(path);
}

MeshArrays ToArrays(vtkPolyData* mesh)
{
  MeshArrays arrays;
  arrays.Points.resize(3 * static_cast<std::size_t>(mesh->GetNumberOfPoints()));
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    mesh->GetPoint(i, arrays.Points.data() + 3 * i);
  }
  arrays.Triangles.reserve(3 * static_cast<std::size_t>(mesh->GetNumberOfPolys()));
  vtkCellArray* polys = mesh->GetPolys();
  polys->InitTraversal();
  vtkIdType size = 0;
  const vtkIdType* ids = nullptr;
  while (polys->GetNextCell(size, ids))
  {
    if (size == 3)
    {
      std::transform(ids, ids + 3, std::back_inserter(arrays.Triangles),
        [](vtkIdType id) { return static_cast<dgg::Id>(id); });
    }
  }
  return arrays;
}

vtkSmartPointer<vtkPolyData> ToPolyData(const MeshArrays& mesh)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(mesh.GetNumberOfVertices()));
  for (std::size_t i = 0; i < mesh.GetNumberOfVertices(); ++i)
  {
    points->SetPoint(static_cast<vtkIdType>(i), mesh.Points.data() + 3 * i);
  }
  vtkNew<vtkCellArray> polys;
  for (std::size_t f = 0; f < mesh.GetNumberOfFaces(); ++f)
  {
    const dgg::Id* corner = mesh.Triangles.data() + 3 * f;
    polys->InsertNextCell({ corner[0], corner[1], corner[2] });
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(polys);
  return data;
}

std::string StemOf(const std::string& path)
{
  const auto slash = path.find_last_of('/');
  const std::string name = slash == std::string::npos ? path : path.substr(slash + 1);
  return name.substr(0, name.find_last_of('.'));
}
