#include "CoarseField.h"

#include "FieldSampler.h"
#include "MaterialVolume.h"
#include "ProceduralFields.h"

#include <cmath>

namespace palpate
{
namespace
{
using test::MaterialVolume;

TEST(CoarseField, HoldsWhatTheFineOneHoldsAtEveryPoint)
{
  std::mt19937_64 random(51);
  int held = 0;
  for (int round = 0; round < 60; ++round)
  {
    const MaterialVolume volume(random);
    const FieldForm form{round % 2 == 0 ? FieldInterpolation::Trilinear
                                        : FieldInterpolation::TricubicBSpline,
                         BrickSizes[random() % 3]};
    const auto fine = volume.Make(form);
    for (int material = 0; material < MaterialVolume::Materials; ++material)
    {
      std::shared_ptr<const ScalarField> coarse;
      if (!MakeCoarseField(*fine, material, coarse).IsOk())
      {
        continue; // it fills everything
      }
      const FieldSampler fineSampler(fine);
      const FieldSampler coarseSampler(coarse);
      for (int point = 0; point < 400; ++point)
      {
        const Vector3 p = test::RandomPointNear(volume.Grid, random);
        if (fineSampler.IsInsideIndex(material, p))
        {
          ++held;
          ASSERT_TRUE(coarseSampler.IsInsideIndex(0, 0.5 * p)) << p.transpose();
        }
      }
    }
  }
  EXPECT_GT(held, 3000);
}

// Where the coarse one is inside there is a fine node nearer than its reach.
TEST(CoarseField, ReachesNoFartherThanItSays)
{
  std::mt19937_64 random(52);
  const int reach = CoarseReach(FieldInterpolation::Trilinear);
  for (int round = 0; round < 10; ++round)
  {
    const FieldGrid grid = test::PlainGrid({30 + static_cast<int>(random() % 3), 33, 28});
    std::vector<float> samples(grid.NodeCount(), -1.0f);
    for (int bump = 0; bump < 12; ++bump)
    {
      samples[random() % samples.size()] = static_cast<float>(random() % 100);
    }
    const auto fine = test::MakeField(grid, samples, 0.0, FieldInterpolation::Trilinear,
                                      BrickSizes[random() % 3]);
    std::shared_ptr<const ScalarField> coarse;
    ASSERT_TRUE(MakeCoarseField(*fine, 0, coarse).IsOk());
    const FieldSampler sampler(coarse);
    for (int point = 0; point < 3000; ++point)
    {
      const Vector3 p = test::RandomPointNear(grid, random);
      if (!sampler.IsInsideIndex(0, 0.5 * p))
      {
        continue;
      }
      double nearest = 1e9;
      for (std::size_t n = 0; n < samples.size(); ++n)
      {
        nearest =
            samples[n] >= 0.0f
                ? std::min(nearest, (test::NodeIndex(grid.Size(), n) - p).lpNorm<Eigen::Infinity>())
                : nearest;
      }
      ASSERT_LT(nearest, reach);
    }
  }
}

// On a ball whose field is the distance, the coarse surface stands out by less than the reach.
TEST(CoarseField, OfASmoothBallIsABallThatIsALittleLarger)
{
  std::mt19937_64 random(53);
  const FieldGrid grid = test::PlainGrid({61, 61, 61});
  const Vector3 middle(30.2, 29.7, 30.4);
  constexpr double Radius = 18.0;
  const test::SphereField sphere{middle, Radius};
  const auto samples = test::SampleAtIndices(grid.Size(), sphere);
  for (const FieldInterpolation method :
       {FieldInterpolation::Trilinear, FieldInterpolation::TricubicBSpline})
  {
    const auto fine = test::MakeField(grid, samples, 0.0, method);
    std::shared_ptr<const ScalarField> coarse;
    ASSERT_TRUE(MakeCoarseField(*fine, 0, coarse).IsOk());
    const FieldSampler sampler(coarse);
    const double outer = Radius + std::sqrt(3.0) * CoarseReach(method);
    std::normal_distribution<double> normal;
    for (int n = 0; n < 2000; ++n)
    {
      const double x = normal(random);
      const double y = normal(random);
      const Vector3 u = Vector3(x, y, normal(random)).normalized();
      ASSERT_TRUE(sampler.IsInsideIndex(0, 0.5 * (middle + (Radius - 0.05) * u)));
      ASSERT_FALSE(sampler.IsInsideIndex(0, 0.5 * (middle + outer * u)));
    }
  }
}

TEST(CoarseField, OfWholeNumbersTakesAQuarterOfTheMemory)
{
  const FieldGrid grid = test::PlainGrid({161, 161, 161});
  std::vector<std::int16_t> samples(grid.NodeCount());
  for (std::size_t n = 0; n < samples.size(); ++n)
  {
    const double distance = (test::NodeIndex(grid.Size(), n) - Vector3(80.0, 80.0, 80.0)).norm();
    samples[n] = static_cast<std::int16_t>(std::lround(40.0 * (65.0 - distance)));
  }
  const auto fine = test::MakeField(grid, samples, 0.5);
  std::shared_ptr<const ScalarField> coarse;
  ASSERT_TRUE(MakeCoarseField(*fine, 0, coarse).IsOk());
  EXPECT_EQ(coarse->Channel(0).StoredType(), ScalarType::Int16);
  EXPECT_LT(coarse->Memory().Bytes, fine->Memory().Bytes * 30 / 100);
}

TEST(CoarseField, OfWhatThenFillsEverythingIsRefused)
{
  const FieldGrid grid = test::PlainGrid({20, 20, 20});
  std::vector<float> samples(grid.NodeCount(), 1.0f);
  samples[grid.NodeCount() / 2] = -1.0f;
  const auto fine = test::MakeField(grid, samples, 0.0);
  std::shared_ptr<const ScalarField> coarse;
  EXPECT_FALSE(MakeCoarseField(*fine, 0, coarse).IsOk());
  EXPECT_EQ(coarse, nullptr);
}
} // namespace
} // namespace palpate
