// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Voronoi cells of exact distances.
#ifndef dggWindowCells_h
#define dggWindowCells_h

#include "dggCoreExport.h"    // for DGG_CORE_EXPORT
#include "dggDistanceField.h" // for DistanceField
#include "dggParallel.h"      // for ParallelFor
#include "dggVoronoi.h"       // for VoronoiDiagram

namespace dgg
{
/// Computes the Voronoi diagram of the sources of a field, which must have windows and
/// NearestSource. Borders are traced like ridges (dggRidges.h): their points have equal distances
/// from both sites up to rounding, except within 1e-7 edges of points where cells meet, and their
/// segments deviate from the border by at most `tolerance`. The mesh is cut along them, and a
/// polygon belongs to the nearest site of a point inside it. The part of a cell in a face is one
/// polygon, or several triangles if it surrounds another cell.
DGG_CORE_EXPORT Status ComputeWindowCells(const DistanceField& field, double tolerance,
  const ParallelFor& parallel, const ProgressCallback& progress, VoronoiDiagram& diagram);
}

#endif
