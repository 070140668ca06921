// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FilterCases.h"

#include "vtkApolloniusIsolines.h"
#include "vtkDGGLoop.h"
#include "vtkDGGPath.h"
#include "vtkGeodesicPatchBoundaries.h"
#include "vtkGeodesicSampler.h"
#include "vtkGeodesicVoronoi.h"
#include "vtkPoissonVectorGraphics.h"

namespace dggtest
{
namespace
{
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

vtkSmartPointer<vtkGeodesicAlgorithm> MakePath(vtkPolyData* surface)
{
  auto path = MakeFilter<vtkDGGPath>(surface);
  path->SetAccuracy(0.05);
  path->AddPair(OnRelief(surface, 0), OnRelief(surface, 70));
  path->AddPair(OnRelief(surface, 3), OnRelief(surface, 41));
  return path;
}

vtkSmartPointer<vtkGeodesicAlgorithm> MakeLoop(vtkPolyData* surface)
{
  auto loop = MakeFilter<vtkDGGLoop>(surface);
  loop->SetAccuracy(0.05);
  loop->SetModeToRope();
  loop->SetPointIds(OnRelief(surface, { 11, 15, 69, 65 }));
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

void SetCurve(vtkPoissonVectorGraphics* graphics, vtkPolyData* points)
{
  vtkNew<vtkPolyData> curve;
  curve->ShallowCopy(points);
  Cells line(1);
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    line[0].push_back(i);
  }
  curve->SetLines(MakeCells(line));
  for (const char* name : { "LeftColor", "RightColor" })
  {
    vtkNew<vtkDoubleArray> colors;
    colors->SetName(name);
    colors->SetNumberOfComponents(3);
    colors->InsertNextTuple3(0.25, 0.5, name[0] == 'L' ? 1.0 : 0.0);
    curve->GetCellData()->AddArray(colors);
  }
  graphics->SetCurveData(curve);
}

vtkSmartPointer<vtkGeodesicAlgorithm> MakeGraphics(vtkPolyData* surface)
{
  vtkNew<vtkPoints> places;
  places->SetDataTypeToDouble();
  for (const vtkIdType id : OnRelief(surface, { 11, 15, 69 }))
  {
    double p[3] = { 0.0, 0.0, 0.0 };
    double q[3] = { 0.0, 0.0, 0.0 };
    if (id + 1 < surface->GetNumberOfPoints())
    {
      surface->GetPoint(id, p);
      surface->GetPoint(id + 1, q);
    }
    // Midpoint of the edge between the two points.
    places->InsertNextPoint(
      (2.0 * p[0] + q[0]) / 3.0, (2.0 * p[1] + q[1]) / 3.0, (2.0 * p[2] + q[2]) / 3.0);
  }
  vtkNew<vtkPolyData> points;
  points->SetPoints(places);
  auto graphics = MakeFilter<vtkPoissonVectorGraphics>(surface);
  SetCurve(graphics, points);
  return graphics;
}

vtkSmartPointer<vtkGeodesicAlgorithm> MakeVoronoi(vtkPolyData* surface)
{
  auto voronoi = MakeFilter<vtkGeodesicVoronoi>(surface);
  voronoi->SetAccuracy(0.05);
  voronoi->SetSiteIds(OnRelief(surface, { 10, 16, 64, 70 }));
  voronoi->CentroidalOn();
  voronoi->SetNumberOfIterations(2);
  return voronoi;
}

vtkSmartPointer<vtkGeodesicAlgorithm> MakeIsolines(vtkPolyData* surface)
{
  const double largest = AddSpaceDistances(surface);
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
  boundaries->SetFirstLandmarkIds(OnRelief(surface, { 10, 16, 70, 64 }));
  boundaries->SetSecondLandmarkIds(OnRelief(surface, { 20, 24, 60, 56 }));
  boundaries->SetLayoutData(layout);
  return boundaries;
}

std::vector<Refusal> RefusePath()
{
  using F = vtkDGGPath;
  const auto lines = [](const Cells& cells) {
    auto pairs = MakeSourcePoints({ { { 15.0, 15.0, 4.0 } }, { { 35.0, 15.0, 4.0 } } });
    pairs->SetLines(MakeCells(cells));
    return pairs;
  };
  return RefuseGraph<F>() +
    RefuseValues(&F::SetProjectionTolerance, { -1.0, NaN }, { "ProjectionTolerance" }) +
    RefuseValues(&F::SetDetour, { NaN }, { "Detour" }) +
    std::vector<Refusal>{
      Refuse<F>([](F* f) { f->RemoveAllPairs(); }, { "no pair", "Add pairs" }),
      Refuse<F>([](F* f) { f->AddPair(3, 81); }, { "id 81 ", "from 0 to 80" }),
      Refuse<F>([](F* f) { f->AddPair(-1, 3); }, { "id -1 " }),
      Refuse<F>([lines](F* f) { f->SetPairData(lines({})); }, { "port 1", "no lines" }),
      Refuse<F>(
        [lines](F* f) {
          f->SetPairData(lines({ { 0, 1 }, { 1, 7 } }));
        },
        { "line 1 of input port 1", "point 7" }),
      Refuse<F>(
        [lines](F* f) {
          f->SetPairData(lines({ { 0, 1 }, {} }));
        },
        { "line 1 of input port 1", "no points" }),
      Refuse<F>(
        [lines](F* f) {
          auto pairs = lines({});
          pairs->SetLines(MakeContradictoryCells());
          f->SetPairData(pairs);
        },
        { "cells of input port 1", "contradict" }),
    };
}

std::vector<Refusal> RefuseLoop()
{
  using F = vtkDGGLoop;
  return RefuseGraph<F>() +
    RefuseValues(&F::SetProjectionTolerance, { -1.0, NaN }, { "ProjectionTolerance" }) +
    RefuseValues(&F::SetTapeWidth, { -0.1, NaN, Infinity }, { "TapeWidth" }) +
    std::vector<Refusal>{
      Refuse<F>([](F* f) { f->SetPointIds({}); }, { "no loop point", "PointIds" }),
      Refuse<F>([](F* f) { f->AddPointId(81); }, { "id 81 ", "from 0 to 80" }),
      Refuse<F>([](F* f) { f->AddPointId(-1); }, { "id -1 " }),
    };
}

std::vector<Refusal> RefuseIsolines()
{
  using F = vtkApolloniusIsolines;
  return RefuseValues(&F::SetSteinerPoints, { -1, 51 }, { "SteinerPoints is", "50" }) +
    RefuseValues(&F::SetChordTolerance, { 0.0, 0.99e-6, NaN }, { "ChordTolerance", "1e-06" }) +
    RefuseValues(&F::SetDistanceArrayName, { "none" }, { "none" }) +
    std::vector<Refusal>{
      Refuse<F>([](F* f) { f->SetValue(2, NaN); }, { "value 2", "nan" }),
      Refuse<F>([](F* f) { f->SetValue(2, Infinity); }, { "value 2", "inf" }),
      Refuse<F>(
        [](F* f) {
          vtkNew<vtkDoubleArray> vectors;
          vectors->SetName("GeodesicDistance");
          vectors->SetNumberOfComponents(3);
          vectors->SetNumberOfTuples(81);
          vtkPolyData::SafeDownCast(f->GetInput())->GetPointData()->AddArray(vectors);
        },
        { "GeodesicDistance", "3 components" }),
    };
}

std::vector<Refusal> RefuseSampler()
{
  using F = vtkGeodesicSampler;
  return RefuseGraph<F>() +
    RefuseValues(&F::SetProjectionTolerance, { -1.0, NaN }, { "ProjectionTolerance" }) +
    RefuseValues(&F::SetNumberOfSamples, { 0 }, { "NumberOfSamples", "0" }) +
    RefuseValues(&F::SetCoveringRadius, { -1.0 }, { "CoveringRadius", "-1" }) +
    RefuseValues(&F::SetFirstSample, { 81 }, { "FirstSample 81", "80" }) +
    RefuseValues(&F::SetFirstSample, { -2 }, { "FirstSample -2" }) +
    std::vector<Refusal>{
      Refuse<F>([](F* f) { f->SetStartData(MakeSourcePoints({})); }, { "no start", "port 1" }),
    };
}

std::vector<Refusal> RefuseVoronoi()
{
  using F = vtkGeodesicVoronoi;
  return RefuseGraph<F>() +
    RefuseValues(&F::SetProjectionTolerance, { -1.0, NaN }, { "ProjectionTolerance" }) +
    RefuseValues(&F::SetTolerance, { -1.0 }, { "Tolerance" }) +
    RefuseValues(&F::SetNumberOfIterations, { -1 }, { "NumberOfIterations" }) +
    RefuseValues(&F::SetDistanceArrayName, { "" }, { "DistanceArrayName" }) +
    RefuseValues(&F::SetDistanceArrayName, { "GeodesicSource" }, { "SourceArrayName" }) +
    std::vector<Refusal>{
      Refuse<F>([](F* f) { f->RemoveAllSites(); }, { "no site", "SiteIds" }),
      Refuse<F>(
        [](F* f) {
          f->SetSiteIds({ 3, 81 });
        },
        { "site id 81", "80" }),
    };
}

std::vector<Refusal> RefuseGraphics()
{
  using F = vtkPoissonVectorGraphics;
  return RefuseValues(&F::SetProjectionTolerance, { -1.0, NaN }, { "ProjectionTolerance" }) +
    RefuseValues(&F::SetWidth, { -1.0, NaN }, { "Width" }) +
    RefuseValues(&F::SetResultArrayName, { "", "RGB", "Component" }, { "ResultArrayName" }) +
    std::vector<Refusal>{ RefuseMemoryLimit(1000),
      Refuse<F>(
        [](F* f) {
          vtkNew<vtkPolyData> broken;
          broken->SetPoints(vtkPolyData::SafeDownCast(f->GetInputDataObject(1, 0))->GetPoints());
          broken->SetLines(MakeContradictoryCells());
          f->SetCurveData(broken);
        },
        { "cells of input port 1", "contradict" }) };
}

std::vector<Refusal> RefuseBoundaries()
{
  using F = vtkGeodesicPatchBoundaries;
  const auto layout = [](const Cells& polygons, const Cells& lines, const auto& parts) {
    return Refuse<F>(
      [=](F* f) {
        vtkNew<vtkPolyData> data;
        data->SetPolys(MakeCells(polygons));
        data->SetLines(MakeCells(lines));
        f->SetLayoutData(data);
      },
      parts);
  };
  const auto second = [](vtkPolyData* surface, const char* part) {
    return Refuse<F>(
      [surface = vtkSmartPointer<vtkPolyData>(surface)](F* f) {
        f->SetSecondSurfaceData(surface);
        f->SetSecondLandmarkIds({ 99 }); // the surface is checked first
      },
      { "second surface: ", part });
  };
  using Parts = std::vector<std::string>;
  return RefuseValues(&F::SetProjectionTolerance, { -1.0 }, { "ProjectionTolerance" }) +
    std::vector<Refusal>{ Refuse<F>([](F* f) { f->SetSecondSurfaceData(nullptr); },
                            { "no second surface" }),
      second(MakeSurface({ { { 0, 0, 0 } } }, {}), "no polygons"),
      second(vtkNew<vtkPolyData>(), "no polygons"),
      second(MakeSurface({ { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, NaN, 0 } } }, { { 0, 1, 2 } }),
        "not finite"),
      Refuse<F>(
        [](F* f) { f->SetSecondLandmarkIds({ 1 }); }, { "4 landmarks", " 1 on the second" }),
      Refuse<F>(
        [](F* f) {
          f->SetSecondLandmarkIds({ 0, 8, 80, 81 });
        },
        { "second landmark id 81", "81" }),
      Refuse<F>([](F* f) { f->SetFirstLandmarkIds({}); }, { "no first landmark" }),
      Refuse<F>(
        [](F* f) {
          f->SetSecondLandmarkIds({ 20, 24, 60, 24 });
        },
        { "landmarks 1 and 3 of the second surface" }),
      Refuse<F>([](F* f) { f->SetLayoutData(nullptr); }, { "no layout" }),
      layout({}, {}, Parts{ "layout is empty" }),
      layout({ { 0, 1, 4 } }, {}, Parts{ "patch 0", "4" }),
      layout({}, { { 0, 1 }, { 1, 2, 1 } }, Parts{ "edge 2 of the layout" }),
      Refuse<F>(
        [](F* f) {
          vtkNew<vtkPolyData> broken;
          broken->SetPolys(MakeContradictoryCells());
          f->SetLayoutData(broken);
        },
        { "layout", "contradict" }),
      Refuse<F>(
        [](F* f) {
          vtkNew<vtkPolyData> broken;
          broken->SetLines(MakeContradictoryCells());
          f->SetLayoutData(broken);
        },
        { "layout", "contradict" }) };
}
}

