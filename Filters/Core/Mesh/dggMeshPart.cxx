// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggMeshPart.h"

#include "dggEdges.h"

#include <algorithm>
#include <unordered_map>

namespace dgg
{
Status MeshPart::Build(const SurfaceMesh& whole)
{
  std::unordered_map<Id, Id> places; // local index per vertex
  std::vector<Id> triangles;
  std::vector<double> lengths;
  std::vector<Id> twins;
  this->Vertices.clear();
  const auto placeOf = [&](Id face) {
    const auto found = std::lower_bound(this->Faces.begin(), this->Faces.end(), face);
    return found != this->Faces.end() && *found == face
      ? static_cast<Id>(found - this->Faces.begin())
      : NoId;
  };
  for (const Id f : this->Faces)
  {
    for (Id h = 3 * f; h < 3 * f + 3; ++h)
    {
      const auto place = places.emplace(whole.Origin(h), static_cast<Id>(this->Vertices.size()));
      if (place.second)
      {
        this->Vertices.push_back(whole.Origin(h));
      }
      triangles.push_back(place.first->second);
      lengths.push_back(whole.Length(h));
      Id twin = NoId;
      ForEachTwin(whole, h, [&](Id e) {
        const Id face = twin == NoId ? placeOf(SurfaceMesh::Face(e)) : NoId;
        twin = face == NoId ? twin : 3 * face + e % 3;
      });
      twins.push_back(twin);
    }
  }
  return SurfaceMesh::FromGluedLengths(static_cast<Offset>(this->Vertices.size()), triangles.data(),
    static_cast<Offset>(this->Faces.size()), lengths.data(), twins.data(), this->Mesh,
    { &whole, this->Faces.data() });
}

std::vector<MeshPart> FindComponentParts(const SurfaceMesh& mesh)
{
  Id count = 0;
  const std::vector<Id> components = mesh.ComputeComponents(count);
  std::vector<MeshPart> parts(static_cast<std::size_t>(count));
  for (Id f = 0; f < mesh.GetNumberOfFaces(); ++f)
  {
    if (!mesh.IsDropped(f))
    {
      parts[components[mesh.Origin(3 * f)]].Faces.push_back(f);
    }
  }
  parts.erase(std::remove_if(parts.begin(), parts.end(),
                [](const MeshPart& part) { return part.Faces.empty(); }),
    parts.end());
  return parts;
}
}
