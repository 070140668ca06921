// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGPath.h"

#include "DGGGraphUser.h"
#include "DGGPieceSearches.h"
#include "DGGProperties.h"
#include "DGGSources.h"
#include "DGGSurfaceArrays.h"

#include "dggOutput.h"
#include "dggPathSearch.h"
#include "dggPiecePaths.h"
#include "dggPieceSurface.h"
#include "dggPreparedSurface.h"
#include "dggProcessGroup.h"
#include "dggPropertyChecks.h"
#include "dggSourceCollection.h"
#include "dggStatus.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkDGGPath);
vtkDGGDefineInputMacro(vtkDGGPath, Pair, 1);

namespace
{
dgg::Status NoPair(bool isConnected)
{
  return dgg::InvalidInput(
    "There is no pair of points", isConnected ? ": input port 1 is empty" : "")
    .Fix("Add pairs, or connect a line for each pair to input port 1");
}

/// Reads the data of input port 1, which may be null: two point ids for each line, its ends.
/// Returns an error for points without lines, for an invalid line, and for an empty input if
/// `isNeeded`.
dgg::Status ReadEnds(vtkPolyData* data, bool isNeeded, std::vector<vtkIdType>& ends)
{
  if (!data || data->GetNumberOfPoints() + data->GetNumberOfLines() == 0)
  {
    return isNeeded ? NoPair(data != nullptr) : dgg::Status::Success();
  }
  if (data->GetNumberOfLines() == 0)
  {
    return dgg::InvalidInput("Input port 1 has points but no lines")
      .Fix("Connect the points of each pair by a line");
  }
  DGGSurfaceArrays arrays;
  std::vector<dgg::Offset> ids;
  DGG_RETURN_IF_ERROR(
    dgg::ReadPathEnds(arrays.ConvertCells(data->GetLines()), data->GetNumberOfPoints(), ids));
  ends.assign(ids.begin(), ids.end());
  return dgg::Status::Success();
}
}

//------------------------------------------------------------------------------
class vtkDGGPath::vtkInternals : public DGGGraphInternalsOf<vtkDGGPath>
{
public:
  using DGGGraphInternalsOf::DGGGraphInternalsOf;

  dgg::Status CheckProperties() const override;
  void ForgetResults() override { this->Self->NumberOfFallbacks = 0; }
  dgg::Status Execute(const DGGContext& context, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  bool CanDistribute() const override { return this->Self->Method == Graph; }
  dgg::Status ExecutePiece(
    const DGGContext& context, const DGGPieceUpdate& update, bool& isDone) override;
  void MakeEmptyOutput(const DGGContext& context, vtkInformationVector* outputVector) override;
  std::string GetMemoryRemedy() const override
  {
    return "Use a smaller mesh, a larger {Accuracy} or fewer pairs at a time";
  }

private:
  DGGPieceSearches Searches;
};

vtkDGGInternalsMacro(vtkDGGPath);
vtkDGGGraphUserMacro(vtkDGGPath);

//------------------------------------------------------------------------------
vtkDGGPath::vtkDGGPath()
  : Method(Graph)
  , Straighten(true)
  , Detour(dgg::PathOptions().Detour)
  , ProjectionTolerance(0.01)
  , NumberOfFallbacks(0)
{
  this->Internals.reset(new vtkInternals(this));
  this->SetNumberOfInputPorts(2);
}

//------------------------------------------------------------------------------
void vtkDGGPath::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << this->GetMethodAsString() << "\n";
  os << indent << "NumberOfPairs: " << this->GetNumberOfPairs() << "\n";
  os << indent << "ProjectionTolerance: " << this->ProjectionTolerance << "\n";
  os << indent << "Straighten: " << (this->Straighten ? "On" : "Off") << "\n";
  os << indent << "Detour: " << this->Detour << "\n";
  os << indent << "NumberOfFallbacks: " << this->NumberOfFallbacks << "\n";
  this->GetInternals().GraphUser.PrintSelf(os, indent);
}

//------------------------------------------------------------------------------
const char* vtkDGGPath::GetMethodAsString() const
{
  return this->Method == Exact ? "Exact" : "Graph";
}

