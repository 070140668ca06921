// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggStoredWindows.h"

#include "dggBitHash.h"
#include "dggOutput.h"
#include "dggPreparedSurface.h"
#include "dggStatus.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace dgg
{
namespace
{
constexpr std::int64_t FormatVersion = 2;
constexpr std::size_t InfoSize = 5;
constexpr std::size_t TableHash = 4; // index of the hash of the windows
constexpr std::size_t RowSize = StoredWindows::NumberOfComponents;

using InfoValues = std::array<std::int64_t, InfoSize>;
using Row = std::array<double, RowSize>;

template <typename Value>
StoredArray Refer(const Buffer<Value>& buffer)
{
  StoredArray array;
  array.Data = buffer.Data();
  array.Size = static_cast<Offset>(buffer.Size());
  return array;
}

template <typename Value>
void Add(BitHash& hash, const StoredArray& array)
{
  hash.Add(array.GetValues<Value>(), static_cast<std::size_t>(array.Size));
}

/// Returns the values of WindowInfo: format version, signature of the surface, hashes of distances
/// and windows.
InfoValues MakeInfo(const StoredWindows::Arrays& arrays, const double* distances,
  std::size_t numberOfDistances, const PreparedSurface& surface)
{
  BitHash ofDistances;
  ofDistances.Add(distances, numberOfDistances);
  BitHash ofTables;
  Add<std::int64_t>(ofTables, arrays[StoredWindows::OffsetsRole]);
  Add<double>(ofTables, arrays[StoredWindows::WindowsRole]);
  Add<double>(ofTables, arrays[StoredWindows::SourcesRole]);
  return { { FormatVersion, CopyBits<std::int64_t>(surface.GetSignature()[0]),
    CopyBits<std::int64_t>(surface.GetSignature()[1]),
    CopyBits<std::int64_t>(ofDistances.Finish()[0]),
    CopyBits<std::int64_t>(ofTables.Finish()[0]) } };
}

/// Writes a row per element.
template <typename Element, typename RowOf>
Buffer<double> MakeTable(const std::vector<Element>& elements, const RowOf& rowOf)
{
  Buffer<double> table(elements.size() * RowSize);
  double* next = table.Data();
  for (const Element& element : elements)
  {
    const Row row = rowOf(element);
    next = std::copy(row.begin(), row.end(), next);
  }
  return table;
}

/// Reads an element from each row.
template <typename Element, typename ElementOf>
void ReadTable(const StoredArray& table, std::vector<Element>& elements, const ElementOf& elementOf)
{
  elements.resize(static_cast<std::size_t>(table.Size) / RowSize);
  const double* row = table.GetValues<double>();
  for (Element& element : elements)
  {
    element = elementOf(row);
    row += RowSize;
  }
}

FaceSource ReadSource(const double* row)
{
  // A value that is not an id must not be converted to an id.
  const bool isId = row[0] >= 0.0 && row[0] < std::numeric_limits<Id>::max();
  return { isId ? static_cast<Id>(row[0]) : NoId, { { row[1], row[2], row[3] } }, row[4], NoId };
}

void ReadTables(const StoredWindows::Arrays& arrays, EdgeWindows& windows)
{
  const StoredArray& offsets = arrays[StoredWindows::OffsetsRole];
  const auto* first = offsets.GetValues<std::int64_t>();
  windows.Offsets.assign(first, first + offsets.Size);
  ReadTable(arrays[StoredWindows::WindowsRole], windows.Windows, [](const double* row) {
    return EdgeWindow{ row[0], row[1], { row[2], row[3] }, row[4], NoId };
  });
  ReadTable(arrays[StoredWindows::SourcesRole], windows.Sources, ReadSource);
}
}

std::string StoredWindows::GetName(const std::string& distances, int role)
{
  static constexpr const char* suffixes[NumberOfRoles] = { ".WindowOffsets", ".Windows",
    ".WindowSources", ".WindowInfo" };
  return distances + suffixes[role];
}

StoredWindows::StoredWindows(const EdgeWindows& windows, const double* distances,
  std::size_t numberOfDistances, const PreparedSurface& surface)
  : Offsets(windows.Offsets.size())
  , Info(InfoSize)
{
  std::copy(windows.Offsets.begin(), windows.Offsets.end(), this->Offsets.begin());
  this->Windows = MakeTable(windows.Windows, [](const EdgeWindow& w) {
    return Row{ { w.Begin, w.End, w.Image.X, w.Image.Y, w.Offset } };
  });
  this->Sources = MakeTable(windows.Sources, [](const FaceSource& s) {
    return Row{ { static_cast<double>(s.Face), s.Barycentric[0], s.Barycentric[1], s.Barycentric[2],
      s.Offset } };
  });
  const InfoValues info =
    MakeInfo({ { Refer(this->Offsets), Refer(this->Windows), Refer(this->Sources), {} } },
      distances, numberOfDistances, surface);
  std::copy(info.begin(), info.end(), this->Info.begin());
}

Status StoredWindows::Read(const Arrays& arrays, const std::string& name, const double* distances,
  std::size_t numberOfDistances, const PreparedSurface& surface, EdgeWindows& windows)
{
  windows = EdgeWindows();
  const std::string subject = "The windows of '" + name + "' in the field data ";
  const bool hasInfo = arrays[InfoRole].Type == StoredArray::Int64 && arrays[InfoRole].Size > 0;
  const auto* info = arrays[InfoRole].GetValues<std::int64_t>();
  if (hasInfo && *info != FormatVersion)
  {
    return InvalidInput(subject, "have the format version ", *info,
      ", but this version of vtkDGG reads version ", FormatVersion);
  }
  if (!hasInfo || arrays[InfoRole].Size != static_cast<Offset>(InfoSize) ||
    arrays[OffsetsRole].Type != StoredArray::Int64 || arrays[OffsetsRole].Size == 0 ||
    arrays[WindowsRole].Type != StoredArray::Double ||
    arrays[SourcesRole].Type != StoredArray::Double)
  {
    return InvalidInput(subject, "are damaged: an array is missing or has another type");
  }
  const InfoValues expected = MakeInfo(arrays, distances, numberOfDistances, surface);
  if (!std::equal(expected.begin(), expected.begin() + TableHash, info))
  {
    return InvalidInput(subject, "do not belong to these distances on this surface");
  }
  if (expected[TableHash] != info[TableHash])
  {
    return InvalidInput(subject, "are damaged: they have changed since they were written");
  }
  ReadTables(arrays, windows);
  const Status status = windows.Check(surface.GetMesh());
  if (!status.IsOk())
  {
    windows = EdgeWindows();
  }
  return status.Of(subject + "are damaged");
}

//------------------------------------------------------------------------------
void StoredWindows::AddTo(const std::string& name, OutputArrays& arrays)
{
  const auto add = [&](int role, int components, auto& values) {
    arrays.push_back({ GetName(name, role), components, std::move(values) });
  };
  add(OffsetsRole, 1, this->Offsets);
  add(WindowsRole, NumberOfComponents, this->Windows);
  add(SourcesRole, NumberOfComponents, this->Sources);
  add(InfoRole, 1, this->Info);
}
}
