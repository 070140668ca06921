// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dggGraphicsGiven.h"

#include <algorithm>
#include <cstddef>

namespace dgg
{
namespace
{
/// Call `visit(vertex, curve, values, parameter)` for every end of an edge of a diffusion curve, on
/// both sides.
template <typename Visitor>
void ForEachGiven(const GraphicsDomain& domain, const std::vector<CurveChain>& chains,
  const std::vector<GraphicsCurve>& curves, Visitor&& visit)
{
  for (std::size_t k = 0; k < curves.size(); ++k)
  {
    if (curves[k].Type != GraphicsCurveType::Diffusion)
    {
      continue;
    }
    const CurveSides& sides = domain.Solved.Sides[domain.SidesInSolved[k]];
    const std::vector<double>& parameters = chains[k].Parameters;
    for (const bool isLeft : { true, false })
    {
      const std::vector<EdgeSide>& edges = isLeft ? sides.Left : sides.Right;
      for (std::size_t i = 0; i < edges.size(); ++i)
      {
        if (edges[i].Face != NoId)
        {
          visit(edges[i].From, curves[k], isLeft, parameters[i]);
          visit(edges[i].To, curves[k], isLeft, parameters[i + 1]);
        }
      }
    }
  }
}
}

std::vector<Id> FindGivenVertices(const GraphicsDomain& domain,
  const std::vector<CurveChain>& chains, const std::vector<GraphicsCurve>& curves)
{
  std::vector<Id> vertices;
  ForEachGiven(domain, chains, curves,
    [&](Id v, const GraphicsCurve&, bool, double) { vertices.push_back(v); });
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

void SetGivenValues(const GraphicsDomain& domain, const std::vector<CurveChain>& chains,
  const std::vector<GraphicsCurve>& curves, const std::vector<double>& bands,
  std::vector<std::vector<double>>& columns)
{
  const std::size_t channels = columns.size();
  const std::size_t n = domain.Solved.Surface.Points.size();
  std::vector<double> counts(n, 0.0);
  std::vector<double> color(channels);
  ForEachGiven(
    domain, chains, curves, [&](Id v, const GraphicsCurve& curve, bool isLeft, double parameter) {
      InterpolateOnCurve(isLeft ? curve.Left : curve.Right, static_cast<int>(channels),
        curve.IsClosed, parameter, color.data());
      for (std::size_t c = 0; c < channels; ++c)
      {
        columns[c][v] = (counts[v] == 0.0 ? 0.0 : columns[c][v]) + color[c];
      }
      counts[v] += 1.0;
    });
  std::vector<double> copies(n, 0.0);
  for (const Id v : domain.SolvedVertexOf)
  {
    copies[v] += 1.0;
  }
  for (std::size_t c = 0; c < channels; ++c)
  {
    for (std::size_t v = 0; v < n; ++v)
    {
      columns[c][v] /= std::max(1.0, counts[v]);
    }
    for (std::size_t d = 0; d < domain.SolvedVertexOf.size(); ++d)
    {
      const Id v = domain.SolvedVertexOf[d];
      columns[c][v] -= counts[v] > 0.0 ? bands[channels * d + c] / copies[v] : 0.0;
    }
  }
}
}
