// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The tree of shortest paths behind the labels of a search. Internal.
#ifndef dggSearchTree_h
#define dggSearchTree_h

#include "dggSearchLabels.h" // for SearchLabels

#include <vector> // for the steps

namespace dgg
{
/// A reached vertex and how it was reached.
struct TreeStep
{
  Offset Edge; ///< from the tail; -1 for a seed
  Id Vertex;
  Id Tail; ///< NoId for a seed
};

/// Write what the labels say into a result whose distances they share: edges, tails and seeds;
/// unreached vertices become Infinity. `steps` receives the reached vertices, every one after its
/// tail.
void FinishTree(const SearchLabels& labels, SearchResult& result, std::vector<TreeStep>& steps);
}

#endif
