// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A piece of a surface with layers of cells of other processes around it. Internal.
#ifndef dggSurfaceRegion_h
#define dggSurfaceRegion_h

#include "dggCoreExport.h"    // for DGG_CORE_EXPORT
#include "dggGroups.h"        // for the cells of points
#include "dggMeshReport.h"    // for defects
#include "dggProcessGroup.h"  // for messages
#include "dggSurfaceMesh.h"   // for the mesh
#include "dggSurfacePieces.h" // for the piece

#include <cstdint>       // for flags
#include <functional>    // for conditions
#include <map>           // for sets of processes
#include <unordered_map> // for ids
#include <utility>       // for std::move
#include <vector>        // for points and cells

namespace dgg
{
/// Properties of the surface that all pieces form. They do not depend on the division.
struct DGG_CORE_EXPORT SurfaceFacts
{
  bool IsRegular = true; ///< no degenerate face, and the same orientation everywhere
  SurfaceDefects Defects;
  Offset NumberOfFaces = 0;
  double LongestEdge = 0.0;
  double ShortestEdge = Infinity;
  /// Smallest difference between the sum of two edges of a face and the third edge.
  double SmallestSlack = Infinity;

  /// Replaces the facts of the region of each process by those of the surface.
  Status Share(ProcessGroup& group);
};

/// Mesh of a region; its vertices and faces are in the order of global ids.
struct RegionMesh
{
  bool IsValid = true; ///< false if the mesh could not be made
  SurfaceMesh Mesh;
  std::vector<Id> Points;          ///< of the region, per vertex
  std::vector<double> Positions;   ///< x y z per vertex
  std::vector<std::uint8_t> IsRim; ///< see SurfaceMesh::FromPoints()
  std::vector<Offset> CellIds;     ///< per face, the global id of a cell of the piece, or NoId
  Offset OwnFaces = 0;             ///< number of faces of the piece
  Offset DroppedCells = 0;         ///< of the piece; see SurfaceDefects
  Offset Fans = 0;                 ///< of the piece
};

/// Polygons of a region, in the order of global ids. Points are those of the mesh of the region.
struct RegionPolygons
{
  std::vector<Id> Points;        ///< of the region, per point
  std::vector<double> Positions; ///< x y z per point
  std::vector<Offset> Offsets;
  std::vector<Offset> Corners;
  std::vector<Offset> CellIds;      ///< global
  std::vector<int> Owners;          ///< per polygon, its process
  std::vector<std::uint8_t> Layers; ///< per polygon, its layer around the piece; 0 for the piece
  std::vector<std::uint8_t> IsRim;  ///< per point, 1 if some of its cells are missing
};

/// The piece of a surface that this process has, and cells of other processes around it. A point
/// that several pieces use belongs to one of their processes, which its id selects, so that the
/// points of interlaced pieces are distributed evenly.
class DGG_CORE_EXPORT SurfaceRegion
{
public:
  /// Starts with a piece without ghosts. `isUsable` becomes false on all processes if the pieces
  /// must be gathered: if a global id is missing or occurs twice, if the copies of a point differ,
  /// or if a piece has strips or is not valid.
  Status Start(ProcessGroup& group, const SurfacePiece& piece, bool& isUsable);

  /// Adds layers of cells. Processes that need none only send theirs. `inUse` are the bytes that
  /// this process uses besides the region.
  Status Grow(ProcessGroup& group, int layers, bool isNeeded, double inUse);

  /// Adds the cells of all processes at points for which `isNear(position)` is true to the region
  /// of the first process. The condition must be the same on all processes. `inUse` as in Grow().
  Status GrowFirst(
    ProcessGroup& group, const std::function<bool(const double*)>& isNear, double inUse);

  /// Makes the mesh of the region.
  void MakeMesh(RegionMesh& region) const;
  /// Returns the facts of the mesh of the region, with the number of faces of the piece and the
  /// defects at points that belong to this process.
  SurfaceFacts MeasureFacts(const RegionMesh& region) const;

  /// Returns the polygons of the region, or those at points for which `isNear(position)` is true.
  RegionPolygons MakePolygons(const std::function<bool(const double*)>& isNear = {}) const;

  /// Returns the size in bytes.
  double GetMemorySize() const;

