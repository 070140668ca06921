// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A piece of a surface as the surface of tasks. Internal.
#ifndef dggPieceSurface_h
#define dggPieceSurface_h

#include "dggCoreExport.h"      // for DGG_CORE_EXPORT
#include "dggDistanceField.h"   // for the connection to other processes
#include "dggGraphBuilder.h"    // for links
#include "dggPieceLocator.h"    // for positions
#include "dggPreparedSurface.h" // for the surface
#include "dggProcessGroup.h"    // for messages
#include "dggSurfaceRegion.h"   // for the region

#include <cstdint>    // for flags
#include <functional> // for conditions
#include <memory>     // for the builder
#include <vector>     // for values

namespace dgg
{
struct Output;
struct TaskContext;

/// The piece of this process, with layers of cells of other processes around it, as an input of
/// tasks that compute in each cell. Points and cells are numbered in the order of global ids. All
/// functions with a group must be called by all processes.
class DGG_CORE_EXPORT PieceSurface
{
public:
  /// Prepares the surface, with three layers of cells. Isolines on an edge depend on all cells at
  /// the corners of the faces of the edge, and bands of the piece depend on the isolines in the
  /// first layer. `isUsable` becomes false on all processes if the pieces must be gathered: for the
  /// reasons of BuildPieceGraph(), if an edge has more than two faces, if ids are not consecutive,
  /// if there are other cells than polygons, and if a process has points but no cells.
  Status Prepare(ProcessGroup& group, const SurfacePiece& piece, bool& isUsable);

  /// Adds layers of cells. `inUse` are the bytes that this process uses besides the surface.
  Status Grow(ProcessGroup& group, int layers, double inUse);
  /// Returns a builder that links points of the surface; null without faces.
  const GraphBuilder* GetBuilder();

  ///@{
  /// PrepareToGather() prepares GatherNear(), which replaces the surface of the first process by
  /// all cells at points for which `isNear(position)` is true. The condition must be the same on
  /// all processes, and no smaller than that of the last call. Other processes have no surface.
  Status PrepareToGather(ProcessGroup& group, const SurfacePiece& piece, bool& isUsable);
  Status GatherNear(
    ProcessGroup& group, const std::function<bool(const double*)>& isNear, double inUse);
  /// Returns 1 per vertex some of whose cells are not on the surface, otherwise 0.
  const std::vector<std::uint8_t>& GetRim() const { return this->Polygons.IsRim; }
  ///@}

  const PreparedSurface& Get() const { return *this->Surface; }
  Offset GetNumberOfPoints() const { return this->Arrays.NumberOfPoints; }
  const double* GetPosition(Offset point) const { return this->Arrays.Points + 3 * point; }
  /// Returns the context of a task on this surface, which must outlive the context.
  TaskContext MakeContext(const TaskContext& context) const;
  /// Returns the layer of each face around the piece; 0 in the piece. See DistanceField::Layers.
  const std::vector<std::uint8_t>& GetLayers() const { return this->Layers; }
  /// Returns the number of layers around the piece.
  int GetNumberOfLayers() const { return this->NumberOfLayers; }
  /// Returns the process of a face.
  int GetOwner(Id face) const { return this->Polygons.Owners[this->Surface->GetCell(face)]; }
  /// Returns the numbers of points and faces of the entire surface.
  Offset GetTotalPoints() const { return this->TotalPoints; }
  Offset GetTotalFaces() const { return this->TotalFaces; }
  /// Returns true if the triangles of the entire surface may be too long for a field.
  bool HasLongTriangles() const { return this->HasLong; }
  /// Returns the mean edge length of the entire surface.
  double GetMeanEdgeLength() const { return this->MeanEdgeLength; }
  /// Returns the connection of a field on this surface to those of other processes. This surface
  /// must outlive the connection.
  FieldPieces MakeFieldPieces(ProcessGroup& group) const;

  /// Replaces the values of points of the piece, `components` each, by those of all points of the
  /// surface.
  Status Extend(ProcessGroup& group, int components, std::vector<double>& values) const;
  /// Extends lists in the same manner, and calls `use(begin, end)` for the list of each vertex.
  template <typename Value, typename Use>
  Status ExtendLists(
    ProcessGroup& group, ValueLists<Value>& lists, double inUse, const Use& use) const
  {
    DGG_RETURN_IF_ERROR(this->Region.TakeListsFromOwners(group, lists, inUse));
    for (const Id point : this->Polygons.Points)
    {
      use(lists.Begin(point), lists.End(point));
    }
    return Status::Success();
  }
  /// Gets the points of all processes, by their indices. Points outside of this surface have
  /// neither a vertex nor a face.
  Status ShareAll(
    ProcessGroup& group, const PiecePoints& here, std::vector<SurfacePoint>& points) const;
  /// Locates the points of a collection that belong to this process: ids, followed by positions
  /// (PieceLocator::Locate()).
  Status Locate(ProcessGroup& group, const SourceCollection& sources, double tolerance,
    PiecePoints& here) const;
  /// Adds a point of the entire surface, given by its index, if the point belongs to this
  /// process.
  void AddVertex(Offset point, std::size_t index, int process, PiecePoints& here) const;
  /// Returns the vertex at a point with a global id; NoId if the point is not on the surface.
  Id FindVertex(Offset globalId) const;
  /// Returns the vertex at a point of the entire surface, given by its index, or NoId.
  Id GetVertexOf(Offset point) const { return this->FindVertex(this->FirstPoint + point); }
  /// Returns values of the points of the piece, given those of the vertices of this surface; `none`
  /// at points without cells.
  template <typename Value>
  std::vector<Value> ToPiece(
    const std::vector<Value>& values, Offset numberOfPoints, Value none) const
  {
    std::vector<Value> ofPiece(static_cast<std::size_t>(numberOfPoints), none);
    for (std::size_t v = 0; v < values.size(); ++v)
    {
      const Id point = this->Polygons.Points[v];
      if (point < numberOfPoints)
      {
        ofPiece[point] = values[v];
      }
    }
    return ofPiece;
  }
  /// Writes the points of all processes to the output of the first one, like WriteSurfacePoints()
  /// on the entire surface.
  Status WritePoints(
    const TaskContext& context, ProcessGroup& group, const PiecePoints& here, Output& output) const;
  /// Replaces the points and cells in the arrays `vtkOriginalPointIds` and `FaceId` of an output by
  /// their indices on the entire surface.
  void Renumber(Output& output) const;

private:
  Status Start(ProcessGroup& group, const SurfacePiece& piece, int layers, bool& isUsable);
  void MakeArrays(const std::function<bool(const double*)>& isNear = {});
  Status MakeSurface();
  Status CheckFaces(ProcessGroup& group, bool& isUsable);
  Status CheckIds(ProcessGroup& group, const SurfacePiece& piece, bool& isUsable);
  Id FindFace(Offset cellId) const;

  SurfaceRegion Region;
  RegionPolygons Polygons;
  SurfaceArrays Arrays; // of Polygons
  PreparedSurface::Pointer Surface;
  std::unique_ptr<const GraphBuilder> Builder; // null until needed
  std::vector<std::uint8_t> Layers;
  int NumberOfLayers = 0;
  bool HasLong = false; // triangles that may be too long for a field
  double MeanEdgeLength = 0.0;
  double LongestEdge = 0.0;
  Offset TotalPoints = 0;
  Offset TotalFaces = 0;
  Offset FirstPoint = 0; // smallest global ids
  Offset FirstCell = 0;
};
}

#endif
