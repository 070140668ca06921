// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggGreensColumn.h"

#include "dggCornerModel.h"
#include "dggGeodesicSource.h"
#include "dggLocalizedGreens.h"
#include "dggProgressPart.h"
#include "dggSourceFinding.h"

#include <algorithm>
#include <cmath>

namespace dgg
{
namespace
{
constexpr double VisibleAngle = Pi / 3.0;

/// Returns the angle at one end of a segment in the plane, from the distances of its ends.
double PlaneAngle(double length, double fromHere, double fromThere)
{
  const Point2 source = LayOut(length, fromHere, fromThere);
  return std::atan2(source.Y, source.X);
}

/// Returns the deviation between the direction in which shortest paths arrive at the origin of an
/// edge and the direction implied by the distances of both ends.
double Misdirection(const SurfaceMesh& mesh, Id v, double polarAngle, double length,
  double distance, double other, const VirtualSources& sources)
{
  const CornerModel model(mesh, v, { 0.0, distance, sources[v].Angle });
  if (!model.IsKnown || !(sources[v].Length > 0.0))
  {
    return 0.0;
  }
  const double angle = std::min(Pi, std::abs(model.AngleFrom(polarAngle)));
  return std::abs(angle - PlaneAngle(length, distance, other));
}

/// Returns the smallest distance of an edge at whose ends shortest paths from the source arrive in
/// directions that differ by more than 60 degrees, with the edge and its paths unfolded into the
/// plane; Infinity if there is no such edge. Behind every convex vertex, paths also meet from two
/// sides, but with hardly different directions; such ridges are ignored. Edges within the distance
/// `checked` are skipped.
double FindRidgeRadius(const SurfaceMesh& mesh, const std::vector<GeodesicSource>& sources,
  const ExactResult& distances, double checked = 0.0)
{
  VirtualSources found;
  FindVirtualSources(mesh, sources, distances, found);
  const std::vector<double>& d = distances.Distances;
  double radius = Infinity;
  for (Id h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
  {
    const Id t = mesh.Twin(h);
    if (mesh.IsDropped(SurfaceMesh::Face(h)) || t < h)
    {
      continue; // one half-edge per interior edge; boundaries bend shortest paths
    }
    const Id i = mesh.Origin(h);
    const Id j = mesh.Destination(h);
    const double here = d[i];
    const double there = d[j];
    // Edges that end at the source are skipped as well.
    if (!(std::max(here, there) < Infinity) || !(std::min(here, there) < radius) ||
      !(std::min(here, there) > 0.0) || std::max(here, there) < checked || mesh.Origin(t) != j)
    {
      continue;
    }
    const double difference =
      Misdirection(mesh, i, mesh.PolarAngle(h), mesh.Length(h), here, there, found) +
      Misdirection(mesh, j, mesh.PolarAngle(t), mesh.Length(h), there, here, found);
    if (difference > VisibleAngle)
    {
      radius = std::min(here, there);
    }
  }
  return radius;
}

/// Minimum R, in mean edges.
constexpr double LeastEdges = 4.0;
/// Minimum default R, in longest sides of triangles.
constexpr double LeastSides = 2.0;
/// Default R, in square roots of the area: about a radian on a sphere. R is slightly larger on
/// coarse meshes, up to CoarseEdges mean edges.
constexpr double UsualPart = 0.28;
constexpr double LargestPart = 0.35;
constexpr double CoarseEdges = 8.0;
/// Maximum R, in mean edges. The error of this R is well below that of the mesh, and exact
/// distances farther away would cost more than all other steps.
constexpr double MostEdges = 48.0;
/// Initial margin of distances beyond R, in mean edges; sufficient except for long edges.
constexpr double UsualMargin = 2.0;
/// Initial search distance of ridges, in mean edges, and its growth factor per step.
constexpr double FirstEdges = 18.0;
constexpr double Growth = 1.7;
/// R as a fraction of the distance to a ridge.
constexpr double RidgeMargin = 0.9;
/// R in mean edges if ridges are nearer. r then has kinks at the ridges, which are less harmful
/// than a steep s, and much less harmful than no s.
constexpr double RidgeEdges = 10.0;
/// Maximum requested R, in square roots of the area. No surface is that large.
constexpr double LargestMultiple = 1e6;
/// Minimum fraction of R that is kept if long edges extend beyond the computed distances.
constexpr double CompletePart = 0.7;
/// Maximum expected number of windows per vertex of the mesh for continuing the search. More
/// windows would cost several times the solve.
constexpr double WindowsPerVertex = 8.0;
/// Tolerance, relative to the sides, with which distances to the corners must fit the plane for a
/// point inside a triangle.
constexpr double FitTolerance = 1e-7;

/// Returns the largest distance d such that all corners of every face with a corner within d are
/// reached.
double FindCompleteRadius(
  const IntrinsicTriangulation& triangulation, const std::vector<double>& distances)
{
  double radius = Infinity;
  for (Id h = 0; h < triangulation.GetNumberOfHalfEdges(); ++h)
  {
    const double here = distances[triangulation.Origin(h)];
    const double there = distances[triangulation.Destination(h)];
    radius = std::max(here, there) < Infinity ? radius : std::min({ radius, here, there });
  }
  return radius;
}
}

Status CheckGreensQuery(const PoissonSolver& solver, const GreensQuery& query)
{
  if (!solver.IsReady())
  {
    return InvalidInput("The solver has not been prepared").Fix("Call Prepare() first");
  }
  if (!(query.Radius >= 0.0) || !(query.Radius < Infinity))
  {
    return InvalidValue("Radius", query.Radius).Fix("Use a finite number of at least 0");
  }
  for (std::size_t k = 0; k < query.Targets.size(); ++k)
  {
    DGG_RETURN_IF_ERROR(query.Targets[k].Check(solver.GetMesh()).Of(JoinText("Target ", k)));
  }
  return Status::Success();
}

double InterpolateAt(
  const SurfaceMesh& mesh, const SurfacePoint& point, const std::vector<double>& values)
{
  if (IsVertex(point))
  {
    return values[point.Vertex];
  }
  double sum = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    sum += point.Barycentric[k] * values[mesh.Origin(3 * point.Face + k)];
  }
  return sum;
}

Status GreensColumn::Start(const SurfacePoint& pole, const GreensQuery& query,
  const ProgressCallback& progress, GreensWorkspace& workspace)
{
  const SurfaceMesh& mesh = this->System.GetMesh();
  this->Pole = pole;
  this->Query = query;
  this->Progress = progress;
  this->Method = query.Method;
  this->Remark = GreensRemark::None;
  this->Mean = 0.0;
  this->Sources.assign(this->System.GetNumberOfVertices(), 0.0);
  this->Component = this->System.GetComponent(pole);
  if (this->Method == GreensMethod::Vertex && !IsVertex(pole))
  {
    const Id corner = this->FindNearestFreeCorner();
    if (corner != NoId)
    {
      this->AddLoad(corner, 1.0);
      return Status::Success();
    }
    this->Method = GreensMethod::Interpolated;
  }
  if (this->Method == GreensMethod::SingularitySubtraction && !(query.Radius > 0.0) &&
    HasLargeTriangles(this->System, this->Component))
  {
    this->Method = GreensMethod::Interpolated;
    this->Remark = GreensRemark::TooCoarse;
  }
  if (this->Method == GreensMethod::SingularitySubtraction)
  {
    Status status = this->StartWithLogarithm(workspace);
    if (!status.IsOk() || this->Method == GreensMethod::SingularitySubtraction)
    {
      return status;
    }
  }
  bool isLoaded = false;
  ForEachCornerAround(mesh, pole, [&](Id v, double weight, double) {
    const bool isFree = weight > 0.0 && !this->System.IsFixed(v);
    this->AddLoad(v, isFree ? weight : 0.0);
    isLoaded = isLoaded || isFree;
  });
  // If all corners have given values, the pole does not affect the finite elements.
  this->Remark = isLoaded ? this->Remark : GreensRemark::TooCoarse;
  return Status::Success();
}

/// Returns the corner of the pole's face with the largest barycentric coordinate and no given
/// value; NoId if there is none.
Id GreensColumn::FindNearestFreeCorner() const
{
  Id corner = NoId;
  double largest = 0.0;
  ForEachCornerAround(this->System.GetMesh(), this->Pole, [&](Id v, double weight, double) {
    if (weight > largest && !this->System.IsFixed(v))
    {
      corner = v;
      largest = weight;
    }
  });
  return corner;
}

Status GreensColumn::FindDistances(double maximum, GreensWorkspace& workspace)
{
  ExactOptions options;
  options.MaximumDistance = maximum;
  options.Targets = this->Query.Targets;
  // The number of searches is unknown, so that each search gets half of the remaining progress.
  options.Progress = ProgressPart(this->Progress, 0.0, 0.5);
  this->Progress = ProgressPart(this->Progress, 0.5, 1.0);
  return workspace.Exact.RunKept({ { this->Pole, 0.0 } }, options);
}

/// Extends distances until all corners of the faces with a corner within the radius are reached.
Status GreensColumn::CompleteDistances(double radius, double reached, GreensWorkspace& workspace)
{
  const ExactResult& result = workspace.Exact.GetKept();
  const IntrinsicTriangulation& triangulation = this->System.GetTriangulation();
  while (true)
  {
    double needed = 0.0;
    for (Id h = 0; h < triangulation.GetNumberOfHalfEdges(); ++h)
    {
      const double here = result.Distances[triangulation.Origin(h)];
      const double there = result.Distances[triangulation.Destination(h)];
      const bool isCut = std::min(here, there) < radius && !(std::max(here, there) < Infinity);
      needed = isCut ? std::max(needed, std::min(here, there) + triangulation.Length(h)) : needed;
    }
    if (!(needed > reached))
    {
      return Status::Success();
    }
    reached = needed * (1.0 + 1e-9);
    DGG_RETURN_IF_ERROR(this->FindDistances(reached, workspace));
  }
}

double GreensColumn::GetPoleAngle() const
{
  const SurfaceMesh& mesh = this->System.GetMesh();
  if (IsVertex(this->Pole))
  {
    return mesh.TotalAngle(this->Pole.Vertex);
  }
  if (this->Pole.On == SurfacePoint::Support::Face)
  {
    return 2.0 * Pi;
  }
  double angle = 0.0; // pi in each face of the edge
  ForEachFaceAround(mesh, this->Pole, [&](Id, const std::array<double, 3>&) { angle += Pi; });
  return angle;
}

/// Finds the triangles that contain the pole; none for a pole at a vertex, for which distances
/// suffice. Returns false if they are not found.
bool GreensColumn::FindPoleFaces(std::vector<PoleFace>& faces) const
{
  if (IsVertex(this->Pole))
  {
    return true;
  }
  if (this->System.GetOptions().IntrinsicDelaunay)
  {
    return this->FindFlippedPoleFace(faces);
  }
  const SurfaceMesh& mesh = this->System.GetMesh();
  ForEachFaceAround(mesh, this->Pole, [&](Id f, const std::array<double, 3>& b) {
    PoleFace face{ this->System.GetTriangleOf(f), b, {} };
    for (int k = 0; k < 3; ++k)
    {
      face.Distances[k] = DistanceToCorner(mesh, f, b, k);
    }
    faces.push_back(face);
  });
  return true;
}

/// Finds the triangle of the flipped mesh that contains the pole, given the distances of its
/// corners from the pole. Returns false if no triangle fits.
bool GreensColumn::FindFlippedPoleFace(std::vector<PoleFace>& faces) const
{
  const IntrinsicTriangulation& triangulation = this->System.GetTriangulation();
  double best = FitTolerance;
  PoleFace found;
  for (Id f = 0; f < triangulation.GetNumberOfFaces(); ++f)
  {
    PoleFace face;
    face.Face = f;
    double longest = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      face.Distances[k] = this->Distances[triangulation.Origin(3 * f + k)];
      longest = std::max(longest, triangulation.Length(3 * f + k));
    }
    const auto& d = face.Distances;
    if (!(std::max({ d[0], d[1], d[2] }) <= longest))
    {
      continue;
    }
    const double base = triangulation.Length(3 * f);
    const Point2 apex = triangulation.Apex(f);
    const Point2 pole = LayOut(base, d[0], d[1]);
    const double misfit = std::abs(Distance(pole, apex) - d[2]) / longest;
    const double third = pole.Y / apex.Y;
    const double second = (pole.X - third * apex.X) / base;
    const double outside = -std::min({ third, second, 1.0 - second - third });
    if (std::max(misfit, outside) < best)
    {
      best = std::max(misfit, outside);
      const double b1 = std::max(0.0, second);
      const double b2 = std::max(0.0, third);
      const double b0 = std::max(0.0, 1.0 - second - third);
      const double sum = b0 + b1 + b2;
      face.Barycentric = { { b0 / sum, b1 / sum, b2 / sum } };
      found = face;
    }
  }
  if (found.Face != NoId)
  {
    faces.push_back(found);
  }
  return found.Face != NoId;
}

