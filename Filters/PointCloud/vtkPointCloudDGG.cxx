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
#include <cmath>
#include <memory>
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
  /// What there is to tell of a graph.
  struct Findings
  {
    vtkDGGGraphSummary Graph;
    std::vector<dgg::Id> ComponentSizes;
    dgg::CloudGraphStatistics Statistics;
  };
  vtkDGGGraphArrays Built;
  Key BuiltBy{};
  std::vector<dgg::Id> Components; // of what was built
  Findings BuiltFindings;
  Findings Current; // of the last update
  dgg::CloudGraphEstimate Estimate;
  vtkTimeStamp BuildTime;

  // By planes, kept while points are the same. Shared: an observer may have the filter forget them.
  Normals PlaneNormals;
  vtkMTimeType NormalsMesh = 0;
  int NormalsNeighbors = 0;
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
  os << indent << "NumberOfStrayPoints: " << this->GetNumberOfStrayPoints() << "\n";
  os << indent << "NumberOfCoincidentPoints: " << this->GetNumberOfCoincidentPoints() << "\n";
  os << indent << "UsedOffsetInVoxels: " << this->GetUsedOffsetInVoxels() << "\n";
  os << indent << "UsedOffset: " << this->GetUsedOffset() << "\n";
  os << indent << "UsedResolution: " << this->GetUsedResolution() << "\n";
  os << indent << "UsedAlpha: " << this->GetUsedAlpha() << "\n";
  os << indent << "VoxelSize: " << this->GetVoxelSize() << "\n";
  os << indent << "Spacing: " << this->GetSpacing() << "\n";
  os << indent << "Noise: " << this->GetNoise() << "\n";
  os << indent << "OffSurfaceShare: " << this->GetOffSurfaceShare() << "\n";
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
  if (!status.IsOk())
  {
    return status;
  }
  // Observers may change the input and the properties.
  vtkNew<vtkPolyData> copy;
  copy->ShallowCopy(cloud);
  dgg::CloudGraphOptions options = this->MakeOptions(copy);
  const NormalsSource source = this->MakeNormalsSource(copy);
  Normals normals;
  double done = 0.0;
  status = this->Advance(0.0) ? this->FindNormals(source, normals, done) : dgg::Status::Abort();
  if (status.IsOk())
  {
    const vtkDGGMeshAdapter& mesh = this->GetMesh();
    options.Normals = normals ? normals->data() : nullptr;
    options.Progress = [this, done](
                         double fraction) { return this->Advance(done + (1.0 - done) * fraction); };
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
  return static_cast<vtkTypeUInt64>(std::ceil(this->Internals->Estimate.Peak)); // a limit that does
}

//------------------------------------------------------------------------------
void vtkPointCloudDGG::ReleaseGraph()
{
  this->Internals->Built.Clear();
  this->Internals->Components = {};
  this->Internals->PlaneNormals.reset();
}

//------------------------------------------------------------------------------
vtkIdType vtkPointCloudDGG::GetNumberOfGraphEdges() const
{
  return this->Internals->Current.Graph.NumberOfEdges;
}

//------------------------------------------------------------------------------
double vtkPointCloudDGG::GetMeanDegree() const
{
  const vtkDGGGraphSummary& graph = this->Internals->Current.Graph;
  return graph.NumberOfVertices > 0
    ? static_cast<double>(graph.NumberOfEdges) / graph.NumberOfVertices
    : 0.0;
}

//------------------------------------------------------------------------------
vtkTypeUInt64 vtkPointCloudDGG::GetMemorySize() const
{
  return this->Internals->Current.Graph.MemorySize;
}

//------------------------------------------------------------------------------
vtkIdType vtkPointCloudDGG::GetNumberOfComponents() const
{
  return static_cast<vtkIdType>(this->Internals->Current.ComponentSizes.size());
}

//------------------------------------------------------------------------------
vtkIdType vtkPointCloudDGG::GetComponentSize(vtkIdType i) const
{
  return i >= 0 && i < this->GetNumberOfComponents() ? this->Internals->Current.ComponentSizes[i]
                                                     : 0;
}

