// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PeerBoost.h"

#include <boost/graph/use_mpi.hpp>

#include <boost/graph/distributed/adjacency_list.hpp>
#include <boost/graph/distributed/delta_stepping_shortest_paths.hpp>
#include <boost/graph/distributed/mpi_process_group.hpp>
#include <boost/mpi/collectives.hpp>
#include <boost/serialization/vector.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

namespace
{
using ProcessGroup = boost::graph::distributed::mpi_process_group;
using Graph = boost::adjacency_list<boost::vecS, boost::distributedS<ProcessGroup, boost::vecS>,
  boost::directedS, boost::no_property, boost::property<boost::edge_weight_t, double>>;
using Vertex = boost::graph_traits<Graph>::vertex_descriptor;
}

struct PeerBoost::Implementation
{
  /// Returns the vertex of a global id.
  Vertex Find(dgg::Offset id, int owner) const
  {
    const std::vector<dgg::Offset>& ids = this->Ids[owner];
    const auto place = std::lower_bound(ids.begin(), ids.end(), id) - ids.begin();
    return Vertex(owner, static_cast<std::size_t>(place));
  }

  ProcessGroup Group;
  Graph Edges{ Group };
  std::vector<std::vector<dgg::Offset>> Ids; // of the vertices of each process, ascending
  std::vector<Vertex> Vertices;              // per vertex of the rows
  std::vector<double> Distances;             // per vertex of this process, in the order of its ids
  double MeanLength = 0.0;                   // of edges of all processes
};

PeerBoost::PeerBoost(
  const dgg::GraphView& rows, const std::vector<dgg::Offset>& ids, const dgg::GhostVertices& ghosts)
  : Internals(new Implementation)
{
  Implementation& internals = *this->Internals;
  const int here = process_id(internals.Group);
  std::vector<dgg::Offset> own;
  for (dgg::Id v = 0; v < rows.NumberOfVertices; ++v)
  {
    if (ghosts.Owners[v] == dgg::GhostVertices::Here)
    {
      own.push_back(ids[v]);
      add_vertex(internals.Edges);
    }
  }
  std::sort(own.begin(), own.end());
  boost::mpi::all_gather(communicator(internals.Group), own, internals.Ids);
  for (dgg::Id v = 0; v < rows.NumberOfVertices; ++v)
  {
    const dgg::Id owner = ghosts.Owners[v];
    internals.Vertices.push_back(
      internals.Find(ids[v], owner == dgg::GhostVertices::Here ? here : owner));
  }
  double length = 0.0;
  for (dgg::Id v = 0; v < rows.NumberOfVertices; ++v)
  {
    for (dgg::Offset e = rows.Offsets[v];
         e < rows.Offsets[v + 1] && internals.Vertices[v].owner == here; ++e)
    {
      length += rows.Length(e);
      add_edge(internals.Vertices[v], internals.Vertices[rows.Targets[e]],
        boost::property<boost::edge_weight_t, double>(rows.Length(e)), internals.Edges);
    }
  }
  synchronize(internals.Edges);
  const auto all = boost::mpi::all_reduce(
    communicator(internals.Group), static_cast<double>(num_edges(internals.Edges)), std::plus<>());
  internals.MeanLength =
    boost::mpi::all_reduce(communicator(internals.Group), length, std::plus<>()) / all;
}

PeerBoost::~PeerBoost() = default;

void PeerBoost::Run(dgg::Offset source, double width)
{
  Implementation& internals = *this->Internals;
  int owner = 0;
  while (!std::binary_search(internals.Ids[owner].begin(), internals.Ids[owner].end(), source))
  {
    ++owner;
  }
  internals.Distances.assign(num_vertices(internals.Edges), dgg::Infinity);
  boost::graph::distributed::delta_stepping_shortest_paths(internals.Edges,
    internals.Find(source, owner), boost::dummy_property_map(),
    make_iterator_property_map(
      internals.Distances.begin(), get(boost::vertex_index, internals.Edges)),
    get(boost::edge_weight, internals.Edges), width * internals.MeanLength);
}

std::vector<double> PeerBoost::GetDistances() const
{
  const int here = process_id(this->Internals->Group);
  std::vector<double> distances;
  for (const Vertex& vertex : this->Internals->Vertices)
  {
    distances.push_back(
      vertex.owner == here ? this->Internals->Distances[vertex.local] : std::nan(""));
  }
  return distances;
}
