// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGeodesicVoronoi.h"

#include "vtkDGGGraphUser.h"
#include "vtkDGGMeshAdapter.h"
#include "vtkDGGNewGeometry.h"
#include "vtkDGGProperties.h"
#include "vtkDGGSourceCollector.h"
#include "vtkDGGVoronoiOutputs.h"

#include "dggCentroidal.h"
#include "dggCloudCenters.h"
#include "dggProgressPart.h"

#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <limits>
#include <utility>

vtkStandardNewMacro(vtkGeodesicVoronoi);
vtkDGGGraphUserMacro(vtkGeodesicVoronoi);

namespace
{
/// Share of the progress after the graph that moving the sites takes.
constexpr double MovingShare = 0.9;
}

//------------------------------------------------------------------------------
vtkGeodesicVoronoi::vtkGeodesicVoronoi()
  : Centroidal(false)
  , NumberOfIterations(20)
  , Tolerance(1e-3)
  , GenerateCells(true)
  , RefineBoundaries(true)
  , UnreachedValue(std::numeric_limits<double>::quiet_NaN())
  , DistanceArrayName("GeodesicDistance")
  , SourceArrayName("GeodesicSource")
  , ProjectionTolerance(0.01)
  , GraphUser(new vtkDGGGraphUser)
  , Collector(new vtkDGGSourceCollector)
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(4);
}

//------------------------------------------------------------------------------
vtkGeodesicVoronoi::~vtkGeodesicVoronoi() = default;

//------------------------------------------------------------------------------
void vtkGeodesicVoronoi::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  vtkDGGPrintIds(os, indent, "SiteIds", this->SiteIds);
  os << indent << "Centroidal: " << (this->Centroidal ? "On" : "Off") << "\n";
  os << indent << "NumberOfIterations: " << this->NumberOfIterations << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "GenerateCells: " << (this->GenerateCells ? "On" : "Off") << "\n";
  os << indent << "RefineBoundaries: " << (this->RefineBoundaries ? "On" : "Off") << "\n";
  os << indent << "UnreachedValue: " << this->UnreachedValue << "\n";
  os << indent << "DistanceArrayName: " << this->DistanceArrayName << "\n";
  os << indent << "SourceArrayName: " << this->SourceArrayName << "\n";
  os << indent << "ProjectionTolerance: " << this->ProjectionTolerance << "\n";
  this->GraphUser->PrintSelf(os, indent);
}

//------------------------------------------------------------------------------
void vtkGeodesicVoronoi::RemoveAllSites()
{
  this->RemoveAllSiteIds();
  this->SetInputConnection(1, nullptr);
}

//------------------------------------------------------------------------------
void vtkGeodesicVoronoi::SetSiteConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(1, output);
}

//------------------------------------------------------------------------------
void vtkGeodesicVoronoi::SetSiteData(vtkPolyData* points)
{
  this->SetInputData(1, points);
}

//------------------------------------------------------------------------------
vtkPolyData* vtkGeodesicVoronoi::GetBoundaries()
{
  return this->GetOutput(1);
}

//------------------------------------------------------------------------------
vtkPolyData* vtkGeodesicVoronoi::GetCells()
{
  return this->GetOutput(2);
}

//------------------------------------------------------------------------------
vtkPolyData* vtkGeodesicVoronoi::GetSites()
{
  return this->GetOutput(3);
}

//------------------------------------------------------------------------------
dgg::Status vtkGeodesicVoronoi::CheckProperties() const
{
  dgg::Status status = vtkDGGCheckLength("ProjectionTolerance", this->ProjectionTolerance);
  if (status.IsOk())
  {
    status = vtkDGGCheckLength("Tolerance", this->Tolerance);
  }
  if (status.IsOk() && this->NumberOfIterations < 0)
  {
    status = dgg::Status::Invalid("NumberOfIterations is " +
      std::to_string(this->NumberOfIterations) + ": call SetNumberOfIterations() with at least 0");
  }
  for (const auto& name : { std::make_pair("DistanceArrayName", &this->DistanceArrayName),
         std::make_pair("SourceArrayName", &this->SourceArrayName) })
  {
    if (status.IsOk() && name.second->empty())
    {
      status = dgg::Status::Invalid(
        std::string(name.first) + " is empty: call Set" + name.first + "() with a name");
    }
  }
  if (status.IsOk() && this->DistanceArrayName == this->SourceArrayName)
  {
    status = dgg::Status::Invalid("DistanceArrayName and SourceArrayName are both '" +
      this->SourceArrayName + "': call SetSourceArrayName() with another name");
  }
  return status.IsOk() ? this->GraphUser->Check() : status;
}

//------------------------------------------------------------------------------
vtkDGGSourceSet vtkGeodesicVoronoi::GetSiteSet(vtkInformationVector** inputVector) const
{
  return { this->SiteIds, vtkPolyData::GetData(inputVector[1]), 1, "site",
    "call AddSiteId() or SetSiteIds()", "" };
}

//------------------------------------------------------------------------------
dgg::Status vtkGeodesicVoronoi::CheckInputs(
  vtkPolyData* surface, vtkInformationVector** inputVector) const
{
  return vtkDGGSourceCollector::Check(this->GetSiteSet(inputVector), surface->GetNumberOfPoints());
}

//------------------------------------------------------------------------------
bool vtkGeodesicVoronoi::IsCloud(vtkPolyData* input) const
{
  return vtkDGGGraphUser::IsCloud(input);
}

