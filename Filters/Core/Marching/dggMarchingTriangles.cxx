// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggMarchingTriangles.h"

#include "dggUnfolding.h"

#include <cmath>

namespace dgg
{
namespace
{
/// Faces in a strip: more are needed only where slivers are many.
constexpr int LongestStrip = 100;

/// An edge on its way away from a corner at the origin of the plane.
struct StripEdge
{
  Point2 Right;
  Point2 Left;
  Id RightVertex;
  Id LeftVertex;
};
}

MarchingTriangle MarchingTriangles::FromFace(const SurfaceMesh& mesh, Id h)
{
  const Id next = SurfaceMesh::Next(h);
  const Id previous = SurfaceMesh::Previous(h);
  return { mesh.Origin(h), mesh.Origin(next), mesh.Origin(previous), mesh.Length(next),
    mesh.Length(h), mesh.Length(previous), mesh.PolarAngle(h) };
}

MarchingTriangles::MarchingTriangles(const SurfaceMesh& mesh)
{
  for (Id h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
  {
    if (!mesh.IsDropped(SurfaceMesh::Face(h)) && mesh.ApexX(h) < 0.0)
    {
      this->Split(mesh, h);
    }
  }
  this->Offsets.assign(static_cast<std::size_t>(mesh.GetNumberOfVertices()) + 1, 0);
  for (const MarchingTriangle& triangle : this->Triangles)
  {
    ++this->Offsets[triangle.Right + 1];
    ++this->Offsets[triangle.Left + 1];
  }
  for (std::size_t v = 1; v < this->Offsets.size(); ++v)
  {
    this->Offsets[v] += this->Offsets[v - 1];
  }
  this->ByVertex.resize(static_cast<std::size_t>(this->Offsets.back()));
  std::vector<Offset> fill(this->Offsets.begin(), this->Offsets.end() - 1);
  for (std::size_t i = 0; i < this->Triangles.size(); ++i)
  {
    this->ByVertex[fill[this->Triangles[i].Right]++] = static_cast<Id>(i);
    this->ByVertex[fill[this->Triangles[i].Left]++] = static_cast<Id>(i);
  }
}

void MarchingTriangles::Split(const SurfaceMesh& mesh, Id h)
{
  const Id next = SurfaceMesh::Next(h);
  const Point2 right{ mesh.Length(h), 0.0 };
  const Point2 left{ mesh.ApexX(h), mesh.ApexY(h) };
  // Directions that leave no obtuse angle: at most a right angle from both sides.
  const auto splits = [&](const Point2& p) {
    return Dot(p, right) >= 0.0 && Dot(p, left) >= 0.0 && Cross(right, p) > 0.0 &&
      Cross(p, left) > 0.0;
  };
  const StripEdge start{ right, left, mesh.Origin(next), mesh.Destination(next) };
  for (Id first = mesh.Twin(next); first != NoId && first != next; first = mesh.Twin(first))
  {
    StripEdge edge = start;
    Id entered = first;
    for (int step = 0; step < LongestStrip && entered != NoId; ++step)
    {
      // The frame of the entered half-edge, or its mirror image, with the corner below the axis.
      const bool isOpposed =
        mesh.Origin(entered) == edge.LeftVertex && mesh.Destination(entered) == edge.RightVertex;
      const double length = mesh.Length(entered);
      const double along = isOpposed ? FootOnEdge(length, mesh.Length(SurfaceMesh::Next(entered)),
                                         mesh.Length(SurfaceMesh::Previous(entered)))
                                     : mesh.ApexX(entered);
      const Point2 axis{ (edge.Left.X - edge.Right.X) / length,
        (edge.Left.Y - edge.Right.Y) / length };
      // Away from the corner is to the right of the way from Right to Left.
      const Point2 apex = FromFrame(edge.Right, axis, { along, -mesh.ApexY(entered) });
      const Id vertex = mesh.Apex(entered);
      if (splits(apex))
      {
        const double distance = Norm(apex.X, apex.Y);
        const double direction = mesh.PolarAngle(h);
        this->Triangles.push_back({ mesh.Origin(h), start.RightVertex, vertex,
          Distance(apex, right), Norm(right.X, right.Y), distance, direction });
        this->Triangles.push_back({ mesh.Origin(h), vertex, start.LeftVertex, Distance(apex, left),
          distance, Norm(left.X, left.Y), direction + std::atan2(apex.Y, apex.X) });
        break;
      }
      // On through the edge that the allowed directions cross.
      const bool isLeft = Dot(apex, left) < 0.0 || Cross(right, apex) <= 0.0; // passes left of it
      const Id toOrigin = SurfaceMesh::Previous(entered);
      const Id toEnd = SurfaceMesh::Next(entered);
      const Id exit = isLeft == isOpposed ? toOrigin : toEnd;
      if (isLeft)
      {
        edge.Right = apex;
        edge.RightVertex = vertex;
      }
      else
      {
        edge.Left = apex;
        edge.LeftVertex = vertex;
      }
      const Id twin = mesh.Twin(exit);
      // Strips go on over manifold edges only.
      entered = twin != NoId && mesh.Twin(twin) == exit ? twin : NoId;
    }
  }
}

std::size_t MarchingTriangles::GetMemorySize() const
{
  return this->Triangles.capacity() * sizeof(MarchingTriangle) +
    this->Offsets.capacity() * sizeof(Offset) + this->ByVertex.capacity() * sizeof(Id);
}
}
