#include "SubjectRows.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
using SubjectQr = Eigen::HouseholderQR<Eigen::MatrixXd>;

Eigen::MatrixXd ThinBasis(const SubjectQr& qr)
{
  return qr.householderQ() * Eigen::MatrixXd::Identity(qr.rows(), std::min(qr.rows(), qr.cols()));
}

Eigen::MatrixXd UpperTriangle(const SubjectQr& qr)
{
  const Eigen::Index rows = std::min(qr.rows(), qr.cols());
  return qr.matrixQR().topRows(rows).triangularView<Eigen::Upper>();
}
} // namespace

SubjectRows::SubjectRows(const Eigen::MatrixXd& fixed, const std::vector<Eigen::Index>& subjects,
                         const Eigen::VectorXd& times)
    : Count(fixed.rows()), HasSlopes(times.size() > 0),
      Design(Eigen::MatrixXd::Ones(fixed.rows(), times.size() > 0 ? 2 : 1))
{
  this->SubjectCount = 1 + *std::max_element(subjects.begin(), subjects.end());
  this->Members.resize(static_cast<std::size_t>(this->SubjectCount));
  for (std::size_t row = 0; row < subjects.size(); ++row)
  {
    this->Members[static_cast<std::size_t>(subjects[row])].push_back(
        static_cast<Eigen::Index>(row));
  }
  if (this->HasSlopes)
  {
    this->MeanTime = times.mean();
    const Eigen::ArrayXd centred = times.array() - this->MeanTime;
    const double deviation = std::sqrt(centred.square().mean());
    this->TimeDeviation = deviation > 0.0 ? deviation : 1.0;
    this->Design.col(1) = centred / this->TimeDeviation;
  }
  const SubjectQr qr(fixed);
  this->Orthonormal = ThinBasis(qr);
  this->Triangle = UpperTriangle(qr);
  const Parts parts = this->Rotate(this->Orthonormal);
  this->Fixed = parts.Leading;
  const SubjectQr others(parts.Others);
  this->Basis = ThinBasis(others);
  this->Reduced = UpperTriangle(others);
  this->Effects = Eigen::MatrixXd::Zero(2 * this->SubjectCount, 2);
  this->Effects.leftCols(this->Design.cols()) = this->Rotate(this->Design).Leading;
}

SubjectRows::Parts SubjectRows::Rotate(const Eigen::MatrixXd& columns) const
{
  const Eigen::Index width = this->Design.cols();
  Parts parts{Eigen::MatrixXd::Zero(2 * this->SubjectCount, columns.cols()),
              Eigen::MatrixXd(this->Count, columns.cols())};
  Eigen::Index others = 0;
  for (Eigen::Index i = 0; i < this->SubjectCount; ++i)
  {
    const std::vector<Eigen::Index>& members = this->Members[static_cast<std::size_t>(i)];
    const auto count = static_cast<Eigen::Index>(members.size());
    const SubjectQr qr(Eigen::MatrixXd(this->Design(members, Eigen::all)));
    const Eigen::MatrixXd rotated =
        qr.householderQ().adjoint() * Eigen::MatrixXd(columns(members, Eigen::all));
    const Eigen::Index leading = std::min(count, width);
    for (Eigen::Index k = 0; k < leading; ++k)
    {
      parts.Leading.row(i + k * this->SubjectCount) = rotated.row(k);
    }
    parts.Others.middleRows(others, count - leading) = rotated.bottomRows(count - leading);
    others += count - leading;
  }
  parts.Others.conservativeResize(others, Eigen::NoChange);
  return parts;
}

SubjectOutcome SubjectRows::Outcome(const Eigen::VectorXd& values) const
{
  SubjectOutcome outcome;
  outcome.Explained = this->Orthonormal.transpose() * values;
  Eigen::VectorXd rest = values - this->Orthonormal * outcome.Explained;
  outcome.Length = rest.norm();
  const Parts parts = this->Rotate(rest / outcome.Length);
  outcome.Leading = parts.Leading;
  outcome.Reduced = this->Basis.transpose() * parts.Others;
  outcome.RestSquares = (parts.Others - this->Basis * outcome.Reduced).squaredNorm();
  return outcome;
}
} // namespace palpate
