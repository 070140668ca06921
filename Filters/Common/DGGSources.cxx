// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DGGSources.h"

#include "DGGContext.h"
#include "DGGProperties.h"
#include "DGGSurfaceArrays.h"

#include "dggPreparedSurface.h"
#include "dggSourceCollection.h"
#include "dggStatus.h"

#include "vtkAbstractArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <limits>

namespace
{
/// Returns an array with a tuple of `from` per id: the tuple `firstTuple + id - firstId`. For ids
/// below `firstId`, or without such a tuple, the array has `missing` if `from` has floating-point
/// numbers, otherwise 0 or the empty string.
template <typename Id>
vtkSmartPointer<vtkAbstractArray> PickTuples(vtkAbstractArray* from, const std::vector<Id>& ids,
  vtkIdType firstId, vtkIdType firstTuple, double missing)
{
  const auto array =
    vtkSmartPointer<vtkAbstractArray>::Take(vtkAbstractArray::CreateArray(from->GetDataType()));
  array->SetName(from->GetName());
  array->SetNumberOfComponents(from->GetNumberOfComponents());
  array->CopyComponentNames(from);
  array->SetNumberOfTuples(static_cast<vtkIdType>(ids.size()));
  if (auto* numbers = vtkDataArray::SafeDownCast(array))
  {
    const int type = numbers->GetDataType();
    numbers->Fill(type == VTK_FLOAT || type == VTK_DOUBLE ? missing : 0.0);
  }
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    const vtkIdType tuple = firstTuple + ids[i] - firstId;
    if (ids[i] >= firstId && tuple < from->GetNumberOfTuples())
    {
      array->SetTuple(static_cast<vtkIdType>(i), tuple, from);
    }
  }
  return array;
}

/// Copies the tuples of the points of a set.
std::vector<double> Gather(const DGGSourceSet& set, vtkDataArray* array)
{
  const auto components = static_cast<std::size_t>(array->GetNumberOfComponents());
  std::vector<double> values(set.CountPoints() * components);
  for (std::size_t i = 0; i < set.CountPoints(); ++i)
  {
    array->GetTuple(set.GetPointId(i), values.data() + i * components);
  }
  return values;
}

/// Copies a point array that identifies points; empty if the array is missing or its size is wrong.
std::vector<double> ReadIdentities(const DGGSourceSet& set, const char* name, int components)
{
  vtkDataArray* array = set.Points->GetPointData()->GetArray(name);
  return array && array->GetNumberOfComponents() == components &&
      array->GetNumberOfTuples() == set.Points->GetNumberOfPoints()
    ? Gather(set, array)
    : std::vector<double>();
}

dgg::Status ReadInitialDistances(const DGGSourceSet& set, std::vector<double>& distances)
{
  vtkDataArray* array = nullptr;
  vtkAbstractArray* found =
    set.Points->GetPointData()->GetAbstractArray(set.InitialDistanceArray.c_str());
  if (found)
  {
    DGG_RETURN_IF_ERROR(
      DGGCheckPointArray(found, set.Points, dgg::JoinText("input port ", set.Port), 1, array));
    distances = Gather(set, array);
  }
  return dgg::Status::Success();
}

dgg::Status ReadPoints(const DGGSourceSet& set, dgg::SourceCollection& sources)
{
  vtkDataArray* positions = set.Points->GetPoints()->GetData();
  sources.Positions = Gather(set, positions);
  sources.AreRounded = positions->GetDataType() != VTK_DOUBLE;
  sources.OriginalIds = ReadIdentities(set, "vtkOriginalPointIds", 1);
  sources.Cells = ReadIdentities(set, "FaceId", 1);
  sources.Barycentric = ReadIdentities(set, "Barycentric", 3);
  vtkPointData* data = set.Points->GetPointData();
  if (sources.OriginalIds.empty() && data->HasArray("FaceId") && data->HasArray("Barycentric") &&
    (sources.Cells.empty() || sources.Barycentric.empty()))
  {
    return dgg::InvalidInput("The point arrays FaceId and Barycentric of input port ", set.Port,
      " are not numeric with 1 and 3 components and one tuple per point")
      .Fix("Correct the arrays, or remove Barycentric");
  }
  return set.InitialDistanceArray.empty() ? dgg::Status::Success()
                                          : ReadInitialDistances(set, sources.InitialDistances);
}
}

