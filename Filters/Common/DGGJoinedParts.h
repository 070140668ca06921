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
/// dgg::JoinSurfacePieces() documents the order of points and cells, and which are identified. A
/// part that another process has as well counts once. A single part is unchanged, but if the other
/// parts are empty, global ids number its points.
class VTKDGGFILTERSCOMMON_EXPORT DGGJoinedParts
{
public:
  dgg::Status Join(const std::vector<DGGSurfacePart>& parts);

  vtkPolyData* GetWhole() const { return this->Whole; }
  /// Returns the ids of the points of a part on the joined surface.
  const std::vector<dgg::Offset>& GetPointIds(std::size_t part) const
  {
    return this->Ids[part].Points;
  }

  /// Returns the result on a part of an output that has the points and cells of the joined surface.
  DGGPartResult MakeResult(vtkPolyData* output, std::size_t part) const;

  static void AddResult(const DGGPartResult& result, vtkPolyData* part);

private:
  vtkSmartPointer<vtkPolyData> Whole;
  std::vector<dgg::PieceIds> Ids; // per part
};

#endif
