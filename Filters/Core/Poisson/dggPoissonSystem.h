// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The Poisson equation on a surface, factorized once. Internal.
#ifndef dggPoissonSystem_h
#define dggPoissonSystem_h

#include "dggLaplaceSystem.h" // for the Laplacian
#include "dggPoissonSolver.h" // for the options
#include "dggSurfaceMesh.h"   // for SurfaceMesh
#include "dggSurfacePoint.h"  // for SurfacePoint

#include <Eigen/SparseCore> // for the matrix

#include <array>   // for cotangents
#include <cstdint> // for flags
#include <vector>  // for arrays

namespace dgg
{
/// L u = b with the cotangent Laplacian L, positive semidefinite, on a mesh that must outlive it.
///
/// In a component without given values, L has the constants as kernel. There b is balanced: what
/// it sums to is taken off in proportion to the weights w. One value is held at 0, the rest is
/// solved for, and the weighted mean of the solution is made 0. With P = I - 1 w^T, w summing to 1,
/// that is P L^+ P^T, which is symmetric. Components (through edges and shared vertices) do not
/// know of each other. Any triangle complex will do; orientation plays no part.
class PoissonSystem : public LaplaceSystem
{
public:
  /// Cotangents beyond this are scaled down (MakeCotanLaplacian()). Edges that short conduct so
  /// well that values at their ends are the same either way.
  static constexpr double LargestCotangent = 1e6;

  explicit PoissonSystem(const SurfaceMesh& mesh);

  /// Triangulation, matrices, order of elimination.
  Status Analyze(const PoissonOptions& options, const ProgressCallback& progress);
  /// After Analyze().
  Status Factorize(const ProgressCallback& progress = {});
  /// Grows whenever other options change the matrix or the weights, which makes what was computed
  /// with them out of date.
  std::uint64_t GetRevision() const { return this->Revision; }
  bool IsReady() const { return this->IsAnalyzed && this->Factor.IsComputed(); }

  const PoissonOptions& GetOptions() const { return this->Options; }
  const SurfaceMesh& GetMesh() const { return this->Mesh; }
  /// The triangles whose hat functions are the elements; those of the mesh where nothing was
  /// flipped, in the same order, without the dropped ones.
  const IntrinsicTriangulation& GetTriangulation() const { return this->Triangulation; }
  std::array<double, 3> GetCotangents(Id face) const;
  /// Which triangle a face of the mesh is, as long as nothing is flipped; NoId for a dropped face.
  Id GetTriangleOf(Id face) const { return this->TriangleOfFace[face]; }

  Id GetNumberOfVertices() const { return static_cast<Id>(this->Components.size()); }
  using LaplaceSystem::GetComponent;
  /// Of a point that is on the mesh.
  Id GetComponent(const SurfacePoint& point) const
  {
    return this->Components[IsVertex(point) ? point.Vertex : this->Mesh.Origin(3 * point.Face)];
  }
  /// A third of the areas of the faces around a vertex.
  const std::vector<double>& GetAreas() const { return this->Areas; }
  double GetArea(Id v) const { return this->Areas[v]; }
  /// Part of the vertex in means over its component.
  double GetWeight(Id v) const { return this->Weights[v]; }
  double GetComponentArea(Id c) const { return this->ComponentAreas[c]; }
  double GetMeanEdge(Id c) const { return this->MeanEdges[c]; }
  /// The longest sides of triangles, in the mean over the area: more than the mean edge where many
  /// small triangles are beside large ones, as on parts of machines.
  double GetMeanLongestSide(Id c) const { return this->MeanLongestSides[c]; }
  bool HasBoundary(Id c) const { return this->ComponentHasBoundary[c] != 0; }
  /// Whether the value of the vertex is given.
  bool IsFixed(Id v) const { return this->Fixed[v] != 0; }
  /// Whether all corners that matter to a point have given values.
  bool IsFixed(const SurfacePoint& point) const;
  /// Whether no value is given in the component.
  bool IsFree(Id c) const { return this->ComponentHasDirichlet[c] == 0; }

  /// Whether the triangles of the component are too thin for solutions there to be right. A few
  /// thin ones do no harm. After Factorize(), which fails when that is so of the whole surface.
  bool IsThin(Id c) const { return this->ComponentIsThin[c] != 0; }
  /// Whether that is so of any component, also where it is what Factorize() failed for.
  bool HasThin() const;

  /// L f.
  std::vector<double> Multiply(const std::vector<double>& f) const;
  /// L, vertex by vertex.
  const Eigen::SparseMatrix<double>& GetStiffness() const { return this->Stiffness; }
  const EliminationOrder& GetOrder() const { return this->Order; }
  /// Whether the value of the vertex is the one that is held at 0 in its component. After
  /// Analyze().
  bool IsPinned(Id v) const { return this->Pinned[this->Components[v]] == v; }

  /// Replace integrated sources (at vertices with given values, these values) by the solution. May
  /// be called by several threads at once.
  void Solve(std::vector<double>& values) const;
  /// Several right-hand sides. More than four are solved for together, eight at a time, in about
  /// half the time for each.
  void Solve(std::vector<std::vector<double>>& columns) const;
  /// As many systems as lanes, for loops that need them side by side.
  void Solve(std::vector<SparseLanes>& block) const;

  /// Replace a density by sources: its integrals with lumped areas, 0 where values are given.
  void Integrate(std::vector<double>& density) const;
  /// L M^-1 L u = b, M the areas: solve, integrate, solve. Given values are 0.
  void SolveBiLaplace(std::vector<std::vector<double>>& columns) const;

  /// Take the weighted mean off in components without given values.
  template <typename Number>
  void Center(std::vector<Number>& values) const;

  /// Bytes that all takes while it is factorized, at most twice what they are. After Analyze().
  double GetEstimatedMemory() const;
  Offset GetNumberOfFactorEntries() const { return this->Order.GetNumberOfFactorEntries(); }
  /// Factorizations done so far, for tests.
  int GetNumberOfFactorizations() const { return this->NumberOfFactorizations; }

private:
  bool NeedsRefinement() const;
  Status CheckDirichletVertices(const std::vector<Id>& vertices) const;
  void MeasureComponents();
  void MarkDirichletVertices();
  void SetWeights();
  template <typename Number>
  void Balance(std::vector<Number>& values) const;
  template <typename Number>
  void TakeDirichletValuesOff(std::vector<Number>& values) const;
  template <typename Number>
  void SolveOnce(std::vector<Number>& values) const;
  void Refine(const std::vector<double>& sources, std::vector<double>& solution) const;

  PoissonOptions Options;
  bool IsAnalyzed = false;
  int NumberOfFactorizations = 0;
  std::uint64_t Revision = 0;
  double LargestEntry = 0.0;

  std::vector<Id> TriangleOfFace;
  std::vector<double> Weights;                     // per vertex
  std::vector<double> Diagonal;                    // per vertex, of the stiffness
  std::vector<std::uint8_t> Fixed;                 // per vertex
  std::vector<double> ComponentAreas;              // per component
  std::vector<double> MeanEdges;                   // per component
  std::vector<double> MeanLongestSides;            // per component
  std::vector<std::uint8_t> ComponentHasBoundary;  // per component
  std::vector<std::uint8_t> ComponentHasDirichlet; // per component
  std::vector<std::uint8_t> ComponentIsThin;       // per component
  SparseFactor Factor;
};
}

#endif
