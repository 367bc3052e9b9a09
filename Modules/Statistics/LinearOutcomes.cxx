#include "LinearOutcomes.h"

#include <algorithm>
#include <utility>

namespace palpate
{
namespace
{
constexpr Eigen::Index RowsAtOnce = 64; // of outcomes, a megabyte
}

LinearOutcomes::LinearOutcomes(Eigen::MatrixXd outcomes) : Values(std::move(outcomes)) {}

LinearOutcomes::LinearOutcomes(Eigen::MatrixXd factors, Eigen::MatrixXd perFactor)
{
  if (factors.rows() > factors.cols())
  {
    this->Values = std::move(factors);
    this->Map = std::move(perFactor);
  }
  else
  {
    this->Values.noalias() = factors * perFactor;
  }
}

Eigen::MatrixXd LinearOutcomes::Spread(const Eigen::Ref<const Eigen::MatrixXd>& rows) const
{
  return this->IsFactored() ? Eigen::MatrixXd(rows * this->Map) : Eigen::MatrixXd(rows);
}

Eigen::VectorXd LinearOutcomes::SquaredNorms(const Eigen::Ref<const Eigen::MatrixXd>& rows) const
{
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(this->OutcomeCount());
  for (Eigen::Index first = 0; first < rows.rows(); first += RowsAtOnce)
  {
    const Eigen::Index count = std::min(RowsAtOnce, rows.rows() - first);
    sums += this->Spread(rows.middleRows(first, count)).colwise().squaredNorm().transpose();
  }
  return sums;
}
} // namespace palpate
