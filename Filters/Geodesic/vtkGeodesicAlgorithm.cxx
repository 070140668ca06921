// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGeodesicAlgorithm.h"

#include "DGGCompatibility.h"
#include "DGGContext.h"
#include "DGGFreeMemory.h"
#include "DGGMeshAdapter.h"
#include "DGGPartedUpdate.h"
#include "DGGProperties.h"
#include "DGGThreads.h"

#include "dggInvalidInput.h"

#include "vtkAlgorithmOutput.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObjectTypes.h"
#include "vtkDataSet.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkErrorCode.h"
#include "vtkExecutive.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cstring>
#include <exception>
#include <new>
#include <sstream>

namespace
{
/// Progress weight of the preparation of the mesh.
constexpr double PreparationShare = 0.1;

void WriteReport(std::ostream& os, const dgg::PreparedSurface& mesh)
{
  const dgg::MeshReport& report = mesh.GetReport();
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
  os << "dropped faces: " << mesh.GetNumberOfDroppedCells() << "\n";
  os << "degenerate faces: " << report.DegenerateFaces << "\n";
  os << "duplicate faces: " << report.DuplicateFaces << "\n";
  os << "isolated points: " << mesh.GetNumberOfIsolatedPoints() << "\n";
  os << "coincident points: " << report.CoincidentPoints << "\n";
  os << "merged points: " << mesh.GetNumberOfMergedPoints() << "\n";
  os << "length added to degenerate faces: " << report.Mollification << "\n";
  os << "height of degenerate faces left out: " << mesh.GetLargestCapHeight() << "\n";
  os << "anisotropy: mean " << report.MeanAnisotropy << ", median " << report.MedianAnisotropy
     << "\n";
}

/// Returns the value of the key on the output port that the request names, for which the input was
/// updated. Values of earlier requests of other ports are ignored.
int GetAsked(vtkInformation* request, vtkInformationVector* outputVector,
  vtkInformationIntegerKey* key, int otherwise)
{
  const int ports = outputVector->GetNumberOfInformationObjects();
  const int asked = request && request->Has(vtkExecutive::FROM_OUTPUT_PORT())
    ? request->Get(vtkExecutive::FROM_OUTPUT_PORT())
    : -1;
  int value = otherwise;
  for (int port = 0; port < ports; ++port)
  {
    vtkInformation* outInfo = outputVector->GetInformationObject(port);
    if ((port == asked || asked < 0 || asked >= ports) && outInfo->Has(key))
    {
      value = std::max(value, outInfo->Get(key));
    }
  }
  return value;
}

/// Other data sets are accepted up to here to report an error with a remedy.
dgg::Status CheckType(vtkDataObject* input)
{
  if (!vtkDataSet::SafeDownCast(input) || vtkPolyData::SafeDownCast(input))
  {
    return dgg::Status::Success();
  }
  return dgg::InvalidInput("the input is a ", input->GetClassName(),
    ", but a vtkPolyData is required: extract the surface with vtkDataSetSurfaceFilter");
}

/// Returns an error if the other pieces are not available: each process must have one piece.
dgg::Status CheckPieces(int piece, int pieces, vtkMultiProcessController* controller)
{
  if (pieces <= 1 ||
    (controller && pieces == controller->GetNumberOfProcesses() &&
      piece == controller->GetLocalProcessId()))
  {
    return dgg::Status::Success();
  }
  return dgg::InvalidInput("one of ", pieces,
    " pieces is requested, but distances need the whole surface: call SetController() with a "
    "controller of as many processes, each of which updates its piece, or gather the surface on "
    "one process and update this filter there, with one piece");
}

/// Empties the outputs and marks them as not generated, so that the next update executes again.
void Empty(vtkInformationVector* outputVector)
{
  for (int port = 0; port < outputVector->GetNumberOfInformationObjects(); ++port)
  {
    vtkInformation* outInfo = outputVector->GetInformationObject(port);
    vtkDataObject::GetData(outInfo)->Initialize();
    outInfo->Set(vtkDemandDrivenPipeline::DATA_NOT_GENERATED(), 1);
  }
}
}

