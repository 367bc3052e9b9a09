#include "SurfaceTexture.h"

#include "FeltCases.h"
#include "SafetyCases.h"
#include "ServoRun.h"
#include "TexturedField.h"

#include <gtest/gtest.h>

namespace palpate::surface_texture_test
{
namespace
{
constexpr double Amplitude = 0.3; // N

std::shared_ptr<const SurfaceTexture> Texture()
{
  std::shared_ptr<const SurfaceTexture> texture;
  const Status status =
      SurfaceTexture::Make(test::TexturedField(), 0, test::TexturedBox(), Amplitude, texture);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return texture;
}

TEST(SurfaceTexture, IsBoundedByItsAmplitudeAndByThePush)
{
  const auto texture = Texture();
  test::Random random(81);
  std::uniform_real_distribution<double> push(0.0, 8.0);
  double largest = 0.0;
  for (int n = 0; n < 10'000; ++n)
  {
    const double pushed = push(random);
    const double force = texture->PushAt(pushed, 12.0 * test::RandomDirection(random));
    EXPECT_LT(std::abs(force), std::min(Amplitude, pushed));
    largest = std::max(largest, std::abs(force));
  }
  EXPECT_GT(largest, 0.5 * Amplitude); // it has an effect
}

TEST(SurfaceTexture, IsZeroWithoutPushOutsideAndForNonFiniteInput)
{
  const auto texture = Texture();
  EXPECT_NE(texture->PushAt(1.0, {1.0, 2.0, 3.0}), 0.0);
  EXPECT_EQ(texture->PushAt(0.0, {1.0, 2.0, 3.0}), 0.0);
  EXPECT_EQ(texture->PushAt(-1.0, {1.0, 2.0, 3.0}), 0.0);
  EXPECT_EQ(texture->PushAt(test::NotANumber, {1.0, 2.0, 3.0}), 0.0);
  EXPECT_EQ(texture->PushAt(1.0, {100.0, 0.0, 0.0}), 0.0);
  EXPECT_EQ(texture->PushAt(1.0, {test::NotANumber, 0.0, 0.0}), 0.0);
}

// For the gyroid, whose slope is at most 3 pi / 3 per mm and whose deviation is 0.87, u changes by
// at most 3.7 per mm, and u / sqrt(1 + u^2) no faster than u.
TEST(SurfaceTexture, HasNoSteps)
{
  const auto texture = Texture();
  constexpr double Step = 1e-3; // mm
  test::Random random(82);
  for (int n = 0; n < 10'000; ++n)
  {
    const Vector3 place = 10.0 * test::RandomDirection(random);
    const Vector3 next = place + Step * test::RandomDirection(random);
    EXPECT_LE(std::abs(texture->BrightnessAt(next) - texture->BrightnessAt(place)), 3.7 * Step);
  }
}

TEST(SurfaceTexture, BrighterPushesMore)
{
  const auto texture = Texture();
  const auto field = test::TexturedField();
  const FieldSampler image(field);
  test::Random random(83);
  for (int n = 0; n < 1000; ++n)
  {
    const Vector3 a = 10.0 * test::RandomDirection(random);
    const Vector3 b = 10.0 * test::RandomDirection(random);
    const bool isBrighter = image.ValueWorld(0, a).Value > image.ValueWorld(0, b).Value;
    EXPECT_EQ(texture->PushAt(1.0, a) > texture->PushAt(1.0, b), isBrighter);
  }
}

// Of an image that rises by a unit per mm, in a box around 7 units: the deviation over n places of
// a lattice with the step h is h sqrt((n^2 - 1) / 12).
TEST(SurfaceTexture, BrightnessIsThatOfDeviationsFromTheMean)
{
  const auto ramp =
      test::FeltField(test::FeltGrid(33), [](const Vector3& place) { return place.x(); });
  const Eigen::AlignedBox3d box(Vector3(1.0, -2.0, -3.0), Vector3(13.0, 2.0, 3.0));
  std::shared_ptr<const SurfaceTexture> texture;
  ASSERT_TRUE(SurfaceTexture::Make(ramp, 0, box, Amplitude, texture).IsOk());
  const double deviation = 12.0 / 32.0 * std::sqrt((32.0 * 32.0 - 1.0) / 12.0);
  for (const double deviations : {-2.0, -1.0, 0.0, 1.0, 2.0})
  {
    EXPECT_NEAR(texture->BrightnessAt({7.0 + deviations * deviation, 0.3, 0.2}),
                deviations / std::hypot(1.0, deviations), 1e-4) // the image has 16 bits
        << deviations;
  }
}

TEST(SurfaceTexture, FrictionDoesNotCountAsPush)
{
  const auto texture = Texture();
  EffectTouch touch;
  touch.Contact.IsTouching = true;
  touch.Contact.Normal = Vector3::UnitZ();
  touch.SurfaceWorld = {1.0, 2.0, 3.0};
  touch.ContactForce = {0.0, 0.0, 0.5};
  const Vector3 without = texture->Force(touch);
  touch.ContactForce = {2.0, -1.0, 0.5};
  EXPECT_EQ(texture->Force(touch), without);
  EXPECT_NE(without, Vector3::Zero());
}

TEST(SurfaceTexture, RejectsInvalidTextures)
{
  const auto field = test::TexturedField();
  std::shared_ptr<const SurfaceTexture> texture;
  const Eigen::AlignedBox3d far(Vector3::Constant(100.0), Vector3::Constant(110.0));
  const Eigen::AlignedBox3d box = test::TexturedBox();
  EXPECT_FALSE(SurfaceTexture::Make(field, 0, box, -0.1, texture).IsOk());
  EXPECT_FALSE(SurfaceTexture::Make(field, 0, box, test::NotANumber, texture).IsOk());
  EXPECT_FALSE(SurfaceTexture::Make(field, 1, box, 0.1, texture).IsOk());
  EXPECT_FALSE(SurfaceTexture::Make(nullptr, 0, box, 0.1, texture).IsOk());
  EXPECT_FALSE(SurfaceTexture::Make(field, 0, far, 0.1, texture).IsOk());
  EXPECT_FALSE(SurfaceTexture::Make(field, 0, {}, 0.1, texture).IsOk());
  EXPECT_EQ(texture, nullptr);
}

TEST(SurfaceTexture, ActsOnlyAtContacts)
{
  TouchScene scene = test::WallScene(0.0, {1.0, 0.0});
  scene.Tool = ToolShape::Sphere(2.0);
  scene.Structures[0].Effects = {Texture()};
  test::ServoRun run(scene);
  EXPECT_EQ(run.RestAt({3.0, 1.0, 2.5}), Vector3::Zero());
  // A millimetre deep, the sphere touches the wall's face below its centre.
  const Vector3 felt = run.RestAt({3.0, 1.0, 1.0});
  const double expected = 1.0 + Texture()->PushAt(1.0, {3.0, 1.0, 0.0});
  EXPECT_NEAR((felt - Vector3(0.0, 0.0, expected)).norm(), 0.0, 1e-14); // roundings of 1 N
  EXPECT_NE(expected, 1.0);
}
} // namespace
} // namespace palpate::surface_texture_test
