// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Input in blocks and partitions, in one process.
#include "PartTestTools.h"

#include "vtkDGGDistance.h"
#include "vtkDiscreteGeodesicGraph.h"
#include "vtkExactGeodesicDistance.h"

#include "vtkCompositeDataSet.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"

using namespace dggtest;

namespace
{
/// Three terrains of different sizes side by side, with gaps between them.
class Blocks : public testing::Test
{
protected:
  const std::vector<int> Sizes{ 13, 17, 21 };
  std::vector<vtkSmartPointer<vtkPolyData>> Surfaces;
  vtkNew<vtkMultiBlockDataSet> All;

  Blocks()
  {
    for (std::size_t block = 0; block < this->Sizes.size(); ++block)
    {
      this->Surfaces.push_back(MakeTerrain(this->Sizes[block]));
      MovePoints(
        this->Surfaces.back(), [&](double* p) { p[0] = p[0] + 1.2 * static_cast<double>(block); });
      this->All->SetBlock(static_cast<unsigned int>(block), this->Surfaces.back());
    }
  }

  static std::array<double, 3> GetPlace(int block, double x, double y)
  {
    return { { x + 1.2 * block, y, GetTerrainHeight(x, y) } };
  }

  static vtkPolyData* GetBlock(vtkAlgorithm* filter, unsigned int block, int port = 0)
  {
    auto* output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(port));
    return output ? vtkPolyData::SafeDownCast(output->GetBlock(block)) : nullptr;
  }

  static vtkDataArray* GetArray(
    vtkAlgorithm* filter, unsigned int block, const char* name = "GeodesicDistance")
  {
    vtkPolyData* leaf = GetBlock(filter, block);
    return leaf ? leaf->GetPointData()->GetArray(name) : nullptr;
  }

  static void ExpectEqual(vtkDataArray* array, vtkDataArray* expected, double tolerance = 1e-12)
  {
    ASSERT_TRUE(array && expected);
    ASSERT_EQ(array->GetNumberOfTuples(), expected->GetNumberOfTuples());
    for (vtkIdType i = 0; i < expected->GetNumberOfValues(); ++i)
    {
      ASSERT_NEAR(
        array->GetVariantValue(i).ToDouble(), expected->GetVariantValue(i).ToDouble(), tolerance);
    }
  }

  static void ExpectUnreached(vtkDataArray* array)
  {
    ASSERT_NE(array, nullptr);
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      ASSERT_TRUE(std::isnan(array->GetComponent(i, 0)));
    }
  }

  /// Returns a distance filter that has run on one block alone.
  template <typename Filter>
  vtkSmartPointer<Filter> OnBlock(std::size_t block, vtkPolyData* sources)
  {
    auto filter = vtkSmartPointer<Filter>::New();
    filter->SetInputData(this->Surfaces[block]);
    filter->SetSourceData(sources);
    filter->Update();
    return filter;
  }
};
}

//------------------------------------------------------------------------------
TEST_F(Blocks, ASourceBelongsToTheNearestBlock)
{
  const auto source = MakeSourcePoints({ GetPlace(1, 0.3, 0.6) });
  vtkNew<vtkDGGDistance> filter;
  filter->SetInputDataObject(this->All);
  filter->SetSourceData(source);
  ExpectSuccess(filter);
  EXPECT_EQ(filter->GetOutput(), nullptr);
  ExpectEqual(GetArray(filter, 1),
    this->OnBlock<vtkDGGDistance>(1, source)->GetOutput()->GetPointData()->GetArray(
      "GeodesicDistance"),
    1e-7);
  ExpectUnreached(GetArray(filter, 0));
  ExpectUnreached(GetArray(filter, 2));
  for (unsigned int block = 0; block < 3; ++block)
  {
    EXPECT_STREQ(
      GetBlock(filter, block)->GetPointData()->GetScalars()->GetName(), "GeodesicDistance");
    EXPECT_EQ(GetBlock(filter, block)->GetPoints(), this->Surfaces[block]->GetPoints());
    EXPECT_EQ(GetBlock(filter, block)->GetPolys(), this->Surfaces[block]->GetPolys());
  }
  // A single vtkPolyData again.
  filter->SetInputData(this->Surfaces[1]);
  ExpectSuccess(filter);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), this->Surfaces[1]->GetNumberOfPoints());
}

