// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggHomotopyBasis.h"

#include "dggDisjointSets.h"
#include "dggEdges.h"
#include "dggMinimumHeap.h"

#include <algorithm>
#include <string>

namespace dgg
{
namespace
{
/// Shortest paths along mesh edges.
struct EdgeTree
{
  std::vector<double> Distances;
  std::vector<Id> HalfEdges; ///< per vertex, the edge to its parent
  std::vector<Id> Parents;

  EdgeTree(const SurfaceMesh& mesh, Id base)
    : Distances(mesh.GetNumberOfVertices(), Infinity)
    , HalfEdges(mesh.GetNumberOfVertices(), NoId)
    , Parents(mesh.GetNumberOfVertices(), NoId)
  {
    MinimumHeap heap;
    this->Distances[base] = 0.0;
    heap.Push(0.0, base);
    while (!heap.IsEmpty())
    {
      const MinimumHeap::Entry top = heap.Pop();
      if (top.Key > this->Distances[top.Vertex])
      {
        continue;
      }
      for (const Id* g = mesh.FanBegin(top.Vertex); g != mesh.FanEnd(top.Vertex); ++g)
      {
        // Both edges of the face: on a boundary one of them is in no other face of the vertex.
        for (const Id h : { *g, SurfaceMesh::Previous(*g) })
        {
          const Id v = mesh.Origin(h) == top.Vertex ? mesh.Destination(h) : mesh.Origin(h);
          const double distance = top.Key + mesh.Length(h);
          if (distance < this->Distances[v])
          {
            this->Distances[v] = distance;
            this->HalfEdges[v] = h;
            this->Parents[v] = top.Vertex;
            heap.Push(distance, v);
          }
        }
      }
    }
  }
};

/// From the base to one end of an edge, over it, and back from the other end. What both ways have
/// in common is left out.
EdgeLoop MakeLoop(const SurfaceMesh& mesh, const EdgeTree& tree, Id h)
{
  std::vector<Id> ways[2];
  const Id ends[2] = { mesh.Origin(h), mesh.Destination(h) };
  for (int k = 0; k < 2; ++k)
  {
    for (Id v = ends[k]; v != NoId; v = tree.Parents[v])
    {
      ways[k].push_back(v);
    }
  }
  while (ways[0].size() > 1 && ways[1].size() > 1 &&
    ways[0][ways[0].size() - 2] == ways[1][ways[1].size() - 2])
  {
    ways[0].pop_back();
    ways[1].pop_back();
  }
  EdgeLoop loop;
  for (std::size_t i = ways[0].size(); i-- > 0;)
  {
    loop.Vertices.push_back(ways[0][i]);
    loop.HalfEdges.push_back(i > 0 ? tree.HalfEdges[ways[0][i - 1]] : h);
  }
  for (std::size_t i = 0; i + 1 < ways[1].size(); ++i)
  {
    loop.Vertices.push_back(ways[1][i]);
    loop.HalfEdges.push_back(tree.HalfEdges[ways[1][i]]);
  }
  for (const Id e : loop.HalfEdges)
  {
    loop.Length += mesh.Length(e);
  }
  return loop;
}

/// A tree of edges through all vertices, a tree of the edges between all faces, and the edges in
/// neither of them.
struct Decomposition
{
  EdgeTree Tree;
  std::vector<Id> Cotree;
  std::vector<Id> Rest; ///< those of the longest loops first

  Decomposition(const SurfaceMesh& mesh, Id base)
    : Tree(mesh, base)
  {
  }