//------------------------------------------------------------------------------
void vtkDGGPath::AddPair(vtkIdType from, vtkIdType to)
{
  this->PairIds.push_back(from);
  this->PairIds.push_back(to);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkDGGPath::RemoveAllPairs()
{
  if (!this->PairIds.empty())
  {
    this->PairIds.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkIdType vtkDGGPath::GetNumberOfPairs() const
{
  return static_cast<vtkIdType>(this->PairIds.size() / 2);
}

//------------------------------------------------------------------------------
vtkIdType vtkDGGPath::GetPairId(vtkIdType i, int side) const
{
  return i >= 0 && i < this->GetNumberOfPairs() ? this->PairIds[2 * i + side] : -1;
}

//------------------------------------------------------------------------------
vtkIdType vtkDGGPath::GetPairStart(vtkIdType i) const
{
  return this->GetPairId(i, 0);
}

//------------------------------------------------------------------------------
vtkIdType vtkDGGPath::GetPairEnd(vtkIdType i) const
{
  return this->GetPairId(i, 1);
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGPath::vtkInternals::CheckProperties() const
{
  DGG_RETURN_IF_ERROR(
    dgg::CheckLengths({ { "ProjectionTolerance", this->Self->ProjectionTolerance },
      { "Detour", this->Self->Detour } }));
  return DGGGraphInternalsOf::CheckProperties();
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGPath::vtkInternals::Execute(
  const DGGContext& context, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const dgg::PreparedSurface& mesh = context.Surface;
  if (mesh.IsCloud() && this->Self->Method == Exact)
  {
    return dgg::InvalidInput("There is no exact path on a point cloud")
      .At("Method")
      .Fix("Set {Method} to Graph");
  }
  const bool isExact = this->Self->Method == Exact;
  this->Searches = DGGPieceSearches();
  dgg::PathOptions options;
  options.Straighten = this->Self->Straighten;
  options.Detour = this->Self->Detour;

  vtkPolyData* lines = vtkPolyData::GetData(inputVector[1]);
  std::vector<vtkIdType> lineEnds;
  std::vector<dgg::SurfacePoint> ends;
  DGG_RETURN_IF_ERROR(ReadEnds(lines, this->Self->PairIds.empty(), lineEnds));
  DGGSourceSet set{ this->Self->PairIds, lines, 1, "path end", "", "" };
  set.ArePairs = true;
  set.PointIds = &lineEnds;
  DGG_RETURN_IF_ERROR(DGGLocate(context, set, this->Self->ProjectionTolerance, ends));
  if (!isExact)
  {
    DGG_RETURN_IF_ERROR(this->GraphUser.Update(context, this->Self));
  }

  const dgg::PathSearch::Pairs pairs = dgg::MakePairs(ends);
  const dgg::PathSearch search(context, pairs);
  dgg::PathSearch::Paths paths;
  DGG_RETURN_IF_ERROR(mesh.IsCloud() ? search.RunOnCloud(this->GraphUser, options.Straighten, paths)
      : isExact                      ? search.RunExact(paths)
                                     : search.RunInGraph(this->GraphUser, options, paths));
  this->Self->NumberOfFallbacks = dgg::CountFallbacks(paths);
  dgg::Output output;
  const std::vector<dgg::Offset> written = dgg::WritePaths(context, paths, output);
  DGG_RETURN_IF_ERROR(this->FillOutput(context, output, outputVector));
  DGGPassLineArrays(lines, written, this->Self->GetNumberOfPairs(),
    vtkPolyData::GetData(outputVector)->GetCellData());
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGPath::vtkInternals::ExecutePiece(
  const DGGContext& context, const DGGPieceUpdate& update, bool& isDone)
{
  dgg::ProcessGroup& group = update.Group;
  dgg::SourceCollection ends;
  vtkSmartPointer<vtkPolyData> lines;
  DGGSourceSet set{ this->Self->PairIds, nullptr, 1, "path end", "", "" };
  set.ArePairs = true;
  DGG_RETURN_IF_ERROR(DGGCollectFromAll(update, set, ends, lines, isDone));
  isDone = isDone && !lines && !ends.Ids.empty();
  DGG_RETURN_IF_ERROR(group.Require(isDone));
  if (!isDone)
  {
    return dgg::Status::Success();
  }
  struct
  {
    bool Straighten;
    double Detour;
  } first{ this->Self->Straighten, this->Self->Detour };
  DGG_RETURN_IF_ERROR(group.TakeFromFirst(first));
  dgg::PathOptions options;
  options.Straighten = first.Straighten;
  options.Detour = first.Detour;
  DGG_RETURN_IF_ERROR(
    this->Searches.Prepare(context, update, {}, this->GraphUser, this->Self, isDone));
  dgg::PieceSurface surface;
  if (isDone)
  {
    DGG_RETURN_IF_ERROR(surface.PrepareToGather(group, update.Piece, isDone));
    if (!isDone)
    {
      this->GraphUser.RefusePiece();
    }
  }
  dgg::PathSearch::Paths paths;
  if (isDone)
  {
    DGG_RETURN_IF_ERROR(dgg::FindPiecePaths(this->Searches.MakeContext(context), group,
      update.Piece, this->Searches.GetSearch(), surface, ends, options, paths, isDone));
  }
  if (!isDone)
  {
    return dgg::Status::Success();
  }
  if (group.Here == 0)
  {
    this->Self->NumberOfFallbacks = dgg::CountFallbacks(paths);
    const DGGContext onSurface{ surface.MakeContext(context), context.Input };
    dgg::Output output;
    dgg::WritePaths(onSurface, paths, output);
    surface.Renumber(output);
    DGG_RETURN_IF_ERROR(this->FillOutput(onSurface, output, update.Outputs));
  }
  this->Searches.Keep(this->GraphUser, this->Self);
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
void vtkDGGPath::vtkInternals::MakeEmptyOutput(
  const DGGContext& context, vtkInformationVector* outputVector)
{
  dgg::Output output;
  dgg::WritePaths(context, {}, output);
  this->FillOutput(context, output, outputVector);
}
