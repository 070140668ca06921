// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DGGGraphicsInput.h"

#include "dggPreparedSurface.h"

#include "dggStatus.h"

#include "vtkAbstractArray.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

namespace
{
constexpr std::size_t NoRegion = std::numeric_limits<std::size_t>::max();
/// Values of CurveType.
constexpr dgg::GraphicsCurveType Types[] = { dgg::GraphicsCurveType::Diffusion,
  dgg::GraphicsCurveType::Poisson, dgg::GraphicsCurveType::Region, dgg::GraphicsCurveType::Source };

/// Runs a function and returns the error that it throws.
template <typename Function>
dgg::Status Try(Function&& function)
{
  try
  {
    function();
  }
  catch (const dgg::Status& status)
  {
    return status;
  }
  return dgg::Status::Success();
}

/// Returns an array of numbers, or null. An array of this name with another type is an error,
/// because the result without the array would be wrong.
vtkDataArray* FindNumbers(vtkDataSetAttributes* data, const char* kind, const std::string& name)
{
  vtkAbstractArray* array = data->GetAbstractArray(name.c_str());
  vtkDataArray* numbers = data->GetArray(name.c_str());
  if (!numbers && array)
  {
    throw dgg::InvalidInput(
      "The ", kind, " array '", name, "' has the type ", array->GetDataTypeAsString())
      .Fix("Use an array of numbers");
  }
  return numbers;
}

/// A point array, or else a cell array of this name.
struct FoundArray
{
  FoundArray(vtkPolyData* data, const std::string& name)
    : Array(data->GetPointData()->GetArray(name.c_str()))
    , IsOfPoints(Array != nullptr)
  {
    Array = Array ? Array : data->GetCellData()->GetArray(name.c_str());
    if (!Array)
    {
      FindNumbers(data->GetPointData(), "point", name);
      FindNumbers(data->GetCellData(), "cell", name);
    }
  }

  vtkDataArray* Array;
  bool IsOfPoints;
};

/// Returns a cell array with one number per cell. `property` contains its name.
vtkDataArray* GetCellNumbers(vtkPolyData* surface, const std::string& name, const char* property)
{
  vtkDataArray* array = FindNumbers(surface->GetCellData(), "cell", name);
  if (!array || array->GetNumberOfComponents() != 1 ||
    array->GetNumberOfTuples() != surface->GetNumberOfCells())
  {
    throw dgg::InvalidInput("The surface has no cell array '", name, "' with one number per cell")
      .At(property)
      .Fix("Set {", property, "} to the name of one");
  }
  return array;
}

double GetNumber(vtkDataArray* array, vtkIdType cell, const char* remedy)
{
  const double number = array->GetComponent(cell, 0);
  if (std::isnan(number))
  {
    throw dgg::InvalidInput("The cell array '", array->GetName(), "' has no number at cell ", cell)
      .Fix(remedy);
  }
  return number;
}

/// Returns true if all points coincide.
bool HasNoLength(vtkPolyData* curves, const std::vector<vtkIdType>& points)
{
  double first[3];
  curves->GetPoint(points[0], first);
  return std::all_of(points.begin(), points.end(), [&](vtkIdType id) {
    double place[3];
    curves->GetPoint(id, place);
    return std::equal(place, place + 3, first);
  });
}

/// Returns the factor that scales colors to [0, 1]; bytes are divided by 255.
double ScaleOf(vtkDataArray* array)
{
  return array->GetDataType() == VTK_UNSIGNED_CHAR ? 1.0 / 255.0 : 1.0;
}

void SortUnique(std::vector<dgg::Id>& ids)
{
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
}

std::string Name(vtkIdType cell)
{
  return "Line " + std::to_string(cell) + " of input port 1";
}
}

//------------------------------------------------------------------------------
dgg::Status DGGGraphicsInput::Read(
  vtkPolyData* curves, vtkPolyData* surface, const DGGGraphicsNames& names)
{
  *this = DGGGraphicsInput();
  return Try([&] {
    if (curves)
    {
      this->CollectLines(curves);
    }
    this->ChooseChannels(curves, surface, names);
    for (std::size_t k = 0; k < this->Curves.size(); ++k)
    {
      this->ReadType(curves, names, k);
      this->ReadCurve(curves, names, k);
    }
    if (!names.Region.empty())
    {
      this->ReadRegions(surface, names);
    }
  });
}

