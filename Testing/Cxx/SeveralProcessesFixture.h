// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A surface, parts of which several processes have.
#ifndef SeveralProcessesFixture_h
#define SeveralProcessesFixture_h

#include "PartTestTools.h"

#include "vtkErrorCode.h"
#include "vtkMultiProcessController.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

namespace dggtest
{
/// Where cells come in another order, angles in graphs are rounded to other floats, and with them
/// corrected distances.
constexpr double FloatTolerance = 1e-7;

class SeveralProcesses : public testing::Test
{
protected:
  vtkMultiProcessController* Controller = vtkMultiProcessController::GetGlobalController();
  const int Count = Controller->GetNumberOfProcesses();
  const int Here = Controller->GetLocalProcessId();
  vtkSmartPointer<vtkPolyData> Surface = MakeTerrain(33);

  bool IsFirst() const { return this->Here == 0; }

  void Update(vtkAlgorithm* filter) { filter->UpdatePiece(this->Here, this->Count, 0); }

  /// The part of this process of a surface in strips.
  vtkSmartPointer<vtkPolyData> TakeStrip(
    vtkPolyData* surface, PartIds ids = PartIds::None, bool ghosts = false) const
  {
    return TakePart(surface, LabelStrips(surface, this->Count), this->Here, ids, ghosts);
  }

  vtkSmartPointer<vtkPolyData> TakeRandom(vtkPolyData* surface, unsigned int seed) const
  {
    return TakePart(surface, LabelRandomly(surface, this->Count, seed), this->Here);
  }

  /// A place amid the terrain, and one near its rim.
  static vtkSmartPointer<vtkPolyData> MakeSources()
  {
    return MakeSourcePoints({ { { 0.31, 0.42, GetTerrainHeight(0.31, 0.42) } },
      { { 0.9, 0.85, GetTerrainHeight(0.9, 0.85) } } });
  }

  /// What a filter finds without other processes.
  template <typename Filter>
  static vtkSmartPointer<Filter> Alone(
    vtkPolyData* surface, const std::function<void(Filter*)>& prepare)
  {
    auto filter = vtkSmartPointer<Filter>::New();
    filter->SetController(nullptr);
    filter->SetInputData(surface);
    prepare(filter);
    filter->Update();
    return filter;
  }

  template <typename Filter>
  vtkSmartPointer<Filter> Together(vtkDataObject* part, const std::function<void(Filter*)>& prepare)
  {
    auto filter = vtkSmartPointer<Filter>::New();
    filter->SetInputDataObject(part);
    prepare(filter);
    const Listener listener(filter);
    this->Update(filter);
    EXPECT_TRUE(listener.Errors.empty()) << listener.Errors[0];
    EXPECT_TRUE(listener.Warnings.empty()) << listener.Warnings[0];
    EXPECT_EQ(filter->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError));
    return filter;
  }

  /// Arrays of points of a part are those of the whole.
  static void ExpectArray(
    vtkPolyData* part, vtkPolyData* whole, const std::string& name, double tolerance)
  {
    vtkDataArray* array = part->GetPointData()->GetArray(name.c_str());
    vtkDataArray* expected = whole->GetPointData()->GetArray(name.c_str());
    vtkDataArray* ids = part->GetPointData()->GetArray("Whole");
    ASSERT_TRUE(array && expected) << name;
    ASSERT_EQ(array->GetNumberOfTuples(), part->GetNumberOfPoints());
    ASSERT_EQ(array->GetNumberOfComponents(), expected->GetNumberOfComponents());
    const double range = std::max(std::abs(expected->GetRange()[0]), expected->GetRange()[1]);
    for (vtkIdType i = 0; i < part->GetNumberOfPoints(); ++i)
    {
      const auto id = static_cast<vtkIdType>(ids->GetComponent(i, 0));
      for (int k = 0; k < array->GetNumberOfComponents(); ++k)
      {
        ASSERT_NEAR(array->GetComponent(i, k), expected->GetComponent(id, k), tolerance * range)
          << name << " at point " << id;
      }
    }
  }

  static vtkIdType GetNumberOfReached(vtkPolyData* part)
  {
    vtkDataArray* array = part->GetPointData()->GetArray("GeodesicDistance");
    vtkIdType reached = 0;
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      reached += array->GetComponent(i, 0) >= 0.0 ? 1 : 0;
    }
    return reached;
  }

  /// The same points in the same number of cells, whatever their order.
  static void ExpectSameSet(vtkPolyData* curves, vtkPolyData* expected, double tolerance)
  {
    ASSERT_GT(expected->GetNumberOfPoints(), 0);
    EXPECT_EQ(curves->GetNumberOfPoints(), expected->GetNumberOfPoints());
    EXPECT_EQ(curves->GetNumberOfCells(), expected->GetNumberOfCells());
    for (vtkIdType i = 0; i < expected->GetNumberOfPoints(); ++i)
    {
      double p[3];
      expected->GetPoint(i, p);
      double nearest = 1e300;
      for (vtkIdType j = 0; j < curves->GetNumberOfPoints(); ++j)
      {
        double q[3];
        curves->GetPoint(j, q);
        nearest = std::min(nearest, std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]));
      }
      ASSERT_LT(nearest, tolerance);
    }
  }
};
}

#endif
