// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// A graph that all processes build together, and distances along it. Each process has one square of
// a strip, with global ids of points and cells.
//
// Usage: mpiexec -n 2 GraphInPieces
#include "vtkCellData.h"
#include "vtkDGGDistance.h"
#include "vtkDataArray.h"
#include "vtkDiscreteGeodesicGraph.h"
#include "vtkIdTypeArray.h"
#include "vtkMPIController.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <iostream>

namespace
{
constexpr int Size = 20;

int Run(int here, int count)
{
  vtkNew<vtkPlaneSource> square;
  square->SetResolution(Size, Size);
  square->SetOrigin(here, 0.0, 0.0);
  square->SetPoint1(here + 1.0, 0.0, 0.0);
  square->SetPoint2(here, 1.0, 0.0);
  square->Update();
  vtkPolyData* piece = square->GetOutput();
  vtkNew<vtkIdTypeArray> points;
  vtkNew<vtkIdTypeArray> cells;
  for (vtkIdType i = 0; i < piece->GetNumberOfPoints(); ++i)
  {
    const vtkIdType row = i / (Size + 1);
    points->InsertNextValue(row * (Size * count + 1) + Size * here + i % (Size + 1));
  }
  for (vtkIdType i = 0; i < piece->GetNumberOfCells(); ++i)
  {
    cells->InsertNextValue(here * piece->GetNumberOfCells() + i);
  }
  points->SetName("PointIds");
  cells->SetName("CellIds");
  piece->GetPointData()->SetGlobalIds(points);
  piece->GetCellData()->SetGlobalIds(cells);

  vtkNew<vtkDiscreteGeodesicGraph> graph;
  graph->SetInputData(piece);
  vtkNew<vtkDGGDistance> distance;
  distance->SetInputConnection(graph->GetOutputPort());
  distance->AddSourceId(0);
  distance->UpdatePiece(here, count, 0);

  vtkDataArray* array = distance->GetOutput()->GetPointData()->GetArray("GeodesicDistance");
  if (!array)
  {
    return 1;
  }
  std::cout << "process " << here << ": " << graph->GetNumberOfGraphEdges()
            << " edges, distances up to " << array->GetRange()[1] << "\n";
  return 0;
}
}

int main(int argc, char* argv[])
{
  vtkNew<vtkMPIController> controller;
  controller->Initialize(&argc, &argv);
  vtkMultiProcessController::SetGlobalController(controller);
  const int failed = Run(controller->GetLocalProcessId(), controller->GetNumberOfProcesses());
  vtkMultiProcessController::SetGlobalController(nullptr);
  controller->Finalize();
  return failed;
}
