// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Graph of a surface or a cloud as arrays in field data. Internal.
#ifndef DGGGraphArrays_h
#define DGGGraphArrays_h

#include "vtkDGGFiltersCommonModule.h" // for the export macro
#include "dggStoredGraph.h"            // for StoredGraph
#include "dggTaskContext.h"            // for the surface and the threads

#include "vtkAbstractArray.h" // for the smart pointers
#include "vtkSmartPointer.h"  // for the arrays
#include "vtkTimeStamp.h"     // for the time
#include "vtkType.h"          // for vtkMTimeType

#include <array>   // for the arrays
#include <cstdint> // for keys
#include <string>  // for messages
#include <vector>  // for radii and keys

class vtkFieldData;
namespace dgg
{
struct PieceGraph;
}

/// Stores a graph of the kernel in field data without a copy, and finds it there. The same arrays
/// are read and checked only once.
class VTKDGGFILTERSCOMMON_EXPORT DGGGraphArrays
{
public:
  /// Creates arrays from the memory of `graph`, which is empty afterwards.
  void Adopt(dgg::GeodesicGraph& graph, const dgg::TaskContext& context);
  /// Creates arrays from the graph of a cloud; `radii` are the radii of its band, one per point.
  void Adopt(dgg::GeodesicGraph& graph, const std::vector<double>& radii, double voxelSize,
    const dgg::TaskContext& context);
  /// Creates arrays from the graph of a piece, which is empty afterwards.
  void Adopt(dgg::PieceGraph& graph, const dgg::TaskContext& context);

  /// Returns true if field data, which may be null, contain the graph of a cloud.
  static bool AreOfCloud(vtkFieldData* data);
  ///@{
  /// Returns true if field data contain the graph of a piece, or the graph of an entire surface.
  static bool AreOfPiece(vtkFieldData* data);
  static bool AreOfEntireSurface(vtkFieldData* data);
  ///@}

  /// Finds the graph of the mesh or cloud in `data`, which may be null. Returns true if there is
  /// one. `complaint` is the reason why existing arrays are not a graph of the mesh; it is empty if
  /// the same arrays were rejected before.
  bool Find(vtkFieldData* data, const dgg::TaskContext& context, std::string& complaint);

  /// Finds the graph of a piece with this number of points in the same manner. Its signature is not
  /// compared.
  bool FindPiece(vtkFieldData* data, vtkIdType numberOfPoints, const dgg::ParallelFor& parallel,
    std::string& complaint);

  /// Returns true if Find() would return the same result as the last time. Does not read the
  /// arrays.
  bool IsSame(vtkFieldData* data, const dgg::PreparedSurface& mesh) const;

  /// Returns true if there is a graph and its arrays have not changed since Find() or Adopt().
  bool IsValid() const;

  /// Adds the arrays to field data; they replace the arrays of an earlier graph.
  void AddTo(vtkFieldData* data) const;

  /// Returns true if the arrays are in field data.
  bool IsIn(vtkFieldData* data) const { return this->IsGraph && this->Arrays == MakeEntries(data); }

  /// Adds the arrays of any graph in field data to other field data.
  static void Pass(vtkFieldData* from, vtkFieldData* to);

  /// Removes the arrays of any graph from field data.
  static void RemoveFrom(vtkFieldData* data);

  void Clear();

  ///@{
  /// Returns the graph, valid as long as this object exists. Precondition: IsValid().
  const dgg::StoredGraph& GetGraph() const { return this->Graph; }
  const dgg::GraphView& GetView() const { return this->Graph.GetView(); }
  ///@}
  /// Returns the defect of arrays that Find() rejected as damaged; empty for other arrays.
  const std::string& GetDamage() const { return this->Graph.GetDamage(); }
  /// Returns the time at which this graph was adopted or found; changes with the graph.
  vtkMTimeType GetTime() const { return this->Time.GetMTime(); }

  /// Identity, modification time and memory of all arrays; changes if any of them changes.
  using Key = std::vector<std::uintptr_t>;
  Key GetKey() const;

private:
  /// Identity and modification time of an array. The reference prevents reuse of the address.
  struct Entry
  {
    vtkSmartPointer<vtkAbstractArray> Array;
    vtkMTimeType Time = 0;
    const void* Data = nullptr;
    vtkIdType Size = 0;

    bool operator==(const Entry& other) const;
  };
  using Entries = std::array<Entry, dgg::StoredGraph::NumberOfRoles>;

  void AdoptArrays(
    dgg::PieceGraph& piece, dgg::Buffer<double>& radii, const dgg::TaskContext& context);
  static dgg::StoredGraph::Arrays ViewArrays(const Entries& entries);
  static Entry MakeEntry(vtkAbstractArray* array);
  static Entries MakeEntries(vtkFieldData* data);

  Entries Arrays;
  std::uint64_t Mesh = 0; // build number of the surface that the arrays were compared with
  dgg::StoredGraph Graph;
  bool IsGraph = false;
  vtkTimeStamp Time;
};

#endif
