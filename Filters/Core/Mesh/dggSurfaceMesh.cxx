// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggSurfaceMesh.h"

#include "dggDisjointSets.h"
#include "dggSurfaceMeshBuilder.h"

#include <algorithm>
#include <cmath>

namespace dgg
{
namespace
{
/// Deviation from 2 pi, radians, below which total angles are flat.
constexpr double FlatTolerance = 1e-9 * 2.0 * Pi;

/// Completes a mesh if its lengths are valid. Otherwise clears the mesh rather than leaving it
/// half-built, and returns the error.
Status Complete(SurfaceMeshBuilder& builder, const Status& status, SurfaceMesh& mesh)
{
  if (status.IsOk())
  {
    builder.Orient();
    builder.Mollify();
    builder.Finish();
  }
  else
  {
    mesh = SurfaceMesh();
  }
  return status;
}

Status CompleteFromLengths(
  SurfaceMeshBuilder& builder, const double* lengths, const PartOfMesh& origin, SurfaceMesh& mesh)
{
  Status status = builder.TakeLengths(lengths);
  if (status.IsOk())
  {
    status = builder.CheckTriangleInequalities();
  }
  if (status.IsOk())
  {
    builder.TakeOrigin(origin);
  }
  status = Complete(builder, status, mesh);
  mesh.MeasureAngles();
  return status;
}
}

Status SurfaceMesh::FromPoints(const double* points, Offset numberOfPoints, const Id* triangles,
  Offset numberOfTriangles, SurfaceMesh& mesh, const std::uint8_t* isRim)
{
  Status status =
    FromPointsWithoutAngles(points, numberOfPoints, triangles, numberOfTriangles, mesh, isRim);
  mesh.MeasureAngles();
  return status;
}

Status SurfaceMesh::FromPointsWithoutAngles(const double* points, Offset numberOfPoints,
  const Id* triangles, Offset numberOfTriangles, SurfaceMesh& mesh, const std::uint8_t* isRim)
{
  SurfaceMeshBuilder builder(mesh);
  Status status = builder.TakeTriangles(numberOfPoints, triangles, numberOfTriangles);
  if (status.IsOk())
  {
    builder.GlueByVertices(isRim);
    status = builder.MeasureLengths(points);
  }
  return Complete(builder, status, mesh);
}

Status SurfaceMesh::FromLengths(Offset numberOfVertices, const Id* triangles,
  Offset numberOfTriangles, const double* lengths, SurfaceMesh& mesh, const PartOfMesh& origin)
{
  SurfaceMeshBuilder builder(mesh);
  const Status status = builder.TakeTriangles(numberOfVertices, triangles, numberOfTriangles);
  if (!status.IsOk())
  {
    return Complete(builder, status, mesh);
  }
  builder.GlueByVertices();
  return CompleteFromLengths(builder, lengths, origin, mesh);
}

Status SurfaceMesh::FromGluedLengths(Offset numberOfVertices, const Id* triangles,
  Offset numberOfTriangles, const double* lengths, const Id* twins, SurfaceMesh& mesh,
  const PartOfMesh& origin)
{
  SurfaceMeshBuilder builder(mesh);
  Status status = builder.TakeTriangles(numberOfVertices, triangles, numberOfTriangles);
  if (status.IsOk())
  {
    // Faces that contain a vertex twice are valid with explicit gluing, because the gluing
    // identifies the corners.
    status = builder.GlueByTwins(twins);
  }
  return status.IsOk() ? CompleteFromLengths(builder, lengths, origin, mesh)
                       : Complete(builder, status, mesh);
}

void SurfaceMesh::MeasureAngles()
{
  const Id n = this->GetNumberOfVertices();
  this->PolarAngles.assign(this->Lengths.size(), 0.0);
  this->TotalAngles.assign(n, 0.0);
  this->Kinds.assign(n, VertexKind::Isolated);
  for (Id v = 0; v < n; ++v)
  {
    double angle = 0.0;
    for (const Id* h = this->FanBegin(v); h != this->FanEnd(v); ++h)
    {
      this->PolarAngles[*h] = angle;
      angle += this->CornerAngle(*h);
    }
    this->TotalAngles[v] = angle;
    this->Kinds[v] = this->Classify(v);
  }
}

VertexKind SurfaceMesh::Classify(Id v) const
{
  if (this->FanBegin(v) == this->FanEnd(v))
  {
    return VertexKind::Isolated;
  }
  if (this->IsIrregular(v))
  {
    return VertexKind::Irregular;
  }
  if (this->Twin(*this->FanBegin(v)) == NoId)
  {
    return VertexKind::Boundary;
  }
  const double excess = this->TotalAngles[v] - 2.0 * Pi;
  if (std::abs(excess) <= FlatTolerance)
  {
    return VertexKind::Flat;
  }
  return excess < 0.0 ? VertexKind::Convex : VertexKind::Saddle;
}

Id SurfaceMesh::GetOriginal(Id f) const
{
  return this->IsDuplicate(f) ? (*std::lower_bound(this->Duplicates.begin(), this->Duplicates.end(),
                                  std::array<Id, 2>{ { f, 0 } }))[1]
                              : f;
}

bool SurfaceMesh::IsPassThrough(Id v) const
{
  switch (this->Kinds[v])
  {
    case VertexKind::Flat:
    case VertexKind::Saddle:
    case VertexKind::Irregular:
      return true;
    case VertexKind::Boundary:
      return this->TotalAngles[v] > Pi * (1.0 - 1e-9);
    case VertexKind::Isolated:
    case VertexKind::Convex:
      return false;
  }
  return true;
}

double SurfaceMesh::CornerAngle(Id h) const
{
  return std::atan2(this->ApexYs[h], this->ApexXs[h]);
}

std::vector<Id> SurfaceMesh::ComputeComponents(Id& numberOfComponents) const
{
  const Id n = this->GetNumberOfVertices();
  DisjointSets sets(static_cast<std::size_t>(n));
  for (Id h = 0; h < this->GetNumberOfHalfEdges(); ++h)
  {
    if (!this->IsDropped(Face(h)))
    {
      sets.Join(this->Origin(h), this->Destination(h));
    }
  }
  // Roots have the smallest ids of their components, so that they come first.
  std::vector<Id> component(n, NoId);
  numberOfComponents = 0;
  for (Id v = 0; v < n; ++v)
  {
    const Id root = sets.Find(v);
    component[v] = root == v ? numberOfComponents++ : component[root];
  }
  return component;
}

std::size_t SurfaceMesh::GetMemorySize() const
{
  return this->Origins.size() * sizeof(Id) + this->Twins.size() * sizeof(Id) +
    (this->Lengths.size() + this->ApexXs.size() + this->ApexYs.size() + this->PolarAngles.size() +
      this->TotalAngles.size()) *
    sizeof(double) +
    this->FanOffsets.size() * sizeof(Offset) + this->Fans.size() * sizeof(Id) + this->Kinds.size() +
    this->VertexFlags.size() + this->FaceFlags.size();
}
}
