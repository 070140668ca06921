// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PeerHeat.h"

#include "PeerCGALSurface.h"

#include <CGAL/Heat_method_3/Surface_mesh_geodesic_distances_3.h>

#include <exception>

namespace
{
namespace heat = CGAL::Heat_method_3;
using DistanceMap = CGALSurface::Property_map<CGALSurface::Vertex_index, double>;

/// Common interface of both instances of CGAL's class template.
class Solver
{
public:
  virtual ~Solver() = default;
  virtual void Run(CGALSurface::Vertex_index source, DistanceMap distances) = 0;
};

template <class Mode>
class SolverOf : public Solver
{
public:
  /// CGAL factorizes in the constructor.
  explicit SolverOf(const CGALSurface& mesh)
    : Method(mesh)
  {
  }
  void Run(CGALSurface::Vertex_index source, DistanceMap distances) override
  {
    this->Method.clear_sources();
    this->Method.add_source(source);
    this->Method.estimate_geodesic_distances(distances);
  }

private:
  heat::Surface_mesh_geodesic_distances_3<CGALSurface, Mode> Method;
};
}

struct PeerHeat::Implementation
{
  CGALSurface Mesh;
  DistanceMap Distances;
  std::unique_ptr<Solver> Method;
};

PeerHeat::PeerHeat(const MeshArrays& mesh, Triangulation triangulation)
  : Mode(triangulation)
  , Internals(std::make_unique<Implementation>())
{
  this->Refusal = BuildCGALSurface(mesh, this->Internals->Mesh);
  this->Internals->Distances =
    this->Internals->Mesh.add_property_map<CGALSurface::Vertex_index, double>("v:distance", 0.0)
      .first;
}

PeerHeat::~PeerHeat() = default;

void PeerHeat::Clear()
{
  this->Internals->Method.reset();
}

/// Runs `work` and handles the exception that CGAL throws if a factorization fails.
template <class Work>
void PeerHeat::Try(Work&& work)
{
  if (!this->Refusal.empty())
  {
    return;
  }
  try
  {
    work();
  }
  catch (const std::exception& error)
  {
    this->Refusal = error.what();
  }
}

void PeerHeat::Precompute()
{
  this->Try([this] {
    Implementation& inside = *this->Internals;
    if (this->Mode == Triangulation::Direct)
    {
      inside.Method = std::make_unique<SolverOf<heat::Direct>>(inside.Mesh);
    }
    else
    {
      inside.Method = std::make_unique<SolverOf<heat::Intrinsic_Delaunay>>(inside.Mesh);
    }
  });
}

void PeerHeat::Run(dgg::Id source)
{
  if (!this->Internals->Method)
  {
    this->Precompute();
  }
  this->Try([this, source] {
    this->Internals->Method->Run(CGALVertex(source), this->Internals->Distances);
  });
}

std::vector<double> PeerHeat::GetDistances() const
{
  const CGALSurface& mesh = this->Internals->Mesh;
  std::vector<double> distances;
  distances.reserve(mesh.number_of_vertices());
  for (const auto v : mesh.vertices())
  {
    distances.push_back(this->Internals->Distances[v]);
  }
  return distances;
}
