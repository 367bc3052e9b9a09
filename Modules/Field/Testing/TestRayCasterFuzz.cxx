#include "RandomRays.h"
#include "RandomVolume.h"
#include "SameBits.h"

#include <cmath>
#include <limits>

namespace palpate::ray_caster_fuzz_test
{
namespace
{
using test::RandomVolume;
using test::RayOracle;
using test::SameBits;

const double Infinity = std::numeric_limits<double>::infinity();
constexpr FieldInterpolation Methods[] = {FieldInterpolation::Trilinear,
                                          FieldInterpolation::TricubicBSpline};

void ExpectNoFaults(FieldInterpolation method, int volumes, int raysOfEach, unsigned seed)
{
  std::mt19937_64 random(seed);
  int hits = 0;
  for (int v = 0; v < volumes; ++v)
  {
    const RandomVolume volume(method, random);
    const RayCaster caster(volume.Field);
    const RayOracle oracle = volume.Oracle();
    for (int r = 0; r < raysOfEach; ++r)
    {
      const FieldRay ray = test::RandomRay(volume.Grid, random);
      double tMin = random() % 3 == 0 ? 0.0 : -Infinity;
      for (int crossing = 0; crossing < 3; ++crossing)
      {
        const FieldHit hit = caster.CastIndex(ray, tMin, Infinity);
        const std::string fault = oracle.Fault(ray, tMin, Infinity, hit);
        ASSERT_EQ(fault, "") << "seed " << seed << " volume " << v << " ray " << r << ": from "
                             << ray.Origin.transpose() << " along " << ray.Direction.transpose()
                             << " after " << tMin;
        if (hit.Kind == HitKind::Missed)
        {
          break;
        }
        ++hits;
        tMin = std::nextafter(hit.T, Infinity);
      }
    }
  }
  EXPECT_GE(hits, volumes * raysOfEach / 2);
}

TEST(RayCasterFuzz, TrilinearHitsAgreeWithTheOracle)
{
  ExpectNoFaults(FieldInterpolation::Trilinear, 150, 100, 31);
}

TEST(RayCasterFuzz, TricubicHitsAgreeWithTheOracle)
{
  ExpectNoFaults(FieldInterpolation::TricubicBSpline, 60, 40, 32);
}

TEST(RayCasterFuzz, EveryIntervalWithTheHitGivesItsBits)
{
  for (const FieldInterpolation method : Methods)
  {
    std::mt19937_64 random(33);
    for (int v = 0; v < 60; ++v)
    {
      const RandomVolume volume(method, random);
      const RayCaster caster(volume.Field);
      for (int r = 0; r < 60; ++r)
      {
        const FieldRay ray = test::RandomRay(volume.Grid, random);
        const FieldHit hit = caster.CastIndex(ray, -100.0, Infinity);
        if (hit.Kind == HitKind::Missed || (hit.Kind == HitKind::Border && !hit.IsEntering))
        {
          continue;
        }
        std::uniform_real_distribution<double> part(0.0, 1.0);
        for (const double share : {0.0, 1.0, part(random), part(random), 1.0 - 1e-3 * part(random)})
        {
          double tMin = -100.0 + share * (hit.T + 100.0);
          tMin = std::min(tMin, hit.T);
          FieldHit again = caster.CastIndex(ray, tMin, hit.T + part(random) * part(random));
          if (tMin > -100.0 && hit.StartsInside != again.StartsInside)
          {
            // It started outside the grid, or where the first one started.
            FAIL() << "starts elsewhere: volume " << v << " ray " << r;
          }
          ASSERT_TRUE(SameBits(hit, again)) << "volume " << v << " ray " << r << " from " << tMin;
          ASSERT_TRUE(SameBits(hit, caster.CastIndex(ray, tMin, hit.T)));
        }
      }
    }
  }
}

TEST(RayCasterFuzz, BatchesGiveTheBitsOfSingleRays)
{
  std::mt19937_64 random(34);
  for (const FieldInterpolation method : Methods)
  {
    const RandomVolume volume(method, random);
    const RayCaster caster(volume.Field);
    std::vector<FieldRay> rays;
    rays.reserve(300);
    for (int r = 0; r < 300; ++r)
    {
      rays.push_back(test::RandomRay(volume.Grid, random));
    }
    std::vector<FieldHit> hits(rays.size());
    const std::vector<RayInterval> intervals(rays.size(), {0.0, 1e3});
    caster.CastAllWorld(rays.data(), intervals.data(), rays.size(), hits.data());
    for (std::size_t r = 0; r < rays.size(); ++r)
    {
      ASSERT_TRUE(SameBits(hits[r], caster.CastWorld(rays[r], 0.0, 1e3)));
    }
  }
}

// From denormal to huge, and the same for the interval: only the existence of a result matters.
TEST(RayCasterFuzz, HandlesEveryMagnitude)
{
  std::mt19937_64 random(36);
  const auto number = [&random]
  {
    const double size = std::pow(10.0, static_cast<double>(random() % 640) - 325.0);
    return random() % 8 == 0 ? 0.0 : random() % 2 == 0 ? size : -size;
  };
  for (const FieldInterpolation method : Methods)
  {
    const RandomVolume volume(method, random);
    const RayCaster caster(volume.Field);
    for (int r = 0; r < 20000; ++r)
    {
      FieldRay ray = test::RandomRay(volume.Grid, random);
      ray.Direction[static_cast<int>(random() % 3)] = number();
      if (random() % 2 == 0)
      {
        ray.Direction = {number(), number(), number()};
      }
      if (random() % 4 == 0)
      {
        ray.Origin[static_cast<int>(random() % 3)] = number();
      }
      const double tMin = random() % 2 == 0 ? -Infinity : number();
      const FieldHit hit = caster.CastIndex(ray, tMin, random() % 2 == 0 ? Infinity : number());
      ASSERT_TRUE(hit.Kind != HitKind::Surface || hit.T >= tMin);
    }
  }
}

// Closed solids: no ray from the inside leaves undetected, aimed at nodes, edges and faces exactly.
TEST(RayCasterFuzz, NothingLeaksThroughFacesEdgesOrCorners)
{
  std::mt19937_64 random(35);
  for (const FieldInterpolation method : Methods)
  {
    const FieldGrid grid = test::PlainGrid({24, 24, 24});
    std::vector<double> samples = test::RandomSteps(grid, random, 4);
    for (std::size_t at = 0; at < samples.size(); ++at)
    {
      const Vector3 p = test::NodeIndex(grid.Size(), at);
      const double radius = (p - Vector3::Constant(12.0)).lpNorm<Eigen::Infinity>();
      samples[at] += radius < 6.0 ? 40.0 : radius < 9.0 ? 4.0 : -40.0;
    }
    const RayCaster caster(test::MakeField(grid, samples, 6.0, method));
    for (std::size_t target = 0; target < grid.NodeCount(); ++target)
    {
      const Vector3 node = test::NodeIndex(grid.Size(), target);
      for (const Vector3& aim :
           {node, Vector3(node + Vector3(0.5, 0, 0)), Vector3(node + Vector3(0, 0.5, 0.5))})
      {
        const Vector3 direction = aim - Vector3::Constant(12.0);
        if (direction.lpNorm<Eigen::Infinity>() < 1.0)
        {
          continue;
        }
        const FieldHit hit = caster.CastIndex({Vector3::Constant(12.0), direction}, 0.0, Infinity);
        ASSERT_EQ(hit.Kind, HitKind::Surface) << direction.transpose();
        ASSERT_EQ(hit.StartsInside, 1u);
        ASSERT_FALSE(hit.IsEntering);
      }
    }
  }
}
} // namespace
} // namespace palpate::ray_caster_fuzz_test
