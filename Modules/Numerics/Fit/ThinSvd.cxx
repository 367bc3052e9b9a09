#include "ThinSvd.h"

#include <Eigen/SVD>

namespace palpate
{
ThinSvd::ThinSvd(const Eigen::MatrixXd& matrix)
{
  const Eigen::BDCSVD<Eigen::MatrixXd> svd(matrix, Eigen::ComputeThinU | Eigen::ComputeThinV);
  this->Values = svd.singularValues();
  this->U = svd.matrixU();
  this->V = svd.matrixV();
}
} // namespace palpate
