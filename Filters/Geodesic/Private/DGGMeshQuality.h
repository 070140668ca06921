// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Meshes that approximate distances are far off on. Internal.
#ifndef DGGMeshQuality_h
#define DGGMeshQuality_h

#include "vtkGeodesicAlgorithm.h"

/// Whether most triangles are long, with a warning. The median, as a few slivers make any mean and
/// do little harm. To be called once for each mesh.
inline bool DGGWarnOfLongTriangles(vtkGeodesicAlgorithm* filter)
{
  constexpr double mostAnisotropy = 3.0;
  const double anisotropy = filter->GetMedianAnisotropy();
  const bool isLong = anisotropy > mostAnisotropy;
  if (isLong)
  {
    vtkWarningWithObjectMacro(filter,
      << "Most triangles are long (GetMedianAnisotropy() is " << anisotropy << ", more than "
      << mostAnisotropy << "): distances may be far off. Use vtkExactGeodesicDistance or "
      << "vtkDGGDistance, or remesh the surface.");
  }
  return isLong;
}

#endif
