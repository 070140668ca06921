// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What it takes to unfold faces into the plane of a far source, one cache line a half-edge.
/// Internal.
#ifndef dggUnfoldingTable_h
#define dggUnfoldingTable_h

#include "dggPrefetch.h"    // for Prefetch
#include "dggSurfaceMesh.h" // for SurfaceMesh
#include "dggUnfolding.h"   // for Point2

#include <algorithm> // for std::min
#include <cstddef>   // for std::size_t
#include <vector>    // for the entries

namespace dgg
{
/// How a face is crossed when it is entered through one of its edges. Positions in the plane are
/// relative to the edge: its origin, and its direction as a unit vector u. The face lies to the
/// left of u.
///
/// Directions are turned by the angles of the face rather than taken from differences of unfolded
/// points: those would lose all accuracy at an edge that is tiny for its distance.
struct alignas(64) FaceCrossing
{
  /// A window goes on through the left edge, from the origin to the apex, or through the right
  /// edge, from the apex to the end.
  enum Side
  {
    Left = 0,
    Right = 1
  };

  Point2 Apex;         ///< in the frame of the edge
  Point2 Direction[2]; ///< of the left and the right edge, unit vectors
  Id Behind[2];        ///< what follows behind them: codes of UnfoldingTable
  Id ApexVertex;       ///< id of the table
  Id HalfEdge;         ///< the edge in the mesh; ~h when entered against its direction

  /// Whether the face is seen in its mirror image.
  bool IsMirrored() const { return this->HalfEdge < 0; }
  Id GetHalfEdge() const { return this->IsMirrored() ? ~this->HalfEdge : this->HalfEdge; }
};

/// The crossings of all faces, in an order that is kind to the cache, with vertices renumbered
/// alike. Where the faces of an edge are not oriented alike, or there are more than two of them,
/// the face behind is crossed in its mirror image: the plane is never flipped.
class UnfoldingTable
{
public:
  /// `order` lists the vertices of the mesh in their new order. The table is good for nothing but
  /// Check() if that fails.
  UnfoldingTable(const SurfaceMesh& mesh, std::vector<Id> order);

  /// Fails with a message when the mesh is too large: crossings are counted by Id, and a mesh that
  /// needs mirror images has two of them a half-edge.
  Status Check() const { return CheckSize(this->Count); }

  /// What decides on the size of a table.
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
  /// From new to old ids and back.
  Id OldVertex(Id v) const { return this->Order[v]; }
  Id NewVertex(Id v) const { return this->Rank[v]; }

  const FaceCrossing& operator[](Id entry) const { return this->Crossings[entry]; }
  /// Have a crossing brought into the cache, if the code is that of one.
  void Prefetch(Id code) const
  {
    if (code >= 0)
    {
      dgg::Prefetch(&this->Crossings[code]);
    }
  }
  /// The crossing of the face of half-edge h, entered through h.
  Id EntryOf(Id h) const { return 3 * this->FaceRank[SurfaceMesh::Face(h)] + h % 3; }

  /// Call `visit(entry)` for everything that follows a code: nothing on the boundary, one crossing
  /// on a manifold edge, more on a non-manifold edge.
  template <typename Visitor>
  void ForEach(Id code, Visitor&& visit) const
  {
    if (code >= 0)
    {
      visit(code);
    }
    else if (code < NoId)
    {
      // Once around the list, from the own place on.
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
  /// What follows behind half-edge `exit`, left from its own face.
  Id CodeBehind(Id exit) const
  {
    return this->Crossings[this->EntryOf(SurfaceMesh::Next(exit))].Behind[FaceCrossing::Left];
  }

  /// SurfaceMesh::PolarAngle() of a half-edge of the mesh, kept where its face is.
  double PolarAngle(Id h) const { return this->PolarAngles[this->EntryOf(h)]; }
  /// Polar angle at a vertex of the table as it is stored: in [0, total angle), as a float not
  /// beyond the end of the range.
  float StoredAngle(Id v, double angle) const
  {
    const AngleRange& range = this->Ranges[v];
    const double turn = angle < 0.0 ? range.Turn : angle >= range.Turn ? -range.Turn : 0.0;
    const auto stored = static_cast<float>(angle + turn);
    return stored > 0.0F ? std::min(stored, range.Last) : 0.0F;
  }

  /// Whether there are edges with more than two faces.
  bool HasBranches() const { return !this->Branches.empty(); }
  /// Whether crossings are there twice, for faces that are not oriented alike.
  bool NeedsMirrors() const { return this->Count.NeedsMirrors; }
  bool HasDegenerateFaces() const { return this->Mesh.GetNumberOfDegenerateFaces() > 0; }

private:
  static constexpr Id FirstBranch = -2;

  struct AngleRange
  {
    double Turn = 0.0; ///< what a full turn adds; nothing on the boundary
    float Last = 0.0F; ///< largest float below the total angle
  };

  Extent Measure() const;
  void OrderFaces();
  void FillAngles();
  void Fill(Id h, bool mirrored, const std::vector<Id>& places);
  std::vector<Id> ListBranches();
  Id FindCodeBehind(Id exit, bool mirrored, const std::vector<Id>& places) const;
  Id Entry(Id h, bool mirrored) const { return this->EntryOf(h) + (mirrored ? this->Mirrors : 0); }

  const SurfaceMesh& Mesh;
  Extent Count;
  std::vector<Id> Order;    // old id of each new vertex
  std::vector<Id> Rank;     // new id of each old vertex
  std::vector<Id> FaceRank; // new id of each old face
  std::vector<FaceCrossing> Crossings;
  std::vector<double> PolarAngles; // per entry
  std::vector<AngleRange> Ranges;  // per new vertex
  /// For every edge with more than two faces two lists of what is entered through it, an entry for
  /// each of its half-edges: one list is the mirror image of the other, and they alternate. At the
  /// end of a list is, negative, the way back to its begin. A code says which place is one's own.
  std::vector<Id> Branches;
  Id Mirrors = 0; // where the mirrored crossings start; 0 when there are none
};
}

#endif
