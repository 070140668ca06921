// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A graph that filters search. Internal.
#ifndef DGGPreparedGraph_h
#define DGGPreparedGraph_h

#include "DGGGraphArrays.h"     // for the arrays
#include "dggPreparedSurface.h" // for the surface

#include "dggGraphSearch.h" // for GraphSearch

#include <memory> // for sharing

/// The arrays of a graph with what searches in it need. It does not change once it is made, so that
/// filters that search the same arrays on the same surface share it, in any threads: those of a
/// chain, and those that answer many queries about one graph.
class DGGPreparedGraph
{
public:
  using Pointer = std::shared_ptr<const DGGPreparedGraph>;

  /// For the valid graph of a surface: one that is in use already, or else a new one. It keeps both
  /// of them alive.
  static Pointer Make(const DGGGraphArrays& arrays, const dgg::PreparedSurface& surface);

  /// Use Make().
  DGGPreparedGraph(const DGGGraphArrays& arrays, const dgg::PreparedSurface& surface);

  const DGGGraphArrays& GetArrays() const { return this->Arrays; }
  const dgg::PreparedSurface& GetSurface() const { return *this->Surface; }
  /// Its numbers, also when somebody has emptied the arrays.
  const dgg::GraphSummary& GetSummary() const { return this->Summary; }
  /// To be copied by those who use landmarks.
  const dgg::GraphSearch& GetSearch() const { return this->Search; }

private:
  DGGGraphArrays Arrays;
  dgg::PreparedSurface::Pointer Surface;
  dgg::GraphSummary Summary;
  dgg::GraphSearch Search;
};

#endif
