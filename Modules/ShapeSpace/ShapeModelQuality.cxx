#include "ShapeModelQuality.h"

#include "LeftOutModes.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace palpate
{
namespace
{
/// Mean and variance of distances at each number of modes (Welford, Technometrics 4, 1962).
class CurveMean
{
public:
  explicit CurveMean(Eigen::Index size)
      : Mean(Eigen::VectorXd::Zero(size)), Squares(Eigen::VectorXd::Zero(size))
  {
  }

  void Add(const Eigen::VectorXd& values)
  {
    this->Count += 1.0;
    this->Change = values - this->Mean;
    this->Mean += this->Change / this->Count;
    this->Squares += this->Change.cwiseProduct(values - this->Mean);
  }
  QualityCurve Curve() const
  {
    const double free = std::max(this->Count * (this->Count - 1.0), 1.0);
    return {this->Mean, (this->Squares / free).cwiseSqrt()};
  }

private:
  double Count = 0.0;
  Eigen::VectorXd Mean;
  Eigen::VectorXd Squares;
  Eigen::VectorXd Change;
};

// From squared distances of coefficients to RMS distances on the sphere.
Eigen::VectorXd SphereDistances(const Eigen::VectorXd& squares)
{
  return (squares.cwiseMax(0.0) / (4.0 * M_PI)).cwiseSqrt();
}

QualityCurve CompactnessOf(const ShapeModes& modes)
{
  const Eigen::Index count = modes.Deviations.size();
  const double factor = 2.0 / static_cast<double>(modes.Scores.rows() - 1);
  QualityCurve curve{Eigen::VectorXd::Zero(count + 1), Eigen::VectorXd::Zero(count + 1)};
  double errors = 0.0;
  for (Eigen::Index k = 0; k < count; ++k)
  {
    const double variance = modes.Deviations[k] * modes.Deviations[k] / (4.0 * M_PI);
    errors += factor * variance * variance;
    curve.Values[k + 1] = curve.Values[k] + variance;
    curve.StandardErrors[k + 1] = std::sqrt(errors);
  }
  return curve;
}

// What is left is summed from the last mode on: differences of sums would lose small remainders.
QualityCurve GeneralisationOf(const ShapeModes& modes)
{
  const Eigen::Index count = modes.Deviations.size();
  LeftOutSolver solver(modes);
  CurveMean mean(count + 1);
  Eigen::VectorXd left(count + 1);
  for (Eigen::Index i = 0; i < modes.Scores.rows(); ++i)
  {
    const LeftOutModes others = solver.Solve(i);
    left.setConstant(others.Outside);
    for (Eigen::Index k = others.Squares.size(); k-- > 0;)
    {
      left[k] = left[k + 1] + others.Squares[k];
    }
    mean.Add(SphereDistances(left));
  }
  return mean.Curve();
}

// With one more mode the squared distance of a random shape (score z) from a case (score s) changes
// from ... + s^2 to ... + (z - s)^2.
QualityCurve SpecificityOf(const ShapeModes& modes, const RandomShapeSettings& settings)
{
  const Eigen::Index count = modes.Deviations.size();
  const Eigen::ArrayXd sizes = modes.Scores.rowwise().squaredNorm().array();
  Eigen::ArrayXd distances(sizes.size());
  Eigen::VectorXd nearest(count + 1);
  nearest[0] = sizes.minCoeff();
  CurveMean mean(count + 1);
  for (int shape = 0; shape < settings.Count; ++shape)
  {
    const Eigen::VectorXd scores =
        RandomScores(modes, settings.Seed, static_cast<std::uint64_t>(shape));
    distances = sizes;
    for (Eigen::Index k = 0; k < count; ++k)
    {
      distances += scores[k] * (scores[k] - 2.0 * modes.Scores.col(k).array());
      nearest[k + 1] = distances.minCoeff();
    }
    mean.Add(SphereDistances(nearest));
  }
  return mean.Curve();
}

double UnitFraction(std::mt19937_64& engine)
{
  // 53 bits, never 0; distributions of the standard library differ between implementations.
  return (static_cast<double>(engine() >> 11U) + 0.5) * 0x1p-53;
}
} // namespace

// Box and Muller, Ann. Math. Statist. 29 (1958).
Eigen::VectorXd RandomScores(const ShapeModes& modes, std::uint64_t seed, std::uint64_t number)
{
  std::seed_seq sequence{seed, seed >> 32U, number, number >> 32U};
  std::mt19937_64 engine(sequence);
  Eigen::VectorXd scores(modes.Deviations.size());
  for (Eigen::Index k = 0; k < scores.size(); k += 2)
  {
    const double radius = std::sqrt(-2.0 * std::log(UnitFraction(engine)));
    const double angle = 2.0 * M_PI * UnitFraction(engine);
    scores[k] = radius * std::cos(angle) * modes.Deviations[k];
    if (k + 1 < scores.size())
    {
      scores[k + 1] = radius * std::sin(angle) * modes.Deviations[k + 1];
    }
  }
  return scores;
}

ShapeModelQuality MeasureShapeModel(const ShapeModes& modes, const RandomShapeSettings& settings)
{
  if (modes.Scores.rows() < 2)
  {
    return {};
  }
  return {CompactnessOf(modes), GeneralisationOf(modes), SpecificityOf(modes, settings)};
}
} // namespace palpate
