#include "ElasticCases.h"

#include <gtest/gtest.h>

namespace palpate::compliance_sampler_test
{
namespace
{
// The bounds are the aims of this module; what is measured is about half of them.
TEST(ComplianceSampler, EqualsTheExactSphere)
{
  std::mt19937_64 random(11);
  for (const double depth : {0.0, 5.0})
  {
    const test::ElasticCase& sphere = test::SphereCase(depth);
    const LayeredSphere truth = test::SphereTruth(depth);
    const ComplianceSampler sampler(sphere.Model, sphere.Solid, sphere.Reduced);
    for (const double patch : {0.5, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0})
    {
      const double exact = truth.Compliance(patch);
      for (int i = 0; i < 5; ++i)
      {
        const double found =
            sampler.Compliance(sampler.PatchAt(test::RandomDirection(random), patch));
        EXPECT_NEAR(found, exact, (depth > 0.0 ? 0.015 : 0.008) * exact)
            << patch << " mm, core " << depth;
      }
    }
  }
}

TEST(ComplianceSampler, PolynomialInterpolatesThePatches)
{
  const test::ElasticCase& sphere = test::SphereCase(5.0);
  const ComplianceSampler sampler(sphere.Model, sphere.Solid, sphere.Reduced);
  const Vector3 direction = Vector3(1.0, 2.0, -0.5).normalized();
  const PatchCompliance place = sampler.At(direction, 9.0);
  for (const double patch : {0.3, 0.7, 1.7, 3.1, 6.2, 8.9})
  {
    const double exact = sampler.Compliance(sampler.PatchAt(direction, patch));
    // Seven terms over a patch that grows thirtyfold.
    EXPECT_NEAR(place.At(patch).Compliance, exact, 0.004 * exact) << patch;
  }
}

TEST(PatchCompliance, DerivativesAreThoseOfTheValue)
{
  const PatchCompliance place{{30.0, -4.0, 1.0, 0.5, -0.2, 0.1, 0.05}, 9.0};
  const double step = 1e-4;
  for (const double patch : {0.5, 2.0, 5.0, 8.5})
  {
    const auto at = place.At(patch);
    const auto before = place.At(patch - step);
    const auto after = place.At(patch + step);
    const double first = (after.Compliance - before.Compliance) / (2.0 * step);
    const double second = (after.First - before.First) / (2.0 * step);
    EXPECT_NEAR(at.First, first, 1e-5 * std::abs(first)) << patch;
    EXPECT_NEAR(at.Second, second, 1e-5 * std::abs(second)) << patch;
  }
}

TEST(PatchCompliance, PassesThroughItsNodes)
{
  const auto nodes = PatchCompliance::Nodes(7.0);
  std::array<double, PatchCompliance::Terms> values{};
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    values[i] = std::exp(-nodes[i]) + 2.0;
  }
  const PatchCompliance place{PatchCompliance::Interpolate(values), 7.0};
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    EXPECT_NEAR(nodes[i] * place.At(nodes[i]).Compliance, values[i], 1e-12) << i;
  }
}
} // namespace
} // namespace palpate::compliance_sampler_test
