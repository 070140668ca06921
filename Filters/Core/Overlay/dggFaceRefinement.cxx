// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggFaceRefinement.h"

#include "dggEdgeSplitting.h"
#include "dggStatus.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace dgg
{
namespace
{
/// Splits the chosen faces level by level.
class LevelRefiner
{
public:
  LevelRefiner(const SurfaceMesh& mesh, SubMesh& surface, std::vector<Id>& parents)
    : Mesh(mesh)
    , Surface(surface)
    , Parents(parents)
    , IsChosen(surface.Faces.size(), 0)
  {
    this->Parents.resize(surface.Faces.size());
    std::iota(this->Parents.begin(), this->Parents.end(), 0);
  }

  Status Choose(const std::vector<Id>& faces);
  Status SplitOnce(int rings, Offset mostFaces);

private:
  std::vector<char> Grow(int rings) const;

  const SurfaceMesh& Mesh;
  SubMesh& Surface;
  std::vector<Id>& Parents;
  std::vector<char> IsChosen; // per face
};

Status LevelRefiner::Choose(const std::vector<Id>& faces)
{
  for (const Id face : faces)
  {
    if (face < 0 || face >= this->Surface.GetNumberOfFaces())
    {
      return InvalidInput("Face ", face, " does not exist")
        .Fix("Use ids from 0 to ", this->Surface.GetNumberOfFaces() - 1);
    }
    this->IsChosen[face] = 1;
  }
  return Status::Success();
}

/// Returns the chosen faces with rings of faces around them.
std::vector<char> LevelRefiner::Grow(int rings) const
{
  std::vector<char> isIn = this->IsChosen;
  std::vector<char> isTouched(this->Surface.Points.size());
  for (int ring = 0; ring < rings; ++ring)
  {
    for (std::size_t h = 0; h < this->Surface.Triangles.size(); ++h)
    {
      isTouched[this->Surface.Triangles[h]] |= isIn[h / 3];
    }
    for (std::size_t h = 0; h < this->Surface.Triangles.size(); ++h)
    {
      isIn[h / 3] |= isTouched[this->Surface.Triangles[h]];
    }
  }
  return isIn;
}

Status LevelRefiner::SplitOnce(int rings, Offset mostFaces)
{
  const std::vector<char> isIn = this->Grow(rings);
  const std::vector<Id>& twins = this->Surface.Twins;
  std::vector<char> isSplit(twins.size(), 0);
  for (Id h = 0; h < static_cast<Id>(twins.size()); ++h)
  {
    if (isIn[SurfaceMesh::Face(h)] && !isSplit[h] && HasMiddle(this->Mesh, this->Surface, h))
    {
      isSplit[h] = 1;
      for (Id e = twins[h]; e != NoId && e != h; e = twins[e])
      {
        isSplit[e] = 1;
      }
    }
  }
  // Each split side adds one face.
  Offset faces = static_cast<Offset>(this->Surface.Faces.size());
  faces = std::accumulate(isSplit.begin(), isSplit.end(), faces);
  mostFaces = std::min<Offset>(mostFaces, std::numeric_limits<Id>::max() / 3);
  if (faces > mostFaces)
  {
    return Status(Status::Code::OutOfMemory,
      JoinText("Refinement needs ", faces, " faces, more than the limit of ", mostFaces))
      .Fix("Refine fewer faces or use fewer levels");
  }
  std::vector<Id> parts;
  SplitEdges(this->Mesh, isSplit, this->Surface, &parts);
  std::vector<char> isChosen;
  std::vector<Id> parents;
  isChosen.reserve(parts.size());
  parents.reserve(parts.size());
  for (const Id face : parts)
  {
    isChosen.push_back(this->IsChosen[face]);
    parents.push_back(this->Parents[face]);
  }
  this->IsChosen.swap(isChosen);
  this->Parents.swap(parents);
  return Status::Success();
}
}

Status RefineFaces(const SurfaceMesh& mesh, const std::vector<Id>& faces, int levels,
  const ProgressCallback& progress, SubMesh& surface, std::vector<Id>& parents, Offset mostFaces)
{
  parents.clear();
  if (levels < 0)
  {
    return InvalidInput("The number of levels is ", levels).Fix("Use a number of at least 0");
  }
  SubMesh refined = surface;
  std::vector<Id> refinedParents;
  LevelRefiner refiner(mesh, refined, refinedParents);
  DGG_RETURN_IF_ERROR(refiner.Choose(faces));
  for (int level = 0; level < levels; ++level)
  {
    if (progress && !progress(static_cast<double>(level) / levels))
    {
      return Status::Abort();
    }
    DGG_RETURN_IF_ERROR(refiner.SplitOnce(levels - 1 - level, mostFaces));
  }
  surface = std::move(refined);
  parents = std::move(refinedParents);
  return Status::Success();
}
}
