// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGeodesicPatchBoundaries.h"

#include "DGGContext.h"
#include "DGGFilterInternals.h"
#include "DGGMakeArray.h"
#include "DGGMeshAdapter.h"
#include "DGGNewGeometry.h"
#include "DGGProperties.h"
#include "DGGSources.h"

#include "dggPatchBoundaries.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <limits>
#include <string>

vtkStandardNewMacro(vtkGeodesicPatchBoundaries);
vtkDGGDefineInputMacro(vtkGeodesicPatchBoundaries, SecondSurface, 1);
vtkDGGDefineInputMacro(vtkGeodesicPatchBoundaries, FirstLandmark, 2);
vtkDGGDefineInputMacro(vtkGeodesicPatchBoundaries, SecondLandmark, 3);
vtkDGGDefineInputMacro(vtkGeodesicPatchBoundaries, Layout, 4);

namespace
{
/// Returns the landmark indices of a cell. Indices beyond the range of the kernel's ids remain out
/// of range.
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

/// Returns the cells that refer to landmarks; null if there are none.
vtkPolyData* GetLayout(vtkInformationVector** inputVector)
{
  vtkPolyData* layout = vtkPolyData::GetData(inputVector[4]);
  return layout ? layout : vtkPolyData::GetData(inputVector[2]);
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

/// Adds a point array with the fraction of the curve before each point.
void AddFractions(vtkPolyData* output)
{
  vtkDataArray* lengths = output->GetPointData()->GetArray("ArcLength");
  const auto fractions =
    DGGAddArray<vtkDoubleArray>(output->GetPointData(), "ArcFraction", output->GetNumberOfPoints());
  for (vtkIdType c = 0; c < output->GetNumberOfLines(); ++c)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    output->GetLines()->GetCellAtId(c, size, ids);
    const vtkIdType last = ids[size - 1];
    const double whole = lengths->GetComponent(last, 0);
    for (vtkIdType i = 0; i < size; ++i)
    {
      fractions->SetValue(ids[i], ids[i] == last ? 1.0 : lengths->GetComponent(ids[i], 0) / whole);
    }
  }
}

void FillOutput(const dgg::PatchBoundaries& boundaries, int side, const DGGNewGeometry& geometry,
  vtkPolyData* output)
{
  const std::vector<dgg::SurfacePath>& curves = boundaries.Curves[side];
  vtkIdType size = 0;
  for (const dgg::SurfacePath& curve : curves)
  {
    size += DGGPolylineWriter::CountPoints(curve, false);
  }
  geometry.Begin(output);
  DGGPolylineWriter writer(geometry, size);
  vtkCellData* data = output->GetCellData();
  const auto edges = DGGAddArray<vtkIdTypeArray>(data, "LayoutEdge", curves.size(), 2);
  const auto lengths = DGGAddArray<vtkDoubleArray>(data, "Length", curves.size());
  for (std::size_t i = 0; i < curves.size(); ++i)
  {
    writer.Add(curves[i]);
    const auto c = static_cast<vtkIdType>(i);
    edges->SetTypedComponent(c, 0, boundaries.Edges[i][0]);
    edges->SetTypedComponent(c, 1, boundaries.Edges[i][1]);
    lengths->SetValue(c, curves[i].Length);
  }
  writer.AddTo(output);
  AddFractions(output);
}
}

//------------------------------------------------------------------------------
class vtkGeodesicPatchBoundaries::vtkInternals : public DGGInternalsOf<vtkGeodesicPatchBoundaries>
{
public:
  using DGGInternalsOf::DGGInternalsOf;

