// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DGGFieldInput.h"

#include "DGGContext.h"
#include "DGGMeshQuality.h"
#include "DGGSurfaceArrays.h"
#include "DGGUnreachedArray.h"
#include "DGGWindowArrays.h"

#include "dggInvalidInput.h"
#include "dggPreparedSurface.h"
#include "dggSourceFinding.h"

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

namespace
{
/// Name of results if the distances have no name: the default name of distance filters.
constexpr const char* DefaultName = "GeodesicDistance";
/// Largest mean difference, relative to the mean edge length, between distances and the sums of
/// offset and length of virtual sources. Virtual sources beyond this limit belong to other
/// distances. Estimates of graphs may differ by the accuracy of the graph.
constexpr double LargestDifference = 0.1;
/// Distances change along an edge by at most its length; approximate distances may exceed the
/// length along a few edges.
constexpr double SteepestSlope = 1.1;
constexpr double LargestShareOfSteepEdges = 0.1;

/// Returns the reason why values cannot be distances in the units of the points; empty if they may
/// be.
std::string FindFault(const dgg::SurfaceMesh& mesh, const std::vector<double>& values)
{
  dgg::Id known = 0;
  dgg::Id steep = 0;
  for (dgg::Id h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
  {
    const double change = std::abs(values[mesh.Destination(h)] - values[mesh.Origin(h)]);
    if (!mesh.IsDropped(dgg::SurfaceMesh::Face(h)) && std::isfinite(change))
    {
      ++known;
      steep += change > SteepestSlope * mesh.Length(h) ? 1 : 0;
    }
  }
  if (known == 0)
  {
    return "The field is not known at any two neighbouring points: pass finite values.";
  }
  const double share = static_cast<double>(steep) / known;
  if (share <= LargestShareOfSteepEdges)
  {
    return "";
  }
  return dgg::JoinText("The field is hardly a distance: along ", std::lround(100.0 * share),
    " % of the edges it changes by more than their length. Pass the distance itself, in the units "
    "of the points.");
}

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
    return dgg::Status::Invalid("the array to process is not one of points: call "
                                "SetInputArrayToProcess() with FIELD_ASSOCIATION_POINTS");
  }
  if (request->Has(vtkAlgorithm::INPUT_PORT()) && request->Get(vtkAlgorithm::INPUT_PORT()) != 0)
  {
    return dgg::Status::Invalid("the array to process is not one of the surface: call "
                                "SetInputArrayToProcess() with the port 0");
  }
  if (request->Has(vtkDataObject::FIELD_ATTRIBUTE_TYPE()) &&
    request->Get(vtkDataObject::FIELD_ATTRIBUTE_TYPE()) != vtkDataSetAttributes::SCALARS)
  {
    return dgg::Status::Invalid("the array to process is not one of scalars: call "
                                "SetInputArrayToProcess() with a name or SCALARS");
  }
  return dgg::Status::Success();
}
}

//------------------------------------------------------------------------------
std::string DGGFieldInput::GetName(vtkDataArray* distances)
{
  const char* name = distances->GetName();
  return name && *name ? name : DefaultName;
}

//------------------------------------------------------------------------------
std::string DGGFieldInput::GetName(vtkInformation* filter, const std::string& property)
{
  const std::string name = GetAskedName(FindRequest(filter), property);
  return name.empty() ? DefaultName : name;
}

//------------------------------------------------------------------------------
dgg::Status DGGFieldInput::FindDistances(vtkInformation* filter, const std::string& property,
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
    return dgg::InvalidInput(name.empty() ? std::string("there are no active point scalars")
                                          : "there is no point array '" + name + "'",
      " with distances. ", ListArrays(data),
      ": call SetDistanceArrayName() or SetInputArrayToProcess() with one of them, or connect a "
      "distance filter");
  }
  return DGGCheckPointArray(found, surface, "the surface", 1, distances);
}