//------------------------------------------------------------------------------
void DGGGraphicsInput::CollectLines(vtkPolyData* curves)
{
  vtkIdType cell = curves->GetNumberOfVerts(); // cell ids count verts first
  const auto lines = vtk::TakeSmartPointer(curves->GetLines()->NewIterator());
  for (lines->GoToFirstCell(); !lines->IsDoneWithTraversal(); lines->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    lines->GetCurrentCell(size, ids);
    dgg::GraphicsCurve curve;
    curve.Name = Name(cell);
    curve.IsClosed = size > 2 && ids[0] == ids[size - 1];
    std::vector<vtkIdType> points(ids, ids + (curve.IsClosed ? size - 1 : size));
    for (const vtkIdType id : points)
    {
      if (id < 0 || id >= curves->GetNumberOfPoints())
      {
        throw dgg::InvalidInput(Name(cell), " refers to point ", id, ", which does not exist")
          .Fix("Repair the line");
      }
    }
    if (points.size() < 2 || HasNoLength(curves, points))
    {
      throw dgg::InvalidInput(Name(cell), " has no length")
        .Fix("Give it two points at different positions");
    }
    this->Curves.push_back(curve);
    this->PointIds.push_back(points);
    this->Cells.push_back(cell++);
  }
}

//------------------------------------------------------------------------------
/// Chooses the number of channels: the number of components of the arrays. Strengths with a single
/// component, which applies to all channels, count only if there are no other arrays.
void DGGGraphicsInput::ChooseChannels(
  vtkPolyData* curves, vtkPolyData* surface, const DGGGraphicsNames& names)
{
  const auto componentsOf = [&](const std::string& name) {
    const char* key = name.c_str();
    vtkDataArray* array = curves ? curves->GetPointData()->GetArray(key) : nullptr;
    array = array || !curves ? array : curves->GetCellData()->GetArray(key);
    return array ? array->GetNumberOfComponents() : 0;
  };
  int channels = 0;
  std::string first;
  for (const std::string& name :
    { names.LeftColor, names.RightColor, names.Strength, names.RightStrength })
  {
    const bool isColor = name == names.LeftColor || name == names.RightColor;
    const int count = componentsOf(name);
    if (count == 0 || (count == 1 && !isColor))
    {
      continue;
    }
    if (channels > 0 && count != channels)
    {
      throw dgg::InvalidInput("The array '", first, "' of input port 1 has ", channels,
        " components, but '", name, "' has ", count)
        .Fix("Use one component per channel in both");
    }
    channels = count;
    first = name;
  }
  vtkDataArray* strength = surface->GetCellData()->GetArray(names.RegionStrength.c_str());
  if (channels == 0 && !names.Region.empty() && strength)
  {
    channels = strength->GetNumberOfComponents();
  }
  if (channels == 0 && componentsOf(names.Strength) > 0)
  {
    channels = 1;
  }
  this->NumberOfChannels = channels == 0 ? 3 : channels;
}

//------------------------------------------------------------------------------
void DGGGraphicsInput::ReadType(vtkPolyData* curves, const DGGGraphicsNames& names, std::size_t k)
{
  vtkDataArray* array = FindNumbers(curves->GetCellData(), "cell", names.CurveType);
  if (!array)
  {
    return; // Diffusion
  }
  if (array->GetNumberOfComponents() != 1)
  {
    throw dgg::InvalidInput("The cell array '", names.CurveType, "' of input port 1 has ",
      array->GetNumberOfComponents(), " components")
      .Fix("Use an array with one component");
  }
  const double value = this->Cells[k] < array->GetNumberOfTuples()
    ? array->GetComponent(this->Cells[k], 0)
    : std::numeric_limits<double>::quiet_NaN();
  if (!(value == 0.0 || value == 1.0 || value == 2.0 || value == 3.0))
  {
    throw dgg::InvalidInput(
      Name(this->Cells[k]), " has the type ", value, " in the cell array '", names.CurveType, "'")
      .Fix("Use 0 (Diffusion), 1 (Poisson), 2 (Region) or 3 (Source)");
  }
  this->Curves[k].Type = Types[static_cast<int>(value)];
}

