// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Meshes that approximate distances are far off on. Internal.
#ifndef DGGMeshQuality_h
#define DGGMeshQuality_h

#include "vtkGeodesicAlgorithm.h"

/// Above that most triangles are long. The median, as a few slivers make any mean and do little
/// harm.
constexpr double DGGMostAnisotropy = 3.0;

/// Whether most triangles are long, with a warning. To be called once for each mesh.
inline bool DGGWarnOfLongTriangles(vtkGeodesicAlgorithm* filter)
{
  const double anisotropy = filter->GetMedianAnisotropy();
  const bool isLong = anisotropy > DGGMostAnisotropy;
  if (isLong)
  {
    vtkWarningWithObjectMacro(filter,
      << "Most triangles are long (GetMedianAnisotropy() is " << anisotropy << ", more than "
      << DGGMostAnisotropy << "): distances may be far off. Use vtkExactGeodesicDistance or "
      << "vtkDGGDistance, or remesh the surface.");
  }
  return isLong;
}

#endif
