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
/// L u = b with the cotangent Laplacian L, positive semidefinite, on a mesh that must outlive the
/// object.
///
/// In a component without given values, the kernel of L consists of the constants. There b is
/// balanced: its sum is subtracted in proportion to the weights w. One value is fixed at 0, the
/// others are solved for, and the weighted mean of the solution is shifted to 0. With P = I - 1
/// w^T, w summing to 1, the solution is P L^+ P^T b, whose operator is symmetric. Components
/// (through edges and shared vertices) are independent of each other. Any triangle complex is
/// accepted; orientation is irrelevant.
class PoissonSystem : public LaplaceSystem
{
public:
  /// Cotangents beyond this are scaled down (CotanLaplacian). Such edges conduct so well that the
  /// values at their ends agree in either case.
  static constexpr double LargestCotangent = 1e6;

  explicit PoissonSystem(const SurfaceMesh& mesh);

  /// Computes the triangulation, the matrices and the elimination order.
  Status Analyze(const PoissonOptions& options, const ProgressCallback& progress);
  /// Factorizes the system. To be called after Analyze().
  Status Factorize(const ProgressCallback& progress = {});
  /// Increases whenever changed options modify the matrix or the weights, which invalidates derived
  /// data.
  std::uint64_t GetRevision() const { return this->Revision; }
  bool IsReady() const { return this->IsAnalyzed && this->Factor.IsComputed(); }

  const PoissonOptions& GetOptions() const { return this->Options; }
  const SurfaceMesh& GetMesh() const { return this->Mesh; }
  /// Returns the triangles of the elements. Without flips, these are the triangles of the mesh in
  /// the same order, without dropped faces.
  const IntrinsicTriangulation& GetTriangulation() const { return this->Triangulation; }
  std::array<double, 3> GetCotangents(Id face) const;
  /// Returns the triangle of a face of the mesh, if no edge is flipped; NoId for a dropped face.
  Id GetTriangleOf(Id face) const { return this->TriangleOfFace[face]; }

  Id GetNumberOfVertices() const { return static_cast<Id>(this->Components.size()); }
  using LaplaceSystem::GetComponent;
  /// Returns the component of a point on the mesh.
  Id GetComponent(const SurfacePoint& point) const
  {
    return this->Components[IsVertex(point) ? point.Vertex : this->Mesh.Origin(3 * point.Face)];
  }
  /// Returns, per vertex, a third of the areas of its faces.
  const std::vector<double>& GetAreas() const { return this->Areas; }
  double GetArea(Id v) const { return this->Areas[v]; }
  /// Returns the weight of the vertex in means over its component.
  double GetWeight(Id v) const { return this->Weights[v]; }
  double GetComponentArea(Id c) const { return this->ComponentAreas[c]; }
  double GetMeanEdge(Id c) const { return this->MeanEdges[c]; }
  /// Returns the area-weighted mean of the longest sides of triangles: larger than the mean edge if
  /// many small triangles occur beside large ones, as on CAD models.
  double GetMeanLongestSide(Id c) const { return this->MeanLongestSides[c]; }
  bool HasBoundary(Id c) const { return this->ComponentHasBoundary[c] != 0; }
  /// Returns true if the value of the vertex is given.
  bool IsFixed(Id v) const { return this->Fixed[v] != 0; }
  /// Returns true if all corners with non-zero weight at a point have given values.
  bool IsFixed(const SurfacePoint& point) const;
  /// Returns true if no value is given in the component.
  bool IsFree(Id c) const { return this->ComponentHasDirichlet[c] == 0; }

  /// Returns true if the triangles of the component are too thin for accurate solutions; a few thin
  /// triangles are harmless. To be called after Factorize(), which fails if this holds for the
  /// entire surface.
  bool IsThin(Id c) const { return this->ComponentIsThin[c] != 0; }
  /// Returns true if any component is too thin, also after Factorize() failed for that reason.
  bool HasThin() const;

  /// Returns L f.
  std::vector<double> Multiply(const std::vector<double>& f) const;
  /// Returns L, indexed by vertices.
  const Eigen::SparseMatrix<double>& GetStiffness() const { return this->Stiffness; }
  const EliminationOrder& GetOrder() const { return this->Order; }
  /// Returns true if the value of the vertex is the one fixed at 0 in its component. To be called
  /// after Analyze().
  bool IsPinned(Id v) const { return this->Pinned[this->Components[v]] == v; }

  /// Replaces integrated sources (at vertices with given values, these values) by the solution. May
  /// be called by several threads simultaneously.
  void Solve(std::vector<double>& values) const;
  /// Solves for several right-hand sides. More than four are solved together, eight at a time, in
  /// about half the time per right-hand side.
  void Solve(std::vector<std::vector<double>>& columns) const;
  /// Solves for one right-hand side per lane, for loops that need them interleaved.
  void Solve(std::vector<SparseLanes>& block) const;

  /// Replaces a density by sources: its integrals with lumped areas, 0 at given values.
  void Integrate(std::vector<double>& density) const;
  /// Solves L M^-1 L u = b, with the areas M: solve, integrate, solve. Given values are 0.
  void SolveBiLaplace(std::vector<std::vector<double>>& columns) const;

  /// Subtracts the weighted mean in components without given values.
  template <typename Number>
  void Center(std::vector<Number>& values) const;

  /// Returns the estimated peak memory of the factorization in bytes, at most twice the actual
  /// size. To be called after Analyze().
  double GetEstimatedMemory() const;
  Offset GetNumberOfFactorEntries() const { return this->Order.GetNumberOfFactorEntries(); }
  /// Returns the number of factorizations so far, for tests.
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
  std::vector<double> Diagonal;                    // per vertex, diagonal of the stiffness
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
