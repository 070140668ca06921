// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggIsolineTask.h"

#include "dggFieldReader.h"
#include "dggOutput.h"
#include "dggPreparedSurface.h"
#include "dggProcessGroup.h"
#include "dggProgressPart.h"
#include "dggSurfaceOutput.h"
#include "dggTaskContext.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace dgg
{
namespace
{
///@{
/// Progress weights, if the parts are requested.
constexpr double LineWork = 1.0;
constexpr double RidgeWork = 1.0;
constexpr double BandWork = 1.5;
///@}

constexpr double DegreesPerRadian = 180.0 / Pi;
constexpr double RadiansPerDegree = Pi / 180.0;

/// Smallest ChordTolerance: time and memory grow without bound as the tolerance decreases.
constexpr double SmallestChordTolerance = 1e-6;

/// Distances and lines of a piece.
struct LineSummary
{
  std::array<double, 2> Range;
  bool HasLines;

  void Add(const LineSummary& piece)
  {
    this->Range[0] = std::min(this->Range[0], piece.Range[0]);
    this->Range[1] = std::max(this->Range[1], piece.Range[1]);
    this->HasLines = this->HasLines || piece.HasLines;
  }
};

/// Writes polylines with a cell array, which becomes the active scalars.
void WriteLines(const TaskContext& context, const std::vector<SurfacePath>& lines,
  const std::vector<bool>& isClosed, const char* name, const std::vector<double>& values,
  Output& output)
{
  std::vector<OutputCurve> curves;
  for (std::size_t i = 0; i < lines.size(); ++i)
  {
    curves.push_back({ &lines[i], isClosed[i] });
  }
  WriteCurves(context, curves, output);
  output.CellData.AddValues<double>(name, values);
  output.CellScalars = name;
}

/// Returns the limits of the bands; the first and the last limit are the extreme distances.
std::vector<double> FindLimits(const Bands& bands)
{
  std::vector<double> limits = bands.Levels;
  const auto [least, largest] = bands.Range;
  limits.insert(limits.begin(), bands.Levels.empty() ? least : std::min(least, bands.Levels[0]));
  limits.push_back(std::max(largest, limits.back()));
  return limits;
}

void WriteIsolines(const TaskContext& context, const Isolines& lines,
  const std::vector<double>& values, Output& output)
{
  std::vector<double> numbers;
  for (const Id level : lines.Levels)
  {
    numbers.push_back(values[level]);
  }
  WriteLines(context, lines.Lines, lines.IsClosed, "IsoValue", numbers, output);
}

void WriteRidges(const TaskContext& context, const Ridges& ridges, Output& output)
{
  std::vector<double> numbers;
  for (const double angle : ridges.Angles)
  {
    numbers.push_back(angle * DegreesPerRadian);
  }
  const std::vector<bool> isClosed(ridges.Lines.size(), false);
  WriteLines(context, ridges.Lines, isClosed, "RidgeAngle", numbers, output);
}

void WriteBands(
  const TaskContext& context, const Bands& bands, const std::string& distances, Output& output)
{
  const SubMesh& surface = bands.Surface;
  std::vector<Id> faces;
  std::vector<Id> used; // vertices of the output
  std::vector<SurfacePoint> places;
  std::vector<Id> pointOf(surface.Points.size(), NoId);
  for (Id f = 0; f < surface.GetNumberOfFaces(); ++f)
  {
    if (bands.BandOf[f] == NoId)
    {
      continue;
    }
    faces.push_back(f);
    for (Id h = 3 * f; h < 3 * f + 3; ++h)
    {
      const Id vertex = surface.Triangles[h];
      if (pointOf[vertex] == NoId)
      {
        pointOf[vertex] = static_cast<Id>(used.size());
        used.push_back(vertex);
        places.push_back(surface.Points[vertex]);
      }
    }
  }
  WritePositions(context.Surface, places, output);
  double* const values = output.PointData.Add<double>(distances, used.size());
  Offset* const ids = output.PointData.Add<Offset>("vtkOriginalPointIds", used.size());
  output.PointScalars = distances;
  for (std::size_t i = 0; i < used.size(); ++i)
  {
    values[i] = bands.Distances[used[i]];
    ids[i] = GetOriginalPoint(places[i]);
  }

  std::int32_t* const numbers = output.CellData.Add<std::int32_t>("Band", faces.size());
  double* const lower = output.CellData.Add<double>("BandMinimum", faces.size());
  double* const upper = output.CellData.Add<double>("BandMaximum", faces.size());
  Offset* const cells = output.CellData.Add<Offset>("FaceId", faces.size());
  output.CellScalars = "Band";
  output.Polygons.Offsets = Buffer<Offset>(faces.size() + 1);
  output.Polygons.Points = Buffer<Offset>(3 * faces.size());
  output.Polygons.Offsets[0] = 0;
  const std::vector<double> limits = FindLimits(bands);
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    const Id f = faces[i];
    Offset* const corners = output.Polygons.Points.Data() + 3 * i;
    for (int k = 0; k < 3; ++k)
    {
      corners[k] = pointOf[surface.Triangles[3 * f + k]];
    }
    if (context.Surface.GetMesh().IsFlipped(surface.Faces[f]))
    {
      std::swap(corners[1], corners[2]); // same orientation as in the input
    }
    output.Polygons.Offsets[i + 1] = static_cast<Offset>(3 * (i + 1));
    numbers[i] = bands.BandOf[f];
    lower[i] = limits[bands.BandOf[f]];
    upper[i] = limits[bands.BandOf[f] + 1];
    cells[i] = GetOriginalCell(context.Surface, surface.Faces[f]);
  }
}

/// Adds the isolines in the first layer of cells around the piece of this process.
Status AddLinesAround(const DistanceField& field, const std::vector<double>& values,
  const IsolineOptions& options, const ParallelFor& parallel, Isolines& lines)
{
  DistanceField around = field;
  std::vector<std::uint8_t> layers(field.Layers, field.Layers + field.Mesh->GetNumberOfFaces());
  for (std::uint8_t& layer : layers)
  {
    layer = layer == 1 ? 0 : 1;
  }
  around.Layers = layers.data();
  Isolines added;
  DGG_RETURN_IF_ERROR(TraceIsolines(around, values, options, parallel, {}, added));
  lines.Lines.insert(lines.Lines.end(), added.Lines.begin(), added.Lines.end());
  lines.Levels.insert(lines.Levels.end(), added.Levels.begin(), added.Levels.end());
  return Status::Success();
}
}

