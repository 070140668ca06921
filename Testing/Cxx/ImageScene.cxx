// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ImageScene.h"

#include "SpectralTestTools.h"
#include "StrictImageComparison.h"

#include "vtkActor.h"
#include "vtkArrowSource.h"
#include "vtkCamera.h"
#include "vtkContourFilter.h"
#include "vtkGlyph3D.h"
#include "vtkPolyDataMapper.h"
#include "vtkPolyDataNormals.h"
#include "vtkProperty.h"
#include "vtkRendererCollection.h"
#include "vtkSphereSource.h"
#include "vtkStripper.h"
#include "vtkTubeFilter.h"

#include <cstdlib>

namespace dggtest
{
namespace
{
/// Returns a table of `count` colors, interpolated linearly between `stops`.
vtkSmartPointer<vtkLookupTable> MakeColors(
  const std::vector<Color>& stops, double low, double high, int count)
{
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(count);
  table->SetTableRange(low, high);
  table->SetNanColor(0.6, 0.6, 0.6, 1.0);
  for (int i = 0; i < count; ++i)
  {
    const double place = static_cast<double>(i) / (count - 1) * (stops.size() - 1);
    const std::size_t k = std::min(static_cast<std::size_t>(place), stops.size() - 2);
    Color color;
    for (int c = 0; c < 3; ++c)
    {
      color[c] = stops[k][c] + (place - k) * (stops[k + 1][c] - stops[k][c]);
    }
    table->SetTableValue(i, color[0], color[1], color[2]);
  }
  return table;
}

/// Returns a copy whose active scalars are a component of a point or cell array, or colors.
vtkSmartPointer<vtkPolyData> WithScalars(
  vtkPolyData* data, const std::string& name, bool isPainted, int component = 0)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->CopyStructure(data);
  const bool isOfPoints = data->GetPointData()->HasArray(name.c_str());
  const int type = isOfPoints ? vtkDataObject::POINT : vtkDataObject::CELL;
  vtkDataArray* array = data->GetAttributes(type)->GetArray(name.c_str());
  EXPECT_NE(array, nullptr) << name;
  if (array)
  {
    auto values = vtkSmartPointer<vtkDataArray>::Take(array->NewInstance());
    values->SetName(name.c_str());
    values->SetNumberOfComponents(isPainted ? array->GetNumberOfComponents() : 1);
    values->SetNumberOfTuples(array->GetNumberOfTuples());
    for (int c = 0; c < values->GetNumberOfComponents(); ++c)
    {
      values->CopyComponent(c, array, isPainted ? c : component);
    }
    copy->GetAttributes(type)->SetScalars(values);
  }
  return copy;
}

/// Returns a copy, because a filter may run again before the image is drawn.
vtkSmartPointer<vtkPolyData> Copy(vtkPolyData* data)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->ShallowCopy(data);
  return copy;
}

vtkSmartPointer<vtkPolyDataAlgorithm> MakeShaded(vtkPolyData* data)
{
  auto normals = vtkSmartPointer<vtkPolyDataNormals>::New();
  normals->SetInputData(Copy(data));
  normals->ConsistencyOff();
  normals->SetFeatureAngle(50.0);
  return normals;
}

vtkSmartPointer<vtkPolyDataAlgorithm> MakeTubes(vtkPolyData* data, double radius)
{
  auto tubes = vtkSmartPointer<vtkTubeFilter>::New();
  tubes->SetInputData(Copy(data));
  tubes->SetRadius(radius);
  tubes->SetNumberOfSides(8);
  return tubes;
}

vtkSmartPointer<vtkPolyDataAlgorithm> MakeBalls(vtkPolyData* data, double radius)
{
  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(radius);
  ball->SetThetaResolution(12);
  auto balls = vtkSmartPointer<vtkGlyph3D>::New();
  balls->SetInputData(Copy(data));
  balls->SetSourceConnection(ball->GetOutputPort());
  balls->ScalingOff();
  balls->SetColorModeToColorByScalar();
  return balls;
}
}

