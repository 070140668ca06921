// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Command line of a benchmark program: meshes and --name=value.
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
  /// `defaults` contains all options with their default values.
  explicit BenchmarkArguments(std::map<std::string, std::string> defaults)
    : Values(std::move(defaults))
  {
  }

  /// Reads the arguments that Google Benchmark left. Throws a BenchmarkError for an unknown option
  /// and for a mesh that cannot be read.
  void Parse(int argc, char** argv);

  const std::string& Get(const std::string& name) const { return this->Values.at(name); }
  double GetNumber(const std::string& name) const;
  int GetInteger(const std::string& name) const;
  /// Like GetInteger(), but throws a BenchmarkError if the value is less than `least`.
  int GetAtLeast(const std::string& name, int least) const;
  /// Returns the parts of a value, separated by commas.
  std::vector<std::string> GetList(const std::string& name) const;
  std::vector<int> GetIntegers(const std::string& name) const;

  /// Returns the meshes of the command line, or else those of the environment
  /// (DGG_BENCHMARK_MESHES, separated by ':'), or else a generated surface and, if installed, the
  /// bunny of Debian's glmark2-data.
  const std::vector<MeshRecipe>& GetMeshes() const { return this->Meshes; }

private:
  std::map<std::string, std::string> Values;
  std::vector<MeshRecipe> Meshes;
};

MeshRecipe MeshFromFile(const std::string& file);

/// Returns a torus, named "torus", with `rings` rings; throws a BenchmarkError if there are fewer
/// than 6.
MeshRecipe TorusOfRings(int rings);

/// Returns the recipe of a mesh after a step of Loop subdivision.
MeshRecipe Subdivided(MeshRecipe mesh);

/// Returns a short name of a size; 5000 is 5K.
std::string SizeName(int size);

/// Main function of a program: reads the arguments, calls `registerCases` and runs the cases. A
/// BenchmarkError before the run is written to the standard error output.
int RunBenchmarks(int argc, char** argv, std::map<std::string, std::string> defaults,
  const std::function<void(const BenchmarkArguments&)>& registerCases);

#endif
