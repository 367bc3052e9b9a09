#include "DescriptionLength.h"

#include "SymmetricEigen.h"

#include <cmath>

namespace palpate
{
DescriptionLength MeasureDescriptionLength(const Eigen::MatrixXd& shapes, double noise,
                                           bool findsPull)
{
  const Eigen::Index count = shapes.cols();
  const Eigen::VectorXd mean = shapes.rowwise().mean();
  const Eigen::MatrixXd centred = shapes.colwise() - mean;
  Eigen::MatrixXd products = Eigen::MatrixXd::Zero(count, count);
  products.selfadjointView<Eigen::Lower>().rankUpdate(centred.transpose(),
                                                      1.0 / static_cast<double>(count - 1));
  const SymmetricEigen parts(products, findsPull);
  const Eigen::ArrayXd variances = parts.Values.array().max(0.0);
  DescriptionLength length;
  length.Variance = variances.sum();
  for (const double variance : variances)
  {
    length.Value += std::log1p(variance / noise);
  }
  if (findsPull)
  {
    const Eigen::MatrixXd& modes = parts.Vectors;
    const Eigen::VectorXd slopes = (variances + noise).inverse().matrix();
    length.Pull = modes * slopes.asDiagonal() * modes.transpose();
    const Eigen::VectorXd rows = length.Pull.rowwise().mean();
    length.Pull.colwise() -= rows;
    length.Pull.rowwise() -= length.Pull.colwise().mean().eval();
  }
  return length;
}
} // namespace palpate
