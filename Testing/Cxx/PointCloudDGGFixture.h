// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Fixture of the tests of vtkPointCloudDGG.
#ifndef PointCloudDGGFixture_h
#define PointCloudDGGFixture_h

#include "CloudTestTools.h"

namespace dggtest
{
/// The filter, on a replaceable cloud.
class PointCloudDGG : public ::testing::Test
{
protected:
  void Use(const Points& points) { this->Filter->SetInputData(MakeCloud(points)); }
  vtkPolyData* GetOutput() { return this->Filter->GetOutput(); }

  vtkNew<vtkPointCloudDGG> Filter;
};
}

#endif
