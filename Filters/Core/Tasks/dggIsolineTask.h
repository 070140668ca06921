// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Isolines, ridges and bands of distances as outputs. Internal.
#ifndef dggIsolineTask_h
#define dggIsolineTask_h

#include "dggBands.h"         // for Bands
#include "dggCoreExport.h"    // for DGG_CORE_EXPORT
#include "dggDistanceField.h" // for DistanceField
#include "dggIsolines.h"      // for Isolines
#include "dggRidges.h"        // for Ridges

#include <string> // for names
#include <vector> // for values

namespace dgg
{
struct Output;
struct TaskContext;

struct IsolineTaskOptions
{
  std::vector<double> Values; ///< distances of the lines
  IsolineOptions Lines;
  RidgeOptions Ridges;
  bool WithRidges = false;
  bool WithBands = false;
};

struct IsolineResult
{
  Isolines Lines;
  dgg::Ridges Ridges;
  dgg::Bands Bands;
};

/// Finds lines and, if requested, ridges and bands. There are no ridges in a field that is linear
/// in each face.
DGG_CORE_EXPORT Status FindIsolines(const TaskContext& context, const DistanceField& field,
  const IsolineTaskOptions& options, const ProgressCallback& progress, IsolineResult& result);

///@{
/// Writes lines with the cell array `IsoValue`; ridges with the cell array `RidgeAngle`, degrees;
/// bands with the point arrays `distances` and `vtkOriginalPointIds` and the cell arrays `Band`,
/// `BandMinimum`, `BandMaximum` and `FaceId`.
DGG_CORE_EXPORT void WriteIsolines(const TaskContext& context, const Isolines& lines,
  const std::vector<double>& values, Output& output);
DGG_CORE_EXPORT void WriteRidges(const TaskContext& context, const Ridges& ridges, Output& output);
DGG_CORE_EXPORT void WriteBands(
  const TaskContext& context, const Bands& bands, const std::string& distances, Output& output);
///@}
}

#endif
