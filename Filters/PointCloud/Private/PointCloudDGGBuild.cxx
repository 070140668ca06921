// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
// vtkPointCloudDGG: how graphs are built, kept and predicted.
#include "PointCloudDGGInternals.h"

#include "DGGContext.h"
#include "DGGSurfaceArrays.h"

#include "dggBitHash.h"
#include "dggCloudGraphTask.h"
#include "dggCloudNormals.h"
#include "dggPreparedSurface.h"
#include "dggProgressPart.h"

#include "vtkDataArray.h"
#include "vtkPolyData.h"

#include <memory>
#include <vector>

namespace
{
/// Progress weight of the estimation of normals.
constexpr double NormalsShare = 0.1;
/// Bytes per point that the estimation of normals takes, including PCL's copies and tree.
constexpr double BytesPerNormal = 106.0;

/// Returns the key that identifies a graph.
dgg::Signature MakeKey(const dgg::CloudGraphOptions& options, dgg::Id numberOfPoints)
{
  dgg::BitHash hash;
  const double numbers[] = { static_cast<double>(options.Scheme), options.OffsetInVoxels,
    static_cast<double>(options.Resolution), options.Alpha, options.Accuracy,
    options.ArcLengthWeights ? 1.0 : 0.0, options.HasOrientedNormals ? 1.0 : 0.0,
    options.Normals ? 1.0 : 0.0 };
  hash.Add(numbers, sizeof(numbers) / sizeof(numbers[0]));
  if (options.Normals)
  {
    hash.Add(options.Normals, 3 * static_cast<std::size_t>(numberOfPoints));
  }
  return hash.Finish();
}
}

//------------------------------------------------------------------------------
vtkTypeUInt64 vtkPointCloudDGG::EstimateMemory()
{
  vtkInternals& internals = this->GetInternals();
  internals.Estimate = dgg::CloudGraphEstimate();
  const bool done = internals.AttemptOutsideOfUpdate([&] { return internals.Predict(); });
  return done ? this->GetEstimatedMemory() : 0;
}

//------------------------------------------------------------------------------
dgg::Status vtkPointCloudDGG::vtkInternals::Predict()
{
  DGG_RETURN_IF_ERROR(this->CheckAllProperties());
  vtkSmartPointer<vtkPolyData> cloud;
  DGG_RETURN_IF_ERROR(this->GetWholeInput(cloud));
  if (cloud && cloud->GetNumberOfPoints() == 0)
  {
    this->WarnAboutEmptyInput("no points");
    return dgg::Status::Success();
  }
  DGG_RETURN_IF_ERROR(this->PrepareMesh(cloud));
  DGG_RETURN_IF_ERROR(this->CheckInputNormals(cloud));
  const NormalsSource source = this->MakeNormalsSource(cloud);
  Normals normals;
  double done = 0.0;
  const DGGContext context = this->MakeContext(cloud);
  dgg::CloudGraphOptions options = this->MakeOptions();
  options.HasOrientedNormals = this->Self->OrientedNormals && source.Given;
  DGG_RETURN_IF_ERROR(dgg::ReportTo(context.Progress, 0.0));
  DGG_RETURN_IF_ERROR(this->FindNormals(context, source, normals, done));
  options.Normals = normals ? normals->data() : nullptr;
  DGG_RETURN_IF_ERROR(dgg::EstimateCloudGraph(
    context, options, dgg::ProgressPart(context.Progress, done, 1.0), this->Estimate));
  return dgg::ReportTo(context.Progress, 1.0);
}

//------------------------------------------------------------------------------
/// Returns the options of the graph that are properties of the filter.
dgg::CloudGraphOptions vtkPointCloudDGG::vtkInternals::MakeOptions() const
{
  dgg::CloudGraphOptions options;
  options.Scheme = static_cast<dgg::CloudScheme>(this->Self->Scheme);
  options.OffsetInVoxels = this->Self->OffsetInVoxels;
  options.Resolution = this->Self->Resolution;
  options.Alpha = this->Self->Alpha;
  options.Accuracy = this->Self->Accuracy;
  options.ArcLengthWeights = this->Self->ArcLengthWeights;
  return options;
}

