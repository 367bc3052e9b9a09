#include "GuideDistance.h"

#include "InputError.h"
#include "ModelSurface.h"
#include "Progress.h"
#include "RandomShapes.h"

#include <cmath>
#include <gtest/gtest.h>

namespace palpate::guide_distance_test
{
namespace
{
bool GoOn(double, const std::string&)
{
  return true;
}

// A ball as a surface of triangles.
SceneProduct Ball(double radius, const Vector3& center)
{
  FitSurface surface;
  surface.Found.Surface = DrawModel(RadialModel(0, {radius * std::sqrt(4.0 * M_PI)}, center), 60);
  return std::make_shared<const FitSurface>(std::move(surface));
}

SceneSettings GuidedBy(int id, std::vector<std::pair<double, double>> distancesAndRanges)
{
  SceneSettings scene;
  for (const auto& [distance, range] : distancesAndRanges)
  {
    GuideSettings guide;
    guide.Shape = GuideShape::Outside;
    guide.Structure = id;
    guide.Distance = distance;
    guide.Range = range;
    scene.Guides.push_back(guide);
  }
  return scene;
}

TEST(GuideDistance, SignedDistanceOfABallIsRightWithinTheReach)
{
  const Vector3 center(3.0, -20.0, 7.5);
  const auto made = MakeGuideDistance({}, Ball(15.0, center), {15.0, 1.0}, GoOn);
  test::Random random(60);
  std::uniform_real_distribution<double> from(1.0, 29.5);
  for (int n = 0; n < 3000; ++n)
  {
    const Vector3 out = test::RandomDirection(random);
    const double radius = from(random);
    const auto place = made->At(center + radius * out);
    ASSERT_TRUE(place);
    // Smoothing by a step of 1 mm raises the distance by 1 / radius.
    EXPECT_NEAR(place->Distance, radius - 15.0, 0.02 + 1.1 / radius);
    EXPECT_NEAR((place->GradientWorld - out).norm(), 0.0, 0.01 + 2.0 / (radius * radius));
  }
  EXPECT_NEAR(made->Steepest(), 1.0, 0.02);
  EXPECT_FALSE(made->At(center + Vector3(40.0, 0.0, 0.0)));
}

TEST(GuideDistance, LargeStructuresGetWiderSteps)
{
  const auto made = MakeGuideDistance({}, Ball(60.0, Vector3::Zero()), {5.0, 0.5}, GoOn);
  EXPECT_LT(made->Bytes(), static_cast<std::size_t>(4 * 3 * MostGuideNodes));
  EXPECT_NEAR(made->At({0.0, 0.0, 62.0})->Distance, 2.0, 0.06);
  const auto isRefused = [](double radius, const GuideReach& reach)
  {
    try
    {
      MakeGuideDistance({}, Ball(radius, Vector3::Zero()), reach, GoOn);
    }
    catch (const InputError& error)
    {
      return std::string(error.what()).find("\"range_mm\" of each at least 10,") !=
             std::string::npos;
    }
    return false;
  };
  EXPECT_TRUE(isRefused(260.0, {5.0, 0.5}));
}

// Each node is a search of the mesh, which takes the longer, the farther away it is.
TEST(GuideDistance, FarGuidesGetFewerNodes)
{
  const auto far = MakeGuideDistance({}, Ball(30.0, Vector3::Zero()), {120.0, 2.0}, GoOn);
  EXPECT_LT(static_cast<double>(far->Bytes()), 6 * MostGuideNodes); // 11 bytes a node
  // Smoothing by a step of about 5 mm raises the distance by its square over 100 mm.
  EXPECT_NEAR(far->At({100.0, 0.0, 0.0})->Distance, 70.0, 0.3);
}

// Of a range of 1e-300 mm: more nodes along an axis than an integer holds.
TEST(GuideDistance, AbsurdlyShortRangeIsRefusedByItsKey)
{
  try
  {
    MakeGuideDistance({}, Ball(15.0, Vector3::Zero()), {5.0, 1e-301}, GoOn);
    FAIL() << "not refused";
  }
  catch (const InputError& error)
  {
    EXPECT_NE(std::string(error.what()).find("range_mm"), std::string::npos) << error.what();
  }
}

TEST(GuideDistance, CanBeCancelled)
{
  int calls = 0;
  const auto stop = [&calls](double, const std::string&) { return ++calls < 20; };
  EXPECT_THROW(MakeGuideDistance({}, Ball(15.0, Vector3::Zero()), {15.0, 1.0}, stop), Cancelled);
}

TEST(GuideDistance, ReachCoversAllGuidesOfAStructureInCoarseSteps)
{
  const GuideReach one = ReachOfGuides(GuidedBy(3, {{2.0, 10.0}}), 3);
  EXPECT_EQ(one.Reach, 15.0);
  EXPECT_EQ(one.Step, 1.0);
  const GuideReach similar = ReachOfGuides(GuidedBy(3, {{2.5, 12.0}}), 3);
  EXPECT_EQ(similar.Reach, one.Reach);
  EXPECT_EQ(similar.Step, one.Step);
  const GuideReach two = ReachOfGuides(GuidedBy(3, {{2.0, 10.0}, {-30.0, 4.0}}), 3);
  EXPECT_EQ(two.Reach, 35.0);
  EXPECT_EQ(two.Step, 0.25);
  EXPECT_EQ(ReachOfGuides(GuidedBy(3, {{2.0, 10.0}}), 4).Reach, 0.0);
}
} // namespace
} // namespace palpate::guide_distance_test
