// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Surfaces that are split into pieces.
#ifndef PartTestTools_h
#define PartTestTools_h

#include "FilterTestTools.h"

namespace dggtest
{
/// Piece index of each cell.
using Labels = std::vector<int>;

/// Assigns cells to `parts` strips along x with equal numbers of cells.
Labels LabelStrips(vtkPolyData* surface, int parts);
/// Assigns cells to connected pieces, grown from random cells.
Labels LabelRandomly(vtkPolyData* surface, int parts, unsigned int seed);

/// Assigns cells to boxes by recursive bisection along x and y in turn; parts differ by one cell.
Labels LabelBisection(vtkPolyData* surface, int parts);
/// Assigns each cell to a random piece.
Labels LabelScattered(vtkPolyData* surface, int parts);

enum class PartIds
{
  None,
  Global, ///< global ids of points and cells
};

/// Returns the cells with a label. The point array "Whole" contains the point ids in the input
/// surface. With `ghosts`, all cells at these points are added and marked as ghosts.
vtkSmartPointer<vtkPolyData> TakePart(vtkPolyData* surface, const Labels& labels, int label,
  PartIds ids = PartIds::None, bool ghosts = false);

/// Relative tolerance of distances when the order of cells differs: angles in graphs, and therefore
/// corrected distances, are rounded differently.
constexpr double FloatTolerance = 1e-7;

/// Expects that a point array of a piece equals that of the parent mesh, up to `tolerance` times
/// its largest value.
void ExpectArray(vtkPolyData* part, vtkPolyData* whole, const std::string& name, double tolerance);
/// Expects that the outputs of a filter on pieces of a surface equal those on the parent mesh:
/// arrays at the points of pieces; new geometry and tables in the first process, in any order.
void ExpectOutputsOfParts(vtkAlgorithm* onParts, vtkAlgorithm* onWhole, bool isFirst = true);

/// Returns a terrain with a seam along half of its middle line: points on both sides of the seam
/// coincide.
vtkSmartPointer<vtkPolyData> MakeSeam(int n);
}

#endif
