// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Images of samples and of Voronoi cells, compared with verified baselines.
#include "ImageScene.h"
#include "SpectralTestTools.h"

#include "vtkGeodesicSampler.h"
#include "vtkGeodesicVoronoi.h"

#include "vtkActor.h"
#include "vtkProperty.h"

using namespace dggtest;

namespace
{
/// Adds cells, their borders and their sites.
void AddCells(ImageScene& scene, vtkGeodesicVoronoi* filter, double size)
{
  const auto count = static_cast<int>(filter->GetSites()->GetNumberOfPoints());
  scene.AddSurface(filter->GetCells(), "SiteId", NumberColors(count));
  scene.AddLines(filter->GetBoundaries(), 0.4 * size, Ink);
  scene.AddPoints(filter->GetSites(), size, Red);
}
}

/// Samples in the order of selection: at points of a fine mesh, and inside large faces.
TEST(ImageSites, Samples)
{
  ImageScene scene(2, 1, 240, 200);
  for (const bool isInFaces : { false, true })
  {
    auto terrain = MakeTerrain(isInFaces ? 7 : 40);
    vtkNew<vtkGeodesicSampler> sampler;
    sampler->SetInputData(terrain);
    sampler->SetNumberOfSamples(60);
    sampler->SetFirstSample(isInFaces ? 22 : 500);
    sampler->SetInFaces(isInFaces);
    ExpectSuccess(sampler);
    scene.AddPanel(TerrainView);
    scene.AddSurface(terrain)->GetProperty()->SetEdgeVisibility(isInFaces);
    scene.AddPoints(sampler->GetOutput(), 0.022, "CoveringRadius", FieldColors(0.09, 0.4));
  }
  scene.ExpectBaseline("TestImageSampler");
}

TEST(ImageSites, VoronoiCells)
{
  constexpr int count = 24;
  auto pebble = MakePebble(3);
  vtkNew<vtkGeodesicSampler> sampler;
  sampler->SetInputData(pebble);
  sampler->SetNumberOfSamples(count);
  sampler->InFacesOn();
  vtkNew<vtkGeodesicVoronoi> voronoi;
  voronoi->SetInputData(pebble);
  voronoi->SetSiteConnection(sampler->GetOutputPort());
  ExpectSuccess(voronoi);
  // Euler's formula for a closed surface without handles on which three cells meet at each corner.
  std::set<std::pair<double, double>> pairs;
  vtkDataArray* sites = voronoi->GetBoundaries()->GetCellData()->GetArray("SiteId");
  for (vtkIdType i = 0; i < sites->GetNumberOfTuples(); ++i)
  {
    pairs.emplace(sites->GetComponent(i, 0), sites->GetComponent(i, 1));
  }
  EXPECT_EQ(voronoi->GetBoundaries()->GetNumberOfLines(), 3 * count - 6);
  EXPECT_GE(pairs.size(), 3u * count - 8u);
  EXPECT_GT(voronoi->GetCells()->GetNumberOfCells(), 1500);

  ImageScene scene;
  scene.AddPanel(PebbleView);
  AddCells(scene, voronoi, 0.035);
  scene.ExpectBaseline("TestImageVoronoi");
}

/// Sites in a corner, before and after they have been moved to the centers of their cells.
TEST(ImageSites, CentroidalVoronoiCells)
{
  constexpr int side = 40;
  ImageScene scene(2, 1, 240, 200);
  vtkNew<vtkGeodesicVoronoi> voronoi;
  voronoi->SetInputData(MakeTerrain(side));
  for (int i = 0; i < 20; ++i)
  {
    voronoi->AddSiteId((3 + 5 * (i % 5)) * side + 4 + 6 * (i / 5) + i % 3);
  }
  for (const bool isCentroidal : { false, true })
  {
    voronoi->SetCentroidal(isCentroidal);
    ExpectSuccess(voronoi);
    scene.AddPanel(TerrainView);
    AddCells(scene, voronoi, 0.016);
  }
  scene.ExpectBaseline("TestImageCentroidal");
}
