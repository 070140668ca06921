// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Meshes whose geodesic distances are known: developable and polyhedral ones.
#ifndef FlatMeshes_h
#define FlatMeshes_h

#include "TestMeshes.h"

namespace dggtest
{
/// Rectangle of nx x ny unit cells in the plane z = 0; vertex (i, j) has id j (nx + 1) + i.
/// Interior vertices are moved at random by up to `jitter` (below 0.3) along each axis.
TestMesh Plane(Id nx, Id ny, double jitter = 0.0, std::uint64_t seed = 1);

/// As Plane(), but only the cells for which `keep` holds. Points without a cell are left out;
/// points on the rim and on corners of the domain never move.
TestMesh Plate(Id nx, Id ny, const std::function<bool(Id, Id)>& keep, double jitter = 0.0,
  std::uint64_t seed = 1);

/// Square [-n, n]^2 with a slit along the positive x axis from the origin to the rim: the points of
/// the slit exist twice. `isLower` tells the copies that belong to y < 0.
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
/// centre of its own, glued along the rim. `isBack` tells the vertices inside the second copy.
TestMesh DoublyCoveredPolygon(Id sides, Id rings, std::vector<bool>& isBack);

/// Triangle (0,0) (4,0) (1,3).
TestMesh SingleTriangle();
/// Two triangles that share the edge from (0,0) to (0,2) and lie to the left and right of it, the
/// right one folded up by `fold` radians.
TestMesh TwoTriangles(double fold);
}

#endif
