// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggBands.h"

#include "dggBandBorder.h"
#include "dggDisjointSets.h"
#include "dggFaceEnvelope.h"
#include "dggPathEdges.h"
#include "dggProcessGroup.h"
#include "dggProgressPart.h"
#include "dggSurfaceRefinement.h"

#include <algorithm>
#include <tuple>
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

/// Range of distances.
struct DistanceRange
{
  std::array<double, 2> Values;

  void Add(const DistanceRange& other)
  {
    this->Values[0] = std::min(this->Values[0], other.Values[0]);
    this->Values[1] = std::max(this->Values[1], other.Values[1]);
  }
};

/// A part of an isoline in one face that ends on the boundary of the face, or is closed.
struct LinePart
{
  Id Level; // index into the levels
  SurfacePath Path;

  static auto KeyOf(const SurfacePoint& point)
  {
    return std::make_tuple(point.On, point.Vertex, point.HalfEdge, point.Barycentric);
  }
  bool operator<(const LinePart& other) const
  {
    const auto key = [](const LinePart& part) {
      return std::make_tuple(part.Path.Faces[0], part.Level, KeyOf(part.Path.Points.front()),
        KeyOf(part.Path.Points.back()));
    };
    return key(*this) < key(other);
  }
};

/// Cuts lines at the boundaries of faces. The order and directions of the parts do not depend on
/// those of the lines, which differ between a surface and its pieces. Lines of repeated levels
/// coincide with the first ones, and are excluded because all of them would be intersected with
/// each other.
std::vector<LinePart> CutLines(
  const SurfaceMesh& mesh, const std::vector<double>& levels, const Isolines& lines)
{
  std::vector<LinePart> parts;
  for (std::size_t p = 0; p < lines.Lines.size(); ++p)
  {
    const auto level = levels.begin() + lines.Levels[p];
    if (std::find(levels.begin(), level, *level) != level)
    {
      continue;
    }
    const SurfacePath& line = lines.Lines[p];
    for (std::size_t i = 0; i < line.Faces.size(); ++i)
    {
      if (i == 0 || line.Points[i].On != SurfacePoint::Support::Face)
      {
        parts.push_back({ lines.Levels[p], {} });
        parts.back().Path.Append(mesh, line.Points[i], line.Faces[i]);
      }
      parts.back().Path.Append(mesh, line.Points[i + 1], line.Faces[i]);
    }
  }
  for (LinePart& part : parts)
  {
    std::vector<SurfacePoint>& points = part.Path.Points;
    if (LinePart::KeyOf(points.back()) < LinePart::KeyOf(points.front()))
    {
      std::reverse(points.begin(), points.end());
    }
  }
  std::sort(parts.begin(), parts.end());
  return parts;
}

class BandFinder
{
public:
  BandFinder(const DistanceField& field, FieldPieces* pieces, Bands& bands)
    : Field(field)
    , Result(bands)
    , Envelope(field)
    , Close(MergeDistance * (pieces ? pieces->LongestEdge : field.Mesh->GetMaximumEdgeLength()))
    , Lines(bands.Surface, bands.Surface.Paths)
    , Border(field, this->Lines, pieces)
  {
  }

  void FindDistances(const std::vector<double>& levels, const std::vector<Id>& levelOf);
  Status FindBands();
  DistanceRange FindRange() const;

private:
  Id BandAt(double distance) const;
  bool IsTraced(Id face) const;
  std::pair<Id, Id> BandsOf(Id face) const;
  Id BandOfCentroid(Id face);
  Status Spread(std::vector<Id>& front);
  Status FindFirst(const std::vector<Id>& faces, std::vector<Id>& first) const;
  template <typename Visitor>
  void ForEachNeighbor(Id face, const Visitor& visit) const;

  const DistanceField& Field;
  Bands& Result;
  FaceEnvelope Envelope;
  const double Close; // tolerance of a level whose line may have collapsed to a vertex
  const PathEdges Lines;
  BandBorder Border;
  std::vector<Id> LevelAt; // per vertex, the level of the lines that pass it, or NoId
};

/// Returns the first band whose upper level is above the distance.
Id BandFinder::BandAt(double distance) const
{
  const std::vector<double>& levels = this->Result.Levels;
  return static_cast<Id>(std::upper_bound(levels.begin(), levels.end(), distance) - levels.begin());
}

