// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DGGFilterInternals.h"

#include "DGGCompatibility.h"
#include "DGGMeshAdapter.h"
#include "DGGOutput.h"
#include "DGGPartedUpdate.h"
#include "DGGProperties.h"
#include "DGGSurfaceArrays.h"
#include "DGGThreads.h"
#include "vtkGeodesicAlgorithm.h"

#include "dggDistanceOutput.h"
#include "dggFreeMemory.h"
#include "dggMatrixRows.h"
#include "dggProcessGroup.h"
#include "dggPropertyChecks.h"
#include "dggStatus.h"

#include "vtkAlgorithmOutput.h"
#include "vtkCompositeDataSet.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkErrorCode.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <exception>
#include <new>
#include <vector>

namespace
{
/// Progress weight of the preparation of the mesh.
constexpr double PreparationShare = 0.1;

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

/// Returns an error if the other pieces are not available: each process must have exactly one
/// piece.
dgg::Status CheckPieces(int piece, int pieces, vtkMultiProcessController* controller)
{
  if (pieces <= 1 ||
    (controller && pieces == controller->GetNumberOfProcesses() &&
      piece == controller->GetLocalProcessId()))
  {
    return dgg::Status::Success();
  }
  return dgg::InvalidInput(
    "One of ", pieces, " pieces is requested, but distances need the whole surface")
    .Fix("Set {Controller} to a controller with one process per piece, or gather the surface in "
         "one process");
}

/// Adds empty field data to inputs without field data, which VTK permits.
void AddFieldData(vtkAlgorithm* filter)
{
  for (int port = 0; port < filter->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < filter->GetNumberOfInputConnections(port); ++i)
    {
      vtkDataObject* input = filter->GetInputDataObject(port, i);
      if (input && !input->GetFieldData())
      {
        input->SetFieldData(vtkNew<vtkFieldData>());
      }
    }
  }
}

/// Empties the outputs. Outputs that are marked as not generated are computed again in the next
/// update, others when something has been modified.
void Empty(vtkInformationVector* outputVector, bool isAgain)
{
  for (int port = 0; port < outputVector->GetNumberOfInformationObjects(); ++port)
  {
    vtkInformation* outInfo = outputVector->GetInformationObject(port);
    vtkDataObject::GetData(outInfo)->Initialize();
    if (isAgain)
    {
      outInfo->Set(vtkDemandDrivenPipeline::DATA_NOT_GENERATED(), 1);
    }
  }
}

/// Gives the points of an empty piece the data type of the first other piece, because new points on
/// this process have that of its piece.
dgg::Status SharePointType(dgg::ProcessGroup& group, vtkSmartPointer<vtkPolyData>& piece)
{
  const bool isEmpty = piece->GetNumberOfPoints() == 0;
  std::vector<int> types;
  DGG_RETURN_IF_ERROR(group.Share(isEmpty ? VTK_VOID : piece->GetPoints()->GetDataType(), types));
  const auto type =
    std::find_if(types.begin(), types.end(), [](int other) { return other != VTK_VOID; });
  if (isEmpty && type != types.end())
  {
    vtkNew<vtkPoints> points;
    points->SetDataType(*type);
    const auto typed = vtkSmartPointer<vtkPolyData>::New();
    typed->ShallowCopy(piece);
    typed->SetPoints(points);
    piece = typed;
  }
  return dgg::Status::Success();
}
}

//------------------------------------------------------------------------------
DGGFilterInternals::DGGFilterInternals(vtkGeodesicAlgorithm* filter)
  : Filter(filter)
  , Reached(0.0)
  , IsStopped(false)
  , GapsBuildTime(0)
  , QualityTime(0)
  , Mesh(new DGGMeshAdapter)
  , Parts(new DGGPartedUpdate)
{
}

//------------------------------------------------------------------------------
DGGFilterInternals::~DGGFilterInternals() = default;

//------------------------------------------------------------------------------
void DGGFilterInternals::Update(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const dgg::Status status = this->Attempt([&] {
    this->ForgetResults();
    AddFieldData(this->Filter);
    return this->Follow(request, inputVector, outputVector);
  });
  if (!status.IsOk())
  {
    // A process without a change would not run, and other processes would wait for it.
    const bool hasPieces = GetAsked(request, outputVector,
                             vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES(), 1) > 1;
    Empty(outputVector, status.IsAborted() || hasPieces);
  }
}

