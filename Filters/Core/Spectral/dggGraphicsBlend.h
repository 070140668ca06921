// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The strengths of a Poisson curve beside it. Internal.
#ifndef dggGraphicsBlend_h
#define dggGraphicsBlend_h

#include "dggGraphicsDomain.h" // for sides

#include <vector> // for values

namespace dgg
{
/// The strengths on the left and on the right of a Poisson curve as continuous functions around it:
/// each is harmonic in the band and has, at both sides of the curve, the strength of the curve
/// there. Those of the nearest place of the curve would jump where two places are as near.
class StrengthBlend
{
public:
  /// Whether strengths change along a curve; where they do not, there is nothing to blend.
  static bool IsNeeded(const GraphicsCurve& curve, int channels);

  /// Solve for them on the faces of a mesh that have a vertex in the band, on the intrinsic
  /// Delaunay triangulation of these, so that no strength lies outside of those of the curve. Where
  /// their triangles are too thin for that, there are no strengths, see Get().
  Status Spread(const SurfaceMesh& mesh, const std::vector<char>& isInBand, const CurveSides& sides,
    const CurveChain& chain, const GraphicsCurve& curve, int channels,
    const ProgressCallback& progress);

  /// The strengths at a vertex, one per channel. False, and nothing, where faces of the band do not
  /// lead to the curve, or are too thin.
  bool Get(Id vertex, std::vector<double>& left, std::vector<double>& right) const;

private:
  std::vector<Id> Places;                   // per vertex, its id in the band, or NoId
  std::vector<std::vector<double>> Columns; // channels of the left, then those of the right
};
}

#endif
