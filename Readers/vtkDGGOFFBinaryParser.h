// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Binary OFF files. Internal to the reader.
#ifndef vtkDGGOFFBinaryParser_h
#define vtkDGGOFFBinaryParser_h

#include "vtkDGGOFFContents.h" // for vtkDGGOFFParser

#include <cstdint> // for std::int32_t

/// 32-bit integers and floats, most significant byte first.
class vtkDGGOFFBinaryParser : public vtkDGGOFFParser
{
public:
  /// `dataBegin` is where the data begin, in the file [begin, end).
  vtkDGGOFFBinaryParser(const char* begin, const char* end, const char* dataBegin,
    const vtkDGGOFFProgress& progress, vtkDGGOFFContents& contents);

protected:
  bool ReadCounts(long long& vertices, long long& faces) override;
  bool ReadVertex(vtkIdType vertex) override;
  bool ReadFace(vtkIdType face) override;
  bool ReadEnd() override;
  std::string DescribePlace(std::size_t place) const override;
  std::size_t GetPlace() const override;
  std::size_t GetLeastVertexSize() const override;
  std::size_t GetLeastFaceSize() const override { return 12; } // one corner, no colour

private:
  bool ReadInteger(const std::string& what, std::int32_t& value);
  bool ReadNumber(const std::string& what, float& value);
  bool ReadNumbers(const char* what, vtkIdType record, int count, float* values);
};

#endif
// VTK-HeaderTest-Exclude: vtkDGGOFFBinaryParser.h
