// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A graph is passed in field data through filters and files. A damaged graph, or a graph of
/// another surface, is detected, reported and rebuilt, but never used.
#include "GraphTestTools.h"

#include "vtkDGGDistance.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkSOADataArrayTemplate.h"
#include "vtkStringArray.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLPolyDataWriter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

using namespace dggtest;

namespace
{
constexpr double Accuracy = 0.05;

/// A surface with a graph, and the resulting distances.
class GraphInFieldData : public ::testing::Test
{
protected:
  void SetUp() override
  {
    this->Surface = MakeSurfaceWithGraph(MakeTerrain(16), Accuracy);
    this->Filter->SetAccuracy(Accuracy);
    this->Filter->AddSourceId(40);
    this->Filter->SetInputData(this->Surface);
    ExpectSuccess(this->Filter);
    EXPECT_TRUE(this->Filter->GetUsedInputGraph());
    this->Expected = GetDistances(this->Filter);
    ASSERT_EQ(this->Expected.size(), 256u);
  }

  vtkSmartPointer<vtkPolyData> Copy() const
  {
    auto copy = vtkSmartPointer<vtkPolyData>::New();
    copy->DeepCopy(this->Surface);
    return copy;
  }

  /// Expects one warning and a rebuilt graph with the same distances. Later updates give no
  /// warning, and a valid graph is used again.
  void ExpectRebuilt(vtkPolyData* surface, const std::vector<std::string>& parts)
  {
    vtkNew<vtkDGGDistance> filter;
    filter->SetAccuracy(Accuracy);
    filter->AddSourceId(40);
    filter->SetInputData(surface);
    std::vector<std::string> all = { "graph on the input", "graph with Accuracy 0.05 replaces it" };
    all.insert(all.end(), parts.begin(), parts.end());
    ExpectWarning(filter, all);
    EXPECT_FALSE(filter->GetUsedInputGraph());
    const vtkMTimeType built = filter->GetGraphBuildTime();
    EXPECT_GT(built, 0u);
    ExpectWithin(GetDistances(filter), GetExactDistances(surface, { 40 }), Accuracy);
    if (!this->IsMoved)
    {
      EXPECT_EQ(GetDistances(filter), this->Expected);
    }
    filter->SetSourceIds({ 41 });
    ExpectSuccess(filter); // reported once, built once
    EXPECT_EQ(filter->GetGraphBuildTime(), built);
    filter->SetSourceIds({ 40 });
    filter->SetInputData(this->Surface);
    ExpectSuccess(filter);
    EXPECT_TRUE(filter->GetUsedInputGraph());
    EXPECT_EQ(GetDistances(filter), this->Expected);
  }

  /// Expects the same for a surface whose graph has been changed.
  void ExpectNoticed(const std::function<void(vtkFieldData*)>& damage, const std::string& part)
  {
    SCOPED_TRACE(part);
    auto copy = this->Copy();
    damage(copy->GetFieldData());
    this->ExpectRebuilt(copy, { part });
  }

  vtkSmartPointer<vtkPolyData> Surface;
  vtkNew<vtkDGGDistance> Filter;
  std::vector<double> Expected;
  bool IsMoved = false; // true if the surface has changed
};

vtkSmartPointer<vtkPolyData> WriteAndRead(vtkPolyData* data, int mode, int compressor = 0)
{
  // Each test has a separate file, because tests may run simultaneously.
  const std::string test = ::testing::UnitTest::GetInstance()->current_test_info()->name();
  const std::string path = std::string(DGG_TEST_OUTPUT) + "/GraphInFieldData" + test +
    std::to_string(mode) + std::to_string(compressor) + ".vtp";
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(data);
  writer->SetFileName(path.c_str());
  writer->SetDataMode(mode);
  writer->SetCompressorType(compressor);
  EXPECT_EQ(writer->Write(), 1);
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  return reader->GetOutput();
}
}

