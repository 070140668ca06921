// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The command line of a benchmark program: meshes and --name=value.
#ifndef BenchmarkArguments_h
#define BenchmarkArguments_h

#include "BenchmarkMesh.h" // for MeshRecipe

#include <functional> // for what registers cases
#include <map>        // for the options
#include <string>     // for names
#include <vector>     // for the meshes

class BenchmarkArguments
{
public:
  /// `defaults` are the options that there are, with the values that they have when not given.
  explicit BenchmarkArguments(std::map<std::string, std::string> defaults)
    : Values(std::move(defaults))
  {
  }

  /// Read what Google Benchmark left on the command line. A BenchmarkError on an option that does
  /// not exist or a mesh that cannot be read.
  void Parse(int argc, char** argv);

  const std::string& Get(const std::string& name) const { return this->Values.at(name); }
  double GetNumber(const std::string& name) const;
  int GetInteger(const std::string& name) const;
  /// The same; a BenchmarkError if it is less than `least`.
  int GetAtLeast(const std::string& name, int least) const;
  /// The parts of a value, separated by commas.
  std::vector<std::string> GetList(const std::string& name) const;
  std::vector<int> GetIntegers(const std::string& name) const;

  /// The meshes named on the command line, else those of the environment (DGG_BENCHMARK_MESHES,
  /// separated by ':'), else a generated surface and, when it is installed, the bunny of Debian's
  /// glmark2-data.
  const std::vector<MeshRecipe>& GetMeshes() const { return this->Meshes; }

private:
  std::map<std::string, std::string> Values;
  std::vector<MeshRecipe> Meshes;
};

MeshRecipe MeshFromFile(const std::string& file);

/// A torus, named "torus", of so many rings: at least 6, else a BenchmarkError.
MeshRecipe TorusOfRings(int rings);

/// A mesh after a step of Loop subdivision.
MeshRecipe Subdivided(MeshRecipe mesh);

/// 5000 is 5K.
std::string SizeName(int size);

/// The main function of a program: reads the arguments, has cases registered and runs them. A
/// BenchmarkError before that is reported on the standard error output.
int RunBenchmarks(int argc, char** argv, std::map<std::string, std::string> defaults,
  const std::function<void(const BenchmarkArguments&)>& registerCases);

#endif
