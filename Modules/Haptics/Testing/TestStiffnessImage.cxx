#include "StiffnessImage.h"

#include "ContactCases.h"
#include "FeltCases.h"
#include "RandomOrientation.h"
#include "StiffnessAdvice.h"

#include <cmath>

namespace palpate::stiffness_image_test
{
namespace
{
constexpr StiffnessRange Range{-100.0, 300.0, 0.2, 1.4};

double Waves(const Vector3& place)
{
  return 100.0 + 260.0 * std::sin(0.4 * place[0] + 0.2 * place[2]) * std::cos(0.3 * place[1]);
}

std::shared_ptr<const StiffnessImage> ImageOf(const std::shared_ptr<const ScalarField>& field,
                                              const StiffnessRange& range = Range)
{
  std::shared_ptr<const StiffnessImage> image;
  const Status status = StiffnessImage::Make(field, 0, range, image);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return image;
}

TouchScene WallWith(std::shared_ptr<const ForceEffect> effect, double stiffness = 0.6)
{
  TouchScene scene = test::WallScene(0.0, {stiffness, 0.0});
  scene.Structures[0].Effects = {std::move(effect)};
  return scene;
}

TEST(StiffnessImage, IsLinearBetweenTwoIntensitiesAndConstantBeyond)
{
  const FieldGrid grid = test::FeltGrid(32);
  const auto image = ImageOf(test::FeltField(grid, Waves));
  int beyond = 0;
  for (int n = 0; n < 20 * 20 * 20; ++n)
  {
    const Vector3 node(6 + n % 20, 6 + n / 20 % 20, 6 + n / 400);
    const Vector3 place = grid.PointWorld(node);
    const double level = std::clamp((Waves(place) + 100.0) / 400.0, 0.0, 1.0);
    EXPECT_NEAR(image->StiffnessAt(7.0, place), 0.2 + 1.2 * level, 1e-14);
    beyond += level == 0.0 || level == 1.0 ? 1 : 0;
  }
  EXPECT_GT(beyond, 100);
}

TEST(StiffnessImage, SecondIntensityMayBeTheSmallerOne)
{
  const auto field = test::FeltField(test::FeltGrid(32), Waves);
  const auto image = ImageOf(field);
  const auto swapped = ImageOf(field, {300.0, -100.0, 1.4, 0.2});
  test::Random random(811);
  for (int n = 0; n < 1000; ++n)
  {
    const Vector3 place = 12.0 * test::RandomDirection(random);
    EXPECT_NEAR(image->StiffnessAt(0.5, place), swapped->StiffnessAt(0.5, place), 1e-14);
  }
}

TEST(StiffnessImage, ConstantImageIsLikeAStructureOfThatStiffness)
{
  const auto constant = test::FeltField(test::FeltGrid(32), [](const Vector3&) { return 40.0; });
  const auto image = ImageOf(constant, {40.0, 90.0, 0.75, 3.0});
  test::ServoRun felt(WallWith(image, 0.1));
  test::ServoRun plain(test::WallScene(0.0, {0.75, 0.0}));
  for (int n = 0; n < 3000; ++n)
  {
    const Vector3 hand(3.0 * std::sin(0.01 * n), 2.0 * std::cos(0.007 * n),
                       1.0 - 2.0 * std::sin(0.003 * n));
    EXPECT_EQ(felt.TickAt(hand), plain.TickAt(hand)) << n;
  }
}

// By at most the blend's 1.5 / (2 voxels of 1 mm) of the difference of stiffness, and the image's
// slope of at most 260 * 0.5 per mm.
TEST(StiffnessImage, BlendsIntoTheStructuresOwnTowardsTheBorder)
{
  const auto image = ImageOf(test::FeltField(test::FeltGrid(32), Waves));
  constexpr double Step = 1e-3;
  constexpr double Slope = 0.75 * 1.2 + 260.0 * 0.5 * 1.2 / 400.0;
  double before = image->StiffnessAt(0.6, {-20.0, 1.0, 2.0});
  EXPECT_EQ(before, 0.6);
  double largest = 0.0;
  for (int n = 1; n <= 40'000; ++n)
  {
    const double now = image->StiffnessAt(0.6, {-20.0 + Step * n, 1.0, 2.0});
    EXPECT_LE(std::abs(now - before), Slope * Step);
    largest = std::max(largest, std::abs(now - 0.6));
    before = now;
  }
  EXPECT_EQ(before, 0.6);
  EXPECT_GT(largest, 0.3);
}

// Frame, scale and image are all turned. The push alone, without the force along the surface, would
// give the hand energy.
TEST(StiffnessImage, ClosedPathsOnAPlaneDoNoWork)
{
  test::Random random(812);
  const Matrix3 turn = test::RandomOrientation(random);
  TouchScene scene = WallWith(ImageOf(test::FeltField(test::FeltGrid(32, turn), Waves)));
  scene.Tool = ToolShape::Sphere(1.5);
  scene.Frame = DeviceFrame(Eigen::AngleAxisd(0.7, Vector3::UnitZ()).toRotationMatrix(), 1.6,
                            Vector3(0.5, -0.5, 0.0));
  test::ClosedPath hand(scene);
  double push = 0.0;
  for (int path = 0; path < 6; ++path)
  {
    const auto around = [path](double turned)
    {
      const double angle = 2.0 * M_PI * turned;
      // Some leave the surface, some the image.
      return Vector3((3.0 + 2.0 * path) * std::sin(angle), 4.0 * std::cos(angle),
                     -1.2 + 1.5 * std::cos(angle + path));
    };
    const auto work = hand.Along(around, 100'000);
    // N mm: the force along the surface has steps of some 0.1 N between voxels, and each falls into
    // one step of about 0.6 um.
    EXPECT_NEAR(work.All, 0.0, 3e-4) << path;
    push = std::max(push, std::abs(work.Push));
  }
  EXPECT_GT(push, 0.2);
}

// A sphere of 20 mm and a point: the gain is at most depth / (R - depth) of the energy that the
// change of stiffness stores, here 1.2 N/mm (2 mm)^2 / 2 on the way there, and as much back.
TEST(StiffnessImage, ClosedPathsOnASphereGainNoMoreThanStated)
{
  constexpr double Radius = 20.0;
  constexpr double Depth = 2.0;
  constexpr double Stored = 0.5 * 1.2 * Depth * Depth;
  TouchScene scene;
  scene.Tool = ToolShape::Sphere(0.0);
  const auto ramp = [](const Vector3& place) { return 100.0 + 25.0 * place[0]; };
  scene.Structures.push_back(
      {"sphere",
       test::RadialContact({0, {Radius * std::sqrt(4.0 * M_PI)}, Vector3::Zero()}),
       {0.6, 0.0},
       {}});
  scene.Structures[0].Effects = {ImageOf(test::FeltField(test::FeltGrid(52), ramp))};
  test::ClosedPath hand(scene);
  // Pressed in on one side, out on the other, and back above the surface; both ways round.
  for (const double sense : {1.0, -1.0})
  {
    const auto around = [sense](double turned)
    {
      const double angle = 2.0 * M_PI * sense * turned;
      const double height = Radius - Depth * std::sin(angle);
      const double tilt = 0.5 * std::cos(angle);
      return Vector3(height * std::sin(tilt), 0.0, height * std::cos(tilt));
    };
    const auto work = hand.Along(around, 50'000);
    EXPECT_LE(std::abs(work.All), Stored * Depth / (Radius - Depth)) << sense;
    EXPECT_GT(std::abs(work.Push), 0.3 * Stored) << sense;
  }
}

TEST(StiffnessImage, ForceAlongTheSurfaceIsTheSlopeOfTheEnergy)
{
  test::Random random(813);
  const Matrix3 turn = test::RandomOrientation(random);
  const auto image = ImageOf(test::FeltField(test::FeltGrid(32, turn), Waves));
  int compared = 0;
  for (int n = 0; n < 1000; ++n)
  {
    EffectTouch touch;
    touch.Contact.IsTouching = true;
    touch.Contact.Normal = test::RandomDirection(random);
    touch.Contact.Offset = 1.7 * touch.Contact.Normal;
    touch.OwnStiffness = 0.5;
    touch.SurfaceWorld = 14.0 * test::RandomDirection(random);
    const Vector3 along = touch.Contact.Normal.unitOrthogonal();
    constexpr double Step = 1e-6;
    const double more = image->StiffnessAt(0.5, touch.SurfaceWorld + Step * along) -
                        image->StiffnessAt(0.5, touch.SurfaceWorld - Step * along);
    const double expected = -0.5 * 1.7 * 1.7 * more / (2.0 * Step);
    const double force = image->Force(touch).dot(along);
    EXPECT_NEAR(image->Force(touch).dot(touch.Contact.Normal), 0.0, 1e-14);
    compared += std::abs(force - expected) < 1e-6 ? 1 : 0;
  }
  EXPECT_GT(compared, 990); // the others cross a face between voxels
}

TEST(StiffnessImage, LeavesStructuresThatYieldAlone)
{
  const auto image = ImageOf(test::FeltField(test::FeltGrid(32), Waves));
  EffectTouch touch;
  touch.Contact.IsTouching = true;
  touch.Contact.Offset = {0.0, 0.0, 1.0};
  touch.SurfaceWorld = {1.0, 2.0, 3.0};
  EXPECT_NE(image->Force(touch), Vector3::Zero());
  touch.Contact.IsElastic = true;
  EXPECT_EQ(image->Force(touch), Vector3::Zero());
}

TEST(StiffnessImage, RejectsInvalidRanges)
{
  const auto field = test::FeltField(test::FeltGrid(16), Waves);
  std::shared_ptr<const StiffnessImage> image;
  const auto isRefused = [&](const StiffnessRange& range, int channel = 0)
  { return !StiffnessImage::Make(field, channel, range, image).IsOk(); };
  EXPECT_TRUE(isRefused({1.0, 1.0, 0.2, 0.4}));
  EXPECT_TRUE(isRefused({1.0, test::NotANumber, 0.2, 0.4}));
  EXPECT_TRUE(isRefused({1.0, test::Infinite, 0.2, 0.4}));
  EXPECT_TRUE(isRefused({1.0, 2.0, -0.2, 0.4}));
  EXPECT_TRUE(isRefused({1.0, 2.0, 0.2, test::NotANumber}));
  EXPECT_TRUE(isRefused(Range, 1));
  EXPECT_FALSE(StiffnessImage::Make(nullptr, 0, Range, image).IsOk());
  EXPECT_EQ(image, nullptr);
}

TEST(StiffnessImage, StaysWithinTheDevicesLimitForHostileNumbers)
{
  test::Random random(814);
  const auto field = test::FeltField(test::FeltGrid(16), [](const Vector3& place)
                                     { return place[0] > 0.0 ? 1e139 : -1e139; });
  for (const StiffnessRange& range :
       {StiffnessRange{-1.0, 1.0, 0.0, 1e4}, StiffnessRange{-1e139, 1e139, 1e4, 0.0},
        StiffnessRange{0.0, 1e-300, 0.0, 1e300}, StiffnessRange{-1e-9, 1e-9, 1e9, 0.0}})
  {
    const auto image = ImageOf(field, range);
    for (int n = 0; n < 2000; ++n)
    {
      const double stiffness = image->StiffnessAt(0.5, test::HostileVector(random));
      EXPECT_TRUE(stiffness >= 0.0 && std::isfinite(stiffness));
    }
    test::ServoRun run(WallWith(image));
    for (int n = 0; n < 2000; ++n)
    {
      const Vector3 hand(2.0 * std::sin(0.01 * n), 0.0, -2.0 * std::cos(0.01 * n));
      EXPECT_LE(run.TickAt(hand).norm(), run.Device.Abilities.MaximumForce * (1.0 + 1e-12));
    }
  }
}

TEST(StiffnessImage, WarningsAreOfTheStiffestPlace)
{
  DeviceCapabilities device;
  device.Name = "example";
  device.MaximumStiffness = 1.3; // N/mm
  const auto field = test::FeltField(test::FeltGrid(16), Waves);
  EXPECT_TRUE(
      StiffnessWarnings(WallWith(ImageOf(field, {0.0, 1.0, 0.2, 1.2})), device, 1000.0).empty());
  const auto warnings = StiffnessWarnings(WallWith(ImageOf(field)), device, 1000.0);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings[0].find("requests 1.4 N/mm"), std::string::npos) << warnings[0];
}
} // namespace
} // namespace palpate::stiffness_image_test
