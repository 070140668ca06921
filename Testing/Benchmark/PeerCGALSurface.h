// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Mesh in CGAL's form, for the source files of the peers made from CGAL.
#ifndef PeerCGALSurface_h
#define PeerCGALSurface_h

#include "MeshArrays.h" // for MeshArrays

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <string> // for the reason of a refusal

using CGALKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CGALSurface = CGAL::Surface_mesh<CGALKernel::Point_3>;

inline CGALSurface::Vertex_index CGALVertex(dgg::Id id)
{
  return CGALSurface::Vertex_index(static_cast<CGALSurface::size_type>(id));
}

/// Fills `surface`. Returns the reason why CGAL cannot represent the mesh; empty if it can.
inline std::string BuildCGALSurface(const MeshArrays& mesh, CGALSurface& surface)
{
  for (std::size_t i = 0; i < mesh.Points.size(); i += 3)
  {
    surface.add_vertex(CGALKernel::Point_3(mesh.Points[i], mesh.Points[i + 1], mesh.Points[i + 2]));
  }
  for (std::size_t h = 0; h < mesh.Triangles.size(); h += 3)
  {
    const auto face = surface.add_face(CGALVertex(mesh.Triangles[h]),
      CGALVertex(mesh.Triangles[h + 1]), CGALVertex(mesh.Triangles[h + 2]));
    if (face == CGALSurface::null_face())
    {
      return "face " + std::to_string(h / 3) + " does not fit an oriented manifold";
    }
  }
  return {};
}

#endif
