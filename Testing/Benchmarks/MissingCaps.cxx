#include "MissingCaps.h"

#include "IcosahedronDirections.h"
#include "RadialModelFit.h"
#include "RandomShapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>

namespace palpate::bench
{
namespace
{
using Options = RadialModelFitOptions;

constexpr int CapDegree = 12;
constexpr double Noise = 0.3; // mm

struct PenaltyKind
{
  const char* Name;
  Options::Penalty Kind;
  double Strength;
};
constexpr std::array<PenaltyKind, 3> Penalties{
    {{"none", Options::Penalty::None, 0.0},
     {"cross-validation", Options::Penalty::GeneralisedCrossValidation, 0.0},
     {"1e-3", Options::Penalty::Given, 1e-3}}};

struct Errors
{
  double Inside = 0.0;
  double Outside = 0.0;
  double Strength = 0.0;
};

bool IsMissing(const Vector3& direction, double capDegrees)
{
  return capDegrees > 0.0 && direction.z() > std::cos(capDegrees * M_PI / 180.0);
}

RadialSamples Samples(const IcosahedronDirections& sphere, const RadialModel& body,
                      double capDegrees, test::Random& random)
{
  std::normal_distribution<double> noise(0.0, Noise);
  const std::vector<double> angles = sphere.SolidAngles();
  RadialSamples samples;
  for (std::size_t i = 0; i < angles.size(); ++i)
  {
    const Vector3& direction = sphere.Directions()[i];
    if (!IsMissing(direction, capDegrees))
    {
      samples.Directions.push_back(direction);
      samples.Radii.push_back(body.Radius(direction) + noise(random));
      samples.Weights.push_back(angles[i]);
    }
  }
  return samples;
}

Options FitOptions(Options::Penalty kind, double strength)
{
  Options options;
  options.Degree = CapDegree;
  options.PenaltyKind = kind;
  options.Roughness = strength;
  options.MaximumCondition = std::numeric_limits<double>::infinity();
  return options;
}

Errors Fit(const IcosahedronDirections& sphere, double capDegrees, const PenaltyKind& penalty,
           unsigned seed)
{
  test::Random random(seed);
  const RadialModel body = test::RandomOrgan(random, CapDegree);
  const Options options = FitOptions(penalty.Kind, penalty.Strength);
  RadialModelFitResult result;
  constexpr double NoFit = std::numeric_limits<double>::infinity();
  if (!FitRadialModel(Samples(sphere, body, capDegrees, random), options, result).IsOk())
  {
    return {NoFit, NoFit, 0.0};
  }
  const RadialModel fitted(CapDegree, result.Coefficients, Vector3::Zero());
  Errors errors;
  errors.Strength = result.Roughness;
  for (const Vector3& direction : sphere.Directions())
  {
    double& worst = IsMissing(direction, capDegrees) ? errors.Inside : errors.Outside;
    worst = std::max(worst, std::abs(fitted.Radius(direction) - body.Radius(direction)));
  }
  return errors;
}

MissingCapRow MakeCapRow(const IcosahedronDirections& sphere, double capDegrees,
                         const PenaltyKind& penalty, int bodies)
{
  MissingCapRow row{};
  row.CapDegrees = capDegrees;
  row.Penalty = penalty.Name;
  std::vector<double> strengths;
  for (int body = 0; body < bodies; ++body)
  {
    const Errors errors = Fit(sphere, capDegrees, penalty, 700U + static_cast<unsigned>(body));
    row.ErrorInside = std::max(row.ErrorInside, errors.Inside);
    row.ErrorOutside = std::max(row.ErrorOutside, errors.Outside);
    strengths.push_back(errors.Strength);
  }
  std::sort(strengths.begin(), strengths.end());
  row.Strength = strengths[strengths.size() / 2];
  test::Random random(1);
  const RadialSamples samples = Samples(sphere, RadialModel(), capDegrees, random);
  const Options options = FitOptions(
      row.Strength > 0.0 ? Options::Penalty::Given : Options::Penalty::None, row.Strength);
  DirectionCoverage coverage;
  RadialModelFitResult fit;
  Status status = FitRadialModel(samples, options, fit);
  if (status.IsOk())
  {
    status = AssessCoverage(samples.Directions, samples.Weights, fit, coverage);
  }
  row.Condition = coverage.Condition;
  row.NoiseGainRms = coverage.NoiseGainRms;
  row.NoiseGainMaximum = coverage.NoiseGainMaximum;
  row.Verdict = coverage.Outcome;
  row.Message = status.IsOk() ? coverage.Message : status.Message();
  return row;
}

const char* NameOfVerdict(DirectionCoverage::Verdict verdict)
{
  switch (verdict)
  {
  case DirectionCoverage::Verdict::Good:
    return "good";
  case DirectionCoverage::Verdict::Gaps:
    return "gaps";
  case DirectionCoverage::Verdict::Undetermined:
    break;
  }
  return "undetermined";
}
} // namespace

std::vector<MissingCapRow> MissingCaps(int bodies)
{
  const IcosahedronDirections sphere(20);
  std::vector<MissingCapRow> rows;
  for (int cap = 0; cap <= 60; cap += 10)
  {
    for (const PenaltyKind& penalty : Penalties)
    {
      rows.push_back(MakeCapRow(sphere, cap, penalty, bodies));
    }
  }
  return rows;
}

std::string ToMarkdown(const std::vector<MissingCapRow>& rows)
{
  std::ostringstream text;
  text
      << "| cap | penalty | strength | condition | noise gain, rms | maximum | error outside, mm | "
         "inside, mm | verdict |\n|---|---|---|---|---|---|---|---|---|\n";
  text << std::setprecision(2);
  for (const MissingCapRow& row : rows)
  {
    text << "| " << static_cast<int>(row.CapDegrees) << "° | " << row.Penalty << " | "
         << row.Strength << " | " << row.Condition << " | " << row.NoiseGainRms << " | "
         << row.NoiseGainMaximum << " | " << row.ErrorOutside << " | " << row.ErrorInside << " | "
         << NameOfVerdict(row.Verdict) << " |\n";
  }
  return text.str();
}
} // namespace palpate::bench
