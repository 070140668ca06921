// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Outputs that are new points and curves on a surface. Internal.
#ifndef dggSurfaceOutput_h
#define dggSurfaceOutput_h

#include "dggCoreExport.h"   // for DGG_CORE_EXPORT
#include "dggOutput.h"       // for Output
#include "dggSurfacePath.h"  // for SurfacePath
#include "dggSurfacePoint.h" // for SurfacePoint

#include <vector> // for points and curves

namespace dgg
{
class PreparedSurface;
struct TaskContext;

/// A polyline of an output.
struct OutputCurve
{
  const SurfacePath* Path; ///< not empty; paths on clouds have no faces
  bool IsClosed = false;   ///< true if the last point repeats the first
};

/// Writes the points, with verts and the point arrays `vtkOriginalPointIds`, `FaceId` and
/// `Barycentric` (if all polygons of the input are triangles).
DGG_CORE_EXPORT void WriteSurfacePoints(
  const TaskContext& context, const std::vector<SurfacePoint>& points, Output& output);

/// Writes the curves as lines, with the point arrays `FaceId`, `Barycentric`, `vtkOriginalPointIds`
/// and `ArcLength`. A closed curve begins and ends with the same point of the output. A curve of
/// one point becomes a line from that point to itself, because a polyline needs two ends. Returns
/// `ArcLength`.
DGG_CORE_EXPORT const double* WriteCurves(
  const TaskContext& context, const std::vector<OutputCurve>& curves, Output& output);

/// Returns one cell with the points 0 to `numberOfPoints` - 1.
DGG_CORE_EXPORT OutputCells MakeCellOfAllPoints(Offset numberOfPoints);

///@{
/// Helpers for other outputs: writes the positions (x y z) of points; writes a vert per point;
/// returns the id of the input point at a surface point, -1 if there is none; returns the cell of
/// the input that contains a face, -1 for NoId.
DGG_CORE_EXPORT void WritePositions(
  const PreparedSurface& surface, const std::vector<SurfacePoint>& points, Output& output);
DGG_CORE_EXPORT void WriteVerts(std::size_t size, Output& output);
DGG_CORE_EXPORT Offset GetOriginalPoint(const SurfacePoint& point);
DGG_CORE_EXPORT Offset GetOriginalCell(const PreparedSurface& surface, Id face);
///@}
}

#endif
