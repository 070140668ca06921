// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkDGGMeshWriter: data that each format preserves, and input that it refuses.
#include "FilterTestTools.h"
#include "MeshDescription.h"

#include "vtkAbstractPolyDataReader.h"
#include "vtkDGGMeshWriter.h"
#include "vtkDGGOBJReader.h"
#include "vtkDGGOFFReader.h"
#include "vtkDGGPLYReader.h"
#include "vtkDGGSTLReader.h"
#include "vtkDGGXYZReader.h"
#include "vtkPCDReader.h"

#include "vtkErrorCode.h"

#include <filesystem>

namespace
{
template <typename ArrayType, typename T>
vtkSmartPointer<ArrayType> MakeArray(const char* name, int components, const std::vector<T>& values)
{
  auto array = vtkSmartPointer<ArrayType>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()) / components);
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  return array;
}

/// Returns a quadrangle and a triangle at large coordinates.
vtkSmartPointer<vtkPolyData> MakeMesh(int pointType = VTK_DOUBLE)
{
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataType(pointType);
  points->InsertNextPoint(512345.678, 5403210.987, 0.1);
  points->InsertNextPoint(512346.678, 5403210.987, 0.0);
  points->InsertNextPoint(512346.678, 5403211.987, 1e-30);
  points->InsertNextPoint(512345.678, 5403211.987, -7.0);
  mesh->SetPoints(points);
  vtkNew<vtkCellArray> polygons;
  polygons->InsertNextCell({ 0, 1, 2, 3 });
  polygons->InsertNextCell({ 2, 1, 0 });
  mesh->SetPolys(polygons);
  return mesh;
}

/// Returns a mesh with all kinds of arrays.
vtkSmartPointer<vtkPolyData> MakeRichMesh()
{
  vtkSmartPointer<vtkPolyData> mesh = MakeMesh();
  vtkPointData* points = mesh->GetPointData();
  points->AddArray(MakeArray<vtkDoubleArray, double>("Distance", 1, { 0.1, 2.0, 1e300, 4.0 }));
  points->AddArray(MakeArray<vtkIdTypeArray, vtkIdType>("near id", 1, { 0, -1, 2, 3 }));
  points->AddArray(MakeArray<vtkIdTypeArray, vtkIdType>("far id", 1, { 0, 1, 2, 1LL << 40 }));
  points->AddArray(MakeArray<vtkIntArray, int>("x", 2, { 1, 2, 3, 4, 5, 6, 7, 8 }));
  points->SetNormals(
    MakeArray<vtkDoubleArray, double>("N", 3, { 0, 0, 1, 0, 0, 1, 0, 0.6, 0.8, 0, 0, -0.1 }));
  points->SetTCoords(MakeArray<vtkDoubleArray, double>("T", 2, { 0, 0, 1, 0, 1, 1, 0, 0.1 }));
  points->SetScalars(
    MakeArray<vtkUnsignedCharArray, int>("Paint", 3, { 1, 2, 3, 0, 255, 128, 7, 8, 9, 5, 0, 0 }));
  mesh->GetCellData()->AddArray(MakeArray<vtkIntArray, int>("Label", 1, { 8, 9 }));
  mesh->GetCellData()->SetScalars(
    MakeArray<vtkUnsignedCharArray, int>("RGBA", 4, { 1, 2, 3, 4, 5, 6, 7, 8 }));
  return mesh;
}

class MeshWriter : public testing::Test
{
protected:
  MeshWriter()
    : Folder(std::filesystem::path(DGG_TEST_OUTPUT) / "MeshWriter" /
        testing::UnitTest::GetInstance()->current_test_info()->name())
  {
    std::filesystem::create_directories(this->Folder);
  }
  ~MeshWriter() override { std::filesystem::remove_all(this->Folder); }

