// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkPointCloudDGG: observers of its progress that change what it works with.
#include "CloudTestTools.h"
#include "GraphTestTools.h"

#include "vtkCommand.h"
#include "vtkDoubleArray.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace dggtest
{
TEST(PointCloudObservers, MayReleaseTheGraph)
{
  // Which must not take away the normals that it is being built with.
  const auto cloud = MakeCloud(MakeSpherePoints(3000));
  vtkNew<vtkPointCloudDGG> filter;
  filter->SetInputData(cloud);
  filter->EstimateNormalsOn();
  ExpectSuccess(filter);
  const std::vector<std::string> bytes = GetCloudBytes(filter->GetOutput());
  vtkNew<vtkPointCloudDGG> other;
  other->SetInputData(cloud);
  other->EstimateNormalsOn();
  struct Releaser
  {
    vtkPointCloudDGG* Filter;
    void Observe() { this->Filter->ReleaseGraph(); }
  } releaser{ other };
  other->AddObserver(vtkCommand::ProgressEvent, &releaser, &Releaser::Observe);
  ExpectSuccess(other);
  EXPECT_EQ(GetCloudBytes(other->GetOutput()), bytes);
}

TEST(PointCloudObservers, MayChangeThePoints)
{
  const auto cloud = MakeCloud(MakeSpherePoints(3000));
  vtkNew<vtkPointCloudDGG> filter;
  filter->SetInputData(cloud);
  ExpectErrorWhenPointsChange(filter, cloud, { "points were changed" });
}

TEST(PointCloudObservers, MayChangeTheNormals)
{
  // In place, when it has been looked at whether they fit: an error, without anything read or
  // written out of bounds.
  const Points points = MakeSpherePoints(600);
  struct Changer
  {
    vtkDoubleArray* Normals;
    int Components;
    vtkIdType Tuples;
    void Observe(vtkObject* caller, unsigned long, void*)
    {
      if (vtkAlgorithm::SafeDownCast(caller)->GetProgress() >= 0.1)
      {
        this->Normals->SetNumberOfComponents(this->Components);
        this->Normals->SetNumberOfTuples(this->Tuples);
        this->Normals->Squeeze();
      }
    }
  };
  const std::string expected = "normals of the input were changed";
  for (const auto& [components, tuples] : std::vector<std::pair<int, vtkIdType>>{
         { 3, 0 }, { 3, 1 }, { 3, 599 }, { 3, 100000 }, { 1, 600 }, { 2, 600 }, { 3000, 600 } })
  {
    for (const bool estimates : { false, true })
    {
      const auto cloud = MakeCloud(points);
      vtkNew<vtkDoubleArray> normals;
      normals->SetNumberOfComponents(3);
      for (const auto& p : points)
      {
        normals->InsertNextTuple(p.data());
      }
      cloud->GetPointData()->SetNormals(normals);
      vtkNew<vtkPointCloudDGG> filter;
      filter->SetInputData(cloud);
      Changer changer{ normals, components, tuples };
      filter->AddObserver(vtkCommand::ProgressEvent, &changer, &Changer::Observe);
      if (!estimates)
      {
        ExpectError(filter, { expected });
        continue;
      }
      const Listener listener(filter);
      EXPECT_EQ(filter->EstimateMemory(), 0u);
      ASSERT_EQ(listener.Errors.size(), 1u);
      EXPECT_NE(listener.Errors[0].find(expected), std::string::npos) << listener.Errors[0];
    }
  }
}

TEST(PointCloudObservers, MayChangeProperties)
{
  // At any time: the graph is that of all properties before, or of all after.
  const auto cloud = MakeCloud(MakeSpherePoints(300));
  struct Changer
  {
    vtkPointCloudDGG* Filter;
    int Events;
    void Observe()
    {
      if (--this->Events == 0)
      {
        this->Filter->EstimateNormalsOff();
        this->Filter->SetAlpha(4.0);
      }
    }
  };
  const auto build = [&](int event) {
    vtkNew<vtkPointCloudDGG> filter;
    filter->SetInputData(cloud);
    filter->EstimateNormalsOn();
    Changer changer{ filter, event };
    if (event == 0)
    {
      filter->EstimateNormalsOff();
      filter->SetAlpha(4.0);
    }
    filter->AddObserver(vtkCommand::ProgressEvent, &changer, &Changer::Observe);
    ExpectSuccess(filter);
    return GetCloudBytes(filter->GetOutput());
  };
  const std::vector<std::string> before = build(-1);
  const std::vector<std::string> after = build(0);
  EXPECT_NE(before, after);
  for (int event = 1; event <= 6; ++event)
  {
    const std::vector<std::string> bytes = build(event);
    EXPECT_TRUE(bytes == before || bytes == after) << event;
  }
}
}
