// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGPath.h"

#include "DGGGraphUser.h"
#include "DGGMakeArray.h"
#include "DGGNewGeometry.h"
#include "DGGProperties.h"
#include "DGGSources.h"

#include "dggInvalidInput.h"
#include "dggPathSearch.h"
#include "dggPreparedSurface.h"

#include "vtkAbstractArray.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkDGGPath);
vtkDGGDefineInputMacro(vtkDGGPath, Pair, 1);

namespace
{
dgg::Status NoPair(bool isConnected)
{
  return dgg::Status::Invalid(isConnected
      ? "there is no pair of points: input port 1 is empty. Add a line for each pair, or call "
        "AddPair()"
      : "there is no pair of points: call AddPair(), or connect a line for each pair to input port "
        "1");
}

dgg::Status CheckLine(vtkIdType line, vtkIdType size, const vtkIdType* ids, vtkIdType points)
{
  if (size == 0)
  {
    return dgg::InvalidInput("line ", line, " of input port 1 has no points: remove it");
  }
  for (const vtkIdType id : { ids[0], ids[size - 1] })
  {
    if (id < 0 || id >= points)
    {
      return dgg::InvalidInput("line ", line, " of input port 1 names point ", id,
        ", but there are ", points, ": repair the line");
    }
  }
  return dgg::Status::Success();
}

/// The lines of a vtkPolyData; the pair of a line is its first and last point.
struct PairLines
{
  std::vector<vtkIdType> Ends;  ///< point ids, two per line
  std::vector<vtkIdType> Cells; ///< cell id per line

