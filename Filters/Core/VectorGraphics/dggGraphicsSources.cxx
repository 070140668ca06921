// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggGraphicsSources.h"
#include "dggGroups.h"
#include "dggProgressPart.h"

namespace dgg
{
LeftFaces::LeftFaces(const PathEdges& edges)
  : Edges(edges)
  , Surface(edges.GetSurface())
  , IsFound(Surface.Faces.size(), 0)
  , IsWall(Surface.Triangles.size(), 0)
{
}

Status LeftFaces::FindSides(const CurveChain& chain, ChainSides& sides) const
{
  for (std::size_t i = 0; i + 1 < chain.Vertices.size(); ++i)
  {
    const Id from = chain.Vertices[i];
    const std::vector<Id> halves = this->Edges.Find(from, chain.Vertices[i + 1]);
    const auto isOnLeft = [&](Id h) { return this->Surface.Triangles[h] == from; };
    if (halves.size() > 2 || (halves.size() == 2 && isOnLeft(halves[0]) == isOnLeft(halves[1])))
    {
      return InvalidInput("It has no sides where it passes along an edge of more than two faces, "
                          "or of two with opposite orientations")
        .Fix("Make the surface an oriented manifold, or move the curve");
    }
    for (const Id h : halves)
    {
      (isOnLeft(h) ? sides.Left : sides.Right).push_back(h);
    }
  }
  return Status::Success();
}

/// Collects all faces connected to the left of the curve without crossing it.
Status LeftFaces::Spread(const ChainSides& sides, std::vector<Id>& faces)
{
  const auto find = [&](Id h) {
    const Id f = SurfaceMesh::Face(h);
    if (!this->IsFound[f])
    {
      this->IsFound[f] = 1;
      faces.push_back(f);
    }
  };
  for (const Id h : sides.Left)
  {
    find(h);
  }
  std::size_t next = 0;
  while (next < faces.size())
  {
    const Id f = faces[next++];
    for (Id h = 3 * f; h < 3 * f + 3; ++h)
    {
      if (!this->IsWall[h])
      {
        ForEachTwin(this->Surface, h, find);
      }
    }
  }
  for (const Id h : sides.Right)
  {
    if (this->IsFound[SurfaceMesh::Face(h)])
    {
      return InvalidInput(
        "The left and the right side of the curve are connected, so it bounds no region")
        .Fix("Draw a closed curve without self-intersections");
    }
  }
  return Status::Success();
}

Status LeftFaces::Find(const CurveChain& chain, bool isClosed, std::vector<Id>& faces)
{
  faces.clear();
  if (!isClosed)
  {
    return InvalidInput("It is open, but a region needs a closed curve")
      .Fix("End the line with the id of its first point; a point at the same position is a "
           "different one");
  }
  ChainSides sides;
  DGG_RETURN_IF_ERROR(this->FindSides(chain, sides));
  const auto setWalls = [&](char value) {
    for (const std::vector<Id>* side : { &sides.Left, &sides.Right })
    {
      for (const Id h : *side)
      {
        this->IsWall[h] = value;
      }
    }
  };
  setWalls(1);
  Status status = this->Spread(sides, faces);
  setWalls(0);
  for (const Id f : faces)
  {
    this->IsFound[f] = 0;
  }
  if (!status.IsOk())
  {
    faces.clear();
  }
  return status;
}

RegionSources::RegionSources(const SurfaceMesh& mesh, const SubMesh& surface)
  : Mesh(mesh)
  , Surface(surface)
  , States(surface.Faces.size(), State::Outside)
{
}

double RegionSources::GetArea(Id face) const
{
  return 0.5 * this->Mesh.Length(3 * face) * this->Mesh.ApexY(3 * face);
}

/// Finds the faces of the region that are connected to a face through edges.
void RegionSources::FindPatch(Id face)
{
  this->Patch.assign(1, face);
  this->States[face] = State::Found;
  for (std::size_t i = 0; i < this->Patch.size(); ++i)
  {
    for (Id h = 3 * this->Patch[i]; h < 3 * this->Patch[i] + 3; ++h)
    {
      ForEachTwin(this->Surface, h, [&](Id e) {
        State& state = this->States[SurfaceMesh::Face(e)];
        if (state == State::Waiting)
        {
          state = State::Found;
          this->Patch.push_back(SurfaceMesh::Face(e));
        }
      });
    }
  }
}

/// Finds the edges of the patch with a face outside the region. If several faces of the patch share
/// such an edge, the smallest half-edge represents it.
void RegionSources::FindRim()
{
  this->Rim.clear();
  for (const Id f : this->Patch)
  {
    for (Id h = 3 * f; h < 3 * f + 3; ++h)
    {
      bool isRim = false;
      bool isFirst = true;
      ForEachTwin(this->Surface, h, [&](Id e) {
        const bool isInside = this->States[SurfaceMesh::Face(e)] != State::Outside;
        isRim = isRim || !isInside;
        isFirst = isFirst && (!isInside || h < e);
      });
      if (isRim && isFirst)
      {
        this->Rim.push_back(h);
      }
    }
  }
}

void RegionSources::AddPatch(
  const std::vector<double>& strength, std::vector<std::vector<double>>& loads) const
{
  double area = 0.0;
  for (const Id f : this->Patch)
  {
    area += this->GetArea(f);
  }
  double length = 0.0;
  for (const Id h : this->Rim)
  {
    length += this->Surface.Lengths[h];
  }
  for (const Id f : this->Patch)
  {
    const double part = area > 0.0 ? this->GetArea(f) / area : 0.0;
    for (std::size_t c = 0; c < loads.size(); ++c)
    {
      for (int k = 0; k < 3; ++k)
      {
        loads[c][this->Surface.Triangles[3 * f + k]] += 4.0 * Pi * strength[c] * part / 3.0;
      }
    }
  }
  for (const Id h : this->Rim)
  {
    const double part = length > 0.0 ? this->Surface.Lengths[h] / length
                                     : 1.0 / static_cast<double>(this->Rim.size());
    for (std::size_t c = 0; c < loads.size() && area > 0.0; ++c)
    {
      const double sink = 0.5 * 4.0 * Pi * strength[c] * part;
      loads[c][this->Surface.Triangles[h]] -= sink;
      loads[c][this->Surface.Triangles[SurfaceMesh::Next(h)]] -= sink;
    }
  }
}

void RegionSources::Add(const std::vector<Id>& faces, const std::vector<double>& strength,
  std::vector<std::vector<double>>& loads)
{
  for (const Id f : faces)
  {
    this->States[f] = State::Waiting;
  }
  for (const Id f : faces)
  {
    if (this->States[f] == State::Waiting)
    {
      this->FindPatch(f);
      this->FindRim();
      this->AddPatch(strength, loads);
    }
  }
  for (const Id f : faces)
  {
    this->States[f] = State::Outside;
  }
}

std::vector<ChainPart> SplitChain(const PathEdges& edges, const CurveChain& chain)
{
  std::vector<ChainPart> parts;
  for (std::size_t i = 0; i + 1 < chain.Vertices.size(); ++i)
  {
    const std::vector<Id> halves = edges.Find(chain.Vertices[i], chain.Vertices[i + 1]);
    for (const Id h : halves)
    {
      ChainPart part;
      part.Edge = i;
      part.HalfEdge = h;
      part.IsBackward = edges.GetSurface().Triangles[h] != chain.Vertices[i];
      part.Length = edges.GetSurface().Lengths[h] / static_cast<double>(halves.size());
      parts.push_back(part);
    }
  }
  return parts;
}

void AddLineSource(const SubMesh& surface, const CurveChain& chain,
  const std::vector<ChainPart>& parts, const GraphicsCurve& curve,
  std::vector<std::vector<double>>& loads)
{
  const auto channels = static_cast<int>(loads.size());
  std::vector<double> begin(loads.size());
  std::vector<double> end(loads.size());
  for (const ChainPart& part : parts)
  {
    const double* parameters = &chain.Parameters[part.Edge];
    InterpolateOnCurve(curve.Left, channels, curve.IsClosed, parameters[0], begin.data());
    InterpolateOnCurve(curve.Left, channels, curve.IsClosed, parameters[1], end.data());
    Id from = surface.Triangles[part.HalfEdge];
    Id to = surface.Triangles[SurfaceMesh::Next(part.HalfEdge)];
    if (part.IsBackward)
    {
      std::swap(from, to);
    }
    for (std::size_t c = 0; c < loads.size(); ++c)
    {
      loads[c][from] += part.Length / 6.0 * (2.0 * begin[c] + end[c]);
      loads[c][to] += part.Length / 6.0 * (begin[c] + 2.0 * end[c]);
    }
  }
}

Status GraphicsLoads::Prepare(const SubMesh& surface, Id numberOfFaces,
  const std::vector<CurveChain>& chains, const std::vector<GraphicsCurve>& curves,
  const GraphicsMemoryCheck& checkMemory, const ProgressCallback& progress)
{
  this->NumberOfFaces = numberOfFaces;
  this->ChainParts.assign(curves.size(), {});
  std::vector<std::vector<Id>> paths;
  for (std::size_t k = 0; k < curves.size(); ++k)
  {
    if (curves[k].Type == GraphicsCurveType::Source || curves[k].Type == GraphicsCurveType::Region)
    {
      paths.push_back(chains[k].Vertices);
    }
  }
  const PathEdges edges(surface, paths);
  for (std::size_t k = 0; k < curves.size(); ++k)
  {
    if (curves[k].Type == GraphicsCurveType::Source)
    {
      this->ChainParts[k] = SplitChain(edges, chains[k]);
    }
  }
  return this->FindRegions(edges, chains, curves, checkMemory, progress);
}

/// Finds the faces on the left of regions. For many regions, their total number may far exceed the
/// number of faces of the surface.
Status GraphicsLoads::FindRegions(const PathEdges& edges, const std::vector<CurveChain>& chains,
  const std::vector<GraphicsCurve>& curves, const GraphicsMemoryCheck& checkMemory,
  const ProgressCallback& progress)
{
  this->RegionFaces.assign(curves.size(), {});
  LeftFaces left(edges);
  const auto faces = static_cast<double>(edges.GetSurface().Faces.size());
  const auto count = static_cast<double>(curves.size());
  for (std::size_t k = 0; k < curves.size(); ++k)
  {
    if (curves[k].Type != GraphicsCurveType::Region)
    {
      continue;
    }
    const double bytes = this->GetMemorySize() + 2.0 * faces * sizeof(Id);
    DGG_RETURN_IF_ERROR(checkMemory ? checkMemory(bytes, bytes) : Status::Success());
    DGG_RETURN_IF_ERROR(
      left.Find(chains[k], curves[k].IsClosed, this->RegionFaces[k]).Of(NameOf(curves[k], k)));
    DGG_RETURN_IF_ERROR(ReportTo(progress, static_cast<double>(k + 1) / count));
  }
  return Status::Success();
}

double GraphicsLoads::GetMemorySize() const
{
  double faces = 0.0;
  for (const std::vector<Id>& region : this->RegionFaces)
  {
    faces += static_cast<double>(region.size());
  }
  return 2.0 * faces * sizeof(Id); // capacity of grown vectors
}

Status GraphicsLoads::Add(const GraphicsDomain& domain, const std::vector<CurveChain>& chains,
  const std::vector<GraphicsCurve>& curves, const std::vector<GraphicsRegion>& regions,
  const std::vector<std::vector<double>>& strengths, const ProgressCallback& progress,
  std::vector<std::vector<double>>& columns) const
{
  const SubMesh& surface = domain.Solved.Surface;
  Groups parts; // faces of the surface by face of the unrefined mesh
  if (!regions.empty())
  {
    parts = MakeGroups(surface.Faces, static_cast<std::size_t>(this->NumberOfFaces));
  }
  RegionSources adder(domain.SolvedMesh, surface);
  const auto count = static_cast<double>(curves.size() + regions.size());
  for (std::size_t k = 0; k < curves.size(); ++k)
  {
    if (curves[k].Type == GraphicsCurveType::Source)
    {
      AddLineSource(surface, chains[k], this->ChainParts[k], curves[k], columns);
    }
    if (curves[k].Type == GraphicsCurveType::Region)
    {
      adder.Add(this->RegionFaces[k], curves[k].Left, columns);
    }
    DGG_RETURN_IF_ERROR(ReportTo(progress, static_cast<double>(k + 1) / count));
  }
  std::vector<Id> faces;
  for (std::size_t r = 0; r < regions.size(); ++r)
  {
    faces.clear();
    for (const Id f : regions[r].Faces)
    {
      faces.insert(faces.end(), parts.Members.begin() + parts.Begins[f],
        parts.Members.begin() + parts.Begins[f + 1]);
    }
    adder.Add(faces, strengths[r], columns);
    DGG_RETURN_IF_ERROR(ReportTo(progress, static_cast<double>(curves.size() + r + 1) / count));
  }
  return Status::Success();
}
}
