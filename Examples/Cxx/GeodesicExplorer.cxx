// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// Click a source of distances and drag it, then click the end of a path. Virtual sources follow the
// mouse, at rest a graph answers. Times and lengths are in the title; --play prints some of them.
// Usage: GeodesicExplorer MESH.ply [--play]
#include "vtkActor.h"
#include "vtkApolloniusIsolines.h"
#include "vtkCellData.h"
#include "vtkCellPicker.h"
#include "vtkCommand.h"
#include "vtkDGGDistance.h"
#include "vtkDGGPath.h"
#include "vtkDataArray.h"
#include "vtkDiscreteGeodesicGraph.h"
#include "vtkInteractorStyleTrackballCamera.h"
#include "vtkLineSource.h"
#include "vtkLookupTable.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPLYReader.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkTimerLog.h"
#include "vtkVirtualSourceGeodesicDistance.h"

#include <cstdlib>
#include <iostream>
#include <string>

namespace
{
/// On the surface, places are picked and moved; beside it, the camera turns.
class Explorer : public vtkInteractorStyleTrackballCamera
{
public:
  static Explorer* New();
  vtkTypeMacro(Explorer, vtkInteractorStyleTrackballCamera);

  void SetUp(vtkRenderer* renderer, vtkPolyData* mesh)
  {
    this->Fast->SetInputData(mesh);
    this->Fast->SetSourceConnection(this->Source->GetOutputPort());
    this->Graph->SetInputData(mesh); // built at the first rest
    this->Accurate->SetInputConnection(this->Graph->GetOutputPort());
    this->Accurate->SetSourceConnection(this->Source->GetOutputPort());
    this->Accurate->GenerateVirtualSourceOn(); // for lines that are curved in triangles
    this->Path->SetInputConnection(this->Graph->GetOutputPort());
    this->Path->SetPairConnection(this->Ends->GetOutputPort());
    this->Surface->SetInputData(mesh);
    vtkLookupTable::SafeDownCast(this->Surface->GetLookupTable())->SetNumberOfTableValues(20);
    this->Surface->InterpolateScalarsBeforeMappingOn();
    vtkNew<vtkActor> surface;
    surface->SetMapper(this->Surface);
    renderer->AddActor(surface);
    vtkMapper::SetResolveCoincidentTopologyToPolygonOffset(); // lines in front of the surface
    vtkAlgorithm* const curves[] = { this->Isolines, this->Path };
    for (int i = 0; i < 2; ++i)
    {
      vtkNew<vtkPolyDataMapper> mapper;
      mapper->SetInputConnection(curves[i]->GetOutputPort());
      mapper->ScalarVisibilityOff();
      this->Curves[i]->SetMapper(mapper);
      this->Curves[i]->PickableOff();
      this->Curves[i]->GetProperty()->SetColor(0.1, 0.1, 0.1);
      this->Curves[i]->GetProperty()->SetLineWidth(i == 0 ? 1.5f : 5.0f);
    }
  }

  void OnLeftButtonDown() override
  {
    this->IsHeld = this->Pick(!this->IsEnd); // by turns
    this->IsHeld ? this->Show() : this->Superclass::OnLeftButtonDown();
  }

  void OnMouseMove() override
  {
    this->Superclass::OnMouseMove();
    if (this->IsHeld && this->Pick(this->IsEnd))
    {
      this->Show();
    }
  }

  void OnLeftButtonUp() override
  {
    this->Superclass::OnLeftButtonUp();
    if (this->IsHeld)
    {
      this->IsHeld = false;
      this->Show();
    }
  }

private:
  bool Pick(bool isEnd)
  {
    const int* pixel = this->Interactor->GetEventPosition();
    this->FindPokedRenderer(pixel[0], pixel[1]);
    if (!this->Picker->Pick(pixel[0], pixel[1], 0.0, this->CurrentRenderer))
    {
      return false;
    }
    this->IsEnd = isEnd;
    this->Ends->SetPoint2(this->Picker->GetPickPosition());
    if (!isEnd)
    {
      this->Ends->SetPoint1(this->Picker->GetPickPosition());
      this->Source->SetPoint1(this->Picker->GetPickPosition());
      this->Source->SetPoint2(this->Picker->GetPickPosition());
    }
    return true;
  }

