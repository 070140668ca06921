// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A torus with loops around its handle, a rope that keeps to its points and the tape along it:
/// compared with a picture that was looked at.
#include "LoopTestTools.h"
#include "StrictImageComparison.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTubeFilter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

using namespace dggtest;

namespace
{
constexpr int Nu = 36;
constexpr int Nv = 18;

/// Through places on the upper side, three near the hole and three far from it.
vtkSmartPointer<vtkPolyData> MakeStar()
{
  Points points;
  for (int k = 0; k < 6; ++k)
  {
    const double u = 0.2 + vtkMath::Pi() * k / 3.0;
    const double v = k % 2 == 0 ? 0.9 : 2.4;
    const double r = 1.0 + 0.4 * std::cos(v);
    points.push_back({ { r * std::cos(u), r * std::sin(u), 0.4 * std::sin(v) } });
  }
  return MakeSourcePoints(points);
}

vtkSmartPointer<vtkActor> AddActor(vtkRenderer* renderer, vtkAlgorithmOutput* output)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(output);
  mapper->ScalarVisibilityOff();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  renderer->AddActor(actor);
  return actor;
}

void AddTubes(
  vtkRenderer* renderer, vtkAlgorithmOutput* output, double radius, double r, double g, double b)
{
  vtkNew<vtkTubeFilter> tubes;
  tubes->SetInputConnection(output);
  tubes->SetRadius(radius);
  tubes->SetNumberOfSides(8);
  AddActor(renderer, tubes->GetOutputPort())->GetProperty()->SetColor(r, g, b);
}
}

TEST(ImageLoop, OnATorus)
{
  ASSERT_NE(std::getenv("DISPLAY"), nullptr) << "pictures need an X display, as of xvfb-run";

  auto torus = MakeTorus(Nu, Nv);
  vtkNew<vtkDGGLoop> handles;
  handles->SetInputData(torus);
  handles->SetModeToAroundHandles();
  ExpectSuccess(handles);
  EXPECT_EQ(GetLoops(handles).size(), 2u);
  vtkNew<vtkDGGLoop> rope;
  rope->SetInputData(torus);
  rope->SetModeToRope();
  rope->SetPointData(MakeStar());
  rope->SetTapeWidth(0.2);
  ExpectSuccess(rope);
  const auto loops = GetLoops(rope);
  ASSERT_EQ(loops.size(), 1u);
  EXPECT_EQ(loops[0].Kinked, 1);
  ExpectOnSurface(loops[0].Line, torus);
  const auto rims = GetRims(rope);
  EXPECT_EQ(rims.size(), 2u);
  for (const LoopLine& rim : rims)
  {
    EXPECT_TRUE(rim.IsClosed);
    ExpectOnSurface(rim.Line, torus);
  }

  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1.0, 1.0, 1.0);
  auto surface = AddActor(renderer, rope->GetInputConnection(0, 0));
  surface->GetProperty()->SetColor(0.85, 0.85, 0.8);
  surface->GetProperty()->SetInterpolationToFlat();
  AddTubes(renderer, handles->GetOutputPort(), 0.02, 0.05, 0.3, 0.62);
  AddTubes(renderer, rope->GetOutputPort(), 0.02, 0.8, 0.05, 0.12);
  AddTubes(renderer, rope->GetTapePort(), 0.016, 0.95, 0.62, 0.1);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetFocalPoint(0.0, -0.05, 0.0);
  camera->SetPosition(0.6, -2.3, 4.4);
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->SetViewAngle(32.0);
  renderer->ResetCameraClippingRange();

  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(300, 240);
  window->AddRenderer(renderer);
  window->Render();
  ExpectBaseline(window, "TestImageLoop");
}
