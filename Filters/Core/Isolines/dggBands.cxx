// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggBands.h"

#include "dggFaceEnvelope.h"
#include "dggPathEdges.h"
#include "dggProgressPart.h"
#include "dggSurfaceRefinement.h"

#include <algorithm>
#include <utility>

namespace dgg
{
namespace
{
/// Progress after each step.
constexpr double CutDone = 0.7;
constexpr double CornersDone = 0.8;
/// Distance below which points of lines in a face become one vertex, in barycentric coordinates
/// (dggSurfaceRefinement.h).
constexpr double MergeDistance = 2e-9;

class BandFinder
{
public:
  BandFinder(const DistanceField& field, Bands& bands)
    : Field(field)
    , Result(bands)
    , Envelope(field)
    , Close(MergeDistance * field.Mesh->GetMaximumEdgeLength())
    , Lines(bands.Surface, bands.Surface.Paths)
  {
  }

  void FindDistances(const std::vector<double>& levels, const std::vector<Id>& levelOf);
  void FindBands();

private:
  Id BandAt(double distance) const;
  bool IsReached(Id face) const;
  std::pair<Id, Id> BandsOf(Id face) const;
  Id BandOfCentroid(Id face);
  void Spread(std::vector<Id>& front);

  const DistanceField& Field;
  Bands& Result;
  FaceEnvelope Envelope;
  const double Close; // tolerance of a level whose line may have collapsed to a vertex
  const PathEdges Lines;
  std::vector<Id> LevelAt; // per vertex, the level of the lines that pass it, or NoId
};

/// Returns the first band whose upper level is above the distance.
Id BandFinder::BandAt(double distance) const
{
  const std::vector<double>& levels = this->Result.Levels;
  return static_cast<Id>(std::upper_bound(levels.begin(), levels.end(), distance) - levels.begin());
}

bool BandFinder::IsReached(Id face) const
{
  return this->Field.IsReached(this->Result.Surface.Faces[face]);
}

/// Sets the distances of vertices: levels on lines, given distances at other vertices. All new
/// vertices are on lines.
void BandFinder::FindDistances(const std::vector<double>& levels, const std::vector<Id>& levelOf)
{
  const SubMesh& surface = this->Result.Surface;
  this->LevelAt.assign(surface.GetNumberOfVertices(), NoId);
  for (std::size_t p = 0; p < surface.Paths.size(); ++p)
  {
    const Id level = this->BandAt(levels[levelOf[p]]) - 1;
    for (const Id v : surface.Paths[p])
    {
      Id& known = this->LevelAt[v];
      known = known == NoId ? level : std::min(known, level); // where lines touch
    }
  }
  this->Result.Distances.resize(surface.GetNumberOfVertices());
  for (Id v = 0; v < surface.GetNumberOfVertices(); ++v)
  {
    const SurfacePoint& point = surface.Points[v];
    this->Result.Distances[v] = this->LevelAt[v] != NoId ? this->Result.Levels[this->LevelAt[v]]
      : IsVertex(point)                                  ? this->Field.Distances[point.Vertex]
                                                         : Infinity;
  }
}

/// Returns the first and the last band to which a face may belong according to its corners. The
/// range is empty if the corners contradict each other.
std::pair<Id, Id> BandFinder::BandsOf(Id face) const
{
  Id first = 0;
  Id last = static_cast<Id>(this->Result.Levels.size());
  for (Id h = 3 * face; h < 3 * face + 3; ++h)
  {
    const Id v = this->Result.Surface.Triangles[h];
    const Id level = this->LevelAt[v];
    const double distance = this->Result.Distances[v];
    first = std::max(first, level == NoId ? this->BandAt(distance - this->Close) : level);
    last = std::min(last, level == NoId ? this->BandAt(distance + this->Close) : level + 1);
  }
  return { first, last };
}

Id BandFinder::BandOfCentroid(Id face)
{
  const SubMesh& surface = this->Result.Surface;
  const Id old = surface.Faces[face];
  std::array<double, 3> sum{ { 0.0, 0.0, 0.0 } };
  for (Id h = 3 * face; h < 3 * face + 3; ++h)
  {
    std::array<double, 3> b{};
    FindInFace(*this->Field.Mesh, surface.Points[surface.Triangles[h]], old, b);
    for (int k = 0; k < 3; ++k)
    {
      sum[k] += b[k] / 3.0;
    }
  }
  this->Envelope.Enter(old);
  return this->BandAt(this->Envelope.At(this->Envelope.PlaceOf(sum)));
}

/// Assigns bands. First assigns the faces that are determined by their corners, then their
/// neighbors that are not separated by a line, and finally the remaining faces one by one.
void BandFinder::FindBands()
{
  const SubMesh& surface = this->Result.Surface;
  std::vector<Id>& bandOf = this->Result.BandOf;
  bandOf.assign(surface.GetNumberOfFaces(), NoId);
  std::vector<Id> front;
  for (Id f = 0; f < surface.GetNumberOfFaces(); ++f)
  {
    if (this->IsReached(f))
    {
      const std::pair<Id, Id> range = this->BandsOf(f);
      if (range.first == range.second)
      {
        bandOf[f] = range.first;
        front.push_back(f);
      }
      else if (range.first > range.second)
      {
        bandOf[f] = this->BandOfCentroid(f); // a line is missing
      }
    }
  }
  this->Spread(front);
  for (Id f = 0; f < surface.GetNumberOfFaces(); ++f)
  {
    if (bandOf[f] == NoId && this->IsReached(f))
    {
      const std::pair<Id, Id> range = this->BandsOf(f);
      bandOf[f] = std::max(range.first, std::min(range.second, this->BandOfCentroid(f)));
      front.assign(1, f);
      this->Spread(front);
    }
  }
}

/// Spreads bands from faces to neighbors that may be in the same band, nearest first.
void BandFinder::Spread(std::vector<Id>& front)
{
  const SubMesh& surface = this->Result.Surface;
  std::vector<Id>& bandOf = this->Result.BandOf;
  for (std::size_t i = 0; i < front.size(); ++i)
  {
    for (Id h = 3 * front[i]; h < 3 * front[i] + 3; ++h)
    {
      for (Id e = surface.Twins[h]; e != NoId && e != h && !this->Lines.IsOnPath(h);
           e = surface.Twins[e])
      {
        const Id f = SurfaceMesh::Face(e);
        if (bandOf[f] != NoId || !this->IsReached(f))
        {
          continue;
        }
        const std::pair<Id, Id> range = this->BandsOf(f);
        const Id band = bandOf[front[i]];
        if (band >= range.first && band <= range.second)
        {
          bandOf[f] = band;
          front.push_back(f);
        }
      }
    }
  }
}
}

Status MakeBands(const DistanceField& field, const std::vector<double>& levels,
  const Isolines& lines, const ProgressCallback& progress, Bands& bands)
{
  bands = Bands();
  DGG_RETURN_IF_ERROR(ReportTo(progress, 0.0));
  bands.Levels = levels;
  std::sort(bands.Levels.begin(), bands.Levels.end());
  bands.Levels.erase(std::unique(bands.Levels.begin(), bands.Levels.end()), bands.Levels.end());
  // Lines of repeated levels coincide with the first ones, and all of them would be intersected
  // with each other.
  std::vector<SurfacePath> cuts;
  std::vector<Id> levelOf;
  for (std::size_t p = 0; p < lines.Lines.size(); ++p)
  {
    const auto level = levels.begin() + lines.Levels[p];
    if (std::find(levels.begin(), level, *level) == level)
    {
      cuts.push_back(lines.Lines[p]);
      levelOf.push_back(lines.Levels[p]);
    }
  }
  // Touching lines may cross by rounding, and lines of discontinuous fields do cross.
  RefinementOptions options;
  options.InsertCrossings = true;
  options.Progress = ProgressPart(progress, 0.0, CutDone);
  DGG_RETURN_IF_ERROR(RefineAlongPaths(*field.Mesh, cuts, options, bands.Surface));
  DGG_RETURN_IF_ERROR(ReportTo(progress, CutDone));
  BandFinder finder(field, bands);
  finder.FindDistances(levels, levelOf);
  DGG_RETURN_IF_ERROR(ReportTo(progress, CornersDone));
  finder.FindBands();
  return ReportTo(progress, 1.0);
}
}
