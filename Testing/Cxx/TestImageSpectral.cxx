// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Images of functions of the Laplacian: Green's functions, distances, splines, flows, colors;
/// compared with verified baselines.
#include "ImageScene.h"
#include "SpectralTestTools.h"
#include "VectorGraphicsTestTools.h"

#include "vtkBiharmonicDistance.h"
#include "vtkDiscreteGreensFunction.h"
#include "vtkHarmonicBSpline.h"
#include "vtkPoissonVectorGraphics.h"
#include "vtkSurfaceEarthMoversDistance.h"

#include "vtkCellCenters.h"
#include "vtkLinearSubdivisionFilter.h"

using namespace dggtest;

namespace
{
double MeanOverArea(vtkPolyData* surface, const std::vector<double>& values)
{
  const auto areas = GetPointAreas(surface);
  return std::inner_product(areas.begin(), areas.end(), values.begin(), 0.0) /
    std::accumulate(areas.begin(), areas.end(), 0.0);
}

/// Adds a closed curve on the terrain: an ellipse in the view from above, counter-clockwise.
void AddEllipse(Points& points, Cells& lines, double x, double y, double width, double height)
{
  constexpr int count = 40;
  std::vector<vtkIdType> line;
  for (int i = 0; i < count; ++i)
  {
    const double angle = 2.0 * vtkMath::Pi() * i / count;
    line.push_back(static_cast<vtkIdType>(points.size()));
    const double u = x + width * std::cos(angle);
    const double v = y + height * std::sin(angle);
    points.push_back({ { u, v, GetTerrainHeight(u, v) } });
  }
  line.push_back(line.front());
  lines.push_back(line);
}

/// Adds an open curve on the terrain, a wave from one side to the other.
void AddWave(Points& points, Cells& lines, double y, double height)
{
  constexpr int count = 40;
  std::vector<vtkIdType> line;
  for (int i = 0; i <= count; ++i)
  {
    const double x = static_cast<double>(i) / count;
    line.push_back(static_cast<vtkIdType>(points.size()));
    const double v = y + height * std::sin(6.0 * x);
    points.push_back({ { x, v, GetTerrainHeight(x, v) } });
  }
  lines.push_back(line);
}

/// A landscape with a horizon, sky, land, sun, dike and lake: two diffusion curves, a Poisson
/// curve, a region.
struct Drawing
{
  Drawing()
  {
    Points points;
    Cells lines;
    AddWave(points, lines, 0.62, 0.05);
    AddEllipse(points, lines, 0.27, 0.83, 0.09, 0.09);
    AddWave(points, lines, 0.11, -0.06);
    AddEllipse(points, lines, 0.3, 0.4, 0.16, 0.07);
    this->Curves = MakeSourcePoints(points);
    this->Curves->SetLines(MakeCells(lines));
    vtkCellData* data = this->Curves->GetCellData();
    AddArray<vtkIntArray>(data, "CurveType", { 0, 0, 1, 2 }, 1);
    AddArray(data, "LeftColor", { 0.45, 0.65, 0.95, 1, 0.85, 0.3, 0, 0, 0, 0, 0, 0 }, 3);
    AddArray(data, "RightColor", { 0.15, 0.4, 0.2, 0.95, 0.6, 0.5, 0, 0, 0, 0, 0, 0 }, 3);
    AddArray(data, "Strength", { 0, 0, 0, 0, 0, 0, 0.3, 0.3, 0.1, 0.2, 0.35, 0.75 }, 3);
    this->Filter->SetInputData(MakeTerrain(30));
    this->Filter->SetCurveData(this->Curves);
    this->Filter->SetWidth(0.1);
  }

  vtkSmartPointer<vtkPolyData> Curves;
  vtkNew<vtkPoissonVectorGraphics> Filter;
};
}

