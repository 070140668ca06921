// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A surface and a cloud with colors, read from files and compared with a verified baseline.
#include "ImageScene.h"

#include "vtkDGGOFFReader.h"
#include "vtkPCDReader.h"
#include "vtkPCDWriter.h"

#include <fstream>

using namespace dggtest;

TEST(ImageReaders, Colors)
{
  // A house of quads, triangles and a pentagon, each with a color.
  const std::string house = std::string(DGG_TEST_OUTPUT) + "/house.off";
  std::ofstream(house) << "OFF\n10 7 0\n"
                          "0 0 0\n1.6 0 0\n1.6 1 0\n0 1 0\n0 0 0.8\n1.6 0 0.8\n1.6 1 0.8\n"
                          "0 1 0.8\n0 0.5 1.3\n1.6 0.5 1.3\n"
                          "4 3 2 1 0 120 120 120\n4 0 1 5 4 240 220 150\n4 2 3 7 6 240 220 150\n"
                          "5 1 2 6 9 5 200 150 90\n5 3 0 4 8 7 200 150 90\n"
                          "4 4 5 9 8 200 60 50\n4 6 7 8 9 160 40 40\n";
  vtkNew<vtkDGGOFFReader> surface;
  surface->SetFileName(house.c_str());
  ExpectSuccess(surface);
  EXPECT_EQ(surface->GetOutput()->GetNumberOfPolys(), 7);

  // A cloud whose colors are its coordinates.
  auto points = MakeTerrain(24);
  points->SetPolys(nullptr);
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("RGB");
  colors->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double p[3];
    points->GetPoint(i, p);
    colors->InsertNextTuple3(40 + 200 * p[0], 200 - 150 * p[1], 120 + 300 * p[2]);
  }
  points->GetPointData()->SetScalars(colors);
  const std::string file = std::string(DGG_TEST_OUTPUT) + "/colors.pcd";
  vtkNew<vtkPCDWriter> writer;
  writer->SetFileName(file.c_str());
  writer->SetInputData(points);
  ASSERT_EQ(writer->Write(), 1);
  vtkNew<vtkPCDReader> cloud;
  cloud->SetFileName(file.c_str());
  ExpectSuccess(cloud);
  EXPECT_EQ(cloud->GetOutput()->GetNumberOfPoints(), 24 * 24);

  ImageScene scene(2, 1, 240, 200);
  scene.AddPanel({ { { 3.6, -3.8, 3.0 } }, { { 0.8, 0.5, 0.55 } }, 24.0 });
  scene.AddSurface(surface->GetOutput(), "RGB", nullptr);
  scene.AddPanel(TerrainView);
  scene.AddPoints(cloud->GetOutput(), 0.016, "RGB", nullptr);
  scene.ExpectBaseline("TestImageReaders");
}
