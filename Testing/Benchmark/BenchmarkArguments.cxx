// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkArguments.h"

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

bool BenchmarkArguments::Parse(int argc, char** argv)
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
    if (option == this->Values.end())
    {
      std::cerr << "unknown option " << argument << "\n";
      return false;
    }
    option->second = argument.substr(equals + 1);
  }
  if (files.empty())
  {
    const char* listed = std::getenv("DGG_BENCHMARK_MESHES");
    files = Split(listed ? listed : "", ':');
  }
  for (const std::string& file : files)
  {
    if (!std::ifstream(file))
    {
      std::cerr << "cannot read " << file << "\n";
      return false;
    }
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
  return true;
}

double BenchmarkArguments::GetNumber(const std::string& name) const
{
  return std::atof(this->Get(name).c_str());
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

void AddBenchmarkContext()
{
  benchmark::AddCustomContext("vtk_version", vtkVersion::GetVTKVersion());
  benchmark::AddCustomContext("compiler", DGG_BENCHMARK_COMPILER);
#ifdef DGG_WITH_CGAL
  benchmark::AddCustomContext("cgal_version", DGG_BENCHMARK_CGAL);
#endif
}
