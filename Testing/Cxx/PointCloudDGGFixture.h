// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What the tests of vtkPointCloudDGG start from.
#ifndef PointCloudDGGFixture_h
#define PointCloudDGGFixture_h

#include "CloudTestTools.h"

#include <gtest/gtest.h>

namespace dggtest
{
/// The filter, with any cloud.
class PointCloudDGG : public ::testing::Test
{
protected:
  void Use(const Points& points) { this->Filter->SetInputData(MakeCloud(points)); }
  vtkPolyData* GetOutput() { return this->Filter->GetOutput(); }

  vtkNew<vtkPointCloudDGG> Filter;
};
}

#endif
