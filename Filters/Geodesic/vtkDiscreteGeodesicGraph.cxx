// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDiscreteGeodesicGraph.h"

#include "DGGContext.h"
#include "DGGFilterInternals.h"
#include "DGGGraphArrays.h"
#include "DGGOutput.h"
#include "DGGPieceGraph.h"

#include "dggGraphBuildTask.h"
#include "dggOutput.h"
#include "dggPieceGraph.h"
#include "dggPreparedSurface.h"
#include "dggProgressPart.h"

#include "vtkCellArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTimeStamp.h"

#include <algorithm>

vtkStandardNewMacro(vtkDiscreteGeodesicGraph);

namespace
{
/// Progress weight of building the graph if lines are generated as well.
constexpr double BuildShare = 0.9;
}

//------------------------------------------------------------------------------
class vtkDiscreteGeodesicGraph::vtkInternals : public DGGInternalsOf<vtkDiscreteGeodesicGraph>
{
public:
  using DGGInternalsOf::DGGInternalsOf;

  dgg::Status CheckProperties() const override;
  void ForgetResults() override;
  dgg::Status Execute(const DGGContext& context, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  bool CanDistribute() const override
  {
    return !this->Self->GenerateGraphLines &&
      this->MakeOptions().Construction != dgg::GraphConstruction::Indirect;
  }
  dgg::Status ExecutePiece(
    const DGGContext& context, const DGGPieceUpdate& update, bool& isDone) override;
  bool PassesSurface() const override { return true; }
  void MakeEmptyOutput(const DGGContext& context, vtkInformationVector* outputVector) override;
  std::string GetMemoryRemedy() const override;

  /// Predicts the memory of the graph without building it.
  dgg::Status Predict();

  DGGGraphArrays OnInput;
  DGGGraphArrays Built;
  dgg::Domain BuiltDomain;
  dgg::GraphSummary Current; // graph of the last update
  std::string InputGraphDamage;
  dgg::GraphEstimate Estimate;
  DGGPieceGraph Piece;
  vtkTimeStamp BuildTime;

private:
  dgg::GraphOptions MakeOptions() const;
  bool FindOnInput(const DGGContext& context);
  dgg::Status Build(const DGGContext& context);
  dgg::Status AddLines(const DGGContext& context, const DGGGraphArrays& arrays, vtkPolyData* lines);
};

vtkDGGInternalsMacro(vtkDiscreteGeodesicGraph);

//------------------------------------------------------------------------------
vtkDiscreteGeodesicGraph::vtkDiscreteGeodesicGraph()
{
  this->Internals.reset(new vtkInternals(this));
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
void vtkDiscreteGeodesicGraph::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Accuracy: " << this->Accuracy << "\n";
  os << indent << "Construction: " << this->GetConstructionAsString() << "\n";
  os << indent << "NumberOfNeighbors: " << this->NumberOfNeighbors << "\n";
  os << indent << "GenerateGraphLines: " << (this->GenerateGraphLines ? "On" : "Off") << "\n";
  os << indent << "EstimatedMemory: " << this->GetEstimatedMemory() << "\n";
  os << indent << "EstimatedPeakMemory: " << this->GetEstimatedPeakMemory() << "\n";
  os << indent << "NumberOfGraphEdges: " << this->GetNumberOfGraphEdges() << "\n";
  os << indent << "MeanDegree: " << this->GetMeanDegree() << "\n";
  os << indent << "MemorySize: " << this->GetMemorySize() << "\n";
  os << indent << "InputGraphDamage: " << this->GetInputGraphDamage() << "\n";
  os << indent << "GraphBuildTime: " << this->GetGraphBuildTime() << "\n";
}

//------------------------------------------------------------------------------
vtkDGGAsStringMacro(vtkDiscreteGeodesicGraph, Construction, "Guaranteed", "OneRelay", "Indirect",
  "SaddleVertexGraph");

//------------------------------------------------------------------------------
vtkPolyData* vtkDiscreteGeodesicGraph::GetGraphLines()
{
  return this->GetOutput(1);
}

//------------------------------------------------------------------------------
vtkTypeUInt64 vtkDiscreteGeodesicGraph::EstimateMemory()
{
  vtkInternals& internals = this->GetInternals();
  internals.Estimate = dgg::GraphEstimate();
  const bool done = internals.AttemptOutsideOfUpdate([&] { return internals.Predict(); });
  return done ? this->GetEstimatedMemory() : 0;
}

//------------------------------------------------------------------------------
dgg::Status vtkDiscreteGeodesicGraph::vtkInternals::Predict()
{
  DGG_RETURN_IF_ERROR(this->CheckAllProperties());
  vtkSmartPointer<vtkPolyData> surface;
  DGG_RETURN_IF_ERROR(this->GetWholeInput(surface));
  if (surface && surface->GetNumberOfPoints() == 0 && surface->GetNumberOfCells() == 0)
  {
    this->WarnAboutEmptyInput("neither points nor cells");
    return dgg::Status::Success();
  }
  DGG_RETURN_IF_ERROR(this->PrepareMesh(surface));
  const DGGContext context = this->MakeContext(surface);
  DGG_RETURN_IF_ERROR(dgg::ReportTo(context.Progress, 0.0));
  dgg::GraphOptions options = this->MakeOptions();
  dgg::UseThreads(context, options);
  DGG_RETURN_IF_ERROR(
    dgg::GraphBuilder(context.Surface.GetMesh()).Estimate(options, this->Estimate));
  return dgg::ReportTo(context.Progress, 1.0);
}

//------------------------------------------------------------------------------
void vtkDiscreteGeodesicGraph::ReleaseGraph()
{
  this->GetInternals().Built.Clear();
  this->GetInternals().OnInput.Clear();
  this->GetInternals().Piece = DGGPieceGraph();
}

//------------------------------------------------------------------------------
vtkDGGResultMacro(vtkDiscreteGeodesicGraph, vtkTypeUInt64, EstimatedMemory, Estimate.Memory);
vtkDGGResultMacro(vtkDiscreteGeodesicGraph, vtkTypeUInt64, EstimatedPeakMemory, Estimate.Peak);
vtkDGGResultMacro(vtkDiscreteGeodesicGraph, vtkIdType, NumberOfGraphEdges, Current.NumberOfEdges);

//------------------------------------------------------------------------------
double vtkDiscreteGeodesicGraph::GetMeanDegree() const
{
  const dgg::GraphSummary& graph = this->GetInternals().Current;
  return graph.NumberOfVertices > 0
    ? static_cast<double>(graph.NumberOfEdges) / graph.NumberOfVertices
    : 0.0;
}

//------------------------------------------------------------------------------
vtkDGGResultMacro(vtkDiscreteGeodesicGraph, vtkTypeUInt64, MemorySize, Current.MemorySize);

//------------------------------------------------------------------------------
std::string vtkDiscreteGeodesicGraph::GetInputGraphDamage() const
{
  return this->GetInternals().InputGraphDamage;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkDiscreteGeodesicGraph::GetGraphBuildTime() const
{
  return std::max(
    this->GetInternals().BuildTime.GetMTime(), this->GetInternals().Piece.GetBuildTime());
}

//------------------------------------------------------------------------------
dgg::GraphOptions vtkDiscreteGeodesicGraph::vtkInternals::MakeOptions() const
{
  dgg::GraphOptions options;
  options.Construction = static_cast<dgg::GraphConstruction>(this->Self->Construction);
  options.Accuracy = this->Self->Accuracy;
  options.NumberOfNeighbors = this->Self->NumberOfNeighbors;
  return options;
}

//------------------------------------------------------------------------------
dgg::Status vtkDiscreteGeodesicGraph::vtkInternals::CheckProperties() const
{
  return dgg::GraphBuilder::Check(this->MakeOptions());
}

//------------------------------------------------------------------------------
std::string vtkDiscreteGeodesicGraph::vtkInternals::GetMemoryRemedy() const
{
  return this->Self->Construction == SaddleVertexGraph
    ? "Use a smaller mesh or a smaller {NumberOfNeighbors}"
    : "Use a smaller mesh or a larger {Accuracy}";
}

//------------------------------------------------------------------------------
void vtkDiscreteGeodesicGraph::vtkInternals::ForgetResults()
{
  this->Current = dgg::GraphSummary();
  this->InputGraphDamage.clear();
}

//------------------------------------------------------------------------------
dgg::Status vtkDiscreteGeodesicGraph::vtkInternals::Execute(const DGGContext& context,
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  this->Piece = DGGPieceGraph();
  const bool isOnInput = this->FindOnInput(context);
  DGGGraphArrays& graph = isOnInput ? this->OnInput : this->Built;
  if (isOnInput)
  {
    this->Built.Clear();
    this->Estimate = dgg::GraphEstimate(); // no graph is built
  }
  else
  {
    DGG_RETURN_IF_ERROR(this->Build(context));
  }
  vtkPolyData* lines = vtkPolyData::GetData(outputVector, 1);
  lines->Initialize();
  if (this->Self->GenerateGraphLines)
  {
    DGG_RETURN_IF_ERROR(this->AddLines(context, graph, lines));
  }
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  output->ShallowCopy(context.Input);
  graph.AddTo(output->GetFieldData());
  this->Current = dgg::GraphSummary(graph.GetView());
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
dgg::Status vtkDiscreteGeodesicGraph::vtkInternals::ExecutePiece(
  const DGGContext& context, const DGGPieceUpdate& update, bool& isDone)
{
  this->Built.Clear();
  std::vector<std::string> warnings;
  DGG_RETURN_IF_ERROR(this->Piece.Update(
    context, update.Group, update.Piece, this->MakeOptions(), false, isDone, warnings));
  this->InputGraphDamage = this->Piece.GetDamage();
  this->Warn(warnings);
  if (!isDone)
  {
    return dgg::Status::Success();
  }
  this->Estimate = this->Piece.GetEstimate();
  vtkPolyData::GetData(update.Outputs, 1)->Initialize();
  vtkPolyData* output = vtkPolyData::GetData(update.Outputs, 0);
  output->ShallowCopy(context.Input);
  this->Piece.Get().AddTo(output->GetFieldData());
  this->Current = this->Piece.GetSummary();
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
void vtkDiscreteGeodesicGraph::vtkInternals::MakeEmptyOutput(
  const DGGContext& context, vtkInformationVector* outputVector)
{
  this->Estimate = dgg::GraphEstimate();
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  output->ShallowCopy(context.Input);
  DGGGraphArrays::RemoveFrom(output->GetFieldData()); // the arrays belong to another surface
  vtkPolyData::GetData(outputVector, 1)->Initialize();
}

//------------------------------------------------------------------------------
bool vtkDiscreteGeodesicGraph::vtkInternals::FindOnInput(const DGGContext& context)
{
  DGGGraphArrays& graph = this->OnInput;
  std::string complaint;
  const bool found = graph.Find(context.Input->GetFieldData(), context, complaint);
  this->InputGraphDamage = graph.GetDamage();
  if (!complaint.empty())
  {
    this->Warn(dgg::DescribeReplacement(complaint, this->MakeOptions()));
  }
  return found && dgg::IsBuiltWith(graph.GetView().Info, this->MakeOptions());
}

//------------------------------------------------------------------------------
dgg::Status vtkDiscreteGeodesicGraph::vtkInternals::Build(const DGGContext& context)
{
  const dgg::PreparedSurface& mesh = context.Surface;
  dgg::GraphOptions options = this->MakeOptions();
  const dgg::GraphInfo& built = this->Built.GetView().Info;
  const bool isKept = this->Built.IsValid() && built.Surface == mesh.GetSignature() &&
    this->BuiltDomain == mesh.GetDomain() && dgg::IsBuiltWith(built, options);
  if (isKept)
  {
    return dgg::Status::Success();
  }
  this->Built.Clear();
  options.Progress =
    dgg::ProgressPart(context.Progress, 0.0, this->Self->GenerateGraphLines ? BuildShare : 1.0);
  const dgg::GraphBuilder builder(mesh.GetMesh());
  dgg::GeodesicGraph graph;
  DGG_RETURN_IF_ERROR(dgg::BuildGraph(context, builder, options, graph, this->Estimate));
  this->Built.Adopt(graph, context);
  this->BuiltDomain = mesh.GetDomain();
  this->BuildTime.Modified();
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
dgg::Status vtkDiscreteGeodesicGraph::vtkInternals::AddLines(
  const DGGContext& context, const DGGGraphArrays& arrays, vtkPolyData* lines)
{
  dgg::Output output;
  DGG_RETURN_IF_ERROR(dgg::WriteGraphLines(
    context, arrays.GetView(), dgg::ProgressPart(context.Progress, BuildShare, 1.0), output));
  lines->SetPoints(context.Input->GetPoints());
  lines->SetLines(DGGMakeCells(output.Lines));
  DGGAddArrays(output, lines);
  return dgg::Status::Success();
}
