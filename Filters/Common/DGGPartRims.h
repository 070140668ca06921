// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Which points of parts of a surface are the same. Internal.
#ifndef DGGPartRims_h
#define DGGPartRims_h

#include "DGGSurfaceParts.h" // for the parts

#include "dggDisjointSets.h" // for sets of points

/// Join points that lie in the same place on the rims of different parts, see DGGJoinedParts. The
/// numbers in `points` are those of all parts, one after the other.
void DGGJoinRims(const std::vector<DGGSurfacePart>& parts, dgg::DisjointSets& points);

#endif