//------------------------------------------------------------------------------
dgg::Status DGGFilterInternals::Attempt(const std::function<dgg::Status()>& step)
{
  // ErrorCode is set directly, because SetErrorCode() would modify the filter.
  this->Filter->ErrorCode = vtkErrorCode::NoError;
  this->Filter->SetAbortExecute(0); // only VTK 9.1 resets the flag at the start of an update
  this->Reached = 0.0;
  this->IsStopped = false;
  this->Caller = std::this_thread::get_id();
  const dgg::Status status = this->Try(step);
  if (!status.IsOk() && !status.IsAborted())
  {
    if (this->Filter->ErrorCode == vtkErrorCode::NoError)
    {
      this->Filter->ErrorCode = vtkErrorCode::UserError;
    }
    vtkErrorWithObjectMacro(this->Filter, << DGGRender(status.GetMessage()));
  }
  return status;
}

//------------------------------------------------------------------------------
/// Runs a step and converts exceptions to errors. VTK must not see them: an exception that reaches
/// Python ends the interpreter.
dgg::Status DGGFilterInternals::Try(const std::function<dgg::Status()>& step)
{
  try
  {
    return step();
  }
  catch (const std::bad_alloc&)
  {
    this->Filter->ErrorCode = vtkErrorCode::UnknownError;
    return dgg::Status(dgg::Status::Code::OutOfMemory, "Memory is exhausted")
      .Fix(this->GetMemoryRemedy());
  }
  catch (const std::exception& exception)
  {
    this->Filter->ErrorCode = vtkErrorCode::UnknownError;
    return dgg::InvalidInput("Unexpected failure: ", exception.what()).Fix("Report this as a bug");
  }
  catch (...)
  {
    this->Filter->ErrorCode = vtkErrorCode::UnknownError;
    return dgg::InvalidInput("Unexpected failure").Fix("Report this as a bug");
  }
}

//------------------------------------------------------------------------------
bool DGGFilterInternals::AttemptOutsideOfUpdate(const std::function<dgg::Status()>& step)
{
  const unsigned long errorCode = this->Filter->GetErrorCode();
  vtkDGGClearAbortMacro(this->Filter);
  const bool done = this
                      ->Attempt([this, &step] {
                        if (this->Filter->GetNumberOfInputConnections(0) > 0)
                        {
                          this->Filter->GetInputAlgorithm()->Update(
                            this->Filter->GetInputConnection(0, 0)->GetIndex());
                        }
                        return step();
                      })
                      .IsOk();
  if (this->Filter->ErrorCode == vtkErrorCode::NoError)
  {
    this->Filter->ErrorCode = errorCode; // restores the code of the last update
  }
  return done;
}

//------------------------------------------------------------------------------
dgg::Status DGGFilterInternals::Follow(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  const int pieces = GetAsked(request, outputVector, Pipeline::UPDATE_NUMBER_OF_PIECES(), 1);
  const int piece = GetAsked(request, outputVector, Pipeline::UPDATE_PIECE_NUMBER(), 0);
  DGG_RETURN_IF_ERROR(CheckPieces(piece, pieces, this->Filter->Controller));
  const int ports = this->Filter->GetNumberOfInputPorts();
  if (pieces == 1 && DGGPartedUpdate::IsPlain(inputVector, ports))
  {
    *this->Parts = DGGPartedUpdate();
    return this->Compute(inputVector, outputVector);
  }
  const DGGProcesses processes(pieces > 1 ? this->Filter->Controller : nullptr);
  bool isDone = false;
  DGG_RETURN_IF_ERROR(this->ComputePiece(processes, inputVector, outputVector, isDone));
  if (isDone)
  {
    *this->Parts = DGGPartedUpdate();
    this->Mesh->Clear(); // the report must not describe another surface
    this->Warn(this->OutputWarnings);
    return dgg::Status::Success();
  }
  dgg::ProcessGroup group;
  const bool isGroup = processes.FindGroup(true, group);
  const auto compute = [&](vtkInformationVector** inputs, vtkInformationVector* outputs) {
    return this->Try([&] {
      if (!inputs)
      {
        DGGContext context = this->MakeContext(nullptr);
        context.Group = &group;
        return isGroup ? dgg::HelpFirstProcess(context) : dgg::Status::Success();
      }
      DGG_RETURN_IF_ERROR(this->Compute(inputs, outputs, isGroup ? &group : nullptr));
      return isGroup ? dgg::DismissHelpers(group) : dgg::Status::Success();
    });
  };
  const dgg::Status status =
    this->Parts->Run(processes, group, pieces > 1 ? this->Filter->GatherLimit : VTK_ID_MAX,
      this->Filter->MemoryLimit, inputVector, ports, outputVector, this->PassesSurface(), compute);
  if (status.IsOk() && this->Parts->GetNumberOfOthers() > 0)
  {
    this->Warn(dgg::JoinText(this->Parts->GetNumberOfOthers(),
      " blocks of the input are not vtkPolyData and are ignored. Extract their "
      "surfaces first"));
  }
  return status;
}

