// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Where the colours of diffusion curves are given. Internal.
#ifndef dggGraphicsGiven_h
#define dggGraphicsGiven_h

#include "dggGraphicsDomain.h" // for the surface

#include <vector> // for vertices and values

namespace dgg
{
/// The vertices of the solved surface on diffusion curves, sorted.
std::vector<Id> FindGivenVertices(const GraphicsDomain& domain,
  const std::vector<CurveChain>& chains, const std::vector<GraphicsCurve>& curves);

/// At these vertices, replace loads by what the bands, per vertex of the drawn surface, have not
/// made of the given colours already. A vertex that bands have cut has several values of theirs, of
/// which the mean counts. Columns are channels.
void SetGivenValues(const GraphicsDomain& domain, const std::vector<CurveChain>& chains,
  const std::vector<GraphicsCurve>& curves, const std::vector<double>& bands,
  std::vector<std::vector<double>>& columns);
}

#endif
