// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Numbers in the text of PCD files. Internal to the reader and the writer.
#ifndef vtkDGGPCDText_h
#define vtkDGGPCDText_h

#include <string> // for the text

/// Put the number that [first, last) says, of that kind (F, I or U) and size, at `out`, in any
/// locale. Floats may be nan and inf; one that is too small is zero. On error false, and `trouble`
/// completes "'text' ...".
bool vtkDGGParsePCDNumber(
  const char* first, const char* last, char kind, int size, char* out, std::string& trouble);

/// Append the number at `in`: the shortest text that gives the same number again.
void vtkDGGAppendPCDNumber(const char* in, char kind, int size, std::string& text);

#endif
// VTK-HeaderTest-Exclude: vtkDGGPCDText.h