//------------------------------------------------------------------------------
dgg::Status DGGFieldInput::ReadDistances(const DGGContext& context, vtkDataArray* distances)
{
  vtkPolyData* surface = context.Input;
  const dgg::PreparedSurface& mesh = context.Surface;
  this->Warning.clear();
  this->IsFitted = false;
  this->Windows = dgg::EdgeWindows();
  this->Sources.clear();
  this->Distances.assign(mesh.GetMesh().GetNumberOfVertices(), dgg::Infinity);
  const std::vector<bool> isUnreached =
    DGGUnreachedArray::Find(surface->GetPointData(), distances, this->UnreachedValue);
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    if (!isUnreached.empty() && isUnreached[i])
    {
      continue;
    }
    const double d = distances->GetComponent(i, 0);
    if (d == -dgg::Infinity)
    {
      return dgg::InvalidInput("the distance of point ", i,
        " is minus infinity: points that are not reached have NaN, plus infinity or the "
        "UnreachedValue");
    }
    // The first of several points at a vertex has the id of the vertex.
    if (!std::isnan(d) && mesh.GetVertex(i) == static_cast<dgg::Id>(i))
    {
      this->Distances[i] = d;
    }
  }
  this->Field = { &mesh.GetMesh(), this->Distances.data(), &this->Windows, &this->Sources };
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
dgg::Status DGGFieldInput::Read(const DGGContext& context, vtkDataArray* distances,
  const std::string& virtualSources, const dgg::ProgressCallback& progress)
{
  DGG_RETURN_IF_ERROR(this->ReadDistances(context, distances));
  this->ReadWindows(context, distances);
  this->ReadSources(context, virtualSources);
  return this->Field.HasWindows() || this->Field.HasSources() ? dgg::Status::Success()
                                                              : this->FitSources(context, progress);
}

//------------------------------------------------------------------------------
void DGGFieldInput::ReadWindows(const DGGContext& context, vtkDataArray* distances)
{
  std::string complaint;
  DGGWindowArrays::Find(
    context.Input->GetFieldData(), distances, context.Surface, this->Windows, complaint);
  if (!complaint.empty())
  {
    this->Warn(complaint + ". They are ignored");
  }
}

//------------------------------------------------------------------------------
void DGGFieldInput::ReadSources(const DGGContext& context, const std::string& name)
{
  vtkPolyData* surface = context.Input;
  const dgg::PreparedSurface& mesh = context.Surface;
  vtkDataArray* array = surface->GetPointData()->GetArray(name.c_str());
  if (!array)
  {
    return;
  }
  const std::string whose = "the virtual sources in the point array '" + name + "' ";
  if (array->GetNumberOfComponents() != 3 ||
    array->GetNumberOfTuples() != surface->GetNumberOfPoints())
  {
    this->Warn(whose + "do not have 3 components per point. They are ignored");
    return;
  }
  for (std::size_t v = 0; v < this->Distances.size(); ++v)
  {
    const double* source = array->GetTuple3(static_cast<vtkIdType>(v));
    this->Sources.push_back({ source[0], source[1], source[2] });
  }
  if (!this->HasSourcesOfDistances(mesh.GetMesh()))
  {
    this->Sources.clear();
    this->Warn(whose + "are not those of the distances on this surface. They are ignored");
  }
}

//------------------------------------------------------------------------------
dgg::Status DGGFieldInput::FitSources(
  const DGGContext& context, const dgg::ProgressCallback& progress)
{
  const dgg::SurfaceMesh& mesh = context.Surface.GetMesh();
  const std::string fault = FindFault(mesh, this->Distances);
  if (!fault.empty())
  {
    this->Warn(fault + " It is taken as linear in each triangle");
    return dgg::Status::Success();
  }
  this->IsFitted = true;
  return dgg::FitVirtualSources(
           mesh, this->Distances.data(), context.Parallel, this->Sources, progress)
    ? dgg::Status::Success()
    : dgg::Status::Abort();
}

//------------------------------------------------------------------------------
std::string DGGFieldInput::DescribeQuality(const dgg::PreparedSurface& surface) const
{
  return this->Field.HasSources() ? DGGDescribeLongTriangles(surface, DGGLongTrianglesHideSources)
                                  : std::string();
}

//------------------------------------------------------------------------------
void DGGFieldInput::Warn(const std::string& text)
{
  this->Warning += this->Warning.empty() ? text : ". " + text;
}

//------------------------------------------------------------------------------
bool DGGFieldInput::HasSourcesOfDistances(const dgg::SurfaceMesh& mesh) const
{
  double difference = 0.0;
  double reached = 0.0;
  for (std::size_t v = 0; v < this->Distances.size(); ++v)
  {
    if (!(this->Distances[v] < dgg::Infinity))
    {
      continue;
    }
    const dgg::VirtualSource& source = this->Sources[v];
    if (!std::isfinite(source.Angle) || !(source.Length >= 0.0))
    {
      return false;
    }
    difference += std::abs(source.Offset + source.Length - this->Distances[v]);
    reached += 1.0;
  }
  // False if the difference is NaN.
  return difference <= LargestDifference * reached * mesh.GetMeanEdgeLength();
}
