// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Poisson vector graphics: smooth colours on a surface from few curves and regions.
#ifndef dggVectorGraphics_h
#define dggVectorGraphics_h

#include "dggCoreExport.h"     // for DGG_CORE_EXPORT
#include "dggCurveEmbedding.h" // for CurveChain
#include "dggRefinedSurface.h" // for RefinedSurface
#include "dggSurfaceCut.h"     // for CutSurface
#include "dggSurfaceMesh.h"    // for SurfaceMesh

#include <functional> // for checks of memory
#include <memory>     // for what is prepared
#include <string>     // for names
#include <vector>     // for curves and values

namespace dgg
{
/// What a curve does to the colours around it.
enum class GraphicsCurveType
{
  Diffusion, ///< gives the colours on its left and on its right
  Poisson,   ///< adds colours on its left and on its right that fade within a width
  Region, ///< closed: brightens what is on its left, in sum by as much as it darkens at the curve
  Source  ///< lets colour flow in, as much per length as is given
};

/// A curve of the drawing. Numbers are given per given point of the curve, all channels of a point
/// after each other, and are linear between the points, by length along the curve.
struct GraphicsCurve
{
  GraphicsCurveType Type = GraphicsCurveType::Diffusion;
  bool IsClosed = false;
  /// Of a diffusion curve the colour on the left; of a Poisson curve the colour that is added
  /// right at it on the left; of a region, see GraphicsRegion::Strength, at the first point; of a
  /// source the flow per length.
  std::vector<double> Left;
  /// On the right, of diffusion and Poisson curves.
  std::vector<double> Right;
  /// Of a Poisson curve, the geodesic distance at which nothing is added any more.
  double Width = 0.0;
  /// In messages; empty for "curve" and its number.
  std::string Name;
};

/// A set of faces with sources. Each of its patches, connected through edges that are not on
/// diffusion curves, has a source of constant density, and a sink as strong, constant per length,
/// on its rim, so that colours far away stay nearly as they are: a round patch changes nothing
/// outside, one of another shape leaves a quadrupole, 2.4 % of the height of the highlight at twice
/// the longer half axis of an ellipse 2 : 1 on a plane, 3.6 % at 5 : 1, and a quarter of that at
/// twice the distance. Where no colour is given, the mean stays, so that all else gets darker by
/// that of the highlight. Edges on the boundary of the surface or on diffusion curves are no rim. A
/// patch without a rim has no sink: all flows to the diffusion curves around it; if there are none,
/// it is all of a component, where a constant source does nothing but show in NetSources.
struct GraphicsRegion
{
  std::vector<Id> Faces; ///< of the mesh that curves were drawn on
  /// Per channel: the colour that a flat, round patch gains in its middle. Its density is 4 pi
  /// Strength / area, with its own area.
  std::vector<double> Strength;
};

/// Asked with the bytes that all will take, and with those of them that are not held yet: what is
/// held is not free any more, so it must not count against what is.
using GraphicsMemoryCheck = std::function<Status(double bytes, double missing)>;

struct GraphicsOptions
{
  int NumberOfChannels = 3;
  /// Per channel, the mean colour that components without a diffusion curve have before Poisson
  /// curves are added; empty for 0.
  std::vector<double> Background;
  /// Flip edges until they are Delaunay before the equation is solved, for meshes with obtuse
  /// triangles: then no colour lies outside of those that are given, but next to obtuse triangles
  /// on the boundary of the surface, whose edges cannot be flipped.
  bool IntrinsicDelaunay = false;
  /// Asked while the faces on the left of regions are found, before the factorization, and whenever
  /// colours are found; may be empty.
  GraphicsMemoryCheck CheckMemory;
  ProgressCallback Progress; ///< may be empty
};

struct GraphicsResult
{
  /// Per vertex of VectorGraphics::GetSurface(), all channels after each other.
  std::vector<double> Values;
  /// Per component of the surface, cut open along diffusion curves, and per channel: what sources
  /// summed to where no diffusion curve takes it in. It was taken off, evenly over the component.
  std::vector<double> NetSources;
  /// Per vertex of GetSurface(), the component that it is in: smallest vertices first. Vertices
  /// without a face, which have the background, have components of their own.
  std::vector<Id> Components;
};

/// Poisson vector graphics on a surface (Hou, Sun, Fang, Liu, Hu, Qin, Hao, He, "Poisson vector
/// graphics", IEEE TVCG 26(2), 2020; diffusion curves: Orzan et al. 2008): -Laplace u = f, one
/// equation for each channel of colour, with natural conditions on the boundary of the surface, by
/// linear finite elements on a mesh in which the curves are chains of edges.
///
/// Diffusion curves cut the surface open; the colours on both sides are given there. At the ends
/// of open ones, where there are no sides, and where curves meet, a vertex gets the mean of the
/// colours given for it.
///
/// A Poisson curve with the colours l and r on its sides adds the Laplacian of
///
///     B = (l + r) / 2 b(min(d_l, d_r)) + (l - r) / 2 (b(d_l) - b(d_r)),   b(d) = (1 - (d/w)^2)^2,
///
/// to the right-hand side, where d_l and d_r are the geodesic distances from its left and its right
/// side on the surface cut open along all diffusion and Poisson curves, and b is 0 from the width w
/// on. So B jumps from r to l across the curve, fades within the width, and is continuous
/// everywhere else, also around ends, where d_l and d_r are the same. Where l and r change along
/// the curve, they are continued into the band as harmonic functions that have their values at both
/// sides of the curve (and natural conditions elsewhere): those of the nearest place would jump
/// where two places of the curve are as near. That is one more small system for such a curve,
/// solved whenever colours are found. Where the triangles of the band are too thin for that system,
/// as a whole, though those of the surface are not, the strengths of the nearest place are taken
/// nevertheless: one such part of a surface does not spoil the drawing. Since B and its slope end
/// at 0, the sources on each side have the sum 0, not only those of both sides together, and no
/// first moment is left either: a layer of sources h on one side and -h on the other, which is what
/// a shadow beside a highlight is at first sight, is a layer of dipoles, whose colours reach far
/// beyond any width. Here nothing changes farther away than the width, to rounding, as long as no
/// diffusion curve runs through the band; if one does, colours on it stay as they are given, and
/// what B would have added there is missing around it, nowhere by more than the largest B on it.
/// With r = -l, there is a highlight on one side and a shadow on the other; with r = l, a glow.
///
/// Discretely, B is linear in the faces of the mesh, and u = v + B with a function v that Poisson
/// curves do not cut. The equation for v has the other sources and, on diffusion curves, what is
/// left of the given colours: that is the equation for u with the Laplacian of B as source, whose
/// integrals against hat functions sum to 0 to rounding.
class DGG_CORE_EXPORT VectorGraphics
{
public:
  VectorGraphics();
  ~VectorGraphics();
  VectorGraphics(const VectorGraphics&) = delete;
  VectorGraphics& operator=(const VectorGraphics&) = delete;