//------------------------------------------------------------------------------
vtkGeodesicAlgorithm::vtkGeodesicAlgorithm()
  : MemoryLimit(0)
  , MergeCoincidentPoints(false)
  , MergeTolerance(0.0)
  , OutputPointsPrecision(DOUBLE_PRECISION)
  , Controller(nullptr)
  , GatherLimit(100000000)
  , Reached(0.0)
  , IsStopped(false)
  , ReportTime(0)
  , GapsBuildTime(0)
  , QualityTime(0)
  , Adapter(new DGGMeshAdapter)
  , Parts(new DGGPartedUpdate)
{
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

//------------------------------------------------------------------------------
vtkGeodesicAlgorithm::~vtkGeodesicAlgorithm()
{
  this->SetController(nullptr);
}

//------------------------------------------------------------------------------
vtkCxxSetObjectMacro(vtkGeodesicAlgorithm, Controller, vtkMultiProcessController);

//------------------------------------------------------------------------------
void vtkGeodesicAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MergeCoincidentPoints: " << (this->MergeCoincidentPoints ? "On" : "Off") << "\n";
  os << indent << "MergeTolerance: " << this->MergeTolerance << "\n";
  os << indent << "OutputPointsPrecision: " << this->OutputPointsPrecision << "\n";
  os << indent << "Controller: " << this->Controller << "\n";
  os << indent << "GatherLimit: " << this->GatherLimit << "\n";
  os << indent << "MemoryLimit: " << this->MemoryLimit << "\n";
  os << indent << "MeshBuildTime: " << this->GetMeshBuildTime() << "\n";
  os << indent << "MeshReport:\n";
  std::istringstream report(this->GetMeshReport());
  for (std::string line; std::getline(report, line);)
  {
    os << indent.GetNextIndent() << line << "\n";
  }
}

//------------------------------------------------------------------------------
std::string vtkGeodesicAlgorithm::GetMeshReport() const
{
  if (this->GetNumberOfTriangles() == 0)
  {
    return "no surface\n";
  }
  std::ostringstream os;
  WriteReport(os, this->Adapter->Get());
  return os.str();
}

//------------------------------------------------------------------------------
#define vtkDGGReportMacro(Type, Name, Value)   \
  Type vtkGeodesicAlgorithm::Get##Name() const \
  {                                            \
    return this->Adapter->Get().Value;         \
  }
vtkDGGReportMacro(vtkIdType, NumberOfTriangles, GetMeshWithoutAngles().GetNumberOfFaces());
vtkDGGReportMacro(vtkIdType, NumberOfIsolatedPoints, GetNumberOfIsolatedPoints());
vtkDGGReportMacro(vtkIdType, NumberOfComponents, GetReport().Components);
vtkDGGReportMacro(vtkIdType, NumberOfBoundaryEdges, GetReport().BoundaryEdges);
vtkDGGReportMacro(vtkIdType, NumberOfBoundaryLoops, GetReport().BoundaryLoops);
vtkDGGReportMacro(vtkIdType, NumberOfNonManifoldEdges, GetReport().NonManifoldEdges);
vtkDGGReportMacro(vtkIdType, NumberOfNonManifoldVertices, GetReport().NonManifoldVertices);
vtkDGGReportMacro(vtkIdType, NumberOfDroppedFaces, GetNumberOfDroppedCells());
vtkDGGReportMacro(vtkIdType, NumberOfDegenerateFaces, GetReport().DegenerateFaces);
vtkDGGReportMacro(vtkIdType, NumberOfDuplicateFaces, GetReport().DuplicateFaces);
vtkDGGReportMacro(vtkIdType, NumberOfCoincidentPoints, GetReport().CoincidentPoints);
vtkDGGReportMacro(
  vtkIdType, NumberOfCoincidentBoundaryPoints, GetNumberOfCoincidentBoundaryPoints());
vtkDGGReportMacro(bool, Orientable, GetReport().Orientable);
vtkDGGReportMacro(vtkIdType, Genus, GetReport().Genus);
vtkDGGReportMacro(double, MeanAnisotropy, GetAnisotropy().Mean);
vtkDGGReportMacro(double, MedianAnisotropy, GetAnisotropy().Median);
vtkDGGReportMacro(double, Mollification, GetReport().Mollification);
vtkDGGReportMacro(double, LargestCapHeight, GetLargestCapHeight());
#undef vtkDGGReportMacro

//------------------------------------------------------------------------------
vtkMTimeType vtkGeodesicAlgorithm::GetMeshBuildTime() const
{
  return this->Adapter->GetBuildTime();
}

//------------------------------------------------------------------------------
int vtkGeodesicAlgorithm::FillInputPortInformation(int port, vtkInformation* info)
{
  // Port 0 is required but checked here: the check of the pipeline would keep an earlier output.
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObjectTree");
  if (port == 0)
  {
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet"); // see CheckType()
  }
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return port >= 0 && port < this->GetNumberOfInputPorts() ? 1 : 0;
}