//------------------------------------------------------------------------------
std::string vtkGeodesicVoronoi::GetMemoryRemedy() const
{
  return "use a smaller mesh, a larger Accuracy or fewer sites";
}

//------------------------------------------------------------------------------
/// From the sites of the result to the rest of it; the graph is there.
dgg::Status vtkGeodesicVoronoi::Compute(vtkDGGVoronoiResult& result)
{
  const vtkDGGMeshAdapter& mesh = this->GetMesh();
  vtkDGGGraphProvider& graph = this->GraphUser->GetProvider();
  const dgg::ProgressCallback progress = graph.GetRemainingProgress();
  double start = 0.0;
  if (result.IsCentroidal)
  {
    start = MovingShare;
    std::vector<dgg::SurfacePoint> places = vtkDGGGetPlaces(result.Sites);
    dgg::CentroidalOptions options = result.Moving;
    options.Progress = dgg::ProgressPart(progress, 0.0, MovingShare);
    dgg::Status status = graph.PrepareBuilder(mesh);
    if (status.IsOk() && mesh.IsCloud())
    {
      status = dgg::MoveToCloudCenters(
        graph.GetSearch(), mesh.GetPositions(), options, places, result.Energies);
    }
    else if (status.IsOk())
    {
      status = dgg::MoveToCenters(graph.GetSearch(), mesh.GetMesh(), graph.GetBuilder(),
        graph.GetLinkAccuracy(), options, places, result.Energies);
    }
    if (!status.IsOk())
    {
      return status;
    }
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      result.Sites[i].Point = places[i];
    }
  }
  dgg::VoronoiInput input;
  input.LabelsOnly = result.LabelsOnly;
  dgg::Status status = graph.MakeSeeds(result.Sites, mesh, input.Seeds);
  if (status.IsOk() && result.IsRefined)
  {
    status = graph.PrepareBuilder(mesh);
    input.Builder = status.IsOk() ? &graph.GetBuilder() : nullptr;
    input.Accuracy = graph.GetLinkAccuracy();
  }
  if (!status.IsOk())
  {
    return status;
  }
  input.Places = vtkDGGGetPlaces(result.Sites);
  return dgg::ComputeVoronoi(graph.GetSearch(), mesh.GetMesh(), input,
    dgg::ProgressPart(progress, start, 1.0), result.Diagram);
}

//------------------------------------------------------------------------------
dgg::Status vtkGeodesicVoronoi::Execute(
  vtkPolyData* surface, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const vtkDGGMeshAdapter& mesh = this->GetMesh();
  const vtkDGGSourceSet set = this->GetSiteSet(inputVector);
  vtkDGGVoronoiResult result;
  dgg::Status status = this->Collector->Collect(
    set, this->ProjectionTolerance, mesh, surface->GetPoints(), result.Sites);
  if (!status.IsOk())
  {
    return status;
  }
  vtkDGGNewGeometry geometry;
  status = geometry.Take(surface, mesh, this->GetOutputPointsPrecision());
  if (!status.IsOk())
  {
    return status;
  }
  result.LabelsOnly = !this->GenerateCells || mesh.IsCloud();
  result.IsCentroidal = this->Centroidal;
  result.IsRefined = this->RefineBoundaries && !result.LabelsOnly;
  result.Moving.NumberOfIterations = this->NumberOfIterations;
  result.Moving.Tolerance = this->Tolerance;
  const std::string warning = vtkDGGSourceCollector::DescribeIsolatedIds(set, mesh);
  if (!warning.empty())
  {
    vtkWarningMacro(<< warning << ".");
  }
  status = this->Advance(0.0)
    ? this->GraphUser->Update(
        surface, mesh, [this](double fraction) { return this->Advance(fraction); }, this)
    : dgg::Status::Abort();
  if (status.IsOk())
  {
    status = this->Compute(result);
  }
  if (status.IsOk())
  {
    this->FillOutputs(result, surface, geometry, outputVector);
  }
  return status;
}

//------------------------------------------------------------------------------
void vtkGeodesicVoronoi::FillOutputs(const vtkDGGVoronoiResult& result, vtkPolyData* surface,
  const vtkDGGNewGeometry& geometry, vtkInformationVector* outputVector) const
{
  const vtkDGGVoronoiOutputs outputs(
    result, this->GetMesh(), geometry, this->DistanceArrayName, this->UnreachedValue);
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  output->ShallowCopy(surface);
  outputs.AddToSurface(this->SourceArrayName, output);
  if (result.LabelsOnly)
  {
    geometry.Begin(vtkPolyData::GetData(outputVector, 1));
    geometry.Begin(vtkPolyData::GetData(outputVector, 2));
  }
  else
  {
    outputs.FillBoundaries(vtkPolyData::GetData(outputVector, 1));
    outputs.FillCells(vtkPolyData::GetData(outputVector, 2));
  }
  outputs.FillSites(vtkPolyData::GetData(outputVector, 3));
}

//------------------------------------------------------------------------------
void vtkGeodesicVoronoi::MakeEmptyOutput(vtkPolyData* surface, vtkInformationVector* outputVector)
{
  vtkDGGNewGeometry geometry;
  geometry.Take(surface, this->GetMesh(), this->GetOutputPointsPrecision());
  this->FillOutputs(vtkDGGVoronoiResult(), surface, geometry, outputVector);
}
