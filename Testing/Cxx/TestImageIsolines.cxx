// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Isolines by all methods, with ridges and bands, on a smooth surface with one source and on a
/// cube with three: compared with a picture that was looked at.
#include "FilterTestTools.h"
#include "StrictImageComparison.h"

#include "vtkApolloniusIsolines.h"
#include "vtkExactGeodesicDistance.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkLookupTable.h"
#include "vtkPLYReader.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <vector>

using namespace dggtest;

namespace
{
constexpr int NumberOfLines = 9;
constexpr int NumberOfColumns = 4;
const double CubePosition[3] = { 2.9, -2.4, 2.3 };
const double BumpyPosition[3] = { 3.0, -6.7, 4.6 };

void AddBands(vtkRenderer* renderer, vtkApolloniusIsolines* isolines)
{
  vtkNew<vtkLookupTable> colours;
  colours->SetNumberOfTableValues(NumberOfLines + 1);
  colours->SetTableRange(0, NumberOfLines);
  for (int i = 0; i <= NumberOfLines; ++i)
  {
    const double t = static_cast<double>(i) / NumberOfLines;
    colours->SetTableValue(i, 1.0 - 0.5 * t, 0.95 - 0.3 * t, 0.7 + 0.25 * t);
  }
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(isolines->GetBandPort());
  mapper->SetScalarModeToUseCellFieldData();
  mapper->SelectColorArray("Band");
  mapper->SetLookupTable(colours);
  mapper->UseLookupTableScalarRangeOn();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetInterpolationToFlat();
  actor->GetProperty()->SetAmbient(0.4);
  actor->GetProperty()->SetDiffuse(0.65);
  renderer->AddActor(actor);
}

void AddLines(vtkRenderer* renderer, vtkAlgorithmOutput* port, double red, float width)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(port);
  mapper->ScalarVisibilityOff();
  mapper->SetResolveCoincidentTopologyToPolygonOffset();
  mapper->SetRelativeCoincidentTopologyLineOffsetParameters(-2.0, -60.0);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(red, 0.0, 0.0);
  actor->GetProperty()->SetLineWidth(width);
  actor->GetProperty()->LightingOff();
  renderer->AddActor(actor);
}

/// A row of the picture: linear, Apollonius, virtual sources, windows.
void AddRow(vtkRenderWindow* window, vtkPolyData* surface, const std::vector<vtkIdType>& sources,
  const double position[3], const double centre[3], double bottom)
{
  for (int column = 0; column < NumberOfColumns; ++column)
  {
    vtkNew<vtkExactGeodesicDistance> distance;
    distance->SetInputData(surface);
    distance->SetSourceIds(sources);
    distance->GenerateVirtualSourceOn();
    distance->SetGenerateWindows(column == 3);
    distance->Update();
    const double farthest =
      distance->GetOutput()->GetPointData()->GetArray("GeodesicDistance")->GetRange()[1];
    vtkNew<vtkApolloniusIsolines> isolines;
    isolines->SetInputConnection(distance->GetOutputPort());
    isolines->GenerateValues(
      NumberOfLines, farthest / (NumberOfLines + 1), farthest - farthest / (NumberOfLines + 1));
    isolines->GenerateBandsOn();
    isolines->SetGenerateRidges(column > 0);
    if (column == 0)
    {
      isolines->SetMethodToLinear();
    }
    else if (column == 1)
    {
      isolines->SetMethodToApollonius();
    }
    ExpectSuccess(isolines);
    EXPECT_GE(isolines->GetOutput()->GetNumberOfLines(), NumberOfLines);
    EXPECT_EQ(isolines->GetUsedWindows(), column == 3);

    vtkNew<vtkRenderer> renderer;
    renderer->SetBackground(1.0, 1.0, 1.0);
    AddBands(renderer, isolines);
    AddLines(renderer, isolines->GetOutputPort(), 0.0, 1.0f);
    AddLines(renderer, isolines->GetRidgePort(), 0.85, 2.0f);
    vtkCamera* camera = renderer->GetActiveCamera();
    camera->SetFocalPoint(centre[0], centre[1], centre[2]);
    camera->SetPosition(centre[0] + position[0], centre[1] + position[1], centre[2] + position[2]);
    camera->SetViewUp(0.0, 0.0, 1.0);
    camera->SetViewAngle(25.0);
    renderer->ResetCameraClippingRange();
    const double width = 1.0 / NumberOfColumns;
    renderer->SetViewport(column * width, bottom, (column + 1) * width, bottom + 0.5);
    window->AddRenderer(renderer);
  }
}
}

TEST(ImageIsolines, AllMethodsSideBySide)
{
  ASSERT_NE(std::getenv("DISPLAY"), nullptr) << "pictures need an X display, as of xvfb-run";

  vtkNew<vtkPLYReader> reader;
  reader->SetFileName((std::string(DGG_TEST_DATA) + "/bumpy.ply").c_str());
  reader->Update();
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(800, 400);
  const double origin[3] = { 0.0, 0.0, 0.0 };
  const double middle[3] = { 0.5, 0.5, 0.5 };
  AddRow(window, reader->GetOutput(), { 17 }, BumpyPosition, origin, 0.5);
  AddRow(window, MakeCube(), { 1, 2, 4 }, CubePosition, middle, 0.0);
  window->Render();
  ExpectBaseline(window, "TestImageIsolines");
}
