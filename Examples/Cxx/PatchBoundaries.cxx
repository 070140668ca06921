// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Two closed surfaces divided into the same eight patches: a picture of the curves on both. The
// landmarks are the points farthest along the axes, the layout is an octahedron.
//
// Usage: PatchBoundaries FIRST.ply SECOND.ply PICTURE.png
#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkGeodesicPatchBoundaries.h"
#include "vtkGlyph3D.h"
#include "vtkLookupTable.h"
#include "vtkNew.h"
#include "vtkPLYReader.h"
#include "vtkPNGWriter.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPolyDataNormals.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"
#include "vtkTubeFilter.h"
#include "vtkWindowToImageFilter.h"

#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <vector>

namespace
{
/// Landmarks are numbered +x +y +z -x -y -z.
constexpr int NumberOfLandmarks = 6;
constexpr vtkIdType Patches[8][3] = { { 0, 1, 2 }, { 1, 3, 2 }, { 3, 4, 2 }, { 4, 0, 2 },
  { 1, 0, 5 }, { 3, 1, 5 }, { 4, 3, 5 }, { 0, 4, 5 } };

/// The points of a mesh that are farthest along the axes.
std::vector<vtkIdType> FindLandmarks(vtkPolyData* mesh)
{
  std::vector<vtkIdType> landmarks(NumberOfLandmarks, 0);
  for (int l = 0; l < NumberOfLandmarks; ++l)
  {
    const int axis = l % 3;
    const double sign = l < 3 ? 1.0 : -1.0;
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      const double best = sign * mesh->GetPoint(landmarks[l])[axis];
      landmarks[l] = sign * mesh->GetPoint(i)[axis] > best ? i : landmarks[l];
    }
  }
  return landmarks;
}

/// Polygons on the numbers of the landmarks; no points are needed.
void MakeLayout(vtkPolyData* layout)
{
  vtkNew<vtkCellArray> polygons;
  for (const auto& patch : Patches)
  {
    polygons->InsertNextCell(3, patch);
  }
  layout->SetPolys(polygons);
}

vtkActor* AddActor(vtkRenderer* renderer, vtkAlgorithmOutput* output, double r, double g, double b)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(output);
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(r, g, b);
  renderer->AddActor(actor);
  return actor;
}

/// Tubes, each in a colour of its own: curves that correspond have the same.
void AddCurves(vtkRenderer* renderer, vtkPolyData* curves, double radius)
{
  const vtkIdType count = curves->GetNumberOfCells();
  vtkNew<vtkDoubleArray> numbers;
  numbers->SetName("Number");
  for (vtkIdType i = 0; i < count; ++i)
  {
    numbers->InsertNextValue(static_cast<double>(i));
  }
  vtkNew<vtkPolyData> coloured;
  coloured->ShallowCopy(curves);
  coloured->GetCellData()->SetScalars(numbers);
  vtkNew<vtkTubeFilter> tubes;
  tubes->SetInputData(coloured);
  tubes->SetRadius(radius);
  tubes->SetNumberOfSides(12);
  vtkNew<vtkLookupTable> colours;
  colours->SetNumberOfTableValues(count);
  colours->SetHueRange(0.0, 0.92);
  colours->SetSaturationRange(0.9, 0.9);
  colours->SetValueRange(0.9, 0.9);
  colours->Build();
  vtkActor* actor = AddActor(renderer, tubes->GetOutputPort(), 1.0, 1.0, 1.0);
  actor->GetMapper()->ScalarVisibilityOn();
  actor->GetMapper()->SetLookupTable(colours);
  actor->GetMapper()->SetScalarRange(-0.5, static_cast<double>(count) - 0.5);
}