/// All methods around a source inside a face of a coarse mesh, also between its points.
TEST(ImageSpectral, GreensFunctionByAllMethods)
{
  auto terrain = MakeTerrain(16);
  const auto place = PointInCell(terrain, 250, { { 0.25, 0.55, 0.2 } });
  vtkNew<vtkLinearSubdivisionFilter> fine;
  fine->SetInputData(terrain);
  fine->SetNumberOfSubdivisions(3);
  ImageScene scene(2, 2, 240, 200);
  for (const int method :
    { vtkDiscreteGreensFunction::Vertex, vtkDiscreteGreensFunction::Interpolated,
      vtkDiscreteGreensFunction::Localized, vtkDiscreteGreensFunction::SingularitySubtraction })
  {
    vtkNew<vtkDiscreteGreensFunction> filter;
    filter->SetInputData(terrain);
    filter->SetSourceData(MakeSourcePoints({ place }));
    filter->SetEvaluationConnection(fine->GetOutputPort());
    filter->SetMethod(method);
    ExpectSuccess(filter);
    scene.AddPanel(TerrainView);
    scene.AddSurface(filter->GetEvaluation(), "GreensFunction", FieldColors(-0.25, 0.5, 15));
    scene.AddContours(filter->GetEvaluation(), 0.0025, "GreensFunction", -0.25, 0.5, 16);
  }
  scene.ExpectBaseline("TestImageGreens");
}

/// Neumann and Dirichlet boundary conditions: no flow through the boundary, and zero on the
/// boundary.
TEST(ImageSpectral, GreensFunctionAtABoundary)
{
  constexpr int side = 40;
  constexpr vtkIdType source = 14 * side + 11;
  ImageScene scene(2, 1, 240, 200);
  for (const bool isDirichlet : { false, true })
  {
    vtkNew<vtkDiscreteGreensFunction> filter;
    filter->SetInputData(MakeTerrain(side));
    filter->SetSourceIds({ source });
    filter->SetBoundary(
      isDirichlet ? vtkSpectralAlgorithm::Dirichlet : vtkSpectralAlgorithm::Neumann);
    ExpectSuccess(filter);
    scene.AddPanel(TerrainView);
    scene.AddSurface(filter->GetOutput(), "GreensFunction",
      isDirichlet ? FieldColors(0.0, 0.4) : FieldColors(-0.25, 0.4));
  }
  scene.ExpectBaseline("TestImageGreensBoundary");
}

TEST(ImageSpectral, BiharmonicDistances)
{
  auto pebble = MakePebble(3);
  double below[3] = { -0.1, -0.9, 0.9 };
  const vtkIdType source = pebble->FindPoint(below);
  ImageScene scene(3, 1, 220, 170);
  for (const int kind : { vtkBiharmonicDistance::Biharmonic, vtkBiharmonicDistance::CommuteTime,
         vtkBiharmonicDistance::Diffusion })
  {
    vtkNew<vtkBiharmonicDistance> filter;
    filter->SetInputData(pebble);
    filter->SetSourceIds({ source });
    filter->SetKind(kind);
    filter->SetDiffusionTime(0.3);
    filter->SetNumberOfEigenvalues(60);
    ExpectSuccess(filter);
    const auto values = GetValues(filter->GetOutput(), "BiharmonicDistance");
    const double farthest = *std::max_element(values.begin(), values.end());
    scene.AddPanel(PebbleView);
    scene.AddSurface(filter->GetOutput(), "BiharmonicDistance", FieldColors(0.0, farthest, 16));
    scene.AddPoints(pebble, { source }, 0.05, Red);
  }
  scene.ExpectBaseline("TestImageBiharmonic");
}

