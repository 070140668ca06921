// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Samples of a surface, moved to the middle of their Voronoi cells: a picture of the cells.
//
// Usage: VoronoiCells MESH.ply NUMBER_OF_SITES PICTURE.png
#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkDiscreteGeodesicGraph.h"
#include "vtkFieldData.h"
#include "vtkGeodesicSampler.h"
#include "vtkGeodesicVoronoi.h"
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

#include <cmath>
#include <cstdlib>
#include <iostream>

namespace
{
/// Neighboring numbers get hues that are far apart.
void SetColours(vtkLookupTable* colours, vtkIdType number)
{
  vtkNew<vtkLookupTable> rainbow;
  rainbow->SetHueRange(0.0, 1.0);
  rainbow->SetSaturationRange(0.45, 0.45);
  rainbow->SetTableRange(0.0, 1.0);
  rainbow->Build();
  colours->SetNumberOfTableValues(number);
  colours->SetTableRange(0.0, static_cast<double>(number - 1));
  for (vtkIdType i = 0; i < number; ++i)
  {
    double rgb[3];
    rainbow->GetColor(std::fmod(0.618034 * static_cast<double>(i), 1.0), rgb);
    colours->SetTableValue(i, rgb);
  }
}

void AddCells(vtkRenderer* renderer, vtkGeodesicVoronoi* voronoi)
{
  vtkNew<vtkLookupTable> colours;
  SetColours(colours, voronoi->GetSites()->GetNumberOfPoints());
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(voronoi->GetCellsPort());
  mapper->SetScalarModeToUseCellFieldData();
  mapper->SelectColorArray("SiteId");
  mapper->SetLookupTable(colours);
  mapper->UseLookupTableScalarRangeOn();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  renderer->AddActor(actor);
}

/// Lines or points in one colour, drawn in front of the surface that they lie on.
void AddDark(vtkRenderer* renderer, vtkAlgorithmOutput* output)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(output);
  mapper->ScalarVisibilityOff();
  mapper->SetResolveCoincidentTopologyToPolygonOffset();
  mapper->SetRelativeCoincidentTopologyLineOffsetParameters(-2.0, -60.0);
  mapper->SetRelativeCoincidentTopologyPointOffsetParameter(-60.0);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.1, 0.1, 0.1);
  actor->GetProperty()->SetLineWidth(3.0f);
  actor->GetProperty()->SetPointSize(7.0f);
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
    std::cerr << "Usage: " << argv[0] << " MESH.ply NUMBER_OF_SITES PICTURE.png\n";
    return EXIT_FAILURE;
  }
  char* end = nullptr;
  const vtkIdType number = std::strtoll(argv[2], &end, 10);
  if (end == argv[2] || *end != '\0')
  {
    std::cerr << "error: " << argv[2] << ": not a number of sites\n";
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

  // The graph: built once, for both filters.
  vtkNew<vtkDiscreteGeodesicGraph> graph;
  graph->SetInputConnection(reader->GetOutputPort());

  // Points that are far from each other, ...
  vtkNew<vtkGeodesicSampler> sampler;
  sampler->SetInputConnection(graph->GetOutputPort());
  sampler->SetNumberOfSamples(number);

  // ... each moved to the middle of what is nearest to it.
  vtkNew<vtkGeodesicVoronoi> voronoi;
  voronoi->SetInputConnection(graph->GetOutputPort());
  voronoi->SetSiteConnection(sampler->GetOutputPort());
  voronoi->CentroidalOn();
  voronoi->Update();
  if (reader->GetErrorCode() + graph->GetErrorCode() + sampler->GetErrorCode() +
      voronoi->GetErrorCode() !=
    0)
  {
    return EXIT_FAILURE; // VTK has said why.
  }

  vtkDataArray* energy = voronoi->GetOutput()->GetFieldData()->GetArray("Energy");
  const vtkIdType last = energy->GetNumberOfTuples() - 1;
  const double* areas = voronoi->GetSites()->GetPointData()->GetArray("CellArea")->GetRange();
  std::cout << voronoi->GetSites()->GetNumberOfPoints() << " cells, areas from " << areas[0]
            << " to " << areas[1] << "\n"
            << "energy " << energy->GetComponent(0, 0) << ", after " << last << " iterations "
            << energy->GetComponent(last, 0) << "\n";

  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1.0, 1.0, 1.0);
  AddCells(renderer, voronoi);
  AddDark(renderer, voronoi->GetBoundariesPort());
  AddDark(renderer, voronoi->GetSitesPort());
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
