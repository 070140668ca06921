// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggIsolineParts.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

namespace dgg
{
namespace
{
/// Curves between two reports.
constexpr std::size_t ProgressInterval = 4096;

/// A curve as a line runs through it.
struct Passage
{
  Id Curve;
  bool IsBackward;
};

class Joiner
{
public:
  Joiner(const SurfaceMesh& mesh, const std::vector<LevelCrossing>& crossings,
    const std::vector<FaceCurve>& curves)
    : Mesh(mesh)
    , Crossings(crossings)
    , Curves(curves)
    , IsUsed(curves.size(), false)
    , Ends(crossings.size())
  {
    for (std::size_t c = 0; c < curves.size(); ++c)
    {
      this->AddEnd(curves[c].First, static_cast<Id>(c));
      this->AddEnd(curves[c].Last, static_cast<Id>(c));
    }
  }

  bool IsDone(Id curve) const { return this->IsUsed[curve]; }

  /// The line through a curve. Returns whether it is closed.
  bool Join(Id curve, SurfacePath& line)
  {
    this->Passages.assign(1, { curve, false });
    this->IsUsed[curve] = true;
    bool isClosed = this->Curves[curve].First == NoId;
    if (!isClosed)
    {
      isClosed = this->Extend();
    }
    if (!isClosed)
    {
      this->TurnAround();
      this->Extend();
      this->TurnAround();
    }
    this->Draw(isClosed, line);
    return isClosed;
  }

private:
  /// The curves that end in a crossing.
  struct CurveEnds
  {
    std::array<Id, 2> Curves{ { NoId, NoId } };
    Id Count = 0;
  };

  void AddEnd(Id crossing, Id curve)
  {
    if (crossing != NoId)
    {
      CurveEnds& ends = this->Ends[crossing];
      if (ends.Count < 2)
      {
        ends.Curves[ends.Count] = curve;
      }
      ++ends.Count;
    }
  }

  Id StartOf(const Passage& p) const
  {
    return p.IsBackward ? this->Curves[p.Curve].Last : this->Curves[p.Curve].First;
  }
  Id StopOf(const Passage& p) const
  {
    return p.IsBackward ? this->Curves[p.Curve].First : this->Curves[p.Curve].Last;
  }

  /// Go on from the last curve as far as possible. Returns whether that leads back to the first
  /// one.
  bool Extend()
  {
    const Id start = this->StartOf(this->Passages.front());
    for (;;)
    {
      const Passage at = this->Passages.back();
      const Id crossing = this->StopOf(at);
      const CurveEnds& ends = this->Ends[crossing];
      if (ends.Count != 2)
      {
        return false;
      }
      if (crossing == start)
      {
        return true;
      }
      const Id next = ends.Curves[0] == at.Curve ? ends.Curves[1] : ends.Curves[0];
      if (this->IsUsed[next])
      {
        return false; // not reached: both of its ends would be the crossing
      }
      this->IsUsed[next] = true;
      this->Passages.push_back({ next, this->Curves[next].First != crossing });
    }
  }

  void TurnAround()
  {
    std::reverse(this->Passages.begin(), this->Passages.end());
    for (Passage& passage : this->Passages)
    {
      passage.IsBackward = !passage.IsBackward;
    }
  }

  SurfacePoint PointOf(Id crossing) const
  {
    const LevelCrossing& c = this->Crossings[crossing];
    return SurfacePoint::OnEdge(
      this->Mesh, c.HalfEdge, std::min(1.0, std::max(0.0, c.X / this->Mesh.Length(c.HalfEdge))));
  }

  /// The coordinates are those of the corners as the mesh has them.
  SurfacePoint PointOf(Id face, std::array<double, 3> b) const
  {
    if (this->Mesh.IsFlipped(face))
    {
      std::swap(b[1], b[2]);
    }
    // In a face of near-zero area, rounding of a place moves its coordinates by much more.
    double sum = 0.0;
    for (double& x : b)
    {
      x = std::max(0.0, x);
      sum += x;
    }
    for (double& x : b)
    {
      x /= sum;
    }
    const SurfacePoint point = SurfacePoint::InFace(this->Mesh, face, b);
    assert(point.Check(this->Mesh).IsOk());
    return point;
  }

  /// Append a point, unless it is where the line is.
  static void Append(const SurfacePoint& point, Id face, SurfacePath& line)
  {
    if (line.Points.empty())
    {
      line.Points.push_back(point);
    }
    else if (!IsSamePoint(line.Points.back(), point))
    {
      line.Points.push_back(point);
      line.Faces.push_back(face);
    }
  }

  void Draw(bool isClosed, SurfacePath& line) const
  {
    line.Clear();
    for (const Passage& passage : this->Passages)
    {
      const FaceCurve& curve = this->Curves[passage.Curve];
      if (curve.First != NoId)
      {
        Append(this->PointOf(this->StartOf(passage)), curve.Face, line);
      }
      for (std::size_t i = 0; i < curve.Points.size(); ++i)
      {
        const std::size_t at = passage.IsBackward ? curve.Points.size() - 1 - i : i;
        Append(this->PointOf(curve.Face, curve.Points[at]), curve.Face, line);
      }
      if (curve.First != NoId)
      {
        Append(this->PointOf(this->StopOf(passage)), curve.Face, line);
      }
    }
    if (isClosed && !line.Points.empty())
    {
      Append(
        SurfacePoint(line.Points.front()), this->Curves[this->Passages.back().Curve].Face, line);
    }
    for (std::size_t i = 0; i < line.Faces.size(); ++i)
    {
      line.Length += MeasurePiece(this->Mesh, line, i);
    }
  }

  const SurfaceMesh& Mesh;
  const std::vector<LevelCrossing>& Crossings;
  const std::vector<FaceCurve>& Curves;
  std::vector<bool> IsUsed;
  std::vector<CurveEnds> Ends;
  std::vector<Passage> Passages;
};
}

bool IsEdgeReached(const DistanceField& field, Id h)
{
  Id e = h;
  do
  {
    if (field.IsReached(SurfaceMesh::Face(e)))
    {
      return true;
    }
    e = field.Mesh->Twin(e);
  } while (e != NoId && e != h);
  return false;
}

Status JoinFaceCurves(const SurfaceMesh& mesh, const std::vector<LevelCrossing>& crossings,
  const std::vector<FaceCurve>& curves, const ProgressCallback& progress, Isolines& lines)
{
  std::vector<Id> order(curves.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(
    order.begin(), order.end(), [&](Id a, Id b) { return curves[a].Level < curves[b].Level; });
  Joiner joiner(mesh, crossings, curves);
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    const Id curve = order[i];
    if (i % ProgressInterval == 0 && progress &&
      !progress(static_cast<double>(i) / static_cast<double>(order.size())))
    {
      lines = Isolines();
      return Status::Abort();
    }
    if (joiner.IsDone(curve))
    {
      continue;
    }
    SurfacePath line;
    const bool isClosed = joiner.Join(curve, line);
    if (!line.Faces.empty())
    {
      lines.Lines.push_back(std::move(line));
      lines.Levels.push_back(curves[curve].Level);
      lines.IsClosed.push_back(isClosed);
    }
  }
  return Status::Success();
}
}
