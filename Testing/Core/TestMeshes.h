// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Mesh type of the tests, operations on test meshes, and generators of all kinds of meshes.
#ifndef TestMeshes_h
#define TestMeshes_h

#include "dggStatus.h"
#include "dggSurfaceMesh.h"

#include <gtest/gtest.h>

// Headers that most tests of the kernel use.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <numeric>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace dggtest
{
using dgg::Id;

/// Random numbers that are equal on every platform: the standard specifies the generator but not
/// the distributions.
class Random
{
public:
  explicit Random(std::uint64_t seed)
    : Generator(seed)
  {
  }
  /// Returns a value uniformly distributed in [0, 1).
  double Uniform() { return static_cast<double>(this->Generator() >> 11) * 0x1.0p-53; }
  /// Returns a value uniformly distributed in [low, high).
  double Uniform(double low, double high) { return low + (high - low) * this->Uniform(); }
  /// Returns an index uniformly distributed in {0, ..., count - 1}.
  Id Index(Id count)
  {
    return static_cast<Id>(this->Generator() % static_cast<std::uint64_t>(count));
  }

private:
  std::mt19937_64 Generator;
};

/// Returns values uniformly distributed in [-1, 1).
std::vector<double> RandomValues(std::size_t count, std::uint64_t seed);

/// Input of a triangle mesh, given by points or by lengths alone.
struct TestMesh
{
  std::vector<double> Points; ///< x y z per vertex; empty when the mesh is given by lengths
  std::vector<Id> Triangles;  ///< three vertices per face
  /// Lengths of the edges from corner k to corner k+1, three per face; or empty
  std::vector<double> Lengths;
  std::vector<Id> Twins;   ///< twin half-edges of a mesh given by lengths; or empty
  Id AbstractVertices = 0; ///< number of vertices of a mesh without points

  Id GetNumberOfVertices() const
  {
    return this->Points.empty() ? this->AbstractVertices : static_cast<Id>(this->Points.size() / 3);
  }
  Id GetNumberOfFaces() const { return static_cast<Id>(this->Triangles.size() / 3); }
  Id AddPoint(double x, double y, double z);
  void AddTriangle(Id a, Id b, Id c);
  /// Adds two triangles that share the diagonal from a to c.
  void AddQuad(Id a, Id b, Id c, Id d);
  const double* Point(Id v) const { return this->Points.data() + 3 * static_cast<std::size_t>(v); }
};

/// Succeeds if the status is ok; otherwise the failure contains the message.
inline testing::AssertionResult Ok(const dgg::Status& status)
{
  return (status.IsOk() ? testing::AssertionSuccess() : testing::AssertionFailure())
    << status.GetMessage();
}
/// Succeeds if the message of the status contains the text. Properties have no braces there.
inline testing::AssertionResult Says(const dgg::Status& status, const std::string& text)
{
  const std::string message = dgg::Render(status.GetMessage());
  const bool isSaid = message.find(text) != std::string::npos;
  return (isSaid ? testing::AssertionSuccess() : testing::AssertionFailure())
    << '"' << text << "\" in: " << message;
}

/// Checks that progress rises within [0, 1], and records its values. Pass it by std::ref.
class ProgressListener
{
public:
  bool operator()(double done)
  {
    EXPECT_GE(done, this->Done - 1e-12); // up to rounding
    EXPECT_LE(done, 1.0);
    this->First = this->Calls == 0 ? done : this->First;
    this->Done = done;
    ++this->Calls;
    return true;
  }
  int Calls = 0;
  double First = 0.0; ///< value of the first call
  double Done = 0.0;  ///< value of the latest call
};

/// Checks the order of convergence of errors on successively refined meshes: each mesh has half the
/// edge lengths of the mesh before.
class Convergence
{
public:
  explicit Convergence(double order)
    : Order(order)
  {
  }
  void Add(double error)
  {
    if (this->Last < dgg::Infinity)
    {
      EXPECT_GT(std::log2(this->Last / error), this->Order) << this->Last << " to " << error;
    }
    this->Last = error;
  }
  double Last = dgg::Infinity;

private:
  double Order;
};

struct NamedMesh
{
  std::string Name;
  TestMesh Mesh;
};

/// Returns the concatenation of two lists.
std::vector<NamedMesh> Joined(std::vector<NamedMesh> some, const std::vector<NamedMesh>& others);

/// Returns the kernel's mesh from the points, lengths or glued lengths of the test mesh. Throws
/// std::runtime_error with the kernel's message on an error.
dgg::SurfaceMesh Build(const TestMesh& mesh);

/// Returns a grid of points, row by row, and the squares between the points. The last column is
/// adjacent to the first one if rows are periodic, and the last row if columns are periodic.
TestMesh Grid(Id columns, Id rows, const std::function<std::array<double, 3>(Id, Id)>& place,
  bool rowsGoAround = false, bool columnsGoAround = false);

double EuclideanDistance(const TestMesh& mesh, Id a, Id b);
/// Returns the direction from one vertex of a plane to another one, and the direction from which
/// the angles of a vertex are measured: that of the first half-edge of its fan.
double DirectionOf(const TestMesh& plane, Id from, Id to);
double FanAngle(const TestMesh& plane, const dgg::SurfaceMesh& mesh, Id v);

/// Adds `other` to `mesh` without connecting them.
void Append(TestMesh& mesh, const TestMesh& other);
TestMesh Translated(const TestMesh& mesh, double x, double y, double z);
TestMesh Scaled(const TestMesh& mesh, double factor);
/// Returns the mesh rotated by an angle (radians) about the axis (1, 2, 3), then translated.
TestMesh MovedRigidly(const TestMesh& mesh, double angle, const std::array<double, 3>& shift);
/// Returns the mesh with every vertex moved at random by up to `amount` along each axis.
TestMesh WithNoise(const TestMesh& mesh, double amount, std::uint64_t seed);
/// Renumbers vertex v as newIds[v]; the order and the first corners of faces change too.
TestMesh Renumbered(const TestMesh& mesh, const std::vector<Id>& newIds, std::uint64_t seed);
std::vector<Id> RandomPermutation(Id count, std::uint64_t seed);

/// Replaces a face by three faces that meet at a new vertex inside it. Preserves the metric.
Id SplitFace(TestMesh& mesh, Id face, const std::array<double, 3>& barycentric);
/// Inserts a vertex at parameter t on the edge (a, b), in all its faces. Preserves the metric.
Id SplitEdge(TestMesh& mesh, Id a, Id b, double t);
/// Inserts `count` vertices at random, half of them in faces and half of them on edges. Old
/// vertices keep their ids. Faces smaller than `smallestArea` are not split.
TestMesh RandomlyRefined(
  const TestMesh& mesh, Id count, std::uint64_t seed, double smallestArea = 0.0);
/// Cuts each face into k x k congruent faces; old vertices keep their ids.
TestMesh Subdivided(const TestMesh& mesh, Id k);
/// Returns the area of a face of a mesh with points.
double FaceArea(const TestMesh& mesh, Id face);
/// Returns the mean length over the sides of all faces.
double MeanEdge(const TestMesh& mesh);

// Meshes with known geodesic distances: developable and polyhedral surfaces.

/// Returns a rectangle of nx x ny unit cells in the plane z = 0; vertex (i, j) has id j (nx + 1) +
/// i. Interior vertices are moved at random by up to `jitter` (below 0.3) along each axis.
TestMesh Plane(Id nx, Id ny, double jitter = 0.0, std::uint64_t seed = 1);

/// Returns a Plane() with only the cells for which `keep` returns true. Points without a cell are
/// removed; points on the rim and at corners of the domain are not moved.
TestMesh Plate(Id nx, Id ny, const std::function<bool(Id, Id)>& keep, double jitter = 0.0,
  std::uint64_t seed = 1);

/// Returns the square [-n, n]^2 with a slit along the positive x axis from the origin to the rim:
/// the points of the slit exist twice. `isLower` is true for the copies on the side y < 0.
TestMesh SlitPlane(Id n, std::vector<bool>& isLower, double jitter = 0.0, std::uint64_t seed = 1);

/// Returns the open side of a prism with `sides` sides of width 1 and `rows` rows of height 1; each
/// side has `columns` columns. Vertex (i, j), i around and j upwards, has id j sides columns + i.
/// Vertices move up or down by up to `jitter`, except at the two rims.
TestMesh PrismSide(Id sides, Id columns, Id rows, double jitter = 0.0, std::uint64_t seed = 1);

/// Polar coordinates of the vertices of Cone().
struct ConePoint
{
  double Radius = 0.0;
  double Angle = 0.0;
};
/// Returns a cone of total apex angle `total` around vertex 0, radius 1, given by its lengths
/// alone. Interior vertices are moved at random when `jitter` > 0 (relative to the spacing, below
/// 0.3).
TestMesh Cone(double total, Id wedges, Id rings, std::vector<ConePoint>& coordinates,
  double jitter = 0.0, std::uint64_t seed = 1);
/// Returns the distance between two points of a cone of total apex angle `total`.
double ConeDistance(double total, const ConePoint& p, const ConePoint& q);

/// Returns the box [0, nx sx] x [0, ny sy] x [0, nz sz] whose faces are grids of right triangles.
/// Vertices inside the six faces move within them by up to `jitter` cells (below 0.3).
TestMesh Box(Id nx, Id ny, Id nz, double sx, double sy, double sz, double jitter = 0.0,
  std::uint64_t seed = 1);
/// Returns the unit cube with k x k cells on each face.
TestMesh Cube(Id k, double jitter = 0.0, std::uint64_t seed = 1);
/// Returns the vertex at this position (to 1e-9); throws std::runtime_error if there is none.
Id VertexAt(const TestMesh& mesh, double x, double y, double z);

/// Return regular polyhedra of edge 1. Each pentagon of the dodecahedron is cut by two diagonals.
TestMesh Tetrahedron();
TestMesh Octahedron();
TestMesh Icosahedron();
TestMesh Dodecahedron();

/// Returns the flat torus R^2 / (u Z + v Z) with u = (ux, 0), v = (vx, vy), cut into nx x ny
/// parallelograms; vertex (i, j) has id j nx + i and position i u / nx + j v / ny. Given by
/// lengths; glued by half-edges if `glued` (needed unless nx and ny are at least 3).
TestMesh FlatTorus(double ux, double vx, double vy, Id nx, Id ny, bool glued);
/// Returns the distance on a flat torus between two points with the difference (dx, dy) in the
/// plane.
double FlatTorusDistance(double ux, double vx, double vy, double dx, double dy);

/// Returns two copies of a regular polygon (circumradius 1), each with `rings` rings of vertices
/// around its own center, glued along the rim. `isBack` is true for the inner vertices of the
/// second copy.
TestMesh DoublyCoveredPolygon(Id sides, Id rings, std::vector<bool>& isBack);

/// Returns the triangle (0,0) (4,0) (1,3).
TestMesh SingleTriangle();
/// Returns two triangles on the left and right of a shared edge from (0,0) to (0,2); the right one
/// is folded up by `fold` radians.
TestMesh TwoTriangles(double fold);

// Curved and rough meshes without defects.

/// Returns the unit sphere: an icosahedron with every face cut into four faces, `level` times.
TestMesh Icosphere(int level);

/// Returns an icosphere whose vertices are moved by up to `noise` mean edge lengths along each
/// axis.
TestMesh NoisySphere(int level, double noise, std::uint64_t seed);

/// Returns an icosphere stretched along x: faces of anisotropy up to about `ratio`.
TestMesh Ellipsoid(int level, double ratio);

/// Returns a plane of n x n jittered cells with random heights in [-roughness, roughness].
TestMesh Terrain(Id n, double roughness, std::uint64_t seed);

/// Returns a torus with radii 1 and 0.4 on a grid of nu x nv quads.
TestMesh Torus(Id nu, Id nv);

/// Returns the surface of the unit cubes for which `filled` returns true, each square cut into two
/// triangles. Closed and manifold if no two cubes share only an edge or only a corner.
TestMesh VoxelSurface(Id nx, Id ny, Id nz, const std::function<bool(Id, Id, Id)>& filled);

/// Returns a closed surface of genus 2: a block with two holes.
TestMesh TwoHoledBlock();

/// Returns a long flat bar with one to three round holes in a row, as in CAD models: closed, with
/// long and thin faces and no points inside its sides.
TestMesh DrilledBar(std::uint64_t seed);

/// Returns a flat cone with a shaft on its tip, as in CAD models: closed by discs, of triangles as
/// long as its parts.
TestMesh Shaft(Id sides);

/// Returns three surfaces side by side: sphere, torus, plane.
TestMesh SeveralComponents();

/// Returns the meshes for comparisons of engines and for invariants: noise 0 to 50 %, anisotropy
/// 1:20, boundary, genus 0 to 2, several components; jittered and regular.
std::vector<NamedMesh> SoundMeshes();

// Meshes with real-world defects and with worse ones. Comments state where the distances are still
// known.

/// Returns a chain of `links` plates of 3 x 3 cells, each touching the next at one corner point
/// only.
TestMesh PinchedPlates(Id links);

/// Returns two icospheres that share one vertex (id 0).
TestMesh TouchingSpheres(int level);

/// Returns `sheets` half planes of n x n cells that meet in one straight edge line along y at equal
/// angles. Vertices of sheet s have sheetOf[v] == s; vertices on the line have sheetOf -1. Any two
/// sheets unfold to a plane.
TestMesh Book(
  Id sheets, Id n, std::vector<Id>& sheetOf, double jitter = 0.0, std::uint64_t seed = 1);

/// Returns a jittered plane [0, 2n] x [0, n] with an additional half plane attached along the
/// middle line x = n. The vertices of the plane come first, and their distances are planar.
TestMesh PlaneWithFin(Id n, Id& verticesOfPlane, double jitter, std::uint64_t seed);

/// Returns a flat Moebius strip of length `columns` and width `rows` (rows even), by lengths alone.
/// Vertex (i, j) has id j columns + i and position (i, j - rows / 2) in the covering strip, which
/// repeats mirrored after `columns`. At least 3 columns.
TestMesh MoebiusStrip(Id columns, Id rows);
double MoebiusDistance(Id columns, double x1, double y1, double x2, double y2);

/// Returns a flat Klein bottle: a Moebius strip whose rim is glued to itself, y modulo `rows`.
/// Vertex (i, j) has id j columns + i and position (i, j). At least 3 columns and 3 rows.
TestMesh KleinBottle(Id columns, Id rows);

/// Returns a plane of n x n cells with an extra row of vertices `height` above the middle one:
/// slivers.
TestMesh SliverPlane(Id n, double height);
/// Returns a plane with needles: an extra column of vertices at a distance of `width` to the right
/// of every column.
TestMesh NeedlePlane(Id n, double width);
/// Returns a plane with caps: many faces have a vertex at a distance of `height` from the midpoint
/// of an edge.
TestMesh CapPlane(Id n, double height);

/// Returns a plane cut along x = n / 2: the points of the cut exist twice, and the two sides are
/// not connected.
TestMesh SeamPlane(Id n);
/// Returns SeamPlane() closed by faces of zero area between the two copies: zero-length edges.
TestMesh ZippedPlane(Id n);
/// Returns a plane with T-junctions closed by faces of three collinear points.
TestMesh CollinearPlane(Id n);
/// Returns an unchanged plane with additional faces that name a vertex twice.
TestMesh RepeatedVertexPlane(Id n);
/// Returns a cube of which every third face exists twice, on the same three vertices.
TestMesh DuplicateFaceCube(Id k);
/// Returns plates with one hole, stacked and welded face to face: at each contact both plates keep
/// their own triangulation, without inner points. The rims have `outer` and `inner` points.
TestMesh WeldedPlates(Id layers, Id outer, Id inner, std::uint64_t seed);

/// Returns a sphere with three isolated points: first, last and in between.
TestMesh SphereWithIsolatedPoints(int level);
/// Returns a sphere with about half of its faces reversed at random.
TestMesh MisorientedSphere(int level, std::uint64_t seed);
/// Returns a sphere with `count` vertices moved onto neighbors: coincident points joined by
/// zero-length edges, and faces of zero area.
TestMesh CollapsedSphere(int level, Id count, std::uint64_t seed);

/// Returns closed surfaces flattened to planes or lines, exactly or nearly: every dihedral angle is
/// 0 or pi. All points of the last one coincide.
std::vector<TestMesh> FlattenedMeshes();

/// Returns one mesh of moderate size for each defect.
std::vector<NamedMesh> DefectMeshes();
/// Returns SoundMeshes() and DefectMeshes().
std::vector<NamedMesh> AllMeshes();

/// Returns a random triangle soup of `faces` faces on `vertices` random points, some coincident,
/// some collinear. Faces may repeat a vertex or each other, and may share edges in any number.
TestMesh RandomSoup(Id vertices, Id faces, std::uint64_t seed);

/// Returns soups of up to 22 vertices and 50 faces, with names that begin with "soup".
std::vector<NamedMesh> SmallSoups(int count);
/// Returns DefectMeshes() and SmallSoups().
std::vector<NamedMesh> DefectMeshesAndSoups(int soups);
/// Returns SmallSoups(), spheres with 1 to `collapsed` vertices moved onto neighbors, and
/// FlattenedMeshes().
std::vector<NamedMesh> BrokenMeshes(int soups, int collapsed);
}

#endif
