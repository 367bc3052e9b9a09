#include "FitPrecision.h"

#include "FitSamples.h"
#include "LeastSquaresSolver.h"
#include "WorstCase.h"

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <cmath>
#include <cstdio>
#include <limits>
#include <sstream>

namespace palpate::test
{
namespace
{
constexpr int Degree = 12;
constexpr int Frequency = 12; // 1,442 directions
// Typical choice of cross-validation for organs with 0.3 mm of noise.
constexpr double UsualRoughness = 2.5e-5;
constexpr double NoNumber = std::numeric_limits<double>::quiet_NaN();

// The rows of samples, then those of the penalty; and the right-hand side as last column.
Eigen::MatrixXd WeightedSystem(const RadialSamples& samples, double roughness)
{
  const SphericalHarmonicBasis basis(Degree);
  const auto count = static_cast<Eigen::Index>(samples.Radii.size());
  const auto size = static_cast<Eigen::Index>(basis.Size());
  const std::vector<double> weights = NormalisedWeights(samples.Weights);
  Eigen::MatrixXd system = Eigen::MatrixXd::Zero(count + size, size + 1);
  std::vector<double> values(basis.Size());
  for (Eigen::Index i = 0; i < count; ++i)
  {
    const auto n = static_cast<std::size_t>(i);
    basis.Evaluate(samples.Directions[n], values.data());
    const double root = std::sqrt(weights[n]);
    system.row(i).head(size) = root * Eigen::Map<const Eigen::RowVectorXd>(values.data(), size);
    system(i, size) = root * samples.Radii[n];
  }
  for (int l = 0; l <= Degree; ++l)
  {
    for (int m = -l; m <= l; ++m)
    {
      const auto k = static_cast<Eigen::Index>(SphericalHarmonicBasis::Index(l, m));
      system(count + k, k) = std::sqrt(roughness * LeastSquaresSolver::Roughness(l));
    }
  }
  return system;
}

template <typename Real>
using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;

template <typename Real>
Matrix<Real> Rounded(const Eigen::MatrixXd& system)
{
  return system.cast<Real>();
}

template <typename Real>
std::vector<double> Orthogonal(const Eigen::MatrixXd& system)
{
  const auto given = Rounded<Real>(system);
  const Eigen::Index size = given.cols() - 1;
  const Matrix<Real> found = given.leftCols(size).householderQr().solve(given.col(size));
  const Eigen::MatrixXd rounded = found.template cast<double>();
  return {rounded.data(), rounded.data() + size};
}

template <typename Real>
std::vector<double> ByNormalEquations(const Eigen::MatrixXd& system)
{
  const auto given = Rounded<Real>(system);
  const Eigen::Index size = given.cols() - 1;
  const auto design = given.leftCols(size);
  const Eigen::LLT<Matrix<Real>> factor(design.transpose() * design);
  if (factor.info() != Eigen::Success)
  {
    return {};
  }
  const Eigen::MatrixXd rounded =
      factor.solve(design.transpose() * given.col(size)).template cast<double>();
  return {rounded.data(), rounded.data() + size};
}

double LargestDifference(const std::vector<Vector3>& directions, const std::vector<double>& found,
                         const std::vector<double>& exact)
{
  if (found.empty())
  {
    return NoNumber;
  }
  std::vector<double> difference = exact;
  for (std::size_t k = 0; k < difference.size(); ++k)
  {
    difference[k] -= found[k];
  }
  const RadialModel model(Degree, difference, Vector3::Zero());
  WorstCase largest;
  for (const Vector3& u : directions)
  {
    largest.Add(model.Radius(u));
  }
  return largest.Value();
}

FitPrecision MakeRow(const HardDirections& hard, const RadialModel& organ, double roughness)
{
  const RadialSamples samples = SamplesAlong(hard, organ);
  const Eigen::MatrixXd system = WeightedSystem(samples, roughness);
  const std::vector<double> exact =
      roughness > 0.0 ? Orthogonal<long double>(system) : organ.Coefficients();
  RadialModelFitOptions options;
  options.Degree = Degree;
  options.MaximumCondition = std::numeric_limits<double>::infinity();
  options.Roughness = roughness;
  options.PenaltyKind = roughness > 0.0 ? RadialModelFitOptions::Penalty::Given
                                        : RadialModelFitOptions::Penalty::None;
  RadialModelFitResult fit;
  const bool isFitted = FitRadialModel(samples, options, fit).IsOk();
  const auto off = [&](const std::vector<double>& found)
  { return LargestDifference(IcosahedronDirections(12).Directions(), found, exact); };
  FitPrecision row;
  row.Directions = hard.Name;
  row.Roughness = roughness;
  row.Condition = fit.Condition;
  row.FloatNormalEquations = off(ByNormalEquations<float>(system));
  row.FloatOrthogonal = off(Orthogonal<float>(system));
  row.DoubleNormalEquations = off(ByNormalEquations<double>(system));
  row.Ours = isFitted ? off(fit.Coefficients) : NoNumber;
  return row;
}

std::string Written(double number)
{
  char text[32];
  std::snprintf(text, sizeof(text), "%.1e", number);
  return std::isnan(number) ? "fails" : text;
}

HardDirections AllBut(double capDegrees)
{
  const RadialSamples kept =
      WithoutCap(SamplesOf(RadialModel(), Frequency), capDegrees * M_PI / 180.0);
  const auto whole = static_cast<int>(capDegrees);
  return {capDegrees > 0.0 ? "all but a cap of " + std::to_string(whole) + "°" : "all",
          kept.Directions, kept.Weights};
}

// Unit weights, so that the cluster has its full effect.
HardDirections Clustered()
{
  Random random(8830);
  HardDirections hard{"nine in ten within 20°", IcosahedronDirections(5).Directions(), {}};
  const std::size_t everywhere = hard.Directions.size();
  while (hard.Directions.size() < 10 * everywhere)
  {
    const Vector3 u = RandomDirection(random);
    if (u[2] > std::cos(20.0 * M_PI / 180.0))
    {
      hard.Directions.push_back(u);
    }
  }
  hard.Weights.assign(hard.Directions.size(), 1.0);
  return hard;
}

HardDirections Duplicated()
{
  Random random(8831);
  HardDirections hard{"each up to ten times", {}, {}};
  const IcosahedronDirections sphere(6);
  for (const Vector3& u : sphere.Directions())
  {
    hard.Directions.insert(hard.Directions.end(), 1 + random() % 10, u);
  }
  hard.Weights.assign(hard.Directions.size(), 1.0);
  return hard;
}

// On a spiral of equal areas.
HardDirections Minimal()
{
  constexpr int Count = (Degree + 1) * (Degree + 1);
  const double golden = M_PI * (3.0 - std::sqrt(5.0));
  HardDirections hard{"169, as many as coefficients", {}, {}};
  for (int n = 0; n < Count; ++n)
  {
    const double z = 1.0 - (2.0 * n + 1.0) / Count;
    const double s = std::sqrt(1.0 - z * z);
    hard.Directions.emplace_back(s * std::cos(golden * n), s * std::sin(golden * n), z);
  }
  hard.Weights.assign(hard.Directions.size(), 1.0);
  return hard;
}
} // namespace

std::vector<HardDirections> AllHardDirections()
{
  std::vector<HardDirections> all;
  for (const double cap : {0.0, 10.0, 20.0, 30.0, 40.0, 50.0, 60.0, 90.0})
  {
    all.push_back(AllBut(cap));
  }
  for (HardDirections (*make)() : {Clustered, Duplicated, Minimal})
  {
    all.push_back(make());
  }
  return all;
}

RadialSamples SamplesAlong(const HardDirections& hard, const RadialModel& organ)
{
  RadialSamples samples{hard.Directions, {}, hard.Weights};
  for (const Vector3& u : samples.Directions)
  {
    samples.Radii.push_back(organ.Radius(u));
  }
  return samples;
}

std::vector<FitPrecision> MeasureFitPrecision()
{
  Random random(8832);
  const RadialModel organ = RandomOrgan(random, Degree);
  std::vector<FitPrecision> rows;
  for (const HardDirections& hard : AllHardDirections())
  {
    for (const double roughness : {0.0, UsualRoughness})
    {
      rows.push_back(MakeRow(hard, organ, roughness));
    }
  }
  return rows;
}

std::string ToMarkdown(const std::vector<FitPrecision>& rows)
{
  std::ostringstream text;
  text
      << "| directions | penalty | condition | float, normal equations, mm | float, orthogonal, mm "
         "| double, normal equations, mm | Palpate, mm |\n|---|---|---|---|---|---|---|\n";
  for (const FitPrecision& row : rows)
  {
    text << "| " << row.Directions << " | "
         << (row.Roughness > 0.0 ? Written(row.Roughness) : "none") << " | "
         << Written(row.Condition) << " | " << Written(row.FloatNormalEquations) << " | "
         << Written(row.FloatOrthogonal) << " | " << Written(row.DoubleNormalEquations) << " | "
         << Written(row.Ours) << " |\n";
  }
  return text.str();
}
} // namespace palpate::test
