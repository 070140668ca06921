// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Loops around handles and through random points on every mesh of the folder DGG_EXTRA_DATA.

#include "ExtraMeshes.h"
#include "LoopTestTools.h"
#include "MeshFile.h"
#include "PathChecks.h"

#include "dggHandleLoops.h"

#include <chrono>
#include <iostream>

using namespace dggtest;

namespace
{
constexpr int NumberOfPoints = 6;
constexpr double Accuracy = 0.02;
/// Largest number of triangles of meshes on which geodesics are checked exactly.
constexpr vtkIdType MostTriangles = 30000;

class ExtraLoops : public testing::TestWithParam<std::string>
{
protected:
  void SetUp() override
  {
    this->Surface = ReadPolyData(GetParam());
    ASSERT_GT(this->Surface->GetNumberOfPolys(), 0) << "cannot read " << GetParam();
    this->Filter->SetInputData(this->Surface);
    this->Filter->SetAccuracy(Accuracy);
  }

  /// Updates the filter and returns its errors; warnings about defects of these meshes are ignored.
  std::vector<std::string> Update()
  {
    const Listener listener(this->Filter);
    this->Filter->Update();
    return listener.Errors;
  }

  /// Returns the length that faces without area may add; 0 on other meshes.
  double GetSlack()
  {
    return 10.0 * GetReported(this->Filter, "NumberOfDegenerateFaces") *
      GetReported(this->Filter, "Mollification");
  }

  void ExpectLoops(const std::vector<LoopLine>& loops)
  {
    for (const LoopLine& loop : loops)
    {
      SCOPED_TRACE(loop.Loop);
      ExpectOnSurface(loop.Line, this->Surface, this->GetSlack());
      EXPECT_GT(loop.Line.Length, 0.0);
      EXPECT_LE(loop.Angle, vtkMath::Pi());
    }
  }

  vtkSmartPointer<vtkPolyData> Surface;
  vtkNew<vtkDGGLoop> Filter;
};

TEST_P(ExtraLoops, AroundHandles)
{
  this->Filter->SetModeToAroundHandles();
  const auto start = std::chrono::steady_clock::now();
  const auto errors = this->Update();
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  if (GetReported(this->Filter, "NumberOfNonManifoldEdges") > 0)
  {
    ASSERT_EQ(errors.size(), 1u);
    EXPECT_NE(errors[0].find("more than two triangles"), std::string::npos);
    return;
  }
  EXPECT_EQ(errors, std::vector<std::string>());
  const auto loops = GetLoops(this->Filter);
  std::cout << loops.size() << " loops around handles in " << time.count() << " s\n";
  if (GetReported(this->Filter, "NumberOfComponents") == 1 &&
    GetReported(this->Filter, "Orientable") == 1 &&
    GetReported(this->Filter, "NumberOfNonManifoldVertices") == 0)
  {
    const double boundaries = GetReported(this->Filter, "NumberOfBoundaryLoops");
    EXPECT_EQ(static_cast<double>(loops.size()),
      2 * GetReported(this->Filter, "Genus") + std::max(boundaries - 1.0, 0.0));
  }
  this->ExpectLoops(loops);
}

/// Loops are geodesics at vertices as well, where they may turn around a corner.
TEST_P(ExtraLoops, HandlesAreGeodesics)
{
  const MeshArrays arrays = ToArrays(this->Surface);
  dgg::SurfaceMesh mesh;
  const dgg::Status status = dgg::SurfaceMesh::FromPoints(arrays.Points.data(),
    static_cast<dgg::Offset>(arrays.GetNumberOfVertices()), arrays.Triangles.data(),
    static_cast<dgg::Offset>(arrays.GetNumberOfFaces()), mesh);
  ASSERT_TRUE(status.IsOk()) << status.GetMessage();
  if (mesh.GetNumberOfFaces() > MostTriangles || mesh.GetNumberOfDegenerateFaces() > 0)
  {
    GTEST_SKIP() << "too large, or with faces of no area";
  }
  std::vector<dgg::FoundLoop> loops;
  if (dgg::FindHandleLoops(mesh, {}, loops).IsOk())
  {
    for (const dgg::FoundLoop& loop : loops)
    {
      ExpectLocallyShortest(mesh, loop.Loop, true);
    }
  }
}

TEST_P(ExtraLoops, ThroughPoints)
{
  std::mt19937 random(4711);
  std::uniform_int_distribution<vtkIdType> ids(0, this->Surface->GetNumberOfPoints() - 1);
  for (int i = 0; i < NumberOfPoints; ++i)
  {
    this->Filter->AddPointId(ids(random));
  }
  std::size_t found[2] = { 0, 0 };
  for (const bool taut : { false, true })
  {
    this->Filter->SetTaut(taut);
    const auto start = std::chrono::steady_clock::now();
    EXPECT_EQ(this->Update(), std::vector<std::string>());
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    const auto loops = GetLoops(this->Filter);
    found[taut ? 1 : 0] = loops.size();
    this->ExpectLoops(loops);
    for (const LoopLine& loop : loops)
    {
      EXPECT_TRUE(taut || loop.Line.PointIds.front() == this->Filter->GetPointId(loop.Loop));
      EXPECT_TRUE(!taut || loop.Kinked == 0);
    }
    std::cout << time.count() << " s; ";
  }
  std::cout << "of " << NumberOfPoints << " points, " << found[0] << " have a loop, " << found[1]
            << " a taut one\n";
}

TEST_P(ExtraLoops, RopesAndTapes)
{
  if (this->Surface->GetNumberOfPolys() > MostTriangles)
  {
    GTEST_SKIP() << "too large";
  }
  std::mt19937 random(1713);
  std::uniform_int_distribution<vtkIdType> ids(0, this->Surface->GetNumberOfPoints() - 1);
  this->Filter->SetModeToRope();
  this->Filter->SetTapeWidth(0.05 * this->Surface->GetLength());
  for (int trial = 0; trial < 3; ++trial)
  {
    this->Filter->RemoveAllPointIds();
    for (int i = 0; i < NumberOfPoints; ++i)
    {
      this->Filter->AddPointId(ids(random));
    }
    for (const bool taut : { false, true })
    {
      this->Filter->SetTaut(taut);
      EXPECT_EQ(this->Update(), std::vector<std::string>());
      this->ExpectLoops(GetLoops(this->Filter));
      for (const LoopLine& rim : GetRims(this->Filter))
      {
        ExpectOnSurface(rim.Line, this->Surface, this->GetSlack());
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Real, ExtraLoops, testing::ValuesIn(FindExtraMeshes()), NameExtraMesh);
}
