// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Images of curves: isolines with ridges and bands, paths, loops with offset curves, patch
/// boundaries; compared with verified baselines.
#include "ImageScene.h"
#include "LoopTestTools.h"
#include "PathTestTools.h"
#include "SpectralTestTools.h"

#include "vtkApolloniusIsolines.h"
#include "vtkExactGeodesicDistance.h"
#include "vtkGeodesicPatchBoundaries.h"

#include "vtkActor.h"
#include "vtkProperty.h"

using namespace dggtest;

namespace
{
/// Returns a bent vase, wide below and narrow near the top, open at both ends.
vtkSmartPointer<vtkPolyData> MakeVase()
{
  constexpr int sides = 28;
  constexpr int rows = 24;
  auto vase = MakePrism(sides, rows);
  for (int j = 0; j <= rows; ++j)
  {
    const double z = static_cast<double>(j) / rows;
    const double radius = 0.3 + 0.16 * std::sin(5.6 * z - 0.3);
    for (int i = 0; i < sides; ++i)
    {
      const double angle = 2.0 * vtkMath::Pi() * i / sides;
      vase->GetPoints()->SetPoint(j * sides + i, radius * std::cos(angle) + 0.3 * z * z,
        0.85 * radius * std::sin(angle), 1.3 * z);
    }
  }
  return vase;
}
constexpr Viewpoint VaseView = { { { 1.2, -3.4, 2.2 } }, { { 0.1, 0.0, 0.67 } }, 22.5 };

/// Returns positions on the upper side of a torus, three near the hole and three far from it.
vtkSmartPointer<vtkPolyData> MakeStar()
{
  Points points;
  for (int k = 0; k < 6; ++k)
  {
    const double u = 0.2 + vtkMath::Pi() * k / 3.0;
    const double v = k % 2 == 0 ? 0.9 : 2.4;
    const double r = 1.0 + 0.4 * std::cos(v);
    points.push_back({ { r * std::cos(u), r * std::sin(u), 0.4 * std::sin(v) } });
  }
  return MakeSourcePoints(points);
}

/// Connects the filter to exact distances and sets `number` evenly spaced values.
void Prepare(vtkApolloniusIsolines* isolines, vtkPolyData* surface,
  const std::vector<vtkIdType>& sources, bool hasWindows, int number)
{
  vtkNew<vtkExactGeodesicDistance> distance;
  distance->SetInputData(surface);
  distance->SetSourceIds(sources);
  distance->GenerateVirtualSourceOn();
  distance->SetGenerateWindows(hasWindows);
  ExpectSuccess(distance);
  const double farthest =
    distance->GetOutput()->GetPointData()->GetArray("GeodesicDistance")->GetRange()[1];
  isolines->SetInputConnection(distance->GetOutputPort());
  isolines->GenerateValues(number, farthest / (number + 1), farthest * number / (number + 1));
  isolines->GenerateBandsOn();
}

/// Returns colors of bands, light enough for lines to be visible.
vtkSmartPointer<vtkLookupTable> BandColors(int number)
{
  auto colors = FieldColors(0, number, number + 1);
  for (int i = 0; i <= number; ++i)
  {
    double c[4];
    colors->GetTableValue(i, c);
    colors->SetTableValue(i, 0.5 + 0.5 * c[0], 0.5 + 0.5 * c[1], 0.5 + 0.5 * c[2]);
  }
  return colors;
}
}

/// Isolines on coarse meshes by the methods linear, Apollonius, virtual sources and windows.
TEST(ImageCurves, IsolinesByAllMethods)
{
  constexpr int number = 12;
  const Viewpoint cubeView = { { { 3.4, -1.9, 2.8 } }, { { 0.5, 0.5, 0.5 } }, 24.0 };
  ImageScene scene(4, 2, 220, 170);
  for (const bool isCube : { false, true })
  {
    auto surface = isCube ? MakeCube() : MakePebble(2);
    std::vector<vtkIdType> sources = { 1, 2, 4 };
    if (!isCube)
    {
      double behind[3] = { -1.6, 5.0, -3.0 }; // so that ridges are in front
      sources = { surface->FindPoint(behind) };
    }
    for (int column = 0; column < 4; ++column)
    {
      vtkNew<vtkApolloniusIsolines> isolines;
      Prepare(isolines, surface, sources, column == 3, number);
      isolines->SetGenerateRidges(column > 0);
      isolines->SetMethod(column == 0 ? vtkApolloniusIsolines::Linear
          : column == 1               ? vtkApolloniusIsolines::Apollonius
                                      : vtkApolloniusIsolines::LocalSources);
      ExpectSuccess(isolines);
      scene.AddPanel(isCube ? cubeView : PebbleView);
      const double radius = isCube ? 0.008 : 0.012;
      scene.AddSurface(isolines->GetBands(), "Band", BandColors(number));
      scene.AddLines(isolines->GetOutput(), radius, Ink);
      scene.AddLines(isolines->GetRidges(), 2.0 * radius, Red);
    }
  }
  scene.ExpectBaseline("TestImageIsolines");
}

