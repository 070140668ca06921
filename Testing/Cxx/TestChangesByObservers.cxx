// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Distances are those of the points that the output has, even when an observer moves them in the
/// middle of an update.
#include "FilterTestTools.h"

#include "vtkDGGDistance.h"
#include "vtkExactGeodesicDistance.h"
#include "vtkFastMarchingGeodesicDistance.h"
#include "vtkHeatGeodesicDistance.h"

#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkPoints.h"

#include <gtest/gtest.h>

#include <functional>
#include <utility>

using namespace dggtest;

/// A surface, and something that an observer does to it once.
template <typename FilterType>
class ChangesByObservers : public ::testing::Test
{
protected:
  ChangesByObservers()
  {
    this->Filter->SetInputData(this->Surface);
    this->Filter->AddSourceId(30);
    this->Command->SetClientData(this);
    this->Command->SetCallback([](vtkObject* caller, unsigned long, void* data, void*) {
      auto* self = static_cast<ChangesByObservers*>(data);
      // The mesh has been prepared by then.
      if (self->Change && vtkAlgorithm::SafeDownCast(caller)->GetProgress() >= 0.1)
      {
        self->Change(self->Surface);
        self->Change = nullptr;
      }
    });
    this->Filter->AddObserver(vtkCommand::ProgressEvent, this->Command);
    // So that the filter has something to keep.
    ExpectSuccess(this->Filter);
  }

  void During(std::function<void(vtkPolyData*)> change)
  {
    this->Change = std::move(change);
    this->Filter->Modified();
  }

  std::function<void(vtkPolyData*)> Change;
  vtkSmartPointer<vtkPolyData> Surface = MakeTerrain(24);
  vtkNew<FilterType> Filter;
  vtkNew<vtkCallbackCommand> Command;
};
using Filters = ::testing::Types<vtkDGGDistance, vtkExactGeodesicDistance,
  vtkFastMarchingGeodesicDistance, vtkHeatGeodesicDistance>;
TYPED_TEST_SUITE(ChangesByObservers, Filters);

TYPED_TEST(ChangesByObservers, PointsThatAreMoved)
{
  const auto before = GetDistances(this->Filter);
  for (const bool tellsByPoints : { true, false })
  {
    this->During([=](vtkPolyData* surface) {
      double p[3];
      surface->GetPoint(100, p);
      surface->GetPoints()->SetPoint(100, p[0], p[1], p[2] + 0.3);
      tellsByPoints ? surface->GetPoints()->Modified() : surface->Modified();
    });
    ExpectError(this->Filter, { "points were changed", "observers" });
    ASSERT_FALSE(this->Change) << "the observer was not called";
    ExpectSuccess(this->Filter);
    EXPECT_NE(GetDistances(this->Filter), before);
  }
}

TYPED_TEST(ChangesByObservers, CellsThatAreChanged)
{
  this->During([](vtkPolyData* surface) {
    const vtkIdType ids[3] = { 0, 1, 100 };
    surface->GetPolys()->ReplaceCellAtId(7, 3, ids);
    surface->GetPolys()->Modified();
  });
  ExpectError(this->Filter, { "changed during the update", "cells", "observers" });
  ASSERT_FALSE(this->Change) << "the observer was not called";
  Listener listener(this->Filter.Get()); // of the edge with three triangles
  this->Filter->Update();
  EXPECT_TRUE(listener.Errors.empty());
}

TYPED_TEST(ChangesByObservers, WhatIsNoChange)
{
  const auto before = GetDistances(this->Filter);
  const std::function<void(vtkPolyData*)> changes[] = {
    [](vtkPolyData* surface) { surface->GetPoints()->Modified(); },
    [](vtkPolyData* surface) { surface->Modified(); },
    // The output has the points from before.
    [](vtkPolyData* surface) {
      vtkNew<vtkPoints> points;
      points->DeepCopy(surface->GetPoints());
      points->SetPoint(100, 0.0, 0.0, 9.0);
      surface->SetPoints(points);
    },
  };
  for (const auto& change : changes)
  {
    this->During(change);
    ExpectSuccess(this->Filter);
    ASSERT_FALSE(this->Change) << "the observer was not called";
    EXPECT_EQ(GetDistances(this->Filter), before);
  }
  EXPECT_NE(this->Filter->GetOutput()->GetPoint(100)[2], 9.0);
  this->Filter->Modified();
  ExpectSuccess(this->Filter);
  EXPECT_NE(GetDistances(this->Filter), before);
}
