// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Benchmarks of the Poisson equation solved by other libraries.
#ifndef PoissonPeerCases_h
#define PoissonPeerCases_h

#include "BenchmarkMesh.h" // for MeshRecipe
#include "PeerPoisson.h"   // for the peers

#include <benchmark/benchmark.h> // for State

#include <functional> // for the factory functions
#include <memory>     // for std::unique_ptr
#include <string>     // for names

struct PoissonPeer
{
  std::string Name;
  int Power = 1; ///< power of the Laplacian
  std::function<std::unique_ptr<PeerPoisson>(const MeshArrays& mesh)> Make;
};

/// Returns the peers that this build includes.
std::vector<PoissonPeer> ListPoissonPeers();

/// Measures matrix and factorization, and their peak memory.
void MeasurePeerFactor(benchmark::State& state, const MeshRecipe& recipe, const PoissonPeer& peer);

/// Measures one solve for the k-th of `numberOfSources` vertices; reports the difference from our
/// solution.
void MeasurePeerColumn(benchmark::State& state, const MeshRecipe& recipe, const PoissonPeer& peer,
  int k, int numberOfSources);

#endif
