// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A sequence of faces through which a path runs. Internal.
#ifndef dggStrip_h
#define dggStrip_h

#include "dggSurfaceMesh.h"  // for SurfaceMesh
#include "dggSurfacePath.h"  // for SurfacePath
#include "dggSurfacePoint.h" // for SurfacePoint

#include <vector> // for the crossings

namespace dgg
{
/// The step from one face to another across an edge; both half-edges belong to that edge.
struct EdgeCrossing
{
  Id Exit;  ///< half-edge of the face that is left
  Id Entry; ///< half-edge of the face that is entered
};

/// Faces from the start point to the end point; consecutive faces share an edge. No
/// face is left through the edge by which it was entered, and the end points do not lie on the
/// adjacent crossed edges (see RemoveRedundantCrossings()).
struct Strip
{
  SurfacePoint Start;
  SurfacePoint End;
  Id FirstFace = NoId; ///< face of Start
  std::vector<EdgeCrossing> Crossings;

  Id LastFace() const
  {
    return this->Crossings.empty() ? this->FirstFace
                                   : SurfaceMesh::Face(this->Crossings.back().Entry);
  }
  /// Returns the face before crossing i; the last face if i is the number of crossings.
  Id FaceBefore(std::size_t i) const
  {
    return i == 0 ? this->FirstFace : SurfaceMesh::Face(this->Crossings[i - 1].Entry);
  }
};

/// Reverses the direction of a sequence of crossings.
void Reverse(std::vector<EdgeCrossing>& crossings);

/// Appends a crossing. A crossing back over the previous edge cancels the previous crossing.
void AppendCrossing(std::vector<EdgeCrossing>& crossings, const EdgeCrossing& crossing);

/// Returns the half-edge of the other edge at vertex c in the face of h.
inline Id OtherEdgeAt(const SurfaceMesh& mesh, Id c, Id h)
{
  return mesh.Origin(h) == c ? SurfaceMesh::Previous(h) : SurfaceMesh::Next(h);
}

/// A path around a vertex from one face to another.
struct Turn
{
  double Angle = Infinity; ///< angle of the faces in between; Infinity if there is no such path
  std::vector<EdgeCrossing> Crossings;
};

/// Returns the turn around c that leaves a face through its edge `exit` at c and ends in another
/// face. Crosses manifold edges only.
Turn WalkAround(const SurfaceMesh& mesh, Id c, Id exit, Id toFace);

/// Appends the crossings around vertex `c` from one of its faces to another, on the side with the
/// smaller angle. Returns false if there is no such path: the faces belong to different fans, which
/// only touch in the vertex.
bool AppendTurn(
  const SurfaceMesh& mesh, Id c, Id fromFace, Id toFace, std::vector<EdgeCrossing>& crossings);

/// One end of a turn around a vertex: a direction in one of its faces.
struct TurnEnd
{
  Id Face;
  Id HalfEdge;  ///< one of the two edges of the face at the vertex
  double Angle; ///< from that edge to the direction, in the face
};

/// Finds the turn around vertex `c` with the smallest angle, through any of its faces. Returns that
/// angle, or Infinity if there is no turn.
double FindTurn(const SurfaceMesh& mesh, Id c, const TurnEnd& from, const TurnEnd& to,
  std::vector<EdgeCrossing>& crossings);

/// Removes redundant crossings: edges crossed back and forth, and edges that contain an end of the
/// strip.
void RemoveRedundantCrossings(const SurfaceMesh& mesh, Strip& strip);

/// Returns the half-edge of a face that contains a point on an edge; NoId if there is none.
Id HalfEdgeUnder(const SurfaceMesh& mesh, const SurfacePoint& point, Id face);

/// Returns the half-edge of a face that starts at the given vertex; NoId if the vertex is not a
/// corner.
inline Id HalfEdgeFrom(const SurfaceMesh& mesh, Id face, Id vertex)
{
  for (Id h = 3 * face; h < 3 * face + 3; ++h)
  {
    if (mesh.Origin(h) == vertex)
    {
      return h;
    }
  }
  return NoId;
}

/// The faces through which a path runs. Where the path passes through a vertex, the faces around
/// the vertex on one side are added, so that there is a single strip. Where faces only touch in the
/// vertex, the path is pinned there, and a new strip begins.
class StripChain
{
public:
  explicit StripChain(const SurfaceMesh& mesh)
    : Mesh(mesh)
  {
  }

  /// Removes all strips. If `join` is false, strips are not joined, and the path passes through the
  /// vertices between them.
  void Clear(bool join = true)
  {
    this->Strips.clear();
    this->IsJoining = join;
  }
  /// Appends a strip that starts where the last one ends, in a vertex. (Elsewhere, both strips must
  /// share the face at that point.)
  void Append(const Strip& strip);
  /// Appends the faces through which a path runs.
  void Append(const SurfacePath& path);

  std::vector<Strip>& GetStrips() { return this->Strips; }

private:
  void AppendPiece(const SurfacePoint& from, const SurfacePoint& to, Id face);

  const SurfaceMesh& Mesh;
  std::vector<Strip> Strips;
  bool IsJoining = true;
};
}

#endif
