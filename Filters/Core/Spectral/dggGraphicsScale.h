// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Colours of any size. Internal.
#ifndef dggGraphicsScale_h
#define dggGraphicsScale_h

#include "dggVectorGraphics.h" // for curves and regions

#include <cstddef> // for std::size_t
#include <string>  // for what is told
#include <vector>  // for numbers

namespace dgg
{
/// Powers of two by which the channels of a drawing are divided while its colours are found. These
/// are linear in what is given, so that nothing overflows or vanishes on the way that does not do
/// so in the end. Channels of usual size, from 2^-100 to 2^100, stay as they are; others are moved
/// just into that range, so that what is much smaller in them is not lost.
class ChannelScale
{
public:
  /// By the largest number of each channel. All must be finite, and as many as are needed.
  ChannelScale(const std::vector<GraphicsCurve>& curves, const std::vector<GraphicsRegion>& regions,
    const GraphicsOptions& options);

  /// Divide numbers, all channels after each other.
  std::vector<double> Apply(std::vector<double> values) const;
  /// The colours of curves divided.
  std::vector<GraphicsCurve> Apply(std::vector<GraphicsCurve> curves) const;
  /// Multiply results again. Fails, with a message that says `what` they are, where one is beyond
  /// the largest number.
  Status Undo(std::vector<double>& values, const std::string& what) const;

private:
  std::vector<int> Exponents; // per channel
  bool IsNeeded = false;      // one of them is not 0
};
}

#endif
