// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Faces in single precision, for the propagation of virtual sources. Internal.
#ifndef dggPropagationFaces_h
#define dggPropagationFaces_h

#include "dggSurfaceMesh.h" // for SurfaceMesh

#include <vector> // for the faces

namespace dgg
{
/// Half-edges of one face.
inline int NextOf(int k)
{
  return k == 2 ? 0 : k + 1;
}
inline int PreviousOf(int k)
{
  return k == 0 ? 2 : k - 1;
}

/// A face in single precision, one cache line. Lengths are in units of the mean edge length.
struct alignas(64) PropagationFace
{
  float Lengths[3]; ///< lengths of its half-edges
  float Cosines[3]; ///< cosines of the corner angles at their origins
  float Sines[3];   ///< sines of the same angles
  Id Behind[3];     ///< the twin, if it is unique and consistently oriented; otherwise a code
  Id Corners[3];    ///< the origins
  bool IsIrregular; ///< true if a corner is a hub
};

class PropagationPieces;

class PropagationFaces
{
public:
  /// Codes of PropagationFace::Behind. From FirstGate on down: a hub, FirstGate - code.
  static constexpr Id Nothing = NoId;
  static constexpr Id AskMesh = -2; ///< a few faces, or one of opposite orientation
  static constexpr Id FirstGate = -3;

  explicit PropagationFaces(const SurfaceMesh& mesh);
  /// Faces of a piece of a surface. `unit` is the mean edge length of the surface, and `pieces` may
  /// be null.
  PropagationFaces(const SurfaceMesh& mesh, double unit, const PropagationPieces* pieces);

  const PropagationFace& operator[](Id f) const { return this->Faces[f]; }
  double GetUnit() const { return this->Unit; }
  /// Returns true if paths can bend somewhere. Otherwise, as in the plane, there are no shadows,
  /// and a source that reaches a vertex earlier than all others is simply nearer.
  bool HasShadows() const { return this->IsAnyBend; }
  /// Sets the value of HasShadows(), for a surface in pieces.
  void SetShadows(bool hasShadows) { this->IsAnyBend = hasShadows; }

  /// Returns the number of hubs, where a label continues into many faces: irregular vertices and
  /// edges with many faces.
  Id GetNumberOfHubs() const { return this->NumberOfHubs; }
  /// Returns the number of vertex hubs, which come first.
  Id GetNumberOfVertexHubs() const { return this->NumberOfVertexHubs; }
  /// Returns the hub of a vertex, or NoId.
  Id GetHub(Id v) const { return this->VertexHubs.empty() ? NoId : this->VertexHubs[v]; }

private:
  void LookAtVertices(const SurfaceMesh& mesh, const PropagationPieces* pieces);
  void FindEdgeHubs(const SurfaceMesh& mesh);

  std::vector<PropagationFace> Faces;
  std::vector<Id> VertexHubs; // empty if no vertex is irregular
  Id NumberOfHubs = 0;
  Id NumberOfVertexHubs = 0;
  bool IsAnyBend = false;
  double Unit; // mean edge length
};
}

#endif
