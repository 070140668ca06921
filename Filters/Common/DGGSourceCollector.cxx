// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DGGSourceCollector.h"

#include "DGGCellCoordinates.h"
#include "DGGContext.h"

#include "dggInvalidInput.h"
#include "dggLocator.h"
#include "dggPreparedSurface.h"

#include "vtkAbstractArray.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkVariant.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace
{
bool IsIsolated(const dgg::PreparedSurface& surface, dgg::Id vertex)
{
  const dgg::SurfaceMesh& mesh = surface.GetMeshWithoutAngles();
  return mesh.FanBegin(vertex) == mesh.FanEnd(vertex);
}

vtkIdType CountPoints(const DGGSourceSet& set)
{
  if (!set.Points)
  {
    return 0;
  }
  return set.PointIds ? static_cast<vtkIdType>(set.PointIds->size())
                      : set.Points->GetNumberOfPoints();
}

/// The i-th of the points that are meant.
vtkIdType GetPointId(const DGGSourceSet& set, vtkIdType i)
{
  return set.PointIds ? (*set.PointIds)[i] : i;
}

/// "source point 3 of input port 1"
std::string Describe(const DGGSourceSet& set, vtkIdType index)
{
  const bool isPoint = set.Role.find("point") != std::string::npos;
  return dgg::JoinText(set.Role, isPoint ? " " : " point ", index, " of input port ", set.Port);
}

/// "source point 3 of input port 1, at (x, y, z),"
std::string Describe(const DGGSourceSet& set, vtkIdType index, const double p[3])
{
  return dgg::JoinText(Describe(set, index), ", at (", p[0], ", ", p[1], ", ", p[2], "),");
}

/// Returns the rounding error of coordinates, relative to the largest one. Outputs of filters,
/// which identify points of inputs in double precision, may be in single precision.
double GetRounding(vtkPoints* points)
{
  constexpr double ulps = 8.0;
  return points->GetDataType() == VTK_DOUBLE ? ulps * std::numeric_limits<double>::epsilon()
                                             : std::numeric_limits<float>::epsilon();
}

/// That of the i-th id.
double GetInitialDistance(const DGGSourceSet& set, std::size_t i)
{
  return set.InitialDistances ? (*set.InitialDistances)[i] : 0.0;
}

dgg::Status CheckIds(const DGGSourceSet& set, vtkIdType numberOfPoints)
{
  for (std::size_t i = 0; i < set.Ids.size(); ++i)
  {
    if (set.Ids[i] < 0 || set.Ids[i] >= numberOfPoints)
    {
      return dgg::InvalidInput(set.Role, " id ", set.Ids[i], " (number ", i, " of the ", set.Role,
        " ids) is out of range: the ", set.Surface, " has ", numberOfPoints,
        " points, so ids must be in [0, ", numberOfPoints - 1, "]");
    }
    const double offset = GetInitialDistance(set, i);
    if (!std::isfinite(offset))
    {
      return dgg::InvalidInput(set.Role, " id ", set.Ids[i], " (number ", i, " of the ", set.Role,
        " ids) has the initial distance ", offset, ": a finite number is needed");
    }
  }
  return dgg::Status::Success();
}

/// The point arrays by which points of an input port identify points of a surface.
class Identities
{
public:
  Identities(const DGGContext& context, const DGGSourceSet& set)
    : Context(context)
    , Set(set)
    , Cells(context.Input, context.Surface)
    , Ids(this->Find("vtkOriginalPointIds", 1))
    , Faces(this->Find("FaceId", 1))
    , Weights(this->Find("Barycentric", 3))
    , Rounding(GetRounding(set.Points->GetPoints()))
  {
  }

  /// Fails if arrays of the right names have other sizes.
  dgg::Status Check() const
  {
    vtkPointData* data = this->Set.Points->GetPointData();
    const bool isMeant = !this->Ids && data->HasArray("FaceId") && data->HasArray("Barycentric");
    return isMeant && !(this->Faces && this->Weights)
      ? dgg::InvalidInput("the point arrays FaceId and Barycentric of input port ", this->Set.Port,
          " must be numeric, with 1 and 3 components and one tuple per point. Correct the arrays "
          "or remove Barycentric.")
      : dgg::Status::Success();
  }

  /// Finds the surface point that the arrays identify and sets `isFound`. If the cell has no area,
  /// moves `position` to the point in the cell. With all three arrays, which may belong to another
  /// surface, an array counts only if the point lies there.
  dgg::Status Resolve(
    vtkIdType index, double position[3], dgg::SurfacePoint& point, bool& isFound) const
  {
    isFound = false;
    if (this->Faces && this->Weights)
    {
      const double cell = this->Faces->GetComponent(index, 0);
      std::array<double, 3> weights{};
      this->Weights->GetTuple(index, weights.data());
      const std::string problem = this->Cells.Check(cell, weights);
      if (!this->Ids && !problem.empty())
      {
        return dgg::Status::Invalid(Describe(this->Set, index, position) + " " + problem);
      }
      const auto id = static_cast<vtkIdType>(problem.empty() ? cell : 0.0);
      if (problem.empty() &&
        (!this->Ids || this->Cells.IsAt(id, weights, position, this->Rounding)))
      {
        isFound = this->Cells.FindPoint(id, weights, point);
        const std::array<double, 3> found = this->Cells.GetPosition(id, weights);
        std::copy(found.begin(), found.end(), position);
        return dgg::Status::Success();
      }
    }
    const vtkIdType original = this->Ids ? this->FindOriginal(index, position) : -1;
    if (original >= 0)
    {
      point = dgg::SurfacePoint::AtVertex(this->Context.Surface.GetVertex(original));
      isFound = true;
    }
    return dgg::Status::Success();
  }

private:
  /// Returns the array of this name; null if its size is wrong.
  vtkDataArray* Find(const char* name, int components) const
  {
    vtkDataArray* array = this->Set.Points->GetPointData()->GetArray(name);
    return array && array->GetNumberOfComponents() == components &&
        array->GetNumberOfTuples() == this->Set.Points->GetNumberOfPoints()
      ? array
      : nullptr;
  }

  /// The point id that the array names, if the point lies there; else -1.
  vtkIdType FindOriginal(vtkIdType index, const double p[3]) const
  {
    vtkPoints* coordinates = this->Context.Input->GetPoints();
    const double id = this->Ids->GetComponent(index, 0);
    if (!(id >= 0.0 && id < static_cast<double>(coordinates->GetNumberOfPoints())))
    {
      return -1;
    }
    double q[3];
    coordinates->GetPoint(static_cast<vtkIdType>(id), q);
    const double largest = std::max({ std::abs(q[0]), std::abs(q[1]), std::abs(q[2]) });
    const bool isThere = std::equal(
      p, p + 3, q, [&](double a, double b) { return std::abs(a - b) <= this->Rounding * largest; });
    return isThere ? static_cast<vtkIdType>(id) : -1;
  }

  const DGGContext& Context;
  const DGGSourceSet& Set;
  DGGCellCoordinates Cells;
  vtkDataArray* Ids;
  vtkDataArray* Faces;
  vtkDataArray* Weights;
  double Rounding;
};

/// Finds the point of the surface that is closest to the position of a point of the set.
dgg::Status FindClosest(const DGGContext& context, const DGGSourceSet& set, vtkIdType id,
  const double p[3], double tolerance, dgg::SurfacePoint& point)
{
  const dgg::PreparedSurface& mesh = context.Surface;
  const dgg::Locator& locator = mesh.GetLocator();
  const double farthest = tolerance * locator.GetDiagonal();
  double distance = dgg::Infinity;
  if (!locator.FindClosestPoint(p, point, distance) || !locator.IsClose(point, distance, farthest))
  {
    return dgg::InvalidInput(Describe(set, id, p), " is ", distance, " away from the ",
      mesh.IsCloud()             ? "cloud"
        : set.Surface == "input" ? "surface"
                                 : set.Surface,
      ", farther than ", farthest, " (ProjectionTolerance ", tolerance, " times the diagonal ",
      locator.GetDiagonal(), "): move it there, or raise ProjectionTolerance");
  }
  return dgg::Status::Success();
}

dgg::Status CheckInitialDistances(vtkPolyData* points, const std::string& name)
{
  const vtkIdType count = points->GetNumberOfPoints();
  vtkPointData* data = points->GetPointData();
  vtkDataArray* array = data->GetArray(name.c_str());
  if (!array)
  {
    if (data->GetAbstractArray(name.c_str()))
    {
      return dgg::InvalidInput("the point array '", name,
        "' of input port 1 is not numeric: InitialDistance needs one number per source point");
    }
    return dgg::Status::Success();
  }
  if (array->GetNumberOfComponents() != 1 || array->GetNumberOfTuples() != count)
  {
    return dgg::InvalidInput("the point array '", name, "' of input port 1 has ",
      array->GetNumberOfComponents(), " components and ", array->GetNumberOfTuples(),
      " tuples for ", count, " source points: one number per source point is needed");
  }
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double value = array->GetComponent(i, 0);
    if (!std::isfinite(value))
    {
      return dgg::InvalidInput("the point array '", name, "' of input port 1 gives source point ",
        i, " the initial distance ", value, ": a finite number is needed");
    }
  }
  return dgg::Status::Success();
}
}

