#include "TradeOff.h"

#include "IcosahedronDirections.h"
#include "RadialEvaluator.h"
#include "RandomShapes.h"
#include "TextbookHarmonics.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <numeric>
#include <sstream>

namespace palpate::bench
{
namespace
{
constexpr int BodyDegree = 96;
constexpr double MeanRadius = 25.0; // mm
constexpr std::size_t DirectionCount = 1000;

// One way to evaluate a degree.
struct Variant
{
  int Degree;
  EvaluationFormulation Formulation;
  bool IsBatch;

  std::string FormulationName() const
  {
    return this->Formulation == EvaluationFormulation::Automatic ? "polynomials" : "recurrence";
  }
  std::string CallsName() const { return this->IsBatch ? "batch" : "one"; }
  std::string Name() const
  {
    return "sh/tradeoff/degree" + std::to_string(this->Degree) + "/" + this->FormulationName() +
           "/" + this->CallsName();
  }
};

std::vector<Variant> AllVariants()
{
  std::vector<Variant> variants;
  for (const int degree : {4, 8, 12, 16})
  {
    for (const bool isBatch : {false, true})
    {
      variants.push_back({degree, EvaluationFormulation::Automatic, isBatch});
    }
  }
  for (const int degree : {4, 8, 12, 16, 20, 32, 48, 64})
  {
    variants.push_back({degree, EvaluationFormulation::Recurrence, false});
  }
  return variants;
}

RadialModel TradedBody()
{
  test::Random random(20261120);
  std::vector<double> coefficients = test::RandomCoefficients(random, BodyDegree, 2.5);
  for (double& c : coefficients)
  {
    c *= 8.0;
  }
  coefficients[0] = MeanRadius * std::sqrt(4.0 * M_PI);
  return {BodyDegree, coefficients, Vector3::Zero()};
}

// The directions, evaluated one way; single calls in an order without pattern.
class Evaluation
{
public:
  Evaluation(const Variant& variant, const std::vector<double>& coefficients)
      : Evaluator(variant.Degree, coefficients, variant.Formulation), IsBatch(variant.IsBatch),
        Samples(DirectionCount)
  {
    test::Random random(3);
    this->Directions = test::RandomDirections(random, static_cast<int>(DirectionCount));
  }

  void Run()
  {
    if (this->IsBatch)
    {
      this->Evaluator.EvaluateBatch(this->Directions.data(), DirectionCount, this->Samples.data());
      return;
    }
    for (std::size_t i = 0; i < DirectionCount; ++i)
    {
      this->Samples[i] = this->Evaluator.Evaluate(this->Directions[i]);
    }
  }

  double Radius(std::size_t direction) const { return this->Samples[direction].Radius; }

private:
  RadialEvaluator Evaluator;
  bool IsBatch;
  std::vector<Vector3> Directions;
  std::vector<RadialEvaluator::Sample> Samples;
};

PairedBenchmark Pair(const Variant& variant, const std::vector<double>& coefficients)
{
  const auto ours = std::make_shared<Evaluation>(variant, coefficients);
  const auto plain = std::make_shared<Evaluation>(
      Variant{variant.Degree, EvaluationFormulation::Recurrence, false}, coefficients);
  const auto disagreement = [ours, plain]() -> std::string
  {
    double worst = 0.0;
    for (std::size_t i = 0; i < DirectionCount; ++i)
    {
      worst = std::fmax(worst, std::abs(ours->Radius(i) - plain->Radius(i)));
    }
    constexpr double Bound = 1e-11;
    std::ostringstream text;
    text << "radii differ by " << worst << " mm";
    return worst <= Bound ? std::string() : text.str();
  };
  return {variant.Name(),
          "recurrence, one direction a call",
          [ours] { ours->Run(); },
          [plain] { plain->Run(); },
          disagreement,
          static_cast<double>(DirectionCount)};
}

// Largest error of the radius of the truncated body, for a few directions: the oracle is slow.
double Rounding(const Variant& variant, const std::vector<double>& coefficients)
{
  const RadialEvaluator evaluator(variant.Degree, coefficients, variant.Formulation);
  test::Random random(4);
  double worst = 0.0;
  for (const Vector3& direction : test::RandomDirections(random, 20))
  {
    const Vector3 exact = direction.normalized();
    long double sum = 0.0L;
    for (int l = 0; l <= variant.Degree; ++l)
    {
      for (int m = -l; m <= l; ++m)
      {
        sum += coefficients[SphericalHarmonicBasis::Index(l, m)] * test::TextbookReal(l, m, exact);
      }
    }
    const long double error = evaluator.Evaluate(direction).Radius - sum;
    worst = std::fmax(worst, static_cast<double>(std::abs(error)));
  }
  return worst;
}

// Root mean square over all directions (Parseval).
double LostRms(const RadialModel& body, int degree)
{
  const std::vector<double> power = body.PowerSpectrum();
  return std::sqrt(std::accumulate(power.begin() + degree + 1, power.end(), 0.0) / (4.0 * M_PI));
}

double LargestLoss(const RadialModel& body, int degree)
{
  const RadialModel truncated = body.WithDegree(degree);
  const IcosahedronDirections sphere(20);
  double worst = 0.0;
  for (const Vector3& direction : sphere.Directions())
  {
    worst = std::fmax(worst, std::abs(body.Radius(direction) - truncated.Radius(direction)));
  }
  return worst;
}
} // namespace

std::vector<PairedBenchmark> TradeOffBenchmarks()
{
  const RadialModel body = TradedBody();
  std::vector<PairedBenchmark> pairs;
  for (const Variant& variant : AllVariants())
  {
    const std::vector<double> coefficients = body.WithDegree(variant.Degree).Coefficients();
    pairs.push_back(Pair(variant, coefficients));
  }
  return pairs;
}

std::vector<TradeOffRow> TradeOffRows(const std::vector<Comparison>& comparisons)
{
  const RadialModel body = TradedBody();
  std::vector<TradeOffRow> rows;
  for (const Variant& variant : AllVariants())
  {
    const auto measured = std::find_if(comparisons.begin(), comparisons.end(),
                                       [name = variant.Name()](const Comparison& comparison)
                                       { return comparison.Name == name; });
    if (measured == comparisons.end())
    {
      continue;
    }
    const std::vector<double> coefficients = body.WithDegree(variant.Degree).Coefficients();
    rows.push_back({variant.Degree, variant.FormulationName(), variant.CallsName(),
                    measured->Nanoseconds, Rounding(variant, coefficients),
                    LostRms(body, variant.Degree), LargestLoss(body, variant.Degree)});
  }
  return rows;
}

std::string ToJson(const std::vector<TradeOffRow>& rows)
{
  nlohmann::json list = nlohmann::json::array();
  for (const TradeOffRow& row : rows)
  {
    list.push_back({{"degree", row.Degree},
                    {"formulation", row.Formulation},
                    {"calls", row.Calls},
                    {"ns", row.Nanoseconds},
                    {"rounding_mm", row.RoundingMillimeters},
                    {"lost_rms_mm", row.LostRmsMillimeters},
                    {"lost_maximum_mm", row.LostMaximumMillimeters}});
  }
  return list.dump(2);
}
} // namespace palpate::bench