//------------------------------------------------------------------------------
/// Returns the values of all points of a curve. If the array is a cell array, each point has the
/// value of the cell.
std::vector<double> DGGGraphicsInput::ReadTuples(
  vtkPolyData* curves, const std::string& name, std::size_t k, int channels, bool mayBeSingle) const
{
  const FoundArray found(curves, name);
  vtkDataArray* array = found.Array;
  const vtkIdType tuples =
    found.IsOfPoints ? curves->GetNumberOfPoints() : curves->GetNumberOfCells();
  if (!array)
  {
    throw dgg::InvalidInput(Name(this->Cells[k]), " needs a point or cell array '", name, "'")
      .Fix("Add the array, or set the name of another one");
  }
  if (array->GetNumberOfTuples() != tuples)
  {
    throw dgg::InvalidInput(
      "The array '", name, "' of input port 1 has ", array->GetNumberOfTuples(), " tuples")
      .Fix("Use an array with ", tuples, " tuples");
  }
  const int components = array->GetNumberOfComponents();
  if (components != channels && !(mayBeSingle && components == 1))
  {
    throw dgg::InvalidInput(
      "The array '", name, "' of input port 1 has ", components, " components")
      .Fix("Use an array with ", channels,
        mayBeSingle && channels > 1 ? " components or 1" : " components");
  }
  std::vector<double> values;
  for (const vtkIdType id : this->PointIds[k])
  {
    for (int c = 0; c < channels; ++c)
    {
      const vtkIdType tuple = found.IsOfPoints ? id : this->Cells[k];
      const double value = array->GetComponent(tuple, components == 1 ? 0 : c);
      if (!std::isfinite(value))
      {
        throw dgg::InvalidInput("The array '", name, "' of input port 1 has the value ", value,
          " at ", found.IsOfPoints ? "point " : "cell ", tuple)
          .Fix("Use finite numbers");
      }
      values.push_back(ScaleOf(array) * value);
    }
  }
  return values;
}

//------------------------------------------------------------------------------
void DGGGraphicsInput::ReadCurve(vtkPolyData* curves, const DGGGraphicsNames& names, std::size_t k)
{
  dgg::GraphicsCurve& curve = this->Curves[k];
  const int channels = this->NumberOfChannels;
  if (curve.Type == dgg::GraphicsCurveType::Diffusion)
  {
    curve.Left = this->ReadTuples(curves, names.LeftColor, k, channels, false);
    curve.Right = this->ReadTuples(curves, names.RightColor, k, channels, false);
    return;
  }
  curve.Left = this->ReadTuples(curves, names.Strength, k, channels, true);
  if (curve.Type != dgg::GraphicsCurveType::Poisson)
  {
    return;
  }
  if (FoundArray(curves, names.RightStrength).Array)
  {
    curve.Right = this->ReadTuples(curves, names.RightStrength, k, channels, true);
  }
  else
  {
    curve.Right = curve.Left;
    std::transform(curve.Right.begin(), curve.Right.end(), curve.Right.begin(), std::negate<>());
  }
  // The width is constant along a curve: that of its cell, or of its first point.
  curve.Width = names.DefaultWidth;
  const FoundArray width(curves, names.Width);
  if (width.Array)
  {
    this->ReadTuples(curves, names.Width, k, 1, false); // checks all values
    curve.Width =
      width.Array->GetComponent(width.IsOfPoints ? this->PointIds[k].front() : this->Cells[k], 0);
  }
  if (!(curve.Width > 0.0) || !std::isfinite(curve.Width))
  {
    throw dgg::InvalidInput(Name(this->Cells[k]), " has the width ", curve.Width)
      .At("Width")
      .Fix("Use a finite positive width");
  }
}

