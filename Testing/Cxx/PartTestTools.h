// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Surfaces in parts.
#ifndef PartTestTools_h
#define PartTestTools_h

#include "FilterTestTools.h"

#include <vector>

namespace dggtest
{
/// Of each cell, the part that it goes to.
using Labels = std::vector<int>;

/// Cells in `parts` strips of equal numbers along x.
Labels LabelStrips(vtkPolyData* surface, int parts);
/// Connected parts, grown from random cells.
Labels LabelRandomly(vtkPolyData* surface, int parts, unsigned int seed);

enum class PartIds
{
  None,
  Global, ///< of points and cells
};

/// The cells with a label. The point array "Whole" has the ids of its points in the surface. With
/// `ghosts`, also all cells at their points, marked.
vtkSmartPointer<vtkPolyData> TakePart(vtkPolyData* surface, const Labels& labels, int label,
  PartIds ids = PartIds::None, bool ghosts = false);

/// A terrain with a seam along half of the line in the middle: points of its sides lie in the same
/// places.
vtkSmartPointer<vtkPolyData> MakeSeam(int n);
}

#endif
