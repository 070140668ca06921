// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BruteForceGeodesics.h"

#include <algorithm>
#include <cmath>

namespace dggtest
{
namespace
{
using dgg::Id;
using dgg::NoId;
using dgg::SurfaceMesh;

struct Vector
{
  double X;
  double Y;
};

Vector operator-(const Vector& a, const Vector& b)
{
  return { a.X - b.X, a.Y - b.Y };
}
double Cross(const Vector& a, const Vector& b)
{
  return a.X * b.Y - a.Y * b.X;
}
double Norm(const Vector& a)
{
  return std::hypot(a.X, a.Y);
}
Vector Between(const Vector& a, const Vector& b, double t)
{
  return { a.X + t * (b.X - a.X), a.Y + t * (b.Y - a.Y) };
}

/// Returns the third corner of a triangle on the left of a -> b, at distances da and db from a and
/// b.
Vector ThirdCorner(const Vector& a, const Vector& b, double da, double db)
{
  const Vector u = b - a;
  const double l = Norm(u);
  const double x = (l * l + da * da - db * db) / (2.0 * l);
  const double y = std::sqrt(std::max(0.0, da * da - x * x));
  return { a.X + (u.X * x - u.Y * y) / l, a.Y + (u.Y * x + u.X * y) / l };
}

/// Returns the parameter t at which the ray from the source (the origin of the plane) in the
/// direction d crosses a + t (b - a).
double ParameterOf(const Vector& d, const Vector& a, const Vector& b)
{
  return std::min(1.0, std::max(0.0, Cross(a, d) / Cross(d, b - a)));
}

double DistanceToSegment(const Vector& a, const Vector& b)
{
  const Vector u = b - a;
  const double t = -(a.X * u.X + a.Y * u.Y) / (u.X * u.X + u.Y * u.Y);
  return Norm(Between(a, b, std::min(1.0, std::max(0.0, t))));
}

/// Cones of straight lines from one vertex, continued through all face sequences.
class Sweep
{
public:
  Sweep(const SurfaceMesh& mesh, double* row, double bound)
    : Mesh(mesh)
    , Row(row)
    , Bound(bound)
  {
  }

  void Shine(Id v)
  {
    for (const Id* g = this->Mesh.FanBegin(v); g != this->Mesh.FanEnd(v); ++g)
    {
      const Id exit = SurfaceMesh::Next(*g);
      const Vector a{ this->Mesh.Length(*g), 0.0 };
      const Vector b = ThirdCorner(
        { 0.0, 0.0 }, a, this->Mesh.Length(SurfaceMesh::Previous(*g)), this->Mesh.Length(exit));
      this->CrossEdge(exit, a, b, 0.0, 1.0);
    }
  }

private:
  /// Continues the cone through the half-edge `exit` between the parameters t0 and t1. The
  /// half-edge is laid out from a to b with the source on its left.
  void CrossEdge(Id exit, const Vector& a, const Vector& b, double t0, double t1)
  {
    if (t1 - t0 < 1e-12 || DistanceToSegment(Between(a, b, t0), Between(a, b, t1)) > this->Bound)
    {
      return;
    }
    for (Id e = this->Mesh.Twin(exit); e != NoId && e != exit; e = this->Mesh.Twin(e))
    {
      // The next face lies on the right of a -> b, that is, on the left of b -> a.
      const bool opposed = this->Mesh.Origin(e) == this->Mesh.Destination(exit);
      const Id toApexOfB = opposed ? SurfaceMesh::Previous(e) : SurfaceMesh::Next(e);
      const Id toApexOfA = opposed ? SurfaceMesh::Next(e) : SurfaceMesh::Previous(e);
      const Vector c =
        ThirdCorner(b, a, this->Mesh.Length(toApexOfB), this->Mesh.Length(toApexOfA));
      const double tc = Cross(a, c) / Cross(c, b - a); // parameter of the ray to the apex
      if (tc >= t0 && tc <= t1)
      {
        double& d = this->Row[this->Mesh.Apex(e)];
        d = std::min(d, Norm(c));
      }
      const Vector first = Between(a, b, t0);
      const Vector last = Between(a, b, t1);
      // The source is on the left of the edges a -> c and c -> b, but the half-edges of the face
      // may have either direction.
      if (tc > t0)
      {
        this->Leave(toApexOfA, this->Mesh.Apex(e) == this->Mesh.Destination(toApexOfA), a, c,
          ParameterOf(first, a, c), tc <= t1 ? 1.0 : ParameterOf(last, a, c));
      }
      if (tc < t1)
      {
        this->Leave(toApexOfB, this->Mesh.Apex(e) == this->Mesh.Origin(toApexOfB), c, b,
          tc >= t0 ? 0.0 : ParameterOf(first, c, b), ParameterOf(last, c, b));
      }
    }
  }

  /// Calls CrossEdge() with the end points in the order of the half-edge; `inOrder` is true if p is
  /// the origin. Otherwise the layout is mirrored to keep the source on the left.
  void Leave(Id exit, bool inOrder, const Vector& p, const Vector& q, double t0, double t1)
  {
    if (inOrder)
    {
      this->CrossEdge(exit, p, q, t0, t1);
    }
    else
    {
      this->CrossEdge(exit, { q.X, -q.Y }, { p.X, -p.Y }, 1.0 - t1, 1.0 - t0);
    }
  }

  const SurfaceMesh& Mesh;
  double* Row;
  double Bound;
};
}

std::vector<double> BruteForceDistances(const SurfaceMesh& mesh)
{
  const auto n = static_cast<std::size_t>(mesh.GetNumberOfVertices());
  std::vector<double> d(n * n, dgg::Infinity);
  for (std::size_t v = 0; v < n; ++v)
  {
    d[v * n + v] = 0.0;
  }
  for (Id h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
  {
    if (!mesh.IsDropped(SurfaceMesh::Face(h)))
    {
      const auto a = static_cast<std::size_t>(mesh.Origin(h));
      const auto b = static_cast<std::size_t>(mesh.Destination(h));
      d[a * n + b] = std::min(d[a * n + b], mesh.Length(h));
      d[b * n + a] = std::min(d[b * n + a], mesh.Length(h));
    }
  }
  auto join = [&]() {
    for (std::size_t k = 0; k < n; ++k)
    {
      for (std::size_t i = 0; i < n; ++i)
      {
        for (std::size_t j = 0; j < n; ++j)
        {
          d[i * n + j] = std::min(d[i * n + j], d[i * n + k] + d[k * n + j]);
        }
      }
    }
  };
  join();
  for (std::size_t v = 0; v < n; ++v)
  {
    double bound = 0.0;
    for (std::size_t w = 0; w < n; ++w)
    {
      bound = d[v * n + w] < dgg::Infinity ? std::max(bound, d[v * n + w]) : bound;
    }
    Sweep(mesh, d.data() + v * n, bound * (1.0 + 1e-9)).Shine(static_cast<Id>(v));
  }
  for (std::size_t v = 0; v < n; ++v)
  {
    for (std::size_t w = 0; w < n; ++w)
    {
      d[v * n + w] = std::min(d[v * n + w], d[w * n + v]);
    }
  }
  join();
  return d;
}
}
