#pragma once

#include <Eigen/Core>

namespace palpate
{
/// A = U diag(Values) Vᵀ, with min(rows, columns) singular values in descending order.
///
/// Eigen's divide and conquer, which takes long to compile and is therefore compiled once.
struct ThinSvd
{
  explicit ThinSvd(const Eigen::MatrixXd& matrix);

  Eigen::VectorXd Values;
  Eigen::MatrixXd U;
  Eigen::MatrixXd V;
};
} // namespace palpate
