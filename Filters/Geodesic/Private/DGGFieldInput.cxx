// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DGGFieldInput.h"

#include "DGGContext.h"
#include "DGGSurfaceArrays.h"
#include "DGGWindowArrays.h"

#include "dggDistanceOutput.h"
#include "dggFieldReader.h"
#include "dggStatus.h"

#include "vtkAlgorithm.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <cmath>
#include <sstream>
#include <utility>

namespace
{
/// Name of results if the distances have no name: the default name of distance filters.
constexpr const char* DefaultName = "GeodesicDistance";

std::string ListArrays(vtkPointData* data)
{
  std::ostringstream text;
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    text << (i > 0 ? ", '" : "'") << (data->GetArrayName(i) ? data->GetArrayName(i) : "(no name)")
         << "'";
  }
  return data->GetNumberOfArrays() > 0 ? "The point arrays are " + text.str()
                                       : "There are no point arrays";
}

/// Returns the request of SetInputArrayToProcess(); null if there is none.
vtkInformation* FindRequest(vtkInformation* filter)
{
  vtkInformationVector* arrays = filter->Get(vtkAlgorithm::INPUT_ARRAYS_TO_PROCESS());
  vtkInformation* request = arrays ? arrays->GetInformationObject(0) : nullptr;
  return request && request->Has(vtkDataObject::FIELD_ASSOCIATION()) ? request : nullptr;
}

/// Returns the name in a request, or else the name in the property; empty for the active scalars.
std::string GetAskedName(vtkInformation* request, const std::string& property)
{
  const char* asked = request ? request->Get(vtkDataObject::FIELD_NAME()) : property.c_str();
  return asked ? asked : "";
}

/// Returns an error unless a request specifies a point array of the surface by its name or as the
/// scalars.
dgg::Status CheckRequest(vtkInformation* request)
{
  const int where = request->Get(vtkDataObject::FIELD_ASSOCIATION());
  if (where != vtkDataObject::FIELD_ASSOCIATION_POINTS &&
    where != vtkDataObject::FIELD_ASSOCIATION_POINTS_THEN_CELLS)
  {
    return dgg::InvalidInput("The array to process is not a point array")
      .Fix("Call SetInputArrayToProcess() with FIELD_ASSOCIATION_POINTS");
  }
  if (request->Has(vtkAlgorithm::INPUT_PORT()) && request->Get(vtkAlgorithm::INPUT_PORT()) != 0)
  {
    return dgg::InvalidInput("The array to process is not an array of the surface")
      .Fix("Call SetInputArrayToProcess() with port 0");
  }
  if (request->Has(vtkDataObject::FIELD_ATTRIBUTE_TYPE()) &&
    request->Get(vtkDataObject::FIELD_ATTRIBUTE_TYPE()) != vtkDataSetAttributes::SCALARS)
  {
    return dgg::InvalidInput("The array to process is not an array of scalars")
      .Fix("Call SetInputArrayToProcess() with a name or SCALARS");
  }
  return dgg::Status::Success();
}
}

//------------------------------------------------------------------------------
std::string DGGGetDistanceName(vtkDataArray* distances)
{
  const char* name = distances->GetName();
  return name && *name ? name : DefaultName;
}

//------------------------------------------------------------------------------
std::string DGGGetDistanceName(vtkInformation* filter, const std::string& property)
{
  const std::string name = GetAskedName(FindRequest(filter), property);
  return name.empty() ? DefaultName : name;
}

//------------------------------------------------------------------------------
dgg::Status DGGFindDistances(vtkInformation* filter, const std::string& property,
  vtkPolyData* surface, vtkDataArray*& distances)
{
  distances = nullptr;
  vtkInformation* request = FindRequest(filter);
  DGG_RETURN_IF_ERROR(request ? CheckRequest(request) : dgg::Status::Success());
  const std::string name = GetAskedName(request, property);
  vtkPointData* data = surface->GetPointData();
  vtkAbstractArray* found =
    name.empty() ? data->GetScalars() : data->GetAbstractArray(name.c_str());
  if (!found)
  {
    return dgg::InvalidInput(name.empty() ? std::string("There are no active point scalars")
                                          : "There is no point array '" + name + "'",
      " with distances. ", ListArrays(data))
      .At("DistanceArrayName")
      .Fix("Set {DistanceArrayName} to one of them, or connect a distance filter");
  }
  return DGGCheckPointArray(found, surface, "the surface", 1, distances);
}

//------------------------------------------------------------------------------
dgg::Status DGGReadField(const DGGContext& context, vtkDataArray* distances, double unreachedValue,
  const char* virtualSources, const dgg::ProgressCallback& progress, dgg::FieldReader& reader)
{
  vtkPointData* data = context.Input->GetPointData();
  const char* name = distances->GetName();
  const bool useMarks = name && std::isnan(unreachedValue);
  DGG_RETURN_IF_ERROR(reader.SetDistances(DGGReadArray(distances, ""), unreachedValue,
    DGGReadArray(data, useMarks ? dgg::GetUnreachedName(name) : "")));
  if (!virtualSources)
  {
    return dgg::Status::Success();
  }
  dgg::EdgeWindows windows;
  std::string complaint;
  DGGWindowArrays::Find(
    context.Input->GetFieldData(), distances, context.Surface, windows, complaint);
  reader.SetWindows(std::move(windows));
  if (!complaint.empty())
  {
    reader.Warn(complaint + ". They are ignored");
  }
  reader.SetSources(DGGReadArray(data, virtualSources));
  return reader.Complete(context, progress);
}

//------------------------------------------------------------------------------
void DGGRemoveDistances(vtkPolyData* surface, const std::string& distances)
{
  surface->GetPointData()->RemoveArray(dgg::GetUnreachedName(distances).c_str());
  DGGWindowArrays::RemoveFrom(surface->GetFieldData(), distances);
}
