// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Vector graphics as a task. Internal.
#ifndef dggGraphicsTask_h
#define dggGraphicsTask_h

#include "dggCoreExport.h"         // for DGG_CORE_EXPORT
#include "dggGraphicsInput.h"      // for drawings
#include "dggGraphicsRefinement.h" // for refinement
#include "dggOutput.h"             // for Output
#include "dggVectorGraphics.h"     // for VectorGraphics

#include <cstddef> // for std::size_t
#include <cstdint> // for the build number
#include <string>  // for names
#include <vector>  // for points

namespace dgg
{
struct TaskContext;

struct GraphicsSettings
{
  std::string ResultName;
  int RefinementLevel = 1;
  RefinedPart Refinement = RefinedPart::Everything;
  std::vector<double> Background; ///< color; further channels have 0
  bool IsIntrinsicDelaunay = true;
  bool WantFragments = false;
  int FragmentDivision = 1;
  ///@{
  /// Bytes of the arrays of the input.
  double BytesPerPoint = 0.0;
  double BytesPerCell = 0.0;
  ///@}
  std::string MemoryRemedy; ///< action besides raising the memory limit
};

/// Colors a surface. The cut and factorized surface is kept while curves and settings are the same;
/// colors may change.
class DGG_CORE_EXPORT GraphicsTask
{
public:
  /// Fails if the name of the result is empty or that of another array of the output.
  static Status CheckName(const std::string& resultName);

  /// Computes the colored surface, and fragments if wanted. `places` are the points of all curves
  /// in succession.
  Status Run(const TaskContext& context, const GraphicsDrawing& drawing,
    const std::vector<SurfacePoint>& places, const GraphicsSettings& settings, Output& surface,
    Output& fragments);

  /// Writes the arrays of the colored surface for a surface without points.
  static void WriteEmpty(const std::string& resultName, Output& output);

  int GetNumberOfFactorizations() const { return this->NumberOfFactorizations; }
  /// Returns the approximate memory in bytes.
  double GetEstimatedMemory() const { return this->Graphics.GetEstimatedMemory(); }

private:
  /// The inputs that a factorization depends on.
  struct Sketch
  {
    std::uint64_t MeshBuild = 0;
    std::vector<SurfacePoint> Places;  // points of all curves in succession
    std::vector<std::size_t> Sizes;    // numbers of points of the curves
    std::vector<GraphicsCurve> Curves; // types and closedness
    GraphicsRefinement Refinement;
    bool IsIntrinsicDelaunay = false;

    bool IsSame(const Sketch& other) const;
  };

  Status Prepare(const TaskContext& context, const Sketch& sketch, const GraphicsOptions& options,
    const std::string& remedy, const ProgressCallback& progress);
  Status Draw(const TaskContext& context, const Sketch& sketch, const GraphicsOptions& options,
    const std::string& remedy, const ProgressCallback& progress);

  VectorGraphics Graphics;
  Sketch Kept; // input that Graphics is prepared for
  bool IsKept = false;
  std::vector<Id> RefinedFaces; // faces within those selected for refinement
  int NumberOfFactorizations = 0;
};
}

#endif
