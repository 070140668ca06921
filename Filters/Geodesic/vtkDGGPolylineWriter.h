// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Curves on a surface as polylines. Internal.
#ifndef vtkDGGPolylineWriter_h
#define vtkDGGPolylineWriter_h

#include "dggSurfacePath.h" // for SurfacePath

#include "vtkCellArray.h"    // for the polylines
#include "vtkDoubleArray.h"  // for ArcLength
#include "vtkIdTypeArray.h"  // for FaceId
#include "vtkNew.h"          // for the points
#include "vtkPoints.h"       // for the points
#include "vtkSmartPointer.h" // for the arrays
#include "vtkType.h"         // for vtkIdType

class vtkDGGNewGeometry;
class vtkPolyData;

/// Fills points and polylines, curve by curve, with the point data FaceId, vtkOriginalPointIds and
/// ArcLength. Curves without faces are those of a cloud, straight in space from point to point.
class vtkDGGPolylineWriter
{
public:
  /// `size` is the number of points of all polylines.
  vtkDGGPolylineWriter(const vtkDGGNewGeometry& geometry, vtkIdType size);

  /// The points that a curve takes: a closed one begins and ends with the same.
  static vtkIdType CountPoints(const dgg::SurfacePath& path, bool isClosed);
  /// Append a curve, which is not empty. One that is a point becomes a polyline from that point to
  /// itself, as a polyline of one point is no valid cell.
  void Add(const dgg::SurfacePath& path, bool isClosed = false);
  /// Put all of it into an output that is empty but for field data.
  void AddTo(vtkPolyData* output) const;

private:
  double MeasurePiece(const dgg::SurfacePath& path, std::size_t piece) const;
  vtkIdType FindCell(const dgg::SurfacePath& path, std::size_t i) const;

  const vtkDGGNewGeometry& Geometry;
  vtkIdType Next = 0;
  vtkSmartPointer<vtkPoints> Points;
  vtkNew<vtkCellArray> Lines;
  vtkSmartPointer<vtkIdTypeArray> Faces;
  vtkSmartPointer<vtkIdTypeArray> PointIds;
  vtkSmartPointer<vtkDoubleArray> ArcLengths;
};

#endif
// VTK-HeaderTest-Exclude: vtkDGGPolylineWriter.h
