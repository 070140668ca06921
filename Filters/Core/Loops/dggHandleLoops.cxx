// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggHandleLoops.h"

#include "dggHomotopyBasis.h"
#include "dggLoopShortener.h"
#include "dggProgressPart.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

namespace dgg
{
namespace
{
/// Linearly independent rows of bits, modulo 2.
class IndependentRows
{
public:
  using Row = std::vector<std::uint64_t>;

  explicit IndependentRows(std::size_t dimension)
    : RowOf(dimension, None)
  {
  }

  /// Adds a row. Returns false if the row is a sum of existing rows.
  bool Add(Row row)
  {
    // Echelon form: a row with pivot p has no bit before p.
    for (std::size_t word = 0; word < row.size(); ++word)
    {
      while (row[word] != 0)
      {
        const std::size_t pivot = 64 * word + FindLowestBit(row[word]);
        if (this->RowOf[pivot] == None)
        {
          this->RowOf[pivot] = this->Rows.size();
          this->Rows.push_back(std::move(row));
          return true;
        }
        const Row& other = this->Rows[this->RowOf[pivot]];
        for (std::size_t i = word; i < row.size(); ++i)
        {
          row[i] ^= other[i];
        }
      }
    }
    return false;
  }

private:
  static constexpr std::size_t None = std::numeric_limits<std::size_t>::max();

  static std::size_t FindLowestBit(std::uint64_t bits)
  {
    std::size_t place = 0;
    while (((bits >> place) & 1) == 0)
    {
      ++place;
    }
    return place;
  }

  std::vector<Row> Rows;
  std::vector<std::size_t> RowOf; // per bit, the row whose pivot is this bit
};

/// Loops around the handles of a component, and their independence.
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

  /// Collects loops through the vertex `base`, and through points on these loops. Returns false if
  /// stopped.
  bool Collect(Id base, const ProgressCallback& progress)
  {
    return this->AddLoopsThrough(base, ProgressPart(progress, 0.0, FirstShare)) &&
      this->AddLoopsThroughLoops(ProgressPart(progress, FirstShare, CollectShare));
  }

  /// Appends independent loops, shortest first, followed by empty loops for missing ones. Returns
  /// false if stopped.
  bool TakeShortest(const ProgressCallback& progress, std::vector<FoundLoop>& loops)
  {
    std::stable_sort(
      this->Candidates.begin(), this->Candidates.end(), [](const Candidate& a, const Candidate& b) {
        return a.Found.Loop.Length < b.Found.Loop.Length;
      });
    const std::size_t dimension = this->Signatures.GetDimension();
    IndependentRows rows(dimension);
    for (std::size_t i = 0; i < this->Candidates.size() && loops.size() < dimension; ++i)
    {
      const double done = static_cast<double>(i) / static_cast<double>(this->Candidates.size());
      if (!progress(CollectShare + (1.0 - CollectShare) * done))
      {
        return false;
      }
      if (rows.Add(std::move(this->Candidates[i].Signature)))
      {
        loops.push_back(std::move(this->Candidates[i].Found));
      }
    }
    loops.resize(dimension);
    return true;
  }

private:
  struct Candidate
  {
    FoundLoop Found;
    IndependentRows::Row Signature;
  };

  /// Adds the shortest loops of edges through a vertex, shortened to geodesics. Returns false if
  /// stopped.
  bool AddLoopsThrough(Id base, const ProgressCallback& progress)
  {
    this->Bases.push_back(base);
    std::vector<EdgeLoop> basis;
    if (!FindHomotopyBasis(this->Components, base, basis).IsOk())
    {
      return true;
    }
    for (std::size_t l = 0; l < basis.size(); ++l)
    {
      if (!progress(static_cast<double>(l) / static_cast<double>(basis.size())))
      {
        return false;
      }
      const EdgeLoop& edges = basis[l];
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
    return true;
  }

  /// Adds loops through points on the loops found so far. Returns false if stopped. The shortest
  /// loops depend on the base: far from a handle, a loop around the handle may also include another
  /// handle. Through points near a loop, the loops that cross this loop are found.
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
        const auto done = static_cast<double>(this->Bases.size() - 1); // without the first one
        const auto part = [&](double fraction) {
          return progress(std::min(1.0, (done + fraction) / steps));
        };
        if (!part(0.0))
        {
          return false;
        }
        if (std::find(this->Bases.begin(), this->Bases.end(), base) == this->Bases.end() &&
          !this->AddLoopsThrough(base, part))
        {
          return false;
        }
      }
    }
    return true;
  }

  /// Progress after the loops through the first base, and through all bases.
  static constexpr double FirstShare = 0.1;
  static constexpr double CollectShare = 0.9;

  static constexpr std::size_t BasesPerLoop = 4;
  static constexpr std::size_t MostBases = 16;

  const SurfaceComponents& Components;
  const SurfaceMesh& Mesh;
  const HomologySignatures& Signatures;
  LoopShortener Shortener;
  std::vector<Candidate> Candidates;
  std::vector<Id> Bases;
};
}

Status FindHandleLoops(
  const SurfaceMesh& mesh, const ProgressCallback& progress, std::vector<FoundLoop>& loops)
{
  loops.clear();
  const SurfaceComponents components(mesh);
  std::vector<Id> bases;
  Status status = FindBasesOfLoops(components, bases);
  for (std::size_t i = 0; i < bases.size() && status.IsOk(); ++i)
  {
    const auto part = [&](double fraction) {
      return !progress ||
        progress((static_cast<double>(i) + fraction) / static_cast<double>(bases.size()));
    };
    const HomologySignatures signatures(components, bases[i]);
    status = signatures.Check();
    if (!status.IsOk())
    {
      break;
    }
    ComponentLoops found(components, signatures);
    std::vector<FoundLoop> shortest;
    const bool isDone =
      found.Collect(bases[i], part) && found.TakeShortest(part, shortest) && part(1.0);
    if (!isDone)
    {
      status = Status::Abort();
      break;
    }
    for (FoundLoop& loop : shortest)
    {
      loops.push_back(std::move(loop));
    }
  }
  if (!status.IsOk())
  {
    loops.clear();
  }
  return status;
}
}
