#include "SubjectWhitening.h"

namespace palpate
{
namespace
{
/// A symmetric 2 x 2 matrix per subject.
struct SubjectMatrices
{
  Eigen::ArrayXd M11;
  Eigen::ArrayXd M21;
  Eigen::ArrayXd M22;

  /// Adds `share` (a b' + b a') / 2 of leading rows.
  void Add(double share, const Eigen::VectorXd& a, const Eigen::VectorXd& b)
  {
    const Eigen::Index count = this->M11.size();
    const auto a1 = a.head(count).array();
    const auto a2 = a.tail(count).array();
    const auto b1 = b.head(count).array();
    const auto b2 = b.tail(count).array();
    this->M11 += share * a1 * b1;
    this->M21 += 0.5 * share * (a1 * b2 + a2 * b1);
    this->M22 += share * a2 * b2;
  }
  Eigen::MatrixXd Times(const Eigen::MatrixXd& leading) const
  {
    const Eigen::Index count = this->M11.size();
    const auto one = leading.topRows(count).array();
    const auto two = leading.bottomRows(count).array();
    Eigen::MatrixXd product(leading.rows(), leading.cols());
    product.topRows(count) = (one.colwise() * this->M11 + two.colwise() * this->M21).matrix();
    product.bottomRows(count) = (one.colwise() * this->M21 + two.colwise() * this->M22).matrix();
    return product;
  }
  double TraceWith(const SubjectMatrices& other) const
  {
    return (this->M11 * other.M11 + 2.0 * this->M21 * other.M21 + this->M22 * other.M22).sum();
  }
};
} // namespace

SubjectWhitening::SubjectWhitening(const SubjectRows& rows, const Eigen::Vector3d& factor)
{
  const Eigen::Index count = rows.SubjectCount;
  const double d11 = factor[0] * factor[0];
  const double d21 = factor[0] * factor[1];
  const double d22 = factor[1] * factor[1] + factor[2] * factor[2];
  const auto r11 = rows.Effects.col(0).head(count).array();
  const auto r12 = rows.Effects.col(1).head(count).array();
  const auto r22 = rows.Effects.col(1).tail(count).array();
  this->L11 = (1.0 + r11.square() * d11 + 2.0 * r11 * r12 * d21 + r12.square() * d22).sqrt();
  this->L21 = r22 * (r11 * d21 + r12 * d22) / this->L11;
  // The determinant as a sum of squares, which keeps its digits where the effects are large.
  const Eigen::ArrayXd determinant =
      this->L11.square() + r22.square() * d22 + (r11 * r22 * (factor[0] * factor[2])).square();
  this->L22 = determinant.sqrt() / this->L11;
  this->Fixed = this->Whiten(rows.Fixed);
  this->Effects = this->Whiten(rows.Effects);
  this->Normal.compute(this->Fixed.transpose() * this->Fixed +
                       rows.Reduced.transpose() * rows.Reduced);
  this->LogDeterminant =
      determinant.log().sum() + 2.0 * this->Normal.matrixLLT().diagonal().array().log().sum();
}

Eigen::MatrixXd SubjectWhitening::Whiten(const Eigen::MatrixXd& leading) const
{
  const Eigen::Index count = this->L11.size();
  Eigen::MatrixXd white(leading.rows(), leading.cols());
  white.topRows(count) = (leading.topRows(count).array().colwise() / this->L11).matrix();
  white.bottomRows(count) =
      ((leading.bottomRows(count).array() - white.topRows(count).array().colwise() * this->L21)
           .colwise() /
       this->L22)
          .matrix();
  return white;
}

SubjectWhitening::Derivatives SubjectWhitening::Differentiate(const SubjectRows& rows) const
{
  const Eigen::Index count = this->L11.size();
  const auto zero = Eigen::ArrayXd::Zero(count);
  std::vector<SubjectMatrices> matrices(rows.HasSlopes ? 4 : 2, {zero, zero, zero});
  Eigen::MatrixXd units = Eigen::MatrixXd::Zero(2 * count, 2);
  units.col(0).head(count).setOnes();
  units.col(1).tail(count).setOnes();
  units = this->Whiten(units);
  matrices[0].Add(1.0, units.col(0), units.col(0));
  matrices[0].Add(1.0, units.col(1), units.col(1));
  matrices[1].Add(1.0, this->Effects.col(0), this->Effects.col(0));
  if (rows.HasSlopes)
  {
    matrices[2].Add(2.0, this->Effects.col(0), this->Effects.col(1));
    matrices[3].Add(1.0, this->Effects.col(1), this->Effects.col(1));
  }
  const Eigen::MatrixXd others = rows.Reduced.transpose() * rows.Reduced;
  const Eigen::Index width = others.rows();
  const Eigen::MatrixXd covariance = this->Normal.solve(Eigen::MatrixXd::Identity(width, width));
  const auto parameters = static_cast<Eigen::Index>(matrices.size());
  Derivatives result;
  std::vector<Eigen::MatrixXd> products;
  std::vector<Eigen::MatrixXd> weighted;
  for (const SubjectMatrices& one : matrices)
  {
    products.push_back(one.Times(this->Fixed));
    result.First.push_back(this->Fixed.transpose() * products.back());
    if (products.size() == 1)
    {
      result.First.back() += others;
    }
    weighted.push_back(covariance * result.First.back());
  }
  result.Information.resize(parameters, parameters);
  for (std::size_t i = 0; i < matrices.size(); ++i)
  {
    for (std::size_t j = 0; j < matrices.size(); ++j)
    {
      Eigen::MatrixXd second = products[i].transpose() * products[j];
      double trace = matrices[i].TraceWith(matrices[j]);
      if (i + j == 0)
      {
        second += others;
        trace += static_cast<double>(rows.Count - 2 * count); // rows that lead, or only fill up
      }
      result.Information(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
          0.5 * trace - covariance.cwiseProduct(second).sum() +
          0.5 * weighted[i].cwiseProduct(weighted[j].transpose()).sum();
      result.Second.push_back(std::move(second));
    }
  }
  return result;
}
} // namespace palpate
