// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The contract of all filters on surfaces: errors in the input, unused cells and points,
/// coincident points, and the graph that some filters search.
#include "FilterCases.h"
#include "GraphTestTools.h"
#include "PartTestTools.h"

#include "vtkDGGDistance.h"
#include "vtkDGGLoop.h"
#include "vtkDGGPath.h"
#include "vtkGeodesicDistanceMatrix.h"
#include "vtkGeodesicSampler.h"
#include "vtkGeodesicVoronoi.h"

#include "vtkDataSetAttributes.h"
#include "vtkErrorCode.h"
#include "vtkPartitionedDataSet.h"

using namespace dggtest;

namespace
{
/// Returns true for equal numbers; eigenvectors of another mesh may differ by rounding.
bool AreSame(double a, double b)
{
  return std::abs(a - b) <= 1e-9 * std::abs(a) || (std::isnan(a) && std::isnan(b));
}

class SurfaceContract : public ::testing::TestWithParam<FilterCase>
{
protected:
  vtkSmartPointer<vtkGeodesicAlgorithm> Make() { return this->GetParam().Make(this->Relief); }

  /// Expects the results of the relief on a surface with the same triangles after `otherCells`
  /// other cells, and the same points followed by others. `elsewhere` checks the values at the
  /// additional points.
  template <typename Function>
  void ExpectTheSame(
    vtkPolyData* surface, vtkIdType otherCells, vtkGeodesicAlgorithm* filter, Function elsewhere)
  {
    const auto plain = this->Make();
    ExpectSuccess(plain);
    ExpectSuccess(filter);
    const auto compare = [&](vtkDataArray* expected, vtkDataArray* found, vtkIdType others) {
      SCOPED_TRACE(expected->GetName());
      ASSERT_NE(found, nullptr);
      const vtkIdType n = expected->GetNumberOfTuples();
      const vtkIdType more = found->GetNumberOfTuples() - n;
      const bool isOfPoints = n == this->Relief->GetNumberOfPoints();
      if (more != 0 && more != others && !isOfPoints)
      {
        return; // new points have different ids
      }
      const std::string name = expected->GetName();
      const vtkIdType first = isOfPoints ? 0 : more;
      for (vtkIdType i = 0; i < n; ++i)
      {
        for (int c = 0; c < expected->GetNumberOfComponents(); ++c)
        {
          const double shift = name == "FaceId" ? static_cast<double>(otherCells) : 0.0;
          ASSERT_TRUE(
            AreSame(expected->GetComponent(i, c) + shift, found->GetComponent(first + i, c)))
            << i << ": " << expected->GetComponent(i, c) - found->GetComponent(first + i, c);
        }
      }
      const bool isResult = name != "Points" && !surface->GetPointData()->HasArray(name.c_str());
      for (vtkIdType i = 0; isResult && i < more; ++i)
      {
        elsewhere(found, isOfPoints ? n + i : i);
      }
    };
    for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
    {
      SCOPED_TRACE(port);
      vtkDataObject* outputs[2] = { plain->GetOutputDataObject(port),
        filter->GetOutputDataObject(port) };
      auto* geometry = vtkPolyData::SafeDownCast(outputs[0]);
      auto* other = vtkPolyData::SafeDownCast(outputs[1]);
      if (geometry && geometry->GetNumberOfPoints() > 0)
      {
        EXPECT_EQ(other->GetNumberOfPolys(), geometry->GetNumberOfPolys());
        compare(geometry->GetPoints()->GetData(), other->GetPoints()->GetData(), 0);
      }
      for (const int kind : { vtkDataObject::POINT, vtkDataObject::CELL, vtkDataObject::ROW })
      {
        vtkDataSetAttributes* expected = outputs[0]->GetAttributes(kind);
        for (int a = 0; expected && a < expected->GetNumberOfArrays(); ++a)
        {
          compare(expected->GetArray(a),
            outputs[1]->GetAttributes(kind)->GetArray(expected->GetArrayName(a)),
            kind == vtkDataObject::CELL ? otherCells : 0);
        }
      }
    }
  }

  vtkSmartPointer<vtkPolyData> Relief = MakeRelief(VTK_DOUBLE);
};

/// Fixture of filters that search a graph.
template <typename FilterType>
class GraphFilters : public ::testing::Test
{
protected:
  void SetUp() override
  {
    for (const FilterCase& tested : GetAllFilters())
    {
      const auto filter = tested.Make(this->Relief);
      if (FilterType::SafeDownCast(filter))
      {
        this->Filter = FilterType::SafeDownCast(filter);
        this->SetPoints = tested.SetPoints;
      }
    }
    if (auto* voronoi = vtkGeodesicVoronoi::SafeDownCast(this->Filter))
    {
      voronoi->RefineBoundariesOff(); // refinement needs links, too
    }
  }

