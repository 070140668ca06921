// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The mesh that tests pass around, what can be done to it, and the generators of all kinds.
#ifndef TestMeshes_h
#define TestMeshes_h

#include "dggSurfaceMesh.h"
#include "dggTypes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
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

/// Uniform in [-1, 1).
std::vector<double> RandomValues(std::size_t count, std::uint64_t seed);

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

/// Whether something went well, with the message if not.
inline testing::AssertionResult Ok(const dgg::Status& status)
{
  return (status.IsOk() ? testing::AssertionSuccess() : testing::AssertionFailure())
    << status.GetMessage();
}
/// Whether a message has this text in it.
inline testing::AssertionResult Says(const dgg::Status& status, const std::string& text)
{
  const bool isSaid = status.GetMessage().find(text) != std::string::npos;
  return (isSaid ? testing::AssertionSuccess() : testing::AssertionFailure())
    << '"' << text << "\" in: " << status.GetMessage();
}

/// Listens to progress, which must rise within [0, 1], and asks to stop at the call of that number.
/// Pass it by std::ref.
class ProgressListener
{
public:
  bool operator()(double done)
  {
    EXPECT_GE(done, this->Done - 1e-12); // but for rounding
    EXPECT_LE(done, 1.0);
    this->First = this->Calls == 0 ? done : this->First;
    this->Done = done;
    ++this->Calls;
    return true;
  }
  int Calls = 0;
  double First = 0.0; ///< what the first call said
  double Done = 0.0;  ///< what the latest call said
};

/// Errors on ever finer meshes, which must fall at an order at least: each is to be that of half
/// the edges of the one before.
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

/// One list after the other.
std::vector<NamedMesh> Joined(std::vector<NamedMesh> some, const std::vector<NamedMesh>& others);

/// The kernel's mesh, from points, lengths or glued lengths, whichever the test mesh has. Throws
/// std::runtime_error with the kernel's message when it refuses.
dgg::SurfaceMesh Build(const TestMesh& mesh);

/// Points row by row and the squares between them; the last column is next to the first one where
/// rows go around, and the last row where columns do.
TestMesh Grid(Id columns, Id rows, const std::function<std::array<double, 3>(Id, Id)>& place,
  bool rowsGoAround = false, bool columnsGoAround = false);

double EuclideanDistance(const TestMesh& mesh, Id a, Id b);
/// Direction from one vertex of a plane to another one, and that from which the angles of a vertex
/// count: of the first half-edge of its fan.
double DirectionOf(const TestMesh& plane, Id from, Id to);
double FanAngle(const TestMesh& plane, const dgg::SurfaceMesh& mesh, Id v);

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

// Meshes whose geodesic distances are known: developable and polyhedral ones.

/// Rectangle of nx x ny unit cells in the plane z = 0; vertex (i, j) has id j (nx + 1) + i.
/// Interior vertices are moved at random by up to `jitter` (below 0.3) along each axis.
TestMesh Plane(Id nx, Id ny, double jitter = 0.0, std::uint64_t seed = 1);

/// As Plane(), but only the cells for which `keep` holds. Points without a cell are left out;
/// points on the rim and on corners of the domain never move.
TestMesh Plate(Id nx, Id ny, const std::function<bool(Id, Id)>& keep, double jitter = 0.0,
  std::uint64_t seed = 1);

/// Square [-n, n]^2 with a slit along the positive x axis from the origin to the rim: the points of
/// the slit exist twice. `isLower` shows the copies that belong to y < 0.
TestMesh SlitPlane(Id n, std::vector<bool>& isLower, double jitter = 0.0, std::uint64_t seed = 1);

/// Open side of a prism with `sides` sides of width 1 and `rows` rows of height 1; each side has
/// `columns` columns. Vertex (i, j), i around and j upwards, has id j sides columns + i. Vertices
/// move up or down by up to `jitter`, except at the two rims.
TestMesh PrismSide(Id sides, Id columns, Id rows, double jitter = 0.0, std::uint64_t seed = 1);