//------------------------------------------------------------------------------
int vtkGeodesicAlgorithm::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(),
    port == 0 && this->PassesSurface() ? "vtkDataObject" : "vtkPolyData");
  return 1;
}

//------------------------------------------------------------------------------
vtkTypeBool vtkGeodesicAlgorithm::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_OBJECT()) && this->PassesSurface())
  {
    this->MakeSurfaceOutput(
      vtkDataObject::GetData(inputVector[0]), outputVector->GetInformationObject(0));
  }
  return this->Superclass::ProcessRequest(request, inputVector, outputVector);
}

//------------------------------------------------------------------------------
/// Makes an output of the type of a composite input, otherwise a vtkPolyData.
void vtkGeodesicAlgorithm::MakeSurfaceOutput(vtkDataObject* input, vtkInformation* outInfo) const
{
  const char* type =
    vtkCompositeDataSet::SafeDownCast(input) ? input->GetClassName() : "vtkPolyData";
  vtkDataObject* output = vtkDataObject::GetData(outInfo);
  if (!output || std::strcmp(output->GetClassName(), type) != 0)
  {
    outInfo->Set(vtkDataObject::DATA_OBJECT(),
      vtkSmartPointer<vtkDataObject>::Take(vtkDataObjectTypes::NewDataObject(type)));
  }
}

//------------------------------------------------------------------------------
int vtkGeodesicAlgorithm::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  if (!this->Attempt([&] { return this->Follow(request, inputVector, outputVector); }))
  {
    Empty(outputVector);
  }
  return 1; // so that filters downstream run and become empty as well
}

//------------------------------------------------------------------------------
bool vtkGeodesicAlgorithm::Attempt(const std::function<dgg::Status()>& step)
{
  // Not by SetErrorCode(): a failure does not modify the filter.
  this->ErrorCode = vtkErrorCode::NoError;
  this->SetAbortExecute(0); // VTK 9.1 does so at the start of an update, later ones do not
  this->Reached = 0.0;
  this->IsStopped = false;
  this->Caller = std::this_thread::get_id();
  unsigned long errorCode = vtkErrorCode::UserError;
  const dgg::Status status = this->Try(step, errorCode);
  this->IsStopped = status.IsAborted();
  if (status.IsOk() || status.IsAborted() || FollowsFailure(this))
  {
    this->Reported.clear();
    return status.IsOk();
  }
  this->ErrorCode = errorCode;
  if (this->IsNewError(status.GetMessage()))
  {
    vtkErrorMacro(<< status.GetMessage());
  }
  return false;
}

//------------------------------------------------------------------------------
/// Returns true if the error differs from that of the previous update, or the pipeline has changed
/// since. There is an update for each output, and ParaView updates all of them many times.
bool vtkGeodesicAlgorithm::IsNewError(const std::string& error)
{
  auto* pipeline = vtkDemandDrivenPipeline::SafeDownCast(this->GetExecutive());
  const vtkMTimeType time = pipeline->GetPipelineMTime();
  const bool isNews = error != this->Reported || time != this->ReportTime;
  this->Reported = error;
  this->ReportTime = time;
  return isNews;
}

//------------------------------------------------------------------------------
/// Returns true if a filter of this module upstream has failed and reported it, or was aborted. Its
/// output is then empty, and errors that follow from this are not reported.
bool vtkGeodesicAlgorithm::FollowsFailure(vtkAlgorithm* filter)
{
  for (int port = 0; port < filter->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < filter->GetNumberOfInputConnections(port); ++i)
    {
      vtkAlgorithm* input = filter->GetInputAlgorithm(port, i);
      auto* ours = vtkGeodesicAlgorithm::SafeDownCast(input);
      const bool hasFailed =
        ours && (ours->GetErrorCode() != vtkErrorCode::NoError || ours->IsStopped);
      if (hasFailed || FollowsFailure(input))
      {
        return true;
      }
    }
  }
  return false;
}

//------------------------------------------------------------------------------
/// Runs a step without letting exceptions pass VTK: one that reaches Python ends the interpreter.
dgg::Status vtkGeodesicAlgorithm::Try(
  const std::function<dgg::Status()>& step, unsigned long& errorCode) const
{
  try
  {
    return step();
  }
  catch (const std::bad_alloc&)
  {
    errorCode = vtkErrorCode::UnknownError;
    return dgg::Status::Invalid("memory is exhausted: " + this->GetMemoryRemedy());
  }
  catch (const std::exception& exception)
  {
    errorCode = vtkErrorCode::UnknownError;
    return dgg::Status::Invalid(std::string("unexpected failure: ") + exception.what());
  }
  catch (...)
  {
    errorCode = vtkErrorCode::UnknownError;
    return dgg::Status::Invalid("unexpected failure");
  }
}

