#include "EvaluationBenchmarks.h"

#include "GslHarmonics.h"
#include "IcosahedronDirections.h"
#include "RadialEvaluator.h"
#include "RandomShapes.h"
#include "SharpGrid.h"

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
using Evaluator = RadialEvaluator;
using Sample = Evaluator::Sample;
using Formulation = EvaluationFormulation;

std::vector<double> OrganCoefficients(int degree)
{
  test::Random random(12);
  return test::RandomOrgan(random, degree).Coefficients();
}

// 4,002 directions in random order, none of them a pole, which GSL does not have.
std::vector<Vector3> ShuffledDirections()
{
  std::vector<Vector3> directions = IcosahedronDirections(20).Directions();
  test::Random random(13);
  std::shuffle(directions.begin(), directions.end(), random);
  for (Vector3& direction : directions)
  {
    if (std::abs(direction.z()) > 1.0 - 1e-9)
    {
      direction = Vector3(0.01, 0.02, direction.z()).normalized();
    }
  }
  return directions;
}

std::string Difference(double worst, double bound)
{
  if (worst <= bound)
  {
    return {};
  }
  std::ostringstream text;
  text << "results differ by " << worst << " mm";
  return text.str();
}

// What both sides made of the directions.
struct Results
{
  std::vector<Sample> Ours;
  std::vector<Sample> Theirs;

  explicit Results(std::size_t count) : Ours(count), Theirs(count) {}

  std::string Disagreement(double bound) const
  {
    double worst = 0.0;
    for (std::size_t i = 0; i < this->Ours.size(); ++i)
    {
      worst = std::fmax(worst, std::abs(this->Ours[i].Radius - this->Theirs[i].Radius));
      worst = std::fmax(worst,
                        (this->Ours[i].SurfaceGradient - this->Theirs[i].SurfaceGradient).norm());
      worst = std::isnan(this->Ours[i].Radius) ? INFINITY : worst;
    }
    return Difference(worst, bound);
  }
};

template <typename Evaluate>
void OneByOne(const std::vector<Vector3>& directions, std::vector<Sample>& samples,
              const Evaluate& evaluate)
{
  for (std::size_t i = 0; i < directions.size(); ++i)
  {
    samples[i] = evaluate(directions[i]);
  }
}

// Number by number `value`, which is known only once `awaited` is: where a sum with zero times that
// would wait for two roundings more, this waits for two logical operations. `none` is zero, but the
// compiler must not know.
Vector3 Await(const Vector3& value, const Vector3& awaited, std::uint64_t none)
{
  using Bits = std::uint64_t __attribute__((vector_size(16)));
  using Pair = double __attribute__((vector_size(16)));
  const auto wait = [none](Pair a, Pair b) {
    return reinterpret_cast<Pair>(reinterpret_cast<Bits>(a) ^ (reinterpret_cast<Bits>(b) & none));
  };
  const Pair xy = wait(Pair{value[0], value[1]}, Pair{awaited[0], awaited[1]});
  const Pair z = wait(Pair{value[2]}, Pair{awaited[2]});
  return {xy[0], xy[1], z[0]};
}

// Each direction waits for the last result, as in an iterative search.
template <typename Evaluate>
void Chained(const std::vector<Vector3>& directions, std::vector<Sample>& samples,
             const Evaluate& evaluate)
{
  std::uint64_t none = 0;
  benchmark::DoNotOptimize(none);
  Sample last{0.0, Vector3::Zero()};
  for (std::size_t i = 0; i < directions.size(); ++i)
  {
    const Vector3 after(last.Radius, last.SurfaceGradient.y(), last.SurfaceGradient.z());
    last = evaluate(Await(directions[i], after, none));
    samples[i] = last;
  }
}

// Single calls of one formulation and instruction set against GSL's.
struct AgainstGsl
{
  AgainstGsl(int degree, Formulation formulation, InstructionSet set)
      : Ours(degree, OrganCoefficients(degree), formulation, set),
        Theirs(degree, OrganCoefficients(degree)), Directions(ShuffledDirections()),
        Found(Directions.size())
  {
  }

  Evaluator Ours;
  GslHarmonics Theirs;
  std::vector<Vector3> Directions;
  Results Found;
};

PairedBenchmark PairWithGsl(const std::string& name, int degree, bool isChained,
                            Formulation formulation = Formulation::Automatic,
                            InstructionSet set = FastestInstructionSet())
{
  const auto c = std::make_shared<AgainstGsl>(degree, formulation, set);
  const auto run = [isChained, c](std::vector<Sample>& samples, const auto& evaluate)
  {
    isChained ? Chained(c->Directions, samples, evaluate)
              : OneByOne(c->Directions, samples, evaluate);
  };
  // GSL is given z alone: near its poles its gradients have half of the digits.
  return {name,
          "GSL, deriv_alt_array and sums",
          [c, run] { run(c->Found.Ours, [&](const Vector3& u) { return c->Ours.Evaluate(u); }); },
          [c, run]
          { run(c->Found.Theirs, [&](const Vector3& u) { return c->Theirs.Evaluate(u); }); },
          [c] { return c->Found.Disagreement(1e-6); },
          static_cast<double>(c->Directions.size())};
}

