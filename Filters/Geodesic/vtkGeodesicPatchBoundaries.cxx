// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGeodesicPatchBoundaries.h"

#include "vtkDGGMeshAdapter.h"
#include "vtkDGGPointCoordinates.h"
#include "vtkDGGProperties.h"
#include "vtkDGGSourceCollector.h"

#include "dggPatchBoundaries.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <limits>
#include <sstream>
#include <string>

vtkStandardNewMacro(vtkGeodesicPatchBoundaries);

namespace
{
std::vector<vtkIdType> ToVector(vtkIdList* ids)
{
  return ids ? std::vector<vtkIdType>(ids->begin(), ids->end()) : std::vector<vtkIdType>();
}

std::vector<dgg::SurfacePoint> ToPoints(const std::vector<dgg::GeodesicSource>& sources)
{
  std::vector<dgg::SurfacePoint> points;
  points.reserve(sources.size());
  for (const dgg::GeodesicSource& source : sources)
  {
    points.push_back(source.Point);
  }
  return points;
}

/// Numbers of landmarks from a cell. Those too large for the kernel are out of range there too.
std::vector<dgg::Id> ReadCell(vtkIdType size, const vtkIdType* ids)
{
  std::vector<dgg::Id> landmarks;
  for (vtkIdType i = 0; i < size; ++i)
  {
    const bool fits = ids[i] >= 0 && ids[i] <= std::numeric_limits<dgg::Id>::max();
    landmarks.push_back(fits ? static_cast<dgg::Id>(ids[i]) : dgg::NoId);
  }
  return landmarks;
}

template <typename Visitor>
void ForEachCell(vtkCellArray* cells, Visitor&& visit)
{
  auto iterator = vtk::TakeSmartPointer(cells->NewIterator());
  for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    iterator->GetCurrentCell(size, ids);
    visit(ReadCell(size, ids));
  }
}

dgg::PatchLayout ReadLayout(vtkPolyData* cells)
{
  dgg::PatchLayout layout;
  ForEachCell(
    cells->GetPolys(), [&](const std::vector<dgg::Id>& patch) { layout.Patches.push_back(patch); });
  ForEachCell(cells->GetLines(), [&](const std::vector<dgg::Id>& line) {
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
    {
      layout.Edges.push_back({ { line[i], line[i + 1] } });
    }
  });
  return layout;
}

template <typename Array>
vtkSmartPointer<Array> MakeArray(const char* name, int components, vtkIdType tuples)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  return array;
}

/// The arrays of the output, and the polylines.
void FillOutput(const dgg::PatchBoundaries& boundaries, int side, const vtkDGGMeshAdapter& mesh,
  vtkPoints* coordinates, vtkPolyData* output)
{
  const std::vector<dgg::SurfacePath>& curves = boundaries.Curves[side];
  vtkIdType count = 0;
  for (const dgg::SurfacePath& curve : curves)
  {
    count += static_cast<vtkIdType>(curve.Points.size());
  }
  const auto cells = static_cast<vtkIdType>(curves.size());
  auto layoutEdges = MakeArray<vtkIdTypeArray>("LayoutEdge", 2, cells);
  auto lengths = MakeArray<vtkDoubleArray>("Length", 1, cells);
  auto arcLengths = MakeArray<vtkDoubleArray>("ArcLength", 1, count);
  auto faces = MakeArray<vtkIdTypeArray>("FaceId", 1, count);
  auto originals = MakeArray<vtkIdTypeArray>("vtkOriginalPointIds", 1, count);
  vtkNew<vtkPoints> points;
  points->SetDataType(coordinates->GetDataType());
  points->SetNumberOfPoints(count);
  vtkNew<vtkCellArray> lines;

  const vtkDGGPointCoordinates positions(coordinates);
  vtkIdType p = 0;
  for (vtkIdType c = 0; c < cells; ++c)
  {
    const dgg::SurfacePath& curve = curves[c];
    layoutEdges->SetTypedComponent(c, 0, boundaries.Edges[c][0]);
    layoutEdges->SetTypedComponent(c, 1, boundaries.Edges[c][1]);
    lengths->SetValue(c, curve.Length);
    lines->InsertNextCell(static_cast<int>(curve.Points.size()));
    double length = 0.0;
    const std::size_t last = curve.Points.size() - 1;
    for (std::size_t i = 0; i <= last; ++i, ++p)
    {
      const dgg::SurfacePoint& point = curve.Points[i];
      length += i > 0 ? dgg::MeasurePiece(mesh.GetMesh(), curve, i - 1) : 0.0;
      points->SetPoint(p, dgg::PositionOf(mesh.GetMesh(), point, positions.GetData()).data());
      arcLengths->SetValue(p, i == last ? 1.0 : length / curve.Length);
      faces->SetValue(p, mesh.GetCell(curve.Faces[i < last ? i : i - 1]));
      originals->SetValue(p, point.On == dgg::SurfacePoint::Support::Vertex ? point.Vertex : -1);
      lines->InsertCellPoint(p);
    }
  }
  output->Initialize();
  output->SetPoints(points);
  output->SetLines(lines);
  output->GetCellData()->AddArray(layoutEdges);
  output->GetCellData()->AddArray(lengths);
  output->GetPointData()->AddArray(arcLengths);
  output->GetPointData()->AddArray(faces);
  output->GetPointData()->AddArray(originals);
}
}

