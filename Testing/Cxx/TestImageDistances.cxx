// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Images of distances: exact distances, errors of the other methods, the graph, a matrix, a probe;
/// compared with verified baselines.
#include "GraphTestTools.h"
#include "ImageScene.h"
#include "SpectralTestTools.h"

#include "vtkDGGDistance.h"
#include "vtkDGGFastMarchingDistance.h"
#include "vtkExactGeodesicDistance.h"
#include "vtkGeodesicDistanceMatrix.h"
#include "vtkGeodesicProbe.h"
#include "vtkHeatGeodesicDistance.h"
#include "vtkVirtualSourceGeodesicDistance.h"

#include "vtkActor.h"
#include "vtkLinearSubdivisionFilter.h"
#include "vtkProperty.h"

using namespace dggtest;

namespace
{
/// Returns the terrain with a cut that separates one corner, which is not reached.
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

/// Adds a panel with the relative errors of a filter on the terrain in percent, and isolines of the
/// distance.
void AddErrors(ImageScene& scene, vtkGeodesicDistanceAlgorithm* filter, double largest)
{
  constexpr vtkIdType source = 30 * 9 + 6;
  auto terrain = MakeTerrain(30);
  filter->SetInputData(terrain);
  filter->SetSourceIds({ source });
  ExpectSuccess(filter);
  const auto exact = GetExactDistances(terrain, { source });
  const auto distances = GetDistances(filter);
  std::vector<double> errors;
  for (std::size_t i = 0; i < distances.size(); ++i)
  {
    errors.push_back(exact[i] > 0.0 ? 100.0 * (distances[i] / exact[i] - 1.0) : 0.0);
  }
  AddArray(filter->GetOutput()->GetPointData(), "Error", errors);
  scene.AddPanel(TerrainView);
  scene.AddSurface(filter->GetOutput(), "Error", ErrorColors(largest));
  scene.AddContours(filter->GetOutput(), 0.003, filter->GetDistanceArrayName(), 0.1, 1.3, 13);
}
}

TEST(ImageDistances, Exact)
{
  // One source by id and one inside a face with an initial distance.
  vtkNew<vtkExactGeodesicDistance> filter;
  filter->SetInputData(MakeCutTerrain());
  filter->AddSourceId(60 * 12 + 9);
  auto sources = MakeSourcePoints({ { { 0.71, 0.84, 0.0 } } });
  AddArray(sources->GetPointData(), "InitialDistance", { 0.25 });
  filter->SetSourceData(sources);
  filter->SetProjectionTolerance(0.2); // the point is projected onto the surface
  ExpectSuccess(filter);
  ImageScene scene;
  scene.AddPanel(TerrainView);
  scene.AddSurface(filter->GetOutput(), "GeodesicDistance", FieldColors(0.0, 1.2));
  scene.AddContours(filter->GetOutput(), 0.0025, "GeodesicDistance", 0.06, 1.2, 20);
  scene.AddPoints(filter->GetOutput(), { 60 * 12 + 9 }, 0.018, Red);
  scene.ExpectBaseline("TestImageExactDistance");
}

TEST(ImageDistances, ErrorsOfTheHeatMethod)
{
  ImageScene scene(3, 1, 240, 200);
  for (const int boundary : { vtkHeatGeodesicDistance::Neumann, vtkHeatGeodesicDistance::Dirichlet,
         vtkHeatGeodesicDistance::Average })
  {
    vtkNew<vtkHeatGeodesicDistance> filter;
    filter->SetBoundary(boundary);
    AddErrors(scene, filter, 10.0);
  }
  scene.ExpectBaseline("TestImageHeatMethod");
}

TEST(ImageDistances, ErrorsOfFastMarching)
{
  ImageScene scene(2, 1, 240, 200);
  vtkNew<vtkDGGFastMarchingDistance> filter;
  AddErrors(scene, filter, 5.0);
  filter->SetFrontShapeToPlanar();
  AddErrors(scene, filter, 5.0);
  scene.ExpectBaseline("TestImageFastMarching");
}

TEST(ImageDistances, ErrorsOfVirtualSources)
{
  ImageScene scene(2, 1, 240, 200);
  vtkNew<vtkVirtualSourceGeodesicDistance> filter;
  filter->SetQualityToFast();
  AddErrors(scene, filter, 2.0);
  filter->SetQualityToHigh();
  AddErrors(scene, filter, 2.0);
  scene.ExpectBaseline("TestImageVirtualSources");
}

TEST(ImageDistances, ErrorsOfTheGraph)
{
  ImageScene scene(2, 1, 240, 200);
  vtkNew<vtkDGGDistance> filter;
  filter->SetAccuracy(0.1);
  filter->CorrectionOff();
  AddErrors(scene, filter, 4.0);
  filter->CorrectionOn();
  AddErrors(scene, filter, 4.0);
  scene.ExpectBaseline("TestImageGraphDistance");
}

