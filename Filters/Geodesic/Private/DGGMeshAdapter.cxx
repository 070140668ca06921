// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DGGMeshAdapter.h"

#include "DGGSurfaceArrays.h"

#include "dggPropertyChecks.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cstdint>

namespace
{
/// Returns the latest modification time of a cell array and its parts.
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

/// Returns an empty surface.
const dgg::PreparedSurface::Pointer& GetNothing()
{
  static const auto nothing = std::make_shared<const dgg::PreparedSurface>();
  return nothing;
}
}

//------------------------------------------------------------------------------
DGGMeshAdapter::DGGMeshAdapter()
  : Prepared(GetNothing())
{
}

//------------------------------------------------------------------------------
DGGMeshAdapter::Key DGGMeshAdapter::MakeKey(vtkPolyData* input, const dgg::Domain& domain)
{
  vtkPoints* points = input->GetPoints();
  const bool isCloud = domain.Kind == dgg::Domain::Cloud;
  vtkCellArray* polygons = isCloud ? nullptr : input->GetPolys();
  vtkCellArray* strips = isCloud ? nullptr : input->GetStrips();
  return { { AddressOf(points), points ? points->GetMTime() : 0, AddressOf(polygons),
    TimeOf(polygons), AddressOf(strips), TimeOf(strips) } };
}

//------------------------------------------------------------------------------
dgg::Status DGGMeshAdapter::CheckSurface(vtkPolyData* input)
{
  return dgg::CheckCells(input->GetNumberOfPoints(),
    input->GetNumberOfPolys() + input->GetNumberOfStrips(),
    "Connect a surface mesh. A point cloud needs the graph of vtkPointCloudDGG (in Python: "
    "vtkdgg.CloudGraph) and a filter that accepts clouds, such as vtkDGGDistance");
}

//------------------------------------------------------------------------------
void DGGMeshAdapter::Clear()
{
  this->Prepared = GetNothing();
  this->IsBuilt = false;
}

//------------------------------------------------------------------------------
dgg::Status DGGMeshAdapter::Update(vtkPolyData* input, const dgg::Domain& domain)
{
  // After an in-place change, applications often call Modified() on the data object only. Another
  // object with identical arrays of points and polygons is not a change.
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
  // Time stamps also change when an update upstream reproduces the same points and cells.
  const bool isCloud = domain.Kind == dgg::Domain::Cloud;
  const DGGSurfaceArrays arrays(input, true, !isCloud);
  const dgg::Signature fingerprint = dgg::PreparedSurface::ComputeFingerprint(arrays.Get(), domain);
  if (this->IsBuilt && this->Fingerprint == fingerprint)
  {
    this->BuiltFrom = key;
    return dgg::Status::Success();
  }
  this->Clear();
  dgg::PreparedSurface::Pointer prepared;
  if (!isCloud)
  {
    DGG_RETURN_IF_ERROR(CheckSurface(input));
  }
  DGG_RETURN_IF_ERROR(dgg::PreparedSurface::Make(arrays.Get(), domain, fingerprint, prepared));
  this->Prepared = prepared;
  this->Fingerprint = fingerprint;
  this->BuiltFrom = key;
  this->IsBuilt = true;
  this->BuildTime.Modified();
  return dgg::Status::Success();
}