  dgg::Status CheckProperties() const override;
  dgg::Status Execute(const DGGContext& context, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  void MakeEmptyOutput(const DGGContext& context, vtkInformationVector* outputVector) override;
  std::string GetMemoryRemedy() const override { return "use smaller meshes"; }

private:
  DGGSourceSet GetLandmarks(int surface, vtkInformationVector** inputVector) const;
  dgg::Status PrepareSecondMesh(vtkPolyData* surface);

  DGGMeshAdapter SecondMesh;
};

//------------------------------------------------------------------------------
vtkGeodesicPatchBoundaries::vtkGeodesicPatchBoundaries()
  : ProjectionTolerance(0.01)
{
  this->Internals.reset(new vtkInternals(this));
  this->SetNumberOfInputPorts(5);
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
void vtkGeodesicPatchBoundaries::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  DGGPrintIds(os, indent, "FirstLandmarkIds", this->FirstLandmarkIds);
  DGGPrintIds(os, indent, "SecondLandmarkIds", this->SecondLandmarkIds);
  os << indent << "ProjectionTolerance: " << this->ProjectionTolerance << "\n";
}

//------------------------------------------------------------------------------
void vtkGeodesicPatchBoundaries::RemoveAllLandmarks()
{
  this->RemoveAllFirstLandmarkIds();
  this->RemoveAllSecondLandmarkIds();
  this->SetInputConnection(2, nullptr);
  this->SetInputConnection(3, nullptr);
}

//------------------------------------------------------------------------------
dgg::Status vtkGeodesicPatchBoundaries::vtkInternals::CheckProperties() const
{
  return DGGCheckLengths({ { "ProjectionTolerance", this->Self->ProjectionTolerance } });
}

//------------------------------------------------------------------------------
DGGSourceSet vtkGeodesicPatchBoundaries::vtkInternals::GetLandmarks(
  int surface, vtkInformationVector** inputVector) const
{
  DGGSourceSet set{ surface == 0 ? this->Self->FirstLandmarkIds : this->Self->SecondLandmarkIds,
    vtkPolyData::GetData(inputVector[2 + surface]), 2 + surface,
    surface == 0 ? "first landmark" : "second landmark",
    surface == 0 ? "call AddFirstLandmarkId() or SetFirstLandmarkIds()"
                 : "call AddSecondLandmarkId() or SetSecondLandmarkIds()",
    "" };
  set.Surface = surface == 0 ? "first surface" : "second surface";
  return set;
}

//------------------------------------------------------------------------------
dgg::Status vtkGeodesicPatchBoundaries::vtkInternals::PrepareSecondMesh(vtkPolyData* surface)
{
  DGGMeshAdapter& mesh = this->SecondMesh;
  const vtkMTimeType built = mesh.GetBuildTime();
  const dgg::Status status = mesh.Update(surface, this->GetDomain(surface));
  if (built != mesh.GetBuildTime())
  {
    for (const std::string& warning : mesh.Get().GetWarnings())
    {
      vtkWarningWithObjectMacro(this->Self, << "Second surface: " << warning << ".");
    }
  }
  return status.Of("second surface");
}

//------------------------------------------------------------------------------
dgg::Status vtkGeodesicPatchBoundaries::vtkInternals::Execute(
  const DGGContext& context, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* secondInput = vtkPolyData::GetData(inputVector[1]);
  if (!secondInput)
  {
    return dgg::Status::Invalid("there is no second surface: call SetSecondSurfaceConnection() or "
                                "SetSecondSurfaceData()");
  }
  vtkPolyData* layout = GetLayout(inputVector);
  if (!layout)
  {
    return dgg::Status::Invalid("there is no layout: connect polygons or lines that name landmarks "
                                "to input port 4, or landmarks with cells to input port 2");
  }
  if (!layout->GetPolys()->IsValid() || !layout->GetLines()->IsValid())
  {
    return dgg::Status::Invalid("the offsets and the connectivity of the polygons or lines of the "
                                "layout contradict each other: rebuild the cell array");
  }
  DGG_RETURN_IF_ERROR(this->PrepareSecondMesh(secondInput));
  const DGGContext contexts[2] = { context,
    { { this->SecondMesh.Get(), context.Memory, context.NumberOfThreads, context.Progress,
        context.Parallel },
      secondInput } };
  std::vector<dgg::SurfacePoint> landmarks[2];
  DGGNewGeometry geometries[2];
  for (int side = 0; side < 2; ++side)
  {
    DGG_RETURN_IF_ERROR(DGGLocate(contexts[side], this->GetLandmarks(side, inputVector),
      this->Self->ProjectionTolerance, landmarks[side]));
    DGG_RETURN_IF_ERROR(
      geometries[side].Take(contexts[side], this->Self->GetOutputPointsPrecision()));
  }
  dgg::PatchBoundaries boundaries;
  DGG_RETURN_IF_ERROR(dgg::TracePatchBoundaries({ contexts[0].Surface.GetMesh(), landmarks[0] },
    { contexts[1].Surface.GetMesh(), landmarks[1] }, ReadLayout(layout), context.Progress,
    boundaries));
  for (int side = 0; side < 2; ++side)
  {
    FillOutput(boundaries, side, geometries[side], vtkPolyData::GetData(outputVector, side));
  }
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
/// Called if the first surface is empty, regardless of the second surface.
void vtkGeodesicPatchBoundaries::vtkInternals::MakeEmptyOutput(
  const DGGContext& context, vtkInformationVector* outputVector)
{
  DGGNewGeometry geometry;
  geometry.Take(context, this->Self->GetOutputPointsPrecision());
  for (int side = 0; side < 2; ++side)
  {
    FillOutput({}, side, geometry, vtkPolyData::GetData(outputVector, side));
  }
}
