// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Clouds that are distributed over several processes. Run under mpiexec.
#include "FilterTestTools.h"

#include "vtkDGGDistance.h"
#include "vtkGeodesicDistanceMatrix.h"
#include "vtkPointCloudDGG.h"

#include "vtkMultiProcessController.h"

using namespace dggtest;

//------------------------------------------------------------------------------
TEST(CloudInPieces, IsGathered)
{
  auto* controller = vtkMultiProcessController::GetGlobalController();
  const int here = controller->GetLocalProcessId();
  const int count = controller->GetNumberOfProcesses();
  const auto terrain = MakeTerrain(33);
  Points all;
  Points some;
  std::vector<std::size_t> ids;
  for (vtkIdType i = 0; i < terrain->GetNumberOfPoints(); ++i)
  {
    all.emplace_back();
    terrain->GetPoint(i, all.back().data());
    if (i * count / terrain->GetNumberOfPoints() == here)
    {
      some.push_back(all.back());
      ids.push_back(static_cast<std::size_t>(i));
    }
  }
  std::vector<double> found[2];
  std::vector<double> rows[2];
  for (const bool isAlone : { true, false })
  {
    vtkNew<vtkPointCloudDGG> graph;
    graph->SetInputData(MakeSourcePoints(isAlone ? all : some));
    graph->GenerateVerticesOn();
    vtkNew<vtkDGGDistance> distance;
    distance->SetInputConnection(graph->GetOutputPort());
    distance->SetSourceIds({ 40, 900 });
    if (isAlone)
    {
      graph->SetController(nullptr);
      distance->SetController(nullptr);
    }
    const Listener listener(distance);
    distance->UpdatePiece(isAlone ? 0 : here, isAlone ? 1 : count, 0);
    EXPECT_TRUE(listener.Errors.empty());
    EXPECT_EQ(distance->GetUsedInputGraph(), isAlone || here == 0);
    found[isAlone ? 0 : 1] = GetDistances(distance);
    EXPECT_EQ(distance->GetOutput()->GetNumberOfVerts(), 1);
    EXPECT_EQ(distance->GetOutput()->GetCell(0)->GetNumberOfPoints(),
      distance->GetOutput()->GetNumberOfPoints());
    vtkNew<vtkGeodesicDistanceMatrix> matrix;
    matrix->SetInputConnection(graph->GetOutputPort());
    matrix->SetController(distance->GetController());
    matrix->SetRowIds({ 3, 40, 900, 901, 1000 });
    matrix->UpdatePiece(isAlone ? 0 : here, isAlone ? 1 : count, 0);
    vtkDoubleArray* values = matrix->GetMatrix();
    rows[isAlone ? 0 : 1] = { values->Begin(), values->End() };
    ASSERT_EQ(rows[isAlone ? 0 : 1].size(), isAlone || here == 0 ? 25u : 0u);
  }
  if (here == 0)
  {
    EXPECT_EQ(rows[1], rows[0]);
  }
  ASSERT_EQ(found[1].size(), ids.size());
  for (std::size_t k = 0; k < ids.size(); ++k)
  {
    ASSERT_EQ(found[1][k], found[0][ids[k]]);
  }
}
