// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggHomotopyBasis.h"

#include "dggDisjointSets.h"
#include "dggEdges.h"
#include "dggHeap.h"

#include <algorithm>

namespace dgg
{
namespace
{
/// Returns the index of each element within its group; NoId for elements without a group.
std::vector<Id> NumberMembers(const Groups& groups, Id numberOfElements)
{
  std::vector<Id> numbers(numberOfElements, NoId);
  for (std::size_t g = 0; g + 1 < groups.Begins.size(); ++g)
  {
    for (Offset i = groups.Begins[g]; i < groups.Begins[g + 1]; ++i)
    {
      numbers[groups.Members[i]] = static_cast<Id>(i - groups.Begins[g]);
    }
  }
  return numbers;
}

/// Shortest paths along mesh edges, in the component of the base.
struct EdgeTree
{
  const SurfaceComponents& Components;
  const Id Component;
  std::vector<double> Distances; ///< per vertex of the component, like all arrays
  std::vector<Id> HalfEdges;     ///< the edge to its parent
  std::vector<Id> Parents;

  EdgeTree(const SurfaceComponents& components, Id base)
    : Components(components)
    , Component(components.GetComponent(base))
    , Distances(components.GetNumberOfVertices(Component), Infinity)
    , HalfEdges(components.GetNumberOfVertices(Component), NoId)
    , Parents(components.GetNumberOfVertices(Component), NoId)
  {
    const SurfaceMesh& mesh = components.GetMesh();
    MinimumHeap heap;
    this->Distances[this->Number(base)] = 0.0;
    heap.Push(0.0, base);
    while (!heap.IsEmpty())
    {
      const MinimumHeap::Entry top = heap.Pop();
      if (top.Key > this->DistanceOf(top.Index))
      {
        continue;
      }
      for (const Id* g = mesh.FanBegin(top.Index); g != mesh.FanEnd(top.Index); ++g)
      {
        // Both edges of the face are used, because a boundary edge belongs to no other face of the
        // vertex.
        for (const Id h : { *g, SurfaceMesh::Previous(*g) })
        {
          const Id v = mesh.Origin(h) == top.Index ? mesh.Destination(h) : mesh.Origin(h);
          const double distance = top.Key + mesh.Length(h);
          const Id number = this->Number(v);
          if (distance < this->Distances[number])
          {
            this->Distances[number] = distance;
            this->HalfEdges[number] = h;
            this->Parents[number] = top.Index;
            heap.Push(distance, v);
          }
        }
      }
    }
  }

  Id Number(Id v) const { return this->Components.NumberOfVertex(v); }
  double DistanceOf(Id v) const { return this->Distances[this->Number(v)]; }
  Id HalfEdgeOf(Id v) const { return this->HalfEdges[this->Number(v)]; }
  Id ParentOf(Id v) const { return this->Parents[this->Number(v)]; }
};

/// Returns the loop from the base to one end of an edge, over the edge, and back from its other
/// end. The common part of both paths is removed.
EdgeLoop MakeLoop(const SurfaceMesh& mesh, const EdgeTree& tree, Id h)
{
  std::vector<Id> ways[2];
  const Id ends[2] = { mesh.Origin(h), mesh.Destination(h) };
  for (int k = 0; k < 2; ++k)
  {
    for (Id v = ends[k]; v != NoId; v = tree.ParentOf(v))
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
    loop.HalfEdges.push_back(i > 0 ? tree.HalfEdgeOf(ways[0][i - 1]) : h);
  }
  for (std::size_t i = 0; i + 1 < ways[1].size(); ++i)
  {
    loop.Vertices.push_back(ways[1][i]);
    loop.HalfEdges.push_back(tree.HalfEdgeOf(ways[1][i]));
  }
  for (const Id e : loop.HalfEdges)
  {
    loop.Length += mesh.Length(e);
  }
  return loop;
}

/// Tree-cotree decomposition of a component: a tree of edges through all vertices, a tree of dual
/// edges between all faces, and the remaining edges.
struct Decomposition
{
  const SurfaceComponents& Components;
  const SurfaceMesh& Mesh;
  EdgeTree Tree;
  std::vector<Id> Cotree;
  std::vector<Id> Rest; ///< remaining edges, those of the longest loops first

