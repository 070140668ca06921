// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A mesh with a field of exact distances, and what approximations are given of it.
#ifndef FieldCase_h
#define FieldCase_h

#include "GeodesicChecks.h"
#include "TestMeshes.h"

#include "dggDistanceField.h"
#include "dggExactGeodesics.h"
#include "dggSourceFinding.h"

#include <vector>

namespace dggtest
{
/// Everything that belongs to a field of exact distances.
struct FieldCase
{
  FieldCase(const TestMesh& test, const std::vector<dgg::GeodesicSource>& sources)
    : Mesh(Build(test))
    , Result(Solve(this->Mesh, dgg::ExactEngine::Triangle, sources,
        [](dgg::ExactOptions& options) { options.KeepWindows = true; }))
  {
    dgg::FindVirtualSources(this->Mesh, sources, this->Result, this->Virtual);
    const double* d = this->Result.Distances.data();
    this->Exact = { &this->Mesh, d, &this->Result.Windows, nullptr };
    this->ExactWithSources = { &this->Mesh, d, &this->Result.Windows, &this->Virtual };
    this->Local = { &this->Mesh, d, nullptr, &this->Virtual };
    this->Plain = { &this->Mesh, d, nullptr, nullptr };
  }
  FieldCase(const FieldCase&) = delete;
  FieldCase& operator=(const FieldCase&) = delete;

  std::vector<double> Levels(int count) const
  {
    const double farthest = LargestFinite(this->Result.Distances);
    std::vector<double> levels;
    for (int i = 1; i <= count; ++i)
    {
      levels.push_back(farthest * i / (count + 1));
    }
    return levels;
  }

  dgg::SurfaceMesh Mesh;
  dgg::ExactResult Result;
  dgg::VirtualSources Virtual;
  dgg::DistanceField Exact;
  dgg::DistanceField ExactWithSources;
  dgg::DistanceField Local;
  dgg::DistanceField Plain;
};
}

#endif
