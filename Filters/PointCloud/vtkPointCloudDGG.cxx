// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointCloudDGG.h"

#include "vtkDGGCloudNormals.h"
#include "vtkDGGGraphArrays.h"
#include "vtkDGGMakeArray.h"
#include "vtkDGGMemory.h"
#include "vtkDGGMeshAdapter.h"
#include "vtkDGGParallel.h"
#include "vtkDGGProperties.h"

#include "dggBitHash.h"
#include "dggCloudGraphBuilder.h"

#include "vtkAlgorithmOutput.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTimeStamp.h"

#include <algorithm>
#include <sstream>
#include <vector>

vtkStandardNewMacro(vtkPointCloudDGG);

namespace
{
/// Share of the progress that goes to normals by planes.
constexpr double NormalsShare = 0.1;
constexpr int FewestNeighbors = 3;

/// Numbers by which a graph is known.
using Key = dgg::Signature;

Key MakeKey(const dgg::CloudGraphOptions& options, dgg::Id numberOfPoints)
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

dgg::Status CheckNumber(const char* name, double value)
{
  if (value >= 0.0 && value < dgg::Infinity)
  {
    return dgg::Status::Success();
  }
  std::ostringstream message;
  message << name << " is " << value << ": call Set" << name
          << "() with a positive number, or with 0 for an automatic one";
  return dgg::Status::Invalid(message.str());
}
}

//------------------------------------------------------------------------------
struct vtkPointCloudDGG::vtkInternals
{
  vtkDGGGraphArrays Built;
  Key BuiltBy{};
  std::vector<dgg::Id> Components;
  std::vector<dgg::Id> ComponentSizes;
  dgg::CloudGraphStatistics Statistics;
  vtkDGGGraphSummary Current; // of the graph of the last update
  dgg::CloudGraphEstimate Estimate;
  vtkTimeStamp BuildTime;

  // Normals that the next graph is built with. Those by planes are kept while points are the same.
  std::vector<double> Normals;
  vtkMTimeType NormalsMesh = 0;
  int NormalsNeighbors = 0; // 0 when they are those of the input

  void ForgetUpdate()
  {
    this->Current = vtkDGGGraphSummary();
    this->ComponentSizes.clear();
    this->Statistics = dgg::CloudGraphStatistics();
  }
};

//------------------------------------------------------------------------------
vtkPointCloudDGG::vtkPointCloudDGG()
  : Scheme(C)
  , OffsetInVoxels(0.0)
  , Resolution(0)
  , Alpha(0.0)
  , Accuracy(dgg::CloudGraphOptions().Accuracy)
  , ArcLengthWeights(true)
  , UseInputNormals(true)
  , OrientedNormals(false)
  , EstimateNormals(false)
  , NumberOfNeighbors(16)
  , MemoryLimit(0)
  , ComponentArrayName("Component")
  , Internals(new vtkInternals)
{
}

//------------------------------------------------------------------------------
vtkPointCloudDGG::~vtkPointCloudDGG() = default;

