#include "ElasticCases.h"

#include <gtest/gtest.h>

#include <limits>

namespace palpate::tissue_map_test
{
namespace
{
std::shared_ptr<TissueMap::Samples> Uniform(float value)
{
  auto samples = std::make_shared<TissueMap::Samples>();
  samples->Grid =
      FieldGrid({3, 4, 5}, Vector3::Zero(), Vector3(1.0, 2.0, 1.0), Matrix3::Identity());
  samples->Values.assign(60, value);
  return samples;
}

TEST(TissueMap, LaterInclusionsLieOverEarlierOnes)
{
  TissueMap tissue(0.02);
  tissue.AddInclusion(test::BallFraction(Vector3::Zero(), 10.0), 0.04);
  tissue.AddInclusion(test::BallFraction(Vector3::Zero(), 3.0), 0.1);
  ASSERT_TRUE(tissue.Check().IsOk());
  EXPECT_FLOAT_EQ(static_cast<float>(tissue.Modulus(Vector3(1, 0, 0))), 0.1F);
  EXPECT_FLOAT_EQ(static_cast<float>(tissue.Modulus(Vector3(0, 6, 0))), 0.04F);
  EXPECT_DOUBLE_EQ(tissue.Modulus(Vector3(0, 0, 30)), 0.02);
}

TEST(TissueMap, PartialVolumesCountInPart)
{
  TissueMap tissue(0.02);
  tissue.AddInclusion(Uniform(0.25F), 0.06);
  EXPECT_NEAR(tissue.Modulus(Vector3(1.0, 1.0, 1.0)), 0.03, 1e-12);
}

TEST(TissueMap, ImageCountsWhereItHasModuli)
{
  const std::shared_ptr<TissueMap::Samples> image = Uniform(0.05F);
  image->Values[0] = -1.0F;
  image->Values[59] = std::numeric_limits<float>::quiet_NaN();
  TissueMap tissue(0.02);
  tissue.AddImage(image);
  EXPECT_FLOAT_EQ(static_cast<float>(tissue.Modulus(Vector3(1.0, 2.0, 2.0))), 0.05F);
  EXPECT_DOUBLE_EQ(tissue.Modulus(Vector3(0.0, 0.0, 0.0)), 0.02);
  EXPECT_DOUBLE_EQ(tissue.Modulus(Vector3(2.0, 6.0, 4.0)), 0.02);
  EXPECT_DOUBLE_EQ(tissue.Modulus(Vector3(-50.0, 0.0, 0.0)), 0.02);
}

// Images are often 0 outside of an organ.
TEST(TissueMap, RimOfAnImageLeadsToTheTissueAroundIt)
{
  for (const float outside : {0.0F, -1.0F, std::numeric_limits<float>::quiet_NaN()})
  {
    const std::shared_ptr<TissueMap::Samples> image = Uniform(0.05F);
    for (std::size_t i = 0; i < image->Values.size(); i += 3)
    {
      image->Values[i] = outside;
    }
    TissueMap tissue(0.02);
    tissue.AddImage(image);
    for (const double x : {0.0, 0.25, 0.5, 0.999, 1.0})
    {
      EXPECT_NEAR(tissue.Modulus(Vector3(x, 3.0, 2.0)), 0.02 + 0.03 * x, 1e-8) << x << outside;
    }
  }
}

TEST(TissueMap, InterpolatesLinearlyToTheLastNode)
{
  auto image = Uniform(0.0F);
  for (std::size_t i = 0; i < image->Values.size(); ++i)
  {
    image->Values[i] = 0.01F * static_cast<float>(1 + i % 3);
  }
  TissueMap tissue(0.5);
  tissue.AddImage(image);
  for (const double x : {0.0, 0.4, 1.0, 1.9, 2.0})
  {
    EXPECT_NEAR(tissue.Modulus(Vector3(x, 6.0, 4.0)), 0.01 * (1.0 + x), 1e-8) << x;
  }
}

TEST(TissueMap, ExaggeratesContrastsWithTheTissueOnly)
{
  TissueMap tissue(0.02);
  tissue.AddImage(Uniform(0.06F));
  tissue.Exaggerate(2.0);
  ASSERT_TRUE(tissue.Check().IsOk());
  EXPECT_NEAR(tissue.Modulus(Vector3(1.0, 6.0, 4.0)), 0.18, 1e-7) << "nine times";
  EXPECT_EQ(tissue.Modulus(Vector3(1e3, 0.0, 0.0)), 0.02);
  tissue.Exaggerate(5.0);
  EXPECT_LE(tissue.Modulus(Vector3(1.0, 6.0, 4.0)), TissueMap::MostModulus);
  for (const double power : {0.5, 6.0, std::numeric_limits<double>::quiet_NaN()})
  {
    tissue.Exaggerate(power);
    EXPECT_FALSE(tissue.Check().IsOk()) << power;
  }
}

TEST(TissueMap, RefusesSamplesThatDoNotFitTheirGrid)
{
  const std::shared_ptr<TissueMap::Samples> image = Uniform(0.05F);
  image->Values.pop_back();
  TissueMap tissue(0.02);
  tissue.AddImage(image);
  EXPECT_FALSE(tissue.Check().IsOk());
}

TEST(ElasticBed, IsZeroWhereFreeAndWholeElsewhere)
{
  ElasticBed bed(2e-3);
  bed.Free(Vector3(0.0, 3.0, 0.0), 0.7);
  EXPECT_TRUE(bed.Check().IsOk());
  EXPECT_DOUBLE_EQ(bed.At(Vector3::UnitY()), 0.0);
  EXPECT_DOUBLE_EQ(bed.At(Vector3(std::sin(0.69), std::cos(0.69), 0.0)), 0.0);
  EXPECT_DOUBLE_EQ(bed.At(Vector3(std::sin(0.9), std::cos(0.9), 0.0)), 2e-3);
  EXPECT_DOUBLE_EQ(bed.At(-Vector3::UnitY()), 2e-3);
}

TEST(ElasticBed, EveryConeIsFree)
{
  ElasticBed bed(2e-3);
  bed.Free(Vector3::UnitX(), 0.5);
  bed.Free(Vector3::UnitY(), 0.5);
  EXPECT_EQ(bed.At(Vector3::UnitX()), 0.0);
  EXPECT_EQ(bed.At(Vector3::UnitY()), 0.0);
  EXPECT_EQ(bed.At(Vector3::UnitZ()), 2e-3);
}

TEST(ElasticBed, WhatHoldsCountsInsteadOfTheRest)
{
  ElasticBed bed(2e-3);
  bed.Free(Vector3::UnitX(), 0.5);
  bed.Hold([](const Vector3& direction) { return 2.0 * std::max(0.0, direction.x()) - 0.5; }, 6e-3);
  EXPECT_TRUE(bed.Check().IsOk());
  EXPECT_DOUBLE_EQ(bed.At(Vector3::UnitX()), 6e-3);
  EXPECT_DOUBLE_EQ(bed.At(-Vector3::UnitX()), 2e-3);
  EXPECT_DOUBLE_EQ(bed.At(Vector3(0.5, 0.0, -std::sqrt(0.75))), 4e-3);
}

TEST(ElasticBed, RefusesStiffnessesThatAreNone)
{
  for (const double stiffness : {-1e-3, 1e9, std::numeric_limits<double>::quiet_NaN()})
  {
    EXPECT_FALSE(ElasticBed(stiffness).Check().IsOk()) << stiffness;
    ElasticBed bed;
    bed.Hold([](const Vector3&) { return 1.0; }, stiffness);
    EXPECT_FALSE(bed.Check().IsOk()) << stiffness;
  }
}

TEST(ElasticBed, RefusesConesThatAreNone)
{
  for (const double angle : {0.0, -1.0, 4.0, std::numeric_limits<double>::quiet_NaN()})
  {
    ElasticBed bed;
    bed.Free(Vector3::UnitX(), angle);
    EXPECT_FALSE(bed.Check().IsOk()) << angle;
  }
  ElasticBed bed;
  bed.Free(Vector3(std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0), 1.0);
  EXPECT_FALSE(bed.Check().IsOk());
}
} // namespace
} // namespace palpate::tissue_map_test
