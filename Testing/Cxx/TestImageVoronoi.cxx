// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Voronoi cells, their borders and their sites on a surface without symmetry: compared with a
/// picture that was looked at.
#include "FilterTestTools.h"
#include "StrictImageComparison.h"

#include "vtkGeodesicSampler.h"
#include "vtkGeodesicVoronoi.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkGlyph3D.h"
#include "vtkIdList.h"
#include "vtkLookupTable.h"
#include "vtkPLYReader.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <set>
#include <string>
#include <utility>

using namespace dggtest;

namespace
{
constexpr int NumberOfSites = 24;

void AddCells(vtkRenderer* renderer, vtkGeodesicVoronoi* filter)
{
  vtkNew<vtkLookupTable> colours;
  colours->SetNumberOfTableValues(NumberOfSites);
  colours->SetTableRange(0, NumberOfSites - 1);
  for (int i = 0; i < NumberOfSites; ++i)
  {
    colours->SetTableValue(i, 0.35 + 0.13 * (i % 5), 0.4 + 0.18 * (i % 4), 0.5 + 0.25 * (i % 3));
  }
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(filter->GetCellsPort());
  mapper->SetScalarModeToUseCellFieldData();
  mapper->SelectColorArray("SiteId");
  mapper->SetLookupTable(colours);
  mapper->UseLookupTableScalarRangeOn();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetInterpolationToFlat();
  renderer->AddActor(actor);
}

void AddBoundaries(vtkRenderer* renderer, vtkGeodesicVoronoi* filter)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(filter->GetBoundariesPort());
  mapper->ScalarVisibilityOff();
  mapper->SetResolveCoincidentTopologyToPolygonOffset();
  mapper->SetRelativeCoincidentTopologyLineOffsetParameters(-2.0, -60.0);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.0, 0.0, 0.0);
  actor->GetProperty()->SetLineWidth(2.0f);
  actor->GetProperty()->LightingOff();
  renderer->AddActor(actor);
}

void AddSites(vtkRenderer* renderer, vtkGeodesicVoronoi* filter)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(0.035);
  vtkNew<vtkGlyph3D> glyphs;
  glyphs->SetInputConnection(filter->GetSitesPort());
  glyphs->SetSourceConnection(sphere->GetOutputPort());
  glyphs->ScalingOff();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(glyphs->GetOutputPort());
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.8, 0.1, 0.1);
  renderer->AddActor(actor);
}
}

TEST(ImageVoronoi, CellsBordersAndSites)
{
  ASSERT_NE(std::getenv("DISPLAY"), nullptr) << "pictures need an X display, as of xvfb-run";

  vtkNew<vtkPLYReader> reader;
  reader->SetFileName((std::string(DGG_TEST_DATA) + "/bumpy.ply").c_str());
  vtkNew<vtkGeodesicSampler> sampler;
  sampler->SetInputConnection(reader->GetOutputPort());
  sampler->SetNumberOfSamples(NumberOfSites);
  sampler->InFacesOn();
  vtkNew<vtkGeodesicVoronoi> voronoi;
  voronoi->SetInputConnection(reader->GetOutputPort());
  voronoi->SetSiteConnection(sampler->GetOutputPort());
  ExpectSuccess(voronoi);

  // A closed surface without handles on which three cells meet at a time: Euler's formula.
  std::set<std::pair<double, double>> pairs;
  vtkDataArray* sites = voronoi->GetBoundaries()->GetCellData()->GetArray("SiteId");
  for (vtkIdType i = 0; i < sites->GetNumberOfTuples(); ++i)
  {
    pairs.emplace(sites->GetComponent(i, 0), sites->GetComponent(i, 1));
  }
  EXPECT_EQ(voronoi->GetBoundaries()->GetNumberOfLines(), 3 * NumberOfSites - 6);
  EXPECT_GE(pairs.size(), 3u * NumberOfSites - 8u);
  EXPECT_GT(voronoi->GetCells()->GetNumberOfCells(), 1500);

  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1.0, 1.0, 1.0);
  AddCells(renderer, voronoi);
  AddBoundaries(renderer, voronoi);
  AddSites(renderer, voronoi);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetPosition(2.0, -4.5, 3.1);
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->SetViewAngle(27.0);
  renderer->ResetCameraClippingRange();

  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(300, 240);
  window->AddRenderer(renderer);
  window->Render();
  ExpectBaseline(window, "TestImageVoronoi");
}