/// A surface with its curves and landmarks in a half of a window.
void AddSurface(vtkRenderWindow* window, int side, vtkPolyData* mesh, vtkPolyData* curves,
  const std::vector<vtkIdType>& landmarks)
{
  const double size = mesh->GetLength();
  vtkNew<vtkPolyDataNormals> surface;
  surface->SetInputData(mesh);
  vtkNew<vtkPoints> points;
  for (const vtkIdType landmark : landmarks)
  {
    points->InsertNextPoint(mesh->GetPoint(landmark));
  }
  vtkNew<vtkPolyData> spots;
  spots->SetPoints(points);
  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(0.012 * size);
  vtkNew<vtkGlyph3D> balls;
  balls->SetInputData(spots);
  balls->SetSourceConnection(ball->GetOutputPort());
  balls->ScalingOff();

  vtkNew<vtkRenderer> renderer;
  renderer->SetViewport(0.5 * side, 0.0, 0.5 * (side + 1), 1.0);
  renderer->SetBackground(1.0, 1.0, 1.0);
  AddActor(renderer, surface->GetOutputPort(), 0.85, 0.85, 0.82);
  AddCurves(renderer, curves, 0.004 * size);
  AddActor(renderer, balls->GetOutputPort(), 0.1, 0.1, 0.1);
  renderer->GetActiveCamera()->SetPosition(0.5, 0.45, 1.0);
  renderer->ResetCamera();
  renderer->GetActiveCamera()->Zoom(1.2);
  window->AddRenderer(renderer);
}

void PrintLengths(vtkGeodesicPatchBoundaries* boundaries)
{
  std::cout << "landmarks   first surface  second surface\n";
  vtkCellData* data[2] = { boundaries->GetOutput(0)->GetCellData(),
    boundaries->GetOutput(1)->GetCellData() };
  for (vtkIdType i = 0; i < boundaries->GetOutput(0)->GetNumberOfCells(); ++i)
  {
    const double* edge = data[0]->GetArray("LayoutEdge")->GetTuple2(i);
    std::cout << edge[0] << " to " << edge[1] << std::setw(19)
              << data[0]->GetArray("Length")->GetTuple1(i) << std::setw(16)
              << data[1]->GetArray("Length")->GetTuple1(i) << "\n";
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
  if (argc != 4)
  {
    std::cerr << "Usage: " << argv[0] << " FIRST.ply SECOND.ply PICTURE.png\n";
    return EXIT_FAILURE;
  }
  vtkNew<vtkPLYReader> readers[2];
  std::vector<vtkIdType> landmarks[2];
  for (int side = 0; side < 2; ++side)
  {
    readers[side]->SetFileName(argv[1 + side]);
    readers[side]->Update();
    if (readers[side]->GetErrorCode() != 0 || readers[side]->GetOutput()->GetNumberOfPoints() == 0)
    {
      std::cerr << "error: " << argv[1 + side] << ": no surface could be read\n";
      return EXIT_FAILURE;
    }
    landmarks[side] = FindLandmarks(readers[side]->GetOutput());
  }
  vtkNew<vtkPolyData> layout;
  MakeLayout(layout);

  // The curves on both, which correspond one by one.
  vtkNew<vtkGeodesicPatchBoundaries> boundaries;
  boundaries->SetInputConnection(readers[0]->GetOutputPort());
  boundaries->SetSecondSurfaceConnection(readers[1]->GetOutputPort());
  boundaries->SetFirstLandmarkIds(landmarks[0]);
  boundaries->SetSecondLandmarkIds(landmarks[1]);
  boundaries->SetLayoutData(layout);
  boundaries->Update();
  if (boundaries->GetErrorCode() != 0)
  {
    return EXIT_FAILURE; // VTK has said why.
  }
  PrintLengths(boundaries);

  vtkNew<vtkRenderWindow> window;
  window->OffScreenRenderingOn();
  window->SetSize(1200, 600);
  for (int side = 0; side < 2; ++side)
  {
    AddSurface(
      window, side, readers[side]->GetOutput(), boundaries->GetOutput(side), landmarks[side]);
  }
  window->Render();
  return Save(window, argv[3]) ? EXIT_SUCCESS : EXIT_FAILURE;
}