/// Bands between isolines of two sources, and ridges colored by their angle.
TEST(ImageCurves, RidgesAndBands)
{
  constexpr int number = 14;
  auto terrain = MakeTerrain(40);
  vtkNew<vtkApolloniusIsolines> isolines;
  Prepare(isolines, terrain, { 40 * 12 + 6, 40 * 30 + 33 }, true, number);
  isolines->GenerateRidgesOn();
  ExpectSuccess(isolines);
  EXPECT_GT(ExpectPiecesInTheirFaces(terrain, isolines->GetOutput()), 1000);
  EXPECT_GT(ExpectPiecesInTheirFaces(terrain, isolines->GetRidges()), 50);

  ImageScene scene;
  scene.AddPanel(TerrainView);
  scene.AddSurface(isolines->GetBands(), "Band", BandColors(number));
  scene.AddLines(isolines->GetOutput(), 0.0025, Ink);
  auto angles = ErrorColors(180.0);
  scene.AddLines(isolines->GetRidges(), 0.008, "RidgeAngle", angles);
  scene.AddPoints(terrain, { 40 * 12 + 6, 40 * 30 + 33 }, 0.018, Ink);
  scene.ExpectBaseline("TestImageRidges");
}

/// Paths from a corner of the terrain to positions around the bump, and between positions in faces.
TEST(ImageCurves, Paths)
{
  constexpr int side = 60;
  auto terrain = MakeTerrain(side);
  vtkNew<vtkDGGPath> filter;
  filter->SetInputData(terrain);
  for (const auto& end : { std::array<int, 2>{ { 59, 2 } }, { { 57, 21 } }, { { 56, 33 } },
         { { 51, 48 } }, { { 30, 57 } }, { { 4, 41 } }, { { 40, 21 } } })
  {
    filter->AddPair(5 * side + 3, end[1] * side + end[0]);
  }
  filter->SetPairData(MakePairs({ { { 0.11, 0.93, 0.0 } }, { { 0.42, 0.63, 0.0 } } }));
  filter->SetProjectionTolerance(0.2); // the points are projected onto the surface
  ExpectSuccess(filter);

  ImageScene scene;
  scene.AddPanel(TerrainView);
  scene.AddSurface(terrain);
  scene.AddLines(filter->GetOutput(), 0.009, "ArcLength", FieldColors(0.0, 1.4));
  scene.ExpectBaseline("TestImagePath");
}

/// Paths in a coarse graph before and after straightening.
TEST(ImageCurves, StraightenedPaths)
{
  constexpr int side = 12;
  auto terrain = MakeTerrain(side);
  ImageScene scene;
  scene.AddPanel(TerrainView);
  scene.AddSurface(terrain)->GetProperty()->EdgeVisibilityOn();
  vtkNew<vtkDGGPath> filter;
  filter->SetInputData(terrain);
  filter->SetAccuracy(0.5);
  for (const vtkIdType end : { side * 3 + 11, side * 8 + 10, side * 11 + 4 })
  {
    filter->AddPair(side, end);
  }
  for (const bool isStraight : { false, true })
  {
    filter->SetStraighten(isStraight);
    ExpectSuccess(filter);
    scene.AddLines(filter->GetOutput(), isStraight ? 0.008 : 0.006, isStraight ? Red : Blue);
  }
  scene.ExpectBaseline("TestImageStraightenedPath");
}

/// Loops around a handle, a rope that is held by its points, and the offset curves of the rope.
TEST(ImageCurves, HandlesAndRope)
{
  auto torus = MakeTorus(36, 18);
  vtkNew<vtkDGGLoop> handles;
  handles->SetInputData(torus);
  handles->SetModeToAroundHandles();
  ExpectSuccess(handles);
  vtkNew<vtkDGGLoop> rope;
  rope->SetInputData(torus);
  rope->SetModeToRope();
  rope->SetPointData(MakeStar());
  rope->SetTapeWidth(0.2);
  ExpectSuccess(rope);
  ImageScene scene;
  scene.AddPanel({ { { 0.6, -2.3, 4.4 } }, { { 0.0, -0.05, 0.0 } }, 32.0 });
  scene.AddSurface(torus);
  scene.AddLines(handles->GetOutput(), 0.02, Blue);
  scene.AddLines(rope->GetOutput(), 0.02, Red);
  scene.AddLines(rope->GetTape(), 0.016, Orange);
  scene.ExpectBaseline("TestImageLoop");
}

