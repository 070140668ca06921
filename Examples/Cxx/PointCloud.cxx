// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// From a cloud of the Point Cloud Library to VTK's filters, back to PCL, and to a PCD file.
//
// Usage: PointCloud RESULT.pcd
#include "vtkDGGPointCloudConversions.h"
#include "vtkDataArray.h"
#include "vtkElevationFilter.h"
#include "vtkNew.h"
#include "vtkPCDReader.h"
#include "vtkPCDWriter.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <pcl/filters/voxel_grid.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>

namespace
{
/// What a pipeline of PCL gives: a rolled sheet with normals, thinned out.
pcl::PointCloud<pcl::PointNormal>::ConstPtr MakeCloud()
{
  pcl::PointCloud<pcl::PointNormal>::Ptr cloud(new pcl::PointCloud<pcl::PointNormal>);
  for (int i = 0; i < 100; ++i)
  {
    const float angle = 0.09f * static_cast<float>(i);
    const float radius = 1.0f + 0.1f * angle;
    for (int j = 0; j < 40; ++j)
    {
      cloud->push_back(pcl::PointNormal(radius * std::cos(angle), radius * std::sin(angle),
        0.1f * static_cast<float>(j), std::cos(angle), std::sin(angle), 0.0f));
    }
  }
  pcl::PointCloud<pcl::PointNormal>::Ptr thinned(new pcl::PointCloud<pcl::PointNormal>);
  pcl::VoxelGrid<pcl::PointNormal> grid;
  grid.setInputCloud(cloud);
  grid.setLeafSize(0.15f, 0.15f, 0.15f);
  grid.filter(*thinned);
  return thinned;
}
}

int main(int argc, char* argv[])
{
  if (argc != 2)
  {
    std::cerr << "Usage: " << argv[0] << " RESULT.pcd\n";
    return EXIT_FAILURE;
  }
  const pcl::PointCloud<pcl::PointNormal>::ConstPtr cloud = MakeCloud();

  // Into a filter, in one line. Any filter for points may stand here.
  vtkNew<vtkElevationFilter> filter;
  filter->SetInputData(vtkDGG::ToPolyData(cloud));
  filter->SetHighPoint(0.0, 0.0, 3.9);
  filter->Update();
  vtkPolyData* result = filter->GetPolyDataOutput();
  std::cout << result->GetNumberOfPoints() << " points "
            << (result->GetPointData()->GetNormals() ? "with" : "without") << " normals\n";

  // Back to PCL: arrays go to the fields of the same name.
  result->GetPointData()->GetArray("Elevation")->SetName("intensity");
  pcl::PointCloud<pcl::PointXYZINormal> back;
  if (!vtkDGG::FromPolyData(result, back) || back.empty())
  {
    return EXIT_FAILURE;
  }
  const auto range = std::minmax_element(back.begin(), back.end(),
    [](const auto& a, const auto& b) { return a.intensity < b.intensity; });
  std::cout << back.size() << " points of PCL, values from " << range.first->intensity << " to "
            << range.second->intensity << "\n";

  // To a file that PCL's programs read, and from one.
  vtkNew<vtkPCDWriter> writer;
  writer->SetInputData(result);
  writer->SetFileName(argv[1]);
  writer->SetDataModeToBinaryCompressed();
  if (writer->Write() != 1)
  {
    return EXIT_FAILURE; // VTK has said why.
  }
  vtkNew<vtkPCDReader> reader;
  reader->SetFileName(argv[1]);
  reader->Update();
  std::cout << argv[1] << ": " << reader->GetOutput()->GetNumberOfPoints() << " points\n";
  return reader->GetErrorCode() == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