//------------------------------------------------------------------------------
vtkIdType vtkPointCloudDGG::GetNumberOfUnusedPoints() const
{
  return this->Internals->Current.Statistics.UnusedPoints;
}

//------------------------------------------------------------------------------
vtkIdType vtkPointCloudDGG::GetNumberOfStrayPoints() const
{
  return this->Internals->Current.Statistics.StrayPoints;
}

//------------------------------------------------------------------------------
vtkIdType vtkPointCloudDGG::GetNumberOfCoincidentPoints() const
{
  return this->Internals->Current.Statistics.CoincidentPoints;
}

//------------------------------------------------------------------------------
double vtkPointCloudDGG::GetUsedOffsetInVoxels() const
{
  return this->Internals->Current.Statistics.OffsetInVoxels;
}

//------------------------------------------------------------------------------
double vtkPointCloudDGG::GetUsedOffset() const
{
  return this->GetUsedOffsetInVoxels() * this->GetVoxelSize();
}

//------------------------------------------------------------------------------
int vtkPointCloudDGG::GetUsedResolution() const
{
  return this->Internals->Current.Statistics.Resolution;
}

//------------------------------------------------------------------------------
double vtkPointCloudDGG::GetUsedAlpha() const
{
  return this->Internals->Current.Statistics.Alpha;
}

//------------------------------------------------------------------------------
double vtkPointCloudDGG::GetVoxelSize() const
{
  return this->Internals->Current.Statistics.VoxelSize;
}

//------------------------------------------------------------------------------
double vtkPointCloudDGG::GetSpacing() const
{
  return this->Internals->Current.Statistics.Spacing;
}

//------------------------------------------------------------------------------
double vtkPointCloudDGG::GetNoise() const
{
  return this->Internals->Current.Statistics.Noise;
}

//------------------------------------------------------------------------------
double vtkPointCloudDGG::GetOffSurfaceShare() const
{
  return this->Internals->Current.Statistics.OffSurface;
}

