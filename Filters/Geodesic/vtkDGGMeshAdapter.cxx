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
void vtkDGGMeshAdapter::Clear()
{
  this->Prepared = GetNothing();
  this->IsBuilt = false;
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGMeshAdapter::Update(vtkPolyData* input, const vtkDGGDomain& domain)
{
  // After a change in place Modified() is often called on the data object alone. Another object
  // with the very same points and polygons is no change.
  const vtkMTimeType object = AddressOf(input);
  const vtkMTimeType time = input->vtkObject::GetMTime();
  const bool modified = object == this->Object && time != this->ObjectTime;
  this->Object = object;
  this->ObjectTime = time;
  const Key key = MakeKey(input, domain);
  if (this->IsBuilt && !modified && this->BuiltFrom == key && this->Prepared->GetDomain() == domain)
  {
    return dgg::Status::Success();
  }
  // Time stamps say that something may have changed, as after any update upstream. Look whether it
  // has.
  const dgg::Signature fingerprint = vtkDGGPreparedMesh::ComputeFingerprint(input, domain);
  if (this->IsBuilt && this->Fingerprint == fingerprint)
  {
    this->BuiltFrom = key;
    return dgg::Status::Success();
  }
  this->Clear();
  vtkDGGPreparedMesh::Pointer prepared;
  const dgg::Status status = vtkDGGPreparedMesh::Make(input, domain, fingerprint, prepared);
  if (status.IsOk())
  {
    this->Prepared = prepared;
    this->Fingerprint = fingerprint;
    this->BuiltFrom = key;
    this->IsBuilt = true;
    this->BuildTime.Modified();
  }
  return status;
}
