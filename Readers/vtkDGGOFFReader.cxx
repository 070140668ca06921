// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGOFFReader.h"

#include "vtkDGGOFFParser.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <numeric>

namespace
{
/// Enough of a file to find its keyword behind comments.
constexpr std::size_t KeywordRange = 4096;

void MakePoints(vtkDGGOFFParser& file, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetData(file.Points);
  output->SetPoints(points);
  vtkPointData* data = output->GetPointData();
  if (file.HasNormals)
  {
    file.Normals->SetName("Normals");
    data->SetNormals(file.Normals);
  }
  if (file.HasTCoords)
  {
    file.TCoords->SetName("TCoords");
    data->SetTCoords(file.TCoords);
  }
  if (file.HasColors)
  {
    std::vector<vtkIdType> order(static_cast<std::size_t>(points->GetNumberOfPoints()));
    std::iota(order.begin(), order.end(), vtkIdType(0));
    data->SetScalars(file.PointColors.MakeArray(order));
  }
}

/// One kind of cells after the other, as vtkPolyData numbers them.
void MakeCells(const vtkDGGOFFParser& file, vtkPolyData* output)
{
  vtkNew<vtkCellArray> verts;
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkCellArray> polys;
  const std::size_t faces = file.FaceOffsets.size() - 1;
  polys->AllocateExact(
    static_cast<vtkIdType>(faces), static_cast<vtkIdType>(file.Connectivity.size()));
  std::vector<vtkIdType> order;
  order.reserve(faces);
  const auto takeFaces = [&](vtkCellArray* cells, vtkIdType least, vtkIdType most) {
    for (std::size_t f = 0; f < faces; ++f)
    {
      const vtkIdType corners = file.FaceOffsets[f + 1] - file.FaceOffsets[f];
      if (corners >= least && corners <= most)
      {
        cells->InsertNextCell(corners, file.Connectivity.data() + file.FaceOffsets[f]);
        order.push_back(static_cast<vtkIdType>(f));
      }
    }
  };
  takeFaces(verts, 1, 1);
  takeFaces(lines, 2, 2);
  takeFaces(polys, 3, VTK_ID_MAX);
  if (verts->GetNumberOfCells() > 0)
  {
    output->SetVerts(verts);
  }
  if (lines->GetNumberOfCells() > 0)
  {
    output->SetLines(lines);
  }
  output->SetPolys(polys);
  if (file.FaceColors.IsUsed)
  {
    output->GetCellData()->SetScalars(file.FaceColors.MakeArray(order));
  }
}
}

vtkStandardNewMacro(vtkDGGOFFReader);

vtkDGGOFFReader::vtkDGGOFFReader()
{
  this->SetNumberOfInputPorts(0);
}

vtkDGGOFFReader::~vtkDGGOFFReader()
{
  this->SetFileName(nullptr);
}

int vtkDGGOFFReader::CanReadFile(const char* fileName)
{
  try
  {
    const std::vector<char> bytes = vtkDGG::LoadFile(fileName ? fileName : "", KeywordRange);
    vtkDGGOFFParser(bytes).ReadKeyword();
    return 1;
  }
  catch (const std::exception&)
  {
    return 0;
  }
}

int vtkDGGOFFReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  const auto read = [](const std::vector<char>& bytes, const vtkDGG::FileProgress& progress,
                      vtkPolyData* output) {
    vtkDGGOFFParser file(bytes);
    file.ReadKeyword();
    file.ReadData(progress);
    MakePoints(file, output);
    MakeCells(file, output);
  };
  unsigned long code = 0;
  const int result = vtkDGG::ReadFile(this, this->FileName, outputVector, read, code);
  this->SetErrorCode(code);
  return result;
}

void vtkDGGOFFReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}
