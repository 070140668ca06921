// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Images of point clouds: components and normals, distances, a path, cells; compared with verified
/// baselines.
#include "CloudTestTools.h"
#include "ImageScene.h"
#include "PathTestTools.h"
#include "SpectralTestTools.h"

#include "vtkDGGDistance.h"
#include "vtkGeodesicSampler.h"
#include "vtkGeodesicVoronoi.h"

#include <random>

using namespace dggtest;

namespace
{
constexpr int Side = 36;

/// Returns a random point in the first triangle of each square of the terrain.
Points MakeTerrainPoints(int side)
{
  auto terrain = MakeTerrain(side + 1);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(0.0, 0.45);
  Points points;
  for (int j = 0; j < side; ++j)
  {
    for (int i = 0; i < side; ++i)
    {
      const double right = number(random);
      const double up = number(random);
      points.push_back(
        PointInCell(terrain, 2 * (j * side + i), { { 1.0 - right - up, right, up } }));
    }
  }
  return points;
}

vtkSmartPointer<vtkPolyData> MakeTerrainCloud()
{
  return MakeCloudWithGraph(MakeTerrainPoints(Side));
}
constexpr vtkIdType Source = Side * 7 + 6;
}

/// Two separate layers in the colors of their components, with normals.
TEST(ImageClouds, ComponentsAndNormals)
{
  vtkNew<vtkPointCloudDGG> graph;
  auto sheets = MakeTerrainPoints(15);
  Points part;
  for (const auto& p : sheets)
  {
    if (p[0] + p[1] < 0.9)
    {
      part.push_back({ { p[0] + 0.35, p[1] + 0.3, p[2] + 0.5 } });
    }
  }
  graph->SetInputData(MakeCloud(Join(sheets, part)));
  graph->EstimateNormalsOn();
  ExpectSuccess(graph);
  ImageScene scene;
  scene.AddPanel({ { { 0.0, -2.0, 1.9 } }, { { 0.64, 0.52, 0.27 } }, 28.0 });
  scene.AddPoints(graph->GetOutput(), 0.02, "Component", NumberColors(2));
  scene.AddArrows(graph->GetOutput(), "Normals", 0.09, Ink);
  scene.ExpectBaseline("TestImageCloud");
}

TEST(ImageClouds, DistanceAndPath)
{
  auto cloud = MakeTerrainCloud();
  vtkNew<vtkDGGDistance> distance;
  distance->SetInputData(cloud);
  distance->SetSourceIds({ Source });
  ExpectSuccess(distance);
  vtkNew<vtkDGGPath> path;
  path->SetInputData(cloud);
  path->AddPair(Source, Side * 17 + 33);
  path->AddPair(Source, Side * 34 + 30);
  ExpectSuccess(path);
  ImageScene distanceScene;
  distanceScene.AddPanel(TerrainView);
  distanceScene.AddPoints(distance->GetOutput(), 0.013, "GeodesicDistance", FieldColors(0.0, 1.4));
  distanceScene.AddPoints(cloud, { Source }, 0.024, Red);
  distanceScene.ExpectBaseline("TestImageCloudDistance");
  ImageScene pathScene;
  pathScene.AddPanel(TerrainView);
  pathScene.AddPoints(cloud, 0.009, { { 0.6, 0.6, 0.56 } });
  pathScene.AddLines(path->GetOutput(), 0.013, Red);
  pathScene.ExpectBaseline("TestImageCloudPath");
}

TEST(ImageClouds, Cells)
{
  auto cloud = MakeTerrainCloud();
  vtkNew<vtkGeodesicSampler> sampler;
  sampler->SetInputData(cloud);
  sampler->SetNumberOfSamples(18);
  vtkNew<vtkGeodesicVoronoi> voronoi;
  voronoi->SetInputData(cloud);
  voronoi->SetSiteConnection(sampler->GetOutputPort());
  voronoi->CentroidalOn();
  ExpectSuccess(voronoi);
  ImageScene scene;
  scene.AddPanel(TerrainView);
  scene.AddPoints(voronoi->GetOutput(), 0.013, "GeodesicSource", NumberColors(18));
  scene.AddPoints(voronoi->GetSites(), 0.024, Red);
  scene.ExpectBaseline("TestImageCloudCells");
}
