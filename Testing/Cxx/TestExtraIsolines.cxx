// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Isolines on the smaller meshes of the folder DGG_EXTRA_DATA.

#include "ExtraMeshes.h"
#include "FilterTestTools.h"
#include "MeshFile.h"
#include "PathTestTools.h"

#include "vtkApolloniusIsolines.h"
#include "vtkDGGDistance.h"
#include "vtkExactGeodesicDistance.h"

using namespace dggtest;

namespace
{
constexpr vtkIdType MostPoints = 15000;

class ExtraIsolines : public testing::TestWithParam<std::string>
{
};

/// Expects that isolines of ten levels of the distance from a point, with bands, lie on the
/// surface.
void ExpectOnSurface(vtkPolyData* surface, vtkGeodesicDistanceAlgorithm* distance)
{
  distance->SetInputData(surface);
  const Listener listener(distance); // these meshes have defects that cause warnings
  distance->Update();
  ASSERT_EQ(listener.Errors, std::vector<std::string>());
  double range[2];
  distance->GetOutput()->GetPointData()->GetArray("GeodesicDistance")->GetRange(range);
  vtkNew<vtkApolloniusIsolines> isolines;
  isolines->SetInputConnection(distance->GetOutputPort());
  isolines->GenerateValues(10, 0.05 * range[1], 0.95 * range[1]);
  isolines->GenerateBandsOn();
  const Listener isolineListener(isolines);
  isolines->Update();
  EXPECT_EQ(isolineListener.Errors, std::vector<std::string>());
  EXPECT_GT(isolines->GetBands()->GetNumberOfCells(), 0);
  EXPECT_GT(ExpectPiecesInTheirFaces(surface, isolines->GetOutput()), 0);
}

TEST_P(ExtraIsolines, LieInTheirFaces)
{
  auto surface = ReadPolyData(GetParam());
  const vtkIdType n = surface->GetNumberOfPoints();
  if (n > MostPoints)
  {
    return;
  }
  std::vector<vtkIdType> sources{ n / 3, n / 5 * 4 };
  if (StemOf(GetParam()) == "z_bar_clamp")
  {
    sources = { 114, 223 }; // with these sources, lines have been off the surface
  }
  for (const vtkIdType source : sources)
  {
    SCOPED_TRACE(source);
    vtkNew<vtkExactGeodesicDistance> exact;
    exact->AddSourceId(source);
    exact->GenerateWindowsOn();
    ExpectOnSurface(surface, exact);
    vtkNew<vtkDGGDistance> graph;
    graph->AddSourceId(source);
    graph->GenerateVirtualSourceOn();
    ExpectOnSurface(surface, graph);
  }
}

INSTANTIATE_TEST_SUITE_P(Real, ExtraIsolines, testing::ValuesIn(FindExtraMeshes()), NameExtraMesh);
}
