// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What the tests of vtkDGGPath start from.
#ifndef PathFixture_h
#define PathFixture_h

#include "PathTestTools.h"

#include "vtkCellArray.h"

#include <gtest/gtest.h>

#include <array>
#include <utility>
#include <vector>

namespace dggtest
{
/// A terrain, and a filter that looks for paths on it.
class PathFixture : public ::testing::Test
{
protected:
  using Pairs = std::vector<std::pair<vtkIdType, vtkIdType>>;

  void SetUp() override
  {
    this->Filter->SetInputData(this->Terrain);
    this->Filter->SetAccuracy(0.05);
  }

  static void AddPairs(vtkDGGPath* filter, const Pairs& pairs)
  {
    for (const auto& pair : pairs)
    {
      filter->AddPair(pair.first, pair.second);
    }
  }

  /// The terrain, and places on it: in faces, on edges, at vertices.
  static Points GetPlaces(vtkPolyData* surface)
  {
    const double weights[][3] = { { 0.2, 0.3, 0.5 }, { 0.6, 0.4, 0.0 }, { 1.0, 0.0, 0.0 },
      { 0.98, 0.01, 0.01 } };
    Points places;
    for (int i = 0; i < 16; ++i)
    {
      const vtkIdType cell = (i * 7919 + 31) % surface->GetNumberOfCells();
      vtkIdType size = 0;
      const vtkIdType* ids = nullptr;
      surface->GetPolys()->GetCellAtId(cell, size, ids);
      std::array<double, 3> place{ { 0.0, 0.0, 0.0 } };
      for (int k = 0; k < 3; ++k)
      {
        double p[3];
        surface->GetPoint(ids[k], p);
        for (int c = 0; c < 3; ++c)
        {
          place[c] += weights[i % 4][k] * p[c];
        }
      }
      places.push_back(place);
    }
    return places;
  }

  vtkSmartPointer<vtkPolyData> Terrain = MakeTerrain(20);
  vtkNew<vtkDGGPath> Filter;
};
}

#endif
