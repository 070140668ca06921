// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Input of several processes: pieces of any kind, files, errors, blocks. Run under mpiexec; a
/// single process is valid, too.
#include "SeveralProcessesFixture.h"

#include "vtkDGGDistance.h"
#include "vtkDGGOFFReader.h"
#include "vtkExactGeodesicDistance.h"

#include "vtkMultiBlockDataSet.h"
#include "vtkSphereSource.h"
#include "vtkXMLPPolyDataReader.h"
#include "vtkXMLPolyDataWriter.h"

#include <fstream>

using namespace dggtest;

//------------------------------------------------------------------------------
TEST_F(SeveralProcesses, FewerPartsThanProcesses)
{
  vtkSmartPointer<vtkPolyData> part = vtkSmartPointer<vtkPolyData>::New();
  if (this->Here == this->Count - 1)
  {
    part = TakePart(this->Surface, Labels(this->Surface->GetNumberOfCells(), 0), 0);
  }
  const auto prepare = [](auto* filter) { filter->SetSourceIds({ 40 }); };
  const auto filter = this->Together<vtkDGGDistance>(part, prepare);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), part->GetNumberOfPoints());
  EXPECT_NE(filter->GetOutput()->GetPointData()->GetArray("GeodesicDistance"), nullptr);
}

//------------------------------------------------------------------------------
/// Only the first process reads the data.
TEST_F(SeveralProcesses, ReadersGiveOnePiece)
{
  vtkNew<vtkDGGOFFReader> reader;
  reader->SetFileName(DGG_TEST_DATA "/tetrahedron.off");
  vtkNew<vtkExactGeodesicDistance> filter;
  filter->SetInputConnection(reader->GetOutputPort());
  filter->SetSourceIds({ 0 });
  this->Update(filter);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), this->IsFirst() ? 4 : 0);
  if (this->Count == 1)
  {
    return;
  }
  // If the file is missing, no process waits for the first one.
  reader->SetFileName("none.off");
  const Listener silence(reader);
  const Listener listener(filter);
  this->Update(filter);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
}

//------------------------------------------------------------------------------
/// A plane in pieces of cells other than triangles, with verts and lines.
TEST_F(SeveralProcesses, PiecesOfQuadsAndStrips)
{
  for (const GridCells cells : { GridCells::Quads, GridCells::Strips })
  {
    const auto part = MakeGrid(10, 3, cells);
    MovePoints(part, [&](double* p) {
      p[1] = p[1] + 3.0 * this->Here;
      p[2] = 0.0;
    });
    part->SetVerts(MakeCells({ { 1 }, { 5 } }));
    part->SetLines(MakeCells({ { 0, 7, 3 } }));
    const auto prepare = [](auto* filter) {
      filter->SetSourceData(MakeSourcePoints({ { { 2.5, 0.5, 0.0 } } }));
    };
    const auto filter = this->Together<vtkExactGeodesicDistance>(part, prepare);
    const auto distances = GetDistances(filter);
    ASSERT_EQ(distances.size(), static_cast<std::size_t>(part->GetNumberOfPoints()));
    for (vtkIdType i = 0; i < part->GetNumberOfPoints(); ++i)
    {
      const double* p = part->GetPoint(i);
      EXPECT_NEAR(distances[i], std::hypot(p[0] - 2.5, p[1] - 0.5), 1e-12);
    }
    EXPECT_EQ(filter->GetOutput()->GetNumberOfCells(), part->GetNumberOfCells());
  }
}

//------------------------------------------------------------------------------
TEST_F(SeveralProcesses, PiecesOfASource)
{
  vtkNew<vtkSphereSource> sphere; // its pieces differ by rounding error on their rims
  sphere->SetThetaResolution(40);
  sphere->SetPhiResolution(30);
  vtkNew<vtkExactGeodesicDistance> filter;
  filter->SetInputConnection(sphere->GetOutputPort());
  filter->SetSourceData(MakeSourcePoints({ { { 0.5, 0.0, 0.0 } } }));
  this->Update(filter);
  if (this->IsFirst())
  {
    EXPECT_EQ(GetReported(filter, "NumberOfBoundaryEdges"), 0);
    EXPECT_EQ(GetReported(filter, "Genus"), 0);
    EXPECT_EQ(GetReported(filter, "NumberOfComponents"), 1);
  }
}

