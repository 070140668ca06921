// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Whether a search can start from given seeds. Internal.
#ifndef dggGraphSeeds_h
#define dggGraphSeeds_h

#include "dggGraphSearch.h" // for GraphSeed

#include <vector> // for the seeds

namespace dgg
{
/// Fails with a message when a vertex does not exist.
Status CheckVertex(Id vertex, Id numberOfVertices);

/// Fails with a message when there is no seed, or one does not exist or starts with a distance that
/// is not finite.
Status CheckSeeds(const std::vector<GraphSeed>& seeds, Id numberOfVertices);
}

#endif
