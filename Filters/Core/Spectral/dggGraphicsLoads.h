// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What flows in where: the right-hand side of the equation of a drawing. Internal.
#ifndef dggGraphicsLoads_h
#define dggGraphicsLoads_h

#include "dggGraphicsScale.h"   // for scales
#include "dggGraphicsSources.h" // for parts of chains

#include <vector> // for loads

namespace dgg
{
class FaceParts;

/// The sources of regions and of curves.
class GraphicsLoads
{
public:
  /// Find where the sources of curves are on a refinement of a mesh with so many faces. Chain k
  /// belongs to curve k. `checkMemory`, which may be empty, is asked with the bytes that the
  /// faces of regions take, which are more than the surface has where there are many. Fails where a
  /// region's curve is open or does not separate its left from its right.
  Status Prepare(const RefinedSurface& surface, Id numberOfFaces,
    const std::vector<CurveChain>& chains, const std::vector<GraphicsCurve>& curves,
    const GraphicsMemoryCheck& checkMemory, const ProgressCallback& progress);

  /// Add the integrals of all sources against hat functions to columns, one per channel. The
  /// strengths of regions are still to be scaled, those of curves are.
  Status Add(const GraphicsDomain& domain, const std::vector<CurveChain>& chains,
    const std::vector<GraphicsCurve>& curves, const std::vector<GraphicsRegion>& regions,
    const ChannelScale& scale, const ProgressCallback& progress,
    std::vector<std::vector<double>>& columns) const;

  /// In all regions that are curves.
  double GetNumberOfRegionFaces() const { return this->NumberOfRegionFaces; }

private:
  Status FindRegions(const ChainEdges& edges, const std::vector<CurveChain>& chains,
    const std::vector<GraphicsCurve>& curves, const GraphicsMemoryCheck& checkMemory,
    const ProgressCallback& progress);
  double CountWork(const std::vector<GraphicsRegion>& regions, const FaceParts& parts) const;

  Id NumberOfFaces = 0; // of the mesh
  double NumberOfRegionFaces = 0.0;
  std::vector<std::vector<Id>> RegionFaces;       // per curve, where it is a region
  std::vector<std::vector<ChainPart>> ChainParts; // per curve, where it is a source
};
}

#endif