//------------------------------------------------------------------------------
/// Four pieces in a file, of which a process may have several adjacent ones.
TEST_F(SeveralProcesses, FilesOfMorePieces)
{
  const std::string base =
    std::string(DGG_TEST_OUTPUT) + "/FourPieces" + std::to_string(this->Count);
  if (this->IsFirst())
  {
    std::ofstream file(base + ".pvtp");
    file << "<VTKFile type=\"PPolyData\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
            "<PPolyData GhostLevel=\"0\">\n"
            "<PPointData><PDataArray type=\"Int64\" Name=\"Whole\"/></PPointData>\n"
            "<PPoints><PDataArray type=\"Float64\" NumberOfComponents=\"3\"/></PPoints>\n";
    for (int i = 0; i < 4; ++i)
    {
      const std::string name = base + "_" + std::to_string(i) + ".vtp";
      vtkNew<vtkXMLPolyDataWriter> writer;
      writer->SetFileName(name.c_str());
      writer->SetInputData(TakePart(this->Surface, LabelRandomly(this->Surface, 4, 13), i));
      writer->Write();
      file << "<Piece Source=\"" << name.substr(name.rfind('/') + 1) << "\"/>\n";
    }
    file << "</PPolyData>\n</VTKFile>\n";
  }
  this->Controller->Barrier();
  vtkNew<vtkXMLPPolyDataReader> reader;
  reader->SetFileName((base + ".pvtp").c_str());
  vtkNew<vtkExactGeodesicDistance> filter;
  filter->SetInputConnection(reader->GetOutputPort());
  filter->SetSourceData(MakeSources());
  filter->MergeCoincidentPointsOn();
  this->Update(filter);
  const auto alone = Alone<vtkExactGeodesicDistance>(
    this->Surface, [](vtkExactGeodesicDistance* other) { other->SetSourceData(MakeSources()); });
  ExpectArray(filter->GetOutput(), alone->GetOutput(), "GeodesicDistance", 1e-12);
}

//------------------------------------------------------------------------------
/// If any process fails, all processes report the error and continue together.
TEST_F(SeveralProcesses, ErrorsOfOneProcess)
{
  if (this->Count == 1)
  {
    GTEST_SKIP() << "the test needs several processes";
  }
  const auto part = this->TakeStrip(this->Surface);
  vtkNew<vtkPolyData> bad;
  const auto sources = MakeSources();
  vtkNew<vtkDGGDistance> filter;
  filter->SetInputData(part);
  filter->SetSourceData(sources);
  const auto expectError = [&](const char* text) {
    const Listener listener(filter);
    this->Update(filter);
    ASSERT_EQ(listener.Errors.size(), 1u);
    EXPECT_NE(listener.Errors[0].find(text), std::string::npos) << listener.Errors[0];
    EXPECT_NE(filter->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError));
    ExpectEmptyOutput(filter);
  };
  for (const bool isMissing : { true, false })
  {
    bad->DeepCopy(part);
    if (this->Here == this->Count - 1 && isMissing)
    {
      const vtkIdType cell[3] = { 0, 1, 1000000 };
      bad->GetPolys()->InsertNextCell(3, cell);
    }
    else if (this->Here == this->Count - 1)
    {
      bad->GetPoints()->SetPoint(0, std::nan(""), 0.0, 0.0);
    }
    filter->SetInputData(bad);
    expectError(isMissing ? "refers to point 1000000" : "not finite");
  }
  filter->SetInputData(part);
  filter->SetGatherLimit(this->IsFirst() ? 100 : 1000000);
  expectError("GatherLimit of 100");
  filter->SetGatherLimit(this->IsFirst() ? 1000000 : 100);
  filter->SetMemoryLimit(1000);
  expectError("Gathering the pieces");
  filter->SetMemoryLimit(0);
  filter->SetProjectionTolerance(-1.0);
  expectError("ProjectionTolerance");
  filter->SetProjectionTolerance(0.01);
  filter->SetController(nullptr);
  expectError("pieces is requested");
  filter->SetController(this->Controller);
  filter->UpdatePiece(0, this->Count + 1, 0);
  EXPECT_NE(filter->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError));

  // The first process requests an abort.
  ProgressWatch watch(filter);
  watch.StopAt = this->IsFirst() ? 0.3 : 2.0;
  filter->SetAccuracy(0.02);
  this->Update(filter);
  EXPECT_EQ(filter->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError));
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  watch.StopAt = 2.0;
  filter->SetAbortExecute(0);
  filter->Modified();
  this->Update(filter);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), part->GetNumberOfPoints());
}