  void Show()
  {
    const double start = vtkTimerLog::GetUniversalTime();
    vtkGeodesicDistanceAlgorithm* fast = this->Fast;
    vtkGeodesicDistanceAlgorithm* distance = this->IsHeld ? fast : this->Accurate;
    distance->Update();
    const double high = distance->GetOutput()->GetScalarRange()[1];
    this->Isolines->SetInputConnection(distance->GetOutputPort());
    this->Isolines->SetMethod(this->IsHeld ? Isolines->Linear : Isolines->LocalSources);
    this->Isolines->GenerateValues(19, 0.05 * high, 0.95 * high);
    this->Isolines->Update();
    this->CurrentRenderer->AddActor(this->Curves[0]);
    this->Surface->SetInputConnection(distance->GetOutputPort());
    this->Surface->SetScalarRange(0.0, high);
    std::string said = this->IsHeld ? "virtual sources" : "graph";
    this->CurrentRenderer->RemoveActor(this->Curves[1]);
    if (this->IsEnd && !this->IsHeld)
    {
      this->Path->Update();
      vtkDataArray* lengths = this->Path->GetOutput()->GetCellData()->GetArray("Length");
      const bool isFound = lengths && lengths->GetNumberOfTuples() > 0;
      said += ", path " + (isFound ? std::to_string(lengths->GetTuple1(0)) : "none");
      this->CurrentRenderer->AddActor(this->Curves[1]);
    }
    said += ", " + std::to_string(1e3 * (vtkTimerLog::GetUniversalTime() - start)) + " ms";
    this->Interactor->GetRenderWindow()->SetWindowName(said.c_str());
    this->Interactor->Render();
  }

  vtkNew<vtkLineSource> Source, Ends; // the source twice, and the ends of the path
  vtkNew<vtkVirtualSourceGeodesicDistance> Fast;
  vtkNew<vtkDiscreteGeodesicGraph> Graph;
  vtkNew<vtkDGGDistance> Accurate;
  vtkNew<vtkDGGPath> Path;
  vtkNew<vtkApolloniusIsolines> Isolines;
  vtkNew<vtkCellPicker> Picker;
  vtkNew<vtkPolyDataMapper> Surface;
  vtkNew<vtkActor> Curves[2];
  bool IsHeld = false, IsEnd = true; // the next one is a source
};
vtkStandardNewMacro(Explorer);
}

int main(int argc, char* argv[])
{
  const bool isPlayed = argc == 3 && std::string(argv[2]) == "--play";
  vtkNew<vtkPLYReader> reader;
  if (argc == 2 || isPlayed)
  {
    reader->SetFileName(argv[1]);
    reader->Update();
  }
  if (reader->GetOutput()->GetNumberOfPolys() == 0)
  {
    std::cerr << "Usage: " << argv[0] << " MESH.ply [--play], of a mesh with triangles\n";
    return EXIT_FAILURE;
  }
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(isPlayed);
  window->AddRenderer(renderer);
  vtkNew<vtkRenderWindowInteractor> interactor;
  interactor->SetRenderWindow(window);
  vtkNew<Explorer> explorer;
  interactor->SetInteractorStyle(explorer);
  explorer->SetUp(renderer, reader->GetOutput());
  window->Render();
  if (!isPlayed)
  {
    interactor->Start();
    return EXIT_SUCCESS;
  }
  const int press = vtkCommand::LeftButtonPressEvent, move = vtkCommand::MouseMoveEvent;
  const int release = vtkCommand::LeftButtonReleaseEvent;
  const int events[][3] = { { press, 150, 150 }, { move, 160, 170 }, { release, 160, 170 },
    { press, 130, 120 }, { release, 130, 120 } };
  for (const auto& event : events)
  {
    interactor->SetEventPosition(event[1], event[2]);
    interactor->InvokeEvent(event[0]);
    std::cout << window->GetWindowName() << "\n";
  }
}
