#include "ThinSvd.h"

#include <Eigen/SVD>

namespace palpate
{
ThinSvd::ThinSvd(const Eigen::MatrixXd& matrix)
{
  constexpr int Parts = Eigen::ComputeThinU | Eigen::ComputeThinV;
#if EIGEN_VERSION_AT_LEAST(3, 4, 90) // Eigen 5
  const Eigen::BDCSVD<Eigen::MatrixXd, Parts> svd(matrix);
#else
  const Eigen::BDCSVD<Eigen::MatrixXd> svd(matrix, Parts);
#endif
  this->Values = svd.singularValues();
  this->U = svd.matrixU();
  this->V = svd.matrixV();
}
} // namespace palpate
