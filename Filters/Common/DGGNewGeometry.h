// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What outputs have in common that are new geometry on a surface. Internal.
#ifndef DGGNewGeometry_h
#define DGGNewGeometry_h

#include "vtkDGGFiltersCommonModule.h" // for the export macro
#include "dggSurfacePath.h"            // for SurfacePath
#include "dggSurfacePoint.h"           // for SurfacePoint
#include "dggTypes.h"                  // for Status

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

/// Paths, loops, samples, cells: outputs whose points lie on a surface but are not its points. Here
/// is what vtkGeodesicAlgorithm promises of all of them: which field data they have, of which
/// precision their points are, how they name cells and points of the input.
class VTKDGGFILTERSCOMMON_EXPORT DGGNewGeometry
{
public:
  DGGNewGeometry();
  ~DGGNewGeometry();
  DGGNewGeometry(const DGGNewGeometry&) = delete;
  DGGNewGeometry& operator=(const DGGNewGeometry&) = delete;

  /// Take from a surface what outputs need. `precision` is one of
  /// vtkAlgorithm::DesiredOutputPrecision. Fails when coordinates are out of the range of the
  /// floats that are asked for.
  dgg::Status Take(const DGGContext& context, int precision);

  /// The mesh that was taken; it must live on.
  const dgg::SurfaceMesh& GetMesh() const;

  /// x y z per vertex.
  const double* GetPositions() const;

  /// Make an output empty but for the field data.
  void Begin(vtkPolyData* output) const;
  /// Points to be set.
  vtkSmartPointer<vtkPoints> MakePoints(std::size_t size) const;
  void SetPoint(vtkPoints* points, vtkIdType i, const dgg::SurfacePoint& place) const;

  /// For `vtkOriginalPointIds`: the point of the input, -1 where the place is not at one.
  static vtkIdType GetPointId(const dgg::SurfacePoint& place);
  /// For `FaceId`: the cell of the input that a face is a part of, -1 for no face.
  vtkIdType GetCell(dgg::Id face) const;
  /// Makes the array `Barycentric`; null unless all polygons of the surface are triangles.
  vtkSmartPointer<vtkDoubleArray> MakeBarycentric(std::size_t size) const;
  /// Sets the coordinates, in the cell of `face`, of a point; 0 for no face. The array may be null.
  void SetBarycentric(
    vtkDoubleArray* array, vtkIdType i, const dgg::SurfacePoint& point, dgg::Id face) const;

private:
  const dgg::PreparedSurface* Mesh = nullptr;
  std::unique_ptr<DGGSurfaceArrays> Cells; // of the input
  std::unique_ptr<dgg::CellCoordinates>
    Coordinates; // null for clouds and for surfaces with other cells than triangles
  vtkNew<vtkFieldData> Fields;
  int DataType;
};

/// Makes an output of surface points: points with verts, and the point arrays
/// `vtkOriginalPointIds`, `FaceId` and `Barycentric`.
VTKDGGFILTERSCOMMON_EXPORT void DGGFillSurfacePoints(const std::vector<dgg::SurfacePoint>& places,
  const DGGNewGeometry& geometry, vtkPolyData* output);

/// Fills points and polylines, curve by curve, with the point data FaceId, Barycentric,
/// vtkOriginalPointIds and ArcLength. Curves without faces are those of a cloud, straight in space
/// from point to point.
class VTKDGGFILTERSCOMMON_EXPORT DGGPolylineWriter
{
public:
  /// `size` is the number of points of all polylines.
  DGGPolylineWriter(const DGGNewGeometry& geometry, vtkIdType size);

  /// The points that a curve takes: a closed one begins and ends with the same.
  static vtkIdType CountPoints(const dgg::SurfacePath& path, bool isClosed);
  /// Append a curve, which is not empty. One that is a point becomes a polyline from that point to
  /// itself, as a polyline of one point is no valid cell.
  void Add(const dgg::SurfacePath& path, bool isClosed = false);
  /// Put all of it into an output that is empty but for field data.
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
