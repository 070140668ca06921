// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A surface cut open along the curves of a drawing. Internal.
#ifndef dggGraphicsDomain_h
#define dggGraphicsDomain_h

#include "dggCurveCut.h"       // for CurveCut
#include "dggVectorGraphics.h" // for curves

#include <cstddef> // for std::size_t
#include <string>  // for names
#include <vector>  // for maps

namespace dgg
{
/// Two cuts of the same surface. Faces are the same ones in both, in the same order.
struct GraphicsDomain
{
  /// Along diffusion curves: what the equation is solved on.
  CurveCut Solved;
  SurfaceMesh SolvedMesh;
  /// Along Poisson curves as well: where colours are.
  CurveCut Drawn;
  SurfaceMesh DrawnMesh;          ///< made only if there is a Poisson curve
  std::vector<Id> SolvedVertexOf; ///< per vertex of Drawn
  /// Per curve, the numbers of its sides in Solved (of diffusion curves) and in Drawn (of both).
  std::vector<std::size_t> SidesInSolved;
  std::vector<std::size_t> SidesInDrawn;
};

/// How messages name a curve of that number.
std::string NameOf(const GraphicsCurve& curve, std::size_t number);

/// Call `visit(vertex, isLeft, parameter)` for both ends of every edge of a curve, on its left and
/// then on its right, where there is a face.
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

/// Fails when a curve has no length, or no sides.
Status CutForGraphics(const SurfaceMesh& mesh, const RefinedSurface& surface,
  const std::vector<CurveChain>& chains, const std::vector<GraphicsCurve>& curves,
  GraphicsDomain& domain);

/// The numbers of a curve at a place among its given points (CurveChain::Parameters).
void InterpolateOnCurve(
  const std::vector<double>& values, int channels, bool isClosed, double parameter, double* result);

/// The vertices of the solved surface on diffusion curves, sorted.
std::vector<Id> FindDirichletVertices(const GraphicsDomain& domain,
  const std::vector<CurveChain>& chains, const std::vector<GraphicsCurve>& curves);

/// At these vertices, replace loads by what the bands, per vertex of the drawn surface, have not
/// made of the given colours already. A vertex that bands have cut has several values of theirs, of
/// which the mean counts. Columns are channels.
void SetDirichletValues(const GraphicsDomain& domain, const std::vector<CurveChain>& chains,
  const std::vector<GraphicsCurve>& curves, const std::vector<double>& bands,
  std::vector<std::vector<double>>& columns);
}

#endif