//------------------------------------------------------------------------------
TEST_F(SeveralProcesses, GlobalIdsInTwoPlaces)
{
  if (this->Count == 1)
  {
    GTEST_SKIP() << "the test needs several processes";
  }
  const auto part = this->TakeStrip(this->Surface, PartIds::Global);
  vtkDataArray* ids = part->GetPointData()->GetGlobalIds();
  for (vtkIdType i = 0; i < ids->GetNumberOfTuples(); ++i)
  {
    ids->SetTuple1(i, static_cast<double>(i)); // ids within this process
  }
  vtkNew<vtkDGGDistance> filter;
  filter->SetInputData(part);
  filter->SetSourceIds({ 0 });
  const Listener listener(filter);
  this->Update(filter);
  ASSERT_EQ(listener.Errors.size(), 1u);
  EXPECT_NE(listener.Errors[0].find("have the global id"), std::string::npos);
}

//------------------------------------------------------------------------------
/// Blocks that have a piece in each process.
TEST_F(SeveralProcesses, BlocksInParts)
{
  vtkNew<vtkMultiBlockDataSet> whole;
  vtkNew<vtkMultiBlockDataSet> part;
  for (unsigned int block = 0; block < 3; ++block)
  {
    const auto surface = MakeTerrain(15 + 4 * static_cast<int>(block));
    MovePoints(surface, [&](double* p) { p[0] = p[0] + block; });
    whole->SetBlock(block, surface);
    // Only the first process has a piece of the second block.
    part->SetBlock(block,
      block != 1          ? this->TakeStrip(surface).Get()
        : this->IsFirst() ? TakePart(surface, Labels(surface->GetNumberOfCells(), 0), 0).Get()
                          : nullptr);
  }
  const auto prepare = [](auto* filter) {
    filter->SetSourceData(MakeSourcePoints({ { { 0.3, 0.5, GetTerrainHeight(0.3, 0.5) } },
      { { 2.8, 0.5, GetTerrainHeight(0.8, 0.5) } } }));
    filter->SetUnreachedValue(-1.0);
  };
  vtkNew<vtkDGGDistance> alone;
  alone->SetController(nullptr);
  alone->SetInputDataObject(whole);
  prepare(alone.Get());
  alone->Update();
  const auto filter = this->Together<vtkDGGDistance>(part, prepare);
  auto* expected = vtkMultiBlockDataSet::SafeDownCast(alone->GetOutputDataObject(0));
  auto* output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  ASSERT_NE(output, nullptr);
  for (unsigned int block = 0; block < 3; ++block)
  {
    auto* leaf = vtkPolyData::SafeDownCast(output->GetBlock(block));
    EXPECT_EQ(leaf != nullptr, block != 1 || this->IsFirst());
    if (leaf)
    {
      ExpectArray(leaf, vtkPolyData::SafeDownCast(expected->GetBlock(block)), "GeodesicDistance",
        FloatTolerance);
    }
  }
  // Each process runs separately, with the same pieces.
  filter->SetSourceData(MakeSourcePoints({ { { (this->Here + 0.5) / this->Count, 0.5, 0.0 } } }));
  filter->SetProjectionTolerance(0.5);
  filter->Update();
  output = vtkMultiBlockDataSet::SafeDownCast(filter->GetOutputDataObject(0));
  EXPECT_EQ(GetNumberOfReached(vtkPolyData::SafeDownCast(output->GetBlock(0))),
    vtkPolyData::SafeDownCast(part->GetBlock(0))->GetNumberOfPoints());
}
