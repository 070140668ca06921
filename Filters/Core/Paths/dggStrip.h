// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A sequence of faces that a path runs through. Internal.
#ifndef dggStrip_h
#define dggStrip_h

#include "dggSurfaceMesh.h"  // for SurfaceMesh
#include "dggSurfacePath.h"  // for SurfacePath
#include "dggSurfacePoint.h" // for SurfacePoint

#include <vector> // for the crossings

namespace dgg
{
/// From one face to another of the same edge: both half-edges are of that edge.
struct EdgeCrossing
{
  Id Exit;  ///< of the face that is left
  Id Entry; ///< of the face that is entered
};

/// Faces from that of a first to that of a last point, each sharing an edge with the next one. No
/// face is left through the edge it was entered through, and the ends do not lie on the edges next
/// to them (see Tidy()).
struct Strip
{
  SurfacePoint Start;
  SurfacePoint End;
  Id FirstFace = NoId; ///< that of Start
  std::vector<EdgeCrossing> Crossings;

  Id LastFace() const
  {
    return this->Crossings.empty() ? this->FirstFace
                                   : SurfaceMesh::Face(this->Crossings.back().Entry);
  }
  /// Face before crossing i; the last face for i the number of crossings.
  Id FaceBefore(std::size_t i) const
  {
    return i == 0 ? this->FirstFace : SurfaceMesh::Face(this->Crossings[i - 1].Entry);
  }
};

/// The same crossings from the last to the first.
void Reverse(std::vector<EdgeCrossing>& crossings);

/// Append a crossing. One that goes back over the edge just crossed takes that crossing back.
void AppendCrossing(std::vector<EdgeCrossing>& crossings, const EdgeCrossing& crossing);

/// The other edge of a face at vertex c.
inline Id OtherEdgeAt(const SurfaceMesh& mesh, Id c, Id h)
{
  return mesh.Origin(h) == c ? SurfaceMesh::Previous(h) : SurfaceMesh::Next(h);
}

/// A path around a vertex from one face to another.
struct Turn
{
  double Angle = Infinity; ///< of the faces in between; Infinity if there is no such path
  std::vector<EdgeCrossing> Crossings;
};

/// Returns the turn around c that leaves a face through its edge `exit` at c and ends in another
/// face. Crosses manifold edges only.
Turn WalkAround(const SurfaceMesh& mesh, Id c, Id exit, Id toFace);

/// Append crossings of edges around vertex `c` that lead from one of its faces to another, on the
/// side where the angle between them is smaller. False when there is no such way: the faces are of
/// different fans, which touch in the vertex only.
bool AppendTurn(
  const SurfaceMesh& mesh, Id c, Id fromFace, Id toFace, std::vector<EdgeCrossing>& crossings);

/// One end of a way around a vertex: a direction in one of its faces.
struct TurnEnd
{
  Id Face;
  Id HalfEdge;  ///< of the face, one of its two edges at the vertex
  double Angle; ///< from that edge to the direction, in the face
};

/// Crossings of the way around vertex `c` with the smallest angle, through any of its faces.
/// Returns that angle, Infinity when there is no way.
double FindTurn(const SurfaceMesh& mesh, Id c, const TurnEnd& from, const TurnEnd& to,
  std::vector<EdgeCrossing>& crossings);

/// Leave out what a strip need not cross: edges crossed to and fro, and edges that an end of the
/// strip lies on.
void Tidy(const SurfaceMesh& mesh, Strip& strip);

/// The half-edge of a face that a point on an edge lies on; NoId when there is none.
Id HalfEdgeUnder(const SurfaceMesh& mesh, const SurfacePoint& point, Id face);

/// The half-edge of a face that starts at the given vertex; NoId when it is not one of its corners.
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

/// The faces that a path runs through. Where it passes through a vertex, the faces around the
/// vertex on one side of it are added, so that there is a single strip, unless faces meet in
/// nothing but that vertex: there the path is pinned, and a new strip begins.
class StripChain
{
public:
  explicit StripChain(const SurfaceMesh& mesh)
    : Mesh(mesh)
  {
  }

  /// With `join` false every strip stays alone, and the path keeps to the vertices between them.
  void Clear(bool join = true)
  {
    this->Strips.clear();
    this->IsJoining = join;
  }
  /// Append a strip that starts where the last one ends, in a vertex. (Elsewhere, both have to be
  /// in the same face there.)
  void Append(const Strip& strip);
  /// Append the faces that a path runs through.
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
