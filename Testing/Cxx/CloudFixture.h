// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Fixture of the tests of filters that use the output of vtkPointCloudDGG.
#ifndef CloudFixture_h
#define CloudFixture_h

#include "CloudTestTools.h"

#include "vtkDataSetAttributes.h"

namespace dggtest
{
/// A point cloud with its graph.
class CloudFixture : public ::testing::Test
{
protected:
  void Use(const Points& points)
  {
    this->Cloud = points;
    this->Graph->SetInputData(MakeCloud(points));
  }
  template <typename Filter>
  void Connect(Filter& filter)
  {
    filter->SetInputConnection(this->Graph->GetOutputPort());
  }
  static std::array<double, 3> At(vtkPolyData* data, vtkIdType i)
  {
    std::array<double, 3> p;
    data->GetPoint(i, p.data());
    return p;
  }
  static double Value(vtkDataSetAttributes* data, const char* name, vtkIdType i)
  {
    vtkDataArray* array = data->GetArray(name);
    EXPECT_NE(array, nullptr) << name;
    return array ? array->GetTuple1(i) : NAN;
  }

  Points Cloud;
  vtkNew<vtkPointCloudDGG> Graph;
};
}

#endif
