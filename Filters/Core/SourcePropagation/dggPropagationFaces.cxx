// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggPropagationFaces.h"

#include "dggEdges.h"
#include "dggPropagationPieces.h"

namespace dgg
{
namespace
{
/// An edge with more faces is a hub, because propagating from each of its faces into all others
/// would be too expensive.
constexpr Id FewFaces = 6;
/// Minimum bend of a path, radians.
constexpr double LeastBend = 1e-6;

/// Returns true if a path can bend at a vertex by more than rounding. Does not need the angles of
/// the mesh.
bool CanBendAt(const SurfaceMesh& mesh, Id v)
{
  double angle = 0.0;
  bool isOnBoundary = false;
  for (const Id* g = mesh.FanBegin(v); g != mesh.FanEnd(v); ++g)
  {
    angle += mesh.CornerAngle(*g);
    isOnBoundary = isOnBoundary || mesh.Twin(*g) == NoId;
  }
  return mesh.IsIrregular(v) || angle > (isOnBoundary ? Pi : 2.0 * Pi) + LeastBend;
}
}

PropagationFaces::PropagationFaces(const SurfaceMesh& mesh)
  : PropagationFaces(mesh, mesh.GetMeanEdgeLength(), nullptr)
{
}

PropagationFaces::PropagationFaces(
  const SurfaceMesh& mesh, double unit, const PropagationPieces* pieces)
  : Faces(static_cast<std::size_t>(mesh.GetNumberOfFaces()))
  , Unit(unit > 0.0 ? unit : 1.0)
{
  for (Id f = 0; f < mesh.GetNumberOfFaces(); ++f)
  {
    PropagationFace& face = this->Faces[f];
    for (int k = 0; k < 3; ++k)
    {
      const Id h = 3 * f + k;
      const double left = mesh.Length(3 * f + PreviousOf(k));
      face.Lengths[k] = static_cast<float>(mesh.Length(h) / this->Unit);
      face.Cosines[k] = static_cast<float>(mesh.ApexX(h) / left);
      face.Sines[k] = static_cast<float>(mesh.ApexY(h) / left);
      face.Corners[k] = mesh.Origin(h);
      face.Behind[k] = mesh.Twin(h);
      face.IsIrregular = face.IsIrregular || mesh.IsIrregular(mesh.Origin(h));
    }
    // Edges with several twins, or one of opposite orientation, have irregular vertices only.
    for (int k = 0; k < 3 && face.IsIrregular; ++k)
    {
      const Id h = 3 * f + k;
      const Id twin = mesh.Twin(h);
      if (twin != NoId && (mesh.Twin(twin) != h || mesh.Origin(twin) != mesh.Destination(h)))
      {
        face.Behind[k] = AskMesh;
      }
    }
  }
  this->LookAtVertices(mesh, pieces);
  if (this->NumberOfVertexHubs > 0)
  {
    this->FindEdgeHubs(mesh);
  }
}

void PropagationFaces::LookAtVertices(const SurfaceMesh& mesh, const PropagationPieces* pieces)
{
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    if (pieces && !pieces->HasVertex(v))
    {
      continue;
    }
    this->IsAnyBend = this->IsAnyBend || CanBendAt(mesh, v);
    if (mesh.IsIrregular(v))
    {
      this->VertexHubs.resize(static_cast<std::size_t>(mesh.GetNumberOfVertices()), NoId);
      this->VertexHubs[v] = this->NumberOfHubs++;
    }
  }
  this->NumberOfVertexHubs = this->NumberOfHubs;
}

void PropagationFaces::FindEdgeHubs(const SurfaceMesh& mesh)
{
  for (Id h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
  {
    if (!mesh.IsNonManifold(h) || this->Faces[SurfaceMesh::Face(h)].Behind[h % 3] <= FirstGate)
    {
      continue;
    }
    Id count = 0;
    ForEachHalfEdge(mesh, h, [&](Id) { ++count; });
    if (count <= FewFaces)
    {
      continue;
    }
    const Id code = FirstGate - this->NumberOfHubs++;
    ForEachHalfEdge(mesh, h, [&](Id t) { this->Faces[SurfaceMesh::Face(t)].Behind[t % 3] = code; });
  }
}
}