TEST_F(GraphInFieldData, SurvivesFiles)
{
  for (const int mode : { vtkXMLWriter::Ascii, vtkXMLWriter::Binary, vtkXMLWriter::Appended })
  {
    for (const int compressor : { vtkXMLWriter::NONE, vtkXMLWriter::ZLIB, vtkXMLWriter::LZ4 })
    {
      SCOPED_TRACE(mode);
      auto read = WriteAndRead(this->Surface, mode, compressor);
      EXPECT_EQ(GetGraphBytes(read), GetGraphBytes(this->Surface));
      vtkNew<vtkDGGDistance> filter;
      filter->SetAccuracy(Accuracy);
      filter->AddSourceId(40);
      filter->SetInputData(read);
      ExpectSuccess(filter);
      EXPECT_TRUE(filter->GetUsedInputGraph());
      EXPECT_EQ(filter->GetGraphBuildTime(), 0u);
      EXPECT_EQ(GetDistances(filter), this->Expected);
    }
  }
}

TEST_F(GraphInFieldData, SurvivesFilesWithFloatPointsAndDoubleLengths)
{
  auto surface = MakeTerrain(7);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToFloat();
  points->DeepCopy(surface->GetPoints());
  ASSERT_EQ(points->GetDataType(), VTK_FLOAT);
  surface->SetPoints(points);
  surface = MakeSurfaceWithGraph(surface, 2e-6);
  EXPECT_EQ(surface->GetFieldData()->GetArray("DGG.Lengths")->GetDataType(), VTK_DOUBLE);
  vtkNew<vtkDGGDistance> filter;
  filter->AddSourceId(0);
  filter->SetInputData(surface);
  ExpectSuccess(filter);
  const auto expected = GetDistances(filter);
  filter->SetInputData(WriteAndRead(surface, vtkXMLWriter::Ascii));
  ExpectSuccess(filter);
  EXPECT_TRUE(filter->GetUsedInputGraph());
  EXPECT_EQ(filter->GetGraphAccuracy(), 2e-6);
  EXPECT_EQ(GetDistances(filter), expected);
}

TEST_F(GraphInFieldData, IntegersOfAnyNameWillDo)
{
  // Types as created by numpy.
  auto copy = this->Copy();
  for (const char* name : { "DGG.Offsets", "DGG.Info" })
  {
    const vtkSmartPointer<vtkDataArray> original = copy->GetFieldData()->GetArray(name);
    for (const int type : { VTK_LONG, VTK_LONG_LONG, VTK_ID_TYPE })
    {
      const auto array = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(type));
      if (array->GetDataTypeSize() != 8)
      {
        continue;
      }
      array->SetName(name);
      array->SetNumberOfTuples(original->GetNumberOfTuples());
      std::copy_n(static_cast<const char*>(original->GetVoidPointer(0)),
        8 * original->GetNumberOfTuples(), static_cast<char*>(array->GetVoidPointer(0)));
      copy->GetFieldData()->AddArray(array);
      this->Filter->SetInputData(copy);
      this->Filter->Modified();
      ExpectSuccess(this->Filter);
      EXPECT_TRUE(this->Filter->GetUsedInputGraph()) << name << " " << type;
    }
  }
}

TEST_F(GraphInFieldData, AMovedPoint)
{
  auto copy = this->Copy();
  double p[3];
  copy->GetPoint(3, p);
  copy->GetPoints()->SetPoint(3, p[0], p[1], std::nextafter(p[2], 1.0));
  this->IsMoved = true;
  this->ExpectRebuilt(copy, { "out of date", "points or cells have changed" });
}

TEST_F(GraphInFieldData, DamageIsNotAnotherSurface)
{
  vtkNew<vtkDiscreteGeodesicGraph> graph;
  graph->SetAccuracy(Accuracy);
  graph->SetInputData(this->Surface);
  ExpectSuccess(graph);
  EXPECT_EQ(graph->GetInputGraphDamage(), "");
  auto copy = this->Copy();
  copy->GetFieldData()->GetArray("DGG.Lengths")->SetComponent(7, 0, 0.125);
  graph->SetInputData(copy);
  ExpectWarning(graph, { "is damaged" });
  EXPECT_NE(graph->GetInputGraphDamage().find("checksum"), std::string::npos);
  copy = this->Copy();
  copy->GetPoints()->SetPoint(7, 0.5, 0.5, 0.125);
  graph->SetInputData(copy);
  ExpectWarning(graph, { "out of date" });
  EXPECT_EQ(graph->GetInputGraphDamage(), "");
}

TEST_F(GraphInFieldData, APointMore)
{
  auto copy = this->Copy();
  copy->GetPoints()->InsertNextPoint(5.0, 5.0, 5.0);
  vtkNew<vtkDGGDistance> filter;
  filter->SetInputData(copy);
  filter->AddSourceId(40);
  ExpectWarning(filter, { "does not fit", "DGG.Offsets has 257 values", "257 points" });
}

