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
};
} // namespace

const EigenPeers& PALPATE_EIGEN_PEERS()
{
  static const Peers peers;
  return peers;
}
} // namespace palpate::bench
