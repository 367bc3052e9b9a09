#include "ElasticCases.h"

#include <gtest/gtest.h>

namespace palpate
{
namespace
{
TEST(ComplianceAtlas, IsConstantOnASphere)
{
  const test::ElasticCase& sphere = test::SphereCase(0.0);
  ComplianceAtlas atlas;
  const Status status =
      ComplianceAtlas::Make(sphere.Model, sphere.Solid, sphere.Reduced, {4, 9.0}, {}, atlas);
  ASSERT_TRUE(status.IsOk()) << status.Message();
  EXPECT_LE(atlas.FitError().Largest, 2e-3); // the grid of elements
  const LayeredSphere truth = test::SphereTruth(0.0);
  for (const Vector3& d : {Vector3(1, 0, 0), Vector3(0, 0, -1)})
  {
    const ComplianceAtlas::Place place = atlas.At(d);
    EXPECT_NEAR(place.MeanCurvature, 1.0 / test::Radius, 1e-9);
    EXPECT_NEAR(place.Compliance.At(4.0).Compliance / truth.Compliance(4.0), 1.0, 0.01);
  }
}

TEST(ComplianceAtlas, StatesItsError)
{
  std::mt19937_64 random(41);
  test::ElasticCase organ;
  organ.Model = test::RandomModel(random, 4, 0.02);
  organ.Solid.Tissue.AddInclusion(
      test::BallFraction(organ.Model.CenterWorld() + Vector3(15.0, 0.0, 0.0), 7.0), 0.1);
  ASSERT_NO_FATAL_FAILURE(organ.Build(8, 8));
  ComplianceAtlas coarse;
  ComplianceAtlas fine;
  ASSERT_TRUE(
      ComplianceAtlas::Make(organ.Model, organ.Solid, organ.Reduced, {6, 0.0}, {}, coarse).IsOk());
  ASSERT_TRUE(
      ComplianceAtlas::Make(organ.Model, organ.Solid, organ.Reduced, {20, 0.0}, {}, fine).IsOk());
  EXPECT_LT(fine.FitError().Rms, 0.5 * coarse.FitError().Rms);
  EXPECT_LE(fine.Bytes(), 100U * 1024U);
  // At other directions than those that were compared.
  const ComplianceSampler sampler(organ.Model, organ.Solid, organ.Reduced);
  double sum = 0.0;
  constexpr int Count = 100;
  for (int i = 0; i < Count; ++i)
  {
    const Vector3 d = test::RandomDirection(random);
    const double patch = fine.FitError().PatchRadius;
    const double off =
        fine.At(d).Compliance.At(patch).Compliance / sampler.Compliance(sampler.PatchAt(d, patch)) -
        1.0;
    sum += off * off;
  }
  const double rms = std::sqrt(sum / Count);
  EXPECT_LT(rms, 2.0 * fine.FitError().Rms);
  EXPECT_GT(rms, 0.5 * fine.FitError().Rms);
}

TEST(ComplianceAtlas, RefusesSettingsOutsideLimitsAndStopsWhenCancelled)
{
  std::mt19937_64 random(43);
  test::ElasticCase organ;
  organ.Model = test::RandomModel(random);
  ASSERT_NO_FATAL_FAILURE(organ.Build(4, 4));
  ComplianceAtlas atlas;
  const auto make = [&](const ComplianceAtlas::Settings& settings, const KernelProgress& progress)
  {
    return ComplianceAtlas::Make(organ.Model, organ.Solid, organ.Reduced, settings, progress, atlas)
        .IsOk();
  };
  EXPECT_FALSE(make({-1, 0.0}, {}));
  EXPECT_FALSE(make({ComplianceAtlas::MostDegree + 1, 0.0}, {}));
  EXPECT_FALSE(make({4, 1000.0}, {}));
  int calls = 0;
  EXPECT_FALSE(make({4, 0.0}, [&](double) { return ++calls < 5; }));
  EXPECT_EQ(calls, 5);
}
} // namespace
} // namespace palpate
