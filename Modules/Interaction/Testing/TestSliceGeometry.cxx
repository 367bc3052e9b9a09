#include "SliceGeometry.h"

#include "ImageAxes.h"
#include "SliceViewTest.h"

#include <cmath>
#include <gtest/gtest.h>

namespace palpate::slice_geometry_test
{
namespace
{
TEST(SliceGeometry, FollowsRadiologicalConvention)
{
  const auto letters = [](SliceOrientation orientation)
  {
    const SliceGeometry geometry(orientation, true, nullptr);
    return OrientationLetters(geometry.Frame.RightWorld) +
           OrientationLetters(geometry.Frame.UpWorld) + OrientationLetters(geometry.ForwardWorld);
  };
  EXPECT_EQ(letters(SliceOrientation::Axial), "LAS");
  EXPECT_EQ(letters(SliceOrientation::Coronal), "LSA");
  EXPECT_EQ(letters(SliceOrientation::Sagittal), "PSR");
}

TEST(SliceGeometry, AlongImageSlicesEqualImageSlices)
{
  const auto image = palpate::test::RampImage(palpate::test::SkewTurn());
  const ImageAxes axes(image);
  const int axisOf[] = {2, 1, 0};
  for (const SliceOrientation orientation : palpate::AllSliceOrientations)
  {
    const int axis = axisOf[static_cast<int>(orientation)];
    const SliceGeometry geometry(orientation, true, image);
    EXPECT_EQ(geometry.Count, axes.Size(axis));
    for (int number = 0; number < geometry.Count; ++number)
    {
      const Vector3 place =
          geometry.FirstWorld + number * geometry.StepMillimeters * geometry.ForwardWorld;
      const double index = axes.ToIndex(place)[axis];
      // Rounding of numbers around 100.
      ASSERT_NEAR(index, std::round(index), 1e-11);
      ASSERT_EQ(geometry.NumberOf(place), number);
    }
    // The same side of the body, within the rotation.
    const SliceGeometry body(orientation, false, image);
    EXPECT_GT(geometry.Frame.RightWorld.dot(body.Frame.RightWorld), 0.9);
    EXPECT_GT(geometry.Frame.UpWorld.dot(body.Frame.UpWorld), 0.9);
    EXPECT_GT(geometry.ForwardWorld.dot(body.ForwardWorld), 0.9);
  }
}

TEST(SliceGeometry, MovedPointsLieOnSlicesAndKeepInPlanePosition)
{
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> place(-40.0, 40.0);
  const auto image = palpate::test::RampImage(palpate::test::SkewTurn());
  for (int trial = 0; trial < 200; ++trial)
  {
    const auto orientation = palpate::AllSliceOrientations[random() % 3];
    const SliceGeometry geometry(orientation, true, image);
    const Vector3 from{place(random), place(random), place(random)};
    const int steps = static_cast<int>(random() % 9) - 4;
    const Vector3 to = geometry.Moved(from, steps);
    const int expected = std::clamp(geometry.NumberOf(from) + steps, 0, geometry.Count - 1);
    ASSERT_EQ(geometry.NumberOf(to), expected);
    ASSERT_NEAR((to - from).dot(geometry.Frame.RightWorld), 0.0, 1e-11);
    ASSERT_NEAR((to - from).dot(geometry.Frame.UpWorld), 0.0, 1e-11);
    ASSERT_NEAR((geometry.Moved(to, 0) - to).norm(), 0.0, 1e-11) << "already on a slice";
  }
}

TEST(SliceGeometry, AlongBodyStepEqualsNearestAxisWithoutNumbers)
{
  const auto image = palpate::test::RampImage(palpate::test::SkewTurn());
  const SliceGeometry geometry(SliceOrientation::Axial, false, image);
  EXPECT_FALSE(geometry.HasNumbers());
  EXPECT_EQ(geometry.Moved(Vector3(1.0, 2.0, 3.0), 2), Vector3(1.0, 2.0, 9.0));
}
} // namespace
} // namespace palpate::slice_geometry_test
