// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DGGWindowArrays.h"

#include "DGGArrayView.h"

#include "dggStoredWindows.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"

#include <vector>

using dgg::StoredWindows;

//------------------------------------------------------------------------------
void DGGWindowArrays::RemoveFrom(vtkFieldData* data, const std::string& distances)
{
  for (int role = 0; role < StoredWindows::NumberOfRoles; ++role)
  {
    data->RemoveArray(StoredWindows::GetName(distances, role).c_str());
  }
}

//------------------------------------------------------------------------------
void DGGWindowArrays::RemoveAllFrom(vtkFieldData* data)
{
  const std::string suffix = StoredWindows::GetName("", StoredWindows::InfoRole);
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
  bool isFound = false;
  StoredWindows::Arrays arrays;
  for (int role = 0; data && !name.empty() && role < StoredWindows::NumberOfRoles; ++role)
  {
    vtkAbstractArray* array = data->GetAbstractArray(StoredWindows::GetName(name, role).c_str());
    const bool isTable = role == StoredWindows::WindowsRole || role == StoredWindows::SourcesRole;
    arrays[role] = DGGViewArray(array, isTable ? StoredWindows::NumberOfComponents : 1);
    isFound = isFound || array;
  }
  if (!isFound)
  {
    return false;
  }
  auto* values = vtkDoubleArray::SafeDownCast(distances);
  if (!values)
  {
    complaint = "The windows of '" + name +
      "' in the field data belong to a vtkDoubleArray, but the distances have the type " +
      distances->GetDataTypeAsString();
    return false;
  }
  const dgg::Status status = StoredWindows::Read(arrays, name, values->GetPointer(0),
    static_cast<std::size_t>(values->GetNumberOfValues()), mesh, windows);
  complaint = status.GetProblem();
  return status.IsOk();
}