//------------------------------------------------------------------------------
std::vector<dgg::SurfacePoint> DGGGetPlaces(const std::vector<dgg::GeodesicSource>& sources)
{
  std::vector<dgg::SurfacePoint> places;
  places.reserve(sources.size());
  for (const dgg::GeodesicSource& source : sources)
  {
    places.push_back(source.Point);
  }
  return places;
}

//------------------------------------------------------------------------------
dgg::Status DGGSourceCollector::Check(const DGGSourceSet& set, vtkIdType numberOfPoints)
{
  if (set.Ids.empty() && CountPoints(set) == 0)
  {
    return set.Points ? dgg::InvalidInput("there is no ", set.Role, ": input port ", set.Port,
                          " has no points. Give it points, or ", set.Remedy)
                      : dgg::InvalidInput("there is no ", set.Role, ": ", set.Remedy,
                          ", or connect points to input port ", set.Port);
  }
  DGG_RETURN_IF_ERROR(CheckIds(set, numberOfPoints));
  for (vtkIdType i = 0; i < CountPoints(set); ++i)
  {
    const vtkIdType id = GetPointId(set, i);
    double p[3];
    set.Points->GetPoint(id, p);
    if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
    {
      return dgg::Status::Invalid(
        Describe(set, id, p) + " has coordinates that are not finite: move or remove it");
    }
  }
  return set.Points && !set.InitialDistanceArray.empty()
    ? CheckInitialDistances(set.Points, set.InitialDistanceArray)
    : dgg::Status::Success();
}

