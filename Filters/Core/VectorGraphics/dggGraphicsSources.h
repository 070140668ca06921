// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Color sources in regions and along curves. Internal.
#ifndef dggGraphicsSources_h
#define dggGraphicsSources_h

#include "dggGraphicsDomain.h" // for the surface
#include "dggPathEdges.h"      // for PathEdges

#include <cstddef> // for std::size_t
#include <cstdint> // for flags
#include <vector>  // for loads

namespace dgg
{
/// Finds the faces on the left of closed curves. The cost of a curve is proportional to its number
/// of edges and faces.
class LeftFaces
{
public:
  /// The edges and their surface must outlive the object.
  explicit LeftFaces(const PathEdges& edges);

  /// Fails if the curve is open, runs along edges without two sides, or does not separate its left
  /// from its right.
  Status Find(const CurveChain& chain, bool isClosed, std::vector<Id>& faces);

private:
  /// The half-edges of a chain on its left and on its right.
  struct ChainSides
  {
    std::vector<Id> Left;
    std::vector<Id> Right;
  };

  Status FindSides(const CurveChain& chain, ChainSides& sides) const;
  Status Spread(const ChainSides& sides, std::vector<Id>& faces);

  const PathEdges& Edges;
  const SubMesh& Surface;
  std::vector<char> IsFound; // per face; all 0 between calls
  std::vector<char> IsWall;  // per half-edge; all 0 between calls
};

/// Adds the sources of regions, see GraphicsRegion. The cost of a region is proportional to its
/// number of faces.
class RegionSources
{
public:
  RegionSources(const SurfaceMesh& mesh, const SubMesh& surface);

  /// Adds the integrals of the sources of a region against hat functions. Faces belong to the
  /// surface and may repeat. Loads are per vertex, one array per channel; the loads of a patch with
  /// a boundary sum to 0 up to rounding.
  void Add(const std::vector<Id>& faces, const std::vector<double>& strength,
    std::vector<std::vector<double>>& loads);

private:
  enum class State : std::uint8_t
  {
    Outside,
    Waiting, ///< in the region
    Found    ///< in one of its patches
  };

  void FindPatch(Id face);
  void FindRim();
  void AddPatch(const std::vector<double>& strength, std::vector<std::vector<double>>& loads) const;
  double GetArea(Id face) const;

  const SurfaceMesh& Mesh;
  const SubMesh& Surface;
  std::vector<State> States; // per face
  std::vector<Id> Patch;     // faces
  std::vector<Id> Rim;       // half-edges, one per edge
};

/// A half-edge of a chain, which receives a share of the flux along its edge.
struct ChainPart
{
  std::size_t Edge = 0; ///< index of the edge in the chain
  Id HalfEdge = NoId;
  bool IsBackward = false; ///< true if directed opposite to the chain
  double Length = 0.0;     ///< length of the edge divided by its number of faces
};

/// Returns the parts of a chain.
std::vector<ChainPart> SplitChain(const PathEdges& edges, const CurveChain& chain);

/// Adds the integrals of a flux per length along a curve, piecewise linear, against hat functions.
/// `parts` is the result of SplitChain(). The flux into a face is assigned to its own corners:
/// where the surface is cut at a vertex of the curve, to the copy of this face.
void AddLineSource(const SubMesh& surface, const CurveChain& chain,
  const std::vector<ChainPart>& parts, const GraphicsCurve& curve,
  std::vector<std::vector<double>>& loads);

/// The sources of regions and of curves.
class GraphicsLoads
{
public:
  /// Locates the sources of curves on a refinement of a mesh with `numberOfFaces` faces. Chain k
  /// belongs to curve k. `checkMemory`, which may be empty, is called with the bytes that the faces
  /// of regions take, which may exceed the size of the surface if there are many regions. Fails if
  /// a region's curve is open or does not separate its left from its right.
  Status Prepare(const SubMesh& surface, Id numberOfFaces, const std::vector<CurveChain>& chains,
    const std::vector<GraphicsCurve>& curves, const GraphicsMemoryCheck& checkMemory,
    const ProgressCallback& progress);

  /// Adds the integrals of all sources against hat functions to columns, one per channel.
  /// `strengths` are per region.
  Status Add(const GraphicsDomain& domain, const std::vector<CurveChain>& chains,
    const std::vector<GraphicsCurve>& curves, const std::vector<GraphicsRegion>& regions,
    const std::vector<std::vector<double>>& strengths, const ProgressCallback& progress,
    std::vector<std::vector<double>>& columns) const;

  /// Returns the approximate memory in bytes.
  double GetMemorySize() const;

private:
  Status FindRegions(const PathEdges& edges, const std::vector<CurveChain>& chains,
    const std::vector<GraphicsCurve>& curves, const GraphicsMemoryCheck& checkMemory,
    const ProgressCallback& progress);

  Id NumberOfFaces = 0;                           // number of faces of the mesh
  std::vector<std::vector<Id>> RegionFaces;       // per curve, if it is a region
  std::vector<std::vector<ChainPart>> ChainParts; // per curve, if it is a source
};
}

#endif
