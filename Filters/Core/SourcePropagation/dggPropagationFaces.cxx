// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggPropagationFaces.h"

namespace dgg
{
namespace
{
/// An edge of more faces is a hub: from each of its faces into all others it would be too many.
constexpr Id FewFaces = 6;
}

PropagationFaces::PropagationFaces(const SurfaceMesh& mesh)
  : Faces(static_cast<std::size_t>(mesh.GetNumberOfFaces()))
  , Unit(mesh.GetMeanEdgeLength() > 0.0 ? mesh.GetMeanEdgeLength() : 1.0)
{
  for (Id h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
  {
    PropagationFace& face = this->Faces[SurfaceMesh::Face(h)];
    const int k = h % 3;
    const double left = mesh.Length(SurfaceMesh::Previous(h));
    face.Lengths[k] = static_cast<float>(mesh.Length(h) / this->Unit);
    face.Cosines[k] = static_cast<float>(mesh.ApexX(h) / left);
    face.Sines[k] = static_cast<float>(mesh.ApexY(h) / left);
    face.Corners[k] = mesh.Origin(h);
    const Id twin = mesh.Twin(h);
    const bool isPlain =
      twin != NoId && mesh.Twin(twin) == h && mesh.Origin(twin) == mesh.Destination(h);
    face.Behind[k] = twin == NoId ? Nothing : isPlain ? twin : AskMesh;
    face.IsIrregular = (k > 0 && face.IsIrregular) || mesh.IsIrregular(mesh.Origin(h));
  }
  this->FindHubs(mesh);
}

void PropagationFaces::FindHubs(const SurfaceMesh& mesh)
{
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    if (mesh.IsIrregular(v))
    {
      this->VertexHubs.resize(static_cast<std::size_t>(mesh.GetNumberOfVertices()), NoId);
      this->VertexHubs[v] = this->NumberOfHubs++;
    }
  }
  this->NumberOfVertexHubs = this->NumberOfHubs;
  for (Id h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
  {
    if (!mesh.IsNonManifold(h) || this->Faces[SurfaceMesh::Face(h)].Behind[h % 3] <= FirstGate)
    {
      continue;
    }
    Id count = 1;
    for (Id t = mesh.Twin(h); t != h; t = mesh.Twin(t))
    {
      ++count;
    }
    if (count <= FewFaces)
    {
      continue;
    }
    const Id code = FirstGate - this->NumberOfHubs++;
    Id t = h;
    do
    {
      this->Faces[SurfaceMesh::Face(t)].Behind[t % 3] = code;
      t = mesh.Twin(t);
    } while (t != h);
  }
}
}
