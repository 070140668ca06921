// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Distances between any two vertices from distances between samples, for comparison.
#ifndef TriangleUnfolding_h
#define TriangleUnfolding_h

#include "dggSurfaceMesh.h" // for SurfaceMesh

#include <array>   // for triangles
#include <cstddef> // for std::size_t
#include <vector>  // for the tables

/// Geodesic triangle unfolding, GTU (Xin, Ying and He, "Constant-time all-pairs geodesic distance
/// query on triangle meshes", 2012). Stores exact distances between all samples, triangles of
/// samples and, for each vertex, its triangle with the distances from the three corners. A query
/// unfolds the two triangles into the plane and returns the straight distance, in constant time.
///
/// Each sample is the vertex farthest from earlier samples. Their triangles are dual to their
/// geodesic Voronoi cells: three samples form a triangle if their cells meet in a face of the mesh.
/// A vertex belongs to the triangle that contains it, or the closest one, among the triangles at
/// the nearest sample that has any. In the plane, with barycentric coordinates a and b in the two
/// triangles,
///
///   |p - q|^2 = sum a_i b_j D_ij^2 - sum_(i<j) a_i a_j l_ij^2 - sum_(i<j) b_i b_j m_ij^2,
///
/// where D are the nine distances between corners, l and m the sides. On a curved surface the nine
/// distances are not realizable in a plane, and this formula is a symmetric compromise. The result
/// is clamped to the bounds of the triangle inequality, which makes it exact between samples.
class TriangleUnfolding
{
public:
  struct Bounds
  {
    double Lower;
    double Upper;
  };

  /// The mesh must outlive this object.
  explicit TriangleUnfolding(const dgg::SurfaceMesh& mesh)
    : Mesh(mesh)
  {
  }

  /// Prepares at most `count` samples, with one exact propagation each.
  dgg::Status Prepare(int count);

  /// Returns the distance between two vertices; Infinity if they are not connected.
  double GetDistance(dgg::Id from, dgg::Id to) const;
  /// Returns the bounds of a distance by the triangle inequality and the samples around both ends.
  /// The error of GetDistance() is at most the difference of the bounds.
  Bounds GetBounds(dgg::Id from, dgg::Id to) const;

  const std::vector<dgg::Id>& GetSamples() const { return this->Samples; }
  std::size_t GetNumberOfTriangles() const { return this->Triangles.size(); }
  /// Returns the bytes that queries need.
  std::size_t GetMemorySize() const;

private:
  using Triangle = std::array<dgg::Id, 3>; // indices of samples

  /// Location of a vertex in a triangle of samples.
  struct Place
  {
    Triangle Corners;
    std::array<double, 3> Distances;
    std::array<double, 3> Weights;
  };

  double Between(dgg::Id i, dgg::Id j) const
  {
    return this->Table[static_cast<std::size_t>(i) * this->Samples.size() + j];
  }
  dgg::Status TakeSamples(int count, std::vector<std::vector<double>>& fields);
  void FindTriangles(const std::vector<std::vector<double>>& fields);
  bool Locate(Place& place) const;
  double InTriangle(const Place& place) const;

  const dgg::SurfaceMesh& Mesh;
  std::vector<dgg::Id> Samples;
  std::vector<double> Table; ///< distances between samples, a square matrix
  std::vector<Triangle> Triangles;
  std::vector<Place> Places; ///< per vertex
};

#endif
