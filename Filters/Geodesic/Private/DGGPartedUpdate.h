// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// An update of a filter whose inputs come in parts. Internal.
#ifndef DGGPartedUpdate_h
#define DGGPartedUpdate_h

#include "DGGJoinedParts.h" // for the wholes
#include "DGGProcesses.h"   // for those that have parts

#include "vtkInformationVector.h" // for inputs and outputs of the step

#include <functional> // for the step
#include <tuple>      // for the key
#include <vector>     // for the ports

/// Joins the parts of the inputs, blocks, partitions and what other processes have, has the first
/// process compute on the whole, and hands the results back to the parts. What is joined is kept
/// for the next update, as long as the parts are the same.
///
/// A graph that is distributed would begin here: with a step for each process in place of the
/// gathering.
class DGGPartedUpdate
{
public:
  /// Computes on whole inputs, and fills outputs.
  using Step = std::function<dgg::Status(vtkInformationVector**, vtkInformationVector*)>;

  /// Whether an input is one part, on this process alone.
  static bool IsPlain(vtkInformationVector** inputs, int numberOfInputs);

  /// Outputs are filled on all processes, or none. `passesSurface`: output 0 is input 0 with arrays
  /// added, and gets its parts; other outputs come as a whole on the first process. `limit` is the
  /// most points that may be gathered, `memory` a MemoryLimit for the messages.
  /// Memory that is exhausted in the midst of a message is not repaired: others wait for ever.
  dgg::Status Run(const DGGProcesses& processes, vtkIdType limit, vtkTypeUInt64 memory,
    vtkInformationVector** inputs, int numberOfInputs, vtkInformationVector* outputs,
    bool passesSurface, const Step& step);

  /// The whole of an input, on this process alone.
  static dgg::Status Join(vtkDataObject* input, vtkSmartPointer<vtkPolyData>& whole);

  /// Leaves of inputs that were no vtkPolyData.
  vtkIdType GetNumberOfOthers() const { return this->Others; }

private:
  using PartKey = std::tuple<const void*, vtkMTimeType, int>; // object, time, block

  struct Port
  {
    std::vector<PartKey> Key;          // of the parts on this process
    std::vector<DGGSurfacePart> Parts; // those here, without ghosts
    std::vector<std::size_t> Counts;   // of parts, per process
    DGGJoinedParts Joined;             // on the first process
  };

  dgg::Status FindParts(const DGGProcesses& processes, vtkIdType limit, vtkTypeUInt64 memory,
    vtkInformationVector** inputs);
  dgg::Status CheckMemory(
    const DGGProcesses& processes, vtkTypeUInt64 limit, const std::vector<int>& isSame) const;
  dgg::Status Compute(vtkInformationVector** inputs, vtkInformationVector* outputs,
    bool passesSurface, const Step& step);
  void Deliver(vtkDataObject* input, vtkDataObject* output);

  std::vector<Port> Ports;
  DGGProcesses Processes{ nullptr }; // that Ports are of
  vtkIdType Others = 0;
  std::vector<vtkSmartPointer<vtkDataObject>> Outputs; // of the step
  std::vector<DGGPartResult> Results;                  // of parts, for output 0
};

#endif
