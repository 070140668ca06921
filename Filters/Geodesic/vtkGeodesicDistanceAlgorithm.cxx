// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGeodesicDistanceAlgorithm.h"

#include "vtkDGGCompatibility.h"
#include "vtkDGGDistanceTask.h"
#include "vtkDGGMeshAdapter.h"
#include "vtkDGGSourceCollector.h"

#include "vtkDemandDrivenPipeline.h"
#include "vtkDoubleArray.h"
#include "vtkErrorCode.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <new>
#include <sstream>

namespace
{
/// Share of the progress that goes to the preparation of the mesh.
constexpr double PreparationShare = 0.1;

/// Change a name; null is the empty name. Returns whether it is a change.
bool Assign(std::string& name, const char* value)
{
  const std::string text = value ? value : "";
  if (name == text)
  {
    return false;
  }
  name = text;
  return true;
}

/// Non-negative, infinity included.
bool IsLength(double value)
{
  return value >= 0.0; // false for NaN
}

dgg::Status InvalidLength(const char* property, double value)
{
  std::ostringstream message;
  message << property << " is " << value << ": it must not be negative or NaN";
  return dgg::Status::Invalid(message.str());
}

void WriteReport(std::ostream& os, const vtkDGGMeshAdapter& adapter)
{
  const dgg::MeshReport& report = adapter.GetReport();
  os << "points: " << report.Vertices << "\n";
  os << "triangles: " << report.Faces << "\n";
  os << "components: " << report.Components << "\n";
  os << "boundary loops: " << report.BoundaryLoops << "\n";
  os << "boundary edges: " << report.BoundaryEdges << "\n";
  os << "orientable: " << (report.Orientable ? "yes" : "no") << "\n";
  os << "genus: ";
  if (report.Genus < 0)
  {
    os << "undefined\n";
  }
  else
  {
    os << report.Genus << "\n";
  }
  os << "non-manifold edges: " << report.NonManifoldEdges << "\n";
  os << "non-manifold vertices: " << report.NonManifoldVertices << "\n";
  os << "dropped faces: " << adapter.GetNumberOfDroppedCells() << "\n";
  os << "degenerate faces: " << report.DegenerateFaces << "\n";
  os << "duplicate faces: " << report.DuplicateFaces << "\n";
  os << "isolated points: " << adapter.GetNumberOfIsolatedPoints() << "\n";
  os << "coincident points: " << report.CoincidentPoints << "\n";
  os << "merged points: " << adapter.GetNumberOfMergedPoints() << "\n";
  os << "length added to degenerate faces: " << report.Mollification << "\n";
  os << "anisotropy: mean " << report.MeanAnisotropy << ", median " << report.MedianAnisotropy
     << "\n";
}
}

//------------------------------------------------------------------------------
struct vtkGeodesicDistanceAlgorithm::vtkInternals
{
  vtkDGGMeshAdapter Adapter;
  vtkDGGSourceCollector Collector;
};

//------------------------------------------------------------------------------
vtkGeodesicDistanceAlgorithm::vtkGeodesicDistanceAlgorithm()
  : ProjectionTolerance(0.01)
  , MergeCoincidentPoints(false)
  , MaximumDistance(VTK_DOUBLE_MAX)
  , UnreachedValue(std::numeric_limits<double>::quiet_NaN())
  , GenerateNearestSource(false)
  , DistanceArrayName("GeodesicDistance")
  , SourceArrayName("GeodesicSource")
  , InitialDistanceArrayName("InitialDistance")
  , Internals(new vtkInternals)
{
  this->SetNumberOfInputPorts(2);
}

//------------------------------------------------------------------------------
vtkGeodesicDistanceAlgorithm::~vtkGeodesicDistanceAlgorithm() = default;