  /// Fails when there is a non-manifold edge.
  Status Decompose(const SurfaceMesh& mesh);
  Status CollectEdges(const SurfaceMesh& mesh, std::vector<Id>& edges) const;
};

/// What lies outside of all boundaries counts as one more face.
Id Outside(const SurfaceMesh& mesh)
{
  return mesh.GetNumberOfFaces();
}

Id FaceBehind(const SurfaceMesh& mesh, Id h)
{
  const Id twin = mesh.Twin(h);
  return twin == NoId ? Outside(mesh) : SurfaceMesh::Face(twin);
}

Status CheckManifold(const SurfaceMesh& mesh, Id h)
{
  const Id twin = mesh.Twin(h);
  return twin == NoId || mesh.Twin(twin) == h
    ? Status::Success()
    : Status::Invalid("the edge between vertices " + std::to_string(mesh.Origin(h)) + " and " +
        std::to_string(mesh.Destination(h)) +
        " has more than two triangles: loops around handles need a manifold");
}

/// The edges of the component that are not in the tree.
Status Decomposition::CollectEdges(const SurfaceMesh& mesh, std::vector<Id>& edges) const
{
  std::vector<char> isInTree(mesh.GetNumberOfHalfEdges(), 0);
  for (const Id h : this->Tree.HalfEdges)
  {
    if (h != NoId)
    {
      isInTree[FindEdge(mesh, h)] = 1;
    }
  }
  for (Id h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
  {
    if (mesh.IsDropped(SurfaceMesh::Face(h)) || this->Tree.Distances[mesh.Origin(h)] == Infinity)
    {
      continue;
    }
    Status status = CheckManifold(mesh, h);
    if (!status.IsOk())
    {
      return status;
    }
    if (FindEdge(mesh, h) == h && !isInTree[h])
    {
      edges.push_back(h);
    }
  }
  return Status::Success();
}

Status Decomposition::Decompose(const SurfaceMesh& mesh)
{
  std::vector<Id> edges;
  Status status = this->CollectEdges(mesh, edges);
  // The longest loops first into the tree of faces, so that the shortest are left.
  const auto length = [&](Id h) {
    return this->Tree.Distances[mesh.Origin(h)] + this->Tree.Distances[mesh.Destination(h)] +
      mesh.Length(h);
  };
  std::stable_sort(edges.begin(), edges.end(), [&](Id a, Id b) { return length(a) > length(b); });
  DisjointSets faces(Outside(mesh) + 1);
  for (const Id h : edges)
  {
    const bool joins = faces.Join(SurfaceMesh::Face(h), FaceBehind(mesh, h));
    (joins ? this->Cotree : this->Rest).push_back(h);
  }
  return status;
}
}

/// A tree of edges takes one edge less than there are vertices, the trees of faces, one less than
/// there are faces in each of them. What is left of the edges is the number of loops.
Status FindBasesOfLoops(const SurfaceMesh& mesh, std::vector<Id>& bases)
{
  bases.clear();
  Id count = 0;
  const std::vector<Id> components = mesh.ComputeComponents(count);
  std::vector<Id> loops(count, 1);
  for (const Id component : components)
  {
    --loops[component];
  }
  // All boundaries of a component are around one face, but not those of several components.
  DisjointSets faces(Outside(mesh) + count);
  for (Id h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
  {
    const Id face = SurfaceMesh::Face(h);
    if (mesh.IsDropped(face) || FindEdge(mesh, h) != h)
    {
      continue;
    }
    Status status = CheckManifold(mesh, h);
    if (!status.IsOk())
    {
      return status;
    }
    const Id component = components[mesh.Origin(h)];
    const Id behind = FaceBehind(mesh, h);
    ++loops[component];
    if (faces.Join(face, behind == Outside(mesh) ? Outside(mesh) + component : behind))
    {
      --loops[component]; // an edge in a tree of faces
    }
  }
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    if (loops[components[v]] > 0)
    {
      bases.push_back(v);
      loops[components[v]] = 0;
    }
  }
  return Status::Success();
}

Status FindHomotopyBasis(const SurfaceMesh& mesh, Id base, std::vector<EdgeLoop>& loops)
{
  loops.clear();
  Decomposition parts(mesh, base);
  Status status = parts.Decompose(mesh);
  if (!status.IsOk())
  {
    return status;
  }
  for (auto h = parts.Rest.rbegin(); h != parts.Rest.rend(); ++h)
  {
    loops.push_back(MakeLoop(mesh, parts.Tree, *h));
  }
  return status;
}

/// Each edge in neither tree closes a cycle of faces. A loop crosses the cycles that it goes around
/// an odd number of times.
HomologySignatures::HomologySignatures(const SurfaceMesh& mesh, Id base)
  : Mesh(mesh)
{
  Decomposition parts(mesh, base);
  this->TheStatus = parts.Decompose(mesh);
  if (!this->TheStatus.IsOk())
  {
    return;
  }
  this->Dimension = parts.Rest.size();
  this->Cycles.resize(mesh.GetNumberOfHalfEdges());
  // Hang up each tree of faces by one of them.
  std::vector<std::vector<Id>> exits(Outside(mesh) + 1); // edges of the tree at each face
  for (const Id h : parts.Cotree)
  {
    exits[SurfaceMesh::Face(h)].push_back(h);
    exits[FaceBehind(mesh, h)].push_back(h);
  }
  std::vector<Id> up(Outside(mesh) + 1, NoId); // edge towards the root
  std::vector<Id> depth(Outside(mesh) + 1, NoId);
  const auto across = [&](Id face, Id h) {
    return SurfaceMesh::Face(h) == face ? FaceBehind(mesh, h) : SurfaceMesh::Face(h);
  };
  for (const Id h : parts.Rest)
  {
    std::vector<Id> open;
    if (depth[SurfaceMesh::Face(h)] == NoId) // there are several trees where sheets touch
    {
      open.push_back(SurfaceMesh::Face(h));
      depth[open.front()] = 0;
    }
    for (std::size_t next = 0; next < open.size(); ++next)
    {
      const Id face = open[next];
      for (const Id exit : exits[face])
      {
        const Id other = across(face, exit);
        if (depth[other] == NoId)
        {
          depth[other] = depth[face] + 1;
          up[other] = exit;
          open.push_back(other);
        }
      }
    }
  }
  for (std::size_t i = 0; i < parts.Rest.size(); ++i)
  {
    const auto cycle = static_cast<Id>(i);
    const Id h = parts.Rest[i];
    this->Cycles[h].push_back(cycle);
    Id a = SurfaceMesh::Face(h);
    Id b = FaceBehind(mesh, h);
    while (a != b)
    {
      Id& deeper = depth[a] >= depth[b] ? a : b;
      this->Cycles[up[deeper]].push_back(cycle);
      deeper = across(deeper, up[deeper]);
    }
  }
}

std::vector<char> HomologySignatures::GetSignature(const EdgeLoop& loop) const
{
  std::vector<char> signature(this->Dimension, 0);
  for (const Id h : loop.HalfEdges)
  {
    for (const Id cycle : this->Cycles[FindEdge(this->Mesh, h)])
    {
      signature[cycle] ^= 1;
    }
  }
  return signature;
}
}
