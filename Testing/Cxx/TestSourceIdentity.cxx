// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Points of input ports that are identified by point arrays, in every filter with such a port.
#include "FilterTestTools.h"

#include "vtkBiharmonicDistance.h"
#include "vtkDGGDistance.h"
#include "vtkDGGFastMarchingDistance.h"
#include "vtkDGGLoop.h"
#include "vtkDGGPath.h"
#include "vtkDiscreteGreensFunction.h"
#include "vtkExactGeodesicDistance.h"
#include "vtkGeodesicDistanceMatrix.h"
#include "vtkGeodesicPatchBoundaries.h"
#include "vtkGeodesicProbe.h"
#include "vtkGeodesicSampler.h"
#include "vtkGeodesicVoronoi.h"
#include "vtkHarmonicBSpline.h"
#include "vtkHeatGeodesicDistance.h"
#include "vtkPoissonVectorGraphics.h"
#include "vtkSurfaceEarthMoversDistance.h"
#include "vtkVirtualSourceGeodesicDistance.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkTable.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

using namespace dggtest;

namespace
{
using Weights = std::array<double, 3>;

/// A point of a triangle of a surface.
struct Place
{
  vtkIdType Cell;
  Weights Coordinates;
};

/// Arrays that identify the points.
enum Naming
{
  ByPosition,
  ByPointId, ///< places are corners of triangles
  ByFace,    ///< whatever the position
  ByAllArrays
};

std::array<double, 3> GetPosition(vtkPolyData* surface, const Place& place)
{
  std::array<double, 3> position{};
  vtkCell* cell = surface->GetCell(place.Cell);
  for (int k = 0; k < 3; ++k)
  {
    double corner[3];
    surface->GetPoint(cell->GetPointId(k), corner);
    for (int i = 0; i < 3; ++i)
    {
      position[i] += place.Coordinates[k] * corner[i];
    }
  }
  return position;
}

vtkIdType GetPointId(vtkPolyData* surface, const Place& place)
{
  for (int k = 0; k < 3; ++k)
  {
    if (place.Coordinates[k] == 1.0)
    {
      return surface->GetCell(place.Cell)->GetPointId(k);
    }
  }
  return -1;
}

vtkSmartPointer<vtkPolyData> MakePoints(
  vtkPolyData* surface, const std::vector<Place>& places, Naming naming)
{
  Points positions;
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("vtkOriginalPointIds");
  vtkNew<vtkIdTypeArray> faces;
  faces->SetName("FaceId");
  vtkNew<vtkDoubleArray> coordinates;
  coordinates->SetName("Barycentric");
  coordinates->SetNumberOfComponents(3);
  for (const Place& place : places)
  {
    positions.push_back(GetPosition(surface, place));
    for (double& x : positions.back())
    {
      x += naming == ByFace ? 10.0 : 0.0; // positions do not count
    }
    ids->InsertNextValue(GetPointId(surface, place));
    faces->InsertNextValue(place.Cell);
    coordinates->InsertNextTuple(place.Coordinates.data());
  }
  auto points = MakeSourcePoints(positions);
  if (naming == ByPointId || naming == ByAllArrays)
  {
    points->GetPointData()->AddArray(ids);
  }
  if (naming == ByFace || naming == ByAllArrays)
  {
    points->GetPointData()->AddArray(faces);
    points->GetPointData()->AddArray(coordinates);
  }
  return points;
}

/// Makes points of some of the places of a test.
using PointMaker = std::function<vtkSmartPointer<vtkPolyData>(const std::vector<int>& which)>;

struct PortCase
{
  const char* Name;
  std::function<vtkSmartPointer<vtkAlgorithm>(vtkPolyData* surface, const PointMaker& points)> Make;
};

void PrintTo(const PortCase& port, std::ostream* os)
{
  *os << port.Name;
}

template <typename Filter>
vtkSmartPointer<vtkAlgorithm> MakeDistance(vtkPolyData* surface, const PointMaker& points)
{
  vtkNew<Filter> filter;
  filter->SetInputData(surface);
  filter->SetSourceData(points({ 0, 1 }));
  return filter.Get();
}

template <typename Filter>
vtkSmartPointer<vtkAlgorithm> MakeSpectral(vtkPolyData* surface, const PointMaker& points)
{
  vtkNew<Filter> filter;
  filter->SetInputData(surface);
  filter->SetSourceIds({ 0, surface->GetNumberOfPoints() - 1 }); // splines need one in each layer
  filter->SetSourceData(points({ 0, 1, 2 }));
  filter->SetEvaluationData(points({ 3, 4 }));
  return filter.Get();
}

vtkSmartPointer<vtkAlgorithm> MakePath(vtkPolyData* surface, const PointMaker& points)
{
  vtkNew<vtkDGGPath> filter;
  filter->SetInputData(surface);
  auto pairs = points({ 0, 1, 2, 4 });
  pairs->SetLines(MakeCells({ { 0, 1 }, { 2, 3 } }));
  filter->SetPairData(pairs);
  return filter.Get();
}

vtkSmartPointer<vtkAlgorithm> MakeLoop(vtkPolyData* surface, const PointMaker& points)
{
  vtkNew<vtkDGGLoop> filter;
  filter->SetInputData(surface);
  filter->SetModeToRope();
  filter->SetPointData(points({ 0, 1, 2, 3 }));
  return filter.Get();
}

vtkSmartPointer<vtkAlgorithm> MakeVoronoi(vtkPolyData* surface, const PointMaker& points)
{
  vtkNew<vtkGeodesicVoronoi> filter;
  filter->SetInputData(surface);
  filter->SetSiteData(points({ 0, 1, 2 }));
  return filter.Get();
}

vtkSmartPointer<vtkAlgorithm> MakeSampler(vtkPolyData* surface, const PointMaker& points)
{
  vtkNew<vtkGeodesicSampler> filter;
  filter->SetInputData(surface);
  filter->SetStartData(points({ 0, 1 }));
  filter->SetNumberOfSamples(6);
  return filter.Get();
}

vtkSmartPointer<vtkAlgorithm> MakeMatrix(vtkPolyData* surface, const PointMaker& points)
{
  vtkNew<vtkGeodesicDistanceMatrix> filter;
  filter->SetInputData(surface);
  filter->SetRowData(points({ 0, 1 }));
  filter->SetColumnData(points({ 2, 3, 4 }));
  return filter.Get();
}

vtkSmartPointer<vtkAlgorithm> MakeProbe(vtkPolyData* surface, const PointMaker& points)
{
  vtkNew<vtkExactGeodesicDistance> distance;
  distance->SetInputData(surface);
  distance->SetSourceIds({ 3, surface->GetNumberOfPoints() - 20 });
  const Listener listener(distance);
  distance->Update();
  vtkNew<vtkGeodesicProbe> filter;
  filter->SetInputData(distance->GetOutput());
  filter->SetProbeData(points({ 0, 1, 2, 3, 4 }));
  return filter.Get();
}

vtkSmartPointer<vtkAlgorithm> MakeBoundaries(vtkPolyData* surface, const PointMaker& points)
{
  vtkNew<vtkGeodesicPatchBoundaries> filter;
  filter->SetInputData(surface);
  filter->SetSecondSurfaceData(surface);
  filter->SetFirstLandmarkData(points({ 0, 1, 2, 3 }));
  filter->SetSecondLandmarkData(points({ 1, 2, 3, 0 }));
  vtkNew<vtkPolyData> layout;
  layout->SetPolys(MakeCells({ { 0, 1, 2 }, { 0, 2, 3 } }));
  filter->SetLayoutData(layout);
  return filter.Get();
}

vtkSmartPointer<vtkAlgorithm> MakeEarthMovers(vtkPolyData* surface, const PointMaker& points)
{
  vtkNew<vtkSurfaceEarthMoversDistance> filter;
  filter->SetInputData(surface);
  filter->SetFromData(points({ 0, 1 }));
  filter->SetToData(points({ 2, 3 }));
  return filter.Get();
}

vtkSmartPointer<vtkAlgorithm> MakeGraphics(vtkPolyData* surface, const PointMaker& points)
{
  vtkNew<vtkPoissonVectorGraphics> filter;
  filter->SetInputData(surface);
  auto curves = points({ 0, 1, 2 });
  curves->SetLines(MakeCells({ { 0, 1, 2 } }));
  for (const char* name : { "LeftColor", "RightColor" })
  {
    vtkNew<vtkDoubleArray> colors;
    colors->SetName(name);
    colors->SetNumberOfComponents(3);
    colors->InsertNextTuple3(0.2, 0.6, name[0] == 'L' ? 1.0 : 0.0);
    curves->GetCellData()->AddArray(colors);
  }
  filter->SetCurveData(curves);
  return filter.Get();
}

const std::vector<PortCase> Ports = {
  { "Exact", MakeDistance<vtkExactGeodesicDistance> },
  { "Graph", MakeDistance<vtkDGGDistance> },
  { "VirtualSources", MakeDistance<vtkVirtualSourceGeodesicDistance> },
  { "Heat", MakeDistance<vtkHeatGeodesicDistance> },
  { "FastMarching", MakeDistance<vtkDGGFastMarchingDistance> },
  { "Path", MakePath },
  { "Loop", MakeLoop },
  { "Voronoi", MakeVoronoi },
  { "Sampler", MakeSampler },
  { "Matrix", MakeMatrix },
  { "Probe", MakeProbe },
  { "PatchBoundaries", MakeBoundaries },
  { "Greens", MakeSpectral<vtkDiscreteGreensFunction> },
  { "Biharmonic", MakeSpectral<vtkBiharmonicDistance> },
  { "BSpline", MakeSpectral<vtkHarmonicBSpline> },
  { "EarthMovers", MakeEarthMovers },
  { "Graphics", MakeGraphics },
};

/// All numbers that a filter puts out, but for the arrays that identify points; FaceId on request.
std::vector<double> GetNumbers(vtkAlgorithm* filter, bool withFaces)
{
  const Listener listener(filter);
  filter->Update();
  EXPECT_EQ(filter->GetErrorCode(), 0u);
  EXPECT_EQ(listener.Errors, std::vector<std::string>());
  std::vector<double> numbers;
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    vtkDataObject* output = filter->GetOutputDataObject(port);
    for (int type : { vtkDataObject::POINT, vtkDataObject::CELL, vtkDataObject::ROW })
    {
      vtkFieldData* data = output->GetAttributesAsFieldData(type);
      for (int a = 0; data && a < data->GetNumberOfArrays(); ++a)
      {
        const std::string name = data->GetArrayName(a);
        vtkDataArray* array = data->GetArray(a);
        const bool isIdentity = (name == "FaceId" && !withFaces) || name == "Barycentric" ||
          name == "vtkOriginalPointIds";
        for (vtkIdType i = 0; array && !isIdentity && i < array->GetNumberOfTuples(); ++i)
        {
          for (int c = 0; c < array->GetNumberOfComponents(); ++c)
          {
            numbers.push_back(array->GetComponent(i, c));
          }
        }
      }
    }
  }
  return numbers;
}

