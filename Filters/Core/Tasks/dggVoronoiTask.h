// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Voronoi cells of sites, which may be moved to the centers of their cells, as outputs. Internal.
#ifndef dggVoronoiTask_h
#define dggVoronoiTask_h

#include "dggCentroidal.h"     // for CentroidalOptions
#include "dggCoreExport.h"     // for DGG_CORE_EXPORT
#include "dggGeodesicSource.h" // for GeodesicSource
#include "dggVoronoi.h"        // for VoronoiDiagram

#include <cstddef> // for std::size_t
#include <string>  // for names
#include <vector>  // for sites

namespace dgg
{
class GraphSession;
class PropagationSession;
struct Output;
struct TaskContext;

struct DGG_CORE_EXPORT VoronoiOptions
{
  /// Fails if an option is out of range, if options exclude each other, or if the name of an array
  /// is empty or used twice.
  Status Check() const;

  bool IsCentroidal = false; ///< move the sites first
  bool IsRefined = false;    ///< refine borders
  bool LabelsOnly = false;   ///< make neither cells nor borders; always so on clouds
  bool IsPreview = false;    ///< FindVoronoiPreview() is used, which makes labels only
  CentroidalOptions Moving;
  ///@{
  /// Names of point arrays.
  std::string DistanceName;
  std::string SourceName;
  ///@}
  double UnreachedValue = 0.0; ///< distance of unreached points
};

struct VoronoiResult
{
  std::vector<GeodesicSource> Sites;
  VoronoiDiagram Diagram;
  std::vector<double> Energies; ///< one per iteration; empty unless sites are moved
  std::string QualityWarning;   ///< reasons why cells may be wrong
};

/// Computes the diagram of the sites in `result`, and moves the sites if requested. `graph` must be
/// up to date.
DGG_CORE_EXPORT Status FindVoronoiCells(const TaskContext& context, GraphSession& graph,
  const VoronoiOptions& options, VoronoiResult& result);

/// Returns the area of the cell of each site, and at the end the unreached area.
std::vector<double> SumCellAreas(const VoronoiDiagram& diagram, std::size_t numberOfSites);

/// Computes the labels of the sites in `result` without a graph.
DGG_CORE_EXPORT Status FindVoronoiPreview(
  const TaskContext& context, PropagationSession& session, VoronoiResult& result);

/// Returns the nearest site of each point of the input; NoId if unreached.
DGG_CORE_EXPORT std::vector<Id> GetNearestSites(
  const TaskContext& context, const VoronoiResult& result);

/// Writes the diagram to four outputs:
/// - `surface`: point arrays of distances (with marks of unreached points) and nearest sites, and
///   the field array `Energy`, for the points of the input;
/// - `borders`: lines with the cell array `SiteId` (two sites) and the point array of distances;
/// - `cells`: polygons with the cell arrays `SiteId`, `CellArea` and `FaceId` and the point
///   array of distances;
/// - `sites`: points with the arrays `SiteId` and, unless there are only labels, `CellArea`.
DGG_CORE_EXPORT void WriteVoronoi(const TaskContext& context, const VoronoiOptions& options,
  const VoronoiResult& result, Output& surface, Output& borders, Output& cells, Output& sites);

/// Writes the borders and cells of a piece of the surface; cells have only the vertices that they
/// use. `areas` are those of all pieces (SumCellAreas()). If `areOthersUnreached`, points of other
/// pieces are unreached.
void WriteVoronoiPiece(const TaskContext& context, const VoronoiOptions& options,
  const VoronoiResult& result, const std::vector<double>& areas, bool areOthersUnreached,
  Output& borders, Output& cells);

/// Add the array `SiteId` to the points of all sites, and `CellArea`.
void AddSiteIds(Output& sites);
void AddCellAreas(const std::vector<double>& areas, Output& sites);
}

#endif