/// Polar coordinates of the vertices of Cone().
struct ConePoint
{
  double Radius = 0.0;
  double Angle = 0.0;
};
/// Cone of total apex angle `total` around vertex 0, radius 1, given by its lengths alone.
/// Interior vertices are moved at random when `jitter` > 0 (relative to the spacing, below 0.3).
TestMesh Cone(double total, Id wedges, Id rings, std::vector<ConePoint>& coordinates,
  double jitter = 0.0, std::uint64_t seed = 1);
/// The distance of two points of a cone of total apex angle `total`.
double ConeDistance(double total, const ConePoint& p, const ConePoint& q);

/// Box [0, nx sx] x [0, ny sy] x [0, nz sz] whose faces are grids of right triangles. Vertices
/// inside the six faces move within them by up to `jitter` cells (below 0.3).
TestMesh Box(Id nx, Id ny, Id nz, double sx, double sy, double sz, double jitter = 0.0,
  std::uint64_t seed = 1);
/// Unit cube with k x k cells on each face.
TestMesh Cube(Id k, double jitter = 0.0, std::uint64_t seed = 1);
/// The vertex at exactly this position (to 1e-9); throws std::runtime_error when there is none.
Id VertexAt(const TestMesh& mesh, double x, double y, double z);

/// Regular polyhedra of edge 1. The pentagons of the dodecahedron are cut by two diagonals each.
TestMesh Tetrahedron();
TestMesh Octahedron();
TestMesh Icosahedron();
TestMesh Dodecahedron();

/// Flat torus R^2 / (u Z + v Z) with u = (ux, 0), v = (vx, vy), cut into nx x ny parallelograms;
/// vertex (i, j) has id j nx + i and sits at i u / nx + j v / ny. Given by lengths; glued by
/// half-edges when `glued` (needed unless nx and ny are at least 3).
TestMesh FlatTorus(double ux, double vx, double vy, Id nx, Id ny, bool glued);
/// Distance on that torus of two points whose difference in the plane is (dx, dy).
double FlatTorusDistance(double ux, double vx, double vy, double dx, double dy);

/// Two copies of a regular polygon (circumradius 1), each with `rings` rings of vertices around a
/// centre of its own, glued along the rim. `isBack` shows the vertices inside the second copy.
TestMesh DoublyCoveredPolygon(Id sides, Id rings, std::vector<bool>& isBack);

/// Triangle (0,0) (4,0) (1,3).
TestMesh SingleTriangle();
/// Two triangles that share the edge from (0,0) to (0,2) and lie to the left and right of it, the
/// right one folded up by `fold` radians.
TestMesh TwoTriangles(double fold);

// Curved and rough meshes without defects.

/// Unit sphere: an icosahedron with every face cut in four, `level` times.
TestMesh Icosphere(int level);

/// Icosphere whose vertices are moved by up to `noise` mean edge lengths along each axis.
TestMesh NoisySphere(int level, double noise, std::uint64_t seed);

/// Icosphere stretched along x: faces of anisotropy up to about `ratio`.
TestMesh Ellipsoid(int level, double ratio);

/// Plane of n x n jittered cells with random heights in [-roughness, roughness].
TestMesh Terrain(Id n, double roughness, std::uint64_t seed);

/// Torus with radii 1 and 0.4 on a grid of nu x nv quads.
TestMesh Torus(Id nu, Id nv);

/// Surface of the unit cubes for which `filled` holds, each square cut in two. Closed and manifold
/// when no two cubes touch along an edge or at a corner alone.
TestMesh VoxelSurface(Id nx, Id ny, Id nz, const std::function<bool(Id, Id, Id)>& filled);

/// Closed surface of genus 2: a block with two holes.
TestMesh TwoHoledBlock();

/// A long flat bar with one to three round holes in a row, as from CAD: closed, no points inside of
/// its faces, which are long and thin.
TestMesh DrilledBar(std::uint64_t seed);

/// Three surfaces side by side: sphere, torus, plane.
TestMesh SeveralComponents();

/// The meshes on which engines and invariants are compared: noise 0 to 50 %, anisotropy 1:20,
/// boundary, genus 0 to 2, several components; jittered and regular.
std::vector<NamedMesh> SoundMeshes();

// Meshes with the defects of real ones, and with worse. Where the defect leaves the truth known,
// the comment says so.

/// Chain of `links` plates of 3 x 3 cells, each touching the next at one corner point only.
TestMesh PinchedPlates(Id links);

