#pragma once

#include <Eigen/Core>

namespace palpate
{
/// Many outcomes per case, of which each is a linear combination of a case's factors: the points of
/// a surface from the coefficients of its shape. Where there are fewer factors than cases, products
/// and sums are taken of the factors, so that memory does not grow by cases times outcomes.
class LinearOutcomes
{
public:
  /// Outcomes that are given themselves: cases x outcomes.
  LinearOutcomes(Eigen::MatrixXd outcomes);
  /// `factors` (cases x factors) times `perFactor` (factors x outcomes).
  LinearOutcomes(Eigen::MatrixXd factors, Eigen::MatrixXd perFactor);

  Eigen::Index CaseCount() const { return this->Values.rows(); }
  Eigen::Index OutcomeCount() const
  {
    return this->IsFactored() ? this->Map.cols() : this->Values.cols();
  }

  /// The factors, or the outcomes themselves: what `Spread` takes the rows of.
  const Eigen::MatrixXd& Factors() const { return this->Values; }
  /// The outcomes of combinations of cases: of rows that were made from those of Factors.
  Eigen::MatrixXd Spread(const Eigen::Ref<const Eigen::MatrixXd>& rows) const;
  /// The sum of squares of each outcome over such rows.
  Eigen::VectorXd SquaredNorms(const Eigen::Ref<const Eigen::MatrixXd>& rows) const;

  bool IsFactored() const { return this->Map.size() > 0; }
  /// Factors x outcomes; empty if Factors are the outcomes themselves.
  const Eigen::MatrixXd& PerFactor() const { return this->Map; }

private:
  Eigen::MatrixXd Values;
  Eigen::MatrixXd Map; ///< empty: Values are the outcomes
};
} // namespace palpate
