// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A surface without symmetry, coloured by distance, with isolines and two sources: compared with a
/// picture that was looked at.
#include "FilterTestTools.h"
#include "StrictImageComparison.h"

#include "vtkExactGeodesicDistance.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkContourFilter.h"
#include "vtkDoubleArray.h"
#include "vtkLookupTable.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

using namespace dggtest;

namespace
{
constexpr double Step = 0.06;
constexpr double Longest = 20 * Step;

/// The terrain with a cut that parts one corner from the rest, which stays without a distance.
vtkSmartPointer<vtkPolyData> MakeCutTerrain()
{
  auto terrain = MakeTerrain(60);
  Cells cells;
  for (vtkIdType c = 0; c < terrain->GetNumberOfCells(); ++c)
  {
    vtkIdType n;
    const vtkIdType* ids;
    terrain->GetPolys()->GetCellAtId(c, n, ids);
    const vtkIdType sum = ids[0] % 60 + 2 * (ids[0] / 60);
    if (sum < 148 || sum > 151)
    {
      cells.emplace_back(ids, ids + n);
    }
  }
  terrain->SetPolys(MakeCells(cells));
  return terrain;
}

/// One source by id and one inside a face that starts later.
void Prepare(vtkExactGeodesicDistance* filter)
{
  filter->SetInputData(MakeCutTerrain());
  filter->AddSourceId(60 * 12 + 9);
  auto sources = MakeSourcePoints({ { { 0.71, 0.84, 0.0 } } });
  vtkNew<vtkDoubleArray> start;
  start->SetName("InitialDistance");
  start->InsertNextValue(0.25);
  sources->GetPointData()->AddArray(start);
  filter->SetSourceData(sources);
  filter->SetProjectionTolerance(0.2); // the point is dropped onto the sheet
}

void AddSurface(vtkRenderer* renderer, vtkExactGeodesicDistance* filter)
{
  vtkNew<vtkLookupTable> colours;
  colours->SetHueRange(0.03, 0.68);
  colours->SetTableRange(0.0, Longest);
  colours->SetNanColor(0.55, 0.55, 0.55, 1.0);
  colours->Build();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(filter->GetOutputPort());
  mapper->SetLookupTable(colours);
  mapper->UseLookupTableScalarRangeOn();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetInterpolationToFlat();
  renderer->AddActor(actor);
}

void AddIsolines(vtkRenderer* renderer, vtkExactGeodesicDistance* filter)
{
  vtkNew<vtkContourFilter> contour;
  contour->SetInputConnection(filter->GetOutputPort());
  contour->GenerateValues(20, Step, Longest);
  contour->Update();
  // The lines are where they say: every point has one of the values.
  vtkDataArray* values = contour->GetOutput()->GetPointData()->GetArray("GeodesicDistance");
  ASSERT_NE(values, nullptr);
  ASSERT_GT(values->GetNumberOfTuples(), 300);
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    const double steps = values->GetComponent(i, 0) / Step;
    ASSERT_NEAR(steps, std::round(steps), 1e-9);
  }
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(contour->GetOutputPort());
  mapper->ScalarVisibilityOff();
  mapper->SetResolveCoincidentTopologyToPolygonOffset();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.0, 0.0, 0.0);
  actor->GetProperty()->LightingOff();
  renderer->AddActor(actor);
}

void AddSource(vtkRenderer* renderer, vtkExactGeodesicDistance* filter)
{
  vtkNew<vtkSphereSource> sphere;
  double p[3];
  filter->GetOutput()->GetPoint(filter->GetSourceId(0), p);
  sphere->SetCenter(p);
  sphere->SetRadius(0.018);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  renderer->AddActor(actor);
}
}

TEST(ImageExactDistance, ColoursAndIsolines)
{
  ASSERT_NE(std::getenv("DISPLAY"), nullptr) << "pictures need an X display, as of xvfb-run";

  vtkNew<vtkExactGeodesicDistance> filter;
  Prepare(filter);
  ExpectSuccess(filter);
  const auto distances = GetDistances(filter);
  EXPECT_EQ(distances[60 * 12 + 9], 0.0);
  EXPECT_TRUE(std::isnan(distances.back()));
  const auto unreached =
    std::count_if(distances.begin(), distances.end(), [](double d) { return std::isnan(d); });
  EXPECT_GT(unreached, 100);
  EXPECT_LT(unreached, 600);
  double range[2];
  filter->GetOutput()->GetPointData()->GetScalars()->GetRange(range);
  EXPECT_EQ(range[0], 0.0);
  EXPECT_GT(range[1], 0.75 * Longest);
  EXPECT_LT(range[1], Longest);

  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1.0, 1.0, 1.0);
  AddSurface(renderer, filter);
  AddIsolines(renderer, filter);
  AddSource(renderer, filter);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetFocalPoint(0.54, 0.5, 0.03);
  camera->SetPosition(0.15, -0.9, 1.85);
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->SetViewAngle(27.0);
  renderer->ResetCameraClippingRange();

  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(300, 240);
  window->AddRenderer(renderer);
  window->Render();
  ExpectBaseline(window, "TestImageExactDistance");
}
