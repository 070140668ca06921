// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Shared tools for tests of isolines.
#ifndef IsolineChecks_h
#define IsolineChecks_h

#include "FieldChecks.h"

#include "dggIsolines.h"

namespace dggtest
{
dgg::Isolines Trace(const dgg::DistanceField& field, const std::vector<double>& levels,
  double tolerance = 0.0, dgg::IsolineMethod method = dgg::IsolineMethod::LocalSources);

/// Returns `count` levels between the smallest and the largest distance.
std::vector<double> EvenLevels(const dgg::DistanceField& field, dgg::Id count);

/// Returns true if isolines cross the edge: it has two faces and is reached. Isolines end at other
/// edges.
bool Conducts(const dgg::DistanceField& field, dgg::Id h);

/// Returns true if the predicate holds for all edges around the vertex.
template <typename Predicate>
bool AllAround(const dgg::SurfaceMesh& mesh, dgg::Id v, Predicate&& holds)
{
  for (const dgg::Id* g = mesh.FanBegin(v); g != mesh.FanEnd(v); ++g)
  {
    if (!holds(*g) || !holds(dgg::SurfaceMesh::Previous(*g)))
    {
      return false;
    }
  }
  return true;
}

/// Checks the invariants of isolines of any field on any mesh: they lie on the surface, end only at
/// the ends of the conducting edges, and miss no edge.
void ExpectSound(const dgg::DistanceField& field, const std::vector<double>& levels,
  const dgg::Isolines& lines, const std::string& what);

/// Points of all lines with their levels.
struct LevelPoints
{
  LevelPoints(const dgg::Isolines& lines, const std::vector<double>& levels)
  {
    for (std::size_t i = 0; i < lines.Lines.size(); ++i)
    {
      for (const dgg::SurfacePoint& point : lines.Lines[i].Points)
      {
        this->Points.push_back(point);
        this->Levels.push_back(levels[lines.Levels[i]]);
      }
    }
  }

  std::vector<dgg::SurfacePoint> Points;
  std::vector<double> Levels;
};

/// Expects the exact distances of all points of the lines to equal their levels.
void ExpectAtLevel(const dgg::SurfaceMesh& mesh, const std::vector<dgg::GeodesicSource>& sources,
  const std::vector<double>& levels, const dgg::Isolines& lines, double tolerance,
  const std::string& what);

std::map<dgg::Id, int> LinesPerLevel(const dgg::Isolines& lines);

bool AllClosed(const dgg::Isolines& lines);

std::array<double, 3> Middle(const std::array<double, 3>& a, const std::array<double, 3>& b);

double DistanceTo(const std::array<double, 3>& p, double x, double y);

dgg::GeodesicSource FaceSourceAt(
  const dgg::SurfaceMesh& mesh, dgg::Id face, const std::array<double, 3>& barycentric);

/// Returns the mean distance error of the midpoints of pieces, averaged along all lines.
double MeanErrorOfPieces(const dgg::SurfaceMesh& mesh,
  const std::vector<dgg::GeodesicSource>& sources, const std::vector<double>& levels,
  const dgg::Isolines& lines);
}

#endif
