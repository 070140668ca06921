// SPDX-FileCopyrightText: Copyright (c) vtkDGG authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PeerPoisson.h"

#include <igl/cotmatrix.h>
#include <igl/harmonic.h>
#include <igl/massmatrix.h>
#include <igl/min_quad_with_fixed.h>

namespace
{
class PeerLibigl : public PeerPoisson
{
public:
  PeerLibigl(const MeshArrays& mesh, int power)
    : Power(power)
    , Points(static_cast<Eigen::Index>(mesh.GetNumberOfVertices()), 3)
    , Faces(static_cast<Eigen::Index>(mesh.GetNumberOfFaces()), 3)
  {
    for (Eigen::Index k = 0; k < 3; ++k)
    {
      for (Eigen::Index v = 0; v < this->Points.rows(); ++v)
      {
        this->Points(v, k) = mesh.Points[3 * v + k];
      }
      for (Eigen::Index f = 0; f < this->Faces.rows(); ++f)
      {
        this->Faces(f, k) = mesh.Triangles[3 * f + k];
      }
    }
  }

  bool Prepare() override
  {
    Eigen::SparseMatrix<double> laplacian; // negative semidefinite
    igl::cotmatrix(this->Points, this->Faces, laplacian);
    Eigen::SparseMatrix<double> matrix = -laplacian;
    if (this->Power > 1)
    {
      Eigen::SparseMatrix<double> mass;
      igl::massmatrix(this->Points, this->Faces, igl::MASSMATRIX_TYPE_BARYCENTRIC, mass);
      igl::harmonic(laplacian, mass, this->Power, matrix);
    }
    const Eigen::VectorXi known = Eigen::VectorXi::Zero(1);
    this->Data = std::make_unique<igl::min_quad_with_fixed_data<double>>();
    return igl::min_quad_with_fixed_precompute(
      matrix, known, Eigen::SparseMatrix<double>(), true, *this->Data);
  }

  bool Solve(const std::vector<double>& sources, std::vector<double>& solution) override
  {
    const Eigen::VectorXd linear =
      -Eigen::Map<const Eigen::VectorXd>(sources.data(), static_cast<Eigen::Index>(sources.size()));
    const Eigen::VectorXd given = Eigen::VectorXd::Zero(1);
    Eigen::VectorXd values;
    const bool isSolved =
      igl::min_quad_with_fixed_solve(*this->Data, linear, given, Eigen::VectorXd(), values);
    solution.assign(values.data(), values.data() + values.size());
    return isSolved;
  }

private:
  int Power;
  Eigen::MatrixXd Points;
  Eigen::MatrixXi Faces;
  std::unique_ptr<igl::min_quad_with_fixed_data<double>> Data;
};
}

std::unique_ptr<PeerPoisson> MakePeerLibigl(const MeshArrays& mesh, int power)
{
  return std::make_unique<PeerLibigl>(mesh, power);
}
