// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Surfaces in parts.
#ifndef PartTestTools_h
#define PartTestTools_h

#include "FilterTestTools.h"

#include <string>
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

/// Where cells come in another order, angles in graphs are rounded to other floats, and with them
/// corrected distances.
constexpr double FloatTolerance = 1e-7;

/// Expects that an array of the points of a part is that of the whole, up to `tolerance` times its
/// largest value.
void ExpectArray(vtkPolyData* part, vtkPolyData* whole, const std::string& name, double tolerance);
/// Expects that outputs of a filter on parts of a surface are those on the whole surface: arrays at
/// the points of parts; new geometry and tables in the first process, in any order.
void ExpectOutputsOfParts(vtkAlgorithm* onParts, vtkAlgorithm* onWhole, bool isFirst = true);

/// A terrain with a seam along half of the line in the middle: points of its sides lie in the same
/// places.
vtkSmartPointer<vtkPolyData> MakeSeam(int n);
}

#endif
