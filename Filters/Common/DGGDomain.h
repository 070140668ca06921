// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What a vtkPolyData is treated as. Internal.
#ifndef DGGDomain_h
#define DGGDomain_h

/// What distances are measured along.
struct DGGDomain
{
  enum KindType
  {
    Surface,       ///< the polygons and strips, as they are glued by point ids
    MergedSurface, ///< the same, with coincident points taken as one
    Cloud          ///< the points alone: cells are not looked at
  };

  KindType Kind = Surface;
  double MergeTolerance = 0.0; ///< of a MergedSurface, see vtkGeodesicAlgorithm; else 0

  bool operator==(const DGGDomain& other) const
  {
    return this->Kind == other.Kind && this->MergeTolerance == other.MergeTolerance;
  }
};

#endif
