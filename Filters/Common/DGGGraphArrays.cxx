// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DGGGraphArrays.h"

#include "DGGIsInteger.h"
#include "DGGMakeArray.h"
#include "DGGThreads.h"

#include "dggBitHash.h"
#include "dggBuffer.h"
#include "dggInvalidInput.h"
#include "dggPreparedSurface.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"

#include <algorithm>
#include <cstring>

namespace
{
/// Where things are in DGG.Info.
enum InfoSlot
{
  Version,
  Kind,
  Construction,
  Accuracy, // the bits of the double
  NumberOfNeighbors,
  Merged, // coincident points are one
  FirstSignature,
  SecondSignature,
  VoxelSize,      // of the band of a cloud, the bits of the double
  MergeTolerance, // the bits of the double
  Reserved,
  Checksum, // of all of the above and of the other arrays
  InfoSize
};

constexpr std::int64_t FormatVersion = 1;

template <typename To, typename From>
To CopyBits(From from)
{
  static_assert(sizeof(To) == sizeof(From), "not the same bits");
  To to;
  std::memcpy(&to, &from, sizeof(to));
  return to;
}

/// Whether DGG.Info, which may be missing or anything, is that of a cloud.
bool SaysCloud(vtkAbstractArray* info)
{
  const bool isReadable = info && DGGIsInteger(info, 8) && info->HasStandardMemoryLayout() &&
    info->GetNumberOfValues() > Kind;
  return isReadable &&
    static_cast<const std::int64_t*>(info->GetVoidPointer(0))[Kind] ==
    static_cast<std::int64_t>(dgg::GraphKind::Cloud);
}

/// The constructions that a kind of graph has.
bool IsConstructionOf(std::int64_t construction, dgg::GraphKind kind)
{
  using Construction = dgg::GraphConstruction;
  const bool isCloud = kind == dgg::GraphKind::Cloud;
  const auto first = isCloud ? Construction::CloudCurvature : Construction::Guaranteed;
  const auto last = isCloud ? Construction::CloudSpacing : Construction::SaddleVertexGraph;
  return construction >= static_cast<std::int64_t>(first) &&
    construction <= static_cast<std::int64_t>(last);
}
}

const std::array<const char*, DGGGraphArrays::NumberOfRoles> DGGGraphArrays::Names = { {
  "DGG.Offsets",
  "DGG.Targets",
  "DGG.Lengths",
  "DGG.Angles",
  "DGG.ArrivalAngles",
  "DGG.Radii",
  "DGG.Info",
} };

//------------------------------------------------------------------------------
bool DGGGraphArrays::Entry::operator==(const Entry& other) const
{
  return this->Array == other.Array && this->Time == other.Time && this->Data == other.Data &&
    this->Size == other.Size;
}

//------------------------------------------------------------------------------
DGGGraphArrays::Entry DGGGraphArrays::MakeEntry(vtkAbstractArray* array)
{
  Entry entry;
  if (array)
  {
    entry.Array = array;
    entry.Time = array->GetMTime();
    // Anything else would be copied by this, and is refused anyway.
    entry.Data = array->HasStandardMemoryLayout() ? array->GetVoidPointer(0) : nullptr;
    entry.Size = array->GetNumberOfValues();
  }
  return entry;
}

//------------------------------------------------------------------------------
DGGGraphArrays::Entries DGGGraphArrays::MakeEntries(vtkFieldData* data)
{
  Entries entries;
  for (int role = 0; data && role < NumberOfRoles; ++role)
  {
    entries[role] = MakeEntry(data->GetAbstractArray(Names[role]));
  }
  return entries;
}

//------------------------------------------------------------------------------
void DGGGraphArrays::Clear()
{
  *this = DGGGraphArrays();
}

//------------------------------------------------------------------------------
void DGGGraphArrays::Adopt(dgg::GeodesicGraph& graph, const dgg::PreparedSurface& mesh)
{
  this->Adopt(graph, {}, 0.0, mesh);
}

