// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggGraphicsChecks.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace dgg
{
namespace
{
Status CheckNumbers(const std::vector<double>& values, std::size_t count, const std::string& what)
{
  if (values.size() != count)
  {
    return Status::Invalid(what + " has " + std::to_string(values.size()) + " numbers where " +
      std::to_string(count) + " are needed");
  }
  if (!std::all_of(values.begin(), values.end(), [](double x) { return std::isfinite(x); }))
  {
    return Status::Invalid(what + " has numbers that are not finite");
  }
  return Status::Success();
}

bool HasRight(GraphicsCurveType type)
{
  return type == GraphicsCurveType::Diffusion || type == GraphicsCurveType::Poisson;
}
}

std::string NameOf(const GraphicsCurve& curve, std::size_t number)
{
  return curve.Name.empty() ? "curve " + std::to_string(number) : curve.Name;
}

Status CheckGraphicsOptions(const GraphicsOptions& options)
{
  if (options.NumberOfChannels < 1)
  {
    return Status::Invalid("there are no channels: ask for at least one");
  }
  return options.Background.empty()
    ? Status::Success()
    : CheckNumbers(options.Background, options.NumberOfChannels, "the background");
}

Status CheckGraphicsCurve(const GraphicsCurve& curve, std::size_t number, std::size_t count)
{
  const std::string name = NameOf(curve, number);
  Status status = CheckNumbers(curve.Left, count, name + ", on its left,");
  if (status.IsOk() && HasRight(curve.Type))
  {
    status = CheckNumbers(curve.Right, count, name + ", on its right,");
  }
  const bool isPoisson = curve.Type == GraphicsCurveType::Poisson;
  if (status.IsOk() && isPoisson && !(curve.Width > 0.0 && std::isfinite(curve.Width)))
  {
    status = Status::Invalid(name + " has the width " + std::to_string(curve.Width) +
      ": a Poisson curve needs a positive, finite one");
  }
  return status;
}

Status CheckGraphicsRegion(
  const GraphicsRegion& region, std::size_t number, std::size_t channels, Id numberOfFaces)
{
  const std::string name = "region " + std::to_string(number);
  if (region.Faces.empty())
  {
    return Status::Invalid(name + " has no faces");
  }
  for (const Id f : region.Faces)
  {
    if (f < 0 || f >= numberOfFaces)
    {
      return Status::Invalid(name + " has the face " + std::to_string(f) +
        ", which does not exist: ids must be in [0, " + std::to_string(numberOfFaces - 1) + "]");
    }
  }
  return CheckNumbers(region.Strength, channels, name);
}
}
