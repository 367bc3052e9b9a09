#include "LinearModel.h"

#include "ProbabilityDistributions.h"

#include <Eigen/QR>

#include <cmath>
#include <limits>

namespace palpate
{
namespace
{
Eigen::MatrixXd OrthonormalBasis(const Eigen::MatrixXd& columns)
{
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(columns);
  Eigen::MatrixXd basis =
      qr.householderQ() * Eigen::MatrixXd::Identity(columns.rows(), columns.cols());
  // Each column grows with the one that it comes from.
  for (Eigen::Index k = 0; k < basis.cols(); ++k)
  {
    if (qr.matrixQR()(k, k) < 0.0)
    {
      basis.col(k) = -basis.col(k);
    }
  }
  return basis;
}
} // namespace

Eigen::MatrixXd LinearModel::ConfidenceWidths(double confidence) const
{
  return StudentQuantile(confidence, static_cast<double>(this->FreeDegrees)) * this->StandardErrors;
}

LinearModel FitLinearModel(const LinearDesign& design, const LinearOutcomes& outcomes)
{
  const Eigen::MatrixXd& matrix = design.Matrix;
  const Eigen::Index count = matrix.cols();
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(matrix);
  LinearModel model;
  model.FreeDegrees = matrix.rows() - count;
  const Eigen::MatrixXd fitted = qr.solve(outcomes.Factors());
  model.Coefficients = outcomes.Spread(fitted);
  model.ResidualSquares = outcomes.SquaredNorms(outcomes.Factors() - matrix * fitted);
  const Eigen::MatrixXd inverse = qr.matrixQR().topRows(count).triangularView<Eigen::Upper>().solve(
      Eigen::MatrixXd::Identity(count, count));
  const Eigen::VectorXd lengths = inverse.rowwise().norm();
  const Eigen::VectorXd deviations =
      (model.ResidualSquares / static_cast<double>(model.FreeDegrees)).cwiseSqrt();
  model.StandardErrors = lengths * deviations.transpose();
  return model;
}

EffectSpace FindEffectSpace(const LinearDesign& design, const DesignTerm& term)
{
  const Eigen::MatrixXd& matrix = design.Matrix;
  const Eigen::Index others = matrix.cols() - term.Count;
  const Eigen::Index after = term.First + term.Count;
  Eigen::MatrixXd ordered(matrix.rows(), matrix.cols());
  ordered << matrix.leftCols(term.First), matrix.rightCols(matrix.cols() - after),
      matrix.middleCols(term.First, term.Count);
  const Eigen::MatrixXd basis = OrthonormalBasis(ordered);
  return {basis.rightCols(term.Count), basis.leftCols(others)};
}

TermTest TestTerm(const LinearDesign& design, const DesignTerm& term, const LinearModel& model,
                  const LinearOutcomes& outcomes)
{
  const EffectSpace space = FindEffectSpace(design, term);
  const Eigen::VectorXd explained =
      outcomes.SquaredNorms(space.Effect.transpose() * outcomes.Factors());
  const auto numerator = static_cast<double>(term.Count);
  const auto denominator = static_cast<double>(model.FreeDegrees);
  TermTest test;
  test.F = (explained / numerator).cwiseQuotient(model.ResidualSquares / denominator);
  test.PartialR2 = explained.cwiseQuotient(explained + model.ResidualSquares);
  test.P = test.F.unaryExpr([&](double f) { return FisherUpper(f, numerator, denominator); });
  return test;
}
} // namespace palpate
