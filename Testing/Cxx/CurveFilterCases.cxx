// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceFilterCases.h"

#include "vtkApolloniusIsolines.h"
#include "vtkDGGLoop.h"
#include "vtkDGGPath.h"
#include "vtkGeodesicPatchBoundaries.h"
#include "vtkGeodesicSampler.h"
#include "vtkGeodesicVoronoi.h"
#include "vtkPoissonVectorGraphics.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStringArray.h"

#include <algorithm>

namespace dggtest
{
namespace
{
template <typename Filter>
vtkSmartPointer<Filter> MakeFilter(vtkPolyData* surface)
{
  auto filter = vtkSmartPointer<Filter>::New();
  filter->SetInputData(surface);
  return filter;
}

vtkSmartPointer<vtkGeodesicAlgorithm> MakePath(vtkPolyData* surface)
{
  auto path = MakeFilter<vtkDGGPath>(surface);
  path->SetAccuracy(0.05);
  path->AddPair(0, 70);
  path->AddPair(3, 41);
  return path;
}

vtkSmartPointer<vtkGeodesicAlgorithm> MakeLoop(vtkPolyData* surface)
{
  auto loop = MakeFilter<vtkDGGLoop>(surface);
  loop->SetAccuracy(0.05);
  loop->SetModeToRope();
  loop->SetPointIds({ 11, 15, 69, 65 });
  loop->SetTapeWidth(25.0);
  return loop;
}

vtkSmartPointer<vtkGeodesicAlgorithm> MakeSampler(vtkPolyData* surface)
{
  auto sampler = MakeFilter<vtkGeodesicSampler>(surface);
  sampler->SetAccuracy(0.05);
  sampler->SetNumberOfSamples(15);
  sampler->InFacesOn();
  return sampler;
}

vtkSmartPointer<vtkGeodesicAlgorithm> MakeGraphics(vtkPolyData* surface)
{
  vtkNew<vtkPoints> places;
  places->SetDataTypeToDouble();
  for (const vtkIdType id : { 11, 15, 69 })
  {
    double p[3] = { 0.0, 0.0, 0.0 };
    double q[3] = { 0.0, 0.0, 0.0 };
    if (id + 1 < surface->GetNumberOfPoints())
    {
      surface->GetPoint(id, p);
      surface->GetPoint(id + 1, q);
    }
    // On the edge between them.
    places->InsertNextPoint(
      (2.0 * p[0] + q[0]) / 3.0, (2.0 * p[1] + q[1]) / 3.0, (2.0 * p[2] + q[2]) / 3.0);
  }
  vtkNew<vtkPolyData> curves;
  curves->SetPoints(places);
  curves->SetLines(MakeCells({ { 0, 1, 2 } }));
  for (const char* name : { "LeftColor", "RightColor" })
  {
    vtkNew<vtkDoubleArray> colors;
    colors->SetName(name);
    colors->SetNumberOfComponents(3);
    colors->InsertNextTuple3(0.25, 0.5, name[0] == 'L' ? 1.0 : 0.0);
    curves->GetCellData()->AddArray(colors);
  }
  auto graphics = MakeFilter<vtkPoissonVectorGraphics>(surface);
  graphics->SetCurveData(curves);
  return graphics;
}

vtkSmartPointer<vtkGeodesicAlgorithm> MakeVoronoi(vtkPolyData* surface)
{
  auto voronoi = MakeFilter<vtkGeodesicVoronoi>(surface);
  voronoi->SetAccuracy(0.05);
  voronoi->SetSiteIds({ 10, 16, 64, 70 });
  voronoi->CentroidalOn();
  voronoi->SetNumberOfIterations(2);
  return voronoi;
}

/// Of the distances in space from the first point.
vtkSmartPointer<vtkGeodesicAlgorithm> MakeIsolines(vtkPolyData* surface)
{
  vtkNew<vtkDoubleArray> distances;
  distances->SetName("GeodesicDistance");
  double largest = 0.0;
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    distances->InsertNextValue(EuclideanDistance(surface, 0, i));
    largest = std::max(largest, distances->GetValue(i));
  }
  surface->GetPointData()->AddArray(distances);
  auto isolines = MakeFilter<vtkApolloniusIsolines>(surface);
  isolines->SetMethodToLinear();
  isolines->GenerateValues(4, 0.1 * largest, 0.9 * largest);
  return isolines;
}

vtkSmartPointer<vtkGeodesicAlgorithm> MakeBoundaries(vtkPolyData* surface)
{
  vtkNew<vtkPolyData> second;
  second->DeepCopy(surface);
  vtkNew<vtkPolyData> layout;
  layout->SetPolys(MakeCells({ { 0, 1, 2 }, { 0, 2, 3 } }));
  auto boundaries = MakeFilter<vtkGeodesicPatchBoundaries>(surface);
  boundaries->SetSecondSurfaceData(second);
  boundaries->SetFirstLandmarkIds({ 10, 16, 70, 64 });
  boundaries->SetSecondLandmarkIds({ 20, 24, 60, 56 });
  boundaries->SetLayoutData(layout);
  return boundaries;
}
}

