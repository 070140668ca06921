// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Shared tools for tests of distances inside faces.
#ifndef FieldChecks_h
#define FieldChecks_h

#include "GeodesicChecks.h"
#include "TestMeshes.h"

#include "dggDistanceField.h"
#include "dggExactGeodesics.h"
#include "dggSourceFinding.h"

namespace dggtest
{
/// A field of exact distances with the results that it refers to.
struct ExactField
{
  ExactField(const dgg::SurfaceMesh& mesh, const std::vector<dgg::GeodesicSource>& sources,
    const std::vector<dgg::SurfacePoint>& targets = {},
    dgg::ExactEngine engine = dgg::ExactEngine::Triangle)
  {
    dgg::ExactOptions options;
    options.Engine = engine;
    options.KeepWindows = true;
    options.Targets = targets;
    EXPECT_TRUE(Ok(dgg::ExactGeodesics(mesh).Run(sources, options, this->Result)));
    dgg::FindVirtualSources(mesh, sources, this->Result, this->Virtual);
    this->Exact = { &mesh, this->Result.Distances.data(), &this->Result.Windows, nullptr };
    this->ExactWithSources = { &mesh, this->Result.Distances.data(), &this->Result.Windows,
      &this->Virtual };
    this->Local = { &mesh, this->Result.Distances.data(), nullptr, &this->Virtual };
    this->Linear = { &mesh, this->Result.Distances.data(), nullptr, nullptr };
  }

  dgg::ExactResult Result;
  dgg::VirtualSources Virtual;
  dgg::DistanceField Exact;
  dgg::DistanceField ExactWithSources;
  dgg::DistanceField Local;
  dgg::DistanceField Linear;
};

struct OwnMesh
{
  dgg::SurfaceMesh Mesh;
};

/// An exact field together with its mesh.
struct FieldCase
  : OwnMesh
  , ExactField
{
  FieldCase(const TestMesh& test, const std::vector<dgg::GeodesicSource>& sources)
    : OwnMesh{ Build(test) }
    , ExactField(OwnMesh::Mesh, sources)
  {
  }
};
}

#endif
