// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGPath.h"

#include "vtkDGGGraphUser.h"
#include "vtkDGGMeshAdapter.h"
#include "vtkDGGNewGeometry.h"
#include "vtkDGGPairLines.h"
#include "vtkDGGPathOutput.h"
#include "vtkDGGPathSearch.h"
#include "vtkDGGProperties.h"
#include "vtkDGGSourceCollector.h"

#include "vtkCellData.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <utility>

vtkStandardNewMacro(vtkDGGPath);
vtkDGGGraphUserMacro(vtkDGGPath);

namespace
{
/// The ends of all pairs, one after the other: those by id and those of lines.
vtkDGGSourceSet MakeSourceSet(
  const std::vector<vtkIdType>& ids, vtkPolyData* lines, const vtkDGGPairLines& pairs)
{
  vtkDGGSourceSet set{ ids, lines, 1, "path end", "call AddPair()", "" };
  set.PointIds = &pairs.Ends;
  return set;
}

vtkDGGPathSearch::Pairs MakePairs(const std::vector<dgg::GeodesicSource>& ends)
{
  vtkDGGPathSearch::Pairs pairs;
  for (std::size_t i = 0; i + 1 < ends.size(); i += 2)
  {
    pairs.push_back({ ends[i].Point, ends[i + 1].Point });
  }
  return pairs;
}
}

//------------------------------------------------------------------------------
vtkDGGPath::vtkDGGPath()
  : Method(Graph)
  , Straighten(true)
  , Detour(dgg::PathOptions().Detour)
  , ProjectionTolerance(0.01)
  , NumberOfFallbacks(0)
  , GraphUser(new vtkDGGGraphUser)
  , Collector(new vtkDGGSourceCollector)
  , Geometry(new vtkDGGNewGeometry)
{
  this->SetNumberOfInputPorts(2);
}

//------------------------------------------------------------------------------
vtkDGGPath::~vtkDGGPath() = default;

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
  this->GraphUser->PrintSelf(os, indent);
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
void vtkDGGPath::SetPairConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(1, output);
}

//------------------------------------------------------------------------------
void vtkDGGPath::SetPairData(vtkPolyData* lines)
{
  this->SetInputData(1, lines);
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGPath::CheckProperties() const
{
  dgg::Status status = vtkDGGCheckLength("ProjectionTolerance", this->ProjectionTolerance);
  if (status.IsOk())
  {
    status = vtkDGGCheckLength("Detour", this->Detour);
  }
  return status.IsOk() ? this->GraphUser->Check() : status;
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGPath::CheckInputs(vtkPolyData* surface, vtkInformationVector** inputVector) const
{
  vtkPolyData* lines = vtkPolyData::GetData(inputVector[1]);
  vtkDGGPairLines pairs;
  const dgg::Status status = pairs.Read(lines, this->PairIds.empty());
  return status.IsOk() ? vtkDGGSourceCollector::Check(
                           MakeSourceSet(this->PairIds, lines, pairs), surface->GetNumberOfPoints())
                       : status;
}

//------------------------------------------------------------------------------
bool vtkDGGPath::IsCloud(vtkPolyData* input) const
{
  return vtkDGGGraphUser::IsCloud(input);
}

//------------------------------------------------------------------------------
std::string vtkDGGPath::GetMemoryRemedy() const
{
  return "use a smaller mesh, a larger Accuracy or fewer pairs at a time";
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGPath::Execute(
  vtkPolyData* surface, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  this->NumberOfFallbacks = 0;
  const vtkDGGMeshAdapter& mesh = this->GetMesh();
  if (mesh.IsCloud() && this->Method == Exact)
  {
    return dgg::Status::Invalid("there is no exact path on a point cloud: call SetMethodToGraph()");
  }
  const bool isExact = this->Method == Exact;
  dgg::PathOptions options;
  options.Straighten = this->Straighten;
  options.Detour = this->Detour;

  vtkPolyData* lines = vtkPolyData::GetData(inputVector[1]);
  vtkDGGPairLines linePairs;
  std::vector<dgg::GeodesicSource> ends;
  dgg::Status status = linePairs.Read(lines, this->PairIds.empty());
  if (status.IsOk())
  {
    status = this->Collector->Collect(MakeSourceSet(this->PairIds, lines, linePairs),
      this->ProjectionTolerance, mesh, surface->GetPoints(), ends);
  }
  if (status.IsOk())
  {
    status = this->Geometry->Take(surface, mesh, this->GetOutputPointsPrecision());
  }
  if (status.IsOk() && !this->Advance(0.0))
  {
    status = dgg::Status::Abort();
  }
  const auto progress = [this](double fraction) { return this->Advance(fraction); };
  if (status.IsOk() && !isExact)
  {
    status = this->GraphUser->Update(surface, mesh, progress, this);
  }
  if (!status.IsOk())
  {
    return status;
  }

  const vtkDGGPathSearch::Pairs pairs = MakePairs(ends);
  const vtkDGGPathSearch search(mesh, pairs);
  vtkDGGPathSearch::Paths paths;
  vtkDGGGraphProvider& graph = this->GraphUser->GetProvider();
  if (mesh.IsCloud())
  {
    status = search.RunOnCloud(graph, options.Straighten, paths);
  }
  else
  {
    status = isExact ? search.RunExact(progress, paths)
                     : search.RunInGraph(graph, this->Geometry->GetPositions(), options, paths);
  }
  if (!status.IsOk())
  {
    return status;
  }
  for (const dgg::FoundPath& path : paths)
  {
    this->NumberOfFallbacks += path.NumberOfFallbacks;
  }
  vtkDGGWritePaths({ paths, lines ? lines->GetCellData() : nullptr, linePairs.Cells },
    *this->Geometry, vtkPolyData::GetData(outputVector));
  this->WarnAboutUnconnectedPairs(vtkDGGFindUnconnected(paths), paths.size());
  return status;
}

//------------------------------------------------------------------------------
void vtkDGGPath::WarnAboutUnconnectedPairs(const std::vector<vtkIdType>& pairs, std::size_t count)
{
  if (!pairs.empty())
  {
    const bool isOne = pairs.size() == 1;
    vtkWarningMacro(<< pairs.size() << " of " << count << (count == 1 ? " pair" : " pairs")
                    << " of points, " << (isOne ? "" : "the first of them ") << "pair " << pairs[0]
                    << (isOne ? ", is" : ", are") << " not connected by the "
                    << (this->GetMesh().IsCloud() ? "graph of the cloud: " : "surface: ")
                    << (isOne ? "it has" : "they have") << " no polyline, and 1 in the "
                    << "field array PathStatus.");
  }
}

//------------------------------------------------------------------------------
void vtkDGGPath::MakeEmptyOutput(vtkPolyData* surface, vtkInformationVector* outputVector)
{
  this->NumberOfFallbacks = 0;
  this->Geometry->Take(surface, this->GetMesh(), this->GetOutputPointsPrecision());
  const vtkDGGPathSearch::Paths none;
  vtkDGGWritePaths({ none, nullptr, {} }, *this->Geometry, vtkPolyData::GetData(outputVector));
}