//------------------------------------------------------------------------------
bool vtkGeodesicAlgorithm::AttemptOutsideOfUpdate(const std::function<dgg::Status()>& step)
{
  const unsigned long errorCode = this->GetErrorCode();
  this->Reported.clear();
  vtkDGGClearAbortMacro(this);
  const bool done = this->Attempt([this, &step] {
    if (this->GetNumberOfInputConnections(0) > 0)
    {
      this->GetInputAlgorithm()->Update(this->GetInputConnection(0, 0)->GetIndex());
    }
    return step();
  });
  this->Reported.clear();
  if (this->ErrorCode == vtkErrorCode::NoError)
  {
    this->ErrorCode = errorCode; // of the last update
  }
  return done;
}

//------------------------------------------------------------------------------
dgg::Status vtkGeodesicAlgorithm::Follow(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  DGG_RETURN_IF_ERROR(CheckType(vtkDataObject::GetData(inputVector[0])));
  const int pieces = GetAsked(request, outputVector, Pipeline::UPDATE_NUMBER_OF_PIECES(), 1);
  const int piece = GetAsked(request, outputVector, Pipeline::UPDATE_PIECE_NUMBER(), 0);
  DGG_RETURN_IF_ERROR(CheckPieces(piece, pieces, this->Controller));
  const int ports = this->GetNumberOfInputPorts();
  if (pieces == 1 && DGGPartedUpdate::IsPlain(inputVector, ports))
  {
    *this->Parts = DGGPartedUpdate();
    return this->Compute(inputVector, outputVector);
  }
  const auto compute = [this](vtkInformationVector** inputs, vtkInformationVector* outputs) {
    unsigned long errorCode = vtkErrorCode::NoError;
    return this->Try([&] { return this->Compute(inputs, outputs); }, errorCode);
  };
  const dgg::Status status = this->Parts->Run(DGGProcesses(pieces > 1 ? this->Controller : nullptr),
    pieces > 1 ? this->GatherLimit : VTK_ID_MAX, this->MemoryLimit, inputVector, ports,
    outputVector, this->PassesSurface(), compute);
  if (status.IsOk() && this->Parts->GetNumberOfOthers() > 0)
  {
    vtkWarningMacro(<< this->Parts->GetNumberOfOthers()
                    << " blocks of the input are not vtkPolyData and are ignored. Extract their "
                       "surfaces first.");
  }
  return status;
}

//------------------------------------------------------------------------------
dgg::Status vtkGeodesicAlgorithm::Compute(
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  if (input && input->GetNumberOfPoints() > 0 && !this->IsCloud(input))
  {
    // First of all checks: other remedies would not help.
    const dgg::Status status = DGGMeshAdapter::CheckSurface(input);
    if (!status.IsOk())
    {
      this->Adapter->Clear(); // so that the report is not that of another surface
      return status;
    }
  }
  DGG_RETURN_IF_ERROR(DGGCheckLengths({ { "MergeTolerance", this->MergeTolerance },
    { "MemoryLimit", static_cast<double>(this->MemoryLimit) } }));
  DGG_RETURN_IF_ERROR(this->CheckProperties());
  if (input && input->GetNumberOfPoints() == 0 && input->GetNumberOfCells() == 0)
  {
    this->WarnAboutEmptyInput("neither points nor cells");
    this->Adapter->Clear();
    this->MakeEmptyOutput(this->MakeContext(input), outputVector);
    return dgg::Status::Success();
  }
  DGG_RETURN_IF_ERROR(input ? this->CheckInputs(input, inputVector) : dgg::Status::Success());
  DGG_RETURN_IF_ERROR(this->PrepareMesh(input));
  return this->Advance(0.0) ? this->Execute(this->MakeContext(input), inputVector, outputVector)
                            : dgg::Status::Abort();
}

//------------------------------------------------------------------------------
void vtkGeodesicAlgorithm::WarnAboutEmptyInput(const char* lack)
{
  if (!FollowsFailure(this))
  {
    vtkWarningMacro("The input is empty: it has " << lack << ". The output is empty, too.");
  }
}