bool BandFinder::IsTraced(Id face) const
{
  return this->Field.IsTraced(this->Result.Surface.Faces[face]);
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

/// Calls `visit(neighbor)` for the traced faces behind the edges of a face, unless a line runs
/// along the edge.
template <typename Visitor>
void BandFinder::ForEachNeighbor(Id face, const Visitor& visit) const
{
  const SubMesh& surface = this->Result.Surface;
  for (Id h = 3 * face; h < 3 * face + 3; ++h)
  {
    for (Id e = surface.Twins[h]; e != NoId && e != h && !this->Lines.IsOnPath(h);
         e = surface.Twins[e])
    {
      if (this->IsTraced(SurfaceMesh::Face(e)))
      {
        visit(SurfaceMesh::Face(e));
      }
    }
  }
}

/// Assigns bands. First assigns the faces that are determined by their corners, then their
/// neighbors that are not separated by a line, and finally the remaining faces: the first one of
/// each component, and its neighbors.
Status BandFinder::FindBands()
{
  std::vector<Id>& bandOf = this->Result.BandOf;
  bandOf.assign(this->Result.Surface.GetNumberOfFaces(), NoId);
  std::vector<Id> front;
  std::vector<Id> undecided;
  for (Id f = 0; f < this->Result.Surface.GetNumberOfFaces(); ++f)
  {
    if (this->IsTraced(f))
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
      else
      {
        undecided.push_back(f);
      }
    }
  }
  DGG_RETURN_IF_ERROR(this->Border.Connect(undecided));
  for (bool isDone = false; !isDone;)
  {
    DGG_RETURN_IF_ERROR(this->Spread(front));
    undecided.erase(
      std::remove_if(undecided.begin(), undecided.end(), [&](Id f) { return bandOf[f] != NoId; }),
      undecided.end());
    DGG_RETURN_IF_ERROR(this->FindFirst(undecided, front));
    for (const Id f : front)
    {
      const std::pair<Id, Id> range = this->BandsOf(f);
      bandOf[f] = std::max(range.first, std::min(range.second, this->BandOfCentroid(f)));
    }
    isDone = undecided.empty();
    DGG_RETURN_IF_ERROR(this->Border.Require(isDone));
  }
  return Status::Success();
}

/// Spreads bands from faces to neighbors that may be in the same band, nearest first. Of several
/// bands, a face takes the lowest one.
Status BandFinder::Spread(std::vector<Id>& front)
{
  std::vector<Id>& bandOf = this->Result.BandOf;
  for (bool isDone = false; !isDone;)
  {
    std::vector<std::pair<Id, Id>> offers; // faces and bands
    const auto offer = [&](Id f, Id band) {
      if (bandOf[f] == NoId)
      {
        const std::pair<Id, Id> range = this->BandsOf(f);
        if (band >= range.first && band <= range.second)
        {
          offers.emplace_back(f, band);
        }
      }
    };
    for (const Id f : front)
    {
      this->ForEachNeighbor(f, [&](Id neighbor) { offer(neighbor, bandOf[f]); });
    }
    DGG_RETURN_IF_ERROR(this->Border.Exchange(front, bandOf, offer));
    std::sort(offers.begin(), offers.end());
    front.clear();
    for (const auto& [f, band] : offers)
    {
      if (bandOf[f] == NoId)
      {
        bandOf[f] = band;
        front.push_back(f);
      }
    }
    isDone = front.empty();
    DGG_RETURN_IF_ERROR(this->Border.Require(isDone));
  }
  return Status::Success();
}

/// Finds the first face of each component of faces, which are sorted.
Status BandFinder::FindFirst(const std::vector<Id>& faces, std::vector<Id>& first) const
{
  DisjointSets components(faces.size());
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    this->ForEachNeighbor(faces[i], [&](Id neighbor) {
      const auto found = std::lower_bound(faces.begin(), faces.end(), neighbor);
      if (found != faces.end() && *found == neighbor)
      {
        components.Join(static_cast<Id>(i), static_cast<Id>(found - faces.begin()));
      }
    });
  }
  std::vector<Id> firstOf;
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    firstOf.push_back(faces[components.Find(static_cast<Id>(i))]);
  }
  return this->Border.SelectFirst(faces, firstOf, first);
}

/// Returns the range of the distances of the faces in bands.
DistanceRange BandFinder::FindRange() const
{
  DistanceRange range{ this->Result.Range };
  const SubMesh& surface = this->Result.Surface;
  for (Id h = 0; h < surface.GetNumberOfHalfEdges(); ++h)
  {
    if (this->Result.BandOf[SurfaceMesh::Face(h)] != NoId)
    {
      const double distance = this->Result.Distances[surface.Triangles[h]];
      range.Add({ { distance, distance } });
    }
  }
  return range;
}
}

Status MakeBands(const DistanceField& field, const std::vector<double>& levels,
  const Isolines& lines, const ProgressCallback& progress, Bands& bands, FieldPieces* pieces)
{
  bands = Bands();
  DGG_RETURN_IF_ERROR(ReportTo(progress, 0.0));
  bands.Levels = levels;
  std::sort(bands.Levels.begin(), bands.Levels.end());
  bands.Levels.erase(std::unique(bands.Levels.begin(), bands.Levels.end()), bands.Levels.end());
  std::vector<SurfacePath> cuts;
  std::vector<Id> levelOf;
  for (LinePart& part : CutLines(*field.Mesh, levels, lines))
  {
    cuts.push_back(std::move(part.Path));
    levelOf.push_back(part.Level);
  }
  // Touching lines may cross by rounding, and lines of discontinuous fields do cross.
  RefinementOptions options;
  options.InsertCrossings = true;
  options.Progress = ProgressPart(progress, 0.0, CutDone);
  DGG_RETURN_IF_ERROR(RefineAlongPaths(*field.Mesh, cuts, options, bands.Surface));
  DGG_RETURN_IF_ERROR(ReportTo(progress, CutDone));
  BandFinder finder(field, pieces, bands);
  finder.FindDistances(levels, levelOf);
  DGG_RETURN_IF_ERROR(ReportTo(progress, CornersDone));
  DGG_RETURN_IF_ERROR(finder.FindBands());
  DistanceRange range = finder.FindRange();
  if (pieces)
  {
    DGG_RETURN_IF_ERROR(pieces->Group.Sum(range));
  }
  bands.Range = range.Values;
  return ReportTo(progress, 1.0);
}
}
