// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Two queries on one graph: distances from two points, side by side in a picture.
//
// Usage: GraphPipeline MESH.ply SOURCE_ID SOURCE_ID PICTURE.png
#include "vtkActor.h"
#include "vtkBandedPolyDataContourFilter.h"
#include "vtkCamera.h"
#include "vtkDGGDistance.h"
#include "vtkDataArray.h"
#include "vtkDiscreteGeodesicGraph.h"
#include "vtkLookupTable.h"
#include "vtkNew.h"
#include "vtkPLYReader.h"
#include "vtkPNGWriter.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkWindowToImageFilter.h"

#include <cstdlib>
#include <iostream>

namespace
{
constexpr int Bands = 24;

/// From yellow to violet, every other band a little darker.
void SetColours(vtkLookupTable* colours)
{
  colours->SetNumberOfTableValues(Bands);
  colours->SetTableRange(0, Bands - 1);
  colours->SetHueRange(0.14, 0.76);
  colours->SetSaturationRange(0.6, 0.6);
  colours->Build();
  for (int i = 0; i < Bands; i += 2)
  {
    const double* c = colours->GetTableValue(i);
    colours->SetTableValue(i, 0.8 * c[0], 0.8 * c[1], 0.8 * c[2]);
  }
}

/// Show the surface in bands of distance, in the left (0) or right (1) half of the window.
void AddView(vtkRenderWindow* window, vtkDGGDistance* distance, int half)
{
  vtkNew<vtkBandedPolyDataContourFilter> bands;
  bands->SetInputConnection(distance->GetOutputPort());
  bands->GenerateValues(Bands + 1, distance->GetOutput()->GetPointData()->GetScalars()->GetRange());
  bands->SetScalarModeToIndex();
  vtkNew<vtkLookupTable> colours;
  SetColours(colours);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(bands->GetOutputPort());
  mapper->SetScalarModeToUseCellData();
  mapper->SetLookupTable(colours);
  mapper->UseLookupTableScalarRangeOn();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1.0, 1.0, 1.0);
  renderer->SetViewport(0.5 * half, 0.0, 0.5 * half + 0.5, 1.0);
  renderer->AddActor(actor);
  window->AddRenderer(renderer);
  renderer->ResetCamera();
  renderer->GetActiveCamera()->Zoom(1.4);
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
    std::cerr << "Usage: " << argv[0] << " MESH.ply SOURCE_ID SOURCE_ID PICTURE.png\n";
    return EXIT_FAILURE;
  }
  vtkNew<vtkPLYReader> reader;
  reader->SetFileName(argv[1]);

  // The graph: built once.
  vtkNew<vtkDiscreteGeodesicGraph> graph;
  graph->SetInputConnection(reader->GetOutputPort());
  graph->SetAccuracy(0.01);

  // Queries: as many as you like, in milliseconds.
  vtkNew<vtkRenderWindow> window;
  window->OffScreenRenderingOn();
  window->SetMultiSamples(8);
  window->SetSize(1200, 600);
  for (int half = 0; half < 2; ++half)
  {
    char* end = nullptr;
    const vtkIdType source = std::strtoll(argv[2 + half], &end, 10);
    if (end == argv[2 + half] || *end != '\0')
    {
      std::cerr << "error: " << argv[2 + half] << ": not a point id\n";
      return EXIT_FAILURE;
    }
    vtkNew<vtkDGGDistance> distance;
    distance->SetInputConnection(graph->GetOutputPort());
    distance->AddSourceId(source);
    distance->Update();
    if (reader->GetErrorCode() + graph->GetErrorCode() + distance->GetErrorCode() != 0)
    {
      return EXIT_FAILURE; // VTK has said why.
    }
    AddView(window, distance, half);
    std::cout << "from point " << source << ": up to "
              << distance->GetOutput()->GetPointData()->GetScalars()->GetRange()[1] << "\n";
  }
  std::cout << graph->GetNumberOfGraphEdges() << " edges, " << graph->GetMeanDegree()
            << " per point\n";
  return Save(window, argv[4]) ? EXIT_SUCCESS : EXIT_FAILURE;
}
