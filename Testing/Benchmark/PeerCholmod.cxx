// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PeerPoisson.h"

#include "dggLaplaceSystem.h"

#include <Eigen/CholmodSupport>

namespace
{
class PeerCholmod : public PeerPoisson
{
public:
  explicit PeerCholmod(const MeshArrays& mesh)
  {
    dgg::SurfaceMesh::FromPoints(mesh.Points.data(),
      static_cast<dgg::Offset>(mesh.GetNumberOfVertices()), mesh.Triangles.data(),
      static_cast<dgg::Offset>(mesh.GetNumberOfFaces()), this->Surface);
  }

  bool Prepare() override
  {
    const Eigen::SparseMatrix<double> whole =
      dgg::MakeCotanLaplacian(dgg::IntrinsicTriangulation(this->Surface)).Stiffness;
    // The last vertex, whose value is fixed, is excluded.
    const Eigen::SparseMatrix<double> matrix =
      whole.topLeftCorner(whole.rows() - 1, whole.cols() - 1);
    this->Decomposition.compute(matrix);
    return this->Decomposition.info() == Eigen::Success;
  }

  bool Solve(const std::vector<double>& sources, std::vector<double>& solution) override
  {
    const auto n = static_cast<Eigen::Index>(sources.size());
    solution.assign(sources.size(), 0.0);
    Eigen::Map<Eigen::VectorXd>(solution.data(), n - 1) =
      this->Decomposition.solve(Eigen::Map<const Eigen::VectorXd>(sources.data(), n - 1));
    return this->Decomposition.info() == Eigen::Success;
  }

private:
  dgg::SurfaceMesh Surface;
  Eigen::CholmodDecomposition<Eigen::SparseMatrix<double>> Decomposition;
};
}

std::unique_ptr<PeerPoisson> MakePeerCholmod(const MeshArrays& mesh)
{
  return std::make_unique<PeerCholmod>(mesh);
}
