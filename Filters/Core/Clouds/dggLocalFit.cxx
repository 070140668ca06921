// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggLocalFit.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Dense>
#include <Eigen/Eigenvalues>

namespace dgg
{
namespace
{
/// Minimum numbers of neighbors for fitting a plane and a quadratic height field.
constexpr std::size_t LeastForPlane = 3;
constexpr std::size_t LeastForQuadric = 12;
/// Minimum extent of the neighbors perpendicular to a line, relative to their extent along the
/// line. Neighbors below this extent do not define a plane.
constexpr double ThinnestPlane = 1e-6;
/// Regularization, relative to the sums of squares: coefficients that are not determined by the
/// neighbors (all of them on a conic) become 0.
constexpr double Damping = 1e-9;

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

Eigen::Vector3d ToEigen(const Point3& p)
{
  return { p.X, p.Y, p.Z };
}
Point3 FromEigen(const Eigen::Vector3d& p)
{
  return { p[0], p[1], p[2] };
}
}

LocalFit FitSurface(const Point3& point, const Point3* neighbors, std::size_t count)
{
  LocalFit fit;
  if (count < LeastForPlane)
  {
    return fit;
  }
  double squaredRadius = 0.0;
  for (std::size_t i = 0; i < count; ++i)
  {
    const Point3 d = neighbors[i] - point;
    squaredRadius = std::max(squaredRadius, Dot(d, d));
  }
  if (!(squaredRadius > 0.0))
  {
    return fit;
  }
  // The unit of length is slightly larger than the distance of the farthest neighbor, so that this
  // neighbor has a small weight.
  const double radius = 1.1 * std::sqrt(squaredRadius);
  const auto weigh = [](const Eigen::Vector3d& d) {
    const double rest = std::max(0.0, 1.0 - d.squaredNorm());
    return rest * rest;
  };
  const auto place = [&](std::size_t i) -> Eigen::Vector3d {
    return ToEigen(neighbors[i] - point) / radius;
  };

  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  double sum = 0.0;
  for (std::size_t i = 0; i < count; ++i)
  {
    const Eigen::Vector3d d = place(i);
    const double w = weigh(d);
    mean += w * d;
    moments += w * d * d.transpose();
    sum += w;
  }
  mean /= sum;
  const Eigen::Matrix3d covariance = moments / sum - mean * mean.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  const Eigen::Vector3d& values = solver.eigenvalues();
  if (solver.info() != Eigen::Success || !(values[1] > ThinnestPlane * ThinnestPlane * values[2]))
  {
    return fit;
  }
  const Eigen::Vector3d z = solver.eigenvectors().col(0);
  const Eigen::Vector3d x = solver.eigenvectors().col(2);
  const Eigen::Vector3d y = z.cross(x);
  fit.Normal = FromEigen(z);
  if (count < LeastForQuadric)
  {
    fit.ToSurface = FromEigen(radius * z.dot(mean) * z);
    fit.Residual = radius * std::sqrt(std::max(0.0, values[0]));
    return fit;
  }

  Matrix6 normal = Matrix6::Zero();
  Vector6 right = Vector6::Zero();
  for (std::size_t i = 0; i < count; ++i)
  {
    const Eigen::Vector3d d = place(i);
    const double w = weigh(d);
    const double u = x.dot(d);
    const double v = y.dot(d);
    const double h = z.dot(d);
    Vector6 row;
    row << 1.0, u, v, u * u, u * v, v * v;
    normal.noalias() += w * row * row.transpose();
    right += w * h * row;
  }
  Matrix6 damped = normal;
  damped.diagonal().array() += Damping * sum;
  const Vector6 c = damped.ldlt().solve(right);
  if (!c.allFinite())
  {
    return fit;
  }
  // The residual is computed as a sum of squares. If the fit is good, the residual of the normal
  // equations is dominated by rounding.
  double rest = 0.0;
  for (std::size_t i = 0; i < count; ++i)
  {
    const Eigen::Vector3d d = place(i);
    const double u = x.dot(d);
    const double v = y.dot(d);
    const double off =
      z.dot(d) - (c[0] + u * c[1] + v * c[2] + u * u * c[3] + u * v * c[4] + v * v * c[5]);
    rest += weigh(d) * off * off;
  }
  const double freedom =
    static_cast<double>(count) / std::max(1.0, static_cast<double>(count) - 6.0);
  fit.Residual = radius * std::sqrt(rest / sum * freedom);
  const Eigen::Vector3d direction = z - c[1] * x - c[2] * y;
  const double slope = direction.norm();
  fit.Normal = FromEigen(direction / slope);
  fit.ToSurface = FromEigen(radius * c[0] * z);
  // Principal curvatures: eigenvalues of the second fundamental form with respect to the first.
  Eigen::Matrix2d first;
  first << 1.0 + c[1] * c[1], c[1] * c[2], c[1] * c[2], 1.0 + c[2] * c[2];
  Eigen::Matrix2d second;
  second << 2.0 * c[3], c[4], c[4], 2.0 * c[5];
  second /= slope * radius;
  const Eigen::Matrix2d shape = first.inverse() * second;
  const double half = 0.5 * shape.trace();
  const double root = std::sqrt(std::max(0.0, half * half - shape.determinant()));
  fit.Curvature = std::abs(half) + root;
  return fit;
}
}
