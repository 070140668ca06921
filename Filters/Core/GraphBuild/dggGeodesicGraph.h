// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The discrete geodesic graph: a sparse symmetric graph over the vertices of a surface, as flat
/// arrays.
#ifndef dggGeodesicGraph_h
#define dggGeodesicGraph_h

#include "dggBuffer.h"     // for the arrays
#include "dggCoreExport.h" // for DGG_CORE_EXPORT
#include "dggParallel.h"   // for ParallelFor
#include "dggStatus.h"     // for Status

#include <array>   // for Signature
#include <cstdint> // for fixed-width words

namespace dgg
{
/// Input from which a graph was built.
enum class GraphKind : std::uint8_t
{
  Mesh = 0, ///< a triangle mesh: edges have polar angles
  Cloud = 1 ///< a point cloud: no polar angles
};

/// Rule that selects the edges.
enum class GraphConstruction : std::uint8_t
{
  Guaranteed = 0,        ///< progress rule: the error of every distance is bounded
  OneRelay = 1,          ///< published direct rule: maximum error unbounded
  Indirect = 2,          ///< published two-step construction, pruned by progress; unproven
  SaddleVertexGraph = 3, ///< K nearest vertices (Ying, Wang and He 2013)
  CloudCurvature = 4,    ///< clouds, scheme A: radius is the mean length of direct pairs
  CloudConstant = 5,     ///< clouds, scheme B: the same radius for all points
  CloudSpacing = 6       ///< clouds, scheme C: radius is a multiple of the local spacing
};

/// 128-bit hash that identifies a surface.
using Signature = std::array<std::uint64_t, 2>;

/// Returns the signature of points (x y z each) and triangles (three ids each), computed from their
/// bit patterns.
DGG_CORE_EXPORT Signature ComputeSignature(
  const double* points, Offset numberOfPoints, const Id* triangles, Offset numberOfTriangles);

/// Metadata of a graph.
struct GraphInfo
{
  GraphKind Kind = GraphKind::Mesh;
  GraphConstruction Construction = GraphConstruction::Guaranteed;
  double Accuracy = 0.0;    ///< relative; 0 for a SaddleVertexGraph
  Id NumberOfNeighbors = 0; ///< K of a SaddleVertexGraph, otherwise 0
  Signature Surface{ { 0, 0 } };

  /// Returns true if every graph distance is within a factor of 1 + Accuracy of the exact distance.
  bool IsGuaranteed() const
  {
    return this->Kind == GraphKind::Mesh && this->Construction == GraphConstruction::Guaranteed;
  }
};

/// Non-owning view of a graph. Row v, [Offsets[v], Offsets[v + 1]), holds the edges that leave v,
/// sorted by Angles. Every edge is stored in both directions with the same length. The length of an
/// edge is the length of a path on the surface: a geodesic that bends at no vertex.
struct GraphView
{
  GraphInfo Info;
  Id NumberOfVertices = 0;
  const Offset* Offsets = nullptr; ///< n + 1
  const Id* Targets = nullptr;
  /// Exactly one of Lengths and WideLengths is set. Float lengths are rounded up, so that no graph
  /// path is shorter than the exact one.
  const float* Lengths = nullptr;
  const double* WideLengths = nullptr;
  /// Direction of departure: polar angle at the tail in [0, total angle), as returned by
  /// SurfaceMesh::PolarAngle(). Null for clouds.
  const float* Angles = nullptr;
  /// Direction of arrival: polar angle at the target, pointing back to the tail. Null for clouds.
  const float* ArrivalAngles = nullptr;

  Offset GetNumberOfEdges() const
  {
    return this->Offsets ? this->Offsets[this->NumberOfVertices] : 0;
  }
  double Length(Offset edge) const
  {
    return this->Lengths ? static_cast<double>(this->Lengths[edge]) : this->WideLengths[edge];
  }
};

/// A graph that owns its arrays.
struct DGG_CORE_EXPORT GeodesicGraph
{
  GraphInfo Info;
  Buffer<Offset> Offsets;
  Buffer<Id> Targets;
  Buffer<float> Lengths;
  Buffer<double> WideLengths; ///< used instead of Lengths if the accuracy is below 1e-5
  Buffer<float> Angles;
  Buffer<float> ArrivalAngles;

  Id GetNumberOfVertices() const
  {
    return this->Offsets.IsEmpty() ? 0 : static_cast<Id>(this->Offsets.Size() - 1);
  }
  GraphView View() const;
  /// Returns the size of the arrays in bytes.
  std::size_t GetMemorySize() const;
};

/// Returns true if lengths must be stored as double for this accuracy. The rounding error of a
/// float is about 1e-7.
inline bool NeedsWideLengths(double accuracy)
{
  return accuracy > 0.0 && accuracy < 1e-5;
}

/// Fails if the arrays do not form a graph. Causes are offsets that do not ascend from 0, targets
/// that are out of range or equal to their row, lengths that are not positive and finite, angles
/// that are not finite, and rows that are not sorted by angle. `numberOfEdges` is the size of all
/// arrays except Offsets, which has NumberOfVertices + 1 entries.
DGG_CORE_EXPORT Status CheckGraph(
  const GraphView& graph, Offset numberOfEdges, const ParallelFor& parallel = ParallelFor());

/// Returns a checksum of the bit patterns of the arrays, which reveals damage that CheckGraph()
/// cannot detect. Offsets must be valid.
DGG_CORE_EXPORT std::uint64_t ComputeChecksum(
  const GraphView& graph, const ParallelFor& parallel = ParallelFor());
}

#endif
