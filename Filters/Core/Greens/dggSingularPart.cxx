// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggSingularPart.h"

#include "dggTypes.h"
#include "dggUnfolding.h"

#include <algorithm>
#include <cmath>

namespace dgg
{
namespace
{
/// Nodes and weights of Gauss-Legendre quadrature on [-1, 1]: exact to degree 7, sufficient for
/// u^3.
constexpr double Nodes[2] = { 0.33998104358485626480, 0.86113631159405257522 };
constexpr double NodeWeights[2] = { 0.65214515486254614263, 0.34785484513745385737 };

/// Returns -(u - 1) + (u - 1)^2 / 2 - (u - 1)^3 / 3.
double Cut(double u)
{
  return 11.0 / 6.0 - u * (3.0 - u * (1.5 - u / 3.0));
}

/// Returns the polynomial part of H. With s = -(log u + Cut(u)) / (2 Theta) and z the vector from
/// the pole, z H has divergence s, where H = -(log(u) / 2 + CutMoment(u)) / (2 Theta).
double CutMoment(double u)
{
  return 5.0 / 12.0 - u * (0.75 - u * (0.25 - u / 24.0));
}

/// Returns S without its factor.
double PotentialOf(double u)
{
  return (u > 0.0 ? u * std::log(u) : 0.0) + 1.0 / 3.0 + u * (0.5 - u * (1.0 - u / 6.0));
}

/// Returns the antiderivative of log(t^2 + y^2) for y >= 0.
double LogarithmTo(double t, double y)
{
  const double square = t * t + y * y;
  return (square > 0.0 ? t * std::log(square) : 0.0) - 2.0 * t + 2.0 * y * std::atan2(t, y);
}

/// The part inside the disk of a segment on a line at height y above the pole, in units of R;
/// abscissae are relative to the foot of the pole.
class Chord
{
public:
  Chord(double length, double fromOrigin, double fromEnd, double radius)
  {
    if (!(length > 0.0) || !(fromOrigin < Infinity) || !(fromEnd < Infinity))
    {
      return;
    }
    const double foot = FootOnEdge(length, fromOrigin, fromEnd);
    this->Height = 2.0 * TriangleArea(length, fromOrigin, fromEnd) / length / radius;
    this->Begin = -foot / radius;
    this->End = (length - foot) / radius;
    const double half =
      this->Height < 1.0 ? std::sqrt((1.0 - this->Height) * (1.0 + this->Height)) : 0.0;
    this->From = std::min(std::max(this->Begin, -half), this->End);
    this->To = std::max(std::min(this->End, half), this->From);
    this->Inside = half > 0.0 && this->From<half&& this->To> - half && this->To > this->From;
  }

  bool IsInside() const { return this->Inside; }
  double GetHeight() const { return this->Height; }

