// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkPointCloudDGG: observers of its progress that change what it works with.
#include "CloudTestTools.h"
#include "GraphTestTools.h"

#include "vtkCommand.h"

#include <gtest/gtest.h>

#include <string>
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
