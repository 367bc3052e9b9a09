#include "AllocationCounter.h"
#include "FieldCases.h"
#include "FieldSampler.h"
#include "RandomRays.h"
#include "RayCaster.h"

#include <utility>

namespace palpate::field_queries_do_not_allocate_test
{
namespace
{
// Functions for the servo thread cannot throw either.
static_assert(
    noexcept(std::declval<const FieldSampler&>().IsInsideWorld(0, std::declval<const Vector3&>())));
static_assert(noexcept(
    std::declval<const FieldSampler&>().ValueAndGradientWorld(0, std::declval<const Vector3&>())));
static_assert(noexcept(std::declval<const FieldSampler&>().AreInsideWorld(0, nullptr, 0, nullptr)));
static_assert(noexcept(std::declval<const RayCaster&>().CastWorld(std::declval<const FieldRay&>(),
                                                                  0.0, 1.0)));

TEST(FieldQueriesDoNotAllocate, OfSamplersAndRayCasters)
{
  std::mt19937_64 random(51);
  for (const auto method : {FieldInterpolation::Trilinear, FieldInterpolation::TricubicBSpline})
  {
    const FieldGrid grid = test::ObliqueGrid({25, 12, 9}, random);
    const auto samples = test::RandomSteps<std::int16_t>(grid, random, 7);
    const auto field = test::MakeField(grid, samples, 3.0, method);
    const FieldSampler sampler(field);
    const RayCaster caster(field);
    std::vector<FieldRay> rays;
    std::vector<Vector3> points;
    for (int n = 0; n < 200; ++n)
    {
      rays.push_back(test::RandomRay(grid, random));
      points.push_back(grid.PointWorld(rays.back().Origin));
    }
    const std::vector<RayInterval> intervals(rays.size(), {0.0, 1e3});
    std::vector<FieldHit> hits(rays.size());
    std::vector<unsigned char> inside(points.size());
    bool isFound = false;
    const std::size_t before = test::AllocationCount();
    caster.CastAllWorld(rays.data(), intervals.data(), rays.size(), hits.data());
    sampler.AreInsideWorld(0, points.data(), points.size(), inside.data());
    for (std::size_t n = 0; n < rays.size(); ++n)
    {
      hits[n] = caster.CastIndex(rays[n], 0.0, 1e3);
      isFound |= sampler.IsInsideWorld(0, points[n]);
      inside[n] = sampler.ValueAndGradientWorld(0, points[n]).Kind != SampleKind::Outside;
    }
    EXPECT_EQ(test::AllocationCount(), before);
    EXPECT_TRUE(isFound);
  }
}
} // namespace
} // namespace palpate::field_queries_do_not_allocate_test
