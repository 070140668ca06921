// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The faces that virtual sources are propagated over, in single precision. Internal.
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

/// A face in single precision, one cache line. Lengths are in mean edges.
struct alignas(64) PropagationFace
{
  float Lengths[3]; ///< of its half-edges
  float Cosines[3]; ///< of the corner angles at their origins
  float Sines[3];   ///< of the same
  Id Behind[3];     ///< the twin where it is the only one and oriented alike; else a code
  Id Corners[3];    ///< the origins
  bool IsIrregular; ///< whether a corner is a hub
};

class PropagationFaces
{
public:
  /// Codes of PropagationFace::Behind. From FirstGate on down: a hub, FirstGate - code.
  static constexpr Id Nothing = NoId;
  static constexpr Id AskMesh = -2; ///< a few faces, or one that is not oriented alike
  static constexpr Id FirstGate = -3;

  explicit PropagationFaces(const SurfaceMesh& mesh);

  const PropagationFace& operator[](Id f) const { return this->Faces[f]; }
  double GetUnit() const { return this->Unit; }
  /// Whether a way can bend anywhere. If not, as in the plane, a source that seems to be too early
  /// is only earlier than others.
  bool HasShadows() const { return this->IsAnyBend; }

  /// Where a label goes on into many faces: irregular vertices, and edges of many faces.
  Id GetNumberOfHubs() const { return this->NumberOfHubs; }
  /// These come first.
  Id GetNumberOfVertexHubs() const { return this->NumberOfVertexHubs; }
  /// NoId where the vertex is none.
  Id GetHub(Id v) const { return this->VertexHubs.empty() ? NoId : this->VertexHubs[v]; }

private:
  void LookAtVertices(const SurfaceMesh& mesh);
  void FindEdgeHubs(const SurfaceMesh& mesh);

  std::vector<PropagationFace> Faces;
  std::vector<Id> VertexHubs; // empty when no vertex is irregular
  Id NumberOfHubs = 0;
  Id NumberOfVertexHubs = 0;
  bool IsAnyBend = false;
  double Unit; // the mean edge
};
}

#endif
