#include "CoefficientDistribution.h"

#include "ShapeMirror.h"

#include <cmath>

namespace palpate
{
namespace
{
constexpr double GroupShare = 0.6; // of the covariance; the rest is its diagonal by degree
constexpr double VarianceFloor = 1e-12;

// Of each coefficient under x to -x.
Eigen::VectorXd MirrorSigns(Eigen::Index count)
{
  Eigen::VectorXd signs(count);
  Eigen::Index at = 0;
  for (int degree = 0; at < count; ++degree)
  {
    for (int order = -degree; order <= degree; ++order)
    {
      signs[at++] = MirrorSign(order);
    }
  }
  return signs;
}

// Whether mirroring changes the mean by less than half of the cases' own spread.
bool IsSymmetric(const Eigen::MatrixXd& cases, const Eigen::VectorXd& signs)
{
  const Eigen::VectorXd mean = cases.colwise().mean();
  const Eigen::MatrixXd rest = cases.rowwise() - mean.transpose();
  double odd = 0.0;
  double spread = 0.0;
  for (Eigen::Index c = 0; c < cases.cols(); ++c)
  {
    if (signs[c] < 0.0)
    {
      odd += mean[c] * mean[c];
      spread += rest.col(c).squaredNorm() / static_cast<double>(cases.rows() - 1);
    }
  }
  return odd <= 0.25 * spread;
}

Eigen::MatrixXd Shrunk(const Eigen::MatrixXd& covariance)
{
  Eigen::MatrixXd made = GroupShare * covariance;
  Eigen::Index at = 0;
  for (Eigen::Index orders = 1; at < covariance.rows(); orders += 2)
  {
    const double mean = covariance.diagonal().segment(at, orders).mean();
    made.diagonal().segment(at, orders).array() += (1.0 - GroupShare) * mean + VarianceFloor;
    at += orders;
  }
  return made;
}
} // namespace

CoefficientDistribution::CoefficientDistribution(const Eigen::MatrixXd& cases)
{
  const Eigen::VectorXd signs = MirrorSigns(cases.cols());
  Eigen::MatrixXd rows = cases;
  this->IsMirrored = IsSymmetric(cases, signs);
  if (this->IsMirrored)
  {
    rows.conservativeResize(2 * cases.rows(), Eigen::NoChange);
    rows.bottomRows(cases.rows()) = cases * signs.asDiagonal();
  }
  this->Mean = rows.colwise().mean();
  rows.rowwise() -= this->Mean.transpose();
  Eigen::MatrixXd sample = Eigen::MatrixXd::Zero(cases.cols(), cases.cols());
  sample.selfadjointView<Eigen::Lower>().rankUpdate(rows.transpose(),
                                                    1.0 / static_cast<double>(rows.rows() - 1));
  sample.triangularView<Eigen::StrictlyUpper>() = sample.transpose();
  this->Covariance = Shrunk(sample);
}
} // namespace palpate
