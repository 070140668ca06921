// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Points of input ports that are identified by point arrays, in every filter with such a port.
#include "FilterCases.h"
#include "SpectralTestTools.h"

#include "vtkExactGeodesicDistance.h"
#include "vtkGeodesicDistanceMatrix.h"
#include "vtkGeodesicSampler.h"
#include "vtkGeodesicVoronoi.h"

#include "vtkAppendPolyData.h"

using namespace dggtest;

namespace
{
using Weights = std::array<double, 3>;

/// A position in a triangle of a surface.
struct Place
{
  vtkIdType Cell;
  Weights Coordinates;
};

/// Arrays that identify the points.
enum Naming
{
  ByPosition,
  ByPointId, ///< positions are corners of triangles
  ByFace,    ///< FaceId, with an arbitrary position
  ByAllArrays
};

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
    positions.push_back(PointInCell(surface, place.Cell, place.Coordinates));
    for (double& x : positions.back())
    {
      x += naming == ByFace ? 10.0 : 0.0; // positions are ignored
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

/// Returns all values of the outputs of a filter except arrays that identify points; FaceId on
/// request.
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

bool AreSame(const std::vector<double>& a, const std::vector<double>& b, double tolerance)
{
  return a.size() == b.size() &&
    std::equal(a.begin(), a.end(), b.begin(), [tolerance](double x, double y) {
      return x == y || (std::isnan(x) && std::isnan(y)) || std::abs(x - y) <= tolerance;
    });
}

/// Returns four positions around the middle of a surface of 9 x 9 points, and one in the middle;
/// the cells of a second layer begin at `firstCell`.
std::vector<Place> MakePlaces(
  vtkPolyData* surface, const Weights& coordinates, vtkIdType firstCell = 0)
{
  std::vector<Place> places;
  for (const vtkIdType id : { 20, 24, 60, 56, 40 })
  {
    vtkIdType cell = 0;
    while (surface->GetCell(cell)->GetPointId(0) != id)
    {
      ++cell;
    }
    places.push_back({ firstCell + cell, coordinates });
  }
  return places;
}

std::vector<FilterCase> GetFiltersWithPoints()
{
  std::vector<FilterCase> filters;
  for (const FilterCase& filter : GetAllFilters())
  {
    if (filter.SetPoints)
    {
      filters.push_back(filter);
    }
  }
  return filters;
}

/// A filter on a relief, or on two coincident reliefs with different arrays.
class SourceIdentity : public ::testing::TestWithParam<FilterCase>
{
protected:
  SourceIdentity()
    : Filter(this->GetParam().Make(this->Relief))
  {
  }

  void UseLayers()
  {
    vtkNew<vtkPolyData> other;
    other->DeepCopy(this->Relief);
    for (int a = 0; a < other->GetPointData()->GetNumberOfArrays(); ++a)
    {
      vtkDataArray* array = other->GetPointData()->GetArray(a);
      for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
      {
        array->SetComponent(i, 0, 0.5 * array->GetComponent(i, 0));
      }
    }
    vtkNew<vtkAppendPolyData> append;
    append->AddInputData(this->Relief);
    append->AddInputData(other);
    append->Update();
    this->Filter->SetInputData(append->GetOutput());
  }

  std::vector<double> Run(const std::vector<Place>& places, Naming naming, bool withFaces = false)
  {
    auto* surface = vtkPolyData::SafeDownCast(this->Filter->GetInput());
    this->GetParam().SetPoints(this->Filter, MakePoints(surface, places, naming));
    return GetNumbers(this->Filter, withFaces);
  }

  vtkSmartPointer<vtkPolyData> Relief = MakeRelief(VTK_DOUBLE);
  vtkSmartPointer<vtkGeodesicAlgorithm> Filter;
};
}

TEST_P(SourceIdentity, FacesNamePointsAsPositionsDo)
{
  const std::vector<Place> places = MakePlaces(this->Relief, { { 0.5, 0.2, 0.3 } });
  const std::vector<double> expected = this->Run(places, ByPosition);
  ASSERT_FALSE(expected.empty());
  for (const Naming naming : { ByFace, ByAllArrays })
  {
    EXPECT_TRUE(AreSame(expected, this->Run(places, naming), 1e-9)) << naming;
  }
}

TEST_P(SourceIdentity, CoincidentLayersAreDistinguished)
{
  // FaceId is the only output of these filters that depends on the layer.
  const std::string name = this->GetParam().Name;
  const bool withFaces =
    name == "Path" || name == "Loop" || name == "PatchBoundaries" || name == "Sampler";
  this->UseLayers();
  std::vector<double> expected[2];
  for (int layer = 0; layer < 2; ++layer)
  {
    const std::vector<Place> places =
      MakePlaces(this->Relief, { { 1.0, 0.0, 0.0 } }, layer * this->Relief->GetNumberOfCells());
    expected[layer] = this->Run(places, ByPointId, withFaces);
    for (const Naming naming : { ByFace, ByAllArrays })
    {
      const auto numbers = this->Run(places, naming, withFaces);
      EXPECT_TRUE(AreSame(expected[layer], numbers, 0.0)) << layer << naming;
    }
  }
  EXPECT_EQ(AreSame(expected[0], expected[1], 1e-9), name == "Matrix"); // tested below
}

INSTANTIATE_TEST_SUITE_P(Filters, SourceIdentity, ::testing::ValuesIn(GetFiltersWithPoints()),
  [](const ::testing::TestParamInfo<FilterCase>& tested) { return tested.param.Name; });

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
    filter, { "FaceId and Barycentric of input port 1 are not numeric with 1 and 3 components" });
}

TEST(SourceFaces, OutputsIdentifyTheirPoints)
{
  // Samples and sites inside faces, on the layer that a search by position does not return.
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