std::vector<double> RunPort(const PortCase& port, vtkPolyData* surface,
  const std::vector<Place>& places, Naming naming, bool withFaces = false)
{
  const PointMaker make = [&](const std::vector<int>& which) {
    std::vector<Place> some;
    for (const int i : which)
    {
      some.push_back(places[i]);
    }
    return MakePoints(surface, some, naming);
  };
  return GetNumbers(port.Make(surface, make), withFaces);
}

bool AreSame(const std::vector<double>& a, const std::vector<double>& b, double tolerance)
{
  return a.size() == b.size() &&
    std::equal(a.begin(), a.end(), b.begin(), [tolerance](double x, double y) {
      return x == y || (std::isnan(x) && std::isnan(y)) || std::abs(x - y) <= tolerance;
    });
}

/// Four places around the middle of a terrain of 9 x 9 points, and one in the middle; the cells of
/// a second layer begin at `firstCell`.
std::vector<Place> MakePlaces(
  vtkPolyData* terrain, const Weights& coordinates, vtkIdType firstCell = 0)
{
  std::vector<Place> places;
  for (const vtkIdType id : { 20, 24, 60, 56, 40 })
  {
    vtkIdType cell = 0;
    while (terrain->GetCell(cell)->GetPointId(0) != id)
    {
      ++cell;
    }
    places.push_back({ firstCell + cell, coordinates });
  }
  return places;
}