double GreensColumn::GetUsualRadius(const PoissonSystem& system, Id component)
{
  const double edge = system.GetMeanEdge(component);
  const double size = std::sqrt(system.GetComponentArea(component));
  return std::min(
    MostEdges * edge, std::clamp(CoarseEdges * edge, UsualPart * size, LargestPart * size));
}

bool GreensColumn::IsTooCoarse(const PoissonSystem& system, Id component, double radius)
{
  return radius < LeastEdges * system.GetMeanEdge(component);
}

bool GreensColumn::HasLargeTriangles(const PoissonSystem& system, Id component)
{
  return GetUsualRadius(system, component) < LeastSides * system.GetMeanLongestSide(component);
}

/// Chooses a radius within which shortest paths do not meet from different sides, if possible, and
/// computes these paths.
Status GreensColumn::ChooseRadius(GreensWorkspace& workspace, double& radius, double& reached)
{
  const ExactResult& result = workspace.Exact.GetKept();
  const SurfaceMesh& mesh = this->System.GetMesh();
  const double edge = this->System.GetMeanEdge(this->Component);
  const double most = GetUsualRadius(this->System, this->Component);
  const double margin = UsualMargin * edge;
  const double budget = WindowsPerVertex * mesh.GetNumberOfVertices();
  // The radius grows in steps, because ridges may be near and the cost of paths is superlinear. On
  // most meshes the first step also covers the margin beyond the radius.
  double checked = 0.0;
  radius = std::min(most, FirstEdges * edge);
  while (true)
  {
    reached = radius + margin;
    DGG_RETURN_IF_ERROR(this->FindDistances(reached, workspace));
    const double ridge =
      RidgeMargin * FindRidgeRadius(mesh, { { this->Pole, 0.0 } }, result, checked);
    if (ridge < radius)
    {
      const double least = std::min(most, RidgeEdges * edge);
      this->Remark = ridge < least ? GreensRemark::NearRidge : this->Remark;
      radius = std::max(ridge, least);
      return Status::Success();
    }
    const double cost = static_cast<double>(result.NumberOfWindows) * Growth * Growth;
    if (radius >= most || cost > budget)
    {
      return Status::Success();
    }
    checked = reached;
    radius = std::min(most, Growth * radius);
  }
}

