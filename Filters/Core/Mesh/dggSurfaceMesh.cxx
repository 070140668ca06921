// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggSurfaceMesh.h"

#include "dggSurfaceMeshBuilder.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace dgg
{
namespace
{
/// An empty mesh rather than a half-built one after a failure.
Status Conclude(const Status& status, SurfaceMesh& mesh)
{
  if (!status.IsOk())
  {
    mesh = SurfaceMesh();
  }
  return status;
}
}

Status SurfaceMesh::FromPoints(const double* points, Offset numberOfPoints, const Id* triangles,
  Offset numberOfTriangles, SurfaceMesh& mesh)
{
  SurfaceMeshBuilder builder(mesh);
  Status status = builder.TakeTriangles(numberOfPoints, triangles, numberOfTriangles);
  if (status.IsOk())
  {
    builder.DropRepeatedVertexFaces();
    builder.GlueByVertices();
    status = builder.MeasureLengths(points);
  }
  if (status.IsOk())
  {
    builder.Orient();
    builder.Mollify();
    builder.Finish();
  }
  return Conclude(status, mesh);
}

Status SurfaceMesh::FromLengths(Offset numberOfVertices, const Id* triangles,
  Offset numberOfTriangles, const double* lengths, SurfaceMesh& mesh, const PartOfMesh& origin)
{
  SurfaceMeshBuilder builder(mesh);
  Status status = builder.TakeTriangles(numberOfVertices, triangles, numberOfTriangles);
  if (status.IsOk())
  {
    builder.DropRepeatedVertexFaces();
    builder.GlueByVertices();
    status = builder.TakeLengths(lengths);
  }
  if (status.IsOk())
  {
    status = builder.CheckTriangleInequalities();
  }
  if (status.IsOk())
  {
    builder.TakeOrigin(origin);
    builder.Orient();
    builder.Mollify();
    builder.Finish();
  }
  return Conclude(status, mesh);
}

Status SurfaceMesh::FromGluedLengths(Offset numberOfVertices, const Id* triangles,
  Offset numberOfTriangles, const double* lengths, const Id* twins, SurfaceMesh& mesh,
  const PartOfMesh& origin)
{
  SurfaceMeshBuilder builder(mesh);
  Status status = builder.TakeTriangles(numberOfVertices, triangles, numberOfTriangles);
  if (status.IsOk())
  {
    // A face that names a vertex twice is a legal face here: the gluing says which corner is which.
    status = builder.GlueByTwins(twins);
  }
  if (status.IsOk())
  {
    status = builder.TakeLengths(lengths);
  }
  if (status.IsOk())
  {
    status = builder.CheckTriangleInequalities();
  }
  if (status.IsOk())
  {
    builder.TakeOrigin(origin);
    builder.Orient();
    builder.Mollify();
    builder.Finish();
  }
  return Conclude(status, mesh);
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
  std::vector<Id> parent(n);
  std::iota(parent.begin(), parent.end(), 0);
  auto find = [&](Id v) {
    while (parent[v] != v)
    {
      parent[v] = parent[parent[v]];
      v = parent[v];
    }
    return v;
  };
  for (Id h = 0; h < this->GetNumberOfHalfEdges(); ++h)
  {
    if (!this->IsDropped(Face(h)))
    {
      const Id a = find(this->Origin(h));
      const Id b = find(this->Destination(h));
      parent[std::max(a, b)] = std::min(a, b);
    }
  }
  // Roots are the smallest ids of their components, so they come first.
  std::vector<Id> component(n, NoId);
  numberOfComponents = 0;
  for (Id v = 0; v < n; ++v)
  {
    const Id root = find(v);
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
    this->FaceFlags.size();
}
}