  Decomposition(const SurfaceComponents& components, Id base)
    : Components(components)
    , Mesh(components.GetMesh())
    , Tree(components, base)
  {
  }

  /// Fails if there is a non-manifold edge.
  Status Decompose();

  /// Returns the local index of the exterior of all boundaries, which counts as one additional
  /// face.
  Id Outside() const { return this->Components.GetNumberOfFaces(this->Tree.Component); }
  /// Returns the local index of the face on one side of an edge.
  Id FaceOf(Id h) const { return this->Components.NumberOfFace(SurfaceMesh::Face(h)); }
  Id FaceBehind(Id h) const
  {
    const Id twin = this->Mesh.Twin(h);
    return twin == NoId ? this->Outside() : this->FaceOf(twin);
  }

private:
  Status CollectEdges(std::vector<Id>& edges) const;
};

Status CheckManifold(const SurfaceMesh& mesh, Id h)
{
  const Id twin = mesh.Twin(h);
  return twin == NoId || mesh.Twin(twin) == h
    ? Status::Success()
    : InvalidInput("The edge between vertices ", mesh.Origin(h), " and ", mesh.Destination(h),
        " has more than two triangles")
        .Fix("Make the surface a manifold: loops around handles exist on manifolds only");
}

/// Collects the edges of the component that are not in the tree.
Status Decomposition::CollectEdges(std::vector<Id>& edges) const
{
  const SurfaceMesh& mesh = this->Mesh;
  std::vector<char> isInTree(3 * static_cast<std::size_t>(this->Outside()), 0);
  for (const Id h : this->Tree.HalfEdges)
  {
    if (h != NoId)
    {
      isInTree[this->Components.NumberOfHalfEdge(FindEdge(mesh, h))] = 1;
    }
  }
  for (Id face = 0; face < this->Outside(); ++face)
  {
    const Id f = this->Components.GetFace(this->Tree.Component, face);
    for (Id h = 3 * f; h < 3 * f + 3; ++h)
    {
      DGG_RETURN_IF_ERROR(CheckManifold(mesh, h));
      if (FindEdge(mesh, h) == h && !isInTree[this->Components.NumberOfHalfEdge(h)])
      {
        edges.push_back(h);
      }
    }
  }
  return Status::Success();
}

Status Decomposition::Decompose()
{
  std::vector<Id> edges;
  Status status = this->CollectEdges(edges);
  // Edges with the longest loops enter the dual tree first, so that edges with the shortest loops
  // remain.
  const auto length = [&](Id h) {
    return this->Tree.DistanceOf(this->Mesh.Origin(h)) +
      this->Tree.DistanceOf(this->Mesh.Destination(h)) + this->Mesh.Length(h);
  };
  std::stable_sort(edges.begin(), edges.end(), [&](Id a, Id b) { return length(a) > length(b); });
  DisjointSets faces(this->Outside() + 1);
  for (const Id h : edges)
  {
    const bool joins = faces.Join(this->FaceOf(h), this->FaceBehind(h));
    (joins ? this->Cotree : this->Rest).push_back(h);
  }
  return status;
}
}

SurfaceComponents::SurfaceComponents(const SurfaceMesh& mesh)
  : Mesh(mesh)
{
  Id count = 0;
  this->Components = mesh.ComputeComponents(count);
  this->Vertices = MakeGroups(this->Components, count);
  this->Faces = MakeGroups(mesh.GetNumberOfFaces(), count,
    [&](Id f) { return mesh.IsDropped(f) ? NoId : this->Components[mesh.Origin(3 * f)]; });
  this->VertexNumbers = NumberMembers(this->Vertices, mesh.GetNumberOfVertices());
  this->FaceNumbers = NumberMembers(this->Faces, mesh.GetNumberOfFaces());
}

/// Finds the bases from the number of loops of each component. A tree of edges has one edge less
/// than the number of vertices; each dual tree has one edge less than its number of faces. The
/// number of remaining edges is the number of loops.
Status FindBasesOfLoops(const SurfaceComponents& components, std::vector<Id>& bases)
{
  bases.clear();
  const SurfaceMesh& mesh = components.GetMesh();
  const Id count = components.GetCount();
  std::vector<Id> loops(count);
  for (Id c = 0; c < count; ++c)
  {
    loops[c] = 1 - components.GetNumberOfVertices(c);
  }
  // All boundaries of a component share one exterior face, but components have separate ones.
  const Id outside = mesh.GetNumberOfFaces();
  DisjointSets faces(outside + count);
  for (Id h = 0; h < mesh.GetNumberOfHalfEdges(); ++h)
  {
    const Id face = SurfaceMesh::Face(h);
    if (mesh.IsDropped(face) || FindEdge(mesh, h) != h)
    {
      continue;
    }
    DGG_RETURN_IF_ERROR(CheckManifold(mesh, h));
    const Id component = components.GetComponent(mesh.Origin(h));
    const Id twin = mesh.Twin(h);
    ++loops[component];
    if (faces.Join(face, twin == NoId ? outside + component : SurfaceMesh::Face(twin)))
    {
      --loops[component]; // an edge of a dual tree
    }
  }
  for (Id v = 0; v < mesh.GetNumberOfVertices(); ++v)
  {
    Id& left = loops[components.GetComponent(v)];
    if (left > 0)
    {
      bases.push_back(v);
      left = 0;
    }
  }
  return Status::Success();
}

Status FindHomotopyBasis(const SurfaceComponents& components, Id base, std::vector<EdgeLoop>& loops)
{
  loops.clear();
  Decomposition parts(components, base);
  DGG_RETURN_IF_ERROR(parts.Decompose());
  for (auto h = parts.Rest.rbegin(); h != parts.Rest.rend(); ++h)
  {
    loops.push_back(MakeLoop(parts.Mesh, parts.Tree, *h));
  }
  return Status::Success();
}

/// Collects the dual cycles. Each edge in neither tree closes a cycle of faces (a dual cycle). The
/// signature of a loop lists the dual cycles that the loop crosses an odd number of times.
HomologySignatures::HomologySignatures(const SurfaceComponents& components, Id base)
  : Components(components)
{
  Decomposition parts(components, base);
  this->TheStatus = parts.Decompose();
  if (!this->TheStatus.IsOk())
  {
    return;
  }
  this->Dimension = parts.Rest.size();
  this->Cycles.resize(3 * static_cast<std::size_t>(parts.Outside()));
  // Root each dual tree at one of its faces.
  std::vector<std::vector<Id>> exits(parts.Outside() + 1); // dual tree edges at each face
  for (const Id h : parts.Cotree)
  {
    exits[parts.FaceOf(h)].push_back(h);
    exits[parts.FaceBehind(h)].push_back(h);
  }
  std::vector<Id> up(parts.Outside() + 1, NoId); // edge towards the root
  std::vector<Id> depth(parts.Outside() + 1, NoId);
  const auto across = [&](Id face, Id h) {
    return parts.FaceOf(h) == face ? parts.FaceBehind(h) : parts.FaceOf(h);
  };
  for (const Id h : parts.Rest)
  {
    std::vector<Id> open;
    if (depth[parts.FaceOf(h)] == NoId) // several trees if parts only touch in vertices
    {
      open.push_back(parts.FaceOf(h));
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
    this->Cycles[components.NumberOfHalfEdge(h)].push_back(cycle);
    Id a = parts.FaceOf(h);
    Id b = parts.FaceBehind(h);
    while (a != b)
    {
      Id& deeper = depth[a] >= depth[b] ? a : b;
      this->Cycles[components.NumberOfHalfEdge(up[deeper])].push_back(cycle);
      deeper = across(deeper, up[deeper]);
    }
  }
}

std::vector<std::uint64_t> HomologySignatures::GetSignature(const EdgeLoop& loop) const
{
  std::vector<std::uint64_t> signature((this->Dimension + 63) / 64, 0);
  for (const Id h : loop.HalfEdges)
  {
    const Id edge = FindEdge(this->Components.GetMesh(), h);
    for (const Id cycle : this->Cycles[this->Components.NumberOfHalfEdge(edge)])
    {
      signature[cycle / 64] ^= std::uint64_t(1) << (cycle % 64);
    }
  }
  return signature;
}
}