//------------------------------------------------------------------------------
/// Computes on the piece of this process together with the other processes. `isDone` becomes false
/// if the pieces must be gathered.
dgg::Status DGGFilterInternals::ComputePiece(const DGGProcesses& processes,
  vtkInformationVector** inputVector, vtkInformationVector* outputVector, bool& isDone)
{
  dgg::ProcessGroup group;
  vtkSmartPointer<vtkPolyData> part = vtkPolyData::GetData(inputVector[0]);
  const bool canJoin = this->CanDistribute() && !this->Filter->MergeCoincidentPoints && part;
  isDone = processes.FindGroup(canJoin, group);
  if (!isDone)
  {
    return dgg::Status::Success();
  }
  return group.Agree(this->Try([&] {
    DGG_RETURN_IF_ERROR(this->CheckAllProperties());
    DGG_RETURN_IF_ERROR(DGGRemoveGhosts(part));
    DGG_RETURN_IF_ERROR(SharePointType(group, part));
    this->OutputWarnings.clear();
    static const dgg::PreparedSurface none; // of the entire surface
    const DGGContext update = this->MakeContext(part);
    const DGGContext context{ { none, update.Memory, update.NumberOfThreads, update.Progress,
                                update.Parallel, update.GetCells },
      part };
    group.MemoryLimit = update.Memory.GetBytes();
    DGGSurfaceArrays copies(part, true, false);
    const dgg::SurfacePiece piece = DGGConvertPart({ part, 0 }, copies);
    return this->ExecutePiece(
      context, { processes, group, piece, inputVector, outputVector }, isDone);
  }));
}

