// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PeerCGAL.h"

#include "PeerCGALSurface.h"

#include <CGAL/Surface_mesh_shortest_path.h>

#include <limits>

namespace
{
using Traits = CGAL::Surface_mesh_shortest_path_traits<CGALKernel, CGALSurface>;
using ShortestPath = CGAL::Surface_mesh_shortest_path<Traits>;
}

struct PeerCGAL::Solver
{
  CGALSurface Mesh;
  std::vector<dgg::Id> Triangles;
  std::unique_ptr<ShortestPath> Algorithm;
};

PeerCGAL::PeerCGAL(const MeshArrays& mesh)
  : State(std::make_unique<Solver>())
{
  this->Refusal = BuildCGALSurface(mesh, this->State->Mesh);
  this->State->Triangles = mesh.Triangles;
}

PeerCGAL::~PeerCGAL() = default;

void PeerCGAL::SetSourceVertex(dgg::Id vertex)
{
  this->State->Algorithm = std::make_unique<ShortestPath>(this->State->Mesh);
  this->State->Algorithm->add_source_point(CGALVertex(vertex));
}

void PeerCGAL::SetSourceInFace(dgg::Id face, const std::array<double, 3>& barycentric)
{
  // CGAL counts the corners of a face from an arbitrary half-edge.
  const CGALSurface& surface = this->State->Mesh;
  const CGALSurface::Face_index cgalFace(static_cast<CGALSurface::size_type>(face));
  auto half = surface.halfedge(cgalFace);
  Traits::Barycentric_coordinates coordinates{};
  for (int k = 0; k < 3; ++k, half = surface.next(half))
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      if (surface.source(half) == CGALVertex(this->State->Triangles[3 * face + corner]))
      {
        coordinates[k] = barycentric[corner];
      }
    }
  }
  this->State->Algorithm = std::make_unique<ShortestPath>(surface);
  this->State->Algorithm->add_source_point(cgalFace, coordinates);
}

std::vector<double> PeerCGAL::ComputeDistances()
{
  const CGALSurface& surface = this->State->Mesh;
  std::vector<double> distances(
    surface.number_of_vertices(), std::numeric_limits<double>::infinity());
  this->State->Algorithm->build_sequence_tree();
  for (const auto v : surface.vertices())
  {
    if (!surface.is_isolated(v))
    {
      // Negative if there is no path.
      const double distance = this->State->Algorithm->shortest_distance_to_source_points(v).first;
      distances[v] = distance < 0.0 ? distances[v] : distance;
    }
  }
  return distances;
}