  /// Writes the mesh and returns a description of the mesh that is read back.
  template <typename ReaderType>
  std::string RoundTrip(vtkPolyData* mesh, const std::string& name)
  {
    const std::string path = (this->Folder / name).string();
    this->Writer->SetInputData(mesh);
    this->Writer->SetFileName(path.c_str());
    EXPECT_EQ(this->Writer->Write(), 1);
    EXPECT_EQ(this->Writer->GetErrorCode(), vtkErrorCode::NoError);
    vtkNew<ReaderType> reader;
    reader->SetFileName(path.c_str());
    dggtest::ExpectSuccess(reader);
    return dggtest::Describe(reader->GetOutput());
  }

  void ExpectRefused(vtkPolyData* mesh, const std::string& name, const std::string& part)
  {
    const std::string path = (this->Folder / name).string();
    this->Writer->SetInputData(mesh);
    this->Writer->SetFileName(path.c_str());
    dggtest::Listener listener(this->Writer);
    EXPECT_EQ(this->Writer->Write(), 0);
    EXPECT_NE(this->Writer->GetErrorCode(), vtkErrorCode::NoError);
    ASSERT_EQ(listener.Errors.size(), 1u);
    EXPECT_NE(listener.Errors[0].find("Cannot write " + path), std::string::npos);
    EXPECT_NE(listener.Errors[0].find(part), std::string::npos) << listener.Errors[0];
    EXPECT_FALSE(std::filesystem::exists(path));
  }

  std::filesystem::path Folder;
  vtkNew<vtkDGGMeshWriter> Writer;
};

const char* const Points = "512345.678 5403210.987 0.1, 512346.678 5403210.987 0, 512346.678 "
                           "5403211.987 1e-30, 512345.678 5403211.987 -7 ";
const char* const Cells = "| polys 0 1 2 3, 2 1 0";
const char* const Vectors = " | active Normals double 0 0 1, 0 0 1, 0 0.6 0.8, 0 0 -0.1 "
                            "| active TCoords double 0 0, 1 0, 1 1, 0 0.1 "
                            "| active RGB unsigned char 1 2 3, 0 255 128, 7 8 9, 5 0 0";
}

TEST_F(MeshWriter, KeepsDigitsCellsAndArrays)
{
  vtkSmartPointer<vtkPolyData> mesh = MakeRichMesh();
  EXPECT_EQ(this->RoundTrip<vtkDGGOBJReader>(mesh, "a.OBJ"), std::string(Points) + Cells + Vectors);
  EXPECT_EQ(this->RoundTrip<vtkDGGOFFReader>(mesh, "a.off"),
    std::string(Points) + Cells + Vectors + " | cells active RGBA unsigned char 1 2 3 4, 5 6 7 8");
  EXPECT_EQ(this->RoundTrip<vtkDGGPLYReader>(mesh, "a.ply"),
    std::string(Points) + Cells + Vectors +
      " | Distance double 0.1, 2, 1e+300, 4 | near_id int 0, -1, 2, 3 "
      "| far_id double 0, 1, 2, 1099511627776 | x_0 int 1, 3, 5, 7 | x_1 int 2, 4, 6, 8 "
      "| cells active RGBA unsigned char 1 2 3 4, 5 6 7 8 | cells Label int 8, 9");
  EXPECT_EQ(
    this->RoundTrip<vtkDGGXYZReader>(mesh, "a.xyz"), std::string(Points) + "| verts 0, 1, 2, 3");
  const std::string cloud = this->RoundTrip<vtkPCDReader>(mesh, "a.pcd");
  EXPECT_EQ(cloud.find(std::string(Points) + "| verts 0, 1, 2, 3 | active Normals double"), 0u);
  EXPECT_NE(cloud.find("far_id long long 0, 1, 2, 1099511627776"), std::string::npos) << cloud;
}

TEST_F(MeshWriter, WritesFloatPointsAsTheyAre)
{
  vtkSmartPointer<vtkPolyData> mesh = MakeMesh(VTK_FLOAT);
  const std::string expected = dggtest::Describe(mesh);
  EXPECT_EQ(expected.substr(0, 6), "float ");
  EXPECT_EQ(this->RoundTrip<vtkDGGPLYReader>(mesh, "a.ply"), expected);
}

