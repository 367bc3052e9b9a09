#include "SphericalHarmonicFit.h"

#include "SphericalHarmonicBasis.h"

#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <sstream>

namespace palpate
{
namespace
{
using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;
using Index = Eigen::Index;

// The weighted problem ||A c - b||, reduced to its triangle by one Householder factorisation.
struct ReducedProblem
{
  Matrix Design;   // A without weights, for the residuals
  Matrix Triangle; // R
  Vector Right;    // first entries of Q^T b
  Vector Tail;     // the other entries: what no coefficients can reach
  Vector Scales;   // square roots of the normalised weights
  double Samples;  // number of those with a weight: the others do not count anywhere
};

Status CheckSamples(const RadialSamples& samples, const SphericalHarmonicFitOptions& options)
{
  if (options.Degree < 0)
  {
    return Status::Failure("the degree must not be negative");
  }
  const std::size_t count = samples.Directions.size();
  if (samples.Radii.size() != count || samples.Weights.size() != count)
  {
    return Status::Failure("directions, radii and weights differ in number");
  }
  std::size_t used = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double weight = samples.Weights[i];
    if (!std::isfinite(samples.Radii[i]) || !samples.Directions[i].allFinite() ||
        !std::isfinite(weight) || weight < 0.0)
    {
      return Status::Failure("a sample is not finite or has a negative weight");
    }
    used += weight > 0.0 ? 1 : 0;
  }
  const std::size_t needed = SphericalHarmonicBasis::CoefficientCount(options.Degree);
  if (used < needed)
  {
    std::ostringstream text;
    text << used << " samples cannot determine the " << needed << " coefficients of degree "
         << options.Degree << "; take more directions or a lower degree";
    return Status::Failure(text.str());
  }
  return Status::Success();
}

ReducedProblem Reduce(const RadialSamples& samples, int degree)
{
  const SphericalHarmonicBasis basis(degree);
  const auto rows = static_cast<Index>(samples.Directions.size());
  const auto columns = static_cast<Index>(basis.Size());
  ReducedProblem problem;
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> values(rows, columns);
  for (Index i = 0; i < rows; ++i)
  {
    basis.Evaluate(samples.Directions[static_cast<std::size_t>(i)], values.row(i).data());
  }
  problem.Design = values;
  const Eigen::Map<const Vector> weights(samples.Weights.data(), rows);
  problem.Scales = (weights * (4.0 * M_PI / weights.sum())).cwiseSqrt();
  problem.Samples = static_cast<double>((weights.array() > 0.0).count());
  const Eigen::Map<const Vector> radii(samples.Radii.data(), rows);
  const Eigen::HouseholderQR<Matrix> qr(problem.Scales.asDiagonal() * problem.Design);
  const Vector rotated = qr.householderQ().adjoint() * Vector(problem.Scales.cwiseProduct(radii));
  problem.Triangle = qr.matrixQR().topRows(columns).triangularView<Eigen::Upper>();
  problem.Right = rotated.head(columns);
  problem.Tail = rotated.tail(rows - columns);
  return problem;
}

// Largest singular value of the map that `apply` multiplies by its own transpose.
template <typename Apply>
double LargestSingularValue(Index size, const Apply& apply)
{
  // A fixed start without symmetry, so that it is orthogonal to no singular vector in practice.
  Vector v(size);
  for (Index i = 0; i < size; ++i)
  {
    v[i] = 1.0 + 0.5 * std::sin(1.0 + 1.7 * static_cast<double>(i));
  }
  v.normalize();
  double value = 0.0;
  // The Rayleigh quotient never overshoots; a change below 1e-6 in a step leaves an error far below
  // the factor of two that a condition number is read with.
  for (int step = 0; step < 500; ++step)
  {
    const Vector w = apply(v);
    const double next = w.norm();
    if (!std::isfinite(next) || next == 0.0)
    {
      return next == 0.0 ? 0.0 : std::numeric_limits<double>::infinity();
    }
    v = w / next;
    const bool settled = std::abs(next - value) <= 1e-6 * next;
    value = next;
    if (settled && step > 10)
    {
      break;
    }
  }
  return std::sqrt(value);
}

double ConditionOfTriangle(const Matrix& triangle)
{
  const auto upper = triangle.triangularView<Eigen::Upper>();
  if ((triangle.diagonal().array() == 0.0).any())
  {
    return std::numeric_limits<double>::infinity();
  }
  const double largest = LargestSingularValue(triangle.cols(),
                                              [&triangle](const Vector& v) -> Vector {
                                                return triangle.transpose() * Vector(triangle * v);
                                              });
  const double inverse =
      LargestSingularValue(triangle.cols(),
                           [&upper](const Vector& v) -> Vector
                           { return upper.solve(Vector(upper.transpose().solve(v))); });
  return largest * inverse;
}

// Weighted mean square residual of every degree from one factorisation: a leading block of the
// triangle solves the problem of the leading columns.
std::vector<double> RmsByDegree(const ReducedProblem& problem, int degree)
{
  std::vector<double> rms;
  const double tail = problem.Tail.squaredNorm();
  for (int l = 0; l <= degree; ++l)
  {
    const auto used = static_cast<Index>(SphericalHarmonicBasis::CoefficientCount(l));
    const double lost = problem.Right.tail(problem.Right.size() - used).squaredNorm();
    rms.push_back(std::sqrt((tail + lost) / (4.0 * M_PI)));
  }
  return rms;
}

// Solution, trace of the influence matrix, and F / sigma with covariance = F F^T.
struct Solution
{
  Vector Coefficients;
  double DegreesOfFreedom;
  Matrix Factor;
};

Solution SolveTriangle(const ReducedProblem& problem)
{
  const auto upper = problem.Triangle.triangularView<Eigen::Upper>();
  const Index size = problem.Triangle.cols();
  return {upper.solve(problem.Right), static_cast<double>(size),
          upper.solve(Matrix(Matrix::Identity(size, size)))};
}

// The penalised problem in standard form. The constant term is not penalised; it is projected out
// and recovered at the end. In the others, z_j = p_j c_j with p_j = l (l+1).
class PenalisedProblem
{
public:
  explicit PenalisedProblem(const ReducedProblem& problem) : Problem(problem)
  {
    const Index size = problem.Triangle.cols();
    this->Scales.resize(size - 1);
    for (int l = 1; static_cast<Index>(l) * l < size; ++l)
    {
      this->Scales.segment(static_cast<Index>(l) * l - 1, 2 * l + 1).setConstant(l * (l + 1.0));
    }
    // The first column of the triangle is its first row's head, so projecting the constant out of
    // the others drops the first row.
    const Matrix others = problem.Triangle.bottomRightCorner(size - 1, size - 1) *
                          this->Scales.cwiseInverse().asDiagonal();
    this->Svd.compute(others, Eigen::ComputeThinU | Eigen::ComputeThinV);
    this->Right = this->Svd.matrixU().transpose() * problem.Right.tail(size - 1);
  }

