// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggCloudNormals.h"

#include "dggBlockLoop.h"
#include "dggCloudFrame.h"
#include "dggOutliers.h"
#include "dggPreparedSurface.h"

#include <pcl/features/normal_3d.h>
#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <limits>

namespace dgg
{
namespace
{
/// Number of points between two checks of the progress by a thread.
constexpr std::size_t NormalBlock = 256;
/// Smallest number of points that define a plane.
constexpr int FewestPoints = 3;
/// Smallest ratio of the standard deviations of points across and along a line at which the points
/// define a plane.
constexpr double ThinnestPlane = 1e-5;

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

/// Converts the finite points to floats in the frame of the cloud, because floats have few digits
/// and a small range. Outliers are excluded. Points far from all others do not enlarge the frame,
/// because few digits would remain for the other points.
Status MakeCloud(
  const double* positions, Id numberOfPoints, std::vector<Id>& ids, Cloud::Ptr& cloud)
{
  const Outliers outliers(positions, numberOfPoints);
  const Outliers far(positions, numberOfPoints, Outliers::RatioOfFar);
  const CloudFrame frame(
    positions, numberOfPoints, [&](const Point3& p) { return far.IsOutlier(p); });
  DGG_RETURN_IF_ERROR(frame.CheckRange());
  cloud.reset(new Cloud);
  cloud->reserve(static_cast<std::size_t>(frame.GetNumberOfPoints()));
  ids.reserve(static_cast<std::size_t>(frame.GetNumberOfPoints()));
  for (Id v = 0; v < numberOfPoints; ++v)
  {
    const Point3 point = PointAt(positions, v);
    if (IsFinite(point) && !outliers.IsOutlier(point))
    {
      const Point3 p = frame.ToLocal(point);
      ids.push_back(v);
      cloud->push_back(
        pcl::PointXYZ(static_cast<float>(p.X), static_cast<float>(p.Y), static_cast<float>(p.Z)));
    }
  }
  return Status::Success();
}

/// Returns true if points are collinear or coincide: any plane through the line would fit them.
bool IsLine(const Cloud& cloud, const pcl::Indices& points)
{
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const int i : points)
  {
    mean += cloud[i].getVector3fMap().cast<double>();
  }
  mean /= static_cast<double>(points.size());
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  for (const int i : points)
  {
    const Eigen::Vector3d d = cloud[i].getVector3fMap().cast<double>() - mean;
    moments += d * d.transpose();
  }
  moments /= static_cast<double>(points.size());
  const Eigen::Vector3d values =
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(moments, Eigen::EigenvaluesOnly).eigenvalues();
  // Rounding error of coordinates up to 1 in the frame.
  const double rounding =
    std::numeric_limits<float>::epsilon() * std::max(1.0, mean.lpNorm<Eigen::Infinity>());
  return !(values[1] > ThinnestPlane * ThinnestPlane * values[2] + rounding * rounding);
}
}

//------------------------------------------------------------------------------
Status EstimateNormals(const TaskContext& context, int numberOfNeighbors,
  const ProgressCallback& progress, std::vector<double>& normals)
{
  const double* positions = context.Surface.GetPositions();
  const Id numberOfPoints = context.Surface.GetMesh().GetNumberOfVertices();
  normals.assign(3 * static_cast<std::size_t>(numberOfPoints), 0.0);
  std::vector<Id> ids;
  Cloud::Ptr cloud;
  DGG_RETURN_IF_ERROR(MakeCloud(positions, numberOfPoints, ids, cloud));
  const int count = std::min(numberOfNeighbors, static_cast<int>(ids.size()));
  if (count < FewestPoints)
  {
    return Status::Success();
  }
  pcl::KdTreeFLANN<pcl::PointXYZ> tree;
  tree.setInputCloud(cloud);
  return ForEach(ids.size(), NormalBlock, context.Parallel, progress,
    [&](std::size_t i, const ProgressCallback&) {
      pcl::Indices found(count);
      std::vector<float> distances(count);
      tree.nearestKSearch((*cloud)[i], count, found, distances);
      Eigen::Vector4f plane;
      float curvature = 0.0f;
      if (!IsLine(*cloud, found) && pcl::computePointNormal(*cloud, found, plane, curvature) &&
        plane.head<3>().allFinite())
      {
        const Eigen::Vector3d normal = plane.head<3>().cast<double>().normalized();
        std::copy(normal.data(), normal.data() + 3, &normals[3 * static_cast<std::size_t>(ids[i])]);
      }
      return Status::Success();
    });
}
}
