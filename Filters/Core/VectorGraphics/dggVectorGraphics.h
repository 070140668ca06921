// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Poisson vector graphics: smooth colors on a surface, defined by few curves and regions.
#ifndef dggVectorGraphics_h
#define dggVectorGraphics_h

#include "dggCoreExport.h"     // for DGG_CORE_EXPORT
#include "dggCurveEmbedding.h" // for CurveChain
#include "dggSubMesh.h"        // for SubMesh
#include "dggSurfaceMesh.h"    // for SurfaceMesh

#include <functional> // for checks of memory
#include <memory>     // for prepared data
#include <string>     // for names
#include <vector>     // for curves and values

namespace dgg
{
/// Effect of a curve on the surrounding colors.
enum class GraphicsCurveType
{
  Diffusion, ///< prescribes the colors on its left and on its right
  Poisson,   ///< adds colors on its left and right that fade within a width
  Region,    ///< closed: a source on its left, balanced by a sink along the curve
  Source     ///< adds a given flux of color per length
};

/// A curve of the drawing. Values are specified at the given points of the curve, all channels of a
/// point consecutively, and interpolated linearly in between by length along the curve.
struct GraphicsCurve
{
  GraphicsCurveType Type = GraphicsCurveType::Diffusion;
  bool IsClosed = false;
  /// Diffusion curve: color on the left. Poisson curve: color added directly at the curve on the
  /// left. Region: see GraphicsRegion::Strength, at the first point. Source: flux per length.
  std::vector<double> Left;
  /// Color on the right, for diffusion and Poisson curves.
  std::vector<double> Right;
  /// Poisson curve: geodesic distance at which the contribution ends.
  double Width = 0.0;
  /// Name in messages; empty for "curve" and its index.
  std::string Name;
};

/// A set of faces with sources. Each of its patches, connected through edges that are not on
/// diffusion curves, has a source of constant density, and an equally strong sink along its
/// boundary, constant per length, so that distant colors hardly change: a round patch changes
/// nothing outside; a patch of another shape leaves a quadrupole, which is 2.4 % of the height of
/// the highlight at a distance of twice the longer half axis of an ellipse 2 : 1 on a plane, 3.6 %
/// at 5 : 1, and a quarter of that at twice the distance. If no color is given, the mean is
/// preserved, so that everything else becomes darker by the mean of the highlight. Edges on the
/// boundary of the surface or on diffusion curves do not count as the boundary of a patch. A patch
/// without boundary has no sink: everything flows to the diffusion curves around it; if there are
/// none, the patch is an entire component, where a constant source only affects NetSources.
struct GraphicsRegion
{
  std::vector<Id> Faces; ///< faces of the mesh on which curves were drawn
  /// Per channel: the color that a flat, round patch gains at its center. The source density is 4
  /// pi Strength / area, with the area of the patch.
  std::vector<double> Strength;
};

/// Called with the total bytes needed, and the part of them that is not yet allocated: allocated
/// memory is no longer free, so that it must not be compared with free memory.
using GraphicsMemoryCheck = std::function<Status(double bytes, double missing)>;

struct GraphicsOptions
{
  int NumberOfChannels = 3;
  /// Per channel, the mean color of components without a diffusion curve, before Poisson curves are
  /// added; empty means 0.
  std::vector<double> Background;
  /// If true, edges are flipped until they are Delaunay before the equation is solved, for meshes
  /// with obtuse triangles. Then no color lies outside the range of the given ones, except next to
  /// obtuse triangles on the boundary of the surface, whose boundary edges cannot be flipped.
  bool IntrinsicDelaunay = false;
  /// Called while the faces on the left of regions are located, before the factorization, and
  /// whenever colors are computed; may be empty.
  GraphicsMemoryCheck CheckMemory;
  ProgressCallback Progress; ///< may be empty
};

struct GraphicsResult
{
  /// Per vertex of VectorGraphics::GetSurface(), all channels consecutively.
  std::vector<double> Values;
  /// Per component of the surface cut open along diffusion curves, and per channel: the sum of
  /// sources in components without a diffusion curve that absorbs it. It was subtracted uniformly
  /// over the component.
  std::vector<double> NetSources;
  /// Per vertex of GetSurface(), its component, ordered by smallest vertex. Vertices without a
  /// face, which have the background color, form components of their own.
  std::vector<Id> Components;
  /// A warning about Poisson curves that are too short for their widths; empty if none is.
  std::string Warning;
};

/// Poisson vector graphics on a surface.
///
/// Solves -Laplace u = f, one equation per color channel, with natural boundary conditions, by
/// linear finite elements on a mesh in which the curves are chains of edges (Hou et al., "Poisson
/// vector graphics", IEEE TVCG 26(2), 2020; diffusion curves: Orzan et al. 2008).
///
/// Diffusion curves cut the surface open; the colors on both sides are given. At the ends of open
/// curves, which have no sides, and where curves meet, a vertex gets the mean of the colors given
/// for it.
///
/// A Poisson curve with the colors l and r on its sides adds the Laplacian of
///
///     B = (l + r) / 2 b(min(d_l, d_r)) + (l - r) / 2 (b(d_l) - b(d_r)),   b(d) = (1 - (d/w)^2)^2,
///
/// to the right-hand side, where d_l and d_r are the geodesic distances from its left and its right
/// side on the surface cut open along all diffusion and Poisson curves, and b is 0 from the width w
/// on. Thus B jumps from r to l across the curve, fades within the width, and is continuous
/// everywhere else, also around ends, where d_l and d_r are equal. On a curve that is shorter than
/// 2 w and open, the jump is nowhere complete; if less than half of it remains, Run() warns.
class DGG_CORE_EXPORT VectorGraphics
{
public:
  VectorGraphics();
  ~VectorGraphics();
  VectorGraphics(const VectorGraphics&) = delete;
  VectorGraphics& operator=(const VectorGraphics&) = delete;

  /// Memory in bytes per face of the surface, including the surface itself, that Prepare() needs
  /// before it calls the memory check. For checks before the surface is built: refinement needs
  /// less.
  static constexpr double BytesPerFace = 1100.0;

  /// Cuts the surface, and factorizes the matrix. `surface` is the result of EmbedCurves() for
  /// `mesh`, or a refinement of it; chain k belongs to curve k. Colors and widths are not used yet.
  /// The mesh must outlive this object.
  ///
  /// Fails if curves have no sides (CutAlongCurves()) or no length, or if a region's curve is open
  /// or does not separate its left from its right.
  Status Prepare(const SurfaceMesh& mesh, const SubMesh& surface,
    const std::vector<CurveChain>& chains, const std::vector<GraphicsCurve>& curves,
    const GraphicsOptions& options);

  /// Computes the colors. Curves must be the curves of Prepare(), but may have other colors and
  /// widths. The number of values must match, all values must be finite, widths positive, and faces
  /// of regions must exist. Fails if a color or a net source overflows. Values may otherwise be of
  /// any magnitude: channels are scaled during the solution.
  Status Run(const std::vector<GraphicsCurve>& curves, const std::vector<GraphicsRegion>& regions,
    const GraphicsOptions& options, GraphicsResult& result);

  /// Returns the surface cut open along diffusion and Poisson curves, to which the values belong.
  const SubMesh& GetSurface() const;
  /// Releases prepared data.
  void Clear();
  /// Returns the approximate memory in bytes.
  double GetEstimatedMemory() const;

private:
  struct Implementation;
  std::unique_ptr<Implementation> Internals;
};
}

#endif
