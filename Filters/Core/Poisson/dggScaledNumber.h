// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Numbers with the precision of double and an unlimited range. Internal.
#ifndef dggScaledNumber_h
#define dggScaledNumber_h

#include <cmath>   // for std::exp
#include <cstdint> // for the exponent

namespace dgg
{
/// Mantissa * 2^(512 Exponent), with a mantissa of absolute value in [2^-256, 2^256), or 0.
/// Temperature falls by a factor of about three per edge: beyond some 700 edges it is too small for
/// a double.
class ScaledNumber
{
public:
  ScaledNumber() = default;
  explicit ScaledNumber(double value)
    : Mantissa(value)
  {
    this->Normalize();
  }
  /// Returns e to the power of x.
  static ScaledNumber Exp(double x)
  {
    constexpr double step = 512.0 * 0.693147180559945309417232;
    const double steps = std::round(x / step);
    ScaledNumber number(std::exp(x - steps * step));
    number.Exponent += static_cast<std::int64_t>(steps);
    return number;
  }

  bool IsZero() const { return this->Mantissa == 0.0; }
  std::int64_t GetExponent() const { return this->Exponent; }

  /// Returns the value times 2^(-512 exponent) as a double, which may underflow or overflow.
  double Relative(std::int64_t exponent) const
  {
    switch (this->Exponent - exponent)
    {
      case 0:
        return this->Mantissa;
      case 1:
        return this->Mantissa * Large;
      case -1:
        return this->Mantissa * Small;
      default:
        return this->Exponent < exponent || this->IsZero() ? 0.0 : this->Mantissa * HUGE_VAL;
    }
  }

  ScaledNumber operator*(double factor) const
  {
    ScaledNumber product;
    product.Mantissa = this->Mantissa * factor;
    product.Exponent = this->Exponent;
    product.Normalize();
    return product;
  }

  ScaledNumber& operator+=(const ScaledNumber& other)
  {
    if (this->IsZero())
    {
      *this = other;
    }
    else if (!other.IsZero())
    {
      // If exponents differ by at least two, the smaller number is below the rounding error.
      if (this->Exponent >= other.Exponent)
      {
        this->Mantissa += other.Relative(this->Exponent);
      }
      else
      {
        this->Mantissa = this->Relative(other.Exponent) + other.Mantissa;
        this->Exponent = other.Exponent;
      }
      this->Normalize();
    }
    return *this;
  }

private:
  static constexpr double Large = 1.3407807929942597e154; // 2^512
  static constexpr double Small = 1.0 / Large;
  static constexpr double Highest = 1.157920892373162e77; // 2^256
  static constexpr double Lowest = 1.0 / Highest;

  void Normalize()
  {
    const double size = std::abs(this->Mantissa);
    if (size >= Highest)
    {
      this->Mantissa *= Small;
      ++this->Exponent;
    }
    else if (size < Lowest && size > 0.0)
    {
      this->Mantissa *= Large;
      --this->Exponent;
    }
  }

  double Mantissa = 0.0;
  std::int64_t Exponent = 0;
};
}

#endif