//------------------------------------------------------------------------------
vtkPointCloudDGG::vtkInternals::NormalsSource vtkPointCloudDGG::vtkInternals::MakeNormalsSource(
  vtkPolyData* cloud) const
{
  vtkDataArray* given = this->GetInputNormals(cloud);
  return { given, this->Self->EstimateNormals && !given, this->Self->NumberOfNeighbors };
}

//------------------------------------------------------------------------------
/// Finds the normals for the builder; null if the builder must estimate them. `done` receives the
/// fraction of the progress that this step took.
dgg::Status vtkPointCloudDGG::vtkInternals::FindNormals(
  const DGGContext& context, const NormalsSource& source, Normals& normals, double& done)
{
  const dgg::PreparedSurface& mesh = context.Surface;
  normals.reset();
  done = 0.0;
  const dgg::Id points = mesh.GetMesh().GetNumberOfVertices();
  if (vtkDataArray* given = source.Given)
  {
    DGG_RETURN_IF_ERROR(context.Memory.Check(
      "A copy of the normals", 3.0 * sizeof(double) * points, "Use fewer points"));
    normals = std::make_shared<const std::vector<double>>(DGGReadArray(given, "").Values);
    return dgg::Status::Success();
  }
  if (!source.ByPlanes)
  {
    return dgg::Status::Success();
  }
  const bool isKept = this->PlaneNormals && this->NormalsNeighbors == source.NumberOfNeighbors &&
    this->NormalsMesh == mesh.GetBuildNumber();
  if (!isKept)
  {
    DGG_RETURN_IF_ERROR(context.Memory.Check("Estimating normals", BytesPerNormal * points,
      "Use fewer points, or turn off {EstimateNormals}"));
    auto found = std::make_shared<std::vector<double>>();
    DGG_RETURN_IF_ERROR(dgg::EstimateNormals(context, source.NumberOfNeighbors,
      dgg::ProgressPart(context.Progress, 0.0, NormalsShare), *found));
    this->PlaneNormals = found;
    this->NormalsNeighbors = source.NumberOfNeighbors;
    this->NormalsMesh = mesh.GetBuildNumber();
    done = NormalsShare;
  }
  normals = this->PlaneNormals;
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
/// Builds a graph with these options, unless the kept graph has the same key.
dgg::Status vtkPointCloudDGG::vtkInternals::Build(
  const DGGContext& context, const dgg::CloudGraphOptions& options, double done)
{
  const dgg::PreparedSurface& mesh = context.Surface;
  const dgg::Signature key = MakeKey(options, mesh.GetMesh().GetNumberOfVertices());
  const bool isKept = this->Built.IsValid() && this->BuiltBy == key &&
    this->Built.GetView().Info.Surface == mesh.GetSignature();
  if (isKept)
  {
    return dgg::Status::Success();
  }
  this->Built.Clear();
  dgg::CloudGraph result;
  Findings findings;
  DGG_RETURN_IF_ERROR(dgg::BuildCloudGraph(
    context, options, dgg::ProgressPart(context.Progress, done, 1.0), result, findings.Statistics));
  this->Built.Adopt(result.Graph, result.Radii, result.VoxelSize, context);
  this->BuiltBy = key;
  this->Components = std::move(result.Components);
  findings.ComponentSizes = std::move(result.ComponentSizes);
  findings.Graph = dgg::GraphSummary(this->Built.GetView());
  this->BuiltFindings = findings;
  this->BuildTime.Modified();
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
void vtkPointCloudDGG::ReleaseGraph()
{
  this->GetInternals().Built.Clear();
  this->GetInternals().Components = {};
  this->GetInternals().PlaneNormals.reset();
}
