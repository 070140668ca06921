// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Path planning on a terrain: the shortest path on the surface between two places, beside the
// shortest one along the edges of the mesh, which is what vtkDijkstraGraphGeodesicPath finds.
//
// Usage: TerrainPath PICTURE.png
#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkContourFilter.h"
#include "vtkDGGPath.h"
#include "vtkDijkstraGraphGeodesicPath.h"
#include "vtkDoubleArray.h"
#include "vtkLight.h"
#include "vtkLookupTable.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPolyDataNormals.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTubeFilter.h"
#include "vtkWindowToImageFilter.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>

namespace
{
constexpr int Side = 150;       // points
constexpr double Extent = 12.0; // km
constexpr double Start[2] = { 1.2, 2.6 };
constexpr double End[2] = { 10.8, 8.1 };

/// A mountain, in km: where, how high, how wide along and across, and the direction of the ridge.
struct Hill
{
  double X, Y, Top, Along, Across, Direction;
};
constexpr Hill Hills[] = {
  { 4.3, 2.4, 2.3, 1.6, 0.7, 2.0 },
  { 3.5, 6.2, 1.9, 2.0, 0.8, 1.5 },
  { 7.2, 5.2, 2.6, 1.9, 0.8, 1.9 },
  { 7.9, 9.3, 1.5, 1.2, 0.9, 0.6 },
  { 9.9, 3.0, 1.2, 1.3, 1.0, 0.2 },
  { 1.7, 9.7, 1.0, 1.0, 1.4, 0.5 },
  { 10.4, 6.1, 0.6, 0.5, 0.9, 1.1 },
};

/// Height of the ground in km.
double GetHeight(double x, double y)
{
  double z = 0.0;
  for (const Hill& hill : Hills)
  {
    const double c = std::cos(hill.Direction);
    const double s = std::sin(hill.Direction);
    const double u = (c * (x - hill.X) + s * (y - hill.Y)) / hill.Along;
    const double v = (c * (y - hill.Y) - s * (x - hill.X)) / hill.Across;
    z += hill.Top * std::exp(-u * u - v * v);
  }
  for (int k = 1; k < 9; ++k) // smaller and smaller ones in all directions
  {
    const double a = std::pow(1.3, k) * std::cos(2.4 * k);
    const double b = std::pow(1.3, k) * std::sin(2.4 * k);
    z +=
      0.09 / std::pow(1.25, k) * std::sin(a * x + b * y + std::sin(0.7 * b * x - 0.6 * a * y + k));
  }
  return z;
}

/// A triangle mesh of the terrain, on a grid that is not regular, with its heights as scalars.
void MakeTerrain(vtkPolyData* terrain)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> heights;
  heights->SetName("Height");
  vtkNew<vtkCellArray> triangles;
  for (int j = 0; j < Side; ++j)
  {
    for (int i = 0; i < Side; ++i)
    {
      const bool isInside = i > 0 && i < Side - 1 && j > 0 && j < Side - 1;
      const double shift = isInside ? 0.3 : 0.0;
      const double x = Extent / (Side - 1) * (i + shift * std::sin(12.9 * i + 78.2 * j));
      const double y = Extent / (Side - 1) * (j + shift * std::sin(39.3 * i + 11.1 * j));
      points->InsertNextPoint(x, y, GetHeight(x, y));
      heights->InsertNextValue(GetHeight(x, y));
      if (i == Side - 1 || j == Side - 1)
      {
        continue;
      }
      const vtkIdType a = j * Side + i;
      const vtkIdType b = a + 1;
      const vtkIdType c = a + Side + 1;
      const vtkIdType d = a + Side;
      if ((i + j) % 2 == 0) // squares are cut along either diagonal by turns
      {
        triangles->InsertNextCell({ a, b, c });
        triangles->InsertNextCell({ a, c, d });
      }
      else
      {
        triangles->InsertNextCell({ a, b, d });
        triangles->InsertNextCell({ b, c, d });
      }
    }
  }
  terrain->SetPoints(points);
  terrain->SetPolys(triangles);
  terrain->GetPointData()->SetScalars(heights);
}

/// The point of the mesh next to a place on the map: both paths end there.
vtkIdType FindClosestPoint(vtkPolyData* terrain, const double place[2])
{
  vtkIdType closest = 0;
  double shortest = VTK_DOUBLE_MAX;
  for (vtkIdType i = 0; i < terrain->GetNumberOfPoints(); ++i)
  {
    const double* p = terrain->GetPoint(i);
    const double distance = std::hypot(p[0] - place[0], p[1] - place[1]);
    closest = distance < shortest ? i : closest;
    shortest = std::min(distance, shortest);
  }
  return closest;
}

double MeasureLength(vtkPolyData* polyline)
{
  double length = 0.0;
  for (vtkIdType i = 1; i < polyline->GetNumberOfPoints(); ++i)
  {
    double p[3];
    double q[3];
    polyline->GetPoint(i - 1, p);
    polyline->GetPoint(i, q);
    length += std::sqrt(vtkMath::Distance2BetweenPoints(p, q));
  }
  return length;
}