//------------------------------------------------------------------------------
Status IsolineTaskOptions::Check() const
{
  if (this->SteinerPoints < 0 || this->SteinerPoints > MaximumSteinerPoints)
  {
    return InvalidValue("SteinerPoints", this->SteinerPoints)
      .Fix("Use a number from 0 to ", MaximumSteinerPoints);
  }
  if (!(this->ChordTolerance >= SmallestChordTolerance))
  {
    return InvalidValue("ChordTolerance", this->ChordTolerance)
      .Fix("Use a number of at least ", SmallestChordTolerance);
  }
  if (!(this->MinimumRidgeAngle >= 0.0 && this->MinimumRidgeAngle <= 180.0))
  {
    return InvalidValue("MinimumRidgeAngle", this->MinimumRidgeAngle)
      .Fix("Use degrees from 0 to 180");
  }
  for (std::size_t i = 0; i < this->Values.size(); ++i)
  {
    if (!std::isfinite(this->Values[i]))
    {
      return InvalidInput("Value ", i, " is ", this->Values[i])
        .At("Values", static_cast<Offset>(i))
        .Fix("Use a finite number");
    }
  }
  return Status::Success();
}

//------------------------------------------------------------------------------
Status FindIsolines(const TaskContext& context, const DistanceField& field,
  const IsolineTaskOptions& options, const ProgressCallback& progress, IsolineResult& result,
  FieldPieces* pieces)
{
  IsolineOptions lines;
  lines.ChordTolerance =
    options.ChordTolerance * (pieces ? pieces->MeanEdgeLength : field.Mesh->GetMeanEdgeLength());
  lines.SteinerPoints = options.SteinerPoints;
  const bool isKnown = field.HasWindows() || field.HasSources();
  lines.Method = isKnown ? options.Method : IsolineMethod::LocalSources;
  const double ridgeWork = options.WithRidges ? RidgeWork : 0.0;
  const double work = LineWork + ridgeWork + (options.WithBands ? BandWork : 0.0);
  const double atRidges = LineWork / work;
  const double atBands = (LineWork + ridgeWork) / work;
  DGG_RETURN_IF_ERROR(TraceIsolines(field, options.Values, lines, context.Parallel,
    ProgressPart(progress, 0.0, atRidges), result.Lines));
  if (options.WithRidges && (isKnown || pieces))
  {
    RidgeOptions ridges;
    ridges.MinimumAngle = options.MinimumRidgeAngle * RadiansPerDegree;
    ridges.ChordTolerance = lines.ChordTolerance;
    DGG_RETURN_IF_ERROR(FindRidges(field, ridges, context.Parallel,
      ProgressPart(progress, atRidges, atBands), result.Ridges, pieces));
  }
  if (!options.WithBands)
  {
    return Status::Success();
  }
  Isolines all;
  if (pieces)
  {
    all = result.Lines;
    DGG_RETURN_IF_ERROR(AddLinesAround(field, options.Values, lines, context.Parallel, all));
  }
  return MakeBands(field, options.Values, pieces ? all : result.Lines,
    ProgressPart(progress, atBands, 1.0), result.Bands, pieces);
}

