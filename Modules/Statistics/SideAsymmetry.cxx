#include "SideAsymmetry.h"

#include "ProbabilityDistributions.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace palpate
{
namespace
{
constexpr Eigen::Index FlipsAtATime = 64;
constexpr double FlipTie = 1.0 - 1e-12; // sums of the same numbers in another order

/// Statistics of the sums of differences under signs.
struct FlippedSums
{
  Eigen::ArrayXd Squares; ///< sums of squares of each point, whatever the signs
  Eigen::ArrayXd Areas;
  double Count;

  // Student's t squared of each point.
  Eigen::ArrayXd TSquares(const Eigen::ArrayXd& sums) const
  {
    const Eigen::ArrayXd explained = sums.square() / this->Count;
    const Eigen::ArrayXd rest = (this->Squares - explained) / (this->Count - 1.0);
    return (rest > 0.0).select(explained / rest, 0.0);
  }
  double Whole(const Eigen::ArrayXd& sums) const
  {
    const double explained = (this->Areas * sums.square()).sum() / this->Count;
    const double rest = (this->Areas * this->Squares).sum() - explained;
    return rest > 0.0 ? explained * (this->Count - 1.0) / rest : 0.0;
  }
};

// Rows of random signs, one column per individual.
Eigen::MatrixXd RandomSigns(Eigen::Index rows, Eigen::Index columns, std::mt19937_64& random)
{
  return Eigen::MatrixXd::NullaryExpr(rows, columns,
                                      [&] { return (random() >> 63U) == 0 ? 1.0 : -1.0; });
}

double ShareFrom(double value, const std::vector<double>& ascending)
{
  const auto reached =
      ascending.end() - std::lower_bound(ascending.begin(), ascending.end(), FlipTie * value);
  return static_cast<double>(reached + 1) / static_cast<double>(ascending.size() + 1);
}
} // namespace

SideAnova FindSideAnova(const Eigen::MatrixXd& left, const Eigen::MatrixXd& right,
                        Eigen::Index symmetric, Eigen::Index asymmetric)
{
  const Eigen::MatrixXd middle = 0.5 * (left + right);
  const Eigen::MatrixXd half = 0.5 * (left - right);
  const Eigen::RowVectorXd middleMean = middle.colwise().mean();
  const Eigen::RowVectorXd halfMean = half.colwise().mean();
  const auto others = static_cast<double>(left.rows() - 1);
  SideAnova anova;
  anova.Individual = {2.0 * (middle.rowwise() - middleMean).squaredNorm(),
                      others * static_cast<double>(symmetric)};
  anova.Side = {2.0 * static_cast<double>(left.rows()) * halfMean.squaredNorm(),
                static_cast<double>(asymmetric)};
  anova.Interaction = {2.0 * (half.rowwise() - halfMean).squaredNorm(),
                       others * static_cast<double>(asymmetric)};
  return anova;
}

Status TestSides(const Eigen::MatrixXd& differences, const std::vector<double>& areas,
                 const PermutationSettings& settings, const KernelProgress& progress,
                 SideTest& test)
{
  const auto count = static_cast<double>(differences.rows());
  const FlippedSums flipped{
      differences.colwise().squaredNorm().transpose().array(),
      Eigen::Map<const Eigen::ArrayXd>(areas.data(), static_cast<Eigen::Index>(areas.size())),
      count};
  const Eigen::ArrayXd sums = differences.colwise().sum().transpose().array();
  const Eigen::ArrayXd observed = flipped.TSquares(sums);
  test.Mean = sums / count;
  test.Deviation =
      ((flipped.Squares - sums.square() / count).max(0.0) / (count - 1.0)).sqrt().matrix();
  test.Statistic = (sums < 0.0).select(-observed.sqrt(), observed.sqrt());
  test.P = test.Statistic.unaryExpr([&](double t) { return StudentTwoSided(t, count - 1.0); });
  test.WholeF = flipped.Whole(sums);
  std::mt19937_64 random(settings.Seed);
  std::vector<double> largest;
  std::vector<double> whole;
  for (Eigen::Index first = 0; first < settings.Count; first += FlipsAtATime)
  {
    if (progress && !progress(static_cast<double>(first) / settings.Count))
    {
      return Status::Failure("cancelled");
    }
    const Eigen::Index rows = std::min<Eigen::Index>(FlipsAtATime, settings.Count - first);
    const Eigen::MatrixXd flips =
        differences.transpose() * RandomSigns(rows, differences.rows(), random).transpose();
    for (Eigen::Index k = 0; k < rows; ++k)
    {
      largest.push_back(flipped.TSquares(flips.col(k).array()).maxCoeff());
      whole.push_back(flipped.Whole(flips.col(k).array()));
    }
  }
  std::sort(largest.begin(), largest.end());
  std::sort(whole.begin(), whole.end());
  test.FamilyP =
      observed.unaryExpr([&](double square) { return ShareFrom(square, largest); }).matrix();
  test.WholeP = ShareFrom(test.WholeF, whole);
  return Status::Success();
}
} // namespace palpate
