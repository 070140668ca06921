// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGeodesicVoronoi.h"

#include "DGGGraphUser.h"
#include "DGGMakeArray.h"
#include "DGGNewGeometry.h"
#include "DGGPropagation.h"
#include "DGGProperties.h"
#include "DGGSources.h"
#include "DGGUnreachedArray.h"
#include "DGGWindowArrays.h"

#include "dggCentroidal.h"
#include "dggPreparedSurface.h"
#include "dggProgressPart.h"
#include "dggSourceCollection.h"
#include "dggVoronoi.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkGeodesicVoronoi);
vtkDGGDefineInputMacro(vtkGeodesicVoronoi, Site, 1);

/// Options and results of vtkGeodesicVoronoi.
struct DGGVoronoiResult
{
  std::vector<dgg::GeodesicSource> Sites;
  dgg::VoronoiDiagram Diagram;
  std::vector<double> Energies; ///< empty unless sites are moved
  bool LabelsOnly = false;      ///< true if there are neither cells nor boundaries
  ///@{
  /// Requested options.
  bool IsCentroidal = false;
  bool IsRefined = false;
  dgg::CentroidalOptions Moving;
  ///@}
};

namespace
{
/// Progress weight of moving the sites, after the graph.
constexpr double MovingShare = 0.9;

/// Makes the outputs of a diagram on one surface.
struct VoronoiOutputs
{
  const DGGVoronoiResult& Result;
  const dgg::PreparedSurface& Mesh;
  const DGGNewGeometry& Geometry;
  const std::string& DistanceName;
  double UnreachedValue;

  /// Returns the distance; infinity if no site reaches the point.
  double GetTrueDistance(dgg::Id point) const
  {
    const dgg::VoronoiDiagram& diagram = this->Result.Diagram;
    const auto n = static_cast<dgg::Id>(diagram.Distances.size());
    return point < n ? diagram.Distances[point] : diagram.BorderDistances[point - n];
  }

  double GetDistance(dgg::Id point) const
  {
    const double distance = this->GetTrueDistance(point);
    return distance < dgg::Infinity ? distance : this->UnreachedValue;
  }

  dgg::SurfacePoint GetPlace(dgg::Id point) const
  {
    const dgg::VoronoiDiagram& diagram = this->Result.Diagram;
    const auto n = static_cast<dgg::Id>(diagram.Distances.size());
    return point < n ? dgg::SurfacePoint::AtVertex(point) : diagram.BorderPoints[point - n];
  }

  /// Returns the area of the cell of each site, and at the end the unreached area.
  std::vector<double> SumAreas() const
  {
    const dgg::VoronoiDiagram& diagram = this->Result.Diagram;
    std::vector<double> areas(this->Result.Sites.size() + 1, 0.0);
    for (std::size_t i = 0; i < diagram.GetNumberOfPolygons(); ++i)
    {
      const dgg::Id site = diagram.PolygonSites[i];
      (site == dgg::NoId ? areas.back() : areas[site]) += diagram.PolygonAreas[i];
    }
    return areas;
  }

  /// Adds the arrays of labels, distances and energies to a copy of the input.
  void AddToSurface(const std::string& sourceName, vtkPolyData* output) const
  {
    const dgg::VoronoiDiagram& diagram = this->Result.Diagram;
    const auto n = static_cast<std::size_t>(output->GetNumberOfPoints());
    vtkPointData* data = output->GetPointData();
    const auto distances = DGGAddArray<vtkDoubleArray>(data, this->DistanceName, n);
    // Windows and marks of the input belong to the replaced array.
    DGGWindowArrays::RemoveFrom(output->GetFieldData(), this->DistanceName);
    DGGUnreachedArray::RemoveFrom(data, this->DistanceName);
    const auto sites = DGGAddArray<vtkIntArray>(data, sourceName, n);
    std::vector<bool> isReached(n);
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      const dgg::Id vertex = this->Mesh.GetVertex(i);
      distances->SetValue(i, this->GetDistance(vertex));
      sites->SetValue(i, diagram.NearestSites[vertex]);
      isReached[static_cast<std::size_t>(i)] = this->GetTrueDistance(vertex) < dgg::Infinity;
    }
    DGGUnreachedArray::AddTo(data, this->DistanceName, this->UnreachedValue, isReached);
    // SetScalars() would remove the scalars of the input.
    data->SetActiveScalars(sourceName.c_str());
    if (!this->Result.Energies.empty())
    {
      const auto energies =
        DGGAddArray<vtkDoubleArray>(output->GetFieldData(), "Energy", this->Result.Energies.size());
      std::copy(
        this->Result.Energies.begin(), this->Result.Energies.end(), energies->GetPointer(0));
    }
  }