//------------------------------------------------------------------------------
struct vtkGeodesicPatchBoundaries::vtkInternals
{
  vtkDGGMeshAdapter SecondMesh;
  vtkDGGSourceCollector Collectors[2];
};

//------------------------------------------------------------------------------
vtkGeodesicPatchBoundaries::vtkGeodesicPatchBoundaries()
  : ProjectionTolerance(0.01)
  , Internals(new vtkInternals)
{
  this->SetNumberOfInputPorts(5);
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
vtkGeodesicPatchBoundaries::~vtkGeodesicPatchBoundaries() = default;

//------------------------------------------------------------------------------
void vtkGeodesicPatchBoundaries::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfFirstLandmarkIds: " << this->FirstLandmarkIds.size() << "\n";
  os << indent << "NumberOfSecondLandmarkIds: " << this->SecondLandmarkIds.size() << "\n";
  os << indent << "ProjectionTolerance: " << this->ProjectionTolerance << "\n";
}

//------------------------------------------------------------------------------
void vtkGeodesicPatchBoundaries::SetFirstLandmarkIds(vtkIdList* ids)
{
  this->SetFirstLandmarkIds(ToVector(ids));
}

//------------------------------------------------------------------------------
void vtkGeodesicPatchBoundaries::SetFirstLandmarkIds(std::initializer_list<vtkIdType> ids)
{
  this->SetFirstLandmarkIds(std::vector<vtkIdType>(ids));
}

//------------------------------------------------------------------------------
void vtkGeodesicPatchBoundaries::SetFirstLandmarkIds(const std::vector<vtkIdType>& ids)
{
  if (this->FirstLandmarkIds != ids)
  {
    this->FirstLandmarkIds = ids;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkGeodesicPatchBoundaries::SetSecondLandmarkIds(vtkIdList* ids)
{
  this->SetSecondLandmarkIds(ToVector(ids));
}

//------------------------------------------------------------------------------
void vtkGeodesicPatchBoundaries::SetSecondLandmarkIds(std::initializer_list<vtkIdType> ids)
{
  this->SetSecondLandmarkIds(std::vector<vtkIdType>(ids));
}

//------------------------------------------------------------------------------
void vtkGeodesicPatchBoundaries::SetSecondLandmarkIds(const std::vector<vtkIdType>& ids)
{
  if (this->SecondLandmarkIds != ids)
  {
    this->SecondLandmarkIds = ids;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkIdType vtkGeodesicPatchBoundaries::GetNumberOfFirstLandmarkIds() const
{
  return static_cast<vtkIdType>(this->FirstLandmarkIds.size());
}

//------------------------------------------------------------------------------
vtkIdType vtkGeodesicPatchBoundaries::GetNumberOfSecondLandmarkIds() const
{
  return static_cast<vtkIdType>(this->SecondLandmarkIds.size());
}

//------------------------------------------------------------------------------
void vtkGeodesicPatchBoundaries::SetSecondSurfaceConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(1, output);
}

//------------------------------------------------------------------------------
void vtkGeodesicPatchBoundaries::SetSecondSurfaceData(vtkPolyData* surface)
{
  this->SetInputData(1, surface);
}

//------------------------------------------------------------------------------
void vtkGeodesicPatchBoundaries::SetFirstLandmarksConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(2, output);
}

//------------------------------------------------------------------------------
void vtkGeodesicPatchBoundaries::SetFirstLandmarksData(vtkPolyData* landmarks)
{
  this->SetInputData(2, landmarks);
}

//------------------------------------------------------------------------------
void vtkGeodesicPatchBoundaries::SetSecondLandmarksConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(3, output);
}

//------------------------------------------------------------------------------
void vtkGeodesicPatchBoundaries::SetSecondLandmarksData(vtkPolyData* landmarks)
{
  this->SetInputData(3, landmarks);
}

//------------------------------------------------------------------------------
void vtkGeodesicPatchBoundaries::SetLayoutConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(4, output);
}

//------------------------------------------------------------------------------
void vtkGeodesicPatchBoundaries::SetLayoutData(vtkPolyData* layout)
{
  this->SetInputData(4, layout);
}

//------------------------------------------------------------------------------
dgg::Status vtkGeodesicPatchBoundaries::CheckProperties() const
{
  return vtkDGGCheckLength("ProjectionTolerance", this->ProjectionTolerance);
}

