// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Number of edges per vertex, estimated from some vertices. Internal.
#ifndef dggDegreeSample_h
#define dggDegreeSample_h

#include <algorithm> // for std::max
#include <cmath>     // for std::sqrt

namespace dgg
{
/// Statistics of the number of edges found per vertex, from a sample of vertices.
class DegreeSample
{
public:
  void Add(double degree)
  {
    this->Count += 1.0;
    this->Sum += degree;
    this->SumOfSquares += degree * degree;
  }
  double GetMean() const { return this->Sum / this->Count; }
  /// Returns an upper bound of the mean over all vertices: three standard errors above the sample
  /// mean.
  double GetLargestMean() const
  {
    const double mean = this->GetMean();
    const double variance = std::max(0.0, this->SumOfSquares / this->Count - mean * mean);
    return mean + 3.0 * std::sqrt(variance / this->Count);
  }

private:
  double Count = 0.0;
  double Sum = 0.0;
  double SumOfSquares = 0.0;
};
}

#endif
