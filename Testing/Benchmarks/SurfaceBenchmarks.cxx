#include "SurfaceBenchmarks.h"

#include "GslHarmonics.h"
#include "IcosahedronDirections.h"
#include "RandomShapes.h"
#include "SurfaceEvaluator.h"

#include <algorithm>
#include <benchmark/benchmark.h>
#include <cmath>
#include <cstdint>
#include <memory>
#include <sstream>

namespace palpate::bench
{
namespace
{
using Together = SurfaceEvaluator;
using Series = RadialEvaluator;

Together::Coefficients SurfaceCoefficients(int degree)
{
  test::Random random(14);
  Together::Coefficients coefficients;
  for (std::vector<double>& coordinate : coefficients)
  {
    coordinate = test::RandomCoefficients(random, degree, 2.0);
  }
  return coefficients;
}

// 1,002 parameters in random order, none of them a pole, which GSL does not have.
std::vector<Vector3> ShuffledParameters()
{
  std::vector<Vector3> parameters = IcosahedronDirections(10).Directions();
  test::Random random(15);
  std::shuffle(parameters.begin(), parameters.end(), random);
  for (Vector3& u : parameters)
  {
    u = std::abs(u.z()) > 1.0 - 1e-9 ? Vector3(0.01, 0.02, u.z()).normalized() : u;
  }
  return parameters;
}

// Both sides with one instruction set.
struct SurfaceCase
{
  SurfaceCase(int degree, InstructionSet set)
      : Surface(degree, SurfaceCoefficients(degree), EvaluationFormulation::Automatic, set),
        Parameters(ShuffledParameters()), Found(Parameters.size()), FoundApart(Parameters.size())
  {
    for (const std::vector<double>& coordinate : SurfaceCoefficients(degree))
    {
      this->Apart.emplace_back(degree, coordinate, EvaluationFormulation::Automatic, set);
    }
  }

  // Numbers that only one side computes stay as they are.
  void Point()
  {
    for (std::size_t i = 0; i < this->Parameters.size(); ++i)
    {
      this->Found[i].Point = this->Surface.Point(this->Parameters[i]);
    }
  }
  void First()
  {
    for (std::size_t i = 0; i < this->Parameters.size(); ++i)
    {
      const Together::Sample sample = this->Surface.Evaluate(this->Parameters[i]);
      this->Found[i].Point = sample.Point;
      this->Found[i].First = sample.First;
      this->Found[i].Tangents = sample.Tangents;
    }
  }
  void Second()
  {
    for (std::size_t i = 0; i < this->Parameters.size(); ++i)
    {
      this->Found[i] = this->Surface.EvaluateSecondOrder(this->Parameters[i]);
    }
  }
  // Each parameter waits for the last result, as in Newton's method.
  void Chained()
  {
    double none = 0.0; // but the compiler must not know
    benchmark::DoNotOptimize(none);
    Vector3 last = Vector3::Zero();
    for (std::size_t i = 0; i < this->Parameters.size(); ++i)
    {
      this->Found[i] = this->Surface.EvaluateSecondOrder(this->Parameters[i] + none * last);
      last = this->Found[i].Second[2];
    }
  }

  using ApartSample = std::array<Series::SecondOrderSample, 3>;
  template <typename Evaluate>
  void EvaluateApart(const Evaluate& evaluate)
  {
    for (std::size_t i = 0; i < this->Parameters.size(); ++i)
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        evaluate(this->Apart[k], this->Parameters[i], this->FoundApart[i][k]);
      }
    }
  }
  void PointApart()
  {
    this->EvaluateApart([](const Series& series, const Vector3& u, Series::SecondOrderSample& s)
                        { s.Radius = series.Radius(u); });
  }
  void FirstApart()
  {
    this->EvaluateApart(
        [](const Series& series, const Vector3& u, Series::SecondOrderSample& s)
        {
          const Series::Sample sample = series.Evaluate(u);
          s.Radius = sample.Radius;
          s.SurfaceGradient = sample.SurfaceGradient;
        });
  }
  void SecondApart()
  {
    this->EvaluateApart([](const Series& series, const Vector3& u, Series::SecondOrderSample& s)
                        { s = series.EvaluateSecondOrder(u); });
  }
  void ChainedApart()
  {
    double none = 0.0;
    benchmark::DoNotOptimize(none);
    Vector3 last = Vector3::Zero();
    for (std::size_t i = 0; i < this->Parameters.size(); ++i)
    {
      const Vector3 u = this->Parameters[i] + none * last;
      for (std::size_t k = 0; k < 3; ++k)
      {
        this->FoundApart[i][k] = this->Apart[k].EvaluateSecondOrder(u);
        last[static_cast<Eigen::Index>(k)] = this->FoundApart[i][k].SurfaceHessian(2, 2);
      }
    }
  }