class SourceIdentity : public ::testing::TestWithParam<PortCase>
{
};
}

TEST_P(SourceIdentity, FacesNamePointsAsPositionsDo)
{
  const auto terrain = MakeTerrain(9);
  const std::vector<Place> places = MakePlaces(terrain, { { 0.5, 0.2, 0.3 } });
  const std::vector<double> expected = RunPort(this->GetParam(), terrain, places, ByPosition);
  ASSERT_FALSE(expected.empty());
  for (const Naming naming : { ByFace, ByAllArrays })
  {
    EXPECT_TRUE(AreSame(expected, RunPort(this->GetParam(), terrain, places, naming), 1e-9))
      << naming;
  }
}

TEST_P(SourceIdentity, CoincidentLayersAreDistinguished)
{
  const auto terrain = MakeTerrain(9);
  const auto twice = Beside(terrain, terrain, 0.0);
  // Other numbers of these filters do not depend on the layer.
  const std::string name = this->GetParam().Name;
  const bool withFaces =
    name == "Path" || name == "Loop" || name == "PatchBoundaries" || name == "Sampler";
  std::vector<double> expected[2];
  for (int layer = 0; layer < 2; ++layer)
  {
    const std::vector<Place> places =
      MakePlaces(terrain, { { 1.0, 0.0, 0.0 } }, layer * terrain->GetNumberOfCells());
    expected[layer] = RunPort(this->GetParam(), twice, places, ByPointId, withFaces);
    for (const Naming naming : { ByFace, ByAllArrays })
    {
      const auto numbers = RunPort(this->GetParam(), twice, places, naming, withFaces);
      EXPECT_TRUE(AreSame(expected[layer], numbers, 0.0)) << layer << naming;
    }
  }
  EXPECT_EQ(AreSame(expected[0], expected[1], 1e-9), name == "Matrix"); // see below
}

