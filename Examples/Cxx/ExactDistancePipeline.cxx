// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// A complete small pipeline: read a mesh, compute distances, colour, render off-screen, save.
//
// Usage: ExactDistancePipeline MESH SOURCE_ID PICTURE.png
#include "vtkActor.h"
#include "vtkDGGOFFReader.h"
#include "vtkDataArray.h"
#include "vtkExactGeodesicDistance.h"
#include "vtkNew.h"
#include "vtkOBJReader.h"
#include "vtkPLYReader.h"
#include "vtkPNGWriter.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPolyDataReader.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSTLReader.h"
#include "vtkSmartPointer.h"
#include "vtkWindowToImageFilter.h"
#include "vtkXMLPolyDataReader.h"

#include "vtksys/SystemTools.hxx"

#include <cstdlib>
#include <iostream>
#include <string>

namespace
{
template <typename ReaderType>
vtkSmartPointer<vtkAlgorithm> MakeReader(const std::string& path)
{
  auto reader = vtkSmartPointer<ReaderType>::New();
  reader->SetFileName(path.c_str());
  return reader;
}

/// The reader for the extension of the file, or nullptr.
vtkSmartPointer<vtkAlgorithm> MakeReaderFor(const std::string& path)
{
  const std::string extension =
    vtksys::SystemTools::LowerCase(vtksys::SystemTools::GetFilenameLastExtension(path));
  if (extension == ".ply")
  {
    return MakeReader<vtkPLYReader>(path);
  }
  if (extension == ".obj")
  {
    return MakeReader<vtkOBJReader>(path);
  }
  if (extension == ".stl")
  {
    return MakeReader<vtkSTLReader>(path);
  }
  if (extension == ".vtp")
  {
    return MakeReader<vtkXMLPolyDataReader>(path);
  }
  if (extension == ".vtk")
  {
    return MakeReader<vtkPolyDataReader>(path);
  }
  if (extension == ".off")
  {
    return MakeReader<vtkDGGOFFReader>(path);
  }
  return nullptr;
}
}

int main(int argc, char* argv[])
{
  if (argc != 4)
  {
    std::cerr << "Usage: " << argv[0] << " MESH SOURCE_ID PICTURE.png\n";
    return EXIT_FAILURE;
  }

  // Read.
  vtkSmartPointer<vtkAlgorithm> reader = MakeReaderFor(argv[1]);
  if (!reader)
  {
    std::cerr << "error: " << argv[1] << ": known are .obj .off .ply .stl .vtk .vtp\n";
    return EXIT_FAILURE;
  }
  char* end = nullptr;
  const vtkIdType source = std::strtoll(argv[2], &end, 10);
  if (end == argv[2] || *end != '\0')
  {
    std::cerr << "error: " << argv[2] << ": not a point id\n";
    return EXIT_FAILURE;
  }

  // Distance from one point.
  vtkNew<vtkExactGeodesicDistance> distance;
  distance->SetInputConnection(reader->GetOutputPort());
  distance->AddSourceId(source);
  distance->Update();
  vtkDataArray* array = distance->GetOutput()->GetPointData()->GetArray("GeodesicDistance");
  if (distance->GetErrorCode() != 0 || !array)
  {
    return EXIT_FAILURE; // VTK has said why.
  }

  // Colour.
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(distance->GetOutputPort());
  mapper->SelectColorArray("GeodesicDistance");
  mapper->SetScalarModeToUsePointFieldData();
  mapper->SetScalarRange(array->GetRange());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);

  // Render off-screen.
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1.0, 1.0, 1.0);
  renderer->AddActor(actor);
  vtkNew<vtkRenderWindow> window;
  window->OffScreenRenderingOn();
  window->SetSize(800, 600);
  window->AddRenderer(renderer);
  renderer->ResetCamera();
  window->Render();

  // Save.
  vtkNew<vtkWindowToImageFilter> grabber;
  grabber->SetInput(window);
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(argv[3]);
  writer->SetInputConnection(grabber->GetOutputPort());
  writer->Write();
  if (writer->GetErrorCode() != 0)
  {
    return EXIT_FAILURE;
  }

  std::cout << array->GetNumberOfTuples() << " points, distances " << array->GetRange()[0] << " to "
            << array->GetRange()[1] << ", " << argv[3] << "\n";
  return EXIT_SUCCESS;
}
