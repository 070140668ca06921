// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What processes say to each other. Internal.
#ifndef DGGProcesses_h
#define DGGProcesses_h

#include "DGGJoinedParts.h" // for parts and results

#include <cstddef> // for std::size_t
#include <vector>  // for parts and results

class vtkMultiProcessController;

/// The processes that have parts of a surface. All of them call the same functions in the same
/// order. Without a controller there is only this one.
class DGGProcesses
{
public:
  explicit DGGProcesses(vtkMultiProcessController* controller)
    : Controller(controller)
  {
  }

  bool IsFirst() const;
  bool operator==(const DGGProcesses& other) const { return this->Controller == other.Controller; }

  /// Success if it went well everywhere, else what went wrong on the first process with an error.
  /// Nobody goes on alone, or waits for one that does not.
  dgg::Status Agree(const dgg::Status& status) const;
  vtkIdType Sum(vtkIdType number) const;
  /// Whether something holds on all of them, item by item.
  std::vector<int> AndAll(const std::vector<int>& holds) const;

  /// On the first process: append the parts of the others, process by process, and count those of
  /// each. Fails there when one does not arrive as it was sent; the others are received all the
  /// same.
  dgg::Status Gather(std::vector<DGGSurfacePart>& parts, std::vector<std::size_t>& counts) const;
  /// Back again: the first process has the results of all parts, the others get theirs.
  void Scatter(const std::vector<std::size_t>& counts, std::vector<DGGPartResult>& results) const;

private:
  vtkMultiProcessController* Controller;
};

#endif
