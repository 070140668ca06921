// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The surface that parts make. Internal.
#ifndef DGGJoinedParts_h
#define DGGJoinedParts_h

#include "DGGSurfaceParts.h" // for the parts

#include "vtkDataSetAttributes.h" // for the attributes

#include <array>   // for the names
#include <cstddef> // for std::size_t
#include <string>  // for the names

class vtkAbstractArray;

/// How the point data or the cell data of an output differ from those of the input.
struct DGGChangedArrays
{
  std::vector<std::string> Removed;
  std::vector<vtkSmartPointer<vtkAbstractArray>> Added;
  /// Names of active arrays; empty where there is none.
  std::array<std::string, vtkDataSetAttributes::NUM_ATTRIBUTES> Active;
};

/// What an output that is the surface with arrays added is on one part.
struct DGGPartResult
{
  DGGChangedArrays Points;
  DGGChangedArrays Cells;
};

/// Makes one surface of parts, and brings what was found on it back to them.
///
/// Points of parts of one block are the same
///  - if all parts have global ids: when these are equal, which they must not be elsewhere;
///  - else, when they lie in the same place on the rims of different parts. Where a part has
///    several points in one place, at a seam, only those are that are ends of edges which lie in
///    the same place.
///
/// Points are numbered block by block, in each of them by global ids or else part by part in the
/// order in which they come; cells alike, within their kind, where those with the same global id on
/// the same points are one. A part that another process has as well counts once. One part alone
/// stays as it is.
class VTKDGGFILTERSCOMMON_EXPORT DGGJoinedParts
{
public:
  dgg::Status Join(const std::vector<DGGSurfacePart>& parts);

  vtkPolyData* GetWhole() const { return this->Whole; }

  /// Of an output that has the points and cells of the whole.
  DGGPartResult MakeResult(vtkPolyData* output, std::size_t part) const;

  static void AddResult(const DGGPartResult& result, vtkPolyData* part);

private:
  vtkSmartPointer<vtkPolyData> Whole;
  std::vector<DGGPartNumbers> Numbers; // per part
};

#endif
