// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggGraphicsInput.h"

#include "dggBoxTree.h"
#include "dggCounted.h"
#include "dggStatus.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <string>
#include <unordered_map>

namespace dgg
{
namespace
{
constexpr double UsualWidth = 0.05; // of the diagonal
/// Values of CurveType.
constexpr GraphicsCurveType Types[] = { GraphicsCurveType::Diffusion, GraphicsCurveType::Poisson,
  GraphicsCurveType::Region, GraphicsCurveType::Source };

/// Fails if an array does not contain numbers: the result without the array would be wrong.
Status CheckType(const InputArray& array, const char* kind)
{
  return array.Exists() && !array.AreNumbers
    ? InvalidInput("The ", kind, " array '", array.Name, "' has the type ", array.Type)
        .Fix("Use an array of numbers")
    : Status::Success();
}

/// Returns the array of points or cells that is used; null if there is none.
const InputArray* Choose(const GraphicsArray& arrays)
{
  return arrays.OfPoints.AreNumbers ? &arrays.OfPoints
    : arrays.OfCells.AreNumbers     ? &arrays.OfCells
                                    : nullptr;
}

Status Find(const GraphicsArray& arrays, const InputArray*& found)
{
  found = Choose(arrays);
  if (!found)
  {
    DGG_RETURN_IF_ERROR(CheckType(arrays.OfPoints, "point"));
    DGG_RETURN_IF_ERROR(CheckType(arrays.OfCells, "cell"));
  }
  return Status::Success();
}

/// Fails unless a cell array of the surface has one number per cell. `property` contains its name.
Status CheckCellNumbers(const InputArray& array, Offset numberOfCells, const char* property)
{
  DGG_RETURN_IF_ERROR(CheckType(array, "cell"));
  return array.Exists() && array.NumberOfComponents == 1 && array.NumberOfTuples == numberOfCells
    ? Status::Success()
    : InvalidInput("The surface has no cell array '", array.Name, "' with one number per cell")
        .At(property)
        .Fix("Set {", property, "} to the name of one");
}

/// Fails if the number of a cell is NaN.
Status CheckNumber(const InputArray& array, Offset cell, const char* remedy)
{
  return std::isnan(array.Get(cell))
    ? InvalidInput("The cell array '", array.Name, "' has no number at cell ", cell).Fix(remedy)
    : Status::Success();
}

/// Returns the factor that scales colors to [0, 1].
double ScaleOf(const InputArray& array)
{
  return array.AreBytes ? 1.0 / 255.0 : 1.0;
}

void SortUnique(std::vector<Id>& ids)
{
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
}

/// A line of the input with its points.
struct Line
{
  const std::string& Name;
  Offset Cell;
  const Offset* Begin;
  const Offset* End;
};

/// Reads the lines, with their types and parameters.
struct CurveReader
{
  const GraphicsInput& Input;
  double DefaultWidth;
  GraphicsDrawing& Drawing;