//------------------------------------------------------------------------------
void DGGGraphArrays::Adopt(dgg::GeodesicGraph& graph, const std::vector<double>& radii,
  double voxelSize, const dgg::PreparedSurface& mesh)
{
  this->Clear();
  dgg::Buffer<double> ownRadii(radii.size());
  std::copy(radii.begin(), radii.end(), ownRadii.begin());
  this->View = graph.View(); // memory keeps its place
  this->Band = { voxelSize, ownRadii.Data() };
  vtkNew<vtkTypeInt64Array> info;
  info->SetName(Names[Info]);
  info->SetNumberOfValues(InfoSize);
  auto* slots = reinterpret_cast<std::int64_t*>(info->GetPointer(0));
  std::fill(slots, slots + InfoSize, 0);
  slots[Version] = FormatVersion;
  slots[Kind] = static_cast<std::int64_t>(graph.Info.Kind);
  slots[Construction] = static_cast<std::int64_t>(graph.Info.Construction);
  slots[Accuracy] = CopyBits<std::int64_t>(graph.Info.Accuracy);
  slots[NumberOfNeighbors] = graph.Info.NumberOfNeighbors;
  slots[Merged] = mesh.GetDomain().Kind == dgg::Domain::MergedSurface ? 1 : 0;
  slots[MergeTolerance] = CopyBits<std::int64_t>(mesh.GetDomain().MergeTolerance);
  slots[FirstSignature] = CopyBits<std::int64_t>(graph.Info.Surface[0]);
  slots[SecondSignature] = CopyBits<std::int64_t>(graph.Info.Surface[1]);
  slots[VoxelSize] = CopyBits<std::int64_t>(voxelSize);

  vtkSmartPointer<vtkAbstractArray> lengths =
    DGGAdoptArray<vtkFloatArray>(graph.Lengths, Names[Lengths]);
  if (this->View.WideLengths)
  {
    lengths = DGGAdoptArray<vtkDoubleArray>(graph.WideLengths, Names[Lengths]);
  }
  std::array<vtkSmartPointer<vtkAbstractArray>, NumberOfRoles> arrays = { {
    DGGAdoptArray<vtkTypeInt64Array>(graph.Offsets, Names[Offsets]),
    DGGAdoptArray<vtkTypeInt32Array>(graph.Targets, Names[Targets]),
    lengths,
    DGGAdoptArray<vtkFloatArray>(graph.Angles, Names[Angles]),
    DGGAdoptArray<vtkFloatArray>(graph.ArrivalAngles, Names[ArrivalAngles]),
    DGGAdoptArray<vtkDoubleArray>(ownRadii, Names[Radii]),
    info.Get(),
  } };
  for (int i = 0; i < NumberOfRoles; ++i)
  {
    const auto role = static_cast<Role>(i);
    if (this->HasRole(role))
    {
      this->Arrays[role] = MakeEntry(arrays[role]);
    }
  }
  slots[Checksum] = this->Seal();
  this->Mesh = mesh.GetBuildNumber();
  this->IsGraph = true;
  this->Time.Modified();
}

//------------------------------------------------------------------------------
void DGGGraphArrays::AddTo(vtkFieldData* data) const
{
  RemoveFrom(data); // a graph of the other kind has arrays that this one has not
  for (const Entry& entry : this->Arrays)
  {
    if (entry.Array)
    {
      data->AddArray(entry.Array);
    }
  }
}

//------------------------------------------------------------------------------
bool DGGGraphArrays::AreOfCloud(vtkFieldData* data)
{
  return data && SaysCloud(data->GetAbstractArray(Names[Info]));
}

//------------------------------------------------------------------------------
/// Whether graphs of this kind have such an array.
bool DGGGraphArrays::HasRole(Role role) const
{
  const bool isCloud = this->View.Info.Kind == dgg::GraphKind::Cloud;
  switch (role)
  {
    case Angles:
    case ArrivalAngles:
      return !isCloud;
    case Radii:
      return isCloud;
    default:
      return true;
  }
}

