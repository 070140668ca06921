// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What a vtkPolyData is taken for. Internal.
#ifndef vtkDGGDomain_h
#define vtkDGGDomain_h

/// What distances are measured along.
enum class vtkDGGDomain
{
  Surface,       ///< the polygons and strips, as they are glued by point ids
  MergedSurface, ///< the same, with coincident points taken as one
  Cloud          ///< the points alone: cells are not looked at
};

#endif
// VTK-HeaderTest-Exclude: vtkDGGDomain.h
