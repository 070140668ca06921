// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// The graph of a cloud in field data: files, other filters, damage, points that move.
#include "CloudTestTools.h"

#include "vtkDGGDistance.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"
#include "vtkTypeInt64Array.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLPolyDataWriter.h"

namespace dggtest
{
namespace
{
class CloudInFieldData : public ::testing::Test
{
protected:
  CloudInFieldData()
    : Cloud(MakeCloudWithGraph(MakeFlatPoints(16, 0.2)))
  {
    this->Distance->SetSourceIds({ 0 });
  }

  std::vector<double> Measure(vtkPolyData* cloud)
  {
    this->Distance->SetInputData(cloud);
    ExpectSuccess(this->Distance);
    EXPECT_TRUE(this->Distance->GetUsedInputGraph());
    return GetDistances(this->Distance);
  }

  std::string MakePath(const char* extension) const
  {
    const ::testing::TestInfo* test = ::testing::UnitTest::GetInstance()->current_test_info();
    return std::string(DGG_TEST_OUTPUT) + "/CloudInFieldData" + test->name() + extension;
  }

  /// Changes a copy of the cloud and expects an error that contains `parts`.
  void ExpectRefused(
    const std::function<void(vtkPolyData*)>& change, std::vector<std::string> parts)
  {
    vtkNew<vtkPolyData> changed;
    changed->DeepCopy(this->Cloud);
    change(changed);
    parts.push_back("vtkPointCloudDGG");
    this->Distance->SetInputData(changed);
    ExpectError(this->Distance, parts);
    this->Distance->Modified();
    ExpectError(this->Distance, parts); // reported again
    EXPECT_FALSE(this->Distance->GetUsedInputGraph());
  }

  static vtkDataArray* Get(vtkPolyData* cloud, const char* name)
  {
    return cloud->GetFieldData()->GetArray(name);
  }

  vtkSmartPointer<vtkPolyData> Cloud;
  vtkNew<vtkDGGDistance> Distance;
};
}

TEST_F(CloudInFieldData, SurvivesFiles)
{
  const std::vector<double> distances = this->Measure(this->Cloud);
  for (const int mode : { vtkXMLWriter::Ascii, vtkXMLWriter::Binary, vtkXMLWriter::Appended })
  {
    vtkNew<vtkXMLPolyDataWriter> writer;
    writer->SetFileName(this->MakePath(".vtp").c_str());
    writer->SetInputData(this->Cloud);
    writer->SetDataMode(mode);
    ASSERT_EQ(writer->Write(), 1);
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName(this->MakePath(".vtp").c_str());
    reader->Update();
    EXPECT_EQ(GetCloudBytes(reader->GetOutput()), GetCloudBytes(this->Cloud)) << mode;
    EXPECT_EQ(this->Measure(reader->GetOutput()), distances) << mode;
    EXPECT_EQ(GetComponents(reader->GetOutput()), GetComponents(this->Cloud));
  }
}

TEST_F(CloudInFieldData, PointsThatMoved)
{
  vtkNew<vtkTransform> transform;
  transform->Translate(1.0, 0.0, 0.0);
  vtkNew<vtkTransformPolyDataFilter> mover;
  mover->SetTransform(transform);
  mover->SetInputData(this->Cloud);
  mover->Update();
  this->ExpectRefused(
    [&](vtkPolyData* cloud) { cloud->SetPoints(mover->GetOutput()->GetPoints()); },
    { "is out of date: points have changed" });
  EXPECT_EQ(this->Measure(this->Cloud)[0], 0.0);
  this->Cloud->GetPoints()->SetPoint(9, 0.5, 0.5, 0.0);
  this->Cloud->GetPoints()->Modified();
  ExpectError(this->Distance,
    { "is out of date", "Compute the graph of these points with vtkPointCloudDGG" });
}

TEST_F(CloudInFieldData, CellsDoNotMatter)
{
  const std::vector<double> distances = this->Measure(this->Cloud);
  this->Cloud->SetPolys(MakeCells({ { 0, 1, 16 }, { 200, 201, 210 } }));
  EXPECT_EQ(this->Measure(this->Cloud), distances);
  this->Cloud->SetPolys(MakeCells({ { 0, 1, 999 } }));
  EXPECT_EQ(this->Measure(this->Cloud), distances);
}

TEST_F(CloudInFieldData, MissingArrays)
{
  for (const char* name : { "DGG.Offsets", "DGG.Targets", "DGG.Lengths", "DGG.Radii" })
  {
    this->ExpectRefused([&](vtkPolyData* cloud) { cloud->GetFieldData()->RemoveArray(name); },
      { "is damaged", name, "missing" });
  }
  // Without this array the graph is not detected.
  this->ExpectRefused([](vtkPolyData* cloud) { cloud->GetFieldData()->RemoveArray("DGG.Info"); },
    { "256 points but no polygons" });
  this->ExpectRefused([](vtkPolyData* cloud) { cloud->GetFieldData()->Initialize(); },
    { "256 points but no polygons" });
}

TEST_F(CloudInFieldData, TheGraphOfAMeshIsNoneOfACloud)
{
  // Points without polygons, with the graph of a mesh.
  const auto points = this->Cloud->GetPoints();
  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(points);
  vtkNew<vtkTypeInt64Array> info;
  info->SetName("DGG.Info");
  info->SetNumberOfTuples(12);
  info->Fill(0);
  info->SetTuple1(0, 1);
  cloud->GetFieldData()->AddArray(info);
  this->Distance->SetInputData(cloud);
  ExpectError(this->Distance, { "256 points but no polygons", "vtkPointCloudDGG" });
}
}
