// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What the tests of point clouds share: PCD files as text, a cloud with everything, comparison.
#ifndef PCDTestTools_h
#define PCDTestTools_h

#include "vtkPCDReader.h"

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

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
class PCDTest : public testing::Test
{
protected:
  PCDTest();
  ~PCDTest() override;

  std::string GetPath(const std::string& name) const { return (this->Folder / name).string(); }
  std::string Write(const std::string& content, const std::string& name = "cloud.pcd") const;
  std::string Load(const std::string& name = "cloud.pcd") const;

  /// Read this content, or the file as it is.
  vtkPolyData* ReadWell(const std::string& content);
  vtkPolyData* ReadWellFile(const std::string& name = "cloud.pcd");
  /// The error has this code and names the file and all of `parts`, and the output is empty; then a
  /// good file is read well.
  void ExpectRefused(
    const std::string& content, unsigned long code, const std::vector<std::string>& parts);

  std::filesystem::path Folder;
  vtkNew<vtkPCDReader> Reader;
};

/// A cloud of 3 x 2 points with normals, colours, an array of each type of number, arrays of
/// several components, NaN, infinity and numbers that need all of their digits.
vtkSmartPointer<vtkPolyData> MakeRichCloud(int pointType, bool hasColors = true);

/// The coordinates and all arrays of points and of field data are the same, bit for bit, and so are
/// their names and types.
void ExpectSameCloud(vtkPolyData* a, vtkPolyData* b);
}

#endif