void PrintTo(const SurfaceFilter& filter, std::ostream* os)
{
  *os << filter.Name;
}

vtkSmartPointer<vtkPolyData> MakeRelief(int dataType)
{
  auto surface = MakeGrid(8, 8);
  vtkNew<vtkPoints> points;
  points->SetDataType(dataType);
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double p[3];
    surface->GetPoint(i, p);
    points->InsertNextPoint(10.0 * p[0], 10.0 * p[1], static_cast<double>(i * i * 7 % 9));
  }
  surface->SetPoints(points);
  return surface;
}

void AddNote(vtkPolyData* surface, const char* name)
{
  vtkNew<vtkStringArray> note;
  note->SetName(name);
  note->InsertNextValue("kept");
  surface->GetFieldData()->AddArray(note);
}

const std::vector<SurfaceFilter>& GetSurfaceFilters()
{
  static const std::vector<const char*> curve{ "FaceId", "Barycentric", "vtkOriginalPointIds",
    "ArcLength" };
  static const std::vector<SurfaceFilter> filters{
    { "Path", MakePath, { 0 }, curve,
      { "Method: Graph", "NumberOfPairs: 0", "Straighten: On", "Detour: 0.0001",
        "ProjectionTolerance: 0.01", "NumberOfFallbacks: 0", "Accuracy: 0.01",
        "GraphAccuracy: 0" } },
    { "Loop", MakeLoop, { 0, 1 }, curve,
      { "Mode: ThroughPoint", "PointIds: (none)", "Taut: Off", "TapeWidth: 0",
        "ProjectionTolerance: 0.01", "Accuracy: 0.01", "GraphAccuracy: 0" } },
    { "Isolines", MakeIsolines, { 0 }, curve, {} },
    { "Sampler", MakeSampler, { 0 },
      { "FaceId", "Barycentric", "vtkOriginalPointIds", "CoveringRadius" },
      { "NumberOfSamples: 100", "FirstSample: -1", "CoveringRadius: 0", "InFaces: Off",
        "ProjectionTolerance: 0.01", "Accuracy: 0.01" } },
    { "Voronoi", MakeVoronoi, { 1, 2, 3 }, {},
      { "SiteIds: (none)", "Centroidal: Off", "NumberOfIterations: 20", "Tolerance: 0.001",
        "GenerateCells: On", "RefineBoundaries: On", "PassSiteArrays: Off", "UnreachedValue: nan",
        "DistanceArrayName: GeodesicDistance", "SourceArrayName: GeodesicSource",
        "ProjectionTolerance: 0.01", "Accuracy: 0.01" } },
    { "Graphics", MakeGraphics, { 0 }, { "Colors", "RGB" }, {} },
    { "PatchBoundaries", MakeBoundaries, { 0, 1 },
      { "FaceId", "Barycentric", "vtkOriginalPointIds", "ArcLength", "ArcFraction" },
      { "FirstLandmarkIds: (none)", "SecondLandmarkIds: (none)", "ProjectionTolerance: 0.01" } },
  };
  return filters;
}

const SurfaceFilter& GetSurfaceFilter(const std::string& name)
{
  return *std::find_if(GetSurfaceFilters().begin(), GetSurfaceFilters().end(),
    [&](const SurfaceFilter& filter) { return filter.Name == name; });
}
}
