// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Text of all points, cells and arrays, to compare data before and after writing and reading.
#ifndef MeshDescription_h
#define MeshDescription_h

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <charconv>
#include <string>

namespace dggtest
{
/// Returns the shortest text that is read back as the same number.
inline std::string Digits(double value)
{
  char buffer[32];
  return std::string(buffer, std::to_chars(buffer, buffer + sizeof(buffer), value).ptr);
}

inline void DescribeArrays(vtkDataSetAttributes* data, const char* kind, std::string& text)
{
  for (int a = 0; a < data->GetNumberOfArrays(); ++a)
  {
    vtkDataArray* array = data->GetArray(a);
    const bool isActive = array == data->GetNormals() || array == data->GetTCoords() ||
      (array == data->GetScalars() && array->GetNumberOfComponents() > 1);
    text += std::string("| ") + kind + (isActive ? "active " : "") + array->GetName() + " " +
      array->GetDataTypeAsString();
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      for (int c = 0; c < array->GetNumberOfComponents(); ++c)
      {
        text += (c == 0 && i > 0 ? ", " : " ") + Digits(array->GetComponent(i, c));
      }
    }
    text += " ";
  }
}

/// Returns all points, cells and arrays as text.
inline std::string Describe(vtkPolyData* data)
{
  std::string text = data->GetPoints()->GetDataType() == VTK_FLOAT ? "float " : "";
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    double p[3];
    data->GetPoint(i, p);
    text += (i > 0 ? ", " : "") + Digits(p[0]) + " " + Digits(p[1]) + " " + Digits(p[2]);
  }
  text += " ";
  const char* const kinds[] = { "verts", "lines", "polys" };
  vtkCellArray* const lists[] = { data->GetVerts(), data->GetLines(), data->GetPolys() };
  for (int k = 0; k < 3; ++k)
  {
    for (vtkIdType i = 0; i < lists[k]->GetNumberOfCells(); ++i)
    {
      text += i == 0 ? std::string("| ") + kinds[k] : ",";
      vtkIdType size = 0;
      const vtkIdType* ids = nullptr;
      lists[k]->GetCellAtId(i, size, ids);
      for (vtkIdType j = 0; j < size; ++j)
      {
        text += " " + std::to_string(ids[j]);
      }
    }
    text += lists[k]->GetNumberOfCells() > 0 ? " " : "";
  }
  DescribeArrays(data->GetPointData(), "", text);
  DescribeArrays(data->GetCellData(), "cells ", text);
  text.pop_back();
  return text;
}
}

#endif
