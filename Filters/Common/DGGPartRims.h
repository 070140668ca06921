// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Identifies points on the boundaries of parts of a surface. Internal.
#ifndef DGGPartRims_h
#define DGGPartRims_h

#include "DGGSurfaceParts.h" // for the parts

#include "dggDisjointSets.h" // for sets of points

/// Joins points that have the same position on the boundaries of different parts, see
/// DGGJoinedParts. Indices in `points` count the points of all parts in succession.
void DGGJoinRims(const std::vector<DGGSurfacePart>& parts, dgg::DisjointSets& points);

#endif
