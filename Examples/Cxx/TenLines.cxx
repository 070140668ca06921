// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGPLYReader.h"
#include "vtkExactGeodesicDistance.h"
#include "vtkNew.h"
#include "vtkXMLPolyDataWriter.h"

int main()
{
  vtkNew<vtkDGGPLYReader> reader;
  reader->SetFileName("mesh.ply");
  vtkNew<vtkExactGeodesicDistance> distance;
  distance->SetInputConnection(reader->GetOutputPort());
  distance->AddSourceId(0);
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputConnection(distance->GetOutputPort());
  writer->SetFileName("distance.vtp");
  writer->Write();
  return reader->GetErrorCode() || distance->GetErrorCode() || writer->GetErrorCode();
}
