// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Distances between any two vertices from those between samples, to compare with.
#ifndef TriangleUnfolding_h
#define TriangleUnfolding_h

#include "dggSurfaceMesh.h" // for SurfaceMesh

#include <array>   // for triangles
#include <cstddef> // for std::size_t
#include <vector>  // for the tables

/// Geodesic triangle unfolding, GTU (Xin, Ying and He, "Constant-time all-pairs geodesic distance
/// query on triangle meshes", 2012): exact distances between all samples, triangles of samples, and
/// for each vertex its triangle with the distances from the three corners. A query lays the two
/// triangles out in the plane and takes the straight line, in constant time.
///
/// Samples are each the vertex farthest from those before. Their triangles are dual to their
/// geodesic Voronoi cells: three samples are a triangle where their cells meet in a face of the
/// mesh. Of the triangles at the nearest sample that has any, a vertex takes the one that it lies
/// in, or the nearest one. In the plane, with barycentric coordinates a and b in the two triangles,
///
///   |p - q|^2 = sum a_i b_j D_ij^2 - sum_(i<j) a_i a_j l_ij^2 - sum_(i<j) b_i b_j m_ij^2,
///
/// where D are the nine distances between corners, l and m the sides. On a curved surface the nine
/// lengths fit into no plane, and this is a compromise that favours none of them. The result is
/// kept within what the triangle inequality leaves, which makes it exact between samples.
class TriangleUnfolding
{
public:
  struct Bounds
  {
    double Lower;
    double Upper;
  };

  /// The mesh must outlive this.
  explicit TriangleUnfolding(const dgg::SurfaceMesh& mesh)
    : Mesh(mesh)
  {
  }

  /// As many exact propagations as there are samples: at most `count`.
  dgg::Status Prepare(int count);

  /// The distance between two vertices; Infinity when they are not connected.
  double GetDistance(dgg::Id from, dgg::Id to) const;
  /// What the triangle inequality says of it, by the samples around both ends. The error of
  /// GetDistance() is at most their difference.
  Bounds GetBounds(dgg::Id from, dgg::Id to) const;

  const std::vector<dgg::Id>& GetSamples() const { return this->Samples; }
  std::size_t GetNumberOfTriangles() const { return this->Triangles.size(); }
  /// Bytes that queries need.
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
  std::vector<double> Table; ///< distances between samples, a square
  std::vector<Triangle> Triangles;
  std::vector<Place> Places; ///< per vertex
};

#endif