INSTANTIATE_TEST_SUITE_P(Filters, SourceIdentity, ::testing::ValuesIn(Ports),
  [](const auto& info) { return std::string(info.param.Name); });

TEST(SourceFaces, RowsAndColumnsAreOnTheirLayers)
{
  const auto terrain = MakeTerrain(9);
  const auto twice = Beside(terrain, terrain, 0.0);
  const Weights corner = { { 1.0, 0.0, 0.0 } };
  const auto upper = MakePlaces(terrain, corner, terrain->GetNumberOfCells());
  for (const Naming naming : { ByPointId, ByFace, ByAllArrays })
  {
    vtkNew<vtkGeodesicDistanceMatrix> filter;
    filter->SetInputData(twice);
    filter->SetRowData(MakePoints(twice, upper, naming));
    filter->SetColumnData(MakePoints(twice, MakePlaces(terrain, corner), naming));
    for (const double distance : GetNumbers(filter, false))
    {
      EXPECT_TRUE(std::isnan(distance)) << naming;
    }
  }
}

TEST(SourceFaces, ThreeCoordinatesAreNeeded)
{
  const auto surface = MakeGrid(1, 1);
  const auto points = MakePoints(surface, { { 0, { { 1, 0, 0 } } } }, ByFace);
  vtkNew<vtkDoubleArray> coordinates;
  coordinates->SetName("Barycentric");
  coordinates->SetNumberOfComponents(2);
  coordinates->InsertNextTuple2(1.0, 0.0);
  points->GetPointData()->AddArray(coordinates);
  vtkNew<vtkExactGeodesicDistance> filter;
  filter->SetInputData(surface);
  filter->SetSourceData(points);
  ExpectError(
    filter, { "FaceId and Barycentric of input port 1 must be numeric, with 1 and 3 components" });
}

TEST(SourceFaces, OutputsIdentifyTheirPoints)
{
  // Samples and sites inside faces, on the layer that the position does not find.
  const auto terrain = MakeTerrain(9);
  vtkNew<vtkGeodesicSampler> sampler;
  sampler->SetInputData(Beside(terrain, terrain, 0.0));
  sampler->SetNumberOfSamples(12);
  sampler->InFacesOn();
  vtkNew<vtkGeodesicVoronoi> cells;
  cells->SetInputData(sampler->GetInput());
  cells->SetSiteConnection(sampler->GetOutputPort());
  cells->CentroidalOn();
  cells->SetNumberOfIterations(2);
  vtkNew<vtkGeodesicVoronoi> again;
  again->SetInputData(sampler->GetInput());
  again->SetSiteConnection(cells->GetOutputPort(3));
  const Listener listeners[] = { Listener(sampler), Listener(cells), Listener(again) };
  again->Update();
  vtkDataArray* before = cells->GetSites()->GetPointData()->GetArray("CellArea");
  vtkDataArray* after = again->GetSites()->GetPointData()->GetArray("CellArea");
  ASSERT_EQ(after->GetNumberOfTuples(), 12);
  for (vtkIdType i = 0; i < 12; ++i)
  {
    EXPECT_GT(after->GetTuple1(i), 0.0);
    EXPECT_NEAR(after->GetTuple1(i), before->GetTuple1(i), 1e-9);
  }
}
