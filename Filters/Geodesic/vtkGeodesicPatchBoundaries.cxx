// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGeodesicPatchBoundaries.h"

#include "DGGContext.h"
#include "DGGFilterInternals.h"
#include "DGGMeshAdapter.h"
#include "DGGProperties.h"
#include "DGGSources.h"
#include "DGGSurfaceArrays.h"

#include "dggOutput.h"
#include "dggPatchOutput.h"
#include "dggPropertyChecks.h"

#include "vtkCellArray.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <string>

vtkStandardNewMacro(vtkGeodesicPatchBoundaries);
vtkDGGDefineInputMacro(vtkGeodesicPatchBoundaries, SecondSurface, 1);
vtkDGGDefineInputMacro(vtkGeodesicPatchBoundaries, FirstLandmark, 2);
vtkDGGDefineInputMacro(vtkGeodesicPatchBoundaries, SecondLandmark, 3);
vtkDGGDefineInputMacro(vtkGeodesicPatchBoundaries, Layout, 4);

namespace
{
/// Returns the cells that refer to landmarks; null if there are none.
vtkPolyData* GetLayout(vtkInformationVector** inputVector)
{
  vtkPolyData* layout = vtkPolyData::GetData(inputVector[4]);
  return layout ? layout : vtkPolyData::GetData(inputVector[2]);
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
  std::string GetMemoryRemedy() const override { return "Use smaller meshes"; }

private:
  DGGSourceSet GetLandmarks(int surface, vtkInformationVector** inputVector) const;
  dgg::Status PrepareSecondMesh(vtkPolyData* surface);
  dgg::Status FillOutputs(const DGGContext (&contexts)[2], const dgg::PatchBoundaries& boundaries,
    vtkInformationVector* outputVector);

  DGGMeshAdapter SecondMesh;
};

//------------------------------------------------------------------------------
vtkGeodesicPatchBoundaries::vtkGeodesicPatchBoundaries()
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
  return dgg::CheckLengths({ { "ProjectionTolerance", this->Self->ProjectionTolerance } });
}

//------------------------------------------------------------------------------
DGGSourceSet vtkGeodesicPatchBoundaries::vtkInternals::GetLandmarks(
  int surface, vtkInformationVector** inputVector) const
{
  DGGSourceSet set{ surface == 0 ? this->Self->FirstLandmarkIds : this->Self->SecondLandmarkIds,
    vtkPolyData::GetData(inputVector[2 + surface]), 2 + surface,
    surface == 0 ? "first landmark" : "second landmark",
    surface == 0 ? "FirstLandmarkIds" : "SecondLandmarkIds", "" };
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
      this->Warn("Second surface: " + warning);
    }
  }
  return status.Of("Second surface");
}

//------------------------------------------------------------------------------
dgg::Status vtkGeodesicPatchBoundaries::vtkInternals::Execute(
  const DGGContext& context, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* secondInput = vtkPolyData::GetData(inputVector[1]);
  if (!secondInput)
  {
    return dgg::InvalidInput("There is no second surface")
      .Fix("Connect a surface to the second input port");
  }
  vtkPolyData* layout = GetLayout(inputVector);
  if (!layout)
  {
    return dgg::InvalidInput("There is no layout")
      .Fix("Connect polygons or lines that refer to landmarks to input port 4, or landmarks with "
           "cells to input port 2");
  }
  DGGSurfaceArrays cells;
  dgg::PatchLayout patches;
  DGG_RETURN_IF_ERROR(dgg::ReadPatchLayout(
    cells.ConvertCells(layout->GetPolys()), cells.ConvertCells(layout->GetLines()), patches));
  DGG_RETURN_IF_ERROR(this->PrepareSecondMesh(secondInput));
  const DGGContext contexts[2] = { context,
    { { this->SecondMesh.Get(), context.Memory, context.NumberOfThreads, context.Progress,
        context.Parallel, DGGConvertCells(secondInput) },
      secondInput } };
  std::vector<dgg::SurfacePoint> landmarks[2];
  for (int side = 0; side < 2; ++side)
  {
    DGG_RETURN_IF_ERROR(DGGLocate(contexts[side], this->GetLandmarks(side, inputVector),
      this->Self->ProjectionTolerance, landmarks[side]));
  }
  dgg::PatchBoundaries boundaries;
  DGG_RETURN_IF_ERROR(dgg::TracePatchBoundaries({ contexts[0].Surface.GetMesh(), landmarks[0] },
    { contexts[1].Surface.GetMesh(), landmarks[1] }, patches, context.Progress, boundaries));
  return this->FillOutputs(contexts, boundaries, outputVector);
}

//------------------------------------------------------------------------------
dgg::Status vtkGeodesicPatchBoundaries::vtkInternals::FillOutputs(const DGGContext (&contexts)[2],
  const dgg::PatchBoundaries& boundaries, vtkInformationVector* outputVector)
{
  for (int side = 0; side < 2; ++side)
  {
    dgg::Output output;
    dgg::WritePatchBoundaries(contexts[side], boundaries, side, output);
    DGG_RETURN_IF_ERROR(this->FillOutput(contexts[side], output, outputVector, side));
  }
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
/// Called if the first surface is empty, regardless of the second surface.
void vtkGeodesicPatchBoundaries::vtkInternals::MakeEmptyOutput(
  const DGGContext& context, vtkInformationVector* outputVector)
{
  this->FillOutputs({ context, context }, dgg::PatchBoundaries(), outputVector);
}