/// Cells, a basis function, and a solution with a source and a sink.
TEST(ImageSpectral, BSplines)
{
  auto pebble = MakePebble(4);
  std::vector<double> density;
  for (vtkIdType i = 0; i < pebble->GetNumberOfPoints(); ++i)
  {
    double p[3];
    pebble->GetPoint(i, p);
    const double place[3] = { 1.0, -0.5, 0.4 };
    density.push_back(std::exp(-12.0 * vtkMath::Distance2BetweenPoints(p, place)));
  }
  const double mean = MeanOverArea(pebble, density);
  for (double& d : density)
  {
    d -= mean;
  }
  AddArray(pebble->GetPointData(), "Source", density, 1);
  constexpr int count = 40;
  vtkNew<vtkHarmonicBSpline> filter;
  filter->SetInputData(pebble);
  filter->SetNumberOfSites(count);
  filter->SetRightHandSideArrayName("Source");
  ExpectSuccess(filter);
  double below[3] = { 0.2, -0.9, 0.2 };
  const vtkIdType place = pebble->FindPoint(below);
  const auto cells = GetValues(filter->GetOutput(), "Cell");
  const int site = static_cast<int>(cells[place]);
  const auto solution = GetValues(filter->GetOutput(), "PoissonSolution");
  const auto range = std::minmax_element(solution.begin(), solution.end());

  ImageScene scene(3, 1, 220, 170);
  scene.AddPanel(PebbleView);
  scene.AddSurface(filter->GetOutput(), "Cell", NumberColors(count));
  scene.AddPanel(PebbleView);
  scene.AddSurface(filter->GetOutput(), "HarmonicBSpline", ErrorColors(0.8), site);
  scene.AddPanel(PebbleView);
  scene.AddSurface(
    filter->GetOutput(), "PoissonSolution", FieldColors(*range.first, *range.second, 24));
  scene.ExpectBaseline("TestImageBSpline");
}

/// Values at a few sites: interpolants of both orders; the harmonic one has bumps at the sites.
TEST(ImageSpectral, Interpolation)
{
  auto pebble = MakePebble(4);
  std::vector<double> height;
  for (vtkIdType i = 0; i < pebble->GetNumberOfPoints(); ++i)
  {
    double p[3];
    pebble->GetPoint(i, p);
    height.push_back(p[2] + 0.5 * std::sin(3.0 * p[0]));
  }
  AddArray(pebble->GetPointData(), "Height", height, 1);
  ImageScene scene(2, 1, 240, 190);
  for (const int order : { vtkHarmonicBSpline::Harmonic, vtkHarmonicBSpline::Biharmonic })
  {
    vtkNew<vtkHarmonicBSpline> filter;
    filter->SetInputData(pebble);
    filter->SetOrder(order);
    filter->SetNumberOfSites(30);
    filter->SetSiteValuesArrayName("Height");
    filter->GenerateBasisOff();
    ExpectSuccess(filter);
    std::vector<vtkIdType> sites;
    for (vtkIdType k = 0; k < filter->GetNumberOfUsedSites(); ++k)
    {
      sites.push_back(filter->GetUsedSite(k));
    }
    scene.AddPanel(PebbleView);
    scene.AddSurface(filter->GetOutput(), "Interpolation", FieldColors(-1.0, 1.2, 11));
    scene.AddContours(filter->GetOutput(), 0.005, "Interpolation", -1.0, 1.2, 23);
    scene.AddPoints(pebble, sites, 0.035, Ink);
  }
  scene.ExpectBaseline("TestImageInterpolation");
}