  /// Returns the integral of log(t^2 + y^2).
  double IntegrateLogarithm() const
  {
    return LogarithmTo(this->To, this->Height) - LogarithmTo(this->From, this->Height);
  }
  /// Returns the integral of a function that is a cubic polynomial of u = t^2 + y^2 or close to
  /// one.
  double Integrate(double (*polynomial)(double)) const
  {
    const double middle = 0.5 * (this->From + this->To);
    const double reach = 0.5 * (this->To - this->From);
    double sum = 0.0;
    for (int k = 0; k < 2; ++k)
    {
      for (const double t : { middle - reach * Nodes[k], middle + reach * Nodes[k] })
      {
        sum += NodeWeights[k] * polynomial(t * t + this->Height * this->Height);
      }
    }
    return reach * sum;
  }
  /// Returns the angle at the pole of the part outside the disk.
  double GetAngleOutside() const
  {
    if (!(this->Height > 0.0))
    {
      return 0.0;
    }
    const double all = std::atan2(this->End, this->Height) - std::atan2(this->Begin, this->Height);
    const double inside = this->Inside
      ? std::atan2(this->To, this->Height) - std::atan2(this->From, this->Height)
      : 0.0;
    return std::max(0.0, all - inside);
  }

private:
  double Height = 0.0;
  double Begin = 0.0;
  double End = 0.0;
  double From = 0.0;
  double To = 0.0;
  bool Inside = false;
};

/// Returns the integral of s over a triangle in the plane.
double IntegrateOver(
  const Logarithm& logarithm, const std::array<Point2, 3>& corners, const Point2& pole)
{
  double sum = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    const Point2& a = corners[k];
    const Point2& b = corners[(k + 1) % 3];
    const double sector =
      logarithm.IntegrateSector(Distance(a, b), Distance(pole, a), Distance(pole, b));
    sum += Cross(Difference(b, a), Difference(pole, a)) < 0.0 ? -sector : sector;
  }
  return sum;
}

/// Returns the shares of the corners in the integral of s over a triangle close to the pole. The
/// triangle is laid out on its first side, with the pole above or below, whichever fits better, and
/// divided into `division`^2 small triangles, in each of which hat functions are treated as
/// constant.
std::array<double, 3> IntegrateNear(const Logarithm& logarithm,
  const IntrinsicTriangulation& triangulation, Id f, const std::array<double, 3>& d, int division)
{
  const double base = triangulation.Length(3 * f);
  const Point2 apex = triangulation.Apex(f);
  Point2 pole = LayOut(base, d[0], d[1]);
  const double above = std::abs(Distance(pole, apex) - d[2]);
  const double below = std::abs(Distance({ pole.X, -pole.Y }, apex) - d[2]);
  pole.Y = below < above ? -pole.Y : pole.Y;
  const double step = 1.0 / division;
  const auto at = [&](int i, int j) {
    return Point2{ step * (i * base + j * apex.X), step * j * apex.Y };
  };
  std::array<double, 3> parts{ { 0.0, 0.0, 0.0 } };
  const auto add = [&](double i, double j, const std::array<Point2, 3>& corners) {
    const double integral = IntegrateOver(logarithm, corners, pole);
    parts[0] += (1.0 - step * (i + j)) * integral;
    parts[1] += step * i * integral;
    parts[2] += step * j * integral;
  };
  for (int i = 0; i < division; ++i)
  {
    for (int j = 0; i + j < division; ++j)
    {
      add(i + 1.0 / 3.0, j + 1.0 / 3.0, { { at(i, j), at(i + 1, j), at(i, j + 1) } });
      if (i + j + 1 < division)
      {
        add(i + 2.0 / 3.0, j + 2.0 / 3.0, { { at(i + 1, j + 1), at(i, j + 1), at(i + 1, j) } });
      }
    }
  }
  return parts;
}

/// Returns the same shares as IntegrateNear(), by three-point quadrature. The quadrature is exact
/// for quadratic functions, and far from the pole s is smooth. In the plane the squared distance
/// from a point, with barycentric coordinates b, is sum_i b_i d_i^2 - sum_{i<j} b_i b_j l_ij^2.
std::array<double, 3> IntegrateFar(const Logarithm& logarithm,
  const IntrinsicTriangulation& triangulation, Id f, const std::array<double, 3>& d, bool isLumped)
{
  std::array<double, 3> parts{ { 0.0, 0.0, 0.0 } };
  for (int node = 0; node < 3; ++node)
  {
    std::array<double, 3> b{ { 1.0 / 6.0, 1.0 / 6.0, 1.0 / 6.0 } };
    b[node] = 2.0 / 3.0;
    double square = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      const double length = triangulation.Length(3 * f + k);
      square += b[k] * d[k] * d[k] - b[k] * b[(k + 1) % 3] * length * length;
    }
    const double value =
      square > 0.0 ? logarithm.At(std::sqrt(square)) * triangulation.Area(f) / 3.0 : 0.0;
    for (int k = 0; k < 3; ++k)
    {
      parts[k] += (isLumped ? 1.0 / 3.0 : b[k]) * value;
    }
  }
  return parts;
}

/// Minimum distance of a far face, in longest sides of the face.
constexpr double FarSides = 4.0;
/// Subdivision of the sides of near faces if the shares of their corners are needed.
constexpr int NearDivision = 4;
}

Logarithm::Logarithm(double radius, double angle)
  : Radius(radius)
  , Angle(angle)
{
}

double Logarithm::At(double distance) const
{
  if (!(distance < this->Radius))
  {
    return 0.0;
  }
  if (!(distance > 0.0))
  {
    return Infinity;
  }
  const double ratio = distance / this->Radius;
  const double u = ratio * ratio;
  return -(2.0 * std::log(ratio) + Cut(u)) / (2.0 * this->Angle);
}

double Logarithm::MeanOverDisk(double radius) const
{
  const double ratio = std::min(1.0, radius / this->Radius);
  return -(std::log(ratio) + CutMoment(ratio * ratio)) / this->Angle;
}

double Logarithm::IntegrateAlong(double length, double fromOrigin, double fromEnd) const
{
  const Chord chord(length, fromOrigin, fromEnd, this->Radius);
  if (!chord.IsInside())
  {
    return 0.0;
  }
  return -0.5 / this->Angle * this->Radius * (chord.IntegrateLogarithm() + chord.Integrate(Cut));
}

double Logarithm::PotentialAt(double distance) const
{
  const double ratio = distance / this->Radius;
  return ratio < 1.0
    ? this->Radius * this->Radius / (8.0 * this->Angle) * PotentialOf(ratio * ratio)
    : 0.0;
}

