// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Meshes with the defects of real ones, and with worse. Where the defect leaves the truth known,
/// the comment says so.
#ifndef DefectMeshes_h
#define DefectMeshes_h

#include "TestMeshes.h"

namespace dggtest
{
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
double KleinBottleDistance(Id columns, Id rows, double x1, double y1, double x2, double y2);

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

/// Random triangle soup of `faces` faces on `vertices` random points, some coincident, some
/// collinear; faces may repeat a vertex, each other, or share edges in any number.
TestMesh RandomSoup(Id vertices, Id faces, std::uint64_t seed);

/// DefectMeshes() and as many small soups, with names that begin with "soup".
std::vector<NamedMesh> DefectMeshesAndSoups(int soups);
}

#endif
