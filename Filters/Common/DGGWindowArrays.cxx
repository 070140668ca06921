// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DGGWindowArrays.h"

#include "DGGIsInteger.h"

#include "dggBitHash.h"
#include "dggPreparedSurface.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkTypeInt64Array.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <vector>

namespace
{
constexpr std::int64_t FormatVersion = 2;
constexpr int NumberOfComponents = 5; // windows and sources
constexpr int InfoSize = 5;
constexpr int TableHash = 4; // index of the hash of the windows
const std::array<const char*, 4> Suffixes = { { ".WindowOffsets", ".Windows", ".WindowSources",
  ".WindowInfo" } };

enum Role
{
  Offsets,
  Windows,
  Sources,
  Info
};

std::string NameOf(const std::string& distances, Role role)
{
  return distances + Suffixes[role];
}

std::int64_t Signed(std::uint64_t bits)
{
  std::int64_t value = 0;
  std::memcpy(&value, &bits, sizeof(value));
  return value;
}

vtkSmartPointer<vtkDoubleArray> MakeTable(const std::string& name, std::size_t size)
{
  auto table = vtkSmartPointer<vtkDoubleArray>::New();
  table->SetName(name.c_str());
  table->SetNumberOfComponents(NumberOfComponents);
  table->SetNumberOfTuples(static_cast<vtkIdType>(size));
  return table;
}

/// Values of a one-component array of 64-bit integers of any of VTK's types.
struct Integers
{
  const std::int64_t* Begin = nullptr; // null if there is no such array
  const std::int64_t* End = nullptr;
};

Integers FindIntegers(vtkAbstractArray* array)
{
  if (!array || !DGGIsInteger(array, sizeof(std::int64_t)) || !array->HasStandardMemoryLayout() ||
    array->GetNumberOfComponents() != 1 || array->GetNumberOfValues() == 0)
  {
    return Integers();
  }
  const auto* values = static_cast<const std::int64_t*>(array->GetVoidPointer(0));
  return { values, values + array->GetNumberOfValues() };
}

vtkDoubleArray* FindTable(vtkAbstractArray* found)
{
  auto* array = vtkDoubleArray::SafeDownCast(found);
  return array && array->GetNumberOfComponents() == NumberOfComponents ? array : nullptr;
}

/// The three arrays with windows as found in field data.
struct Tables
{
  Integers Offsets;
  vtkDoubleArray* Windows = nullptr;
  vtkDoubleArray* Sources = nullptr;
};

void Add(dgg::BitHash& hash, vtkDoubleArray* array)
{
  hash.Add(array->GetPointer(0), static_cast<std::size_t>(array->GetNumberOfValues()));
}

/// Returns the values of WindowInfo: version, signature of the surface, hashes of distances and
/// windows.
std::array<std::int64_t, InfoSize> MakeInfo(
  vtkDoubleArray* distances, const dgg::PreparedSurface& mesh, const Tables& tables)
{
  dgg::BitHash ofDistances;
  Add(ofDistances, distances);
  dgg::BitHash ofTables;
  ofTables.Add(
    tables.Offsets.Begin, static_cast<std::size_t>(tables.Offsets.End - tables.Offsets.Begin));
  Add(ofTables, tables.Windows);
  Add(ofTables, tables.Sources);
  return { { FormatVersion, Signed(mesh.GetSignature()[0]), Signed(mesh.GetSignature()[1]),
    Signed(ofDistances.Finish()[0]), Signed(ofTables.Finish()[0]) } };
}

void ReadTables(const Tables& tables, dgg::EdgeWindows& found)
{
  found.Offsets.assign(tables.Offsets.Begin, tables.Offsets.End);
  found.Windows.resize(static_cast<std::size_t>(tables.Windows->GetNumberOfTuples()));
  const double* row = tables.Windows->GetPointer(0);
  for (dgg::EdgeWindow& w : found.Windows)
  {
    w = { row[0], row[1], { row[2], row[3] }, row[4], dgg::NoId };
    row += NumberOfComponents;
  }
  found.Sources.resize(static_cast<std::size_t>(tables.Sources->GetNumberOfTuples()));
  row = tables.Sources->GetPointer(0);
  for (dgg::FaceSource& s : found.Sources)
  {
    // A value that is not an id must not be converted to an id.
    const bool isId = row[0] >= 0.0 && row[0] < 2147483647.0;
    s = { isId ? static_cast<dgg::Id>(row[0]) : dgg::NoId, { { row[1], row[2], row[3] } }, row[4],
      dgg::NoId };
    row += NumberOfComponents;
  }
}
}

