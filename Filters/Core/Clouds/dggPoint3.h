// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Points and vectors in space.
#ifndef dggPoint3_h
#define dggPoint3_h

#include "dggTypes.h" // for Id

#include <cmath>   // for std::sqrt
#include <cstddef> // for std::size_t

namespace dgg
{
struct Point3
{
  double X = 0.0;
  double Y = 0.0;
  double Z = 0.0;
};

inline Point3 operator+(const Point3& a, const Point3& b)
{
  return { a.X + b.X, a.Y + b.Y, a.Z + b.Z };
}
inline Point3 operator-(const Point3& a, const Point3& b)
{
  return { a.X - b.X, a.Y - b.Y, a.Z - b.Z };
}
inline Point3 operator*(double factor, const Point3& a)
{
  return { factor * a.X, factor * a.Y, factor * a.Z };
}
inline double Dot(const Point3& a, const Point3& b)
{
  return a.X * b.X + a.Y * b.Y + a.Z * b.Z;
}
inline Point3 Cross(const Point3& a, const Point3& b)
{
  return { a.Y * b.Z - a.Z * b.Y, a.Z * b.X - a.X * b.Z, a.X * b.Y - a.Y * b.X };
}
inline double Norm(const Point3& a)
{
  return std::sqrt(Dot(a, a));
}
inline bool IsFinite(const Point3& a)
{
  return std::isfinite(a.X) && std::isfinite(a.Y) && std::isfinite(a.Z);
}
/// Returns point i of `points`, x y z each.
inline Point3 PointAt(const double* points, Id i)
{
  const double* p = points + 3 * static_cast<std::size_t>(i);
  return { p[0], p[1], p[2] };
}
}

#endif