vtkSmartPointer<vtkPolyData> MakePebble(int level)
{
  struct Bump
  {
    std::array<double, 3> Place;
    double Height;
    double Width;
  };
  const Bump bumps[] = { { { { 0.9, -0.3, 0.3 } }, 0.55, 0.5 },
    { { { -0.6, -0.5, 0.6 } }, 0.4, 0.35 }, { { { 0.15, -0.85, 0.5 } }, -0.4, 0.45 } };
  auto surface = MakeSphere(level);
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    std::array<double, 3> p;
    surface->GetPoint(i, p.data());
    double radius = 1.0;
    for (const Bump& bump : bumps)
    {
      const double d = vtkMath::Distance2BetweenPoints(p.data(), bump.Place.data());
      radius += bump.Height * std::exp(-d / (bump.Width * bump.Width));
    }
    surface->GetPoints()->SetPoint(i, radius * p[0], radius * p[1], 0.85 * radius * p[2]);
  }
  return surface;
}

vtkSmartPointer<vtkLookupTable> FieldColors(double low, double high, int bands)
{
  return MakeColors({ { { 0.99, 0.92, 0.35 } }, { { 0.57, 0.84, 0.3 } }, { { 0.21, 0.72, 0.47 } },
                      { { 0.13, 0.57, 0.6 } }, { { 0.25, 0.45, 0.7 } }, { { 0.37, 0.33, 0.68 } },
                      { { 0.48, 0.22, 0.6 } } },
    low, high, bands);
}

vtkSmartPointer<vtkLookupTable> ErrorColors(double largest)
{
  return MakeColors({ { { 0.1, 0.25, 0.6 } }, { { 0.45, 0.7, 0.9 } }, { { 0.97, 0.97, 0.94 } },
                      { { 0.96, 0.6, 0.35 } }, { { 0.7, 0.1, 0.2 } } },
    -largest, largest, 41);
}

vtkSmartPointer<vtkLookupTable> NumberColors(int count)
{
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(count);
  table->SetTableRange(0, std::max(1, count - 1));
  table->SetBelowRangeColor(0.6, 0.6, 0.6, 1.0);
  table->UseBelowRangeColorOn();
  for (int i = 0; i < count; ++i)
  {
    const double hue = std::fmod(0.55 + 0.618034 * i, 1.0);
    double r, g, b;
    vtkMath::HSVToRGB(hue, i % 2 ? 0.35 : 0.55, i % 3 ? 0.95 : 0.8, &r, &g, &b);
    table->SetTableValue(i, r, g, b);
  }
  return table;
}

ImageScene::ImageScene(int columns, int rows, int width, int height)
  : Columns(columns)
  , Rows(rows)
{
  this->Window->SetOffScreenRendering(1);
  this->Window->SetMultiSamples(0);
  this->Window->SetSize(columns * width, rows * height);
}

void ImageScene::AddPanel(const Viewpoint& view)
{
  const double width = 1.0 / this->Columns;
  const double height = 1.0 / this->Rows;
  const double left = this->NumberOfPanels % this->Columns * width;
  const double top = 1.0 - this->NumberOfPanels / this->Columns * height;
  ++this->NumberOfPanels;
  this->Panel = vtkSmartPointer<vtkRenderer>::New();
  this->Panel->SetViewport(left, top - height, left + width, top);
  this->Panel->SetBackground(1.0, 1.0, 1.0);
  vtkCamera* camera = this->Panel->GetActiveCamera();
  camera->SetPosition(view.Position.data());
  camera->SetFocalPoint(view.FocalPoint.data());
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->SetViewAngle(view.Angle);
  this->Window->AddRenderer(this->Panel);
}

vtkActor* ImageScene::AddActor(vtkAlgorithmOutput* output, const Color& color)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(output);
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color[0], color[1], color[2]);
  actor->GetProperty()->SetAmbient(0.45);
  actor->GetProperty()->SetDiffuse(0.6);
  actor->GetProperty()->SetEdgeColor(0.6, 0.6, 0.58);
  this->Panel->AddActor(actor);
  return actor;
}

