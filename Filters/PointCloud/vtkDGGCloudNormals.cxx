// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGCloudNormals.h"

#include "vtkDGGParallel.h"

#include <pcl/features/normal_3d.h>
#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace
{
/// Points between two looks at the progress.
constexpr std::size_t NormalBlock = 4096;
/// Points that make a plane.
constexpr int FewestPoints = 3;

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

bool IsFinite(const double* p)
{
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}

/// The finite points as floats: from the middle of their box, and scaled to it, as floats have few
/// digits and a small range.
Cloud::Ptr MakeCloud(const double* positions, dgg::Id numberOfPoints, std::vector<dgg::Id>& ids)
{
  std::array<double, 3> low;
  std::array<double, 3> high;
  low.fill(dgg::Infinity);
  high.fill(-dgg::Infinity);
  for (dgg::Id v = 0; v < numberOfPoints; ++v)
  {
    const double* p = positions + 3 * static_cast<std::size_t>(v);
    if (IsFinite(p))
    {
      ids.push_back(v);
      for (int c = 0; c < 3; ++c)
      {
        low[c] = std::min(low[c], p[c]);
        high[c] = std::max(high[c], p[c]);
      }
    }
  }
  // Halves first: the box of large numbers may have an extent beyond the range of double.
  double halfExtent = 0.0;
  std::array<double, 3> middle;
  for (int c = 0; c < 3; ++c)
  {
    middle[c] = 0.5 * low[c] + 0.5 * high[c];
    halfExtent = std::max(halfExtent, 0.5 * high[c] - 0.5 * low[c]);
  }
  const int exponent = halfExtent > 0.0 ? -std::ilogb(halfExtent) : 0;
  Cloud::Ptr cloud(new Cloud);
  cloud->reserve(ids.size());
  for (const dgg::Id v : ids)
  {
    const double* p = positions + 3 * static_cast<std::size_t>(v);
    std::array<float, 3> local;
    for (int c = 0; c < 3; ++c)
    {
      local[c] = static_cast<float>(std::ldexp(p[c] - middle[c], exponent));
    }
    cloud->push_back(pcl::PointXYZ(local[0], local[1], local[2]));
  }
  return cloud;
}
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGEstimateNormals(const double* positions, dgg::Id numberOfPoints,
  int numberOfNeighbors, const dgg::ProgressCallback& progress, std::vector<double>& normals)
{
  normals.assign(3 * static_cast<std::size_t>(numberOfPoints), 0.0);
  std::vector<dgg::Id> ids;
  const Cloud::Ptr cloud = MakeCloud(positions, numberOfPoints, ids);
  const int count = std::min(numberOfNeighbors, static_cast<int>(ids.size()));
  if (count < FewestPoints)
  {
    return dgg::Status::Success();
  }
  pcl::KdTreeFLANN<pcl::PointXYZ> tree;
  tree.setInputCloud(cloud);
  return vtkDGGForBlocks(ids.size(), NormalBlock, progress, [&](std::size_t i) {
    pcl::Indices found(count);
    std::vector<float> distances(count);
    tree.nearestKSearch((*cloud)[i], count, found, distances);
    Eigen::Vector4f plane;
    float curvature = 0.0f;
    if (pcl::computePointNormal(*cloud, found, plane, curvature) && plane.head<3>().allFinite())
    {
      const Eigen::Vector3d normal = plane.head<3>().cast<double>().normalized();
      std::copy(normal.data(), normal.data() + 3, &normals[3 * static_cast<std::size_t>(ids[i])]);
    }
    return dgg::Status::Success();
  });
}
