// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Data for unfolding faces into the plane of a distant source, one cache line per half-edge.
/// Internal.
#ifndef dggUnfoldingTable_h
#define dggUnfoldingTable_h

#include "dggSurfaceMesh.h" // for SurfaceMesh
#include "dggUnfolding.h"   // for Point2

#include <algorithm> // for std::min
#include <array>     // for the entries
#include <cstddef>   // for std::size_t
#include <cstdint>   // for the size of blocks
#include <limits>    // for the code of the rim
#include <vector>    // for the maps

namespace dgg
{
/// Crossing of a face that is entered through one of its edges. Positions in the plane are relative
/// to the edge: to its origin, and to its direction as a unit vector u. The face lies to the left
/// of u.
///
/// Directions are rotated by the angles of the face rather than computed from differences of
/// unfolded points, which would lose all accuracy at an edge that is tiny relative to its distance.
struct alignas(64) FaceCrossing
{
  /// Exit edges of a window: the left edge, from the origin to the apex, and the right edge, from
  /// the apex to the end.
  enum Side
  {
    Left = 0,
    Right = 1
  };

  Point2 Apex;         ///< apex in the frame of the edge
  Point2 Direction[2]; ///< unit vectors along the left and the right edge
  Id Behind[2];        ///< codes (see UnfoldingTable) of the entries behind both edges
  Id ApexVertex;       ///< id of the table
  Id HalfEdge;         ///< the edge in the mesh; ~h if entered as its mirror image

  /// Returns true if the face is unfolded as its mirror image.
  bool IsMirrored() const { return this->HalfEdge < 0; }
  Id GetHalfEdge() const { return this->IsMirrored() ? ~this->HalfEdge : this->HalfEdge; }
};

/// Consecutive crossings of an UnfoldingTable.
struct CrossingBlock
{
  static constexpr Id Size =
    1024; ///< a power of two, so that the block of an entry is quickly found

  std::array<FaceCrossing, Size> Crossings;
  std::array<double, Size> PolarAngles; ///< SurfaceMesh::PolarAngle() of the half-edges
};

/// Numbers the crossings of all faces in a cache-friendly order, with vertices renumbered
/// accordingly, and computes them block by block. At edges with inconsistent orientation or more
/// than two faces, the face behind the edge is crossed as its mirror image: the plane is never
/// flipped.
class UnfoldingTable
{
public:
  /// Builds the table. `order` lists the vertices of the mesh in their new order. `isRim`, one flag
  /// per vertex or empty, is documented in SurfaceMesh::FromPoints(): faces with a vertex on the
  /// rim cannot be entered, and the code behind their edges is RimCode. If Check() fails, no other
  /// function may be called.
  UnfoldingTable(
    const SurfaceMesh& mesh, std::vector<Id> order, const std::vector<std::uint8_t>& isRim = {});

  /// Code behind an edge whose faces have vertices on the rim.
  static constexpr Id RimCode = std::numeric_limits<Id>::min();

  /// Fails if the mesh is too large. Crossings are indexed by Id, and a mesh that needs mirror
  /// images has two crossings per half-edge.
  Status Check() const { return CheckSize(this->Count); }

  /// Quantities that determine the size of a table.
  struct Extent
  {
    Offset HalfEdges = 0;
    bool NeedsMirrors = false;
    Offset BranchEdges = 0;     ///< edges with more than two faces
    Offset BranchHalfEdges = 0; ///< their half-edges
  };
  static Status CheckSize(const Extent& count);

  const SurfaceMesh& GetMesh() const { return this->Mesh; }
  Id GetNumberOfVertices() const { return static_cast<Id>(this->Order.size()); }
  /// Returns the old ids of the vertices of the table.
  const std::vector<Id>& GetOrder() const { return this->Order; }
  /// Returns the old id of a vertex of the table, or the new id of a vertex of the mesh.
  Id OldVertex(Id v) const { return this->Order[v]; }
  Id NewVertex(Id v) const { return this->Rank[v]; }