  void FillBoundaries(vtkPolyData* output) const
  {
    const dgg::VoronoiDiagram& diagram = this->Result.Diagram;
    // Only points of curves are written, in ascending order.
    std::vector<dgg::Id> used = diagram.CurvePoints;
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    this->Geometry.Begin(output);
    const auto points = this->Geometry.MakePoints(used.size());
    const auto distances =
      DGGAddArray<vtkDoubleArray>(output->GetPointData(), this->DistanceName, used.size());
    for (std::size_t k = 0; k < used.size(); ++k)
    {
      const auto i = static_cast<vtkIdType>(k);
      this->Geometry.SetPoint(points, i, this->GetPlace(used[k]));
      distances->SetValue(i, this->GetDistance(used[k]));
    }
    vtkNew<vtkCellArray> lines;
    const auto sites =
      DGGAddArray<vtkIntArray>(output->GetCellData(), "SiteId", diagram.GetNumberOfCurves(), 2);
    for (std::size_t k = 0; k < diagram.GetNumberOfCurves(); ++k)
    {
      const dgg::Offset begin = diagram.CurveOffsets[k];
      const dgg::Offset end = diagram.CurveOffsets[k + 1];
      lines->InsertNextCell(static_cast<int>(end - begin));
      for (dgg::Offset i = begin; i < end; ++i)
      {
        lines->InsertCellPoint(
          std::lower_bound(used.begin(), used.end(), diagram.CurvePoints[i]) - used.begin());
      }
      for (int c = 0; c < 2; ++c)
      {
        sites->SetTypedComponent(static_cast<vtkIdType>(k), c, diagram.CurveSites[k][c]);
      }
    }
    output->SetPoints(points);
    output->SetLines(lines);
  }

  void FillCells(vtkPolyData* output) const
  {
    const dgg::VoronoiDiagram& diagram = this->Result.Diagram;
    this->Geometry.Begin(output);
    const std::size_t n = diagram.Distances.size() + diagram.BorderPoints.size();
    const auto points = this->Geometry.MakePoints(n);
    const auto distances =
      DGGAddArray<vtkDoubleArray>(output->GetPointData(), this->DistanceName, n);
    std::vector<bool> isReached(n);
    for (std::size_t k = 0; k < n; ++k)
    {
      const auto i = static_cast<vtkIdType>(k);
      const auto point = static_cast<dgg::Id>(k);
      this->Geometry.SetPoint(points, i, this->GetPlace(point));
      distances->SetValue(i, this->GetDistance(point));
      isReached[k] = this->GetTrueDistance(point) < dgg::Infinity;
    }
    DGGUnreachedArray::AddTo(
      output->GetPointData(), this->DistanceName, this->UnreachedValue, isReached);
    const std::vector<double> areas = this->SumAreas();
    vtkNew<vtkCellArray> polygons;
    vtkCellData* data = output->GetCellData();
    const std::size_t count = diagram.GetNumberOfPolygons();
    const auto sites = DGGAddArray<vtkIntArray>(data, "SiteId", count);
    const auto cellAreas = DGGAddArray<vtkDoubleArray>(data, "CellArea", count);
    const auto faces = DGGAddArray<vtkIdTypeArray>(data, "FaceId", count);
    std::vector<vtkIdType> corners;
    for (std::size_t k = 0; k < count; ++k)
    {
      corners.assign(diagram.PolygonPoints.begin() + diagram.PolygonOffsets[k],
        diagram.PolygonPoints.begin() + diagram.PolygonOffsets[k + 1]);
      const dgg::Id face = diagram.PolygonFaces[k];
      if (this->Mesh.GetMesh().IsFlipped(face))
      {
        std::reverse(corners.begin(), corners.end()); // same orientation as in the input
      }
      polygons->InsertNextCell(static_cast<vtkIdType>(corners.size()), corners.data());
      const auto i = static_cast<vtkIdType>(k);
      const dgg::Id site = diagram.PolygonSites[k];
      sites->SetValue(i, site);
      cellAreas->SetValue(i, site == dgg::NoId ? areas.back() : areas[site]);
      faces->SetValue(i, this->Geometry.GetCell(face));
    }
    output->SetPoints(points);
    output->SetPolys(polygons);
    data->SetActiveScalars("SiteId");
  }