  // What both computed, up to this order of derivatives.
  std::string Disagreement(int order) const
  {
    double worst = 0.0;
    for (std::size_t i = 0; i < this->Parameters.size(); ++i)
    {
      for (Eigen::Index k = 0; k < 3; ++k)
      {
        const Together::SecondOrderSample& s = this->Found[i];
        const auto& [a, b] = s.Tangents;
        const Series::SecondOrderSample& apart = this->FoundApart[i][static_cast<std::size_t>(k)];
        const auto add = [&worst](double difference)
        {
          // NaN disagrees.
          worst = std::abs(difference) <= worst ? worst : std::abs(difference);
        };
        add(s.Point[k] - apart.Radius);
        if (order > 0)
        {
          add(s.First[0][k] - apart.SurfaceGradient.dot(a));
          add(s.First[1][k] - apart.SurfaceGradient.dot(b));
        }
        if (order > 1)
        {
          add(s.Second[0][k] - a.dot(apart.SurfaceHessian * a));
          add(s.Second[1][k] - a.dot(apart.SurfaceHessian * b));
          add(s.Second[2][k] - b.dot(apart.SurfaceHessian * b));
        }
      }
    }
    if (worst <= 1e-9)
    {
      return {};
    }
    std::ostringstream text;
    text << "results differ by " << worst << " mm";
    return text.str();
  }

  Together Surface;
  std::vector<Series> Apart;
  std::vector<Vector3> Parameters;
  std::vector<Together::SecondOrderSample> Found;
  std::vector<ApartSample> FoundApart;
};

PairedBenchmark SurfacePair(const std::string& name, int degree, int order,
                            void (SurfaceCase::*run)(), void (SurfaceCase::*runApart)(),
                            InstructionSet set = FastestInstructionSet())
{
  const auto c = std::make_shared<SurfaceCase>(degree, set);
  return {name,
          "three separate evaluators",
          [c, run] { ((*c).*run)(); },
          [c, runApart] { ((*c).*runApart)(); },
          [c, order] { return c->Disagreement(order); },
          static_cast<double>(c->Parameters.size())};
}

// GSL offers no second derivatives: it computes the gradient of one coordinate only.
PairedBenchmark SurfaceWithGsl()
{
  constexpr int Degree = 12;
  struct Case : SurfaceCase
  {
    Case() : SurfaceCase(Degree, FastestInstructionSet()) {}
    GslHarmonics Theirs{Degree, SurfaceCoefficients(Degree)[0]};
  };
  const auto c = std::make_shared<Case>();
  return {"surface/second/degree12/gsl",
          "GSL, gradient of one coordinate",
          [c] { c->Second(); },
          [c]
          {
            for (std::size_t i = 0; i < c->Parameters.size(); ++i)
            {
              const Series::Sample sample = c->Theirs.Evaluate(c->Parameters[i]);
              c->FoundApart[i][0].Radius = sample.Radius;
              c->FoundApart[i][0].SurfaceGradient = sample.SurfaceGradient;
            }
          },
          [c]() -> std::string
          {
            for (std::size_t i = 0; i < c->Parameters.size(); ++i)
            {
              const Together::SecondOrderSample& s = c->Found[i];
              const double slope = c->FoundApart[i][0].SurfaceGradient.dot(s.Tangents[0]);
              if (!(std::abs(s.First[0].x() - slope) <= 1e-6))
              {
                return "a gradient differs by more than 1e-6 mm";
              }
            }
            return {};
          },
          static_cast<double>(c->Parameters.size())};
}
} // namespace

std::vector<PairedBenchmark> SurfaceBenchmarks()
{
  using Case = SurfaceCase;
  return {
      SurfacePair("surface/point/degree12/independent", 12, 0, &Case::Point, &Case::PointApart),
      SurfacePair("surface/first/degree12/independent", 12, 1, &Case::First, &Case::FirstApart),
      SurfacePair("surface/second/degree12/independent", 12, 2, &Case::Second, &Case::SecondApart),
      SurfacePair("surface/second/degree12/chained", 12, 2, &Case::Chained, &Case::ChainedApart),
      SurfacePair("surface/second/degree12/portable", 12, 2, &Case::Second, &Case::SecondApart,
                  InstructionSet::Portable),
      SurfacePair("surface/second/degree20/independent", 20, 2, &Case::Second, &Case::SecondApart),
      SurfacePair("surface/second/degree40/independent", 40, 2, &Case::Second, &Case::SecondApart),
      SurfaceWithGsl()};
}
} // namespace palpate::bench
