// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A surface in pieces that are distributed over several processes.
#ifndef SeveralProcessesFixture_h
#define SeveralProcessesFixture_h

#include "PartTestTools.h"

#include "vtkErrorCode.h"
#include "vtkMultiProcessController.h"

namespace dggtest
{
class SeveralProcesses : public testing::Test
{
protected:
  vtkMultiProcessController* Controller = vtkMultiProcessController::GetGlobalController();
  const int Count = Controller->GetNumberOfProcesses();
  const int Here = Controller->GetLocalProcessId();
  vtkSmartPointer<vtkPolyData> Surface = MakeTerrain(33);

  bool IsFirst() const { return this->Here == 0; }

  void Update(vtkAlgorithm* filter) { filter->UpdatePiece(this->Here, this->Count, 0); }

  /// Returns the strip of a surface that belongs to this process.
  vtkSmartPointer<vtkPolyData> TakeStrip(
    vtkPolyData* surface, PartIds ids = PartIds::None, bool ghosts = false) const
  {
    return TakePart(surface, LabelStrips(surface, this->Count), this->Here, ids, ghosts);
  }

  vtkSmartPointer<vtkPolyData> TakeRandom(vtkPolyData* surface, unsigned int seed) const
  {
    return TakePart(surface, LabelRandomly(surface, this->Count, seed), this->Here);
  }

  /// Returns one source in the middle of the terrain and one near its rim.
  static vtkSmartPointer<vtkPolyData> MakeSources()
  {
    return MakeSourcePoints({ { { 0.31, 0.42, GetTerrainHeight(0.31, 0.42) } },
      { { 0.9, 0.85, GetTerrainHeight(0.9, 0.85) } } });
  }

  /// Returns the output of a filter without other processes.
  template <typename Filter, typename Prepare>
  static vtkSmartPointer<Filter> Alone(vtkPolyData* surface, const Prepare& prepare)
  {
    auto filter = vtkSmartPointer<Filter>::New();
    filter->SetController(nullptr);
    filter->SetInputData(surface);
    prepare(filter.Get());
    filter->Update();
    return filter;
  }

  template <typename Filter, typename Prepare>
  vtkSmartPointer<Filter> Together(vtkDataObject* part, const Prepare& prepare)
  {
    auto filter = vtkSmartPointer<Filter>::New();
    filter->SetInputDataObject(part);
    prepare(filter.Get());
    const Listener listener(filter);
    this->Update(filter);
    EXPECT_TRUE(listener.Errors.empty()) << listener.Errors[0];
    EXPECT_TRUE(listener.Warnings.empty()) << listener.Warnings[0];
    EXPECT_EQ(filter->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError));
    return filter;
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
};
}

#endif