TEST_F(GraphInFieldData, OtherTreatmentOfCoincidentPoints)
{
  // Two triangles with a seam.
  const Points points = { { { 0, 0, 0 } }, { { 1, 0, 0 } }, { { 0, 1, 0 } }, { { 1, 1, 0 } },
    { { 1, 0, 0 } }, { { 0, 1, 0 } } };
  auto surface = MakeSurface(points, { { 0, 1, 2 }, { 3, 5, 4 } });
  for (const bool merge : { false, true })
  {
    vtkNew<vtkDiscreteGeodesicGraph> graph;
    graph->SetInputData(surface);
    graph->SetMergeCoincidentPoints(merge);
    Listener mute(graph); // ignores the warning about the seam
    vtkNew<vtkDGGDistance> filter;
    filter->SetInputConnection(graph->GetOutputPort());
    filter->AddSourceId(0);
    filter->SetMergeCoincidentPoints(!merge);
    Listener listener(filter);
    filter->Update();
    EXPECT_EQ(listener.Errors, std::vector<std::string>());
    ASSERT_FALSE(listener.Warnings.empty());
    EXPECT_NE(
      listener.Warnings.back().find(merge ? "MergeCoincidentPoints on, but the filter has it off"
                                          : "MergeCoincidentPoints off, but the filter has it on"),
      std::string::npos)
      << listener.Warnings.back();
    EXPECT_FALSE(filter->GetUsedInputGraph());
    EXPECT_EQ(std::isnan(GetDistances(filter)[3]), merge);
    listener.Warnings.clear();
    filter->SetMergeCoincidentPoints(merge);
    filter->Update();
    EXPECT_EQ(listener.Warnings.size(), merge ? 0u : 1u); // about the seam
    EXPECT_TRUE(filter->GetUsedInputGraph());
    EXPECT_EQ(std::isnan(GetDistances(filter)[3]), !merge);
  }
}

TEST_F(GraphInFieldData, MissingArrays)
{
  for (const std::string& name : GetGraphArrayNames())
  {
    this->ExpectNoticed(
      [&](vtkFieldData* data) { data->RemoveArray(name.c_str()); }, name + " is missing");
  }
  // Without any array there is no graph and no warning.
  auto copy = this->Copy();
  copy->GetFieldData()->Initialize();
  vtkNew<vtkDGGDistance> filter;
  filter->SetAccuracy(Accuracy);
  filter->AddSourceId(40);
  filter->SetInputData(copy);
  ExpectSuccess(filter);
  EXPECT_FALSE(filter->GetUsedInputGraph());
  EXPECT_EQ(GetDistances(filter), this->Expected);
}

TEST_F(GraphInFieldData, TruncatedArrays)
{
  for (const std::string& name : GetGraphArrayNames())
  {
    for (const bool all : { false, true })
    {
      this->ExpectNoticed(
        [&](vtkFieldData* data) {
          vtkDataArray* array = data->GetArray(name.c_str());
          array->SetNumberOfTuples(all ? 0 : array->GetNumberOfTuples() - 1);
        },
        " has ");
    }
  }
}

TEST_F(GraphInFieldData, ArraysOfOtherTypes)
{
  const std::vector<std::pair<std::string, int>> types = { { "DGG.Offsets", VTK_INT },
    { "DGG.Offsets", VTK_DOUBLE }, { "DGG.Targets", VTK_ID_TYPE }, { "DGG.Targets", VTK_FLOAT },
    { "DGG.Targets", VTK_UNSIGNED_INT }, { "DGG.Lengths", VTK_INT }, { "DGG.Angles", VTK_DOUBLE },
    { "DGG.ArrivalAngles", VTK_INT }, { "DGG.Info", VTK_INT }, { "DGG.Info", VTK_DOUBLE } };
  for (const auto& nameAndType : types)
  {
    this->ExpectNoticed(
      [&](vtkFieldData* data) {
        const char* name = nameAndType.first.c_str();
        const auto array = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(nameAndType.second));
        array->DeepCopy(data->GetArray(name));
        array->SetName(name);
        data->AddArray(array);
      },
      nameAndType.first + " has the type ");
  }
  for (const std::string& name : GetGraphArrayNames())
  {
    this->ExpectNoticed(
      [&](vtkFieldData* data) {
        vtkNew<vtkStringArray> words;
        words->SetName(name.c_str());
        words->SetNumberOfValues(data->GetArray(name.c_str())->GetNumberOfTuples());
        data->AddArray(words);
      },
      name + " has the type ");
  }
  this->ExpectNoticed(
    [](vtkFieldData* data) {
      vtkDataArray* array = data->GetArray("DGG.Angles");
      const vtkIdType size = array->GetNumberOfTuples();
      array->SetNumberOfComponents(2);
      array->SetNumberOfTuples(size);
    },
    "DGG.Angles has the type float with 2 components");
  this->ExpectNoticed(
    [](vtkFieldData* data) {
      vtkNew<vtkSOADataArrayTemplate<float>> array; // not contiguous
      array->DeepCopy(data->GetArray("DGG.Lengths"));
      array->SetName("DGG.Lengths");
      data->AddArray(array);
    },
    "DGG.Lengths has the type");
}

