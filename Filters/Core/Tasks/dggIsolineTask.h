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

#include <array>  // for ranges
#include <string> // for names
#include <vector> // for values

namespace dgg
{
class FieldReader;
class ProcessGroup;
struct FieldPieces;
struct Output;
struct TaskContext;

struct DGG_CORE_EXPORT IsolineTaskOptions
{
  /// Fails if a value is not finite or an option is out of range.
  Status Check() const;

  std::vector<double> Values;   ///< distances of the lines
  double ChordTolerance = 1e-3; ///< largest distance from the level set / mean edge length
  /// Apollonius needs windows or virtual sources; other fields are linear in each triangle.
  IsolineMethod Method = IsolineMethod::LocalSources;
  int SteinerPoints = 2; ///< see IsolineOptions
  bool WithRidges = false;
  double MinimumRidgeAngle = 20.0; ///< degrees; see RidgeOptions
  bool WithBands = false;
};

struct IsolineResult
{
  Isolines Lines;
  dgg::Ridges Ridges;
  dgg::Bands Bands;
};

/// Finds lines and, if requested, ridges and bands. There are no ridges in a field that is linear
/// in each face. If several processes have pieces of the surface, all of them must call the
/// function, and request ridges only if the field is not linear.
DGG_CORE_EXPORT Status FindIsolines(const TaskContext& context, const DistanceField& field,
  const IsolineTaskOptions& options, const ProgressCallback& progress, IsolineResult& result,
  FieldPieces* pieces = nullptr);

///@{
/// Returns a warning about ridges that are missing or unreliable, or if only lines are requested
/// and there are none although points are reached; otherwise an empty text. `range` is that of the
/// distances (FieldReader::FindRange()).
DGG_CORE_EXPORT std::string DescribeRidges(
  const IsolineTaskOptions& options, const FieldReader& reader);
DGG_CORE_EXPORT std::string DescribeMissingLines(
  const IsolineTaskOptions& options, const std::array<double, 2>& range, bool hasLines);
///@}
/// Describes the lines of all processes on the first one; elsewhere the warning is empty. Must be
/// called by all processes, with the range and lines of each.
DGG_CORE_EXPORT Status DescribeMissingLines(ProcessGroup& group, const IsolineTaskOptions& options,
  const std::array<double, 2>& range, bool hasLines, std::string& warning);

/// Writes lines with the cell array `IsoValue`; ridges with the cell array `RidgeAngle`, degrees;
/// bands with the point arrays `distances` and `vtkOriginalPointIds` and the cell arrays `Band`,
/// `BandMinimum`, `BandMaximum` and `FaceId`; each to an output.
DGG_CORE_EXPORT void WriteIsolines(const TaskContext& context, const IsolineResult& result,
  const std::vector<double>& values, const std::string& distances, Output (&outputs)[3]);
}

#endif
