// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What the tests of vtkDGGDistance start from.
#ifndef DGGDistanceFixture_h
#define DGGDistanceFixture_h

#include "GraphTestTools.h"

#include "vtkDGGDistance.h"

#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace dggtest
{
/// A terrain, and a filter that finds distances on it from one of its points. The suite has its
/// name, in several files.
class DGGDistance : public ::testing::Test
{
protected:
  void SetUp() override
  {
    this->Filter->SetInputData(this->Terrain);
    this->Filter->AddSourceId(40);
  }

  void ExpectBuilt(const char* what)
  {
    ExpectSuccess(this->Filter);
    EXPECT_GT(this->Filter->GetGraphBuildTime(), this->Built) << what;
    this->Built = this->Filter->GetGraphBuildTime();
  }

  void ExpectKept(const char* what)
  {
    ExpectSuccess(this->Filter);
    EXPECT_EQ(this->Filter->GetGraphBuildTime(), this->Built) << what;
  }

  /// One component of a point array of the output; empty when there is none of that name.
  static std::vector<double> GetComponent(
    vtkDGGDistance* filter, const char* name, int component = 0)
  {
    std::vector<double> values;
    vtkDataArray* array = filter->GetOutput()->GetPointData()->GetArray(name);
    for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
    {
      values.push_back(array->GetComponent(i, component));
    }
    return values;
  }

  /// Places at vertices, on edges, inside of faces and at the rim of a sheet.
  static Points GetPlaces(vtkPolyData* surface)
  {
    Points places;
    for (vtkIdType cell = 3; cell < surface->GetNumberOfCells(); cell += 97)
    {
      vtkNew<vtkIdList> ids;
      surface->GetCellPoints(cell, ids);
      std::array<double, 3> corners[3];
      for (int k = 0; k < 3; ++k)
      {
        surface->GetPoint(ids->GetId(k), corners[k].data());
      }
      for (const std::array<double, 3>& weights :
        { std::array<double, 3>{ { 0.2, 0.3, 0.5 } }, std::array<double, 3>{ { 0.01, 0.01, 0.98 } },
          std::array<double, 3>{ { 0.5, 0.5, 0 } },
          std::array<double, 3>{ { 0.9, 0.0999, 0.0001 } } })
      {
        std::array<double, 3> place{ { 0, 0, 0 } };
        for (int k = 0; k < 3; ++k)
        {
          for (int i = 0; i < 3; ++i)
          {
            place[i] += weights[k] * corners[k][i];
          }
        }
        places.push_back(place);
      }
    }
    return places;
  }

  vtkSmartPointer<vtkPolyData> Terrain = MakeTerrain(24);
  vtkNew<vtkDGGDistance> Filter;
  vtkMTimeType Built = 0;
};
}

#endif
