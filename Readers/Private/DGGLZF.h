// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The compression of PCD files, LZF. Internal to the reader and the writer.
///
/// A stream of LZF is a sequence of items that begin with a control byte c:
/// - c < 32: c + 1 bytes follow and are taken as they are;
/// - otherwise a copy of what was put out before. Its length is 2 plus the three high bits of c,
/// and
///   when these are 7, plus one more byte. The five low bits of c are the high bits of the distance
///   less one, whose low bits are the last byte of the item.
///
/// PCL has the same in its library of files, which brings a whole VTK and Qt with it.
#ifndef DGGLZF_h
#define DGGLZF_h

#include <cstddef> // for std::size_t
#include <vector>  // for the output

/// More than that many bytes per compressed byte cannot come out: three bytes give 264.
constexpr std::size_t DGGLZFMaximumRatio = 88;

/// True when the input is well-formed and gives just as many bytes as there is room for.
bool DGGDecompressLZF(
  const char* input, std::size_t inputSize, char* output, std::size_t outputSize);

/// Append the compressed input to the output.
void DGGCompressLZF(const char* input, std::size_t inputSize, std::vector<char>& output);

#endif
