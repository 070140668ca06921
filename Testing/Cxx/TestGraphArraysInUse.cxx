// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The arrays of a graph are public: any code may empty or replace them between updates. Filters
/// that use or built the graph never access released memory.
#include "GraphTestTools.h"

#include "vtkDGGDistance.h"
#include "vtkGeodesicDistanceMatrix.h"

#include "vtkCallbackCommand.h"
#include "vtkTypeInt32Array.h"

#include <sstream>

using namespace dggtest;

namespace
{
using Change = std::function<void(vtkFieldData*)>;

/// Returns changes that release the memory of arrays without notification.
std::vector<std::pair<std::string, Change>> GetChanges()
{
  std::vector<std::pair<std::string, Change>> changes;
  for (const std::string& name : GetGraphArrayNames())
  {
    changes.emplace_back(name + " initialized",
      [=](vtkFieldData* data) { data->GetArray(name.c_str())->Initialize(); });
    changes.emplace_back(
      name + " shorter", [=](vtkFieldData* data) { data->GetArray(name.c_str())->Resize(3); });
    changes.emplace_back(name + " longer", [=](vtkFieldData* data) {
      vtkDataArray* array = data->GetArray(name.c_str());
      array->SetNumberOfTuples(5 * array->GetNumberOfTuples());
    });
  }
  changes.emplace_back("other memory", [](vtkFieldData* data) {
    auto* targets = vtkTypeInt32Array::SafeDownCast(data->GetArray("DGG.Targets"));
    const vtkIdType size = targets->GetNumberOfValues();
    auto* values = new vtkTypeInt32[size];
    std::fill_n(values, size, 1 << 30);
    targets->SetArray(values, size, 0, vtkTypeInt32Array::VTK_DATA_ARRAY_DELETE);
  });
  changes.emplace_back("all gone", [](vtkFieldData* data) { data->Initialize(); });
  return changes;
}

std::string Print(vtkObject* object)
{
  std::ostringstream os;
  object->Print(os);
  return os.str();
}

/// Calls a function whenever an event is invoked.
class Reaction
{
public:
  Reaction(vtkObject* subject, unsigned long event, const std::function<void()>& action)
    : Action(action)
  {
    this->Command->SetCallback(
      [](vtkObject*, unsigned long, void* self, void*) { static_cast<Reaction*>(self)->Action(); });
    this->Command->SetClientData(this);
    subject->AddObserver(event, this->Command);
  }

private:
  std::function<void()> Action;
  vtkNew<vtkCallbackCommand> Command;
};

class GraphArraysInUse : public ::testing::Test
{
protected:
  void SetUp() override
  {
    this->Graph->SetInputData(this->Terrain);
    this->Graph->SetAccuracy(0.05);
    this->Distance->SetInputConnection(this->Graph->GetOutputPort());
    this->Distance->AddSourceId(40);
    this->Matrix->SetInputConnection(this->Graph->GetOutputPort());
    this->Matrix->SetRowIds({ 0, 40 });
    this->Update();
    this->Expected = GetDistances(this->Distance);
  }

  void Update()
  {
    ExpectSuccess(this->Distance);
    ExpectSuccess(this->Matrix);
    EXPECT_TRUE(this->Distance->GetUsedInputGraph());
  }

  vtkFieldData* GetArrays() { return this->Graph->GetOutput()->GetFieldData(); }

  vtkSmartPointer<vtkPolyData> Terrain = MakeTerrain(16);
  vtkNew<vtkDiscreteGeodesicGraph> Graph;
  vtkNew<vtkDGGDistance> Distance;
  vtkNew<vtkGeodesicDistanceMatrix> Matrix;
  std::vector<double> Expected;
};
}

TEST_F(GraphArraysInUse, GettersReportWhatWas)
{
  const vtkIdType edges = this->Graph->GetNumberOfGraphEdges();
  const double degree = this->Graph->GetMeanDegree();
  const vtkTypeUInt64 size = this->Graph->GetMemorySize();
  const vtkTypeUInt64 searched = this->Distance->GetMemorySize();
  for (const auto& change : GetChanges())
  {
    SCOPED_TRACE(change.first);
    change.second(this->GetArrays());
    EXPECT_EQ(this->Graph->GetNumberOfGraphEdges(), edges);
    EXPECT_EQ(this->Graph->GetMeanDegree(), degree);
    EXPECT_EQ(this->Graph->GetMemorySize(), size);
    EXPECT_EQ(this->Distance->GetNumberOfGraphEdges(), edges);
    EXPECT_EQ(this->Distance->GetMemorySize(), searched);
    EXPECT_EQ(this->Distance->GetGraphAccuracy(), 0.05);
    EXPECT_TRUE(this->Distance->GetGraphIsGuaranteed());
    EXPECT_EQ(this->Matrix->GetNumberOfGraphEdges(), edges);
    EXPECT_GT(this->Matrix->GetMemorySize(), size);
    const std::string line = "NumberOfGraphEdges: " + std::to_string(edges) + "\n";
    EXPECT_NE(Print(this->Graph).find(line), std::string::npos);
    EXPECT_NE(Print(this->Distance).find(line), std::string::npos);
    EXPECT_NE(Print(this->Matrix).find(line), std::string::npos);
    this->Graph->ReleaseGraph();
    this->Graph->Modified();
    this->Update();
    ASSERT_EQ(GetDistances(this->Distance), this->Expected);
  }
}

TEST_F(GraphArraysInUse, ALaterUpdateNoticesAndBuildsAnother)
{
  for (const auto& change : GetChanges())
  {
    SCOPED_TRACE(change.first);
    auto surface = MakeSurfaceWithGraph(this->Terrain, 0.05);
    vtkNew<vtkDGGDistance> distance;
    distance->SetInputData(surface);
    distance->SetAccuracy(0.05);
    distance->AddSourceId(40);
    ExpectSuccess(distance);
    EXPECT_TRUE(distance->GetUsedInputGraph());
    change.second(surface->GetFieldData());
    // Observers of the warning must not see the old graph, whose arrays are already released.
    std::string seen;
    const Reaction reaction(distance, vtkCommand::WarningEvent, [&] { seen = Print(distance); });
    distance->Modified();
    const Listener listener(distance);
    distance->Update();
    EXPECT_EQ(listener.Errors, std::vector<std::string>());
    EXPECT_FALSE(distance->GetUsedInputGraph());
    EXPECT_EQ(GetDistances(distance), this->Expected);
    if (change.first != "all gone") // a missing graph causes no warning
    {
      EXPECT_EQ(listener.Warnings.size(), 1u);
      EXPECT_NE(seen.find("NumberOfGraphEdges: 0\n"), std::string::npos) << seen;
    }
  }
}

TEST_F(GraphArraysInUse, TheFilterThatMadeItBuildsItAgain)
{
  for (const auto& change : GetChanges())
  {
    SCOPED_TRACE(change.first);
    const vtkMTimeType built = this->Graph->GetGraphBuildTime();
    const vtkIdType arrays = this->GetArrays()->GetNumberOfArrays();
    change.second(this->GetArrays());
    const bool isGone = this->GetArrays()->GetNumberOfArrays() < arrays;
    this->Graph->Modified();
    this->Update();
    EXPECT_EQ(this->Graph->GetGraphBuildTime() > built, !isGone); // the filter still has the arrays
    EXPECT_EQ(GetDistances(this->Distance), this->Expected);
  }
}