Status GreensColumn::StartWithLogarithm(GreensWorkspace& workspace)
{
  const PoissonSystem& system = this->System;
  // A radius beyond the entire surface only adds a constant, which is subtracted at the end.
  const double size = std::sqrt(system.GetComponentArea(this->Component));
  double radius = std::min(this->Query.Radius, LargestMultiple * size);
  double reached = radius + UsualMargin * system.GetMeanEdge(this->Component);
  const ExactResult& result = workspace.Exact.GetKept();
  DGG_RETURN_IF_ERROR(radius > 0.0 ? this->FindDistances(reached, workspace)
                                   : this->ChooseRadius(workspace, radius, reached));
  if (this->Query.Radius > 0.0)
  {
    const double ridge = FindRidgeRadius(system.GetMesh(), { { this->Pole, 0.0 } }, result);
    this->Remark = ridge < radius ? GreensRemark::NearRidge : this->Remark;
  }
  else
  {
    // A slightly smaller radius is preferable to recomputing all paths because of a long edge.
    const double complete = FindCompleteRadius(system.GetTriangulation(), result.Distances);
    radius = complete > CompletePart * radius ? std::min(radius, complete) : radius;
  }
  DGG_RETURN_IF_ERROR(this->CompleteDistances(radius, reached, workspace));
  if (IsTooCoarse(system, this->Component, radius))
  {
    this->Method = GreensMethod::Interpolated;
    this->Remark = GreensRemark::TooCoarse;
    return Status::Success();
  }
  this->Distances = result.Distances;
  this->TargetDistances = result.TargetDistances;
  std::vector<PoleFace> faces;
  if (!this->FindPoleFaces(faces))
  {
    this->Method = GreensMethod::Interpolated;
    this->Remark = GreensRemark::NoTriangle;
    return Status::Success();
  }
  this->Singular = Logarithm(radius, this->GetPoleAngle());
  const bool isSecond = this->Query.Order == GreensOrder::BiLaplace;
  workspace.Singular.Assemble(this->Singular, this->Distances, faces, isSecond);
  this->Sources = workspace.Singular.GetLoads();
  this->Integrals = workspace.Singular.GetIntegrals();
  if (faces.empty())
  {
    this->AddLoad(this->Pole.Vertex, 1.0);
  }
  else
  {
    for (int k = 0; k < 3; ++k)
    {
      this->AddLoad(
        system.GetTriangulation().Origin(3 * faces[0].Face + k), faces[0].Barycentric[k]);
    }
  }
  const bool isFree = system.IsFree(this->Component);
  for (Id v = 0; v < system.GetNumberOfVertices(); ++v)
  {
    if (system.IsFixed(v))
    {
      this->Sources[v] = -this->Singular.At(this->Distances[v]);
    }
    const double area = system.GetArea(v);
    this->Mean += isFree && area > 0.0 ? system.GetWeight(v) / area * this->Integrals[v] : 0.0;
    this->Integrals[v] += isSecond ? workspace.Singular.GetPotentialLoads()[v] : 0.0;
  }
  return Status::Success();
}