//------------------------------------------------------------------------------
TEST_F(Blocks, IdsCountThePointsOfAllBlocks)
{
  vtkNew<vtkExactGeodesicDistance> filter;
  filter->SetInputDataObject(this->All);
  const vtkIdType first = this->Surfaces[0]->GetNumberOfPoints();
  const vtkIdType second = this->Surfaces[1]->GetNumberOfPoints();
  filter->SetSourceIds({ 5, first + second + 7 });
  filter->GenerateNearestSourceOn();
  ExpectSuccess(filter);
  EXPECT_EQ(GetArray(filter, 0)->GetComponent(5, 0), 0.0);
  EXPECT_EQ(GetArray(filter, 2)->GetComponent(7, 0), 0.0);
  EXPECT_EQ(GetArray(filter, 0, "GeodesicSource")->GetComponent(30, 0), 0.0);
  EXPECT_EQ(GetArray(filter, 2, "GeodesicSource")->GetComponent(30, 0), 1.0);
  EXPECT_EQ(GetArray(filter, 1, "GeodesicSource")->GetComponent(30, 0), -1.0);
  ExpectUnreached(GetArray(filter, 1));
  filter->SetSourceIds({ first + second + this->Surfaces[2]->GetNumberOfPoints() });
  ExpectError(filter, { "vtkExactGeodesicDistance", "out of range" });
}

//------------------------------------------------------------------------------
/// The graph of all blocks is built once, and rebuilt only when a block changes.
TEST_F(Blocks, GraphsAreKept)
{
  vtkNew<vtkDiscreteGeodesicGraph> graph;
  graph->SetInputDataObject(this->All);
  vtkNew<vtkDGGDistance> chained;
  chained->SetInputConnection(graph->GetOutputPort());
  vtkNew<vtkDGGDistance> alone;
  alone->SetInputDataObject(this->All);
  vtkMTimeType built = 0;
  vtkMTimeType own = 0;
  for (const int block : { 0, 2, 1, 0 })
  {
    const auto source = MakeSourcePoints({ GetPlace(block, 0.5, 0.1 * block + 0.1) });
    chained->SetSourceData(source);
    alone->SetSourceData(source);
    ExpectSuccess(chained);
    ExpectSuccess(alone);
    EXPECT_TRUE(chained->GetUsedInputGraph());
    EXPECT_FALSE(alone->GetUsedInputGraph());
    built = built == 0 ? graph->GetGraphBuildTime() : built;
    own = own == 0 ? alone->GetGraphBuildTime() : own;
    EXPECT_EQ(graph->GetGraphBuildTime(), built);
    EXPECT_EQ(alone->GetGraphBuildTime(), own);
    ExpectEqual(GetArray(chained, block), GetArray(alone, block));
  }
  EXPECT_TRUE(graph->GetOutputDataObject(0)->GetFieldData()->HasArray("DGG.Offsets"));
  EXPECT_FALSE(GetBlock(graph, 0)->GetFieldData()->HasArray("DGG.Offsets"));
  EXPECT_GT(graph->EstimateMemory(), 0u);

  this->Surfaces[1]->GetPoints()->SetPoint(3, this->Surfaces[1]->GetPoint(4));
  this->Surfaces[1]->GetPoints()->Modified();
  this->All->Modified();
  chained->Update();
  EXPECT_NE(graph->GetGraphBuildTime(), built);
}

//------------------------------------------------------------------------------
/// Null blocks, empty blocks, blocks without cells, and blocks that are not vtkPolyData.
TEST_F(Blocks, LeavesThatAreNoSurfaces)
{
  vtkNew<vtkMultiBlockDataSet> mixed;
  vtkNew<vtkPolyData> empty;
  vtkNew<vtkImageData> image;
  image->SetDimensions(3, 3, 3);
  mixed->SetNumberOfBlocks(5);
  mixed->SetBlock(1, empty);
  mixed->SetBlock(2, this->Surfaces[0]);
  mixed->SetBlock(3, image);
  mixed->GetMetaData(2u)->Set(vtkCompositeDataSet::NAME(), "terrain");
  vtkNew<vtkDGGDistance> filter;
  filter->SetInputDataObject(mixed);
  filter->SetSourceIds({ 4 });
  ExpectWarning(filter, { "1 blocks of the input are not vtkPolyData" });
  auto* output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  EXPECT_EQ(output->GetBlock(0), nullptr);
  EXPECT_EQ(GetBlock(filter, 1)->GetNumberOfPoints(), 0);
  EXPECT_EQ(GetArray(filter, 2)->GetComponent(4, 0), 0.0);
  EXPECT_TRUE(output->GetBlock(3)->IsA("vtkImageData"));
  EXPECT_STREQ(output->GetMetaData(2u)->Get(vtkCompositeDataSet::NAME()), "terrain");

  vtkNew<vtkMultiBlockDataSet> nothing;
  filter->SetInputDataObject(nothing);
  ExpectWarning(filter, { "empty" });
  filter->SetInputData(this->Surfaces[0]);
  ExpectSuccess(filter);
}

