// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointCloudDGG.h"

#include "PointCloudDGGInternals.h"

#include "DGGGraphArrays.h"
#include "DGGMakeArray.h"
#include "DGGOutput.h"
#include "DGGSurfaceParts.h"

#include "dggCloudGraphTask.h"
#include "dggCounted.h"
#include "dggPropertyChecks.h"
#include "dggStatus.h"
#include "dggSurfaceOutput.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <cstdint>

vtkStandardNewMacro(vtkPointCloudDGG);

namespace
{
constexpr int FewestNeighbors = 3;

/// Adds one vertex cell with all points.
void AddVertices(vtkPolyData* cloud)
{
  dgg::OutputCells vertices = dgg::MakeCellOfAllPoints(cloud->GetNumberOfPoints());
  cloud->SetVerts(DGGMakeCells(vertices));
  cloud->GetCellData()->Initialize(); // removes arrays without tuples
}
}

vtkDGGInternalsMacro(vtkPointCloudDGG);

//------------------------------------------------------------------------------
vtkPointCloudDGG::vtkPointCloudDGG()
  : Accuracy(dgg::CloudGraphOptions().Accuracy)
{
  this->Internals.reset(new vtkInternals(this));
}

//------------------------------------------------------------------------------
vtkDGGAsStringMacro(vtkPointCloudDGG, Scheme, "A", "B", "C");

//------------------------------------------------------------------------------
int vtkPointCloudDGG::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const int result = this->Superclass::RequestData(request, inputVector, outputVector);
  if (!this->GenerateVertices)
  {
    return result;
  }
  vtkIdType others = 0;
  for (const DGGSurfacePart& part : DGGFindParts(vtkDataObject::GetData(outputVector), others))
  {
    if (part.Data->GetNumberOfCells() == 0 && part.Data->GetNumberOfPoints() > 0)
    {
      AddVertices(part.Data);
    }
  }
  return result;
}

//------------------------------------------------------------------------------
dgg::Status vtkPointCloudDGG::vtkInternals::CheckProperties() const
{
  if (this->Self->NumberOfNeighbors < FewestNeighbors)
  {
    return dgg::InvalidValue("NumberOfNeighbors", this->Self->NumberOfNeighbors)
      .Fix("Use a number of at least ", FewestNeighbors);
  }
  DGG_RETURN_IF_ERROR(
    dgg::CheckNames({ { "ComponentArrayName", this->Self->ComponentArrayName } }));
  return dgg::CloudGraphBuilder::Check(this->MakeOptions());
}

//------------------------------------------------------------------------------
vtkDataArray* vtkPointCloudDGG::vtkInternals::GetInputNormals(vtkPolyData* cloud) const
{
  return this->Self->UseInputNormals ? cloud->GetPointData()->GetNormals() : nullptr;
}

//------------------------------------------------------------------------------
dgg::Status vtkPointCloudDGG::vtkInternals::CheckInputNormals(vtkPolyData* cloud) const
{
  vtkDataArray* normals = this->GetInputNormals(cloud);
  const bool fits = !normals ||
    (normals->GetNumberOfComponents() == 3 &&
      normals->GetNumberOfTuples() == cloud->GetNumberOfPoints());
  if (fits)
  {
    return dgg::Status::Success();
  }
  return dgg::InvalidInput("The point normals of the input have ",
    dgg::Counted(normals->GetNumberOfComponents(), "component"), " and ",
    dgg::Counted(normals->GetNumberOfTuples(), "tuple"), " for ",
    dgg::Counted(cloud->GetNumberOfPoints(), "point"))
    .At("UseInputNormals")
    .Fix("Use three numbers per point, or turn off {UseInputNormals}");
}

//------------------------------------------------------------------------------
dgg::Status vtkPointCloudDGG::vtkInternals::Execute(const DGGContext& context,
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  DGG_RETURN_IF_ERROR(this->CheckInputNormals(context.Input));
  const NormalsSource source = this->MakeNormalsSource(context.Input);
  const vtkMTimeType built = this->Self->GetGraphBuildTime();
  dgg::CloudGraphOptions options = this->MakeOptions();
  options.HasOrientedNormals = this->Self->OrientedNormals && source.Given;
  Normals normals;
  double done = 0.0;
  DGG_RETURN_IF_ERROR(this->FindNormals(context, source, normals, done));
  options.Normals = normals ? normals->data() : nullptr;
  DGG_RETURN_IF_ERROR(this->Build(context, options, done));
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  output->ShallowCopy(context.Input);
  this->Built.AddTo(output->GetFieldData());
  this->Current = this->BuiltFindings;
  vtkPointData* data = output->GetPointData();
  dgg::OutputArrays arrays;
  arrays.AddValues<std::int32_t>(this->Self->ComponentArrayName, this->Components);
  const bool hasPlaneNormals = source.ByPlanes && normals;
  if (hasPlaneNormals)
  {
    arrays.AddValues<double>("Normals", *normals, 3);
  }
  DGGAddArrays(arrays, data);
  if (hasPlaneNormals)
  {
    data->SetNormals(data->GetArray("Normals"));
  }
  if (built != this->Self->GetGraphBuildTime())
  {
    this->Warn(dgg::DescribeCloudGraph(options, this->Current.Statistics));
  }
  if (this->Self->OrientedNormals && !source.Given)
  {
    this->Warn("{OrientedNormals} is on, but no point normals of the input are used. It has no "
               "effect, and opposite layers may be connected. Add normals to the input, turn on "
               "{UseInputNormals}, or turn off {OrientedNormals}");
  }
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
void vtkPointCloudDGG::vtkInternals::MakeEmptyOutput(
  const DGGContext& context, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  output->ShallowCopy(context.Input);
  DGGGraphArrays::RemoveFrom(output->GetFieldData()); // they belong to other points
  DGGAddArray<vtkIntArray>(output->GetPointData(), this->Self->ComponentArrayName, 0);
}
