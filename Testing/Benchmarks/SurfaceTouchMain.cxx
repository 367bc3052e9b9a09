// PalpateSurfaceTouch PATHS TICKS TIMED [MODEL.json ...]: touches surface models and, without any,
// phantoms of degree 16 by a point and spheres of 1, 2 and 4 mm; prints a table of short paths next
// to searches of the whole surface, one of a random hand, and one of times, scaled by GSL, of each
// model and of the ticks of all.
#include "GslHarmonics.h"
#include "ModelFile.h"
#include "SurfacePhantoms.h"
#include "SurfaceTouch.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace palpate::bench
{
namespace
{
using Named = std::pair<std::string, SurfaceModel>;

std::vector<Named> Phantoms()
{
  test::Random random(5);
  return {{"C", test::OpenRing()},
          {"bowl", test::Bowl()},
          {"bent tube", test::BumpyTube(random)},
          {"blob with a cleft", test::CleftBlob()},
          {"ring that crosses itself", test::CrossingRing()}};
}

std::vector<Named> ModelsOf(int count, char** names)
{
  std::vector<Named> models;
  models.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i)
  {
    models.emplace_back(names[i], std::get<SurfaceModel>(ReadModel(names[i]).Surface));
  }
  return models;
}

void PrintPaths(const Named& model, double radius, long paths)
{
  const TouchedPaths touched = TouchPaths(model.second, radius, paths);
  const auto& counts = touched.Counts;
  std::printf(
      "paths | %s | %g | %ld | %ld | %ld | %ld | %ld | %ld | %ld | %.2g | %ld | %ld | %.2g | %ld "
      "| %.2g | %ld | %.2g\n",
      model.first.c_str(), radius, touched.Paths, counts.Ticks, counts.Touching, counts.Ended,
      counts.Unique, counts.Other, counts.Inexact, counts.Error.Value(), counts.Wrong, counts.Late,
      counts.LateDepth.Value(), counts.Early, counts.EarlyGap.Value(), counts.Overlaps,
      counts.Overlap.Value());
  std::fflush(stdout);
}

void PrintTicks(const Named& model, double radius, long ticks)
{
  const TouchedTicks touched = TouchByHand(model.second, radius, ticks);
  std::printf("hand | %s | %g | %ld | %ld | %ld | %ld | %ld | %ld\n", model.first.c_str(), radius,
              touched.Ticks, touched.Touching, touched.NotFinite, touched.Lags, touched.LongestLag,
              touched.Jumps);
  std::fflush(stdout);
}

// Of GSL's gradient of degree 12, us: the shortest of many.
double TimeGsl()
{
  using Ticking = std::chrono::steady_clock;
  constexpr int Calls = 200;
  test::Random random(7);
  GslHarmonics harmonics(12, test::RandomCoefficients(random, 12));
  const std::vector<Vector3> directions = test::RandomDirections(random, Calls);
  double shortest = 1e300;
  double sum = 0.0;
  for (int run = 0; run < 200; ++run)
  {
    const Ticking::time_point start = Ticking::now();
    for (const Vector3& direction : directions)
    {
      sum += harmonics.Evaluate(direction).Radius;
    }
    const double time = std::chrono::duration<double, std::micro>(Ticking::now() - start).count();
    shortest = std::min(shortest, time / Calls);
  }
  return std::isfinite(sum) ? shortest : 0.0;
}

double PartOf(std::vector<float>& times, double part)
{
  const auto at = static_cast<std::ptrdiff_t>(part * static_cast<double>(times.size() - 1));
  std::nth_element(times.begin(), times.begin() + at, times.end());
  return times[static_cast<std::size_t>(at)];
}

void PrintTimes(const std::string& name, double radius, double gsl, std::vector<float> times)
{
  std::printf("times | %s | %g | %.3f | %.2f | %.2f | %.1f | %.1f\n", name.c_str(), radius,
              1e3 * gsl, PartOf(times, 0.5), PartOf(times, 0.99), PartOf(times, 0.999),
              PartOf(times, 1.0));
  std::fflush(stdout);
}

/// Times by tools, of single surfaces and of all ticks together.
class TouchTimes
{
public:
  void Measure(const Named& model, double radius, long ticks)
  {
    constexpr double Reference = 0.541; // us, of GSL's gradient on the machine of the aims
    std::vector<float> times = TimeTouch(model.second, radius, ticks);
    const double gsl = TimeGsl();
    for (float& time : times)
    {
      time *= static_cast<float>(Reference / gsl);
    }
    PrintTimes(model.first, radius, gsl, times);
    std::vector<float>& all = this->All[radius];
    all.insert(all.end(), times.begin(), times.end());
    this->Gsl = std::min(this->Gsl, gsl);
  }
  void PrintAll() const
  {
    for (const auto& [radius, times] : this->All)
    {
      PrintTimes("all", radius, this->Gsl, times);
    }
  }

private:
  std::map<double, std::vector<float>> All;
  double Gsl = std::numeric_limits<double>::infinity(); // us, the shortest
};
} // namespace
} // namespace palpate::bench

int main(int argc, char** argv)
{
  using namespace palpate::bench;
  if (argc < 4)
  {
    std::cerr << "usage: PalpateSurfaceTouch PATHS TICKS TIMED [MODEL.json ...]\n";
    return 2;
  }
  try
  {
    const long paths = std::atol(argv[1]);
    const long ticks = std::atol(argv[2]);
    const long timed = std::atol(argv[3]);
    std::puts(
        "paths | surface | radius mm | paths | ticks | touching | ended | unique foot | other part "
        "nearer | off > 1e-9 N | most N | off > 0.05 mm | late | most mm | early | most mm | "
        "overlap | most mm");
    std::puts("hand | surface | radius mm | ticks | touching | not finite | could move | longest, "
              "ticks | jumps > 1 N");
    std::puts("times | surface | radius mm | GSL ns | median us | 99 % | 99.9 % | longest");
    TouchTimes times;
    for (const auto& model : argc > 4 ? ModelsOf(argc - 4, argv + 4) : Phantoms())
    {
      for (const double radius : {0.0, 1.0, 2.0, 4.0})
      {
        if (paths > 0)
        {
          PrintPaths(model, radius, paths);
        }
        if (ticks > 0)
        {
          PrintTicks(model, radius, ticks);
        }
        if (timed > 0)
        {
          times.Measure(model, radius, timed);
        }
      }
    }
    times.PrintAll();
    return 0;
  }
  catch (const std::exception& error)
  {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
