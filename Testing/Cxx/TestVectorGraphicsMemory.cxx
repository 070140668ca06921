// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// vtkPoissonVectorGraphics tells what it keeps, and what it keeps is not asked for again.
#include "../Benchmark/MemoryProbe.h"
#include "VectorGraphicsTestTools.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <fstream>
#include <limits>
#include <string>

#if defined(__linux__)
#include <sys/resource.h>
#endif

using namespace dggtest;

namespace
{
/// Each of two ends of a line `count` times.
GraphicsFixture MakeLine(std::size_t count, vtkPolyData* surface)
{
  Points points(count, { { 0.3, 0.4, 0.0 } });
  points.insert(points.end(), count, { { 0.7, 0.5, 0.0 } });
  Cells lines(1);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    lines[0].push_back(static_cast<vtkIdType>(i));
  }
  GraphicsFixture drawing(points, lines);
  drawing.Filter->SetInputData(surface);
  drawing.Filter->SetProjectionTolerance(0.5); // to the bumps
  drawing.Filter->SetRefinementLevel(0);
  return drawing;
}

void SetColors(GraphicsFixture& drawing, double left)
{
  const auto count = static_cast<std::size_t>(drawing.Curves->GetNumberOfPoints());
  AddArray(drawing.OfPoints(), "LeftColor", std::vector<double>(8 * count, left), 8);
  AddArray(drawing.OfPoints(), "RightColor", std::vector<double>(8 * count, 1.0), 8);
  drawing.Curves->Modified();
}

#if defined(__linux__)
double ReadStatus(const std::string& key)
{
  std::ifstream status("/proc/self/status");
  std::string word;
  while (status >> word && word != key + ":")
  {
    status.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
  }
  double kilobytes = 0.0;
  status >> kilobytes;
  return 1024.0 * kilobytes;
}

/// As long as it lives, no more data than that.
class DataLimit
{
public:
  explicit DataLimit(double bytes)
  {
    getrlimit(RLIMIT_DATA, &this->Before);
    rlimit now = this->Before;
    now.rlim_cur = static_cast<rlim_t>(bytes);
    this->IsSet = setrlimit(RLIMIT_DATA, &now) == 0;
  }
  ~DataLimit() { setrlimit(RLIMIT_DATA, &this->Before); }
  DataLimit(const DataLimit&) = delete;
  DataLimit& operator=(const DataLimit&) = delete;

  bool IsSet = false;

private:
  rlimit Before;
};
#endif
}

#if defined(__linux__)
TEST(VectorGraphicsMemory, WhatIsKeptIsNotAskedForAgain)
{
  // As much memory is left as for most of what is kept, which is more than other colours take.
  const auto surface = MakeTerrain(200);
  GraphicsFixture drawing = MakeLine(1, surface);
  SetColors(drawing, 0.0);
  drawing.Run();
  const auto kept = static_cast<double>(drawing.Filter->GetMemorySize());
  const double limit = ReadStatus("VmRSS") + 0.8 * kept;
  if (ReadStatus("VmData") + 0.6 * kept > limit)
  {
    GTEST_SKIP() << "stacks of threads and the like are too large beside what is kept";
  }
  SetColors(drawing, 0.5);
  const DataLimit leave(limit);
  ASSERT_TRUE(leave.IsSet);
  drawing.Run();
  EXPECT_EQ(drawing.Filter->GetNumberOfFactorizations(), 1);
  EXPECT_EQ(drawing.Filter->GetMemorySize(), static_cast<vtkTypeUInt64>(kept));
}
#endif
