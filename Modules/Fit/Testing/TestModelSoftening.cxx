#include "ModelSoftening.h"

#include "ComplianceAtlas.h"
#include "InputError.h"
#include "LabelImages.h"
#include "Progress.h"
#include "SphericalHarmonicProjection.h"
#include "SurfacePhantoms.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace palpate::model_softening_test
{
namespace
{
bool GoOn(double, const std::string&)
{
  return true;
}

RadialModel Ball()
{
  return {0, {14.0 * std::sqrt(4.0 * M_PI)}, Vector3::Zero()};
}

// With few elements, since that is quick.
SofteningSettings Quick()
{
  SofteningSettings settings;
  settings.Numbers.ElementsAcross = 4;
  settings.Numbers.Degree = 4;
  settings.Numbers.Maps.Degree = 6;
  return settings;
}

// A ball of 5 mm at x, with `margin` voxels of background around it.
SofteningSettings::Inclusion BallAt(double x0, int margin)
{
  test::LabelGrid grid;
  const int size = 11 + 2 * margin;
  grid.Size = {{size, size, size}};
  grid.CenterOnOrigin();
  grid.Origin[0] += x0;
  auto read = std::make_shared<Segmentation>();
  read->Source = "lesion.nii.gz";
  read->Layers.push_back(test::MakeLabelImage(
      grid, [x0](double x, double y, double z) { return std::hypot(x - x0, y, z) < 5.0; }, 3));
  Segment segment;
  segment.Label = segment.Value = 3;
  read->Segments.push_back(segment);
  return {read, read->Segments, 60.0};
}

TEST(ModelSoftening, BackgroundAroundAnInclusionDoesNotCount)
{
  const auto mapsOf = [](int margin)
  {
    SofteningSettings settings = Quick();
    settings.Inclusions.push_back(BallAt(5.0, margin));
    return *SoftenModel(Ball(), "ball", settings, GoOn).Elasticity;
  };
  const ComplianceMaps narrow = mapsOf(1);
  const ComplianceMaps wide = mapsOf(8);
  for (std::size_t term = 0; term < ComplianceMaps::Count; ++term)
  {
    for (std::size_t i = 0; i < narrow.Coefficients[term].size(); ++i)
    {
      // Up to the rounding of the grids' origins.
      EXPECT_NEAR(narrow.Coefficients[term][i], wide.Coefficients[term][i],
                  1e-9 * (1.0 + std::abs(narrow.Coefficients[term][0])));
    }
  }
}

TEST(ModelSoftening, TellsWhatIsInTheModel)
{
  SofteningSettings settings = Quick();
  EXPECT_EQ(SoftenModel(Ball(), "ball", settings, GoOn).Tissue, "20 kPa");
  settings.Inclusions = {BallAt(5.0, 1), BallAt(60.0, 1)};
  const ModelSoftness made = SoftenModel(Ball(), "ball", settings, GoOn);
  EXPECT_EQ(made.Tissue, "20 kPa, inclusions of 60 kPa");
  ASSERT_EQ(made.Inclusions.size(), 2U);
  EXPECT_TRUE(made.Inclusions.front().IsInside());
  EXPECT_FALSE(made.Inclusions.back().IsInside());
  ASSERT_EQ(made.Warnings().size(), 1U);
  EXPECT_NE(made.Warnings().front().find("lesion.nii.gz lies outside"), std::string::npos);
}

TEST(ModelSoftening, TellsOfASharpHollow)
{
  // A ball with a hole of this depth and angle.
  const auto holed = [](double depth, double angle)
  {
    constexpr int Degree = 20;
    const auto radius = [=](const Vector3& direction)
    {
      const double part = std::acos(std::clamp(direction.z(), -1.0, 1.0)) / angle;
      return 20.0 - depth * std::exp(-part * part);
    };
    return RadialModel(Degree, ProjectOnHarmonics(Degree, 4 * Degree, radius), Vector3::Zero());
  };
  SofteningSettings settings = Quick();
  const auto warnings = SoftenModel(holed(5.0, 0.3), "holed", settings, GoOn).Warnings();
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings.front().find("hollow with a radius of"), std::string::npos);
  EXPECT_TRUE(SoftenModel(holed(1.0, 0.5), "flat", settings, GoOn).Warnings().empty());
  settings.Numbers.ElementsAcross = 10;
  settings.Numbers.Degree = 0;
  const ModelSoftness chosen = SoftenModel(holed(5.0, 0.3), "holed", settings, GoOn);
  EXPECT_TRUE(chosen.Warnings().empty());
  EXPECT_EQ(chosen.ComplianceDegree, OrganSoftening::DegreeInHollows);
}

// Beyond x0 (mm); the ball's surface is at 14 mm.
SofteningSettings::Neighbour WallAt(double x0, double kilopascalPerMillimeter)
{
  test::LabelGrid grid;
  grid.Size = {{45, 45, 45}};
  grid.CenterOnOrigin();
  auto read = std::make_shared<Segmentation>();
  read->Source = "wall.nii.gz";
  read->Layers.push_back(test::MakeLabelImage(
      grid, [x0](double x, double, double) { return x > x0; }, 2));
  Segment segment;
  segment.Label = segment.Value = 2;
  read->Segments.push_back(segment);
  return {read, read->Segments, kilopascalPerMillimeter};
}

TEST(ModelSoftening, NeighbourHoldsWhereItIs)
{
  const auto mapsOf = [](double kilopascalPerMillimeter)
  {
    SofteningSettings settings = Quick();
    settings.Neighbours = {WallAt(12.0, kilopascalPerMillimeter)};
    return ComplianceAtlas(*SoftenModel(Ball(), "ball", settings, GoOn).Elasticity);
  };
  const ComplianceAtlas same = mapsOf(1.0);
  const ComplianceAtlas held = mapsOf(20.0);
  const auto softness = [](const ComplianceAtlas& atlas, const Vector3& direction)
  { return atlas.At(direction).Compliance.At(3.0).Compliance; };
  const Vector3 towards = Vector3::UnitX();
  EXPECT_LT(softness(held, towards), 0.8 * softness(same, towards));
  EXPECT_GT(softness(held, -towards), 0.9 * softness(same, -towards));
  // As stiff as the rest of the support.
  EXPECT_NEAR(softness(same, towards), softness(same, -towards), 1e-3 * softness(same, towards));
}

TEST(ModelSoftening, NeighbourThatIsNoneIsTold)
{
  SofteningSettings settings = Quick();
  settings.Neighbours = {WallAt(20.0, 5.0)};
  const ModelSoftness made = SoftenModel(Ball(), "ball", settings, GoOn);
  ASSERT_EQ(made.Notes.size(), 1U);
  EXPECT_NE(made.Notes.front().find("wall.nii.gz is not next to"), std::string::npos);
}

TEST(ModelSoftening, RefusesModelsOfThreeCoordinates)
{
  EXPECT_THROW(SoftenModel(test::OpenRing(4), "ring", Quick(), GoOn), InputError);
}

TEST(ModelSoftening, CancelThrows)
{
  const auto stop = [](double, const std::string&) { return false; };
  EXPECT_THROW(SoftenModel(Ball(), "ball", Quick(), stop), Cancelled);
}

TEST(SofteningSettings, FailsOutsideOfItsLimits)
{
  EXPECT_TRUE(SofteningSettings().Check().IsOk());
  const auto fails = [](auto change)
  {
    SofteningSettings settings;
    change(settings);
    return !settings.Check().IsOk();
  };
  const double nan = std::nan("");
  for (const double modulus : {-1.0, 0.0, 1e-4, 1e7, nan})
  {
    EXPECT_TRUE(fails([=](SofteningSettings& s) { s.TissueKilopascal = modulus; })) << modulus;
    EXPECT_TRUE(fails([=](SofteningSettings& s) { s.Inclusions = {{nullptr, {}, modulus}}; }));
  }
  for (const double ratio : {-0.1, 0.5, nan})
  {
    EXPECT_TRUE(fails([=](SofteningSettings& s) { s.PoissonRatio = ratio; })) << ratio;
  }
  for (const double support : {0.0, 1e6, nan})
  {
    EXPECT_TRUE(fails([=](SofteningSettings& s) { s.BedPerMillimeter = support; })) << support;
  }
  for (const double support : {0.0, 1e6, nan})
  {
    EXPECT_TRUE(fails([=](SofteningSettings& s) { s.Neighbours = {{nullptr, {}, support}}; }));
  }
  for (const double degrees : {0.0, 180.0, nan})
  {
    EXPECT_TRUE(fails([=](SofteningSettings& s) { s.FreeDegrees = degrees; })) << degrees;
  }
  for (const int elements : {2, 5, 26})
  {
    EXPECT_TRUE(fails([=](SofteningSettings& s) { s.Numbers.ElementsAcross = elements; }));
  }
}

// Before any element is made; the same number for a larger modulus is not refused.
TEST(ModelSoftening, RefusesSupportThatLeavesNothingToYield)
{
  SofteningSettings settings = Quick();
  settings.BedPerMillimeter = 290.0; // of at most 200 x 20 kPa / 14 mm
  double most = 0.0;
  const auto watch = [&most](double part, const std::string&)
  {
    most = std::max(most, part);
    return true;
  };
  try
  {
    SoftenModel(Ball(), "ball.json", settings, watch);
    FAIL();
  }
  catch (const InputError& error)
  {
    EXPECT_NE(std::string(error.what()).find("at most 286 kPa per mm"), std::string::npos)
        << error.what();
  }
  EXPECT_EQ(most, 0.0);
  settings.BedPerMillimeter = 280.0;
  EXPECT_NE(SoftenModel(Ball(), "ball.json", settings, GoOn).Elasticity, nullptr);
  settings.BedPerMillimeter = 290.0;
  settings.TissueKilopascal = 21.0;
  EXPECT_NE(SoftenModel(Ball(), "ball.json", settings, GoOn).Elasticity, nullptr);
}
} // namespace
} // namespace palpate::model_softening_test
