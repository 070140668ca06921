// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGMeshAdapter.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cstdint>

namespace
{
/// Later of the cell array's own time and that of its parts.
vtkMTimeType TimeOf(vtkCellArray* cells)
{
  return cells ? std::max({ cells->GetMTime(), cells->GetOffsetsArray()->GetMTime(),
                   cells->GetConnectivityArray()->GetMTime() })
               : 0;
}

vtkMTimeType AddressOf(const void* object)
{
  return static_cast<vtkMTimeType>(reinterpret_cast<std::uintptr_t>(object));
}

/// A mesh without anything, so that there always is one.
const vtkDGGPreparedMesh::Pointer& GetNothing()
{
  static const auto nothing = std::make_shared<const vtkDGGPreparedMesh>();
  return nothing;
}
}

//------------------------------------------------------------------------------
vtkDGGMeshAdapter::vtkDGGMeshAdapter()
  : Prepared(GetNothing())
{
}

//------------------------------------------------------------------------------
vtkDGGMeshAdapter::Key vtkDGGMeshAdapter::MakeKey(vtkPolyData* input, const vtkDGGDomain& domain)
{
  vtkPoints* points = input->GetPoints();
  const bool isCloud = domain.Kind == vtkDGGDomain::Cloud;
  vtkCellArray* polygons = isCloud ? nullptr : input->GetPolys();
  vtkCellArray* strips = isCloud ? nullptr : input->GetStrips();
  return { { AddressOf(points), points ? points->GetMTime() : 0, AddressOf(polygons),
    TimeOf(polygons), AddressOf(strips), TimeOf(strips) } };
}

//------------------------------------------------------------------------------
bool vtkDGGMeshAdapter::IsUpToDate(vtkPolyData* input, const vtkDGGDomain& domain)
{
  // After a change in place Modified() is often called on the data object alone. Another object
  // with the very same points and polygons is no change.
  const vtkMTimeType object = AddressOf(input);
  const vtkMTimeType time = input->vtkObject::GetMTime();
  const bool modified = object == this->Object && time != this->ObjectTime;
  this->Object = object;
  this->ObjectTime = time;
  if (!this->IsBuilt)
  {
    return false;
  }
  const Key key = MakeKey(input, domain);
  if (modified || this->BuiltFrom != key || !(this->GetDomain() == domain))
  {
    // Time stamps say that something may have changed, as after any update upstream. Look whether
    // it has.
    if (this->Fingerprint != vtkDGGPreparedMesh::ComputeFingerprint(input, domain))
    {
      return false;
    }
    this->BuiltFrom = key;
  }
  return true;
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGMeshAdapter::CheckPoints(vtkPolyData* input) const
{
  return input->GetNumberOfPoints() == this->GetMesh().GetNumberOfVertices()
    ? dgg::Status::Success()
    : dgg::Status::Invalid("the points were changed during the update: do not change them in "
                           "observers, and update again");
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGMeshAdapter::CheckUnchanged(vtkPolyData* input, vtkPolyData* copy) const
{
  const dgg::Status status = this->CheckPoints(copy);
  if (!status.IsOk())
  {
    return status;
  }
  const vtkDGGDomain& domain = this->GetDomain();
  const bool isTouched = MakeKey(copy, domain) != this->BuiltFrom ||
    AddressOf(input) != this->Object || input->vtkObject::GetMTime() != this->ObjectTime;
  if (isTouched && vtkDGGPreparedMesh::ComputeFingerprint(copy, domain) != this->Fingerprint)
  {
    return dgg::Status::Invalid("the points were changed during the update, or the cells: do not "
                                "change them in observers, and update again");
  }
  return status;
}

//------------------------------------------------------------------------------
void vtkDGGMeshAdapter::Clear()
{
  this->Prepared = GetNothing();
  this->IsBuilt = false;
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGMeshAdapter::Update(vtkPolyData* input, const vtkDGGDomain& domain)
{
  this->Clear();
  this->Fingerprint = vtkDGGPreparedMesh::ComputeFingerprint(input, domain);
  vtkDGGPreparedMesh::Pointer prepared;
  const dgg::Status status = vtkDGGPreparedMesh::Make(input, domain, this->Fingerprint, prepared);
  if (status.IsOk())
  {
    this->Prepared = prepared;
    this->BuiltFrom = MakeKey(input, domain);
    this->IsBuilt = true;
    this->BuildTime.Modified();
  }
  return status;
}