/// Loops through points, with kinks there; one relaxed loop at the waist, and its offset curves.
TEST(ImageCurves, LoopsThroughPoints)
{
  auto vase = MakeVase();
  vtkNew<vtkDGGLoop> loop;
  loop->SetInputData(vase);
  loop->SetPointIds({ 28 * 4 + 22, 28 * 13 + 20 });
  ExpectSuccess(loop);
  vtkNew<vtkDGGLoop> taut;
  taut->SetInputData(vase);
  taut->AddPointId(28 * 17 + 20);
  taut->TautOn();
  taut->SetTapeWidth(0.12);
  ExpectSuccess(taut);
  ImageScene scene;
  scene.AddPanel(VaseView);
  scene.AddSurface(vase);
  scene.AddLines(loop->GetOutput(), 0.011, Blue);
  scene.AddPoints(vase, { 28 * 4 + 22, 28 * 13 + 20 }, 0.025, Blue);
  scene.AddLines(taut->GetOutput(), 0.011, Red);
  scene.AddLines(taut->GetTape(), 0.009, Orange);
  scene.ExpectBaseline("TestImageTautLoop");
}

/// Twelve curves between six landmarks on two surfaces; corresponding curves have the same color.
TEST(ImageCurves, PatchBoundaries)
{
  const Cells octahedron = { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 4 }, { 0, 4, 1 }, { 5, 2, 1 },
    { 5, 3, 2 }, { 5, 4, 3 }, { 5, 1, 4 } };
  auto pebble = MakePebble(3);
  auto bean = MakeSphere(3);
  MovePoints(bean, [&](double* p) {
    p[0] = 0.9 * p[0] + 0.45 * p[2] * p[2];
    p[1] = 0.8 * p[1] * (1.0 - 0.3 * p[2]);
    p[2] *= 1.15;
  });
  // The corners of an octahedron, three of them facing the viewer.
  const auto landmarks = [](vtkPolyData* surface, double turn) {
    const double towards[3] = { 0.36, -0.81, 0.46 };
    const double right[3] = { 0.91, 0.41, 0.0 };
    double up[3];
    vtkMath::Cross(right, towards, up);
    std::vector<vtkIdType> ids(6);
    for (int k = 0; k < 3; ++k)
    {
      const double angle = turn + 2.0 * vtkMath::Pi() / 3.0 * k;
      double axis[3];
      for (int c = 0; c < 3; ++c)
      {
        axis[c] = 2.4 * towards[c] + 2.0 * (std::cos(angle) * right[c] + std::sin(angle) * up[c]);
      }
      const int opposite[3] = { 5, 3, 4 };
      ids[k] = surface->FindPoint(axis);
      vtkMath::MultiplyScalar(axis, -1.0);
      ids[opposite[k]] = surface->FindPoint(axis);
    }
    return ids;
  };
  const auto first = landmarks(pebble, 0.3);
  const auto second = landmarks(bean, 0.55);
  vtkNew<vtkPolyData> layout;
  layout->SetPolys(MakeCells(octahedron));
  vtkNew<vtkGeodesicPatchBoundaries> filter;
  filter->SetInputData(pebble);
  filter->SetSecondSurfaceData(bean);
  filter->SetFirstLandmarkIds(first);
  filter->SetSecondLandmarkIds(second);
  filter->SetLayoutData(layout);
  ExpectSuccess(filter);

  ImageScene scene(2, 1, 240, 190);
  for (const int port : { 0, 1 })
  {
    vtkPolyData* curves = filter->GetOutput(port);
    EXPECT_EQ(curves->GetNumberOfLines(), 12);
    vtkSmartPointer<vtkPolyData> surface = port == 0 ? pebble : bean;
    EXPECT_GT(ExpectPiecesInTheirFaces(surface, curves), 100);
    AddArray(curves->GetCellData(), "Number", { 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11 });
    scene.AddPanel(PebbleView);
    scene.AddSurface(surface);
    scene.AddLines(curves, 0.025, "Number", NumberColors(12));
    scene.AddPoints(surface, port == 0 ? first : second, 0.05, Ink);
  }
  scene.ExpectBaseline("TestImagePatchBoundaries");
}
