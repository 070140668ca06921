// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A graph is passed in field data through filters and files. A damaged graph, or a graph of
/// another surface, is detected, reported and rebuilt, but never used.
#include "GraphTestTools.h"

#include "vtkDGGDistance.h"

#include "vtkSOADataArrayTemplate.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLPolyDataWriter.h"

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

  /// Expects one warning and a rebuilt graph with the same distances, and no warning in later
  /// updates.
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
    filter->SetSourceIds({ 41 });
    ExpectSuccess(filter); // reported once, built once
    EXPECT_EQ(filter->GetGraphBuildTime(), built);
  }

  /// Expects a warning and a rebuilt graph if the graph of the surface is changed by `damage`.
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
};

vtkSmartPointer<vtkPolyData> WriteAndRead(vtkPolyData* data, int mode, int compressor)
{
  const std::string path = std::string(DGG_TEST_OUTPUT) + "/GraphInFieldData.vtp";
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
  auto floats = MakeTerrain(7);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToFloat();
  points->DeepCopy(floats->GetPoints());
  floats->SetPoints(points);
  floats = MakeSurfaceWithGraph(floats, 2e-6);
  EXPECT_EQ(floats->GetFieldData()->GetArray("DGG.Lengths")->GetDataType(), VTK_DOUBLE);
  const std::pair<int, int> formats[] = { { vtkXMLWriter::Ascii, vtkXMLWriter::NONE },
    { vtkXMLWriter::Binary, vtkXMLWriter::ZLIB }, { vtkXMLWriter::Appended, vtkXMLWriter::LZ4 } };
  for (const auto& surface : { this->Surface, floats })
  {
    this->Filter->SetInputData(surface);
    ExpectSuccess(this->Filter);
    const std::vector<double> expected = GetDistances(this->Filter);
    for (const auto& [mode, compressor] : formats)
    {
      SCOPED_TRACE(mode);
      auto read = WriteAndRead(surface, mode, compressor);
      EXPECT_EQ(GetGraphBytes(read), GetGraphBytes(surface));
      this->Filter->SetInputData(read);
      ExpectSuccess(this->Filter);
      EXPECT_TRUE(this->Filter->GetUsedInputGraph());
      EXPECT_EQ(this->Filter->GetGraphBuildTime(), 0u);
      EXPECT_EQ(GetDistances(this->Filter), expected);
    }
  }
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

TEST_F(GraphInFieldData, ArraysOfOtherTypes)
{
  const auto replace = [&](vtkAbstractArray* other, const std::string& name) {
    this->ExpectNoticed(
      [&](vtkFieldData* data) {
        other->DeepCopy(data->GetArray(name.c_str()));
        other->SetName(name.c_str());
        data->AddArray(other);
      },
      name + " has the type ");
  };
  replace(vtkNew<vtkIntArray>(), "DGG.Offsets");
  replace(vtkNew<vtkDoubleArray>(), "DGG.Angles");
  replace(vtkNew<vtkSOADataArrayTemplate<float>>(), "DGG.Lengths"); // not contiguous
  this->ExpectNoticed(
    [](vtkFieldData* data) {
      vtkNew<vtkStringArray> words;
      words->SetName("DGG.Targets");
      words->SetNumberOfValues(data->GetArray("DGG.Targets")->GetNumberOfTuples());
      data->AddArray(words);
    },
    "DGG.Targets has the type ");
  this->ExpectNoticed(
    [](vtkFieldData* data) {
      vtkDataArray* array = data->GetArray("DGG.Angles");
      const vtkIdType size = array->GetNumberOfTuples();
      array->SetNumberOfComponents(2);
      array->SetNumberOfTuples(size);
    },
    "DGG.Angles has the type float with 2 components");
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