/// Two icospheres that share one vertex (id 0).
TestMesh TouchingSpheres(int level);

/// `sheets` half planes of n x n cells that meet in one straight edge line along y, evenly turned
/// about it. Sheet s holds the vertices with sheetOf[v] == s; those on the line have sheetOf -1.
/// Any two sheets unfold to a plane.
TestMesh Book(
  Id sheets, Id n, std::vector<Id>& sheetOf, double jitter = 0.0, std::uint64_t seed = 1);

/// A jittered plane [0, 2n] x [0, n] cut along the middle x = n and glued again, with one more half
/// plane standing on the cut. The vertices of the plane come first and are at their plane
/// distance of each other.
TestMesh PlaneWithFin(Id n, Id& verticesOfPlane, double jitter, std::uint64_t seed);

/// Flat Moebius strip of length `columns` and width `rows` (rows even), by lengths alone. Vertex
/// (i, j) has id j columns + i and sits at (i, j - rows / 2) in the strip that covers it; that
/// strip repeats mirrored after `columns`. At least 3 columns.
TestMesh MoebiusStrip(Id columns, Id rows);
double MoebiusDistance(Id columns, double x1, double y1, double x2, double y2);

/// Flat Klein bottle: a Moebius strip whose rim is glued to itself, y modulo `rows`. Vertex (i, j)
/// has id j columns + i and sits at (i, j). At least 3 of each.
TestMesh KleinBottle(Id columns, Id rows);

/// Plane of n x n cells with an extra row of vertices `height` above the middle one: slivers.
TestMesh SliverPlane(Id n, double height);
/// Plane with needles: an extra column of vertices `width` right of every column.
TestMesh NeedlePlane(Id n, double width);
/// Plane with caps: a vertex `height` away from the middle of one edge of many faces.
TestMesh CapPlane(Id n, double height);

/// Plane cut along x = n / 2: the points of the cut exist twice, and there is no way across.
TestMesh SeamPlane(Id n);
/// The same cut, closed by faces of zero area between the two copies: zero-length edges.
TestMesh ZippedPlane(Id n);
/// Plane with T-junctions closed by faces of three collinear points.
TestMesh CollinearPlane(Id n);
/// Every vertex and face of a plane as it is, and faces that name a vertex twice.
TestMesh RepeatedVertexPlane(Id n);
/// A cube of which every third face exists twice, on the same three vertices.
TestMesh DuplicateFaceCube(Id k);
/// Plates with one hole, stacked and welded face to face: at each contact both plates keep their
/// own triangulation, without points inside. `outer` and `inner` points on the rims.
TestMesh WeldedPlates(Id layers, Id outer, Id inner, std::uint64_t seed);

/// A sphere with isolated points: first, last and in between. Three in all.
TestMesh SphereWithIsolatedPoints(int level);
/// A sphere with about half of its faces turned over at random.
TestMesh MisorientedSphere(int level, std::uint64_t seed);
/// A sphere of which `count` vertices were pulled onto neighbours: coincident points joined by
/// zero-length edges, and faces of zero area.
TestMesh CollapsedSphere(int level, Id count, std::uint64_t seed);

/// Closed surfaces pressed flat, to lines, and nearly so: every dihedral angle is 0 or pi. The last
/// one has all points in one place.
std::vector<TestMesh> FlattenedMeshes();

/// One of each, moderate in size.
std::vector<NamedMesh> DefectMeshes();
/// SoundMeshes() and these.
std::vector<NamedMesh> AllMeshes();

/// Random triangle soup of `faces` faces on `vertices` random points, some coincident, some
/// collinear; faces may repeat a vertex, each other, or share edges in any number.
TestMesh RandomSoup(Id vertices, Id faces, std::uint64_t seed);

/// Soups of up to 22 vertices and 50 faces, with names that begin with "soup".
std::vector<NamedMesh> SmallSoups(int count);
/// DefectMeshes() and SmallSoups().
std::vector<NamedMesh> DefectMeshesAndSoups(int soups);
/// SmallSoups(), spheres with 1 to `collapsed` vertices pulled onto neighbors, FlattenedMeshes().
std::vector<NamedMesh> BrokenMeshes(int soups, int collapsed);
}

#endif
