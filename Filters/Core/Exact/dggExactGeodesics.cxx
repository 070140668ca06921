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

Status ExactGeodesics::Run(
  const std::vector<GeodesicSource>& sources, const ExactOptions& options, ExactResult& result)
{
  // The engine keeps its arrays from run to run.
  if (!this->Engine || this->EngineKind != options.Engine)
  {
    if (options.Engine == ExactEngine::Reference)
    {
      this->Engine = std::make_unique<ReferenceEngine>(this->Mesh);
    }
    else
    {
      this->Engine = std::make_unique<TriangleEngine>(this->Mesh);
    }
    this->EngineKind = options.Engine;
  }
  return this->Engine->Run(sources, options, result);
}
}
