// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Generated meshes for machines without scans: irregular, with convex and saddle vertices.
#ifndef GeneratedMesh_h
#define GeneratedMesh_h

#include "MeshArrays.h" // for MeshArrays

/// Returns a sphere of radius 1 from an icosahedron split `level` times: 10 * 4^level + 2 vertices.
/// Face f of one level is split into the faces 4 f to 4 f + 3 of the next.
MeshArrays Icosphere(int level);

/// Returns an Icosphere() with waves of relative height `amplitude` and vertices shifted at random
/// by up to 0.2 edge lengths.
MeshArrays BumpySphere(int level, double amplitude = 0.1);

/// Returns a torus of radii 1 and 0.4 with `rings` x `sides` vertices, shifted at random along the
/// surface by up to 0.2 steps.
MeshArrays Torus(int rings, int sides);

#endif
