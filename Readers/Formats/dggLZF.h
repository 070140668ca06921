// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// LZF, the compression of PCD files. Internal to the parser and the writer.
///
/// A stream of LZF is a sequence of items that begin with a control byte c:
/// - c < 32: c + 1 bytes follow and are taken as they are;
/// - otherwise a copy of earlier output. Its length is 2 plus the three high bits of c and, when
///   these are 7, plus one more byte. The five low bits of c are the high bits of the distance less
///   one, whose low bits are the last byte of the item.
#ifndef dggLZF_h
#define dggLZF_h

#include <cstddef> // for std::size_t
#include <vector>  // for the output

namespace dgg
{
/// Largest number of bytes per compressed byte: three bytes give 264.
constexpr std::size_t LZFMaximumRatio = 88;

/// Returns true if the input is well-formed and gives exactly `outputSize` bytes.
bool DecompressLZF(const char* input, std::size_t inputSize, char* output, std::size_t outputSize);

/// Appends the compressed input to the output.
void CompressLZF(const char* input, std::size_t inputSize, std::vector<char>& output);
}

#endif
