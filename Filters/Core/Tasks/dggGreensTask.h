// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Green's functions of sources as a task. Internal.
#ifndef dggGreensTask_h
#define dggGreensTask_h

#include "dggGreensFunction.h"      // for queries
#include "dggGreensInterpolation.h" // for columns
#include "dggSpectralTask.h"        // for the base

#include <optional> // for kept functions
#include <vector>   // for methods

namespace dgg
{
/// Computes the Green's function of each source. Columns of vertices are kept until the surface
/// changes.
class DGG_CORE_EXPORT GreensTask : public SpectralTask
{
public:
  GreensQuery Query; ///< targets and progress are set here
  /// True to interpolate the regular parts of SingularitySubtraction.
  bool IsInterpolated = false;

  /// Method that was used for a source.
  struct UsedMethod
  {
    int Method = -1; ///< a GreensMethod; -1 if there is no such source
    GreensRemark Remark = GreensRemark::None;
    double Radius = 0.0;
  };

  ///@{
  /// Returns the result of a source; there is none after Forget() or a failure.
  UsedMethod GetUsed(Offset source) const
  {
    const bool exists = source >= 0 && source < static_cast<Offset>(this->Used.size());
    return exists ? this->Used[source] : UsedMethod();
  }
  void Forget() { this->Used.clear(); }
  ///@}

  ///@{
  /// Return the number of columns that are kept, and their size in bytes.
  Id GetNumberOfColumns() const { return this->Columns ? this->Columns->GetNumberOfColumns() : 0; }
  std::size_t GetMemorySize() const { return this->Columns ? this->Columns->GetMemorySize() : 0; }
  ///@}

protected:
  double EstimateMemory(const TaskContext& context, const PoissonSolver& solver,
    std::size_t numberOfSources, std::size_t numberOfTargets) const override;
  Status Compute(const SpectralRun& run) override;

private:
  Status RunBlocks(const SpectralRun& run, const GreensQuery& query);
  Status RunOneByOne(const SpectralRun& run, const GreensQuery& query);
  void Store(const SpectralRun& run, std::size_t source, const GreensResult& result);
  void Warn(std::vector<std::string>& warnings) const;

  ///@{
  /// Functions on the solver of SolverNumber.
  std::optional<GreensFunction> Function;
  std::optional<GreensInterpolation> Columns;
  int SolverNumber = 0;
  ///@}
  std::vector<UsedMethod> Used;
};
}

#endif