  void FillSites(vtkPolyData* output) const
  {
    DGGFillSurfacePoints(dgg::GetPoints(this->Result.Sites), this->Geometry, output);
    const std::size_t count = this->Result.Sites.size();
    const auto numbers = DGGAddArray<vtkIntArray>(output->GetPointData(), "SiteId", count);
    for (std::size_t k = 0; k < count; ++k)
    {
      numbers->SetValue(static_cast<vtkIdType>(k), static_cast<int>(k));
    }
    if (this->Result.LabelsOnly)
    {
      return;
    }
    const std::vector<double> areas = this->SumAreas();
    const auto cellAreas = DGGAddArray<vtkDoubleArray>(output->GetPointData(), "CellArea", count);
    for (std::size_t k = 0; k < count; ++k)
    {
      cellAreas->SetValue(static_cast<vtkIdType>(k), areas[k]);
    }
  }
};
}

//------------------------------------------------------------------------------
class vtkGeodesicVoronoi::vtkInternals : public DGGGraphInternalsOf<vtkGeodesicVoronoi>
{
public:
  using DGGGraphInternalsOf::DGGGraphInternalsOf;

  dgg::Status CheckProperties() const override;
  dgg::Status Execute(const DGGContext& context, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  bool PassesSurface() const override { return true; }
  void MakeEmptyOutput(const DGGContext& context, vtkInformationVector* outputVector) override;
  std::string GetMemoryRemedy() const override
  {
    return "use a smaller mesh, a larger Accuracy or fewer sites";
  }

private:
  DGGSourceSet GetSiteSet(vtkInformationVector** inputVector) const;
  dgg::Status ComputePreview(const DGGContext& context, DGGVoronoiResult& result);
  dgg::Status Compute(const DGGContext& context, DGGVoronoiResult& result);
  void FillOutputs(const DGGContext& context, const DGGVoronoiResult& result,
    const DGGNewGeometry& geometry, vtkInformationVector* outputVector) const;
  void PassArrays(const DGGContext& context, const DGGVoronoiResult& result,
    const DGGSourceSet& set, vtkInformationVector* outputVector) const;

  DGGPropagation PreviewSolver;
};

vtkDGGInternalsMacro(vtkGeodesicVoronoi);
vtkDGGGraphUserMacro(vtkGeodesicVoronoi);

//------------------------------------------------------------------------------
vtkGeodesicVoronoi::vtkGeodesicVoronoi()
  : Centroidal(false)
  , NumberOfIterations(20)
  , Tolerance(1e-3)
  , GenerateCells(true)
  , Preview(false)
  , RefineBoundaries(true)
  , PassSiteArrays(false)
  , UnreachedValue(std::numeric_limits<double>::quiet_NaN())
  , DistanceArrayName("GeodesicDistance")
  , SourceArrayName("GeodesicSource")
  , ProjectionTolerance(0.01)
{
  this->Internals.reset(new vtkInternals(this));
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(4);
}

//------------------------------------------------------------------------------
void vtkGeodesicVoronoi::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  DGGPrintIds(os, indent, "SiteIds", this->SiteIds);
  os << indent << "Centroidal: " << (this->Centroidal ? "On" : "Off") << "\n";
  os << indent << "NumberOfIterations: " << this->NumberOfIterations << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "GenerateCells: " << (this->GenerateCells ? "On" : "Off") << "\n";
  os << indent << "Preview: " << (this->Preview ? "On" : "Off") << "\n";
  os << indent << "RefineBoundaries: " << (this->RefineBoundaries ? "On" : "Off") << "\n";
  os << indent << "PassSiteArrays: " << (this->PassSiteArrays ? "On" : "Off") << "\n";
  os << indent << "UnreachedValue: " << this->UnreachedValue << "\n";
  os << indent << "DistanceArrayName: " << this->DistanceArrayName << "\n";
  os << indent << "SourceArrayName: " << this->SourceArrayName << "\n";
  os << indent << "ProjectionTolerance: " << this->ProjectionTolerance << "\n";
  this->GetInternals().GraphUser.PrintSelf(os, indent);
}

