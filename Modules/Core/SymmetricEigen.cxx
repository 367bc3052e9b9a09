#include "SymmetricEigen.h"

#include <Eigen/Eigenvalues>

namespace palpate
{
SymmetricEigen::SymmetricEigen(const Eigen::MatrixXd& matrix, bool findsVectors)
{
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(
      matrix, findsVectors ? Eigen::ComputeEigenvectors : Eigen::EigenvaluesOnly);
  this->Values = solver.eigenvalues();
  if (findsVectors)
  {
    this->Vectors = solver.eigenvectors();
  }
}
} // namespace palpate