  /// Sets points that are not vertices.
  void UseLinks()
  {
    this->SetPoints(this->Filter, MakeSourcePoints(GetPointsOnEdges(this->Relief)));
  }

  vtkSmartPointer<vtkPolyData> Relief = MakeRelief(VTK_DOUBLE);
  vtkSmartPointer<FilterType> Filter;

private:
  std::function<void(vtkGeodesicAlgorithm*, vtkPolyData*)> SetPoints;
};
using GraphFilterTypes = ::testing::Types<vtkDGGDistance, vtkGeodesicDistanceMatrix, vtkDGGPath,
  vtkDGGLoop, vtkGeodesicSampler, vtkGeodesicVoronoi>;
TYPED_TEST_SUITE(GraphFilters, GraphFilterTypes);
}

TEST_P(SurfaceContract, RecoversFromErrors)
{
  const auto filter = this->Make();
  ExpectSuccess(filter);
  const std::string expected = DescribeOutputs(filter);
  double p[3];
  this->Relief->GetPoint(5, p);
  this->Relief->GetPoints()->SetPoint(5, std::nan(""), 0.0, 0.0);
  this->Relief->GetPoints()->Modified();
  ExpectError(filter, { "point 5" });
  {
    const Listener listener(filter);
    filter->Update(); // nothing has changed: the error is not repeated, but remains set
    EXPECT_TRUE(listener.Errors.empty());
    EXPECT_NE(filter->GetErrorCode(), vtkErrorCode::NoError);
    ExpectEmptyOutput(filter);
  }
  filter->Modified();
  ExpectError(filter, { "point 5" });
  this->Relief->GetPoints()->SetPoint(5, p);
  this->Relief->GetPoints()->Modified();
  {
    const Listener listener(filter);
    filter->UpdatePiece(0, 2, 0);
    ASSERT_EQ(listener.Errors.size(), 1u);
    EXPECT_NE(listener.Errors[0].find("One of 2 pieces"), std::string::npos);
    ExpectEmptyOutput(filter);
    filter->UpdatePiece(0, 1, 0);
    EXPECT_EQ(listener.Errors.size(), 1u);
  }
  EXPECT_TRUE(DescribeOutputs(filter) == expected);
}

TEST_P(SurfaceContract, KeepsTheMeshOfTheSamePointsAndCells)
{
  const auto filter = this->Make();
  ExpectSuccess(filter);
  const std::string expected = DescribeOutputs(filter);
  const vtkMTimeType built = filter->GetMeshBuildTime();
  vtkNew<vtkPolyData> copy;
  copy->DeepCopy(this->Relief);
  copy->GetPolys()->ConvertTo32BitStorage();
  filter->SetInputData(copy);
  ExpectSuccess(filter);
  EXPECT_EQ(filter->GetMeshBuildTime(), built);
  EXPECT_TRUE(DescribeOutputs(filter) == expected);
}

TEST_P(SurfaceContract, UsesNoOtherCellsAndNoPointsWithoutPolygons)
{
  const auto surface = MakeRelief(VTK_DOUBLE);
  for (int i = 0; i < 4; ++i)
  {
    surface->GetPoints()->InsertNextPoint(11.0 + i, 5.0, 2.0);
  }
  surface->SetVerts(MakeCells({ { 81 } }));
  surface->SetLines(MakeCells({ { 82, 83 } }));
  this->ExpectTheSame(
    surface, 2, this->GetParam().Make(surface), [](vtkDataArray* array, vtkIdType i) {
      const bool isDistance = std::string(array->GetName()).find("Distance") != std::string::npos;
      const bool isNumber = array->GetDataType() == VTK_DOUBLE || array->GetDataType() == VTK_FLOAT;
      const double unreached = isDistance ? std::nan("") : isNumber ? 0.0 : -1.0;
      EXPECT_TRUE(AreSame(array->GetComponent(i, 0), unreached)) << array->GetComponent(i, 0);
    });
}

TEST_P(SurfaceContract, MergesCoincidentPoints)
{
  // A relief cut in two: the upper part has copies of the points of the middle row.
  const auto surface = MakeRelief(VTK_DOUBLE);
  vtkCellArray* triangles = surface->GetPolys();
  for (vtkIdType id = 36; id < 45; ++id)
  {
    surface->GetPoints()->InsertNextPoint(surface->GetPoint(id));
  }
  for (vtkIdType cell = 64; cell < 128; ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    triangles->GetCellAtId(cell, size, ids);
    std::array<vtkIdType, 3> corners{ { ids[0], ids[1], ids[2] } };
    for (vtkIdType& id : corners)
    {
      id = id < 45 ? 81 + id - 36 : id;
    }
    triangles->ReplaceCellAtId(cell, 3, corners.data());
  }
  const auto filter = this->GetParam().Make(surface);
  filter->MergeCoincidentPointsOn();
  vtkDataArray* integrals = surface->GetPointData()->GetArray("f");
  for (vtkIdType id = 81; integrals && id < 90; ++id)
  {
    integrals->SetComponent(id, 0, 0.0); // values of merged points are added
  }
  this->ExpectTheSame(surface, 0, filter, [](vtkDataArray* array, vtkIdType i) {
    EXPECT_TRUE(AreSame(array->GetComponent(i, 0), array->GetComponent(i - 81 + 36, 0)));
  });
}

