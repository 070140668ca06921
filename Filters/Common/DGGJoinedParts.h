// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Joins the parts of a surface. Internal.
#ifndef DGGJoinedParts_h
#define DGGJoinedParts_h

#include "DGGSurfaceParts.h" // for the parts

#include "vtkDataSetAttributes.h" // for the attributes

#include <array>   // for the names
#include <cstddef> // for std::size_t
#include <string>  // for the names

class vtkAbstractArray;

/// Differences between the point data or the cell data of an output and of the input.
struct DGGChangedArrays
{
  std::vector<std::string> Removed;
  std::vector<vtkSmartPointer<vtkAbstractArray>> Added;
  /// Names of active arrays; empty if there is none.
  std::array<std::string, vtkDataSetAttributes::NUM_ATTRIBUTES> Active;
};

/// Result on one part, for an output that is the surface with arrays added.
struct DGGPartResult
{
  DGGChangedArrays Points;
  DGGChangedArrays Cells;
};

/// Joins parts to one surface, and transfers results on this surface to the parts.
/// Points of parts of one block are identified
///  - if all parts have global ids: by equal ids, which must not occur at other positions;
///  - otherwise by equal positions on the boundaries of different parts. If a part has several
///    points at one position, at a seam, only ends of edges that coincide are identified.
/// Points are numbered block by block, within a block by global ids or else part by part in their
/// order. Cells are numbered in the same manner within their kind; cells with the same global id on
/// the same points are identified. A part that another process has as well counts once. A single
/// part is unchanged.
class VTKDGGFILTERSCOMMON_EXPORT DGGJoinedParts
{
public:
  dgg::Status Join(const std::vector<DGGSurfacePart>& parts);

  vtkPolyData* GetWhole() const { return this->Whole; }

  /// Returns the result on a part of an output that has the points and cells of the joined surface.
  DGGPartResult MakeResult(vtkPolyData* output, std::size_t part) const;

  static void AddResult(const DGGPartResult& result, vtkPolyData* part);

private:
  vtkSmartPointer<vtkPolyData> Whole;
  std::vector<DGGPartNumbers> Numbers; // per part
};

#endif
