// PalpateSurfaceTouch PATHS TICKS [MODEL.json ...]: touches surface models and, without any,
// phantoms of degree 16 by a point and spheres of 1 and 4 mm; prints a table of short paths next to
// searches of the whole surface, and one of a random hand.
#include "ModelFile.h"
#include "ParametricPhantoms.h"
#include "SurfaceTouch.h"

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace palpate::bench
{
namespace
{
using Named = std::pair<std::string, ParametricSphericalSurface>;

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
  for (int i = 0; i < count; ++i)
  {
    models.emplace_back(names[i],
                        std::get<ParametricSphericalSurface>(ReadModel(names[i]).Surface));
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
  std::printf("hand | %s | %g | %ld | %ld | %ld | %ld | %ld | %ld | %.2f | %.1f | %.1f | %.0f\n",
              model.first.c_str(), radius, touched.Ticks, touched.Touching, touched.NotFinite,
              touched.Lags, touched.LongestLag, touched.Jumps, touched.Median, touched.Slow,
              touched.Rare, touched.Longest);
  std::fflush(stdout);
}
} // namespace
} // namespace palpate::bench

int main(int argc, char** argv)
{
  using namespace palpate::bench;
  if (argc < 3)
  {
    std::cerr << "usage: PalpateSurfaceTouch PATHS TICKS [MODEL.json ...]\n";
    return 2;
  }
  try
  {
    const long paths = std::atol(argv[1]);
    const long ticks = std::atol(argv[2]);
    std::puts(
        "paths | surface | radius mm | paths | ticks | touching | ended | unique foot | other part "
        "nearer | off > 1e-9 N | most N | off > 0.05 mm | late | most mm | early | most mm | "
        "overlap | most mm");
    std::puts("hand | surface | radius mm | ticks | touching | not finite | could move | longest, "
              "ticks | jumps > 1 N | median us | 99 % | 99.9 % | longest");
    for (const auto& model : argc > 3 ? ModelsOf(argc - 3, argv + 3) : Phantoms())
    {
      for (const double radius : {0.0, 1.0, 4.0})
      {
        if (paths > 0)
        {
          PrintPaths(model, radius, paths);
        }
        if (ticks > 0)
        {
          PrintTicks(model, radius, ticks);
        }
      }
    }
    return 0;
  }
  catch (const std::exception& error)
  {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