  /// Reads the data of input port 1, which may be null. Returns an error for points without lines,
  /// for an invalid line, and for an empty input if `isNeeded`.
  dgg::Status Read(vtkPolyData* lines, bool isNeeded)
  {
    this->Ends.clear();
    this->Cells.clear();
    if (!lines || lines->GetNumberOfPoints() + lines->GetNumberOfLines() == 0)
    {
      return isNeeded ? NoPair(lines != nullptr) : dgg::Status::Success();
    }
    const vtkIdType count = lines->GetNumberOfLines();
    if (count == 0)
    {
      return dgg::Status::Invalid(
        "input port 1 has points but no lines: connect the points of each pair by a line");
    }
    if (!lines->GetLines()->IsValid())
    {
      return dgg::Status::Invalid("the offsets and the connectivity of the lines of input port 1 "
                                  "contradict each other: rebuild the cell array");
    }
    const vtkIdType firstCell = lines->GetNumberOfVerts(); // cells are numbered verts first
    for (vtkIdType i = 0; i < count; ++i)
    {
      vtkIdType size = 0;
      const vtkIdType* ids = nullptr;
      lines->GetLines()->GetCellAtId(i, size, ids);
      DGG_RETURN_IF_ERROR(CheckLine(i, size, ids, lines->GetNumberOfPoints()));
      this->Ends.push_back(ids[0]);
      this->Ends.push_back(ids[size - 1]);
      this->Cells.push_back(firstCell + i);
    }
    return dgg::Status::Success();
  }
};

/// Returns the ends of all pairs in succession: pairs by id, then lines.
DGGSourceSet MakeSourceSet(
  const std::vector<vtkIdType>& ids, vtkPolyData* lines, const PairLines& pairs)
{
  DGGSourceSet set{ ids, lines, 1, "path end", "call AddPair()", "" };
  set.PointIds = &pairs.Ends;
  return set;
}

dgg::PathSearch::Pairs MakePairs(const std::vector<dgg::SurfacePoint>& ends)
{
  dgg::PathSearch::Pairs pairs;
  for (std::size_t i = 0; i + 1 < ends.size(); i += 2)
  {
    pairs.push_back({ ends[i], ends[i + 1] });
  }
  return pairs;
}

/// The paths of the output and the cell data of their lines.
struct PathSet
{
  const std::vector<dgg::FoundPath>& Paths;  ///< per pair
  vtkDataSetAttributes* CellData;            ///< to be passed to the output; may be null
  const std::vector<vtkIdType>& CellsOfLast; ///< tuples of CellData for the last pairs
};

/// Values of PathStatus.
constexpr int HasPath = 0;
constexpr int NotConnected = 1;

void AddCellData(const PathSet& set, const std::vector<vtkIdType>& pairs, vtkCellData* output)
{
  const auto count = static_cast<vtkIdType>(pairs.size());
  // Pairs by id come before those of lines, and have no tuple.
  const auto firstLine = static_cast<vtkIdType>(set.Paths.size() - set.CellsOfLast.size());
  std::vector<vtkIdType> tuples;
  auto ids = DGGMakeArray<vtkIdTypeArray>("PairId", count);
  auto lengths = DGGMakeArray<vtkDoubleArray>("Length", count);
  auto graphLengths = DGGMakeArray<vtkDoubleArray>("GraphLength", count);
  auto straightened = DGGMakeArray<vtkIntArray>("Straightened", count);
  for (vtkIdType line = 0; line < count; ++line)
  {
    const vtkIdType pair = pairs[line];
    const dgg::FoundPath& path = set.Paths[pair];
    tuples.push_back(pair < firstLine ? -1 : set.CellsOfLast[pair - firstLine]);
    ids->SetValue(line, pair);
    lengths->SetValue(line, path.Path.Length);
    graphLengths->SetValue(line, path.GraphLength);
    straightened->SetValue(line, path.IsStraightened ? 1 : 0);
  }
  for (int a = 0; set.CellData && a < set.CellData->GetNumberOfArrays(); ++a)
  {
    output->AddArray(DGGPickTuples(set.CellData->GetAbstractArray(a), tuples, 0.0));
  }
  output->AddArray(lengths);
  output->AddArray(graphLengths);
  output->AddArray(straightened);
  output->AddArray(ids);
}

std::vector<vtkIdType> FindUnconnected(const std::vector<dgg::FoundPath>& paths)
{
  std::vector<vtkIdType> unconnected;
  for (std::size_t i = 0; i < paths.size(); ++i)
  {
    if (paths[i].Path.IsEmpty())
    {
      unconnected.push_back(static_cast<vtkIdType>(i));
    }
  }
  return unconnected;
}

void WritePaths(const PathSet& set, const DGGNewGeometry& geometry, vtkPolyData* output)
{
  geometry.Begin(output);
  const auto status =
    DGGAddArray<vtkIntArray>(output->GetFieldData(), "PathStatus", set.Paths.size());
  std::vector<vtkIdType> pairs;
  vtkIdType size = 0;
  for (std::size_t i = 0; i < set.Paths.size(); ++i)
  {
    const dgg::SurfacePath& path = set.Paths[i].Path;
    status->SetValue(static_cast<vtkIdType>(i), path.IsEmpty() ? NotConnected : HasPath);
    if (!path.IsEmpty())
    {
      pairs.push_back(static_cast<vtkIdType>(i));
      size += static_cast<vtkIdType>(path.Points.size());
    }
  }
  DGGPolylineWriter writer(geometry, size);
  for (const vtkIdType pair : pairs)
  {
    writer.Add(set.Paths[pair].Path);
  }
  writer.AddTo(output);
  AddCellData(set, pairs, output->GetCellData());
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
  void MakeEmptyOutput(const DGGContext& context, vtkInformationVector* outputVector) override;
  std::string GetMemoryRemedy() const override
  {
    return "use a smaller mesh, a larger Accuracy or fewer pairs at a time";
  }

private:
  void WarnAboutUnconnectedPairs(
    const DGGContext& context, const std::vector<vtkIdType>& pairs, std::size_t count);
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
  DGG_RETURN_IF_ERROR(DGGCheckLengths({ { "ProjectionTolerance", this->Self->ProjectionTolerance },
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
    return dgg::Status::Invalid("there is no exact path on a point cloud: call SetMethodToGraph()");
  }
  const bool isExact = this->Self->Method == Exact;
  dgg::PathOptions options;
  options.Straighten = this->Self->Straighten;
  options.Detour = this->Self->Detour;

  vtkPolyData* lines = vtkPolyData::GetData(inputVector[1]);
  PairLines linePairs;
  std::vector<dgg::SurfacePoint> ends;
  DGG_RETURN_IF_ERROR(linePairs.Read(lines, this->Self->PairIds.empty()));
  DGG_RETURN_IF_ERROR(DGGLocate(context, MakeSourceSet(this->Self->PairIds, lines, linePairs),
    this->Self->ProjectionTolerance, ends));
  DGGNewGeometry geometry;
  DGG_RETURN_IF_ERROR(geometry.Take(context, this->Self->GetOutputPointsPrecision()));
  DGGGraphUser& graph = this->GraphUser;
  if (!isExact)
  {
    DGG_RETURN_IF_ERROR(graph.Update(context, this->Self));
  }

  const dgg::PathSearch::Pairs pairs = MakePairs(ends);
  const dgg::PathSearch search(context, pairs);
  dgg::PathSearch::Paths paths;
  DGG_RETURN_IF_ERROR(mesh.IsCloud() ? search.RunOnCloud(graph, options.Straighten, paths)
      : isExact                      ? search.RunExact(paths)
                                     : search.RunInGraph(graph, options, paths));
  for (const dgg::FoundPath& path : paths)
  {
    this->Self->NumberOfFallbacks += path.NumberOfFallbacks;
  }
  WritePaths({ paths, lines ? lines->GetCellData() : nullptr, linePairs.Cells }, geometry,
    vtkPolyData::GetData(outputVector));
  this->WarnAboutUnconnectedPairs(context, FindUnconnected(paths), paths.size());
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
void vtkDGGPath::vtkInternals::WarnAboutUnconnectedPairs(
  const DGGContext& context, const std::vector<vtkIdType>& pairs, std::size_t count)
{
  if (!pairs.empty())
  {
    const bool isOne = pairs.size() == 1;
    vtkWarningWithObjectMacro(
      this->Self, << pairs.size() << " of " << count << (count == 1 ? " pair" : " pairs")
                  << " of points, " << (isOne ? "" : "the first of them ") << "pair " << pairs[0]
                  << (isOne ? ", is" : ", are") << " not connected by the "
                  << (context.Surface.IsCloud() ? "graph of the cloud: " : "surface: ")
                  << (isOne ? "it has" : "they have") << " no polyline, and 1 in the "
                  << "field array PathStatus.");
  }
}

//------------------------------------------------------------------------------
void vtkDGGPath::vtkInternals::MakeEmptyOutput(
  const DGGContext& context, vtkInformationVector* outputVector)
{
  DGGNewGeometry geometry;
  geometry.Take(context, this->Self->GetOutputPointsPrecision());
  const dgg::PathSearch::Paths none;
  WritePaths({ none, nullptr, {} }, geometry, vtkPolyData::GetData(outputVector));
}