  /// Bytes that Prepare() takes for each face of the surface, itself included, until it asks. To
  /// ask before that is made: refining takes less.
  static constexpr double BytesPerFace = 1100.0;

  /// Cut the surface, and factorize the matrix. `surface` is what EmbedCurves() made of `mesh`, or
  /// a refinement of it; chain k belongs to curve k. Colours and widths do not matter yet. The mesh
  /// must outlive this object.
  ///
  /// Fails where curves have no sides (CutAlongCurves()), or no length; where a region's curve is
  /// open or does not separate its left from its right.
  Status Prepare(const SurfaceMesh& mesh, const RefinedSurface& surface,
    const std::vector<CurveChain>& chains, const std::vector<GraphicsCurve>& curves,
    const GraphicsOptions& options);

  /// Find the colours. Curves are those of Prepare(), but may have other colours and widths. There
  /// must be as many numbers as needed, all finite; widths must be positive, and faces of regions
  /// exist. Fails when a colour or a net source is beyond the largest number. Numbers may be of any
  /// size otherwise: channels are scaled while they are solved for.
  Status Run(const std::vector<GraphicsCurve>& curves, const std::vector<GraphicsRegion>& regions,
    const GraphicsOptions& options, GraphicsResult& result);

  /// The surface cut open along diffusion and Poisson curves, which the values belong to.
  const CutSurface& GetSurface() const;
  /// Forget what is prepared.
  void Clear();
  /// About how many bytes are held.
  double GetEstimatedMemory() const;

private:
  struct Implementation;
  std::unique_ptr<Implementation> Internals;
};
}

#endif
