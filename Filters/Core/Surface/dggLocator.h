// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The point of a surface or a cloud that is closest to a point in space. Internal.
#ifndef dggLocator_h
#define dggLocator_h

#include "dggBoxTree.h"      // for BoxTree
#include "dggCloudFrame.h"   // for CloudFrame
#include "dggCoreExport.h"   // for DGG_CORE_EXPORT
#include "dggSurfacePoint.h" // for SurfacePoint

#include <array>  // for the coordinates
#include <vector> // for the map

namespace dgg
{
/// Finds closest points. Several threads may search at the same time.
class Locator
{
public:
  virtual ~Locator() = default;

  /// Finds the closest point, and its distance in the units of the points. Returns false if there
  /// is none.
  virtual bool FindClosestPoint(
    const double position[3], SurfacePoint& closest, double& distance) const = 0;

  /// Returns the diagonal of the bounding box.
  virtual double GetDiagonal() const = 0;

  /// Returns true if a position at this distance from its closest point counts as a point of the
  /// surface. Positions no farther away than `farthest` always do.
  virtual bool IsClose(const SurfacePoint& closest, double distance, double farthest) const = 0;
};

/// Finds closest points on a mesh. Coordinates are scaled by a power of two for the search, so that
/// the result is bitwise the same at any scale. Of several closest faces, the one with the
/// smallest id is used.
class DGG_CORE_EXPORT SurfaceLocator : public Locator
{
public:
  /// `mesh` and `positions` (x y z per vertex) must outlive the locator; the mesh has a face.
  SurfaceLocator(const SurfaceMesh& mesh, const double* positions);
  /// `whole` is the box of a larger surface, of which the mesh is a part.
  SurfaceLocator(const SurfaceMesh& mesh, const double* positions, const Box& whole);

  /// Returns the box of the points with faces.
  static Box MeasureBox(const SurfaceMesh& mesh, const double* positions);

  bool FindClosestPoint(
    const double position[3], SurfacePoint& closest, double& distance) const override;
  double GetDiagonal() const override { return this->Diagonal; }
  bool IsClose(const SurfacePoint&, double distance, double farthest) const override
  {
    return distance <= farthest + this->Rounding;
  }

private:
  using Vector = std::array<double, 3>;

  Vector GetScaled(const double* position) const;
  /// Returns barycentric coordinates, in the order of the input, of the closest point of a face.
  Vector Project(const Vector& p, Id face, double& squaredDistance) const;
  std::array<Id, 3> GetInputTriangle(Id face) const;

  const SurfaceMesh& Mesh;
  const double* Positions;
  double Diagonal = 0.0;
  double Rounding = 0.0; // a few units in the last place of the largest coordinate
  double Scale = 1.0;    // power of two
  BoxTree Tree;          // of faces
};

/// Finds the closest finite point of a cloud. Coordinates are relative to the center of the cloud
/// and scaled by a power of two for the search, so that the result is bitwise the same at any
/// scale. The few outliers (dggOutliers.h) are examined one by one: in a frame that contains them,
/// the coordinates of the other points would lose digits.
class DGG_CORE_EXPORT CloudLocator : public Locator
{
public:
  /// `positions`, x y z per point, must outlive the locator.
  CloudLocator(const double* positions, Id numberOfPoints);

  /// The result is relative to the closest point of the cloud; of several, to the one with the
  /// smallest id. Returns false also if no distance is in the range of double.
  bool FindClosestPoint(
    const double position[3], SurfacePoint& closest, double& distance) const override;

  /// Returns the diagonal of the bounding box of the finite points without outliers.
  double GetDiagonal() const override { return this->Frame.GetDiagonal(); }

  /// Returns true if the distance is at most `farthest` or the reach of the closest point.
  bool IsClose(const SurfacePoint& closest, double distance, double farthest) const override
  {
    return distance <= farthest || distance <= this->GetReach(closest);
  }

private:
  double GetDistance(Id point, const double position[3]) const;
  /// Converts a distance to a squared distance in units of the search, rounded up.
  double GetSquaredLimit(double distance) const;
  /// Returns the reach of the point that `closest` refers to: the distance to its sixth neighbor,
  /// since vertices of triangle meshes have six neighbors on average; 0 if there are fewer. Only
  /// outliers are neighbors of outliers.
  double GetReach(const SurfacePoint& closest) const;

  const double* Positions;
  CloudFrame Frame;    // of the points in Tree
  std::vector<Id> Ids; // point ids in the cloud, per element of Tree
  std::vector<Id> Far; // outliers of the cloud, one per position
  BoxTree Tree;
};
}

#endif