//------------------------------------------------------------------------------
void vtkGeodesicDistanceAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SourceIds:";
  for (const vtkIdType id : this->SourceIds)
  {
    os << " " << id;
  }
  os << (this->SourceIds.empty() ? " (none)\n" : "\n");
  os << indent << "ProjectionTolerance: " << this->ProjectionTolerance << "\n";
  os << indent << "MergeCoincidentPoints: " << (this->MergeCoincidentPoints ? "On" : "Off") << "\n";
  os << indent << "MaximumDistance: " << this->MaximumDistance << "\n";
  os << indent << "UnreachedValue: " << this->UnreachedValue << "\n";
  os << indent << "GenerateNearestSource: " << (this->GenerateNearestSource ? "On" : "Off") << "\n";
  os << indent << "DistanceArrayName: " << this->DistanceArrayName << "\n";
  os << indent << "SourceArrayName: " << this->SourceArrayName << "\n";
  os << indent << "InitialDistanceArrayName: " << this->InitialDistanceArrayName << "\n";
  os << indent << "MeshBuildTime: " << this->GetMeshBuildTime() << "\n";
  os << indent << "MeshReport:\n";
  std::istringstream report(this->GetMeshReport());
  for (std::string line; std::getline(report, line);)
  {
    os << indent.GetNextIndent() << line << "\n";
  }
}