double GreensColumn::SingularAt(double distance, double area) const
{
  if (distance > 0.0 || this->Query.Pole == GreensPole::Infinite)
  {
    return this->Singular.At(distance);
  }
  return this->Singular.MeanOverDisk(std::sqrt(2.0 * area / this->Singular.GetAngle()));
}

Status GreensColumn::Finish(std::vector<double>& solution, const ProgressCallback& progress,
  GreensWorkspace& workspace, GreensResult& result) const
{
  const PoissonSystem& system = this->System;
  bool isLocalized = true;
  if (this->Method == GreensMethod::Localized && !IsVertex(this->Pole))
  {
    DGG_RETURN_IF_ERROR(
      Localize(system, this->Pole, workspace.Exact, progress, solution, isLocalized));
  }
  for (Id v = 0; v < system.GetNumberOfVertices() && this->HasLogarithm(); ++v)
  {
    solution[v] -= system.GetComponent(v) == this->Component ? this->Mean : 0.0;
  }
  this->AddLogarithm(solution, result);
  if (!isLocalized)
  {
    result.Method = GreensMethod::Interpolated;
    result.Remark = GreensRemark::NotLocalized;
  }
  return Status::Success();
}

void GreensColumn::AddLogarithm(std::vector<double>& solution, GreensResult& result) const
{
  const PoissonSystem& system = this->System;
  const SurfaceMesh& mesh = system.GetMesh();
  result = GreensResult();
  result.Method = this->Method;
  result.Remark = this->Remark;
  result.Radius = this->HasLogarithm() ? this->Singular.GetRadius() : 0.0;
  const Id n = system.GetNumberOfVertices();
  const double sign = this->Query.Sign == GreensSign::Positive ? 1.0 : -1.0;
  const std::vector<SurfacePoint>& targets = this->Query.Targets;
  result.TargetValues.reserve(targets.size());
  for (std::size_t k = 0; k < targets.size(); ++k)
  {
    double value = InterpolateAt(mesh, targets[k], solution);
    if (this->HasLogarithm())
    {
      const Id h = 3 * targets[k].Face;
      const double area = IsVertex(targets[k])
        ? system.GetArea(targets[k].Vertex)
        : TriangleArea(mesh.Length(h), mesh.Length(h + 1), mesh.Length(h + 2)) / 3.0;
      value += this->SingularAt(this->TargetDistances[k], area);
    }
    result.TargetValues.push_back(sign * value);
  }
  if (this->Query.WantIntegrals)
  {
    result.Integrals.resize(n);
    for (Id v = 0; v < n; ++v)
    {
      result.Integrals[v] = sign *
        (system.GetArea(v) * solution[v] + (this->HasLogarithm() ? this->Integrals[v] : 0.0));
    }
  }
  for (Id v = 0; v < n; ++v)
  {
    if (this->HasLogarithm() && this->Distances[v] < Infinity)
    {
      solution[v] += this->SingularAt(this->Distances[v], system.GetArea(v));
    }
    solution[v] *= sign;
  }
  result.Values.swap(solution);
}
}
