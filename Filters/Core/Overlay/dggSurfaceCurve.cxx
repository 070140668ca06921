// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggSurfaceCurve.h"

#include "dggExactPath.h"
#include "dggProgressPart.h"
#include "dggStatus.h"

#include <algorithm>
#include <memory>
#include <string>

namespace dgg
{
namespace
{
/// Straight legs between two progress reports.
constexpr std::size_t ProgressInterval = 1024;

/// Joins the points one after the other.
class CurveBuilder
{
public:
  CurveBuilder(
    const SurfaceMesh& mesh, const std::vector<SurfacePoint>& points, SurfaceCurve& curve)
    : Mesh(mesh)
    , Points(points)
    , Curve(curve)
  {
  }

  Status Run(bool isClosed, const ProgressCallback& progress);

private:
  Status CheckPoints() const;
  Status FindLeg(std::size_t from, std::size_t to, const ProgressCallback& progress);
  void AddLeg(std::size_t from);

  const SurfaceMesh& Mesh;
  const std::vector<SurfacePoint>& Points;
  SurfaceCurve& Curve;
  std::unique_ptr<ExactPathFinder> Finder; // created for the first leg that is not straight
  SurfacePath Leg;                         // current leg
};

Status CurveBuilder::Run(bool isClosed, const ProgressCallback& progress)
{
  this->Curve = SurfaceCurve();
  this->Curve.IsClosed = isClosed;
  Status status = this->CheckPoints();
  const std::size_t points = this->Points.size();
  if (!status.IsOk() || points == 0)
  {
    return status;
  }
  this->Curve.Path.Points.push_back(this->Points[0]);
  this->Curve.Parameters.push_back(0.0);
  this->Curve.GivenPoints.push_back(0);
  const std::size_t legs = isClosed && points > 1 ? points : points - 1;
  for (std::size_t leg = 0; leg < legs && status.IsOk(); ++leg)
  {
    const double done = static_cast<double>(leg) / static_cast<double>(legs);
    const double next = static_cast<double>(leg + 1) / static_cast<double>(legs);
    if (progress && leg % ProgressInterval == 0 && !progress(done))
    {
      status = Status::Abort();
      break;
    }
    status = this->FindLeg(leg, (leg + 1) % points, ProgressPart(progress, done, next));
    if (status.IsOk())
    {
      this->AddLeg(leg);
    }
  }
  if (!status.IsOk())
  {
    this->Curve = SurfaceCurve();
  }
  return status;
}

Status CurveBuilder::CheckPoints() const
{
  for (std::size_t i = 0; i < this->Points.size(); ++i)
  {
    DGG_RETURN_IF_ERROR(
      this->Points[i].Check(this->Mesh).Of(JoinText("Point ", i, " of the curve")));
  }
  return Status::Success();
}

/// Computes the leg from one given point to another: straight within a common face, otherwise a
/// shortest path.
Status CurveBuilder::FindLeg(std::size_t from, std::size_t to, const ProgressCallback& progress)
{
  const SurfacePoint& start = this->Points[from];
  const SurfacePoint& end = this->Points[to];
  this->Leg.Clear();
  const Id face = FindCommonFace(this->Mesh, start, end);
  if (face != NoId)
  {
    this->Leg.Points = { start, end };
    this->Leg.Faces = { face };
    this->Leg.Length = MeasurePiece(this->Mesh, this->Leg, 0);
    return Status::Success();
  }
  if (progress && !progress(0.0))
  {
    return Status::Abort();
  }
  if (!this->Finder)
  {
    this->Finder = std::make_unique<ExactPathFinder>(this->Mesh);
  }
  std::vector<SurfacePath> paths;
  const std::string name = JoinText("Points ", from, " and ", to, " of the curve");
  DGG_RETURN_IF_ERROR(this->Finder->Find(start, { end }, progress, paths).Of(name));
  if (paths[0].Faces.empty())
  {
    return Status(Status::Code::NotConnected, name + " are not connected by the surface")
      .Fix("Split the curve in two");
  }
  this->Leg = std::move(paths[0]);
  this->Leg.Points.front() = start;
  this->Leg.Points.back() = end;
  return Status::Success();
}

/// Appends the leg that starts at a given point.
void CurveBuilder::AddLeg(std::size_t from)
{
  SurfacePath& path = this->Curve.Path;
  double behind = 0.0;
  const std::size_t pieces = this->Leg.Faces.size();
  for (std::size_t piece = 0; piece < pieces; ++piece)
  {
    path.Points.push_back(this->Leg.Points[piece + 1]);
    path.Faces.push_back(this->Leg.Faces[piece]);
    if (piece + 1 < pieces)
    {
      behind += MeasurePiece(this->Mesh, this->Leg, piece);
      this->Curve.Parameters.push_back(
        static_cast<double>(from) + std::min(1.0, behind / this->Leg.Length));
    }
  }
  this->Curve.Parameters.push_back(static_cast<double>(from + 1));
  path.Length += this->Leg.Length;
  if (from + 1 < this->Points.size())
  {
    this->Curve.GivenPoints.push_back(static_cast<Offset>(path.Points.size()) - 1);
  }
}

bool IsInFace(const SurfaceMesh& mesh, const SurfacePoint& point, Id face)
{
  std::array<double, 3> barycentric{};
  return FindInFace(mesh, point, face, barycentric);
}
}

Status JoinPoints(const SurfaceMesh& mesh, const std::vector<SurfacePoint>& points, bool isClosed,
  const ProgressCallback& progress, SurfaceCurve& curve)
{
  return CurveBuilder(mesh, points, curve).Run(isClosed, progress);
}

Id FindCommonFace(const SurfaceMesh& mesh, const SurfacePoint& a, const SurfacePoint& b)
{
  Id smallest = NoId;
  auto look = [&](const SurfacePoint& other, Id face) {
    if ((smallest == NoId || face < smallest) && IsInFace(mesh, other, face))
    {
      smallest = face;
    }
  };
  const bool areVertices = IsVertex(a) && IsVertex(b);
  if (!areVertices)
  {
    const SurfacePoint& point = IsVertex(a) ? b : a; // the point with few faces
    const SurfacePoint& other = IsVertex(a) ? a : b;
    ForEachFaceAround(
      mesh, point, [&](Id face, const std::array<double, 3>&) { look(other, face); });
    return smallest;
  }
  // The vertex with the smaller fan.
  const auto sizeOf = [&](Id v) { return mesh.FanEnd(v) - mesh.FanBegin(v); };
  const bool isFirst = sizeOf(a.Vertex) <= sizeOf(b.Vertex);
  const SurfacePoint& center = isFirst ? a : b;
  for (const Id* h = mesh.FanBegin(center.Vertex); h != mesh.FanEnd(center.Vertex); ++h)
  {
    look(isFirst ? b : a, SurfaceMesh::Face(*h));
  }
  return smallest;
}
}