/// Quads of two components and a third one that no source reaches; a maximum distance; the nearest
/// source.
TEST(ImageDistances, QuadsAndComponents)
{
  auto relief = MakeGrid(14, 11, GridCells::Quads);
  MovePoints(relief,
    [&](double* p) { p[2] = 0.8 * std::sin(0.5 * p[0]) + 0.6 * std::cos(0.3 * p[0] + p[1]); });
  auto small = MakeGrid(5, 8, GridCells::Quads);
  auto surface = Beside(Beside(relief, small, 16.0), small, 23.0);
  vtkNew<vtkExactGeodesicDistance> filter;
  filter->SetInputData(surface);
  const std::vector<vtkIdType> sources = { 32, 130, 185 };
  filter->SetSourceIds(sources);
  filter->SetMaximumDistance(9.0);
  filter->GenerateNearestSourceOn();
  ExpectSuccess(filter);

  ImageScene scene(1, 2, 360, 160);
  const Viewpoint view = { { { 11.0, -20.0, 27.0 } }, { { 14.0, 4.8, 0.0 } }, 22.0 };
  for (const bool isDistance : { true, false })
  {
    scene.AddPanel(view);
    auto* actor = isDistance
      ? scene.AddSurface(filter->GetOutput(), "GeodesicDistance", FieldColors(0.0, 9.0, 18))
      : scene.AddSurface(filter->GetOutput(), filter->GetSourceArrayName(), NumberColors(3));
    actor->GetProperty()->EdgeVisibilityOn();
    scene.AddPoints(surface, sources, 0.3, Red);
  }
  scene.ExpectBaseline("TestImageQuads");
}

/// The edges that leave three points, by two constructions.
TEST(ImageDistances, GraphEdges)
{
  const std::vector<vtkIdType> points = { 25 * 6 + 5, 25 * 9 + 17, 25 * 19 + 10 };
  ImageScene scene(2, 1, 280, 220);
  vtkNew<vtkDiscreteGeodesicGraph> graph;
  graph->SetInputData(MakeTerrain(25));
  graph->GenerateGraphLinesOn();
  graph->SetNumberOfNeighbors(60);
  for (const int construction :
    { vtkDiscreteGeodesicGraph::Guaranteed, vtkDiscreteGeodesicGraph::SaddleVertexGraph })
  {
    graph->SetConstruction(construction);
    graph->SetAccuracy(0.02);
    ExpectSuccess(graph);
    vtkPolyData* lines = graph->GetGraphLines();
    Cells chosen;
    for (vtkIdType i = 0; i < lines->GetNumberOfLines(); ++i)
    {
      vtkIdType n;
      const vtkIdType* ids;
      lines->GetLines()->GetCellAtId(i, n, ids);
      if (std::find_first_of(ids, ids + n, points.begin(), points.end()) != ids + n)
      {
        chosen.emplace_back(ids, ids + n);
      }
    }
    vtkNew<vtkPolyData> star;
    star->SetPoints(lines->GetPoints());
    star->SetLines(MakeCells(chosen));
    scene.AddPanel(TerrainView);
    auto* actor = scene.AddSurface(graph->GetOutput(), { { 0.75, 0.75, 0.72 } });
    actor->GetProperty()->SetRepresentationToWireframe(); // otherwise it would hide lines
    scene.AddLines(star, 0.004, Blue);
    scene.AddPoints(star, points, 0.02, Red);
  }
  scene.ExpectBaseline("TestImageGraphEdges");
}

/// Distances from the red points (rows, from below) to the blue points (columns, from the left).
TEST(ImageDistances, Matrix)
{
  constexpr int side = 41;
  constexpr int numberOfRows = 30;
  auto terrain = MakeTerrain(side);
  std::vector<vtkIdType> rows;
  std::vector<vtkIdType> columns;
  for (int i = 0; i < side; ++i)
  {
    columns.push_back(side * 14 + i);
  }
  for (int j = 0; j < numberOfRows; ++j)
  {
    rows.push_back(side * (j + 8) + 10 + j);
  }
  vtkNew<vtkGeodesicDistanceMatrix> filter;
  filter->SetInputData(terrain);
  filter->SetRowIds(rows);
  filter->SetColumnIds(columns);
  ExpectSuccess(filter);
  auto grid = MakeGrid(side, numberOfRows, GridCells::Quads, 1.0 / side);
  std::vector<double> values;
  for (int row = 0; row < numberOfRows; ++row)
  {
    for (int column = 0; column < side; ++column)
    {
      values.push_back(filter->GetMatrix()->GetComponent(row, column));
    }
  }
  AddArray(grid->GetCellData(), "Distance", values);

  ImageScene scene(2, 1, 240, 200);
  scene.AddPanel(TerrainView);
  scene.AddSurface(terrain);
  scene.AddPoints(terrain, columns, 0.012, Blue);
  scene.AddPoints(terrain, rows, 0.012, Red);
  scene.AddPanel({ { { 0.5, 0.369, 3.0 } }, { { 0.5, 0.37, 0.0 } }, 20.0 });
  scene.AddSurface(grid, "Distance", FieldColors(0.0, 0.8, 16));
  scene.ExpectBaseline("TestImageMatrix");
}

/// A distance that is known at few points: linear in triangles, and probed.
TEST(ImageDistances, Probe)
{
  constexpr int side = 6;
  constexpr vtkIdType source = side + 1;
  vtkNew<vtkExactGeodesicDistance> distance;
  distance->SetInputData(MakeTerrain(side));
  distance->SetSourceIds({ source });
  distance->GenerateWindowsOn();
  vtkNew<vtkLinearSubdivisionFilter> fine;
  fine->SetInputConnection(distance->GetOutputPort());
  fine->SetNumberOfSubdivisions(3);
  vtkNew<vtkGeodesicProbe> probe;
  probe->SetInputConnection(distance->GetOutputPort());
  probe->SetProbeConnection(fine->GetOutputPort());
  ExpectSuccess(probe);
  ImageScene scene(2, 1, 240, 200);
  for (vtkPolyData* surface : { fine->GetOutput(), probe->GetOutput() })
  {
    scene.AddPanel(TerrainView);
    scene.AddSurface(surface, "GeodesicDistance", FieldColors(0.0, 1.4));
    scene.AddContours(surface, 0.003, "GeodesicDistance", 0.07, 1.4, 20);
    scene.AddPoints(surface, { source }, 0.02, Red);
  }
  scene.ExpectBaseline("TestImageProbe");
}
