// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Paths from one point around a bump on a surface without symmetry, coloured by length: compared
/// with a picture that was looked at.
#include "PathTestTools.h"
#include "StrictImageComparison.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkLookupTable.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTubeFilter.h"

#include <gtest/gtest.h>

#include <cstdlib>

using namespace dggtest;

namespace
{
constexpr int Side = 60;
constexpr double Longest = 1.4;

vtkIdType PointAt(int i, int j)
{
  return j * Side + i;
}

/// From a corner of the map to places all around the bump, and one path between places in faces.
void Prepare(vtkDGGPath* filter)
{
  filter->SetInputData(MakeTerrain(Side));
  for (const auto& end : { std::array<int, 2>{ { 59, 2 } }, { { 57, 21 } }, { { 56, 33 } },
         { { 51, 48 } }, { { 30, 57 } }, { { 4, 41 } }, { { 40, 21 } } })
  {
    filter->AddPair(PointAt(3, 5), PointAt(end[0], end[1]));
  }
  filter->SetPairData(MakePairs({ { { 0.11, 0.93, 0.0 } }, { { 0.42, 0.63, 0.0 } } }));
  filter->SetProjectionTolerance(0.2); // the points are dropped onto the sheet
}

void AddSurface(vtkRenderer* renderer, vtkDGGPath* filter)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(filter->GetInputConnection(0, 0));
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.85, 0.85, 0.8);
  actor->GetProperty()->SetInterpolationToFlat();
  renderer->AddActor(actor);
}

void AddPaths(vtkRenderer* renderer, vtkDGGPath* filter)
{
  filter->GetOutput()->GetPointData()->SetActiveScalars("ArcLength");
  vtkNew<vtkTubeFilter> tube;
  tube->SetInputConnection(filter->GetOutputPort());
  tube->SetRadius(0.008);
  tube->SetNumberOfSides(8);
  vtkNew<vtkLookupTable> colours;
  colours->SetHueRange(0.03, 0.68);
  colours->SetTableRange(0.0, Longest);
  colours->Build();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(tube->GetOutputPort());
  mapper->SetLookupTable(colours);
  mapper->UseLookupTableScalarRangeOn();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  renderer->AddActor(actor);
}
}

TEST(ImagePath, AroundABump)
{
  ASSERT_NE(std::getenv("DISPLAY"), nullptr) << "pictures need an X display, as of xvfb-run";

  vtkNew<vtkDGGPath> filter;
  Prepare(filter);
  ExpectSuccess(filter);
  const auto paths = GetPaths(filter);
  ASSERT_EQ(paths.size(), 8u);
  vtkNew<vtkDGGPath> exact;
  Prepare(exact);
  exact->SetMethodToExact();
  ExpectSuccess(exact);
  const auto shortest = GetPaths(exact);
  ASSERT_EQ(shortest.size(), 8u);
  for (std::size_t i = 0; i < paths.size(); ++i)
  {
    ExpectOnSurface(paths[i], vtkPolyData::SafeDownCast(filter->GetInput()));
    EXPECT_NEAR(paths[i].Length, shortest[i].Length, 1e-6) << i;
    EXPECT_LT(paths[i].Length, Longest);
  }

  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1.0, 1.0, 1.0);
  AddSurface(renderer, filter);
  AddPaths(renderer, filter);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetFocalPoint(0.54, 0.5, 0.03);
  camera->SetPosition(0.15, -0.7, 2.0);
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->SetViewAngle(30.0);
  renderer->ResetCameraClippingRange();

  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(300, 240);
  window->AddRenderer(renderer);
  window->Render();
  ExpectBaseline(window, "TestImagePath");
}
