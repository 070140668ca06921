// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggGraphicsLoads.h"

#include <algorithm>
#include <numeric>
#include <string>

namespace dgg
{
/// The parts of the faces of the mesh that was refined.
class FaceParts
{
public:
  FaceParts(const RefinedSurface& surface, Id numberOfFaces)
    : Begins(static_cast<std::size_t>(numberOfFaces) + 1, 0)
    , Parts(numberOfFaces > 0 ? surface.Faces.size() : 0)
  {
    if (numberOfFaces == 0)
    {
      return;
    }
    for (const Id f : surface.Faces)
    {
      ++this->Begins[f];
    }
    std::partial_sum(this->Begins.begin(), this->Begins.end(), this->Begins.begin());
    for (auto part = static_cast<Id>(surface.Faces.size()); part-- > 0;)
    {
      this->Parts[--this->Begins[surface.Faces[part]]] = part;
    }
  }
  Id Count(Id face) const { return this->Begins[face + 1] - this->Begins[face]; }
  void Append(Id face, std::vector<Id>& parts) const
  {
    parts.insert(parts.end(), this->Parts.begin() + this->Begins[face],
      this->Parts.begin() + this->Begins[face + 1]);
  }

private:
  std::vector<Id> Begins; // per face; one more at the end
  std::vector<Id> Parts;
};

Status GraphicsLoads::Prepare(const RefinedSurface& surface, Id numberOfFaces,
  const std::vector<CurveChain>& chains, const std::vector<GraphicsCurve>& curves,
  const GraphicsMemoryCheck& checkMemory, const ProgressCallback& progress)
{
  this->NumberOfFaces = numberOfFaces;
  this->ChainParts.assign(curves.size(), {});
  std::vector<char> isMeant;
  isMeant.reserve(curves.size());
  for (const GraphicsCurve& curve : curves)
  {
    isMeant.push_back(
      curve.Type == GraphicsCurveType::Source || curve.Type == GraphicsCurveType::Region);
  }
  const ChainEdges edges(surface, chains, isMeant);
  for (std::size_t k = 0; k < curves.size(); ++k)
  {
    if (curves[k].Type == GraphicsCurveType::Source)
    {
      this->ChainParts[k] = SplitChain(edges, chains[k]);
    }
  }
  return this->FindRegions(edges, chains, curves, checkMemory, progress);
}

/// The faces on the left of regions; of many regions they may be many more than the surface has.
Status GraphicsLoads::FindRegions(const ChainEdges& edges, const std::vector<CurveChain>& chains,
  const std::vector<GraphicsCurve>& curves, const GraphicsMemoryCheck& checkMemory,
  const ProgressCallback& progress)
{
  const RefinedSurface& surface = edges.GetSurface();
  this->RegionFaces.assign(curves.size(), {});
  LeftFaces left(edges);
  const auto faces = static_cast<double>(surface.Faces.size());
  const auto regions = static_cast<double>(std::count_if(curves.begin(), curves.end(),
    [](const GraphicsCurve& curve) { return curve.Type == GraphicsCurveType::Region; }));
  WorkProgress work(progress, regions * faces);
  this->NumberOfRegionFaces = 0.0;
  for (std::size_t k = 0; k < curves.size(); ++k)
  {
    if (curves[k].Type != GraphicsCurveType::Region)
    {
      continue;
    }
    const double bytes = (this->NumberOfRegionFaces + faces) * sizeof(Id);
    Status status = checkMemory ? checkMemory(bytes, bytes) : Status::Success();
    if (!status.IsOk())
    {
      return status;
    }
    status = left.Find(chains[k], curves[k].IsClosed, work, this->RegionFaces[k]);
    if (!status.IsOk())
    {
      return status.IsAborted()
        ? status
        : Status::Invalid(NameOf(curves[k], k) + ": " + status.GetMessage());
    }
    this->NumberOfRegionFaces += static_cast<double>(this->RegionFaces[k].size());
  }
  return Status::Success();
}

Status GraphicsLoads::Add(const GraphicsDomain& domain, const std::vector<CurveChain>& chains,
  const std::vector<GraphicsCurve>& curves, const std::vector<GraphicsRegion>& regions,
  const ChannelScale& scale, const ProgressCallback& progress,
  std::vector<std::vector<double>>& columns) const
{
  const CutSurface& surface = domain.Solved.Surface;
  const FaceParts parts(surface, regions.empty() ? 0 : this->NumberOfFaces);
  WorkProgress work(progress, this->CountWork(regions, parts));
  RegionSources adder(domain.SolvedMesh, surface);
  Status status;
  for (std::size_t k = 0; k < curves.size() && status.IsOk(); ++k)
  {
    if (curves[k].Type == GraphicsCurveType::Source)
    {
      AddLineSource(surface, chains[k], this->ChainParts[k], curves[k], columns);
    }
    if (curves[k].Type == GraphicsCurveType::Region)
    {
      status = adder.Add(this->RegionFaces[k], curves[k].Left, work, columns);
    }
  }
  for (std::size_t r = 0; r < regions.size() && status.IsOk(); ++r)
  {
    std::vector<Id> faces;
    for (const Id f : regions[r].Faces)
    {
      parts.Append(f, faces);
    }
    status = adder.Add(faces, scale.Apply(regions[r].Strength), work, columns);
  }
  return status;
}

/// What sources of regions take, as WorkProgress is told.
double GraphicsLoads::CountWork(
  const std::vector<GraphicsRegion>& regions, const FaceParts& parts) const
{
  double faces = this->NumberOfRegionFaces;
  for (const GraphicsRegion& region : regions)
  {
    for (const Id f : region.Faces)
    {
      faces += parts.Count(f);
    }
  }
  return RegionSources::WorkPerFace * faces;
}
}