  // Strength that minimises n ||residual||^2 / (n - trace)^2, by golden sections in its logarithm
  // after a scan, because the function may have several minima.
  double StrengthByCrossValidation() const
  {
    const Vector& values = this->Svd.singularValues();
    const double high = 2.0 * std::log(values[0]) + 2.0;
    const double low = high - 2.0 * std::log(1e12);
    constexpr int ScanSteps = 60;
    double best = low;
    for (int i = 0; i <= ScanSteps; ++i)
    {
      const double candidate = low + (high - low) * i / ScanSteps;
      if (this->CrossValidation(candidate) < this->CrossValidation(best))
      {
        best = candidate;
      }
    }
    const double step = (high - low) / ScanSteps;
    return std::exp(this->GoldenSection(best - step, best + step));
  }

  Solution Solve(double strength) const
  {
    const Vector& s = this->Svd.singularValues();
    const Vector gain = s.array() / (s.array().square() + strength);
    const Matrix& triangle = this->Problem.Triangle;
    const Index size = triangle.cols();
    // Columns of `map` take the rotated right-hand side (constant first) to the coefficients.
    Matrix map = Matrix::Zero(size, size);
    map.bottomRightCorner(size - 1, size - 1) =
        this->Scales.cwiseInverse().asDiagonal() * this->Svd.matrixV() * gain.asDiagonal();
    map(0, 0) = 1.0 / triangle(0, 0);
    map.row(0).tail(size - 1) = -triangle.row(0).tail(size - 1) *
                                map.bottomRightCorner(size - 1, size - 1) / triangle(0, 0);
    Vector right(size);
    right << this->Problem.Right[0], this->Right;
    return {map * right, 1.0 + (gain.array() * s.array()).sum(), map};
  }

private:
  double CrossValidation(double logStrength) const
  {
    const double strength = std::exp(logStrength);
    const Vector& s = this->Svd.singularValues();
    const Eigen::ArrayXd kept = s.array().square() / (s.array().square() + strength);
    const double residual =
        ((1.0 - kept) * this->Right.array()).square().sum() + this->Problem.Tail.squaredNorm();
    const double free = this->Problem.Samples - 1.0 - kept.sum();
    return residual / (free * free);
  }

