// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What is measured of the Poisson equation by other libraries.
#ifndef PoissonPeerCases_h
#define PoissonPeerCases_h

#include "BenchmarkMesh.h" // for MeshRecipe
#include "PeerPoisson.h"   // for the peers

#include <benchmark/benchmark.h> // for State

#include <functional> // for those who make a peer
#include <memory>     // for what they make
#include <string>     // for names

struct PoissonPeer
{
  std::string Name;
  int Power = 1; ///< of the Laplacian
  std::function<std::unique_ptr<PeerPoisson>(const MeshArrays& mesh)> Make;
};

/// Returns the peers that this build includes.
std::vector<PoissonPeer> ListPoissonPeers();

/// Matrix and factorization, and the memory that they take at most.
void MeasurePeerFactor(benchmark::State& state, const MeshRecipe& recipe, const PoissonPeer& peer);

/// One solve for the k-th of so many vertices, and how far the solution is from ours.
void MeasurePeerColumn(benchmark::State& state, const MeshRecipe& recipe, const PoissonPeer& peer,
  int k, int numberOfSources);

#endif
