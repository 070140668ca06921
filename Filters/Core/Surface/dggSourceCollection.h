// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// From ids and positions to points of a surface or a cloud. Internal.
#ifndef dggSourceCollection_h
#define dggSourceCollection_h

#include "dggGeodesicSource.h"  // for GeodesicSource
#include "dggPreparedSurface.h" // for SurfaceArrays

#include <array>  // for positions
#include <string> // for messages
#include <vector> // for the arrays

namespace dgg
{
class CellCoordinates;
struct TaskContext;

/// Points that a task starts from or evaluates at: point ids of the input, then positions of a
/// second input. Optional arrays identify the points of positions where several layers of the
/// surface coincide, in this order:
///  - `Cells` and `Barycentric` together: a triangle of the input and coordinates with respect to
///    its corners. The position is ignored;
///  - `OriginalIds`: a point of the input, if the position is that of the point.
/// If all three are present, the first two count only if they are at the position: they may belong
/// to another surface. Other positions are moved to the closest point of the surface.
struct DGG_CORE_EXPORT SourceCollection
{
  /// Usual tolerance of Locate().
  static constexpr double DefaultTolerance = 0.01;

  ///@{
  /// Wording of messages.
  std::string Role;              ///< name of a point, such as "source"
  std::string Property;          ///< property of ids; empty if there is none
  std::string Input;             ///< input of the positions; empty if Property has them, too
  std::string Surface = "input"; ///< name of the surface, if there are several
  bool ArePairs = false;         ///< true if points are starts and ends of pairs in turn
  std::vector<Offset> Indices;   ///< per position, its index in the input; empty for 0, 1, 2 ...
  ///@}

  std::vector<Offset> Ids;
  std::vector<double> InitialDistancesOfIds; ///< empty for zeros

  bool IsConnected = false;             ///< true if there is an input of positions
  bool AreRounded = false;              ///< true if positions were stored in single precision
  std::vector<double> Positions;        ///< x y z each
  std::vector<double> InitialDistances; ///< per position; empty for zeros
  ///@{
  /// Per position; may be empty.
  std::vector<double> OriginalIds;
  std::vector<double> Cells;
  std::vector<double> Barycentric; ///< three each
  ///@}

  /// Fails if there is no point, an id is out of range, or a coordinate or an initial distance is
  /// not finite.
  Status Check(Offset numberOfPoints) const;

  /// Locates the points on the surface, or near the points of a cloud. Fails as Check(), or
  /// if a position is too far away. `input` has the cells that the surface was made from; unused
  /// without Barycentric. `tolerance` is the largest distance of a position from the surface, as a
  /// fraction of the diagonal. Positions between the points of a sparser cloud are accepted as
  /// well.
  Status Locate(const SurfaceArrays& input, const PreparedSurface& surface, double tolerance,
    std::vector<GeodesicSource>& sources) const;

  ///@{
  /// Like above, on the surface of the context. Appends a warning by DescribeIsolated() unless
  /// `warnings` is null.
  Status Locate(const TaskContext& context, double tolerance, std::vector<GeodesicSource>& sources,
    std::vector<std::string>* warnings = nullptr) const;
  Status Locate(const TaskContext& context, double tolerance, std::vector<SurfacePoint>& points,
    std::vector<std::string>* warnings = nullptr) const;
  ///@}

  /// Returns a warning about located points that no polygon uses, or, in clouds, that are not
  /// finite; else an empty text.
  std::string DescribeIsolated(
    const PreparedSurface& surface, const std::vector<GeodesicSource>& sources) const;
  /// Returns the same warning for sources given by their indices: ids first, then positions.
  std::string DescribeIsolated(const std::vector<std::size_t>& isolated, bool isCloud) const;

  using Position = std::array<double, 3>;

  std::size_t GetNumberOfPositions() const { return this->Positions.size() / 3; }
  Position GetPosition(std::size_t i) const;
  double GetInitialDistanceOfId(std::size_t i) const;
  double GetInitialDistanceOfPosition(std::size_t i) const;
  /// Returns the error of a position that is too far from a surface with this diagonal.
  Status RefuseDistant(std::size_t i, double distance, double tolerance, double diagonal,
    const std::string& surface = "surface") const;

private:
  std::string Describe(std::size_t i) const;
  std::string DescribeWithPosition(std::size_t i) const;
  Status Identify(std::size_t i, const CellCoordinates& cells, const PreparedSurface& surface,
    Position& position, SurfacePoint& point, bool& isFound) const;
  Status FindClosest(std::size_t i, const PreparedSurface& surface, double tolerance,
    const Position& position, SurfacePoint& point) const;
};

/// Returns the points of sources.
DGG_CORE_EXPORT std::vector<SurfacePoint> GetPoints(const std::vector<GeodesicSource>& sources);
}

#endif
