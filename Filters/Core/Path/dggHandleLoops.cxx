// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggHandleLoops.h"

#include "dggHomotopyBasis.h"
#include "dggLoopShortener.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace dgg
{
namespace
{
/// Loops around the handles of a component, and which of them are independent.
class ComponentLoops
{
public:
  ComponentLoops(const SurfaceComponents& components, const HomologySignatures& signatures)
    : Components(components)
    , Mesh(components.GetMesh())
    , Signatures(signatures)
    , Shortener(components.GetMesh())
  {
  }

  /// Vertices, faces and half-edges looked at.
  std::size_t GetNumberOfSteps() const { return this->Steps; }

  /// Loops through the vertex `base`, and through places on them. False when it was stopped.
  bool Collect(Id base, const ProgressCallback& progress)
  {
    this->AddLoopsThrough(base);
    return this->AddLoopsThroughLoops(progress);
  }

  /// Independent ones, the shortest first, followed by empty ones for those that are missing.
  std::vector<FoundLoop> TakeShortest()
  {
    std::stable_sort(
      this->Candidates.begin(), this->Candidates.end(), [](const Candidate& a, const Candidate& b) {
        return a.Found.Loop.Length < b.Found.Loop.Length;
      });
    std::vector<FoundLoop> loops;
    std::vector<std::vector<char>> rows; // in echelon form
    for (Candidate& candidate : this->Candidates)
    {
      std::vector<char> row = candidate.Signature;
      for (const std::vector<char>& other : rows)
      {
        const auto pivot = std::find(other.begin(), other.end(), 1) - other.begin();
        if (row[pivot])
        {
          std::transform(row.begin(), row.end(), other.begin(), row.begin(),
            [](char a, char b) { return static_cast<char>(a ^ b); });
        }
      }
      if (std::find(row.begin(), row.end(), 1) != row.end())
      {
        rows.push_back(std::move(row));
        loops.push_back(std::move(candidate.Found));
      }
    }
    loops.resize(this->Signatures.GetDimension());
    return loops;
  }

private:
  struct Candidate
  {
    FoundLoop Found;
    std::vector<char> Signature;
  };

  /// The shortest loops of edges through a vertex, pulled tight.
  void AddLoopsThrough(Id base)
  {
    this->Bases.push_back(base);
    std::vector<EdgeLoop> basis;
    if (!FindHomotopyBasis(this->Components, base, basis, this->Steps).IsOk())
    {
      return;
    }
    for (const EdgeLoop& edges : basis)
    {
      SurfacePath path;
      for (std::size_t i = 0; i < edges.Vertices.size(); ++i)
      {
        path.Points.push_back(SurfacePoint::AtVertex(edges.Vertices[i]));
        path.Faces.push_back(SurfaceMesh::Face(edges.HalfEdges[i]));
      }
      path.Points.push_back(path.Points.front());
      path.Length = edges.Length;
      Candidate candidate;
      candidate.Signature = this->Signatures.GetSignature(edges);
      if (this->Shortener.PullTight(path, candidate.Found.Loop))
      {
        this->Candidates.push_back(std::move(candidate));
      }
    }
  }

  /// Which loops are shortest through a vertex depends on where that is: far from a handle, a loop
  /// around it may as well take in another one. Close to a loop, those that cross it are found.
  bool AddLoopsThroughLoops(const ProgressCallback& progress)
  {
    const std::size_t count = this->Candidates.size();
    const std::size_t places =
      count > 0 ? std::max<std::size_t>(1, std::min(BasesPerLoop, MostBases / count)) : 0;
    const auto steps = static_cast<double>(std::min(count * places, MostBases));
    for (std::size_t i = 0; i < count && this->Bases.size() <= MostBases; ++i)
    {
      for (std::size_t k = 0; k < places; ++k)
      {
        const SurfacePath& path = this->Candidates[i].Found.Loop;
        const Id face = path.Faces[k * path.Faces.size() / places];
        const Id base = this->Mesh.Origin(3 * face);
        if (progress && !progress(std::min(1.0, static_cast<double>(this->Bases.size()) / steps)))
        {
          return false;
        }
        if (std::find(this->Bases.begin(), this->Bases.end(), base) == this->Bases.end())
        {
          this->AddLoopsThrough(base);
        }
      }
    }
    return true;
  }

  static constexpr std::size_t BasesPerLoop = 4;
  static constexpr std::size_t MostBases = 16;

  const SurfaceComponents& Components;
  const SurfaceMesh& Mesh;
  const HomologySignatures& Signatures;
  LoopShortener Shortener;
  std::vector<Candidate> Candidates;
  std::vector<Id> Bases;
  std::size_t Steps = 0;
};
}

Status FindHandleLoops(const SurfaceMesh& mesh, const ProgressCallback& progress,
  std::vector<FoundLoop>& loops, std::size_t* steps)
{
  loops.clear();
  const SurfaceComponents components(mesh);
  std::size_t count = static_cast<std::size_t>(mesh.GetNumberOfVertices()) +
    static_cast<std::size_t>(mesh.GetNumberOfHalfEdges());
  std::vector<Id> bases;
  Status status = FindBasesOfLoops(components, bases);
  for (std::size_t i = 0; i < bases.size() && status.IsOk(); ++i)
  {
    const auto part = [&](double fraction) {
      return !progress ||
        progress((static_cast<double>(i) + fraction) / static_cast<double>(bases.size()));
    };
    const HomologySignatures signatures(components, bases[i], count);
    status = signatures.Check();
    if (!status.IsOk())
    {
      break;
    }
    ComponentLoops found(components, signatures);
    const bool isDone = found.Collect(bases[i], part) && part(1.0);
    count += found.GetNumberOfSteps();
    if (!isDone)
    {
      status = Status::Abort();
      break;
    }
    for (FoundLoop& loop : found.TakeShortest())
    {
      loops.push_back(std::move(loop));
    }
  }
  if (!status.IsOk())
  {
    loops.clear();
  }
  if (steps)
  {
    *steps = count;
  }
  return status;
}
}
