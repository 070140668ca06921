// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The graph of a surface or a cloud as arrays in field data. Internal.
#ifndef DGGGraphArrays_h
#define DGGGraphArrays_h

#include "vtkDGGFiltersCommonModule.h" // for the export macro
#include "dggGeodesicGraph.h"          // for GeodesicGraph

#include "vtkAbstractArray.h" // for the smart pointers
#include "vtkSmartPointer.h"  // for the arrays
#include "vtkTimeStamp.h"     // for the time
#include "vtkType.h"          // for vtkMTimeType

#include <array>   // for the arrays
#include <cstddef> // for sizes
#include <cstdint> // for the checksum
#include <string>  // for what is wrong
#include <vector>  // for radii and keys

namespace dgg
{
class PreparedSurface;
}
class vtkFieldData;

/// The band around a cloud that its graph was built in: the space within a radius of each point,
/// made of voxels.
struct DGGCloudBand
{
  double VoxelSize = 0.0;
  const double* Radii = nullptr; ///< per point
};

/// Numbers of the graph of the last update, which getters report when its arrays may be gone.
struct DGGGraphSummary
{
  dgg::GraphInfo Info;
  dgg::Id NumberOfVertices = 0;
  dgg::Offset NumberOfEdges = 0;
  std::size_t MemorySize = 0; ///< bytes of the arrays

  DGGGraphSummary() = default;
  explicit DGGGraphSummary(const dgg::GraphView& graph)
    : Info(graph.Info)
    , NumberOfVertices(graph.NumberOfVertices)
    , NumberOfEdges(graph.GetNumberOfEdges())
  {
    const std::size_t perEdge = sizeof(dgg::Id) + (graph.Lengths ? sizeof(float) : sizeof(double)) +
      (graph.Angles ? 2 * sizeof(float) : 0);
    this->MemorySize = static_cast<std::size_t>(this->NumberOfEdges) * perEdge +
      (static_cast<std::size_t>(this->NumberOfVertices) + 1) * sizeof(dgg::Offset);
  }
};

/// Puts a graph of the kernel into field data, without a copy, and finds it there again. What the
/// arrays hold is described in vtkDiscreteGeodesicGraph, and in vtkPointCloudDGG for clouds.
///
/// Nothing that is found is trusted: types, sizes, version, ids, the signature of the surface and a
/// checksum are looked at, once for the same arrays.
class VTKDGGFILTERSCOMMON_EXPORT DGGGraphArrays
{
public:
  /// Make arrays of the memory of `graph`, which is empty afterwards.
  void Adopt(dgg::GeodesicGraph& graph, const dgg::PreparedSurface& mesh);
  /// The same for the graph of a cloud, and of the radii of its band, one per point.
  void Adopt(dgg::GeodesicGraph& graph, const std::vector<double>& radii, double voxelSize,
    const dgg::PreparedSurface& cloud);

  /// Whether field data, which may be null, say that they have the graph of a cloud.
  static bool AreOfCloud(vtkFieldData* data);

  /// Look for a graph of the mesh or cloud in `data`, which may be null. Returns whether there is
  /// one. `complaint` is what is wrong with arrays that are there but are not a graph of the mesh;
  /// it is empty when they were complained about before.
  bool Find(vtkFieldData* data, const dgg::PreparedSurface& mesh, std::string& complaint);

  /// Whether Find() would give the same answer as the last time, without a new look at the arrays.
  /// Otherwise it lets go of the arrays that it knows.
  bool IsSame(vtkFieldData* data, const dgg::PreparedSurface& mesh) const;

  /// Whether there is a graph and its arrays have not been changed since.
  bool IsValid() const;

  /// Add the arrays to field data, in the place of those of an earlier graph.
  void AddTo(vtkFieldData* data) const;

  /// Remove the arrays of any graph from field data.
  static void RemoveFrom(vtkFieldData* data);

  void Clear();

  /// The graph, as long as these arrays live. Only for a valid graph.
  const dgg::GraphView& GetView() const { return this->View; }
  /// The band of a cloud, as long as these arrays live. Only for a valid graph of a cloud.
  const DGGCloudBand& GetBand() const { return this->Band; }
  /// What is damaged in arrays that Find() has refused; empty when they are sound but of another
  /// surface or version.
  const std::string& GetDamage() const { return this->Damage; }
  /// When this graph was adopted or found. It changes with the graph.
  vtkMTimeType GetTime() const { return this->Time.GetMTime(); }

  /// Identity, age and memory of all arrays: it changes with any of them.
  using Key = std::vector<std::uintptr_t>;
  Key GetKey() const;

private:
  enum Role
  {
    Offsets,
    Targets,
    Lengths,
    Angles,
    ArrivalAngles,
    Radii, // of the band of a cloud
    Info,
    NumberOfRoles
  };
  static const std::array<const char*, NumberOfRoles> Names;

  /// Identity and age of an array. Holding it keeps its address from being used again.
  struct Entry
  {
    vtkSmartPointer<vtkAbstractArray> Array;
    vtkMTimeType Time = 0;
    const void* Data = nullptr;
    vtkIdType Size = 0;

    bool operator==(const Entry& other) const;
  };
  using Entries = std::array<Entry, NumberOfRoles>;

  static Entry MakeEntry(vtkAbstractArray* array);
  static Entries MakeEntries(vtkFieldData* data);

  dgg::Status Check(const dgg::PreparedSurface& mesh);
  bool HasRole(Role role) const;
  dgg::Status Damaged(const std::string& what);
  dgg::Status CheckTypes();
  dgg::Status ReadInfo(vtkIdType numberOfPoints, bool isCloud);
  dgg::Status ReadSizes(vtkIdType numberOfPoints);
  dgg::Status CheckSurface(const dgg::PreparedSurface& mesh) const;
  dgg::Status CheckContents();
  dgg::Status CheckBand();
  std::int64_t Seal() const;
  template <typename ValueType>
  const ValueType* GetValues(Role role) const;

  Entries Arrays;
  std::uint64_t Mesh = 0; // build number of the surface that they were compared with
  dgg::GraphView View;
  DGGCloudBand Band;
  std::string Damage;
  bool IsGraph = false;
  vtkTimeStamp Time;
};

#endif
