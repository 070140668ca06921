// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDGGGraphicsInput.h"

#include "vtkDGGMeshAdapter.h"

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
#include <sstream>
#include <unordered_map>

namespace
{
constexpr std::size_t NoRegion = std::numeric_limits<std::size_t>::max();
/// Values of CurveType.
constexpr dgg::GraphicsCurveType Types[] = { dgg::GraphicsCurveType::Diffusion,
  dgg::GraphicsCurveType::Poisson, dgg::GraphicsCurveType::Region, dgg::GraphicsCurveType::Source };
constexpr int NumberOfTypes = 4;

/// An array of points, or else one of cells.
vtkDataArray* FindArray(vtkPolyData* data, const std::string& name, bool& isOfPoints)
{
  vtkDataArray* array = data->GetPointData()->GetArray(name.c_str());
  isOfPoints = array != nullptr;
  return isOfPoints ? array : data->GetCellData()->GetArray(name.c_str());
}

/// Fails when there is an array of another type than numbers by that name, and none of numbers. To
/// pass over it would mean another picture.
dgg::Status CheckHoldsNumbers(vtkDataSetAttributes* data, const char* kind, const std::string& name)
{
  vtkAbstractArray* array = data->GetAbstractArray(name.c_str());
  return array && !vtkDataArray::SafeDownCast(array)
    ? dgg::Status::Invalid("the " + std::string(kind) + " array '" + name + "' is of type " +
        array->GetDataTypeAsString() + " where numbers are needed")
    : dgg::Status::Success();
}

/// The same for an array of points or cells.
dgg::Status CheckHoldsNumbers(vtkPolyData* data, const std::string& name)
{
  bool isOfPoints = false;
  if (FindArray(data, name, isOfPoints))
  {
    return dgg::Status::Success();
  }
  const dgg::Status status = CheckHoldsNumbers(data->GetPointData(), "point", name);
  return status.IsOk() ? CheckHoldsNumbers(data->GetCellData(), "cell", name) : status;
}

/// Whether all points are in one place.
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

/// Colours in bytes are from 0 to 1.
double ScaleOf(vtkDataArray* array)
{
  return array->GetDataType() == VTK_UNSIGNED_CHAR ? 1.0 / 255.0 : 1.0;
}

std::string Name(vtkIdType cell)
{
  return "line " + std::to_string(cell) + " of input port 1";
}
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGGraphicsInput::Read(
  vtkPolyData* curves, vtkPolyData* surface, const vtkDGGGraphicsNames& names)
{
  *this = vtkDGGGraphicsInput();
  dgg::Status status;
  if (curves)
  {
    status = this->CollectLines(curves);
  }
  status = status.IsOk() ? this->ChooseChannels(curves, surface, names) : status;
  for (std::size_t k = 0; k < this->Curves.size() && status.IsOk(); ++k)
  {
    status = this->ReadType(curves, names, k);
    status = status.IsOk() ? this->ReadCurve(curves, names, k) : status;
  }
  return status.IsOk() ? this->ReadRegions(surface, names) : status;
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGGraphicsInput::CollectLines(vtkPolyData* curves)
{
  vtkIdType cell = curves->GetNumberOfVerts(); // cells are numbered from verts on
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
        return dgg::Status::Invalid(
          Name(cell) + " has the point " + std::to_string(id) + ", which does not exist");
      }
    }
    if (points.size() < 2 || HasNoLength(curves, points))
    {
      return dgg::Status::Invalid(
        Name(cell) + " has no length: give it two points in different places");
    }
    this->Curves.push_back(curve);
    this->PointIds.push_back(points);
    this->Cells.push_back(cell++);
  }
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
/// As many as the arrays have components, those with a single strength for all channels apart.
dgg::Status vtkDGGGraphicsInput::ChooseChannels(
  vtkPolyData* curves, vtkPolyData* surface, const vtkDGGGraphicsNames& names)
{
  int channels = 0;
  std::string first;
  for (const std::string& name :
    { names.LeftColor, names.RightColor, names.Strength, names.RightStrength })
  {
    bool isOfPoints = false;
    vtkDataArray* array = curves ? FindArray(curves, name, isOfPoints) : nullptr;
    const bool isColor = name == names.LeftColor || name == names.RightColor;
    const int count = array ? array->GetNumberOfComponents() : 0;
    if (count == 0 || (count == 1 && !isColor))
    {
      continue;
    }
    if (channels > 0 && count != channels)
    {
      std::ostringstream message;
      message << "the array '" << first << "' of input port 1 has " << channels
              << " components and '" << name << "' has " << count
              << ": give both as many as there are channels";
      return dgg::Status::Invalid(message.str());
    }
    channels = count;
    first = name;
  }
  vtkDataArray* strength = surface->GetCellData()->GetArray(names.RegionStrength.c_str());
  if (channels == 0 && !names.Region.empty() && strength)
  {
    channels = strength->GetNumberOfComponents();
  }
  bool isOfPoints = false;
  if (channels == 0 && curves && FindArray(curves, names.Strength, isOfPoints))
  {
    channels = 1;
  }
  this->NumberOfChannels = channels == 0 ? 3 : channels;
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGGraphicsInput::ReadType(
  vtkPolyData* curves, const vtkDGGGraphicsNames& names, std::size_t k)
{
  vtkDataArray* array = curves->GetCellData()->GetArray(names.CurveType.c_str());
  if (!array)
  {
    // Diffusion, unless something else was meant.
    return CheckHoldsNumbers(curves->GetCellData(), "cell", names.CurveType);
  }
  if (array->GetNumberOfComponents() != 1)
  {
    return dgg::Status::Invalid("the cell array '" + names.CurveType + "' of input port 1 has " +
      std::to_string(array->GetNumberOfComponents()) + " components where 1 is needed");
  }
  const double value = this->Cells[k] < array->GetNumberOfTuples()
    ? array->GetComponent(this->Cells[k], 0)
    : std::numeric_limits<double>::quiet_NaN();
  for (int type = 0; type < NumberOfTypes; ++type)
  {
    if (value == type)
    {
      this->Curves[k].Type = Types[type];
      return dgg::Status::Success();
    }
  }
  std::ostringstream message;
  message << Name(this->Cells[k]) << " has the type " << value << " in the cell array '"
          << names.CurveType << "': use 0 (Diffusion), 1 (Poisson), 2 (Region) or 3 (Source)";
  return dgg::Status::Invalid(message.str());
}

//------------------------------------------------------------------------------
/// The numbers of all points of a curve; those of its cell for each where the array is of cells.
dgg::Status vtkDGGGraphicsInput::ReadTuples(vtkPolyData* curves, const std::string& name,
  std::size_t k, int channels, bool mayBeSingle, std::vector<double>& values) const
{
  const dgg::Status status = CheckHoldsNumbers(curves, name);
  if (!status.IsOk())
  {
    return status;
  }
  bool isOfPoints = false;
  vtkDataArray* array = FindArray(curves, name, isOfPoints);
  std::ostringstream message;
  const int components = array ? array->GetNumberOfComponents() : 0;
  const vtkIdType tuples = isOfPoints ? curves->GetNumberOfPoints() : curves->GetNumberOfCells();
  if (!array)
  {
    message << Name(this->Cells[k]) << " needs a point or cell array '" << name
            << "': add it, or set the name of another one";
  }
  else if (array->GetNumberOfTuples() != tuples)
  {
    message << "the array '" << name << "' of input port 1 has " << array->GetNumberOfTuples()
            << " tuples where " << tuples << " are needed";
  }
  else if (components != channels && !(mayBeSingle && components == 1))
  {
    message << "the array '" << name << "' of input port 1 has " << components
            << " components where " << channels
            << (mayBeSingle && channels > 1 ? " or 1 are needed" : " are needed");
  }
  if (!message.str().empty())
  {
    return dgg::Status::Invalid(message.str());
  }
  const double scale = ScaleOf(array);
  values.clear();
  for (const vtkIdType id : this->PointIds[k])
  {
    for (int c = 0; c < channels; ++c)
    {
      const vtkIdType tuple = isOfPoints ? id : this->Cells[k];
      const double value = array->GetComponent(tuple, components == 1 ? 0 : c);
      if (!std::isfinite(value))
      {
        message << "the array '" << name << "' of input port 1 has the value " << value << " at "
                << (isOfPoints ? "point " : "cell ") << tuple << ": numbers must be finite";
        return dgg::Status::Invalid(message.str());
      }
      values.push_back(scale * value);
    }
  }
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGGraphicsInput::ReadCurve(
  vtkPolyData* curves, const vtkDGGGraphicsNames& names, std::size_t k)
{
  dgg::GraphicsCurve& curve = this->Curves[k];
  if (curve.Type == dgg::GraphicsCurveType::Diffusion)
  {
    const dgg::Status status =
      this->ReadTuples(curves, names.LeftColor, k, this->NumberOfChannels, false, curve.Left);
    return status.IsOk()
      ? this->ReadTuples(curves, names.RightColor, k, this->NumberOfChannels, false, curve.Right)
      : status;
  }
  dgg::Status status =
    this->ReadTuples(curves, names.Strength, k, this->NumberOfChannels, true, curve.Left);
  if (!status.IsOk() || curve.Type != dgg::GraphicsCurveType::Poisson)
  {
    return status;
  }
  status = CheckHoldsNumbers(curves, names.RightStrength);
  bool isOfPoints = false;
  if (!status.IsOk())
  {
    return status;
  }
  if (FindArray(curves, names.RightStrength, isOfPoints))
  {
    status =
      this->ReadTuples(curves, names.RightStrength, k, this->NumberOfChannels, true, curve.Right);
  }
  else
  {
    curve.Right = curve.Left;
    for (double& value : curve.Right)
    {
      value = -value;
    }
  }
  return status.IsOk() ? this->ReadWidth(curves, names, k) : status;
}

//------------------------------------------------------------------------------
/// One number for the whole curve: that of its cell, or of its first point.
dgg::Status vtkDGGGraphicsInput::ReadWidth(
  vtkPolyData* curves, const vtkDGGGraphicsNames& names, std::size_t k)
{
  bool isOfPoints = false;
  vtkDataArray* array = FindArray(curves, names.Width, isOfPoints);
  double& width = this->Curves[k].Width;
  width = names.DefaultWidth;
  if (array)
  {
    std::vector<double> widths;
    const dgg::Status status = this->ReadTuples(curves, names.Width, k, 1, false, widths);
    if (!status.IsOk())
    {
      return status;
    }
    width = array->GetComponent(isOfPoints ? this->PointIds[k].front() : this->Cells[k], 0);
  }
  else
  {
    const dgg::Status status = CheckHoldsNumbers(curves, names.Width);
    if (!status.IsOk())
    {
      return status;
    }
  }
  if (width > 0.0)
  {
    return dgg::Status::Success();
  }
  std::ostringstream message;
  message << Name(this->Cells[k]) << " has the width " << width
          << ": a Poisson curve needs a positive, finite one";
  return dgg::Status::Invalid(message.str());
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGGraphicsInput::ReadRegions(vtkPolyData* surface, const vtkDGGGraphicsNames& names)
{
  if (names.Region.empty())
  {
    return dgg::Status::Success();
  }
  for (const std::string& name : { names.Region, names.RegionStrength })
  {
    const dgg::Status status = CheckHoldsNumbers(surface->GetCellData(), "cell", name);
    if (!status.IsOk())
    {
      return status;
    }
  }
  vtkDataArray* regions = surface->GetCellData()->GetArray(names.Region.c_str());
  vtkDataArray* strength = surface->GetCellData()->GetArray(names.RegionStrength.c_str());
  const vtkIdType cells = surface->GetNumberOfCells();
  const int components = strength ? strength->GetNumberOfComponents() : 0;
  std::ostringstream message;
  if (!regions || regions->GetNumberOfComponents() != 1 || regions->GetNumberOfTuples() != cells)
  {
    message << "the surface has no cell array '" << names.Region
            << "' with one number per cell: call SetRegionArrayName() with the name of one";
  }
  else if (!strength || strength->GetNumberOfTuples() != cells ||
    (components != 1 && components != this->NumberOfChannels))
  {
    message << "the surface has no cell array '" << names.RegionStrength << "' with 1 or "
            << this->NumberOfChannels
            << " components: call SetRegionStrengthArrayName() with the name of one";
  }
  if (!message.str().empty())
  {
    return dgg::Status::Invalid(message.str());
  }
  std::unordered_map<double, std::size_t> found;
  this->RegionOfCell.assign(static_cast<std::size_t>(cells), NoRegion);
  for (vtkIdType cell = 0; cell < cells; ++cell)
  {
    const double id = regions->GetComponent(cell, 0);
    if (std::isnan(id))
    {
      message << "the cell array '" << names.Region << "' has no number at cell " << cell
              << ": use 0 for cells without a region";
      return dgg::Status::Invalid(message.str());
    }
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
        message << "the cell array '" << names.RegionStrength << "' is not finite at cell " << cell;
        return dgg::Status::Invalid(message.str());
      }
      this->RegionStrengths.push_back(values);
    }
  }
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
std::vector<dgg::GraphicsRegion> vtkDGGGraphicsInput::MakeRegions(
  const vtkDGGMeshAdapter& mesh) const
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
    // Of triangles on the same points, the region of the first one counts, if it has one.
    const dgg::Id original = mesh.GetMesh().GetOriginal(f);
    const std::size_t region = regionOf(f);
    if (region != NoRegion && (f == original || regionOf(original) == NoRegion))
    {
      regions[region].Faces.push_back(original);
    }
  }
  for (dgg::GraphicsRegion& region : regions)
  {
    std::sort(region.Faces.begin(), region.Faces.end());
    region.Faces.erase(std::unique(region.Faces.begin(), region.Faces.end()), region.Faces.end());
  }
  regions.erase(std::remove_if(regions.begin(), regions.end(),
                  [](const dgg::GraphicsRegion& region) { return region.Faces.empty(); }),
    regions.end()); // of lines or verts
  return regions;
}

