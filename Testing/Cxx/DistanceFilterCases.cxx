// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Table of filters: distances from sources, graphs, matrices, probes.
#include "FilterCases.h"

#include "vtkDGGDistance.h"
#include "vtkDGGFastMarchingDistance.h"
#include "vtkDiscreteGeodesicGraph.h"
#include "vtkExactGeodesicDistance.h"
#include "vtkGeodesicDistanceMatrix.h"
#include "vtkGeodesicProbe.h"
#include "vtkHeatGeodesicDistance.h"
#include "vtkVirtualSourceGeodesicDistance.h"

namespace dggtest
{
namespace
{
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

template <typename Filter>
vtkSmartPointer<vtkGeodesicAlgorithm> MakeDistance(vtkPolyData* surface)
{
  auto distance = MakeFilter<Filter>(surface);
  distance->SetSourceIds(OnRelief(surface, { 40, 7 }));
  distance->GenerateNearestSourceOn();
  return distance;
}

const auto SetSources =
  PointSetter<vtkGeodesicDistanceAlgorithm>([](auto* distance, vtkPolyData* points) {
    distance->RemoveAllSources();
    distance->SetSourceData(points);
  });

vtkSmartPointer<vtkGeodesicAlgorithm> MakeGraphDistance(vtkPolyData* surface)
{
  auto distance = MakeDistance<vtkDGGDistance>(surface);
  vtkDGGDistance::SafeDownCast(distance)->SetAccuracy(0.05);
  return distance;
}

vtkSmartPointer<vtkGeodesicAlgorithm> MakeGraph(vtkPolyData* surface)
{
  auto graph = MakeFilter<vtkDiscreteGeodesicGraph>(surface);
  graph->SetAccuracy(0.05);
  graph->GenerateGraphLinesOn();
  return graph;
}

vtkSmartPointer<vtkGeodesicAlgorithm> MakeMatrix(vtkPolyData* surface)
{
  auto matrix = MakeFilter<vtkGeodesicDistanceMatrix>(surface);
  matrix->SetAccuracy(0.05);
  matrix->SetRowIds(OnRelief(surface, { 3, 40, 77 }));
  matrix->SetColumnIds(OnRelief(surface, { 0, 8, 72, 80 }));
  return matrix;
}

/// Returns a probe of the straight-line distances from the first point.
vtkSmartPointer<vtkGeodesicAlgorithm> MakeProbe(vtkPolyData* surface)
{
  AddSpaceDistances(surface);
  Points places;
  for (const vtkIdType id : OnRelief(surface, { 11, 40, 69 }))
  {
    places.push_back({ { 0.0, 0.0, 0.0 } });
    if (id < surface->GetNumberOfPoints())
    {
      surface->GetPoint(id, places.back().data());
    }
  }
  auto probe = MakeFilter<vtkGeodesicProbe>(surface);
  probe->SetProbeData(MakeSourcePoints(places));
  return probe;
}

void SetInitialDistances(vtkGeodesicDistanceAlgorithm* filter, vtkAbstractArray* array)
{
  array->SetName("InitialDistance");
  auto sources = MakeSourcePoints({ { { 15.0, 15.0, 4.0 } }, { { 35.0, 15.0, 4.0 } } });
  sources->GetPointData()->AddArray(array);
  filter->SetSourceData(sources);
}

std::vector<Refusal> RefuseDistance()
{
  using F = vtkGeodesicDistanceAlgorithm;
  const auto initial = [](int tuples, int components, const char* part) {
    return Refuse<F>(
      [=](F* f) {
        vtkNew<vtkDoubleArray> values;
        values->SetNumberOfComponents(components);
        values->SetNumberOfTuples(tuples);
        values->Fill(0.0);
        SetInitialDistances(f, values);
      },
      { "'InitialDistance'", part });
  };
  return RefuseValues(&F::SetProjectionTolerance, { -1e-9, NaN }, { "ProjectionTolerance" }) +
    RefuseValues(&F::SetMaximumDistance, { -1.0, NaN }, { "MaximumDistance" }) +
    RefuseValues(&F::SetDistanceArrayName, { "" }, { "DistanceArrayName" }) +
    RefuseValues(&F::SetSourceArrayName, { nullptr }, { "SourceArrayName" }) +
    RefuseValues(
      &F::SetSourceArrayName, { "GeodesicDistance" }, { "'GeodesicDistance'", "SourceArrayName" }) +
    std::vector<Refusal>{ Refuse<F>([](F* f) { f->RemoveAllSources(); },
                            { "no source", "SourceIds", "port 1" }),
      Refuse<F>(
        [](F* f) {
          f->RemoveAllSources();
          f->SetSourceData(MakeSourcePoints({}));
        },
        { "no source", "port 1 has no points" }),
      Refuse<F>([](F* f) { f->AddSourceId(81); }, { "source id 81 ", "from 0 to 80" }),
      initial(3, 1, "3 tuples"), initial(2, 3, "3 components"),
      Refuse<F>(
        [](F* f) {
          vtkNew<vtkStringArray> words;
          words->SetNumberOfValues(2);
          SetInitialDistances(f, words);
        },
        { "'InitialDistance'", "of type string" }) };
}

std::vector<Refusal> RefuseHeat()
{
  using F = vtkHeatGeodesicDistance;
  return RefuseDistance() +
    RefuseValues(&F::SetTimeStepFactor, { 0.0, 0.99e-6, 1.01e6, Infinity, NaN },
      { "TimeStepFactor", "1e-06", "1e+06" }) +
    std::vector<Refusal>{
      RefuseMemoryLimit(1000),
      Refuse<F>(
        [](F* f) {
          f->SetBoundaryToDirichlet();
          f->SetSourceIds({ 0 });
        },
        { "boundary", "Neumann" }),
    };
}

std::vector<Refusal> RefuseGraphDistance()
{
  using F = vtkDGGDistance;
  const auto upperBound = [](const char* name) {
    return [name](F* f) {
      f->GenerateUpperBoundOn();
      f->SetUpperBoundArrayName(name);
    };
  };
  return RefuseDistance() + RefuseGraph<F>() +
    std::vector<Refusal>{
      Refuse<F>(upperBound(""), { "UpperBoundArrayName" }),
      Refuse<F>(upperBound("GeodesicDistance"), { "'GeodesicDistance'", "UpperBoundArrayName" }),
      Refuse<F>(
        [](F* f) {
          f->GenerateVirtualSourceOn();
          f->SetVirtualSourceArrayName(nullptr);
        },
        { "VirtualSourceArrayName" }),
    };
}

std::vector<Refusal> RefuseExact()
{
  using F = vtkExactGeodesicDistance;
  return RefuseDistance() +
    std::vector<Refusal>{ Refuse<F>(
      [](F* f) {
        f->GenerateWindowsOn();
        f->SetMemoryLimit(2000);
      },
      { "MemoryLimit", "2000", "MaximumDistance", "GenerateWindows" }) };
}

std::vector<Refusal> RefuseGraphOptions()
{
  using F = vtkDiscreteGeodesicGraph;
  return RefuseGraph<F>() +
    std::vector<Refusal>{
      Refuse<F>(
        [](F* f) {
          f->SetConstructionToSaddleVertexGraph();
          f->SetNumberOfNeighbors(0);
        },
        { "eighbo" }),
      Refuse<F>(
        [](F* f) {
          f->SetConstructionToSaddleVertexGraph();
          f->SetMemoryLimit(1000);
        },
        { "NumberOfNeighbors", "30" }),
    };
}

std::vector<Refusal> RefuseMatrix()
{
  using F = vtkGeodesicDistanceMatrix;
  const auto columns = [](const Points& points, const std::vector<std::string>& parts) {
    return Refuse<F>(
      [points](F* f) {
        f->SetColumnIds(nullptr);
        f->SetColumnData(MakeSourcePoints(points));
      },
      parts);
  };
  return RefuseGraph<F>() +
    RefuseValues(&F::SetMaximumDistance, { -1.0, NaN }, { "MaximumDistance" }) +
    std::vector<Refusal>{ Refuse<F>(
                            [](F* f) { f->SetRowIds(nullptr); }, { "no row", "RowIds", "port 1" }),
      Refuse<F>(
        [](F* f) {
          f->SetRowIds({ 0, 81 });
        },
        { "row id 81 ", "from 0 to 80" }),
      columns({}, { "no column", "port 2 has no points" }) } +
    RefuseValues(&F::SetProjectionTolerance, { -1.0 }, { "ProjectionTolerance" });
}

std::vector<Refusal> RefuseProbe()
{
  using F = vtkGeodesicProbe;
  return RefuseValues(&F::SetProjectionTolerance, { -1.0 }, { "ProjectionTolerance" }) +
    RefuseValues(&F::SetDistanceArrayName, { "nothing" }, { "'nothing'", "'GeodesicDistance'" }) +
    std::vector<Refusal>{ Refuse<F>(
                            [](F* f) { f->SetProbeData(nullptr); }, { "probe point", "port 1" }),
      Refuse<F>(
        [](F* f) {
          vtkPolyData::SafeDownCast(f->GetInput())
            ->GetPointData()
            ->GetArray("GeodesicDistance")
            ->SetComponent(0, 0, -Infinity);
        },
        { "point 0", "minus infinity" }) };
}
}

std::vector<FilterCase> GetDistanceFilters()
{
  const auto defaults = [](std::vector<const char*> own) {
    own.insert(own.end(),
      { "SourceIds: (none)", "ProjectionTolerance: 0.01", "MergeCoincidentPoints: Off",
        "UnreachedValue: nan", "GenerateNearestSource: Off", "PassSourceArrays: Off",
        "DistanceArrayName: GeodesicDistance", "SourceArrayName: GeodesicSource",
        "InitialDistanceArrayName: InitialDistance" });
    return own;
  };
  return {
    { "Exact", MakeDistance<vtkExactGeodesicDistance>, SetSources,
      defaults({ "Engine: Triangle", "GenerateWindows: Off" }), RefuseExact() },
    { "GraphDistance", MakeGraphDistance, SetSources,
      defaults({ "Accuracy: 0.01", "Correction: On", "Search: Certified", "AcceptCoarserGraph: Off",
        "GenerateUpperBound: Off", "GenerateVirtualSource: Off",
        "UpperBoundArrayName: GeodesicUpperBound", "VirtualSourceArrayName: GeodesicVirtualSource",
        "UsedInputGraph: no", "GraphAccuracy: 0", "NumberOfGraphEdges: 0" }),
      RefuseGraphDistance() },
    { "VirtualSource", MakeDistance<vtkVirtualSourceGeodesicDistance>, SetSources,
      defaults({ "Quality: Automatic" }), RefuseDistance() },
    { "Heat", MakeDistance<vtkHeatGeodesicDistance>, SetSources,
      defaults({ "TimeStepFactor: 1", "IntrinsicDelaunay: On", "Boundary: Neumann",
        "NumberOfFactorizations: 0" }),
      RefuseHeat() },
    { "FastMarching", MakeDistance<vtkDGGFastMarchingDistance>, SetSources,
      defaults({ "FrontShape: Spherical" }), RefuseDistance(), {}, {}, true },
    { "Graph", MakeGraph, nullptr,
      { "Accuracy: 0.01", "Construction: Guaranteed", "NumberOfNeighbors: 30",
        "GenerateGraphLines: Off", "MergeCoincidentPoints: Off", "MemoryLimit: 0",
        "NumberOfGraphEdges: 0" },
      RefuseGraphOptions() },
    { "Matrix", MakeMatrix,
      PointSetter<vtkGeodesicDistanceMatrix>([](auto* matrix, vtkPolyData* points) {
        matrix->SetRowIds(nullptr);
        matrix->SetColumnIds(nullptr);
        matrix->SetRowData(points);
        matrix->SetColumnData(points);
      }),
      { "NumberOfRowIds: 0", "NumberOfColumnIds: 0", "Accuracy: 0.01", "ProjectionTolerance: 0.01",
        "UnreachedValue: nan", "GenerateTable: On" },
      RefuseMatrix() },
    { "Probe", MakeProbe, PointSetter<vtkGeodesicProbe>([](auto* probe, vtkPolyData* points) {
       probe->SetProbeData(points);
     }),
      { "DistanceArrayName: GeodesicDistance", "ProjectionTolerance: 0.01" }, RefuseProbe() },
  };
}
}