double Logarithm::IntegratePotentialAlong(double length, double fromOrigin, double fromEnd) const
{
  const Chord chord(length, fromOrigin, fromEnd, this->Radius);
  return chord.IsInside()
    ? std::pow(this->Radius, 3) / (8.0 * this->Angle) * chord.Integrate(PotentialOf)
    : 0.0;
}

double Logarithm::IntegrateSector(double length, double fromOrigin, double fromEnd) const
{
  const Chord chord(length, fromOrigin, fromEnd, this->Radius);
  // The integral beyond R depends on the angle only.
  double sector = chord.GetAngleOutside() / 16.0;
  if (chord.IsInside())
  {
    sector -=
      0.5 * chord.GetHeight() * (0.5 * chord.IntegrateLogarithm() + chord.Integrate(CutMoment));
  }
  return sector / this->Angle * this->Radius * this->Radius;
}

void SingularPart::Assemble(const Logarithm& logarithm, const std::vector<double>& distances,
  const std::vector<PoleFace>& poleFaces, bool hasPotential)
{
  const IntrinsicTriangulation& triangulation = this->System.GetTriangulation();
  const std::size_t n = distances.size();
  this->Loads.assign(n, 0.0);
  this->PotentialLoads.assign(hasPotential ? n : 0, 0.0);
  this->Integrals.assign(n, 0.0);
  this->Means.resize(triangulation.GetNumberOfHalfEdges());
  this->IsDone.assign(triangulation.GetNumberOfHalfEdges(), 0);
  // The edges of faces that contain the pole, by their first half-edges.
  struct PoleEdge
  {
    Id HalfEdge;
    double FromOrigin;
    double FromEnd;
  };
  std::vector<PoleEdge> poleEdges;
  for (const PoleFace& pole : poleFaces)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Id h = 3 * pole.Face + k;
      poleEdges.push_back(
        { triangulation.FirstOfEdge(h), pole.Distances[k], pole.Distances[(k + 1) % 3] });
    }
  }
  const double radius = logarithm.GetRadius();
  for (Id f = 0; f < triangulation.GetNumberOfFaces(); ++f)
  {
    std::array<double, 3> d;
    std::array<Id, 3> v;
    double least = Infinity;
    for (int k = 0; k < 3; ++k)
    {
      v[k] = triangulation.Origin(3 * f + k);
      d[k] = distances[v[k]];
      least = std::min(least, d[k] - triangulation.Length(3 * f + k));
    }
    if (!(least < radius) || !(std::max({ d[0], d[1], d[2] }) < Infinity))
    {
      continue; // too far away
    }
    for (const PoleFace& pole : poleFaces)
    {
      d = pole.Face == f ? pole.Distances : d;
    }
    std::array<std::array<double, 2>, 3> means; // means of s and S on the side opposite to corner k
    double longest = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      const Id h = 3 * f + k;
      const double length = triangulation.Length(h);
      const Id first = triangulation.FirstOfEdge(h);
      longest = std::max(longest, length);
      if (!this->IsDone[first])
      {
        this->IsDone[first] = 1;
        double fromOrigin = distances[v[k]];
        double fromEnd = distances[v[(k + 1) % 3]];
        for (const PoleEdge& edge : poleEdges)
        {
          if (edge.HalfEdge == first)
          {
            fromOrigin = edge.FromOrigin;
            fromEnd = edge.FromEnd;
          }
        }
        this->Means[first] = { { logarithm.IntegrateAlong(length, fromOrigin, fromEnd) / length,
          hasPotential ? logarithm.IntegratePotentialAlong(length, fromOrigin, fromEnd) / length
                       : 0.0 } };
      }
      means[(k + 2) % 3] = this->Means[first];
    }
    const std::array<double, 3> cotangents = this->System.GetCotangents(f);
    const bool isFar = std::min({ d[0], d[1], d[2] }) > FarSides * longest;
    const std::array<double, 3> parts = isFar
      ? IntegrateFar(logarithm, triangulation, f, d, !hasPotential)
      : IntegrateNear(logarithm, triangulation, f, d, hasPotential ? NearDivision : 1);
    for (int i = 0; i < 3; ++i)
    {
      const int j = (i + 1) % 3;
      const int k = (i + 2) % 3;
      const auto loadOf = [&](int part) {
        return cotangents[k] * (means[i][part] - means[j][part]) +
          cotangents[j] * (means[i][part] - means[k][part]);
      };
      this->Loads[v[i]] += loadOf(0);
      if (hasPotential)
      {
        this->PotentialLoads[v[i]] += loadOf(1);
      }
      this->Integrals[v[i]] += parts[i];
    }
  }
}
}
