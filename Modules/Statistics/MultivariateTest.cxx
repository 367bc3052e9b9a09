#include "MultivariateTest.h"

#include "ProbabilityDistributions.h"
#include "SymmetricEigen.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <string>

namespace palpate
{
namespace
{
/// Numbers of outcomes and of columns of the term, free degrees of the residuals.
struct Sizes
{
  double Outcomes;
  double Columns;
  double Free;

  double Fewer() const { return std::min(this->Outcomes, this->Columns); }
  double M() const { return 0.5 * (std::abs(this->Outcomes - this->Columns) - 1.0); }
  double N() const { return 0.5 * (this->Free - this->Outcomes - 1.0); }
};

MultivariateStatistic Finished(double value, double f, double numerator, double denominator)
{
  return {value, f, numerator, denominator, FisherUpper(f, numerator, denominator)};
}

MultivariateStatistic PillaiOf(const Eigen::ArrayXd& roots, const Sizes& sizes)
{
  const double value = (roots / (1.0 + roots)).sum();
  const double fewer = sizes.Fewer();
  const double a = 2.0 * sizes.M() + fewer + 1.0;
  const double b = 2.0 * sizes.N() + fewer + 1.0;
  return Finished(value, b / a * value / (fewer - value), fewer * a, fewer * b);
}

MultivariateStatistic WilksOf(const Eigen::ArrayXd& roots, const Sizes& sizes)
{
  const double value = (1.0 / (1.0 + roots)).prod();
  const double p = sizes.Outcomes;
  const double q = sizes.Columns;
  const double a = sizes.Free - 0.5 * (p - q + 1.0);
  const double b = p * p + q * q - 5.0;
  const double power = b > 0.0 ? std::sqrt((p * p * q * q - 4.0) / b) : 1.0;
  const double denominator = a * power - 0.5 * (p * q - 2.0);
  return Finished(value, (std::pow(value, -1.0 / power) - 1.0) * denominator / (p * q), p * q,
                  denominator);
}

MultivariateStatistic HotellingLawleyOf(const Eigen::ArrayXd& roots, const Sizes& sizes)
{
  const double value = roots.sum();
  const double fewer = sizes.Fewer();
  const double a = 2.0 * sizes.M() + fewer + 1.0;
  const double b = 2.0 * (fewer * sizes.N() + 1.0);
  return Finished(value, b * value / (fewer * fewer * a), fewer * a, b);
}

MultivariateStatistic RoyOf(const Eigen::ArrayXd& roots, const Sizes& sizes)
{
  const double value = roots.maxCoeff();
  const double more = std::max(sizes.Outcomes, sizes.Columns);
  const double denominator = sizes.Free - more + sizes.Columns;
  return Finished(value, denominator * value / more, more, denominator);
}
} // namespace

Status TestTogether(const LinearDesign& design, const DesignTerm& term,
                    const Eigen::MatrixXd& outcomes, MultivariateTest& test)
{
  const EffectSpace space = FindEffectSpace(design, term);
  const Eigen::Index free = design.Matrix.rows() - design.Matrix.cols();
  if (outcomes.cols() > free)
  {
    return Status::Failure(std::to_string(outcomes.cols()) + " outcomes are more than the " +
                           std::to_string(free) + " free degrees of the residuals");
  }
  const Eigen::MatrixXd explained = space.Effect.transpose() * outcomes;
  const Eigen::MatrixXd residuals =
      outcomes - space.Others * (space.Others.transpose() * outcomes) - space.Effect * explained;
  // Unit variances: the tests don't depend on the outcomes' scales, but the decomposition's
  // accuracy does.
  const Eigen::VectorXd lengths = residuals.colwise().norm();
  const Eigen::MatrixXd scaled = residuals * lengths.cwiseInverse().asDiagonal();
  const Eigen::LLT<Eigen::MatrixXd> factor(scaled.transpose() * scaled);
  if (factor.info() != Eigen::Success || !(factor.rcond() > 1e-12))
  {
    return Status::Failure("the outcomes depend on each other");
  }
  const Eigen::MatrixXd whitened =
      factor.matrixL().solve((explained * lengths.cwiseInverse().asDiagonal()).transpose());
  const SymmetricEigen parts(whitened.transpose() * whitened, false);
  const Eigen::Index count = std::min(term.Count, outcomes.cols());
  const Eigen::ArrayXd roots = parts.Values.tail(count).cwiseMax(0.0);
  const Sizes sizes{static_cast<double>(outcomes.cols()), static_cast<double>(term.Count),
                    static_cast<double>(free)};
  test = {PillaiOf(roots, sizes), WilksOf(roots, sizes), HotellingLawleyOf(roots, sizes),
          RoyOf(roots, sizes)};
  return Status::Success();
}
} // namespace palpate
