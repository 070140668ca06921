// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What flows in where: the right-hand side of the equation of a drawing. Internal.
#ifndef dggGraphicsLoads_h
#define dggGraphicsLoads_h

#include "dggGraphicsScale.h"   // for scales
#include "dggGraphicsSources.h" // for parts of chains

#include <cstddef> // for std::size_t
#include <vector>  // for loads

namespace dgg
{
class FaceParts;

/// The sources of regions and of curves.
class GraphicsLoads
{
public:
  /// Find where the sources of curves are on a refinement of a mesh with so many faces. Chain k
  /// belongs to curve k. `checkMemory`, which may be empty, is asked with the bytes that this
  /// takes. Fails where a region's curve is open or does not separate its left from its right.
  Status Prepare(const RefinedSurface& surface, Id numberOfFaces,
    const std::vector<CurveChain>& chains, const std::vector<GraphicsCurve>& curves,
    const GraphicsMemoryCheck& checkMemory, const ProgressCallback& progress);

  /// Add the integrals of all sources against hat functions to columns, one per channel. The
  /// strengths of regions are still to be scaled, those of curves are.
  Status Add(const GraphicsDomain& domain, const std::vector<CurveChain>& chains,
    const std::vector<GraphicsCurve>& curves, const std::vector<GraphicsRegion>& regions,
    const ChannelScale& scale, const ProgressCallback& progress,
    std::vector<std::vector<double>>& columns) const;

  /// Bytes that Add() takes besides.
  double GetAddingMemory(const GraphicsDomain& domain) const;
  /// Bytes that the sources of curves take; those of regions are asked for when they are found.
  static double PredictMemory(
    const std::vector<CurveChain>& chains, const std::vector<GraphicsCurve>& curves);
  /// Bytes held.
  std::size_t GetMemorySize() const;

private:
  Status FindRegions(const ChainEdges& edges, const std::vector<CurveChain>& chains,
    const std::vector<GraphicsCurve>& curves, const GraphicsMemoryCheck& checkMemory,
    const ProgressCallback& progress);
  double CountWork(const std::vector<GraphicsRegion>& regions, const FaceParts& parts) const;

  Id NumberOfFaces = 0;                           // of the mesh
  std::vector<std::vector<Id>> RegionFaces;       // per curve, where it is a region
  std::vector<std::vector<ChainPart>> ChainParts; // per curve, where it is a source
};
}

#endif
