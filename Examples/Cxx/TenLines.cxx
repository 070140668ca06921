// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkExactGeodesicDistance.h"
#include "vtkNew.h"
#include "vtkPLYReader.h"
#include "vtkXMLPolyDataWriter.h"

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
  const bool written = writer->Write() == 1;
  return written && reader->GetErrorCode() + distance->GetErrorCode() == 0 ? 0 : 1;
}
