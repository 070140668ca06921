// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Common properties of outputs that are new geometry on a surface. Internal.
#ifndef DGGNewGeometry_h
#define DGGNewGeometry_h

#include "vtkDGGFiltersCommonModule.h" // for the export macro
#include "dggSurfacePath.h"            // for SurfacePath
#include "dggSurfacePoint.h"           // for SurfacePoint
#include "dggStatus.h"                 // for Status

#include "vtkCellArray.h"    // for polylines
#include "vtkDoubleArray.h"  // for ArcLength
#include "vtkIdTypeArray.h"  // for FaceId
#include "vtkNew.h"          // for the field data
#include "vtkPoints.h"       // for points
#include "vtkSmartPointer.h" // for points
#include "vtkType.h"         // for vtkIdType

#include <cstddef> // for std::size_t
#include <memory>  // for the coordinates
#include <vector>  // for the positions

class DGGSurfaceArrays;
namespace dgg
{
class CellCoordinates;
class PreparedSurface;
}
class vtkFieldData;
class vtkPolyData;
struct DGGContext;

/// Common base of outputs whose points lie on a surface but are not its points: paths, loops,
/// samples, cells. Implements the guarantees of vtkGeodesicAlgorithm for all of them: field data,
/// precision of points, and ids of cells and points of the input.
class VTKDGGFILTERSCOMMON_EXPORT DGGNewGeometry
{
public:
  DGGNewGeometry();
  ~DGGNewGeometry();
  DGGNewGeometry(const DGGNewGeometry&) = delete;
  DGGNewGeometry& operator=(const DGGNewGeometry&) = delete;

  /// Stores the data of a surface that outputs need. `precision` is a value of
  /// vtkAlgorithm::DesiredOutputPrecision. Fails if floats are requested and coordinates exceed
  /// their range.
  dgg::Status Take(const DGGContext& context, int precision);

  /// Returns the mesh of Take(), which must outlive this object.
  const dgg::SurfaceMesh& GetMesh() const;

  /// Returns x y z per vertex.
  const double* GetPositions() const;

  /// Removes all data of an output and sets the field data.
  void Begin(vtkPolyData* output) const;
  /// Returns points with uninitialized coordinates.
  vtkSmartPointer<vtkPoints> MakePoints(std::size_t size) const;
  void SetPoint(vtkPoints* points, vtkIdType i, const dgg::SurfacePoint& place) const;

  /// Returns the value of `vtkOriginalPointIds`: the point of the input at `place`, -1 if there is
  /// none.
  static vtkIdType GetPointId(const dgg::SurfacePoint& place);
  /// Returns the value of `FaceId`: the cell of the input that contains a face, -1 for no face.
  vtkIdType GetCell(dgg::Id face) const;
  /// Returns the array `Barycentric`; null unless all polygons of the surface are triangles.
  vtkSmartPointer<vtkDoubleArray> MakeBarycentric(std::size_t size) const;
  /// Sets the coordinates of a point in the cell of `face`; 0 for no face. The array may be null.
  void SetBarycentric(
    vtkDoubleArray* array, vtkIdType i, const dgg::SurfacePoint& point, dgg::Id face) const;

private:
  const dgg::PreparedSurface* Mesh = nullptr;
  std::unique_ptr<DGGSurfaceArrays> Cells; // cells of the input
  std::unique_ptr<dgg::CellCoordinates>
    Coordinates; // null for clouds and for surfaces with cells other than triangles
  vtkNew<vtkFieldData> Fields;
  int DataType;
};

/// Makes an output of surface points: points with verts, and the point arrays
/// `vtkOriginalPointIds`, `FaceId` and `Barycentric`.
VTKDGGFILTERSCOMMON_EXPORT void DGGFillSurfacePoints(const std::vector<dgg::SurfacePoint>& places,
  const DGGNewGeometry& geometry, vtkPolyData* output);

/// Collects points and polylines, curve by curve, with the point data FaceId, Barycentric,
/// vtkOriginalPointIds and ArcLength. Curves without faces belong to a cloud and are straight in
/// space between their points.
class VTKDGGFILTERSCOMMON_EXPORT DGGPolylineWriter
{
public:
  /// `size` is the number of points of all polylines.
  DGGPolylineWriter(const DGGNewGeometry& geometry, vtkIdType size);

  /// Returns the number of points of a curve in the output: a closed curve begins and ends with the
  /// same point.
  static vtkIdType CountPoints(const dgg::SurfacePath& path, bool isClosed);
  /// Appends a non-empty curve. A curve of one point becomes a polyline from that point to itself,
  /// because a polyline of one point is not a valid cell.
  void Add(const dgg::SurfacePath& path, bool isClosed = false);
  /// Adds all curves to an output that is empty except for its field data.
  void AddTo(vtkPolyData* output) const;

private:
  double MeasurePiece(const dgg::SurfacePath& path, std::size_t piece) const;
  dgg::Id FindFace(const dgg::SurfacePath& path, std::size_t i) const;

  const DGGNewGeometry& Geometry;
  vtkIdType Next = 0;
  vtkSmartPointer<vtkPoints> Points;
  vtkNew<vtkCellArray> Lines;
  vtkSmartPointer<vtkIdTypeArray> Faces;
  vtkSmartPointer<vtkDoubleArray> Barycentric; // may be null
  vtkSmartPointer<vtkIdTypeArray> PointIds;
  vtkSmartPointer<vtkDoubleArray> ArcLengths;
};

#endif
