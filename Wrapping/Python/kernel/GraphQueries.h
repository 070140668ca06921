// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Distances and matrices of a graph.
#ifndef GraphQueries_h
#define GraphQueries_h

#include "Graph.h"

namespace dggPython
{
/// Adds the methods that search a graph.
void AddGraphQueries(py::class_<Graph, std::shared_ptr<Graph>>& type);
}

#endif