//------------------------------------------------------------------------------
vtkDGGSourceSet vtkGeodesicPatchBoundaries::GetLandmarks(
  int surface, vtkInformationVector** inputVector) const
{
  return { surface == 0 ? this->FirstLandmarkIds : this->SecondLandmarkIds,
    vtkPolyData::GetData(inputVector[2 + surface]), 2 + surface,
    surface == 0 ? "first landmark" : "second landmark",
    surface == 0 ? "call SetFirstLandmarkIds()" : "call SetSecondLandmarkIds()", "" };
}

//------------------------------------------------------------------------------
dgg::Status vtkGeodesicPatchBoundaries::CheckInputs(
  vtkPolyData* surface, vtkInformationVector** inputVector) const
{
  vtkPolyData* second = vtkPolyData::GetData(inputVector[1]);
  if (!second)
  {
    return dgg::Status::Invalid("there is no second surface: call SetSecondSurfaceConnection() or "
                                "SetSecondSurfaceData()");
  }
  if (!vtkPolyData::GetData(inputVector[4]) && !vtkPolyData::GetData(inputVector[2]))
  {
    return dgg::Status::Invalid("there is no layout: connect polygons or lines that name landmarks "
                                "to input port 4, or landmarks with cells to input port 2");
  }
  const dgg::Status status =
    vtkDGGSourceCollector::Check(this->GetLandmarks(0, inputVector), surface->GetNumberOfPoints());
  return status.IsOk()
    ? vtkDGGSourceCollector::Check(this->GetLandmarks(1, inputVector), second->GetNumberOfPoints())
    : status;
}

//------------------------------------------------------------------------------
dgg::Status vtkGeodesicPatchBoundaries::PrepareSecondMesh(vtkPolyData* surface)
{
  vtkDGGMeshAdapter& mesh = this->Internals->SecondMesh;
  if (mesh.IsUpToDate(surface, this->GetMergeCoincidentPoints()))
  {
    return dgg::Status::Success();
  }
  const dgg::Status status = mesh.Update(surface, this->GetMergeCoincidentPoints());
  for (const std::string& warning : mesh.GetWarnings())
  {
    vtkWarningMacro(<< "Second surface: " << warning << ".");
  }
  return status.IsOk() || status.IsAborted()
    ? status
    : dgg::Status::Invalid("second surface: " + status.GetMessage());
}

//------------------------------------------------------------------------------
std::string vtkGeodesicPatchBoundaries::GetMemoryRemedy() const
{
  return "use smaller meshes";
}

//------------------------------------------------------------------------------
dgg::Status vtkGeodesicPatchBoundaries::Execute(
  vtkPolyData* surface, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* surfaces[2] = { surface, vtkPolyData::GetData(inputVector[1]) };
  dgg::Status status = this->PrepareSecondMesh(surfaces[1]);
  const vtkDGGMeshAdapter* meshes[2] = { &this->GetMesh(), &this->Internals->SecondMesh };
  std::vector<dgg::SurfacePoint> landmarks[2];
  for (int side = 0; side < 2 && status.IsOk(); ++side)
  {
    std::vector<dgg::GeodesicSource> sources;
    status = this->Internals->Collectors[side].Collect(this->GetLandmarks(side, inputVector),
      this->ProjectionTolerance, *meshes[side], surfaces[side]->GetPoints(), sources);
    landmarks[side] = ToPoints(sources);
  }
  vtkNew<vtkPoints> points[2];
  for (int side = 0; side < 2 && status.IsOk(); ++side)
  {
    status = vtkDGGCopyPoints(
      surfaces[side]->GetPoints(), meshes[side]->GetMesh().GetNumberOfVertices(), points[side]);
  }
  vtkPolyData* layout = vtkPolyData::GetData(inputVector[4]);
  layout = layout ? layout : vtkPolyData::GetData(inputVector[2]);
  if (status.IsOk() && (!layout || !this->Advance(0.0)))
  {
    status = dgg::Status::Abort();
  }
  if (!status.IsOk())
  {
    return status;
  }
  dgg::PatchBoundaries boundaries;
  status = dgg::TracePatchBoundaries(
    { meshes[0]->GetMesh(), landmarks[0] }, { meshes[1]->GetMesh(), landmarks[1] },
    ReadLayout(layout), [this](double fraction) { return this->Advance(fraction); }, boundaries);
  if (!status.IsOk())
  {
    return status;
  }
  for (int side = 0; side < 2; ++side)
  {
    FillOutput(
      boundaries, side, *meshes[side], points[side], vtkPolyData::GetData(outputVector, side));
  }
  return status;
}

//------------------------------------------------------------------------------
void vtkGeodesicPatchBoundaries::MakeEmptyOutput(
  vtkPolyData* vtkNotUsed(surface), vtkInformationVector* outputVector)
{
  for (int side = 0; side < 2; ++side)
  {
    vtkPolyData::GetData(outputVector, side)->Initialize();
  }
}
