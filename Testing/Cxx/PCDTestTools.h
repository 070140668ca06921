// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Tools shared by the tests of point cloud files: PCD files as text, a cloud with all kinds of
/// arrays, comparison.
#ifndef PCDTestTools_h
#define PCDTestTools_h

#include "ReaderFixture.h"

#include "vtkPCDReader.h"

#include <cstdint>

namespace dggtest
{
/// The lines of a header; empty lines are omitted.
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

/// A valid file of two points.
extern const char* const GoodPCD;

/// Returns the two sizes that precede compressed data, as bytes.
std::string Sizes(std::uint32_t compressed, std::uint32_t uncompressed);

/// Fixture of tests that read and write in a separate folder.
class PCDTest : public ReaderFixture<vtkPCDReader>
{
protected:
  PCDTest()
    : ReaderFixture("cloud.pcd", GoodPCD)
  {
  }
};

/// Returns a cloud of 3 x 2 points with normals, colors, an array of each numeric type, arrays of
/// several components, NaN, infinity and values that need all of their digits.
vtkSmartPointer<vtkPolyData> MakeRichCloud(int pointType, bool hasColors = true);

/// Expects that all arrays are bitwise equal and have equal names and types.
void ExpectSameArrays(vtkFieldData* a, vtkFieldData* b);
/// Expects that coordinates and all point and field arrays are bitwise equal and have equal names
/// and types.
void ExpectSameCloud(vtkPolyData* a, vtkPolyData* b);
}

#endif