  Status Read();
  Status AddLine(Offset line);
  Status ChooseChannels();
  Status ReadType(const Line& line, GraphicsCurve& curve) const;
  Status ReadParameters(const Line& line, GraphicsCurve& curve) const;
  Status ReadTuples(const GraphicsArray& arrays, const Line& line, int channels, bool mayBeSingle,
    std::vector<double>& values) const;
};

//------------------------------------------------------------------------------
Status CurveReader::Read()
{
  DGG_RETURN_IF_ERROR(this->Input.Lines.CheckOffsets("{Curves}"));
  for (Offset line = 0; line < this->Input.Lines.NumberOfCells; ++line)
  {
    DGG_RETURN_IF_ERROR(this->AddLine(line));
  }
  DGG_RETURN_IF_ERROR(this->ChooseChannels());
  const Offset* points = this->Drawing.Points.data();
  for (std::size_t k = 0; k < this->Drawing.Curves.size(); ++k)
  {
    GraphicsCurve& curve = this->Drawing.Curves[k];
    const Line line{ curve.Name, this->Input.FirstLine + static_cast<Offset>(k), points,
      points + this->Drawing.Sizes[k] };
    DGG_RETURN_IF_ERROR(this->ReadType(line, curve));
    DGG_RETURN_IF_ERROR(this->ReadParameters(line, curve));
    points = line.End;
  }
  return Status::Success();
}

//------------------------------------------------------------------------------
Status CurveReader::AddLine(Offset line)
{
  const CellArrays& lines = this->Input.Lines;
  const Offset* begin = lines.Ids + lines.Offsets[line];
  const Offset* end = lines.Ids + lines.Offsets[line + 1];
  GraphicsCurve curve;
  curve.Name = JoinText("Line ", this->Input.FirstLine + line, " of {Curves}");
  curve.IsClosed = end - begin > 2 && *begin == *(end - 1);
  end -= curve.IsClosed ? 1 : 0;
  const auto missing =
    std::find_if(begin, end, [&](Offset id) { return id < 0 || id >= this->Input.NumberOfPoints; });
  if (missing != end)
  {
    return InvalidInput(curve.Name, " refers to point ", *missing, ", which does not exist")
      .Fix("Repair the line");
  }
  const double* points = this->Input.Points;
  const bool hasLength = std::any_of(begin, end, [&](Offset id) {
    return !std::equal(points + 3 * id, points + 3 * id + 3, points + 3 * *begin);
  });
  if (!hasLength)
  {
    return InvalidInput(curve.Name, " has no length")
      .Fix("Give it two points at different positions");
  }
  this->Drawing.Curves.push_back(curve);
  this->Drawing.Points.insert(this->Drawing.Points.end(), begin, end);
  this->Drawing.Sizes.push_back(static_cast<std::size_t>(end - begin));
  return Status::Success();
}

//------------------------------------------------------------------------------
/// Chooses the number of channels: the number of components of the arrays. Strengths with a single
/// component, which applies to all channels, count only if there are no other arrays.
Status CurveReader::ChooseChannels()
{
  const GraphicsInput& input = this->Input;
  int channels = 0;
  std::string first;
  for (const GraphicsArray* arrays :
    { &input.LeftColor, &input.RightColor, &input.Strength, &input.RightStrength })
  {
    const std::string& name = arrays->OfPoints.Name;
    const bool isColor =
      name == input.LeftColor.OfPoints.Name || name == input.RightColor.OfPoints.Name;
    const InputArray* array = Choose(*arrays);
    if (!array || (array->NumberOfComponents == 1 && !isColor))
    {
      continue;
    }
    if (channels > 0 && array->NumberOfComponents != channels)
    {
      return InvalidInput("The array '", first, "' of {Curves} has ",
        Counted(channels, "component"), ", but '", name, "' has ", array->NumberOfComponents)
        .Fix("Use one component per channel in both");
    }
    channels = array->NumberOfComponents;
    first = name;
  }
  if (channels == 0 && !input.Region.Name.empty() && input.RegionStrength.AreNumbers)
  {
    channels = input.RegionStrength.NumberOfComponents;
  }
  if (channels == 0 && Choose(input.Strength))
  {
    channels = 1;
  }
  this->Drawing.NumberOfChannels = channels == 0 ? 3 : channels;
  return Status::Success();
}

//------------------------------------------------------------------------------
Status CurveReader::ReadType(const Line& line, GraphicsCurve& curve) const
{
  const InputArray& array = this->Input.CurveType;
  DGG_RETURN_IF_ERROR(CheckType(array, "cell"));
  if (!array.Exists())
  {
    return Status::Success(); // Diffusion
  }
  if (array.NumberOfComponents != 1)
  {
    return InvalidInput(
      "The cell array '", array.Name, "' of {Curves} has ", array.NumberOfComponents, " components")
      .Fix("Use an array with one component");
  }
  const double value = line.Cell < array.NumberOfTuples ? array.Get(line.Cell)
                                                        : std::numeric_limits<double>::quiet_NaN();
  if (!(value == 0.0 || value == 1.0 || value == 2.0 || value == 3.0))
  {
    return InvalidInput(line.Name, " has the type ", value, " in the cell array '", array.Name, "'")
      .Fix("Use 0 (Diffusion), 1 (Poisson), 2 (Region) or 3 (Source)");
  }
  curve.Type = Types[static_cast<int>(value)];
  return Status::Success();
}

//------------------------------------------------------------------------------
/// Reads the values of all points of a curve. If the array is a cell array, each point has the
/// value of the cell.
Status CurveReader::ReadTuples(const GraphicsArray& arrays, const Line& line, int channels,
  bool mayBeSingle, std::vector<double>& values) const
{
  const std::string& name = arrays.OfPoints.Name;
  const InputArray* array = nullptr;
  DGG_RETURN_IF_ERROR(Find(arrays, array));
  if (!array)
  {
    return InvalidInput(line.Name, " needs a point or cell array '", name, "'")
      .Fix("Add the array, or set the name of another one");
  }
  const bool isOfPoints = array == &arrays.OfPoints;
  const Offset tuples = isOfPoints ? this->Input.NumberOfPoints : this->Input.NumberOfCells;
  if (array->NumberOfTuples != tuples)
  {
    return InvalidInput(
      "The array '", name, "' of {Curves} has ", Counted(array->NumberOfTuples, "tuple"))
      .Fix("Use an array with ", Counted(tuples, "tuple"));
  }
  const int components = array->NumberOfComponents;
  if (components != channels && !(mayBeSingle && components == 1))
  {
    return InvalidInput("The array '", name, "' of {Curves} has ", Counted(components, "component"))
      .Fix("Use an array with ", Counted(channels, "component"),
        mayBeSingle && channels > 1 ? " or 1" : "");
  }
  values.clear();
  for (const Offset* id = line.Begin; id != line.End; ++id)
  {
    const Offset tuple = isOfPoints ? *id : line.Cell;
    for (int c = 0; c < channels; ++c)
    {
      const double value = array->Get(tuple, components == 1 ? 0 : c);
      if (!std::isfinite(value))
      {
        return InvalidInput("The array '", name, "' of {Curves} has the value ", value, " at ",
          isOfPoints ? "point " : "cell ", tuple)
          .Fix("Use finite numbers");
      }
      values.push_back(ScaleOf(*array) * value);
    }
  }
  return Status::Success();
}

//------------------------------------------------------------------------------
Status CurveReader::ReadParameters(const Line& line, GraphicsCurve& curve) const
{
  const GraphicsInput& input = this->Input;
  const int channels = this->Drawing.NumberOfChannels;
  if (curve.Type == GraphicsCurveType::Diffusion)
  {
    DGG_RETURN_IF_ERROR(this->ReadTuples(input.LeftColor, line, channels, false, curve.Left));
    return this->ReadTuples(input.RightColor, line, channels, false, curve.Right);
  }
  DGG_RETURN_IF_ERROR(this->ReadTuples(input.Strength, line, channels, true, curve.Left));
  if (curve.Type != GraphicsCurveType::Poisson)
  {
    return Status::Success();
  }
  const InputArray* right = nullptr;
  DGG_RETURN_IF_ERROR(Find(input.RightStrength, right));
  if (right)
  {
    DGG_RETURN_IF_ERROR(this->ReadTuples(input.RightStrength, line, channels, true, curve.Right));
  }
  else
  {
    std::transform(
      curve.Left.begin(), curve.Left.end(), std::back_inserter(curve.Right), std::negate<>());
  }
  // The width is constant along a curve: that of its cell, or of its first point.
  const InputArray* width = nullptr;
  DGG_RETURN_IF_ERROR(Find(input.Width, width));
  curve.Width = this->DefaultWidth;
  if (width)
  {
    std::vector<double> all;
    DGG_RETURN_IF_ERROR(this->ReadTuples(input.Width, line, 1, false, all));
    curve.Width = width->Get(width == &input.Width.OfPoints ? *line.Begin : line.Cell);
  }
  return curve.Width > 0.0 && std::isfinite(curve.Width)
    ? Status::Success()
    : InvalidInput(line.Name, " has the width ", curve.Width)
        .At("Width")
        .Fix("Use a finite positive width");
}

/// Reads the strengths of regions, and finds the index of the region of each id.
Status ReadStrengths(const GraphicsInput& input, int channels, std::vector<GraphicsRegion>& regions,
  std::unordered_map<double, std::size_t>& indices)
{
  const InputArray& strength = input.RegionStrength;
  const Offset cells = input.NumberOfSurfaceCells;
  DGG_RETURN_IF_ERROR(CheckType(input.Region, "cell"));
  DGG_RETURN_IF_ERROR(CheckType(strength, "cell"));
  DGG_RETURN_IF_ERROR(CheckCellNumbers(input.Region, cells, "RegionArrayName"));
  const int components = strength.NumberOfComponents;
  if (!strength.Exists() || strength.NumberOfTuples != cells ||
    (components != 1 && components != channels))
  {
    return InvalidInput("The surface has no cell array '", strength.Name, "' with ",
      channels == 1 ? "1 component" : JoinText("1 or ", channels, " components"))
      .At("RegionStrengthArrayName")
      .Fix("Set {RegionStrengthArrayName} to the name of one");
  }
  for (Offset cell = 0; cell < cells; ++cell)
  {
    DGG_RETURN_IF_ERROR(CheckNumber(input.Region, cell, "Use 0 for cells without a region"));
    const double id = input.Region.Get(cell);
    if (id == 0.0 || !indices.emplace(id, regions.size()).second)
    {
      continue;
    }
    GraphicsRegion& region = regions.emplace_back();
    for (int c = 0; c < channels; ++c)
    {
      const double value = ScaleOf(strength) * strength.Get(cell, components == 1 ? 0 : c);
      if (!std::isfinite(value))
      {
        return InvalidInput("The cell array '", strength.Name, "' is not finite at cell ", cell)
          .Fix("Use finite numbers");
      }
      region.Strength.push_back(value);
    }
  }
  return Status::Success();
}

Status ReadRegions(const GraphicsInput& input, const PreparedSurface& surface, int channels,
  std::vector<GraphicsRegion>& regions)
{
  std::unordered_map<double, std::size_t> indices;
  DGG_RETURN_IF_ERROR(ReadStrengths(input, channels, regions, indices));
  const auto regionOf = [&](Id face) {
    const auto index = indices.find(input.Region.Get(surface.GetCell(face)));
    return index == indices.end() ? nullptr : &regions[index->second];
  };
  const SurfaceMesh& mesh = surface.GetMesh();
  for (Id f = 0; f < mesh.GetNumberOfFaces() && !regions.empty(); ++f)
  {
    // If triangles have the same points, the first one with a region determines the region.
    const Id original = mesh.GetOriginal(f);
    GraphicsRegion* const region = regionOf(f);
    if (region && (f == original || !regionOf(original)))
    {
      region->Faces.push_back(original);
    }
  }
  for (GraphicsRegion& region : regions)
  {
    SortUnique(region.Faces);
  }
  regions.erase(std::remove_if(regions.begin(), regions.end(),
                  [](const GraphicsRegion& region) { return region.Faces.empty(); }),
    regions.end()); // regions of lines or verts
  return Status::Success();
}

Status FindRefinedFaces(
  const GraphicsInput& input, const PreparedSurface& surface, std::vector<Id>& faces)
{
  const InputArray& array = input.Refinement;
  DGG_RETURN_IF_ERROR(CheckCellNumbers(array, input.NumberOfSurfaceCells, "RefinementArrayName"));
  for (Id f = 0; f < surface.GetMesh().GetNumberOfFaces(); ++f)
  {
    const Offset cell = surface.GetCell(f);
    DGG_RETURN_IF_ERROR(CheckNumber(array, cell, "Use 0, or another number for cells to refine"));
    if (array.Get(cell) != 0.0)
    {
      faces.push_back(surface.GetMesh().GetOriginal(f));
    }
  }
  SortUnique(faces);
  return Status::Success();
}
}

//------------------------------------------------------------------------------
Status ReadGraphics(
  const GraphicsInput& input, const PreparedSurface& surface, GraphicsDrawing& drawing)
{
  drawing = GraphicsDrawing();
  double width = input.DefaultWidth;
  if (!(width > 0.0))
  {
    Box box;
    for (Id v = 0; v < surface.GetMesh().GetNumberOfVertices(); ++v)
    {
      box.Add(surface.GetPositions() + 3 * static_cast<std::size_t>(v));
    }
    width = UsualWidth * box.GetDiagonal();
  }
  DGG_RETURN_IF_ERROR(CurveReader{ input, width, drawing }.Read());
  if (!input.Region.Name.empty())
  {
    DGG_RETURN_IF_ERROR(ReadRegions(input, surface, drawing.NumberOfChannels, drawing.Regions));
  }
  else if (drawing.Curves.empty())
  {
    return InvalidInput("There is nothing to draw")
      .Fix("Add lines to {Curves}, or set {RegionArrayName}");
  }
  return input.WantRefinement ? FindRefinedFaces(input, surface, drawing.RefinedFaces)
                              : Status::Success();
}
}