  std::size_t GetNumberOfBlocks() const
  {
    return static_cast<std::size_t>(this->CountEntries() + CrossingBlock::Size - 1) /
      CrossingBlock::Size;
  }
  /// Returns the size of the arrays in bytes.
  std::size_t GetMemorySize() const;
  /// Computes the crossings of a block. Entries of faces that are dropped are not set.
  void Fill(std::size_t index, CrossingBlock& block) const;

  /// Returns the crossing of the face of half-edge h, entered through h.
  Id EntryOf(Id h) const { return 3 * this->FaceRank[SurfaceMesh::Face(h)] + h % 3; }

  /// Calls `visit(entry)` for the crossings behind a code: no crossing on the boundary, one on a
  /// manifold edge, more on a non-manifold edge.
  template <typename Visitor>
  void ForEach(Id code, Visitor&& visit) const
  {
    if (code >= 0)
    {
      visit(code);
    }
    else if (code < NoId && code != RimCode)
    {
      // The loop traverses the circular list once, starting at its own position.
      const Id* const own = this->Branches.data() + (FirstBranch - code);
      for (const Id* next = own + 2;; next += 2)
      {
        if (*next < 0)
        {
          next += *next;
        }
        if (next == own)
        {
          return;
        }
        visit(*next);
      }
    }
  }
  /// Returns the polar angle at a vertex of the table as stored in a graph: in [0, total angle), as
  /// a float below the end of the range.
  float StoredAngle(Id v, double angle) const
  {
    const float last = this->LastAngles[v];
    const auto stored =
      static_cast<float>(angle >= 0.0 && angle <= last ? angle : this->Wrap(v, angle));
    return stored > 0.0F ? std::min(stored, last) : 0.0F;
  }

  /// Returns true if a vertex of the table is on the rim.
  bool IsRim(Id v) const { return !this->Rim.empty() && this->Rim[this->Order[v]] != 0; }
  /// Returns true if edges with more than two faces exist.
  bool HasBranches() const { return !this->Branches.empty(); }
  /// Returns true if mirrored crossings exist as well, because orientations are inconsistent.
  bool NeedsMirrors() const { return this->Count.NeedsMirrors; }
  bool HasDegenerateFaces() const { return this->Mesh.GetNumberOfDegenerateFaces() > 0; }

private:
  static constexpr Id FirstBranch = -2;

  Extent Measure() const;
  Offset CountEntries() const { return (this->Count.NeedsMirrors ? 2 : 1) * this->Count.HalfEdges; }
  void OrderFaces();
  void MeasureLastAngles();
  double Wrap(Id v, double angle) const;
  void ListBranches();
  void FillEntries(Offset first, bool mirrored, CrossingBlock& block) const;
  FaceCrossing MakeCrossing(Id h, bool mirrored) const;
  Id FindCodeBehind(Id exit, bool mirrored) const;
  bool LeadsToRim(Id exit) const;
  Id Entry(Id h, bool mirrored) const { return this->EntryOf(h) + (mirrored ? this->Mirrors : 0); }

  const SurfaceMesh& Mesh;
  Extent Count;
  std::vector<std::uint8_t> Rim; // per old vertex; empty if no vertex is on the rim
  std::vector<Id> Order;         // old id of each new vertex
  std::vector<Id> Rank;          // new id of each old vertex
  std::vector<Id> FaceRank;      // new id of each old face
  /// Per block of entries that are not mirrored, the first new vertex at the face of its first
  /// entry.
  std::vector<Id> FirstVertices;
  std::vector<float> LastAngles; // per new vertex, largest float below the total angle
  /// Per non-manifold edge, two lists of the crossings that are entered through the edge, with one
  /// entry per half-edge. The lists are mirror images of each other and interleaved. A negative
  /// entry at the end of a list is the offset back to the beginning of the list. A code contains
  /// the position of its own half-edge.
  std::vector<Id> Branches;
  /// Position of each half-edge of a non-manifold edge in the first list of its edge; empty if all
  /// edges are manifold.
  std::vector<Id> BranchPositions;
  Id Mirrors = 0; // first mirrored crossing; 0 if no crossing is mirrored
};
}

#endif
