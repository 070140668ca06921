// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggGraphicsScale.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace dgg
{
namespace
{
/// Numbers from 2^-100 to 2^100 can be multiplied by those of meshes, and squared.
constexpr int UsualExponent = 100;

/// What is not used may be anything.
void FindLargest(const std::vector<double>& values, std::vector<double>& largest)
{
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    double& found = largest[i % largest.size()];
    found = std::isfinite(values[i]) ? std::max(found, std::abs(values[i])) : found;
  }
}
}

ChannelScale::ChannelScale(const std::vector<GraphicsCurve>& curves,
  const std::vector<GraphicsRegion>& regions, const GraphicsOptions& options)
{
  std::vector<double> largest(static_cast<std::size_t>(options.NumberOfChannels), 0.0);
  FindLargest(options.Background, largest);
  for (const GraphicsCurve& curve : curves)
  {
    FindLargest(curve.Left, largest);
    FindLargest(curve.Right, largest);
  }
  for (const GraphicsRegion& region : regions)
  {
    FindLargest(region.Strength, largest);
  }
  for (const double value : largest)
  {
    const int exponent = value > 0.0 ? std::ilogb(value) : 0;
    const int usual = std::min(std::max(exponent, -UsualExponent), UsualExponent);
    this->Exponents.push_back(exponent - usual);
    this->IsNeeded = this->IsNeeded || exponent != usual;
  }
}

std::vector<double> ChannelScale::Apply(std::vector<double> values) const
{
  for (std::size_t i = 0; i < values.size() && this->IsNeeded; ++i)
  {
    values[i] = std::ldexp(values[i], -this->Exponents[i % this->Exponents.size()]);
  }
  return values;
}

std::vector<GraphicsCurve> ChannelScale::Apply(std::vector<GraphicsCurve> curves) const
{
  for (GraphicsCurve& curve : curves)
  {
    curve.Left = this->Apply(std::move(curve.Left));
    curve.Right = this->Apply(std::move(curve.Right));
  }
  return curves;
}

Status ChannelScale::Undo(std::vector<double>& values, const std::string& what) const
{
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const std::size_t channel = i % this->Exponents.size();
    values[i] = this->IsNeeded ? std::ldexp(values[i], this->Exponents[channel]) : values[i];
    if (!std::isfinite(values[i]))
    {
      return Status::Invalid(what + " of channel " + std::to_string(channel) +
        " are beyond the largest number, 1.8e308: divide its colours, strengths and background by "
        "a number");
    }
  }
  return Status::Success();
}
}