//------------------------------------------------------------------------------
void vtkPointCloudDGG::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Scheme: " << this->GetSchemeAsString() << "\n";
  os << indent << "OffsetInVoxels: " << this->OffsetInVoxels << "\n";
  os << indent << "Resolution: " << this->Resolution << "\n";
  os << indent << "Alpha: " << this->Alpha << "\n";
  os << indent << "Accuracy: " << this->Accuracy << "\n";
  os << indent << "ArcLengthWeights: " << (this->ArcLengthWeights ? "On" : "Off") << "\n";
  os << indent << "UseInputNormals: " << (this->UseInputNormals ? "On" : "Off") << "\n";
  os << indent << "OrientedNormals: " << (this->OrientedNormals ? "On" : "Off") << "\n";
  os << indent << "EstimateNormals: " << (this->EstimateNormals ? "On" : "Off") << "\n";
  os << indent << "NumberOfNeighbors: " << this->NumberOfNeighbors << "\n";
  os << indent << "MemoryLimit: " << this->MemoryLimit << "\n";
  os << indent << "ComponentArrayName: " << this->ComponentArrayName << "\n";
  os << indent << "EstimatedMemory: " << this->GetEstimatedMemory() << "\n";
  os << indent << "EstimatedPeakMemory: " << this->GetEstimatedPeakMemory() << "\n";
  os << indent << "NumberOfGraphEdges: " << this->GetNumberOfGraphEdges() << "\n";
  os << indent << "MeanDegree: " << this->GetMeanDegree() << "\n";
  os << indent << "MemorySize: " << this->GetMemorySize() << "\n";
  os << indent << "NumberOfComponents: " << this->GetNumberOfComponents() << "\n";
  os << indent << "NumberOfUnusedPoints: " << this->GetNumberOfUnusedPoints() << "\n";
  os << indent << "NumberOfCoincidentPoints: " << this->GetNumberOfCoincidentPoints() << "\n";
  os << indent << "UsedOffsetInVoxels: " << this->GetUsedOffsetInVoxels() << "\n";
  os << indent << "UsedOffset: " << this->GetUsedOffset() << "\n";
  os << indent << "UsedResolution: " << this->GetUsedResolution() << "\n";
  os << indent << "UsedAlpha: " << this->GetUsedAlpha() << "\n";
  os << indent << "VoxelSize: " << this->GetVoxelSize() << "\n";
  os << indent << "Spacing: " << this->GetSpacing() << "\n";
  os << indent << "Noise: " << this->GetNoise() << "\n";
  os << indent << "Reach: " << this->GetReach() << "\n";
  os << indent << "GraphBuildTime: " << this->GetGraphBuildTime() << "\n";
}

//------------------------------------------------------------------------------
const char* vtkPointCloudDGG::GetSchemeAsString() const
{
  switch (this->Scheme)
  {
    case A:
      return "A";
    case B:
      return "B";
    default:
      return "C";
  }
}

