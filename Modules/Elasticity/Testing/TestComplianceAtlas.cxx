#include "ElasticCases.h"
#include "OrganSoftening.h"
#include "SphericalHarmonicProjection.h"
#include "Units.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include <limits>

namespace palpate::compliance_atlas_test
{
namespace
{
ComplianceMaps MapsOf(const test::ElasticCase& organ, const ComplianceMaps::Settings& settings)
{
  ComplianceMaps maps;
  const Status status =
      ComplianceMaps::Fit(organ.Model, organ.Solid, organ.Reduced, settings, {}, maps);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return maps;
}

TEST(ComplianceMaps, AreConstantOnASphere)
{
  const test::ElasticCase& sphere = test::SphereCase(0.0);
  const ComplianceMaps maps = MapsOf(sphere, {4, 9.0});
  EXPECT_LE(maps.FitError.Largest, 2e-3); // the grid of elements
  const ComplianceAtlas atlas(maps);
  const LayeredSphere truth = test::SphereTruth(0.0);
  for (const Vector3& d : {Vector3(1, 0, 0), Vector3(0, 0, -1)})
  {
    const ComplianceAtlas::Place place = atlas.At(d);
    EXPECT_NEAR(place.MeanCurvature, 1.0 / test::Radius, 1e-9);
    EXPECT_NEAR(place.Compliance.At(4.0).Compliance / truth.Compliance(4.0), 1.0, 0.01);
  }
}

TEST(ComplianceMaps, StateTheirError)
{
  std::mt19937_64 random(41);
  test::ElasticCase organ;
  organ.Model = test::RandomModel(random, 4, 0.02);
  organ.Solid.Tissue.AddInclusion(
      test::BallFraction(organ.Model.CenterWorld() + Vector3(15.0, 0.0, 0.0), 7.0), 0.1);
  ASSERT_NO_FATAL_FAILURE(organ.Build(8, 8));
  const ComplianceMaps coarse = MapsOf(organ, {6, 0.0});
  const ComplianceMaps fine = MapsOf(organ, {20, 0.0});
  EXPECT_LT(fine.FitError.Rms, 0.5 * coarse.FitError.Rms);
  const ComplianceAtlas atlas(fine);
  EXPECT_LE(atlas.Bytes(), 100U * 1024U);
  // At other directions than those that were compared.
  const ComplianceSampler sampler(organ.Model, organ.Solid, organ.Reduced);
  double sum = 0.0;
  constexpr int Count = 100;
  for (int i = 0; i < Count; ++i)
  {
    const Vector3 d = test::RandomDirection(random);
    const double patch = fine.FitError.PatchRadius;
    const double off = atlas.At(d).Compliance.At(patch).Compliance /
                           sampler.Compliance(sampler.PatchAt(d, patch)) -
                       1.0;
    sum += off * off;
  }
  const double rms = std::sqrt(sum / Count);
  EXPECT_LT(rms, 2.0 * fine.FitError.Rms);
  EXPECT_GT(rms, 0.5 * fine.FitError.Rms);
}

class SmallOrgan : public ::testing::Test
{
protected:
  void SetUp() override
  {
    std::mt19937_64 random(43);
    this->Organ.Model = test::RandomModel(random, 4, 0.02);
    this->Organ.Build(4, 4);
  }
  test::ElasticCase Organ;
};

TEST_F(SmallOrgan, MapsRefuseSettingsOutsideLimits)
{
  ComplianceMaps maps;
  for (const ComplianceMaps::Settings& settings :
       {ComplianceMaps::Settings{-1, 0.0}, {ComplianceMaps::MostDegree + 1, 0.0}, {4, 1000.0}})
  {
    EXPECT_FALSE(ComplianceMaps::Fit(this->Organ.Model, this->Organ.Solid, this->Organ.Reduced,
                                     settings, {}, maps)
                     .IsOk());
  }
}

TEST_F(SmallOrgan, MapsStopWhenCancelled)
{
  ComplianceMaps maps;
  int calls = 0;
  EXPECT_FALSE(ComplianceMaps::Fit(
                   this->Organ.Model, this->Organ.Solid, this->Organ.Reduced, {4, 0.0},
                   [&](double) { return ++calls < 5; }, maps)
                   .IsOk());
  EXPECT_EQ(calls, 5);
}

TEST_F(SmallOrgan, TruncatedMapsKeepTheirLowDegrees)
{
  const ComplianceMaps maps = MapsOf(this->Organ, {6, 0.0});
  const ComplianceMaps low = maps.Truncated(3);
  EXPECT_TRUE(low.Check().IsOk()) << low.Check().Message();
  EXPECT_EQ(low.Degree, 3);
  EXPECT_EQ(low.LargestPatch, maps.LargestPatch);
  EXPECT_EQ(low.FitError.Rms, 0.0);
  for (std::size_t map = 0; map < ComplianceMaps::Count; ++map)
  {
    ASSERT_EQ(low.Coefficients[map].size(), 16U);
    EXPECT_TRUE(std::equal(low.Coefficients[map].begin(), low.Coefficients[map].end(),
                           maps.Coefficients[map].begin()));
  }
  const ComplianceMaps same = maps.Truncated(7);
  EXPECT_EQ(same.Degree, 6);
  EXPECT_EQ(same.Coefficients, maps.Coefficients);
}

TEST_F(SmallOrgan, CheckFindsMapsThatAreNoBody)
{
  const ComplianceMaps maps = MapsOf(this->Organ, {4, 0.0});
  EXPECT_TRUE(maps.Check().IsOk()) << maps.Check().Message();
  const auto isRefused = [&](const auto& change)
  {
    ComplianceMaps changed = maps;
    change(changed);
    return !changed.Check().IsOk();
  };
  EXPECT_TRUE(isRefused([](ComplianceMaps& m) { m.Coefficients[0][0] *= -1.0; }));
  EXPECT_TRUE(isRefused([](ComplianceMaps& m) { m.Coefficients[1][0] = 1e3; }));
  EXPECT_TRUE(isRefused([](ComplianceMaps& m) { m.Coefficients[3].pop_back(); }));
  EXPECT_TRUE(isRefused([](ComplianceMaps& m)
                        { m.Coefficients[7][2] = std::numeric_limits<double>::quiet_NaN(); }));
  EXPECT_TRUE(isRefused([](ComplianceMaps& m) { m.Coefficients[7][0] = 1e6; }));
  EXPECT_TRUE(isRefused([](ComplianceMaps& m) { m.Coefficients[0][0] = 1e12; }));
  EXPECT_TRUE(isRefused([](ComplianceMaps& m) { m.LargestPatch = 0.0; }));
  EXPECT_TRUE(isRefused([](ComplianceMaps& m) { m.LargestPatch = 1e7; }));
  EXPECT_TRUE(isRefused([](ComplianceMaps& m) { m.PoissonRatio = 0.5; }));
  EXPECT_TRUE(isRefused([](ComplianceMaps& m) { m.Degree = 5; }));
}

// A ball does not fit into it, but maps of whole surfaces include it.
TEST(ComplianceMaps, OfADeepHollowAreThoseOfABody)
{
  test::ElasticCase organ;
  organ.Model = test::HollowModel();
  ASSERT_NO_FATAL_FAILURE(organ.Build(8, 8));
  const ComplianceMaps maps = MapsOf(organ, {16, 0.0});
  EXPECT_LT(ComplianceAtlas(maps).At(test::HollowDirection()).MeanCurvature, -0.1);
  EXPECT_TRUE(maps.Check().IsOk()) << maps.Check().Message();
}

TEST(OrganSoftening, DegreeIsWhatTheSurfaceNeedsAndElementsCarry)
{
  const RadialModel ball(0, {20.0 * std::sqrt(4.0 * Pi)}, Vector3::Zero());
  const auto groove = [](const Vector3& direction)
  { return 20.0 - 4.0 * std::exp(-std::pow(direction.x() / 0.15, 2)); };
  const RadialModel cleft(24, ProjectOnHarmonics(24, 96, groove), Vector3::Zero());
  EXPECT_EQ(OrganSoftening::SharpestHollow(ball), std::numeric_limits<double>::infinity());
  // 0.75 mm before its harmonics above 24 are left out.
  EXPECT_NEAR(OrganSoftening::SharpestHollow(cleft), 1.0, 0.3);
  OrganSoftening softening;
  EXPECT_EQ(softening.DegreeFor(ball), 12);
  EXPECT_EQ(softening.DegreeFor(cleft), 20);
  softening.ElementsAcross = 6;
  EXPECT_EQ(softening.DegreeFor(ball), 6);
  EXPECT_EQ(softening.DegreeFor(cleft), 12);
  softening.Degree = 16;
  EXPECT_EQ(softening.DegreeFor(ball), 12) << "two for each element";
}

TEST(OrganSoftening, MakesTheSameMapsAsItsParts)
{
  std::mt19937_64 random(47);
  test::ElasticCase organ;
  organ.Model = test::RandomModel(random, 4, 0.02);
  ASSERT_NO_FATAL_FAILURE(organ.Build(6, 6));
  OrganSoftening softening;
  softening.ElementsAcross = 6;
  softening.Degree = 6;
  softening.Maps.Degree = 8;
  ComplianceMaps maps;
  OrganSoftening::Account account;
  double last = -1.0;
  const auto progress = [&](double fraction)
  {
    EXPECT_GE(fraction, last);
    EXPECT_LE(fraction, 1.0);
    last = fraction;
    return true;
  };
  const Status status = softening.Make(organ.Model, organ.Solid, progress, maps, account);
  ASSERT_TRUE(status.IsOk()) << status.Message();
  EXPECT_EQ(last, 1.0);
  EXPECT_EQ(account.Unknowns, 3 * organ.Mesh.Nodes().size());
  EXPECT_EQ(account.ElementEdge, organ.Mesh.SurfaceEdge());
  const ComplianceMaps parts = MapsOf(organ, {8, 0.0});
  for (std::size_t map = 0; map < ComplianceMaps::Count; ++map)
  {
    for (std::size_t i = 0; i < parts.Coefficients[map].size(); ++i)
    {
      EXPECT_EQ(maps.Coefficients[map][i], parts.Coefficients[map][i]);
    }
  }
}
} // namespace
} // namespace palpate::compliance_atlas_test