TEST_F(GraphInFieldData, AlteredValues)
{
  const double NaN = std::numeric_limits<double>::quiet_NaN();
  vtkFieldData* data = this->Surface->GetFieldData();
  const struct
  {
    const char* Array;
    vtkIdType Index;
    double Value;
    const char* Part;
  } changes[] = {
    { "DGG.Targets", 17, 256, "leads to vertex 256 of 256" },
    { "DGG.Targets", 17, -1, "leads to vertex -1" },
    { "DGG.Targets", 0, 0, "own vertex" },
    { "DGG.Targets", 17, 2000000000, "2000000000" },
    { "DGG.Targets", 17, data->GetArray("DGG.Targets")->GetTuple1(18), "checksum" },
    { "DGG.Offsets", 0, 1, "offsets" },
    { "DGG.Offsets", 256, 1, "offsets" },
    { "DGG.Offsets", 100, 0, "offsets" },
    { "DGG.Offsets", 100, 1e15, "offsets" },
    { "DGG.Offsets", 100, -1e15, "offsets" },
    { "DGG.Lengths", 17, 0.0, "length" },
    { "DGG.Lengths", 17, -1.0, "length" },
    { "DGG.Lengths", 17, NaN, "length" },
    { "DGG.Lengths", 17, 0.5 * data->GetArray("DGG.Lengths")->GetTuple1(17), "checksum" },
    { "DGG.Angles", 2, NaN, "angle" },
    { "DGG.Angles", 2, 9.0, "sorted by angle" },
    { "DGG.ArrivalAngles", 2, NaN, "angle" },
    { "DGG.ArrivalAngles", 17, 0.25, "checksum" },
    { "DGG.Info", 0, 2, "has the format version 2" },
    { "DGG.Info", 0, 0, "has the format version 0" },
    { "DGG.Info", 1, 2, "its kind is 2" }, // 1 is the kind of a cloud
    { "DGG.Info", 2, 4, "construction is 4" },
    { "DGG.Info", 2, -1, "construction is -1" },
    { "DGG.Info", 3, 4.517329193108107e18, "checksum" }, // bits of an accuracy near 1e-6
    { "DGG.Info", 9, 1, "checksum" },
    { "DGG.Info", 11, 1, "checksum" },
  };
  for (const auto& change : changes)
  {
    SCOPED_TRACE(change.Array);
    this->ExpectNoticed(
      [&](vtkFieldData* arrays) {
        arrays->GetArray(change.Array)->SetComponent(change.Index, 0, change.Value);
      },
      change.Part);
  }
}

TEST_F(GraphInFieldData, ChangesInPlaceAreNoticed)
{
  vtkDataArray* lengths = this->Surface->GetFieldData()->GetArray("DGG.Lengths");
  const double original = lengths->GetComponent(0, 0);
  lengths->SetComponent(0, 0, 3.0 * original);
  lengths->Modified();
  ExpectWarning(this->Filter, { "checksum" });
  EXPECT_FALSE(this->Filter->GetUsedInputGraph());
  EXPECT_EQ(GetDistances(this->Filter), this->Expected);
  lengths->SetComponent(0, 0, original);
  lengths->Modified();
  ExpectSuccess(this->Filter);
  EXPECT_TRUE(this->Filter->GetUsedInputGraph());
  EXPECT_EQ(GetDistances(this->Filter), this->Expected);
}
