// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Distance field from the arrays of an output. Internal.
#ifndef dggFieldReader_h
#define dggFieldReader_h

#include "dggCoreExport.h"     // for DGG_CORE_EXPORT
#include "dggDistanceField.h"  // for DistanceField
#include "dggEdgeWindows.h"    // for EdgeWindows
#include "dggVirtualSources.h" // for VirtualSources

#include <array>   // for ranges
#include <string>  // for warnings
#include <utility> // for std::move
#include <vector>  // for distances

namespace dgg
{
class PreparedSurface;
struct InputArray;
struct SurfacePoint;
struct TaskContext;

/// Distances at points of the input, and the data that determine distances inside faces: windows,
/// or else virtual sources, or else virtual sources that are fitted to the distances. Values that
/// are too steep for distances are interpolated linearly, with a warning; further checks are not
/// made.
class DGG_CORE_EXPORT FieldReader
{
public:
  /// The surface must outlive this object.
  explicit FieldReader(const PreparedSurface& surface);

  /// Takes a distance per point of the input. Points are unreached if their distance is NaN,
  /// Infinity or `unreachedValue`; if `unreachedValue` is NaN, also where `marks`, the array of
  /// GetUnreachedName(), is not zero. Fails if another distance is minus infinity.
  Status SetDistances(const InputArray& distances, double unreachedValue, const InputArray& marks);
  /// Takes the windows of the distances.
  void SetWindows(EdgeWindows windows) { this->Windows = std::move(windows); }
  /// Takes the virtual sources (three numbers per point of the input: offset, length, angle), if
  /// there are any. Warns about virtual sources of another size or of other distances; they are
  /// ignored. No effect after SetWindows().
  void SetSources(const InputArray& sources);
  /// Fits virtual sources to the distances unless there are windows or virtual sources.
  Status Complete(const TaskContext& context, const ProgressCallback& progress);

  /// Returns the field, which is valid as long as this object exists.
  const DistanceField& GetField() const { return this->Field; }
  /// Returns the smallest and the largest distance; Infinity and -Infinity if no point is reached.
  std::array<double, 2> FindRange() const;
  /// Returns true if virtual sources were fitted to the distances.
  bool HasFittedSources() const { return this->IsFitted; }

  /// Adds a warning about arrays that are not used.
  void Warn(const std::string& warning) { this->Warnings.push_back(warning); }
  const std::vector<std::string>& GetWarnings() const { return this->Warnings; }
  /// Returns a warning if distances inside triangles may be far off, otherwise an empty text.
  std::string DescribeQuality() const;

private:
  bool HasSourcesOfDistances() const;

  const PreparedSurface& Surface;
  std::vector<double> Distances; // per vertex
  EdgeWindows Windows;
  VirtualSources Sources;
  DistanceField Field;
  std::vector<std::string> Warnings;
  bool IsFitted = false;
};

/// Evaluates a field at surface points; NaN where it is not reached. On an edge, the value is the
/// smallest distance of the reached faces, as for isolines: a shortest path may come through any of
/// them.
DGG_CORE_EXPORT Status ProbeField(const TaskContext& context, const DistanceField& field,
  const std::vector<SurfacePoint>& points, const ProgressCallback& progress, double* values);
}

#endif
