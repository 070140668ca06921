// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The graph of a surface or a cloud as arrays in field data. Internal.
#ifndef DGGGraphArrays_h
#define DGGGraphArrays_h

#include "vtkDGGFiltersCommonModule.h" // for the export macro
#include "dggStoredGraph.h"            // for StoredGraph

#include "vtkAbstractArray.h" // for the smart pointers
#include "vtkSmartPointer.h"  // for the arrays
#include "vtkTimeStamp.h"     // for the time
#include "vtkType.h"          // for vtkMTimeType

#include <array>   // for the arrays
#include <cstdint> // for keys
#include <string>  // for messages
#include <vector>  // for radii and keys

class vtkFieldData;

/// Puts a graph of the kernel into field data, without a copy, and finds it there again. The same
/// arrays are read and checked once.
class VTKDGGFILTERSCOMMON_EXPORT DGGGraphArrays
{
public:
  /// Makes arrays of the memory of `graph`, which is empty afterwards.
  void Adopt(dgg::GeodesicGraph& graph, const dgg::PreparedSurface& mesh);
  /// The same for the graph of a cloud, and the radii of its band, one per point.
  void Adopt(dgg::GeodesicGraph& graph, const std::vector<double>& radii, double voxelSize,
    const dgg::PreparedSurface& cloud);

  /// Returns true if field data, which may be null, contain the graph of a cloud.
  static bool AreOfCloud(vtkFieldData* data);

  /// Finds a graph of the mesh or cloud in `data`, which may be null. Returns true if there is one.
  /// `complaint` says why arrays that are present are not a graph of the mesh. It is empty if the
  /// same arrays were complained about before.
  bool Find(vtkFieldData* data, const dgg::PreparedSurface& mesh, std::string& complaint);

  /// Returns true if Find() would give the same answer as the last time, without reading the
  /// arrays.
  bool IsSame(vtkFieldData* data, const dgg::PreparedSurface& mesh) const;

  /// Returns true if there is a graph and its arrays have not been changed since.
  bool IsValid() const;

  /// Adds the arrays to field data, in place of those of an earlier graph.
  void AddTo(vtkFieldData* data) const;

  /// Removes the arrays of any graph from field data.
  static void RemoveFrom(vtkFieldData* data);

  void Clear();

  ///@{
  /// The graph, as long as these arrays live. Only for a valid graph.
  const dgg::StoredGraph& GetGraph() const { return this->Graph; }
  const dgg::GraphView& GetView() const { return this->Graph.GetView(); }
  ///@}
  /// Returns the defect of arrays that Find() has refused as damaged; empty for others.
  const std::string& GetDamage() const { return this->Graph.GetDamage(); }
  /// Time at which this graph was adopted or found. It changes with the graph.
  vtkMTimeType GetTime() const { return this->Time.GetMTime(); }

  /// Identity, age and memory of all arrays: it changes with any of them.
  using Key = std::vector<std::uintptr_t>;
  Key GetKey() const;

private:
  /// Identity and age of an array. Holding it keeps its address from being used again.
  struct Entry
  {
    vtkSmartPointer<vtkAbstractArray> Array;
    vtkMTimeType Time = 0;
    const void* Data = nullptr;
    vtkIdType Size = 0;

    bool operator==(const Entry& other) const;
  };
  using Entries = std::array<Entry, dgg::StoredGraph::NumberOfRoles>;

  static Entry MakeEntry(vtkAbstractArray* array);
  static Entries MakeEntries(vtkFieldData* data);

  Entries Arrays;
  std::uint64_t Mesh = 0; // build number of the surface that they were compared with
  dgg::StoredGraph Graph;
  bool IsGraph = false;
  vtkTimeStamp Time;
};

#endif