//------------------------------------------------------------------------------
std::size_t DGGSourceSet::CountPoints() const
{
  if (!this->Points)
  {
    return 0;
  }
  return this->PointIds ? this->PointIds->size()
                        : static_cast<std::size_t>(this->Points->GetNumberOfPoints());
}

//------------------------------------------------------------------------------
vtkIdType DGGSourceSet::GetPointId(std::size_t i) const
{
  return this->PointIds ? (*this->PointIds)[i] : static_cast<vtkIdType>(i);
}

//------------------------------------------------------------------------------
dgg::Status DGGCollect(const DGGSourceSet& set, dgg::SourceCollection& sources)
{
  sources.Role = set.Role;
  sources.Property = set.Property;
  sources.ArePairs = set.ArePairs;
  sources.Input = dgg::JoinText("input port ", set.Port);
  sources.Surface = set.Surface;
  sources.Ids.assign(set.Ids.begin(), set.Ids.end());
  sources.IsConnected = set.Points != nullptr;
  if (set.InitialDistances)
  {
    sources.InitialDistancesOfIds = *set.InitialDistances;
  }
  if (set.PointIds)
  {
    sources.Indices.assign(set.PointIds->begin(), set.PointIds->end());
  }
  return set.CountPoints() > 0 ? ReadPoints(set, sources) : dgg::Status::Success();
}

//------------------------------------------------------------------------------
dgg::Status DGGLocate(const DGGContext& context, const DGGSourceSet& set, double tolerance,
  std::vector<dgg::GeodesicSource>& sources, vtkObject* filter)
{
  dgg::SourceCollection collection;
  std::vector<std::string> warnings;
  DGG_RETURN_IF_ERROR(DGGCollect(set, collection));
  DGG_RETURN_IF_ERROR(collection.Locate(context, tolerance, sources, &warnings));
  for (const std::string& warning : warnings)
  {
    if (filter)
    {
      vtkWarningWithObjectMacro(filter, << DGGRender(warning) << ".");
    }
  }
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
dgg::Status DGGLocate(const DGGContext& context, const DGGSourceSet& set, double tolerance,
  std::vector<dgg::SurfacePoint>& points, vtkObject* filter)
{
  std::vector<dgg::GeodesicSource> sources;
  DGG_RETURN_IF_ERROR(DGGLocate(context, set, tolerance, sources, filter));
  points = dgg::GetPoints(sources);
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
void DGGPassLineArrays(vtkPolyData* data, const std::vector<dgg::Offset>& lines, vtkIdType first,
  vtkDataSetAttributes* output)
{
  if (!data)
  {
    return;
  }
  for (int a = 0; a < data->GetCellData()->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* array = data->GetCellData()->GetAbstractArray(a);
    if (!array->GetName() || !output->HasArray(array->GetName()))
    {
      output->AddArray(PickTuples(array, lines, first, data->GetNumberOfVerts(), 0.0));
    }
  }
}

//------------------------------------------------------------------------------
void DGGPassArrays(
  const DGGSourceSet& set, const std::vector<dgg::Id>& nearest, vtkDataSetAttributes* output)
{
  if (!set.Points)
  {
    return;
  }
  const auto first = static_cast<vtkIdType>(set.Ids.size());
  vtkPointData* data = set.Points->GetPointData();
  for (int k = 0; k < data->GetNumberOfArrays(); ++k)
  {
    vtkAbstractArray* values = data->GetAbstractArray(k);
    const std::string name = values->GetName() ? values->GetName() : "";
    // Ghost flags and identities describe the source, not the points nearest to it.
    if (!name.empty() && name != vtkDataSetAttributes::GhostArrayName() &&
      name != "vtkOriginalPointIds" && name != "Barycentric" && !output->HasArray(name.c_str()) &&
      values->GetNumberOfTuples() == set.Points->GetNumberOfPoints())
    {
      output->AddArray(
        PickTuples(values, nearest, first, 0, std::numeric_limits<double>::quiet_NaN()));
    }
  }
}
