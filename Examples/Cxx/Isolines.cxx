// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Exact isolines of the distance from a point, the ridges where shortest paths of two sides meet,
// and the bands between the lines: a picture of them.
//
// Usage: Isolines MESH.ply NUMBER_OF_LINES PICTURE.png
#include "vtkActor.h"
#include "vtkApolloniusIsolines.h"
#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkExactGeodesicDistance.h"
#include "vtkLookupTable.h"
#include "vtkNew.h"
#include "vtkPLYReader.h"
#include "vtkPNGWriter.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkWindowToImageFilter.h"

#include <cstdlib>
#include <iostream>

namespace
{
/// From light near the source to dark far away.
void AddBands(vtkRenderer* renderer, vtkApolloniusIsolines* isolines, int number)
{
  vtkNew<vtkLookupTable> colours;
  colours->SetNumberOfTableValues(number + 1);
  colours->SetTableRange(0.0, number);
  for (int i = 0; i <= number; ++i)
  {
    const double t = static_cast<double>(i) / number;
    colours->SetTableValue(i, 1.0 - 0.6 * t, 0.95 - 0.4 * t, 0.75 + 0.1 * t);
  }
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(isolines->GetBandPort());
  mapper->SetScalarModeToUseCellFieldData();
  mapper->SelectColorArray("Band");
  mapper->SetLookupTable(colours);
  mapper->UseLookupTableScalarRangeOn();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  renderer->AddActor(actor);
}

/// Lines in one colour, drawn in front of the surface that they lie on.
void AddLines(vtkRenderer* renderer, vtkAlgorithmOutput* output, double red, float width)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(output);
  mapper->ScalarVisibilityOff();
  mapper->SetResolveCoincidentTopologyToPolygonOffset();
  mapper->SetRelativeCoincidentTopologyLineOffsetParameters(-2.0, -60.0);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(red, 0.1, 0.1);
  actor->GetProperty()->SetLineWidth(width);
  actor->GetProperty()->LightingOff();
  renderer->AddActor(actor);
}

bool Save(vtkRenderWindow* window, const char* path)
{
  vtkNew<vtkWindowToImageFilter> grabber;
  grabber->SetInput(window);
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(path);
  writer->SetInputConnection(grabber->GetOutputPort());
  writer->Write();
  return writer->GetErrorCode() == 0;
}
}

int main(int argc, char* argv[])
{
  if (argc != 4)
  {
    std::cerr << "Usage: " << argv[0] << " MESH.ply NUMBER_OF_LINES PICTURE.png\n";
    return EXIT_FAILURE;
  }
  char* end = nullptr;
  const long number = std::strtol(argv[2], &end, 10);
  if (end == argv[2] || *end != '\0' || number < 1 || number > 10000)
  {
    std::cerr << "error: " << argv[2] << ": not a number of lines\n";
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

  // Windows tell the exact distance inside of triangles.
  vtkNew<vtkExactGeodesicDistance> distance;
  distance->SetInputConnection(reader->GetOutputPort());
  distance->AddSourceId(0);
  distance->GenerateWindowsOn();
  distance->Update();
  if (reader->GetErrorCode() + distance->GetErrorCode() != 0)
  {
    return EXIT_FAILURE; // VTK has said why.
  }
  const double farthest =
    distance->GetOutput()->GetPointData()->GetArray("GeodesicDistance")->GetRange()[1];
  const double step = farthest / static_cast<double>(number + 1);

  vtkNew<vtkApolloniusIsolines> isolines;
  isolines->SetInputConnection(distance->GetOutputPort());
  isolines->GenerateValues(static_cast<int>(number), step, farthest - step);
  isolines->GenerateRidgesOn();
  isolines->GenerateBandsOn();
  isolines->Update();
  if (isolines->GetErrorCode() != 0)
  {
    return EXIT_FAILURE;
  }
  std::cout << isolines->GetOutput()->GetNumberOfLines() << " lines, "
            << isolines->GetRidges()->GetNumberOfLines() << " ridges, "
            << isolines->GetBands()->GetNumberOfCells() << " triangles in bands\n";

  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1.0, 1.0, 1.0);
  AddBands(renderer, isolines, static_cast<int>(number));
  AddLines(renderer, isolines->GetOutputPort(), 0.1, 2.0f);
  AddLines(renderer, isolines->GetRidgePort(), 0.85, 3.0f);
  vtkNew<vtkRenderWindow> window;
  window->OffScreenRenderingOn();
  window->SetMultiSamples(8);
  window->SetSize(800, 800);
  window->AddRenderer(renderer);
  renderer->ResetCamera();
  renderer->GetActiveCamera()->Zoom(1.4);
  window->Render();
  return Save(window, argv[3]) ? EXIT_SUCCESS : EXIT_FAILURE;
}