//------------------------------------------------------------------------------
void vtkGeodesicVoronoi::RemoveAllSites()
{
  this->RemoveAllSiteIds();
  this->SetInputConnection(1, nullptr);
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
dgg::Status vtkGeodesicVoronoi::vtkInternals::CheckProperties() const
{
  DGG_RETURN_IF_ERROR(DGGCheckLengths({ { "ProjectionTolerance", this->Self->ProjectionTolerance },
    { "Tolerance", this->Self->Tolerance } }));
  if (this->Self->NumberOfIterations < 0)
  {
    return dgg::Status::Invalid("NumberOfIterations is " +
      std::to_string(this->Self->NumberOfIterations) +
      ": call SetNumberOfIterations() with at least 0");
  }
  const std::pair<const char*, const std::string*> names[] = {
    { "DistanceArrayName", &this->Self->DistanceArrayName },
    { "SourceArrayName", &this->Self->SourceArrayName },
  };
  for (const auto& name : names)
  {
    if (name.second->empty())
    {
      return dgg::Status::Invalid(
        std::string(name.first) + " is empty: call Set" + name.first + "() with a name");
    }
  }
  if (this->Self->DistanceArrayName == this->Self->SourceArrayName)
  {
    return dgg::Status::Invalid("DistanceArrayName and SourceArrayName are both '" +
      this->Self->SourceArrayName + "': call SetSourceArrayName() with another name");
  }
  if (this->Self->Preview && this->Self->Centroidal)
  {
    return dgg::Status::Invalid("Preview does not move sites: turn Preview or Centroidal off");
  }
  return DGGGraphInternalsOf::CheckProperties();
}

//------------------------------------------------------------------------------
DGGSourceSet vtkGeodesicVoronoi::vtkInternals::GetSiteSet(vtkInformationVector** inputVector) const
{
  return { this->Self->SiteIds, vtkPolyData::GetData(inputVector[1]), 1, "site",
    "call AddSiteId() or SetSiteIds()", "" };
}

//------------------------------------------------------------------------------
/// Computes labels from the sites of the result, without a graph.
dgg::Status vtkGeodesicVoronoi::vtkInternals::ComputePreview(
  const DGGContext& context, DGGVoronoiResult& result)
{
  if (context.Surface.IsCloud())
  {
    return dgg::Status::Invalid("Preview needs a surface, not a point cloud: turn Preview off");
  }
  dgg::PropagationOptions options;
  options.Quality = DGGPropagation::Choose(context.Surface);
  options.WantNearestSource = true;
  dgg::PropagationResult found;
  DGG_RETURN_IF_ERROR(this->PreviewSolver.Run(context, result.Sites, options, found)
                        .Of("Preview, which can be turned off"));
  this->WarnAboutQuality(
    DGGJoinReasons({ DGGDescribeLongTriangles(context.Surface,
                       "cells of Preview may be wrong. Turn Preview off, or remesh the surface"),
      found.IsSettled ? ""
                      : "Preview: distances did not settle on triangles this irregular, so cells "
                        "may be wrong. Turn Preview off" }));
  result.Diagram.NearestSites = std::move(found.NearestSource);
  result.Diagram.Distances = std::move(found.Distances);
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
/// Computes the diagram from the sites of the result. The graph is up to date.
dgg::Status vtkGeodesicVoronoi::vtkInternals::Compute(
  const DGGContext& context, DGGVoronoiResult& result)
{
  const dgg::PreparedSurface& mesh = context.Surface;
  DGGGraphUser& graph = this->GraphUser;
  const dgg::ProgressCallback progress = graph.GetRemainingProgress(context);
  double start = 0.0;
  if (result.IsCentroidal)
  {
    start = MovingShare;
    std::vector<dgg::SurfacePoint> places = dgg::GetPoints(result.Sites);
    dgg::CentroidalOptions options = result.Moving;
    options.Progress = dgg::ProgressPart(progress, 0.0, MovingShare);
    DGG_RETURN_IF_ERROR(graph.PrepareBuilder(context));
    DGG_RETURN_IF_ERROR(mesh.IsCloud()
        ? dgg::MoveToCloudCenters(
            graph.GetSearch(), mesh.GetPositions(), options, places, result.Energies)
        : dgg::MoveToCenters(graph.GetSearch(), mesh.GetMesh(), graph.GetBuilder(),
            graph.GetLinkAccuracy(), options, places, result.Energies));
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      result.Sites[i].Point = places[i];
    }
  }
  dgg::VoronoiInput input;
  input.LabelsOnly = result.LabelsOnly;
  DGG_RETURN_IF_ERROR(graph.MakeSeeds(context, result.Sites, input.Seeds));
  if (result.IsRefined)
  {
    DGG_RETURN_IF_ERROR(graph.PrepareBuilder(context));
    input.Builder = &graph.GetBuilder();
    input.Accuracy = graph.GetLinkAccuracy();
  }
  input.Places = dgg::GetPoints(result.Sites);
  return dgg::ComputeVoronoi(graph.GetSearch(), mesh.GetMesh(), input,
    dgg::ProgressPart(progress, start, 1.0), result.Diagram);
}

//------------------------------------------------------------------------------
dgg::Status vtkGeodesicVoronoi::vtkInternals::Execute(
  const DGGContext& context, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const dgg::PreparedSurface& mesh = context.Surface;
  const DGGSourceSet set = this->GetSiteSet(inputVector);
  DGGVoronoiResult result;
  DGG_RETURN_IF_ERROR(
    DGGLocate(context, set, this->Self->ProjectionTolerance, result.Sites, this->Self));
  DGGNewGeometry geometry;
  DGG_RETURN_IF_ERROR(geometry.Take(context, this->Self->GetOutputPointsPrecision()));
  result.LabelsOnly = !this->Self->GenerateCells || this->Self->Preview || mesh.IsCloud();
  result.IsCentroidal = this->Self->Centroidal;
  result.IsRefined = this->Self->RefineBoundaries && !result.LabelsOnly;
  result.Moving.NumberOfIterations = this->Self->NumberOfIterations;
  result.Moving.Tolerance = this->Self->Tolerance;
  if (this->Self->Preview)
  {
    DGG_RETURN_IF_ERROR(this->ComputePreview(context, result));
  }
  else
  {
    DGG_RETURN_IF_ERROR(this->GraphUser.Update(context, this->Self));
    DGG_RETURN_IF_ERROR(this->Compute(context, result));
  }
  this->FillOutputs(context, result, geometry, outputVector);
  if (this->Self->PassSiteArrays)
  {
    this->PassArrays(context, result, set, outputVector);
  }
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
void vtkGeodesicVoronoi::vtkInternals::PassArrays(const DGGContext& context,
  const DGGVoronoiResult& result, const DGGSourceSet& set, vtkInformationVector* outputVector) const
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  std::vector<dgg::Id> nearest(static_cast<std::size_t>(output->GetNumberOfPoints()));
  for (std::size_t i = 0; i < nearest.size(); ++i)
  {
    nearest[i] = result.Diagram.NearestSites[context.Surface.GetVertex(static_cast<vtkIdType>(i))];
  }
  DGGPassArrays(set, nearest, output->GetPointData());
  DGGPassArrays(
    set, result.Diagram.PolygonSites, vtkPolyData::GetData(outputVector, 2)->GetCellData());
  std::vector<dgg::Id> all(result.Sites.size());
  std::iota(all.begin(), all.end(), 0);
  DGGPassArrays(set, all, vtkPolyData::GetData(outputVector, 3)->GetPointData());
}

//------------------------------------------------------------------------------
void vtkGeodesicVoronoi::vtkInternals::FillOutputs(const DGGContext& context,
  const DGGVoronoiResult& result, const DGGNewGeometry& geometry,
  vtkInformationVector* outputVector) const
{
  const VoronoiOutputs outputs{ result, context.Surface, geometry, this->Self->DistanceArrayName,
    this->Self->UnreachedValue };
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  output->ShallowCopy(context.Input);
  outputs.AddToSurface(this->Self->SourceArrayName, output);
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
void vtkGeodesicVoronoi::vtkInternals::MakeEmptyOutput(
  const DGGContext& context, vtkInformationVector* outputVector)
{
  DGGNewGeometry geometry;
  geometry.Take(context, this->Self->GetOutputPointsPrecision());
  this->FillOutputs(context, DGGVoronoiResult(), geometry, outputVector);
}
