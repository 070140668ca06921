// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggExactGeodesics.h"

#include "dggReferenceEngine.h"
#include "dggTriangleEngine.h"

namespace dgg
{
ExactGeodesics::ExactGeodesics(const SurfaceMesh& mesh)
  : Mesh(mesh)
{
}

ExactGeodesics::~ExactGeodesics() = default;

/// Returns the engine, which reuses its arrays between runs.
WindowPropagation& ExactGeodesics::GetEngine(ExactEngine kind)
{
  if (!this->Engine || this->EngineKind != kind)
  {
    if (kind == ExactEngine::Reference)
    {
      this->Engine = std::make_unique<ReferenceEngine>(this->Mesh);
    }
    else
    {
      this->Engine = std::make_unique<TriangleEngine>(this->Mesh);
    }
    this->EngineKind = kind;
  }
  return *this->Engine;
}

Status ExactGeodesics::Run(
  const std::vector<GeodesicSource>& sources, const ExactOptions& options, ExactResult& result)
{
  return this->GetEngine(options.Engine).Run(sources, options, result, false);
}

Status ExactGeodesics::RunKept(
  const std::vector<GeodesicSource>& sources, const ExactOptions& options)
{
  return this->GetEngine(options.Engine).Run(sources, options, this->Kept, true);
}
}
