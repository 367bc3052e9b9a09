#include "MixedModel.h"

#include "ProbabilityDistributions.h"
#include "SubjectWhitening.h"
#include "SymmetricEigen.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace palpate
{
namespace
{
constexpr double Unknown = std::numeric_limits<double>::quiet_NaN();
// Relative standard deviations of effects from which on there is no residual variance.
constexpr double LargestFactor = 1e6;
constexpr double SmallestFactor = 0.05;
constexpr double FactorStep = 4.0;
// As lme4's isSingular.
constexpr double SingularFactor = 1e-4;
// A criterion is below rounding of its sums, and tells no models apart.
constexpr double SmallestDecrease = 1e-11;
constexpr double SameCriterion = 1e-9;
// Below it the criterion of slopes may have several minima: one start misses the lowest
// in 3 of 1,000 random groups of ten.
constexpr Eigen::Index FewSubjects = 50;
constexpr double LeastInformation = 1e-8; // reciprocal condition of the parameters' information

/// The criterion of an outcome, without its constants.
class SubjectCriterion
{
public:
  SubjectCriterion(const SubjectRows& rows, const SubjectOutcome& outcome)
      : Rows(rows), Outcome(outcome), Degrees(static_cast<double>(rows.Count - rows.Fixed.cols()))
  {
  }

  double Value(const Eigen::Vector3d& factor, Eigen::Vector3d* gradient = nullptr) const
  {
    const SubjectWhitening white(this->Rows, factor);
    const Solution solution = this->Solve(white);
    if (gradient != nullptr)
    {
      *gradient = this->Gradient(white, solution, factor);
    }
    return white.LogDeterminant + this->Degrees * std::log(solution.Squares);
  }
  /// Generalised least squares.
  struct Solution
  {
    Eigen::VectorXd Coefficients;
    Eigen::VectorXd Residuals; ///< of leading rows
    double Squares = 0.0;      ///< of all rows
  };
  Solution Solve(const SubjectWhitening& white) const
  {
    const Eigen::VectorXd leading = white.Whiten(this->Outcome.Leading);
    Solution solution;
    solution.Coefficients = white.Normal.solve(
        white.Fixed.transpose() * leading + this->Rows.Reduced.transpose() * this->Outcome.Reduced);
    solution.Residuals = leading - white.Fixed * solution.Coefficients;
    solution.Squares =
        solution.Residuals.squaredNorm() + this->Outcome.RestSquares +
        (this->Outcome.Reduced - this->Rows.Reduced * solution.Coefficients).squaredNorm();
    return solution;
  }

private:
  // By the entries of the factor L: twice G L, where G is the derivative by the covariance L L'.
  Eigen::Vector3d Gradient(const SubjectWhitening& white, const Solution& solution,
                           const Eigen::Vector3d& factor) const
  {
    const Eigen::Index width = white.Fixed.cols();
    const Eigen::MatrixXd one = this->SubjectSums(white, 0, solution.Residuals);
    const Eigen::MatrixXd two = this->SubjectSums(white, 1, solution.Residuals);
    const Eigen::MatrixXd covariance = white.Normal.solve(Eigen::MatrixXd::Identity(width, width));
    const double weight = this->Degrees / solution.Squares;
    const auto entry = [&](const Eigen::MatrixXd& a, const Eigen::MatrixXd& b)
    {
      const Eigen::MatrixXd products = a.leftCols(width).transpose() * b.leftCols(width);
      return covariance.cwiseProduct(products).sum() + weight * a.col(width).dot(b.col(width));
    };
    const Eigen::Matrix2d effects = white.Effects.transpose() * white.Effects;
    const double g11 = effects(0, 0) - entry(one, one);
    const double g21 = effects(1, 0) - entry(two, one);
    const double g22 = effects(1, 1) - entry(two, two);
    return {2.0 * (g11 * factor[0] + g21 * factor[1]),
            this->Rows.HasSlopes ? 2.0 * (g21 * factor[0] + g22 * factor[1]) : 0.0,
            2.0 * g22 * factor[2]};
  }
  // Of the fixed effects and the residuals, times an effect, of each subject.
  Eigen::MatrixXd SubjectSums(const SubjectWhitening& white, Eigen::Index effect,
                              const Eigen::VectorXd& residuals) const
  {
    const Eigen::Index count = this->Rows.SubjectCount;
    Eigen::MatrixXd all(2 * count, white.Fixed.cols() + 1);
    all << white.Fixed, residuals;
    all.array().colwise() *= white.Effects.col(effect).array();
    return all.topRows(count) + all.bottomRows(count);
  }

  const SubjectRows& Rows;
  const SubjectOutcome& Outcome;
  double Degrees;
};

/// A minimum by BFGS updates. The factor needs no bounds, as its signs do not count.
class FactorSearch
{
public:
  FactorSearch(const SubjectCriterion& criterion, const Eigen::Vector3d& start, double step)
      : Criterion(criterion), Factor(start), Inverse(step * Eigen::Matrix3d::Identity())
  {
    this->Value = criterion.Value(start, &this->Gradient);
  }
  void Run()
  {
    constexpr int MostSteps = 200;
    double before = std::numeric_limits<double>::infinity();
    for (int i = 0; i < MostSteps && before - this->Value > SmallestDecrease; ++i)
    {
      before = this->Value;
      this->Step();
    }
  }
  std::pair<double, Eigen::Vector3d> Best() const { return {this->Value, this->Factor}; }

private:
  // With the conditions of Wolfe, by bisection.
  void Step()
  {
    const Eigen::Vector3d direction = -this->Inverse * this->Gradient;
    const double slope = direction.dot(this->Gradient);
    double low = 0.0;
    double high = std::numeric_limits<double>::infinity();
    double length = 1.0;
    for (int i = 0; i < 60 && slope < -SmallestDecrease; ++i)
    {
      Eigen::Vector3d gradient;
      const Eigen::Vector3d next = this->Factor + length * direction;
      const double value = this->Criterion.Value(next, &gradient);
      if (!(value <= this->Value + 1e-4 * length * slope))
      {
        high = length;
      }
      else if (gradient.dot(direction) < 0.9 * slope && next.norm() < LargestFactor)
      {
        low = length;
      }
      else
      {
        this->Update(next - this->Factor, gradient - this->Gradient);
        this->Factor = next;
        this->Value = value;
        this->Gradient = gradient;
        return;
      }
      length = std::isinf(high) ? 2.0 * length : 0.5 * (low + high);
    }
  }
  void Update(const Eigen::Vector3d& step, const Eigen::Vector3d& change)
  {
    const double curvature = step.dot(change);
    if (curvature > 0.0)
    {
      const Eigen::Matrix3d left =
          Eigen::Matrix3d::Identity() - step * change.transpose() / curvature;
      this->Inverse = left * this->Inverse * left.transpose() + step * step.transpose() / curvature;
    }
  }

  const SubjectCriterion& Criterion;
  Eigen::Vector3d Factor;
  double Value;
  Eigen::Vector3d Gradient;
  Eigen::Matrix3d Inverse;
};

// Takes the other factor if its criterion is as small.
void Prefer(const SubjectCriterion& criterion, const Eigen::Vector3d& other,
            std::pair<double, Eigen::Vector3d>& best)
{
  const double value = criterion.Value(other);
  if (value <= best.first + SameCriterion)
  {
    best = {value, other};
  }
}

Eigen::Vector3d FindFactor(const SubjectRows& rows, const SubjectCriterion& criterion)
{
  const Eigen::Vector3d shape(1.0, 0.0, rows.HasSlopes ? 0.5 : 0.0);
  std::pair<double, double> start{std::numeric_limits<double>::infinity(), 0.0};
  for (double size = SmallestFactor; size < LargestFactor; size *= FactorStep)
  {
    start = std::min(start, {criterion.Value(size * shape), size});
  }
  std::vector<double> sizes{start.second};
  if (rows.HasSlopes && rows.SubjectCount < FewSubjects)
  {
    sizes.insert(sizes.end(), {0.2, 3.0});
  }
  std::pair<double, Eigen::Vector3d> best{start.first, start.second * shape};
  for (const double size : sizes)
  {
    FactorSearch search(criterion, size * shape,
                        size * size / static_cast<double>(2 * rows.SubjectCount));
    search.Run();
    best = search.Best().first < best.first ? search.Best() : best;
  }
  if (rows.HasSlopes)
  {
    Prefer(criterion, {best.second[0], best.second[1], 0.0}, best);
  }
  Prefer(criterion, Eigen::Vector3d::Zero(), best);
  return best.second;
}

Eigen::Matrix2d FactorSquare(const Eigen::Vector3d& factor)
{
  Eigen::Matrix2d lower;
  lower << factor[0], 0.0, factor[1], factor[2];
  return lower * lower.transpose();
}
} // namespace

Status MixedModel::Make(const Eigen::MatrixXd& fixed, const std::vector<Eigen::Index>& subjects,
                        const Eigen::VectorXd& times, MixedModel& model)
{
  model.Rows = SubjectRows(fixed, subjects, times);
  Eigen::MatrixXd information =
      SubjectWhitening(model.Rows, Eigen::Vector3d::Zero()).Differentiate(model.Rows).Information;
  const Eigen::VectorXd scale = information.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  information = scale.asDiagonal() * information * scale.asDiagonal();
  if (!(SymmetricEigen(information, false).Values[0] > LeastInformation))
  {
    return Status::Failure(
        model.Rows.HasSlopes
            ? "the times are too few to separate slopes of subjects from residuals"
            : "variation between and within subjects cannot be separated: none has several "
              "measurements that differ in nothing else");
  }
  return Status::Success();
}

MixedFit MixedModel::Fit(const Eigen::VectorXd& values) const
{
  const SubjectOutcome outcome = this->Rows.Outcome(values);
  MixedFit fit;
  const Eigen::Index width = this->Rows.Fixed.cols();
  fit.Criterion = fit.ResidualVariance = Unknown;
  fit.SubjectCovariance.setConstant(Unknown);
  fit.Coefficients.setConstant(width, Unknown);
  fit.Covariance.setConstant(width, width, Unknown);
  if (!(outcome.Length > 1e-12 * values.norm()))
  {
    return fit;
  }
  const Eigen::Vector3d factor = FindFactor(this->Rows, {this->Rows, outcome});
  return factor.norm() < LargestFactor / FactorStep ? this->Describe(factor, outcome) : fit;
}

MixedFit MixedModel::Describe(const Eigen::Vector3d& factor, const SubjectOutcome& outcome) const
{
  const SubjectCriterion criterion(this->Rows, outcome);
  const SubjectWhitening white(this->Rows, factor);
  const SubjectCriterion::Solution solution = criterion.Solve(white);
  const Eigen::Index width = this->Rows.Fixed.cols();
  const auto degrees = static_cast<double>(this->Rows.Count - width);
  const auto triangle = this->Rows.Triangle.triangularView<Eigen::Upper>();
  MixedFit fit;
  fit.IsFound = true;
  fit.Criterion = criterion.Value(factor) + 2.0 * degrees * std::log(outcome.Length) +
                  2.0 * this->Rows.Triangle.diagonal().array().abs().log().sum() +
                  degrees * (1.0 + std::log(2.0 * M_PI / degrees));
  fit.ResidualVariance = outcome.Length * outcome.Length * solution.Squares / degrees;
  fit.Coefficients = triangle.solve(outcome.Explained + outcome.Length * solution.Coefficients);
  const Eigen::Matrix2d covariance = FactorSquare(factor);
  Eigen::Matrix2d toTime;
  toTime << 1.0, -this->Rows.MeanTime / this->Rows.TimeDeviation, 0.0,
      1.0 / this->Rows.TimeDeviation;
  fit.SubjectCovariance = fit.ResidualVariance * toTime * covariance * toTime.transpose();
  fit.IsSingular = (this->Rows.HasSlopes ? SymmetricEigen(covariance, false).Values[0]
                                         : covariance(0, 0)) < SingularFactor * SingularFactor;
  AddCorrections(white, triangle.solve(Eigen::MatrixXd::Identity(width, width)), fit);
  return fit;
}

// Kenward and Roger 1997, eq. 3 and 5; V is linear in its parameters, so R_ij = 0.
void MixedModel::AddCorrections(const SubjectWhitening& white, const Eigen::MatrixXd& inverse,
                                MixedFit& fit) const
{
  const SubjectWhitening::Derivatives derivatives = white.Differentiate(this->Rows);
  const Eigen::Index width = inverse.rows();
  const Eigen::MatrixXd plain = white.Normal.solve(Eigen::MatrixXd::Identity(width, width));
  const Eigen::VectorXd scale = derivatives.Information.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd scaled = scale.asDiagonal() * derivatives.Information * scale.asDiagonal();
  fit.ParameterCovariance = scale.asDiagonal() * scaled.inverse() * scale.asDiagonal();
  Eigen::MatrixXd correction = Eigen::MatrixXd::Zero(width, width);
  const std::size_t count = derivatives.First.size();
  for (std::size_t i = 0; i < count; ++i)
  {
    for (std::size_t j = 0; j < count; ++j)
    {
      correction +=
          fit.ParameterCovariance(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) *
          (derivatives.Second[i * count + j] - derivatives.First[i] * plain * derivatives.First[j]);
    }
    fit.Decreases.push_back(fit.ResidualVariance * inverse * plain * derivatives.First[i] * plain *
                            inverse.transpose());
  }
  const auto inUnits = [&](const Eigen::MatrixXd& covariance) -> Eigen::MatrixXd
  { return fit.ResidualVariance * inverse * covariance * inverse.transpose(); };
  fit.PlainCovariance = inUnits(plain);
  fit.Covariance = inUnits(plain + 2.0 * plain * correction * plain);
}

// Kenward and Roger 1997, section 2.3.
FixedTest MixedModel::Test(const MixedFit& fit, Eigen::Index first, Eigen::Index count)
{
  FixedTest test;
  if (!fit.IsFound)
  {
    return {Unknown, Unknown, Unknown, Unknown};
  }
  const auto block = [&](const Eigen::MatrixXd& matrix) -> Eigen::MatrixXd
  { return matrix.block(first, first, count, count); };
  const Eigen::MatrixXd inverse = block(fit.PlainCovariance).inverse();
  const auto q = static_cast<double>(count);
  double a1 = 0.0;
  double a2 = 0.0;
  for (std::size_t i = 0; i < fit.Decreases.size(); ++i)
  {
    for (std::size_t j = 0; j < fit.Decreases.size(); ++j)
    {
      const double weight =
          fit.ParameterCovariance(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
      const Eigen::MatrixXd one = inverse * block(fit.Decreases[i]);
      const Eigen::MatrixXd two = inverse * block(fit.Decreases[j]);
      a1 += weight * one.trace() * two.trace();
      a2 += weight * (one * two).trace();
    }
  }
  const double b = (a1 + 6.0 * a2) / (2.0 * q);
  const double g = ((q + 1.0) * a1 - (q + 4.0) * a2) / ((q + 2.0) * a2);
  const double base = 3.0 * q + 2.0 * (1.0 - g);
  const double mean = 1.0 / (1.0 - a2 / q);
  const double second = 1.0 - (q - g) / base * b;
  const double variance =
      2.0 / q * (1.0 + g / base * b) / (second * second * (1.0 - (q + 2.0 - g) / base * b));
  const double ratio = variance / (2.0 * mean * mean);
  test.NumeratorDegrees = q;
  test.DenominatorDegrees = 4.0 + (q + 2.0) / (q * ratio - 1.0);
  double scale = test.DenominatorDegrees / (mean * (test.DenominatorDegrees - 2.0));
  if (count == 1 || !(mean > 0.0) || !(test.DenominatorDegrees > 2.0))
  {
    test.DenominatorDegrees = 2.0 * q / a2; // what the above is for one column
    scale = 1.0;
  }
  const Eigen::VectorXd effect = fit.Coefficients.segment(first, count);
  test.F = scale / q * effect.dot(block(fit.Covariance).inverse() * effect);
  test.P = FisherUpper(test.F, q, test.DenominatorDegrees);
  return test;
}

double MixedModel::ConfidenceWidth(const MixedFit& fit, Eigen::Index column, double confidence)
{
  return fit.IsFound ? StudentQuantile(confidence, Test(fit, column, 1).DenominatorDegrees) *
                           std::sqrt(fit.Covariance(column, column))
                     : Unknown;
}
} // namespace palpate