/// The terrain, coloured by height, with lines of equal height.
void AddTerrain(vtkRenderer* renderer, vtkPolyData* terrain)
{
  vtkNew<vtkLookupTable> colours;
  colours->SetHueRange(0.33, 0.05);
  colours->SetSaturationRange(0.35, 0.1);
  colours->SetValueRange(0.5, 0.9);
  colours->Build();
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(terrain);
  normals->SplittingOff();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(normals->GetOutputPort());
  mapper->SetLookupTable(colours);
  mapper->SetScalarRange(terrain->GetPointData()->GetScalars()->GetRange());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetAmbient(0.2);
  renderer->AddActor(actor);

  vtkNew<vtkContourFilter> contour;
  contour->SetInputData(terrain);
  contour->GenerateValues(15, 0.0, 2.8);
  vtkNew<vtkPolyDataMapper> lineMapper;
  lineMapper->SetInputConnection(contour->GetOutputPort());
  lineMapper->ScalarVisibilityOff();
  vtkNew<vtkActor> lines;
  lines->SetMapper(lineMapper);
  lines->SetPosition(0.0, 0.0, 0.01); // a little above the ground, to be seen
  lines->GetProperty()->SetColor(0.3, 0.3, 0.2);
  renderer->AddActor(lines);
}

void AddPath(vtkRenderer* renderer, vtkAlgorithmOutput* path, const double colour[3])
{
  vtkNew<vtkTubeFilter> tube;
  tube->SetInputConnection(path);
  tube->SetRadius(0.045);
  tube->SetNumberOfSides(16);
  tube->CappingOn();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(tube->GetOutputPort());
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
  renderer->AddActor(actor);
}

/// Look from above and from the south, with the sun in the north-west.
void Aim(vtkRenderer* renderer)
{
  renderer->SetBackground(1.0, 1.0, 1.0);
  vtkNew<vtkLight> sun;
  sun->SetPosition(-8.0, 14.0, 12.0);
  sun->SetFocalPoint(0.5 * Extent, 0.5 * Extent, 0.0);
  sun->SetIntensity(0.8);
  renderer->AddLight(sun);
  vtkNew<vtkLight> sky; // what it sends into the shadows
  sky->SetPosition(9.0, -20.0, 25.0);
  sky->SetIntensity(0.5);
  renderer->AddLight(sky);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetFocalPoint(0.5 * Extent, 0.51 * Extent, 0.0);
  camera->SetPosition(0.58 * Extent, -0.45 * Extent, 2.15 * Extent);
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->SetViewAngle(27.5);
  renderer->ResetCameraClippingRange();
}

bool Save(vtkRenderWindow* window, const char* path)
{
  vtkNew<vtkWindowToImageFilter> grabber;
  grabber->SetInput(window);
  grabber->ReadFrontBufferOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(path);
  writer->SetInputConnection(grabber->GetOutputPort());
  writer->Write();
  return writer->GetErrorCode() == 0;
}
}

int main(int argc, char* argv[])
{
  if (argc != 2)
  {
    std::cerr << "Usage: " << argv[0] << " PICTURE.png\n";
    return EXIT_FAILURE;
  }
  vtkNew<vtkPolyData> terrain;
  MakeTerrain(terrain);
  const vtkIdType start = FindClosestPoint(terrain, Start);
  const vtkIdType end = FindClosestPoint(terrain, End);

  // On the surface.
  vtkNew<vtkDGGPath> path;
  path->SetInputData(terrain);
  path->AddPair(start, end);
  path->Update();
  if (path->GetErrorCode() != 0)
  {
    return EXIT_FAILURE; // VTK has said why.
  }
  const double length = path->GetOutput()->GetCellData()->GetArray("Length")->GetComponent(0, 0);

  // Along edges of the mesh.
  vtkNew<vtkDijkstraGraphGeodesicPath> edges;
  edges->SetInputData(terrain);
  edges->SetStartVertex(start);
  edges->SetEndVertex(end);
  edges->Update();
  const double edgeLength = MeasureLength(edges->GetOutput());

  std::cout << "on the surface: " << length << " km\n"
            << "along mesh edges: " << edgeLength << " km, " << 100.0 * (edgeLength / length - 1.0)
            << " % longer\n";

  vtkNew<vtkRenderer> renderer;
  const double red[3] = { 0.80, 0.05, 0.12 };
  const double blue[3] = { 0.08, 0.16, 0.55 };
  AddTerrain(renderer, terrain);
  AddPath(renderer, edges->GetOutputPort(), blue);
  AddPath(renderer, path->GetOutputPort(), red);
  Aim(renderer);
  vtkNew<vtkRenderWindow> window;
  window->OffScreenRenderingOn();
  window->SetMultiSamples(8);
  window->SetSize(1000, 900);
  window->AddRenderer(renderer);
  window->Render();
  return Save(window, argv[1]) ? EXIT_SUCCESS : EXIT_FAILURE;
}
