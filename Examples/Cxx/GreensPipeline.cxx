// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// What a unit source at a point of a mesh does everywhere else, and how far all points are from it
// by the biharmonic distance, which is smoother than the geodesic one: one filter after the other,
// and a file with both arrays.
//
// Usage: GreensPipeline MESH.ply POINT OUTPUT.vtp
#include "vtkBiharmonicDistance.h"
#include "vtkDataArray.h"
#include "vtkDiscreteGreensFunction.h"
#include "vtkNew.h"
#include "vtkPLYReader.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkXMLPolyDataWriter.h"

#include <cstdlib>
#include <iostream>

int main(int argc, char* argv[])
{
  if (argc != 4)
  {
    std::cerr << "Usage: " << argv[0] << " MESH.ply POINT OUTPUT.vtp\n";
    return EXIT_FAILURE;
  }
  char* end = nullptr;
  const long point = std::strtol(argv[2], &end, 10);
  if (end == argv[2] || *end != '\0')
  {
    std::cerr << "error: " << argv[2] << ": not the number of a point\n";
    return EXIT_FAILURE;
  }
  vtkNew<vtkPLYReader> reader;
  reader->SetFileName(argv[1]);
  reader->Update();
  if (reader->GetOutput()->GetNumberOfPoints() == 0)
  {
    std::cerr << "error: " << argv[1] << ": no points\n";
    return EXIT_FAILURE;
  }

  vtkNew<vtkDiscreteGreensFunction> greens;
  greens->SetInputConnection(reader->GetOutputPort());
  greens->AddSourceId(point);
  vtkNew<vtkBiharmonicDistance> distance; // passes on the array of the filter before it
  distance->SetInputConnection(greens->GetOutputPort());
  distance->AddSourceId(point);
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputConnection(distance->GetOutputPort());
  writer->SetFileName(argv[3]);
  distance->Update();
  vtkPointData* data = distance->GetOutput()->GetPointData();
  vtkDataArray* function = data->GetArray("GreensFunction");
  vtkDataArray* distances = data->GetArray("BiharmonicDistance");
  if (!function || !distances || writer->Write() != 1)
  {
    return EXIT_FAILURE; // VTK has said why.
  }
  std::cout << "Green's function from " << function->GetRange()[0] << " to "
            << function->GetRange()[1] << ", biharmonic distance up to " << distances->GetRange()[1]
            << "\n";
  return EXIT_SUCCESS;
}
