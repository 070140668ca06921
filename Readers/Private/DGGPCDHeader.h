// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The header of PCD files, read and written. Internal to the reader and the writer.
#ifndef DGGPCDHeader_h
#define DGGPCDHeader_h

#include "DGGFileLoader.h"     // for the text
#include "vtkDGGPointFields.h" // for fields and viewpoint

#include <cstddef> // for std::size_t
#include <string>  // for the text
#include <vector>  // for the fields

enum class DGGPCDData
{
  ASCII,
  Binary,
  BinaryCompressed
};

struct DGGPCDHeader
{
  /// VTK seeks arrays one by one, so that many more would take forever.
  static constexpr std::size_t MostFields = 10000;

  std::vector<vtkDGG::PointField> Fields; ///< padding (`_`) included
  vtkIdType Width = 0;
  vtkIdType Height = 1;
  vtkDGG::Viewpoint Sensor = vtkDGG::PointCloudView().Sensor;
  DGGPCDData Data = DGGPCDData::ASCII;
  std::size_t FieldsLine = 0; ///< the line with the names of the fields
  std::size_t CountLine = 0;  ///< the line with the number of points

  vtkIdType GetNumberOfPoints() const { return this->Width * this->Height; }
  /// Bytes of a point in a binary file.
  std::size_t GetPointBytes() const;

  /// Understand the header of a file, and move behind it. Nothing is known about the body then.
  /// Throws vtkDGG::FileError.
  void Parse(vtkDGG::TextCursor& text);
  /// The header as text, from the first line to the one with DATA.
  std::string Format() const;
};

/// Whether the beginning of a file can be that of a PCD file.
bool DGGLooksLikePCD(std::string_view begin);

#endif
