// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGFieldInput.h"

#include "vtkDGGMeshAdapter.h"
#include "vtkDGGParallel.h"
#include "vtkDGGWindowArrays.h"

#include "dggCornerModel.h"
#include "dggFieldTest.h"
#include "dggSourceFit.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <cmath>
#include <sstream>

namespace
{
/// How far virtual sources may be from the distances of their neighbours on the whole, in lengths
/// of the edges. Those of a field are off by hundredths; those of another field, or in other
/// directions, by a half and more.
constexpr double LargestMisfit = 0.25;

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
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGFieldInput::FindDistances(
  vtkPolyData* surface, const std::string& name, vtkDataArray*& distances)
{
  vtkPointData* data = surface->GetPointData();
  vtkAbstractArray* found =
    name.empty() ? data->GetScalars() : data->GetAbstractArray(name.c_str());
  distances = vtkDataArray::SafeDownCast(found);
  std::ostringstream message;
  if (!found)
  {
    message << (name.empty() ? std::string("there are no active point scalars")
                             : "there is no point array '" + name + "'")
            << " with distances. " << ListArrays(data)
            << ": name one of them, or connect a distance filter";
    return dgg::Status::Invalid(message.str());
  }
  if (!distances || distances->GetNumberOfComponents() != 1 ||
    distances->GetNumberOfTuples() != surface->GetNumberOfPoints())
  {
    const char* called = found->GetName();
    message << "the point array '" << (called ? called : "(no name)") << "' has "
            << found->GetNumberOfComponents() << " components and " << found->GetNumberOfTuples()
            << " tuples of type " << found->GetDataTypeAsString() << " for "
            << surface->GetNumberOfPoints() << " points: one number per point is needed";
    return dgg::Status::Invalid(message.str());
  }
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGFieldInput::ReadDistances(
  vtkPolyData* surface, vtkDataArray* distances, const vtkDGGMeshAdapter& mesh)
{
  this->Warning.clear();
  this->Windows = dgg::EdgeWindows();
  this->Sources = dgg::VirtualSources();
  this->Distances.assign(mesh.GetMesh().GetNumberOfVertices(), dgg::Infinity);
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    const double d = distances->GetComponent(i, 0);
    if (d == -dgg::Infinity)
    {
      std::ostringstream message;
      message << "the distance of point " << i
              << " is minus infinity: points that are not reached have NaN or plus infinity";
      return dgg::Status::Invalid(message.str());
    }
    // Of points that share a vertex, the first is the vertex.
    if (!std::isnan(d) && mesh.GetVertex(i) == static_cast<dgg::Id>(i))
    {
      this->Distances[i] = d;
    }
  }
  this->Field = { &mesh.GetMesh(), this->Distances.data(), &this->Windows, &this->Sources };
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGFieldInput::Read(vtkPolyData* surface, vtkDataArray* distances,
  const std::string& virtualSources, const vtkDGGMeshAdapter& mesh,
  const dgg::ProgressCallback& progress)
{
  const dgg::Status status = this->ReadDistances(surface, distances, mesh);
  if (!status.IsOk())
  {
    return status;
  }
  this->ReadWindows(surface, distances, mesh);
  if (!this->Field.HasWindows())
  {
    this->ReadSources(surface, virtualSources, mesh);
  }
  if (!this->Field.HasWindows() && !this->Field.HasSources() &&
    !this->FitSources(mesh.GetMesh(), progress))
  {
    return dgg::Status::Abort();
  }
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
void vtkDGGFieldInput::ReadWindows(
  vtkPolyData* surface, vtkDataArray* distances, const vtkDGGMeshAdapter& mesh)
{
  std::string complaint;
  vtkDGGWindowArrays::Find(surface->GetFieldData(), vtkDoubleArray::SafeDownCast(distances), mesh,
    this->Windows, complaint);
  if (!complaint.empty())
  {
    this->Warn(complaint + ". They are ignored");
  }
}

//------------------------------------------------------------------------------
void vtkDGGFieldInput::ReadSources(
  vtkPolyData* surface, const std::string& name, const vtkDGGMeshAdapter& mesh)
{
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
  const std::size_t n = this->Distances.size();
  for (std::vector<double>* values :
    { &this->Sources.Offsets, &this->Sources.Lengths, &this->Sources.Angles })
  {
    values->resize(n);
  }
  for (std::size_t v = 0; v < n; ++v)
  {
    const auto i = static_cast<vtkIdType>(v);
    this->Sources.Offsets[v] = array->GetComponent(i, 0);
    this->Sources.Lengths[v] = array->GetComponent(i, 1);
    this->Sources.Angles[v] = array->GetComponent(i, 2);
  }
  if (!this->FitsSources(mesh.GetMesh()))
  {
    this->Sources = dgg::VirtualSources();
    this->Warn(whose + "are not those of the distances on this surface. They are ignored");
  }
}

//------------------------------------------------------------------------------
bool vtkDGGFieldInput::FitSources(
  const dgg::SurfaceMesh& mesh, const dgg::ProgressCallback& progress)
{
  const dgg::FieldReport report = dgg::TestField(mesh, this->Distances.data());
  if (report.IsDistance())
  {
    return dgg::FitVirtualSources(
      mesh, this->Distances.data(), vtkDGGMakeParallelFor(), this->Sources, progress);
  }
  if (!report.Sentence.empty())
  {
    this->Warn(report.Sentence + " It is taken as linear in each triangle");
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkDGGFieldInput::Warn(const std::string& text)
{
  this->Warning += this->Warning.empty() ? text : ". " + text;
}

//------------------------------------------------------------------------------
bool vtkDGGFieldInput::FitsSources(const dgg::SurfaceMesh& mesh) const
{
  double misfit = 0.0;
  double length = 0.0;
  for (dgg::Id h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
  {
    const dgg::Id v = mesh.Origin(h);
    const dgg::Id w = mesh.Destination(h);
    if (mesh.IsDropped(dgg::SurfaceMesh::Face(h)) || !(this->Distances[v] < dgg::Infinity) ||
      !(this->Distances[w] < dgg::Infinity))
    {
      continue;
    }
    const bool isNumber = std::isfinite(this->Sources.Offsets[v]) &&
      std::isfinite(this->Sources.Angles[v]) && this->Sources.Lengths[v] >= 0.0 &&
      this->Sources.Lengths[v] < dgg::Infinity;
    if (!isNumber)
    {
      return false;
    }
    const dgg::CornerModel model(
      mesh, v, this->Sources.Offsets[v], this->Sources.Lengths[v], this->Sources.Angles[v]);
    if (model.IsKnown)
    {
      misfit += std::abs(model.At(mesh.Length(h), mesh.PolarAngle(h)) - this->Distances[w]);
      length += mesh.Length(h);
    }
  }
  return misfit <= LargestMisfit * length;
}
