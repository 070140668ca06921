// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The bytes of a file, and what can be wrong with it. Internal to the readers.
#ifndef vtkDGGFileLoader_h
#define vtkDGGFileLoader_h

#include <cstddef>    // for std::size_t
#include <functional> // for the progress callback
#include <string>     // for messages
#include <vector>     // for the bytes

/// What went wrong, and the place: a line of a text file or a byte of a binary one.
struct vtkDGGFileError
{
  unsigned long Code = 0; ///< of vtkErrorCode; 0 when all is well
  std::string Message;
};

/// Called now and then with the finished fraction; returns false to stop.
using vtkDGGFileProgress = std::function<bool(double)>;

/// The first bytes of a file, at most `limit`. False on error.
bool vtkDGGLoadFile(
  const char* name, std::size_t limit, std::vector<char>& bytes, vtkDGGFileError& error);

/// A part of a file as it can be shown in a message: quoted, not too long, and printable.
std::string vtkDGGQuote(const char* first, const char* last);
std::string vtkDGGQuote(const std::string& text);

#endif
// VTK-HeaderTest-Exclude: vtkDGGFileLoader.h