  double GoldenSection(double low, double high) const
  {
    const double ratio = (std::sqrt(5.0) - 1.0) / 2.0;
    while (high - low > 1e-3)
    {
      const double left = high - ratio * (high - low);
      const double right = low + ratio * (high - low);
      if (this->CrossValidation(left) < this->CrossValidation(right))
      {
        high = right;
      }
      else
      {
        low = left;
      }
    }
    return 0.5 * (low + high);
  }

  const ReducedProblem& Problem;
  Vector Scales;
  Eigen::BDCSVD<Matrix> Svd;
  Vector Right;
};

void FinishResult(const RadialSamples& samples, const ReducedProblem& problem,
                  const Solution& solution, SphericalHarmonicFitResult& result)
{
  const auto rows = static_cast<Index>(samples.Radii.size());
  const Eigen::Map<const Vector> radii(samples.Radii.data(), rows);
  const Vector residuals = radii - problem.Design * solution.Coefficients;
  const double squares = problem.Scales.cwiseProduct(residuals).squaredNorm();
  result.Coefficients.assign(solution.Coefficients.begin(), solution.Coefficients.end());
  result.Residuals.assign(residuals.begin(), residuals.end());
  result.DegreesOfFreedom = solution.DegreesOfFreedom;
  result.Rms = std::sqrt(squares / (4.0 * M_PI));
  const double free = problem.Samples - solution.DegreesOfFreedom;
  // In scaled rows the noise of a sample of mean weight is sigma sqrt(4 pi / n).
  const double scaledVariance = free > 0.0 ? squares / free : 0.0;
  result.NoiseDeviation = std::sqrt(scaledVariance * problem.Samples / (4.0 * M_PI));
  result.CovarianceFactor = std::sqrt(scaledVariance) * solution.Factor;
}

Status IllPosed(double condition, const SphericalHarmonicFitOptions& options)
{
  std::ostringstream text;
  text.precision(3);
  text << "the directions leave degree " << options.Degree << " undetermined (condition "
       << condition << ", limit " << options.MaximumCondition
       << "); add a roughness penalty or take a lower degree";
  return Status::Failure(text.str());
}
} // namespace

double SphericalHarmonicFitResult::RadiusDeviation(const double* basisValues) const
{
  const Eigen::Map<const Vector> values(basisValues, this->CovarianceFactor.rows());
  return (this->CovarianceFactor.transpose() * values).norm();
}

Status FitSphericalHarmonics(const RadialSamples& samples,
                             const SphericalHarmonicFitOptions& options,
                             SphericalHarmonicFitResult& result)
{
  using Penalty = SphericalHarmonicFitOptions::Penalty;
  Status check = CheckSamples(samples, options);
  if (!check.IsOk())
  {
    return check;
  }
  const auto cancelled = [&options] { return options.IsCancelled && options.IsCancelled(); };
  const ReducedProblem problem = Reduce(samples, options.Degree);
  result = {};
  result.Condition = ConditionOfTriangle(problem.Triangle);
  if (cancelled())
  {
    return Status::Failure("cancelled");
  }
  const bool penalised = options.PenaltyKind != Penalty::None && options.Degree > 0;
  if (!penalised)
  {
    if (!(result.Condition <= options.MaximumCondition))
    {
      return IllPosed(result.Condition, options);
    }
    result.RmsByDegree = RmsByDegree(problem, options.Degree);
    FinishResult(samples, problem, SolveTriangle(problem), result);
    return Status::Success();
  }
  const bool automatic = options.PenaltyKind == Penalty::GeneralisedCrossValidation;
  if (!automatic && !(options.Roughness > 0.0 && std::isfinite(options.Roughness)))
  {
    return Status::Failure("the roughness penalty must be a positive number");
  }
  const PenalisedProblem penalisedProblem(problem);
  if (cancelled())
  {
    return Status::Failure("cancelled");
  }
  result.Roughness = automatic ? penalisedProblem.StrengthByCrossValidation() : options.Roughness;
  FinishResult(samples, problem, penalisedProblem.Solve(result.Roughness), result);
  return Status::Success();
}
} // namespace palpate
