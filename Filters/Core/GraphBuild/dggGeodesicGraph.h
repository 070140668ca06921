// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The discrete geodesic graph: a sparse symmetric graph over the vertices of a surface, as flat
/// arrays.
#ifndef dggGeodesicGraph_h
#define dggGeodesicGraph_h

#include "dggCoreExport.h" // for DGG_CORE_EXPORT
#include "dggBuffer.h"     // for the arrays
#include "dggParallel.h"   // for ParallelFor
#include "dggTypes.h"      // for Id, Offset, Status

#include <array>   // for Signature
#include <cstdint> // for fixed-width words

namespace dgg
{
/// What a graph was built from.
enum class GraphKind : std::uint8_t
{
  Mesh = 0, ///< a triangle mesh: edges have directions
  Cloud = 1 ///< a point cloud: no directions
};

/// Which rule chose the edges.
enum class GraphConstruction : std::uint8_t
{
  Guaranteed = 0,        ///< progress rule: every path within the accuracy, a theorem
  OneRelay = 1,          ///< published direct rule: nothing bounds the maximum
  Indirect = 2,          ///< published two-step construction, pruned by progress; not proven
  SaddleVertexGraph = 3, ///< a number of nearest neighbours (Ying, Wang and He 2013)
  CloudCurvature = 4,    ///< clouds, scheme A: the reach of a point is the mean of its direct pairs
  CloudConstant = 5,     ///< clouds, scheme B: all points reach equally far
  CloudSpacing = 6       ///< clouds, scheme C: the reach is a multiple of the local spacing
};

/// 128 bits by which a surface is recognised.
using Signature = std::array<std::uint64_t, 2>;

/// Signature of points (x y z each) and triangles (three ids each): of their very bits.
DGG_CORE_EXPORT Signature ComputeSignature(
  const double* points, Offset numberOfPoints, const Id* triangles, Offset numberOfTriangles);

/// What is to be known of a graph besides its arrays.
struct GraphInfo
{
  GraphKind Kind = GraphKind::Mesh;
  GraphConstruction Construction = GraphConstruction::Guaranteed;
  double Accuracy = 0.0;    ///< relative; 0 for a SaddleVertexGraph
  Id NumberOfNeighbors = 0; ///< of a SaddleVertexGraph; else 0
  Signature Surface{ { 0, 0 } };

  /// Whether every distance in the graph is within (1 + Accuracy) of the exact one.
  bool IsGuaranteed() const
  {
    return this->Kind == GraphKind::Mesh && this->Construction == GraphConstruction::Guaranteed;
  }
};

/// A graph in arrays of somebody else. Row v, [Offsets[v], Offsets[v + 1]), holds the edges that
/// leave v, sorted by Angles. Every edge is there in both directions, with the same length. An edge
/// is the length of a real path on the surface: a geodesic without a bend.
struct GraphView
{
  GraphInfo Info;
  Id NumberOfVertices = 0;
  const Offset* Offsets = nullptr; ///< n + 1
  const Id* Targets = nullptr;
  /// Either Lengths (rounded up, so that no path is shorter than the exact one) or WideLengths.
  const float* Lengths = nullptr;
  const double* WideLengths = nullptr;
  /// Direction of departure: polar angle at the tail, in [0, total angle), as
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
  Buffer<double> WideLengths; ///< instead of Lengths when the accuracy is below 1e-5
  Buffer<float> Angles;
  Buffer<float> ArrivalAngles;

  Id GetNumberOfVertices() const
  {
    return this->Offsets.IsEmpty() ? 0 : static_cast<Id>(this->Offsets.Size() - 1);
  }
  GraphView View() const;
  /// Bytes held by the arrays.
  std::size_t GetMemorySize() const;
};

/// Whether lengths have to be double for this accuracy: floats are only good to 1e-7.
inline bool NeedsWideLengths(double accuracy)
{
  return accuracy > 0.0 && accuracy < 1e-5;
}

/// Fails with a message when the arrays are not those of a graph: offsets that do not ascend from
/// 0, targets out of range or equal to their row, lengths that are not positive and finite, angles
/// that are not finite or rows that are not sorted by them. `numberOfEdges` is the size of all
/// arrays but Offsets, which has NumberOfVertices + 1.
DGG_CORE_EXPORT Status CheckGraph(
  const GraphView& graph, Offset numberOfEdges, const ParallelFor& parallel = ParallelFor());

/// Checksum of the arrays: of their very bits. Shows damage that CheckGraph() cannot see.
/// Offsets must be those of a graph.
DGG_CORE_EXPORT std::uint64_t ComputeChecksum(
  const GraphView& graph, const ParallelFor& parallel = ParallelFor());
}

#endif
