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

class vtkInformationVector;
class vtkPolyData;

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

/// What reading a file into the output of a reader comes to, whatever the format: `read` fills the
/// output and returns whether it did; nothing of what it throws gets out. Without a file name it is
/// not called. Returns what RequestData() returns. When it failed, the output is empty and `error`
/// says why; when it was stopped, the output does not count as up to date.
int vtkDGGReadFile(const char* fileName, vtkInformationVector* outputVector,
  const std::function<bool(vtkPolyData* output, vtkDGGFileError& error)>& read,
  vtkDGGFileError& error);

/// A part of a file as it can be shown in a message: quoted, not too long, and printable.
std::string vtkDGGQuote(const char* first, const char* last);
std::string vtkDGGQuote(const std::string& text);

#endif
// VTK-HeaderTest-Exclude: vtkDGGFileLoader.h
