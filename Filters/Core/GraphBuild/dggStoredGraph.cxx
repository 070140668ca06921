// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggStoredGraph.h"

#include "dggBitHash.h"
#include "dggCounted.h"
#include "dggGraphBuilder.h"
#include "dggStatus.h"

#include <algorithm>

namespace dgg
{
namespace
{
/// Positions in the array Info.
enum InfoSlot
{
  Version,
  Kind,
  Construction,
  Accuracy, // bits of the double
  NumberOfNeighbors,
  Merged, // 1 for a graph built with MergeCoincidentPoints
  FirstSignature,
  SecondSignature,
  VoxelSize,      // bits of the double
  MergeTolerance, // bits of the double
  Piece,          // mark of the signature of a piece, else 0
  Checksum,       // of the slots above and of the other arrays
  InfoSize
};

constexpr std::int64_t FormatVersion = 1;

/// Returns a number that identifies a piece, which is not 0.
std::int64_t MarkPiece(const Signature& piece)
{
  return CopyBits<std::int64_t>(piece[0]) | 1;
}

bool IsMerged(const PreparedSurface& surface)
{
  return surface.GetDomain().Kind == Domain::MergedSurface;
}

/// Returns true if a construction builds graphs of this kind.
bool IsConstructionOf(std::int64_t construction, GraphKind kind)
{
  const bool isCloud = kind == GraphKind::Cloud;
  const auto first = isCloud ? GraphConstruction::CloudCurvature : GraphConstruction::Guaranteed;
  const auto last =
    isCloud ? GraphConstruction::CloudSpacing : GraphConstruction::SaddleVertexGraph;
  return construction >= static_cast<std::int64_t>(first) &&
    construction <= static_cast<std::int64_t>(last);
}
}

const char* StoredGraph::GetName(int role)
{
  static constexpr const char* names[NumberOfRoles] = { "DGG.Offsets", "DGG.Targets", "DGG.Lengths",
    "DGG.Angles", "DGG.ArrivalAngles", "DGG.Radii", "DGG.GhostIds", "DGG.Owners", "DGG.Info" };
  return names[role];
}

bool StoredGraph::IsOfCloud(const StoredArray& info)
{
  return info.Type == StoredArray::Int64 && info.Size > Kind &&
    info.GetValues<std::int64_t>()[Kind] == static_cast<std::int64_t>(GraphKind::Cloud);
}

bool StoredGraph::IsOfPiece(const StoredArray& info)
{
  return info.Type == StoredArray::Int64 && info.Size > Piece &&
    info.GetValues<std::int64_t>()[Piece] != 0;
}

StoredGraph::StoredGraph(const GraphView& graph, const CloudBand& band)
  : View(graph)
  , Band(band)
{
}

StoredGraph::StoredGraph(
  const GraphView& graph, const GhostVertices& ghosts, const Signature& piece)
  : View(graph)
  , Ghosts(ghosts)
  , PieceMark(MarkPiece(piece))
{
}

bool StoredGraph::IsOf(const Signature& piece) const
{
  return this->PieceMark == MarkPiece(piece);
}

Buffer<std::int64_t> StoredGraph::MakeInfo(
  const PreparedSurface& surface, const ParallelFor& parallel) const
{
  const GraphInfo& graph = this->View.Info;
  Buffer<std::int64_t> info(InfoSize);
  std::fill(info.begin(), info.end(), 0);
  info[Version] = FormatVersion;
  info[Kind] = static_cast<std::int64_t>(graph.Kind);
  info[Construction] = static_cast<std::int64_t>(graph.Construction);
  info[Accuracy] = CopyBits<std::int64_t>(graph.Accuracy);
  info[NumberOfNeighbors] = graph.NumberOfNeighbors;
  info[Merged] = IsMerged(surface) ? 1 : 0;
  info[MergeTolerance] = CopyBits<std::int64_t>(surface.GetDomain().MergeTolerance);
  info[FirstSignature] = CopyBits<std::int64_t>(graph.Surface[0]);
  info[SecondSignature] = CopyBits<std::int64_t>(graph.Surface[1]);
  info[VoxelSize] = CopyBits<std::int64_t>(this->Band.VoxelSize);
  info[Piece] = this->PieceMark;
  info[Checksum] = this->ComputeChecksum(info.Data(), parallel);
  return info;
}

bool StoredGraph::HasRole(int role) const
{
  const bool isCloud = this->View.Info.Kind == GraphKind::Cloud;
  switch (role)
  {
    case Angles:
    case ArrivalAngles:
      return !isCloud;
    case Radii:
      return isCloud;
    case GhostIds:
    case Owners:
      return this->PieceMark != 0;
    default:
      return true;
  }
}

template <typename... Parts>
Status StoredGraph::Damaged(const Parts&... parts)
{
  this->Damage = JoinText(parts...);
  return Status(Status::Code::DamagedGraph, "The graph {InArrays} is damaged: " + this->Damage);
}

Status StoredGraph::Read(
  const Arrays& arrays, const PreparedSurface& surface, const ParallelFor& parallel)
{
  *this = StoredGraph();
  Status status = this->Check(arrays, surface, parallel);
  if (!status.IsOk())
  {
    this->View = GraphView();
    this->BuiltOn = Domain();
    this->Band = CloudBand();
    this->PieceMark = 0;
  }
  return status;
}

Status StoredGraph::Check(
  const Arrays& arrays, const PreparedSurface& surface, const ParallelFor& parallel)
{
  DGG_RETURN_IF_ERROR(this->CheckTypes(arrays));
  if (this->PieceMark != 0)
  {
    return InvalidInput("The graph {InArrays} is that of a piece of a surface");
  }
  if ((this->BuiltOn.Kind == Domain::Cloud) != surface.IsCloud())
  {
    return InvalidInput(
      "The graph {InArrays} is that of ", surface.IsCloud() ? "a mesh" : "a point cloud");
  }
  DGG_RETURN_IF_ERROR(
    this->ReadSizes(arrays, surface.GetMeshWithoutAngles().GetNumberOfVertices()));
  this->Refer(arrays);
  const auto* info = arrays[Info].GetValues<std::int64_t>();
  DGG_RETURN_IF_ERROR(this->CheckSurface(surface));
  return this->CheckContents(info, arrays[Targets].Size, parallel);
}

Status StoredGraph::ReadPiece(
  const Arrays& arrays, Offset numberOfPoints, const ParallelFor& parallel)
{
  *this = StoredGraph();
  DGG_RETURN_IF_ERROR(this->CheckTypes(arrays));
  if (this->PieceMark == 0)
  {
    return InvalidInput("The graph {InArrays} is that of an entire surface");
  }
  this->Ghosts = { arrays[GhostIds].GetValues<Offset>(), static_cast<Id>(arrays[GhostIds].Size),
    arrays[Owners].GetValues<Id>() };
  DGG_RETURN_IF_ERROR(this->ReadSizes(arrays, numberOfPoints + arrays[GhostIds].Size));
  this->Refer(arrays);
  return this->CheckContents(
    arrays[Info].GetValues<std::int64_t>(), arrays[Targets].Size, parallel);
}

/// Checks the types of the arrays, and reads Info.
Status StoredGraph::CheckTypes(const Arrays& arrays)
{
  this->View.Info.Kind = IsOfCloud(arrays[Info]) ? GraphKind::Cloud : GraphKind::Mesh;
  this->PieceMark = IsOfPiece(arrays[Info]) ? arrays[Info].GetValues<std::int64_t>()[Piece] : 0;
  for (int role = 0; role < NumberOfRoles; ++role)
  {
    DGG_RETURN_IF_ERROR(this->CheckType(role, arrays[role]));
  }
  return this->ReadInfo(arrays[Info]);
}

Status StoredGraph::CheckType(int role, const StoredArray& array)
{
  struct Types
  {
    StoredArray::ValueType First;
    StoredArray::ValueType Second;
    const char* Text;
  };
  static const Types expected[NumberOfRoles] = {
    { StoredArray::Int64, StoredArray::Int64, "single 64-bit integers" },
    { StoredArray::Int32, StoredArray::Int32, "single 32-bit integers" },
    { StoredArray::Float, StoredArray::Double, "single floats or doubles" },
    { StoredArray::Float, StoredArray::Float, "single floats" },
    { StoredArray::Float, StoredArray::Float, "single floats" },
    { StoredArray::Double, StoredArray::Double, "single doubles" },
    { StoredArray::Int64, StoredArray::Int64, "single 64-bit integers" },
    { StoredArray::Int32, StoredArray::Int32, "single 32-bit integers" },
    { StoredArray::Int64, StoredArray::Int64, "single 64-bit integers" },
  };
  if (!this->HasRole(role) || array.Type == expected[role].First ||
    array.Type == expected[role].Second)
  {
    return Status::Success();
  }
  return array.Type == StoredArray::Missing
    ? this->Damaged("the field array ", GetName(role), " is missing")
    : this->Damaged("the field array ", GetName(role), " has the type ", array.Description,
        " (expected ", expected[role].Text, ")");
}

Status StoredGraph::ReadInfo(const StoredArray& array)
{
  DGG_RETURN_IF_ERROR(this->CheckType(Info, array));
  const auto* info = array.GetValues<std::int64_t>();
  if (array.Size >= 1 && info[Version] != FormatVersion)
  {
    return InvalidInput("The graph {InArrays} has the format version ", info[Version],
      ", but this version of vtkDGG reads version ", FormatVersion);
  }
  if (array.Size != InfoSize)
  {
    return this->Damaged("DGG.Info has ", Counted(array.Size, "value"), " (expected ",
      static_cast<int>(InfoSize), ")");
  }
  GraphInfo& graph = this->View.Info;
  graph.Kind = IsOfCloud(array) ? GraphKind::Cloud : GraphKind::Mesh;
  const bool isCloud = graph.Kind == GraphKind::Cloud;
  graph.Accuracy = CopyBits<double>(info[Accuracy]);
  graph.NumberOfNeighbors = static_cast<Id>(info[NumberOfNeighbors]);
  graph.Surface = { { CopyBits<std::uint64_t>(info[FirstSignature]),
    CopyBits<std::uint64_t>(info[SecondSignature]) } };
  if (info[Kind] != static_cast<std::int64_t>(graph.Kind))
  {
    return this->Damaged("its kind is ", info[Kind]);
  }
  if (!IsConstructionOf(info[Construction], graph.Kind))
  {
    return this->Damaged("its construction is ", info[Construction]);
  }
  graph.Construction = static_cast<GraphConstruction>(info[Construction]);
  if (!isCloud && !GraphBuilder::Check(MakeOptions(graph)).IsOk())
  {
    return graph.Construction == GraphConstruction::SaddleVertexGraph
      ? this->Damaged("its number of neighbors is ", graph.NumberOfNeighbors)
      : this->Damaged("its accuracy is ", graph.Accuracy);
  }
  this->BuiltOn.Kind = isCloud ? Domain::Cloud
    : info[Merged] != 0        ? Domain::MergedSurface
                               : Domain::Surface;
  this->BuiltOn.MergeTolerance = CopyBits<double>(info[MergeTolerance]);
  if (!(this->BuiltOn.MergeTolerance >= 0.0))
  {
    return this->Damaged("its merge tolerance is ", this->BuiltOn.MergeTolerance);
  }
  return Status::Success();
}

Status StoredGraph::ReadSizes(const Arrays& arrays, Offset numberOfPoints)
{
  const Offset edges = arrays[Targets].Size;
  for (const Role role : { Lengths, Angles, ArrivalAngles })
  {
    if (this->HasRole(role) && arrays[role].Size != edges)
    {
      return this->Damaged(GetName(role), " has ", Counted(arrays[role].Size, "value"),
        ", but DGG.Targets has ", edges);
    }
  }
  if (arrays[Offsets].Size != numberOfPoints + 1)
  {
    return InvalidInput("The graph {InArrays} does not fit: DGG.Offsets has ",
      Counted(arrays[Offsets].Size, "value"), ", but ", numberOfPoints, " points need ",
      numberOfPoints + 1);
  }
  for (const Role role : { Radii, Owners })
  {
    if (this->HasRole(role) && arrays[role].Size != numberOfPoints)
    {
      return this->Damaged(GetName(role), " has ", Counted(arrays[role].Size, "value"), ", but ",
        numberOfPoints, " are needed");
    }
  }
  this->View.NumberOfVertices = static_cast<Id>(numberOfPoints);
  return Status::Success();
}

void StoredGraph::Refer(const Arrays& arrays)
{
  this->View.Offsets = arrays[Offsets].GetValues<Offset>();
  this->View.Targets = arrays[Targets].GetValues<Id>();
  if (arrays[Lengths].Type == StoredArray::Float)
  {
    this->View.Lengths = arrays[Lengths].GetValues<float>();
  }
  else
  {
    this->View.WideLengths = arrays[Lengths].GetValues<double>();
  }
  if (this->View.Info.Kind == GraphKind::Mesh)
  {
    this->View.Angles = arrays[Angles].GetValues<float>();
    this->View.ArrivalAngles = arrays[ArrivalAngles].GetValues<float>();
  }
  else
  {
    this->Band = { CopyBits<double>(arrays[Info].GetValues<std::int64_t>()[VoxelSize]),
      arrays[Radii].GetValues<double>() };
  }
}

Status StoredGraph::CheckSurface(const PreparedSurface& surface) const
{
  if (this->View.Info.Surface == surface.GetSignature())
  {
    return Status::Success();
  }
  const bool wasMerged = this->BuiltOn.Kind == Domain::MergedSurface;
  if (wasMerged != IsMerged(surface))
  {
    return InvalidInput("The graph {InArrays} was built with {MergeCoincidentPoints} ",
      wasMerged ? "on, but the surface has it off" : "off, but the surface has it on")
      .At("MergeCoincidentPoints");
  }
  const double tolerance = this->BuiltOn.MergeTolerance;
  if (tolerance != surface.GetDomain().MergeTolerance)
  {
    return InvalidInput("The graph {InArrays} was built with a {MergeTolerance} of ", tolerance,
      ", but the surface has ", surface.GetDomain().MergeTolerance)
      .At("MergeTolerance");
  }
  return InvalidInput("The graph {InArrays} is out of date: ",
    surface.IsCloud() ? "points" : "points or cells", " have changed since it was built");
}

Status StoredGraph::CheckContents(
  const std::int64_t* info, Offset edges, const ParallelFor& parallel)
{
  const Status status = CheckGraph(this->View, edges, parallel);
  if (!status.IsOk())
  {
    this->Damage = status.GetProblem();
    return status.Of("The graph {InArrays} is damaged");
  }
  if (info[Checksum] != this->ComputeChecksum(info, parallel))
  {
    return this->Damaged(
      "its checksum is wrong. A text file that rounds values may have altered them");
  }
  return this->View.Info.Kind == GraphKind::Cloud ? this->CheckBand() : Status::Success();
}

/// Returns the checksum of all arrays and of the slots of Info before the checksum. Offsets must be
/// valid.
std::int64_t StoredGraph::ComputeChecksum(
  const std::int64_t* info, const ParallelFor& parallel) const
{
  const std::uint64_t arrays = dgg::ComputeChecksum(this->View, parallel);
  BitHash hash;
  hash.Add(info, Checksum);
  hash.Add(&arrays, 1);
  if (this->View.Info.Kind == GraphKind::Cloud)
  {
    hash.Add(this->Band.Radii, static_cast<std::size_t>(this->View.NumberOfVertices));
  }
  if (this->PieceMark != 0)
  {
    hash.Add(this->Ghosts.Ids, static_cast<std::size_t>(this->Ghosts.Count));
    hash.Add(this->Ghosts.Owners, static_cast<std::size_t>(this->View.NumberOfVertices));
  }
  return CopyBits<std::int64_t>(hash.Finish()[0]);
}

Status StoredGraph::CheckBand()
{
  bool hasBalls = false;
  for (Id v = 0; v < this->View.NumberOfVertices; ++v)
  {
    const double radius = this->Band.Radii[v];
    if (!(radius >= 0.0 && radius < Infinity))
    {
      return this->Damaged("the radius of point ", v, " in DGG.Radii is ", radius);
    }
    hasBalls = hasBalls || radius > 0.0;
  }
  // A cloud without a finite point has neither balls nor voxels.
  const double size = this->Band.VoxelSize;
  if (!(size > 0.0 && size < Infinity) && (hasBalls || size != 0.0))
  {
    return this->Damaged("the size of its voxels is ", size);
  }
  return Status::Success();
}

GraphSummary::GraphSummary(const GraphView& graph)
  : Info(graph.Info)
  , NumberOfVertices(graph.NumberOfVertices)
  , NumberOfEdges(graph.GetNumberOfEdges())
{
  const std::size_t perEdge = sizeof(Id) + (graph.Lengths ? sizeof(float) : sizeof(double)) +
    (graph.Angles ? 2 * sizeof(float) : 0);
  this->MemorySize = static_cast<std::size_t>(this->NumberOfEdges) * perEdge +
    (static_cast<std::size_t>(this->NumberOfVertices) + 1) * sizeof(Offset);
}
}
