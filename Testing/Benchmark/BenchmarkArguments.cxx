// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkArguments.h"

#include "BenchmarkTools.h"
#include "MeshFile.h"

#include <benchmark/benchmark.h>
#include <vtkVersion.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <sstream>

namespace
{
const char* const BunnyFile = "/usr/share/glmark2/models/bunny.obj";

std::vector<std::string> Split(const std::string& text, char separator)
{
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);)
  {
    parts.push_back(part);
  }
  return parts;
}

MeshRecipe Generated()
{
  MeshRecipe recipe;
  recipe.Name = "bumpy_sphere";
  recipe.Level = 6;
  return recipe;
}
}

MeshRecipe MeshFromFile(const std::string& file)
{
  MeshRecipe recipe;
  recipe.Name = StemOf(file);
  recipe.File = file;
  return recipe;
}

void BenchmarkArguments::Parse(int argc, char** argv)
{
  std::vector<std::string> files;
  for (int i = 1; i < argc; ++i)
  {
    const std::string argument = argv[i];
    if (argument.rfind('-', 0) != 0)
    {
      files.push_back(argument);
      continue;
    }
    const auto equals = argument.find('=');
    const auto option = argument.rfind("--", 0) == 0 && equals != std::string::npos
      ? this->Values.find(argument.substr(2, equals - 2))
      : this->Values.end();
    Require(option != this->Values.end(), "unknown option " + argument);
    option->second = argument.substr(equals + 1);
  }
  if (files.empty())
  {
    const char* listed = std::getenv("DGG_BENCHMARK_MESHES");
    files = Split(listed ? listed : "", ':');
  }
  for (const std::string& file : files)
  {
    Require(std::ifstream(file).good(), "cannot read " + file);
  }
  std::transform(files.begin(), files.end(), std::back_inserter(this->Meshes), MeshFromFile);
  if (this->Meshes.empty())
  {
    this->Meshes.push_back(Generated());
    if (std::ifstream(BunnyFile))
    {
      this->Meshes.push_back(MeshFromFile(BunnyFile));
    }
  }
}

double BenchmarkArguments::GetNumber(const std::string& name) const
{
  return std::atof(this->Get(name).c_str());
}

int BenchmarkArguments::GetInteger(const std::string& name) const
{
  return static_cast<int>(this->GetNumber(name));
}

int BenchmarkArguments::GetAtLeast(const std::string& name, int least) const
{
  const int value = this->GetInteger(name);
  Require(value >= least, name + " must be at least " + std::to_string(least));
  return value;
}

std::vector<std::string> BenchmarkArguments::GetList(const std::string& name) const
{
  return Split(this->Get(name), ',');
}

std::vector<int> BenchmarkArguments::GetIntegers(const std::string& name) const
{
  std::vector<int> values;
  for (const std::string& value : this->GetList(name))
  {
    values.push_back(std::atoi(value.c_str()));
  }
  return values;
}

MeshRecipe TorusOfRings(int rings)
{
  Require(rings >= 6, "a torus has at least 6 rings");
  MeshRecipe torus;
  torus.Name = "torus";
  torus.Rings = rings;
  return torus;
}

MeshRecipe Subdivided(MeshRecipe mesh)
{
  mesh.Name += "-x4";
  mesh.Subdivisions = 1;
  return mesh;
}

std::string SizeName(int size)
{
  return size % 1000 == 0 ? std::to_string(size / 1000) + "K" : std::to_string(size);
}

int RunBenchmarks(int argc, char** argv, std::map<std::string, std::string> defaults,
  const std::function<void(const BenchmarkArguments&)>& registerCases)
{
  benchmark::Initialize(&argc, argv);
  try
  {
    BenchmarkArguments arguments(std::move(defaults));
    arguments.Parse(argc, argv);
    registerCases(arguments);
  }
  catch (const BenchmarkError& error)
  {
    std::cerr << error.what() << "\n";
    return 1;
  }
  // Libraries and compiler of this build.
  benchmark::AddCustomContext("vtk_version", vtkVersion::GetVTKVersion());
  benchmark::AddCustomContext("compiler", DGG_BENCHMARK_COMPILER);
#ifdef DGG_WITH_CGAL
  benchmark::AddCustomContext("cgal_version", DGG_BENCHMARK_CGAL);
#endif
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