/// Transport from two positions to a third one: the potential, and the flow where it is strong.
TEST(ImageSpectral, EarthMoversFlow)
{
  auto terrain = MakeTerrain(18);
  const std::vector<vtkIdType> from = { 18 * 3 + 3, 18 * 14 + 4 };
  const vtkIdType to = 18 * 11 + 15;
  const auto places = [&](const std::vector<vtkIdType>& ids) {
    Points points(ids.size());
    for (std::size_t i = 0; i < ids.size(); ++i)
    {
      terrain->GetPoint(ids[i], points[i].data());
    }
    return MakeSourcePoints(points);
  };
  vtkNew<vtkSurfaceEarthMoversDistance> filter;
  filter->SetInputData(terrain);
  filter->SetFromData(places(from));
  filter->SetToData(places({ to }));
  ExpectSuccess(filter);
  const auto potential = GetValues(filter->GetOutput(), "EarthMoversPotential");
  const auto range = std::minmax_element(potential.begin(), potential.end());

  vtkNew<vtkCellCenters> centers;
  centers->SetInputConnection(filter->GetOutputPort());
  centers->Update();
  vtkPolyData* arrows = centers->GetOutput();
  vtkDataArray* flow = arrows->GetPointData()->GetArray("EarthMoversFlow");
  std::vector<double> directions;
  for (vtkIdType i = 0; i < flow->GetNumberOfTuples(); ++i)
  {
    double f[3];
    flow->GetTuple(i, f);
    const double size = vtkMath::Norm(f); // weak flow is not drawn; other arrows have equal length
    for (const double component : f)
    {
      directions.push_back(size < 0.5 ? 0.0 : 0.06 / size * component);
    }
  }
  AddArray(arrows->GetPointData(), "Arrow", directions, 3);
  ImageScene scene;
  scene.AddPanel(TerrainView);
  scene.AddSurface(
    filter->GetOutput(), "EarthMoversPotential", FieldColors(*range.first, *range.second));
  scene.AddArrows(arrows, "Arrow", 1.0, Ink);
  scene.AddPoints(terrain, from, 0.022, Red);
  scene.AddPoints(terrain, { to }, 0.022, Blue);
  scene.ExpectBaseline("TestImageEarthMovers");
}

/// Diffusion and Poisson curves and a region.
TEST(ImageSpectral, VectorGraphics)
{
  Drawing drawing;
  drawing.Filter->SetRefinementLevel(1);
  ExpectSuccess(drawing.Filter);
  ImageScene scene;
  scene.AddPanel(TerrainView);
  scene.AddSurface(drawing.Filter->GetOutput(), "RGB", nullptr);
  scene.ExpectBaseline("TestImageVectorGraphics");
}

/// A curve that emits color, and a region of cells, on gray.
TEST(ImageSpectral, VectorGraphicsSources)
{
  constexpr int side = 40;
  auto terrain = MakeTerrain(side);
  std::vector<double> regions;
  std::vector<double> strengths;
  for (vtkIdType cell = 0; cell < terrain->GetNumberOfCells(); ++cell)
  {
    const auto p = PointInCell(terrain, cell, { { 0.4, 0.3, 0.3 } });
    const bool isInside = std::hypot(p[0] - 0.3, p[1] - 0.75) < 0.17 && p[0] + p[1] > 0.95;
    regions.push_back(isInside);
    strengths.insert(strengths.end(), { 0.1 * isInside, 0.4 * isInside, 0.4 * isInside });
  }
  AddArray(terrain->GetCellData(), "Region", regions, 1);
  AddArray(terrain->GetCellData(), "RegionStrength", strengths, 3);
  Points points;
  Cells lines;
  AddWave(points, lines, 0.25, 0.08);
  auto curve = MakeSourcePoints(points);
  curve->SetLines(MakeCells(lines));
  AddArray<vtkIntArray>(curve->GetCellData(), "CurveType", { 3 }, 1);
  AddArray(curve->GetCellData(), "Strength", { 2.0, 0.8, -1.2 }, 3);
  vtkNew<vtkPoissonVectorGraphics> filter;
  filter->SetInputData(terrain);
  filter->SetCurveData(curve);
  filter->SetRegionArrayName("Region");
  filter->SetBackgroundColor(0.5, 0.45, 0.5);
  ExpectSuccess(filter);
  ImageScene scene;
  scene.AddPanel(TerrainView);
  scene.AddSurface(filter->GetOutput(), "RGB", nullptr);
  scene.ExpectBaseline("TestImageSources");
}

/// The same drawing as colored points.
TEST(ImageSpectral, VectorGraphicsFragments)
{
  Drawing drawing;
  drawing.Filter->SetInputData(MakeTerrain(16));
  drawing.Filter->SetRefinementLevel(1);
  drawing.Filter->GenerateFragmentsOn();
  drawing.Filter->SetFragmentDivision(1);
  ExpectSuccess(drawing.Filter);
  ImageScene scene;
  scene.AddPanel(TerrainView);
  scene.AddPoints(drawing.Filter->GetFragments(), 0.011, "RGB", nullptr);
  scene.ExpectBaseline("TestImageFragments");
}
