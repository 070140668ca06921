// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The header of PCD files, read and written. Internal to the parser and the writer.
#ifndef dggPCDHeader_h
#define dggPCDHeader_h

#include "dggFileText.h"    // for the text
#include "dggPointFields.h" // for fields and layout

#include <cstddef> // for std::size_t
#include <string>  // for the text
#include <vector>  // for the fields

namespace dgg
{
enum class PCDData
{
  ASCII,
  Binary,
  BinaryCompressed
};

struct PCDHeader
{
  /// Limit of fields: VTK's search of arrays by name is linear, so the time is quadratic.
  static constexpr std::size_t MaximumFields = 10000;

  std::vector<PointField> Fields; ///< padding (`_`) included
  CloudLayout Layout;
  PCDData Data = PCDData::ASCII;
  std::size_t FieldsLine = 0; ///< line with the names of the fields
  std::size_t CountLine = 0;  ///< line with the number of points

  std::int64_t GetNumberOfPoints() const { return this->Layout.Width * this->Layout.Height; }
  /// Returns the bytes of a point in a binary file.
  std::size_t GetPointBytes() const;

  /// Reads the header of a file and moves past it. Does not read the body. Throws FileError.
  void Parse(TextCursor& text);
  /// Returns the header as text, from the first line to the line with DATA.
  std::string Format() const;
};
}

#endif
