// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Distances and a path on a point cloud: only the points of the file are used.
//
// Usage: CloudPath CLOUD.ply SOURCE_ID PATH.vtp
#include "vtkCellData.h"
#include "vtkDGGDistance.h"
#include "vtkDGGPath.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPLYReader.h"
#include "vtkPointCloudDGG.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkXMLPolyDataWriter.h"

#include <cstdlib>
#include <iostream>

namespace
{
/// The point that is farthest from the source; points that are not reached have NaN.
vtkIdType FindFarthest(vtkDataArray* distances, vtkIdType source)
{
  vtkIdType farthest = source;
  for (vtkIdType i = 0; i < distances->GetNumberOfTuples(); ++i)
  {
    farthest = distances->GetTuple1(i) > distances->GetTuple1(farthest) ? i : farthest;
  }
  return farthest;
}
}

int main(int argc, char* argv[])
{
  if (argc != 4)
  {
    std::cerr << "usage: " << argv[0] << " CLOUD.ply SOURCE_ID PATH.vtp\n";
    return 1;
  }
  char* end = nullptr;
  const vtkIdType source = std::strtoll(argv[2], &end, 10);
  if (end == argv[2] || *end != '\0')
  {
    std::cerr << argv[2] << ": not the number of a point\n";
    return 1;
  }
  vtkNew<vtkPLYReader> reader;
  reader->SetFileName(argv[1]);
  vtkNew<vtkPointCloudDGG> graph;
  graph->SetInputConnection(reader->GetOutputPort());
  vtkNew<vtkDGGDistance> distance;
  distance->SetInputConnection(graph->GetOutputPort());
  distance->AddSourceId(source);
  distance->Update();
  if (distance->GetErrorCode() != 0 || distance->GetOutput()->GetNumberOfPoints() == 0)
  {
    std::cerr << argv[1] << ": no distances from point " << source << "\n";
    return 1;
  }
  std::cout << distance->GetOutput()->GetNumberOfPoints() << " points, "
            << graph->GetNumberOfGraphEdges() << " edges, " << graph->GetNumberOfComponents()
            << " components\n";

  const vtkIdType farthest =
    FindFarthest(distance->GetOutput()->GetPointData()->GetScalars(), source);
  vtkNew<vtkDGGPath> path;
  path->SetInputConnection(graph->GetOutputPort());
  path->AddPair(source, farthest);
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputConnection(path->GetOutputPort());
  writer->SetFileName(argv[3]);
  const bool written = writer->Write() == 1;
  if (path->GetErrorCode() != 0 || !written)
  {
    std::cerr << argv[3] << ": not written\n";
    return 1;
  }
  vtkDataArray* lengths = path->GetOutput()->GetCellData()->GetArray("GraphLength");
  std::cout << "farthest is point " << farthest << ": " << lengths->GetTuple1(0) << " away\n";
  return 0;
}
