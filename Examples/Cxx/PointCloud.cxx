// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// From a cloud of the Point Cloud Library to distances along what it samples, back to PCL, and to a
// PCD file.
//
// Usage: PointCloud RESULT.pcd
#include "vtkDGGDistance.h"
#include "vtkDGGPointCloudConversions.h"
#include "vtkNew.h"
#include "vtkPCDReader.h"
#include "vtkPCDWriter.h"
#include "vtkPointCloudDGG.h"
#include "vtkPolyData.h"

#include <pcl/filters/voxel_grid.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>

namespace
{
/// What a pipeline of PCL gives: a sheet rolled up one and a half times, with normals, thinned out.
pcl::PointCloud<pcl::PointNormal>::ConstPtr MakeCloud()
{
  pcl::PointCloud<pcl::PointNormal>::Ptr cloud(new pcl::PointCloud<pcl::PointNormal>);
  const float slope = 0.1f;
  for (int i = 0; i < 300; ++i)
  {
    const float angle = 0.03f * static_cast<float>(i);
    const float radius = 1.0f + slope * angle;
    const float c = std::cos(angle);
    const float s = std::sin(angle);
    const float length = std::hypot(radius, slope);
    for (int j = 0; j < 80; ++j)
    {
      cloud->push_back(pcl::PointNormal(radius * c, radius * s, 0.05f * static_cast<float>(j),
        (radius * c + slope * s) / length, (radius * s - slope * c) / length, 0.0f));
    }
  }
  pcl::PointCloud<pcl::PointNormal>::Ptr thinned(new pcl::PointCloud<pcl::PointNormal>);
  pcl::VoxelGrid<pcl::PointNormal> grid;
  grid.setInputCloud(cloud);
  grid.setLeafSize(0.1f, 0.1f, 0.1f);
  grid.filter(*thinned);
  return thinned;
}

/// The point where the sheet starts: the one that is nearest to the inner end of its lower rim.
vtkIdType FindStart(const pcl::PointCloud<pcl::PointNormal>& cloud)
{
  const auto distance = [](const pcl::PointNormal& p) { return std::hypot(p.x - 1.0f, p.y, p.z); };
  const auto nearest = std::min_element(cloud.begin(), cloud.end(),
    [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
  return nearest - cloud.begin();
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

  // The graph of the cloud, whose normals come along, and distances in it.
  vtkNew<vtkPointCloudDGG> graph;
  graph->SetInputData(vtkDGG::ToPolyData(cloud));
  vtkNew<vtkDGGDistance> distance;
  distance->SetInputConnection(graph->GetOutputPort());
  const vtkIdType start = FindStart(*cloud);
  distance->AddSourceId(start);
  distance->SetDistanceArrayName("intensity"); // a field that PCL knows
  distance->Update();
  if (distance->GetErrorCode() != 0)
  {
    return EXIT_FAILURE; // VTK has said why.
  }
  vtkPolyData* result = distance->GetOutput();
  std::cout << result->GetNumberOfPoints() << " points, " << graph->GetNumberOfGraphEdges()
            << " edges, " << graph->GetNumberOfComponents() << " components\n";

  // Back to PCL: arrays go to the fields of the same name.
  pcl::PointCloud<pcl::PointXYZINormal> back;
  if (!vtkDGG::FromPolyData(result, back) || back.empty())
  {
    return EXIT_FAILURE;
  }
  // Points that are not reached have NaN, which would upset the order.
  const auto distanceOf = [](const auto& point) {
    return std::isnan(point.intensity) ? -1.0f : point.intensity;
  };
  const auto farthest = std::max_element(back.begin(), back.end(),
    [&](const auto& a, const auto& b) { return distanceOf(a) < distanceOf(b); });
  const Eigen::Vector3f straight =
    farthest->getVector3fMap() - (*cloud)[static_cast<std::size_t>(start)].getVector3fMap();
  std::cout << "farthest point: " << farthest->intensity << " along the sheet, " << straight.norm()
            << " in a straight line\n";

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
