// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDiscreteGeodesicGraph.h"

#include "vtkDGGGraphArrays.h"
#include "vtkDGGGraphBuild.h"
#include "vtkDGGMeshAdapter.h"

#include "vtkAlgorithmOutput.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTimeStamp.h"

vtkStandardNewMacro(vtkDiscreteGeodesicGraph);

namespace
{
/// Whether a graph is what the options would make.
bool IsMadeBy(const dgg::GraphInfo& info, const dgg::GraphOptions& options)
{
  if (info.Construction != options.Construction)
  {
    return false;
  }
  return options.Construction == dgg::GraphConstruction::SaddleVertexGraph
    ? info.NumberOfNeighbors == options.NumberOfNeighbors
    : info.Accuracy == options.Accuracy;
}
}

//------------------------------------------------------------------------------
struct vtkDiscreteGeodesicGraph::vtkInternals
{
  vtkDGGGraphArrays OnInput;
  vtkDGGGraphArrays Built;
  vtkMTimeType BuiltMesh = 0;                 // build time of the mesh that it is the graph of
  const vtkDGGGraphArrays* Current = nullptr; // that of the last update
  dgg::GraphEstimate Estimate;
  vtkTimeStamp BuildTime;
};

//------------------------------------------------------------------------------
vtkDiscreteGeodesicGraph::vtkDiscreteGeodesicGraph()
  : Accuracy(0.01)
  , Construction(Guaranteed)
  , NumberOfNeighbors(30)
  , MemoryLimit(0)
  , GenerateGraphLines(false)
  , Internals(new vtkInternals)
{
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
vtkDiscreteGeodesicGraph::~vtkDiscreteGeodesicGraph() = default;

//------------------------------------------------------------------------------
void vtkDiscreteGeodesicGraph::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Accuracy: " << this->Accuracy << "\n";
  os << indent << "Construction: " << this->GetConstructionAsString() << "\n";
  os << indent << "NumberOfNeighbors: " << this->NumberOfNeighbors << "\n";
  os << indent << "MemoryLimit: " << this->MemoryLimit << "\n";
  os << indent << "GenerateGraphLines: " << (this->GenerateGraphLines ? "On" : "Off") << "\n";
  os << indent << "EstimatedMemory: " << this->GetEstimatedMemory() << "\n";
  os << indent << "EstimatedPeakMemory: " << this->GetEstimatedPeakMemory() << "\n";
  os << indent << "NumberOfGraphEdges: " << this->GetNumberOfGraphEdges() << "\n";
  os << indent << "MeanDegree: " << this->GetMeanDegree() << "\n";
  os << indent << "MemorySize: " << this->GetMemorySize() << "\n";
  os << indent << "GraphBuildTime: " << this->GetGraphBuildTime() << "\n";
}

//------------------------------------------------------------------------------
const char* vtkDiscreteGeodesicGraph::GetConstructionAsString() const
{
  switch (this->Construction)
  {
    case OneRelay:
      return "OneRelay";
    case Indirect:
      return "Indirect";
    case SaddleVertexGraph:
      return "SaddleVertexGraph";
    default:
      return "Guaranteed";
  }
}

//------------------------------------------------------------------------------
vtkPolyData* vtkDiscreteGeodesicGraph::GetGraphLines()
{
  return this->GetOutput(1);
}

//------------------------------------------------------------------------------
vtkTypeUInt64 vtkDiscreteGeodesicGraph::EstimateMemory()
{
  this->Internals->Estimate = dgg::GraphEstimate();
  const bool done = this->Attempt([this] {
    if (this->GetNumberOfInputConnections(0) > 0)
    {
      this->GetInputAlgorithm()->Update(this->GetInputConnection(0, 0)->GetIndex());
    }
    dgg::Status status = this->CheckProperties();
    if (status.IsOk())
    {
      status = this->PrepareMesh(vtkPolyData::SafeDownCast(this->GetInput()));
    }
    return status.IsOk() ? dgg::GraphBuilder(this->GetMesh().GetMesh())
                             .Estimate(this->MakeOptions(), this->Internals->Estimate)
                         : status;
  });
  return done ? this->GetEstimatedMemory() : 0;
}

//------------------------------------------------------------------------------
vtkTypeUInt64 vtkDiscreteGeodesicGraph::GetEstimatedMemory() const
{
  return static_cast<vtkTypeUInt64>(this->Internals->Estimate.Memory);
}

//------------------------------------------------------------------------------
vtkTypeUInt64 vtkDiscreteGeodesicGraph::GetEstimatedPeakMemory() const
{
  return static_cast<vtkTypeUInt64>(this->Internals->Estimate.Peak);
}

//------------------------------------------------------------------------------
vtkIdType vtkDiscreteGeodesicGraph::GetNumberOfGraphEdges() const
{
  const vtkDGGGraphArrays* graph = this->Internals->Current;
  return graph ? graph->GetView().GetNumberOfEdges() : 0;
}

//------------------------------------------------------------------------------
double vtkDiscreteGeodesicGraph::GetMeanDegree() const
{
  const vtkDGGGraphArrays* graph = this->Internals->Current;
  const dgg::Id points = graph ? graph->GetView().NumberOfVertices : 0;
  return points > 0 ? static_cast<double>(this->GetNumberOfGraphEdges()) / points : 0.0;
}

