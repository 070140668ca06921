// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Distances of a vtkPolyData and the arrays that belong to them. Internal.
#ifndef DGGFieldInput_h
#define DGGFieldInput_h

#include "dggStatus.h" // for Status

#include <string> // for names

class vtkDataArray;
class vtkInformation;
class vtkPolyData;
namespace dgg
{
class FieldReader;
}
struct DGGContext;

/// Finds the point array that a filter uses: the array of its SetInputArrayToProcess(), or else the
/// array that its property names; the active scalars if that name is empty. There is no fallback to
/// another array: fails, with the names of existing arrays, if the array is missing or does not
/// have one number per point. `filter` is the information object of the filter.
dgg::Status DGGFindDistances(vtkInformation* filter, const std::string& property,
  vtkPolyData* surface, vtkDataArray*& distances);

///@{
/// Returns the base name of result arrays: the name of the distances, or "GeodesicDistance" if they
/// have no name. The second form is for a filter that has not called DGGFindDistances().
std::string DGGGetDistanceName(vtkDataArray* distances);
std::string DGGGetDistanceName(vtkInformation* filter, const std::string& property);
///@}

/// Reads distances and the marks of unreached points, windows and virtual sources that belong to
/// them: see dgg::FieldReader. `virtualSources` is the name of a point array; null for a field that
/// is linear in each face.
dgg::Status DGGReadField(const DGGContext& context, vtkDataArray* distances, double unreachedValue,
  const char* virtualSources, const dgg::ProgressCallback& progress, dgg::FieldReader& reader);

/// Removes the arrays that belong to distances from a surface: marks of unreached points
/// (dgg::AddDistances()) and windows (DGGWindowArrays).
void DGGRemoveDistances(vtkPolyData* surface, const std::string& distances);

#endif
