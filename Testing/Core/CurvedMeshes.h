// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Curved and rough meshes without defects.
#ifndef CurvedMeshes_h
#define CurvedMeshes_h

#include "TestMeshes.h"

namespace dggtest
{
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
}

#endif