std::vector<FilterCase> GetCurveFilters()
{
  const std::vector<const char*> curve{ "FaceId", "Barycentric", "vtkOriginalPointIds",
    "ArcLength" };
  return {
    { "Path", MakePath, PointSetter<vtkDGGPath>([](auto* path, vtkPolyData* points) {
       vtkNew<vtkPolyData> pairs;
       pairs->ShallowCopy(points);
       pairs->SetLines(MakeCells({ { 0, 1 }, { 2, 4 } }));
       path->RemoveAllPairs();
       path->SetPairData(pairs);
     }),
      { "Method: Graph", "NumberOfPairs: 0", "Straighten: On", "Detour: 0.0001",
        "ProjectionTolerance: 0.01", "NumberOfFallbacks: 0", "Accuracy: 0.01", "GraphAccuracy: 0" },
      RefusePath(), { 0 }, curve },
    { "Loop", MakeLoop, PointSetter<vtkDGGLoop>([](auto* loop, vtkPolyData* points) {
       loop->RemoveAllPointIds();
       loop->SetPointData(points);
     }),
      { "Mode: ThroughPoint", "PointIds: (none)", "Taut: Off", "TapeWidth: 0",
        "ProjectionTolerance: 0.01", "Accuracy: 0.01", "GraphAccuracy: 0" },
      RefuseLoop(), { 0, 1 }, curve },
    { "Isolines", MakeIsolines, nullptr,
      { "Method: LocalSources", "ChordTolerance: 0.001", "SteinerPoints: 2",
        "ContourValues:", "NumberOfFallbacks: 0", "DistanceArrayName: GeodesicDistance" },
      RefuseIsolines(), { 0 }, curve },
    { "Sampler", MakeSampler,
      PointSetter<vtkGeodesicSampler>(
        [](auto* sampler, vtkPolyData* points) { sampler->SetStartData(points); }),
      { "NumberOfSamples: 100", "FirstSample: -1", "CoveringRadius: 0", "InFaces: Off",
        "ProjectionTolerance: 0.01", "Accuracy: 0.01" },
      RefuseSampler(), { 0 },
      { "FaceId", "Barycentric", "vtkOriginalPointIds", "CoveringRadius" } },
    { "Voronoi", MakeVoronoi,
      PointSetter<vtkGeodesicVoronoi>([](auto* voronoi, vtkPolyData* points) {
        voronoi->RemoveAllSites();
        voronoi->SetSiteData(points);
      }),
      { "SiteIds: (none)", "Centroidal: Off", "NumberOfIterations: 20", "Tolerance: 0.001",
        "GenerateCells: On", "RefineBoundaries: On", "PassSiteArrays: Off", "UnreachedValue: nan",
        "DistanceArrayName: GeodesicDistance", "SourceArrayName: GeodesicSource",
        "ProjectionTolerance: 0.01", "Accuracy: 0.01" },
      RefuseVoronoi(), { 1, 2, 3 } },
    { "Graphics", MakeGraphics, PointSetter<vtkPoissonVectorGraphics>(SetCurve),
      { "Width: 0", "RefinementRegion: Everywhere", "RefinementLevel: 1" }, RefuseGraphics(), { 0 },
      { "Colors", "RGB" } },
    { "PatchBoundaries", MakeBoundaries,
      PointSetter<vtkGeodesicPatchBoundaries>([](auto* boundaries, vtkPolyData* points) {
        boundaries->SetSecondSurfaceData(vtkPolyData::SafeDownCast(boundaries->GetInput()));
        boundaries->SetFirstLandmarkIds({});
        boundaries->SetSecondLandmarkIds({});
        boundaries->SetFirstLandmarkData(points);
        boundaries->SetSecondLandmarkData(points);
      }),
      { "FirstLandmarkIds: (none)", "SecondLandmarkIds: (none)", "ProjectionTolerance: 0.01" },
      RefuseBoundaries(), { 0, 1 },
      { "FaceId", "Barycentric", "vtkOriginalPointIds", "ArcLength", "ArcFraction" } },
  };
}
}
