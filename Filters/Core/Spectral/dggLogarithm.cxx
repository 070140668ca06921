// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggLogarithm.h"

#include "dggTypes.h"
#include "dggUnfolding.h"

#include <algorithm>
#include <cmath>

namespace dgg
{
namespace
{
/// Nodes and weights of Gauss on [-1, 1]: exact to degree 7, enough for u^3.
constexpr double Nodes[2] = { 0.33998104358485626480, 0.86113631159405257522 };
constexpr double NodeWeights[2] = { 0.65214515486254614263, 0.34785484513745385737 };

/// -(u - 1) + (u - 1)^2 / 2 - (u - 1)^3 / 3.
double Cut(double u)
{
  return 11.0 / 6.0 - u * (3.0 - u * (1.5 - u / 3.0));
}

/// With s = -(log u + Cut(u)) / (2 Theta) and z the way from the pole, z H has divergence s where
/// H = -(log(u) / 2 + CutMoment(u)) / (2 Theta).
double CutMoment(double u)
{
  return 5.0 / 12.0 - u * (0.75 - u * (0.25 - u / 24.0));
}

/// Antiderivative of log(t^2 + y^2), y not negative.
double LogarithmTo(double t, double y)
{
  const double square = t * t + y * y;
  return (square > 0.0 ? t * std::log(square) : 0.0) - 2.0 * t + 2.0 * y * std::atan2(t, y);
}

/// A segment on a line at height y over the pole, in units of R; abscissae count from the foot of
/// the pole. The part of it that is in the disk.
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

  /// Of log(t^2 + y^2).
  double IntegrateLogarithm() const
  {
    return LogarithmTo(this->To, this->Height) - LogarithmTo(this->From, this->Height);
  }
  /// Of a cubic polynomial of u = t^2 + y^2.
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
  /// At the pole, of what is outside of the disk.
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

double Logarithm::IntegrateSector(double length, double fromOrigin, double fromEnd) const
{
  const Chord chord(length, fromOrigin, fromEnd, this->Radius);
  // Beyond R it is the angle that counts.
  double sector = chord.GetAngleOutside() / 16.0;
  if (chord.IsInside())
  {
    sector -=
      0.5 * chord.GetHeight() * (0.5 * chord.IntegrateLogarithm() + chord.Integrate(CutMoment));
  }
  return sector / this->Angle * this->Radius * this->Radius;
}
}