//------------------------------------------------------------------------------
void DGGGraphicsInput::ReadRegions(vtkPolyData* surface, const DGGGraphicsNames& names)
{
  vtkCellData* data = surface->GetCellData();
  FindNumbers(data, "cell", names.Region);
  vtkDataArray* strength = FindNumbers(data, "cell", names.RegionStrength);
  vtkDataArray* regions = GetCellNumbers(surface, names.Region, "RegionArrayName");
  const vtkIdType cells = surface->GetNumberOfCells();
  const int components = strength ? strength->GetNumberOfComponents() : 0;
  if (!strength || strength->GetNumberOfTuples() != cells ||
    (components != 1 && components != this->NumberOfChannels))
  {
    throw dgg::InvalidInput("The surface has no cell array '", names.RegionStrength, "' with 1 or ",
      this->NumberOfChannels, " components")
      .At("RegionStrengthArrayName")
      .Fix("Set {RegionStrengthArrayName} to the name of one");
  }
  std::unordered_map<double, std::size_t> found;
  this->RegionOfCell.assign(static_cast<std::size_t>(cells), NoRegion);
  for (vtkIdType cell = 0; cell < cells; ++cell)
  {
    const double id = GetNumber(regions, cell, "Use 0 for cells without a region");
    if (id == 0.0)
    {
      continue;
    }
    const auto [region, isNew] = found.emplace(id, found.size());
    this->RegionOfCell[static_cast<std::size_t>(cell)] = region->second;
    if (isNew)
    {
      std::vector<double> values;
      for (int c = 0; c < this->NumberOfChannels; ++c)
      {
        values.push_back(ScaleOf(strength) * strength->GetComponent(cell, components == 1 ? 0 : c));
      }
      if (!std::all_of(values.begin(), values.end(), [](double x) { return std::isfinite(x); }))
      {
        throw dgg::InvalidInput(
          "The cell array '", names.RegionStrength, "' is not finite at cell ", cell)
          .Fix("Use finite numbers");
      }
      this->RegionStrengths.push_back(values);
    }
  }
}

//------------------------------------------------------------------------------
std::vector<dgg::GraphicsRegion> DGGGraphicsInput::MakeRegions(
  const dgg::PreparedSurface& mesh) const
{
  std::vector<dgg::GraphicsRegion> regions;
  for (const std::vector<double>& strength : this->RegionStrengths)
  {
    regions.push_back({ {}, strength });
  }
  const auto regionOf = [&](dgg::Id face) {
    const auto cell = static_cast<std::size_t>(mesh.GetCell(face));
    return cell < this->RegionOfCell.size() ? this->RegionOfCell[cell] : NoRegion;
  };
  for (dgg::Id f = 0; f < mesh.GetMesh().GetNumberOfFaces() && !regions.empty(); ++f)
  {
    // If triangles have the same points, the first one with a region determines the region.
    const dgg::Id original = mesh.GetMesh().GetOriginal(f);
    const std::size_t region = regionOf(f);
    if (region != NoRegion && (f == original || regionOf(original) == NoRegion))
    {
      regions[region].Faces.push_back(original);
    }
  }
  for (dgg::GraphicsRegion& region : regions)
  {
    SortUnique(region.Faces);
  }
  regions.erase(std::remove_if(regions.begin(), regions.end(),
                  [](const dgg::GraphicsRegion& region) { return region.Faces.empty(); }),
    regions.end()); // regions of lines or verts
  return regions;
}

//------------------------------------------------------------------------------
dgg::Status DGGGraphicsInput::FindRefinedFaces(vtkPolyData* surface, const DGGGraphicsNames& names,
  const dgg::PreparedSurface& mesh, std::vector<dgg::Id>& faces)
{
  faces.clear();
  return Try([&] {
    vtkDataArray* array = GetCellNumbers(surface, names.Refinement, "RefinementArrayName");
    for (dgg::Id f = 0; f < mesh.GetMesh().GetNumberOfFaces(); ++f)
    {
      const vtkIdType cell = mesh.GetCell(f);
      if (GetNumber(array, cell, "Use 0, or another number for cells to refine") != 0.0)
      {
        faces.push_back(mesh.GetMesh().GetOriginal(f));
      }
    }
    SortUnique(faces);
  });
}
