// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Triangle mesh as flat arrays, identical input of the kernel and the peers.
#ifndef MeshArrays_h
#define MeshArrays_h

#include "dggTypes.h" // for Id

#include <cstddef> // for std::size_t
#include <vector>  // for the arrays

struct MeshArrays
{
  std::vector<double> Points;     ///< x y z per vertex
  std::vector<dgg::Id> Triangles; ///< three vertex ids per face

  std::size_t GetNumberOfVertices() const { return this->Points.size() / 3; }
  std::size_t GetNumberOfFaces() const { return this->Triangles.size() / 3; }
};

#endif