//------------------------------------------------------------------------------
void DGGWindowArrays::AddTo(vtkFieldData* data, vtkDoubleArray* distances,
  const dgg::PreparedSurface& mesh, const dgg::EdgeWindows& windows)
{
  const std::string name = distances->GetName();
  vtkNew<vtkTypeInt64Array> offsets;
  offsets->SetName(NameOf(name, Offsets).c_str());
  offsets->SetNumberOfValues(static_cast<vtkIdType>(windows.Offsets.size()));
  std::copy(windows.Offsets.begin(), windows.Offsets.end(), offsets->GetPointer(0));

  const auto table = MakeTable(NameOf(name, Windows), windows.Windows.size());
  double* row = table->GetPointer(0);
  for (const dgg::EdgeWindow& w : windows.Windows)
  {
    row = std::copy_n(
      std::array<double, NumberOfComponents>{ { w.Begin, w.End, w.Image.X, w.Image.Y, w.Offset } }
        .begin(),
      NumberOfComponents, row);
  }
  const auto places = MakeTable(NameOf(name, Sources), windows.Sources.size());
  row = places->GetPointer(0);
  for (const dgg::FaceSource& s : windows.Sources)
  {
    row = std::copy_n(
      std::array<double, NumberOfComponents>{ { static_cast<double>(s.Face), s.Barycentric[0],
                                                s.Barycentric[1], s.Barycentric[2], s.Offset } }
        .begin(),
      NumberOfComponents, row);
  }
  vtkNew<vtkTypeInt64Array> info;
  info->SetName(NameOf(name, Info).c_str());
  info->SetNumberOfValues(InfoSize);
  const std::array<std::int64_t, InfoSize> values =
    MakeInfo(distances, mesh, { FindIntegers(offsets), table, places });
  std::copy(values.begin(), values.end(), info->GetPointer(0));

  data->AddArray(offsets);
  data->AddArray(table);
  data->AddArray(places);
  data->AddArray(info);
}

//------------------------------------------------------------------------------
void DGGWindowArrays::RemoveFrom(vtkFieldData* data, const std::string& distances)
{
  for (const Role role : { Offsets, Windows, Sources, Info })
  {
    data->RemoveArray(NameOf(distances, role).c_str());
  }
}

//------------------------------------------------------------------------------
void DGGWindowArrays::RemoveAllFrom(vtkFieldData* data)
{
  const std::string suffix = Suffixes[Info];
  std::vector<std::string> found;
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    const std::string name = data->GetArrayName(i) ? data->GetArrayName(i) : "";
    if (name.size() > suffix.size() &&
      name.compare(name.size() - suffix.size(), suffix.size(), suffix) == 0)
    {
      found.push_back(name.substr(0, name.size() - suffix.size()));
    }
  }
  for (const std::string& distances : found)
  {
    DGGWindowArrays::RemoveFrom(data, distances);
  }
}

//------------------------------------------------------------------------------
bool DGGWindowArrays::Find(vtkFieldData* data, vtkDataArray* distances,
  const dgg::PreparedSurface& mesh, dgg::EdgeWindows& windows, std::string& complaint)
{
  windows = dgg::EdgeWindows();
  complaint.clear();
  const std::string name = distances && distances->GetName() ? distances->GetName() : "";
  const auto find = [&](Role role) { return data->GetAbstractArray(NameOf(name, role).c_str()); };
  if (!data || name.empty() || (!find(Offsets) && !find(Windows) && !find(Sources) && !find(Info)))
  {
    return false;
  }
  const std::string whose = "The windows of '" + name + "' in the field data ";
  auto* values = vtkDoubleArray::SafeDownCast(distances);
  if (!values)
  {
    complaint = whose + "belong to a vtkDoubleArray, but the distances have the type " +
      distances->GetDataTypeAsString();
    return false;
  }
  const Integers info = FindIntegers(find(Info));
  if (info.Begin && *info.Begin != FormatVersion)
  {
    complaint = whose + "have the format version " + std::to_string(*info.Begin) +
      ", but this version of vtkDGG reads version " + std::to_string(FormatVersion);
    return false;
  }
  const Tables tables = { FindIntegers(find(Offsets)), FindTable(find(Windows)),
    FindTable(find(Sources)) };
  if (!tables.Offsets.Begin || !tables.Windows || !tables.Sources ||
    info.End - info.Begin != InfoSize)
  {
    complaint = whose + "are damaged: an array is missing or has another type";
    return false;
  }
  const std::array<std::int64_t, InfoSize> wanted = MakeInfo(values, mesh, tables);
  if (!std::equal(wanted.begin(), wanted.begin() + TableHash, info.Begin))
  {
    complaint = whose + "do not belong to these distances on this surface";
    return false;
  }
  if (wanted[TableHash] != info.Begin[TableHash])
  {
    complaint = whose + "are damaged: they have changed since they were written";
    return false;
  }
  ReadTables(tables, windows);
  const dgg::Status status = windows.Check(mesh.GetMesh());
  if (!status.IsOk())
  {
    windows = dgg::EdgeWindows();
    complaint = status.Of(whose + "are damaged").GetProblem();
    return false;
  }
  return true;
}