//------------------------------------------------------------------------------
vtkTypeUInt64 vtkDiscreteGeodesicGraph::GetMemorySize() const
{
  const vtkDGGGraphArrays* graph = this->Internals->Current;
  return graph ? vtkDGGGraphArrays::GetMemorySize(graph->GetView()) : 0;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkDiscreteGeodesicGraph::GetGraphBuildTime() const
{
  return this->Internals->BuildTime.GetMTime();
}

//------------------------------------------------------------------------------
dgg::GraphOptions vtkDiscreteGeodesicGraph::MakeOptions() const
{
  dgg::GraphOptions options;
  options.Construction = static_cast<dgg::GraphConstruction>(this->Construction);
  options.Accuracy = this->Accuracy;
  options.NumberOfNeighbors = this->NumberOfNeighbors;
  return options;
}

//------------------------------------------------------------------------------
int vtkDiscreteGeodesicGraph::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->Internals->Current = nullptr;
  return this->Superclass::RequestData(request, inputVector, outputVector);
}

//------------------------------------------------------------------------------
dgg::Status vtkDiscreteGeodesicGraph::CheckProperties() const
{
  return dgg::GraphBuilder::Check(this->MakeOptions());
}

//------------------------------------------------------------------------------
std::string vtkDiscreteGeodesicGraph::GetMemoryRemedy() const
{
  return "use a smaller mesh or a larger Accuracy";
}

//------------------------------------------------------------------------------
dgg::Status vtkDiscreteGeodesicGraph::Execute(vtkPolyData* surface,
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  vtkInternals& internals = *this->Internals;
  if (!this->Advance(0.0))
  {
    return dgg::Status::Abort();
  }
  if (this->FindOnInput(surface))
  {
    internals.Current = &internals.OnInput;
    internals.Built.Clear();
  }
  else
  {
    const dgg::Status status = this->Build();
    if (!status.IsOk())
    {
      return status;
    }
    internals.Current = &internals.Built;
  }
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  output->ShallowCopy(surface);
  internals.Current->AddTo(output->GetFieldData());
  vtkPolyData* lines = vtkPolyData::GetData(outputVector, 1);
  lines->Initialize();
  if (this->GenerateGraphLines)
  {
    this->AddLines(surface, lines);
  }
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
void vtkDiscreteGeodesicGraph::MakeEmptyOutput(
  vtkPolyData* surface, vtkInformationVector* outputVector)
{
  vtkPolyData::GetData(outputVector, 0)->ShallowCopy(surface);
  vtkPolyData::GetData(outputVector, 1)->Initialize();
}

//------------------------------------------------------------------------------
bool vtkDiscreteGeodesicGraph::FindOnInput(vtkPolyData* surface)
{
  vtkDGGGraphArrays& graph = this->Internals->OnInput;
  std::string complaint;
  const bool found = graph.Find(surface->GetFieldData(), this->GetMesh(), complaint);
  if (!complaint.empty())
  {
    vtkWarningMacro(<< complaint << ". A new one takes its place.");
  }
  return found && IsMadeBy(graph.GetView().Info, this->MakeOptions());
}

//------------------------------------------------------------------------------
dgg::Status vtkDiscreteGeodesicGraph::Build()
{
  vtkInternals& internals = *this->Internals;
  const vtkDGGMeshAdapter& mesh = this->GetMesh();
  dgg::GraphOptions options = this->MakeOptions();
  if (internals.BuiltMesh == mesh.GetBuildTime() && internals.Built.IsValid() &&
    IsMadeBy(internals.Built.GetView().Info, options))
  {
    return dgg::Status::Success();
  }
  internals.Built.Clear();
  options.Progress = [this](double fraction) { return this->Advance(fraction); };
  const dgg::GraphBuilder builder(mesh.GetMesh());
  dgg::GeodesicGraph graph;
  const dgg::Status status =
    vtkDGGBuildGraph(builder, mesh, options, this->MemoryLimit, graph, internals.Estimate);
  if (status.IsOk())
  {
    internals.Built.Adopt(graph, mesh);
    internals.BuiltMesh = mesh.GetBuildTime();
    internals.BuildTime.Modified();
  }
  return status;
}

//------------------------------------------------------------------------------
void vtkDiscreteGeodesicGraph::AddLines(vtkPolyData* surface, vtkPolyData* lines) const
{
  const dgg::GraphView& graph = this->Internals->Current->GetView();
  const vtkIdType count = graph.GetNumberOfEdges() / 2;
  vtkNew<vtkCellArray> cells;
  cells->AllocateExact(count, 2 * count);
  vtkNew<vtkDoubleArray> lengths;
  lengths->SetName("Length");
  lengths->Allocate(count);
  for (dgg::Id v = 0; v < graph.NumberOfVertices; ++v)
  {
    for (dgg::Offset e = graph.Offsets[v]; e < graph.Offsets[v + 1]; ++e)
    {
      const vtkIdType ends[2] = { v, graph.Targets[e] };
      if (ends[0] < ends[1])
      {
        cells->InsertNextCell(2, ends);
        lengths->InsertNextValue(graph.Length(e));
      }
    }
  }
  lines->SetPoints(surface->GetPoints());
  lines->SetLines(cells);
  lines->GetCellData()->SetScalars(lengths);
}
