// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A surface cut open along the curves of a drawing. Internal.
#ifndef dggGraphicsDomain_h
#define dggGraphicsDomain_h

#include "dggSurfaceCut.h"     // for CurveCut
#include "dggVectorGraphics.h" // for curves

#include <cstddef> // for std::size_t
#include <string>  // for names
#include <vector>  // for maps

namespace dgg
{
/// Two cuts of the same surface. Both have the same faces in the same order.
struct GraphicsDomain
{
  /// Cut along diffusion curves: the domain of the equation.
  CurveCut Solved;
  SurfaceMesh SolvedMesh;
  /// Cut along Poisson curves as well: the domain of colors.
  CurveCut Drawn;
  SurfaceMesh DrawnMesh;          ///< only built if there is a Poisson curve
  std::vector<Id> SolvedVertexOf; ///< per vertex of Drawn, the vertex of Solved
  /// Per curve, the index of its sides in Solved (for diffusion curves) and in Drawn (for both
  /// types).
  std::vector<std::size_t> SidesInSolved;
  std::vector<std::size_t> SidesInDrawn;
};

/// Returns the name of a curve with the given index for messages.
std::string NameOf(const GraphicsCurve& curve, std::size_t number);

/// Calls `visit(vertex, isLeft, parameter)` for both ends of every edge of a curve, first on its
/// left and then on its right, wherever there is a face.
template <typename Visitor>
void ForEachEnd(const CurveSides& sides, const CurveChain& chain, Visitor&& visit)
{
  for (const bool isLeft : { true, false })
  {
    const std::vector<EdgeSide>& edges = isLeft ? sides.Left : sides.Right;
    for (std::size_t i = 0; i < edges.size(); ++i)
    {
      if (edges[i].Face != NoId)
      {
        visit(edges[i].From, isLeft, chain.Parameters[i]);
        visit(edges[i].To, isLeft, chain.Parameters[i + 1]);
      }
    }
  }
}

/// Cuts a surface for graphics. Fails if a curve has no length or no sides.
Status CutForGraphics(const SurfaceMesh& mesh, const SubMesh& surface,
  const std::vector<CurveChain>& chains, const std::vector<GraphicsCurve>& curves,
  GraphicsDomain& domain);

/// Interpolates the values of a curve at a parameter (CurveChain::Parameters).
void InterpolateOnCurve(
  const std::vector<double>& values, int channels, bool isClosed, double parameter, double* result);

/// Returns the vertices of the solved surface on diffusion curves, sorted.
std::vector<Id> FindDirichletVertices(const GraphicsDomain& domain,
  const std::vector<CurveChain>& chains, const std::vector<GraphicsCurve>& curves);

/// At the vertices of FindDirichletVertices(), replaces loads by the given colors minus the
/// contribution of the bands, which is per vertex of the drawn surface. For a vertex that bands
/// have cut, the mean of its copies is used. Columns are channels.
void SetDirichletValues(const GraphicsDomain& domain, const std::vector<CurveChain>& chains,
  const std::vector<GraphicsCurve>& curves, const std::vector<double>& bands,
  std::vector<std::vector<double>>& columns);
}

#endif
