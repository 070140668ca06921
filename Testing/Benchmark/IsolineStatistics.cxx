// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "IsolineStatistics.h"

#include "dggFaceProfile.h"

#include <cmath>

namespace
{
constexpr double AlmostAll = 0.999;
}

std::vector<IsolineSegment> ToSegments(
  const dgg::SurfaceMesh& mesh, const dgg::Isolines& lines, const std::vector<double>& levels)
{
  std::vector<IsolineSegment> segments;
  for (std::size_t i = 0; i < lines.Lines.size(); ++i)
  {
    const dgg::SurfacePath& line = lines.Lines[i];
    for (std::size_t piece = 0; piece + 1 < line.Points.size(); ++piece)
    {
      std::array<double, 3> begin;
      std::array<double, 3> end;
      IsolineSegment segment;
      segment.Face = line.Faces[piece];
      segment.Level = levels[lines.Levels[i]];
      segment.Length = dgg::MeasurePiece(mesh, line, piece);
      if (segment.Length > 0.0 && dgg::FindInFace(mesh, line.Points[piece], segment.Face, begin) &&
        dgg::FindInFace(mesh, line.Points[piece + 1], segment.Face, end))
      {
        for (int k = 0; k < 3; ++k)
        {
          segment.Middle[k] = 0.5 * (begin[k] + end[k]);
        }
        segments.push_back(segment);
      }
    }
  }
  return segments;
}

IsolineStatistics::IsolineStatistics(
  const dgg::DistanceField& exact, const std::vector<IsolineSegment>& segments)
{
  dgg::FaceProfile profile(exact);
  for (const IsolineSegment& segment : segments)
  {
    if (segment.Face != profile.GetFace())
    {
      profile.Enter(segment.Face);
    }
    const double distance = profile.At(profile.PlaceOf(segment.Middle));
    const double error = std::abs(distance - segment.Level) / segment.Level;
    this->Errors.Add(error);
    this->Length += segment.Length;
    this->ErrorTimesLength += error * segment.Length;
    if (error > this->Largest)
    {
      this->Largest = error;
      this->Worst = segment;
    }
  }
}

void IsolineStatistics::Report(benchmark::State& state) const
{
  state.counters["segments"] = static_cast<double>(this->Errors.GetCount());
  state.counters["length"] = this->Length;
  state.counters["error_mean"] = this->Errors.GetMean();
  state.counters["error_by_length"] =
    this->Length > 0.0 ? this->ErrorTimesLength / this->Length : 0.0;
  state.counters["error_p999"] = this->Errors.GetQuantile(AlmostAll);
  state.counters["error_max"] = this->Errors.GetMaximum();
  state.counters["worst_face"] = static_cast<double>(this->Worst.Face);
  state.counters["worst_level"] = this->Worst.Level;
}
