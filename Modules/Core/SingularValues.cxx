#include "SingularValues.h"

#include <Eigen/SVD>

namespace palpate
{
SingularValues SingularValuesOf(const Matrix3& matrix)
{
#if EIGEN_VERSION_AT_LEAST(3, 4, 90) // Eigen 5
  const Eigen::JacobiSVD<Matrix3, Eigen::ComputeFullU | Eigen::ComputeFullV> svd(matrix);
#else
  const Eigen::JacobiSVD<Matrix3> svd(matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
#endif
  return {svd.matrixU(), svd.singularValues(), svd.matrixV()};
}
} // namespace palpate
