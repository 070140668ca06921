// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Table of filters on point clouds: vtkPointCloudDGG, the filters that search its graph, and fast
/// marching.
#include "FilterCases.h"

#include "vtkDGGDistance.h"
#include "vtkDGGFastMarchingDistance.h"
#include "vtkDGGPath.h"
#include "vtkGeodesicDistanceMatrix.h"
#include "vtkGeodesicSampler.h"
#include "vtkGeodesicVoronoi.h"
#include "vtkPointCloudDGG.h"

namespace dggtest
{
namespace
{
/// Turns a relief into a nearly flat point cloud.
void TakePoints(vtkPolyData* relief)
{
  relief->SetPolys(nullptr);
  MovePoints(relief, [&](double* p) { p[2] *= 0.05; });
}

vtkSmartPointer<vtkGeodesicAlgorithm> MakeCloudGraph(vtkPolyData* relief)
{
  TakePoints(relief);
  auto graph = MakeFilter<vtkPointCloudDGG>(relief);
  graph->EstimateNormalsOn();
  return graph;
}

/// Returns a filter whose input is the output of vtkPointCloudDGG on the points of a relief.
template <typename Filter>
vtkSmartPointer<Filter> MakeConsumer(vtkPolyData* relief)
{
  TakePoints(relief);
  vtkNew<vtkPointCloudDGG> graph;
  graph->SetInputData(relief);
  auto filter = vtkSmartPointer<Filter>::New();
  filter->SetInputConnection(graph->GetOutputPort());
  return filter;
}

/// Returns positions between points of a relief.
vtkSmartPointer<vtkPolyData> MakePositions(vtkPolyData* relief, const std::vector<vtkIdType>& ids)
{
  Points positions;
  for (const vtkIdType id : OnRelief(relief, ids))
  {
    positions.push_back({ { 0.0, 0.0, 0.0 } });
    if (id < relief->GetNumberOfPoints())
    {
      relief->GetPoint(id, positions.back().data());
      positions.back()[0] += 3.0;
    }
  }
  return MakeSourcePoints(positions);
}

vtkSmartPointer<vtkGeodesicAlgorithm> MakeDistance(vtkPolyData* relief)
{
  auto distance = MakeConsumer<vtkDGGDistance>(relief);
  distance->AddSourceId(OnRelief(relief, 40));
  distance->SetSourceData(MakePositions(relief, { 20 }));
  distance->GenerateNearestSourceOn();
  return distance;
}

vtkSmartPointer<vtkGeodesicAlgorithm> MakePath(vtkPolyData* relief)
{
  auto path = MakeConsumer<vtkDGGPath>(relief);
  path->AddPair(OnRelief(relief, 0), OnRelief(relief, 70));
  path->AddPair(OnRelief(relief, 3), OnRelief(relief, 41));
  return path;
}

vtkSmartPointer<vtkGeodesicAlgorithm> MakeMatrix(vtkPolyData* relief)
{
  auto matrix = MakeConsumer<vtkGeodesicDistanceMatrix>(relief);
  matrix->SetRowIds(OnRelief(relief, { 3, 40, 77 }));
  matrix->SetRowData(MakePositions(relief, { 11, 60 }));
  return matrix;
}

vtkSmartPointer<vtkGeodesicAlgorithm> MakeSampler(vtkPolyData* relief)
{
  auto sampler = MakeConsumer<vtkGeodesicSampler>(relief);
  sampler->SetNumberOfSamples(15);
  return sampler;
}

vtkSmartPointer<vtkGeodesicAlgorithm> MakeVoronoi(vtkPolyData* relief)
{
  auto voronoi = MakeConsumer<vtkGeodesicVoronoi>(relief);
  voronoi->SetSiteIds(OnRelief(relief, { 10, 16, 64, 70 }));
  voronoi->CentroidalOn();
  voronoi->SetNumberOfIterations(2);
  return voronoi;
}

vtkSmartPointer<vtkGeodesicAlgorithm> MakeMarching(vtkPolyData* relief)
{
  TakePoints(relief);
  auto marching = MakeFilter<vtkDGGFastMarchingDistance>(relief);
  marching->SetSourceIds(OnRelief(relief, { 40, 7 }));
  marching->GenerateNearestSourceOn();
  return marching;
}

std::vector<Refusal> RefuseCloudGraph()
{
  using F = vtkPointCloudDGG;
  const double nan = std::nan("");
  return RefuseValues(&F::SetOffsetInVoxels, { -1.0 }, { "OffsetInVoxels", "-1" }) +
    RefuseValues(&F::SetOffsetInVoxels, { nan }, { "OffsetInVoxels", "nan" }) +
    RefuseValues(&F::SetOffsetInVoxels, { 1000.5 }, { "OffsetInVoxels is 1000.5", "to 1000" }) +
    RefuseValues(&F::SetOffsetInVoxels, { 1e-300 }, { "OffsetInVoxels is 1e-300", "from 0.5" }) +
    RefuseValues(&F::SetResolution, { -5 }, { "Resolution", "-5" }) +
    RefuseValues(&F::SetResolution, { 2000000 }, { "esolution", "2000000" }) +
    RefuseValues(&F::SetAlpha, { -0.5 }, { "Alpha", "-0.5" }) +
    RefuseValues(&F::SetAlpha, { 2e6 }, { "Alpha is 2e+06", "to 1e6" }) +
    RefuseValues(&F::SetAlpha, { 1e-300 }, { "Alpha is 1e-300", "from 1e-3" }) +
    RefuseValues(&F::SetNumberOfNeighbors, { 2 }, { "NumberOfNeighbors", "2" }) +
    RefuseValues(&F::SetComponentArrayName, { nullptr }, { "ComponentArrayName is empty" }) +
    RefuseValues(&F::SetAccuracy, { -0.1, 1e-7, 0.6, nan }, { "ccuracy" }) +
    RefuseValues(&F::SetMemoryLimit, { 10000 }, { "limit" });
}

std::vector<Refusal> RefuseMarching()
{
  using F = vtkDGGFastMarchingDistance;
  const auto band = [](int resolution, vtkTypeInt64 limit, const std::vector<std::string>& parts) {
    return Refuse<F>(
      [=](F* f) {
        f->SetResolution(resolution);
        f->SetBandRadius(1000.0);
        f->SetMemoryLimit(limit);
      },
      parts);
  };
  return RefuseValues(&F::SetResolution, { -1, 524289 }, { "Resolution" }) +
    RefuseValues(&F::SetBandRadius, { -1.0, 0.2, 1001.0, std::nan("") }, { "BandRadius" }) +
    std::vector<Refusal>{ Refuse<F>([](F* f) { f->RemoveAllSources(); }, { "no source" }),
      Refuse<F>([](F* f) { f->AddSourceId(81); }, { "81", "out of range" }),
      Refuse<F>([](F* f) { f->GenerateVirtualSourceOn(); }, { "GenerateVirtualSource" }),
      band(524288, 1 << 24, { "band", "16 MiB", "smaller Resolution", "MemoryLimit" }),
      band(0, 1000, { "1000 bytes", "fewer points" }) };
}

}

std::vector<FilterCase> GetAllFilters()
{
  std::vector<FilterCase> all = {
    { "CloudGraph", MakeCloudGraph, nullptr,
      { "Scheme: C", "OffsetInVoxels: 0", "Resolution: 0", "Alpha: 0", "Accuracy: 0.001",
        "EstimateNormals: Off", "GenerateVertices: Off", "NumberOfNeighbors: 16",
        "ComponentArrayName: Component" },
      RefuseCloudGraph() },
    { "CloudDistance", MakeDistance,
      PointSetter<vtkDGGDistance>([](auto* f, vtkPolyData* points) { f->SetSourceData(points); }),
      {},
      { Refuse<vtkDGGDistance>([](auto* f) { f->GenerateVirtualSourceOn(); },
        { "point cloud", "Turn off GenerateVirtualSource" }) } },
    { "CloudPath", MakePath, nullptr, {},
      { Refuse<vtkDGGPath>([](auto* f) { f->SetMethodToExact(); },
        { "no exact path on a point cloud", "Set Method to Graph" }) } },
    { "CloudMatrix", MakeMatrix,
      PointSetter<vtkGeodesicDistanceMatrix>(
        [](auto* f, vtkPolyData* points) { f->SetRowData(points); }) },
    { "CloudSampler", MakeSampler,
      PointSetter<vtkGeodesicSampler>(
        [](auto* f, vtkPolyData* points) { f->SetStartData(points); }) },
    { "CloudVoronoi", MakeVoronoi,
      PointSetter<vtkGeodesicVoronoi>(
        [](auto* f, vtkPolyData* points) { f->SetSiteData(points); }) },
    { "CloudMarching", MakeMarching, nullptr, { "BandRadius: 0", "Resolution: 0" },
      RefuseMarching() },
  };
  for (FilterCase& filter : all)
  {
    filter.Refusals = filter.Refusals + RefuseInput();
    if (filter.SetPoints)
    {
      filter.Refusals = filter.Refusals + RefusePoints(filter, "away from the cloud");
    }
  }
  return all;
}
}
