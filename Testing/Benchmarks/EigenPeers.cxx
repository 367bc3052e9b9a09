#include "PeerLibraries.h"

#include <Eigen/Cholesky>
#include <Eigen/QR>

namespace palpate::bench
{
namespace
{
using Matrix = Eigen::MatrixXd;
using ConstMatrix = Eigen::Map<const Matrix>;
using ConstVector = Eigen::Map<const Eigen::VectorXd>;
using VectorMap = Eigen::Map<Eigen::VectorXd>;
using Index = std::ptrdiff_t;

class Peers final : public EigenPeers
{
  void NormalEquations(const double* design, Index rows, Index columns, const double* right,
                       double* solution) const override
  {
    const ConstMatrix a(design, rows, columns);
    Matrix gram = Matrix::Zero(columns, columns);
    gram.selfadjointView<Eigen::Lower>().rankUpdate(a.transpose());
    VectorMap(solution, columns) =
        Eigen::LLT<Eigen::Ref<Matrix>>(gram).solve(a.transpose() * ConstVector(right, rows));
  }
  void Householder(const double* design, Index rows, Index columns, const double* right,
                   double* solution) const override
  {
    VectorMap(solution, columns) = Eigen::HouseholderQR<Matrix>(ConstMatrix(design, rows, columns))
                                       .solve(ConstVector(right, rows));
  }
  void PivotedHouseholder(const double* design, Index rows, Index columns, const double* right,
                          double* solution) const override
  {
    VectorMap(solution, columns) =
        Eigen::ColPivHouseholderQR<Matrix>(ConstMatrix(design, rows, columns))
            .solve(ConstVector(right, rows));
  }
  void Multiply(const double* matrix, Index rows, Index columns, const double* vector,
                double* result) const override
  {
    VectorMap(result, rows).noalias() =
        ConstMatrix(matrix, rows, columns) * ConstVector(vector, columns);
  }
  void RankUpdate(double* factor, Index size, const double* vector, double sigma) const override
  {
    Eigen::Map<Matrix> l(factor, size, size);
    Eigen::internal::llt_inplace<double, Eigen::Lower>::rankUpdate(l, ConstVector(vector, size),
                                                                   sigma);
  }
  void SolveByFactor(const double* factor, Index size, const double* right,
                     double* solution) const override
  {
    const ConstMatrix l(factor, size, size);
    VectorMap x(solution, size);
    x = ConstVector(right, size);
    l.triangularView<Eigen::Lower>().solveInPlace(x);
    l.triangularView<Eigen::Lower>().adjoint().solveInPlace(x);
  }
};
} // namespace

const EigenPeers& PALPATE_EIGEN_PEERS()
{
  static const Peers peers;
  return peers;
}
} // namespace palpate::bench