//------------------------------------------------------------------------------
std::string DescribeRidges(const IsolineTaskOptions& options, const FieldReader& reader)
{
  const DistanceField& field = reader.GetField();
  if (options.WithRidges && !field.HasWindows() && !field.HasSources())
  {
    return "There are no ridges in distances that are linear in each triangle. Use another "
           "{Method}, and distances with windows or virtual sources";
  }
  return options.WithRidges && reader.HasFittedSources()
    ? "Ridges of virtual sources that are fitted to distances alone are not reliable. Turn on "
      "{GenerateWindows} or {GenerateVirtualSource} of the distances"
    : "";
}

//------------------------------------------------------------------------------
std::string DescribeMissingLines(
  const IsolineTaskOptions& options, const std::array<double, 2>& range, bool hasLines)
{
  if (hasLines || options.WithRidges || options.WithBands)
  {
    return {};
  }
  const auto [smallest, largest] = range;
  return smallest > largest // no point is reached
    ? std::string()
    : JoinText("There are no isolines: the distances of the points are from ", smallest, " to ",
        largest, ", and none of the values yields a line");
}

//------------------------------------------------------------------------------
Status DescribeMissingLines(ProcessGroup& group, const IsolineTaskOptions& options,
  const std::array<double, 2>& range, bool hasLines, std::string& warning)
{
  LineSummary all{ range, hasLines };
  DGG_RETURN_IF_ERROR(group.Sum(all));
  warning = group.Here == 0 ? DescribeMissingLines(options, all.Range, all.HasLines) : "";
  return Status::Success();
}

//------------------------------------------------------------------------------
void WriteIsolines(const TaskContext& context, const IsolineResult& result,
  const std::vector<double>& values, const std::string& distances, Output (&outputs)[3])
{
  WriteIsolines(context, result.Lines, values, outputs[0]);
  WriteRidges(context, result.Ridges, outputs[1]);
  WriteBands(context, result.Bands, distances, outputs[2]);
}
}
