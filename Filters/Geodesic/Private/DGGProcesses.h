// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Communication between processes. Internal.
#ifndef DGGProcesses_h
#define DGGProcesses_h

#include "DGGJoinedParts.h" // for parts and results

#include <cstddef> // for std::size_t
#include <vector>  // for parts and results

class vtkMultiProcessController;
namespace dgg
{
class ProcessGroup;
}

using DGGArrayList = std::vector<vtkSmartPointer<vtkAbstractArray>>;

/// Processes that have parts of a surface. All of them must call the same functions in the same
/// order. Without a controller this is the only process.
class DGGProcesses
{
public:
  explicit DGGProcesses(vtkMultiProcessController* controller)
    : Controller(controller)
  {
  }

  bool IsFirst() const;
  bool operator==(const DGGProcesses& other) const { return this->Controller == other.Controller; }

  /// Returns success if all processes succeeded, otherwise the error of the first process with an
  /// error. No process continues alone or waits for one that has stopped.
  dgg::Status Agree(const dgg::Status& status) const;
  vtkIdType Sum(vtkIdType number) const;
  /// Returns, item by item, true if the item is true on all processes.
  std::vector<int> AndAll(const std::vector<int>& holds) const;

  /// Gets the processes as a group. Returns false on all processes if they cannot exchange
  /// messages, or if `canJoin` is false on one of them; the group can only agree then.
  bool FindGroup(bool canJoin, dgg::ProcessGroup& group) const;

  /// Appends the parts of the other processes on the first process, process by process, with the
  /// number of parts of each. Fails there if a part arrives damaged; the remaining parts are
  /// received nevertheless.
  dgg::Status Gather(std::vector<DGGSurfacePart>& parts, std::vector<std::size_t>& counts) const;
  /// Joins the points and cells that all processes have of an input, on the first process;
  /// elsewhere `joined` is null. `here` may be null.
  dgg::Status JoinOnFirst(
    dgg::ProcessGroup& group, vtkDataObject* here, vtkSmartPointer<vtkPolyData>& joined) const;
  /// Sends the results of all parts from the first process to the processes of the parts; the
  /// inverse of Gather().
  void Scatter(const std::vector<std::size_t>& counts, std::vector<DGGPartResult>& results) const;

  /// Gathers arrays, one list per process, on the first process.
  std::vector<DGGArrayList> GatherArrays(const DGGArrayList& arrays) const;

private:
  vtkMultiProcessController* Controller;
};

#endif
