// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What the tests of point clouds share: PCD files as text, a cloud with everything, comparison.
#ifndef PCDTestTools_h
#define PCDTestTools_h

#include "ReaderFixture.h"

#include "vtkPCDReader.h"
#include "vtkSmartPointer.h"

#include <cstdint>
#include <string>

namespace dggtest
{
/// The lines of a header; those that are empty are left out.
struct PCDLines
{
  std::string Fields = "x y z";
  std::string Size = "4 4 4";
  std::string Type = "F F F";
  std::string Count = "1 1 1";
  std::string Width = "2";
  std::string Height = "1";
  std::string Viewpoint = "0 0 0 1 0 0 0";
  std::string Points = "2";
  std::string Data = "ascii";

  std::string Format() const;
};

/// A file of two points that is well.
extern const char* const GoodPCD;

/// The two numbers before compressed data.
std::string Sizes(std::uint32_t compressed, std::uint32_t uncompressed);

/// Tests that read and write in a folder of their own.
class PCDTest : public ReaderFixture<vtkPCDReader>
{
protected:
  PCDTest()
    : ReaderFixture("cloud.pcd", GoodPCD)
  {
  }
};

/// A cloud of 3 x 2 points with normals, colours, an array of each type of number, arrays of
/// several components, NaN, infinity and numbers that need all of their digits.
vtkSmartPointer<vtkPolyData> MakeRichCloud(int pointType, bool hasColors = true);

/// Expects that all arrays are the same, bit for bit, and so are their names and types.
void ExpectSameArrays(vtkFieldData* a, vtkFieldData* b);
/// The coordinates and all arrays of points and of field data are the same, bit for bit, and so are
/// their names and types.
void ExpectSameCloud(vtkPolyData* a, vtkPolyData* b);
}

#endif