//------------------------------------------------------------------------------
dgg::Status DGGFilterInternals::ExecutePiece(
  const DGGContext& vtkNotUsed(context), const DGGPieceUpdate& vtkNotUsed(update), bool& isDone)
{
  isDone = false;
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
dgg::Status DGGFilterInternals::CheckAllProperties() const
{
  DGG_RETURN_IF_ERROR(dgg::CheckLengths({ { "MergeTolerance", this->Filter->MergeTolerance },
    { "MemoryLimit", static_cast<double>(this->Filter->MemoryLimit) } }));
  return this->CheckProperties();
}

//------------------------------------------------------------------------------
dgg::Status DGGFilterInternals::Compute(
  vtkInformationVector** inputVector, vtkInformationVector* outputVector, dgg::ProcessGroup* group)
{
  this->OutputWarnings.clear();
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  if (input && input->GetNumberOfPoints() > 0 && !this->IsCloud(input))
  {
    // This check comes first, because the remedies of other checks would not help.
    const dgg::Status status = DGGMeshAdapter::CheckSurface(input);
    if (!status.IsOk())
    {
      this->Mesh->Clear(); // the report must not describe another surface
      return status;
    }
  }
  DGG_RETURN_IF_ERROR(this->CheckAllProperties());
  if (input && input->GetNumberOfPoints() == 0 && input->GetNumberOfCells() == 0)
  {
    this->WarnAboutEmptyInput("neither points nor cells");
    this->Mesh->Clear();
    this->MakeEmptyOutput(this->MakeContext(input), outputVector);
    this->Warn(this->OutputWarnings);
    return dgg::Status::Success();
  }
  DGG_RETURN_IF_ERROR(this->PrepareMesh(input));
  if (!this->Advance(0.0))
  {
    return dgg::Status::Abort();
  }
  DGGContext context = this->MakeContext(input);
  context.Group = group;
  this->Parts->AddGraph(context);
  DGG_RETURN_IF_ERROR(this->Execute(context, inputVector, outputVector));
  this->Warn(this->OutputWarnings);
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
void DGGFilterInternals::Warn(const std::string& text) const
{
  if (!text.empty())
  {
    vtkWarningWithObjectMacro(this->Filter, << DGGRender(text) << ".");
  }
}

//------------------------------------------------------------------------------
void DGGFilterInternals::Warn(const std::vector<std::string>& texts) const
{
  for (const std::string& text : texts)
  {
    this->Warn(text);
  }
}

//------------------------------------------------------------------------------
void DGGFilterInternals::WarnAboutEmptyInput(const char* lack)
{
  this->Warn(dgg::JoinText("The input is empty: it has ", lack, ". The output is empty, too"));
}

//------------------------------------------------------------------------------
void DGGFilterInternals::MakeEmptyOutput(
  const DGGContext& vtkNotUsed(context), vtkInformationVector* outputVector)
{
  Empty(outputVector, false);
}

//------------------------------------------------------------------------------
dgg::Status DGGFilterInternals::GetWholeInput(vtkSmartPointer<vtkPolyData>& surface)
{
  vtkDataObject* input = this->Filter->GetInputDataObject(0, 0);
  surface = vtkPolyData::SafeDownCast(input);
  return vtkCompositeDataSet::SafeDownCast(input) ? DGGPartedUpdate::Join(input, surface)
                                                  : dgg::Status::Success();
}

//------------------------------------------------------------------------------
DGGContext DGGFilterInternals::MakeContext(vtkPolyData* surface)
{
  const dgg::ProgressCallback progress = [this](double done) { return this->Advance(done); };
  return { { this->Mesh->Get(), dgg::MakeBudget(this->Filter->MemoryLimit),
             vtkSMPTools::GetEstimatedNumberOfThreads(), progress, DGGMakeParallelFor(progress),
             DGGConvertCells(surface) },
    surface };
}

//------------------------------------------------------------------------------
dgg::Domain DGGFilterInternals::GetDomain(vtkPolyData* surface) const
{
  if (this->IsCloud(surface))
  {
    return { dgg::Domain::Cloud, 0.0 };
  }
  return this->Filter->MergeCoincidentPoints
    ? dgg::Domain{ dgg::Domain::MergedSurface, this->Filter->MergeTolerance }
    : dgg::Domain{ dgg::Domain::Surface, 0.0 };
}

//------------------------------------------------------------------------------
void DGGFilterInternals::WarnAboutGaps(const std::vector<bool>& isReached)
{
  if (this->GapsBuildTime == this->Mesh->GetBuildTime() || dgg::AreMostReached(isReached))
  {
    return;
  }
  this->GapsBuildTime = this->Mesh->GetBuildTime();
  this->Warn(this->Mesh->Get().DescribeGaps(isReached));
}

//------------------------------------------------------------------------------
void DGGFilterInternals::WarnAtEnd(const dgg::Output& output)
{
  this->OutputWarnings.insert(
    this->OutputWarnings.end(), output.Warnings.begin(), output.Warnings.end());
}

//------------------------------------------------------------------------------
dgg::Status DGGFilterInternals::FillOutput(
  const DGGContext& context, dgg::Output& output, vtkInformationVector* outputVector, int port)
{
  DGG_RETURN_IF_ERROR(DGGFillOutput(output, context.Input, this->Filter->OutputPointsPrecision,
    vtkPolyData::GetData(outputVector, port)));
  this->WarnAtEnd(output);
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
bool DGGFilterInternals::WarnAboutQuality(const std::string& reason)
{
  if (this->QualityTime != this->Mesh->GetBuildTime())
  {
    this->QualityTime = this->Mesh->GetBuildTime();
    this->QualityReasons.clear();
  }
  if (!reason.empty() && this->QualityReasons.insert(reason).second)
  {
    this->Warn(reason);
  }
  return !reason.empty();
}

//------------------------------------------------------------------------------
dgg::Status DGGFilterInternals::PrepareMesh(vtkPolyData* surface)
{
  if (!surface)
  {
    this->Mesh->Clear(); // the report must not describe another surface
    return dgg::InvalidInput("There is no input").Fix("Connect input port 0");
  }
  const vtkMTimeType built = this->Mesh->GetBuildTime();
  const dgg::Status status = this->Mesh->Update(surface, this->GetDomain(surface));
  if (built != this->Mesh->GetBuildTime())
  {
    this->Warn(this->Mesh->Get().GetWarnings());
  }
  return status;
}

//------------------------------------------------------------------------------
bool DGGFilterInternals::Advance(double fraction)
{
  const double now =
    PreparationShare + (1.0 - PreparationShare) * std::min(1.0, std::max(0.0, fraction));
  double before = this->Reached;
  while (before < now && !this->Reached.compare_exchange_weak(before, now))
  {
  }
  if (std::this_thread::get_id() == this->Caller)
  {
    this->Filter->UpdateProgress(this->Reached);
    this->IsStopped = vtkDGGIsAbortedMacro(this->Filter);
  }
  return !this->IsStopped;
}
