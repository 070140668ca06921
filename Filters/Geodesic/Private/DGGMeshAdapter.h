// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Surface of an input, kept between updates. Internal.
#ifndef DGGMeshAdapter_h
#define DGGMeshAdapter_h

#include "dggPreparedSurface.h" // for the surface

#include "vtkTimeStamp.h" // for the time
#include "vtkType.h"      // for vtkMTimeType

#include <array> // for the key

class vtkPolyData;

/// The surface of a vtkPolyData, kept until points, polygons or strips change.
class DGGMeshAdapter
{
public:
  DGGMeshAdapter();

  /// Prepares the surface, or shares the surface of another filter. Does nothing if time stamps or
  /// bits show that points and cells are unchanged. Fails like dgg::PreparedSurface::Make(); then
  /// the surface is empty.
  dgg::Status Update(vtkPolyData* input, const dgg::Domain& domain);

  /// Returns an error if no cell of the input can be part of a surface.
  static dgg::Status CheckSurface(vtkPolyData* input);

  void Clear();

  const dgg::PreparedSurface& Get() const { return *this->Prepared; }
  /// Returns the time of the last change of the surface.
  vtkMTimeType GetBuildTime() const { return this->BuildTime.GetMTime(); }

private:
  /// Identities and modification times of points, polygons and strips. Time stamps are unique in
  /// VTK.
  using Key = std::array<vtkMTimeType, 6>;
  static Key MakeKey(vtkPolyData* input, const dgg::Domain& domain);

  dgg::PreparedSurface::Pointer Prepared; // never null
  dgg::Signature Fingerprint{};           // signature of the input of Prepared
  vtkTimeStamp BuildTime;
  Key BuiltFrom{};
  vtkMTimeType Object = 0; // address and own time of the last vtkPolyData
  vtkMTimeType ObjectTime = 0;
  bool IsBuilt = false;
};

#endif