//------------------------------------------------------------------------------
dgg::Status vtkGeodesicAlgorithm::CheckProperties() const
{
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
dgg::Status vtkGeodesicAlgorithm::CheckInputs(
  vtkPolyData* vtkNotUsed(surface), vtkInformationVector** vtkNotUsed(inputVector)) const
{
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
bool vtkGeodesicAlgorithm::PassesSurface() const
{
  return false;
}

//------------------------------------------------------------------------------
dgg::Status vtkGeodesicAlgorithm::GetWholeInput(vtkSmartPointer<vtkPolyData>& surface)
{
  vtkDataObject* input = this->GetInputDataObject(0, 0);
  DGG_RETURN_IF_ERROR(CheckType(input));
  surface = vtkPolyData::SafeDownCast(input);
  return input && !surface ? DGGPartedUpdate::Join(input, surface) : dgg::Status::Success();
}

//------------------------------------------------------------------------------
bool vtkGeodesicAlgorithm::IsCloud(vtkPolyData* vtkNotUsed(input)) const
{
  return false;
}

//------------------------------------------------------------------------------
std::string vtkGeodesicAlgorithm::GetMemoryRemedy() const
{
  return "use a smaller mesh";
}

//------------------------------------------------------------------------------
DGGContext vtkGeodesicAlgorithm::MakeContext(vtkPolyData* surface)
{
  const dgg::ProgressCallback progress = [this](double done) { return this->Advance(done); };
  return { { this->Adapter->Get(), DGGMakeBudget(this->MemoryLimit),
             vtkSMPTools::GetEstimatedNumberOfThreads(), progress, DGGMakeParallelFor(progress) },
    surface };
}

//------------------------------------------------------------------------------
dgg::Domain vtkGeodesicAlgorithm::GetDomain(vtkPolyData* surface) const
{
  if (this->IsCloud(surface))
  {
    return { dgg::Domain::Cloud, 0.0 };
  }
  return this->MergeCoincidentPoints
    ? dgg::Domain{ dgg::Domain::MergedSurface, this->MergeTolerance }
    : dgg::Domain{ dgg::Domain::Surface, 0.0 };
}

//------------------------------------------------------------------------------
void vtkGeodesicAlgorithm::WarnAboutGaps(const std::vector<bool>& isReached)
{
  if (this->GapsBuildTime == this->GetMeshBuildTime() ||
    2 * std::count(isReached.begin(), isReached.end(), true) >
      static_cast<std::ptrdiff_t>(isReached.size()))
  {
    return;
  }
  this->GapsBuildTime = this->GetMeshBuildTime();
  const std::string warning = this->Adapter->Get().DescribeGaps(isReached);
  if (!warning.empty())
  {
    vtkWarningMacro(<< warning << ".");
  }
}

//------------------------------------------------------------------------------
bool vtkGeodesicAlgorithm::WarnAboutQuality(const std::string& reason)
{
  if (this->QualityTime != this->GetMeshBuildTime())
  {
    this->QualityTime = this->GetMeshBuildTime();
    this->QualityReasons.clear();
  }
  if (!reason.empty() && this->QualityReasons.insert(reason).second)
  {
    vtkWarningMacro(<< reason << ".");
  }
  return !reason.empty();
}

//------------------------------------------------------------------------------
dgg::Status vtkGeodesicAlgorithm::PrepareMesh(vtkPolyData* surface)
{
  if (!surface)
  {
    return dgg::Status::Invalid(
      "there is no input: call SetInputConnection() or SetInputData() with a surface");
  }
  const vtkMTimeType built = this->Adapter->GetBuildTime();
  const dgg::Status status = this->Adapter->Update(surface, this->GetDomain(surface));
  if (built != this->Adapter->GetBuildTime())
  {
    for (const std::string& warning : this->Adapter->Get().GetWarnings())
    {
      vtkWarningMacro(<< warning << ".");
    }
  }
  return status;
}

//------------------------------------------------------------------------------
bool vtkGeodesicAlgorithm::Advance(double fraction)
{
  const double now =
    PreparationShare + (1.0 - PreparationShare) * std::min(1.0, std::max(0.0, fraction));
  double before = this->Reached;
  while (before < now && !this->Reached.compare_exchange_weak(before, now))
  {
  }
  if (std::this_thread::get_id() == this->Caller)
  {
    this->UpdateProgress(this->Reached);
    this->IsStopped = vtkDGGIsAbortedMacro(this);
  }
  return !this->IsStopped;
}