//------------------------------------------------------------------------------
TEST_F(Blocks, NestedBlocksAndSourcesInSeveral)
{
  vtkNew<vtkMultiBlockDataSet> inner;
  inner->SetBlock(0, this->Surfaces[1]);
  inner->SetBlock(1, this->Surfaces[2]);
  vtkNew<vtkMultiBlockDataSet> outer;
  outer->SetBlock(0, this->Surfaces[0]);
  outer->SetBlock(1, inner);
  const auto sources =
    MakeSourcePoints({ GetPlace(2, 0.3, 0.6), GetPlace(0, 0.7, 0.2), GetPlace(2, 0.8, 0.8) });
  vtkNew<vtkExactGeodesicDistance> filter;
  filter->SetInputDataObject(outer);
  filter->SetSourceData(sources);
  filter->GenerateNearestSourceOn();
  ExpectSuccess(filter);
  auto* output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  auto* innerOutput = vtkMultiBlockDataSet::SafeDownCast(output->GetBlock(1));
  ASSERT_NE(innerOutput, nullptr);
  auto* last = vtkPolyData::SafeDownCast(innerOutput->GetBlock(1));
  const auto expected = this->OnBlock<vtkExactGeodesicDistance>(
    2, MakeSourcePoints({ GetPlace(2, 0.3, 0.6), GetPlace(2, 0.8, 0.8) }));
  ExpectEqual(last->GetPointData()->GetArray("GeodesicDistance"),
    expected->GetOutput()->GetPointData()->GetArray("GeodesicDistance"));
  ExpectEqual(GetArray(filter, 0),
    this->OnBlock<vtkExactGeodesicDistance>(0, MakeSourcePoints({ GetPlace(0, 0.7, 0.2) }))
      ->GetOutput()
      ->GetPointData()
      ->GetArray("GeodesicDistance"));
  double range[2];
  last->GetPointData()->GetArray("GeodesicSource")->GetRange(range);
  EXPECT_EQ(range[0], 0.0);
  EXPECT_EQ(range[1], 2.0);
}

//------------------------------------------------------------------------------
/// The partitions of each member of a collection form one surface; the members stay separate.
TEST_F(Blocks, PartitionsAreJoined)
{
  vtkPolyData* surface = this->Surfaces[2];
  const Labels labels = LabelRandomly(surface, 4, 3);
  vtkNew<vtkPartitionedDataSetCollection> collection;
  for (int i = 0; i < 4; ++i)
  {
    collection->SetPartition(
      0, static_cast<unsigned int>(i), TakePart(surface, labels, i, PartIds::None, true));
  }
  collection->SetPartition(1, 0, this->Surfaces[0]);
  const auto source = MakeSourcePoints({ GetPlace(2, 0.3, 0.6) });
  const auto whole = this->OnBlock<vtkExactGeodesicDistance>(2, source);
  vtkNew<vtkExactGeodesicDistance> filter;
  filter->SetSourceData(source);
  filter->SetInputDataObject(collection);
  ExpectSuccess(filter);
  EXPECT_EQ(GetReported(filter, "NumberOfComponents"), 2);
  auto* output = vtkPartitionedDataSetCollection::SafeDownCast(filter->GetOutputDataObject(0));
  ASSERT_NE(output, nullptr);
  for (unsigned int i = 0; i < 4; ++i)
  {
    auto* part =
      vtkPolyData::SafeDownCast(output->GetPartitionedDataSet(0)->GetPartitionAsDataObject(i));
    ExpectArray(part, whole->GetOutput(), "GeodesicDistance", 1e-12);
  }
}

