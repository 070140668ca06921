// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGOFFReader.h"

#include "vtkDGGFileLoader.h"
#include "vtkDGGOFFBinaryParser.h"
#include "vtkDGGOFFContents.h"
#include "vtkDGGOFFTextParser.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkErrorCode.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace
{
/// Enough of a file to find its keyword behind comments.
constexpr std::size_t KeywordRange = 4096;

/// False on error, and when stopped by the callback (without an error).
bool ParseFile(const std::vector<char>& bytes, const vtkDGGOFFProgress& progress,
  vtkDGGOFFContents& contents, vtkDGGOFFError& error)
{
  const char* const begin = bytes.data();
  const char* const end = begin + bytes.size();
  if (bytes.empty())
  {
    error = { vtkErrorCode::PrematureEndOfFileError, "line 1: the file is empty" };
    return false;
  }
  const char* binary = nullptr;
  vtkDGGOFFTextParser text(begin, end, progress, contents);
  if (!text.ReadKeyword(binary))
  {
    error = text.GetError();
    return false;
  }
  if (!binary)
  {
    const bool parsed = text.Parse();
    error = text.GetError();
    return parsed;
  }
  vtkDGGOFFBinaryParser data(begin, end, binary, progress, contents);
  const bool parsed = data.Parse();
  error = data.GetError();
  return parsed;
}

/// Colours of the records in the given order.
vtkNew<vtkUnsignedCharArray> MakeColors(
  const vtkDGGOFFColors& colors, const std::vector<vtkIdType>& order)
{
  const int components = colors.GetNumberOfComponents();
  vtkNew<vtkUnsignedCharArray> array;
  array->SetName(components == 4 ? "RGBA" : "RGB");
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(order.size()));
  unsigned char* out = array->GetPointer(0);
  for (const vtkIdType record : order)
  {
    for (int c = 0; c < components; ++c)
    {
      *out++ = colors.Get(static_cast<std::size_t>(record), c);
    }
  }
  return array;
}

vtkNew<vtkFloatArray> MakeFloats(const char* name, int components, const std::vector<float>& values)
{
  vtkNew<vtkFloatArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()) / components);
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  return array;
}

void MakePoints(const vtkDGGOFFContents& contents, vtkPolyData* output)
{
  const auto count = static_cast<vtkIdType>(contents.Points.size() / 3);
  vtkNew<vtkDoubleArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(count);
  std::copy(contents.Points.begin(), contents.Points.end(), coordinates->GetPointer(0));
  vtkNew<vtkPoints> points;
  points->SetData(coordinates);
  output->SetPoints(points);

  vtkPointData* data = output->GetPointData();
  if (contents.Header.HasNormals)
  {
    data->SetNormals(MakeFloats("Normals", 3, contents.Normals));
  }
  if (contents.Header.HasTCoords)
  {
    data->SetTCoords(MakeFloats("TCoords", 2, contents.TCoords));
  }
  if (contents.Header.HasColors)
  {
    std::vector<vtkIdType> order(static_cast<std::size_t>(count));
    for (vtkIdType v = 0; v < count; ++v)
    {
      order[static_cast<std::size_t>(v)] = v;
    }
    data->SetScalars(MakeColors(contents.PointColors, order));
  }
}

void MakeCells(const vtkDGGOFFContents& contents, vtkPolyData* output)
{
  // One kind of cells after the other, as vtkPolyData numbers them.
  vtkNew<vtkCellArray> verts;
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkCellArray> polys;
  polys->AllocateExact(static_cast<vtkIdType>(contents.FaceOffsets.size()) - 1,
    static_cast<vtkIdType>(contents.Connectivity.size()));
  std::vector<vtkIdType> order;
  order.reserve(contents.FaceOffsets.size() - 1);
  auto takeFaces = [&](vtkCellArray* cells, vtkIdType least, vtkIdType most) {
    for (std::size_t f = 0; f + 1 < contents.FaceOffsets.size(); ++f)
    {
      const vtkIdType corners = contents.FaceOffsets[f + 1] - contents.FaceOffsets[f];
      if (corners >= least && corners <= most)
      {
        cells->InsertNextCell(corners, contents.Connectivity.data() + contents.FaceOffsets[f]);
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
  if (contents.FaceColors.IsUsed())
  {
    output->GetCellData()->SetScalars(MakeColors(contents.FaceColors, order));
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
  std::vector<char> bytes;
  vtkDGGOFFError error;
  if (!fileName || !vtkDGGLoadFile(fileName, KeywordRange, bytes, error) || bytes.empty())
  {
    return 0;
  }
  vtkDGGOFFContents contents;
  const vtkDGGOFFProgress noProgress;
  const char* binary = nullptr;
  vtkDGGOFFTextParser text(bytes.data(), bytes.data() + bytes.size(), noProgress, contents);
  return text.ReadKeyword(binary) ? 1 : 0;
}

int vtkDGGOFFReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  const vtkDGGFileProgress progress = [this](double done) {
    this->UpdateProgress(0.9 * done);
    return this->GetAbortExecute() == 0;
  };
  const auto read = [&](vtkPolyData* output, vtkDGGFileError& error) {
    std::vector<char> bytes;
    vtkDGGOFFContents contents;
    if (!vtkDGGLoadFile(this->FileName, SIZE_MAX, bytes, error) ||
      !ParseFile(bytes, progress, contents, error))
    {
      return false;
    }
    std::vector<char>().swap(bytes);
    MakePoints(contents, output);
    MakeCells(contents, output);
    this->UpdateProgress(1.0);
    return true;
  };
  vtkDGGFileError error;
  const int done = vtkDGGReadFile(this->FileName, outputVector, read, error);
  this->SetErrorCode(error.Code);
  if (error.Code != vtkErrorCode::NoError)
  {
    vtkErrorMacro(<< error.Message);
  }
  return done;
}

void vtkDGGOFFReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}