TEST_P(SurfaceContract, PartitionsAreOneSurface)
{
  const auto whole = this->Make();
  ExpectSuccess(whole);
  const Labels labels = LabelRandomly(this->Relief, 4, 3);
  vtkNew<vtkPartitionedDataSet> partitions;
  for (int i = 0; i < 4; ++i)
  {
    partitions->SetPartition(
      static_cast<unsigned int>(i), TakePart(this->Relief, labels, i, PartIds::Global));
  }
  const auto filter = this->Make();
  filter->SetInputDataObject(partitions);
  ExpectSuccess(filter);
  ExpectOutputsOfParts(filter, whole);
}

INSTANTIATE_TEST_SUITE_P(Filters, SurfaceContract, ::testing::ValuesIn(GetAllFilters()),
  [](const ::testing::TestParamInfo<FilterCase>& tested) { return tested.param.Name; });

TYPED_TEST(GraphFilters, TakeTheGraphOnTheirInputOrBuildOne)
{
  ExpectSuccess(this->Filter);
  const vtkMTimeType built = this->Filter->GetGraphBuildTime();
  EXPECT_GT(built, 0u);
  EXPECT_FALSE(this->Filter->GetUsedInputGraph());
  EXPECT_TRUE(this->Filter->GetGraphIsGuaranteed());
  EXPECT_EQ(this->Filter->GetGraphAccuracy(), 0.05);
  EXPECT_GE(this->Filter->GetMemorySize(),
    static_cast<vtkTypeUInt64>(16 * this->Filter->GetNumberOfGraphEdges()));
  const std::string expected = DescribeOutputs(this->Filter, false);
  this->Filter->Modified();
  ExpectSuccess(this->Filter);
  EXPECT_EQ(this->Filter->GetGraphBuildTime(), built);
  vtkNew<vtkPolyData> copy;
  copy->DeepCopy(this->Relief);
  copy->GetPolys()->ConvertTo32BitStorage();
  this->Filter->SetInputData(copy);
  ExpectSuccess(this->Filter);
  EXPECT_EQ(this->Filter->GetGraphBuildTime(), built);
  this->Filter->SetInputData(MakeSurfaceWithGraph(this->Relief, 0.05));
  ExpectSuccess(this->Filter);
  EXPECT_EQ(this->Filter->GetGraphBuildTime(), built);
  EXPECT_TRUE(this->Filter->GetUsedInputGraph());
  EXPECT_EQ(DescribeOutputs(this->Filter, false), expected);
  this->Filter->SetAccuracy(0.01);
  ExpectWarning(this->Filter, { "Accuracy is 0.01" });
  this->Filter->AcceptCoarserGraphOn();
  this->Filter->SetAccuracy(0.02);
  ExpectSuccess(this->Filter);
}

TYPED_TEST(GraphFilters, RefuseLinksBeyondTheMemoryLimit)
{
  ExpectSuccess(this->Filter);
  this->Filter->SetMemoryLimit(1000); // the graph exists
  this->UseLinks();
  ExpectError(this->Filter, { "linking points that are not vertices" });
}

TYPED_TEST(GraphFilters, TakeGraphsOfAnyConstruction)
{
  this->UseLinks();
  this->Filter->AcceptCoarserGraphOn();
  for (const int construction : { vtkDiscreteGeodesicGraph::OneRelay,
         vtkDiscreteGeodesicGraph::Indirect, vtkDiscreteGeodesicGraph::SaddleVertexGraph })
  {
    this->Filter->SetInputData(MakeSurfaceWithGraph(this->Relief, 0.05, construction));
    ExpectSuccess(this->Filter);
    EXPECT_TRUE(this->Filter->GetUsedInputGraph());
    EXPECT_FALSE(this->Filter->GetGraphIsGuaranteed());
    EXPECT_FALSE(DescribeOutputs(this->Filter, false).empty());
    this->Filter->AcceptCoarserGraphOff();
    ExpectWarning(this->Filter, { "guarantees no accuracy" });
    this->Filter->AcceptCoarserGraphOn();
  }
}