//------------------------------------------------------------------------------
void vtkGeodesicDistanceAlgorithm::AddSourceId(vtkIdType id)
{
  this->SourceIds.push_back(id);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkGeodesicDistanceAlgorithm::SetSourceIds(vtkIdList* ids)
{
  std::vector<vtkIdType> copy;
  if (ids)
  {
    copy.assign(ids->begin(), ids->end());
  }
  this->SetSourceIds(copy);
}

//------------------------------------------------------------------------------
void vtkGeodesicDistanceAlgorithm::SetSourceIds(const std::vector<vtkIdType>& ids)
{
  if (this->SourceIds != ids)
  {
    this->SourceIds = ids;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkGeodesicDistanceAlgorithm::SetSourceIds(std::initializer_list<vtkIdType> ids)
{
  this->SetSourceIds(std::vector<vtkIdType>(ids));
}

//------------------------------------------------------------------------------
void vtkGeodesicDistanceAlgorithm::RemoveAllSourceIds()
{
  this->SetSourceIds(std::vector<vtkIdType>());
}

//------------------------------------------------------------------------------
void vtkGeodesicDistanceAlgorithm::RemoveAllSources()
{
  this->RemoveAllSourceIds();
  this->SetInputConnection(1, nullptr);
}

//------------------------------------------------------------------------------
vtkIdType vtkGeodesicDistanceAlgorithm::GetNumberOfSourceIds() const
{
  return static_cast<vtkIdType>(this->SourceIds.size());
}

//------------------------------------------------------------------------------
vtkIdType vtkGeodesicDistanceAlgorithm::GetSourceId(vtkIdType i) const
{
  return i >= 0 && i < this->GetNumberOfSourceIds() ? this->SourceIds[i] : -1;
}

//------------------------------------------------------------------------------
void vtkGeodesicDistanceAlgorithm::SetSourceConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(1, output);
}

//------------------------------------------------------------------------------
void vtkGeodesicDistanceAlgorithm::SetSourceData(vtkPolyData* points)
{
  this->SetInputData(1, points);
}

//------------------------------------------------------------------------------
void vtkGeodesicDistanceAlgorithm::SetUnreachedValue(double value)
{
  const bool bothNaN = std::isnan(value) && std::isnan(this->UnreachedValue);
  if (this->UnreachedValue != value && !bothNaN)
  {
    this->UnreachedValue = value;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkGeodesicDistanceAlgorithm::SetDistanceArrayName(const char* name)
{
  if (Assign(this->DistanceArrayName, name))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
const char* vtkGeodesicDistanceAlgorithm::GetDistanceArrayName() const
{
  return this->DistanceArrayName.c_str();
}

//------------------------------------------------------------------------------
void vtkGeodesicDistanceAlgorithm::SetSourceArrayName(const char* name)
{
  if (Assign(this->SourceArrayName, name))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
const char* vtkGeodesicDistanceAlgorithm::GetSourceArrayName() const
{
  return this->SourceArrayName.c_str();
}

//------------------------------------------------------------------------------
void vtkGeodesicDistanceAlgorithm::SetInitialDistanceArrayName(const char* name)
{
  if (Assign(this->InitialDistanceArrayName, name))
  {
    this->Modified();
  }
}

//------------------------------------------------------------------------------
const char* vtkGeodesicDistanceAlgorithm::GetInitialDistanceArrayName() const
{
  return this->InitialDistanceArrayName.c_str();
}

//------------------------------------------------------------------------------
std::string vtkGeodesicDistanceAlgorithm::GetMeshReport() const
{
  if (this->GetNumberOfTriangles() == 0)
  {
    return "no surface\n";
  }
  std::ostringstream os;
  WriteReport(os, this->Internals->Adapter);
  return os.str();
}

//------------------------------------------------------------------------------
vtkIdType vtkGeodesicDistanceAlgorithm::GetNumberOfTriangles() const
{
  return this->Internals->Adapter.GetReport().Faces;
}

//------------------------------------------------------------------------------
vtkIdType vtkGeodesicDistanceAlgorithm::GetNumberOfIsolatedPoints() const
{
  return this->Internals->Adapter.GetNumberOfIsolatedPoints();
}

//------------------------------------------------------------------------------
vtkIdType vtkGeodesicDistanceAlgorithm::GetNumberOfComponents() const
{
  return this->Internals->Adapter.GetReport().Components;
}

//------------------------------------------------------------------------------
vtkIdType vtkGeodesicDistanceAlgorithm::GetNumberOfBoundaryEdges() const
{
  return this->Internals->Adapter.GetReport().BoundaryEdges;
}

//------------------------------------------------------------------------------
vtkIdType vtkGeodesicDistanceAlgorithm::GetNumberOfBoundaryLoops() const
{
  return this->Internals->Adapter.GetReport().BoundaryLoops;
}

//------------------------------------------------------------------------------
vtkIdType vtkGeodesicDistanceAlgorithm::GetNumberOfNonManifoldEdges() const
{
  return this->Internals->Adapter.GetReport().NonManifoldEdges;
}

//------------------------------------------------------------------------------
vtkIdType vtkGeodesicDistanceAlgorithm::GetNumberOfNonManifoldVertices() const
{
  return this->Internals->Adapter.GetReport().NonManifoldVertices;
}

//------------------------------------------------------------------------------
vtkIdType vtkGeodesicDistanceAlgorithm::GetNumberOfDroppedFaces() const
{
  return this->Internals->Adapter.GetNumberOfDroppedCells();
}

//------------------------------------------------------------------------------
vtkIdType vtkGeodesicDistanceAlgorithm::GetNumberOfDegenerateFaces() const
{
  return this->Internals->Adapter.GetReport().DegenerateFaces;
}

//------------------------------------------------------------------------------
vtkIdType vtkGeodesicDistanceAlgorithm::GetNumberOfDuplicateFaces() const
{
  return this->Internals->Adapter.GetReport().DuplicateFaces;
}

//------------------------------------------------------------------------------
vtkIdType vtkGeodesicDistanceAlgorithm::GetNumberOfCoincidentPoints() const
{
  return this->Internals->Adapter.GetReport().CoincidentPoints;
}

//------------------------------------------------------------------------------
vtkIdType vtkGeodesicDistanceAlgorithm::GetNumberOfCoincidentBoundaryPoints() const
{
  return this->Internals->Adapter.GetNumberOfCoincidentBoundaryPoints();
}

//------------------------------------------------------------------------------
bool vtkGeodesicDistanceAlgorithm::GetOrientable() const
{
  return this->Internals->Adapter.GetReport().Orientable;
}

//------------------------------------------------------------------------------
vtkIdType vtkGeodesicDistanceAlgorithm::GetGenus() const
{
  return this->Internals->Adapter.GetReport().Genus;
}

//------------------------------------------------------------------------------
double vtkGeodesicDistanceAlgorithm::GetMeanAnisotropy() const
{
  return this->Internals->Adapter.GetReport().MeanAnisotropy;
}

//------------------------------------------------------------------------------
double vtkGeodesicDistanceAlgorithm::GetMedianAnisotropy() const
{
  return this->Internals->Adapter.GetReport().MedianAnisotropy;
}

//------------------------------------------------------------------------------
double vtkGeodesicDistanceAlgorithm::GetMollification() const
{
  return this->Internals->Adapter.GetReport().Mollification;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkGeodesicDistanceAlgorithm::GetMeshBuildTime() const
{
  return this->Internals->Adapter.GetBuildTime();
}

//------------------------------------------------------------------------------
int vtkGeodesicDistanceAlgorithm::FillInputPortInformation(int port, vtkInformation* info)
{
  // Port 0 is needed, but looked for by us: when the pipeline does it, an earlier output stays.
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return port == 0 || port == 1 ? 1 : 0;
}

//------------------------------------------------------------------------------
int vtkGeodesicDistanceAlgorithm::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->SetErrorCode(vtkErrorCode::NoError);
  vtkInformation* outInfo = outputVector->GetInformationObject(0);
  vtkPolyData* output = vtkPolyData::GetData(outInfo);

  // Nothing may be thrown across VTK: an exception that reaches Python ends the interpreter.
  dgg::Status status;
  unsigned long errorCode = vtkErrorCode::UserError;
  try
  {
    status = this->Execute(
      vtkPolyData::GetData(inputVector[0]), vtkPolyData::GetData(inputVector[1]), outInfo, output);
  }
  catch (const std::bad_alloc&)
  {
    status = dgg::Status::Invalid("memory is exhausted: use a smaller mesh or MaximumDistance");
    errorCode = vtkErrorCode::UnknownError;
  }
  catch (const std::exception& exception)
  {
    status = dgg::Status::Invalid(std::string("unexpected failure: ") + exception.what());
    errorCode = vtkErrorCode::UnknownError;
  }
  catch (...)
  {
    status = dgg::Status::Invalid("unexpected failure");
    errorCode = vtkErrorCode::UnknownError;
  }
  if (status.IsOk())
  {
    return 1;
  }

  output->Initialize();
  // An empty output does not count as up to date: the next update tries again.
  outInfo->Set(vtkDemandDrivenPipeline::DATA_NOT_GENERATED(), 1);
  if (!status.IsAborted())
  {
    this->SetErrorCode(errorCode);
    vtkErrorMacro(<< status.GetMessage());
  }
  return 1; // so that filters downstream run and become empty as well
}

//------------------------------------------------------------------------------
dgg::Status vtkGeodesicDistanceAlgorithm::Execute(
  vtkPolyData* input, vtkPolyData* sourcePoints, vtkInformation* outInfo, vtkPolyData* output)
{
  dgg::Status status = this->CheckProperties(outInfo);
  if (!status.IsOk())
  {
    return status;
  }
  if (!input)
  {
    return dgg::Status::Invalid(
      "there is no input: call SetInputConnection() or SetInputData() with a surface");
  }
  if (input->GetNumberOfPoints() == 0 && input->GetNumberOfCells() == 0)
  {
    vtkWarningMacro("The input is empty: it has neither points nor cells. So is the output.");
    this->Internals->Collector.Forget();
    this->Internals->Adapter.Clear();
    output->ShallowCopy(input);
    vtkNew<vtkDoubleArray> distances;
    vtkNew<vtkIntArray> sources;
    this->AddArrays(output, distances, sources);
    return dgg::Status::Success();
  }
  status = vtkDGGSourceCollector::Check(
    this->SourceIds, sourcePoints, this->InitialDistanceArrayName, input->GetNumberOfPoints());
  if (!status.IsOk())
  {
    return status;
  }
  status = this->PrepareMesh(input);
  if (!status.IsOk())
  {
    return status;
  }
  const vtkDGGMeshAdapter& adapter = this->Internals->Adapter;
  std::vector<dgg::GeodesicSource> sources;
  status = this->Internals->Collector.Collect(this->SourceIds, sourcePoints,
    this->InitialDistanceArrayName, this->ProjectionTolerance, adapter, input->GetPoints(),
    sources);
  if (!status.IsOk())
  {
    return status;
  }
  this->WarnAboutIsolatedSources();

  double reached = PreparationShare;
  auto progress = [this, &reached](double fraction) {
    reached = std::max(reached,
      PreparationShare + (1.0 - PreparationShare) * std::min(1.0, std::max(0.0, fraction)));
    this->UpdateProgress(reached);
    return !vtkDGGIsAbortedMacro(this);
  };
  if (!progress(0.0))
  {
    return dgg::Status::Abort();
  }
  const double limit =
    this->MaximumDistance < VTK_DOUBLE_MAX ? this->MaximumDistance : dgg::Infinity;
  vtkDGGDistanceTask task{ adapter.GetMesh(), sources, input, limit, this->GenerateNearestSource,
    progress, {}, {} };
  status = this->ComputeDistances(task);
  if (!status.IsOk())
  {
    return status;
  }
  const auto n = static_cast<std::size_t>(adapter.GetMesh().GetNumberOfVertices());
  if (task.Distances.size() != n || (task.WantNearestSource && task.NearestSource.size() != n))
  {
    return dgg::Status::Invalid("the results do not match the mesh: report this as a bug");
  }
  output->ShallowCopy(input);
  this->AddResults(input, task, output);
  return status;
}

//------------------------------------------------------------------------------
dgg::Status vtkGeodesicDistanceAlgorithm::CheckProperties(vtkInformation* outInfo) const
{
  const int pieces = outInfo->Has(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES())
    ? outInfo->Get(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES())
    : 1;
  if (pieces > 1)
  {
    std::ostringstream message;
    message << "one of " << pieces << " pieces was asked for, but distances need the whole "
            << "surface: gather it on one process and update this filter there, with one piece";
    return dgg::Status::Invalid(message.str());
  }
  if (!IsLength(this->MaximumDistance))
  {
    return InvalidLength("MaximumDistance", this->MaximumDistance);
  }
  if (!IsLength(this->ProjectionTolerance))
  {
    return InvalidLength("ProjectionTolerance", this->ProjectionTolerance);
  }
  if (this->DistanceArrayName.empty())
  {
    return dgg::Status::Invalid("the distances have no name: call SetDistanceArrayName()");
  }
  if (this->GenerateNearestSource && this->SourceArrayName.empty())
  {
    return dgg::Status::Invalid("the nearest sources have no name: call SetSourceArrayName()");
  }
  if (this->GenerateNearestSource && this->SourceArrayName == this->DistanceArrayName)
  {
    return dgg::Status::Invalid("distances and nearest sources are both to be named '" +
      this->SourceArrayName + "': call SetSourceArrayName() with another name");
  }
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
dgg::Status vtkGeodesicDistanceAlgorithm::PrepareMesh(vtkPolyData* input)
{
  vtkDGGMeshAdapter& adapter = this->Internals->Adapter;
  if (adapter.IsUpToDate(input, this->MergeCoincidentPoints))
  {
    return dgg::Status::Success();
  }
  this->Internals->Collector.Forget();
  const dgg::Status status = adapter.Update(input, this->MergeCoincidentPoints);
  for (const std::string& warning : adapter.GetWarnings())
  {
    vtkWarningMacro(<< warning << ".");
  }
  return status;
}

//------------------------------------------------------------------------------
void vtkGeodesicDistanceAlgorithm::WarnAboutIsolatedSources() const
{
  const vtkDGGMeshAdapter& adapter = this->Internals->Adapter;
  vtkIdType count = 0;
  vtkIdType example = 0;
  for (const vtkIdType id : this->SourceIds)
  {
    if (adapter.GetMesh().Kind(adapter.GetVertex(id)) == dgg::VertexKind::Isolated)
    {
      example = count == 0 ? id : example;
      ++count;
    }
  }
  if (count > 0)
  {
    vtkWarningMacro(<< count << " of the source ids, the first of them " << example
                    << ", are points that no polygon uses. They reach no other point.");
  }
}

//------------------------------------------------------------------------------
void vtkGeodesicDistanceAlgorithm::AddResults(
  vtkPolyData* input, const vtkDGGDistanceTask& task, vtkPolyData* output)
{
  const vtkDGGMeshAdapter& adapter = this->Internals->Adapter;
  const vtkIdType n = input->GetNumberOfPoints();
  vtkNew<vtkDoubleArray> distances;
  vtkNew<vtkIntArray> sources;
  distances->SetNumberOfValues(n);
  sources->SetNumberOfValues(this->GenerateNearestSource ? n : 0);
  for (vtkIdType i = 0; i < n; ++i)
  {
    const dgg::Id vertex = adapter.GetVertex(i);
    const double distance = task.Distances[vertex];
    const bool reached = distance <= task.MaximumDistance && distance < dgg::Infinity;
    distances->SetValue(i, reached ? distance : this->UnreachedValue);
    if (this->GenerateNearestSource)
    {
      sources->SetValue(i, reached ? task.NearestSource[vertex] : -1);
    }
  }
  this->AddArrays(output, distances, sources);
}

//------------------------------------------------------------------------------
void vtkGeodesicDistanceAlgorithm::AddArrays(
  vtkPolyData* output, vtkDataArray* distances, vtkDataArray* sources)
{
  vtkPointData* data = output->GetPointData();
  distances->SetName(this->DistanceArrayName.c_str());
  data->AddArray(distances);
  // Not SetScalars(), which would remove the scalars of the input.
  data->SetActiveScalars(this->DistanceArrayName.c_str());
  if (this->GenerateNearestSource)
  {
    sources->SetName(this->SourceArrayName.c_str());
    data->AddArray(sources);
  }
}