vtkActor* ImageScene::AddActor(vtkAlgorithmOutput* output, vtkLookupTable* colors)
{
  vtkActor* actor = this->AddActor(output, Clay);
  auto* mapper = vtkPolyDataMapper::SafeDownCast(actor->GetMapper());
  mapper->ScalarVisibilityOn();
  if (colors)
  {
    mapper->SetLookupTable(colors);
    mapper->UseLookupTableScalarRangeOn();
    // Colors are looked up per pixel, so that bands have sharp borders. Ids must not be
    // interpolated.
    mapper->SetInterpolateScalarsBeforeMapping(!colors->GetUseBelowRangeColor());
  }
  return actor;
}

vtkActor* ImageScene::AddSurface(vtkPolyData* data, const Color& color)
{
  return this->AddActor(MakeShaded(data)->GetOutputPort(), color);
}

vtkActor* ImageScene::AddSurface(
  vtkPolyData* data, const std::string& array, vtkLookupTable* colors, int component)
{
  auto shown = WithScalars(data, array, !colors, component);
  return this->AddActor(MakeShaded(shown)->GetOutputPort(), colors);
}

vtkActor* ImageScene::AddLines(vtkPolyData* data, double radius, const Color& color)
{
  return this->AddActor(MakeTubes(data, radius)->GetOutputPort(), color);
}

vtkActor* ImageScene::AddLines(
  vtkPolyData* data, double radius, const std::string& array, vtkLookupTable* colors)
{
  auto shown = WithScalars(data, array, !colors);
  return this->AddActor(MakeTubes(shown, radius)->GetOutputPort(), colors);
}

vtkActor* ImageScene::AddPoints(vtkPolyData* data, double radius, const Color& color)
{
  return this->AddActor(MakeBalls(data, radius)->GetOutputPort(), color);
}

vtkActor* ImageScene::AddPoints(
  vtkPolyData* data, double radius, const std::string& array, vtkLookupTable* colors)
{
  auto shown = WithScalars(data, array, !colors);
  return this->AddActor(MakeBalls(shown, radius)->GetOutputPort(), colors);
}

vtkActor* ImageScene::AddPoints(
  vtkPolyData* data, const std::vector<vtkIdType>& ids, double radius, const Color& color)
{
  Points places(ids.size());
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    data->GetPoint(ids[i], places[i].data());
  }
  return this->AddPoints(MakeSourcePoints(places), radius, color);
}

vtkActor* ImageScene::AddContours(
  vtkPolyData* data, double radius, const std::string& array, double first, double last, int n)
{
  vtkNew<vtkContourFilter> contour;
  contour->SetInputData(data);
  contour->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, array.c_str());
  contour->GenerateValues(n, first, last);
  vtkNew<vtkStripper> lines;
  lines->SetInputConnection(contour->GetOutputPort());
  lines->JoinContiguousSegmentsOn();
  lines->Update();
  return this->AddLines(lines->GetOutput(), radius, Ink);
}

vtkActor* ImageScene::AddArrows(
  vtkPolyData* data, const std::string& vectors, double length, const Color& color)
{
  vtkNew<vtkArrowSource> arrow;
  arrow->SetTipResolution(8);
  arrow->SetTipLength(0.45);
  arrow->SetTipRadius(0.1);
  arrow->SetShaftRadius(0.03);
  vtkNew<vtkGlyph3D> arrows;
  arrows->SetInputData(Copy(data));
  arrows->SetSourceConnection(arrow->GetOutputPort());
  arrows->SetInputArrayToProcess(1, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, vectors.c_str());
  arrows->SetVectorModeToUseVector();
  arrows->SetScaleModeToScaleByVector();
  arrows->SetScaleFactor(length);
  return this->AddActor(arrows->GetOutputPort(), color);
}

void ImageScene::ExpectBaseline(const std::string& name)
{
  ASSERT_NE(std::getenv("DISPLAY"), nullptr) << "pictures need an X display, as of xvfb-run";
  vtkRendererCollection* panels = this->Window->GetRenderers();
  for (int i = 0; i < panels->GetNumberOfItems(); ++i)
  {
    vtkRenderer::SafeDownCast(panels->GetItemAsObject(i))->ResetCameraClippingRange();
  }
  this->Window->Render();
  dggtest::ExpectBaseline(this->Window, name);
}
}