//------------------------------------------------------------------------------
dgg::Status DGGSourceCollector::Collect(const DGGContext& context, const DGGSourceSet& set,
  double tolerance, std::vector<dgg::GeodesicSource>& sources)
{
  const dgg::PreparedSurface& mesh = context.Surface;
  sources.clear();
  for (std::size_t i = 0; i < set.Ids.size(); ++i)
  {
    sources.push_back(
      { dgg::SurfacePoint::AtVertex(mesh.GetVertex(set.Ids[i])), GetInitialDistance(set, i) });
  }
  if (CountPoints(set) == 0)
  {
    return dgg::Status::Success();
  }

  const Identities identities(context, set);
  DGG_RETURN_IF_ERROR(identities.Check());
  vtkDataArray* offsets = set.InitialDistanceArray.empty()
    ? nullptr
    : set.Points->GetPointData()->GetArray(set.InitialDistanceArray.c_str());
  for (vtkIdType i = 0; i < CountPoints(set); ++i)
  {
    const vtkIdType id = GetPointId(set, i);
    double p[3];
    set.Points->GetPoint(id, p);
    dgg::GeodesicSource source;
    source.InitialDistance = offsets ? offsets->GetComponent(id, 0) : 0.0;
    bool isFound = false;
    DGG_RETURN_IF_ERROR(identities.Resolve(id, p, source.Point, isFound));
    if (!isFound)
    {
      DGG_RETURN_IF_ERROR(FindClosest(context, set, id, p, tolerance, source.Point));
    }
    sources.push_back(source);
  }
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
void DGGSourceCollector::PassArrays(
  const DGGSourceSet& set, const std::vector<dgg::Id>& nearest, vtkDataSetAttributes* output)
{
  if (!set.Points)
  {
    return;
  }
  const auto first = static_cast<dgg::Id>(set.Ids.size());
  vtkPointData* data = set.Points->GetPointData();
  for (int k = 0; k < data->GetNumberOfArrays(); ++k)
  {
    vtkAbstractArray* values = data->GetAbstractArray(k);
    const std::string name = values->GetName() ? values->GetName() : "";
    // Ghost flags and identities describe the source, not the points nearest to it.
    if (name.empty() || name == vtkDataSetAttributes::GhostArrayName() ||
      name == "vtkOriginalPointIds" || name == "Barycentric" || output->HasArray(name.c_str()) ||
      values->GetNumberOfTuples() != set.Points->GetNumberOfPoints())
    {
      continue;
    }
    const auto array =
      vtkSmartPointer<vtkAbstractArray>::Take(vtkAbstractArray::CreateArray(values->GetDataType()));
    const int components = values->GetNumberOfComponents();
    array->SetName(name.c_str());
    array->SetNumberOfComponents(components);
    array->CopyComponentNames(values);
    array->SetNumberOfTuples(static_cast<vtkIdType>(nearest.size()));
    const bool isReal = values->GetDataType() == VTK_FLOAT || values->GetDataType() == VTK_DOUBLE;
    const vtkVariant nothing = vtkStringArray::SafeDownCast(values)
      ? vtkVariant("")
      : vtkVariant(isReal ? std::numeric_limits<double>::quiet_NaN() : 0.0);
    for (std::size_t i = 0; i < nearest.size(); ++i)
    {
      const auto place = static_cast<vtkIdType>(i);
      if (nearest[i] >= first)
      {
        array->SetTuple(place, GetPointId(set, nearest[i] - first), values);
        continue;
      }
      for (int c = 0; c < components; ++c)
      {
        array->SetVariantValue(place * components + c, nothing);
      }
    }
    output->AddArray(array);
  }
}

//------------------------------------------------------------------------------
void DGGSourceCollector::WarnAboutIsolated(const DGGContext& context, const DGGSourceSet& set,
  const std::vector<dgg::GeodesicSource>& sources, vtkObject* filter)
{
  const dgg::PreparedSurface& mesh = context.Surface;
  const double* positions = mesh.IsCloud() ? mesh.GetPositions() : nullptr;
  const auto isIsolated = [&](const dgg::SurfacePoint& point) {
    if (!dgg::IsVertex(point))
    {
      return false;
    }
    if (!positions)
    {
      return IsIsolated(mesh, point.Vertex);
    }
    const double* p = positions + 3 * static_cast<std::size_t>(point.Vertex);
    return !std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]);
  };
  std::size_t count = 0;
  std::string first;
  for (std::size_t i = 0; i < sources.size(); ++i)
  {
    if (isIsolated(sources[i].Point) && ++count == 1)
    {
      const std::size_t numberOfIds = set.Ids.size();
      first = i < numberOfIds
        ? dgg::JoinText(set.Role, " id ", set.Ids[i])
        : Describe(set, GetPointId(set, static_cast<vtkIdType>(i - numberOfIds)));
    }
  }
  if (count > 0)
  {
    const std::string all = count == 1
      ? first + " is a point"
      : dgg::JoinText(first, " and ", count - 1, " more are points");
    vtkWarningWithObjectMacro(filter,
      << all << (positions ? " with coordinates that are not finite" : " that no polygon uses")
      << ". Such points reach no other point. Choose points "
      << (positions ? "with finite coordinates." : "of polygons."));
  }
}