//------------------------------------------------------------------------------
/// Faces of one volume cell share its global id. Common cells of two pieces are therefore also
/// identified by their points.
TEST_F(Blocks, CellsWithOneGlobalId)
{
  vtkPolyData* surface = this->Surfaces[2];
  const Labels labels = LabelStrips(surface, 2);
  vtkNew<vtkPartitionedDataSet> partitions;
  for (int i = 0; i < 2; ++i)
  {
    const auto part = TakePart(surface, labels, i, PartIds::Global, true);
    for (vtkDataSetAttributes* data : { static_cast<vtkDataSetAttributes*>(part->GetPointData()),
           static_cast<vtkDataSetAttributes*>(part->GetCellData()) })
    {
      data->RemoveArray(vtkDataSetAttributes::GhostArrayName());
    }
    vtkDataArray* ids = part->GetCellData()->GetGlobalIds();
    for (vtkIdType c = 0; c < ids->GetNumberOfTuples(); ++c)
    {
      ids->SetComponent(c, 0, std::floor(ids->GetComponent(c, 0) / 2.0));
    }
    partitions->SetPartition(static_cast<unsigned int>(i), part);
  }
  vtkNew<vtkExactGeodesicDistance> filter;
  filter->SetInputDataObject(partitions);
  filter->SetSourceIds({ 0 });
  ExpectSuccess(filter);
  EXPECT_EQ(GetReported(filter, "NumberOfTriangles"), surface->GetNumberOfCells());
  EXPECT_EQ(GetReported(filter, "NumberOfDuplicateFaces"), 0);
}

//------------------------------------------------------------------------------
/// The same leaves, first in one surface and then in two.
TEST_F(Blocks, LeavesGroupedAnew)
{
  const auto surface = MakeTerrain(17);
  const Labels labels = LabelStrips(surface, 2);
  const auto left = TakePart(surface, labels, 0);
  const auto right = TakePart(surface, labels, 1);
  vtkNew<vtkExactGeodesicDistance> filter;
  filter->SetSourceIds({ 0 });
  for (const unsigned int members : { 1u, 2u, 1u })
  {
    vtkNew<vtkPartitionedDataSetCollection> collection;
    collection->SetPartition(0, 0, left);
    collection->SetPartition(members - 1, members == 1 ? 1 : 0, right);
    filter->SetInputDataObject(collection);
    const Listener silence(filter); // ignores the warning about blocks that touch
    filter->Update();
    EXPECT_EQ(GetReported(filter, "NumberOfComponents"), members);
  }
}

//------------------------------------------------------------------------------
/// Blocks that touch are joined only on request.
TEST_F(Blocks, BlocksThatTouch)
{
  const auto surface = MakeTerrain(17);
  const Labels labels = LabelStrips(surface, 2);
  vtkNew<vtkMultiBlockDataSet> halves;
  halves->SetBlock(0, TakePart(surface, labels, 0));
  halves->SetBlock(1, TakePart(surface, labels, 1));
  vtkNew<vtkExactGeodesicDistance> filter;
  filter->SetInputDataObject(halves);
  filter->SetSourceData(MakeSourcePoints({ { { 0.1, 0.5, GetTerrainHeight(0.1, 0.5) } } }));
  ExpectWarning(filter, { "the same coordinates" });
  double range[2];
  GetArray(filter, 0)->GetRange(range);
  EXPECT_GT(range[1], 0.3);
  ExpectUnreached(GetArray(filter, 1));
  filter->MergeCoincidentPointsOn();
  ExpectSuccess(filter);
  GetArray(filter, 1)->GetFiniteRange(range);
  EXPECT_GT(range[1], 0.9);
}

//------------------------------------------------------------------------------
/// Sources may be given in blocks.
TEST_F(Blocks, OtherPortsTakeBlocks)
{
  vtkNew<vtkMultiBlockDataSet> sources;
  sources->SetBlock(0, MakeSourcePoints({ GetPlace(0, 0.5, 0.5) }));
  sources->SetBlock(2, MakeSourcePoints({ GetPlace(0, 0.2, 0.2) }));
  vtkNew<vtkExactGeodesicDistance> filter;
  filter->SetInputData(this->Surfaces[0]);
  filter->SetInputDataObject(1, sources);
  ExpectSuccess(filter);
  const auto expected = this->OnBlock<vtkExactGeodesicDistance>(
    0, MakeSourcePoints({ GetPlace(0, 0.5, 0.5), GetPlace(0, 0.2, 0.2) }));
  ASSERT_NE(filter->GetOutput(), nullptr);
  EXPECT_EQ(GetDistances(filter), GetDistances(expected));
}

//------------------------------------------------------------------------------
TEST_F(Blocks, WrongBlocks)
{
  this->Surfaces[1]->GetPolys()->InsertNextCell({ 0, 1, 100000 });
  vtkNew<vtkDGGDistance> filter;
  filter->SetInputDataObject(this->All);
  filter->SetSourceIds({ 0 });
  const Listener listener(filter);
  filter->Update();
  ASSERT_EQ(listener.Errors.size(), 1u);
  EXPECT_NE(listener.Errors[0].find("refers to point 100000"), std::string::npos);
  EXPECT_EQ(GetBlock(filter, 0), nullptr);
  EXPECT_NE(filter->GetErrorCode(), 0u);
}