//------------------------------------------------------------------------------
dgg::Status vtkDGGGraphicsInput::CheckRefinement(
  vtkPolyData* surface, const vtkDGGGraphicsNames& names)
{
  const dgg::Status status = CheckHoldsNumbers(surface->GetCellData(), "cell", names.Refinement);
  if (!status.IsOk())
  {
    return status;
  }
  vtkDataArray* array = surface->GetCellData()->GetArray(names.Refinement.c_str());
  if (!array || array->GetNumberOfComponents() != 1 ||
    array->GetNumberOfTuples() != surface->GetNumberOfCells())
  {
    return dgg::Status::Invalid("the surface has no cell array '" + names.Refinement +
      "' with one number per cell: call SetRefinementArrayName() with the name of one");
  }
  for (vtkIdType cell = 0; cell < array->GetNumberOfTuples(); ++cell)
  {
    if (std::isnan(array->GetComponent(cell, 0)))
    {
      return dgg::Status::Invalid("the cell array '" + names.Refinement +
        "' has no number at cell " + std::to_string(cell) +
        ": use 0, or another number for cells to refine");
    }
  }
  return dgg::Status::Success();
}

//------------------------------------------------------------------------------
std::vector<dgg::Id> vtkDGGGraphicsInput::FindRefinedFaces(
  vtkPolyData* surface, const vtkDGGGraphicsNames& names, const vtkDGGMeshAdapter& mesh)
{
  std::vector<dgg::Id> faces;
  vtkDataArray* array = surface->GetCellData()->GetArray(names.Refinement.c_str());
  for (dgg::Id f = 0; f < mesh.GetMesh().GetNumberOfFaces(); ++f)
  {
    if (array->GetComponent(mesh.GetCell(f), 0) != 0.0)
    {
      faces.push_back(mesh.GetMesh().GetOriginal(f));
    }
  }
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}
