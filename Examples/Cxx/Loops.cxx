// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// The shortest loop through a point of a surface and the closed geodesic next to it, with a tape: a
// picture of them.
//
// Usage: Loops MESH.ply POINT TAPE_WIDTH PICTURE.png
#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDGGLoop.h"
#include "vtkDataArray.h"
#include "vtkDiscreteGeodesicGraph.h"
#include "vtkNew.h"
#include "vtkPLYReader.h"
#include "vtkPNGWriter.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTubeFilter.h"
#include "vtkWindowToImageFilter.h"

#include <cstdlib>
#include <iostream>

namespace
{
void AddActor(vtkRenderer* renderer, vtkAlgorithmOutput* output, double r, double g, double b)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(output);
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(r, g, b);
  renderer->AddActor(actor);
}

void AddTubes(vtkRenderer* renderer, vtkAlgorithmOutput* output, double radius, const double* rgb)
{
  vtkNew<vtkTubeFilter> tubes;
  tubes->SetInputConnection(output);
  tubes->SetRadius(radius);
  tubes->SetNumberOfSides(12);
  AddActor(renderer, tubes->GetOutputPort(), rgb[0], rgb[1], rgb[2]);
}

void Describe(const char* name, vtkDGGLoop* loop)
{
  vtkCellData* data = loop->GetOutput()->GetCellData();
  if (loop->GetOutput()->GetNumberOfLines() > 0)
  {
    std::cout << name << ": length " << data->GetArray("Length")->GetComponent(0, 0) << ", angle "
              << data->GetArray("Angle")->GetComponent(0, 0) << "\n";
  }
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
  if (argc != 5)
  {
    std::cerr << "Usage: " << argv[0] << " MESH.ply POINT TAPE_WIDTH PICTURE.png\n";
    return EXIT_FAILURE;
  }
  char* end = nullptr;
  const vtkIdType point = std::strtoll(argv[2], &end, 10);
  const bool isId = end != argv[2] && *end == '\0';
  const double width = std::strtod(argv[3], &end);
  if (!isId || end == argv[3] || *end != '\0')
  {
    std::cerr << "error: " << argv[2] << " " << argv[3] << ": not a point id and a width\n";
    return EXIT_FAILURE;
  }
  vtkNew<vtkPLYReader> reader;
  reader->SetFileName(argv[1]);

  // The graph: built once, for both filters.
  vtkNew<vtkDiscreteGeodesicGraph> graph;
  graph->SetInputConnection(reader->GetOutputPort());

  // From the point around the surface and back, ...
  vtkNew<vtkDGGLoop> loop;
  loop->SetInputConnection(graph->GetOutputPort());
  loop->AddPointId(point);
  loop->Update();

  // ... and pulled tight, with a tape along it.
  vtkNew<vtkDGGLoop> taut;
  taut->SetInputConnection(graph->GetOutputPort());
  taut->AddPointId(point);
  taut->TautOn();
  taut->SetTapeWidth(width);
  taut->Update();
  if (reader->GetErrorCode() + graph->GetErrorCode() + loop->GetErrorCode() +
      taut->GetErrorCode() !=
    0)
  {
    return EXIT_FAILURE; // VTK has said why.
  }
  Describe("through the point", loop);
  Describe("taut", taut);
  std::cout << taut->GetTape()->GetNumberOfLines() << " rims\n";

  const double size = reader->GetOutput()->GetLength();
  const double blue[] = { 0.05, 0.30, 0.62 };
  const double red[] = { 0.80, 0.05, 0.12 };
  const double orange[] = { 0.95, 0.62, 0.10 };
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1.0, 1.0, 1.0);
  AddActor(renderer, reader->GetOutputPort(), 0.80, 0.80, 0.76);
  AddTubes(renderer, loop->GetOutputPort(), 0.005 * size, blue);
  AddTubes(renderer, taut->GetOutputPort(), 0.005 * size, red);
  AddTubes(renderer, taut->GetTapePort(), 0.0025 * size, orange);
  vtkNew<vtkRenderWindow> window;
  window->OffScreenRenderingOn();
  window->SetMultiSamples(8);
  window->SetSize(800, 800);
  window->AddRenderer(renderer);
  renderer->GetActiveCamera()->SetPosition(0.5, 0.4, 1.0);
  renderer->ResetCamera();
  renderer->GetActiveCamera()->Zoom(1.3);
  window->Render();
  return Save(window, argv[4]) ? EXIT_SUCCESS : EXIT_FAILURE;
}