//------------------------------------------------------------------------------
void vtkPointCloudDGG::SetComponentArrayName(const char* name)
{
  if (vtkDGGChangeName(this->ComponentArrayName, name))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
const char* vtkPointCloudDGG::GetComponentArrayName() const
{
  return this->ComponentArrayName.c_str();
}

//------------------------------------------------------------------------------
vtkTypeUInt64 vtkPointCloudDGG::EstimateMemory()
{
  this->Internals->Estimate = dgg::CloudGraphEstimate();
  const unsigned long errorCode = this->GetErrorCode();
  this->SetAbortExecute(0);
  const bool done = this->Attempt([this] { return this->Estimate(); });
  if (this->GetErrorCode() == vtkErrorCode::NoError)
  {
    this->SetErrorCode(errorCode); // that of the last update
  }
  return done ? this->GetEstimatedMemory() : 0;
}

//------------------------------------------------------------------------------
dgg::Status vtkPointCloudDGG::Estimate()
{
  if (this->GetNumberOfInputConnections(0) > 0)
  {
    this->GetInputAlgorithm()->Update(this->GetInputConnection(0, 0)->GetIndex());
  }
  dgg::Status status = this->CheckProperties();
  vtkPolyData* cloud = vtkPolyData::SafeDownCast(this->GetInput());
  if (status.IsOk() && cloud && cloud->GetNumberOfPoints() == 0)
  {
    vtkWarningMacro("The input is empty: it has no points. So is its graph.");
    return status;
  }
  if (status.IsOk() && cloud)
  {
    status = this->CheckInputs(cloud, nullptr);
  }
  if (status.IsOk())
  {
    status = this->PrepareMesh(cloud);
  }
  dgg::CloudGraphOptions options;
  double done = 0.0;
  if (status.IsOk())
  {
    status = this->Advance(0.0) ? this->Prepare(cloud, options, done) : dgg::Status::Abort();
  }
  if (status.IsOk())
  {
    const vtkDGGMeshAdapter& mesh = this->GetMesh();
    status = dgg::CloudGraphBuilder(mesh.GetPositions(), mesh.GetMesh().GetNumberOfVertices())
               .Estimate(options, this->Internals->Estimate);
  }
  return status.IsOk() && !this->Advance(1.0) ? dgg::Status::Abort() : status;
}

//------------------------------------------------------------------------------
vtkTypeUInt64 vtkPointCloudDGG::GetEstimatedMemory() const
{
  return static_cast<vtkTypeUInt64>(this->Internals->Estimate.Memory);
}

//------------------------------------------------------------------------------
vtkTypeUInt64 vtkPointCloudDGG::GetEstimatedPeakMemory() const
{
  return static_cast<vtkTypeUInt64>(this->Internals->Estimate.Peak);
}

//------------------------------------------------------------------------------
void vtkPointCloudDGG::ReleaseGraph()
{
  this->Internals->Built.Clear();
  this->Internals->Components = {};
  this->Internals->Normals = {};
  this->Internals->NormalsMesh = 0;
}

//------------------------------------------------------------------------------
vtkIdType vtkPointCloudDGG::GetNumberOfGraphEdges() const
{
  return this->Internals->Current.NumberOfEdges;
}

//------------------------------------------------------------------------------
double vtkPointCloudDGG::GetMeanDegree() const
{
  const vtkDGGGraphSummary& graph = this->Internals->Current;
  return graph.NumberOfVertices > 0
    ? static_cast<double>(graph.NumberOfEdges) / graph.NumberOfVertices
    : 0.0;
}

//------------------------------------------------------------------------------
vtkTypeUInt64 vtkPointCloudDGG::GetMemorySize() const
{
  return this->Internals->Current.MemorySize;
}

//------------------------------------------------------------------------------
vtkIdType vtkPointCloudDGG::GetNumberOfComponents() const
{
  return static_cast<vtkIdType>(this->Internals->ComponentSizes.size());
}

//------------------------------------------------------------------------------
vtkIdType vtkPointCloudDGG::GetComponentSize(vtkIdType i) const
{
  return i >= 0 && i < this->GetNumberOfComponents() ? this->Internals->ComponentSizes[i] : 0;
}

//------------------------------------------------------------------------------
vtkIdType vtkPointCloudDGG::GetNumberOfUnusedPoints() const
{
  return this->Internals->Statistics.UnusedPoints;
}

//------------------------------------------------------------------------------
vtkIdType vtkPointCloudDGG::GetNumberOfCoincidentPoints() const
{
  return this->Internals->Statistics.CoincidentPoints;
}

//------------------------------------------------------------------------------
double vtkPointCloudDGG::GetUsedOffsetInVoxels() const
{
  return this->Internals->Statistics.OffsetInVoxels;
}

//------------------------------------------------------------------------------
double vtkPointCloudDGG::GetUsedOffset() const
{
  return this->GetUsedOffsetInVoxels() * this->GetVoxelSize();
}

//------------------------------------------------------------------------------
int vtkPointCloudDGG::GetUsedResolution() const
{
  return this->Internals->Statistics.Resolution;
}

//------------------------------------------------------------------------------
double vtkPointCloudDGG::GetUsedAlpha() const
{
  return this->Internals->Statistics.Alpha;
}

//------------------------------------------------------------------------------
double vtkPointCloudDGG::GetVoxelSize() const
{
  return this->Internals->Statistics.VoxelSize;
}

//------------------------------------------------------------------------------
double vtkPointCloudDGG::GetSpacing() const
{
  return this->Internals->Statistics.Spacing;
}

//------------------------------------------------------------------------------
double vtkPointCloudDGG::GetNoise() const
{
  return this->Internals->Statistics.Noise;
}

//------------------------------------------------------------------------------
double vtkPointCloudDGG::GetReach() const
{
  return this->Internals->Statistics.Reach;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkPointCloudDGG::GetGraphBuildTime() const
{
  return this->Internals->BuildTime.GetMTime();
}

//------------------------------------------------------------------------------
dgg::CloudGraphOptions vtkPointCloudDGG::MakeOptions() const
{
  dgg::CloudGraphOptions options;
  options.Scheme = static_cast<dgg::CloudScheme>(this->Scheme);
  options.OffsetInVoxels = this->OffsetInVoxels;
  options.Resolution = this->Resolution;
  options.Alpha = this->Alpha;
  options.Accuracy = this->Accuracy;
  options.ArcLengthWeights = this->ArcLengthWeights;
  options.MemoryLimit = vtkDGGGetMemoryLimit(this->MemoryLimit);
  options.Parallel = vtkDGGMakeParallelFor();
  return options;
}

//------------------------------------------------------------------------------
int vtkPointCloudDGG::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->Internals->Current = vtkDGGGraphSummary();
  const int result = this->Superclass::RequestData(request, inputVector, outputVector);
  if (this->Internals->Current.NumberOfVertices == 0)
  {
    this->Internals->ForgetUpdate();
  }
  return result;
}

//------------------------------------------------------------------------------
dgg::Status vtkPointCloudDGG::CheckProperties() const
{
  dgg::Status status = CheckNumber("OffsetInVoxels", this->OffsetInVoxels);
  if (status.IsOk())
  {
    status = CheckNumber("Resolution", this->Resolution);
  }
  if (status.IsOk())
  {
    status = CheckNumber("Alpha", this->Alpha);
  }
  if (status.IsOk() && this->NumberOfNeighbors < FewestNeighbors)
  {
    status =
      dgg::Status::Invalid("NumberOfNeighbors is " + std::to_string(this->NumberOfNeighbors) +
        ": call SetNumberOfNeighbors() with at least " + std::to_string(FewestNeighbors));
  }
  if (status.IsOk() && this->ComponentArrayName.empty())
  {
    status =
      dgg::Status::Invalid("ComponentArrayName is empty: call SetComponentArrayName() with a name");
  }
  return status.IsOk() ? dgg::CloudGraphBuilder::Check(this->MakeOptions()) : status;
}

//------------------------------------------------------------------------------
vtkDataArray* vtkPointCloudDGG::GetInputNormals(vtkPolyData* cloud) const
{
  return this->UseInputNormals ? cloud->GetPointData()->GetNormals() : nullptr;
}

//------------------------------------------------------------------------------
dgg::Status vtkPointCloudDGG::CheckInputs(
  vtkPolyData* cloud, vtkInformationVector** vtkNotUsed(inputVector)) const
{
  vtkDataArray* normals = this->GetInputNormals(cloud);
  const bool fits = !normals ||
    (normals->GetNumberOfComponents() == 3 &&
      normals->GetNumberOfTuples() == cloud->GetNumberOfPoints());
  if (fits)
  {
    return dgg::Status::Success();
  }
  std::ostringstream message;
  message << "the point normals of the input have " << normals->GetNumberOfComponents()
          << " components and " << normals->GetNumberOfTuples() << " tuples for "
          << cloud->GetNumberOfPoints()
          << " points: three numbers per point are needed. Repair them, or turn UseInputNormals "
             "off";
  return dgg::Status::Invalid(message.str());
}

//------------------------------------------------------------------------------
bool vtkPointCloudDGG::IsCloud(vtkPolyData* vtkNotUsed(input)) const
{
  return true;
}

//------------------------------------------------------------------------------
std::string vtkPointCloudDGG::GetMemoryRemedy() const
{
  return "use fewer points, a larger Accuracy, a smaller Alpha or a smaller Resolution";
}

//------------------------------------------------------------------------------
/// The options, with normals. `done` is the share of the progress that these took.
dgg::Status vtkPointCloudDGG::Prepare(
  vtkPolyData* cloud, dgg::CloudGraphOptions& options, double& done)
{
  vtkInternals& internals = *this->Internals;
  const vtkDGGMeshAdapter& mesh = this->GetMesh();
  options = this->MakeOptions();
  done = 0.0;
  vtkDataArray* given = this->GetInputNormals(cloud);
  if (given)
  {
    const vtkIdType n = given->GetNumberOfTuples();
    internals.NormalsNeighbors = 0;
    internals.Normals.resize(3 * static_cast<std::size_t>(n));
    for (vtkIdType i = 0; i < n; ++i)
    {
      given->GetTuple(i, &internals.Normals[3 * static_cast<std::size_t>(i)]);
    }
    options.HasOrientedNormals = this->OrientedNormals;
  }
  else if (this->EstimateNormals)
  {
    const bool isKept = internals.NormalsNeighbors == this->NumberOfNeighbors &&
      internals.NormalsMesh == mesh.GetBuildTime();
    if (!isKept)
    {
      const int count = this->NumberOfNeighbors; // observers may change it
      internals.NormalsNeighbors = 0;
      const dgg::Status status = vtkDGGEstimateNormals(
        mesh.GetPositions(), mesh.GetMesh().GetNumberOfVertices(), count,
        [this](double fraction) { return this->Advance(NormalsShare * fraction); },
        internals.Normals);
      if (!status.IsOk())
      {
        return status;
      }
      internals.NormalsNeighbors = count;
      internals.NormalsMesh = mesh.GetBuildTime();
      done = NormalsShare;
    }
  }
  else
  {
    internals.NormalsNeighbors = 0;
    internals.Normals = {};
  }
  options.Normals = internals.Normals.empty() ? nullptr : internals.Normals.data();
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
dgg::Status vtkPointCloudDGG::Build(vtkPolyData* cloud)
{
  vtkInternals& internals = *this->Internals;
  const vtkDGGMeshAdapter& mesh = this->GetMesh();
  const dgg::Id n = mesh.GetMesh().GetNumberOfVertices();
  dgg::CloudGraphOptions options;
  double done = 0.0;
  dgg::Status status = this->Prepare(cloud, options, done);
  if (!status.IsOk())
  {
    return status;
  }
  const Key key = MakeKey(options, n);
  const bool isKept = internals.Built.IsValid() && internals.BuiltBy == key &&
    internals.Built.GetSummary().Info.Surface == mesh.GetSignature();
  if (isKept)
  {
    return status;
  }
  internals.Built.Clear();
  internals.ForgetUpdate();
  options.Progress = [this, done](
                       double fraction) { return this->Advance(done + (1.0 - done) * fraction); };
  dgg::CloudGraph result;
  status =
    dgg::CloudGraphBuilder(mesh.GetPositions(), n).Build(options, result, &internals.Statistics);
  if (status.IsOk())
  {
    result.Graph.Info.Surface = mesh.GetSignature();
    internals.Built.Adopt(result.Graph, result.Radii, result.VoxelSize, mesh);
    internals.BuiltBy = key;
    internals.Components = std::move(result.Components);
    internals.ComponentSizes = std::move(result.ComponentSizes);
    internals.BuildTime.Modified();
    if (internals.Statistics.UnusedPoints > 0)
    {
      vtkWarningMacro(<< "the cloud has " << internals.Statistics.UnusedPoints
                      << " points that are not finite. They are kept, and connected to nothing.");
    }
  }
  return status;
}

//------------------------------------------------------------------------------
dgg::Status vtkPointCloudDGG::Execute(vtkPolyData* cloud,
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  vtkInternals& internals = *this->Internals;
  // Observers may change the input and the properties.
  vtkNew<vtkPolyData> copy;
  copy->ShallowCopy(cloud);
  const bool addsNormals = this->EstimateNormals && !this->GetInputNormals(copy);
  const std::string name = this->ComponentArrayName;
  dgg::Status status = this->Advance(0.0) ? this->Build(copy) : dgg::Status::Abort();
  if (status.IsOk())
  {
    status = this->GetMesh().CheckPoints(copy);
  }
  if (!status.IsOk())
  {
    return status;
  }
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  output->ShallowCopy(copy);
  internals.Built.AddTo(output->GetFieldData());
  internals.Current = internals.Built.GetSummary();
  const auto n = static_cast<std::size_t>(output->GetNumberOfPoints());
  const auto components = vtkDGGAddArray<vtkIntArray>(output->GetPointData(), name, n);
  std::copy(internals.Components.begin(), internals.Components.end(), components->GetPointer(0));
  if (addsNormals)
  {
    const auto normals = vtkDGGMakeArray<vtkDoubleArray>("Normals", n, 3);
    std::copy(internals.Normals.begin(), internals.Normals.end(), normals->GetPointer(0));
    output->GetPointData()->SetNormals(normals);
  }
  return status;
}

//------------------------------------------------------------------------------
void vtkPointCloudDGG::MakeEmptyOutput(vtkPolyData* cloud, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  output->ShallowCopy(cloud);
  vtkDGGGraphArrays::RemoveFrom(output->GetFieldData()); // they are of another cloud
  vtkDGGAddArray<vtkIntArray>(output->GetPointData(), this->ComponentArrayName, 0);
}