//------------------------------------------------------------------------------
void DGGGraphArrays::RemoveFrom(vtkFieldData* data)
{
  for (const char* name : Names)
  {
    data->RemoveArray(name);
  }
}

//------------------------------------------------------------------------------
bool DGGGraphArrays::IsValid() const
{
  bool valid = this->IsGraph;
  for (const Entry& entry : this->Arrays)
  {
    valid = valid && MakeEntry(entry.Array) == entry;
  }
  return valid;
}

//------------------------------------------------------------------------------
DGGGraphArrays::Key DGGGraphArrays::GetKey() const
{
  Key key;
  for (const Entry& entry : this->Arrays)
  {
    key.push_back(reinterpret_cast<std::uintptr_t>(entry.Array.Get()));
    key.push_back(static_cast<std::uintptr_t>(entry.Time));
    key.push_back(reinterpret_cast<std::uintptr_t>(entry.Data));
    key.push_back(static_cast<std::uintptr_t>(entry.Size));
  }
  return key;
}

//------------------------------------------------------------------------------
bool DGGGraphArrays::Find(
  vtkFieldData* data, const dgg::PreparedSurface& mesh, std::string& complaint)
{
  complaint.clear();
  if (this->IsSame(data, mesh))
  {
    return this->IsGraph;
  }
  this->Clear();
  this->Arrays = MakeEntries(data);
  if (this->Arrays == Entries())
  {
    this->Mesh = mesh.GetBuildNumber();
    return false;
  }
  const dgg::Status status = this->Check(mesh);
  // Only now: when the check throws, it has to be made again.
  this->Mesh = mesh.GetBuildNumber();
  this->IsGraph = status.IsOk();
  this->Time.Modified();
  if (!this->IsGraph)
  {
    this->View = dgg::GraphView();
    this->Band = DGGCloudBand();
    complaint = "the graph on the input " + status.GetMessage();
  }
  return this->IsGraph;
}

//------------------------------------------------------------------------------
bool DGGGraphArrays::IsSame(vtkFieldData* data, const dgg::PreparedSurface& mesh) const
{
  return this->Mesh == mesh.GetBuildNumber() && this->Arrays == MakeEntries(data);
}

//------------------------------------------------------------------------------
dgg::Status DGGGraphArrays::Damaged(const std::string& what)
{
  this->Damage = what;
  return dgg::Status::Invalid("is damaged: " + what);
}

//------------------------------------------------------------------------------
dgg::Status DGGGraphArrays::Check(const dgg::PreparedSurface& mesh)
{
  this->View.Info.Kind =
    SaysCloud(this->Arrays[Info].Array) ? dgg::GraphKind::Cloud : dgg::GraphKind::Mesh;
  DGG_RETURN_IF_ERROR(this->CheckTypes());
  DGG_RETURN_IF_ERROR(this->ReadInfo(mesh.GetMesh().GetNumberOfVertices(), mesh.IsCloud()));
  DGG_RETURN_IF_ERROR(this->CheckSurface(mesh));
  return this->CheckContents();
}

