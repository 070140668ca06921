// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What follows the header of a PCD file. Internal to the reader.
#ifndef vtkDGGPCDBody_h
#define vtkDGGPCDBody_h

#include "vtkDGGFileLoader.h"  // for the error and the progress callback
#include "vtkDGGPCDHeader.h"   // for the header
#include "vtkDGGPointFields.h" // for the view

#include <vector> // for the buffer

class vtkDGGPCDBody
{
public:
  vtkDGGPCDBody(const char* begin, const char* end, const vtkDGGPCDHeader& header,
    const vtkDGGFileProgress& progress);
  vtkDGGPCDBody(const vtkDGGPCDBody&) = delete;
  vtkDGGPCDBody& operator=(const vtkDGGPCDBody&) = delete;

  /// Find the values of all fields in the file [begin, end), which must stay where it is. Nothing
  /// is allocated before the number of points is compared with the size of the file. False on error
  /// (see GetError()) and when stopped (no error then).
  bool Read();
  const vtkDGGFileError& GetError() const { return this->Error; }
  /// Where the values are: in the file, or in a buffer of this object. Without padding.
  const vtkDGG::PointCloudView& GetView() const { return this->View; }

private:
  bool ReadText();
  bool ReadLine(const char*& cursor, std::size_t line, vtkIdType point);
  bool ReadBinary();
  bool ReadCompressed();
  bool Tell(double done) const;
  bool Decompress(std::size_t compressed, std::size_t uncompressed);

  /// Points one after the other, each with all of its fields, or (`isByField`) fields one after the
  /// other, each of all points.
  void SetView(const char* data, bool isByField, bool hasPadding);
  bool CheckRest(const char* rest);
  bool FailAtLine(unsigned long code, std::size_t line, const std::string& message);
  bool FailAtByte(unsigned long code, const char* place, const std::string& message);
  bool FailCount(const std::string& needed);

  const char* const Begin;
  const char* const Body;
  const char* const End;
  const vtkDGGPCDHeader& Header;
  const vtkDGGFileProgress& Progress;
  std::vector<char> Buffer;
  vtkDGG::PointCloudView View;
  vtkDGGFileError Error;
};

#endif
// VTK-HeaderTest-Exclude: vtkDGGPCDBody.h