TEST_F(MeshWriter, WritesTriangles)
{
  const std::string polygons =
    this->RoundTrip<vtkDGGSTLReader>(MakeMesh(), "a.stl").substr(std::string(Points).size());
  EXPECT_EQ(std::count(polygons.begin(), polygons.end(), ','), 2) << polygons; // the quad is split
  for (const int type : { VTK_DOUBLE, VTK_FLOAT })
  {
    vtkSmartPointer<vtkPolyData> mesh = MakeMesh(type);
    vtkNew<vtkCellArray> triangles;
    triangles->InsertNextCell({ 0, 1, 2 });
    triangles->InsertNextCell({ 2, 3, 0 });
    mesh->SetPolys(triangles);
    EXPECT_EQ(this->RoundTrip<vtkDGGSTLReader>(mesh, "a.stl"), dggtest::Describe(mesh));
  }
}

TEST_F(MeshWriter, WritesLinesVertsAndStrips)
{
  vtkSmartPointer<vtkPolyData> mesh = MakeMesh(VTK_FLOAT);
  for (vtkIdType i = 0; i < 4; ++i)
  {
    const double p[] = { 1.0 * (i % 2), 1.0 * (i / 2), 0.0 };
    mesh->GetPoints()->SetPoint(i, p);
  }
  const std::string points = "0 0 0, 1 0 0, 0 1 0, 1 1 0 ";
  mesh->SetPolys(vtkNew<vtkCellArray>());
  vtkNew<vtkCellArray> strips;
  strips->InsertNextCell({ 0, 1, 2, 3 });
  mesh->SetStrips(strips);
  EXPECT_EQ(
    this->RoundTrip<vtkDGGPLYReader>(mesh, "a.ply"), "float " + points + "| polys 0 1 2, 2 1 3");
  vtkNew<vtkCellArray> verts;
  verts->InsertNextCell({ 3 });
  mesh->SetVerts(verts);
  EXPECT_EQ(
    this->RoundTrip<vtkDGGPLYReader>(mesh, "a.ply"), "float " + points + "| polys 0 1 2, 2 1 3");
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 0, 2 });
  mesh->SetLines(lines);
  const std::string all = points + "| verts 3 | lines 0 2 | polys 0 1 2, 2 1 3";
  EXPECT_EQ(this->RoundTrip<vtkDGGOBJReader>(mesh, "a.obj"), all);
  EXPECT_EQ(this->RoundTrip<vtkDGGOFFReader>(mesh, "a.off"), all);
  for (const char* name : { "lines.ply", "lines.stl", "lines.xyz", "lines.pcd" })
  {
    this->ExpectRefused(mesh, name, "the format cannot store lines");
  }
}

TEST_F(MeshWriter, WritesCellsOfAnySize)
{
  vtkSmartPointer<vtkPolyData> mesh = MakeMesh();
  mesh->GetPoints()->SetPoint(0, NAN, 0.0, 0.0);
  vtkNew<vtkCellArray> verts;
  verts->InsertNextCell({ 0, 1, 2 });
  mesh->SetVerts(verts);
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 3 });
  mesh->SetLines(lines);
  vtkNew<vtkCellArray> polygons;
  polygons->InsertNextCell({});
  polygons->InsertNextCell({ 0, 2 });
  polygons->InsertNextCell({ 2, 1, 0 });
  mesh->SetPolys(polygons);
  mesh->GetCellData()->SetScalars(MakeArray<vtkUnsignedCharArray, int>(
    "RGB", 3, { 1, 1, 1, 2, 2, 2, 3, 3, 3, 4, 4, 4, 5, 5, 5 }));
  const std::string points = "nan 0 0" + std::string(Points).substr(std::string(Points).find(','));
  const std::string cells = "| verts 0, 1, 2, 3 | lines 0 2 | polys 2 1 0";
  EXPECT_EQ(this->RoundTrip<vtkDGGOBJReader>(mesh, "a.obj"), points + cells);
  EXPECT_EQ(this->RoundTrip<vtkDGGOFFReader>(mesh, "a.off"),
    points + cells + " | cells active RGB unsigned char 1 1 1, 1 1 1, 1 1 1, 2 2 2, 4 4 4, 5 5 5");
  mesh->SetLines(nullptr);
  mesh->GetCellData()->Initialize();
  EXPECT_EQ(this->RoundTrip<vtkDGGPLYReader>(mesh, "a.ply"), points + "| lines 0 2 | polys 2 1 0");
  lines->InsertNextCell({ 0, 1, 2 });
  mesh->SetLines(lines);
  this->ExpectRefused(mesh, "refused.off", "polylines of more than two points. Write an OBJ file");
  for (const char* name : { "none.obj", "none.xyz" })
  {
    this->ExpectRefused(vtkNew<vtkPolyData>(), name, "the input has no points");
  }
}