//------------------------------------------------------------------------------
dgg::Status DGGGraphArrays::CheckTypes()
{
  const char* const wanted[NumberOfRoles] = { "single 64-bit integers", "single 32-bit integers",
    "single floats or doubles", "single floats", "single floats", "single doubles",
    "single 64-bit integers" };
  for (int i = 0; i < NumberOfRoles; ++i)
  {
    const auto role = static_cast<Role>(i);
    vtkAbstractArray* array = this->Arrays[role].Array;
    if (!this->HasRole(role))
    {
      continue;
    }
    if (!array)
    {
      return Damaged(std::string("the field array ") + Names[role] + " is missing");
    }
    const int type = array->GetDataType();
    const bool isFloat = type == VTK_FLOAT && role != Radii;
    const bool isDouble = type == VTK_DOUBLE && (role == Lengths || role == Radii);
    const int bytes = role == Targets ? 4 : 8;
    const bool isInteger = role == Offsets || role == Targets || role == Info;
    const bool fits = isInteger ? DGGIsInteger(array, bytes) : isFloat || isDouble;
    if (!fits || !array->HasStandardMemoryLayout() || array->GetNumberOfComponents() != 1)
    {
      return Damaged(std::string("the field array ") + Names[role] + " is of type " +
        array->GetDataTypeAsString() + " with " + std::to_string(array->GetNumberOfComponents()) +
        " components, not of " + wanted[role]);
    }
  }
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
template <typename ValueType>
const ValueType* DGGGraphArrays::GetValues(Role role) const
{
  return static_cast<const ValueType*>(this->Arrays[role].Data);
}

//------------------------------------------------------------------------------
dgg::Status DGGGraphArrays::ReadInfo(vtkIdType numberOfPoints, bool isCloud)
{
  const std::int64_t* info = this->GetValues<std::int64_t>(Info);
  const vtkIdType infoSize = this->Arrays[Info].Size;
  if (infoSize >= 1 && info[Version] != FormatVersion)
  {
    return dgg::Status::Invalid("has the format version " + std::to_string(info[Version]) +
      ", but this version of vtkDGG knows " + std::to_string(FormatVersion) + " only");
  }
  if (infoSize != InfoSize)
  {
    return Damaged("DGG.Info has " + std::to_string(infoSize) + " values, not " +
      std::to_string(static_cast<int>(InfoSize)));
  }
  this->View.Info.Accuracy = CopyBits<double>(info[Accuracy]);
  this->View.Info.NumberOfNeighbors = static_cast<dgg::Id>(info[NumberOfNeighbors]);
  this->View.Info.Surface = { { CopyBits<std::uint64_t>(info[FirstSignature]),
    CopyBits<std::uint64_t>(info[SecondSignature]) } };
  const dgg::GraphKind kind = this->View.Info.Kind;
  if (info[Kind] != static_cast<std::int64_t>(kind))
  {
    return Damaged("its kind is " + std::to_string(info[Kind]));
  }
  if (kind != (isCloud ? dgg::GraphKind::Cloud : dgg::GraphKind::Mesh))
  {
    return dgg::Status::Invalid(isCloud ? "is that of a mesh, not of a point cloud"
                                        : "is that of a point cloud, not of a mesh");
  }
  if (!IsConstructionOf(info[Construction], kind))
  {
    return Damaged("its construction is " + std::to_string(info[Construction]));
  }
  this->View.Info.Construction = static_cast<dgg::GraphConstruction>(info[Construction]);
  return this->ReadSizes(numberOfPoints);
}

//------------------------------------------------------------------------------
dgg::Status DGGGraphArrays::ReadSizes(vtkIdType numberOfPoints)
{
  const vtkIdType edges = this->Arrays[Targets].Size;
  for (const Role role : { Lengths, Angles, ArrivalAngles })
  {
    if (this->HasRole(role) && this->Arrays[role].Size != edges)
    {
      return Damaged(std::string(Names[role]) + " has " + std::to_string(this->Arrays[role].Size) +
        " values, but DGG.Targets has " + std::to_string(edges));
    }
  }
  if (this->Arrays[Offsets].Size != numberOfPoints + 1)
  {
    return dgg::Status::Invalid("does not fit: DGG.Offsets has " +
      std::to_string(this->Arrays[Offsets].Size) + " values, not one more than the " +
      std::to_string(numberOfPoints) + " points");
  }
  if (this->HasRole(Radii) && this->Arrays[Radii].Size != numberOfPoints)
  {
    return Damaged("DGG.Radii has " + std::to_string(this->Arrays[Radii].Size) +
      " values, but there are " + std::to_string(numberOfPoints) + " points");
  }
  this->View.NumberOfVertices = static_cast<dgg::Id>(numberOfPoints);
  this->View.Offsets = this->GetValues<dgg::Offset>(Offsets);
  this->View.Targets = this->GetValues<dgg::Id>(Targets);
  if (this->Arrays[Lengths].Array->GetDataType() == VTK_FLOAT)
  {
    this->View.Lengths = this->GetValues<float>(Lengths);
  }
  else
  {
    this->View.WideLengths = this->GetValues<double>(Lengths);
  }
  if (this->HasRole(Angles))
  {
    this->View.Angles = this->GetValues<float>(Angles);
    this->View.ArrivalAngles = this->GetValues<float>(ArrivalAngles);
  }
  else
  {
    const std::int64_t* info = this->GetValues<std::int64_t>(Info);
    this->Band = { CopyBits<double>(info[VoxelSize]), this->GetValues<double>(Radii) };
  }
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
dgg::Status DGGGraphArrays::CheckSurface(const dgg::PreparedSurface& mesh) const
{
  if (this->View.Info.Surface == mesh.GetSignature())
  {
    return dgg::Status::Success();
  }
  const std::int64_t* info = this->GetValues<std::int64_t>(Info);
  const bool merged = info[Merged] != 0;
  if (merged != (mesh.GetDomain().Kind == dgg::Domain::MergedSurface))
  {
    return dgg::Status::Invalid(std::string("was built with MergeCoincidentPoints ") +
      (merged ? "on, but it is off here" : "off, but it is on here"));
  }
  const double tolerance = CopyBits<double>(info[MergeTolerance]);
  if (tolerance != mesh.GetDomain().MergeTolerance)
  {
    return dgg::InvalidInput("was built with a MergeTolerance of ", tolerance, ", but it is ",
      mesh.GetDomain().MergeTolerance, " here");
  }
  return dgg::Status::Invalid(std::string("is out of date: ") +
    (mesh.IsCloud() ? "points" : "points or cells") + " have changed since it was built");
}

//------------------------------------------------------------------------------
dgg::Status DGGGraphArrays::CheckContents()
{
  const dgg::Status status =
    dgg::CheckGraph(this->View, this->Arrays[Targets].Size, DGGMakeParallelFor());
  if (!status.IsOk())
  {
    this->Damage = status.GetMessage();
    return dgg::Status::Invalid("is " + status.GetMessage());
  }
  if (this->GetValues<std::int64_t>(Info)[Checksum] != this->Seal())
  {
    return Damaged(
      "its checksum is wrong, so values have been altered, as by a text file that rounds them");
  }
  return this->HasRole(Radii) ? this->CheckBand() : dgg::Status::Success();
}

//------------------------------------------------------------------------------
/// A sum of all that has been read. Only for a graph that has been checked.
std::int64_t DGGGraphArrays::Seal() const
{
  const std::uint64_t arrays = dgg::ComputeChecksum(this->View, DGGMakeParallelFor());
  dgg::BitHash hash;
  hash.Add(this->GetValues<std::int64_t>(Info), Checksum);
  hash.Add(&arrays, 1);
  if (this->HasRole(Radii))
  {
    hash.Add(this->Band.Radii, static_cast<std::size_t>(this->View.NumberOfVertices));
  }
  return CopyBits<std::int64_t>(hash.Finish()[0]);
}

//------------------------------------------------------------------------------
dgg::Status DGGGraphArrays::CheckBand()
{
  bool hasBalls = false;
  for (dgg::Id v = 0; v < this->View.NumberOfVertices; ++v)
  {
    const double radius = this->Band.Radii[v];
    if (!(radius >= 0.0 && radius < dgg::Infinity))
    {
      return Damaged(
        "DGG.Radii gives point " + std::to_string(v) + " the radius " + std::to_string(radius));
    }
    hasBalls = hasBalls || radius > 0.0;
  }
  // Where no point is finite there are neither balls nor voxels.
  const double size = this->Band.VoxelSize;
  if (!(size > 0.0 && size < dgg::Infinity) && (hasBalls || size != 0.0))
  {
    return Damaged("its voxels have the size " + std::to_string(size));
  }
  return dgg::Status::Success();
}
