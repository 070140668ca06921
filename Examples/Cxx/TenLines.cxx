// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkExactGeodesicDistance.h"
#include "vtkNew.h"
#include "vtkPLYReader.h"
#include "vtkPolyData.h"
#include "vtkXMLPolyDataWriter.h"

#include <iostream>

int main()
{
  vtkNew<vtkPLYReader> reader;
  reader->SetFileName("mesh.ply");
  vtkNew<vtkExactGeodesicDistance> distance;
  distance->SetInputConnection(reader->GetOutputPort());
  distance->AddSourceId(0);
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputConnection(distance->GetOutputPort());
  writer->SetFileName("distance.vtp");
  distance->Update();
  if (distance->GetOutput()->GetNumberOfPoints() == 0 || writer->Write() != 1)
  {
    std::cerr << "error: no distances of mesh.ply in distance.vtp\n";
    return 1;
  }
}