  ///@{
  /// Points of the region; those of the piece come first.
  Id GetNumberOfPoints() const { return static_cast<Id>(this->PointIds.size()); }
  Offset GetPointId(Id point) const { return this->PointIds[point]; }
  int GetOwner(Id point) const
  {
    const std::vector<int>& holders = this->GetHolders(point);
    return holders[static_cast<std::uint64_t>(this->PointIds[point]) % holders.size()];
  }
  ///@}
  /// Returns the point with a global id, which must exist.
  Id GetPoint(Offset globalId) const { return this->Points.at(globalId); }
  /// Replaces the values of points that belong to other processes by the values there. `values` has
  /// `components` numbers per point of the region; those of the piece are known. `inUse` as in
  /// Grow().
  Status TakeFromOwners(
    ProcessGroup& group, int components, std::vector<double>& values, double inUse) const;
  /// Replaces lists, one per point of the piece, by those of all points of the region; lists of
  /// points that belong to other processes are taken from there.
  template <typename Value>
  Status TakeListsFromOwners(ProcessGroup& group, ValueLists<Value>& lists, double inUse) const;
  /// Returns the point with a global id. Adds a point without cells if there is none, after which
  /// the region must not grow.
  Id AddVertex(Offset globalId, int owner);
  /// Returns the points of the region in the order of the vertices of the mesh.
  std::vector<Id> GetOrder() const;

private:
  struct Cell
  {
    Offset GlobalId;
    std::size_t Begin; // into Corners
    std::size_t Size;
    int Owner;
  };

  Status RequestFromOwners(ProcessGroup& group, std::vector<std::vector<Id>>& points,
    std::vector<std::vector<Offset>>& requested, double inUse) const;
  bool AddPiece(const SurfacePiece& piece);
  Status FindHolders(ProcessGroup& group, bool& isUnique);
  Id AddPoint(Offset globalId, const double* position, Id holders);
  Id GetSet(const std::vector<int>& holders);
  const std::vector<int>& GetHolders(Id point) const { return this->Sets[this->Holders[point]]; }
  std::vector<std::size_t> GetOrderOfCells() const;
  void AddToRim(Id point);
  void Answer(std::size_t process, const std::vector<Offset>& requested, Message& answer);
  void AddCells(const std::vector<Message>& messages);

  int Here = 0; // this process
  std::vector<Offset> PointIds;
  std::vector<double> Positions;
  std::vector<Id> Holders; // per point, the set of processes that have it
  ///@{
  // Sets of processes, each sorted, and their indices.
  std::vector<std::vector<int>> Sets;
  std::map<std::vector<int>, Id> IndexOfSet;
  ///@}
  std::vector<Id> Rim;                   // points some of whose cells are missing
  std::unordered_map<Offset, Id> Points; // by global id
  std::vector<Cell> Cells;
  std::vector<Id> Corners;
  std::size_t NumberOfOwnCells = 0;
  std::vector<std::size_t> LayerBegins;       // first cell of each layer around the piece
  Groups CellsOfPoints;                       // of the piece
  std::vector<std::vector<bool>> IsSent;      // per process and cell of the piece
  std::vector<std::vector<bool>> IsPointSent; // per process and point of the piece
};

template <typename Value>
Status SurfaceRegion::TakeListsFromOwners(
  ProcessGroup& group, ValueLists<Value>& lists, double inUse) const
{
  std::vector<std::vector<Id>> points;
  std::vector<std::vector<Offset>> ids;
  inUse += static_cast<double>(lists.Values.size() * sizeof(Value));
  DGG_RETURN_IF_ERROR(this->RequestFromOwners(group, points, ids, inUse));
  inUse += this->GetMemorySize();
  std::vector<Message> messages(ids.size());
  std::vector<ValueLists<Value>> sent(ids.size());
  for (std::size_t process = 0; process < ids.size(); ++process)
  {
    for (const Offset id : ids[process])
    {
      const Id point = this->GetPoint(id);
      sent[process].Add(lists.Begin(point), lists.End(point));
    }
    Append(messages[process], sent[process].Begins);
    Append(messages[process], sent[process].Values);
    sent[process] = ValueLists<Value>();
  }
  DGG_RETURN_IF_ERROR(group.Exchange(messages, inUse));
  for (std::size_t process = 0; process < ids.size(); ++process)
  {
    MessageReader reader(messages[process]);
    sent[process].Begins = reader.Take<Offset>();
    sent[process].Values = reader.Take<Value>();
    messages[process] = Message();
  }
  ValueLists<Value> all;
  std::vector<Offset> next(ids.size(), 0);
  for (Id point = 0; point < this->GetNumberOfPoints(); ++point)
  {
    const int owner = this->GetOwner(point);
    const bool isHere = owner == this->Here;
    const ValueLists<Value>& from = isHere ? lists : sent[owner];
    const Offset i = isHere ? point : next[owner]++;
    all.Add(from.Begin(i), from.End(i));
  }
  lists = std::move(all);
  return Status::Success();
}
}

#endif