//------------------------------------------------------------------------------
double vtkPointCloudDGG::GetReach() const
{
  return this->Internals->Current.Statistics.Reach;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkPointCloudDGG::GetGraphBuildTime() const
{
  return this->Internals->BuildTime.GetMTime();
}

//------------------------------------------------------------------------------
/// Without normals.
dgg::CloudGraphOptions vtkPointCloudDGG::MakeOptions(vtkPolyData* cloud) const
{
  dgg::CloudGraphOptions options;
  options.Scheme = static_cast<dgg::CloudScheme>(this->Scheme);
  options.OffsetInVoxels = this->OffsetInVoxels;
  options.Resolution = this->Resolution;
  options.Alpha = this->Alpha;
  options.Accuracy = this->Accuracy;
  options.ArcLengthWeights = this->ArcLengthWeights;
  options.HasOrientedNormals = this->OrientedNormals && cloud && this->GetInputNormals(cloud);
  options.MemoryLimit = vtkDGGGetMemoryLimit(this->MemoryLimit);
  options.Parallel = vtkDGGMakeParallelFor();
  return options;
}

//------------------------------------------------------------------------------
int vtkPointCloudDGG::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->Internals->Current = vtkInternals::Findings();
  return this->Superclass::RequestData(request, inputVector, outputVector);
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
  return status.IsOk() ? dgg::CloudGraphBuilder::Check(this->MakeOptions(nullptr)) : status;
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
vtkPointCloudDGG::NormalsSource vtkPointCloudDGG::MakeNormalsSource(vtkPolyData* cloud) const
{
  vtkDataArray* given = this->GetInputNormals(cloud);
  return { given, this->EstimateNormals && !given, this->NumberOfNeighbors };
}

//------------------------------------------------------------------------------
/// The normals to build with, null when the builder is to find them. `done` is the share of the
/// progress that it took.
dgg::Status vtkPointCloudDGG::FindNormals(
  const NormalsSource& source, Normals& normals, double& done)
{
  vtkInternals& internals = *this->Internals;
  const vtkDGGMeshAdapter& mesh = this->GetMesh();
  normals.reset();
  done = 0.0;
  const dgg::Id points = mesh.GetMesh().GetNumberOfVertices();
  if (vtkDataArray* given = source.Given)
  {
    const dgg::Status status = vtkDGGCheckMemory("a copy of the normals",
      3.0 * sizeof(double) * points, this->MemoryLimit, "use fewer points");
    if (!status.IsOk())
    {
      return status;
    }
    const vtkIdType n = given->GetNumberOfTuples();
    auto copy = std::make_shared<std::vector<double>>(3 * static_cast<std::size_t>(n));
    for (vtkIdType i = 0; i < n; ++i)
    {
      given->GetTuple(i, copy->data() + 3 * i);
    }
    normals = copy;
    return dgg::Status::Success();
  }
  if (!source.ByPlanes)
  {
    return dgg::Status::Success();
  }
  const bool isKept = internals.PlaneNormals &&
    internals.NormalsNeighbors == source.NumberOfNeighbors &&
    internals.NormalsMesh == mesh.GetBuildTime();
  if (!isKept)
  {
    dgg::Status status = vtkDGGCheckMemory("finding normals", vtkDGGPredictNormalsMemory(points),
      this->MemoryLimit, "use fewer points, or turn EstimateNormals off");
    if (!status.IsOk())
    {
      return status;
    }
    auto found = std::make_shared<std::vector<double>>();
    status = vtkDGGEstimateNormals(
      mesh.GetPositions(), points, source.NumberOfNeighbors,
      [this](double fraction) { return this->Advance(NormalsShare * fraction); }, *found);
    if (!status.IsOk())
    {
      return status;
    }
    internals.PlaneNormals = found;
    internals.NormalsNeighbors = source.NumberOfNeighbors;
    internals.NormalsMesh = mesh.GetBuildTime();
    done = NormalsShare;
  }
  normals = internals.PlaneNormals;
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
/// Build a graph with these options, unless it is the one that is kept.
dgg::Status vtkPointCloudDGG::Build(dgg::CloudGraphOptions options, double done)
{
  vtkInternals& internals = *this->Internals;
  const vtkDGGMeshAdapter& mesh = this->GetMesh();
  const dgg::Id n = mesh.GetMesh().GetNumberOfVertices();
  const Key key = MakeKey(options, n);
  const bool isKept = internals.Built.IsValid() && internals.BuiltBy == key &&
    internals.Built.GetSummary().Info.Surface == mesh.GetSignature();
  if (isKept)
  {
    return dgg::Status::Success();
  }
  internals.Built.Clear();
  options.Progress = [this, done](
                       double fraction) { return this->Advance(done + (1.0 - done) * fraction); };
  dgg::CloudGraph result;
  vtkInternals::Findings findings;
  const dgg::Status status =
    dgg::CloudGraphBuilder(mesh.GetPositions(), n).Build(options, result, &findings.Statistics);
  if (!status.IsOk())
  {
    return status;
  }
  result.Graph.Info.Surface = mesh.GetSignature();
  internals.Built.Adopt(result.Graph, result.Radii, result.VoxelSize, mesh);
  internals.BuiltBy = key;
  internals.Components = std::move(result.Components);
  findings.ComponentSizes = std::move(result.ComponentSizes);
  findings.Graph = internals.Built.GetSummary();
  internals.BuiltFindings = findings;
  internals.BuildTime.Modified();
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
  const NormalsSource source = this->MakeNormalsSource(copy);
  const bool lacksNormals = this->OrientedNormals && !source.Given;
  const std::string name = this->ComponentArrayName;
  const vtkMTimeType built = this->GetGraphBuildTime();
  dgg::CloudGraphOptions options = this->MakeOptions(copy);
  Normals normals;
  double done = 0.0;
  dgg::Status status =
    this->Advance(0.0) ? this->FindNormals(source, normals, done) : dgg::Status::Abort();
  if (status.IsOk())
  {
    options.Normals = normals ? normals->data() : nullptr;
    status = this->Build(options, done);
  }
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
  internals.Current = internals.BuiltFindings;
  const auto n = static_cast<std::size_t>(output->GetNumberOfPoints());
  const auto components = vtkDGGAddArray<vtkIntArray>(output->GetPointData(), name, n);
  std::copy(internals.Components.begin(), internals.Components.end(), components->GetPointer(0));
  if (source.ByPlanes && normals)
  {
    const auto array = vtkDGGMakeArray<vtkDoubleArray>("Normals", n, 3);
    std::copy(normals->begin(), normals->end(), array->GetPointer(0));
    output->GetPointData()->SetNormals(array);
  }
  if (built != this->GetGraphBuildTime())
  {
    this->WarnAboutPoints();
    this->WarnAboutVoxels(options);
  }
  if (lacksNormals)
  {
    vtkWarningMacro("OrientedNormals is on, but the input has no point normals that are used: it "
                    "has no effect, and sheets back to back may be connected. Give the input "
                    "normals, or turn UseInputNormals on or OrientedNormals off.");
  }
  return status;
}

//------------------------------------------------------------------------------
/// Of a graph that has just been built.
void vtkPointCloudDGG::WarnAboutPoints()
{
  const dgg::Id unused = this->Internals->Current.Statistics.UnusedPoints;
  if (unused > 0)
  {
    const bool isOne = unused == 1;
    vtkWarningMacro(<< "the cloud has " << unused << (isOne ? " point that is" : " points that are")
                    << " not finite. " << (isOne ? "It is" : "They are")
                    << " kept, and connected to nothing.");
  }
  const dgg::Id stray = this->Internals->Current.Statistics.StrayPoints;
  if (stray > 0)
  {
    const bool isOne = stray == 1;
    vtkWarningMacro(<< "the cloud has " << stray << (isOne ? " point that is" : " points that are")
                    << " more than 1000 times as far off as all others. "
                    << (isOne ? "It is" : "They are")
                    << " kept, and connected to nothing but points in the same place.");
  }
  const dgg::CloudGraphStatistics& statistics = this->Internals->Current.Statistics;
  if (statistics.Scatter > 0.0)
  {
    vtkWarningMacro(<< "the neighbours of " << 100.0 * statistics.OffSurface
                    << " % of the points do not lie on a surface: points typically scatter by "
                    << statistics.Scatter
                    << " times their spacing. That much is not all taken off: distances may be "
                       "wrong by far. Thin the cloud out, to every tenth point for example or to "
                       "averages of points, until points scatter by less than their spacing.");
  }
}

//------------------------------------------------------------------------------
/// Of a graph that has just been built: voxels that tell less than the points do.
void vtkPointCloudDGG::WarnAboutVoxels(const dgg::CloudGraphOptions& options)
{
  const dgg::CloudGraphStatistics& used = this->Internals->Current.Statistics;
  if (used.Spacing > 0.0 && used.VoxelSize > used.Spacing)
  {
    const bool isGiven = options.OffsetInVoxels > 0.0;
    vtkWarningMacro(
      << "the voxels of the band, of size " << used.VoxelSize << " (Resolution " << used.Resolution
      << (options.Resolution > 0 ? "" : ", automatic")
      << "), are larger than the spacing of the points, which is " << used.Spacing << ". "
      << (isGiven ? "The graph bridges gaps and holes, and may connect or tear apart "
                    "what it should not"
                  : "Building is slower, and paths that vtkDGGPath straightens may "
                    "cross gaps as narrow as a voxel")
      << ". "
      << (options.Resolution > 0 || isGiven
             ? "Use a larger Resolution."
             : "Parts of the cloud are very much sparser than others: leave them out, "
               "or build graphs of their own, if that matters."));
  }
}

//------------------------------------------------------------------------------
void vtkPointCloudDGG::MakeEmptyOutput(vtkPolyData* cloud, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  output->ShallowCopy(cloud);
  vtkDGGGraphArrays::RemoveFrom(output->GetFieldData()); // they are of another cloud
  vtkDGGAddArray<vtkIntArray>(output->GetPointData(), this->ComponentArrayName, 0);
}
