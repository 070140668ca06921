// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggSurfaceComponents.h"

#include <numeric>

namespace dgg
{
SurfaceComponents::SurfaceComponents(const SurfaceMesh& mesh)
  : Mesh(mesh)
  , VertexNumbers(mesh.GetNumberOfVertices())
  , FaceNumbers(mesh.GetNumberOfFaces(), NoId)
{
  Id count = 0;
  this->Components = mesh.ComputeComponents(count);
  this->FirstVertices.assign(count + 1, 0);
  this->FirstFaces.assign(count + 1, 0);
  // Counts per component, shifted by one, then their prefix sums.
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    this->VertexNumbers[v] = this->FirstVertices[this->Components[v] + 1]++;
  }
  for (Id f = 0; f < mesh.GetNumberOfFaces(); ++f)
  {
    if (!mesh.IsDropped(f))
    {
      this->FaceNumbers[f] = this->FirstFaces[this->Components[mesh.Origin(3 * f)] + 1]++;
    }
  }
  std::partial_sum(
    this->FirstVertices.begin(), this->FirstVertices.end(), this->FirstVertices.begin());
  std::partial_sum(this->FirstFaces.begin(), this->FirstFaces.end(), this->FirstFaces.begin());
  this->Faces.resize(this->FirstFaces.back());
  for (Id f = 0; f < mesh.GetNumberOfFaces(); ++f)
  {
    if (!mesh.IsDropped(f))
    {
      this->Faces[this->FirstFaces[this->Components[mesh.Origin(3 * f)]] + this->FaceNumbers[f]] =
        f;
    }
  }
}
}
