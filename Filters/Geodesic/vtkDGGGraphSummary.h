// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What there is to tell of a graph. Internal.
#ifndef vtkDGGGraphSummary_h
#define vtkDGGGraphSummary_h

#include "dggGeodesicGraph.h" // for GraphView

#include <cstddef> // for std::size_t

/// Numbers of a graph by value. The arrays of a graph belong to field data, where anybody may empty
/// them at any time: what getters of filters tell must not be read from them.
struct vtkDGGGraphSummary
{
  dgg::GraphInfo Info;
  dgg::Id NumberOfVertices = 0;
  dgg::Offset NumberOfEdges = 0;
  std::size_t MemorySize = 0; ///< bytes of the arrays

  vtkDGGGraphSummary() = default;
  explicit vtkDGGGraphSummary(const dgg::GraphView& graph)
    : Info(graph.Info)
    , NumberOfVertices(graph.NumberOfVertices)
    , NumberOfEdges(graph.GetNumberOfEdges())
  {
    const std::size_t perEdge = sizeof(dgg::Id) + (graph.Lengths ? sizeof(float) : sizeof(double)) +
      (graph.Angles ? 2 * sizeof(float) : 0);
    this->MemorySize = static_cast<std::size_t>(this->NumberOfEdges) * perEdge +
      (static_cast<std::size_t>(this->NumberOfVertices) + 1) * sizeof(dgg::Offset);
  }
};

#endif
// VTK-HeaderTest-Exclude: vtkDGGGraphSummary.h
