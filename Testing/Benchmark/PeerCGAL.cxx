// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PeerCGAL.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>

#include <limits>

namespace
{
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
using Traits = CGAL::Surface_mesh_shortest_path_traits<Kernel, Surface>;
using ShortestPath = CGAL::Surface_mesh_shortest_path<Traits>;

Surface::Vertex_index VertexOf(dgg::Id id)
{
  return Surface::Vertex_index(static_cast<Surface::size_type>(id));
}
}

struct PeerCGAL::Solver
{
  Surface Mesh;
  std::vector<dgg::Id> Triangles;
  std::unique_ptr<ShortestPath> Algorithm;
};

PeerCGAL::PeerCGAL(const MeshArrays& mesh)
  : State(std::make_unique<Solver>())
{
  Surface& surface = this->State->Mesh;
  for (std::size_t i = 0; i < mesh.Points.size(); i += 3)
  {
    surface.add_vertex(Kernel::Point_3(mesh.Points[i], mesh.Points[i + 1], mesh.Points[i + 2]));
  }
  for (std::size_t h = 0; h < mesh.Triangles.size(); h += 3)
  {
    const auto face = surface.add_face(VertexOf(mesh.Triangles[h]), VertexOf(mesh.Triangles[h + 1]),
      VertexOf(mesh.Triangles[h + 2]));
    if (face == Surface::null_face())
    {
      this->Refusal = "face " + std::to_string(h / 3) + " does not fit an oriented manifold";
      return;
    }
  }
  this->State->Triangles = mesh.Triangles;
}

PeerCGAL::~PeerCGAL() = default;

void PeerCGAL::SetSourceVertex(dgg::Id vertex)
{
  this->State->Algorithm = std::make_unique<ShortestPath>(this->State->Mesh);
  this->State->Algorithm->add_source_point(VertexOf(vertex));
}

void PeerCGAL::SetSourceInFace(dgg::Id face, const std::array<double, 3>& barycentric)
{
  // CGAL counts the corners of a face from a half-edge of its own choice.
  const Surface& surface = this->State->Mesh;
  const Surface::Face_index cgalFace(static_cast<Surface::size_type>(face));
  auto half = surface.halfedge(cgalFace);
  Traits::Barycentric_coordinates coordinates{};
  for (int k = 0; k < 3; ++k, half = surface.next(half))
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      if (surface.source(half) == VertexOf(this->State->Triangles[3 * face + corner]))
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
  const Surface& surface = this->State->Mesh;
  std::vector<double> distances(
    surface.number_of_vertices(), std::numeric_limits<double>::infinity());
  this->State->Algorithm->build_sequence_tree();
  for (const auto v : surface.vertices())
  {
    if (!surface.is_isolated(v))
    {
      // Negative where there is no path.
      const double distance = this->State->Algorithm->shortest_distance_to_source_points(v).first;
      distances[v] = distance < 0.0 ? distances[v] : distance;
    }
  }
  return distances;
}
