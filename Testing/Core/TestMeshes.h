// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The mesh that tests pass around, and what can be done to it. The generators are in FlatMeshes.h,
/// CurvedMeshes.h and DefectMeshes.h.
#ifndef TestMeshes_h
#define TestMeshes_h

#include "dggSurfaceMesh.h"
#include "dggTypes.h"

#include <array>
#include <cstdint>
#include <functional>
#include <random>
#include <string>
#include <vector>

namespace dggtest
{
using dgg::Id;

/// Random numbers that are the same on every platform: the standard fixes the generator but not
/// the distributions.
class Random
{
public:
  explicit Random(std::uint64_t seed)
    : Generator(seed)
  {
  }
  /// Uniform in [0, 1).
  double Uniform() { return static_cast<double>(this->Generator() >> 11) * 0x1.0p-53; }
  /// Uniform in [low, high).
  double Uniform(double low, double high) { return low + (high - low) * this->Uniform(); }
  /// Uniform in {0, ..., count - 1}.
  Id Index(Id count)
  {
    return static_cast<Id>(this->Generator() % static_cast<std::uint64_t>(count));
  }

private:
  std::mt19937_64 Generator;
};

/// A triangle mesh before the kernel sees it: by points, or by lengths alone.
struct TestMesh
{
  std::vector<double> Points;  ///< x y z per vertex; empty when the mesh is given by lengths
  std::vector<Id> Triangles;   ///< three vertices per face
  std::vector<double> Lengths; ///< of the edges from corner k to corner k+1 of each face; or empty
  std::vector<Id> Twins;       ///< gluing, with lengths; or empty
  Id AbstractVertices = 0;     ///< number of vertices of a mesh without points

  Id GetNumberOfVertices() const
  {
    return this->Points.empty() ? this->AbstractVertices : static_cast<Id>(this->Points.size() / 3);
  }
  Id GetNumberOfFaces() const { return static_cast<Id>(this->Triangles.size() / 3); }
  Id AddPoint(double x, double y, double z);
  void AddTriangle(Id a, Id b, Id c);
  /// Two triangles on the diagonal from a to c.
  void AddQuad(Id a, Id b, Id c, Id d);
  const double* Point(Id v) const { return this->Points.data() + 3 * static_cast<std::size_t>(v); }
};

struct NamedMesh
{
  std::string Name;
  TestMesh Mesh;
};

/// The kernel's mesh, from points, lengths or glued lengths, whichever the test mesh has. Throws
/// std::runtime_error with the kernel's message when it refuses.
dgg::SurfaceMesh Build(const TestMesh& mesh);

double EuclideanDistance(const TestMesh& mesh, Id a, Id b);
/// Diagonal of the bounding box.
double Diagonal(const TestMesh& mesh);

/// Put `other` beside `mesh`, as it is.
void Append(TestMesh& mesh, const TestMesh& other);
TestMesh Translated(const TestMesh& mesh, double x, double y, double z);
TestMesh Scaled(const TestMesh& mesh, double factor);
/// Turned by an angle (radians) about the axis (1, 2, 3), then moved.
TestMesh MovedRigidly(const TestMesh& mesh, double angle, const std::array<double, 3>& shift);
/// Every vertex moved at random by up to `amount` along each axis.
TestMesh WithNoise(const TestMesh& mesh, double amount, std::uint64_t seed);
/// Vertex v becomes vertex newIds[v]; faces change their order and first corner too.
TestMesh Renumbered(const TestMesh& mesh, const std::vector<Id>& newIds, std::uint64_t seed);
std::vector<Id> RandomPermutation(Id count, std::uint64_t seed);

/// Replace a face by three that meet at a new vertex inside it. Changes nothing metrically.
Id SplitFace(TestMesh& mesh, Id face, const std::array<double, 3>& barycentric);
/// Insert a vertex at parameter t on the edge (a, b), in all its faces. Changes nothing metrically.
Id SplitEdge(TestMesh& mesh, Id a, Id b, double t);
/// Insert `count` vertices at random, half of them in faces and half of them on edges. Old vertices
/// keep their ids. Faces smaller than `smallestArea` are spared.
TestMesh RandomlyRefined(
  const TestMesh& mesh, Id count, std::uint64_t seed, double smallestArea = 0.0);
/// Each face cut into k x k congruent faces; old vertices keep their ids.
TestMesh Subdivided(const TestMesh& mesh, Id k);
/// Area of a face of a mesh with points.
double FaceArea(const TestMesh& mesh, Id face);
/// Mean length over the sides of all faces.
double MeanEdge(const TestMesh& mesh);
}

#endif
