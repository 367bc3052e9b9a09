#include "FeltImage.h"

#include "FeltCases.h"
#include "RandomOrientation.h"

namespace palpate::felt_image_test
{
namespace
{
double Slope(const Vector3& place)
{
  return 3.0 * place.x() - place.y() + 2.0 * place.z();
}

FeltImage ImageOf(int size, double fade, const Matrix3& turn = Matrix3::Identity())
{
  std::optional<FeltImage> image;
  const Status status = FeltImage::Make(
      test::FeltField(test::FeltGrid(size, turn), Slope, FieldInterpolation::TricubicBSpline), 0,
      -20.0, 20.0, fade, image);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return *image;
}

TEST(FeltImage, ThinImageIsFeltInFullInTheMiddleHalf)
{
  const FeltImage image = ImageOf(9, 100.0); // 8 mm
  EXPECT_DOUBLE_EQ(image.At({0.0, 1.99, -1.99}).Weight, 1.0);
  EXPECT_LT(image.At({0.0, 2.5, 0.0}).Weight, 1.0);
  EXPECT_EQ(image.At({0.0, 0.0, 4.0}).Weight, 0.0);
  EXPECT_EQ(image.At({0.0, -4.0, 0.0}).Weight, 0.0);
}

// Differences of the level and the weight themselves, towards all borders.
TEST(FeltImage, GradientsAreTheSlopesOfLevelAndWeight)
{
  test::Random random(91);
  const Matrix3 turn = test::RandomOrientation(random);
  const FeltImage image = ImageOf(31, 5.0, turn);
  std::uniform_real_distribution<double> coordinate(-14.9, 14.9);
  constexpr double Step = 1e-4;
  for (int n = 0; n < 3000; ++n)
  {
    const Vector3 place =
        turn * Vector3(coordinate(random), coordinate(random), coordinate(random));
    const Vector3 step = Step * test::RandomDirection(random);
    const FeltImage::Place before = image.At(place - step);
    const FeltImage::Place here = image.At(place);
    const FeltImage::Place after = image.At(place + step);
    EXPECT_NEAR(here.WeightGradient.dot(step), 0.5 * (after.Weight - before.Weight), 1e-8);
    const bool isOverABend = here.LevelGradient.isZero() != before.LevelGradient.isZero() ||
                             here.LevelGradient.isZero() != after.LevelGradient.isZero();
    if (!isOverABend)
    {
      EXPECT_NEAR(here.LevelGradient.dot(step), 0.5 * (after.Level - before.Level), 1e-8);
    }
    EXPECT_GE(here.Level, 0.0);
    EXPECT_LE(here.Level, 1.0);
  }
}
} // namespace
} // namespace palpate::felt_image_test
