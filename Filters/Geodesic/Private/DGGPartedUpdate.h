// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Update of a filter whose inputs consist of parts. Internal.
#ifndef DGGPartedUpdate_h
#define DGGPartedUpdate_h

#include "DGGContext.h"     // for the surface of a graph
#include "DGGGraphArrays.h" // for the graph of the pieces
#include "DGGJoinedParts.h" // for the wholes
#include "DGGProcesses.h"   // for those that have parts

#include "vtkInformationVector.h" // for inputs and outputs of the step

#include <functional> // for the step
#include <tuple>      // for the key
#include <vector>     // for the ports

/// Joins the parts of the inputs (blocks, partitions and pieces of other processes), runs the
/// computation on the joined surfaces on the first process, and distributes the results to the
/// parts. Joined surfaces are kept for the next update as long as the parts are unchanged.
/// If the parts have the graphs of pieces, they are joined, too.
class DGGPartedUpdate
{
public:
  /// Computes on joined inputs and fills outputs. Called with null on processes other than the
  /// first.
  using Step = std::function<dgg::Status(vtkInformationVector**, vtkInformationVector*)>;

  /// Returns true if each input is a single part on this process alone.
  static bool IsPlain(vtkInformationVector** inputs, int numberOfInputs);

  /// Fills the outputs on all processes or on none. If `passesSurface`, output 0 is input 0 with
  /// arrays added, and is divided into the parts of the input; other outputs are on the first
  /// process as a whole. `limit` is the largest number of points that may be gathered, `memory` a
  /// MemoryLimit for the messages. The processes agree by `group`. If a process runs out of memory
  /// while sending, the other processes hang.
  dgg::Status Run(const DGGProcesses& processes, dgg::ProcessGroup& group, vtkIdType limit,
    vtkTypeUInt64 memory, vtkInformationVector** inputs, int numberOfInputs,
    vtkInformationVector* outputs, bool passesSurface, const Step& step);

  /// Adds the joined graph of the pieces, if there is one, to the joined surface that is the input
  /// of the context. Called by the step.
  void AddGraph(const DGGContext& context);

  /// Joins the parts of an input on this process alone.
  static dgg::Status Join(vtkDataObject* input, vtkSmartPointer<vtkPolyData>& whole);

  /// Returns the number of leaves of inputs that are not vtkPolyData.
  vtkIdType GetNumberOfOthers() const { return this->Others; }

private:
  using PartKey = std::tuple<const void*, vtkMTimeType, int>; // object, time, block

  struct Port
  {
    std::vector<PartKey> Key;          // keys of the parts on this process
    std::vector<DGGSurfacePart> Parts; // parts on this process, without ghosts
    std::vector<std::size_t> Counts;   // number of parts per process
    DGGJoinedParts Joined;             // on the first process only
  };

  dgg::Status FindParts(const DGGProcesses& processes, vtkIdType limit, vtkTypeUInt64 memory,
    vtkInformationVector** inputs);
  dgg::Status CheckMemory(
    const DGGProcesses& processes, vtkTypeUInt64 limit, const std::vector<int>& isSame) const;
  dgg::Status Compute(vtkInformationVector** inputs, vtkInformationVector* outputs,
    bool passesSurface, const Step& step);
  dgg::Status JoinGraphs(const DGGProcesses& processes, const std::vector<DGGSurfacePart>& all);
  dgg::Status JoinGraphsHere(
    const std::vector<DGGArrayList>& arrays, const std::vector<DGGSurfacePart>& all);
  void Deliver(vtkDataObject* input, vtkDataObject* output, bool removesGraph);

  std::vector<Port> Ports;
  DGGProcesses Processes{ nullptr }; // processes of the last update
  vtkIdType Others = 0;
  dgg::GeodesicGraph JoinedGraph;                      // until AddGraph()
  DGGGraphArrays Graph;                                // joined graph, on the first process
  std::vector<vtkSmartPointer<vtkDataObject>> Outputs; // outputs of the step
  std::vector<DGGPartResult> Results;                  // results of the parts, for output 0
};

#endif
