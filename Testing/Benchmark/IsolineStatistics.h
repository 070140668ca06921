// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// How far isolines are from where they should be.
#ifndef IsolineStatistics_h
#define IsolineStatistics_h

#include "SampleStatistics.h" // for the errors
#include "dggDistanceField.h" // for DistanceField
#include "dggIsolines.h"      // for Isolines

#include <benchmark/benchmark.h> // for State

#include <array>  // for barycentric coordinates
#include <vector> // for segments

/// A straight piece of an isoline within a face.
struct IsolineSegment
{
  dgg::Id Face = dgg::NoId;
  double Level = 0.0;
  double Length = 0.0;
  std::array<double, 3> Middle{ { 1.0, 0.0, 0.0 } }; ///< with respect to SurfaceMesh::GetTriangle()
};

/// The pieces of polylines on a mesh, those without length left out.
std::vector<IsolineSegment> ToSegments(
  const dgg::SurfaceMesh& mesh, const dgg::Isolines& lines, const std::vector<double>& levels);

/// The error of a segment is |d - c| / c, with the distance d at its midpoint and its level c.
class IsolineStatistics
{
public:
  IsolineStatistics(const dgg::DistanceField& exact, const std::vector<IsolineSegment>& segments);

  void Report(benchmark::State& state) const;

private:
  SampleStatistics Errors;
  double Length = 0.0;
  double ErrorTimesLength = 0.0;
  double Largest = -1.0;
  IsolineSegment Worst;
};

#endif