TEST_F(MeshWriter, WarnsOfArrays)
{
  vtkSmartPointer<vtkPolyData> mesh = MakeMesh();
  vtkNew<vtkIdTypeArray> large;
  large->SetName("Large");
  large->SetNumberOfComponents(2);
  large->SetNumberOfTuples(mesh->GetNumberOfPoints());
  large->Fill(7);
  large->SetComponent(1, 1, -9007199254740992.0);
  mesh->GetPointData()->AddArray(large);
  vtkNew<vtkStringArray> names;
  names->SetName("Names");
  mesh->GetPointData()->AddArray(names);
  mesh->GetCellData()->AddArray(names);
  for (const auto& [name, warnings] : { std::pair("a.ply", 3u), { "a.pcd", 1u }, { "a.xyz", 0u } })
  {
    this->Writer->SetInputData(mesh);
    this->Writer->SetFileName((this->Folder / name).c_str());
    dggtest::Listener listener(this->Writer);
    EXPECT_EQ(this->Writer->Write(), 1);
    EXPECT_EQ(listener.Warnings.size(), warnings) << name;
  }
}

TEST_F(MeshWriter, RefusesWhatCannotBeWritten)
{
  vtkSmartPointer<vtkPolyData> mesh = MakeMesh();
  this->ExpectRefused(mesh, "a.txt", "the extension is unknown");
  this->ExpectRefused(mesh, "none/a.ply", "cannot be opened for writing");
  mesh->GetPointData()->AddArray(MakeArray<vtkIntArray, int>("Short", 1, { 1 }));
  this->ExpectRefused(mesh, "a.ply", "the point array Short has 1 values for 4 points");
  mesh = MakeMesh();
  mesh->GetPolys()->InsertNextCell({ 0, 1, 4 });
  for (const char* name : { "a.obj", "a.stl" })
  {
    this->ExpectRefused(mesh, name, "a cell has a point id that is out of range");
  }
  mesh->SetPolys(vtkNew<vtkCellArray>());
  this->ExpectRefused(mesh, "a.stl", "there are 0 triangles");
  this->Writer->SetFileName(nullptr);
  dggtest::Listener listener(this->Writer);
  EXPECT_EQ(this->Writer->Write(), 0);
  EXPECT_EQ(this->Writer->GetErrorCode(), vtkErrorCode::NoFileNameError);
}

TEST_F(MeshWriter, KeepsOlderFilesUntilTheEnd)
{
  const std::string before = this->RoundTrip<vtkDGGPLYReader>(MakeMesh(), "a.ply");
  vtkSmartPointer<vtkPolyData> large = MakeMesh(); // larger than a block of the writer
  large->GetPoints()->SetNumberOfPoints(300000);
  this->Writer->SetInputData(large);
  dggtest::ProgressWatch watch(this->Writer);
  watch.StopAt = 0.9;
  EXPECT_EQ(this->Writer->Write(), 0);
  EXPECT_EQ(this->Writer->GetErrorCode(), vtkErrorCode::NoError);
  vtkNew<vtkDGGPLYReader> reader;
  reader->SetFileName((this->Folder / "a.ply").c_str());
  dggtest::ExpectSuccess(reader);
  EXPECT_EQ(dggtest::Describe(reader->GetOutput()), before);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(this->Folder), {}), 1);
}
