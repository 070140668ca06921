// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggPropagationFaces.h"

namespace dgg
{
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
}
}