PairedBenchmark PairWithSharp()
{
  constexpr int Degree = 12;
  constexpr int Rings = 46;
  constexpr int Columns = 87; // 4,002 nodes
  struct Case
  {
    Evaluator Ours{Degree, OrganCoefficients(Degree)};
    SharpGrid Theirs{Degree, OrganCoefficients(Degree), Rings, Columns};
    Results Found{static_cast<std::size_t>(Rings) * Columns};
  };
  const auto c = std::make_shared<Case>();
  return {"sh/gradient/degree12/batch",
          "libsharp on a grid of 46 x 87",
          [c]
          {
            const std::vector<Vector3>& nodes = c->Theirs.Directions();
            c->Ours.EvaluateBatch(nodes.data(), nodes.size(), c->Found.Ours.data());
          },
          [c] { c->Theirs.Run(); },
          [c]
          {
            for (std::size_t i = 0; i < c->Found.Theirs.size(); ++i)
            {
              c->Found.Theirs[i] = c->Theirs.At(i);
            }
            return c->Found.Disagreement(1e-11);
          },
          static_cast<double>(Rings) * Columns};
}

PairedBenchmark PairValuesWithGsl()
{
  constexpr int Degree = 12;
  struct Case
  {
    Evaluator Ours{Degree, OrganCoefficients(Degree)};
    GslHarmonics Theirs{Degree, OrganCoefficients(Degree)};
    std::vector<Vector3> Directions = ShuffledDirections();
    Results Found{Directions.size()};
  };
  const auto c = std::make_shared<Case>();
  return {"sh/value/degree12/independent",
          "GSL, legendre_array and sums",
          [c]
          {
            OneByOne(c->Directions, c->Found.Ours,
                     [&](const Vector3& u) {
                       return Sample{c->Ours.Radius(u), Vector3::Zero()};
                     });
          },
          [c]
          {
            OneByOne(c->Directions, c->Found.Theirs,
                     [&](const Vector3& u) {
                       return Sample{c->Theirs.Radius(u), Vector3::Zero()};
                     });
          },
          [c] { return c->Found.Disagreement(1e-6); },
          static_cast<double>(c->Directions.size())};
}

// Second derivatives against two gradients along each of two tangents.
PairedBenchmark PairWithDifferences()
{
  constexpr int Degree = 12;
  constexpr double Step = 1e-5;
  struct Case
  {
    Evaluator Ours{Degree, OrganCoefficients(Degree)};
    std::vector<Vector3> Directions = ShuffledDirections();
    std::vector<double> Traces = std::vector<double>(Directions.size());
    std::vector<double> Differences = std::vector<double>(Directions.size());
  };
  const auto c = std::make_shared<Case>();
  const auto differences = [c](const Vector3& u)
  {
    double trace = 0.0;
    const Vector3 first = u.unitOrthogonal();
    for (const Vector3& tangent : {first, Vector3(u.cross(first))})
    {
      const auto slope = [&](double angle)
      {
        const Vector3 at = std::cos(angle) * u + std::sin(angle) * tangent;
        const Vector3 along = std::cos(angle) * tangent - std::sin(angle) * u;
        return c->Ours.Evaluate(at).SurfaceGradient.dot(along);
      };
      trace += (slope(Step) - slope(-Step)) / (2.0 * Step);
    }
    return trace;
  };
  return {"sh/hessian/degree12/independent",
          "differences of our gradients",
          [c]
          {
            for (std::size_t i = 0; i < c->Directions.size(); ++i)
            {
              c->Traces[i] = c->Ours.EvaluateSecondOrder(c->Directions[i]).SurfaceHessian.trace();
            }
          },
          [c, differences]
          {
            for (std::size_t i = 0; i < c->Directions.size(); ++i)
            {
              c->Differences[i] = differences(c->Directions[i]);
            }
          },
          [c]
          {
            double worst = 0.0;
            for (std::size_t i = 0; i < c->Traces.size(); ++i)
            {
              worst = std::fmax(worst, std::abs(c->Traces[i] - c->Differences[i]));
            }
            return Difference(worst, 1e-6);
          },
          static_cast<double>(c->Directions.size())};
}
} // namespace

std::vector<PairedBenchmark> EvaluationBenchmarks()
{
  return {PairWithGsl("sh/gradient/degree12/chained", 12, true),
          PairWithGsl("sh/gradient/degree12/independent", 12, false),
          PairWithSharp(),
          PairWithGsl("sh/gradient/degree12/portable", 12, false, Formulation::Automatic,
                      InstructionSet::Portable),
          PairWithGsl("sh/gradient/degree12/recurrence", 12, false, Formulation::Recurrence),
          PairWithGsl("sh/gradient/degree40/independent", 40, false),
          PairValuesWithGsl(),
          PairWithDifferences()};
}
} // namespace palpate::bench
